#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Natural frequencies of the rotor, compared to those that CalculiX finds.

usage: benchmarks/against_calculix.py [FILE.prm ...] [--waves 7 14] [--sizes 0.08 0.04 0.02] [--target 3e-4]
                                      [--programs DIR] [--markdown FILE]

CalculiX (Debian package calculix-ccx) gets a mesh of quadratic bricks (C3D20) over a quarter of a wave: symmetric at
theta = 0, antisymmetric at pi/(2n). Its spectrum holds modes of n, 3n, 5n, ... waves; those of n waves are told by the
displacement along circles, and compared in ascending order. Cells at the two re-entrant corners where the flange leaves
the ring have the size given by --sizes and grow from there. Frequencies converge as h^1.089, twice the exponent of
the stress singularity at a corner of 270 degrees of metal; they are extrapolated from the last two sizes. Their
uncertainty is half of this step, and a share for the cells far from the corners, which are the same on all meshes.
Both models have a solid flange and no radial bars: those of ringmotor hold a band of the surface, CalculiX would need
springs at nodes.
"""
import argparse
import json
import math
import pathlib
import shutil
import sys
import tempfile
from dataclasses import dataclass

import numpy

sys.dont_write_bytecode = True
from contact_checks import entries_of  # noqa: E402
from motor_run import OUTPUT_OFF, table, write_markdown  # noqa: E402
from timed_run import PROGRAMS, ROOT, arguments, limited_run, program  # noqa: E402

MOTORS = [ROOT / "prm" / name for name in ("canon_ring.prm", "canon_stiff_spring.prm")]
N_MODES = 4  # of each number of waves
N_SOLVED = 8  # by CalculiX, with those of 3n and 5n waves
CORNER_EXPONENT = 2. * 0.544484  # root of sin(3 pi/2 x) = x, the symmetric singularity of a plane corner
# Relative: with n = 14 on the reference motor, 1.8 times as many cells across the ring lower the frequencies that
# hardly depend on the corners by at most 3.3e-5, 1.6 times as many along theta by 2e-6.
FAR_CELLS = 4e-5
GROWTH = 0.25  # of the cells, per distance from a corner
CELLS_PER_WIDTH = 9  # of the ring, far from the corners
CELLS_PER_QUARTER = 9  # of a wave, along theta
# Nodes of a C3D20 in steps of half a cell along r, theta, z.
BRICK = [(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (0, 0, 2), (2, 0, 2), (2, 2, 2), (0, 2, 2),
         (1, 0, 0), (2, 1, 0), (1, 2, 0), (0, 1, 0), (1, 0, 2), (2, 1, 2), (1, 2, 2), (0, 1, 2),
         (0, 0, 1), (2, 0, 1), (2, 2, 1), (0, 2, 1)]


@dataclass
class Rotor:
    """Section and metal of a rotor, lengths in m."""
    ring_radii: tuple
    ring_faces: tuple
    flange_faces: tuple
    lip_radii: tuple
    young_modulus: float
    poisson_ratio: float
    density: float

    @staticmethod
    def of(entries):
        def number(name):
            return float(entries[name])

        flange = number("Rotor/Flange lower face")
        return Rotor((number("Rotor/Ring inner radius"), number("Rotor/Ring outer radius")),
                     (number("Rotor/Ring lower face"), number("Rotor/Ring upper face")),
                     (flange, flange + number("Rotor/Flange thickness")),
                     (number("Rotor/Lip inner radius"), number("Rotor/Lip outer radius")),
                     *(number(f"Materials/Rotor metal/{name}")
                       for name in ("Young modulus", "Poisson ratio", "Density")))

    def has_metal(self, r, z):
        return r > self.ring_radii[0] or self.flange_faces[0] < z < self.flange_faces[1]


@dataclass
class Run:
    """Frequencies of one run of CalculiX in Hz, ascending."""
    frequencies: list
    seconds: float


def graded_line(stops, corners, size, largest):
    """Places between stops, each one included, with cells of a size that grows from corners up to the largest."""
    line = [stops[0]]
    for begin, end in zip(stops[:-1], stops[1:]):
        x = numpy.linspace(begin, end, 2001)
        wanted = numpy.minimum(largest, size + GROWTH * numpy.min([abs(x - corner) for corner in corners], axis=0))
        n_before = numpy.concatenate(([0.], numpy.cumsum(0.5 * numpy.diff(x) * (1. / wanted[1:] + 1. / wanted[:-1]))))
        n_cells = math.ceil(n_before[-1] - 1e-9)
        line += list(numpy.interp(numpy.arange(1, n_cells + 1) * n_before[-1] / n_cells, n_before, x))
    return numpy.array(line)


def with_middles(line):
    """A line of places and the middles between them."""
    return numpy.insert(line, numpy.arange(1, len(line)), 0.5 * (line[1:] + line[:-1]))


def mesh_of(rotor, n_waves, size):
    """Numbers of nodes by their places on the lines, their cylindrical coordinates, and the nodes of each brick."""
    largest = (rotor.ring_radii[1] - rotor.ring_radii[0]) / CELLS_PER_WIDTH
    lines = [with_middles(line) for line in (
        graded_line([*rotor.lip_radii, *rotor.ring_radii], rotor.ring_radii[:1], size, largest),
        numpy.linspace(0., 0.5 * math.pi / n_waves, CELLS_PER_QUARTER + 1),
        graded_line(sorted({*rotor.ring_faces, *rotor.flange_faces}), rotor.flange_faces, size, largest))]
    numbers, bricks = {}, []
    for i in range(0, len(lines[0]) - 1, 2):
        for k in range(0, len(lines[2]) - 1, 2):
            if not rotor.has_metal(lines[0][i + 1], lines[2][k + 1]):
                continue
            for j in range(0, len(lines[1]) - 1, 2):
                bricks.append([numbers.setdefault((i + a, j + b, k + c), len(numbers) + 1) for a, b, c in BRICK])
    places = [[line[index] for line, index in zip(lines, key)] for key in numbers]
    return numbers, places, bricks


def circles_of(numbers):
    """Nodes along theta at the inner edge of the lip and the outer edge of the ring, two rows from theta = 0."""
    n_angles = 2 * CELLS_PER_QUARTER + 1
    last = max(i for i, _, _ in numbers)
    flange = max(k for i, _, k in numbers if i == 0)
    ring = max(k for i, _, k in numbers if i == last)
    return [[numbers[i, j, k] for j in range(n_angles)] for i, k in ((0, flange), (last, ring))]


def write_input(path, rotor, numbers, places, bricks):
    """CalculiX's input; displacements of all nodes are along r, theta, z."""
    lines = ["*NODE, NSET=ALL"]
    lines += [f"{number}, {r * math.cos(theta):.12e}, {r * math.sin(theta):.12e}, {z:.12e}"
              for number, (r, theta, z) in enumerate(places, 1)]
    lines.append("*ELEMENT, TYPE=C3D20, ELSET=METAL")
    for number, nodes in enumerate(bricks, 1):
        words = [str(word) for word in [number, *nodes]]
        lines += [", ".join(words[:16]) + ",", ", ".join(words[16:])]
    lines += ["*MATERIAL, NAME=METAL", "*ELASTIC", f"{rotor.young_modulus}, {rotor.poisson_ratio}", "*DENSITY",
              f"{rotor.density}", "*SOLID SECTION, ELSET=METAL, MATERIAL=METAL", "*TRANSFORM, NSET=ALL, TYPE=C",
              "0, 0, 0, 0, 0, 1"]
    for name, nodes in (("BEGIN", [number for (_, j, _), number in numbers.items() if j == 0]),
                        ("END", [number for (_, j, _), number in numbers.items() if j == 2 * CELLS_PER_QUARTER]),
                        ("CIRCLES", sum(circles_of(numbers), []))):
        lines += [f"*NSET, NSET={name}"] + [f"{number}," for number in nodes]
    lines += ["*BOUNDARY", "BEGIN, 2, 2", "END, 1, 1", "END, 3, 3", "*STEP", "*FREQUENCY", f"{N_SOLVED}",
              "*NODE PRINT, NSET=CIRCLES, GLOBAL=NO", "U", "*END STEP"]
    path.write_text("\n".join(lines) + "\n")


