#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the program contact costs on the reference motor: whole runs, timed from outside, and phases.

usage: benchmarks/contact_cost.py [--repeat 3] [--growth] [--markdown FILE]

Each case is run `--repeat` times in a folder of its own; the table quotes medians. "condensation" is that
of the finest interface mesh in use (the next coarser one, from which errors are estimated, comes on top in
"whole"), "point" the median of the operating points that are shown, "curve" all of them, "memory" the
largest resident set. --growth lets the interface and the number of teeth grow and fits exponents.
"""
import argparse
import csv
import json
import math
import pathlib
import shutil
import statistics
import sys
import tempfile

sys.dont_write_bytecode = True
from motor_run import write_markdown  # noqa: E402
from timed_run import program, teeth, timed_run  # noqa: E402

PLAIN = {"Friction/Law": "coulomb", "Rotor/Flange element": "solid", "Accuracy/Mode": "fixed",
         "Accuracy/Target": "1e-3", "Accuracy/Refinement": "1", "Output/VTU": "false"}


def adaptive(target, **others):
    return {"Accuracy/Mode": "adaptive", "Accuracy/Contact target": str(target), **others}


CASES = [(f"target {target}", adaptive(target)) for target in (0.1, 0.03, 0.01)]
CASES += [("target 0.03, flange as shell", adaptive(0.03, **{"Rotor/Flange element": "shell"})),
          ("target 0.01, flange as shell", adaptive(0.01, **{"Rotor/Flange element": "shell"})),
          ("target 0.03, static-dynamic law", adaptive(0.03, **{"Friction/Law": "static-dynamic"})),
          ("target 0.03, warp 4 um, marched, two points",
           adaptive(0.03, **{"Initial deformation/Amplitude": "4e-6", "Loading/Values": "0, 0.05"}))]
LOADS = "0.05, 0.1"  # N m; without load, power takes more steps to balance
STEPS_IN_PERIOD = 360


def motor_with(number):
    """Of teeth, with the same steps in a period."""
    return {**teeth(number), "Time/Snapshots": str(STEPS_IN_PERIOD // number), "Accuracy/Interface refinement": "1",
            "Loading/Values": LOADS}


POINTS_ON_A_TOOTH = (15, 25, 49, 81)  # of the interface meshes on the reference motor
GROWTH_OF_TEETH = [(number, motor_with(number)) for number in (30, 60, 90, 180, 360)]
GROWTH_OF_INTERFACE = [(level, {**motor_with(90), "Accuracy/Interface refinement": str(level)})
                       for level in range(len(POINTS_ON_A_TOOTH))]


def condensation_seconds(summary):
    """Of the finest mesh in use."""
    name = "condensation, interface mesh "
    return max((int(key[len(name):]), value) for key, value in summary["seconds"].items() if key.startswith(name))[1]


def measure(entries, repeat):
    """Medians of some runs: dict of numbers."""
    runs = []
    with tempfile.TemporaryDirectory() as folder:
        timed_run("stator", folder, {**PLAIN, **entries})
        for _ in range(repeat):
            shutil.rmtree(pathlib.Path(folder) / "contact", ignore_errors=True)  # kept condensations
            seconds, memory = timed_run("contact", folder, {**PLAIN, **entries})
            summary = json.loads((pathlib.Path(folder) / "contact" / "summary.json").read_text())
            with open(pathlib.Path(folder) / "contact" / "torque_speed.csv") as file:
                points = [float(row["seconds"]) for row in csv.DictReader(file)]
            runs.append({"whole": seconds, "memory": memory,
                         "condensation": condensation_seconds(summary),
                         "curve": sum(points), "point": statistics.median(points)})
    result = {key: statistics.median(r[key] for r in runs) for key in runs[0]}
    for speed in (q for q in summary["quantities"] if q["name"] == "no_load_speed"):
        result["speed"] = speed["value"] * 30 / math.pi
        result["error"] = speed["error"] * 30 / math.pi
    result["dofs"] = summary["dofs"]
    return result


def table(rows, repeat):
    header = ["case", "dofs", "whole s", "condensation s", "point s", "curve s", "memory MB", "no-load rpm"]
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    print("\n".join(lines), flush=True)
    for name, entries in rows:
        r = measure(entries, repeat)
        lines.append(f"| {name} | {r['dofs']} | {r['whole']:.2f} | {r['condensation']:.2f} | {r['point']:.3f} | "
                     f"{r['curve']:.2f} | {r['memory']:.0f} | {r['speed']:.2f} +- {r['error']:.2f} |")
        print(lines[-1], flush=True)
    return lines


def exponent(sizes, values):
    """Slope of the straight line through the logarithms."""
    x, y = [math.log(s) for s in sizes], [math.log(v) for v in values]
    mean_x, mean_y = statistics.mean(x), statistics.mean(y)
    return sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y)) / sum((a - mean_x) ** 2 for a in x)


def growth(name, cases, size_of, repeat):
    header = [name, "condensation s", "point s", "memory MB"]
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    found = [(size_of(key), measure(entries, repeat)) for key, entries in cases]
    for size, r in found:
        lines.append(f"| {size} | {r['condensation']:.2f} | {r['point']:.3f} | {r['memory']:.0f} |")
    sizes = [size for size, _ in found]
    lines.append("| exponent | " + " | ".join(
        f"{exponent(sizes, [r[key] for _, r in found]):.1f}" for key in ("condensation", "point", "memory")) + " |")
    print("\n".join(lines) + "\n", flush=True)
    return lines + [""]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--growth", action="store_true", help="with the interface's and the ring's size")
    parser.add_argument("--markdown", help="also write the tables to this file")
    options = parser.parse_args()
    program("contact")
    if options.growth:
        lines = growth("points on a tooth", GROWTH_OF_INTERFACE, POINTS_ON_A_TOOTH.__getitem__, options.repeat)
        lines += growth("teeth", GROWTH_OF_TEETH, int, options.repeat)
    else:
        lines = table(CASES, options.repeat)
    if options.markdown:
        write_markdown(options.markdown, lines)


if __name__ == "__main__":
    main()
