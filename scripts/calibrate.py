#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finds entries, such as friction coefficients and the amplitude, from a measured torque-speed curve.

usage: scripts/calibrate.py FILE.prm MEASURED.csv --fit 'Section/Entry = low:high'... [options]

MEASURED.csv has a row for each measured point and the columns torque_mNm, speed_rpm and, as standard deviations,
torque_error_mNm and speed_error_rpm (one of them may be left out). Motors with values from the ranges are computed from no
load to stall (scripts/sweep.py); polynomials through the shapes of their curves take the place of the motor in a fit by
least squares and in a Markov chain, which also count the error bars of the motors and what the polynomials miss of them.
Example:

  scripts/calibrate.py prm/static_rotor.prm prm/static_rotor_measured.csv --set 'Friction/Law = coulomb' \\
      --fit 'Friction/Dynamic coefficient = 0.1:0.6' --fit 'Wave/Amplitude = 1e-6:2.5e-6'

Says first how many motors it will compute, and after each how long the others will take. Writes calibration.json (values,
intervals of 95 %, correlations), the motor at the best values, and a figure of curve, band and data into the folder
output/FILE_calibration (or --output DIR). Started again, it computes no motor twice.
"""
import json
import math
import sys

sys.dont_write_bytecode = True
from running import surroundings  # noqa: F401
import numpy as np
from drawing.basics import BLUE, ORANGE, plt, save
from motors.calibration import LEAST_POINTS, Posterior, Surrogate, check_on_curve, least_motors, n_terms, shape_of
from motors.many_motors import Engine
from motors.measured import read_measured
from motors.motor_options import family_of, motors_parser
from motors.variation import entry_and_value, latin_hypercube, ranged
from results.case import CaseError, run_script
from results.contact_case import ContactCase
from results.motor_results import RPM
from sweep import print_inputs, sweep

CURVE_POINTS = 11  # of each motor
INTERVAL = (2.5, 50., 97.5)  # per cent of the chain
CURVE = {"Loading/Control": "torque", "Loading/Values": "curve"}
OWN_ENTRIES = (*CURVE, "Loading/Number of curve points")


def shape_in(row):
    """Shape and error bars of the curve of a motor. @throws CaseError if it has none"""
    if row.outcome != "certified":
        raise CaseError(row.message)
    points = ContactCase(row.folder).curve
    torque, speed, torque_error, speed_error = (np.array([point[name] for point in points]) for name in (
        "torque_mNm", "speed_rpm", "torque_error_mNm", "speed_error_rpm"))
    return shape_of(torque * 1e-3, speed * RPM, torque_error * 1e-3, speed_error * RPM)


def surrogate_of(rows, fitted):
    """From the motors that have a curve. @throws CaseError if they are too few"""
    places, shapes, left_out = [], [], []
    for row in rows:
        try:
            shapes.append(shape_in(row))
            places.append([one.share_of(row.varied[one.entry]) for one in fitted])
        except CaseError as problem:
            left_out.append(f"{', '.join(f'{entry} = {text}' for entry, text in row.varied.items())}: {problem}")
    if left_out:
        print(f"{len(left_out)} of {len(rows)} motors are left out:", *left_out, sep="\n  ")
    if len(places) < least_motors(len(fitted)):
        raise CaseError(f"{len(places)} of {len(rows)} motors have a curve, {least_motors(len(fitted))} are needed; the "
                        f"first without one has {left_out[0]}; compute more with --motors, or narrow the ranges of --fit")
    values, bars = (np.array(part) for part in zip(*shapes))
    return Surrogate(np.array(places), values, bars)


def interval_of(one, places):
    """Low end, median and high end of an entry."""
    return [float(one.at(share)) for share in np.percentile(places, INTERVAL)]


def draw(output, title, measured, surrogate, best, chain):
    figure, axes = plt.subplots(figsize=(5, 3.8), layout="constrained")
    figure.suptitle(title, fontsize=10)
    torques, speeds = surrogate.shapes(np.vstack([best, chain])).points(200)
    # The band is cut along rays: neither speeds at a given torque nor torques at a given speed exist for all of the curves.
    speed_unit, torque_unit = surrogate.typical[:2]
    rays = np.linspace(0., math.pi / 2, 200)
    y, x = torques[1:] / torque_unit, speeds[1:] / speed_unit
    radii = [np.interp(rays, *curve) for curve in zip(np.arctan2(y, x), np.hypot(x, y))]
    low, high = np.percentile(radii, INTERVAL[::2], axis=0)
    outline, rays = np.concatenate([low, high[::-1]]), np.concatenate([rays, rays[::-1]])
    axes.fill(outline * np.sin(rays) * torque_unit * 1e3, outline * np.cos(rays) * speed_unit / RPM, color=BLUE, alpha=0.25,
              lw=0, label="95 % of the fits")
    axes.plot(torques[0] * 1e3, speeds[0] / RPM, color=BLUE, lw=1, label="best fit")
    axes.errorbar(measured.torque * 1e3, measured.speed / RPM, xerr=measured.torque_error * 1e3,
                  yerr=measured.speed_error / RPM, fmt="o", color=ORANGE, ms=3, capsize=2, lw=0.8, label="measured")
    axes.set(xlabel="torque (mN m)", ylabel="speed (rpm)")
    axes.legend(frameon=False)
    axes.spines[["top", "right"]].set_visible(False)
    save(figure, output, "calibration")


def report(output, fitted, n_points, fit, chain):
    """Prints and writes the values with their intervals."""
    n_free = n_points - len(fitted)
    result = {"entries": {}, "chi_squared": fit.chi_squared, "degrees_of_freedom": n_free,
              "correlations": np.atleast_2d(np.corrcoef(chain.T)).tolist()}
    for number, one in enumerate(fitted):
        low, median, high = interval_of(one, chain[:, number])
        result["entries"][one.entry] = {"best": float(one.at(fit.place[number])), "median": median,
                                        "interval_95": [low, high]}
        print(f"{one.entry} = {median:.4g}, 95 % within {low:.4g} to {high:.4g}")
        if fit.place[number] < 1e-3 or fit.place[number] > 1 - 1e-3:
            print(f"warning: the best value, {one.at(fit.place[number])}, is at an end of its range: widen it")
    print(f"chi squared {fit.chi_squared:.3g}, degrees of freedom: {n_free}")
    if fit.chi_squared > n_free + 4 * math.sqrt(2 * max(n_free, 1)):
        print("warning: no motor of these ranges explains the curve within its deviations")
    (output / "calibration.json").write_text(json.dumps(result, indent=1) + "\n", encoding="utf-8")


def parse(arguments):
    parser = motors_parser(__doc__)
    parser.add_argument("measured", metavar="MEASURED.csv")
    parser.add_argument("--fit", action="append", required=True, metavar="'Section/Entry = low:high'")
    parser.add_argument("--motors", type=int, metavar="N",
                        help="to be computed; by default twice the terms of the polynomials, at least eight")
    parser.add_argument("--points", type=int, metavar="N", default=CURVE_POINTS,
                        help=f"of the curve of each motor, by default {CURVE_POINTS}")
    options = parser.parse_args(arguments)
    if options.points < LEAST_POINTS:
        raise CaseError(f"--points {options.points}: expected {LEAST_POINTS} or more")
    return options


def fitted_of(options):
    """Entries with their ranges."""
    fitted = [ranged("--fit", text) for text in options.fit]
    given = [entry_and_value("--set", text)[0] for text in options.settings]
    entries = [one.entry for one in fitted]
    for entry in [*given, *entries]:
        if entry in OWN_ENTRIES:
            raise CaseError(f"{entry}: motors are computed from no load to stall; leave this entry out, and choose the "
                            "number of points with --points")
    for number, entry in enumerate(entries):
        if entry in given or entry in entries[:number]:
            raise CaseError(f'--fit "{entry}": this entry is given twice')
    return fitted


def n_motors_of(options, n_entries):
    least, chosen = least_motors(n_entries), max(8, 2 * n_terms(n_entries))
    found = chosen if options.motors is None else options.motors
    if found < least:
        raise CaseError(f"--motors {found}: expected {least} or more (entries to fit: {n_entries})")
    return found


def main(arguments):
    options = parse(arguments)
    fitted, measured = fitted_of(options), read_measured(options.measured)
    check_on_curve(measured)
    if len(measured.torque) < len(fitted):
        raise CaseError(f"{options.measured} has too few points: expected one for each entry to fit, {len(fitted)} or more, "
                        f"found {len(measured.torque)}")
    n_motors = n_motors_of(options, len(fitted))
    family = family_of(options, "calibration", **CURVE, **{"Loading/Number of curve points": str(options.points)})
    for one in fitted:
        family.check_name("--fit", one.entry)
    dice = np.random.default_rng(options.seed)
    with Engine(options.workers, options.scheduler) as engine:
        print(f"{n_motors} motors will be computed at {options.points} points each, {engine.n_workers()} at the same time, "
              "and one more at the best values; the first ones show how long that takes", flush=True)
        surrogate = surrogate_of(sweep(engine, family, latin_hypercube(fitted, n_motors, options.seed)), fitted)
        missed = 100. * surrogate.missed[:2] / surrogate.typical[:2]
        print(f"the polynomials miss no-load speeds by {missed[0]:.2g} % and stall torques by {missed[1]:.2g} %, root mean "
              "square")
        posterior = Posterior(surrogate, measured)
        fit = posterior.best(len(fitted), dice)
        chain = posterior.sample(fit, dice)
        report(family.output, fitted, len(measured.torque), fit, chain)
        [row] = sweep(engine, family, [{one.entry: one.at(share) for one, share in zip(fitted, fit.place)}])
    draw(family.output, family.entries["Motor/Name"], measured, surrogate, fit.place, chain)
    print(f"the motor at the best values is {row.outcome}, in {row.folder}; the figure is in {options.output}")
    print_inputs(row)


if __name__ == "__main__":
    run_script("calibrate", main)
