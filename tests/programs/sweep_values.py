#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What scripts of many motors make of options and uncertainties, without a run of a program: values, samples, limits, fronts.

Usage: tests/programs/sweep_values.py

What is compared: samples with what defines them; fronts with comparison of all pairs.
"""
import math
import random
import sys
import unittest

sys.dont_write_bytecode = True  # a test leaves nothing in the source tree
from program import ROOT  # noqa: E402

sys.path.insert(0, str(ROOT / "scripts"))
from motors.goals import limit  # noqa: E402
from motors.sweep_figures import pareto_front  # noqa: E402
from motors.sweep_table import short_names  # noqa: E402
from motors.uncertainty import motor_of, sample_of, uncertain_inputs  # noqa: E402
from motors.variation import combinations, latin_hypercube, varied  # noqa: E402
from results.case import CaseError  # noqa: E402


class Values(unittest.TestCase):
    def test_of_ranges(self):
        self.assertEqual(varied("--vary", "a/b = 1:2:3").values, ("1", "1.5", "2"))
        self.assertEqual(varied("--vary", "a/b = 1:100:3:log").values, ("1", "10", "100"))
        self.assertEqual(varied("--vary", "a/b = solid, shell").values, ("solid", "shell"))
        self.assertEqual(len(combinations([varied("--vary", "a/b = 1:2:3"), varied("--vary", "a/c = x, y")])), 6)

    def test_of_a_latin_hypercube_fill_each_part_once(self):
        ranges = [varied("--vary", "a/b = 1:2"), varied("--vary", "a/c = 1:1000:log"), varied("--vary", "a/d = x, y")]
        sample = latin_hypercube(ranges, 50, seed=3)
        self.assertEqual(sorted(int(50 * (float(row["a/b"]) - 1)) for row in sample), list(range(50)))
        self.assertEqual(sorted(int(50 * math.log10(float(row["a/c"])) / 3) for row in sample), list(range(50)))
        self.assertEqual(sum(row["a/d"] == "x" for row in sample), 25)
        self.assertEqual(sample, latin_hypercube(ranges, 50, seed=3))
        self.assertNotEqual(sample, latin_hypercube(ranges, 50, seed=4))

    def test_of_uncertain_inputs(self):
        entries = {"Uncertainty/Loss factors": "0.5", "Uncertainty/Friction": "0.1", "Uncertainty/Young moduli": "0",
                   "Materials/Stator metal/Loss factor": "0.4", "Materials/Rotor metal/Loss factor": "0",
                   "Materials/Stator metal/Young modulus": "2e11", "Friction/Dynamic coefficient": "0.2",
                   "Friction/Static coefficient": "0.3"}
        inputs = uncertain_inputs(entries)
        self.assertEqual([one.name for one in inputs], ["Materials/Stator metal/Loss factor", "Friction"])
        motor = motor_of(inputs, [1., -1.], entries)
        self.assertAlmostEqual(float(motor["Materials/Stator metal/Loss factor"]), 0.4 * math.exp(0.5), 7)
        self.assertAlmostEqual(float(motor["Friction/Dynamic coefficient"]), 0.2 * math.exp(-0.1), 7)
        self.assertAlmostEqual(float(motor["Friction/Static coefficient"]), 0.3 * math.exp(-0.1), 7)
        self.assertEqual(motor_of(inputs, [9., 0.], entries)["Materials/Stator metal/Loss factor"], "1")
        sample = sample_of(inputs, 1000, 1)
        self.assertAlmostEqual(float(sample.mean()), 0., 2)
        self.assertAlmostEqual(float(sample.std()), 1., 1)

    def test_in_words_tell_entries_apart(self):
        self.assertEqual(short_names(["Wave/Amplitude", "Materials/A/Density", "Materials/B/Density"]),
                         ["Amplitude", "A/Density", "B/Density"])

    def test_of_limits(self):
        self.assertEqual((limit("", "f = 1:2").low, limit("", "f = 1:2").high), (1, 2))
        self.assertEqual((limit("", "f at 0.10 > 3").name, limit("", "f > 3").low), ("f at 0.1", 3))
        for text in ("f = 1", "f = 2:1", "> 3", "f > x", "f >= 3"):
            with self.assertRaises(CaseError):
                limit("--subject-to", text)

    def test_on_a_pareto_front_are_beaten_by_none(self):
        dice = random.Random(7)
        points = [(dice.randrange(20), dice.randrange(20)) for _ in range(100)]
        beaten = {one for one in points for other in points
                  if other != one and other[0] >= one[0] and other[1] >= one[1]}
        self.assertEqual(pareto_front(points, lambda point: point), sorted(set(points) - beaten))


if __name__ == "__main__":
    unittest.main()
