# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page about a case as tables of texts, which summary.py prints and report.py writes as HTML."""
import os
from dataclasses import dataclass, field

from results.case import failures, known
from results.losses_case import PARTS, read_case
from results.node_history import pass_of_node

MOST_MODES = 12

# name in summary.json -> how to say it, unit to print, what to multiply with
WAVE_QUANTITIES = {
    "A_t/A_n": ("A_t/A_n, tooth top, outer edge", "", 1),
    "A_r/A_n": ("A_r/A_n, the same place", "", 1),
    "phi_edge": ("phi, +theta edge of the tooth", "deg", 1),
    "modal_mass": ("modal mass", "g", 1e3),
    "strain_energy": ("strain energy of the wave", "mJ", 1e3),
}
ROTOR_QUANTITIES = {
    "clearance": ("clearance of the ring from the stator", "mm", 1e3),
    "lip_A_r/A_n": ("A_r/A_n of the lip on the wave", "", 1),
}
CIRCUIT_QUANTITIES = (  # name and unit of a column of circuits.csv, what to call it, its unit
    ("open_circuit_frequency", "_Hz", "open-circuit frequency", "Hz"),
    ("k_eff^2", "", "k_eff^2", ""),
    ("force_factor", "_N_per_V", "force factor", "N/V"),
    ("C0", "_nF", "capacitance C0", "nF"),
    ("free_capacitance", "_nF", "capacitance at rest, free", "nF"),
    ("clamped_capacitance", "_nF", "capacitance, clamped", "nF"),
    ("Lm", "_H", "Lm", "H"),
    ("Cm", "_pF", "Cm", "pF"),
    ("Rm", "_ohm", "Rm", "ohm"),
    ("Q", "", "Q", ""),
)
LOSS_NAMES = dict(zip(PARTS, ("friction", "stator metal", "piezoceramic", "other modes of the stator", "rotor", "support")))
LOSS_FACTORS = {"Materials/Stator metal/Loss factor": "stator metal", "Materials/Piezoceramic/Loss factor": "piezoceramic",
                "Materials/Rotor metal/Loss factor": "rotor", "Support/Felt loss factor": "felt of the support"}
FILES = {
    "report.html": "this page with its figures",
    "figures": "figures, PNG and SVG",
    "stator/frequencies.csv": "natural frequencies",
    "stator/ellipses.csv": "motion of 18 points of a tooth",
    "stator/circuits.csv": "equivalent circuits of the phases",
    "contact/torque_speed.csv": "operating points",
    "losses/losses.csv": "each loss at the operating points",
    "losses/efficiency.csv": "input, output, efficiency",
    "losses/drive.csv": "voltage, current, electrical power",
    "stator/ring.pvd": "the wave, for ParaView",
    "contact/motor.pvd": "rotor and teeth, for ParaView",
    "contact/contact.pvd": "contact on the tooth tops, for ParaView",
    "stator/used.prm": "all parameters",
}


@dataclass
class Table:
    """Texts in columns. `align` has "l" or "r" for each column, `head` (name, unit) for each or nothing."""

    title: str
    align: str
    head: list = field(default_factory=list)
    rows: list = field(default_factory=list)
    notes: list = field(default_factory=list)


