#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Natural frequencies of a ring with ears for mounting, on the whole ring, by CalculiX; and its mesh for ringmotor.

usage: benchmarks/ring_with_ears.py [--cells 3 4 5] [--modes 12] [--csv tests/wave/ring_with_ears.csv]
                                    [--mesh tests/wave/ring_with_ears.msh] [--markdown FILE] [--programs DIR]

A ring of 59.2 to 71.2 mm, 4.2 mm thick, with three ears of different length, width and distance: no two of its sectors
are equal. CalculiX (Debian package calculix-ccx) gets quadratic bricks (C3D20): the coarsest cells, each of whose edges
is divided by --cells; frequencies are extrapolated from three meshes as in sections_by_calculix.py. ringmotor reads the
coarsest cells (`Modes/Domain = ring`) and refines them itself.
"""
import argparse
import csv
import json
import math
import pathlib
import sys
import tempfile

import numpy

sys.dont_write_bytecode = True
from against_calculix import RIGID  # noqa: E402
from calculix import check_installed, extruded, run_calculix  # noqa: E402
from calculix_bodies import rectangles  # noqa: E402
from motor_run import OUTPUT_OFF, table, write_markdown  # noqa: E402
from sections_by_calculix import limit_of  # noqa: E402
from timed_run import PROGRAMS, ROOT, arguments, limited_run, program  # noqa: E402

BRONZE = (110e9, 0.33, 8800.)  # Young modulus (Pa), Poisson ratio, density (kg/m^3)
RADII = (29.6e-3, 35.6e-3)  # m, of the ring
HEIGHTS = (0., 4.2e-3)  # m
# Each ear: first and last cell of N_AROUND around the ring, its outer radius and its upper face
EARS = ((0, 2, 39.6e-3, 2.1e-3), (17, 18, 37.6e-3, 4.2e-3), (30, 33, 37.6e-3, 2.1e-3))
N_AROUND = 48
ENTRIES = {**OUTPUT_OFF, "Modes/Domain": "ring", "Effects/Felt support": "off", "Effects/Target plates": "off",
           "Effects/Piezoelectric coupling": "off", "Stator/Piezoceramic element": "solid",
           "Materials/Stator metal/Young modulus": str(BRONZE[0]), "Materials/Stator metal/Poisson ratio": str(BRONZE[1]),
           "Materials/Stator metal/Density": str(BRONZE[2])}


def section(n_cells):
    """Quadrilaterals of the section in z and r with the name of what they belong to: the ring, or a part of the ears
    between two radii and heights."""
    stops_z, stops_r = (HEIGHTS[0], 2.1e-3, HEIGHTS[1]), (*RADII, 37.6e-3, 39.6e-3)

    def line(stops):
        return numpy.interp(numpy.arange(n_cells * (len(stops) - 1) + 1) / n_cells, range(len(stops)), stops)

    for corners in rectangles(line(stops_z), line(stops_r)):
        z, r = numpy.mean(corners, axis=0)
        yield corners, "RING" if r < RADII[1] else f"EAR{sum(r > stop for stop in stops_r)}{sum(z > stop for stop in stops_z)}"


def is_there(name, station):
    """Whether a part of the section reaches an angle, in cells around the ring."""
    if name == "RING":
        return True
    radius, height = (36.6e-3 if name[3] == "2" else 38.6e-3), (1e-3 if name[4] == "1" else 3e-3)
    return any(first < station < last and radius < outer and height < top for first, last, outer, top in EARS)


def mesh(n_cells):
    return extruded(list(section(n_cells)), numpy.arange(n_cells * N_AROUND + 1) / n_cells,
                    lambda z, r, station: (r, 2. * math.pi * station / N_AROUND, z), is_there, closed=True)


def write_gmsh(path):
    """The coarsest cells as a mesh of Gmsh (format 2.2), all of them `base`."""
    coarse = mesh(1)
    bricks = [nodes[:8] for of_part in coarse.bricks.values() for nodes in of_part]
    number = {node: i for i, node in enumerate(sorted({node for nodes in bricks for node in nodes}), 1)}
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", "1", '3 1 "base"', "$EndPhysicalNames",
             "$Nodes", str(len(number))]
    for node, i in number.items():
        r, theta, z = coarse.places[node - 1]
        lines.append(f"{i} {r * math.cos(theta):.15g} {r * math.sin(theta):.15g} {z:.15g}")
    lines += ["$EndNodes", "$Elements", str(len(bricks))]
    lines += [f"{i} 5 2 1 1 " + " ".join(str(number[node]) for node in nodes) for i, nodes in enumerate(bricks, 1)]
    path.write_text("\n".join(lines + ["$EndElements"]) + "\n", encoding="utf-8")


def by_calculix(n_cells, n_modes):
    """Frequencies (Hz) of the lowest elastic modes, and the seconds."""
    body = mesh(n_cells)
    with tempfile.TemporaryDirectory() as folder:
        run = run_calculix(body, {name: BRONZE for name in body.bricks},
                           ["*STEP", "*FREQUENCY", f"{n_modes + 6}", "*END STEP"], pathlib.Path(folder))
    print(f"CalculiX, {n_cells}: {run.cost.processor_seconds:.0f} s", file=sys.stderr, flush=True)
    return [frequency for _, frequency in run.modes if frequency > RIGID][:n_modes], run.cost


def by_ringmotor(mesh_file, n_modes, programs, entries):
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        entries = {**ENTRIES, "Stator/Mesh file": str(mesh_file), "Modes/Number of modes": str(n_modes), **entries}
        run = limited_run([str(program("stator", programs))] +
                          arguments(ROOT / "prm" / "quick.prm", folder, entries))
        if run.status != 0:
            sys.exit(f"stator: {run.message}")
        summary = json.loads((folder / "ring_of_stator" / "summary.json").read_text())
    return [quantity for quantity in summary["quantities"] if quantity["name"] == "frequency"], run


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--cells", nargs=3, type=int, default=[3, 4, 5], help="by which edges are divided, ascending")
    parser.add_argument("--modes", type=int, default=12, help="elastic ones")
    parser.add_argument("--programs", default=PROGRAMS, help="the folder of the programs")
    parser.add_argument("--mesh", type=pathlib.Path, default=ROOT / "tests" / "wave" / "ring_with_ears.msh")
    parser.add_argument("--csv", type=pathlib.Path, help="also write CalculiX's frequencies to this file")
    parser.add_argument("--markdown", help="also write the table to this file")
    options = parser.parse_args()
    check_installed()
    write_gmsh(options.mesh)
    found, costs = zip(*(by_calculix(n, options.modes) for n in options.cells))
    limits = [limit_of(options.cells, of_mode)[:2] for of_mode in zip(*found)]
    ours, run = by_ringmotor(options.mesh, options.modes, options.programs, {"Accuracy/Target": "1e-3"})
    rows = [[i, f"{limit:.1f} ± {error:.1f}", f"{mode['value']:.1f} ± {mode['error']:.1f}",
             f"{abs(mode['value'] - limit) / (mode['error'] + error):.2f}"]
            for i, ((limit, error), mode) in enumerate(zip(limits, ours), 1)]
    lines = table(["mode", "CalculiX, Hz", "ringmotor, Hz", "difference over both error bars"], rows)
    lines += ["", f"Processor time: CalculiX {', '.join(f'{cost.processor_seconds:.0f}' for cost in costs)} s "
                  f"({', '.join(f'{cost.memory:.0f}' for cost in costs)} MB), ringmotor "
                  f"{run.processor_seconds:.0f} s ({run.memory:.0f} MB)."]
    print("\n".join(lines))
    if options.csv:
        with open(options.csv, "w", newline="", encoding="utf-8") as file:
            file.write("# Natural frequencies (Hz) of the ring of ring_with_ears.msh, by benchmarks/ring_with_ears.py: "
                       "CalculiX, C3D20,\n# extrapolated from three meshes, with half of the last step as uncertainty. Young "
                       f"modulus {BRONZE[0]:g} Pa, Poisson ratio {BRONZE[1]}, density {BRONZE[2]:g} kg/m^3.\n")
            writer = csv.writer(file)
            writer.writerow(["mode", "frequency_Hz", "uncertainty_Hz"])
            writer.writerows([i, f"{limit:.2f}", f"{error:.2f}"] for i, (limit, error) in enumerate(limits, 1))
    if options.markdown:
        write_markdown(options.markdown, lines)


if __name__ == "__main__":
    main()
