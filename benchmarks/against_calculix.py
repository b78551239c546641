#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Natural frequencies of the rotor or the stator, compared to those that CalculiX finds.

usage: benchmarks/against_calculix.py [FILE.prm ...] [--body rotor | stator | both] [--programs DIR] [--markdown FILE]
                                      [--waves 7 14] [--sizes 0.08 0.04 0.02] [--target 3e-4]
                                      [--cells 1 2 3] [--targets 1e-2 1e-3 3e-4 1e-4 3e-5] [--last 12] [--repeat 3]

Rotor (--waves, --sizes, --target): CalculiX (Debian package calculix-ccx) gets a mesh of quadratic bricks (C3D20) over
a quarter of a wave: symmetric at theta = 0, antisymmetric at pi/(2n). Its spectrum holds modes of n, 3n, 5n, ...
waves; those of n waves are told by the displacement along circles, and compared in ascending order. Cells at the two
re-entrant corners where the flange leaves the ring have the size given by --sizes and grow from there. Frequencies
converge as h^1.089, twice the exponent of the stress singularity at a corner of 270 degrees of metal; they are
extrapolated from the last two sizes. Their uncertainty is half of this step, and a share for the cells far from the
corners, which are the same on all meshes. Both models have a solid flange and no radial bars: those of ringmotor hold
a band of the surface, CalculiX would need springs at nodes.

