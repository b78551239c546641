#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random motors: each has to end with certified results or with a refusal in words, in its time.

usage: tests/hard/random_motors.py [--examples] [--seed 1] [--count 200] [--seconds 120] [--workers N] [--invariances]
           [--csv FILE [--resume]] [--keep FOLDER] [--markdown FILE]

Motor number k is drawn from seed k alone, from --seed on: `--seed 17 --count 1` runs number 17 again. It is
tests/programs/static_rotor.prm with other dimensions, materials, loads, friction, and schemes or, with --examples, one of
the examples in prm/ with other materials, loads, friction, and warps, and with all effects on "auto"; ranges are those of
random_draws.py. The command line of each motor that is not certified is printed. Results are checked by
contact_checks.py. Outcomes: certified; refused (exit status 1, a mistake in the input); failed (status 2, the programs
say why, which may be Accuracy/Time limit: three quarters of --seconds); hang (more than --seconds of processor time),
crash (any other end), silent wrong (status 0, but a check finds something). The exit status is 1 if one of the last
three has happened.

With --invariances each certified motor is also computed in millimetres, newtons and MPa, and on two ranks: speeds and
torques have to agree within rounding or, where another discretisation was chosen, within the sum of their error bars.
"""
import argparse
import concurrent.futures
import json
import math
import pathlib
import shutil
import sys
import tempfile

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent.parent / "benchmarks"))
from contact_checks import ContactResults, disagreements  # noqa: E402
from motor_run import (COLUMNS, RowFile, add_options, command_lines, is_acceptable, run_contact,  # noqa: E402
                       run_program, summary, table, write_markdown)
from random_draws import draw_example, draw_motor, text  # noqa: E402
from timed_run import ROOT, entries_of  # noqa: E402

SHOWN = ("Motor/Number of waves", "Motor/Number of teeth", "Loading/Preload", "Wave/Amplitude", "Friction/Law",
         "Time/Scheme", "Loading/Control", "Contact/Formulation", "Effects/Friction lining",
         "Initial deformation/Amplitude", "Rotor/Flange element", "Stator/Piezoceramic element")

HEAVY = 1e8  # N/m, of preload per amplitude of the wave: nearly all teeth touch all the time
CLASSES = {
    "warped": lambda row: float(row["Initial deformation/Amplitude"] or 0.) > 0.,
    "marched": lambda row: row["Time/Scheme"] == "marching",
    "above 100 N/um": lambda row: float(row["Loading/Preload"]) > HEAVY * float(row["Wave/Amplitude"]),
    "friction that falls": lambda row: row["Friction/Law"] != "coulomb",
    "none of these": lambda row: not any(has(row) for name, has in CLASSES.items() if name != "none of these")}

OWN_LIMIT = 0.75  # of the seconds, after which the program has to end itself


def entries_by_wave(folder, entries, later):
    """Entries that go with the wave: steps that resolve its period, speeds in the measure of its surface."""
    summary_of_stator = json.loads((pathlib.Path(folder) / "stator" / "summary.json").read_text())
    value = {q["name"]: q["value"] for q in reversed(summary_of_stator["quantities"])
             if q["name"] != "frequency" or q["family"] == "out-of-plane"}
    found = {}
    if "frequency" not in value:
        return found  # the wave is not among the modes: contact has to refuse
    if later["marches"]:
        steps = later["steps"]
        found.update({"Time/Time step": text(1. / (value["frequency"] * steps)),
                      "Time/Number of steps": str(steps), "Time/Average from step": str(steps // 2),
                      "Time/Average to step": str(steps)})
    if later["speeds"]:
        surface = (2. * math.pi * value["frequency"] * value["A_t/A_n"] * float(entries["Wave/Amplitude"]) /
                   float(entries["Stator/Tip outer radius"]))
        found["Loading/Values"] = ", ".join(text(share * surface) for share in later["speeds"])
    return found


# The power of length in the unit of an entry, of all entries of a section, or of one in its subsections.
LENGTHS = {"Stator": 1, "Stator/Target plate cross-section": 2, "Rotor": 1, "Rotor/Radial bar stiffness": -2,
           "Materials/Young modulus": -2, "Materials/Density": -4, "Wave/Amplitude": 1, "Friction/Decay velocity": 1,
           "Friction/Weakening length": 1, "Friction/Lining normal stiffness": -3,
           "Friction/Lining tangential stiffness": -3, "Contact/Normal penalty": -1, "Contact/Tangential penalty": -1,
           "Initial deformation/Amplitude": 1}
WORDS = ("solid", "shell", "none")  # values in these sections that are no numbers


def in_millimetres(base, entries, options):
    """The same motor in mm, N, s and therefore tonnes: its torques are in N mm."""
    changed = {**entries, "Motor/Unusual values": "accept"}
    for entry, value in {**entries_of(base, options.programs), **entries}.items():
        section, _, name = entry.rpartition("/")
        power = next((LENGTHS[key] for key in (entry, f"{section.partition('/')[0]}/{name}", section)
                      if key in LENGTHS), 0)
        if power and value not in WORDS:
            changed[entry] = f"{float(value) * 1e3 ** power:.15g}"
    return changed


def invariances(base, folder, entries, options):
    """What changes although it must not: list of texts."""
    millimetres, two_ranks, results = folder / "millimetres", folder / "two_ranks", ContactResults(folder)
    in_mm = in_millimetres(base, entries, options)
    row = run_program("stator", base, millimetres, in_mm, options)
    if row["outcome"] == "certified":
        row = run_contact(base, millimetres, in_mm, options, checks=False)
    shutil.copytree(folder / "stator", two_ranks / "stator")
    runs = (("in mm", row, millimetres, 1e-3),
            ("on two ranks", run_contact(base, two_ranks, entries, options, checks=False, n_ranks=2), two_ranks, 1.))
    found = []
    for what, row, other, torque_unit in runs:
        if row["outcome"] == "certified":
            found += [f"{what}: {text}" for text in disagreements(results, ContactResults(other), torque_unit)]
        elif "Time limit" not in row["message"]:
            found.append(f"{what}: {row['outcome']}: {row['message']}")
    return found


def run_motor(seed, folder, options):
    """Row of one motor, the file it varies, and its entries."""
    base, entries, later = (draw_example(seed, lambda file: entries_of(file, options.programs)) if options.examples else
                            draw_motor(seed))
    entries["Accuracy/Time limit"] = f"{OWN_LIMIT * options.seconds:g}"
    row = run_program("stator", base, folder, entries, options)
    if row["outcome"] == "certified":
        entries.update(entries_by_wave(folder, entries, later))
        row = run_contact(base, folder, entries, options)
    if row["outcome"] == "certified" and options.invariances:
        if wrong := invariances(base, folder, entries, options):
            row.update(outcome="silent wrong", message="; ".join(wrong[:3]))
    return row, base, entries


def run_seed(seed, options):
    """The whole row of one motor."""
    with tempfile.TemporaryDirectory() as scratch:
        row, base, entries = run_motor(seed, pathlib.Path(options.keep or scratch) / str(seed), options)
    return {"seed": seed, "file": base.stem, **row, **{entry: entries.get(entry, "") for entry in SHOWN},
            "command": command_lines(base, f"output/random/{seed}", entries)}


def by_class(rows):
    """How many runs of motors of each kind, and of each file if they vary several, were certified: a table."""
    files = sorted({row["file"] for row in rows})
    kinds = {**CLASSES, **{name: lambda row, name=name: row["file"] == name for name in files if len(files) > 1}}
    chosen = {kind: [row["outcome"] == "certified" for row in rows if has(row)] for kind, has in kinds.items()}
    return table(["motors", "runs", "certified", "share"],
                 [[kind, len(ends), sum(ends), f"{sum(ends) / len(ends):.0%}"] for kind, ends in chosen.items() if ends])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seed", type=int, default=1, help="of the first motor")
    parser.add_argument("--count", type=int, default=200, help="of motors")
    parser.add_argument("--workers", type=int, default=1, help="motors that are computed at the same time")
    parser.add_argument("--examples", action="store_true", help="vary the examples in prm/, not the static rotor")
    parser.add_argument("--invariances", action="store_true", help="also compute each in other units, on two ranks")
    add_options(parser, "random_motors.csv")
    options = parser.parse_args()

    print(f"motors {options.seed} to {options.seed + options.count - 1}, {options.seconds:g} s for each run", flush=True)
    file = RowFile(options.csv, ["seed", "file", *COLUMNS, *SHOWN, "command"], options.resume)
    seeds = [seed for seed in range(options.seed, options.seed + options.count) if not file.find(seed=seed)]
    with concurrent.futures.ThreadPoolExecutor(options.workers) as pool:
        for done in concurrent.futures.as_completed([pool.submit(run_seed, seed, options) for seed in seeds]):
            row = done.result()
            file.add(row)
            print(f"{row['seed']}: {row['outcome']}, {row['program']}, {row['processor_seconds']} s", flush=True)
            if row["outcome"] != "certified":
                print(f"    {row['message']}\n    {row['command']}", flush=True)
    lines = [*summary(file.rows), "", *by_class(file.rows)]
    print("\n" + "\n".join(lines))
    if options.markdown:
        write_markdown(options.markdown, lines)
    sys.exit(0 if is_acceptable(file.rows) else 1)


if __name__ == "__main__":
    main()
