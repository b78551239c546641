#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Many motors: every combination of values of some entries, or a sample of them, through the three programs.

usage: scripts/sweep.py FILE.prm --vary 'Section/Entry = VALUES'... [--sample lhs=COUNT] [options]

VALUES are numbers or words separated by commas, low:high:count for equal steps, or low:high:count:log for equal ratios.
With --sample lhs=200 a Latin hypercube of 200 motors is drawn from ranges low:high and lists. Example:

  scripts/sweep.py prm/static_rotor.prm --vary 'Stator/Base thickness = 4.0e-3:5.0e-3:11' --vary 'Wave/Amplitude = 1e-6, 2e-6'

Other questions: --maximise (or --minimise) QUANTITY with --subject-to 'QUANTITY > NUMBER' looks for the best motor of
ranges low:high; --solve 'Section/Entry = low:high' --for 'QUANTITY = NUMBER' for the value of an entry:

  scripts/sweep.py prm/static_rotor.prm --vary 'Stator/Tooth height = 1e-3:3e-3' --maximise 'efficiency at 0.1' \\
      --subject-to 'frequency = 28e3:32e3' --subject-to 'no_load_speed > 60'
  scripts/sweep.py prm/static_rotor.prm --solve 'Stator/Base thickness = 4e-3:8e-3' --for 'frequency = 43e3'

--uncertainty COUNT draws motors whose loss factors, friction and Young moduli deviate as the section Uncertainty of the
parameter file says, and adds what follows for each quantity to its numerical error:

  scripts/sweep.py prm/static_rotor.prm --set 'Uncertainty/Friction = 0.1' --set 'Uncertainty/Young moduli = 0.02' --uncertainty 40

