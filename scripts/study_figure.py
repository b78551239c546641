#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws what accuracy costs, from studies (stator FILE.prm --study, contact FILE.prm --study).

Usage: scripts/study_figure.py CASE_DIR      e.g. scripts/study_figure.py output/canon_ring

Reads CASE_DIR/stator/study.csv and CASE_DIR/contact/study.csv, what there is of them, and writes
CASE_DIR/figures/study.png and contact_study.png (and .svg): for each setting the relative error bar of
its results, and their distance from those of the best setting, against the seconds.
"""
import csv
import os
import sys

sys.dont_write_bytecode = True  # a drawing leaves nothing outside the folder of its case
from case import CaseError
from drawing import BLUE, GREEN, ORANGE, PURPLE, figures_folder, plt, save

STYLES = [(GREEN, "^"), (ORANGE, "s"), (BLUE, "o"), (PURPLE, "D")]


class Study:
    """What a program's study shows: one line for each value of a column, a point for each row."""

    def __init__(self, program, figure, line, number, result):
        self.program, self.figure, self.line, self.number, self.result = program, figure, line, number, result

    def error(self, row):
        return row["error_Hz"] / row["frequency_Hz"] if "error_Hz" in row else row["largest_relative_error"]

    def read(self, case_folder):
        """The rows of the study; none if the program has made none."""
        path = os.path.join(case_folder, self.program, "study.csv")
        try:
            with open(path, newline="") as file:
                return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]
        except FileNotFoundError:
            return []
        except (OSError, ValueError, TypeError) as error:
            raise CaseError(f"{path} cannot be read ({error}); run {self.program} with --study again") from None

    def draw(self, rows):
        figure = plt.figure(figsize=(6.2, 4.4), layout="constrained")
        axes = figure.subplots()
        column, name = self.line
        for value, (color, marker) in zip(sorted({row[column] for row in rows}), STYLES):
            of_line = [row for row in rows if row[column] == value]
            axes.plot([row["seconds"] for row in of_line], [self.error(row) for row in of_line], color=color,
                      marker=marker, lw=1.2, ms=5, label=f"{name} {value:.0f}: error bar")
            known = [row for row in of_line if row["distance_from_best"] > 0]
            axes.plot([row["seconds"] for row in known], [row["distance_from_best"] for row in known], color=color,
                      marker=marker, mfc="none", ls=":", lw=0.8, ms=5, label=f"{name} {value:.0f}: distance from the best")
            for row in of_line:
                axes.annotate(f"{row[self.number[0]]:.0f}", (row["seconds"], self.error(row)), (0, 6),
                              textcoords="offset points", ha="center", fontsize=7, color=color)
        axes.set(xscale="log", yscale="log", xlabel=f"seconds (numbers: {self.number[1]})",
                 ylabel=f"relative error of {self.result}", title=f"What accuracy costs: {self.result}")
        axes.grid(color="#DDDDDD", lw=0.5)
        axes.set_axisbelow(True)
        axes.spines[["top", "right"]].set_visible(False)
        axes.legend(fontsize=7.5, frameon=False)
        return figure


STUDIES = [
    Study("stator", "study", ("degree", "degree"), ("refinement", "refinement"), "the frequency of the motor's wave"),
    Study("contact", "contact_study", ("interface_mesh", "interface mesh"), ("steps_per_period", "steps in a period"),
          "speeds and torques"),
]


def main(arguments):
    if arguments in (["-h"], ["--help"]):
        print(__doc__)
        return
    if len(arguments) != 1:
        raise CaseError("expected one folder; usage: scripts/study_figure.py CASE_DIR")
    found = [(study, rows) for study in STUDIES if (rows := study.read(arguments[0]))]
    if not found:
        raise CaseError(f"there is no study in {arguments[0]}; run stator or contact with --study first")
    with figures_folder(arguments[0]) as folder:
        for study, rows in found:
            save(study.draw(rows), folder, study.figure)
    print(f"figures in {folder}/")


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except CaseError as error:
        sys.exit(f"study_figure: {error}")
