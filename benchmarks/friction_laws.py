#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Speeds of the reference motor for all friction laws on three interface meshes with three time steps.

usage: benchmarks/friction_laws.py [--seconds 300] [--laws velocity ...] [--markdown FILE]

Each cell is a run of its own with the speeds (rpm) without load and at 50 mN m, its seconds behind them.
Runs that take longer than `--seconds` are ended and written as "-", refused ones as "refused".
"""
import argparse
import csv
import pathlib
import sys
import tempfile

sys.dont_write_bytecode = True
from timed_run import program, timed_run  # noqa: E402

LAWS = {"one coefficient, 0.40": {"Friction/Law": "coulomb"},
        "one coefficient, 0.48": {"Friction/Law": "coulomb", "Friction/Dynamic coefficient": "0.48"},
        "static-dynamic": {},
        "velocity": {"Friction/Law": "velocity", "Friction/Decay velocity": "0.05"},
        "slip-weakening": {"Friction/Law": "slip-weakening", "Friction/Weakening length": "20e-9"}}
PLAIN = {"Rotor/Flange element": "solid", "Accuracy/Mode": "fixed", "Accuracy/Refinement": "1",
         "Output/VTU": "false", "Loading/Values": "0, 0.05"}
POINTS_ON_A_TOOTH = {0: 15, 1: 25, 2: 63}  # by interface mesh
STEPS_IN_A_PERIOD = {1: 90, 2: 180, 4: 360}  # by moments in a snapshot


def cell(folder, law, level, moments, seconds):
    entries = {**PLAIN, **LAWS[law], "Accuracy/Interface refinement": str(level), "Time/Snapshots": str(moments)}
    try:
        taken, _ = timed_run("contact", folder, entries, most_seconds=seconds)
    except TimeoutError:
        return "-"
    except RuntimeError:
        return "refused"
    with open(pathlib.Path(folder) / "contact" / "torque_speed.csv") as file:
        speeds = ", ".join(f"{float(row['speed_rpm']):.2f}" for row in csv.DictReader(file))
    return f"{speeds} ({taken:.0f} s)"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seconds", type=float, default=300., help="the most that a run may take")
    parser.add_argument("--laws", nargs="+", choices=list(LAWS), default=list(LAWS))
    parser.add_argument("--markdown", help="also write the table to this file")
    options = parser.parse_args()
    program("contact")
    columns = [(level, moments) for level in POINTS_ON_A_TOOTH for moments in STEPS_IN_A_PERIOD]
    lines = ["| law | " + " | ".join(f"{POINTS_ON_A_TOOTH[level]} points, {STEPS_IN_A_PERIOD[moments]} steps"
                                     for level, moments in columns) + " |", "|" + "---|" * (len(columns) + 1)]
    with tempfile.TemporaryDirectory() as folder:
        timed_run("stator", folder, PLAIN)
        for law in options.laws:
            cells = [cell(folder, law, level, moments, options.seconds) for level, moments in columns]
            lines.append(f"| {law} | " + " | ".join(cells) + " |")
            print(lines[-1], flush=True)
    if options.markdown:
        pathlib.Path(options.markdown).write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
