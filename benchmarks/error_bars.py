#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""True errors of operating points against their error bars, on 24 motors.

usage: benchmarks/error_bars.py [--inertia] [--resume] [--csv FILE] [--markdown FILE] [--figure FILE.png] [MOTOR ...]

Each motor is computed at five torques with two targets. The truth is interface mesh 3 with at least 720 steps per period,
one or two meshes finer; its own error bars are not taken into account. With the first twelve motors the lower bounds of
error bars were chosen, not with the others. With --inertia, teeth and rotor have inertia and damping, and what results are
compared with is interface mesh 2 with at least 240 steps per period and modes of level 2: hardly better known than they are,
so that the difference is compared with the root of the sum of the squares of both error bars. It takes one to three minutes for each motor (45
and 60 mm: five to ten); with --resume the rows of the CSV file are kept.
"""
import argparse
import dataclasses
import math
import pathlib
import shutil
import statistics
import sys

sys.dont_write_bytecode = True
from motor_run import (OUTPUT_OFF, RowFile, add_operating_points, certified_run, operating_points,  # noqa: E402
                       table, write_markdown)
from timed_run import PAPERS_MODEL, ROOT, entries_of  # noqa: E402

SOFT, STIFF, RING60, CANON = (ROOT / "prm" / f"{name}.prm"
                              for name in ("soft_spring", "stiff_spring", "ring60", "canon_ring"))
RING45 = ROOT / "tests" / "programs" / "ring45.prm"


def friction(coefficient):
    return {f"Friction/{which} coefficient": coefficient for which in ("Static", "Dynamic")}


TUNED = {
    "reference": (SOFT, {}), "stiff spring": (STIFF, {}), "solid flange": (SOFT, {"Rotor/Flange element": "solid"}),
    "lip inside the teeth": (SOFT, {"Rotor/Lip outer radius": "0.0338"}),
    "60 N": (SOFT, {"Loading/Preload": "60"}), "3 N": (SOFT, {"Loading/Preload": "3"}),
    "high teeth": (SOFT, {"Stator/Tooth height": "0.0035", "Stator/Slot width": "0.0003"}),
    "friction 0.15": (SOFT, friction("0.15")),
    "thick flange": (SOFT, {"Rotor/Flange thickness": "0.0009"}),
    "45 mm": (RING45, {"Loading/Preload": "10", "Wave/Amplitude": "1e-6"}),
    "60 mm": (RING60, {"Effects/Friction lining": "on"}),
    "wave of 1 um": (SOFT, {"Wave/Amplitude": "1e-6"})}
OTHERS = {
    "canon": (CANON, {}), "canon 5 N": (CANON, {"Loading/Preload": "5"}),
    "canon 20 N, 1.5 um, 0.30": (CANON, {"Loading/Preload": "20", "Wave/Amplitude": "1.5e-6", **friction("0.30")}),
    "canon 40 N, 3 um": (CANON, {"Loading/Preload": "40", "Wave/Amplitude": "3e-6"}),
    "canon, friction 0.6": (CANON, friction("0.6")), "canon, 72 teeth": (CANON, {"Motor/Number of teeth": "72"}),
    "thin flange": (SOFT, {"Rotor/Flange thickness": "0.0004"}), "wave of 3 um": (SOFT, {"Wave/Amplitude": "3e-6"}),
    "stiff, 8 N": (STIFF, {"Loading/Preload": "8"}),
    "stiff, 30 N, 0.2": (STIFF, {"Loading/Preload": "30", **friction("0.2")}),
    "45 mm, 25 N, 1.5 um": (RING45, {"Loading/Preload": "25", "Wave/Amplitude": "1.5e-6"}),
    "60 mm, 80 N": (RING60, {"Loading/Preload": "80"})}
MOTORS = {**TUNED, **OTHERS}
BASE = {**PAPERS_MODEL, **OUTPUT_OFF, "Effects/Static friction excess": "off", "Effects/Initial deformation": "off",
        **friction("0.4")}
INERTIA = ("Rotor inertia", "Tooth inertia", "Tooth vibration", "Damping")
SHARES = (0., 0.25, 0.5, 0.75, 0.9)  # of the stall torque
# Columns of values and of their error bars.
QUANTITIES = {"speeds": ("speed_rpm", "speed_error_rpm"),
              "losses": ("friction_loss_mW", "friction_loss_error_mW"),
              "stick fractions": ("stick_fraction", "stick_fraction_error"),
              "teeth in contact": ("teeth_in_contact_per_wave", "teeth_in_contact_per_wave_error")}
COLUMNS = ["motor", "target", "seconds", "torque_mNm"] + sum(map(list, QUANTITIES.values()), [])


@dataclasses.dataclass
class Kind:
    """What motors are computed with and without inertia."""
    name: str  # of its results
    entries: dict
    targets: tuple
    finest: dict  # entries of the truth
    n_steps: int  # in a period, of the truth
    is_exact: bool  # whether the error bars of the truth do not matter

    def truth_of(self, motor, others):
        """Entries of the finest discretisation."""
        entries = {**entries_of(motor), **others}
        n_waves, n_teeth = (int(entries[f"Motor/Number of {which}"]) for which in ("waves", "teeth"))
        steps = n_teeth // math.gcd(n_waves, n_teeth)  # with one time sample: a step from tooth to tooth that differ
        return {"Accuracy/Mode": "fixed", "Time/Snapshots": str(math.ceil(self.n_steps / steps)), **self.finest}


WITHOUT_INERTIA = Kind("error_bars", {}, ("0.03", "0.01"), {"Accuracy/Interface refinement": "3"}, 720, True)
WITH_INERTIA = Kind("error_bars_inertia",
                    {**{f"Effects/{name}": "on" for name in INERTIA}, "Accuracy/Time limit": "100"}, ("0.1", "0.03"),
                    {"Accuracy/Interface refinement": "2", "Accuracy/Rotor modes": "2"}, 240, False)


def compute(kind, name, rows, scratch):
    motor, others = MOTORS[name]
    entries = {**BASE, **kind.entries, **others}
    wanted = [target for target in kind.targets + ("truth",) if not rows.find(motor=name, target=target)]
    if not wanted:
        return
    shutil.rmtree(scratch, ignore_errors=True)
    certified_run("stator", motor, scratch, {**entries, "Accuracy/Contact target": "0.001"})
    ends, _ = operating_points(motor, scratch, {**entries, "Accuracy/Contact target": "0.3",
                                                "Loading/Number of curve points": "2"})
    stall = 1e-3 * max(row["torque_mNm"] for row in ends)
    loads = {"Loading/Values": ", ".join(f"{share * stall:.6g}" for share in SHARES)}
    for target in wanted:
        accuracy = kind.truth_of(motor, others) if target == "truth" else {"Accuracy/Contact target": target}
        add_operating_points(rows, {"motor": name, "target": target}, motor, scratch, {**entries, **loads, **accuracy})
    shutil.rmtree(scratch, ignore_errors=True)


def ratios(kind, rows, truth, value, error):
    """True error over error bar."""
    return [abs(float(row[value]) - float(true[value])) /
            math.hypot(float(row[error]), 0. if kind.is_exact else float(true[error])) for row, true in zip(rows, truth)]


def evaluate(kind, rows):
    """The lines of the table and what they say of both groups of motors; and all ratios by target."""
    header = ["motor", "target", "seconds", "largest bar of speed, %", "true error over bar: " + ", ".join(QUANTITIES)]
    header[-1:] = header[-1].split(", ")
    lines, every, by_motor = [], {target: [] for target in kind.targets}, {name: [] for name in MOTORS}
    for name in MOTORS:
        of = {target: [row for row in rows.rows if row["motor"] == name and row["target"] == target]
              for target in kind.targets + ("truth",)}
        truth = of.pop("truth")
        for target, found in of.items():
            if not found or len(truth) != len(found):
                continue
            parts = [ratios(kind, found, truth, *columns) for columns in QUANTITIES.values()]
            every[target] += sum(parts, [])
            by_motor[name] += sum(parts, [])
            fastest = max(float(row["speed_rpm"]) for row in truth)
            bar = max(float(row["speed_error_rpm"]) for row in found) / fastest
            lines.append([name, target, found[0]["seconds"], f"{100 * bar:.2f}"] +
                         [", ".join(f"{ratio:.2f}" for ratio in part) for part in parts])
    closing = []
    for said, group in (("The first twelve motors", TUNED), ("The other twelve", OTHERS)):
        if found := sum((by_motor[name] for name in group), []):
            n_above = sum(ratio > 1. + 1e-6 for ratio in found)  # counts of teeth differ by whole steps
            closing.append(f"{said}, {len(found)} quantities: the median of true error over bar is "
                           f"{statistics.median(found):.2f}, {n_above} are above 1 ({100. * n_above / len(found):.0f} %), "
                           f"the largest is {max(found):.1f}.")
    return table(header, lines) + ["", *closing], every


def draw(every, path):
    sys.path.insert(0, str(ROOT / "scripts"))
    from drawing import basics
    import numpy
    figure, axes = basics.plt.subplots(figsize=(6.2, 3.4), layout="constrained")
    for (target, found), color in zip(every.items(), (basics.BLUE, basics.ORANGE, basics.GREEN)):
        axes.step(numpy.sort(found), 100. * (numpy.arange(len(found)) + 1.) / len(found), where="post", color=color,
                  label=f"target {target}, {len(found)} quantities")
    axes.axvline(1., color=basics.GREY, lw=0.8)
    axes.set(xlabel="true error over error bar", ylabel="quantities below, %", xlim=(0, 2.5), ylim=(0, 102))
    axes.legend(frameon=False, loc="lower right")
    axes.spines[["top", "right"]].set_visible(False)
    figure.savefig(path, dpi=160)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("motors", nargs="*", default=list(MOTORS), metavar="MOTOR", help=", ".join(MOTORS))
    parser.add_argument("--inertia", dest="kind", action="store_const", const=WITH_INERTIA, default=WITHOUT_INERTIA,
                        help="motors with inertia of teeth and rotor")
    parser.add_argument("--csv", type=pathlib.Path, help="the file of all rows")
    parser.add_argument("--resume", action="store_true", help="keep the rows of that file, run what it lacks")
    parser.add_argument("--markdown", type=pathlib.Path, help="also write the tables to this file")
    parser.add_argument("--figure", type=pathlib.Path, help="file of the figure of the distribution")
    options = parser.parse_args()
    kind = options.kind
    csv = options.csv or ROOT / "output" / f"{kind.name}.csv"
    rows = RowFile(csv, COLUMNS, options.resume)
    for name in options.motors:
        compute(kind, name, rows, csv.with_suffix(f".{name.replace(' ', '_')}"))
    lines, every = evaluate(kind, rows)
    print("\n".join(lines))
    if options.markdown:
        write_markdown(options.markdown, lines)
    if options.figure:
        draw(every, options.figure)


if __name__ == "__main__":
    main()
