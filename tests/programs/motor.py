#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The program motor, which runs the three others in one process, against those.

Usage: tests/programs/motor.py STATOR CONTACT LOSSES MOTOR [unittest arguments]
"""
import json
import pathlib
import shutil
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True  # a test leaves nothing in the source tree
from program import QUICK, on_ranks, rows_of, run, settings  # noqa: E402

STATOR, CONTACT, LOSSES, MOTOR = (sys.argv.pop(1) for _ in range(4))
QUIET = settings("Output/VTU = false", "Loading/Values = 0, 0.05")
TABLES = ("stator/frequencies.csv", "stator/ellipses.csv", "contact/torque_speed.csv", "losses/losses.csv",
          "losses/efficiency.csv")


class Motor(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp())
        cls.one_by_one = cls.folder / "one_by_one"
        for program in (STATOR, CONTACT, LOSSES):
            done = run(program, QUICK, "--output", cls.one_by_one, *QUIET)
            assert done.returncode == 0, done.stderr

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    def assert_same_tables(self, case, tables=TABLES, relative=0.):
        for table in tables:
            for row, same in zip(rows_of(self.one_by_one / table), rows_of(case / table), strict=True):
                for name in row:
                    # Rounding decides on certificates and on errors, which are differences.
                    if name == "seconds" or relative and ("error" in name or name == "certificate"):
                        continue
                    try:
                        self.assertLessEqual(abs(float(row[name]) - float(same[name])), relative * abs(float(row[name])),
                                             f"{table}: {name}")
                    except ValueError:
                        self.assertEqual(row[name], same[name])

    def refused(self, *options):
        done = run(MOTOR, QUICK, "--output", self.folder / "refused", *options)
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        self.assertFalse((self.folder / "refused").exists())
        return done.stderr

    def test_is_the_three_programs(self):
        case = self.folder / "motor"
        done = run(MOTOR, QUICK, "--output", case, *QUIET)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_same_tables(case)
        files = [sorted(path.relative_to(folder) for path in folder.rglob("*") if path.is_file() and "kept" not in path.parts)
                 for folder in (self.one_by_one, case)]
        self.assertEqual(*files)
        for program in ("stator", "contact", "losses"):
            summary = json.loads((case / program / "summary.json").read_text())
            alone = json.loads((self.one_by_one / program / "summary.json").read_text())
            self.assertEqual(summary["program"], program)
            self.assertEqual(summary["seconds"].keys(), alone["seconds"].keys())
            self.assertEqual([check["name"] for check in summary["certificate"]["checks"]],
                             [check["name"] for check in alone["certificate"]["checks"]])

    def test_two_ranks(self):
        case = self.folder / "two_ranks"
        done = run(*on_ranks(2), MOTOR, QUICK, "--output", case, *QUIET)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_same_tables(case, ("stator/frequencies.csv", "contact/torque_speed.csv"), 1e-6)

    def test_begins_with_what_is_asked_for(self):
        case = self.folder / "from"
        shutil.copytree(self.one_by_one, case)
        wave = case / "stator" / "modes.h5"
        time = wave.stat().st_mtime_ns
        for table in ("contact/torque_speed.csv", "losses/losses.csv"):
            (case / table).unlink()
        done = run(MOTOR, QUICK, "--output", case, "--from", "contact", *QUIET)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(wave.stat().st_mtime_ns, time)
        self.assert_same_tables(case)

    def test_goes_on_after_an_interruption(self):
        case = self.folder / "resumed"
        shutil.copytree(self.one_by_one, case)
        done = run(MOTOR, QUICK, "--output", case, "--resume", *QUIET)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("resumed: ", done.stdout)
        self.assert_same_tables(case)

    def test_modes_of_a_rotor_have_no_motor(self):
        case = self.folder / "rotor"
        done = run(MOTOR, QUICK, "--output", case, *QUIET, "--set", "Modes/Body = rotor")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual([path.name for path in case.iterdir()], ["rotor"])

    def test_what_is_wrong_for_the_last_program_stops_the_first(self):
        self.assertIn("Friction/Dynamic coefficient", self.refused("--set", "Friction/Dynamic coefficient = 0"))

    def test_options(self):
        self.assertIn("--from stator: expected contact or losses", self.refused("--from", "stator"))
        self.assertIn("needs a value", self.refused("--from"))
        self.assertIn("--study is not available for the program motor", self.refused("--study"))
        done = run(CONTACT, QUICK, "--from", "losses")
        self.assertEqual(done.returncode, 1)
        self.assertIn("--from is not available for the program contact", done.stderr)

    def test_a_program_that_fails_is_named_and_the_last_one(self):
        case = self.folder / "fails"
        done = run(MOTOR, QUICK, "--output", case, "--set", "Output/VTU = false", "--set", "Loading/Values = 9")
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertTrue(done.stderr.startswith("contact: Loading/Values = 9"), done.stderr)
        self.assertIn("Loading/Values = 9", (case / "contact_failed.txt").read_text())
        self.assertTrue((case / "stator" / "summary.json").exists())
        self.assertFalse((case / "losses").exists())


if __name__ == "__main__":
    unittest.main()
