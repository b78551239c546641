# SPDX-License-Identifier: LGPL-2.1-or-later
"""CalculiX (Debian package calculix-ccx) for the benchmarks: meshes of quadratic bricks, input, runs, frequencies."""
import math
import shutil
import sys
from dataclasses import dataclass

import numpy

import timed_run

CLOSE = 1e-12  # two nodes of a section with coordinates this close are one


@dataclass
class Mesh:
    """Quadratic bricks in cylindrical coordinates."""
    places: numpy.ndarray  # r, theta, z of the nodes 1, 2, ...
    bricks: dict  # by the name of their material: lists of 20 nodes

    def nodes_where(self, condition):
        """Numbers of the nodes whose r, theta, z fulfil a condition."""
        return [int(index) + 1 for index in numpy.flatnonzero(condition(*self.places.T))]


@dataclass
class Run:
    """One run of CalculiX."""
    modes: list  # (nodal diameter, frequency in Hz), as written
    motions: list  # for each mode the displacement along r, theta, z by node, if printed
    cost: timed_run.Run


def check_installed():
    if not shutil.which("ccx"):
        sys.exit("ccx is missing: install calculix-ccx")


def with_middles(line):
    """A line of places and the middles between them."""
    return numpy.insert(line, numpy.arange(1, len(line)), 0.5 * (line[1:] + line[:-1]))


def extruded(section, stations, place, is_there=lambda material, station: True, closed=False):
    """Bricks between stations over a section of quadrilaterals (four corners, material), whose two coordinates
    and that of the stations are right-handed in this order; `place` maps all three to r, theta, z. Middle nodes are
    mapped as well, so that they lie on curved surfaces. `is_there` tells by the station in the middle of a brick
    whether the material reaches there. If `closed`, the last station is the first one."""
    stations = with_middles(numpy.asarray(stations))
    numbers, places, bricks = {}, [], {}

    def number_of(point, station):
        station = station % (len(stations) - 1) if closed else station
        key = (*(math.floor(x / CLOSE + 0.37) for x in point), station)  # 0.37: round decimals are not at a step
        if key not in numbers:
            numbers[key] = len(numbers) + 1
            places.append(place(*point, stations[station]))
        return numbers[key]

    for corners, material in section:
        corners = numpy.asarray(corners)
        middles = 0.5 * (corners + numpy.roll(corners, -1, axis=0))
        for first in range(0, len(stations) - 1, 2):
            if not is_there(material, stations[first + 1]):
                continue
            bricks.setdefault(material, []).append(
                [number_of(point, station) for points, station in (
                    (corners, first), (corners, first + 2), (middles, first), (middles, first + 2),
                    (corners, first + 1)) for point in points])
    return Mesh(numpy.array(places), bricks)


def nodes_card(name, nodes):
    return [f"*NSET, NSET={name}"] + [f"{number}," for number in nodes]


def cyclic_cards(mesh, half_angle, n_sectors, diameters, n_modes, close=1e-9):
    """The lowest modes of each nodal diameter of a whole sector between minus and plus half an angle: each of them is
    found twice, and so are the motions of a free body as a rigid one, two each with 0 and 1 nodal diameters."""
    sides = [nodes_card(name, mesh.nodes_where(lambda r, theta, z, sign=sign: sign * theta > half_angle - close)) +
             [f"*SURFACE, NAME={name}FACE, TYPE=NODE", name] for name, sign in (("LOW", -1.), ("HIGH", 1.))]
    steps = []
    for group, n_solved in (([n for n in diameters if n < 2], 2 * n_modes + 4),
                            ([n for n in diameters if n >= 2], 2 * n_modes)):
        if group:
            steps += ["*STEP", "*FREQUENCY", f"{n_solved}",
                      f"*SELECT CYCLIC SYMMETRY MODES, NMIN={min(group)}, NMAX={max(group)}", "*END STEP"]
    return [*sides[0], *sides[1], "*TIE, POSITION TOLERANCE=1e-8, CYCLIC SYMMETRY, NAME=CUT", "LOWFACE, HIGHFACE",
            f"*CYCLIC SYMMETRY MODEL, N={n_sectors}, TIE=CUT, NGRAPH=1", "0, 0, 0, 0, 0, 1", *steps]


def write_input(path, mesh, materials, cards, element):
    """CalculiX's input: nodes, bricks, materials (Young modulus, Poisson ratio, density by name), then the cards."""
    lines = ["*NODE, NSET=ALL"]
    lines += [f"{number}, {r * math.cos(theta):.12e}, {r * math.sin(theta):.12e}, {z:.12e}"
              for number, (r, theta, z) in enumerate(mesh.places, 1)]
    n_bricks = 0
    for name, bricks in mesh.bricks.items():
        lines.append(f"*ELEMENT, TYPE={element}, ELSET={name}")
        for number, nodes in enumerate(bricks, n_bricks + 1):
            words = [str(word) for word in [number, *nodes]]
            lines += [", ".join(words[:16]) + ",", ", ".join(words[16:])]
        n_bricks += len(bricks)
    for name in mesh.bricks:
        young_modulus, poisson_ratio, density = materials[name]
        lines += [f"*MATERIAL, NAME={name}", "*ELASTIC", f"{young_modulus}, {poisson_ratio}", "*DENSITY", f"{density}",
                  f"*SOLID SECTION, ELSET={name}, MATERIAL={name}"]
    path.write_text("\n".join(lines + cards) + "\n")


def read_modes(path):
    """Nodal diameter (0 without cyclic symmetry) and frequency of each mode, and the displacements by node."""
    modes, motions = [], []
    for line in path.read_text().splitlines():
        words = line.split()
        if line.strip().startswith("displacements"):
            motions.append({})
        elif not motions and len(words) in (5, 6) and words[0].isdigit():
            numbers = [float(word) for word in words]
            modes.append((int(numbers[0]) if len(words) == 6 else 0, numbers[-2]))
        elif motions and words[-1:] == ["L"]:  # along the local axes
            motions[-1][int(words[0])] = numpy.array([float(word) for word in words[1:4]])
    return modes, motions


def run_calculix(mesh, materials, cards, folder, element="C3D20"):
    """Natural frequencies of a mesh; ends the benchmark if CalculiX fails."""
    write_input(folder / "body.inp", mesh, materials, cards, element)
    done = timed_run.limited_run(["env", f"--chdir={folder}", "ccx", "body"])
    if done.status != 0:
        sys.exit(f"CalculiX: {done.message}")
    return Run(*read_modes(folder / "body.dat"), done)
