#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What tests measure: a table of the numbers that they keep with tests/support/record.h.

Usage: scripts/development/test_records.py FOLDER_OF_TEST_PROGRAMS [--filter PATTERN ...]

Runs the programs test_* of GoogleTest in the folder, one after the other, each with one process, and prints a row for each
number or list of numbers. PATTERN: of GoogleTest, as 'Rolling.*'; tests that match one of them run, by default all.
If tests fail, the exit status is 1 and a line names them.
"""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from running import surroundings  # noqa: E402, F401  (first: see there)
import argparse
import json
import os
import subprocess
import tempfile

from document_tables import table

# What GoogleTest itself says of a test; the rest is what the test has recorded.
OF_GOOGLETEST = {"name", "file", "line", "type_param", "value_param", "status", "result", "timestamp", "time", "classname",
                 "failures", "skipped"}


def report_of(program, patterns):
    """Suites as GoogleTest reports them, and the exit status."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "report.json"
        done = subprocess.run([program, f"--gtest_output=json:{path}", f"--gtest_filter={':'.join(patterns)}"], cwd=folder,
                              env={**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"},
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        suites = json.loads(path.read_text(encoding="utf-8"))["testsuites"] if path.exists() else []
        return suites, done.returncode


def name_of(test):
    """Suite.Test; one that has a number only is told by its parameter, too."""
    name = f"{test['classname']}.{test['name']}"
    return f"`{name}`, {test['value_param']}" if name.rpartition("/")[2].isdigit() and "value_param" in test else f"`{name}`"


def rows_of(tests):
    for test in sorted(tests, key=name_of):
        name = name_of(test)
        for record, value in test.items():
            if record not in OF_GOOGLETEST:
                yield [cell.replace("|", "\\|") for cell in (name, record, value)]
                name = ""  # below, the same test


def main():
    parser = argparse.ArgumentParser(usage=__doc__.split("Usage: ")[1].split("\n")[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--filter", nargs="+", default=["*"], metavar="PATTERN")
    options = parser.parse_args()
    programs = [path for path in sorted(options.folder.resolve().glob("test_*")) if path.is_file() and os.access(path, os.X_OK)]
    if not programs:
        sys.exit(f"{options.folder} holds no programs test_*; build the tests first")
    rows, failed = [], []
    for program in programs:
        suites, status = report_of(program, options.filter)
        tests = [test for suite in suites for test in suite["testsuite"] if test["status"] == "RUN"]
        rows += rows_of(tests)
        wrong = [f"{test['classname']}.{test['name']}" for test in tests if "failures" in test]
        failed += wrong or ([f"{program.name} (status {status})"] if status != 0 else [])
    print(table(["test", "record", "value"], rows))
    if failed:
        sys.exit(f"failed: {', '.join(failed)}")


if __name__ == "__main__":
    sys.exit(main())
