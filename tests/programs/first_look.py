#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The first file that a user meets: the reference motor computed coarsely, with the effects of the reference motor.

Usage: tests/programs/first_look.py MOTOR [unittest arguments]

What is compared: prm/quick.prm with prm/canon_ring.prm, within the error bars of both; the estimate of an effect that is
switched off with the change that it makes; the reference motor, with inertia and without, with what an earlier version of the
program and an independent model of its bodies and its contact found for it, which agree to 1 % of the speed and 8 % of the loss.
"""
import json
import pathlib
import shutil
import sys
import tempfile
import unittest

import h5py

sys.dont_write_bytecode = True  # a test leaves nothing in the source tree
from program import ROOT, rows_of, run, settings  # noqa: E402

MOTOR = sys.argv.pop(1)
QUIET = settings("Output/VTU = false", "Loading/Number of curve points = 3")
COARSE = settings("Accuracy/Target = 1e-2", "Accuracy/Contact target = 0.2")
STATIC = settings("Effects/Rotor inertia = off")


class FirstLook(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp())
        for name, file, options in (("quick", "quick", ()), ("reference", "canon_ring", ()), ("moving", "soft_spring", COARSE),
                                    ("static", "soft_spring", (*COARSE, *STATIC))):
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
        for place, key, share in ((0, "speed_rpm", 0.25), (-1, "torque_mNm", 0.25), (-1, "friction_loss_mW", 0.25),
                                  (0, "friction_loss_mW", 0.7)):  # small, and known less well
            error = key.replace("_", "_error_") if key.count("_") == 1 else key.replace("loss_", "loss_error_")
            with self.subTest(key):
                bars = quick[place][error] + reference[place][error]
                self.assertAlmostEqual(quick[place][key], reference[place][key], delta=bars)
                self.assertLess(bars, share * reference[place][key])

    def test_has_its_effects(self):
        quick, reference = self.effects("quick"), self.effects("reference")
        self.assertEqual(list(quick), list(reference))
        self.assertEqual(self.effects("moving")["Rotor inertia"]["choice"], "on")
        for name, effect in quick.items():  # but for what is small against its larger targets
            if effect["choice"] != reference[name]["choice"]:
                self.assertLess(abs(effect["indicator"]), 1e-2 / 3, name)

    def test_judges_what_is_switched_off(self):
        """A third of the change of the lip's motion is a rough estimate: within a factor of two."""
        effect = self.effects("static")["Rotor inertia"]
        self.assertEqual((effect["choice"], effect["automatic"]), ("off", False))
        static, moving = self.points("static"), self.points("moving")
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

    def test_tells_what_a_variant_changes(self):
        done = run(ROOT / "scripts" / "summary.py", self.folder / "static")
        self.assertEqual(done.returncode, 0, done.stderr)
        table = done.stdout.split("Differences from canon_ring.prm")[1].split("\n\n")[0]
        for row in (r"Stator/Base thickness +0.00437 +0.004153\n", r"Effects/Rotor inertia +off +auto\n",
                    r"Accuracy/Contact target +0.2 +0.03\n"):
            self.assertRegex(table, row)
        self.assertNotIn("Output/Directory", table)
        self.assertNotIn("Differences", run(ROOT / "scripts" / "summary.py", self.folder / "reference").stdout)


