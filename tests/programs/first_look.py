#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The first file that a user meets: the reference motor computed coarsely, with the effects of the reference motor.

Usage: tests/programs/first_look.py MOTOR [unittest arguments]

What is compared: prm/quick.prm with prm/canon_ring.prm, within the error bars of both; the estimate of an effect that is
switched off with the change that it makes.
"""
import json
import pathlib
import shutil
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True  # a test leaves nothing in the source tree
from program import ROOT, rows_of, run, settings  # noqa: E402

MOTOR = sys.argv.pop(1)
QUIET = settings("Output/VTU = false", "Loading/Number of curve points = 3")
STATIC = settings("Effects/Rotor inertia = off")


class FirstLook(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp())
        for name, file, options in (("quick", "quick", ()), ("reference", "canon_ring", ()), ("static", "quick", STATIC)):
            done = run(MOTOR, ROOT / "prm" / f"{file}.prm", "--output", cls.folder / name, *QUIET, *options)
            assert done.returncode == 0, done.stderr

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    def points(self, name):
        return [{key: float(text) for key, text in row.items() if key != "control"}
                for row in rows_of(self.folder / name / "contact" / "torque_speed.csv")]

    def effects(self, name):
        return {effect["name"]: effect for program in ("stator", "contact") for effect in
                json.loads((self.folder / name / program / "summary.json").read_text())["effects"]}

    def test_is_the_reference_motor_within_both_error_bars(self):
        quick, reference = self.points("quick"), self.points("reference")
        for place, key in ((0, "speed_rpm"), (-1, "torque_mNm"), (0, "friction_loss_mW"), (-1, "friction_loss_mW")):
            error = key.replace("_", "_error_") if key.count("_") == 1 else key.replace("loss_", "loss_error_")
            with self.subTest(key):
                bars = quick[place][error] + reference[place][error]
                self.assertAlmostEqual(quick[place][key], reference[place][key], delta=bars)
                self.assertLess(bars, 0.25 * reference[place][key])

    def test_has_its_effects(self):
        quick, reference = self.effects("quick"), self.effects("reference")
        self.assertEqual(list(quick), list(reference))
        self.assertEqual(quick["Rotor inertia"]["choice"], "on")
        for name, effect in quick.items():  # but for what is small against its larger targets
            if effect["choice"] != reference[name]["choice"]:
                self.assertLess(abs(effect["indicator"]), 1e-2 / 3, name)

    def test_judges_what_is_switched_off(self):
        """A third of the change of the lip's motion is a rough estimate: within a factor of two."""
        effect = self.effects("static")["Rotor inertia"]
        self.assertEqual((effect["choice"], effect["automatic"]), ("off", False))
        static, moving = self.points("static"), self.points("quick")
        largest = 0.
        for one, two in zip(static, static[1:]):  # speeds of the static rotor at the torques of the other
            for point in moving:
                if one["torque_mNm"] <= point["torque_mNm"] <= two["torque_mNm"]:
                    share = (point["torque_mNm"] - one["torque_mNm"]) / (two["torque_mNm"] - one["torque_mNm"])
                    speed = one["speed_rpm"] + share * (two["speed_rpm"] - one["speed_rpm"])
                    largest = max(largest, abs(point["speed_rpm"] - speed) / static[0]["speed_rpm"])
        self.assertGreater(effect["indicator"], 0.5 * largest)
        self.assertLess(effect["indicator"], 2. * largest)

    def test_names_on_the_page_what_is_missing(self):
        done = run(ROOT / "scripts" / "summary.py", self.folder / "static")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"Rotor inertia is off, but would change the results by \d\d %\n")
        self.assertNotIn("Tooth inertia is off, but", done.stdout)


if __name__ == "__main__":
    unittest.main()
