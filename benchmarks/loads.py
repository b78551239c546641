#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Torque-speed curves of one motor from a feather's touch to a ring pressed flat, each on one core.

usage: benchmarks/loads.py [FILE.prm] [--preloads 0.01 14 ...] [--amplitudes 0.2 2 ...] [--seconds 120]
           [--set 'Section/Entry = value']... [--csv FILE [--resume]] [--markdown FILE]

Each combination of preload (N) and amplitude (um) is a run of its own of the program contact; the program
stator runs once for each amplitude. Each row is added to the CSV file as soon as it is known; --resume runs
what the file lacks. "error" is the largest error bar, over the largest speed or torque,
or half of what wave and friction allow for. The exit status is 1 if a run did not end in time, crashed, or gave
wrong results without saying so.
"""
import argparse
import pathlib
import sys
import tempfile

sys.dont_write_bytecode = True
from motor_run import (COLUMNS, OUTPUT_OFF, RowFile, add_options, command_lines, is_acceptable,  # noqa: E402
                       run_contact, run_program, summary, table, write_markdown)
from timed_run import MOTOR  # noqa: E402

PRELOADS = (0.01, 1., 14., 60., 120., 300., 1000.)  # N
AMPLITUDES = (0.02, 0.2, 2.)  # um
HEADER = ["preload N", "amplitude um", "outcome", "seconds", "processor s", "Newton iterations", "nodes touching",
          "no load rpm", "stall mN m", "violation", "error"]
SHOWN = ["preload_N", "amplitude_um", "outcome", "seconds", "processor_seconds", "newton_iterations",
         "nodes_touching", "no_load_rpm", "stall_mNm", "certificate", "worst_error"]


def run_amplitude(options, amplitude, file):
    """All preloads that the file lacks."""
    missing = [preload for preload in options.preloads
               if not file.find(motor=options.motor.stem, preload_N=preload, amplitude_um=amplitude)]
    if not missing:
        return
    entries = {**OUTPUT_OFF, "Loading/Number of curve points": str(options.points), **options.entries,
               "Wave/Amplitude": f"{amplitude * 1e-6:.6g}"}
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(options.keep or scratch) / f"{options.motor.stem}_{amplitude:g}um"
        stator = run_program("stator", options.motor, folder, entries, options)
        for preload in missing:
            of_load = {**entries, "Loading/Preload": f"{preload:g}"}
            row = (run_contact(options.motor, folder, of_load, options) if stator["outcome"] == "certified" else
                   dict(stator))
            row.update(motor=options.motor.stem, preload_N=preload, amplitude_um=amplitude)
            file.add(row)
            print(table([], [[file.rows[-1][column] for column in SHOWN]])[-1], flush=True)
            if row["outcome"] != "certified":
                again = command_lines(options.motor, f"output/loads/{folder.name}", of_load)
                print(f"    {row['message']}\n    {again}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("motor", nargs="?", type=pathlib.Path, default=MOTOR, metavar="FILE.prm")
    parser.add_argument("--preloads", type=float, nargs="+", default=PRELOADS, help="in N")
    parser.add_argument("--amplitudes", type=float, nargs="+", default=AMPLITUDES, help="in um")
    parser.add_argument("--points", type=int, default=4, help="operating points of a curve")
    parser.add_argument("--set", action="append", default=[], help="an entry for all runs")
    add_options(parser, "loads.csv")
    options = parser.parse_args()
    options.entries = dict(tuple(part.strip() for part in text.split("=", 1)) for text in options.set)

    file = RowFile(options.csv, ["motor", "preload_N", "amplitude_um"] + COLUMNS, options.resume)
    print("\n".join(table(HEADER, [])), flush=True)
    for amplitude in options.amplitudes:
        run_amplitude(options, amplitude, file)
    rows = [row for row in file.rows if row["motor"] == options.motor.stem]
    lines = summary(rows) + [""] + table(HEADER, [[row[column] for column in SHOWN] for row in rows])
    print("\n" + "\n".join(lines))
    if options.markdown:
        write_markdown(options.markdown, lines)
    sys.exit(0 if is_acceptable(rows) else 1)


if __name__ == "__main__":
    main()
