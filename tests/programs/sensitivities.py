#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The option --sensitivities as its user meets it.

Usage: tests/programs/sensitivities.py STATOR CONTACT LOSSES [unittest arguments]

What is compared: derivatives with differences of complete runs on other meshes; the reasons of those that are missing.
"""
import math
import pathlib
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True  # a test leaves nothing in the source tree
from program import STATIC_ROTOR, WithWave, rows_of, run, settings  # noqa: E402

STATOR, CONTACT, LOSSES = sys.argv.pop(1), sys.argv.pop(1), sys.argv.pop(1)
WithWave.stator = STATOR
COARSE = ("Accuracy/Contact target = 0.3", "Loading/Number of curve points = 2", "Output/VTU = false")
FINE = ("Accuracy/Mode = fixed", "Accuracy/Interface refinement = 2", "Time/Snapshots = 2",
        "Loading/Number of curve points = 2", "Output/VTU = false")


class Sensitivities(WithWave):
    def contact(self, *words, entries=COARSE, folder=None):
        return run(CONTACT, STATIC_ROTOR, "--output", folder or self.case, *words, *settings(*entries))

    def test_are_those_of_complete_runs(self):
        done = self.contact("--sensitivities")
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = {row["entry"]: row for row in rows_of(self.case / "contact" / "sensitivities.csv")}
        self.assertIn("Stator/Base thickness", rows)
        self.assertFalse({"Time/Spectral radius", "Accuracy/Target", "Stator/Target plate cross-section"} & set(rows),
                         "of the run, or of no effect here")
        for name in ("Loading/Preload", "Friction/Dynamic coefficient", "Rotor/Flange thickness"):
            with self.subTest(entry=name):
                self.compare(rows[name], name)

    def ends(self, *entries):
        """Speed without load, torque at stall, by a complete run."""
        done = self.contact(entries=(*FINE, *entries))
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = rows_of(self.case / "contact" / "torque_speed.csv")
        return float(rows[0]["speed_rpm"]), float(rows[-1]["torque_mNm"])

    def compare(self, row, name):
        step, value = float(row["step"]) / float(row["value"]), float(row["value"])
        less, more = (self.ends(f"{name} = {value * math.exp(change)!r}") for change in (-step, step))
        for i, quantity in enumerate(("no_load_speed", "stall_torque")):
            difference = math.log(more[i] / less[i]) / (2. * step)
            self.assertAlmostEqual(float(row[quantity]), difference, delta=0.02 + float(row[quantity + "_error"]))

    def test_says_what_has_none(self):
        with tempfile.TemporaryDirectory() as folder:
            done = run(STATOR, STATIC_ROTOR, "--sensitivities", "--output", folder)
            self.assertEqual(done.returncode, 1)
            self.assertIn("--sensitivities is not available for the program stator", done.stderr)
        done = self.contact("--sensitivities", "--study")
        self.assertIn("--sensitivities cannot be combined with --study", done.stderr)
        with tempfile.TemporaryDirectory() as folder:  # before anything is computed or looked for
            for entry, reason in (("Time/Scheme = marching", "--sensitivities needs the steady state"),
                                  ("Wave/Drive = voltage", "Wave/Drive = voltage is not available with --sensitivities")):
                with self.subTest(entry=entry):
                    done = self.contact("--sensitivities", entries=(*COARSE, "Wave/Voltage = 40", "Effects/Piezoelectric coupling = on", entry), folder=folder)
                    self.assertEqual((done.returncode, len(done.stderr.splitlines())), (1, 1), done.stderr)
                    self.assertIn(reason, done.stderr)


if __name__ == "__main__":
    unittest.main()
