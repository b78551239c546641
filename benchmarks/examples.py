#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""All parameter files of prm/ by the commands of the documents, and a motor of other dimensions copied from the reference motor.

usage: benchmarks/examples.py [--csv FILE [--resume]] [--markdown FILE] [CASE ...]

Whole runs of scripts/run.sh with figures and page on all cores (for a mesh of a stator alone: of the program stator). Each must end
with certified results; the exit status is 1 if one does not.
"""
import argparse
import json
import pathlib
import shutil
import sys

sys.dont_write_bytecode = True
from motor_run import RowFile, outcome_of, table, write_markdown  # noqa: E402
from timed_run import MOTOR, PROGRAMS, ROOT, entries_of, limited_run  # noqa: E402

RING45 = ROOT / "tests" / "programs" / "ring45.prm"
WITHOUT_INERTIA = {f"Effects/{name} inertia": "off" for name in ("Rotor", "Tooth")}
COLUMNS = ["case", "outcome", "seconds", "processor_seconds", "error", "target", "message"]


def copied():
    """What a designer changes in a copy of a motor: dimensions, materials, wave and preload."""
    wanted = ("Motor/", "Stator/", "Rotor/", "Materials/", "Wave/Amplitude", "Loading/Preload")
    reference = entries_of(MOTOR)
    return {entry: value for entry, value in entries_of(RING45).items()
            if entry.startswith(wanted) and value != reference[entry]}


def cases():
    """Command and entries by name."""
    found = {f"prm/{path.name}": ([ROOT / "scripts" / "run.sh", path], {}) for path in sorted((ROOT / "prm").glob("*.prm"))}
    found["prm/soft_spring_mesh.prm"] = ([PROGRAMS / "stator", ROOT / "prm" / "soft_spring_mesh.prm"], {})
    run_sh = ROOT / "scripts" / "run.sh"
    found["prm/soft_spring.prm without inertia, Contact target = 0.01"] = (
        [run_sh, MOTOR], {**WITHOUT_INERTIA, "Accuracy/Contact target": "0.01"})
    found["ring of 45 mm, copied from prm/soft_spring.prm"] = ([run_sh, MOTOR], copied())
    found["the same without inertia"] = ([run_sh, MOTOR], {**copied(), **WITHOUT_INERTIA})
    return found


def largest_error(folder):
    """The relative error that had to meet a target, and that target, of the last program that has one."""
    for program in ("contact", "stator"):
        path = folder / program / "summary.json"
        if path.exists():
            for check in json.loads(path.read_text(encoding="utf-8"))["certificate"]["checks"]:
                if check["name"].startswith("largest relative error"):
                    return f"{check['value']:.2g}", f"{check['limit']:.2g}"
    return "", ""


def run(name, command, entries, folder):
    shutil.rmtree(folder, ignore_errors=True)
    words = [str(word) for word in command]
    for entry, value in entries.items():
        words += ["--set", f"{entry} = {value}"]
    done = limited_run(words + ["--output", str(folder)], most_threads=None)
    error, target = largest_error(folder) if done.status == 0 else ("", "")
    shutil.rmtree(folder, ignore_errors=True)
    return {"case": name, "outcome": outcome_of(done), "seconds": f"{done.seconds:.0f}",
            "processor_seconds": f"{done.processor_seconds:.0f}", "error": error, "target": target,
            "message": done.message if done.status else ""}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("cases", nargs="*", metavar="CASE", help="names of the table; default: all")
    parser.add_argument("--csv", type=pathlib.Path, default=ROOT / "output" / "examples.csv")
    parser.add_argument("--resume", action="store_true", help="keep the rows of that file, run what it lacks")
    parser.add_argument("--markdown", type=pathlib.Path, help="also write the tables to this file")
    options = parser.parse_args()
    rows = RowFile(options.csv, COLUMNS, options.resume)
    for name, (command, entries) in cases().items():
        if (not options.cases or name in options.cases) and not rows.find(case=name):
            rows.add(run(name, command, entries, options.csv.with_suffix(".case")))
            print(" | ".join(rows.rows[-1].values()), flush=True)
    lines = table(["motor", "outcome", "seconds", "of the processor", "error reached", "asked"],
                  [[row[key] for key in COLUMNS[:6]] for row in rows.rows])
    print("\n".join(lines))
    if options.markdown:
        write_markdown(options.markdown, lines)
    return 0 if all(row["outcome"] == "certified" for row in rows.rows) else 1


if __name__ == "__main__":
    sys.exit(main())