Stator (--cells, --targets, --last, --repeat): both programs find the two lowest elastic modes, of the motor's wave
alone and of 0 to --last nodal diameters, on the sector of one tooth. CalculiX has no half sector: its *CYCLIC SYMMETRY
MODEL couples two copies of the whole one. Rings of cells around the slot root have sizes in proportion to 1, 8, 27,
..., so that all errors decrease as the fourth power of the number of cells (--cells along each side of the
quadrilaterals of the section). With the fully integrated C3D20 all frequencies decrease to their limits; those of the
last two meshes are extrapolated, with half of the step as their uncertainty. C3D20R (reduced integration) costs the
same and has a smaller error, but of either sign. It does not run on the finest mesh for all nodal diameters, to save
time. The cost at equal true error takes the better of both. True errors are the largest of all modes of a run,
relative to the mean of CalculiX's limit and of what elements of degree 6 give in ringmotor, weighted by the inverse
squares of their uncertainties. Both programs run on one thread.
"""
import argparse
import datetime
import json
import math
import pathlib
import platform
import statistics
import sys
import tempfile
from dataclasses import dataclass

import numpy

sys.dont_write_bytecode = True
from calculix import check_installed, run_calculix  # noqa: E402
from calculix_bodies import CELLS_PER_QUARTER, Rotor, Stator  # noqa: E402
from motor_run import OUTPUT_OFF, table, write_markdown  # noqa: E402
from timed_run import MOTOR, PAPERS_MODEL, PROGRAMS, ROOT, arguments, limited_run, program  # noqa: E402

ROTORS = [ROOT / "prm" / name for name in ("soft_spring.prm", "stiff_spring.prm")]
N_MODES = {"rotor": 4, "stator": 2}  # for each number of waves
CORNER_EXPONENT = 2. * 0.544484  # root of sin(3 pi/2 x) = x, the symmetric singularity of a plane corner
# Relative: with n = 14 on the reference motor, 1.8 times as many cells across the ring lower the frequencies that
# hardly depend on the corners by at most 3.3e-5, 1.6 times as many along theta by 2e-6.
FAR_CELLS = 4e-5
SMOOTH_EXPONENT = 4.  # of quadratic elements where cells shrink fast enough towards the corners
# Whether cells get thinner near the inner and the outer side of the stator: between 2 and 3 cells C3D20 then converges
# with an exponent of 3.7 instead of 2.9, whereas C3D20R has twice the error in the in-plane mode.
ELEMENTS = {"C3D20": True, "C3D20R": False}
BEST = {"Accuracy/Mode": "fixed", "Accuracy/Polynomial degree": "6", "Accuracy/Refinement": "3"}
RIGID = 10.  # Hz: motions of the free sector as a rigid body are below
EQUAL_ERRORS = (2e-3, 1e-3, 3e-4, 1e-4, 3e-5)


def run_ringmotor(path, motor, folder, body, entries):
    """Modes of a body, ascending for each number of waves; all entries used; and the cost."""
    entries = {**OUTPUT_OFF, "Modes/Body": body, "Modes/Number of modes": str(N_MODES[body]),
               "Modes/Frequency target": "0", **entries}
    done = limited_run([str(path)] + arguments(motor, folder, entries))
    if done.status != 0:
        sys.exit(f"stator {motor}: {done.message}")
    summary = json.loads((folder / body / "summary.json").read_text())
    modes = [quantity for quantity in summary["quantities"] if quantity["name"] == "frequency"]
    return sorted(modes, key=lambda mode: (mode["n"], mode["value"])), summary, done


def extrapolated(sizes, frequencies, exponent):
    """The limit for small cells and half the step to it, by the exponent of the last two sizes."""
    before, last = frequencies[-2:]
    step = (before - last) / ((sizes[-2] / sizes[-1]) ** exponent - 1.)
    return last - step, 0.5 * abs(step)


def waves_of(motion, circles):
    """The number of waves of a mode over that of the mesh: 1, 3 or 5."""
    theta = numpy.linspace(0., 0.5 * math.pi, 2 * CELLS_PER_QUARTER + 1)
    weights = numpy.ones(len(theta))
    weights[[0, -1]] = 0.5  # these sums are zero for products of different waves
    energy = {}
    for factor in (1, 3, 5):
        shape = numpy.stack([numpy.cos(factor * theta), numpy.sin(factor * theta), numpy.cos(factor * theta)], axis=1)
        energy[factor] = sum(numpy.sum((weights[:, None] * shape * numpy.array([motion[node] for node in circle]))
                                       .sum(axis=0) ** 2) for circle in circles)
    return max(energy, key=energy.get)


def rotor_modes(rotor, n_waves, size, folder):
    """The lowest modes of n waves on a mesh with cells of this size at the corners, and the seconds."""
    mesh = rotor.mesh(n_waves, size)
    run = run_calculix(mesh, rotor.materials, rotor.cards(mesh, n_waves), folder)
    circles = rotor.circles(mesh)
    found = [frequency for (_, frequency), motion in zip(run.modes, run.motions) if waves_of(motion, circles) == 1]
    if len(found) < N_MODES["rotor"]:
        sys.exit(f"CalculiX found {len(found)} of {N_MODES['rotor']} modes of {n_waves} waves")
    return found[:N_MODES["rotor"]], run.cost.seconds


def rotor_rows(motor, n_waves, options, path):
    """A row for each mode."""
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        ours, summary, cost = run_ringmotor(path, motor, folder, "rotor", {
            "Modes/Nodal diameters": str(n_waves), "Rotor/Flange element": "solid", "Rotor/Radial bar stiffness": "0",
            "Accuracy/Mode": "adaptive", "Accuracy/Target": options.target})
        rotor = Rotor.of(summary["entries"])
        runs = [rotor_modes(rotor, n_waves, 1e-3 * size, folder) for size in options.sizes]
    all_seconds = ", ".join(f"{seconds:.0f}" for _, seconds in runs)
    for mode, theirs in zip(ours, zip(*(frequencies for frequencies, _ in runs))):
        limit, uncertainty = extrapolated(options.sizes, theirs, CORNER_EXPONENT)
        yield [motor.stem, n_waves, mode["family"], *(f"{frequency:.1f}" for frequency in theirs),
               shown_exponent(options.sizes, theirs), f"{limit:.1f} +- {uncertainty + FAR_CELLS * theirs[-1]:.1f}",
               f"{mode['value']:.1f} +- {mode['error']:.1f}", f"{mode['value'] / limit - 1.:+.1e}", all_seconds,
               f"{cost.seconds:.0f}"]


def shown_exponent(sizes, frequencies):
    """What three sizes show, if each is the same part of the one before."""
    if len(sizes) < 3 or not math.isclose(sizes[-3] * sizes[-1], sizes[-2] ** 2):
        return ""
    first, before, last = frequencies[-3:]
    return (f"{math.log((first - before) / (before - last)) / math.log(sizes[-2] / sizes[-1]):.2f}"
            if first > before > last else "")


def rotor_lines(options, path):
    rows = []
    for motor in options.motors or ROTORS:
        for n_waves in options.waves:
            for row in rotor_rows(motor, n_waves, options, path):
                rows.append(row)
                print(" | ".join(str(cell) for cell in row), flush=True)
    header = ["motor", "n", "mode", *(f"CalculiX, {size} mm" for size in options.sizes), "exponent", "extrapolated, Hz",
              "ours, Hz", "difference", "s, CalculiX", "s, ours"]
    return table(header, rows)


@dataclass
class Case:
    """Runs of one of the programs on the stator with one setting."""
    program: str
    setting: str
    modes: dict  # Hz, ascending, by nodal diameter
    n_dofs: int
    seconds: float  # of the processor
    memory: float  # MB

    def true_error(self, true_modes):
        return max(abs(found / true - 1.) for n, frequencies in self.modes.items()
                   for found, true in zip(frequencies, true_modes[n]))


def by_diameter(pairs):
    """Frequencies by nodal diameter."""
    modes = {}
    for n, frequency in pairs:
        modes.setdefault(n, []).append(frequency)
    return modes


class StatorComparison:
    """Both programs on the stator of one motor. The runs of degree 6 take 4 minutes and 6 GB."""

    def __init__(self, motor, options, path):
        self.motor, self.options, self.path = motor, options, path
        self.all_diameters = range(options.last + 1)
        self.best, summary, self.best_cost = self._run_ringmotor(BEST, self.all_diameters)
        self.best_dofs = summary["dofs"]
        entries = summary["entries"]
        self.stator = Stator.of(entries)
        wave = int(entries["Motor/Number of waves"])
        if wave > options.last:
            sys.exit(f"--last is less than the number of waves, {wave}")
        self.wave_alone = range(wave, wave + 1)
        self.cases = {diameters: self._cases(diameters) for diameters in (self.wave_alone, self.all_diameters)}

    def _cases(self, diameters):
        cases = [self._case("ringmotor", f"target {target}", diameters,
                            lambda target=target: self._ringmotor(target, diameters))
                 for target in self.options.targets]
        for element in ELEMENTS:
            is_left_out = element == "C3D20R" and diameters == self.all_diameters  # on the finest mesh
            cases += [self._case(element, f"cells {n_cells}", diameters,
                                 lambda element=element, n_cells=n_cells: self._calculix(element, n_cells, diameters))
                      for n_cells in (self.options.cells[:-1] if is_left_out else self.options.cells)]
        return cases

    def _case(self, name, setting, diameters, run):
        """The medians of the runs for the wave alone; the others are longer and not repeated."""
        runs = [run() for _ in range(self.options.repeat if diameters == self.wave_alone else 1)]
        modes, n_dofs, _ = runs[0]
        case = Case(name, setting, modes, n_dofs, statistics.median(cost.processor_seconds for _, _, cost in runs),
                    statistics.median(cost.memory for _, _, cost in runs))
        print(f"{name}, {setting}, n = {shown(diameters)}: {case.seconds:.2f} s, {case.memory:.0f} MB", flush=True)
        return case

    def _run_ringmotor(self, entries, diameters):
        with tempfile.TemporaryDirectory() as scratch:
            return run_ringmotor(self.path, self.motor, pathlib.Path(scratch), "stator", {
                **PAPERS_MODEL, "Accuracy/Contact target": "0.5", "Stator/Piezoceramic element": "solid",
                "Modes/Nodal diameters": shown(diameters), **entries})

    def _ringmotor(self, target, diameters):
        modes, summary, cost = self._run_ringmotor({"Accuracy/Mode": "adaptive", "Accuracy/Target": target}, diameters)
        return by_diameter((mode["n"], mode["value"]) for mode in modes), summary["dofs"], cost

    def _calculix(self, element, n_cells, diameters):
        mesh = self.stator.mesh(n_cells, ELEMENTS[element])
        with tempfile.TemporaryDirectory() as scratch:
            run = run_calculix(mesh, self.stator.materials, self.stator.cards(mesh, diameters, N_MODES["stator"]),
                               pathlib.Path(scratch), element)
        modes = by_diameter((n, frequency) for n, frequency in run.modes if frequency > RIGID)
        modes = {n: frequencies[::2][:N_MODES["stator"]] for n, frequencies in modes.items()}  # each is found twice
        return modes, 3 * len(mesh.places), run.cost

    def lines(self):
        sizes = [1. / n_cells for n_cells in self.options.cells]
        runs = [case.modes for case in self.cases[self.all_diameters] if case.program == "C3D20"]
        frequencies, true_modes, numbers = [], {}, {}
        for mode in self.best:
            n, ours = mode["n"], mode["value"]
            index = numbers[n] = numbers.get(n, -1) + 1
            limit, uncertainty = extrapolated(sizes, [modes[n][index] for modes in runs], SMOOTH_EXPONENT)
            weights = mode["error"] ** -2, uncertainty ** -2
            true_modes.setdefault(n, []).append(numpy.average([ours, limit], weights=weights))
            frequencies.append([n, mode["family"], f"{ours:.2f} +- {mode['error']:.2f}",
                                f"{limit:.2f} +- {uncertainty:.2f}", f"{ours / limit - 1.:+.1e}",
                                f"{abs(ours - limit) / (mode['error'] + uncertainty):.2f}"])
        return [f"`{self.motor.name}`, one core of a machine with {processor()}, {datetime.date.today().isoformat()}; "
                f"medians of {self.options.repeat} runs for n = {shown(self.wave_alone)}:", "",
                *self._costs(true_modes), "", *self._runs(true_modes), "",
                *table(["n", "mode", "ringmotor, Hz", "CalculiX, Hz", "difference", "over both uncertainties"],
                       frequencies)]

    def _runs(self, true_modes):
        return table(["program", "n", "setting", "dofs", "processor s", "memory MB", "true error"],
                     [[case.program, shown(diameters), case.setting, case.n_dofs, f"{case.seconds:.2f}",
                       f"{case.memory:.0f}", f"{case.true_error(true_modes):.1e}"]
                      for diameters, cases in self.cases.items() for case in cases] +
                     [["ringmotor", shown(self.all_diameters), "degree 6", self.best_dofs,
                       f"{self.best_cost.processor_seconds:.0f}", f"{self.best_cost.memory:.0f}", ""]])

    def _costs(self, true_modes):
        rows = []
        for diameters, cases in self.cases.items():
            for error in EQUAL_ERRORS:
                ours = cost_at(error, [case for case in cases if case.program == "ringmotor"], true_modes)
                theirs = min((cost for element in ELEMENTS if (cost := cost_at(
                    error, [case for case in cases if case.program == element], true_modes))), default=None)
                row = [shown(diameters), f"{error:.0e}"]
                for i, digits in ((0, 2), (1, 0)):  # seconds, memory
                    row += [f"{cost[2]}{cost[i]:.{digits}f}" if cost else "-" for cost in (ours, theirs)]
                    row.append(f"{theirs[i] / ours[i]:.2g}" if ours and theirs else "-")
                rows.append(row)
        return table(["n", "true error", "ringmotor, s", "CalculiX, s", "ratio", "ringmotor, MB", "CalculiX, MB",
                      "ratio"], rows)


def cost_at(error, cases, true_modes):
    """Processor seconds and memory at this true error, interpolated between the runs that are better than all
    cheaper ones, and "at most " where the cheapest run is better; None where no run is as good."""
    front = []
    for case in sorted(cases, key=lambda case: case.seconds):
        if not front or case.true_error(true_modes) < front[-1][0]:
            front.append((case.true_error(true_modes), case.seconds, case.memory))
    if error >= front[0][0]:
        return *front[0][1:], "at most "
    if error < front[-1][0]:
        return None
    logarithms = numpy.log(front[::-1]).T
    return *(math.exp(numpy.interp(math.log(error), logarithms[0], line)) for line in logarithms[1:]), ""


def shown(diameters):
    return f"{diameters[0]}-{diameters[-1]}" if len(diameters) > 1 else f"{diameters[0]}"


def processor():
    names = [line.partition(":")[2].strip() for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines()
             if line.startswith("model name")]
    return names[0] if names else platform.machine()


def stator_lines(options, path):
    lines = []
    for motor in options.motors or [MOTOR]:
        lines += ([""] if lines else []) + StatorComparison(motor, options, path).lines()
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("motors", nargs="*", type=pathlib.Path, metavar="FILE.prm")
    parser.add_argument("--body", choices=("rotor", "stator", "both"), default="both")
    parser.add_argument("--waves", type=int, nargs="+", default=[7, 14], help="rotor: numbers of waves around the ring")
    parser.add_argument("--sizes", type=float, nargs="+", default=[0.08, 0.04, 0.02],
                        help="rotor: of the cells at the corners in CalculiX's meshes, in mm, descending; at least two")
    parser.add_argument("--target", default="3e-4", help="rotor: Accuracy/Target of our modes")
    parser.add_argument("--cells", type=int, nargs="+", default=[1, 2, 3],
                        help="stator: in CalculiX's meshes, ascending; at least two")
    parser.add_argument("--targets", nargs="+", default=["1e-2", "1e-3", "3e-4", "1e-4", "3e-5"],
                        help="stator: Accuracy/Target of our modes")
    parser.add_argument("--last", type=int, default=12, help="stator: the last of all nodal diameters")
    parser.add_argument("--repeat", type=int, default=3, help="stator: runs of each case with the wave alone")
    parser.add_argument("--programs", default=PROGRAMS, help="the folder of the programs")
    parser.add_argument("--markdown", help="also write the tables to this file")
    options = parser.parse_args()
    for name, values in (("--sizes", [-size for size in options.sizes]), ("--cells", options.cells)):
        if len(values) < 2 or sorted(set(values)) != values:
            parser.error(f"{name} needs two or more, in order")
    if min(options.waves + options.cells) < 1:
        parser.error("--waves and --cells need numbers from 1")
    if options.markdown and options.body == "both":
        parser.error("--markdown needs --body rotor or --body stator: their tables are in different pages")
    check_installed()
    path = program("stator", options.programs)
    for body, make_lines in (("rotor", rotor_lines), ("stator", stator_lines)):
        if options.body in (body, "both"):
            lines = make_lines(options, path)
            print("\n".join(lines))
            if options.markdown:
                write_markdown(options.markdown, lines)


if __name__ == "__main__":
    main()
