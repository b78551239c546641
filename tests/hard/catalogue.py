#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Motors that are hard for a solver: each must end as its file says.

usage: tests/hard/catalogue.py [--programs FOLDER] [--csv FILE [--resume]] [--markdown FILE] [FILE.case ...]

A case is a file of this folder: what differs from tests/programs/static_rotor.prm, a line "Section/Entry = value" for each
entry, as the option --set takes it, below a header of comments. Lines of the header that begin with more than one blank continue
the one before.

  # Hard: what is hard about it
  # Must: certified | refused: WORDS | failed: WORDS; several, separated by " or ": any of them. A refusal (exit
  #       status 1) or failure (status 2) has to say these words.
  # Why:  why that must happen
  # Vary: Section/Entry = VALUE; VALUE ...     optional: a run for each of these values
  # Check: an expression that holds for certified results; optional, any number. The columns of torque_speed.csv are
  #       arrays by their names; crest_rpm is the speed of the crests, friction_mNm what friction bears.
  # Agree: variants | CASE                     optional: speeds and torques agree with each other within their bars
  # After: CASE                                optional: continues (--resume) in the folder of that case
  # Within: processor seconds for each run; 60 without this line

Certified results are also checked by benchmarks/contact_checks.py. The exit status is 1 if a case does not end as it must.
"""
import argparse
import os
import pathlib
import re
import sys
import tempfile

import numpy

sys.dont_write_bytecode = True
FOLDER = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parent.parent / "benchmarks"))
from contact_checks import RPM, ContactResults, disagreements  # noqa: E402
from motor_run import (COLUMNS, OUTPUT_OFF, RowFile, run_contact, run_program, table, write_markdown)  # noqa: E402
from timed_run import ROOT  # noqa: E402

STATIC_ROTOR = ROOT / "tests" / "programs" / "static_rotor.prm"
FIELDS = ("Hard", "Must", "Why", "Vary", "Check", "Agree", "After", "Within")


class Case:
    """Entries that differ, and what the header asks for."""

    def __init__(self, path):
        self.path = pathlib.Path(path)
        text = self.path.read_text()
        self.name = self.path.stem
        self.entries = {**OUTPUT_OFF, **self._entries(text)}
        self.fields = self._header(text)
        self.seconds = float(self.one("Within", "60"))
        entry, _, values = self.one("Vary", "").partition("=")
        self.variants = [{entry.strip(): value.strip()} for value in values.split(";")] if entry else [{}]

    def _entries(self, text):
        found = {}
        for line in text.splitlines():
            if line and not line.startswith("#"):
                entry, equals, value = line.partition(" = ")
                if not equals:
                    raise SystemExit(f"{self.path}: not understood: {line}")
                found[entry] = value
        return found

    def _header(self, text):
        found = {}
        for line in text.splitlines():
            if not line.startswith("#"):
                break
            begin = re.fullmatch(r"# (\w+): +(.*)", line)
            if begin and begin[1] in FIELDS:
                last = found.setdefault(begin[1], [])
                last.append(begin[2])
            elif line.startswith("#  ") and found:
                last[-1] += " " + line[1:].strip()
            else:
                raise SystemExit(f"{self.path}: not understood: {line}")
        missing = [name for name in FIELDS[:3] if len(found.get(name, [])) != 1]
        if missing:
            raise SystemExit(f"{self.path}: the header needs one line each of {', '.join(missing)}")
        return found

    def one(self, field, default=None):
        return self.fields.get(field, [default])[0]

    def allows(self, row):
        """Whether a run ended in one of the ways the case allows."""
        for way in self.one("Must").split(" or "):
            outcome, _, words = way.partition(":")
            if row["outcome"] == outcome.strip() and words.strip() in row["message"]:
                return True
        return False


def run(case, variant, folder, options):
    """Row and, if it is certified, the results of one run."""
    options = argparse.Namespace(seconds=options.slowness * case.seconds, programs=options.programs)
    entries = {**case.entries, **variant}
    row = run_program("stator", STATIC_ROTOR, folder, entries, options)
    if row["outcome"] == "certified":
        row = run_contact(STATIC_ROTOR, folder, entries, options, *(["--resume"] if case.one("After") else []))
    results = ContactResults(folder) if row["outcome"] == "certified" else None
    return row, results


def check(expression, results):
    """Whether an expression of the header holds."""
    names = {name: results.column(name) for name in results.rows[0] if name != "control"}
    names.update(crest_rpm=results.wave_speed() / RPM, friction_mNm=1e3 * results.most_torque(),
                 n_teeth=results.attributes["n_teeth"], n_waves=results.attributes["n_waves"],
                 all=numpy.all, abs=abs, diff=numpy.diff, max=numpy.max, min=numpy.min)
    return bool(eval(expression, {"__builtins__": {}}, names))  # pylint: disable=eval-used


def judge(case, rows, results, options):
    """What is not as it must be: list of texts."""
    wrong = [f"{row['outcome']} ({row['message']}) instead of {case.one('Must')}"
             for row in rows if not case.allows(row)]
    certified = [result for result in results if result]
    for expression in case.fields.get("Check", []):
        wrong += [f"does not hold: {expression}" for result in certified if not check(expression, result)]
    agree = case.one("Agree")
    if agree and agree != "variants":
        with tempfile.TemporaryDirectory() as scratch:
            certified.append(run(Case(FOLDER / f"{agree}.case"), {}, pathlib.Path(scratch), options)[1])
    if agree:
        wrong += [text for result in certified[:-1] for text in disagreements(result, certified[-1])]
    return wrong


def run_case(case, options):
    """Rows of all variants and what is wrong with them."""
    rows, results = [], []
    with tempfile.TemporaryDirectory() as scratch:
        if case.one("After"):
            before, _ = run(Case(FOLDER / f"{case.one('After')}.case"), {}, pathlib.Path(scratch) / "0", options)
            assert before["outcome"] == "certified", before["message"]
        for number, variant in enumerate(case.variants):
            folder = pathlib.Path(scratch) / str(0 if case.one("After") else number)
            row, result = run(case, variant, folder, options)
            rows.append({"case": case.name, "variant": ", ".join(variant.values()), **row, "points": points(result)})
            results.append(result)
        return rows, judge(case, rows, results, options)


def points(results):
    """The first and the last operating point in words."""
    if not results:
        return ""
    ends = [results.rows[0], results.rows[-1]][:len(results.rows)]
    return " to ".join(f"{row['speed_rpm']:.3g} rpm at {row['torque_mNm']:.3g} mN m" for row in ends)


def in_short(message):
    """The first statement of a message, without names of programs and folders."""
    return re.sub(r"/\S*/(stator/\S+)", r"\1", message.split(": ", 1)[-1].split("; ")[0])[:160]


def lines_of(cases, rows):
    """The table of the document."""
    lines = []
    for case in cases:
        name, said = f"`{case.name}`", [case.one("Hard"), case.one("Must")]
        for row in (row for row in rows if row["case"] == case.name):
            result = row["points"] or f"{row['outcome']}: {in_short(row['message'])}"
            lines.append([name, *said, row["variant"], result, row["newton_iterations"], row["processor_seconds"]])
            name, said = "", ["", ""]
    return table(["case", "hard", "must be", "with", "result", "iterations", "s"], lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("cases", nargs="*", default=sorted(FOLDER.glob("*.case")), metavar="FILE.case")
    parser.add_argument("--programs", default=ROOT / "build" / "bin", help="the folder of the programs")
    parser.add_argument("--slowness", type=float, default=1., help="of the programs, by which all limits are raised")
    parser.add_argument("--csv", help="the file of all rows")
    parser.add_argument("--resume", action="store_true", help="keep the rows of that file, run what it lacks")
    parser.add_argument("--markdown", help="also write the tables to this file")
    options = parser.parse_args()
    cases = [Case(path) for path in options.cases]
    columns = ["case", "variant", "points", "wrong"] + COLUMNS
    file = RowFile(options.csv or os.devnull, columns, options.resume and options.csv)
    known = list(file.rows)
    for case in cases:
        if sum(row["case"] == case.name for row in known) == len(case.variants):
            continue
        rows, wrong = run_case(case, options)
        for row in rows:
            file.add({**row, "wrong": "; ".join(wrong)})
            print(f"{case.name} {row['variant']}: {row['outcome']}, {row['processor_seconds']} s, "
                  f"{row['newton_iterations']} iterations, {row['points']} {row['message']}", flush=True)
        for text in wrong:
            print(f"    WRONG: {text}", flush=True)
    if options.markdown:
        write_markdown(options.markdown, lines_of(cases, file.rows))
    sys.exit(1 if any(row["wrong"] for row in file.rows) else 0)


if __name__ == "__main__":
    main()
