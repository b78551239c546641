#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Exact vibrations and deflections of annular plates that are clamped at the inner edge and free at the outer one.

usage: benchmarks/annular_plates.py [--inner 10e-3] [--outer 30e-3] [--step 20e-3] [--step-ratio 2]
                                    [--poisson-ratio 0.33] [--thicknesses 0.01 0.02 0.05] [--modes 2] [--last 4]

Four tables, for deflections along cos(n theta):

plate: frequency parameters omega a^2 sqrt(rho h / D) of Kirchhoff's plate, with D = E h^3 / 12 / (1 - nu^2), the outer
radius a and the thickness h. The deflection is a sum of the Bessel functions J, Y, I, K of k r,
k^4 = rho h omega^2 / D.

Mindlin: the same parameters of Mindlin's plate, relative to Kirchhoff's, for several h / a. With the shear
coefficient 5 / (6 - nu) its bending waves are as fast as those of an infinite solid layer, up to terms of h^4.

stepped: frequency parameters of Kirchhoff's plate whose thickness is larger outside the step radius by the step
ratio, both parts symmetric about one plane; D and h in the parameter are those of the inner part. Deflection, slope,
moment and effective shear force are continuous at the step.

ring load: w D / q a^3 at the outer edge under a load of q cos(n theta) per length of the outer edge, and what shear
adds for n = 0: ln(a / b) D / (kappa G h a^2), with the inner radius b and kappa = 5 / 6.

A solid of the same shape differs from Kirchhoff's plate by terms of h / a, not only of its square: layers as wide as
the plate is thick run along a free edge where n > 0 (they lower its torsional stiffness by 0.63 h per length, which
Mindlin's plate has almost exactly) and along a clamped edge (which holds the expansion across the plate; no theory of
plates has this). Frequencies of solids must therefore be extrapolated with h and h^2, from three thin plates or more.
"""
import argparse
import math
from dataclasses import dataclass

import numpy
from scipy.optimize import brentq
from scipy.special import ive, jv, jvp, kve, yv, yvp

STEPS = 60  # in which roots are searched, per mode


@dataclass
class Functions:
    """Several radial functions at one radius: values, slopes, Laplacians of f(r) cos(n theta) and their slopes."""
    values: numpy.ndarray
    slopes: numpy.ndarray
    laplacians: numpy.ndarray
    laplacian_slopes: numpy.ndarray

    def rows(self, r, n, poisson_ratio):
        """Deflection, slope, and over D: radial moment and effective shear force."""
        factor = 1. - poisson_ratio
        return (self.values, self.slopes,
                self.laplacians - factor * (self.slopes / r - n ** 2 * self.values / r ** 2),
                self.laplacian_slopes - factor * n ** 2 / r ** 2 * (self.slopes - self.values / r))


def bessel_pair(k_squared, r, n, inner, outer):
    """Both solutions of Laplacian f + k^2 f = 0; where k^2 is negative, they are 1 at about one of the radii."""
    k = math.sqrt(abs(k_squared))
    if k_squared > 0.:
        values = numpy.array([jv(n, k * r), yv(n, k * r)])
        slopes = k * numpy.array([jvp(n, k * r), yvp(n, k * r)])
    else:
        decay = numpy.exp([k * (r - outer), k * (inner - r)])
        values = decay * [ive(n, k * r), kve(n, k * r)]
        slopes = 0.5 * k * decay * [ive(n - 1, k * r) + ive(n + 1, k * r), -kve(n - 1, k * r) - kve(n + 1, k * r)]
        size = [ive(n, k * outer), kve(n, k * inner)]
        values, slopes = values / size, slopes / size
    return values, slopes


def waves(k, r, n, inner, outer):
    """The four functions of Kirchhoff's plate."""
    pairs = [(sign * k ** 2, *bessel_pair(sign * k ** 2, r, n, inner, outer)) for sign in (1., -1.)]
    return Functions(*(numpy.concatenate(parts) for parts in zip(*(
        (values, slopes, -k_squared * values, -k_squared * slopes) for k_squared, values, slopes in pairs))))


