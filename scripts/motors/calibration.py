# SPDX-License-Identifier: LGPL-2.1-or-later
"""Entries that explain a measured torque-speed curve: shape of a curve, surrogate of the motor, least squares, Markov chain.

Near no load the torque barely changes the speed, and near stall the speed barely changes the torque: neither of them, when
prescribed, determines the other everywhere, and a motor with little friction does not bear a measured torque at all. A motor
is therefore computed along its own curve from no load to stall (the program contact prescribes torques where the curve is
flat and speeds where it is steep), and its curve is described relative to the straight line between its ends, which every
motor has.
"""
import itertools
import math
from dataclasses import dataclass

import emcee
import numpy as np
from results.case import CaseError
from scipy.interpolate import Akima1DInterpolator, CubicSpline
from scipy.optimize import least_squares

DEGREE = 2  # of the surrogate in each entry, of all entries together
N_STARTS = 12
MOST_ROUNDS, SAME_PLACE = 10, 1e-6  # of least squares, until the deviations are those at the place
N_WALKERS, N_STEPS, N_BURNED = 32, 2500, 500
LEAST_MARGIN = 1e-9
LEAST_POINTS = 5  # of the curve of a motor
LEAST_DEVIATION = 1e-3  # of no-load speed and stall torque: nothing is measured or computed better
BEYOND_AN_END = 3.  # standard deviations by which a measured point may be beyond no load or stall

# Along a curve: share of the stall torque minus share of the no-load speed, from -1 at no load to 1 at stall.
PLACES = np.linspace(-1., 1., 11)
WEIGHTS = CubicSpline(PLACES, np.eye(len(PLACES))[:, 1:-1])  # of the bulges at the inner ones, for the bulge anywhere
SLOPES = WEIGHTS.derivative()


def n_terms(n_entries):
    return math.comb(n_entries + DEGREE, DEGREE)


def least_motors(n_entries):
    """Two more than the polynomials have terms: fewer do not show what the polynomials miss."""
    return n_terms(n_entries) + 2


@dataclass(frozen=True)
class Measured:
    """Points of a torque-speed curve with standard deviations, in N m and rad/s."""

    torque: np.ndarray
    speed: np.ndarray
    torque_error: np.ndarray
    speed_error: np.ndarray


def check_on_curve(measured):
    """@throws CaseError if a point cannot be one between no load and stall"""
    torque = measured.torque + BEYOND_AN_END * measured.torque_error
    speed = measured.speed + BEYOND_AN_END * measured.speed_error
    outside = (torque < 0) | (speed < 0)
    if np.any(outside):
        number = int(np.flatnonzero(outside)[0])
        raise CaseError(f"point {number + 1} of the measured curve, {measured.torque[number] * 1e3:g} mN m at "
                        f"{measured.speed[number] * 30 / math.pi:g} rpm, is not between no load and stall; torques and "
                        "speeds must not be negative by more than three deviations")


@dataclass(frozen=True)
class Shapes:
    """Curves from no load to stall.

    values  (curve, value): no-load speed (rad/s), stall torque (N m), and the bulges at the inner ones of PLACES: by how
            much the sum of the shares of stall torque and no-load speed exceeds 1, the sum along a straight line
    """

    values: np.ndarray

    @property
    def speed(self):
        return self.values[:, 0:1]

    @property
    def torque(self):
        return self.values[:, 1:2]

    @property
    def bulges(self):
        return self.values[:, 2:]

    def excess(self, torque, speed):
        """How far points are outside of each curve, as the sum of both shares, with the derivatives of that.

        @returns excess (curve, point), its derivatives by the speed and the torque of the point, and by the values (curve,
        point, value); beyond the ends those by the bulges are 0
        """
        x, y = speed / self.speed, torque / self.torque
        # Beyond its ends a curve is continued by straight lines, whose slopes are taken as exact: errors of the bulges would
        # grow with the distance from the end until they explain everything.
        within = np.clip(y - x, -1., 1.)
        weights = WEIGHTS(within)
        slope = np.einsum("cpb,cb->cp", SLOPES(within), self.bulges)
        bulge = np.einsum("cpb,cb->cp", weights, self.bulges) + slope * (y - x - within)
        by_x, by_y = 1. + slope, 1. - slope
        by_speed, by_torque = by_x / self.speed, by_y / self.torque
        by_values = np.concatenate([-(by_speed * x)[..., None], -(by_torque * y)[..., None], -weights], axis=-1)
        return x + y - 1. - bulge, by_speed, by_torque, by_values

    def points(self, n_points):
        """Torques and speeds along each curve, in N m and rad/s."""
        places = np.linspace(-1., 1., n_points)
        total = 1. + self.bulges @ WEIGHTS(places).T
        return self.torque * (total + places) / 2., self.speed * (total - places) / 2.


