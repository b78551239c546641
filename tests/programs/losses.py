#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The program losses as its user meets it: files, messages, exit status.

Usage: tests/programs/losses.py STATOR CONTACT LOSSES [unittest arguments]

What is compared: files with each other; losses that a change of a loss factor must scale; powers with the work of
the forces in contact.h5.
"""
import json
import math
import pathlib
import shutil
import sys
import tempfile
import unittest

import h5py
import numpy as np

sys.dont_write_bytecode = True  # a test leaves nothing in the source tree
from program import STATIC_ROTOR, WithWave, rows_of, run, settings, vtu_array  # noqa: E402

STATOR, CONTACT, LOSSES = sys.argv.pop(1), sys.argv.pop(1), sys.argv.pop(1)
PARTS = ("friction_loss", "internal_loss_stator_metal", "internal_loss_piezoceramic",
         "internal_loss_stator_vibration", "internal_loss_rotor", "support_loss")


def numbers(path):
    return [{key: float(value) for key, value in row.items()} for row in rows_of(path)]


class Losses(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.case = pathlib.Path(tempfile.mkdtemp())
        for program in (STATOR, CONTACT):
            done = run(program, STATIC_ROTOR, "--output", cls.case, "--set", "Output/VTU = false")
            assert done.returncode == 0, done.stderr

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.case)

    def losses(self, *entries):
        return run(LOSSES, STATIC_ROTOR, "--output", self.case, *settings(*entries))

    def results(self, *entries):
        """losses.csv, efficiency.csv, summary.json"""
        done = self.losses(*entries)
        self.assertEqual(done.returncode, 0, done.stderr)
        folder = self.case / "losses"
        return numbers(folder / "losses.csv"), numbers(folder / "efficiency.csv"), \
            json.loads((folder / "summary.json").read_text())

    def refused(self, *entries):
        done = self.losses(*entries)
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        return done.stderr

    def test_the_power_adds_up(self):
        losses, efficiency, summary = self.results()
        self.assertTrue(summary["certificate"]["holds"])
        for quantity in summary["quantities"]:
            self.assertAlmostEqual(math.hypot(*quantity["error_causes"].values()), quantity["error"], delta=1e-9)
            self.assertGreater(quantity["seconds"], 0)
            only_wave = "internal_loss_stator" in quantity["name"] or quantity["name"] in ("internal_loss_piezoceramic", "support_loss")
            if quantity["error"] > 0:  # there is no output without load
                self.assertEqual(quantity["error_causes"]["time step"] == 0, only_wave, quantity["name"])
        curve = [{key: float(value) for key, value in row.items() if key != "control"}
                 for row in rows_of(self.case / "contact" / "torque_speed.csv")]
        self.assertEqual(len(losses), len(curve))
        for loss, power, point in zip(losses, efficiency, curve):
            total = sum(loss[part + "_mW"] for part in PARTS)
            self.assertAlmostEqual(total, loss["total_loss_mW"], delta=1e-6 * total)
            # Between errors of one cause, which add up, and independent ones, whose squares do
            errors = [loss[part + "_error_mW"] for part in PARTS]
            self.assertLess(loss["total_loss_error_mW"], sum(errors) + 1e-6 * total)
            self.assertGreater(loss["total_loss_error_mW"], math.hypot(*errors) - 1e-6 * total)
            self.assertAlmostEqual(loss["friction_loss_mW"], point["friction_loss_mW"], delta=1e-6 * total)
            self.assertAlmostEqual(loss["friction_loss_error_mW"], point["friction_loss_error_mW"], delta=1e-6 * total)
            self.assertAlmostEqual(power["output_power_mW"], point["output_power_mW"], delta=1e-6 * total)
            self.assertAlmostEqual(power["input_power_mW"], total + power["output_power_mW"], delta=1e-6 * total)
            self.assertAlmostEqual(power["efficiency"], power["output_power_mW"] / power["input_power_mW"], places=9)
            self.assertTrue(0 <= power["efficiency"] < 1)
        # Between no load and stall the motor does work.
        self.assertGreater(efficiency[1]["efficiency"], 0.1)

    def test_the_loss_density_adds_up(self):
        losses, _, _ = self.results("Output/VTU = true")
        path = self.case / "losses" / "loss_density.vtu"
        # Quadratic cells, corners first, then edges, faces and the inside; Simpson's rule.
        nodes = vtu_array(path, "connectivity", np.int32).reshape(-1, 27)
        points = vtu_array(path, "").reshape(-1, 3).astype(float)[nodes]
        density = vtu_array(path, "loss_density").astype(float)[nodes]
        weights = np.repeat((1., 4., 16., 64.), (8, 12, 6, 1)) / 216
        along = [points[:, ends].mean(axis=1) - points[:, starts].mean(axis=1) for starts, ends in
                 (((0, 3, 4, 7), (1, 2, 5, 6)), ((0, 1, 4, 5), (3, 2, 7, 6)), ((0, 1, 2, 3), (4, 5, 6, 7)))]
        volumes = np.einsum("ci,ci->c", along[0], np.cross(along[1], along[2]))
        self.assertGreater(volumes.min(), 0)
        found = 1e3 * (volumes * (density @ weights)).sum()
        expected = losses[0]["internal_loss_stator_metal_mW"] + losses[0]["internal_loss_piezoceramic_mW"]
        self.assertAlmostEqual(found, expected, delta=0.03 * expected)

    def test_the_wave_loses_twice_omega_times_its_energy(self):
        losses, _, _ = self.results("Materials/Stator metal/Loss factor = 0.003",
                                    "Materials/Piezoceramic/Loss factor = 0.004")
        with h5py.File(self.case / "stator" / "modes.h5") as file:
            shape = file["wave/shape"].attrs
            twice_omega = 2 * file["wave"].attrs["angular_frequency_rad_per_s"]
            metal = shape["strain_energy_base"] + shape["strain_energy_tooth"]
            piezoceramic = shape["strain_energy_piezoceramic"]
        for loss in losses:
            self.assertAlmostEqual(loss["internal_loss_stator_metal_mW"], 1e3 * 0.003 * twice_omega * metal, places=6)
            self.assertAlmostEqual(loss["internal_loss_piezoceramic_mW"], 1e3 * 0.004 * twice_omega * piezoceramic,
                                   places=6)

    def test_each_loss_factor_scales_its_part(self):
        before, _, _ = self.results()
        after, _, _ = self.results("Materials/Rotor metal/Loss factor = 0.002", "Support/Felt loss factor = 0.15",
                                   "Materials/Piezoceramic/Loss factor = 0")
        for old, new in zip(before, after):
            self.assertAlmostEqual(new["internal_loss_rotor_mW"], 2 * old["internal_loss_rotor_mW"], places=9)
            self.assertAlmostEqual(new["support_loss_mW"], 0.5 * old["support_loss_mW"], places=9)
            self.assertEqual(new["internal_loss_piezoceramic_mW"], 0)
            self.assertEqual(new["friction_loss_mW"], old["friction_loss_mW"])

    def test_results_of_other_parameters_are_refused(self):
        self.assertIn("Loading/Preload = 14 there, 12 here", self.refused("Loading/Preload = 12"))
        self.assertIn("Friction/Dynamic coefficient", self.refused("Friction/Dynamic coefficient = 0.35"))
        self.assertIn("Wave/Amplitude", self.refused("Wave/Amplitude = 1e-6"))
        self.assertIn("Support/Felt outer radius", self.refused("Support/Felt outer radius = 0.029"))
        self.assertIn("--study", run(LOSSES, STATIC_ROTOR, "--output", self.case, "--study").stderr)

    def test_files_that_are_missing_or_damaged(self):
        for file in (self.case / "contact" / "contact.h5", self.case / "stator" / "modes.h5"):
            content = file.read_bytes()
            try:
                file.write_bytes(content[:len(content) // 2])
                self.assertIn(file.name, self.refused())
                file.unlink()
                self.assertIn("does not exist", self.refused())
            finally:
                file.write_bytes(content)

    def losses_with(self, change):
        """What losses says of contact.h5 in which the attributes of a point are changed."""
        path = self.case / "contact" / "contact.h5"
        content = path.read_bytes()
        with h5py.File(path, "a") as file:
            change(file["points/001"].attrs)
        try:
            done = self.losses()
        finally:
            path.write_bytes(content)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        return done

    def test_power_that_is_missing_is_not_certified(self):
        """The balance is that of the powers in contact.h5: of wrong ones it does not follow, nor hold."""
        def imbalance_of(point):
            rest = (point["input_power_W"] - point["output_work_W"] - point["friction_loss_W"] - point["stored_power_W"] -
                    point["modal_power_W"])
            return abs(rest) / max(point["friction_loss_W"], point["exchanged_power_W"])

        for name in ("input_power_W", "output_work_W", "stored_power_W", "tangential_loss_W", "radial_loss_W"):
            def change(point, name=name):
                point[name] += 1e-2 * point["exchanged_power_W"]

            def change_all(point, name=name):
                self.assertAlmostEqual(imbalance_of(point) / point["power_imbalance"], 1, places=6)
                change(point)
                point["friction_loss_W"] = point["tangential_loss_W"] + point["radial_loss_W"]
                point["radial_loss_share"] = point["radial_loss_W"] / point["friction_loss_W"]
                point["power_imbalance"] = imbalance_of(point)

            done = self.losses_with(change)
            self.assertEqual(done.returncode, 1, name + done.stdout)
            self.assertIn("does not follow from the other numbers", done.stderr)
            done = self.losses_with(change_all)
            self.assertEqual(done.returncode, 2, name + done.stdout)
            for said in ("power put into the contact", "allowed: at most 1.0e-03", "a larger Time/Snapshots or a smaller "
                         "Accuracy/Contact target"):
                self.assertIn(said, done.stderr)

    def test_a_felt_beside_the_stator_is_warned_of(self):
        done = self.losses("Support/Felt inner radius = 0.028")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("warning: the felt", done.stdout)


class Powers(WithWave):
    """The powers of a point, from forces and motions in contact.h5 (doc/theory.md, section 9)."""

    stator = STATOR

    def powers(self, file, point, steps):
        """Input, output, friction loss along and across the ring (W), the means over steps that are numbered as the
        moments at their ends. In the steady state a tooth that was nowhere earlier was another one."""
        n_all, n_waves = file.attrs["n_teeth"], file.attrs["n_waves"]
        omega = file.attrs["angular_frequency_rad_per_s"]
        dt, speed = point.attrs["time_step_s"], point.attrs["speed_rad_per_s"]
        force, slip, times = (point[name][()] for name in ("force", "gap_and_slip", "time"))
        n_moments, n_teeth = force.shape[:2]
        fold = np.gcd(n_waves, n_all)
        n_repeats = n_all // n_teeth
        s = next(s for s in range(n_teeth) if (n_waves * s - fold) % n_all == 0)
        amplitude = file["nodes/free_motion"][..., 0] + 1j * file["nodes/free_motion"][..., 1]
        tooth = np.arange(n_teeth)[:, None, None]

        def free_motion(time):
            return (amplitude * np.exp(1j * (omega * time - n_waves * tooth * 2 * np.pi / n_all))).real

        found = np.zeros(4)
        for m in steps:
            before = force[m - 1] if m > 0 else np.roll(force[-1], -s, axis=0)
            mean = 0.5 * (force[m] + before)
            put_in = mean * (free_motion(times[m]) - free_motion(times[m] - dt))
            torque = (mean[..., 1] * file["nodes/radius"][()]).sum()
            found += np.array([put_in.sum() / dt, torque * speed, -(mean * slip[m])[..., 1].sum() / dt,
                               -(mean * slip[m])[..., 2].sum() / dt]) * n_repeats / len(steps)
        return found

    def check(self, *entries, steps=None, case=None):
        """@param steps of which the point is the mean; all by default"""
        case = case or self.case
        done = run(CONTACT, STATIC_ROTOR, "--output", case,
                   *settings("Output/VTU = false", "Accuracy/Mode = fixed", "Accuracy/Interface refinement = 1", *entries))
        self.assertEqual(done.returncode, 0, done.stderr)
        with h5py.File(case / "contact" / "contact.h5") as file:
            for point in file["points"].values():
                kept = point.attrs
                found = self.powers(file, point, range(len(point["time"])) if steps is None else steps)
                names = ("input_power_W", "output_work_W", "tangential_loss_W", "radial_loss_W")
                for name, power in zip(names, found):
                    self.assertAlmostEqual(power, kept[name], delta=1e-9 * kept["input_power_W"], msg=name)
                rest = found[0] - found[1:].sum() - kept["stored_power_W"]
                largest = max(found[2:].sum(), kept["exchanged_power_W"])
                self.assertAlmostEqual(abs(rest) / largest, kept["power_imbalance"], delta=1e-9)
                self.assertAlmostEqual(rest, kept["closing_work_W"], delta=1e-7 * largest)
                self.assertLess(abs(rest), 1e-3 * largest)
                yield point

    def test_steady_state(self):
        for point in self.check("Loading/Values = 0.05, 0.1", "Time/Snapshots = 2"):
            self.assertEqual(point.attrs["stored_power_W"], 0.0)
            # The teeth themselves do the same work: what they store comes back.
            force, moved, dt = point["force"][()], point["tooth"][()], point.attrs["time_step_s"]
            put_in = 0.0
            for m in range(len(force)):
                before, moved_before = ((force[m - 1], moved[m - 1]) if m > 0 else
                                        (np.roll(force[-1], -13, axis=0), np.roll(moved[-1], -13, axis=0)))
                put_in += (0.5 * (force[m] + before) * (moved[m] - moved_before)).sum() / dt / len(force)
            self.assertAlmostEqual(put_in, point.attrs["input_power_W"], delta=1e-9 * put_in)

    def test_a_part_that_repeats_itself(self):
        """Nine waves on ninety teeth: ten teeth are computed."""
        nine = ("Motor/Number of waves = 9", "Modes/Nodal diameters = 9")
        with tempfile.TemporaryDirectory() as folder:
            case = pathlib.Path(folder)
            done = run(STATOR, STATIC_ROTOR, "--output", case, *settings(*nine))
            self.assertEqual(done.returncode, 0, done.stderr)
            for point in self.check("Loading/Values = 0.1", "Time/Snapshots = 12", *nine, case=case):
                self.assertEqual(point["force"].shape[1], 10)

    def test_some_steps_of_a_warped_motor(self):
        fifteen = ("Time/Number of steps = 15", "Time/Average from step = 6", "Time/Average to step = 15")
        for point in self.check("Loading/Control = speed", "Loading/Values = 7", "Initial deformation/Amplitude = 4e-6",
                                *fifteen, steps=range(5, 15)):
            self.assertGreater(abs(point.attrs["stored_power_W"]), 1e-4 * point.attrs["input_power_W"])


if __name__ == "__main__":
    unittest.main()
