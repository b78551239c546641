# SPDX-License-Identifier: LGPL-2.1-or-later
"""The bodies of a motor as meshes for CalculiX: the rotor's quarter wave and the stator's sector of one tooth."""
import math
from dataclasses import dataclass

import numpy

from calculix import cyclic_cards, extruded, nodes_card

# Rotor
N_SOLVED = 8  # modes, with those of 3n and 5n waves
GROWTH = 0.25  # of the cells, per distance from a corner
CELLS_PER_WIDTH = 9  # of the ring, far from the corners
CELLS_PER_QUARTER = 9  # of a wave, along theta
# Stator
GRADING = 3  # power of the rings of cells around the slot root, so that errors there decrease as those far away
FACTOR = 2.5  # of the sizes of neighbouring quadrilaterals, about
CLOSE = 1e-9  # m or radians: nodes this close to a line or a face are on it


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


def rectangles(first_line, second_line):
    """The cells between two families of lines: four corners each, counterclockwise if both lines ascend."""
    for a, b in zip(first_line[:-1], first_line[1:]):
        for c, d in zip(second_line[:-1], second_line[1:]):
            yield [(a, c), (b, c), (b, d), (a, d)]


def material_of(entries, name):
    """Young modulus, Poisson ratio and density."""
    return tuple(float(entries[f"Materials/{name}/{entry}"]) for entry in ("Young modulus", "Poisson ratio", "Density"))


@dataclass
class Rotor:
    """Section and metal of a rotor, lengths in m."""
    ring_radii: tuple
    ring_faces: tuple
    flange_faces: tuple
    lip_radii: tuple
    materials: dict

    @staticmethod
    def of(entries):
        def number(name):
            return float(entries[f"Rotor/{name}"])

        flange = number("Flange lower face")
        return Rotor((number("Ring inner radius"), number("Ring outer radius")),
                     (number("Ring lower face"), number("Ring upper face")),
                     (flange, flange + number("Flange thickness")),
                     (number("Lip inner radius"), number("Lip outer radius")),
                     {"METAL": material_of(entries, "Rotor metal")})

    def mesh(self, n_waves, size):
        """A quarter of a wave, with cells of this size at the two corners where the flange leaves the ring."""
        largest = (self.ring_radii[1] - self.ring_radii[0]) / CELLS_PER_WIDTH
        heights = graded_line(sorted({*self.ring_faces, *self.flange_faces}), self.flange_faces, size, largest)
        radii = graded_line([*self.lip_radii, *self.ring_radii], self.ring_radii[:1], size, largest)
        section = [(corners, "METAL") for corners in rectangles(heights, radii)
                   if self._has_metal(*numpy.mean(corners, axis=0))]
        return extruded(section, numpy.linspace(0., 0.5 * math.pi / n_waves, CELLS_PER_QUARTER + 1),
                        lambda z, r, theta: (r, theta, z))

    def _has_metal(self, z, r):
        return r > self.ring_radii[0] or self.flange_faces[0] < z < self.flange_faces[1]

    def circles(self, mesh):
        """Nodes along theta at the inner edge of the lip and the outer edge of the ring, two rows from theta = 0."""
        return [sorted(mesh.nodes_where(lambda r, theta, z: abs(r - radius) + abs(z - height) < CLOSE),
                       key=lambda number: mesh.places[number - 1][1])
                for radius, height in ((self.lip_radii[0], self.flange_faces[1]),
                                       (self.ring_radii[1], self.ring_faces[1]))]

    def cards(self, mesh, n_waves):
        """Symmetric at theta = 0, antisymmetric a quarter of a wave further; displacements of all nodes are along r,
        theta, z."""
        end = 0.5 * math.pi / n_waves
        return (["*TRANSFORM, NSET=ALL, TYPE=C", "0, 0, 0, 0, 0, 1"] +
                nodes_card("BEGIN", mesh.nodes_where(lambda r, theta, z: theta < CLOSE)) +
                nodes_card("END", mesh.nodes_where(lambda r, theta, z: theta > end - CLOSE)) +
                nodes_card("CIRCLES", sum(self.circles(mesh), [])) +
                ["*BOUNDARY", "BEGIN, 2, 2", "END, 1, 1", "END, 3, 3", "*STEP", "*FREQUENCY", f"{N_SOLVED}",
                 "*NODE PRINT, NSET=CIRCLES, GLOBAL=NO", "U", "*END STEP"])


