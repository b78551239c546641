#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Natural frequencies of revolved sections by CalculiX, extrapolated, for the tests.

usage: benchmarks/sections_by_calculix.py [--sections disc_stator disc_rotor stepped_ring] [--last 10] [--modes 4]
                                          [--keep FOLDER] [--csv tests/structure/sections_calculix.csv]
       benchmarks/sections_by_calculix.py --thin 0.01 0.02 0.04

CalculiX (Debian package calculix-ccx) gets meshes of quadratic bricks with full integration (C3D20), made in
calculix_sections.py without the files of Gmsh, with cyclic symmetry: one tooth pitch of the stator, 3.75 degrees of the
others. Bodies without a clamped edge are free; their motions as rigid bodies are left out. With full integration all
frequencies decrease to their limits. These follow from three meshes with the exponent that they show, no
less than 1.5 and no more than 4, or from two with the exponent 4 where solutions are smooth; the uncertainty is half of
the step from the finest mesh to the limit, and at least 5e-6 of the frequency, for what CalculiX's seven digits and its
solver of eigenproblems leave.

There are two series of meshes: one is finer along r and z, the other along theta; with slots, the other is finer
around the slots in all directions. The limit is the frequency on the first mesh and the steps from there to the limits
of both series, whose uncertainties add up. A mesh that is finer in both ways differs from this by a term in proportion
to the product of both steps; this product over the frequency is uncertainty, too.

With --keep, meshes and results stay in a folder, and a run whose results are there is not repeated.

