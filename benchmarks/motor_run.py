# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the programs on one motor under a limit, and says how it ended; and tables of such runs."""
import collections
import csv
import pathlib
import re
import shlex
import sys

from contact_checks import ContactResults, check
from timed_run import ROOT, arguments, limited_run, on_ranks, program

# How a run may end. The last three must not happen.
OUTCOMES = ("certified", "refused", "failed", "hang", "crash", "silent wrong")
UNACCEPTABLE = ("hang", "crash", "silent wrong")
CLOCK = 6.  # times the limit of processor time: what a process may take that waits, or shares its processor

OUTPUT_OFF = {"Output/VTU": "false", "Output/Figures": "false"}
COLUMNS = ["outcome", "program", "status", "seconds", "processor_seconds", "memory_MB", "newton_iterations",
           "nodes_touching", "nodes", "certificate", "worst_error", "no_load_rpm", "stall_mNm", "message"]


def outcome_of(run):
    if run.is_too_long:
        return "hang"
    return {0: "certified", 1: "refused", 2: "failed"}.get(run.status, "crash")


def run_program(name, motor, folder, entries, options, *words, n_ranks=1):
    """One run under the limit, with further words on its command line; returns a row with COLUMNS, those of results
    empty."""
    command = on_ranks(n_ranks) + [str(program(name, options.programs))] + arguments(motor, folder, entries)
    run = limited_run(command + list(words), options.seconds, CLOCK * options.seconds)
    return {**dict.fromkeys(COLUMNS, ""), "outcome": outcome_of(run), "program": name, "status": run.status,
            "seconds": f"{run.seconds:.2f}", "processor_seconds": f"{run.processor_seconds:.2f}",
            "memory_MB": f"{run.memory:.0f}", "message": run.message if run.status else ""}


def certified_run(name, motor, folder, entries):
    """One run without a limit; raises RuntimeError with its message if it does not end with certified results."""
    run = limited_run([str(program(name))] + arguments(motor, folder, entries))
    if run.status != 0:
        raise RuntimeError(f"{name} {pathlib.Path(motor).name}: {run.message}")
    return run


def operating_points(motor, folder, entries):
    """Of a run of the program contact: the rows of its table, numbers by name of a column, and the run itself."""
    run = certified_run("contact", motor, folder, entries)
    with open(folder / "contact" / "torque_speed.csv") as file:
        return [{key: value if key == "control" else float(value) for key, value in row.items()}
                for row in csv.DictReader(file)], run


def add_operating_points(rows, labels, motor, folder, entries):
    """Adds to a RowFile the operating points of a run of the program contact, with labels that name the run; says what
    happened, also if it failed."""
    name = ", ".join(labels.values())
    try:
        found, done = operating_points(motor, folder, entries)
    except RuntimeError as error:
        print(f"{name}: {error}", file=sys.stderr, flush=True)
        return
    for row in found:
        rows.add({**{key: row[key] for key in rows.columns if key in row}, **labels,
                  "seconds": f"{done.processor_seconds:.1f}"})
    print(f"{name}: {done.processor_seconds:.1f} s", flush=True)


def add_results(row, folder):
    """Fills the row of a finished run of the program contact, and judges its results."""
    try:
        wrong = check(folder)
        results = ContactResults(folder)
    except (OSError, KeyError, ValueError) as error:
        row.update(outcome="silent wrong", message=f"results cannot be read: {error}")
        return row
    touching, nodes = results.touching()
    asked = [(r, point["asked_for"]) for r, point in zip(results.rows, results.points)]
    no_load = [r["speed_rpm"] for r, value in asked if r["control"] == "torque" and value == 0.]
    stall = [r["torque_mNm"] for r, value in asked if r["control"] == "speed" and value == 0.]
    row.update(newton_iterations=f"{sum(r['newton_iterations'] for r in results.rows):.0f}",
               nodes_touching=f"{touching:.0f}", nodes=nodes,
               certificate=f"{max(r['certificate'] for r in results.rows):.1e}",
               worst_error=f"{results.worst_error():.1e}", no_load_rpm=f"{no_load[0]:.2f}" if no_load else "",
               stall_mNm=f"{stall[0]:.2f}" if stall else "")
    if wrong:
        row.update(outcome="silent wrong", message="; ".join(wrong[:3]))
    return row