@dataclass
class Stator:
    """Section, teeth and materials of a stator, lengths in m. Its ceramic ring consists of solid cells."""
    n_teeth: int
    base_radii: tuple
    tip_radii: tuple
    base_thickness: float
    tooth_height: float
    slot_width: float
    piezoceramic_thickness: float
    materials: dict

    @staticmethod
    def of(entries):
        def number(name):
            return float(entries[f"Stator/{name}"])

        return Stator(int(entries["Motor/Number of teeth"]),
                      (number("Base inner radius"), number("Base outer radius")),
                      (number("Tip inner radius"), number("Tip outer radius")),
                      number("Base thickness"), number("Tooth height"), number("Slot width"),
                      number("Piezoceramic thickness"),
                      {"METAL": material_of(entries, "Stator metal"), "CERAMIC": material_of(entries, "Piezoceramic")})

    @property
    def half_pitch(self):
        return math.pi / self.n_teeth

    def mesh(self, n_cells, is_graded_radially):
        """The sector of one tooth, between the middles of two slots, with n_cells along each side of the
        quadrilaterals of its section and twice as many from the inner to the outer side: of equal lengths, or
        thinner near both sides, where the slots end."""
        stations = numpy.linspace(0., 1., 2 * n_cells + 1)
        if is_graded_radially:
            stations = 0.5 * (1. - numpy.cos(math.pi * stations))
        return extruded(self._section(n_cells), stations, self._place)

    def _place(self, s, z, rho):
        """s is 0 at the middle of the tooth, 1 at the slot's wall, 2 at the middle of the slot; rho runs from 0 to 1
        between the inner and the outer side. The slot's walls are parallel, so that the angle of s = 1 depends on r."""
        fraction = max(0., z) / (self.base_thickness + self.tooth_height)
        inner, outer = (base + fraction * (tip - base) for base, tip in zip(self.base_radii, self.tip_radii))
        r = inner + rho * (outer - inner)
        wall = self.half_pitch - math.asin(0.5 * self.slot_width / r)
        distance = abs(s) * wall if abs(s) <= 1. else wall + (abs(s) - 1.) * (self.half_pitch - wall)
        return r, math.copysign(distance, s), z

    def _section(self, n_cells):
        """Quadrilaterals in the plane of s and z; their sizes grow away from the slot root (s = 1, base thickness)."""
        half_slot = 0.5 * self.slot_width
        half_tooth = self.half_pitch * self.base_radii[0] - half_slot
        first = min(half_slot, half_tooth, self.tooth_height, self.base_thickness)
        section = []

        def lines(length):
            n_quads = max(round(math.log(length / first) / math.log(FACTOR)), int(length > first))  # beyond the first
            stops = [0., first] + [first * (length / first) ** (i / n_quads) for i in range(1, n_quads + 1)]
            return numpy.interp(numpy.arange(n_cells * (len(stops) - 1) + 1) / n_cells, range(len(stops)), stops)

        def add(cells, width, s_sign, z_sign, material):
            """Cells given by distances from the slot root, on both sides of the tooth."""
            for side in (1., -1.):
                for corners in cells:
                    placed = [(side * (1. + s_sign * x / width), self.base_thickness + z_sign * y) for x, y in corners]
                    section.append((placed if side * s_sign * z_sign > 0. else placed[::-1], material))

        ceramic = self.base_thickness + numpy.linspace(0., self.piezoceramic_thickness, (n_cells + 1) // 2 + 1)
        for width, s_sign in ((half_tooth, -1.), (half_slot, 1.)):
            for height, z_sign in ((self.tooth_height, 1.), (self.base_thickness, -1.)):
                if s_sign < 0. or z_sign < 0.:  # no metal in the slot
                    far = [corners for corners in rectangles(lines(width), lines(height))
                           if max(corners[2]) > first * (1. + 1e-9)]
                    add(far + list(root_cells(first, n_cells)), width, s_sign, z_sign, "METAL")
            if self.piezoceramic_thickness > 0.:
                add(list(rectangles(lines(width), ceramic)), width, s_sign, -1., "CERAMIC")
        return section

    def cards(self, mesh, diameters, n_modes):
        """The lowest modes of each nodal diameter."""
        return cyclic_cards(mesh, self.half_pitch, self.n_teeth, diameters, n_modes, CLOSE)


def root_cells(size, n_cells):
    """A square of this size with a corner at the origin in rings of cells around this corner, and a square of
    cells within the innermost ring."""
    rings = size * (numpy.arange(1, 2 * n_cells + 1) / (2. * n_cells)) ** GRADING
    steps = numpy.linspace(0., 1., n_cells + 1)
    yield from rectangles(rings[0] * steps, rings[0] * steps)
    for inner, outer in zip(rings[:-1], rings[1:]):
        for a, b in zip(steps[:-1], steps[1:]):
            yield [(inner, inner * a), (outer, outer * a), (outer, outer * b), (inner, inner * b)]
            yield [(inner * a, inner), (inner * b, inner), (outer * b, outer), (outer * a, outer)]