def read_modes(path):
    """Frequencies in Hz, and for each mode the displacement along r, theta, z by node."""
    frequencies, motions = [], []
    for line in path.read_text().splitlines():
        words = line.split()
        if line.strip().startswith("displacements"):
            motions.append({})
        elif not motions and len(words) == 5 and words[0].isdigit():
            frequencies.append(float(words[3]))
        elif motions and words[-1:] == ["L"]:  # along the local axes
            motions[-1][int(words[0])] = numpy.array([float(word) for word in words[1:4]])
    return frequencies, motions


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


def run_calculix(rotor, n_waves, size, folder):
    """The lowest modes of n waves on a mesh with cells of this size at the corners."""
    numbers, places, bricks = mesh_of(rotor, n_waves, size)
    write_input(folder / "rotor.inp", rotor, numbers, places, bricks)
    done = limited_run(["env", f"--chdir={folder}", "ccx", "rotor"])
    frequencies, motions = read_modes(folder / "rotor.dat") if done.status == 0 else ([], [])
    found = [frequency for frequency, motion in zip(frequencies, motions)
             if waves_of(motion, circles_of(numbers)) == 1][:N_MODES]
    if len(found) < N_MODES:
        sys.exit(f"CalculiX found {len(found)} of {N_MODES} modes of {n_waves} waves: {done.message}")
    return Run(found, done.seconds)