def run_contact(motor, folder, entries, options, *words, checks=True, n_ranks=1):
    """The same of the program contact, with its results, which are judged if asked for."""
    row = run_program("contact", motor, folder, entries, options, *words, n_ranks=n_ranks)
    return add_results(row, folder) if checks and row["outcome"] == "certified" else row


def command_lines(motor, folder, entries):
    """What to type in the project's folder to run one case again."""
    path = pathlib.Path(motor).resolve()
    path = path.relative_to(ROOT) if path.is_relative_to(ROOT) else path
    words = shlex.join(arguments(path, folder, entries))
    return f"for program in stator contact; do build/bin/$program {words} || break; done"


def cause_of(message):
    """A message without its numbers, by which like ones are counted together."""
    text = re.sub(r"^(stator|contact): |\[ *[\d.]+ s\]", "", message)
    text = re.sub(r"'[^']*/[^']*'|\S*/stator/\S+|\S*/contact/\S+", "FILE", text)
    text = re.sub(r"(?<![A-Za-z])[-+]?\d+(\.\d+)?([eE][-+]?\d+)?", "#", text)
    return re.sub(r"\s+", " ", text)[:160]


def is_acceptable(rows):
    return not any(row["outcome"] in UNACCEPTABLE for row in rows)


class RowFile:
    """A CSV file to which each row is added as soon as it is known."""

    def __init__(self, path, columns, resumes):
        self.path, self.columns, self.rows = pathlib.Path(path), columns, []
        self.path.parent.mkdir(parents=True, exist_ok=True)
        if resumes and self.path.exists():
            with open(self.path) as file:
                self.rows = list(csv.DictReader(file))
        with open(self.path, "w") as file:  # of what another version has written, only these columns stay
            writer = self._writer(file)
            writer.writeheader()
            writer.writerows(self.rows)

    def _writer(self, file):
        return csv.DictWriter(file, self.columns, restval="", extrasaction="ignore")

    def add(self, row):
        self.rows.append({key: str(value) for key, value in row.items()})
        with open(self.path, "a") as file:
            self._writer(file).writerow(row)

    def find(self, **wanted):
        return next((row for row in self.rows if all(row[key] == str(value) for key, value in wanted.items())), None)


def table(header, rows):
    return ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)] + [
        "| " + " | ".join(str(cell).replace("|", "/") for cell in row) + " |" for row in rows]


def summary(rows):
    """How many runs ended in which way, and why: two tables."""
    counts = collections.Counter(row["outcome"] for row in rows)
    lines = table(["runs"] + list(OUTCOMES), [[len(rows)] + [counts[outcome] for outcome in OUTCOMES]])
    causes = collections.Counter((row["outcome"], row["program"], cause_of(row["message"])) for row in rows
                                 if row["outcome"] != "certified")
    if causes:
        lines += [""] + table(["outcome", "program", "message", "runs"],
                              [[*cause, count] for cause, count in sorted(
                                  causes.items(), key=lambda item: (OUTCOMES.index(item[0][0]), -item[1]))])
    return lines


def write_markdown(path, lines):
    """Writes tables to a file; scripts/development/documents.py puts them into the pages."""
    pathlib.Path(path).write_text("\n".join(lines) + "\n", encoding="utf-8")


def add_options(parser, default_csv):
    parser.add_argument("--seconds", type=float, default=120., help="of processor time that a run may take")
    parser.add_argument("--programs", default=ROOT / "build" / "bin", help="the folder of the programs")
    parser.add_argument("--csv", default=ROOT / "output" / default_csv, help="the file of all rows")
    parser.add_argument("--resume", action="store_true", help="keep the rows of that file, run what it lacks")
    parser.add_argument("--keep", help="folder for the results of the runs, which are removed otherwise")
    parser.add_argument("--markdown", help="also write the tables to this file")