def shape_of(torque, speed, torque_error, speed_error):
    """Values of the shape of a motor that was computed at points from no load to stall, and their error bars: those of the
    points, and the one of the curve between them. @throws CaseError if the points are no such curve"""
    if len(torque) < LEAST_POINTS or speed[0] <= speed_error[0] or torque[-1] <= torque_error[-1]:
        raise CaseError("it has no curve from no load to stall beyond its error bars")
    x, y = speed / speed[0], torque / torque[-1]
    places = y - x
    if np.any(np.diff(places) <= 0):
        raise CaseError("its speed does not fall as its torque rises")
    inner = PLACES[1:-1]
    bulges = Akima1DInterpolator(places, x + y - 1.)(inner)
    # Where interpolants of different kinds differ, the points are too far apart.
    between = CubicSpline(places, x + y - 1.)(inner) - bulges
    values = np.concatenate([[speed[0], torque[-1]], bulges])
    _, by_speed, by_torque, _ = Shapes(values[None]).excess(torque, speed)
    of_points = np.interp(inner, places, np.hypot(by_speed * speed_error, by_torque * torque_error)[0])
    return values, np.concatenate([[speed_error[0], torque_error[-1]], np.hypot(between, of_points)])


class Surrogate:
    """Shapes of a motor's curve as polynomials in the entries, each from 0 to 1 over its range, by least squares.

    errors  of the values of a shape: error bars of the motors, and what the polynomials miss of them
    """

    def __init__(self, places, values, bars):
        """@param places (motor, entry) @param values, bars (motor, value of the shape)"""
        n_entries = places.shape[1]
        if len(places) < least_motors(n_entries):
            raise CaseError(f"{len(places)} motors are too few for {n_entries} entries: {least_motors(n_entries)} or more")
        self.powers = np.array([power for power in itertools.product(range(DEGREE + 1), repeat=n_entries)
                                if sum(power) <= DEGREE])
        basis = self.basis(places)
        self.coefficients, *_ = np.linalg.lstsq(basis, values, rcond=None)
        # Polynomials may leave what is possible in the corners of the ranges, where there are no motors.
        self.least_ends = values[:, :2].min(axis=0) / 2.
        self.typical = np.median(values, axis=0)
        # Each motor against the polynomial of all others (leverages of least squares).
        leverage = np.sum(np.linalg.qr(basis)[0] ** 2, axis=1)
        left_out = (values - basis @ self.coefficients) / np.maximum(1. - leverage, 1e-3)[:, None]
        self.missed = np.sqrt(np.mean(left_out ** 2, axis=0))
        self.errors = np.hypot(self.missed, np.sqrt(np.mean(bars ** 2, axis=0)))

    def basis(self, places):
        return np.prod(np.atleast_2d(places)[:, None, :] ** self.powers, axis=2)

    def shapes(self, places):
        """One for each place."""
        values = self.basis(places) @ self.coefficients
        values[:, :2] = np.maximum(values[:, :2], self.least_ends)
        return Shapes(values)


@dataclass(frozen=True)
class Deviations:
    """Normal errors of the distances of measured points from a curve.

    own         of each point by itself
    directions  (point, direction) orthonormal patterns of the errors that move all points, relative to their own deviations
    shares      of each pattern that are taken away so that what remains has the deviation 1
    """

    own: np.ndarray
    directions: np.ndarray
    shares: np.ndarray

    def scaled(self, distances):
        """Distances (curve, point) as independent numbers with the deviation 1."""
        relative = distances / self.own
        return relative - (relative @ self.directions * self.shares) @ self.directions.T


