#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""How much of the work of contact several ranks share, counted on any number of cores.

usage: benchmarks/shared_work.py [--ranks 2,4,8,16] [--markdown FILE] [MOTOR...]

A rank counts the seconds of the processor that its tasks take (`ranks` in contact/summary.json). What is not shared is
the time of one rank without these. With a core for each rank a run would take that and, each time that work is shared,
as long as the busiest rank: "times faster" compares one rank with it. The processor counts the same seconds where several
ranks have to share a core, as here, or somewhat more, as they also share caches. All motors are computed with the
defaults of a user, fields for ParaView included; speeds and torques have to be the same on any number of ranks.
"""
import argparse
import csv
import json
import pathlib
import shutil
import sys
import tempfile

sys.dont_write_bytecode = True
from motor_run import table, write_markdown  # noqa: E402
from timed_run import ROOT, limited_run, on_ranks, program  # noqa: E402

INERTIA = {f"Effects/{name}": "on" for name in ("Rotor inertia", "Tooth inertia", "Damping")}
MOTORS = {
    "canon_ring": ("canon_ring.prm", {}),
    "canon_ring with inertia": ("canon_ring.prm", INERTIA),
    "ring60": ("ring60.prm", {}),
    "canon_ring, 360 teeth": ("canon_ring.prm", {"Motor/Number of teeth": "360", "Stator/Slot width": "0.00015"}),
}
EQUAL = 1e-6  # of the largest speed or torque


def run(name, n_ranks, motor, entries, folder):
    words = [str(ROOT / "prm" / motor)]
    for entry, value in {**entries, "Output/Figures": "false"}.items():
        words += ["--set", f"{entry} = {value}"]
    done = limited_run([*on_ranks(n_ranks), str(program(name)), *words, "--output", str(folder)])
    if done.status != 0:
        sys.exit(f"{name} {' '.join(words)} on {n_ranks} ranks: {done.message}")


def curve(folder):
    with open(folder / "contact" / "torque_speed.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    return [[float(row[name]) for row in rows] for name in ("speed_rpm", "torque_mNm")]


def difference(one, other):
    """Of two curves, relative to the largest speed or torque."""
    return max(abs(a - b) / max(map(abs, values)) for values, others in zip(one, other) for a, b in zip(values, others))


def measured(name, numbers_of_ranks):
    motor, entries = MOTORS[name]
    row, alone, whole, first, largest = [name], 0., 0., None, 0.
    with tempfile.TemporaryDirectory() as scratch:
        run("stator", 1, motor, entries, scratch)
        for n_ranks in (1, *numbers_of_ranks):
            shutil.rmtree(pathlib.Path(scratch) / "contact", ignore_errors=True)  # with what it keeps
            run("contact", n_ranks, motor, entries, scratch)
            summary = json.loads((pathlib.Path(scratch) / "contact" / "summary.json").read_text(encoding="utf-8"))
            found = curve(pathlib.Path(scratch))
            longest = summary["ranks"]["longest_shares"]
            if n_ranks == 1:
                whole, first = sum(summary["seconds"].values()), found
                alone = whole - longest
                row += [f"{whole:.1f}", f"{100. * alone / whole:.0f}"]
            else:
                largest = max(largest, difference(first, found))
                row.append(f"{longest:.1f}, {whole / (alone + longest):.1f}")
    if largest > EQUAL:
        sys.exit(f"{name}: speeds or torques differ by {largest:.1e} between numbers of ranks")
    return row


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("motors", nargs="*", default=list(MOTORS), metavar="MOTOR", help=", ".join(MOTORS))
    parser.add_argument("--ranks", default="2,4,8,16", help="numbers of ranks")
    parser.add_argument("--markdown", type=pathlib.Path, help="also write the table to this file")
    options = parser.parse_args()
    numbers = [int(number) for number in options.ranks.split(",")]
    lines = table(["motor", "one rank, s", "not shared, %",
                   *(f"{number} ranks: longest shares, s; times faster" for number in numbers)],
                  [measured(name, numbers) for name in options.motors])
    print("\n".join(lines))
    if options.markdown:
        write_markdown(options.markdown, lines)


if __name__ == "__main__":
    main()
