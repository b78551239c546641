#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Convergence with the inertia of the rotor, and the influence of friction, on the reference motor.

usage: benchmarks/inertia.py convergence | friction [--markdown FILE] [--figure FILE.png]

One coefficient of friction, all other effects as in the paper. The first table varies steps, dissipation, modes and
interface mesh one at a time from a common setting; each row quotes its own error bars, except those of the
wave, which is the same in all rows. Last, the values with the target of the reference motor, whose bars must contain
all rows that are at least as fine as the common setting. The second table, and the figure, vary the coefficient.
"""
import argparse
import pathlib
import shutil
import sys
import tempfile

sys.dont_write_bytecode = True
from motor_run import OUTPUT_OFF, certified_run, operating_points, table, write_markdown  # noqa: E402
from timed_run import MOTOR, ROOT  # noqa: E402

TORQUES = (0., 0.05, 0.1, 0.13)  # N m
BASE = {**OUTPUT_OFF, "Effects/Rotor inertia": "on", "Effects/Damping": "on",
        "Effects/Static friction excess": "off", "Friction/Dynamic coefficient": "0.4", "Time/Spectral radius": "0.8",
        "Loading/Values": ", ".join(map(str, TORQUES))}
FIXED = {"Accuracy/Mode": "fixed", "Accuracy/Interface refinement": "1", "Time/Snapshots": "4"}
# Name, entries, and whether the setting is at least as fine as the common one.
ROWS = [("common setting: 360 steps, spectral radius 0.8, `Rotor modes = 2`, interface mesh 1", {}, True)]
ROWS += [(f"{90 * number} steps", {"Time/Snapshots": str(number)}, number > 4) for number in (2, 3, 6)]
ROWS += [(f"spectral radius {radius}", {"Time/Spectral radius": str(radius)}, True) for radius in (0.5, 0.9)]
ROWS += [(f"`Rotor modes = {level}`", {"Accuracy/Rotor modes": str(level)}, level > 2) for level in (1, 3)]
ROWS += [(f"interface mesh {level}", {"Accuracy/Interface refinement": str(level)}, level > 1) for level in (0, 2, 3)]
FRICTION = [("0.40, without", {"Effects/Rotor inertia": "off", "Effects/Damping": "off", "Time/Snapshots": "8"})]
FRICTION += [(f"{mu:.2f}, with", {"Friction/Dynamic coefficient": str(mu)}) for mu in (0.4, 0.6, 0.7, 0.8)]


def cells(rows, key, error, digits):
    return [f"{row[key]:.{digits}f} +- {row[error]:.{digits}f}" if row else "" for row in rows]


def points_where_powers_balance(folder, entries):
    """The rows of the torques; None for those at which long steps leave the powers unbalanced."""
    for left_out in range(len(TORQUES)):
        values = {"Loading/Values": ", ".join(map(str, TORQUES[left_out:]))}
        try:
            found, done = operating_points(MOTOR, folder, {**entries, **values})
        except RuntimeError as error:
            if "power put in" not in str(error):
                raise
            continue
        return [None] * left_out + found, done
    raise RuntimeError("powers do not balance at any torque")


def convergence(folder):
    header = ["varied"] + [f"{1e3 * torque:g} mN m, rpm" for torque in TORQUES] + ["loss at 0, mW", "seconds"]
    lines, finer = [], []

    def add(name, found, done):
        lines.append([name] + cells(found, "speed_rpm", "speed_error_rpm", 2) +
                     cells(found[:1], "friction_loss_mW", "friction_loss_error_mW", 0) +
                     [f"{done.processor_seconds:.0f}"])
        print(" | ".join(lines[-1]), flush=True)
    for name, entries, is_finer in ROWS:
        try:
            found, done = points_where_powers_balance(folder, {**BASE, **FIXED, **entries})
        except RuntimeError as error:
            print(f"{name}: {error}", file=sys.stderr)
            continue
        add(name, found, done)
        if is_finer:
            finer.append((name, found))
    found, done = operating_points(MOTOR, folder, {**BASE, "Accuracy/Contact target": "0.1"})
    add("`Contact target = 0.1`", found, done)
    compared = [(f"{name}, {1e3 * torque:g} mN m",
                 abs(row["speed_rpm"] - bar["speed_rpm"]) <= bar["speed_error_rpm"])
                for name, rows in finer for torque, row, bar in zip(TORQUES, rows, found) if row]
    outside = [name for name, is_inside in compared if not is_inside]
    closing = (f"The last bars contain {len(compared) - len(outside)} of {len(compared)} speeds "
               "of the rows that are at least as fine as the common setting")
    return table(header, lines) + ["", f"{closing}; not {'; '.join(outside)}." if outside else f"{closing}."]


def friction(folder, figure):
    torques = (0., 0.05, 0.1, 0.15)
    header = ["coefficient, inertia", "speed at 0, 50, 100, 150 mN m, rpm", "friction loss, mW"]
    lines, cases = [], []
    for name, entries in FRICTION:
        found, _ = operating_points(MOTOR, folder, {**BASE, **FIXED, "Motor/Name": f"friction {name} inertia",
                                   "Loading/Values": ", ".join(map(str, torques)), **entries})
        lines.append([name] + [", ".join(f"{row[key]:.{digits}f}" for row in found)
                               for key, digits in (("speed_rpm", 1), ("friction_loss_mW", 0))])
        print(" | ".join(lines[-1]), flush=True)
        cases.append(pathlib.Path(shutil.copytree(folder, folder.parent / f"case{len(cases)}")))
    if figure:
        draw(cases, figure)
    return table(header, lines)


def draw(folders, path):
    sys.path.insert(0, str(ROOT / "scripts"))
    from drawing import curve_figures
    from results import contact_case
    cases = [contact_case.ContactCase(str(folder)) for folder in folders]
    figure = curve_figures.draw_torque_speed(cases[0], cases[1:])
    figure.suptitle("Reference motor: speed and friction loss, friction 0.40 without and 0.40 to 0.80 with inertia",
                    fontsize=9)
    figure.savefig(path, dpi=160)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("table", choices=("convergence", "friction"))
    parser.add_argument("--markdown", type=pathlib.Path, help="also write the tables to this file")
    parser.add_argument("--figure", type=pathlib.Path, help="file of the figure of friction coefficients")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch) / "case"
        certified_run("stator", MOTOR, folder, {**BASE, "Accuracy/Target": "1e-4"})
        lines = convergence(folder) if options.table == "convergence" else friction(folder, options.figure)
        print("\n".join(lines))
        if options.markdown:
            write_markdown(options.markdown, lines)


if __name__ == "__main__":
    main()