@dataclass(frozen=True)
class Fit:
    """The place of the least squares, with their sum and the deviations there."""

    place: np.ndarray
    chi_squared: float
    deviations: Deviations


class Posterior:
    """How well a motor explains what was measured.

    Of each measured point the distance to the motor's curve counts, with its standard deviations of speed and torque in the
    direction of that distance: near no load the one of the speed alone, near stall the one of the torque. An error of the
    surrogate, such as of the no-load speed, moves all points together.
    """

    def __init__(self, surrogate, measured):
        self.surrogate, self.measured = surrogate, measured

    def compare(self, places):
        """Distances of the measured points from the curve of each place, relative to no-load speed and stall torque of the
        typical motor, and their derivatives by speed, torque and the values of the shape."""
        shapes = self.surrogate.shapes(places)
        excess, by_speed, by_torque, by_values = shapes.excess(self.measured.torque, self.measured.speed)
        unit_speed, unit_torque = self.surrogate.typical[:2]
        steepness = np.hypot(by_speed * unit_speed, by_torque * unit_torque)
        return excess / steepness, by_speed / steepness, by_torque / steepness, by_values / steepness[..., None]

    def deviations_at(self, place):
        _, by_speed, by_torque, by_values = (one[0] for one in self.compare(place))
        of_measuring = np.hypot(by_speed * self.measured.speed_error, by_torque * self.measured.torque_error)
        own = np.hypot(of_measuring, LEAST_DEVIATION)
        directions, sizes, _ = np.linalg.svd(by_values * self.surrogate.errors / own[:, None], full_matrices=False)
        return Deviations(own, directions, 1. - 1. / np.sqrt(1. + sizes ** 2))

    def best(self, n_entries, dice):
        """From several starts. The deviations are those at the place that is found."""
        starts, place = dice.uniform(0.05, 0.95, (N_STARTS, n_entries)), np.full(n_entries, 0.5)
        for _ in range(MOST_ROUNDS):
            deviations, before = self.deviations_at(place), place
            fits = [least_squares(lambda one, by=deviations: by.scaled(self.compare(one)[0])[0], start, bounds=(0, 1))
                    for start in starts]
            fit = min(fits, key=lambda fit: fit.cost)
            place = fit.x
            if np.all(abs(place - before) < SAME_PLACE):
                break
            starts = [np.clip(place, LEAST_MARGIN, 1 - LEAST_MARGIN)]
        return Fit(place, 2. * fit.cost, deviations)

    def log_probability(self, places, deviations):
        """Of each place; uniform within the ranges before anything was measured. Deviations that changed with the place
        would draw it to where they are small."""
        found = -0.5 * np.sum(deviations.scaled(self.compare(places)[0]) ** 2, axis=1)
        return np.where(np.all((places >= 0) & (places <= 1), axis=1), found, -math.inf)

    def sample(self, fit, dice):
        """Places drawn from the posterior probability. @throws CaseError if the chain is too short"""
        n_entries = len(fit.place)
        starts = np.clip(fit.place + 1e-3 * dice.standard_normal((N_WALKERS, n_entries)), LEAST_MARGIN, 1 - LEAST_MARGIN)
        sampler = emcee.EnsembleSampler(N_WALKERS, n_entries, self.log_probability, args=[fit.deviations], vectorize=True)
        sampler.random_state = np.random.RandomState(dice.integers(2 ** 31)).get_state()
        sampler.run_mcmc(starts, N_STEPS)
        correlation = float(np.max(sampler.get_autocorr_time(tol=0)))
        if not correlation * 20 < N_STEPS:
            raise CaseError(f"the Markov chain is correlated over {correlation:.0f} of its {N_STEPS} steps: the curve does "
                            "not determine these entries; fit fewer")
        return sampler.get_chain(discard=N_BURNED, thin=10, flat=True)
