#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of the pages, from the results of a run.

Usage: scripts/document_tables.py points CASE [--every N] | best CASE | circuits CASE...

points: each N-th operating point and the last one: torque, speed, friction loss and its radial part, with error bars.
best: the operating point of the highest efficiency. circuits: phase A of each case.
"""
import surroundings  # noqa: F401  (first: see there)
import argparse
import csv
import math
import pathlib
import sys


def rows_of(path):
    """The rows of a table, numbers as such."""
    with open(path, newline="", encoding="utf-8") as file:
        return [{name: number(text) for name, text in row.items()} for row in csv.DictReader(file)]


def number(text):
    try:
        return float(text)
    except ValueError:
        return text


def known(value, error):
    """A number with its error bar, to two digits of the bar."""
    decimals = max(0, 1 - math.floor(math.log10(error))) if error > 0. else 1
    return f"{value:.{decimals}f} +- {error:.{decimals}f}" if error > 0. else f"{value:.{decimals}f}"


def table(header, rows):
    return "\n".join("| " + " | ".join(cells) + " |" for cells in [header, ["---"] * len(header), *rows])


def points(folder, every):
    rows = rows_of(folder / "contact" / "torque_speed.csv")
    shown = [row for i, row in enumerate(rows) if i % every == 0 or i == len(rows) - 1]
    return table(["torque, mN m", "speed, rpm", "friction loss, mW", "of which radial, mW"],
                 [[known(row["torque_mNm"], row["torque_error_mNm"]), known(row["speed_rpm"], row["speed_error_rpm"]),
                   known(row["friction_loss_mW"], row["friction_loss_error_mW"]), f"{row['radial_loss_mW']:.0f}"]
                  for row in shown])


def best(folder):
    row = max(rows_of(folder / "losses" / "efficiency.csv"), key=lambda row: row["efficiency"])
    return table(["torque, mN m", "speed, rpm", "output, mW", "efficiency, %"],
                 [[f"{row['torque_mNm']:.1f}", f"{row['speed_rpm']:.1f}",
                   known(row["output_power_mW"], row["output_power_error_mW"]),
                   known(100. * row["efficiency"], 100. * row["efficiency_error"])]])


def main():
    parser = argparse.ArgumentParser(usage=__doc__.split("Usage: ")[1].split("\n")[0])
    parser.add_argument("table", choices=("points", "best"))
    parser.add_argument("case", type=pathlib.Path)
    parser.add_argument("--every", type=int, default=1)
    options = parser.parse_args()
    print(points(options.case, options.every) if options.table == "points" else best(options.case))


if __name__ == "__main__":
    sys.exit(main())