Results are in output/FILE_sweep (or --output DIR): table.csv and table.h5 with inputs, quantities, errors, seconds and the
words of motors that were refused; figures of each quantity over the varied entries; one folder for each motor. A sweep
that was interrupted goes on when it is started again; motors that are there are not computed twice.
"""
import shlex
import sys
import time
from dataclasses import replace

sys.dont_write_bytecode = True
from running import surroundings  # noqa: F401
from motors.goals import Aim, is_of_wave, limit, loading_for, name_of, target
from motors.many_motors import Engine
from motors.motor_options import at_least, family_of, motors_parser
from motors.solution import solve
from motors.sweep_figures import draw_optimum, draw_sweep
from motors.sweep_table import row_of, write_table
from motors.uncertainty import draw_spreads, in_words, motor_of, sample_of, spreads_of, uncertain_inputs, write_spreads
from motors.variation import combinations, latin_hypercube, ranged, varied
from results.case import CaseError, run_script
from running.programs import options_of

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
              f"{self.n_done / elapsed * 3600:.0f} motors per hour, {duration(left)} left", flush=True)
        if row.message:
            print(f"    {row.message}", flush=True)


def duration(seconds):
    if seconds < 100:
        return f"{seconds:.0f} s"
    if seconds < 6000:
        return f"{seconds / 60:.0f} min"
    return f"{seconds / 3600:.1f} h"


def sweep(engine, family, all_varied):
    """Runs all of them, and returns their rows in the order of the combinations."""
    motors = [family.motor(one) for one in all_varied]
    known = {motor for motor in motors if motor.is_known()}
    progress, rows, written = Progress(len(motors) - len(known), len(known)), {}, time.monotonic()

    def rows_in_order():
        return [rows[motor] for motor in motors if motor in rows]

    for motor in motors:
        engine.submit(motor)
    while len(rows) < len(motors):
        motor, outcome = engine.next_done()
        rows[motor] = row_of(motor, outcome)
        if motor not in known:
            progress.add(rows[motor])
        if time.monotonic() > written + INTERVAL:
            write_table(family.output, rows_in_order())
            written = time.monotonic()
    return rows_in_order()


def sample_size(text):
    kind, _, count = text.partition("=")
    if kind != "lhs" or not count.isdigit() or int(count) < 1:
        raise CaseError(f'--sample "{text}": expected lhs=COUNT, such as lhs=200')
    return int(count)


def parse(arguments):
    parser = motors_parser(__doc__)
    parser.add_argument("--vary", action="append", default=[], metavar="'Section/Entry = VALUES'")
    parser.add_argument("--sample", metavar="lhs=COUNT", help="draw so many motors instead of all combinations")
    parser.add_argument("--wave-only", action="store_true", help="the program stator alone: frequencies, shape of the wave")
    parser.add_argument("--maximise", metavar="QUANTITY")
    parser.add_argument("--minimise", metavar="QUANTITY")
    parser.add_argument("--subject-to", action="append", default=[], metavar="'QUANTITY > NUMBER'")
    parser.add_argument("--trials", type=at_least(1), default=60, metavar="N",
                        help="motors of the coarse search for an optimum")
    parser.add_argument("--solve", metavar="'Section/Entry = low:high'")
    parser.add_argument("--for", metavar="'QUANTITY = NUMBER'", dest="goal")
    parser.add_argument("--uncertainty", type=at_least(4), metavar="COUNT",
                        help="motors of a sample of uncertain inputs, better 40 than 4")
    options = parser.parse_args(arguments)
    kinds = [name for name in ("sample", "maximise", "minimise", "solve", "uncertainty") if getattr(options, name)]
    if len(kinds) > 1:
        raise CaseError(f"--{kinds[0]} and --{kinds[1]} exclude each other")
    if bool(options.solve) != bool(options.goal):
        raise CaseError("--solve and --for go together: --solve 'Stator/Base thickness = 1e-3:3e-3' --for 'frequency = 43e3'")
    if options.vary and (options.solve or options.uncertainty):
        raise CaseError(f"--{kinds[0]} chooses the motors: leave out --vary")
    if not (options.vary or options.solve or options.uncertainty):
        raise CaseError("no --vary: nothing varies; example: --vary 'Wave/Amplitude = 1e-6, 2e-6'")
    return options


def print_inputs(row):
    for entry, text in row.varied.items():
        print(f"  --set '{entry} = {text}'")


def run_sweep(options, family, all_varied):
    chosen = (latin_hypercube(all_varied, sample_size(options.sample), options.seed) if options.sample
              else combinations(all_varied))
    with Engine(options.workers, options.scheduler) as engine:
        rows = sweep(engine, family, chosen)
    write_table(family.output, rows)
    draw_sweep(family.output, f"{family.entries['Motor/Name']}: {len(rows)} motors", rows)
    counts = {outcome: sum(row.outcome == outcome for row in rows) for outcome in ("certified", "refused", "failed")}
    print(", ".join(f"{count} {outcome}" for outcome, count in counts.items() if count) +
          f": tables and figures in {options.output}")


def aim_of(options):
    option = "--maximise" if options.maximise else "--minimise"
    return Aim(name_of(option, options.maximise or options.minimise), 1 if options.maximise else -1,
               tuple(limit("--subject-to", text) for text in options.subject_to))


def is_of_the_wave_alone(options):
    """Whether the program stator answers the question."""
    if options.solve:
        return is_of_wave(target("--for", options.goal)[0])
    return aim_of(options).is_of_wave() if options.maximise or options.minimise else options.wave_only


def run_optimisation(options, family, all_varied):
    from motors.optimum import optimise  # pylint: disable=import-outside-toplevel # slow to import
    aim = aim_of(options)
    own_target = float(family.entries["Accuracy/Contact target"])
    loading = loading_for(aim.names())
    with Engine(options.workers, options.scheduler) as engine:
        staged, best = optimise(engine, family, all_varied, aim, loading, own_target, options.trials, options.seed)
    write_table(family.output, [replace(row, varied={**row.varied, "Accuracy/Contact target": f"{target:g}"})
                                for target, row in staged])
    draw_optimum(family.output, family.entries["Motor/Name"], staged, aim, best)
    print(f"\nthe best of {options.trials} motors, at Contact target = {own_target:g}:")
    print_inputs(best[0])
    for name in dict.fromkeys(aim.names()):
        print(f"  {name} = {best[0].quantities[name]}")
    for row in best[1:]:
        print("cannot be told from it within the error bars: " + ", ".join(f"{entry} = {text}" for entry, text in
                                                                          row.varied.items()))
    print(f"its results are in {best[0].folder}, those of all in {options.output}; for a report:\n"
          f"  scripts/run.sh {options.prm} {' '.join(shlex.quote(word) for word in settings_of(best[0], family))}")


def settings_of(row, family):
    return options_of({**{entry: text for entry, text in family.settings.items() if not entry.startswith("Output/")},
                       **row.varied})


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


def run_uncertainty(options, family):
    inputs = uncertain_inputs(family.entries)
    deviates = sample_of(inputs, options.uncertainty, options.seed)
    chosen = [motor_of(inputs, row, family.entries) for row in [[0.] * len(inputs), *deviates]]
    with Engine(options.workers, options.scheduler) as engine:
        nominal, *rows = sweep(engine, family, chosen)
    write_table(family.output, [nominal, *rows])
    if not nominal.quantities:
        raise CaseError(f"the motor itself is {nominal.outcome}: {nominal.message}")
    spreads = spreads_of(nominal, rows, inputs, deviates)
    write_spreads(family.output / "uncertainty.csv", spreads)
    draw_spreads(family.output, f"{family.entries['Motor/Name']}: {len(rows)} motors with uncertain inputs", spreads)
    print("\nvalue +- numerical error +- standard deviation by the inputs:")
    print("\n".join(in_words(one) for one in spreads))
    print(f"tables and figure in {options.output}")


def main(arguments):
    options = parse(arguments)
    all_varied = [varied("--vary", text) for text in options.vary]
    family = family_of(options, "sweep", is_of_the_wave_alone(options))
    for one in all_varied:
        family.check_name("--vary", one.entry)
    if options.solve:
        run_solution(options, family)
    elif options.uncertainty:
        run_uncertainty(options, family)
    elif options.maximise or options.minimise:
        run_optimisation(options, family, all_varied)
    else:
        run_sweep(options, family, all_varied)


if __name__ == "__main__":
    run_script("sweep", main)
