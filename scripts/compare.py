#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compares motors: entries that differ, and each quantity with its difference and error bars.

Usage: scripts/compare.py CASE_A CASE_B...      e.g. scripts/compare.py output/canon_ring output/ring60

Every other case is compared with CASE_A. A difference is real if it exceeds the sum of both error bars, and open if it does not:
then the target and the time are given with which it could be decided. Writes CASE_A/figures/compare.png and .svg.
"""
import itertools
import os
import sys

sys.dont_write_bytecode = True
from running import surroundings  # noqa: F401
from drawing.basics import BLUE, GREEN, GREY, ORANGE, PURPLE, SKY, figures_folder, literal, plt, save
from results.case import CaseError, known, run_script
from results.contact_case import ContactCase
from results.motor_results import quantities_of

COLORS = (BLUE, ORANGE, GREEN, PURPLE, SKY)
COARSENESS = ("Accuracy/", "Output/", "Modes/")  # entries that say how, not what
LEAST_TARGET = 1e-3  # that Accuracy/Contact target may have
NIL = 1e-9  # relative: below, two numbers are the same


class Motor:
    """A case with a short name, its entries, quantities, and what they cost."""

    def __init__(self, folder):
        self.folder, self.name = folder, os.path.basename(os.path.normpath(folder))
        self.quantities, contact = quantities_of(folder), ContactCase(folder)
        self.entries = contact.parameters
        self.seconds = sum(contact.summary["seconds"].values())
        self.curve = contact.curve
        self.target = float(self.entries["Accuracy/Contact target"])


def verdict(first, second, one, other):
    """Whether a difference is real or open; for an open one with the target and seconds that would decide it.

    Errors fall in proportion to the target and, as measured for targets from 0.1 to 0.003, time grows with its inverse.
    """
    difference, bars = abs(other.value - one.value), one.error + other.error
    if difference <= NIL * max(abs(one.value), abs(other.value)):
        return "none"
    if difference > bars:
        return "real"
    target = min(first.target, second.target) * 0.9 * difference / bars
    if target < LEAST_TARGET:
        return f"open: no target from {LEAST_TARGET:g} on would decide it"
    seconds = (first.seconds * first.target + second.seconds * second.target) / target
    return f"open: Contact target = {target:.1g} would decide it, about {seconds:.0f} s"


def print_entries(motors):
    """Those that are not the same in all motors."""
    names = [name for name in motors[0].entries
             if name != "Output/Directory" and len({motor.entries.get(name) for motor in motors}) > 1]
    print("entries that differ" if names else "all entries are the same")
    width = max(map(len, names), default=0)
    for name in sorted(names, key=lambda name: name.startswith(COARSENESS)):
        print(f"  {name.ljust(width)}  " + "   ".join(motor.entries.get(name, "-") for motor in motors))


def print_differences(first, second):
    print(f"\n{second.name} against {first.name}")
    rows = [["quantity", "unit", first.name, second.name, "difference", ""]]
    for name, one in first.quantities.items():
        if (other := second.quantities.get(name)) is None:
            continue
        share = f" ({100 * (other.value / one.value - 1):+.2g} %)" if one.value else ""
        rows.append([name, one.unit, known(one.value, one.error), known(other.value, other.error),
                     f"{known(other.value - one.value, one.error + other.error)}{share}", verdict(first, second, one, other)])
    widths = [max(len(row[column]) for row in rows) for column in range(5)]
    for row in rows:
        print("  " + "  ".join(cell.ljust(width) for cell, width in zip(row, widths)) + "  " + row[5])
    lacking = [name for name in first.quantities if name not in second.quantities]
    if lacking:
        print(f"  only {first.name} has {', '.join(lacking)}")


def draw(motors):
    """Torque-speed curves with their bars, and relative differences of all quantities."""
    figure, (curve, bars) = plt.subplots(1, 2, figsize=(9, 4), layout="constrained")
    for motor, color in zip(motors, itertools.cycle(COLORS)):
        curve.errorbar([row["torque_mNm"] for row in motor.curve], [row["speed_rpm"] for row in motor.curve],
                       xerr=[row["torque_error_mNm"] for row in motor.curve],
                       yerr=[row["speed_error_rpm"] for row in motor.curve], fmt="o-", color=color, ms=2.5, lw=0.9,
                       capsize=1.5, label=literal(motor.name))
    curve.set(xlabel="torque (mN m)", ylabel="speed (rpm)")
    curve.legend(frameon=False)
    names = [name for name, one in motors[0].quantities.items()
             if one.value and all(name in motor.quantities for motor in motors)]
    for motor, color in zip(motors[1:], itertools.cycle(COLORS[1:])):
        for place, name in enumerate(names):
            one, other = motors[0].quantities[name], motor.quantities[name]
            bars.errorbar(100 * (other.value / one.value - 1), place, xerr=100 * (one.error + other.error) / abs(one.value),
                          fmt="o", color=color, ms=3, capsize=2)
    bars.axvline(0, color=GREY, lw=0.8)
    bars.set_yticks(range(len(names)), names, fontsize=7)
    bars.invert_yaxis()
    bars.set_xlabel(f"difference from {literal(motors[0].name)} (%)")
    for axes in (curve, bars):
        axes.grid(color="#EEEEEE", lw=0.5)
        axes.set_axisbelow(True)
        axes.spines[["top", "right"]].set_visible(False)
    with figures_folder(motors[0].folder) as folder:
        save(figure, folder, "compare")


def main(folders):
    if len(folders) < 2:
        raise CaseError("expected two folders or more; usage: scripts/compare.py CASE_A CASE_B...")
    motors = [Motor(folder) for folder in folders]
    print_entries(motors)
    for other in motors[1:]:
        print_differences(motors[0], other)
    draw(motors)


if __name__ == "__main__":
    run_script("compare", main)
