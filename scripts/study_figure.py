#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws what accuracy costs, from a study of the program stator (stator FILE.prm --study).

Usage: scripts/study_figure.py CASE_DIR      e.g. scripts/study_figure.py output/canon_ring

Reads CASE_DIR/stator/study.csv and writes CASE_DIR/figures/study.png and .svg: for each setting the
relative error bar of the frequency, and its distance from the best setting's, against the seconds.
"""
import csv
import os
import sys

sys.dont_write_bytecode = True  # a drawing leaves nothing outside the folder of its case
from case import CaseError
from drawing import BLUE, GREEN, ORANGE, PURPLE, figures_folder, plt, save

STYLE = {2: (GREEN, "^"), 3: (ORANGE, "s"), 4: (BLUE, "o")}


def read_study(path):
    try:
        with open(path, newline="") as file:
            return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]
    except FileNotFoundError:
        raise CaseError(f"{path} is missing; run stator with --study first") from None
    except (OSError, ValueError, TypeError) as error:
        raise CaseError(f"{path} cannot be read ({error}); run stator with --study again") from None


def draw_study(rows):
    figure = plt.figure(figsize=(6.2, 4.4), layout="constrained")
    axes = figure.subplots()
    for degree in sorted({int(row["degree"]) for row in rows}):
        color, marker = STYLE.get(degree, (PURPLE, "D"))
        of_degree = [row for row in rows if row["degree"] == degree]
        seconds = [row["seconds"] for row in of_degree]
        axes.plot(seconds, [row["error_Hz"] / row["frequency_Hz"] for row in of_degree], color=color, marker=marker,
                  lw=1.2, ms=5, label=f"degree {degree}: error bar")
        known = [row for row in of_degree if row["distance_from_best"] > 0]
        axes.plot([row["seconds"] for row in known], [row["distance_from_best"] for row in known], color=color,
                  marker=marker, mfc="none", ls=":", lw=0.8, ms=5, label=f"degree {degree}: distance from the best")
        for row, x in zip(of_degree, seconds):
            axes.annotate(f"{int(row['refinement'])}", (x, row["error_Hz"] / row["frequency_Hz"]), (0, 6),
                          textcoords="offset points", ha="center", fontsize=7, color=color)
    axes.set(xscale="log", yscale="log", xlabel="seconds (numbers: refinement)", ylabel="relative error of the frequency",
             title="What accuracy costs: frequency of the motor's wave")
    axes.grid(color="#DDDDDD", lw=0.5)
    axes.set_axisbelow(True)
    axes.spines[["top", "right"]].set_visible(False)
    axes.legend(fontsize=7.5, frameon=False)
    return figure


def main(arguments):
    if arguments in (["-h"], ["--help"]):
        print(__doc__)
        return
    if len(arguments) != 1:
        raise CaseError("expected one folder; usage: scripts/study_figure.py CASE_DIR")
    rows = read_study(os.path.join(arguments[0], "stator", "study.csv"))
    with figures_folder(arguments[0]) as folder:
        save(draw_study(rows), folder, "study")
    print(f"figure in {folder}/")


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except CaseError as error:
        sys.exit(f"study_figure: {error}")
