#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws what accuracy costs, from studies (stator FILE.prm --study, contact FILE.prm --study).

Usage: scripts/study_figure.py CASE_DIR      e.g. scripts/study_figure.py output/canon_ring

Reads CASE_DIR/stator/study.csv and CASE_DIR/contact/study.csv, what there is of them, and writes
CASE_DIR/figures/study.png and contact_study.png (and .svg): for each quantity the relative distance of all
settings from the best one against their seconds, with the Pareto front.
"""
import csv
import math
import os
import sys

sys.dont_write_bytecode = True  # a drawing leaves nothing outside the folder of its case
from running import surroundings  # noqa: F401
from drawing.basics import BLUE, GREEN, GREY, ORANGE, PURPLE, SKY, figures_folder, plt, save
from results.case import CaseError, run_script

STUDIES = (("stator", "study"), ("contact", "contact_study"))
PAPER, BEST, COMMON = "as in the paper", "best setting", "common setting"
TITLES = {"frequency": "frequency of the wave", "A_t/A_n": "$A_t/A_n$ at the outer edge",
          "phi_edge": r"$\varphi$ at the tooth's edge", "speed": "speed", "torque": "stall torque",
          "friction_loss": "friction loss", "stick_fraction": "stick fraction",
          "teeth_in_contact_per_wave": "teeth in contact"}
RED = "#CC0000"
TOLERANCES = (1e-2, 3e-3, 1e-3)
STYLES = [(color, marker) for marker in "o^D" for color in (BLUE, ORANGE, GREEN, PURPLE, SKY)]


def read(case_folder, program):
    """The rows of a program's study, without those that have no solution; none if it has made none."""
    path = os.path.join(case_folder, program, "study.csv")
    try:
        with open(path, newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        for row in rows:
            row["seconds"] = float(row["seconds"])
            row["distance"] = {column[len("distance_"):]: float(row[column]) for column in row
                               if column.startswith("distance_") and row[column]}
            row["on_front"] = row["pareto_front"].split()
        return [row for row in rows if row["distance"]]
    except FileNotFoundError:
        return []
    except (OSError, ValueError, TypeError, LookupError) as error:
        raise CaseError(f"{path} cannot be read ({error}); run {program} with --study again") from None


def draw_panel(axes, rows, quantity, styles):
    """One quantity; a distance of zero, which only the best setting has, is not drawn."""
    shown = [row for row in rows if row["distance"].get(quantity, 0.0) > 0.0]
    for tolerance in TOLERANCES:
        axes.axhline(tolerance, color="#888888", lw=0.8, ls="--", zorder=0.9)
    front = sorted((row for row in shown if quantity in row["on_front"]), key=lambda row: row["seconds"])
    axes.plot([row["seconds"] for row in front], [row["distance"][quantity] for row in front],
              color="#444444", lw=1.0, zorder=1, drawstyle="steps-post")
    for row in shown:
        knob = row["knob"]
        at = row["seconds"], row["distance"][quantity]
        if knob == PAPER:
            is_whole = not row["value"]
            axes.plot(*at, "*", color=RED if is_whole else "none", mec=RED, ms=11 if is_whole else 9, mew=0.8, zorder=4)
        elif knob == COMMON:
            axes.plot(*at, "s", color="black", ms=6, zorder=3)
        else:
            color, marker = styles[knob]
            hollow = row["other_model"] == "1"
            axes.plot(*at, marker, color=color, mfc="white" if hollow else color, ms=5, alpha=0.9, zorder=2)
    axes.set(xscale="log", yscale="log", title=TITLES.get(quantity, quantity))
    axes.title.set_fontsize(9)
    axes.grid(color="#EEEEEE", lw=0.5)
    axes.set_axisbelow(True)
    axes.spines[["top", "right"]].set_visible(False)


def legend_entries(rows, styles):
    """A handle and a label for each kind of setting that is there."""
    def handle(marker, color, **more):
        return plt.Line2D([], [], ls="none", marker=marker, color=color, **more)
    knobs = {row["knob"] for row in rows}
    entries = [(handle(marker, color, ms=5), knob) for knob, (color, marker) in styles.items()]
    if COMMON in knobs:
        entries.insert(0, (handle("s", "black", ms=6), COMMON))
    if any(row["other_model"] == "1" for row in rows):
        entries.append((handle("o", GREY, mfc="white", ms=5), "hollow: another model"))
    if PAPER in knobs:
        entries.append((handle("*", RED, ms=11), PAPER))
        entries.append((handle("*", "none", mec=RED, ms=9), "one part of it alone"))
    entries.append((plt.Line2D([], [], color="#444444", lw=1.0), "Pareto front"))
    return entries


def draw(rows, program):
    quantities = [quantity for quantity in TITLES if quantity in rows[-1]["distance"]]
    knobs = list(dict.fromkeys(row["knob"] for row in rows if row["knob"] not in (PAPER, BEST, COMMON)))
    styles = dict(zip(knobs, STYLES))
    n_columns = 2 if len(quantities) < 4 else 3  # one panel more holds the legend
    n_rows = math.ceil((len(quantities) + 1) / n_columns)
    figure = plt.figure(figsize=(3.3 * n_columns, 3.0 * n_rows), layout="constrained")
    panels = figure.subplots(n_rows, n_columns, squeeze=False).flatten()
    for axes, quantity in zip(panels, quantities):
        draw_panel(axes, rows, quantity, styles)
    for axes in panels[len(quantities):]:
        axes.axis("off")
    handles, labels = zip(*legend_entries(rows, styles))
    panels[len(quantities)].legend(handles, labels, fontsize=8, frameon=False, loc="center", borderaxespad=0.0)
    figure.supxlabel("seconds", fontsize=9)
    figure.supylabel("relative distance from the best setting", fontsize=9)
    figure.suptitle(f"What accuracy costs the program {program}", fontsize=10)
    return figure


def main(arguments):
    if arguments in (["-h"], ["--help"]):
        print(__doc__)
        return
    if len(arguments) != 1:
        raise CaseError("expected one folder; usage: scripts/study_figure.py CASE_DIR")
    found = [(program, figure, rows) for program, figure in STUDIES if (rows := read(arguments[0], program))]
    if not found:
        raise CaseError(f"there is no study in {arguments[0]}; run stator or contact with --study first")
    with figures_folder(arguments[0]) as folder:
        for program, figure, rows in found:
            save(draw(rows, program), folder, figure)
    print(f"figures in {folder}/")


if __name__ == "__main__":
    run_script("study_figure", main)