def statics(r, n):
    """The four functions of Kirchhoff's plate at rest."""
    powers = [float(p) for p in {0: (0, 2), 1: (1, -1, 3)}.get(n, (n, -n, n + 2, 2 - n))]
    columns = [(r ** p, p * r ** (p - 1.), (p ** 2 - n ** 2) * r ** (p - 2.),
                (p ** 2 - n ** 2) * (p - 2.) * r ** (p - 3.)) for p in powers]
    log = math.log(r)
    if n == 0:
        columns += [(log, 1. / r, 0., 0.), (r ** 2 * log, 2. * r * log + r, 4. * log + 4., 4. / r)]
    elif n == 1:
        columns += [(r * log, log + 1., 2. / r, -2. / r ** 2)]
    return Functions(*numpy.array(columns).T)


def determinant(rows):
    """Of rows scaled to length 1."""
    matrix = numpy.array(rows)
    return numpy.linalg.det(matrix / numpy.linalg.norm(matrix, axis=1)[:, None])


@dataclass
class Plate:
    """An annulus with the outer radius 1 and the thickness 1 (inside the step, if there is one)."""
    inner: float
    poisson_ratio: float
    step: float = 0.
    step_ratio: float = 1.

    def uniform(self, parameter, n):
        """Zero at the frequency parameters of a plate without a step."""
        k = math.sqrt(parameter)
        at_inner, at_outer = (waves(k, r, n, self.inner, 1.).rows(r, n, self.poisson_ratio) for r in (self.inner, 1.))
        return determinant([*at_inner[:2], *at_outer[2:]])

    def stepped(self, parameter, n):
        """Zero at the frequency parameters of a plate with a step."""
        k = math.sqrt(parameter)
        k_outside = k / math.sqrt(self.step_ratio)
        inside = [waves(k, r, n, self.inner, self.step).rows(r, n, self.poisson_ratio)
                  for r in (self.inner, self.step)]
        outside = [waves(k_outside, r, n, self.step, 1.).rows(r, n, self.poisson_ratio) for r in (self.step, 1.)]
        nothing, stiffness = numpy.zeros(4), self.step_ratio ** 3
        rows = [numpy.concatenate([row, nothing]) for row in inside[0][:2]]
        rows += [numpy.concatenate([row, -factor * other])
                 for row, other, factor in zip(inside[1], outside[0], (1., 1., stiffness, stiffness))]
        return determinant(rows + [numpy.concatenate([nothing, row]) for row in outside[1][2:]])

    def mindlin(self, parameter, n, thickness):
        """Zero at the frequency parameters of Mindlin's plate."""
        def rows(r):
            return mindlin_rows(parameter, r, n, thickness, self)
        return determinant([*rows(self.inner)[:3], *rows(1.)[3:]])

    def edge_deflection(self, n):
        """w D / q a^3 at the outer edge under the load q cos(n theta) there."""
        at_inner, at_outer = (statics(r, n).rows(r, n, self.poisson_ratio) for r in (self.inner, 1.))
        amplitudes = numpy.linalg.solve([*at_inner[:2], *at_outer[2:]], [0., 0., 0., -1.])
        return at_outer[0] @ amplitudes

    def edge_shear(self, thickness):
        """What shear adds to w D / q a^3 for n = 0."""
        return -math.log(self.inner) * thickness ** 2 / (6. * (1. - self.poisson_ratio)) * 6. / 5.


