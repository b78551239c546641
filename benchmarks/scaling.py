#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""How the time of the programs grows with the size of the problem, and what a second rank gains.

usage: benchmarks/scaling.py [--repeat 3] [--markdown FILE] [--only TEXT]

The reference motor with the model of the paper, unless stated otherwise; stator and contact are each timed from outside.
Growth is in seconds of the processor, medians of --repeat runs, with the exponent of the growth over the last doubling.
A second rank is measured by the clock, alternating with one rank, as the median of the ratios of neighbouring runs.
"""
import argparse
import math
import pathlib
import shutil
import statistics
import sys
import tempfile

sys.dont_write_bytecode = True
from motor_run import OUTPUT_OFF, table, write_markdown  # noqa: E402
from timed_run import AUTO, MOTOR, ROOT, arguments, limited_run, on_ranks, program, teeth  # noqa: E402

WITH_INERTIA = {**AUTO, "Accuracy/Contact target": "0.1"}
FIXED = {"Accuracy/Mode": "fixed", "Accuracy/Polynomial degree": "3", "Accuracy/Refinement": "1"}
COARSE = {"Accuracy/Target": "1e-3"}


# what grows: program, sizes, entries of a size
GROWTH = {
    "largest number of waves, stator (n = 0 to it, degree 3)":
        ("stator", (3, 6, 12, 24, 45), lambda n: {**FIXED, "Modes/Nodal diameters": f"0-{n}"}),
    "teeth, stator (n = 7, degree 3)": ("stator", (45, 90, 180, 360), lambda n: {**FIXED, **teeth(n)}),
    "points on a curve, contact":
        ("contact", (3, 6, 11, 21, 41), lambda n: {**COARSE, "Loading/Number of curve points": n}),
    "points on a curve, contact with inertia":
        ("contact", (3, 6, 11, 21, 41), lambda n: {**COARSE, **WITH_INERTIA, "Loading/Number of curve points": n}),
}
RANKS = {
    "stator, n = 7, target 1e-4": ("stator", {"Accuracy/Target": "1e-4"}),
    "stator, n = 0-12, target 2.5e-4": ("stator", {"Accuracy/Target": "2.5e-4", "Modes/Nodal diameters": "0-12"}),
    "contact, eleven points": ("contact", COARSE),
    "contact, eleven points, with inertia": ("contact", {**COARSE, **WITH_INERTIA}),
}


def run(name, folder, entries, n_ranks=1):
    done = limited_run([*on_ranks(n_ranks), str(program(name)), *arguments(MOTOR, folder, {**OUTPUT_OFF, **entries})])
    if done.status != 0:
        sys.exit(f"{name} {entries}: {done.message}")
    return done


def prepared(name, folder, entries):
    """What the program needs, without what it keeps of earlier runs."""
    if name == "contact" and not (pathlib.Path(folder) / "stator").exists():
        run("stator", folder, entries)
    shutil.rmtree(pathlib.Path(folder) / "contact", ignore_errors=True)


def seconds_of(name, entries, repeat):
    with tempfile.TemporaryDirectory() as folder:
        found = []
        for _ in range(repeat):
            prepared(name, folder, entries)
            found.append(run(name, folder, entries).processor_seconds)
    return statistics.median(found)


def growth(what, repeat):
    name, sizes, entries_of = GROWTH[what]
    seconds = [seconds_of(name, entries_of(size), repeat) for size in sizes]
    exponent = math.log(seconds[-1] / seconds[-2]) / math.log(sizes[-1] / sizes[-2])
    return [what, ", ".join(map(str, sizes)), ", ".join(f"{s:.2f}" for s in seconds), f"{exponent:.1f}"]


def second_rank(what, repeat):
    name, entries = RANKS[what]
    with tempfile.TemporaryDirectory() as folder:
        pairs = []
        for _ in range(repeat):
            pairs.append([])
            for n_ranks in (1, 2):
                prepared(name, folder, entries)
                pairs[-1].append(run(name, folder, entries, n_ranks).seconds)
    one, two = (statistics.median(times) for times in zip(*pairs))
    return [what, f"{one:.1f}", f"{two:.1f}", f"{statistics.median(a / b for a, b in pairs):.2f}"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--only", default="", metavar="TEXT", help="only rows with these words")
    parser.add_argument("--markdown", metavar="FILE", help="also write the tables to this file")
    options = parser.parse_args()
    lines = table(["what grows", "sizes", "seconds of the processor", "exponent"],
                  [growth(what, options.repeat) for what in GROWTH if options.only in what])
    lines += ["", *table(["run", "one rank, s", "two ranks, s", "times faster"],
                         [second_rank(what, options.repeat) for what in RANKS if options.only in what])]
    print("\n".join(lines))
    if options.markdown:
        write_markdown(options.markdown, lines)


if __name__ == "__main__":
    main()
