#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sensitivities against differences of complete runs, for ten entries, six quantities and three motors without inertia.

usage: benchmarks/sensitivities.py [--resume] [--csv FILE] [--markdown FILE] [MOTOR ...]

Each motor runs once with --sensitivities. Of the runs that they are compared with, each on finer meshes of its own
(Accuracy/Mode = fixed), those of a pair have one entry a little smaller and larger; the difference of their logarithms is
the derivative, and half of the difference of the slopes to both sides its error bar, as for the sensitivities themselves.
"""
import argparse
import csv
import json
import math
import pathlib
import re
import statistics
import sys
import tempfile

sys.dont_write_bytecode = True
from motor_run import OUTPUT_OFF, RowFile, certified_run, operating_points, table, write_markdown  # noqa: E402
from timed_run import PAPERS_MODEL, ROOT, arguments, limited_run, program  # noqa: E402

# Waves of ring60 repeat after ten teeth: with one snapshot it would have ten steps in a period.
MOTORS = {"canon_ring": {}, "soft_spring": {}, "ring60": {"Effects/Friction lining": "on", "Time/Snapshots": "18"}}
BASE = {**PAPERS_MODEL, **OUTPUT_OFF, "Effects/Stator compliance": "off", "Effects/Piezoelectric coupling": "off",
        "Loading/Number of curve points": "2"}
FINE = {"Accuracy/Mode": "fixed", "Accuracy/Polynomial degree": "3", "Accuracy/Refinement": "2",
        "Accuracy/Interface refinement": "2", "Time/Snapshots": "2"}
QUICK = {"Accuracy/Target": "1e-3", "Accuracy/Contact target": "0.2"}  # on which sensitivities do not depend
QUANTITIES = ("frequency", "no_load_speed", "stall_torque", "half_load_speed", "half_load_friction_loss",
              "half_load_efficiency")
ENTRIES = ("Loading/Preload", "Wave/Amplitude", "Friction/Dynamic coefficient", "Stator/Base thickness",
           "Stator/Tooth height", "Stator/Tip outer radius", "Rotor/Flange thickness", "Rotor/Ring inner radius",
           "Materials/Stator metal/Young modulus", "Materials/Rotor metal/Young modulus")
COLUMNS = ["motor", "entry", "quantity", "derivative", "error", "difference", "difference_error"]


def sensitivities_of(name, folder):
    """The rows of the entries, by entry, and the seconds that they took."""
    motor = ROOT / "prm" / f"{name}.prm"
    command = [str(program("motor"))] + arguments(motor, folder, {**BASE, **MOTORS[name], **QUICK}) + ["--sensitivities"]
    done = limited_run(command)
    if done.status != 0:
        raise RuntimeError(f"{name}: {done.message}")
    with open(folder / "contact" / "sensitivities.csv", newline="") as file:
        return {row["entry"]: row for row in csv.DictReader(file)}


def values_of(name, entries, folder):
    """The quantities of one motor, by complete runs."""
    motor = ROOT / "prm" / f"{name}.prm"
    entries = {**BASE, **FINE, **MOTORS[name], **entries}
    certified_run("stator", motor, folder, entries)
    ends, _ = operating_points(motor, folder, entries)
    stall = 1e-3 * ends[-1]["torque_mNm"]
    half, _ = operating_points(motor, folder, {**entries, "Loading/Values": repr(0.5 * stall)})
    certified_run("losses", motor, folder, {**entries, "Loading/Values": repr(0.5 * stall)})
    with open(folder / "losses" / "efficiency.csv", newline="") as file:
        efficiency = float(next(csv.DictReader(file))["efficiency"])
    summary = json.loads((folder / "stator" / "summary.json").read_text())
    frequency = next(quantity["value"] for quantity in summary["quantities"] if quantity["name"] == "frequency")
    return dict(zip(QUANTITIES, (frequency, ends[0]["speed_rpm"], stall, half[0]["speed_rpm"],
                                 half[0]["friction_loss_mW"], efficiency)))


def slope(less, itself, more, step):
    """The derivative of a logarithm and its error bar."""
    less, itself, more = map(math.log, (less, itself, more))
    return (more - less) / (2 * step), abs(more - 2 * itself + less) / (2 * step)


def compute(name, rows, scratch):
    wanted = [entry for entry in ENTRIES if not rows.find(motor=name, entry=entry)]
    if not wanted:
        return
    found = sensitivities_of(name, scratch / "sensitivities")
    itself = values_of(name, {}, scratch / "itself")
    for entry in wanted:
        if not found.get(entry, {}).get("frequency"):
            print(f"{name}: {entry} has no derivative", file=sys.stderr, flush=True)
            continue
        value, step = float(found[entry]["value"]), float(found[entry]["step"])
        step = step / value
        together = [entry, *re.findall("together with ([^;]*)", found[entry]["remark"])]
        try:
            less, more = (values_of(name, dict.fromkeys(together, repr(value * math.exp(change))), scratch / "changed")
                          for change in (-step, step))
        except RuntimeError as error:  # the motor cannot be made
            print(error, file=sys.stderr, flush=True)
            continue
        for quantity in QUANTITIES:
            difference, error = slope(less[quantity], itself[quantity], more[quantity], step)
            scale = float(found[entry]["scale"]) / abs(value)  # radii by their distance from the next one
            numbers = (float(found[entry][quantity]), float(found[entry][quantity + "_error"]), difference, error)
            rows.add({"motor": name, "entry": entry, "quantity": quantity,
                      **dict(zip(COLUMNS[3:], (f"{scale * number:.5g}" for number in numbers)))})
        print(f"{name}: {entry}", flush=True)


def evaluate(rows):
    """The lines of a table for each quantity: derivative and difference."""
    lines, misses, bars = [], [], []
    for name in MOTORS:
        for entry in ENTRIES:
            of = {row["quantity"]: row for row in rows.rows if row["motor"] == name and row["entry"] == entry}
            if not of:
                continue
            cells = []
            for quantity in QUANTITIES:
                derivative, error, difference, other_error = (float(of[quantity][column]) for column in COLUMNS[3:])
                misses.append(abs(derivative - difference))
                bars.append(error + other_error + 0.01)
                cells.append(f"{derivative:.3f} ± {error:.3f} ({difference:.3f})")
            lines.append([name, entry, *cells])
    inside = sum(miss <= bar for miss, bar in zip(misses, bars))
    return table(["motor", "entry", *QUANTITIES], lines) + ["", (
        f"{len(misses)} derivatives, with those by complete runs in brackets: the median difference is "
        f"{statistics.median(misses):.4f}, the largest {max(misses):.3f}; {inside} are within both error bars and 0.01.")]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--resume", action="store_true", help="keep the rows of the CSV file, compute what it lacks")
    parser.add_argument("--csv", default=ROOT / "output" / "sensitivities.csv")
    parser.add_argument("--markdown", help="also write the table to this file")
    parser.add_argument("motors", nargs="*", metavar="MOTOR", help=", ".join(MOTORS))
    options = parser.parse_args()
    rows = RowFile(options.csv, COLUMNS, options.resume)
    for name in options.motors or MOTORS:
        with tempfile.TemporaryDirectory() as scratch:
            compute(name, rows, pathlib.Path(scratch))
    lines = evaluate(rows)
    print("\n".join(lines))
    if options.markdown:
        write_markdown(options.markdown, lines)


if __name__ == "__main__":
    main()
