# SPDX-License-Identifier: LGPL-2.1-or-later
"""Entries that explain a measured torque-speed curve: a surrogate of the motor, least squares, a Markov chain."""
import itertools
import math
from dataclasses import dataclass

import emcee
import numpy as np
from case import CaseError
from scipy.interpolate import PchipInterpolator
from scipy.optimize import least_squares

DEGREE = 3  # of the surrogate in each entry, of all entries together
N_STARTS = 12
N_WALKERS, N_STEPS, N_BURNED = 32, 2500, 500
LEAST_MARGIN = 1e-9


def n_terms(n_entries):
    return math.comb(n_entries + DEGREE, DEGREE)


class Surrogate:
    """Torques of a motor at given speeds as polynomials in the entries, each from 0 to 1 over its range, by least squares.

    speeds         rad/s, increasing
    errors         N m, of the torque at each speed: error bars of the motors, and what the polynomials miss of them
    """

    def __init__(self, speeds, places, torques, bars):
        """@param places (motor, entry) @param torques, bars (motor, speed), N m"""
        self.speeds, n_entries = np.asarray(speeds), places.shape[1]
        self.powers = np.array([power for power in itertools.product(range(DEGREE + 1), repeat=n_entries)
                                if sum(power) <= DEGREE])
        basis = self.basis(places)
        if len(places) < len(self.powers) + 2:
            raise CaseError(f"{len(places)} motors are too few for {n_entries} entries: {len(self.powers) + 2} or more")
        self.coefficients, *_ = np.linalg.lstsq(basis, torques, rcond=None)
        # Each motor against the polynomial of all others (leverages of least squares).
        leverage = np.sum(np.linalg.qr(basis)[0] ** 2, axis=1)
        left_out = (torques - basis @ self.coefficients) / np.maximum(1. - leverage, 1e-3)[:, None]
        self.missed = np.sqrt(np.mean(left_out ** 2, axis=0))
        self.errors = np.hypot(self.missed, np.sqrt(np.mean(bars ** 2, axis=0)))

    def basis(self, places):
        return np.prod(np.atleast_2d(places)[:, None, :] ** self.powers, axis=2)

    def torques(self, places):
        """(place, speed)"""
        return self.basis(places) @ self.coefficients


@dataclass(frozen=True)
class Measured:
    """A torque-speed curve with standard deviations, in N m and rad/s."""

    torque: np.ndarray
    speed: np.ndarray
    torque_error: np.ndarray
    speed_error: np.ndarray


class Posterior:
    """How well a motor explains what was measured. Of each measured point the torque is compared with that of the motor at
    the measured speed; the deviation of the speed counts by the slope of the motor's curve."""

    def __init__(self, surrogate, measured):
        self.surrogate, self.measured = surrogate, measured

    def residuals_and_deviations(self, places):
        """N m, (place, measured point)."""
        speeds = self.surrogate.speeds
        curve = PchipInterpolator(speeds, self.surrogate.torques(places), axis=1)
        at = np.clip(self.measured.speed, speeds[0], speeds[-1])
        model_error = np.interp(at, speeds, self.surrogate.errors)
        deviation = np.sqrt(self.measured.torque_error ** 2 + (curve(at, 1) * self.measured.speed_error) ** 2 +
                            model_error ** 2)
        return self.measured.torque - curve(at), deviation

    def scaled(self, place):
        residual, deviation = self.residuals_and_deviations(place)
        return (residual / deviation)[0]

    def log_probability(self, places):
        """Of each place; uniform within the ranges before anything was measured."""
        residual, deviation = self.residuals_and_deviations(places)
        found = -0.5 * np.sum((residual / deviation) ** 2, axis=1) - np.sum(np.log(deviation), axis=1)
        return np.where(np.all((places >= 0) & (places <= 1), axis=1), found, -math.inf)

    def best(self, n_entries, dice):
        """The place of the least squares, from several starts."""
        starts = dice.uniform(0.05, 0.95, (N_STARTS, n_entries))
        fits = [least_squares(self.scaled, start, bounds=(0, 1)) for start in starts]
        return min(fits, key=lambda fit: fit.cost).x

    def sample(self, best, dice):
        """Places drawn from the posterior probability. @throws CaseError if the chain is too short"""
        starts = np.clip(best + 1e-3 * dice.standard_normal((N_WALKERS, len(best))), LEAST_MARGIN, 1 - LEAST_MARGIN)
        sampler = emcee.EnsembleSampler(N_WALKERS, len(best), self.log_probability, vectorize=True)
        sampler.random_state = np.random.RandomState(dice.integers(2 ** 31)).get_state()
        sampler.run_mcmc(starts, N_STEPS)
        correlation = float(np.max(sampler.get_autocorr_time(quiet=True)))
        if not correlation * 20 < N_STEPS:
            raise CaseError(f"the Markov chain is correlated over {correlation:.0f} of its {N_STEPS} steps: the curve does not "
                            "determine these entries; fit fewer")
        return sampler.get_chain(discard=N_BURNED, thin=10, flat=True)