def run_ringmotor(path, motor, n_waves, folder, target):
    """Our modes of n waves, ascending; all entries used; and seconds."""
    entries = {**OUTPUT_OFF, "Modes/Body": "rotor", "Modes/Nodal diameters": str(n_waves),
               "Modes/Number of modes": str(N_MODES), "Modes/Frequency target": "0", "Rotor/Flange element": "solid",
               "Rotor/Radial bar stiffness": "0", "Accuracy/Mode": "adaptive", "Accuracy/Target": target}
    done = limited_run([str(path)] + arguments(motor, folder, entries))
    if done.status != 0:
        sys.exit(f"stator {motor}: {done.message}")
    summary = json.loads((folder / "rotor" / "summary.json").read_text())
    modes = [quantity for quantity in summary["quantities"] if quantity["name"] == "frequency"]
    return sorted(modes, key=lambda mode: mode["value"])[:N_MODES], entries_of(summary["prm"]), done.seconds


def extrapolated(sizes, frequencies):
    """The limit for small cells, its uncertainty, and the exponent that three sizes show."""
    before, last = frequencies[-2:]
    step = (before - last) / ((sizes[-2] / sizes[-1]) ** CORNER_EXPONENT - 1.)
    exponent = ""
    if len(sizes) > 2 and math.isclose(sizes[-3] * sizes[-1], sizes[-2] ** 2) and frequencies[-3] > before > last:
        exponent = f"{math.log((frequencies[-3] - before) / (before - last)) / math.log(sizes[-2] / sizes[-1]):.2f}"
    return last - step, 0.5 * abs(step) + FAR_CELLS * last, exponent


def rows_of(motor, n_waves, options, path):
    """A row for each mode."""
    with tempfile.TemporaryDirectory() as scratch:
        ours, entries, seconds = run_ringmotor(path, motor, n_waves, pathlib.Path(scratch), options.target)
        runs = [run_calculix(Rotor.of(entries), n_waves, 1e-3 * size, pathlib.Path(scratch)) for size in options.sizes]
    all_seconds = ", ".join(f"{run.seconds:.0f}" for run in runs)
    for mode, theirs in zip(ours, zip(*(run.frequencies for run in runs))):
        limit, uncertainty, exponent = extrapolated(options.sizes, theirs)
        yield [motor.stem, n_waves, mode["family"], *(f"{frequency:.1f}" for frequency in theirs), exponent,
               f"{limit:.1f} +- {uncertainty:.1f}", f"{mode['value']:.1f} +- {mode['error']:.1f}",
               f"{mode['value'] / limit - 1.:+.1e}", all_seconds, f"{seconds:.0f}"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("motors", nargs="*", type=pathlib.Path, default=MOTORS, metavar="FILE.prm")
    parser.add_argument("--waves", type=int, nargs="+", default=[7, 14], help="numbers of waves around the ring")
    parser.add_argument("--sizes", type=float, nargs="+", default=[0.08, 0.04, 0.02],
                        help="of the cells at the corners in CalculiX's meshes, in mm, descending; at least two")
    parser.add_argument("--target", default="3e-4", help="Accuracy/Target of our modes")
    parser.add_argument("--programs", default=PROGRAMS, help="the folder of the programs")
    parser.add_argument("--markdown", help="also write the table to this file, or between its comments for it")
    options = parser.parse_args()
    if len(options.sizes) < 2 or sorted(set(options.sizes), reverse=True) != options.sizes:
        parser.error("--sizes needs two or more, descending")
    if min(options.waves) < 1:
        parser.error("--waves needs numbers from 1")
    if not shutil.which("ccx"):
        sys.exit("ccx is missing: install calculix-ccx")
    path = program("stator", options.programs)
    rows = []
    for motor in options.motors or MOTORS:
        for n_waves in options.waves:
            for row in rows_of(motor, n_waves, options, path):
                rows.append(row)
                print(" | ".join(str(cell) for cell in row), flush=True)
    header = ["motor", "n", "mode", *(f"CalculiX, {size} mm" for size in options.sizes), "exponent", "extrapolated, Hz",
              "ours, Hz", "difference", "s, CalculiX", "s, ours"]
    lines = table(header, rows)
    print("\n".join(lines))
    if options.markdown:
        write_markdown(options.markdown, "benchmarks/against_calculix.py", lines)


if __name__ == "__main__":
    main()
