#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Many motors at once: sweeps, samples, optima, solutions, comparisons, as their user meets them.

Usage: tests/programs/sweep.py STATOR CONTACT LOSSES Table|Search|Mistakes

What is compared: rows of the table with runs of the programs by hand; optima and solutions with what follows from monotony.
"""
import json
import math
import os
import shutil
import signal
import subprocess
import sys
import time
import unittest

sys.dont_write_bytecode = True  # a test leaves nothing in the source tree
from program import STATIC_ROTOR, rows_of, run, settings  # noqa: E402
from sweep_folder import COARSE, COMPARE, PROGRAMS, SWEEP, TWO_BY_TWO, InAFolder, command  # noqa: E402  (finds the scripts)
import h5py  # noqa: E402
from motors.goals import limit  # noqa: E402
from motor_task import without_launcher  # noqa: E402

SUITE = sys.argv.pop(1)


@unittest.skipUnless(SUITE == "Table", "another suite")
class Table(InAFolder):
    def rows(self):
        return rows_of(self.output / "table.csv")

    def test_has_what_runs_by_hand_give(self):
        said = self.sweep(*TWO_BY_TWO)
        self.assertIn("4 certified", said)
        rows = self.rows()
        self.assertEqual([(row["Loading/Preload"], row["Friction/Dynamic coefficient"]) for row in rows],
                         [("10", "0.3"), ("10", "0.4"), ("14", "0.3"), ("14", "0.4")])
        case = self.folder / "by_hand"
        for program in PROGRAMS:
            done = run(program, STATIC_ROTOR, "--output", case, *settings(*COARSE, "Loading/Preload = 10", "Output/VTU = false",
                                                                   "Friction/Dynamic coefficient = 0.4"))
            self.assertEqual(done.returncode, 0, done.stderr)
        [curve], [efficiency] = rows_of(case / "contact" / "torque_speed.csv"), rows_of(case / "losses" / "efficiency.csv")
        for column, value in (("speed_rpm at 0.05", curve["speed_rpm"]), ("speed_error_rpm at 0.05", curve["speed_error_rpm"]),
                              ("friction_loss_mW at 0.05", curve["friction_loss_mW"]),
                              ("efficiency at 0.05", efficiency["efficiency"])):
            self.assertAlmostEqual(float(rows[1][column]) / float(value), 1, 9, column)
        self.assertEqual(len({row["frequency_Hz"] for row in rows}), 1)  # neither entry concerns the wave
        self.assertEqual(len(list((self.output / "waves").iterdir())), 1)
        with h5py.File(self.output / "table.h5") as file:
            self.assertEqual(list(file["inputs/Loading: Preload"]), [10, 10, 14, 14])
            self.assertEqual(file["values/speed at 0.05"].attrs["unit"], "rpm")
            self.assertEqual(list(file["values/speed at 0.05"]), [float(row["speed_rpm at 0.05"]) for row in rows])
        self.assertTrue((self.output / "figures" / "quantities.svg").exists())

    def test_has_a_row_for_each_motor_though_some_are_the_same(self):
        said = self.sweep("--wave-only", "--vary", "Wave/Amplitude = 1e-6, 1.0e-6", "--vary", "Motor/Name = a, b")
        self.assertIn("4 certified", said)
        self.assertEqual(len(list((self.output / "waves").iterdir())), 1)
        rows = self.rows()
        self.assertEqual([row["Motor/Name"] for row in rows], ["a", "b"] * 2)
        self.assertEqual(len({row["frequency_Hz"] for row in rows}), 1)

    def test_has_the_words_of_motors_that_are_refused(self):
        said = self.sweep("--vary", "Stator/Slot width = 0.6e-3, 3e-3")
        self.assertIn("1 certified, 1 refused", said)
        self.assertIn("stator: ", self.rows()[1]["message"])
        self.assertIn("Stator/Slot width", self.rows()[1]["message"])
        self.assertEqual(self.rows()[1]["frequency_Hz"], "")

    def finished(self):
        """When each motor was computed, by its folder."""
        return {path.parent.name: path.stat().st_mtime_ns for path in self.output.glob("motors/*/motor.json")}

    def test_is_completed_after_a_kill_and_computes_nothing_twice(self):
        options = ("--output", self.output, "--vary", "Loading/Preload = 8:14:6")
        started = subprocess.Popen([str(word) for word in command(*options)], stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL, start_new_session=True)
        until = time.monotonic() + 120
        while len(self.finished()) < 2 and time.monotonic() < until:
            time.sleep(0.05)
        os.kill(started.pid, signal.SIGKILL)
        started.wait()
        time.sleep(1)  # workers end by themselves
        before = self.finished()
        self.assertTrue(2 <= len(before) < 6, before)
        self.assertIn(f"{len(before)} motors are known already", self.sweep(*options[2:]))
        after = self.finished()
        self.assertEqual(len(after), 6)
        self.assertEqual({name: after[name] for name in before}, before)
        self.assertIn("6 motors are known already", self.sweep(*options[2:]))
        self.assertEqual(self.finished(), after)

    def test_is_the_same_by_workers_that_were_started_by_hand(self):
        self.sweep(*TWO_BY_TWO)
        expected = [{key: value for key, value in row.items() if key not in ("seconds", "wave_seconds", "folder")}
                    for row in self.rows()]
        shutil.rmtree(self.output)
        address = self.folder / "address.json"
        quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
        shells = [subprocess.Popen(["dask-scheduler", "--scheduler-file", address, "--port", "0", "--no-dashboard",
                                    "--interface", "lo"], **quiet)]
        try:
            shells += [subprocess.Popen(["dask-worker", "--scheduler-file", address, "--nthreads", "1", "--no-dashboard",
                                         "--local-directory", self.folder / "scratch"], **quiet) for _ in range(2)]
            while not address.exists() or not address.read_text().endswith("\n}"):  # it is being written
                time.sleep(0.1)
            found = json.loads(address.read_text())["address"]
            self.sweep(*TWO_BY_TWO, "--scheduler", found)
        finally:
            for shell in shells:
                shell.terminate()
                shell.wait()
        self.assertEqual([{key: row[key] for key in expected[0]} for row in self.rows()], expected)


@unittest.skipUnless(SUITE == "Search", "another suite")
class Search(InAFolder):
    def frequency(self, thickness):
        done = run(PROGRAMS[0], STATIC_ROTOR, "--output", self.folder / "by_hand", *settings(
            f"Stator/Base thickness = {thickness}", "Output/VTU = false"))
        self.assertEqual(done.returncode, 0, done.stderr)
        summary = json.loads((self.folder / "by_hand" / "stator" / "summary.json").read_text())
        return next(quantity for quantity in summary["quantities"]
                    if quantity["name"] == "frequency" and quantity["family"] == "out-of-plane")

    def test_finds_the_thickness_for_a_frequency(self):
        said = self.sweep("--solve", "Stator/Base thickness = 4e-3:8e-3", "--for", "frequency = 33e3")
        [row] = rows_of(self.output / "table.csv")
        found = self.frequency(row["Stator/Base thickness"])
        self.assertLess(abs(found["value"] - 33e3), found["error"])
        self.assertIn(f"Stator/Base thickness = {row['Stator/Base thickness']} +-", said)

    def test_finds_the_optimum_where_a_limit_is(self):
        # The frequency grows with the thickness, so that the best motor is where the limit is reached.
        said = self.sweep("--vary", "Stator/Base thickness = 4e-3:5e-3", "--maximise", "frequency", "--subject-to",
                          "frequency < 31e3", "--trials", "25")
        self.assertIn("the best of 25 motors", said)
        thickness = said.split("--set 'Stator/Base thickness = ")[1].split("'")[0]
        found = self.frequency(thickness)
        self.assertLess(found["value"] - found["error"], 31e3)
        self.assertGreater(found["value"], 0.99 * 31e3)
        # Started again, it finds the same, and computes nothing.
        before = {path: path.stat().st_mtime_ns for path in self.output.glob("waves/*/wave.json")}
        again = self.sweep("--vary", "Stator/Base thickness = 4e-3:5e-3", "--maximise", "frequency", "--subject-to",
                           "frequency < 31e3", "--trials", "25")
        self.assertIn(f"--set 'Stator/Base thickness = {thickness}'", again)
        self.assertEqual({path: path.stat().st_mtime_ns for path in self.output.glob("waves/*/wave.json")}, before)

    def test_turns_uncertain_inputs_into_bars(self):
        # Frequencies grow with the root of all moduli: the logarithmic slopes of each add up to a half.
        deviation, count = 0.02, 12
        said = self.sweep("--wave-only", "--uncertainty", str(count), *settings(f"Uncertainty/Young moduli = {deviation}"))
        self.assertEqual(len(rows_of(self.output / "table.csv")), 1 + count)
        rows = {row["quantity"]: row for row in rows_of(self.output / "uncertainty.csv")}
        frequency = {name: float(text) for name, text in rows["frequency"].items() if name not in ("quantity", "unit")}
        shares = [frequency[f"share of Materials/{material}/Young modulus"] for material in ("Stator metal", "Piezoceramic")]
        slopes = [math.sqrt(share) * frequency["deviation_of_inputs"] / frequency["value"] / deviation for share in shares]
        self.assertAlmostEqual(sum(slopes), 0.5, delta=0.005)
        self.assertTrue(0.99 < sum(shares) <= 1)  # nearly linear, and nothing else counts
        self.assertRegex(said, r"frequency = [\d.]+ Hz \+- [\d.]+ Hz \(numerical\) \+- [\d.]+ Hz \(inputs, \d+ % of it from Materials/Stator metal")
        self.assertTrue((self.output / "figures" / "uncertainty.svg").exists())

    def test_compares_two_motors(self):
        self.sweep("--vary", "Friction/Dynamic coefficient = 0.3, 0.4")
        rows = rows_of(self.output / "table.csv")
        done = run(COMPARE, *(row["folder"] for row in rows))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"Friction/Dynamic coefficient +0.3 +0.4\n")
        lines = {line.split("  ")[1].strip(): line for line in done.stdout.splitlines() if line.startswith("  ")}
        self.assertTrue(lines["frequency"].endswith(" none"), lines["frequency"])
        loss = [(float(row["friction_loss_mW at 0.05"]), float(row["friction_loss_error_mW at 0.05"])) for row in rows]
        is_real = abs(loss[1][0] - loss[0][0]) > loss[0][1] + loss[1][1]
        self.assertIn(" real" if is_real else " open: ", lines["friction_loss at 0.05"])
        same = run(COMPARE, rows[0]["folder"], rows[0]["folder"])
        self.assertIn("all entries are the same", same.stdout)
        self.assertNotIn(" real", same.stdout)
        self.assertNotIn(" open", same.stdout)


@unittest.skipUnless(SUITE == "Mistakes", "another suite")
class Workers(InAFolder):
    def test_of_a_scheduler_are_waited_for_with_a_word(self):
        address, said = self.folder / "address.json", self.folder / "said"
        quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
        shells = [subprocess.Popen(["dask-scheduler", "--scheduler-file", address, "--port", "0", "--no-dashboard",
                                    "--interface", "lo"], **quiet)]
        try:
            while not address.exists() or not address.read_text().endswith("\n}"):  # it is being written
                time.sleep(0.1)
            found = json.loads(address.read_text())["address"]
            with open(said, "w", encoding="utf-8") as file:
                words = command("--output", self.output, "--wave-only", "--vary", "Wave/Amplitude = 1e-6, 2e-6", "--scheduler",
                                found)
                sweep = subprocess.Popen([str(word) for word in words], stdout=file, stderr=file)
            shells.append(sweep)
            while "waiting for workers" not in said.read_text() and sweep.poll() is None:
                time.sleep(0.1)
            self.assertIn(f"start some with: dask-worker {found}", said.read_text())
            # As srun would start one.
            shells.append(subprocess.Popen(["dask-worker", "--scheduler-file", address, "--nthreads", "1", "--no-dashboard",
                                            "--local-directory", self.folder / "scratch"], **quiet,
                                           env={**os.environ, "PMI_SIZE": "2", "PMI_RANK": "1"}))
            self.assertEqual(sweep.wait(timeout=100), 0, said.read_text())
            self.assertIn("2 certified", said.read_text())
        finally:
            for shell in shells[::-1]:
                shell.terminate()
                shell.wait()

    def test_know_nothing_of_their_launcher(self):
        mine = {"PATH": "/bin", "OMPI_MCA_btl": "self", "OMPI_ALLOW_RUN_AS_ROOT": "1", "SLURM_JOB_ID": "3"}
        self.assertEqual(without_launcher({**mine, "PMI_RANK": "1", "PMIX_RANK": "1", "SLURM_PROCID": "1"}), mine)
        under_mpirun = without_launcher({**mine, "OMPI_COMM_WORLD_SIZE": "1", "OMPI_COMMAND": "x", "PMIX_RANK": "0"})
        self.assertEqual(under_mpirun, {name: text for name, text in mine.items() if name != "OMPI_MCA_btl"})


@unittest.skipUnless(SUITE == "Mistakes", "another suite")
class Mistakes(InAFolder):
    def test_are_told_in_one_line(self):
        for options, words in (
                ([], "no --vary"),
                (["--vary", "Loading/Preload"], 'expected "Section/Entry = value"'),
                (["--vary", "Loading/Preload = 1:x:3"], '"x" is not a number'),
                (["--vary", "Loading/Preload = 3:1:3"], "increasing"),
                (["--vary", "Loading/Preload = 1:3:1"], "at least 2"),
                (["--vary", "Loading/Preload = -1:3:4:log"], "positive"),
                (["--vary", "Loading/Preload = 1:3"], "without a number of values"),
                (["--vary", "Loading/Preloud = 1, 2"], 'did you mean "Loading/Preload"'),
                (["--set", "Loading/Preloud = 1", "--vary", "Loading/Preload = 1, 2"],
                 '--set "Loading/Preloud = 1": unknown entry'),
                (["--vary", "Loading/Preload = 1:3", "--sample", "sobol=3"], "lhs=COUNT"),
                (["--vary", "Loading/Preload = 1:3", "--maximise", "efficiency >"], "name of a quantity"),
                (["--vary", "Loading/Preload = 1:3", "--maximise", "efficiency at 0.1", "--subject-to", "speed"], "QUANTITY >"),
                (["--vary", "Loading/Preload = 1:3", "--maximise", "efficiency at 0.1", "--subject-to", "stall_torque > 1"],
                 "whole curve"),
                (["--solve", "Loading/Preload = 1:3"], "--for go together"),
                (["--solve", "Loading/Preload = 1:3", "--for", "frequency"], "QUANTITY = number"),
                (["--solve", "Loading/Preload = 1:3", "--vary", "Loading/Preload = 1, 2", "--for", "frequency = 3"], "--vary"),
                (["--uncertainty", "40"], "no input is uncertain"),
                (["--vary", "Loading/Preload = 1, 2", "--workers", "0"], "--workers: expected a whole number, at least 1"),
                (["--vary", "Loading/Preload = 1, 2", "--workers", "-1"], "--workers: expected a whole number, at least 1"),
                (["--vary", "Loading/Preload = 1, 2", "--workers", "two"], "--workers: expected a whole number, at least 1"),
                (["--vary", "Loading/Preload = 1:2", "--maximise", "frequency", "--trials", "0"], "--trials: expected"),
                (["--vary", "Loading/Preload = 1:2", "--sample", "lhs=4", "--seed", "-1"], "--seed: expected"),
                (["--vary", "Loading/Preload = 1, 2", "--scheduler"], "--scheduler: expected one argument"),
                (["--vary", "Loading/Preload = 1, 2", "--nonsense"], "unrecognized arguments: --nonsense"),
                (["--vary", "Loading/Preload = 1, 2", *settings("Loading/Preload = -1")], "Loading/Preload"),
                (["--vary", "Loading/Preload = 1, 2", *settings("Modes/Body = rotor")], "Modes/Body = rotor has no wave"),
                (["--uncertainty", "1"], "at least 4"),
                (["--uncertainty", "40", "--vary", "Loading/Preload = 1, 2"], "leave out --vary"),
                (["--vary", "Loading/Preload = 1, 2", "--scheduler", "tcp://127.0.0.1:9"], "does not answer")):
            with self.subTest(options):
                self.assertIn(words, self.refused(*options))

    def test_a_file_that_is_not_there(self):
        done = run(SWEEP, self.folder / "nothing.prm", "--programs", PROGRAMS[0].parent, *TWO_BY_TWO)
        self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1), done.stderr)
        self.assertIn("nothing.prm: no such parameter file", done.stderr)
        os.mkfifo(self.folder / "pipe.prm")
        done = run(SWEEP, self.folder / "pipe.prm", "--programs", PROGRAMS[0].parent, *TWO_BY_TWO)
        self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1), done.stderr)
        self.assertIn("is a pipe", done.stderr)
        done = run(SWEEP, STATIC_ROTOR, "--programs", self.folder, *TWO_BY_TWO)
        self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1), done.stderr)
        self.assertIn("scripts/setup.sh", done.stderr)

    def test_quantities_that_no_motor_has(self):
        done = run(*command("--output", self.output, "--vary", "Stator/Base thickness = 4e-3:5e-3", "--maximise", "frequncy",
                            "--trials", "2"))
        self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1), done.stderr)
        self.assertIn("there are: frequency", done.stderr)


if __name__ == "__main__":
    unittest.main()
