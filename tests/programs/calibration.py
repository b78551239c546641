#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Entries from a measured torque-speed curve, as their user meets it.

Usage: tests/programs/calibration.py STATOR CONTACT LOSSES

What is compared: coefficient of friction and amplitude with those of the motor from which the "measured" curves come, to
which noise of known size was added, five times; shapes of curves with curves that have a formula; the surrogate with exact
polynomials; the posterior of linear motors with its closed form.
"""
import json
import math
import pathlib
import shutil
import sys
import tempfile
import unittest
from types import SimpleNamespace

sys.dont_write_bytecode = True  # a test leaves nothing in the source tree
from program import STATIC_ROTOR, ROOT, rows_of, run, settings  # noqa: E402

sys.path.insert(0, str(ROOT / "scripts"))
import numpy as np  # noqa: E402
from calibrate import CURVE, fitted_of, interval_of, main, n_motors_of, parse, read_measured, surrogate_of  # noqa: E402
from motors.calibration import PLACES, Measured, Posterior, Shapes, Surrogate, check_on_curve, shape_of  # noqa: E402
from motors.many_motors import Engine, Family  # noqa: E402
from motors.variation import latin_hypercube, ranged  # noqa: E402
from results.case import CaseError  # noqa: E402
from sweep import sweep  # noqa: E402

if __name__ == "__main__":  # processes of workers import this file, too
    PROGRAMS = [pathlib.Path(sys.argv.pop(1)) for _ in range(3)]
TRUTH = {"Friction/Dynamic coefficient": 0.27, "Wave/Amplitude": 1.7e-6}
# Half of these motors do not bear all measured torques, and half of them do not reach all measured speeds.
RANGES = "Friction/Dynamic coefficient = 0.1:0.6", "Wave/Amplitude = 1e-6:2.5e-6"
N_MOTORS, N_POINTS = 8, 7
COARSE = {"Friction/Law": "coulomb", "Accuracy/Contact target": "0.2"}
TORQUE_NOISE, SPEED_NOISE = 2., 0.3  # mN m, rpm
N_CURVES, MOST_OUTSIDE = 5, 3  # of two intervals of 95 % for each curve: more have a probability of 0.1 %


class Calibration(unittest.TestCase):
    """With motors of the programs."""

    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp())
        cls.output = cls.folder / "calibration"
        case, entries = cls.folder / "truth", {**COARSE, **TRUTH, "Accuracy/Contact target": "0.03", "Output/VTU": "false",
                                               "Loading/Number of curve points": "10"}
        for program in PROGRAMS[:2]:
            done = run(program, STATIC_ROTOR, "--output", case, *settings(*(f"{entry} = {text}" for entry, text in
                                                                     entries.items())))
            assert done.returncode == 0, done.stderr
        cls.truth = rows_of(case / "contact" / "torque_speed.csv")
        cls.fitted = [ranged("--fit", text) for text in RANGES]
        family = Family(STATIC_ROTOR, {**COARSE, **CURVE, "Loading/Number of curve points": str(N_POINTS)}, cls.output,
                        PROGRAMS[0].parent)
        with Engine(2) as engine:
            cls.rows = sweep(engine, family, latin_hypercube(cls.fitted, N_MOTORS, 1))

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

    def test_finds_friction_and_amplitude(self):
        self.assertEqual([row.outcome for row in self.rows], ["certified"] * N_MOTORS)
        surrogate = surrogate_of(self.rows, self.fitted)
        intervals, widths = [], []
        for seed in range(N_CURVES):
            posterior, dice = Posterior(surrogate, read_measured(self.write_measured(seed))), np.random.default_rng(seed)
            chain = posterior.sample(posterior.best(2, dice), dice)
            for one, places in zip(self.fitted, chain.T):
                low, median, high = interval_of(one, places)
                self.assertTrue(low < median < high)
                intervals.append((low, TRUTH[one.entry], high))
                widths.append((high - low) / (one.high - one.low))
        outside = [one for one in intervals if not one[0] < one[1] < one[2]]
        print(f"{len(outside)} of {len(intervals)} outside, mean widths {np.mean(widths[::2]):.2g} and "
              f"{np.mean(widths[1::2]):.2g} of the ranges", file=sys.stderr)
        self.assertLessEqual(len(outside), MOST_OUTSIDE, intervals)
        self.assertLess(np.mean(widths), 0.15)

    def command(self, measured, *options):
        return run(ROOT / "scripts" / "calibrate.py", STATIC_ROTOR, measured, "--output", self.output, "--programs",
                   PROGRAMS[0].parent, *(word for text in RANGES for word in ("--fit", text)), "--motors", N_MOTORS,
                   "--points", N_POINTS, *settings(*(f"{entry} = {text}" for entry, text in COARSE.items())), *options)

    def test_by_one_command(self):
        done = self.command(ROOT / "prm" / "static_rotor_measured.csv")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue(done.stdout.startswith(f"{N_MOTORS} motors will be computed at {N_POINTS} points each"), done.stdout)
        self.assertIn(f"{N_MOTORS} motors are known already", done.stdout)
        found = json.loads((self.output / "calibration.json").read_text())["entries"]
        for entry, true in TRUTH.items():
            low, high = found[entry]["interval_95"]
            self.assertTrue(low < true < high and low < found[entry]["median"] < high, found)
        self.assertTrue((self.output / "calibration.svg").exists())

    def test_mistakes_are_told_in_one_line(self):
        done = self.command(self.write_measured(1), "--fit", "Friction/Dynamic = 0.1:0.2", "--motors", "12")
        self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1), done.stderr)
        self.assertIn("there is no such entry", done.stderr)
        names = "torque_mNm,speed_rpm,speed_error_rpm"
        for text, words in (("", "cannot be read"), ("torque_mNm,speed_rpm\n1,x\n", "cannot be read"),
                            ("a,b\n1,2\n", "torque_mNm"), ("torque_mNm,speed_rpm\n1,2\n2,3\n", "needs torque_error_mNm"),
                            (f"{names}\n1,nan,1\n", "not finite"), (f"{names}\n1,2,1\n", "too few points: .*, found 1"),
                            (f"{names}\n1,2,1\n-1,2,1\n", "point 2 .* -1 mN m at 2 rpm, is not between no load and stall")):
            path = self.folder / "mistake.csv"
            path.write_text(text)
            with self.assertRaisesRegex(CaseError, words):
                main([str(word) for word in (STATIC_ROTOR, path, "--fit", RANGES[0], "--fit", RANGES[1], "--programs",
                                             PROGRAMS[0].parent)])


class Options(unittest.TestCase):
    def options(self, *words):
        return parse(["FILE.prm", "MEASURED.csv", "--fit", RANGES[0], *words])

    def test_that_contradict_each_other_are_refused(self):
        for words, told in ((("--fit", RANGES[0]), "given twice"),
                            (settings("Friction/Dynamic coefficient = 0.3"), "given twice"),
                            (settings("Loading/Values = 0.1"), "--points"),
                            (("--fit", "Loading/Number of curve points = 3:9"), "--points")):
            with self.assertRaisesRegex(CaseError, told):
                fitted_of(self.options(*words))
        with self.assertRaisesRegex(CaseError, "expected 5 or more"):
            self.options("--points", "2")
        for n_motors in ("0", "4"):
            with self.assertRaisesRegex(CaseError, "expected 5 or more "):
                n_motors_of(self.options("--motors", n_motors), 1)
        self.assertEqual([n_motors_of(self.options(), n_entries) for n_entries in (1, 2, 3)], [8, 12, 20])


def superellipse(exponent, places):
    """Shares of torque and speed with share^exponent adding up to 1, at places along the curve from 0 to 1."""
    return np.sin(places * math.pi / 2) ** (2 / exponent), np.cos(places * math.pi / 2) ** (2 / exponent)


class CurvesWithFormula(unittest.TestCase):
    """Motors with a no-load speed, a stall torque and a superellipse between them."""

    def shape(self, speed, torque, exponent, n_points=11, error=0.):
        y, x = superellipse(exponent, np.linspace(0, 1, n_points))
        y[0], x[-1] = 0., 0.
        none = np.full(n_points, error)
        return shape_of(torque * y, speed * x, none, none)

    def test_are_met_between_the_points(self):
        for exponent in (1., 1.5, 2., 4.):
            values, bars = self.shape(9., 0.2, exponent)
            self.assertEqual(list(values[:2]), [9., 0.2])
            y, x = superellipse(exponent, np.linspace(0.02, 0.98, 60))
            excess, *_ = Shapes(values[None]).excess(0.2 * y, 9. * x)
            self.assertLess(abs(excess).max(), 0.02)
            self.assertLess(np.sqrt(np.mean(excess ** 2)), 0.01)
            torque, speed = Shapes(values[None]).points(50)
            self.assertLess(abs((torque[0] / 0.2) ** exponent + (speed[0] / 9.) ** exponent - 1.).max(), 0.1)
            self.assertEqual(list(bars[:2]), [0., 0.])

    def test_with_few_points_have_error_bars_that_say_so(self):
        few, many = (self.shape(9., 0.2, 4., n_points)[1][2:].max() for n_points in (5, 21))
        self.assertTrue(0.005 < few and many < few / 5, (few, many))

    def test_pass_the_errors_of_their_points_on(self):
        _, bars = self.shape(1., 1., 1., error=0.01)
        np.testing.assert_allclose(bars[2:], 0.01 * math.sqrt(2.), rtol=1e-9)  # along the straight line both count the same
        self.assertEqual(list(bars[:2]), [0.01, 0.01])

    def test_have_the_derivatives_of_the_excess(self):
        values, step = self.shape(9., 0.2, 3.)[0], 1e-6
        torque, speed = np.array([0.01, 0.1, 0.19, 0.3]), np.array([9.1, 7., 2., 4.])
        excess, by_speed, by_torque, by_values = Shapes(values[None]).excess(torque, speed)

        def difference(changed):
            return (changed[0] - excess) / step
        np.testing.assert_allclose(by_speed, difference(Shapes(values[None]).excess(torque, speed + step)), rtol=1e-3)
        np.testing.assert_allclose(by_torque, difference(Shapes(values[None]).excess(torque + step, speed)), rtol=1e-3)
        for number, change in enumerate(step * np.eye(len(values))):
            changed = Shapes((values + change)[None]).excess(torque, speed)
            n_within = 4 if number < 2 else 3  # the last point is beyond stall
            np.testing.assert_allclose(by_values[0, :n_within, number], difference(changed)[0, :n_within], 1e-3, 1e-6)
            np.testing.assert_allclose(by_values[0, n_within:, number], 0., atol=1e-12)

    def test_compare_the_speed_near_no_load_and_the_torque_near_stall(self):
        values, bars = self.shape(9., 0.2, 6.)
        _, by_speed, by_torque, _ = Shapes(values[None]).excess(np.array([0.02, 0.199]), np.array([8.99, 0.9]))
        by_speed, by_torque = 9. * by_speed[0], 0.2 * by_torque[0]
        self.assertTrue(abs(by_torque[0]) < 0.02 * by_speed[0] and abs(by_speed[1]) < 0.02 * by_torque[1])

    def test_that_are_none_are_refused(self):
        zero = np.zeros(6)
        rising = np.linspace(0., 1., 6)
        for torque, speed, words in ((rising, rising[::-1] - 1., "no curve"), (rising[:3], rising[2::-1], "no curve"),
                                     (rising, np.array([1., 1., 1.5, 0.5, 0.2, 0.]), "does not fall")):
            with self.assertRaisesRegex(CaseError, words):
                shape_of(torque, speed, zero[:len(torque)], zero[:len(torque)])

    def shape_at(self, place, error=0.):
        return self.shape(5. + 10. * place[0], 0.05 + 0.25 * place[1], 3. + place[1], 15, error)

    def surrogate(self, error=0.):
        places = np.random.default_rng(2).uniform(0, 1, (12, 2))
        return Surrogate(places, *(np.array(part) for part in zip(*(self.shape_at(place, error) for place in places))))

    def test_are_not_drawn_to_where_deviations_are_small(self):
        # Many points that scatter less than their deviations say, and motors with error bars.
        true, dice = np.array([0.5, 0.5]), np.random.default_rng(3)
        torque, speed = Shapes(self.shape_at(true)[0][None]).points(200)
        measured = Measured(torque[0], speed[0], np.full(200, 0.01), np.full(200, 0.1))
        posterior = Posterior(self.surrogate(error=2e-3), measured)
        chain = posterior.sample(posterior.best(2, dice), dice)
        np.testing.assert_array_less(abs(np.mean(chain, axis=0) - true), 0.5 * np.std(chain, axis=0))

    def test_find_the_motor_of_measured_points(self):
        # From points near no load, near stall, and all along, of a motor that more than half of the others cannot follow.
        surrogate, true, dice = self.surrogate(), np.array([0.7, 0.6]), np.random.default_rng(3)
        torque, speed = Shapes(self.shape_at(true)[0][None]).points(21)
        for among, determined in ((slice(0, 3), [0]), (slice(18, 21), [1]), (slice(0, 21, 2), [0, 1])):
            n_points = len(torque[0][among])
            measured = Measured(torque[0][among] + 1e-3 * dice.standard_normal(n_points), speed[0][among] + 0.05 *
                                dice.standard_normal(n_points), np.full(n_points, 1e-3), np.full(n_points, 0.05))
            posterior = Posterior(surrogate, measured)
            fit = posterior.best(2, dice)
            self.assertLess(fit.chi_squared, n_points + 4 * math.sqrt(2. * n_points))
            low, high = np.percentile(posterior.sample(fit, dice), (0.1, 99.9), axis=0)
            self.assertTrue(np.all((low < true) & (true < high)), (low, high))
            for entry in (0, 1):
                self.assertEqual(high[entry] - low[entry] < 0.1, entry in determined, (among, low, high))


class Surrogates(unittest.TestCase):
    def surrogate(self, values_at, n_entries=2, bars=0.):
        places = np.random.default_rng(1).uniform(0, 1, (40, n_entries))
        values = np.array([values_at(place) for place in places])
        return Surrogate(places, values, np.full(values.shape, bars))

    def test_are_exact_for_polynomials(self):
        def values_at(place):
            return 3. + np.array([place[0] * place[1] - place[0], place[1] ** 2, 1., 0.])
        surrogate = self.surrogate(values_at)
        np.testing.assert_allclose(surrogate.shapes(np.array([[0.3, 0.7]])).values[0], values_at([0.3, 0.7]), rtol=1e-12)
        self.assertLess(surrogate.missed.max(), 1e-12)

    def test_know_what_they_miss(self):
        surrogate = self.surrogate(lambda place: np.array([3. + math.sin(4. * place[0])]), 1)
        true = [3. + math.sin(4. * x) - surrogate.shapes(np.array([[x]])).values[0, 0] for x in np.linspace(0, 1, 101)]
        self.assertTrue(0.5 < surrogate.missed[0] / np.sqrt(np.mean(np.square(true))) < 2.)

    def test_of_too_few_motors_are_refused(self):
        with self.assertRaisesRegex(CaseError, "5 or more"):
            Surrogate(np.zeros((4, 1)), np.zeros((4, 2)), np.zeros((4, 2)))

    def test_leave_out_motors_without_a_curve(self):
        rows = [SimpleNamespace(outcome="failed", varied={"Friction/Dynamic coefficient": "0.3"},
                                message="contact: no steady state")]
        with self.assertRaisesRegex(CaseError, "0 of 1 motors have a curve, 5 are needed; .*0.3: contact: no steady state"):
            surrogate_of(rows, [ranged("--fit", RANGES[0])])


class Posteriors(unittest.TestCase):
    """Of straight curves torque + speed = a; n measurements of a with deviations s leave it normal with s / sqrt(n)."""

    def posterior(self, measured, bars=0.):
        places = np.linspace(0, 1, 12)[:, None]
        ends, bulges = np.repeat(2. + 10. * places, 2, axis=1), np.zeros((12, len(PLACES) - 2))
        return Posterior(Surrogate(places, np.hstack([ends, bulges]), np.hstack([np.full((12, 2), bars), bulges])), measured)

    def test_of_a_linear_motor_is_that_of_textbooks(self):
        speeds, deviation = np.linspace(1., 4., 9), 0.6
        for of_torque in (1., 0., 0.6):  # deviations of the torque alone, of the speed alone, of both
            torques = 6. - speeds + deviation * np.array([0.5, -1, 0.2, 1.1, -0.3, -0.6, 0.9, -0.4, 0.1])
            posterior = self.posterior(Measured(torques, speeds, np.full(9, deviation * of_torque), np.full(
                9, deviation * math.sqrt(1. - of_torque ** 2))))
            dice = np.random.default_rng(5)
            fit = posterior.best(1, dice)
            mean = (np.mean(torques + speeds) - 2.) / 10.
            self.assertAlmostEqual(fit.place[0], mean, 6)
            chain = posterior.sample(fit, dice)[:, 0]
            self.assertAlmostEqual(np.mean(chain), mean, delta=0.002)  # 0.02 over the root of some thousand
            self.assertAlmostEqual(np.std(chain) / (deviation / 3. / 10.), 1., 1)

    def test_does_not_average_errors_of_the_motor(self):
        # At no load, where the error bar of the no-load speed shifts all points.
        n_points, deviation, bar = 25, 0.3, 0.1
        posterior = self.posterior(Measured(np.zeros(n_points), np.full(n_points, 7.), np.full(n_points, 1e-9),
                                            np.full(n_points, deviation)), bar)
        dice = np.random.default_rng(5)
        chain = posterior.sample(posterior.best(1, dice), dice)[:, 0]
        self.assertAlmostEqual(np.std(chain) * 10. / math.hypot(deviation / 5., bar), 1., 1)

    def test_points_beyond_the_ends_are_refused_but_for_noise(self):
        def points(torque, speed):
            return Measured(np.array([0.1, torque]), np.array([5., speed]), np.full(2, 2e-3), np.full(2, 0.1))
        check_on_curve(points(-5e-3, 9.))
        check_on_curve(points(0.2, -0.2))
        for torque, speed in ((-7e-3, 9.), (0.2, -0.4)):
            with self.assertRaisesRegex(CaseError, "point 2 .* is not between no load and stall"):
                check_on_curve(points(torque, speed))


if __name__ == "__main__":
    unittest.main()
