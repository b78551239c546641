#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The program contact as its user meets it: files, messages, exit status.

Usage: tests/programs/contact.py STATOR CONTACT [unittest arguments]

What is compared: files with each other and with the loads that were asked for; an independent model of
the motor turns at 85.3 rpm without load (see tests/points/motor.cc).
"""
import json
import math
import pathlib
import re
import sys
import tempfile
import unittest

import h5py
import numpy as np

sys.dont_write_bytecode = True  # a test leaves nothing in the source tree
from program import STATIC_ROTOR, ROOT, WithWave, on_ranks, rows_of, run, settings, vtu_array  # noqa: E402

STATOR, CONTACT = sys.argv.pop(1), sys.argv.pop(1)
PRELOAD = 14.0
# The paper's own run.
FIFTEEN_STEPS = ("Time/Number of steps = 15", "Time/Average from step = 6", "Time/Average to step = 15")


class WithContact(WithWave):
    stator = STATOR

    def contact(self, *entries, ranks=1):
        return run(*on_ranks(ranks), CONTACT, STATIC_ROTOR, "--output", self.case, *settings(*entries))


class Results(WithContact):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.done = run(CONTACT, STATIC_ROTOR, "--output", cls.case)
        cls.folder = cls.case / "contact"

    def test_all_files_are_there(self):
        self.assertEqual(self.done.returncode, 0, self.done.stderr)
        self.assertEqual(self.done.stderr, "")
        written = {path.name for path in self.folder.iterdir()}
        for name in ("used.prm", "torque_speed.csv", "history.csv", "contact.h5", "summary.json", "contact.pvd",
                     "contact_000.vtu", "contact_002.vtu", "motor.pvd", "rotor_002.vtu", "teeth_002.vtu"):
            self.assertIn(name, written)

    def test_the_curve_goes_from_no_load_to_stall(self):
        rows = rows_of(self.folder / "torque_speed.csv")
        self.assertEqual([row["control"] for row in rows], ["torque", "torque", "speed"])
        speed = [float(row["speed_rpm"]) for row in rows]
        torque = [float(row["torque_mNm"]) for row in rows]
        self.assertAlmostEqual(speed[0], 85.3, delta=0.02 * 85.3)
        self.assertAlmostEqual(torque[0], 0.0, places=6)
        self.assertTrue(0.5 < torque[1] / torque[2] < 0.8, torque)  # half of the way along the curve
        self.assertEqual(speed[2], 0.0)
        self.assertTrue(speed[0] > speed[1] > speed[2])
        for row in rows:
            self.assertLessEqual(float(row["certificate"]), 1e-7)

    def test_forces_balance_the_loads(self):
        rows = rows_of(self.folder / "torque_speed.csv")
        with h5py.File(self.folder / "contact.h5") as file:
            radius = file["nodes/radius"][()]
            for number, row in enumerate(rows):
                force = file[f"points/{number:03d}/force"][()]
                for moment in force:
                    self.assertAlmostEqual(moment[..., 0].sum(), PRELOAD, delta=1e-8 * PRELOAD)
                torque = (force[..., 1] * radius).sum() / force.shape[0]
                self.assertAlmostEqual(1e3 * torque, float(row["torque_mNm"]), delta=1e-6)
                gap = file[f"points/{number:03d}/gap_and_slip"][..., 0]
                status = file[f"points/{number:03d}/status"][()]
                self.assertGreater(gap.min(), -1e-14)
                self.assertTrue(np.all(np.abs(gap[status > 0]) < 1e-14))
                self.assertTrue(np.all(force[status == 0] == 0.0))

    def test_whole_bodies_carry_what_happens_at_the_contact_points(self):
        record = (self.folder / "motor.pvd").read_text()
        files = re.findall(r'timestep="(\S+)" part="(\d)" file="(\S+)"', record)
        # All points have the same wave, and so the same base below the teeth.
        self.assertEqual([name for _, _, name in files], [name for number in range(3) for name in (
            f"rotor_{number:03d}.vtu", f"teeth_{number:03d}.vtu", "base_000.vtu")])
        self.assertEqual([part for _, part, _ in files], ["0", "1", "2"] * 3)
        place = vtu_array(self.folder / "teeth_001.vtu", "").reshape(-1, 3)
        moved = vtu_array(self.folder / "teeth_001.vtu", "displacement").reshape(-1, 3)
        gap = vtu_array(self.folder / "teeth_001.vtu", "gap")
        status = vtu_array(self.folder / "teeth_001.vtu", "status")
        pressure = vtu_array(self.folder / "teeth_001.vtu", "pressure")
        self.assertTrue(np.all((pressure > 0) == (status > 0)))
        with h5py.File(self.folder / "contact.h5") as file:
            radius, angle = file["nodes/radius"][()], file["nodes/angle"][()]
            group = file["points/001"]
            lift, is_closed = group["tooth"][-1, ..., 0], group["status"][-1] > 0
            n_teeth = len(lift)
            where = np.hypot(place[:, 0], place[:, 1]), np.arctan2(place[:, 1], place[:, 0])
            n_found = 0
            for point in np.flatnonzero(status > 0):
                turned = (where[1][point] - angle) * n_teeth / (2 * np.pi)
                tooth = np.round(turned).astype(int)
                node = np.argmin(np.abs(where[0][point] - radius) + radius * np.abs(turned - tooth))
                self.assertTrue(is_closed[tooth[node] % n_teeth, node])
                self.assertAlmostEqual(moved[point, 2], lift[tooth[node] % n_teeth, node], delta=1e-6 * lift.max())
                self.assertLess(abs(gap[point]), 1e-14)
                n_found += 1
            self.assertGreater(n_found, 20)
        rise = vtu_array(self.folder / "rotor_001.vtu", "displacement").reshape(-1, 3)[:, 2]
        self.assertTrue(np.all(np.isfinite(rise)))
        self.assertGreater(lift.max(), rise.min())

    def test_the_summary_is_certified(self):
        summary = json.loads((self.folder / "summary.json").read_text())
        self.assertTrue(summary["certificate"]["holds"])
        names = [quantity["name"] for quantity in summary["quantities"]]
        for name in ("no_load_speed", "stall_torque", "speed", "friction_loss"):
            self.assertIn(name, names)
        for quantity in summary["quantities"]:
            if quantity["name"] == "clearance":  # follows from the dimensions alone
                self.assertEqual(quantity["error"], 0.0)
                continue
            self.assertGreater(quantity["error"], 0.0, quantity["name"])
            self.assertAlmostEqual(math.hypot(*quantity["error_causes"].values()), quantity["error"])

    def test_two_ranks_find_the_same(self):
        one = rows_of(self.folder / "torque_speed.csv")
        done = self.contact(ranks=2)
        self.assertEqual(done.returncode, 0, done.stderr)
        for a, b in zip(one, rows_of(self.folder / "torque_speed.csv")):
            for column in ("speed_rpm", "torque_mNm", "friction_loss_mW"):
                self.assertAlmostEqual(float(a[column]), float(b[column]), delta=1e-5)


class Mistakes(WithContact):
    def refused(self, status, *entries):
        done = self.contact(*entries)
        self.assertEqual(done.returncode, status, done.stderr)
        self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
        return done.stderr

    def test_entries_that_do_not_go_together(self):
        for entries, said in (
                (["Rotor/Lip inner radius = 0.0290", "Rotor/Lip outer radius = 0.0298"], "the lip misses the teeth"),
                (["Rotor/Ring inner radius = 0.0357", "Rotor/Ring lower face = -0.006"],
                 "Rotor/Ring lower face = -0.006 m; allowed: above 0.035895"),
                (["Loading/Preload = 0"], "Loading/Preload"),
                (["Friction/Dynamic coefficient = 0"], "Friction/Dynamic coefficient"),
                (["Friction/Law = velocity"], "Friction/Decay velocity"),
                (["Effects/Spin convection = on"], "Effects/Spin convection = on is not available"),
                (["Effects/Rotor inertia = on", "Initial deformation/Amplitude = 4e-6", "Rotor/Radial bar stiffness = 0"],
                 "Effects/Rotor inertia = on is not available with Rotor/Radial bar stiffness = 0"),
                (["Effects/Damping = on", "Time/Scheme = marching"],
                 "Effects/Damping = on is not available with Effects/Rotor inertia = off"),
                (["Contact/Formulation = penalty"], "Contact/Normal penalty"),
                (["Time/Average to step = 20"], "allowed: all three auto, or 2 <= Average from step"),
                ([*FIFTEEN_STEPS, "Time/Average to step = 20"], "Time/Average to step = 20"),
                (["Output/History points = 0:0.031"], "0.0332 to 0.0342 m"),
                (["Output/History points = 90:0.034"], "from 0 to less than 90"),
                (["Time/Scheme = marching", "Time/Time step = 2e-5"], "longer than half a period of the wave"),
                (["Motor/Number of waves = 6"], "belongs to another motor"),
                (["Stator/Tooth height = 0.0021"], "Stator/Tooth height = 0.002"),
                (["Wave/Amplitude = 1e-6"], "Wave/Amplitude")):
            self.assertIn(said, self.refused(1, *entries))

    def test_loads_beyond_stall_lose_nothing(self):
        self.assertEqual(self.contact("Loading/Values = 0.05").returncode, 0)
        before = (self.case / "contact" / "torque_speed.csv").read_bytes()
        self.assertIn("beyond the stall", self.refused(1, "Loading/Values = 0.05, 0.3"))
        self.assertEqual((self.case / "contact" / "torque_speed.csv").read_bytes(), before)

    def test_a_wave_that_is_missing_or_damaged(self):
        modes = self.case / "stator" / "modes.h5"
        kept = modes.read_bytes()
        try:
            modes.write_bytes(kept[:len(kept) // 2])
            self.assertIn("modes.h5", self.refused(1))
            modes.unlink()
            self.assertIn("does not exist", self.refused(1))
        finally:
            modes.write_bytes(kept)

    def test_long_steps_are_warned_of_and_have_long_bars(self):
        # Other teeth touch at the end of such a step than at its begin.
        done = self.contact("Time/Scheme = marching", "Time/Time step = 5e-6", "Loading/Values = 0", *FIFTEEN_STEPS,
                            "Accuracy/Mode = fixed", "Friction/Law = coulomb")
        self.assertEqual(done.returncode, 0, done.stderr)
        (point,) = rows_of(self.case / "contact" / "torque_speed.csv")  # solved, but of no use, as the bars say
        self.assertGreater(float(point["friction_loss_error_mW"]), float(point["friction_loss_mW"]))
        self.assertGreater(float(point["speed_error_rpm"]), 0.2 * float(point["speed_rpm"]))
        self.assertIn("is not small compared to the time for which a tooth is in contact", done.stdout)

    def test_a_rotor_that_sticks_is_loaded_by_a_quarter_of_what_friction_bears(self):
        # 30 kN for each micrometre press the lip flat.
        preload, outer_radius = 60e3, 0.0342
        done = self.contact(f"Loading/Preload = {preload}", "Output/VTU = false")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("warning: the wave does not turn the rotor", done.stdout)
        rows = rows_of(self.case / "contact" / "torque_speed.csv")
        self.assertEqual([row["control"] for row in rows], ["torque"] * 3)
        borne = 1e3 * 0.40 * preload * outer_radius  # mN m
        self.assertAlmostEqual(float(rows[-1]["torque_mNm"]) / borne, 0.25, delta=0.01)
        for row in rows:
            self.assertLess(abs(float(row["speed_rpm"])), 1e-6)

    def test_unusual_friction_is_warned_of(self):
        done = self.contact("Friction/Static coefficient = 0.7", "Friction/Dynamic coefficient = 0.84",
                            "Loading/Values = 0.05", "Accuracy/Contact target = 0.2")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("warning: Friction/Dynamic coefficient", done.stdout)


class Targets(unittest.TestCase):
    """The accuracy that the contact asks for is that of the stator's wave, too."""

    def relative_error(self, *entries):
        """Of the wave in modes.h5, and what the program says."""
        with tempfile.TemporaryDirectory() as case:
            done = run(STATOR, STATIC_ROTOR, "--output", case, *settings("Output/VTU = false", *entries))
            self.assertEqual(done.returncode, 0, done.stderr)
            with h5py.File(pathlib.Path(case) / "stator" / "modes.h5") as file:
                wave, shape = file["wave"].attrs, file["wave/shape"].attrs
                error = wave["relative_error"]
                self.assertAlmostEqual(error, wave["natural_frequency_error_Hz"] / wave["natural_frequency_Hz"]
                                       + shape["A_t/A_n error"] / shape["A_t/A_n"], delta=1e-12)
            return error, done.stdout

    def test_the_wave_is_a_fifth_of_what_the_contact_asks_for(self):
        loose = "Accuracy/Target = 3e-2"
        for target in (0.5, 1e-2, 3e-3):
            error, said = self.relative_error(loose, f"Accuracy/Contact target = {target}")
            self.assertLessEqual(error, target / 5)
            driven_by = "Accuracy/Target = 0.03" if target == 0.5 else f"Accuracy/Contact target = {target:g} (a fifth"
            self.assertIn(f"the last mesh was made for {driven_by}", said)
        error, said = self.relative_error("Accuracy/Target = 3e-4", "Accuracy/Contact target = 0.1")
        self.assertLessEqual(error, 0.02)
        self.assertIn("the last mesh was made for Accuracy/Target = 0.0003", said)

    def test_a_fresh_wave_is_never_too_coarse_for_the_contact(self):
        plain = settings("Accuracy/Target = 3e-2", "Loading/Values = 0.05", "Output/VTU = false")
        entries = plain + settings("Accuracy/Contact target = 1e-2")
        with tempfile.TemporaryDirectory() as case:
            for program in (STATOR, CONTACT):
                done = run(program, STATIC_ROTOR, "--output", case, *entries)
                self.assertEqual(done.returncode, 0, done.stderr)
            # A wave from elsewhere may be.
            coarse = settings("Accuracy/Mode = fixed", "Accuracy/Polynomial degree = 2")
            self.assertEqual(run(STATOR, STATIC_ROTOR, "--output", case, *coarse).returncode, 0)
            done = run(CONTACT, STATIC_ROTOR, "--output", case, *plain, "--set", "Accuracy/Contact target = 1e-3")
            self.assertEqual(done.returncode, 2, done.stdout)
            self.assertIn("run the program stator with these parameters", done.stderr)