class ReferenceMotor(unittest.TestCase):
    """Speeds in rpm at 0, 50, 100, 150 mN m; at the first of them friction loss in mW and teeth in contact per wave. The solid
    flange is 0.32 mm thick, and its ring begins at 35 mm."""

    SHELL = {"off": ([72.0, 69.6, 66.0, 60.1], 57.5, 3.7), "on": ([72.8, 70.2, 66.3, 59.9], 65.2, 3.95)}
    SOLID = {"off": ([72.4, 70.2, 67.0, 62.0], 48.2, 3.4)}
    SOLID_FLANGE = ("Rotor/Flange element = solid", "Rotor/Flange thickness = 0.00032", "Rotor/Ring inner radius = 0.035")
    FIXED = ("Output/VTU = false", "Accuracy/Mode = fixed", "Accuracy/Polynomial degree = 3", "Accuracy/Interface refinement = 1",
             "Time/Snapshots = 2")

    def run_motor(self, *entries):
        folder = self.enterContext(tempfile.TemporaryDirectory())
        done = run(MOTOR, ROOT / "prm" / "canon_ring.prm", "--output", folder, *settings(*self.FIXED, *entries))
        self.assertEqual(done.returncode, 0, done.stderr)
        points = [{name: float(text) for name, text in row.items() if name != "control"}
                  for row in rows_of(pathlib.Path(folder) / "contact" / "torque_speed.csv")]
        return points, done.stdout

    def compare(self, expected, inertia, *entries):
        speeds, loss, teeth = expected[inertia]
        effects = (f"Effects/{name} = {inertia}" for name in ("Rotor inertia", "Tooth inertia", "Tooth vibration", "Damping"))
        points, said = self.run_motor("Loading/Values = 0, 0.05, 0.1, 0.15", *entries, *effects)
        for point, speed in zip(points, speeds):
            self.assertAlmostEqual(point["speed_rpm"], speed, delta=0.01 * speeds[0])
        self.assertAlmostEqual(points[0]["friction_loss_mW"], loss, delta=0.05 * loss)
        self.assertAlmostEqual(points[0]["teeth_in_contact_per_wave"], teeth, delta=0.15)
        return said

    def test_without_inertia(self):
        self.compare(self.SHELL, "off")

    def test_with_inertia(self):
        said = self.compare(self.SHELL, "on")
        ratios = said.split("at the harmonics of the wave: ")[1].split("\n")[0].split()
        for ratio, expected in zip(map(float, ratios), (1.04, 1.08, 1.17, 1.30, 1.45, 1.61)):
            self.assertAlmostEqual(ratio, expected, delta=0.015)

    def test_lets_a_node_stick_twice(self):
        """The teeth move inwards at a crest as far as the bent lip does; all force is on the outer line."""
        folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        done = run(MOTOR, ROOT / "prm" / "canon_ring.prm", "--output", folder, *QUIET, *settings("Loading/Values = 0"))
        self.assertEqual(done.returncode, 0, done.stderr)
        found = {quantity["name"]: quantity for program in ("stator", "contact") for quantity in
                 json.loads((folder / program / "summary.json").read_text())["quantities"]}
        for name in ("A_r/A_n", "lip_A_r/A_n"):
            self.assertAlmostEqual(found[name]["value"], -0.23, delta=0.005)
            self.assertLess(found[name]["error"], 0.005)
        self.assertAlmostEqual(found["clearance"]["value"], 0.03495 - (0.0342 + 1.5 / 5.853 * 0.0014), delta=1e-9)
        self.assertGreater(found["second_stick_fraction"]["value"], 0)
        share = found["friction_loss_radial"]["value"] / found["friction_loss"]["value"]
        self.assertAlmostEqual(found["radial_loss_share"]["value"], share, delta=1e-12)
        rows = rows_of(folder / "contact" / "history.csv")
        self.assertEqual({round(float(row["r_mm"]), 9) for row in rows}, {34.2})
        with h5py.File(folder / "contact" / "contact.h5") as file:
            force = file["points/000/force"][..., 0]
            outer = file["nodes/radius"][()] > 0.0342 - 2e-5  # of a lip that is 150 um wide
            self.assertGreater(force[..., outer].sum(), 0.999 * force.sum())
        page = run(ROOT / "scripts" / "summary.py", folder).stdout
        self.assertIn("brakes, sticks, drives, sticks, brakes, releases", page)

    def test_with_a_solid_flange(self):
        self.compare(self.SOLID, "off", *self.SOLID_FLANGE)

    def test_with_a_solid_flange_and_inertia(self):
        """With everything on auto, the motor that was found is within the error bars and those of the other model, which is
        known to a hundredth of the speed without load."""
        folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        done = run(MOTOR, ROOT / "prm" / "canon_ring.prm", "--output", folder,
                   *settings("Output/VTU = false", "Accuracy/Contact target = 0.06", "Loading/Values = 0, 0.05, 0.1, 0.15",
                             *self.SOLID_FLANGE))
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = rows_of(folder / "contact" / "torque_speed.csv")
        for row, speed in zip(rows, (73.2, 70.7, 67.1, 61.4)):
            self.assertAlmostEqual(float(row["speed_rpm"]), speed, delta=float(row["speed_error_rpm"]) + 0.01 * 73.2)
            self.assertLess(float(row["speed_error_rpm"]), 0.06 * 73.2)
        self.assertAlmostEqual(float(rows[0]["friction_loss_mW"]), 54.4, delta=float(rows[0]["friction_loss_error_mW"]))
        self.assertAlmostEqual(float(rows[0]["teeth_in_contact_per_wave"]), 3.6,
                               delta=float(rows[0]["teeth_in_contact_per_wave_error"]))

    def test_stalls_where_all_friction_points_one_way(self):
        (point,), _ = self.run_motor("Loading/Control = speed", "Loading/Values = 0")
        self.assertAlmostEqual(point["torque_mNm"], 1e3 * 0.40 * 14 * 0.0342, delta=0.2)


if __name__ == "__main__":
    unittest.main()
