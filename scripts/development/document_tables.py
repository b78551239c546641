#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of the pages, from the results of a run.

Usage: scripts/development/document_tables.py points CASE [--every N] | circuits CASE... | rotors CASE...

points: each N-th operating point and the last one: torque, speed, friction loss and its radial part, with error bars.
circuits: phase A of each case, and the voltages that its amplitude takes.
rotors: how the lip of each case answers the wave, and the contact at its first operating point.
"""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from running import surroundings  # noqa: E402, F401  (first: see there)
import argparse
import json

from results.case import read_table, with_error
from results.contact_case import ContactCase
from results.motor_results import quantities_of
from results.node_history import pass_of_node


def bar(value, error):
    """A number with its error bar as the programs print it, or without one."""
    return with_error(value, error).replace("±", "+-") if error > 0. else f"{value:.3g}" if abs(value) < 1 else f"{value:.1f}"


def table(header, rows):
    return "\n".join("| " + " | ".join(cells) + " |" for cells in [header, ["---"] * len(header), *rows])


def points(folder, every):
    rows = read_table(folder / "contact" / "torque_speed.csv", ("control",))
    shown = [row for i, row in enumerate(rows) if i % every == 0 or i == len(rows) - 1]
    return table(["torque, mN m", "speed, rpm", "friction loss, mW", "of which radial, mW"],
                 [[bar(row["torque_mNm"], row["torque_error_mNm"]), bar(row["speed_rpm"], row["speed_error_rpm"]),
                   bar(row["friction_loss_mW"], row["friction_loss_error_mW"]), f"{row['radial_loss_mW']:.0f}"]
                  for row in shown])


def circuits(folders):
    rows = []
    for folder in folders:
        phase = read_table(folder / "stator" / "circuits.csv", ("phase",))[0]
        drive = read_table(folder / "losses" / "drive.csv")
        best = max(drive, key=lambda row: row["electrical_efficiency"])
        rows.append([json.loads((folder / "stator" / "summary.json").read_text(encoding="utf-8"))["entries"]["Motor/Name"],
                     f"{1e-3 * phase['short_circuit_frequency_Hz']:.2f}", f"{phase['k_eff^2']:.4f}", f"{phase['C0_nF']:.1f}",
                     f"{phase['force_factor_N_per_V']:.3f}", f"{phase['Lm_H']:.3f}", f"{phase['Cm_pF']:.1f}",
                     f"{drive[0]['voltage_V']:.1f}", f"{best['voltage_V']:.1f}", f"{drive[-1]['voltage_V']:.1f}"])
    return table(["motor", "f, kHz", "k_eff^2", "C0, nF", "force factor, N/V", "Lm, H", "Cm, pF", "no load, V",
                  "best efficiency, V", "stall, V"], rows)


ROTOR_ROWS = (("frequency of the wave, kHz", "frequency", 1e-3), ("A_r/A_n of the teeth", "A_r/A_n", 1.),
              ("A_r/A_n of the lip", "lip_A_r/A_n", 1.), ("clearance, mm", "clearance", 1.),
              *((f"lip with inertia over without, harmonic {m}", f"lip_amplification_{m}", 1.) for m in (1, 2, 3, 6)),
              ("speed without load, rpm", "speed at 0", 1.), ("friction loss, mW", "friction_loss at 0", 1.),
              ("share of the radial loss", "radial_loss_share at 0", 1.),
              ("teeth per wave", "teeth_in_contact_per_wave at 0", 1.), ("stick fraction", "stick_fraction at 0", 1.),
              ("second stick fraction", "second_stick_fraction at 0", 1.))


def rotors(folders):
    cases = [quantities_of(folder) for folder in folders]
    names = [ContactCase(folder).motor for folder in folders]
    words = [", ".join(pass_of_node(ContactCase(folder), 0)) or "-" for folder in folders]
    return table(["without load", *names], [
        *([said, *(bar(scale * case[name].value, scale * case[name].error) for case in cases)]
          for said, name, scale in ROTOR_ROWS),
        ["friction at a node", *words]])


TABLES = {"circuits": circuits, "rotors": rotors}


def main():
    parser = argparse.ArgumentParser(usage=__doc__.split("Usage: ")[1].split("\n")[0])
    parser.add_argument("table", choices=("points", *TABLES))
    parser.add_argument("cases", type=pathlib.Path, nargs="+")
    parser.add_argument("--every", type=int, default=1)
    options = parser.parse_args()
    print(points(options.cases[0], options.every) if options.table == "points" else TABLES[options.table](options.cases))


if __name__ == "__main__":
    sys.exit(main())