def mindlin_rows(parameter, r, n, thickness, plate):
    """Deflection, rotations along r and theta, and over D or D (1 - nu) / 2: moments along r and theta, shear force.
    Waves of deflection have rotations along their gradient; a sixth and seventh function has rotations only."""
    nu = plate.poisson_ratio
    inertia, shear = thickness ** 2 / 12., thickness ** 2 / (6. * (1. - nu)) * (6. - nu) / 5.  # D / kappa G h
    fourth = parameter ** 2
    root = math.sqrt((inertia - shear) ** 2 + 4. / fourth)
    squares = [0.5 * fourth * (inertia + shear + sign * root) for sign in (1., -1.)]
    rest = inertia * fourth - 1. / shear
    columns = []
    for k_squared, other in (squares, squares[::-1]):
        factor = other / rest - 1.
        for f, slope in zip(*bessel_pair(k_squared, r, n, plate.inner, 1.)):
            second = -k_squared * f - slope / r + n ** 2 * f / r ** 2
            columns.append([f, factor * slope, -factor * n * f / r,
                            factor * (second + nu * (slope / r - n ** 2 * f / r ** 2)),
                            -2. * factor * n * (slope / r - f / r ** 2), (1. + factor) * slope])
    k_squared = 2. * rest / (1. - nu)
    for f, slope in zip(*bessel_pair(k_squared, r, n, plate.inner, 1.)):
        second = -k_squared * f - slope / r + n ** 2 * f / r ** 2
        columns.append([0., n * f / r, -slope, (1. - nu) * n * (slope / r - f / r ** 2),
                        -second + slope / r - n ** 2 * f / r ** 2, n * f / r])
    return numpy.array(columns).T


def roots(function, n_roots, first):
    """The lowest roots, searched in steps of a part of the first or of the last found."""
    found, x = [], 0.02 * first
    value = function(x)
    while len(found) < n_roots:
        step = max(first, found[-1] if found else 0.) / STEPS
        following = function(x + step)
        if value * following < 0.:
            found.append(brentq(function, x, x + step, xtol=1e-13, rtol=1e-14))
        x, value = x + step, following
    return found


def print_table(title, header, rows):
    print(title)
    print("  ".join(f"{name:>14}" for name in header))
    for row in rows:
        print("  ".join(f"{cell:>14}" if isinstance(cell, (int, str)) else f"{cell:14.10g}" for cell in row))
    print()


def print_tables(options):
    inner, step = options.inner / options.outer, options.step / options.outer
    plate = Plate(inner, options.poisson_ratio)
    stepped = Plate(inner, options.poisson_ratio, step, options.step_ratio)
    waves_around = range(options.last + 1)
    first = 3. / (1. - inner) ** 2  # a strip that is clamped at one end has 3.5
    names = ["n", *(f"mode {mode + 1}" for mode in range(options.modes))]
    parameters = [roots(lambda x, n=n: plate.uniform(x, n), options.modes, first) for n in waves_around]
    print_table(f"plate, b / a = {inner:.10g}, nu = {options.poisson_ratio}", names,
                [[n, *row] for n, row in enumerate(parameters)])
    for thickness in options.thicknesses:
        ratios = [[n, *numpy.divide(roots(lambda x, n=n, h=thickness: plate.mindlin(x, n, h), options.modes, first),
                                    parameters[n])] for n in waves_around]
        print_table(f"Mindlin over Kirchhoff, h / a = {thickness}", names, ratios)
    print_table(f"stepped at r / a = {step:.10g}, thickness ratio {options.step_ratio}", names,
                [[n, *roots(lambda x, n=n: stepped.stepped(x, n), options.modes, first)] for n in waves_around])
    print_table("ring load", ["n", "w D / q a^3", *(f"shear, {thickness}" for thickness in options.thicknesses)],
                [[n, plate.edge_deflection(n),
                  *(plate.edge_shear(thickness) if n == 0 else "" for thickness in options.thicknesses)]
                 for n in waves_around])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--inner", type=float, default=10e-3, help="radius, m")
    parser.add_argument("--outer", type=float, default=30e-3, help="radius, m")
    parser.add_argument("--step", type=float, default=20e-3, help="radius of the step, m")
    parser.add_argument("--step-ratio", type=float, default=2., help="thickness outside the step over that inside")
    parser.add_argument("--poisson-ratio", type=float, default=0.33)
    parser.add_argument("--thicknesses", type=float, nargs="+", default=[0.01, 0.02, 0.05], help="over the radius")
    parser.add_argument("--modes", type=int, default=2, help="for each n")
    parser.add_argument("--last", type=int, default=4, help="the largest n")
    options = parser.parse_args()
    if not 0. < options.inner < options.step < options.outer:
        parser.error("--inner, --step and --outer must ascend")
    print_tables(options)


if __name__ == "__main__":
    main()
