#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Many motors: every combination of values of some entries, or a sample of them, through the three programs.

usage: scripts/sweep.py FILE.prm --vary 'Section/Entry = VALUES'... [--sample lhs=COUNT] [options]

VALUES are numbers or words separated by commas, low:high:count for equal steps, or low:high:count:log for equal ratios.
With --sample lhs=200 a Latin hypercube of 200 motors is drawn from ranges low:high and lists. Example:

  scripts/sweep.py prm/quick.prm --vary 'Stator/Base thickness = 4.0e-3:5.0e-3:11' --vary 'Wave/Amplitude = 1e-6, 2e-6'

Other questions: --maximise (or --minimise) QUANTITY with --subject-to 'QUANTITY > NUMBER' looks for the best motor of
ranges low:high; --solve 'Section/Entry = low:high' --for 'QUANTITY = NUMBER' for the value of an entry:

  scripts/sweep.py prm/quick.prm --vary 'Stator/Tooth height = 1e-3:3e-3' --maximise 'efficiency at 0.1' \\
      --subject-to 'frequency = 28e3:32e3' --subject-to 'no_load_speed > 60'
  scripts/sweep.py prm/quick.prm --solve 'Stator/Base thickness = 4e-3:8e-3' --for 'frequency = 43e3'

Results are in output/FILE_sweep (or --output DIR): table.csv and table.h5 with inputs, quantities, errors, seconds and the
words of motors that were refused; figures of each quantity over the varied entries; one folder for each motor. A sweep
that was interrupted goes on when it is started again; motors that are there are not computed twice.
"""
import argparse
import os
import pathlib
import shlex
import sys
import time
from dataclasses import replace

sys.dont_write_bytecode = True
from case import CaseError, run_script
from goals import limit, loading_for, name_of, target
from many_motors import Engine, Family
from optimum import Aim, optimise
from solution import solve
from sweep_figures import draw_optimum, draw_sweep
from sweep_table import row_of, write_table
from variation import combinations, entry_and_value, latin_hypercube, ranged, varied

ROOT = pathlib.Path(__file__).resolve().parent.parent
# Installed, the programs are not beside the sources.
PROGRAMS = ROOT / "build" / "bin" if (ROOT / "CMakeLists.txt").exists() else ROOT.parent.parent / "bin"
INTERVAL = 30.  # seconds between tables of a sweep that is not finished


class Progress:
    """Says after each motor how many are done, and how long the others will take."""

    def __init__(self, count, n_known):
        self.count, self.n_done, self.begin = count, 0, time.monotonic()
        if n_known:
            print(f"{n_known} motors are known already")

    def add(self, row):
        self.n_done += 1
        elapsed = time.monotonic() - self.begin
        left = elapsed / self.n_done * (self.count - self.n_done)
        print(f"{self.n_done} of {self.count}: {row.inputs()}: {row.outcome}, {row.wave_seconds + row.seconds:.1f} s; "
              f"{self.n_done / elapsed * 3600:.0f} motors per hour, {in_words(left)} left", flush=True)
        if row.message:
            print(f"    {row.message}", flush=True)


def in_words(seconds):
    if seconds < 100:
        return f"{seconds:.0f} s"
    if seconds < 6000:
        return f"{seconds / 60:.0f} min"
    return f"{seconds / 3600:.1f} h"


def sweep(engine, family, all_varied, wave_only=False):
    """Runs all of them, and returns their rows in the order of the combinations."""
    motors = [family.motor(one, wave_only) for one in all_varied]
    order = {motor.task.folder: number for number, motor in enumerate(motors)}
    known = {motor.task.folder for motor in motors if motor.is_known()}
    progress, rows, written = Progress(len(order) - len(known), len(known)), {}, time.monotonic()
    for motor in motors:
        engine.submit(motor)
    while len(rows) < len(order):
        motor, outcome = engine.next_done()
        rows[motor.task.folder] = row_of(motor, outcome)
        if motor.task.folder not in known:
            progress.add(rows[motor.task.folder])
        if time.monotonic() > written + INTERVAL:
            write_table(family.output, sorted(rows.values(), key=lambda row: order[row.folder]))
            written = time.monotonic()
    return sorted(rows.values(), key=lambda row: order[row.folder])


def sample_size(text):
    kind, _, count = text.partition("=")
    if kind != "lhs" or not count.isdigit() or int(count) < 1:
        raise CaseError(f'--sample "{text}": expected lhs=COUNT, such as lhs=200')
    return int(count)


def parse(arguments):
    first, usage, rest = __doc__.split("\n\n", 2)
    parser = argparse.ArgumentParser(description=first, usage=usage[7:], epilog=rest,
                                     formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("prm", metavar="FILE.prm")
    parser.add_argument("--vary", action="append", default=[], metavar="'Section/Entry = VALUES'")
    parser.add_argument("--set", action="append", default=[], metavar="'Section/Entry = value'", dest="settings",
                        help="an entry for all motors")
    parser.add_argument("--sample", metavar="lhs=COUNT", help="draw so many motors instead of all combinations")
    parser.add_argument("--wave-only", action="store_true", help="the program stator alone: frequencies, shape of the wave")
    parser.add_argument("--maximise", metavar="QUANTITY")
    parser.add_argument("--minimise", metavar="QUANTITY")
    parser.add_argument("--subject-to", action="append", default=[], metavar="'QUANTITY > NUMBER'")
    parser.add_argument("--trials", type=int, default=60, metavar="N", help="motors of the coarse search for an optimum")
    parser.add_argument("--solve", metavar="'Section/Entry = low:high'")
    parser.add_argument("--for", metavar="'QUANTITY = NUMBER'", dest="goal")
    parser.add_argument("--seed", type=int, default=1, help="of a sample or a search")
    parser.add_argument("--workers", type=int, default=os.cpu_count(), metavar="N",
                        help="motors at the same time on this machine, by default as many as it has cores")
    parser.add_argument("--scheduler", metavar="ADDRESS", help="of a Dask scheduler with workers of its own")
    parser.add_argument("--output", metavar="DIR")
    parser.add_argument("--programs", metavar="DIR", default=PROGRAMS, help="where stator, contact and losses are")
    options = parser.parse_args(arguments)
    kinds = [name for name in ("maximise", "minimise", "solve") if getattr(options, name)]
    if len(kinds) > 1:
        raise CaseError(f"--{kinds[0]} and --{kinds[1]} exclude each other")
    if bool(options.solve) != bool(options.goal):
        raise CaseError("--solve and --for go together: --solve 'Stator/Base thickness = 1e-3:3e-3' --for 'frequency = 43e3'")
    if options.solve and options.vary or not options.solve and not options.vary:
        raise CaseError("--solve varies one entry only: leave out --vary" if options.solve else
                        "no --vary: nothing varies; example: --vary 'Wave/Amplitude = 1e-6, 2e-6'")
    return options


def print_inputs(row):
    for entry, text in row.varied.items():
        print(f"  --set '{entry} = {text}'")


def run_sweep(options, family, all_varied):
    chosen = (latin_hypercube(all_varied, sample_size(options.sample), options.seed) if options.sample
              else combinations(all_varied))
    with Engine(options.workers, options.scheduler) as engine:
        rows = sweep(engine, family, chosen, options.wave_only)
    write_table(family.output, rows)
    draw_sweep(family.output, f"{family.entries['Motor/Name']}: {len(rows)} motors", rows)
    counts = {outcome: sum(row.outcome == outcome for row in rows) for outcome in ("certified", "refused", "failed")}
    print(", ".join(f"{count} {outcome}" for outcome, count in counts.items() if count) +
          f": tables and figures in {options.output}")


def run_optimisation(options, family, all_varied):
    option = "--maximise" if options.maximise else "--minimise"
    aim = Aim(name_of(option, options.maximise or options.minimise), 1 if options.maximise else -1,
              tuple(limit("--subject-to", text) for text in options.subject_to))
    own_target = float(family.entries["Accuracy/Contact target"])
    loading = loading_for(aim.names())
    with Engine(options.workers, options.scheduler) as engine:
        staged, best = optimise(engine, family, all_varied, aim, loading, own_target, options.trials, options.seed)
    write_table(family.output, [replace(row, varied={**row.varied, "Accuracy/Contact target": f"{target:g}"})
                                for target, row in staged])
    draw_optimum(family.output, family.entries["Motor/Name"], staged, aim, best)
    print(f"\nthe best of {options.trials} motors, at Contact target = {own_target:g}:")
    print_inputs(best[0])
    for name in aim.names():
        quantity = best[0].quantities[name]
        print(f"  {name} = {quantity.value:.5g} +- {quantity.error:.2g} {quantity.unit}".rstrip())
    for row in best[1:]:
        print("cannot be told from it within the error bars: " + ", ".join(f"{entry} = {text}" for entry, text in
                                                                          row.varied.items()))
    print(f"its results are in {best[0].folder}, those of all in {options.output}; for a report:\n"
          f"  scripts/run.sh {options.prm} {' '.join(shlex.quote(word) for word in settings_of(best[0], family))}")


def settings_of(row, family):
    entries = {entry: text for entry, text in family.settings.items() if not entry.startswith("Output/")}
    return [word for entry, text in {**entries, **row.varied}.items() for word in ("--set", f"{entry} = {text}")]


def run_solution(options, family):
    one, (name, value) = ranged("--solve", options.solve), target("--for", options.goal)
    family.check_name("--solve", one.entry)
    with Engine(options.workers, options.scheduler) as engine:
        row, uncertainty, is_met = solve(engine, family, one, name, value)
    write_table(family.output, [row])
    quantity = row.quantities[name]
    print(f"\n{one.entry} = {row.varied[one.entry]} +- {uncertainty:.2g} (from the error bar): {name} = {quantity.value:.6g} "
          f"+- {quantity.error:.2g} {quantity.unit}; its results are in {row.folder}")
    if not is_met:
        raise CaseError(f"{name} = {value:g} is outside the error bar: the quantity may jump within the range")


def main(arguments):
    options = parse(arguments)
    all_varied = [varied("--vary", text) for text in options.vary]
    options.output = options.output or f"output/{pathlib.Path(options.prm).stem}_sweep"
    family = Family(options.prm, dict(entry_and_value("--set", text) for text in options.settings), options.output,
                    options.programs)
    for one in all_varied:
        family.check_name("--vary", one.entry)
    if options.solve:
        run_solution(options, family)
    elif options.maximise or options.minimise:
        run_optimisation(options, family, all_varied)
    else:
        run_sweep(options, family, all_varied)


if __name__ == "__main__":
    run_script("sweep", main)
