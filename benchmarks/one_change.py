#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What single entries change in a motor: prm/static_rotor.prm with one change at a time.

usage: benchmarks/one_change.py [--markdown FILE]

Each row is a run of stator, contact and losses in a folder of its own; six points of the curve, Accuracy/Target = 1e-3.
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
from motor_run import OUTPUT_OFF, table, write_markdown  # noqa: E402
from timed_run import ROOT, program  # noqa: E402

sys.path.insert(0, str(ROOT / "scripts"))
from results.case import read_table  # noqa: E402

MOTOR = ROOT / "prm" / "static_rotor.prm"
COMMON = {**OUTPUT_OFF, "Accuracy/Target": "1e-3", "Loading/Number of curve points": "6"}
CHANGES = [("nothing", {}),
           ("`Stator/Base thickness` 4.37 to 4.8 mm", {"Stator/Base thickness": "4.8e-3"}),
           ("`Stator/Tooth height` 2.0 to 2.5 mm", {"Stator/Tooth height": "2.5e-3"}),
           ("`Wave/Amplitude` 2 to 1.5 um", {"Wave/Amplitude": "1.5e-6"}),
           ("`Loading/Preload` 14 to 20 N", {"Loading/Preload": "20"}),
           ("both coefficients of friction, 0.36 and 0.30",
            {"Friction/Static coefficient": "0.36", "Friction/Dynamic coefficient": "0.30"}),
           ("`Initial deformation/Amplitude` 0 to 4 um", {"Initial deformation/Amplitude": "4e-6"})]
HEADER = ["changed", "f kHz", "A_t/A_n", "next mode above", "no load rpm", "stall mN m", "best efficiency", "stator loss mW"]


def row_of(name, entries, folder):
    words = [word for entry, value in {**COMMON, **entries}.items() for word in ("--set", f"{entry} = {value}")]
    subprocess.run([program("motor"), MOTOR, *words, "--output", folder], check=True, stdout=subprocess.DEVNULL)
    summary = json.loads((folder / "stator" / "summary.json").read_text(encoding="utf-8"))
    value = {quantity["name"]: quantity["value"] for quantity in summary["quantities"]}
    bending, other = read_table(folder / "stator" / "frequencies.csv", ("family",))[:2]
    points = read_table(folder / "contact" / "torque_speed.csv", ("control",))
    losses, efficiencies = (read_table(folder / "losses" / f"{table}.csv") for table in ("losses", "efficiency"))
    return [name, f"{1e-3 * bending['frequency_Hz']:.2f}", f"{value['A_t/A_n']:.3f}",
            f"{100 * (other['frequency_Hz'] / bending['frequency_Hz'] - 1):.1f} %", f"{points[0]['speed_rpm']:.1f}",
            f"{points[-1]['torque_mNm']:.1f}", f"{100 * max(row['efficiency'] for row in efficiencies):.1f} %",
            f"{losses[0]['internal_loss_stator_mW']:.0f}"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--markdown", type=pathlib.Path, help="also write the tables to this file")
    options = parser.parse_args()
    rows = []
    for name, entries in CHANGES:
        with tempfile.TemporaryDirectory() as folder:
            rows.append(row_of(name, entries, pathlib.Path(folder)))
        print(" | ".join(rows[-1]), flush=True)
    if options.markdown:
        write_markdown(options.markdown, table(HEADER, rows))


if __name__ == "__main__":
    main()
