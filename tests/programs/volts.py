#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A motor with piezoelectric coupling as its user meets it: circuits, voltages, messages.

Usage: tests/programs/volts.py STATOR CONTACT LOSSES [unittest arguments]

What is compared: files with each other; the numbers of a circuit with its admittance; voltages and currents with
those that follow by hand from the powers of the other files.
"""
import json
import math
import pathlib
import shutil
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True  # a test leaves nothing in the source tree
from program import STATIC_ROTOR, rows_of, run, settings, vtu_array  # noqa: E402

STATOR, CONTACT, LOSSES = sys.argv.pop(1), sys.argv.pop(1), sys.argv.pop(1)
USUAL_LOSSES = settings("Effects/Piezoelectric coupling = on", "Output/VTU = false")
COUPLED = USUAL_LOSSES + settings("Materials/Stator metal/Loss factor = 3e-3",
                                  "Materials/Piezoceramic/Loss factor = 7e-3")

FIXED = ("Accuracy/Mode = fixed", "Accuracy/Interface refinement = 0", "Time/Snapshots = 8")


def numbers(path):
    """Rows as dict; texts stay texts."""
    def number(text):
        try:
            return float(text)
        except ValueError:
            return text
    return [{key: number(value) for key, value in row.items()} for row in rows_of(path)]


class Volts(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.case = pathlib.Path(tempfile.mkdtemp())
        for program in (STATOR, CONTACT, LOSSES):
            done = run(program, STATIC_ROTOR, "--output", cls.case, *COUPLED)
            assert done.returncode == 0, done.stderr
        cls.circuit = {row["phase"]: row for row in numbers(cls.case / "stator" / "circuits.csv")}

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.case)

    def test_circuits_are_consistent(self):
        summary = json.loads((self.case / "stator" / "summary.json").read_text())
        for phase, row in self.circuit.items():
            omega = 2 * math.pi * row["short_circuit_frequency_Hz"]
            lm, cm, c0 = row["Lm_H"], 1e-12 * row["Cm_pF"], 1e-9 * row["C0_nF"]
            self.assertAlmostEqual(omega**2 * lm * cm, 1, delta=1e-9)
            self.assertAlmostEqual(omega * lm / row["Rm_ohm"] / row["Q"], 1, delta=1e-9)
            self.assertAlmostEqual(row["k_eff^2"], cm / (c0 + cm), delta=1e-9)
            self.assertAlmostEqual((row["short_circuit_frequency_Hz"] / row["open_circuit_frequency_Hz"])**2,
                                   1 - row["k_eff^2"], delta=1e-9)
            found = {quantity["name"]: quantity for quantity in summary["quantities"] if quantity.get("phase") == phase}
            self.assertEqual(found["C0"]["value"], c0)
            for quantity in found.values():
                self.assertGreater(quantity["error"], 0)
                self.assertLess(quantity["error"], 0.05 * quantity["value"], quantity["name"])
                self.assertAlmostEqual(math.hypot(*quantity["error_causes"].values()), quantity["error"],
                                       delta=1e-9 * quantity["error"])

    def test_quality(self):
        """Stored energy, twice the strain energy of the wave, over what is lost per radian, by the file of losses."""
        summary = json.loads((self.case / "stator" / "summary.json").read_text())
        energy = next(quantity["value"] for quantity in summary["quantities"] if quantity["name"] == "strain_energy")
        lost = 1e-3 * numbers(self.case / "losses" / "losses.csv")[0]["internal_loss_stator_mW"]
        omega = 2 * math.pi * self.circuit["A"]["short_circuit_frequency_Hz"]
        self.assertAlmostEqual(2 * energy * omega / lost / self.circuit["A"]["Q"], 1, delta=5e-3)

    def test_admittance_is_that_of_the_circuit(self):
        rows = numbers(self.case / "stator" / "admittance.csv")
        peak = max(rows, key=lambda row: row["conductance_A_S"])
        row = self.circuit["A"]
        self.assertAlmostEqual(peak["frequency_Hz"], row["short_circuit_frequency_Hz"],
                               delta=1e-4 * peak["frequency_Hz"])
        lost = 2 * math.pi * peak["frequency_Hz"] * 1e-9 * row["C0_nF"] * 0.004  # dielectric loss of C0
        self.assertAlmostEqual((peak["conductance_A_S"] - lost) * row["Rm_ohm"], 1, delta=5e-3)

    def test_electrodes(self):
        arcs = numbers(self.case / "stator" / "electrodes.csv")
        self.assertEqual([sum(arc["phase"] == phase for arc in arcs) for phase in "AB"], [6, 6])
        self.assertEqual([arc["poling"] for arc in arcs[:3]], ["up", "down", "up"])
        excitation = numbers(self.case / "stator" / "excitation.csv")
        self.assertEqual(max(excitation, key=lambda row: row["phase_A"])["n"], 7)
        self.assertAlmostEqual(excitation[7]["phase_A"], 12 / (7 * math.pi), delta=0.01)

    def rows_of_losses(self):
        return zip(*(numbers(self.case / "losses" / name) for name in ("drive.csv", "losses.csv", "efficiency.csv")))

    def test_power_from_the_plug(self):
        for drive, losses, efficiency in self.rows_of_losses():
            self.assertAlmostEqual(drive["voltage_V"] * drive["current_mA"] * drive["power_factor"],
                                   drive["electrical_input_mW"], delta=1e-6 * drive["electrical_input_mW"])
            used = efficiency["output_power_mW"] + losses["total_loss_mW"] + drive["dielectric_loss_mW"]
            self.assertAlmostEqual(drive["electrical_input_mW"] / used, 1, delta=1e-3)
            self.assertAlmostEqual(drive["electrical_efficiency"] * drive["electrical_input_mW"],
                                   max(0, efficiency["output_power_mW"]), delta=1e-6)
        summary = json.loads((self.case / "losses" / "summary.json").read_text())
        self.assertTrue(summary["certificate"]["holds"])
        for quantity in summary["quantities"]:
            if "error" in quantity:
                self.assertAlmostEqual(math.hypot(*quantity["error_causes"].values()), quantity["error"],
                                       delta=1e-9 + 1e-6 * quantity["error"], msg=quantity["name"])

    def test_voltage_at_resonance(self):
        force_factor = self.circuit["A"]["force_factor_N_per_V"]
        for drive, _, efficiency in self.rows_of_losses():
            omega_a = 2 * math.pi * drive["drive_frequency_Hz"] * 2e-6
            by_hand = 1e-3 * efficiency["input_power_mW"] / omega_a / force_factor
            self.assertAlmostEqual(drive["voltage_V"] / by_hand, 1, delta=5e-3)
            c0 = 1e-9 * self.circuit["A"]["C0_nF"]
            current = math.hypot(force_factor * omega_a, 2 * math.pi * drive["drive_frequency_Hz"] * c0 * by_hand)
            self.assertAlmostEqual(1e-3 * drive["current_mA"] / current, 1, delta=5e-3)

    def test_voltage_beside_the_resonance(self):
        """One percent above the natural frequency inertia needs most of the force."""
        with tempfile.TemporaryDirectory() as scratch:
            frequency = f"Wave/Frequency = {1.01 * self.circuit['A']['short_circuit_frequency_Hz']}"
            for program in (STATOR, CONTACT, LOSSES):
                done = run(program, STATIC_ROTOR, "--output", scratch, *COUPLED, *settings(frequency))
                self.assertEqual(done.returncode, 0, done.stderr)
            row = self.circuit["A"]
            mass = row["Lm_H"] * row["force_factor_N_per_V"]**2
            for drive, near in zip(numbers(pathlib.Path(scratch) / "losses" / "drive.csv"),
                                   numbers(self.case / "losses" / "drive.csv")):
                squares = [(2 * math.pi * point["drive_frequency_Hz"])**2 for point in (drive, near)]
                inertia = mass * (squares[0] - squares[1]) * 2e-6 / row["force_factor_N_per_V"]
                self.assertAlmostEqual(drive["voltage_V"] / math.hypot(inertia, near["voltage_V"]), 1, delta=0.03)
                self.assertLess(drive["power_factor"], near["power_factor"])

    def test_amplitude_from_the_voltage(self):
        """The voltage that an amplitude needs gives that amplitude, from whatever amplitude the search begins."""
        for change in ("Wave/Frequency = mode", "Effects/Damping = on",
                       f"Wave/Frequency = {1.01 * self.circuit['A']['short_circuit_frequency_Hz']}"):
            common = ("Loading/Values = 0.1", change, *FIXED)
            (given,), _ = self.drive_with(*common)
            for amplitude in (1e-6, 3e-6):
                (found,), _ = self.drive_with("Wave/Drive = voltage", f"Wave/Voltage = {given['voltage_V']:.15g}",
                                              f"Wave/Amplitude = {amplitude}", *common)
                for name in ("amplitude_um", "speed_rpm", "drive_frequency_Hz", "current_mA", "electrical_input_mW"):
                    self.assertAlmostEqual(found[name] / given[name], 1, delta=1e-3, msg=name)
                self.assertAlmostEqual(found["voltage_V"], given["voltage_V"], delta=1e-9)
                self.assertEqual(found["voltage_error_V"], 0)
                self.assertGreater(found["amplitude_error_um"], 0)
                self.assertLess(found["amplitude_error_um"], 0.3 * found["amplitude_um"])

    def test_curve_at_a_voltage(self):
        """From no load to stall the wave becomes weaker, and the motor slower than at a given amplitude."""
        rows, _ = self.drive_with("Wave/Drive = voltage", "Wave/Voltage = 40", "Loading/Values = curve",
                                  "Loading/Number of curve points = 3", *FIXED)
        for row, share in zip(rows, (1, 1 / 2, 0)):
            self.assertAlmostEqual(row["speed_rpm"] / rows[0]["speed_rpm"], share, delta=0.01)
        for before, after in zip(rows, rows[1:]):
            self.assertLess(before["torque_mNm"], after["torque_mNm"])
            self.assertGreater(before["amplitude_um"], after["amplitude_um"])
        # The point in the middle asks for that voltage at its amplitude.
        (same,), _ = self.drive_with(f"Wave/Amplitude = {1e-6 * rows[1]['amplitude_um']:.15g}", "Loading/Control = speed",
                                     f"Loading/Values = {math.pi / 30 * rows[1]['speed_rpm']:.15g}", *FIXED)
        self.assertAlmostEqual(same["voltage_V"] / 40, 1, delta=3e-3)

    def test_response_to_the_frequency(self):
        """Found by amplitude; at the frequency of a stable state the search by frequency finds the same state."""
        common = ("Wave/Drive = voltage", "Wave/Voltage = 40", "Loading/Values = 0.1", *FIXED)
        with tempfile.TemporaryDirectory() as scratch:
            for program in (STATOR, CONTACT):
                done = run(program, STATIC_ROTOR, "--output", scratch, *COUPLED,
                           *settings("Wave/Response torques = 0.1", *common))
                self.assertEqual(done.returncode, 0, done.stderr)
            rows = numbers(pathlib.Path(scratch) / "contact" / "response.csv")
            self.assertRegex(done.stdout, r"response to the frequency at 100.00 mN m: largest amplitude .* kHz")
        peak = max(range(len(rows)), key=lambda i: rows[i]["amplitude_um"])
        self.assertEqual([row["state"] for row in rows[peak + 1:]], ["stable"] * (len(rows) - peak - 1))
        state = min(rows[peak:], key=lambda row: abs(row["amplitude_um"] / rows[peak]["amplitude_um"] - 0.7))
        (found,), _ = self.drive_with(f"Wave/Frequency = {state['frequency_Hz']:.12g}", *common)
        self.assertAlmostEqual(found["amplitude_um"] / state["amplitude_um"], 1, delta=0.01)
        self.assertAlmostEqual(found["speed_rpm"], state["speed_rpm"], delta=state["speed_error_rpm"] + 0.5)

    def test_mistakes_of_the_drive(self):
        for entries, words in ((("Wave/Drive = voltage",), ("Wave/Voltage", "none")),
                               (("Wave/Drive = voltage", "Wave/Voltage = 20", "Time/Scheme = marching"), ("steady",)),
                               (("Wave/Drive = voltage", "Wave/Voltage = 1e6"), ("Wave/Voltage", "plausible"))):
            done = run(CONTACT, STATIC_ROTOR, "--output", self.case, *COUPLED, *settings(*entries))
            self.assertEqual((done.returncode, len(done.stderr.splitlines())), (1, 1), done.stderr)
            for word in words:
                self.assertIn(word, done.stderr)
        driven = settings("Wave/Drive = voltage", "Wave/Voltage = 20")
        done = run(CONTACT, STATIC_ROTOR, "--output", self.case, *driven)
        self.assertEqual(done.returncode, 1)
        self.assertIn("Effects/Piezoelectric coupling = on, found off", done.stderr)
        with tempfile.TemporaryDirectory() as scratch:
            options = COUPLED + driven + settings("Electrodes/Distance of phases = 0.5")
            self.assertEqual(run(STATOR, STATIC_ROTOR, "--output", scratch, *options).returncode, 0)
            done = run(CONTACT, STATIC_ROTOR, "--output", scratch, *options)
            self.assertEqual((done.returncode, len(done.stderr.splitlines())), (1, 1), done.stderr)
            self.assertIn("standing", done.stderr)

    def test_torques_near_stall(self):
        """Above what a rotor would bear whose teeth touch at their inner edge alone, but below stall."""
        common = ("Wave/Drive = voltage", "Wave/Voltage = 40", *FIXED)
        rows, _ = self.drive_with("Loading/Values = 0.189", *common)
        self.assertGreater(rows[0]["speed_rpm"], 0)
        for entry in ("Loading/Values", "Wave/Response torques"):
            done = run(CONTACT, STATIC_ROTOR, "--output", self.case, *COUPLED, *settings(f"{entry} = 0.3", *common))
            self.assertEqual((done.returncode, len(done.stderr.splitlines())), (1, 1), done.stderr)
            self.assertIn(f"{entry} = 0.3 N m is beyond the stall", done.stderr)

    def test_losses_of_another_voltage_are_refused(self):
        with tempfile.TemporaryDirectory() as scratch:
            options = COUPLED + settings("Wave/Drive = voltage", "Loading/Values = 0.1", *FIXED)
            for program, voltage, status in ((STATOR, 40, 0), (CONTACT, 40, 0), (LOSSES, 40, 0), (LOSSES, 41, 1)):
                done = run(program, STATIC_ROTOR, "--output", scratch, *options, *settings(f"Wave/Voltage = {voltage}"))
                self.assertEqual(done.returncode, status, done.stderr)
            self.assertIn("Wave/Voltage = 40 there, 41 here", done.stderr)
            felt = settings("Wave/Voltage = 40", "Support/Felt loss factor = 0.2")  # changes the balance of the wave
            done = run(LOSSES, STATIC_ROTOR, "--output", scratch, *options, *felt)
            self.assertEqual(done.returncode, 1)
            self.assertIn("another drive", done.stderr)

    def drive_with(self, *entries, options=COUPLED):
        """Rows of drive.csv, none if there is no such file, and the log of losses."""
        with tempfile.TemporaryDirectory() as scratch:
            for program in (STATOR, CONTACT, LOSSES):
                done = run(program, STATIC_ROTOR, "--output", scratch, *options, *settings(*entries))
                self.assertEqual(done.returncode, 0, done.stderr)
            file = pathlib.Path(scratch) / "losses" / "drive.csv"
            return numbers(file) if file.exists() else None, done.stdout

    def test_rotor_driven_from_outside(self):
        """It may give more power back than the stator loses: errors stay positive, there is no efficiency."""
        rows, _ = self.drive_with("Loading/Control = speed", "Loading/Values = 12", options=USUAL_LOSSES)
        self.assertLess(rows[0]["electrical_input_mW"], 0)
        self.assertEqual(rows[0]["electrical_efficiency"], 0)
        for key, value in rows[0].items():
            if "error" in key:
                self.assertGreaterEqual(value, 0, key)

    def test_phases_that_drive_no_travelling_wave(self):
        rows, log = self.drive_with("Electrodes/Distance of phases = 0.5")
        self.assertIsNone(rows)
        self.assertIn("warning: with Electrodes/Distance of phases = 0.5", log)

    def test_felt_has_no_electric_field(self):
        rows, _ = self.drive_with("Effects/Felt support = on")
        for with_felt, without in zip(rows, numbers(self.case / "losses" / "drive.csv")):
            self.assertAlmostEqual(with_felt["dielectric_loss_mW"] / without["dielectric_loss_mW"], 1, delta=0.03)

    def refused(self, *entries):
        done = run(STATOR, STATIC_ROTOR, "--output", self.case, *COUPLED, *settings(*entries))
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        return done.stderr

    def test_mistakes(self):
        for entries, words in ((("Stator/Piezoceramic element = shell",), ("shell", "no potential", "solid")),
                               (("Stator/Piezoceramic thickness = 0",), ("needs a ceramic",)),
                               (("Electrodes/Arcs of phase A = 12",), ("Electrodes/Arcs of phase A = 12", "7")),
                               (("Electrodes/Gap between arcs = 0.02",), ("Gap between arcs",)),
                               (("Electrodes/Gap between arcs = 0.0001",), ("Gap between arcs", "half of")),
                               (("Piezoelectricity/Coupling 31 = 0", "Piezoelectricity/Coupling 33 = 0"), ("Coupling 33",)),
                               (("Piezoelectricity/Permittivity at = stress", "Piezoelectricity/Permittivity 11 = 6e-9"),
                                ("coupling factor", "Permittivity at")),
                               (("Piezoelectricity/Coupling form = d",), ("Coupling 31", "m/V", "Coupling form = e")),
                               (("Piezoelectricity/Stiffness c33 = 115.4",), ("Stiffness c33", "plausible"))):
            message = self.refused(*entries)
            for word in words:
                self.assertIn(word, message)

    def test_potential_for_paraview(self):
        """Between two grounded electrodes a bent ceramic has a potential inside, which mirror images share."""
        with tempfile.TemporaryDirectory() as scratch:
            done = run(STATOR, STATIC_ROTOR, "--output", scratch, *settings("Effects/Piezoelectric coupling = on"))
            self.assertEqual(done.returncode, 0, done.stderr)
            file = pathlib.Path(scratch) / "stator" / "sector.vtu"
            points = vtu_array(file, "").reshape(-1, 3)
            potential = vtu_array(file, "potential_real")
            inside = (points[:, 2] < -1e-5) & (points[:, 2] > -0.00049)
            self.assertEqual(abs(potential[~inside]).max(), 0)
            self.assertGreater(abs(potential[inside]).max(), 0.1)
            self.assertLess(abs(potential[inside]).max(), 100)
            self.assertAlmostEqual(potential[points[:, 1] > 0].sum() / potential[points[:, 1] < 0].sum(), 1, delta=1e-4)

    def test_off_leaves_nothing_behind(self):
        with tempfile.TemporaryDirectory() as scratch:
            for choice in ("on", "off"):
                done = run(STATOR, STATIC_ROTOR, "--output", scratch, *settings(f"Effects/Piezoelectric coupling = {choice}",
                                                                         "Output/VTU = false"))
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertEqual((pathlib.Path(scratch) / "stator" / "circuits.csv").exists(), choice == "on")

    def test_wave_of_another_ceramic_is_refused(self):
        done = run(CONTACT, STATIC_ROTOR, "--output", self.case, *COUPLED, *settings("Piezoelectricity/Stiffness c11 = 140e9"))
        self.assertEqual(done.returncode, 1)
        self.assertIn("Piezoelectricity/Stiffness c11", done.stderr)


if __name__ == "__main__":
    unittest.main()