class Page:
    """What there is to say about a case; of many operating points some, from the first to the last.

    motor, motor_line, version  its name; waves and teeth; that of the programs
    tables                     by name: list of Table, in the order of the page
    notes                      of results that do not belong together and are left out
    """

    def __init__(self, folder, most_points):
        self.case, self.contact, self.losses, self.notes = read_case(folder)
        self.folder, self.most_points = folder, most_points
        self.programs = [part for part in (self.case, self.contact, self.losses) if part]
        summary = self.case.summary
        self.motor = self.case.motor
        self.motor_line = f"{self.case.n_waves} waves, {self.case.n_teeth} teeth"
        self.version = summary["version"] + (f" ({summary['git']})" if summary["git"] else "")
        tables = {"glance": self.glance()}
        if "variant" in summary:
            tables["variant"] = self.variant()
        tables["modes"] = self.modes()
        if self.case.wave:
            tables["wave"] = self.wave()
        if self.case.circuits:
            tables["circuits"] = self.circuits()
        if self.contact:
            tables["rotor"] = self.rotor()
            tables["curve"] = self.curve()
        if self.losses:
            tables["losses"] = self.loss_table()
            if self.losses.has_drive:
                tables["drive"] = self.drive()
                tables["simulators"] = self.for_simulators()
        self.tables = {**tables, "effects": self.effects(), "certificates": self.certificates(), "cost": self.cost(),
                       "files": self.files()}

    def newest_result(self):
        """Seconds; pictures and pages that are older show other results."""
        return max(os.path.getmtime(os.path.join(part.folder, "summary.json")) for part in self.programs)

    @property
    def points(self):
        """Operating points with their losses, if there are any."""
        return self.losses.points_with(self.contact) if self.losses else self.contact.curve

    def shown_points(self):
        """All of them or, of many, some from the first to the last."""
        n_points = len(self.points)
        n_shown = min(self.most_points, n_points)
        numbers = sorted({round(i * (n_points - 1) / max(1, n_shown - 1)) for i in range(n_shown)})
        return [self.points[i] for i in numbers]

    def notes_of_more(self, file):
        n_more = len(self.points) - len(self.shown_points())
        return [f"and {n_more} more points in {file}"] if n_more else []

    # ------------------------------------------------------------------------------ tables
    def glance(self):
        rows = []
        if self.case.wave:
            driving = self.case.wave
            frequency, error = driving["natural_frequency_Hz"], driving["natural_frequency_error_Hz"]
            rows.append(["frequency of the wave", known(frequency / 1e3, error / 1e3), "kHz", ""])
        for point in self.contact.curve if self.contact else []:
            if point["control"] == "torque" and abs(point["torque_mNm"]) < 1e-6:
                rows.append(["speed without load", speed(point), "rpm", ""])
            elif point["control"] == "speed" and point["speed_rpm"] == 0:
                rows.append(["torque at stall", torque(point), "mN m", ""])
        if self.losses:
            best = max(self.points, key=lambda point: point["efficiency"])
            where = f"at {torque(best)} mN m, the highest of {len(self.points)} points"
            rows.append(["efficiency", efficiency(best), "%", where])
        failed = [check for part in self.programs for check in part.summary["certificate"]["checks"]
                  if not check["holds"]]
        missing = failures(self.folder)
        holds = f"{len(failed)} DO NOT HOLD" if failed else "all hold" if not missing else "those below hold"
        rows.append(["certificates", ", ".join([*(f"{program} FAILED" for program in missing), holds]), "", ""])
        rows.append(["computed in", f"{sum(map(seconds, self.programs)):.1f}", "s", ""])
        return Table("At a glance", "lrll", rows=rows)

    def variant(self):
        """What the parameter file and the command line change in the file that it is based on."""
        variant = self.case.summary["variant"]
        rows = [[row["entry"], row["value"], row["value_of_base"] or "-"] for row in variant["differences"]]
        base = os.path.basename(variant["base"])
        return Table(f"Differences from {base}", "lll", [("entry", ""), ("here", ""), (f"in {base}", "")], rows)

    def modes(self):
        case, rows = self.case, []
        modes = sorted(case.modes, key=lambda mode: (mode["n"] != case.n_waves, mode["n"], mode["frequency_Hz"]))
        for mode in modes[:MOST_MODES]:
            driving = case.wave and mode["frequency_Hz"] == case.wave["natural_frequency_Hz"]
            rows.append([f"n = {mode['n']}, {mode['family']}",
                         known(mode["frequency_Hz"] / 1e3, mode["error_Hz"] / 1e3), "kHz",
                         f"({100 * mode['error_Hz'] / mode['frequency_Hz']:.2g} %)",
                         "the motor's wave" if driving else ""])
        n_more = len(modes) - len(rows)
        return Table("Natural frequencies", "lrlll", rows=rows,
                     notes=[f"and {n_more} more in stator/frequencies.csv"] if n_more else [])

    def wave(self):
        case, rows = self.case, []
        for quantity in case.summary["quantities"]:
            if quantity["name"] in WAVE_QUANTITIES:
                name, unit, scale = WAVE_QUANTITIES[quantity["name"]]
                rows.append([name, known(scale * quantity["value"], scale * quantity["error"]), unit, ""])
        frequency = case.wave["natural_frequency_Hz"]
        gaps = [mode["frequency_Hz"] / frequency - 1 for mode in case.modes
                if mode["n"] == case.n_waves and mode["frequency_Hz"] != frequency]
        if gaps:
            gap = min(gaps, key=abs)
            rows.append(["gap to the next mode of this n", f"{100 * abs(gap):.1f}", "%",
                         "above" if gap > 0 else "below"])
        return Table(f"The travelling wave, amplitude {case.wave['amplitude_m'] * 1e6:g} um", "lrll", rows=rows)

    def rotor(self):
        found = {quantity["name"]: quantity for quantity in self.contact.of_rotor()}
        rows = [[name, known(scale * found[key]["value"], scale * found[key]["error"]), unit]
                for key, (name, unit, scale) in ROTOR_QUANTITIES.items() if key in found]
        gain = [f"{quantity['value']:.2f}" for name, quantity in found.items() if name.startswith("lip_amplification")]
        if gain:
            rows.append(["motion of the lip with inertia over that without", " ".join(gain), "harmonics 1, 2, ... of the wave"])
        point = self.contact.point_near(0)
        phases = pass_of_node(self.contact, point)
        if phases:
            rows.append(["a node while a crest passes", ", ".join(phases),
                         f"friction on the rotor, {self.contact.curve[point]['torque_mNm']:.3g} mN m"])
        return Table("The rotor on the wave", "lll", rows=rows)

    def circuits(self):
        phases = self.case.circuits
        rows = [[said, *(known(row[f"{name}{unit}"], row[f"{name}_error{unit}"]) for row in phases.values()), shown]
                for name, unit, said, shown in CIRCUIT_QUANTITIES]
        return Table("Electrodes and equivalent circuits", "lrrl",
                     [("", ""), *((f"phase {name}", "") for name in phases), ("", "")], rows,
                     ["without rotor, the other phase grounded; Q is that of the stator's materials alone"])

    def curve(self):
        columns = [("torque", "mN m", torque), ("speed", "rpm", speed), ("output", "mW", output)]
        if self.losses:
            columns += [("losses", "mW", lambda point: power(point, "total_loss")), ("efficiency", "%", efficiency)]
        else:
            columns += [("friction loss", "mW", lambda point: power(point, "friction_loss"))]
        columns += [("teeth in contact", "per wave", lambda point: f"{point['teeth_in_contact_per_wave']:.2f}"),
                    ("time", "s", lambda point: f"{point['seconds']:.2f}")]
        given = self.contact.parameters
        notes = [*self.notes_of_more("contact/torque_speed.csv"),
                 f"preload {float(given['Loading/Preload']):g} N, friction law {given['Friction/Law']}, "
                 f"dynamic coefficient {self.contact.friction_coefficient:g}"]
        return self.table_of_points("Torque and speed", columns, notes)

    def loss_table(self):
        columns = [("torque", "mN m", torque)]
        columns += [(said, "mW", lambda point, name=name: power(point, name)) for name, said in LOSS_NAMES.items()
                    if name != "internal_loss_stator_vibration" or any(point[name + "_mW"] for point in self.losses.points)]
        columns += [("total", "mW", lambda point: power(point, "total_loss"))]
        given = {entry: self.losses.parameters[entry] for entry in LOSS_FACTORS}
        factors = ", ".join(f"{LOSS_FACTORS[entry]} {float(text):g}" for entry, text in given.items() if text != "none")
        notes = [*self.notes_of_more("losses/losses.csv"), f"loss factors: {factors}"]
        return self.table_of_points("Where the power is lost", columns, notes)

    def drive(self):
        columns = [("torque", "mN m", torque), ("speed", "rpm", speed),
                   ("amplitude", "um", lambda point: known(point["amplitude_um"], point["amplitude_error_um"])),
                   ("voltage", "V", lambda point: known(point["voltage_V"], point["voltage_error_V"])),
                   ("current", "mA", lambda point: known(point["current_mA"], point["current_error_mA"])),
                   ("power factor", "", lambda point: known(point["power_factor"], point["power_factor_error"])),
                   ("input", "mW", lambda point: power(point, "electrical_input")),
                   ("efficiency", "%", electrical_efficiency)]
        notes = [*self.notes_of_more("losses/drive.csv"), "amplitude of the wave, voltage and current of each phase, "
                 "zero to peak; electrical input and efficiency"]
        return self.table_of_points("What the phases need", columns, notes)

    def for_simulators(self):
        """What a block of a system simulator for such a motor asks for."""
        best = max(self.points, key=lambda point: point["electrical_efficiency"])
        rows = [["rated torque", torque(best), "mN m"], ["rated speed", speed(best), "rpm"]]
        for point in self.points:
            if point["control"] == "torque" and abs(point["torque_mNm"]) < 1e-6:
                rows.append(["no-load speed", speed(point), "rpm"])
            elif point["control"] == "speed" and point["speed_rpm"] == 0:
                rows.append(["stall torque", torque(point), "mN m"])
        wave, circuit = self.case.wave, next(iter(self.case.circuits.values()))
        rows += [["natural frequency", known(wave["natural_frequency_Hz"] / 1e3, wave["natural_frequency_error_Hz"] / 1e3),
                  "kHz"],
                 ["rated voltage, rms", known(best["voltage_V"] / 2**0.5, best["voltage_error_V"] / 2**0.5), "V"],
                 ["capacitance of a phase", known(circuit["C0_nF"], circuit["C0_error_nF"]), "nF"],
                 ["Q of the stator", known(circuit["Q"], circuit["Q_error"]), ""]]
        return Table("For a system simulator", "lrl", rows=rows,
                     notes=["rated: the operating point of the highest electrical efficiency"])

    def table_of_points(self, title, columns, notes):
        return Table(title, "r" * len(columns), [(name, unit) for name, unit, _ in columns],
                     [[cell(point) for _, _, cell in columns] for point in self.shown_points()], notes)

    def effects(self):
        rows, told = [], set()
        for part in self.programs:
            for effect in part.summary["effects"]:
                told.add(effect["name"])
                rows.append([effect["name"], ("auto: " if effect["automatic"] else "") + effect["choice"],
                             "-" if effect["indicator"] is None else f"{100 * effect['indicator']:+.2g} %",
                             f"{effect['seconds']:.1f}", str(effect["dofs"]), f"{effect['bytes'] / 1e6:.1f}", part.program])
        notes = [line for part in self.programs for line in self.needed_but_off(part)]
        parameters = self.programs[-1].parameters
        for choice in ("on", "off", "auto"):
            names = [entry.split("/")[1] for entry, text in parameters.items()
                     if entry.startswith("Effects/") and text == choice and entry.split("/")[1] not in told]
            if names:
                notes.append(f"{choice}, without an estimate: {', '.join(names)}")
        return Table("Effects", "llrrrrl", [("effect", ""), ("choice", ""), ("it changes results by", ""), ("seconds", "s"),
                                            ("modes", ""), ("memory", "MB"), ("program", "")], rows, notes)

    def needed_but_off(self, part):
        """Of the effects that the user has switched off: those that the program would have included."""
        target = "Accuracy/Target" if part.program == "stator" else "Accuracy/Contact target"
        for effect in part.summary["effects"]:
            change = abs(effect["indicator"] or 0.)
            if effect["choice"] == "off" and not effect["automatic"] and change > float(part.parameters[target]) / 3:
                yield f"{effect['name']} is off, but would change the results by {100 * change:.2g} %"

    def certificates(self):
        rows = [["ok" if check["holds"] else "FAIL", part.program, check["name"], f"{check['value']:.2g}",
                 f"{check['limit']:.2g}"] for part in self.programs for check in part.summary["certificate"]["checks"]]
        return Table("Certificates", "lllrr", [(name, "") for name in ("", "program", "check", "value", "limit")], rows)

    def cost(self):
        rows = [[part.program, f"{seconds(part):.2f}", f"{part.summary['peak_memory_MB']:.0f}",
                 f"{part.summary['dofs']}"] for part in self.programs]
        return Table("Cost", "lrrr", [("program", ""), ("time", "s"), ("memory", "MB"), ("unknowns", "")], rows)

    def files(self):
        rows = [[path, said] for path, said in FILES.items() if self.has_file(path)]
        return Table(f"Files in {self.folder} (described in doc/files.md)", "ll", rows=rows)

    def has_file(self, path):
        whole = os.path.join(self.folder, path)
        return os.path.exists(whole) and (path != "report.html" or os.path.getmtime(whole) >= self.newest_result())


def seconds(part):
    return sum(part.summary["seconds"].values())


def torque(point):
    return known(point["torque_mNm"], point["torque_error_mNm"])


def speed(point):
    return known(point["speed_rpm"], point["speed_error_rpm"])


def output(point):
    return known(point["output_power_mW"], point.get("output_power_error_mW"))


def efficiency(point):
    return known(100 * point["efficiency"], 100 * point["efficiency_error"])


def electrical_efficiency(point):
    return known(100 * point["electrical_efficiency"], 100 * point["electrical_efficiency_error"])


def power(point, name):
    return known(point[f"{name}_mW"], point[f"{name}_error_mW"])