class Histories(WithContact):
    def test_teeth_live_alike_one_after_the_other(self):
        """In the steady state tooth 12 lives as tooth 0 does, 12 n T / N later."""
        done = self.contact("Output/History points = 0:0.0342, 12:0.0342, 89.75:0.0333", "Output/VTU = false",
                            "Loading/Values = 0.05", "Accuracy/Mode = fixed", "Time/Snapshots = 3")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertFalse((self.case / "contact" / "motor.pvd").exists())
        with h5py.File(self.case / "contact" / "contact.h5") as file:
            period = 2e6 * np.pi / file.attrs["angular_frequency_rad_per_s"]
        histories = {}
        for row in rows_of(self.case / "contact" / "history.csv"):
            histories.setdefault((int(row["tooth"]), int(row["node"])), []).append(row)
        (first, edge), (later, same), (last, inside) = histories
        self.assertEqual((first, later, last), (0, 12, 0))  # 89.75 belongs to the tooth at 90, which is 0
        self.assertEqual(edge, same)
        self.assertAlmostEqual(float(histories[0, edge][0]["theta_deg"]), 0.0)
        self.assertAlmostEqual(float(histories[0, edge][0]["r_mm"]), 34.2)
        self.assertLess(float(histories[0, inside][0]["theta_deg"]), -0.5)
        self.assertLess(float(histories[0, inside][0]["r_mm"]), 34.0)
        lag = 12 * 7 / 90 * period
        steps = len(histories[0, edge])
        for row in histories[12, edge]:
            at = round((float(row["time_us"]) - lag) / period * steps) % steps
            twin = histories[0, edge][at]
            for name in row:
                if name not in ("tooth", "time_us"):
                    self.assertEqual(row[name], twin[name], name)
        self.assertGreater(max(float(row["force_n_N"]) for row in histories[12, edge]), 0.01)


