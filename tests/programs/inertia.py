#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Inertia of the rotor as users of the programs meet it.

Usage: tests/programs/inertia.py STATOR CONTACT LOSSES [unittest arguments]

What is compared: an independent model of the motor with the stiff spring finds that inertia changes speeds at half of the
stall torque by 2.6 % of the speed without load (see tests/points/inertia.cc), near stall by more; that is below what a
target of 0.4 leaves to the error bars, and above that of 0.01; results on one rank and on two; the power balance.
"""
import json
import math
import pathlib
import shutil
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True  # a test leaves nothing in the source tree
from program import ROOT, on_ranks, rows_of, run, settings  # noqa: E402

STATOR, CONTACT, LOSSES = sys.argv.pop(1), sys.argv.pop(1), sys.argv.pop(1)
STIFF = ROOT / "prm" / "stiff_spring.prm"
COARSE = ("Accuracy/Mode = fixed", "Accuracy/Interface refinement = 0", "Output/VTU = false",
          "Friction/Law = coulomb", "Loading/Values = 0.05, 0.1, 0.16",
          "Time/Snapshots = 4")  # with fewer powers do not balance


class StiffSpring(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.case = pathlib.Path(tempfile.mkdtemp())
        done = run(STATOR, STIFF, "--output", cls.case, *settings("Accuracy/Target = 1e-3", "Output/VTU = false"))
        assert done.returncode == 0, done.stderr

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.case)

    def contact(self, *entries, ranks=1):
        done = run(*on_ranks(ranks), CONTACT, STIFF, "--output", self.case, *settings(*COARSE, *entries))
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.case / "contact" / "summary.json") as file:
            summary = json.load(file)
        rows = rows_of(self.case / "contact" / "torque_speed.csv")
        effect = [effect for effect in summary["effects"] if effect["name"] == "Rotor inertia"]
        return rows, effect, done.stdout

    def test_auto_compares_with_the_target(self):
        without, (effect,), said = self.contact("Accuracy/Contact target = 0.4")
        self.assertEqual(effect["choice"], "off")
        self.assertIn("Effects/Rotor inertia = auto: off", said)
        with_inertia, (chosen,), said = self.contact("Accuracy/Contact target = 0.01")
        self.assertEqual(chosen["choice"], "on")
        # Far from the threshold the lip alone tells, roughly.
        self.assertLess(chosen["indicator"], 3 * effect["indicator"])
        self.assertGreater(chosen["indicator"], effect["indicator"] / 3)
        no_load = 83.7  # rpm, nearly
        change = max(abs(float(a["speed_rpm"]) - float(b["speed_rpm"])) / no_load
                     for a, b in zip(without, with_inertia))
        self.assertLess(effect["indicator"], 3 * change)
        self.assertGreater(effect["indicator"], change / 3)
        differences = [abs(float(a["speed_rpm"]) - float(b["speed_rpm"])) for a, b in zip(without, with_inertia)]
        for difference, row in zip(differences[:-1], without):  # what is left out is in the error bars
            self.assertLess(difference, float(row["speed_error_rpm"]))
        # Near stall the speed with inertia is itself hardly known better.
        self.assertLess(differences[-1], math.hypot(*(float(rows[-1]["speed_error_rpm"]) for rows in (without, with_inertia))))

    def test_ranks_agree_and_losses_close(self):
        one, _, _ = self.contact("Effects/Rotor inertia = on")
        done = run(LOSSES, STIFF, "--output", self.case, *settings(*COARSE, "Effects/Rotor inertia = on"))
        self.assertEqual(done.returncode, 0, done.stderr)
        two, _, _ = self.contact("Effects/Rotor inertia = on", ranks=2)
        for a, b in zip(one, two):
            self.assertAlmostEqual(float(a["speed_rpm"]), float(b["speed_rpm"]), delta=1e-6)


if __name__ == "__main__":
    unittest.main()
