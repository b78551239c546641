#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Speeds of the reference motor for all friction laws on three interface meshes with three time steps.

usage: benchmarks/friction_laws.py [--seconds 300] [--laws velocity ...] [--markdown FILE]

Each cell is a run of its own with the speeds (rpm) at 50 and 100 mN m, its seconds behind them.
Runs that take longer than `--seconds` are ended and written as "-", refused ones as "refused".
"""
import argparse
import csv
import pathlib
import sys
import tempfile

sys.dont_write_bytecode = True
from contact_cost import PLAIN as COULOMB, points_on_a_tooth  # noqa: E402
from motor_run import write_markdown  # noqa: E402
from timed_run import program, timed_run  # noqa: E402

LAWS = {"one coefficient, 0.40": {},
        "one coefficient, 0.48": {"Friction/Dynamic coefficient": "0.48"},
        "static-dynamic": {"Friction/Law": "static-dynamic"},
        "velocity": {"Friction/Law": "velocity", "Friction/Decay velocity": "0.05"},
        "slip-weakening": {"Friction/Law": "slip-weakening", "Friction/Weakening length": "20e-9"}}
PLAIN = {**COULOMB, "Loading/Values": "0.05, 0.1"}  # without load, power takes more steps to balance
LEVELS = (0, 1, 2)  # of the interface mesh
MOMENTS = (1, 2, 4)  # in a snapshot, each of ninety steps in a period


def cell(folder, law, level, moments, seconds):
    entries = {**PLAIN, **LAWS[law], "Accuracy/Interface refinement": str(level), "Time/Snapshots": str(moments)}
    try:
        taken, _ = timed_run("contact", folder, entries, most_seconds=seconds)
    except TimeoutError:
        return "-"
    except SystemExit:
        return "refused"
    with open(pathlib.Path(folder) / "contact" / "torque_speed.csv") as file:
        speeds = ", ".join(f"{float(row['speed_rpm']):.2f}" for row in csv.DictReader(file))
    return f"{speeds} ({taken:.0f} s)"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seconds", type=float, default=300., help="the most that a run may take")
    parser.add_argument("--laws", nargs="+", choices=list(LAWS), default=list(LAWS))
    parser.add_argument("--markdown", help="also write the tables to this file")
    options = parser.parse_args()
    program("contact")
    columns = [(level, moments) for level in LEVELS for moments in MOMENTS]
    lines = ["| law | " + " | ".join(f"{points_on_a_tooth(level)} points, {90 * moments} steps"
                                     for level, moments in columns) + " |", "|" + "---|" * (len(columns) + 1)]
    with tempfile.TemporaryDirectory() as folder:
        timed_run("stator", folder, PLAIN)
        for law in options.laws:
            cells = [cell(folder, law, level, moments, options.seconds) for level, moments in columns]
            lines.append(f"| {law} | " + " | ".join(cells) + " |")
            print(lines[-1], flush=True)
    if options.markdown:
        write_markdown(options.markdown, lines)


if __name__ == "__main__":
    main()
