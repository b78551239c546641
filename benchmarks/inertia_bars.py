#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Error bars of motors with inertia against finer settings of each kind: steps, modes, meshes, scheme.

usage: benchmarks/inertia_bars.py [--resume] [--csv FILE] [--markdown FILE] [MOTOR ...]

Three motors, one coefficient of friction, at 50 and 100 mN m (the short spring at 100). From a common setting one thing at a
time is made finer; nineteen of twenty changes of a speed or a friction loss have to be within its error bar in the common setting.
Five minutes for each motor; with --resume the rows of the CSV file are kept.
"""
import argparse
import pathlib
import shutil
import sys

sys.dont_write_bytecode = True
from motor_run import OUTPUT_OFF, RowFile, add_operating_points, certified_run, table, write_markdown  # noqa: E402
from timed_run import ROOT  # noqa: E402

SOFT, STIFF = (ROOT / "prm" / f"{name}.prm" for name in ("soft_spring", "stiff_spring"))
# A spring and teeth that vibrate far above the drive: the loss factor is small, and high harmonics of the wave matter.
SHORT_SPRING = {
    "Stator/Base inner radius": "0.0296", "Stator/Base outer radius": "0.0356", "Stator/Base thickness": "0.004153",
    "Stator/Tooth height": "0.0017", "Rotor/Ring inner radius": "0.0350", "Rotor/Ring outer radius": "0.0410",
    "Rotor/Ring lower face": "-0.0015", "Rotor/Ring upper face": "0.0065", "Rotor/Flange thickness": "0.00032",
    "Rotor/Flange element": "solid", "Rotor/Lip inner radius": "0.03405"}
MOTORS = {"reference": (SOFT, {}, {"Accuracy/Rotor modes": "1"}, "0.8"),
          "stiff spring": (STIFF, {}, {}, "0.9"),
          "short spring": (SOFT, {**SHORT_SPRING, "Time/Spectral radius": "0.8", "Loading/Values": "0.1"}, {}, "0.9")}
TORQUES = ("0.05", "0.1")  # N m
BASE = {**OUTPUT_OFF, "Effects/Rotor inertia": "on", "Effects/Tooth inertia": "on", "Effects/Tooth vibration": "on",
        "Effects/Damping": "on", "Effects/Tooth shear": "on", "Effects/Rotor tangential compliance": "on", "Effects/Static friction excess": "off",
        "Effects/Stator back-reaction": "off", "Effects/Felt support": "off", "Friction/Static coefficient": "0.4",
        "Friction/Dynamic coefficient": "0.4", "Loading/Values": ", ".join(TORQUES)}
COMMON = {"Accuracy/Mode": "fixed", "Accuracy/Interface refinement": "1", "Accuracy/Rotor modes": "2", "Time/Snapshots": "4"}
QUANTITIES = (("speed", "rpm", "speed_rpm", "speed_error_rpm"),
              ("friction loss", "mW", "friction_loss_mW", "friction_loss_error_mW"))
COLUMNS = ["motor", "setting", "seconds", "torque_mNm"] + [column for quantity in QUANTITIES for column in quantity[2:]]


def settings(common, radius):
    """The common setting and those that are finer in one thing, by name."""
    def one_more(entry, factor=1, increment=1):
        return {**common, entry: str(int(common[entry]) * factor + increment)}
    return {"common": common, "half the step": one_more("Time/Snapshots", 2, 0), "finer modes": one_more("Accuracy/Rotor modes"),
            "finer meshes": one_more("Accuracy/Interface refinement"), "other scheme": {**common, "Time/Spectral radius": radius}}


def compute(name, rows, folder):
    motor, entries, of_common, radius = MOTORS[name]
    shutil.rmtree(folder, ignore_errors=True)
    wanted = {setting: accuracy for setting, accuracy in settings({**COMMON, **of_common}, radius).items()
              if not rows.find(motor=name, setting=setting)}
    if wanted:
        certified_run("stator", motor, folder, {**BASE, **entries})
    for setting, accuracy in wanted.items():
        add_operating_points(rows, {"motor": name, "setting": setting}, motor, folder, {**BASE, **entries, **accuracy})
    shutil.rmtree(folder, ignore_errors=True)


def evaluate(rows):
    finer = [setting for setting in settings(COMMON, "") if setting != "common"]
    lines, ratios = [], []
    for name in MOTORS:
        for torque in TORQUES:
            of = {row["setting"]: row for row in rows.rows
                  if row["motor"] == name and abs(float(row["torque_mNm"]) - 1e3 * float(torque)) < 0.1}
            if "common" not in of:
                continue
            for quantity, unit, value, error in QUANTITIES:
                bar, own = float(of["common"][error]), float(of["common"][value])
                changes = [float(of[setting][value]) - own if setting in of else None for setting in finer]
                ratios += [abs(change) / bar for change in changes if change is not None]
                lines.append([name, f"{1e3 * float(torque):g}", f"{quantity}, {unit}", f"{own:.2f} +- {bar:.2f}"] +
                             ["not found" if change is None else f"{change:+.2f}" for change in changes] +
                             [f"{max(abs(change) / bar for change in changes if change is not None):.2f}"])
    header = ["motor", "torque, mN m", "quantity", "common setting"] + finer + ["largest change over bar"]
    closing = (f"{len(ratios)} changes: {sum(ratio > 1. for ratio in ratios)} exceed their error bar, the largest is "
               f"{max(ratios):.2f} of it.")
    return table(header, lines) + ["", closing]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("motors", nargs="*", default=list(MOTORS), metavar="MOTOR", help=", ".join(MOTORS))
    parser.add_argument("--csv", type=pathlib.Path, default=ROOT / "output" / "inertia_bars.csv")
    parser.add_argument("--resume", action="store_true", help="keep the rows of that file, run what it lacks")
    parser.add_argument("--markdown", type=pathlib.Path, help="also write the tables to this file")
    options = parser.parse_args()
    rows = RowFile(options.csv, COLUMNS, options.resume)
    for name in options.motors:
        compute(name, rows, options.csv.with_suffix(f".{name.replace(' ', '_')}"))
    lines = evaluate(rows)
    print("\n".join(lines))
    if options.markdown:
        write_markdown(options.markdown, lines)


if __name__ == "__main__":
    main()
