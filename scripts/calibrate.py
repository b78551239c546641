#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finds entries, such as friction coefficients and the amplitude, from a measured torque-speed curve.

usage: scripts/calibrate.py FILE.prm MEASURED.csv --fit 'Section/Entry = low:high'... [options]

MEASURED.csv has a row for each measured point and the columns torque_mNm, speed_rpm and, as standard deviations,
torque_error_mNm and speed_error_rpm (one of them may be left out). Motors with values from the ranges are computed at the
measured speeds (scripts/sweep.py); polynomials through their torques take the place of the motor in a least-squares fit and in
a Markov chain, which also count the error bars of the motors and what the polynomials miss of them. Example:

  scripts/calibrate.py prm/quick.prm measured.csv --fit 'Friction/Dynamic coefficient = 0.1:0.6'

Writes calibration.json (values, 95 % intervals, correlations), the motor at the best values, and a figure of curve, band and data
into output/FILE_calibration (or --output DIR).
"""
import json
import math
import sys

sys.dont_write_bytecode = True
import surroundings  # noqa: F401
import numpy as np
from calibration import Posterior, Surrogate, n_terms
from case import CaseError, run_script
from drawing import BLUE, ORANGE, plt, save
from many_motors import Engine
from measured import read_measured
from motor_options import family_of, motors_parser
from motor_results import RPM
from scipy.interpolate import PchipInterpolator
from sweep import print_inputs, sweep
from variation import latin_hypercube, number_text, ranged

MOST_SPEEDS = 12  # at which each motor is computed
INTERVAL = (2.5, 50., 97.5)  # per cent of the chain


def speeds_for(measured):
    """At which the motors are computed, in rad/s: those measured or, of many, some between the extreme ones."""
    speeds = np.unique(measured.speed)
    if len(speeds) > MOST_SPEEDS:
        speeds = np.quantile(speeds, np.linspace(0, 1, MOST_SPEEDS))
    if len(speeds) < 2:
        raise CaseError("a curve needs two different speeds or more")
    return [float(f"{speed:.6g}") for speed in speeds]


def surrogate_of(rows, fitted, speeds):
    """From the motors that are certified."""
    rows = [row for row in rows if row.outcome == "certified"]
    names = [f"torque at speed {speed:.6g}" for speed in speeds]
    places = np.array([[one.share_of(row.varied[one.entry]) for one in fitted] for row in rows]).reshape(len(rows), len(fitted))
    torques = np.array([[row.quantities[name].value for name in names] for row in rows]).reshape(len(rows), len(names))
    bars = np.array([[row.quantities[name].error for name in names] for row in rows]).reshape(len(rows), len(names))
    return Surrogate(speeds, places, torques * 1e-3, bars * 1e-3)


def interval_of(one, places):
    """Low end, median and high end of an entry."""
    return [float(one.at(share)) for share in np.percentile(places, INTERVAL)]


def draw(output, title, measured, surrogate, best, chain):
    figure, axes = plt.subplots(figsize=(5, 3.8), layout="constrained")
    figure.suptitle(title, fontsize=10)
    speeds = np.linspace(surrogate.speeds[0], surrogate.speeds[-1], 200)
    curves = PchipInterpolator(surrogate.speeds, surrogate.torques(np.vstack([best, chain])), axis=1)(speeds)
    low, high = np.percentile(curves[1:], (2.5, 97.5), axis=0)
    axes.fill_betweenx(speeds / RPM, low * 1e3, high * 1e3, color=BLUE, alpha=0.25, lw=0, label="95 % of the fits")
    axes.plot(curves[0] * 1e3, speeds / RPM, color=BLUE, lw=1, label="best fit")
    axes.errorbar(measured.torque * 1e3, measured.speed / RPM, xerr=measured.torque_error * 1e3, yerr=measured.speed_error / RPM,
                  fmt="o", color=ORANGE, ms=3, capsize=2, lw=0.8, label="measured")
    axes.set(xlabel="torque (mN m)", ylabel="speed (rpm)")
    axes.legend(frameon=False)
    axes.spines[["top", "right"]].set_visible(False)
    save(figure, output, "calibration")


def report(output, fitted, posterior, best, chain):
    """Prints and writes the values with their intervals."""
    chi_squared = float(np.sum(posterior.scaled(best) ** 2))
    n_free = len(posterior.measured.torque) - len(fitted)
    result = {"entries": {}, "chi_squared": chi_squared, "degrees_of_freedom": n_free,
              "correlations": np.atleast_2d(np.corrcoef(chain.T)).tolist()}
    for number, one in enumerate(fitted):
        low, median, high = interval_of(one, chain[:, number])
        result["entries"][one.entry] = {"best": float(one.at(best[number])), "median": median, "interval_95": [low, high]}
        print(f"{one.entry} = {median:.4g}, 95 % within {low:.4g} to {high:.4g}")
        if best[number] < 1e-3 or best[number] > 1 - 1e-3:
            print(f"warning: the best value, {one.at(best[number])}, is at an end of its range: widen it")
    print(f"chi squared {chi_squared:.3g} for {n_free} degrees of freedom")
    if n_free > 0 and chi_squared > n_free + 4 * math.sqrt(2 * n_free):
        print("warning: no motor of these ranges explains the curve within its deviations")
    (output / "calibration.json").write_text(json.dumps(result, indent=1) + "\n", encoding="utf-8")


def parse(arguments):
    parser = motors_parser(__doc__)
    parser.add_argument("measured", metavar="MEASURED.csv")
    parser.add_argument("--fit", action="append", required=True, metavar="'Section/Entry = low:high'")
    parser.add_argument("--motors", type=int, metavar="N", help="to be computed; by default twice the terms of the polynomials")
    return parser.parse_args(arguments)


def main(arguments):
    options = parse(arguments)
    fitted, measured = [ranged("--fit", text) for text in options.fit], read_measured(options.measured)
    speeds = speeds_for(measured)
    family = family_of(options, "calibration",
                       **{"Loading/Control": "speed", "Loading/Values": ", ".join(map(number_text, speeds))})
    for one in fitted:
        family.check_name("--fit", one.entry)
    dice = np.random.default_rng(options.seed)
    with Engine(options.workers, options.scheduler) as engine:
        n_motors = options.motors or max(8, 2 * n_terms(len(fitted)))
        rows = sweep(engine, family, latin_hypercube(fitted, n_motors, options.seed))
        surrogate = surrogate_of(rows, fitted, speeds)
        print(f"the polynomials miss torques by {1e3 * surrogate.missed.max():.2g} mN m at most, root mean square of "
              f"{len(rows)} motors")
        posterior = Posterior(surrogate, measured)
        best = posterior.best(len(fitted), dice)
        chain = posterior.sample(best, dice)
        report(family.output, fitted, posterior, best, chain)
        [row] = sweep(engine, family, [{one.entry: one.at(share) for one, share in zip(fitted, best)}])
    draw(family.output, family.entries["Motor/Name"], measured, surrogate, best, chain)
    print(f"the motor at the best values is in {row.folder}; the figure in {options.output}")
    print_inputs(row)


if __name__ == "__main__":
    run_script("calibrate", main)
