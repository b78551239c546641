#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""True errors of operating points against their error bars, on twelve motors without inertia.

usage: benchmarks/error_bars.py [--resume] [--csv FILE] [--markdown FILE] [--figure FILE.png] [MOTOR ...]

Each motor is computed at five torques with several targets. The truth is interface mesh 4 with at least 720 steps per
period; its own error bars, a few times shorter, are not taken into account. It takes two to six minutes for each motor
(60 mm: a quarter of an hour); with --resume the rows of the CSV file are kept.
"""
import argparse
import math
import pathlib
import shutil
import statistics
import sys

sys.dont_write_bytecode = True
from motor_run import (OUTPUT_OFF, RowFile, add_operating_points, certified_run, operating_points,  # noqa: E402
                       table, write_markdown)
from timed_run import PAPERS_MODEL, ROOT, entries_of  # noqa: E402

SOFT, STIFF, RING60 = (ROOT / "prm" / f"{name}.prm" for name in ("soft_spring", "stiff_spring", "ring60"))
RING45 = ROOT / "tests" / "programs" / "ring45.prm"
MOTORS = {
    "reference": (SOFT, {}), "stiff spring": (STIFF, {}), "solid flange": (SOFT, {"Rotor/Flange element": "solid"}),
    "lip inside the teeth": (SOFT, {"Rotor/Lip outer radius": "0.0338"}),
    "60 N": (SOFT, {"Loading/Preload": "60"}), "3 N": (SOFT, {"Loading/Preload": "3"}),
    "high teeth": (SOFT, {"Stator/Tooth height": "0.0035", "Stator/Slot width": "0.0003"}),
    "friction 0.15": (SOFT, {"Friction/Static coefficient": "0.15", "Friction/Dynamic coefficient": "0.15"}),
    "thick flange": (SOFT, {"Rotor/Flange thickness": "0.0009"}),
    "45 mm": (RING45, {"Loading/Preload": "10", "Wave/Amplitude": "1e-6"}),
    "60 mm": (RING60, {"Effects/Friction lining": "on"}),
    "wave of 1 um": (SOFT, {"Wave/Amplitude": "1e-6"})}
BASE = {**PAPERS_MODEL, **OUTPUT_OFF, "Effects/Static friction excess": "off", "Effects/Initial deformation": "off",
        "Friction/Static coefficient": "0.4", "Friction/Dynamic coefficient": "0.4"}
TARGETS = ("0.03", "0.01", "0.003")
STEPS_OF_TRUTH = 720  # per period
SHARES = (0., 0.25, 0.5, 0.75, 0.9)  # of the stall torque
# Columns of values and of their error bars.
QUANTITIES = {"speeds": ("speed_rpm", "speed_error_rpm"),
              "losses": ("friction_loss_mW", "friction_loss_error_mW"),
              "stick fractions": ("stick_fraction", "stick_fraction_error"),
              "teeth in contact": ("teeth_in_contact_per_wave", "teeth_in_contact_per_wave_error")}
COLUMNS = ["motor", "target", "seconds", "torque_mNm"] + sum(map(list, QUANTITIES.values()), [])


def truth_of(motor):
    """Entries of the finest discretisation."""
    n_waves, n_teeth = (int(entries_of(motor)[f"Motor/Number of {which}"]) for which in ("waves", "teeth"))
    steps = n_teeth // math.gcd(n_waves, n_teeth)  # with one time sample: a step from tooth to tooth that differ
    return {"Accuracy/Mode": "fixed", "Accuracy/Interface refinement": "4",
            "Time/Snapshots": str(math.ceil(STEPS_OF_TRUTH / steps))}


def compute(name, rows, scratch):
    motor, others = MOTORS[name]
    entries = {**BASE, **others}
    wanted = [target for target in TARGETS + ("truth",) if not rows.find(motor=name, target=target)]
    if not wanted:
        return
    shutil.rmtree(scratch, ignore_errors=True)
    certified_run("stator", motor, scratch, {**entries, "Accuracy/Contact target": "0.001"})
    ends, _ = operating_points(motor, scratch, {**entries, "Accuracy/Contact target": "0.3",
                                                "Loading/Number of curve points": "2"})
    stall = 1e-3 * max(row["torque_mNm"] for row in ends)
    loads = {"Loading/Values": ", ".join(f"{share * stall:.6g}" for share in SHARES)}
    for target in wanted:
        accuracy = truth_of(motor) if target == "truth" else {"Accuracy/Contact target": target}
        add_operating_points(rows, {"motor": name, "target": target}, motor, scratch, {**entries, **loads, **accuracy})
    shutil.rmtree(scratch, ignore_errors=True)


def ratios(rows, truth, value, error):
    """True error over error bar."""
    return [abs(float(row[value]) - float(true[value])) / float(row[error]) for row, true in zip(rows, truth)]


def evaluate(rows):
    """The lines of the table, and all ratios by target."""
    header = ["motor", "target", "seconds", "largest bar of speed, %", "true error over bar: " + ", ".join(QUANTITIES)]
    header[-1:] = header[-1].split(", ")
    lines, every = [], {target: [] for target in TARGETS}
    for name in MOTORS:
        of = {target: [row for row in rows.rows if row["motor"] == name and row["target"] == target]
              for target in TARGETS + ("truth",)}
        truth = of.pop("truth")
        for target, found in of.items():
            if not found or len(truth) != len(found):
                continue
            parts = [ratios(found, truth, *columns) for columns in QUANTITIES.values()]
            every[target] += sum(parts, [])
            fastest = max(float(row["speed_rpm"]) for row in truth)
            bar = max(float(row["speed_error_rpm"]) for row in found) / fastest
            lines.append([name, target, found[0]["seconds"], f"{100 * bar:.2f}"] +
                         [", ".join(f"{ratio:.2f}" for ratio in part) for part in parts])
    everything = sum(every.values(), [])
    closing = (f"{len(everything)} quantities: the median of true error over bar is "
               f"{statistics.median(everything):.2f}, "
               f"{sum(ratio > 1. for ratio in everything)} are above 1, the largest is {max(everything):.1f}.")
    return table(header, lines) + ["", closing], every


def draw(every, path):
    sys.path.insert(0, str(ROOT / "scripts"))
    from drawing import basics
    import numpy
    figure, axes = basics.plt.subplots(figsize=(6.2, 3.4), layout="constrained")
    for (target, found), color in zip(every.items(), (basics.BLUE, basics.ORANGE, basics.GREEN)):
        axes.step(numpy.sort(found), 100. * (numpy.arange(len(found)) + 1.) / len(found), where="post", color=color,
                  label=f"target {target}, {len(found)} quantities")
    axes.axvline(1., color=basics.GREY, lw=0.8)
    axes.set(xlabel="true error over error bar", ylabel="quantities below, %", xlim=(0, 2.5), ylim=(0, 102))
    axes.legend(frameon=False, loc="lower right")
    axes.spines[["top", "right"]].set_visible(False)
    figure.savefig(path, dpi=160)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("motors", nargs="*", default=list(MOTORS), metavar="MOTOR", help=", ".join(MOTORS))
    parser.add_argument("--csv", type=pathlib.Path, default=ROOT / "output" / "error_bars.csv")
    parser.add_argument("--resume", action="store_true", help="keep the rows of that file, run what it lacks")
    parser.add_argument("--markdown", type=pathlib.Path, help="also write the tables to this file")
    parser.add_argument("--figure", type=pathlib.Path, help="file of the figure of the distribution")
    options = parser.parse_args()
    rows = RowFile(options.csv, COLUMNS, options.resume)
    for name in options.motors:
        compute(name, rows, options.csv.with_suffix(f".{name.replace(' ', '_')}"))
    lines, every = evaluate(rows)
    print("\n".join(lines))
    if options.markdown:
        write_markdown(options.markdown, lines)
    if options.figure:
        draw(every, options.figure)


if __name__ == "__main__":
    main()
