# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies given by a section that is revolved, as meshes for CalculiX: one pitch of a stator with teeth, or a small
sector of a body of revolution.

The cells are those between lines of constant r, theta and z, graded towards re-entrant edges. Where a line has one
cell between two stops on level 1, it has m on level m. Around the slots and along theta the level may be another one.
"""
import math
from dataclasses import dataclass

import numpy

from calculix import cyclic_cards, extruded, nodes_card
from calculix_bodies import rectangles

CLOSE = 1e-9  # m
# How cells between two stops are graded: < and ( towards the lower one, > and ) towards the upper one
GRADINGS = {"-": lambda t: t, "<": lambda t: t ** 3, ">": lambda t: 1. - (1. - t) ** 3,
            "(": lambda t: t ** 2, ")": lambda t: 1. - (1. - t) ** 2}
# Young modulus (Pa), Poisson ratio, density (kg/m^3)
BRONZE = (110e9, 0.33, 8800.)  # phosphor bronze
CERAMIC = (81e9, 0.31, 7600.)  # lead zirconate titanate, taken as isotropic, without coupling
ALUMINIUM = (68.9e9, 0.33, 2700.)
LINING = (2e9, 0.35, 1500.)  # filled polymer


@dataclass
class Block:
    """A rectangle of the section."""
    part: str
    radii: tuple
    heights: tuple


@dataclass
class Section:
    """Lengths in m. A line is its first place and then: next stop, cells on level 1, grading, and True where the other
    level holds. That along theta runs from 0 in the middle of the sector to 1 at its end; with teeth, to 1 at
    the slot's wall and 2 at the end."""
    blocks: list
    materials: dict  # by the part
    radial_line: list
    axial_line: list
    angular_line: list
    n_sectors: int
    slot_width: float = 0.  # of slots with parallel walls, where a part "tooth" ends
    clamped_radius: float = 0.  # 0: free

    @property
    def half_pitch(self):
        return math.pi / self.n_sectors

    @property
    def slots_from(self):
        """The smallest radius of the teeth."""
        return min(block.radii[0] for block in self.blocks if block.part == "tooth")

    def mesh(self, level, other_level):
        heights, radii, half = (places(line, level, other_level)
                                for line in (self.axial_line, self.radial_line, self.angular_line))
        section = [(corners, part) for corners in rectangles(heights, radii)
                   if (part := self._part_at(*numpy.mean(corners, axis=0)))]
        return extruded(section, numpy.concatenate((-half[:0:-1], half)), self._place,
                        lambda part, s: part != "tooth" or abs(s) < 1.)

    def _part_at(self, z, r):
        return next((block.part for block in self.blocks
                     if block.radii[0] < r < block.radii[1] and block.heights[0] < z < block.heights[1]), None)

    def _place(self, z, r, s):
        """Walls of slots are parallel, so that their angle depends on r, but only where there are teeth: further
        inside, slots would overlap."""
        if self.slot_width == 0.:
            return r, s * self.half_pitch, z
        wall = self.half_pitch - math.asin(0.5 * self.slot_width / max(r, self.slots_from))
        distance = abs(s) * wall if abs(s) <= 1. else wall + (abs(s) - 1.) * (self.half_pitch - wall)
        return r, math.copysign(distance, s), z

    def cards(self, mesh, diameters, n_modes):
        clamped = []
        if self.clamped_radius > 0.:
            nodes = mesh.nodes_where(lambda r, theta, z: (abs(r - self.clamped_radius) < CLOSE) &
                                     (theta > CLOSE - self.half_pitch))  # the lower cut follows the upper one
            clamped = [*nodes_card("CLAMPED", nodes), "*BOUNDARY", "CLAMPED, 1, 3"]
        return clamped + cyclic_cards(mesh, self.half_pitch, self.n_sectors, diameters, n_modes)


def places(line, level, other_level):
    """The places of a line."""
    found = [line[0]]
    for stop, n_cells, grading, *is_other in line[1:]:
        n_cells = math.ceil((other_level if is_other else level) * n_cells)
        found += list(found[-1] + (stop - found[-1]) * GRADINGS[grading](numpy.arange(1, n_cells + 1) / n_cells))
    return numpy.array(found)


def disc_stator():
    """That of meshes/disc60_stator.geo."""
    web, ring = (10e-3, 22.5e-3), (22.5e-3, 30e-3)
    return Section(
        [Block("base", web, (0., 1e-3)), Block("base", ring, (0., 2.8e-3)), Block("tooth", ring, (2.8e-3, 4.8e-3)),
         Block("piezoceramic", ring, (-0.5e-3, 0.))],
        {"base": BRONZE, "tooth": BRONZE, "piezoceramic": CERAMIC},
        [10e-3, (12e-3, 1, "("), (20.5e-3, 2, "-"), (22.5e-3, 1, ">"), (26.25e-3, 1, "<"), (30e-3, 1, ")")],
        [-0.5e-3, (0., 1, ">"), (0.5e-3, 1, "<"), (1e-3, 1, ">"), (1.9e-3, 1, "<"), (2.8e-3, 2, ">", True),
         (4.8e-3, 2, "<", True)],
        [0., (1., 2, ">", True), (2., 1, "<", True)], 90, slot_width=0.7e-3, clamped_radius=10e-3)


def disc_rotor():
    """That of meshes/disc60_rotor.geo without adhesive, free."""
    top = 3.5e-3
    return Section(
        [Block("rotor", (5e-3, 9e-3), (0.5e-3, top)), Block("rotor", (9e-3, 25e-3), (2.5e-3, top)),
         Block("rotor", (25e-3, 30e-3), (0.5e-3, top)), Block("lining", (26e-3, 29e-3), (0., 0.5e-3))],
        {"rotor": ALUMINIUM, "lining": LINING},
        [5e-3, (9e-3, 1, ">"), (11e-3, 1, "<"), (23e-3, 2, "-"), (25e-3, 1, ">"), (26e-3, 1, "<"),
         (27.5e-3, 1, "("), (29e-3, 1, ")"), (30e-3, 1, "(")],
        [0., (0.5e-3, 1, ")"), (1.5e-3, 1, "("), (2.5e-3, 1, ">"), (top, 1, "<")],
        [0., (1., 1, "-", True)], 96)


def stepped_ring():
    """That of tests/sections/stepped_ring.geo, free."""
    return Section(
        [Block("base", (10e-3, 30e-3), (0., 2e-3)), Block("base", (20e-3, 30e-3), (2e-3, 4e-3))], {"base": BRONZE},
        [10e-3, (17e-3, 1, "-"), (20e-3, 1, ">"), (23e-3, 1, "<"), (30e-3, 1, "-")],
        [0., (1e-3, 1, "-"), (2e-3, 1, ">"), (3e-3, 1, "<"), (4e-3, 1, "-")],
        [0., (1., 1, "-", True)], 96)


def thin_plate(thickness):
    """A plate that is clamped at the inner edge, of the radii of benchmarks/annular_plates.py."""
    return Section(
        [Block("base", (10e-3, 30e-3), (0., thickness))], {"base": BRONZE},
        [10e-3, (12e-3, 2, "("), (28e-3, 4, "-"), (30e-3, 1, ")")], [0., (thickness, 0.5, "-")],
        [0., (1., 1, "-", True)], 96, clamped_radius=10e-3)
