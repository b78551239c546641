#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""prm/ring60.prm from its modes to its efficiency, coarsely.

Usage: tests/programs/second_motor.py STATOR CONTACT LOSSES [unittest arguments]

What is compared: the frequency with that of a ring of beams (Timoshenko's, with twist); forces with the loads; stall with
Coulomb's law; speed with that of the crests; powers with each other.
"""
import math
import pathlib
import shutil
import sys
import tempfile
import unittest

import h5py
import numpy as np

sys.dont_write_bytecode = True  # a test leaves nothing in the source tree
from program import ROOT, rows_of, run, settings  # noqa: E402

PROGRAMS = [sys.argv.pop(1) for _ in range(3)]
MOTOR = ROOT / "prm" / "ring60.prm"
COARSE = ("Accuracy/Mode = fixed", "Accuracy/Polynomial degree = 2", "Accuracy/Interface refinement = 1",
          "Time/Snapshots = 4", "Loading/Number of curve points = 3", "Output/VTU = false")
N_WAVES, N_TEETH, PRELOAD, FRICTION = 9, 90, 160.0, 0.25
LIP = 0.0237, 0.0249
TEETH_THAT_DIFFER = 10  # 90 over the greatest common divisor


def frequency_of_a_ring_of_beams():
    """Base and ceramic bend, shear and twist as one curved beam; teeth only have mass. Hz"""
    inner, outer, tip, base, tooth, slot, ceramic = 0.0210, 0.0262, 0.0249, 0.00188, 0.0016, 0.0005, 0.0005
    root = outer + (tip - outer) * base / (base + tooth)
    radius = (inner + (outer + root) / 2) / 2
    tooth_width = (root + tip) / 2 - inner
    filled = 1 - N_TEETH * slot / (2 * math.pi * (inner + tooth_width / 2))
    # width, height, middle, Young modulus, shear modulus, density, share along the ring
    parts = [((outer + root) / 2 - inner, base, base / 2, 112e9, 112e9 / 2.66, 8825, 1.0),
             (outer - inner, ceramic, -ceramic / 2, 81e9, 81e9 / 2.62, 7600, 1.0),
             (tooth_width, tooth, base + tooth / 2, 0.0, 0.0, 8825, filled)]
    neutral = sum(e * b * h * z for b, h, z, e, _, _, _ in parts) / sum(e * b * h for b, h, _, e, _, _, _ in parts)

    def about_neutral(b, h, z):
        return b * h**3 / 12 + b * h * (z - neutral)**2
    bending = sum(e * about_neutral(b, h, z) for b, h, z, e, _, _, _ in parts)
    shear = 5 / 6 * sum(g * b * h for b, h, _, _, g, _, _ in parts)
    b, h = parts[0][0], base + ceramic
    twist = (parts[0][4] * base + parts[1][4] * ceramic) / h * b * h**3 * (1 / 3 - 0.21 * h / b * (1 - (h / b)**4 / 12))
    mass = sum(rho * share * b * h for b, h, _, _, _, rho, share in parts)
    rotary = sum(rho * share * about_neutral(b, h, z) for b, h, z, _, _, rho, share in parts)
    across = sum(rho * share * h * b**3 / 12 for b, h, _, _, _, rho, share in parts)
    # Unknowns: deflection, twist, slope of the cross-section
    n = N_WAVES
    stiffness = (bending * np.outer(*2 * [[0, 1 / radius, n / radius]]) +
                 twist * np.outer(*2 * [[0, n / radius, 1 / radius]]) + shear * np.outer(*2 * [[n / radius, 0, -1]]))
    squares = np.linalg.eigvals(np.linalg.solve(np.diag([mass, rotary + across, rotary]), stiffness)).real
    return math.sqrt(squares.min()) / (2 * math.pi)


class SecondMotor(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.case = pathlib.Path(tempfile.mkdtemp())
        for program in PROGRAMS:
            done = run(program, MOTOR, "--output", cls.case, *settings(*COARSE))
            assert done.returncode == 0, done.stdout + done.stderr
        cls.curve = rows_of(cls.case / "contact" / "torque_speed.csv")
        with h5py.File(cls.case / "stator" / "modes.h5") as file:
            cls.omega = file["wave"].attrs["angular_frequency_rad_per_s"]

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.case)

    def test_the_frequency_is_about_that_of_a_ring_of_beams(self):
        frequency = self.omega / (2 * math.pi)
        # The feet of the teeth stiffen the base, which the beams do not know.
        self.assertGreater(frequency, frequency_of_a_ring_of_beams())
        self.assertLess(frequency, 1.07 * frequency_of_a_ring_of_beams())

    def test_a_ninth_of_the_ring_carries_a_ninth_of_the_loads(self):
        with h5py.File(self.case / "contact" / "contact.h5") as file:
            radius = file["nodes/radius"][()]
            for number, row in enumerate(self.curve):
                force = file[f"points/{number:03d}/force"][()]
                self.assertEqual(force.shape[:2], (4, TEETH_THAT_DIFFER))
                for moment in force:
                    self.assertAlmostEqual(N_WAVES * moment[..., 0].sum(), PRELOAD, delta=1e-8 * PRELOAD)
                torque = N_WAVES * (force[..., 1] * radius).sum() / len(force)
                self.assertAlmostEqual(1e3 * torque, float(row["torque_mNm"]), delta=1e-5)

    def test_part_of_the_wave_touches_and_part_of_that_sticks(self):
        with h5py.File(self.case / "contact" / "contact.h5") as file:
            for number in range(2):
                status = file[f"points/{number:03d}/status"][()]
                self.assertTrue(0.1 < (status > 0).mean() < 0.5, (status > 0).mean())
                self.assertGreater((status == 1).sum(), 0)
                self.assertGreater((status == 2).sum(), 0)

    def test_stall_is_what_friction_can_hold(self):
        stall = 1e-3 * float(self.curve[2]["torque_mNm"])
        self.assertLess(stall, FRICTION * PRELOAD * LIP[1])
        self.assertGreater(stall, 0.95 * FRICTION * PRELOAD * LIP[0])  # some points still stick

    def test_the_rotor_is_slower_than_the_crests(self):
        with h5py.File(self.case / "stator" / "modes.h5") as file:
            along = file["wave"].attrs["amplitude_m"] * file["wave/shape"].attrs["A_t/A_n"]
        crest = self.omega * along / LIP[0] * 30 / math.pi
        speeds = [float(row["speed_rpm"]) for row in self.curve]
        self.assertTrue(0.5 * crest < speeds[0] < crest, (speeds, crest))
        self.assertTrue(speeds[0] > speeds[1] > speeds[2] == 0.0, speeds)

    def test_powers_balance(self):
        """What the teeth give, force times motion summed over a period, is output and friction."""
        def one_step_earlier(field):  # a tooth was a step ago, at the first moment, where the next one was at the last
            return np.concatenate([np.roll(field[-1], -1, axis=0)[None], field[:-1]])
        efficiency = rows_of(self.case / "losses" / "efficiency.csv")
        with h5py.File(self.case / "contact" / "contact.h5") as file:
            for number, (row, power) in enumerate(zip(self.curve, efficiency)):
                point = file[f"points/{number:03d}"]
                force, tooth = point["force"][()], point["tooth"][()]
                mean_force = (force + one_step_earlier(force)) / 2
                given = 1e3 * N_WAVES * (mean_force * (tooth - one_step_earlier(tooth))).sum() / (
                    len(force) * point.attrs["time_step_s"])
                output = float(row["torque_mNm"]) * float(row["speed_rpm"]) * math.pi / 30
                self.assertAlmostEqual(output + float(row["friction_loss_mW"]), given, delta=0.03 * given)
                share = float(power["efficiency"])
                # Losses inside the bodies come on top.
                self.assertTrue(0.3 < share < output / given if number == 1 else abs(share) < 1e-12, share)


if __name__ == "__main__":
    unittest.main()