class Paper(WithContact):
    def test_marching_and_warp(self):
        """Fifteen steps of 5e-7 s with springs at the nodes; warp makes the motor slower."""
        speeds = []
        for amplitude in ("0", "4e-6"):
            done = self.contact("Time/Scheme = marching", *FIFTEEN_STEPS, "Contact/Formulation = penalty",
                                "Contact/Normal penalty = 1e8", "Contact/Tangential penalty = 1e8",
                                "Loading/Values = 0.05", f"Initial deformation/Amplitude = {amplitude}",
                                "Accuracy/Mode = fixed", "Accuracy/Interface refinement = 1")
            self.assertEqual(done.returncode, 0, done.stderr)
            speeds.append(float(rows_of(self.case / "contact" / "torque_speed.csv")[0]["speed_rpm"]))
            times = {row["time_us"] for row in rows_of(self.case / "contact" / "history.csv")}
            self.assertEqual(len(times), 15)
        self.assertAlmostEqual(speeds[0], 82.7, delta=0.02 * 82.7)
        self.assertLess(speeds[1], speeds[0] - 3.0)

    def test_its_window_is_in_the_error_bar(self):
        """The mean of steps 6 to 15 and its bar hold the mean over a whole period of the solution."""
        torques, errors, losses, loss_errors = [], [], [], []
        for steps in (FIFTEEN_STEPS, ()):
            done = self.contact("Loading/Control = speed", "Loading/Values = 8", "Friction/Law = coulomb", *steps,
                                "Initial deformation/Amplitude = 4e-6", "Accuracy/Mode = fixed", "Output/VTU = false")
            self.assertEqual(done.returncode, 0, done.stderr)
            summary = json.loads((self.case / "contact" / "summary.json").read_text())
            torque = next(quantity for quantity in summary["quantities"] if quantity["name"] == "torque")
            torques.append(torque["value"])
            errors.append(torque["error_causes"]["averaging window"])
            loss = next(quantity for quantity in summary["quantities"] if quantity["name"] == "friction_loss")
            losses.append(loss["value"])
            loss_errors.append(loss["error_causes"]["averaging window"])
        self.assertLess(errors[1], 0.1 * 0.05 * 0.2)
        self.assertGreater(errors[0], errors[1])
        self.assertLessEqual(abs(torques[0] - torques[1]), errors[0])
        self.assertLessEqual(abs(losses[0] - losses[1]), loss_errors[0])
        with h5py.File(self.case / "contact" / "contact.h5") as file:
            moments = file["points/000/time"][()]
            period = 2 * np.pi / file.attrs["angular_frequency_rad_per_s"]
        # With cos(2 theta) the solution repeats itself after half a period of the wave.
        self.assertAlmostEqual(len(moments) * (moments[1] - moments[0]) / period, 0.5)


