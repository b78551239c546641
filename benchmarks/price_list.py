#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a number of given accuracy costs: seconds on one and on two cores, and memory.

usage: benchmarks/price_list.py [--repeat 1] [--most-seconds 600] [--markdown FILE] [--only TEXT]

Each row is one run of a program with its target, timed from outside; those of the program contact find eleven
operating points from no load to stall. "reached" is the largest relative error bar. The words of a run that fails,
or that takes longer than --most-seconds, stand in the table.
"""
import argparse
import datetime
import json
import pathlib
import statistics
import sys
import tempfile

sys.dont_write_bytecode = True
from motor_run import OUTPUT_OFF, table, write_markdown  # noqa: E402
from timed_run import MOTOR, ROOT, arguments, limited_run, on_ranks, program  # noqa: E402

ONE_COEFFICIENT = {"Friction/Law": "coulomb", "Friction/Static coefficient": "0.40"}
CANON = ROOT / "prm" / "canon_ring.prm"
INERTIA = {"Effects/Rotor inertia": "on", "Effects/Tooth inertia": "on", "Effects/Damping": "on"}


def stator(what, targets, **others):
    return [("stator", MOTOR, what, target, {"Accuracy/Target": target, **others}) for target in targets]


def contact(what, targets, motor=MOTOR, **others):
    return [("contact", motor, what, target, {"Accuracy/Contact target": target, **others}) for target in targets]


ROWS = (
    stator("frequency of the wave", ("1e-2", "1e-3", "1e-4")) +
    stator("two frequencies each, 0 to 12 waves", ("1e-3",), **{"Modes/Nodal diameters": "0-12"}) +
    stator("two frequencies of the rotor, 7 waves", ("1e-2", "1e-3"), **{"Modes/Body": "rotor"}) +
    contact("speed and torque of the reference motor", ("0.1", "0.03", "0.01"), motor=CANON) +
    contact("the same, with inertia of rotor and teeth", ("0.1", "0.03"), motor=CANON, **INERTIA) +
    contact("speed and torque, static rotor with a soft spring", ("0.03", "0.01")) +
    contact("the same, one coefficient of friction", ("0.01",), **ONE_COEFFICIENT))


def run(row, folder, n_ranks, most_seconds):
    name, motor, _, _, entries = row
    command = on_ranks(n_ranks) + [str(program(name))] + arguments(motor, folder, {**OUTPUT_OFF, **entries})
    return limited_run(command, most_clock_seconds=most_seconds)


def reached(folder, row):
    """The largest relative error of the results, and the memory of a rank in MB."""
    part = row[4].get("Modes/Body", "stator") if row[0] == "stator" else "contact"
    summary = json.loads((folder / part / "summary.json").read_text())
    checks = [check for check in summary["certificate"]["checks"] if check["name"].startswith("largest relative error")]
    return checks[0]["value"], summary["peak_memory_MB"]


def measure(row, repeat, most_seconds):
    """The cells of a row behind its target."""
    cells, value, memory = [], None, None
    for n_ranks in (1, 2):
        seconds = []
        for _ in range(repeat):
            with tempfile.TemporaryDirectory() as name:
                folder = pathlib.Path(name)
                if row[0] == "contact":
                    before = run(("stator", row[1], "", "", row[4]), folder, 1, None)
                    if before.status != 0:
                        sys.exit(before.message)
                done = run(row, folder, n_ranks, most_seconds)
                if done.is_too_long or done.status != 0:
                    words = f"more than {most_seconds:.0f} s" if done.is_too_long else done.message
                    return ["-", words, "-", "-"]
                seconds.append(done.seconds)
                if n_ranks == 1:
                    value, memory = reached(folder, row)
        cells.append(f"{statistics.median(seconds):.1f}")
    return [f"{value:.1e}"] + cells + [f"{memory:.0f}"]


def machine():
    lines = pathlib.Path("/proc/cpuinfo").read_text().splitlines()
    model = next((line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")), "unknown processor")
    return f"{model}, {datetime.date.today().isoformat()}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--repeat", type=int, default=1, help="runs of which the median is quoted")
    parser.add_argument("--most-seconds", type=float, default=600., help="on the clock, for a run")
    parser.add_argument("--only", default="", help="rows whose description has this text")
    parser.add_argument("--markdown", type=pathlib.Path, help="also write the tables to this file")
    options = parser.parse_args()
    rows = []
    for row in (row for row in ROWS if options.only in row[2]):
        rows.append([row[2], row[3]] + measure(row, options.repeat, options.most_seconds))
        print(" | ".join(rows[-1]), flush=True)
    lines = table(["what", "asked", "reached", "s, one core", "s, two cores", "MB"], rows) + ["", f"{machine()}."]
    print("\n".join(lines))
    if options.markdown:
        write_markdown(options.markdown, lines)


if __name__ == "__main__":
    main()
