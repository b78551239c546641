#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Entries from a measured torque-speed curve, as their user meets it.

Usage: tests/programs/calibration.py STATOR CONTACT LOSSES

What is compared: the coefficient of friction with that of the motor from which the "measured" curves come, to which noise of known
size was added, twenty times; the surrogate with exact polynomials; the posterior of a linear problem with its closed form.
"""
import json
import math
import pathlib
import shutil
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True  # a test leaves nothing in the source tree
from program import QUICK, ROOT, rows_of, run, settings  # noqa: E402

sys.path.insert(0, str(ROOT / "scripts"))
import numpy as np  # noqa: E402
from calibrate import interval_of, main, read_measured, speeds_for, surrogate_of  # noqa: E402
from calibration import Measured, Posterior, Surrogate  # noqa: E402
from case import CaseError  # noqa: E402
from many_motors import Engine, Family  # noqa: E402
from sweep import sweep  # noqa: E402
from variation import latin_hypercube, ranged  # noqa: E402

if __name__ == "__main__":  # processes of workers import this file, too
    PROGRAMS = [pathlib.Path(sys.argv.pop(1)) for _ in range(3)]
COEFFICIENT = 0.27
TORQUES = "0.01, 0.03, 0.05, 0.07, 0.09, 0.11, 0.12"
COARSE = {"Accuracy/Contact target": "0.1"}
TORQUE_NOISE, SPEED_NOISE = 2., 0.3  # mN m, rpm
RANGE = "Friction/Dynamic coefficient = 0.2:0.4"
MOST_OUTSIDE = 4  # of 20 intervals of 95 %: more have a probability of 0.3 %


class Calibration(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp())
        case = cls.folder / "truth"
        for program in PROGRAMS[:2]:
            done = run(program, QUICK, "--output", case, *settings(
                f"Friction/Dynamic coefficient = {COEFFICIENT}", "Friction/Law = coulomb", f"Loading/Values = {TORQUES}",
                "Accuracy/Contact target = 0.03", "Output/VTU = false"))
            assert done.returncode == 0, done.stderr
        cls.truth = rows_of(case / "contact" / "torque_speed.csv")

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    def write_measured(self, seed):
        dice = np.random.default_rng(seed)
        lines = ["torque_mNm,speed_rpm,torque_error_mNm,speed_error_rpm"]
        for row in self.truth:
            torque = float(row["torque_mNm"]) + TORQUE_NOISE * dice.standard_normal()
            speed = float(row["speed_rpm"]) + SPEED_NOISE * dice.standard_normal()
            lines.append(f"{torque:.4f},{speed:.4f},{TORQUE_NOISE},{SPEED_NOISE}")
        path = self.folder / f"measured_{seed}.csv"
        path.write_text("\n".join(lines) + "\n")
        return path

    def test_finds_the_coefficient_of_friction(self):
        fitted = [ranged("--fit", RANGE)]
        speeds = speeds_for(read_measured(self.write_measured(0)))
        family = Family(QUICK, {**COARSE, "Friction/Law": "coulomb", "Loading/Control": "speed",
                                "Loading/Values": ", ".join(map(str, speeds))}, self.folder / "motors", PROGRAMS[0].parent)
        with Engine(2) as engine:
            rows = sweep(engine, family, latin_hypercube(fitted, 8, 1))
        surrogate = surrogate_of(rows, fitted, speeds)
        intervals = []
        for seed in range(20):
            posterior = Posterior(surrogate, read_measured(self.write_measured(seed)))
            dice = np.random.default_rng(seed)
            best = posterior.best(1, dice)
            low, median, high = interval_of(fitted[0], posterior.sample(best, dice)[:, 0])
            self.assertTrue(low < median < high)
            intervals.append((low, high))
        outside = [one for one in intervals if not one[0] < COEFFICIENT < one[1]]
        print(f"{len(outside)} of 20 outside, mean width {np.mean([high - low for low, high in intervals]):.3g}", file=sys.stderr)
        self.assertLessEqual(len(outside), MOST_OUTSIDE, intervals)
        self.assertLess(np.mean([high - low for low, high in intervals]), 0.1)  # half of the range tells nothing

    def test_by_one_command(self):
        output = self.folder / "calibration"
        done = run(ROOT / "scripts" / "calibrate.py", QUICK, self.write_measured(3), "--fit", RANGE, "--output", output, "--motors", "6",
                   "--programs", PROGRAMS[0].parent, *settings("Friction/Law = coulomb", "Accuracy/Contact target = 0.2"))
        self.assertEqual(done.returncode, 0, done.stderr)
        found = json.loads((output / "calibration.json").read_text())["entries"]["Friction/Dynamic coefficient"]
        self.assertLess(abs(found["median"] - COEFFICIENT), 0.05)
        self.assertTrue(found["interval_95"][0] < found["median"] < found["interval_95"][1])
        self.assertTrue((output / "calibration.svg").exists())

    def test_mistakes_are_told_in_one_line(self):
        good = self.write_measured(1)
        for text, words in (("", "cannot be read"), ("torque_mNm,speed_rpm\n1,x\n", "cannot be read"), ("a,b\n1,2\n", "torque_mNm"),
                            ("torque_mNm,speed_rpm\n1,2\n2,3\n", "needs torque_error_mNm"),
                            ("torque_mNm,speed_rpm,speed_error_rpm\n1,nan,1\n", "not finite"),
                            ("torque_mNm,speed_rpm,speed_error_rpm\n1,2,1\n", "two different speeds")):
            path = self.folder / "mistake.csv"
            path.write_text(text)
            with self.assertRaisesRegex(CaseError, words):
                main([str(word) for word in (QUICK, path, "--fit", RANGE, "--programs", PROGRAMS[0].parent)])
        done = run(ROOT / "scripts" / "calibrate.py", QUICK, good, "--fit", "Friction/Dynamic = 0.1:0.2", "--programs",
                   PROGRAMS[0].parent)
        self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1), done.stderr)
        self.assertIn("there is no such entry", done.stderr)


class Surrogates(unittest.TestCase):
    def surrogate(self, curve, n_entries=2):
        places = np.random.default_rng(1).uniform(0, 1, (40, n_entries))
        speeds = np.linspace(1., 5., 5)
        return Surrogate(speeds, places, np.array([curve(place, speeds) for place in places]), np.zeros((40, 5)))

    def test_are_exact_for_polynomials(self):
        def curve(place, speeds):
            return speeds * place[0] ** 2 * place[1] - place[0] + 3.
        surrogate = self.surrogate(curve)
        np.testing.assert_allclose(surrogate.torques([[0.3, 0.7]])[0], curve([0.3, 0.7], surrogate.speeds), rtol=1e-12)
        self.assertLess(surrogate.missed.max(), 1e-12)

    def test_know_what_they_miss(self):
        surrogate = self.surrogate(lambda place, speeds: 0. * speeds + math.sin(6. * place[0]), 1)
        true = [math.sin(6. * x) - surrogate.torques([[x]])[0, 0] for x in np.linspace(0, 1, 101)]
        root_mean_square = np.sqrt(np.mean(np.square(true)))
        self.assertTrue(0.5 < surrogate.missed[0] / root_mean_square < 2.)

    def test_of_too_few_motors_are_refused(self):
        with self.assertRaises(CaseError):
            Surrogate([1., 2.], np.zeros((5, 1)), np.zeros((5, 2)), np.zeros((5, 2)))

    def test_posterior_of_a_linear_motor_is_that_of_textbooks(self):
        # torque = a - speed + 0 x, measured with deviations of the torque s: a is normal with s / sqrt(n).
        surrogate = self.surrogate(lambda place, speeds: 10. * place[0] - speeds, 1)
        speeds, deviation = np.linspace(1., 5., 9), 0.6
        torques = 4. - speeds + deviation * np.array([0.5, -1, 0.2, 1.1, -0.3, -0.6, 0.9, -0.4, 0.1])
        posterior = Posterior(surrogate, Measured(torques, speeds, np.full(9, deviation), np.zeros(9)))
        dice = np.random.default_rng(5)
        best = posterior.best(1, dice)
        mean = np.mean(torques + speeds) / 10.
        self.assertAlmostEqual(best[0], mean, 7)
        chain = posterior.sample(best, dice)[:, 0]
        self.assertAlmostEqual(np.mean(chain), mean, delta=0.002)  # 0.02 over the root of some thousand
        self.assertAlmostEqual(np.std(chain) / (deviation / 3. / 10.), 1., 1)


if __name__ == "__main__":
    unittest.main()
