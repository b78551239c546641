# SPDX-License-Identifier: LGPL-2.1-or-later
"""Meshes of half a sector of a disc motor whose bodies are not of revolution, in Gmsh's format 2.2: the stator's web
has a hole below each slot, the rotor's web one above each slot.

A mesh is a grid of cells between lines of r, theta and z; where there is none, there is no part.
"""
import itertools
import math

import numpy as np

N_TEETH = 90
HALF_PITCH = math.pi / N_TEETH
SIDE = HALF_PITCH - 0.35e-3 / 26e-3  # of the tooth
AROUND = (0.0, SIDE, HALF_PITCH)


def write_mesh(path, lines, part_of, face_of):
    """part_of(r, theta, z) of a cell's middle: its name or ""; face_of(r, z, normal) of an outer face that lies on no
    plane of the sector, with normal "r-", "r+", "z-" or "z+": its name or ""."""
    n = [len(of_direction) for of_direction in lines]
    middles = [0.5 * (np.array(line[1:]) + line[:-1]) for line in lines]

    def node(i, j, k):
        return 1 + i + n[0] * (j + n[1] * k)

    def part(place):
        inside = all(0 <= at < len(middle) for at, middle in zip(place, middles))
        return part_of(*(middle[at] for at, middle in zip(place, middles))) if inside else ""

    elements = []  # (dimension, name, nodes)
    around = ((0, 0), (1, 0), (1, 1), (0, 1))
    for place in itertools.product(*(range(len(middle)) for middle in middles)):
        if not part(place):
            continue
        i, j, k = place
        elements.append((3, part(place), [node(i + a, j + b, k + up) for up in (0, 1) for a, b in around]))
        for direction, upper in itertools.product(range(3), (0, 1)):
            beyond = list(place)
            beyond[direction] += 2 * upper - 1
            if part(beyond):
                continue
            at = [middle[index] for index, middle in zip(place, middles)]
            at[direction] = lines[direction][place[direction] + upper]
            if direction == 1:
                name = {0.0: "mirror", HALF_PITCH: "cut"}.get(at[1], "")
            else:
                name = face_of(at[0], at[2], "rtz"[direction] + "-+"[upper])
            if name:
                corners = []
                for a, b in around:
                    corner = list(place)
                    corner[direction] += upper
                    corner[(direction + 1) % 3] += a
                    corner[(direction + 2) % 3] += b
                    corners.append(node(*corner))
                elements.append((2, name, corners))
    names = sorted({(dimension, name) for dimension, name, _ in elements})
    with open(path, "w", encoding="ascii") as file:
        print("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames", len(names), sep="\n", file=file)
        for number, (dimension, name) in enumerate(names, start=1):
            print(dimension, number, f'"{name}"', file=file)
        print("$EndPhysicalNames\n$Nodes", n[0] * n[1] * n[2], sep="\n", file=file)
        for k, j, i in itertools.product(*(range(size) for size in reversed(n))):
            r, theta, z = lines[0][i], lines[1][j], lines[2][k]
            print(node(i, j, k), f"{r * math.cos(theta):.17g} {r * math.sin(theta):.17g} {z:.17g}", file=file)
        print("$EndNodes\n$Elements", len(elements), sep="\n", file=file)
        for number, (dimension, name, nodes) in enumerate(elements, start=1):
            kind = {3: 5, 2: 3}[dimension]
            print(number, kind, 2, names.index((dimension, name)) + 1, 1, *nodes, file=file)
        print("$EndElements", file=file)


def write_stator(path):
    """A ring with teeth, r = 22.5 to 30 mm, on a web that is clamped at r = 10 mm."""
    def part_of(r, theta, z):
        if r < 22.5e-3:
            is_hole = 14e-3 < r < 18e-3 and theta > SIDE
            return "base" if 0 < z < 1e-3 and not is_hole else ""
        if z < 0:
            return "piezoceramic"
        return "base" if z < 2.8e-3 else "tooth" if theta < SIDE else ""

    def face_of(r, z, normal):
        return ("clamped" if normal == "r-" and abs(r - 10e-3) < 1e-9 else
                "contact" if normal == "z+" and abs(z - 4.8e-3) < 1e-9 else "")

    write_mesh(path, ((10e-3, 14e-3, 18e-3, 22.5e-3, 26e-3, 29e-3, 30e-3), AROUND,
                      (-0.5e-3, 0.0, 1e-3, 2.8e-3, 4.8e-3)), part_of, face_of)


def write_rotor(path):
    """A hub, a web and a ring with a lining below it, r = 26 to 29 mm."""
    def part_of(r, theta, z):
        if z < 0:
            return "lining" if 26e-3 < r < 29e-3 else ""
        is_hole = 13e-3 < r < 17e-3 and theta > SIDE
        return "rotor" if (r < 9e-3 or r > 25e-3 or z > 2e-3) and not is_hole else ""

    def face_of(r, z, normal):
        return ("contact" if normal == "z-" and abs(z + 0.5e-3) < 1e-9 else
                "pressed" if normal == "z+" and r < 9e-3 else
                "driven" if normal == "r-" and abs(r - 5e-3) < 1e-9 else "")

    write_mesh(path, ((5e-3, 9e-3, 13e-3, 17e-3, 21e-3, 25e-3, 26e-3, 29e-3, 30e-3), AROUND,
                      (-0.5e-3, 0.0, 2e-3, 3e-3)), part_of, face_of)