class Study(WithContact):
    def study(self, *options):
        done = run(CONTACT, STATIC_ROTOR, "--output", self.case, "--study", *options,
                   *settings("Loading/Values = 0.05", "Friction/Law = coulomb", "Rotor/Flange element = shell",
                             "Accuracy/Mode = fixed", "Accuracy/Interface refinement = 0"))
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout, rows_of(self.case / "contact" / "study.csv")

    def test_shows_what_accuracy_costs_and_goes_on_after_an_interruption(self):
        said, rows = self.study()
        knobs = [row["knob"] for row in rows]
        for knob in ("common setting", "interface mesh", "degree", "flange", "contact", "steps per period", "as in the paper"):
            self.assertIn(knob, knobs)
        self.assertEqual((knobs[-1], rows[-1]["distance_speed"]), ("best setting", "0"))
        self.assertNotIn("distance_torque", rows[0])  # it is given
        for row in rows:
            self.assertLessEqual(int(row["degree"]), 2)
            self.assertEqual(row["other_model"] == "1", row["knob"] == "flange")

        def distance(knob, value):
            return next(float(row["distance_speed"]) for row in rows if (row["knob"], row["value"]) == (knob, value))
        self.assertGreater(distance("degree", "1"), 2 * distance("common setting", ""))
        self.assertGreater(distance("as in the paper", ""), distance("as in the paper", "its springs alone"))
        # The cheapest setting for a tolerance: none that reaches it took less.
        line = next(line for line in said.splitlines() if "cheapest for speed to 1.0e-02" in line)
        best = min((row for row in rows[:-1] if row["distance_speed"] and float(row["distance_speed"]) <= 1e-2),
                   key=lambda row: float(row["seconds"]))
        self.assertIn(f": {best['knob']} {best['value']}".rstrip() + ",", line)
        self.assertIn("speed", best["pareto_front"])
        figure = run(ROOT / "scripts" / "study_figure.py", self.case)
        self.assertEqual(figure.returncode, 0, figure.stderr)
        self.assertTrue((self.case / "figures" / "contact_study.png").exists())

        # As if the run had been killed: two rows are missing, one is damaged.
        kept = sorted((self.case / "contact" / "kept" / "study").iterdir())
        self.assertEqual(len(kept), len(rows))
        for path in kept[:2]:
            path.unlink()
        kept[2].write_bytes(kept[2].read_bytes()[:-1])
        said, resumed = self.study("--resume")
        self.assertIn("1 kept settings were damaged: computed anew", said)
        self.assertIn(f"resumed: {len(rows) - 3} settings were available; 3 were computed", said)
        for before, after in zip(rows, resumed):
            for column in before:
                if column not in ("seconds", "pareto_front"):
                    self.assertEqual(after[column], before[column], column)
        self.assertGreaterEqual(sum(a["seconds"] == b["seconds"] for a, b in zip(rows, resumed)), len(rows) - 3)


if __name__ == "__main__":
    unittest.main()