With --thin, thin plates of these thicknesses over their outer radius instead, for comparison with the exact
frequencies of benchmarks/annular_plates.py: parameters omega a^2 sqrt(rho h / D) and their limit for h = 0 by a
polynomial in h.
"""
import argparse
import csv
import math
import pathlib
import sys
import tempfile

import numpy
from scipy.optimize import brentq

sys.dont_write_bytecode = True
import calculix_sections  # noqa: E402
from against_calculix import RIGID, by_diameter, extrapolated  # noqa: E402
from calculix import check_installed, read_modes, run_calculix  # noqa: E402

# Meshes of both series: level, other level (see calculix_sections.py)
STATOR_SERIES = [(2, 1), (3, 1), (4, 1)], [(2, 1), (2, 2), (2, 3)]
SERIES = [(3, 1), (4, 1), (6, 1)], [(3, 1), (3, 2)]
SECTIONS = ("disc_stator", "disc_rotor", "stepped_ring")
EXPONENTS = 1.5, 4.  # the least and the largest
LEAST_UNCERTAINTY = 5e-6  # relative
CONSTANTS = "Young modulus (Pa), Poisson ratio, density (kg/m^3)"


def exponent_of(sizes, frequencies):
    """That of the errors on three meshes, within its bounds; on two, that of smooth solutions."""
    if len(frequencies) == 2:
        return EXPONENTS[1]
    first, before, last = frequencies
    if not first > before > last:
        return EXPONENTS[0]

    def excess(exponent):
        a, b, c = (size ** exponent for size in sizes)
        return (a - b) * (before - last) - (b - c) * (first - before)
    if excess(EXPONENTS[0]) > 0.:
        return EXPONENTS[0]
    if excess(EXPONENTS[1]) < 0.:
        return EXPONENTS[1]
    return brentq(excess, *EXPONENTS)


def limit_of(levels, frequencies):
    """The limit, its uncertainty and the exponent."""
    sizes = [1. / level for level in levels]
    exponent = exponent_of(sizes, frequencies)
    limit, uncertainty = extrapolated(sizes, frequencies, exponent)
    return limit, max(uncertainty, LEAST_UNCERTAINTY * limit), exponent


def modes_on(section, levels, options, folder):
    """The lowest elastic modes on one mesh, by n."""
    folder.mkdir(parents=True, exist_ok=True)
    if (folder / "body.dat").exists():
        modes, _ = read_modes(folder / "body.dat")
    else:
        mesh = section.mesh(*levels)
        cards = section.cards(mesh, range(options.last + 1), options.modes)
        modes = run_calculix(mesh, section.materials, cards, folder).modes
    modes = by_diameter((n, frequency) for n, frequency in modes if frequency > RIGID)
    for n, frequencies in modes.items():
        if not numpy.allclose(frequencies[::2], frequencies[1::2], rtol=1e-5):
            sys.exit(f"CalculiX did not find every mode of n = {n} twice: {folder}")
    return {n: frequencies[::2][:options.modes] for n, frequencies in modes.items()}


def series_of(section):
    return STATOR_SERIES if section.slot_width > 0. else SERIES


def limits(name, section, options, folder):
    """(n, mode, limit, uncertainty) of each mode."""
    series = series_of(section)
    runs = {levels: modes_on(section, levels, options, folder / f"{name}_{levels[0]}_{levels[1]}")
            for levels in dict.fromkeys(sum(series, []))}
    for n in range(options.last + 1):
        for mode in range(options.modes):
            found = {levels: run[n][mode] for levels, run in runs.items()}
            limit, uncertainty, exponents = limit_of_series(series, found)
            print(f"{name} {n:2} {mode + 1} {' '.join(f'{frequency:.2f}' for frequency in found.values())} exponents "
                  f"{exponents}: {limit:.2f} +- {uncertainty:.2f} ({uncertainty / limit:.1e})", flush=True)
            yield n, mode + 1, limit, uncertainty


def limit_of_series(series, found):
    """The limit of both series of meshes, its uncertainty and the exponents."""
    first = found[series[0][0]]
    uncertainty, steps, exponents = 0., [], []
    for which, levels in enumerate(series):
        limit, part, exponent = limit_of([pair[which] for pair in levels], [found[pair] for pair in levels])
        steps.append(limit - first)
        uncertainty += part
        exponents.append(f"{exponent:.2f}")
    uncertainty += abs(math.prod(steps)) / first
    return first + sum(steps), uncertainty, " ".join(exponents)


def header(sections):
    """Lines that tell how the file was made."""
    lines = ["Natural frequencies of revolved sections, extrapolated from CalculiX's on several meshes of quadratic",
             "bricks (C3D20) with cyclic symmetry, by benchmarks/sections_by_calculix.py. Mode 1 is the lowest elastic",
             f"one of n nodal diameters. Materials: {CONSTANTS}."]
    for name, section in sections.items():
        materials = "; ".join(f"{part} " + ", ".join(f"{constant:g}" for constant in constants)
                              for part, constants in section.materials.items())
        teeth = (f"; {section.n_sectors} teeth between slots with parallel walls of {1e3 * section.slot_width:g} mm"
                 if section.slot_width > 0. else "")
        support = f"clamped at r = {1e3 * section.clamped_radius:g} mm" if section.clamped_radius > 0. else "free"
        levels = ", ".join(map(str, dict.fromkeys(sum(series_of(section), []))))
        lines += [f"{name}: {materials};",
                  f"  {support}{teeth};", f"  levels {levels} of {name} in benchmarks/calculix_sections.py"]
    return ["# " + line for line in lines]


def sections_to_file(options, folder):
    sections = {name: getattr(calculix_sections, name)() for name in options.sections}
    rows = [[name, n, mode, f"{limit:.3f}", f"{uncertainty:.3f}"] for name, section in sections.items()
            for n, mode, limit, uncertainty in limits(name, section, options, folder)]
    if options.csv:
        with open(options.csv, "w") as file:
            file.write("\n".join(header(sections)) + "\n")
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(["section", "n", "mode", "frequency_Hz", "uncertainty_Hz"])
            writer.writerows(rows)


def thin_plates(options, folder):
    found = {}
    for ratio in options.thin:
        section = calculix_sections.thin_plate(30e-3 * ratio)
        young_modulus, poisson_ratio, density = section.materials["base"]
        stiffness = young_modulus * (30e-3 * ratio) ** 2 / 12. / (1. - poisson_ratio ** 2)  # over the thickness
        factor = 2. * math.pi * 30e-3 ** 2 * math.sqrt(density / stiffness)
        for n, mode, limit, _ in limits(f"thin_{ratio}", section, options, folder):
            found.setdefault((n, mode), []).append(factor * limit)
    for (n, mode), parameters in found.items():
        powers = numpy.vander(options.thin, len(options.thin), increasing=True)
        print(f"n {n} mode {mode}: {' '.join(f'{parameter:.5f}' for parameter in parameters)}, "
              f"limit {numpy.linalg.solve(powers, parameters)[0]:.5f}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--sections", nargs="+", choices=SECTIONS, default=list(SECTIONS))
    parser.add_argument("--last", type=int, default=10, help="the largest number of nodal diameters")
    parser.add_argument("--modes", type=int, default=4, help="for each of them")
    parser.add_argument("--thin", type=float, nargs="+", help="thicknesses of thin plates over the radius")
    parser.add_argument("--keep", type=pathlib.Path, help="folder for meshes and results")
    parser.add_argument("--csv", help="write the frequencies to this file")
    options = parser.parse_args()
    check_installed()
    with tempfile.TemporaryDirectory() as scratch:
        (thin_plates if options.thin else sections_to_file)(options, options.keep or pathlib.Path(scratch))


if __name__ == "__main__":
    main()
