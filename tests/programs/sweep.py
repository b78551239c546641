#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Many motors at once: sweeps, samples, optima, solutions, comparisons, as their user meets them.

Usage: tests/programs/sweep.py Table|Search|Files|Mistakes STATOR CONTACT LOSSES

What is compared: rows of the table with runs of the programs by hand; optima and solutions with what follows from monotony;
fronts with comparison of all pairs.
"""
import json
import math
import os
import pathlib
import random
import shutil
import signal
import sqlite3
import subprocess
import sys
import tempfile
import time
import unittest

sys.dont_write_bytecode = True  # a test leaves nothing in the source tree
from program import QUICK, ROOT, rows_of, run, settings  # noqa: E402

sys.path.insert(0, str(ROOT / "scripts"))
import h5py  # noqa: E402
import motor_task  # noqa: E402
from case import CaseError  # noqa: E402
from goals import limit  # noqa: E402
from many_motors import Family  # noqa: E402
from motor_task import known_outcome, without_launcher  # noqa: E402
from sweep import main  # noqa: E402
from sweep_figures import pareto_front  # noqa: E402
from sweep_table import short_names  # noqa: E402
from uncertainty import motor_of, sample_of, uncertain_inputs  # noqa: E402
from variation import combinations, latin_hypercube, varied  # noqa: E402

SUITE, PROGRAMS = sys.argv.pop(1), [pathlib.Path(sys.argv.pop(1)) for _ in range(3)]
SWEEP, COMPARE = ROOT / "scripts" / "sweep.py", ROOT / "scripts" / "compare.py"
# One operating point, coarse.
COARSE = ("Accuracy/Contact target = 0.2", "Loading/Values = 0.05")
TWO_BY_TWO = ("--vary", "Loading/Preload = 10, 14", "--vary", "Friction/Dynamic coefficient = 0.3:0.4:2")


def command(*options):
    return [SWEEP, QUICK, "--programs", PROGRAMS[0].parent, "--workers", "2", *settings(*COARSE), *options]


class InAFolder(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.output = self.folder / "sweep"

    def tearDown(self):
        shutil.rmtree(self.folder, ignore_errors=True)

    def sweep(self, *options):
        done = run(*command("--output", self.output, *options))
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def refused(self, *options):
        """The line with which a sweep refuses its options, before it has computed anything."""
        with self.assertRaises(CaseError) as caught:
            main([str(word) for word in command("--output", self.output, *options)[1:]])
        self.assertFalse((self.output / "waves").exists())
        self.assertNotIn("\n", str(caught.exception))
        return str(caught.exception)


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
            done = run(program, QUICK, "--output", case, *settings(*COARSE, "Loading/Preload = 10", "Output/VTU = false",
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
            while not address.exists():
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
        done = run(PROGRAMS[0], QUICK, "--output", self.folder / "by_hand", *settings(
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


@unittest.skipUnless(SUITE == "Files", "another suite")
class Files(InAFolder):
    """Parameter files, mesh files, and the small files that a sweep keeps."""

    WAVES = ("--wave-only", "--vary", "Stator/Base thickness = 4.0e-3, 4.2e-3")

    def family(self, prm):
        return Family(prm, {}, self.output, PROGRAMS[0].parent, is_wave_only=True)

    def test_are_read_as_the_programs_read_them(self):
        text = QUICK.read_text()
        plain = self.family(QUICK)
        edits = {
            "a comment behind end": text.replace("\nend\n", "\nend # of it\n"),
            "blanks": text.replace("subsection ", "subsection   ").replace("set ", "   set   "),
            "tabs": text.replace("subsection ", "subsection\t").replace("set ", "set\t").replace(" = ", "\t=\t"),
            "comments behind values": text.replace("= 141e9", "= 141e9 # Invar"),
            "a mark of the byte order": "\ufeff" + text,
            "lines of DOS": text.replace("\n", "\r\n"),
            "a line in two": text.replace("set Young modulus = 141e9", "set Young \\\n modulus = 141e9"),
            "an empty comment": text.replace("= 141e9", "= 141e9#"),
            "comments beyond ASCII": "# Ma\xdfe des L\xe4ufers\n" + text}
        for name, edited in edits.items():
            with self.subTest(name):
                self.assertNotEqual(edited, text)
                path = self.folder / "edited.prm"
                path.write_bytes(edited.encode("utf-8"))
                family = self.family(path)
                self.assertEqual(family.identity, plain.identity)
                self.assertEqual(family.motor({"Wave/Amplitude": "1e-6"}).key, plain.motor({"Wave/Amplitude": "1.0e-6"}).key)

    def watched(self, script, *words):
        """A script that is ended as soon as it, or what it imports, opens a parameter file."""
        hook = ("import os, runpy, sys\n"
                "def look(event, words):\n"
                "    if event == 'open' and str(words[0]).endswith('.prm'):\n"
                "        print('opened', words[0], file=sys.stderr, flush=True)\n"
                "        os._exit(99)\n"
                "sys.addaudithook(look)\n"
                "sys.argv = sys.argv[1:]\n"
                "sys.path.insert(0, os.path.dirname(sys.argv[0]))\n"
                "runpy.run_path(sys.argv[0], run_name='__main__')\n")
        return run("/usr/bin/python3", "-c", hook, script, *words)

    def test_are_not_read_by_scripts(self):
        (self.folder / "reader.py").write_text(f"open({str(QUICK)!r})")
        self.assertEqual(self.watched(self.folder / "reader.py").returncode, 99)
        scripts = ROOT / "scripts"
        case = self.folder / "case"
        for script, *words in ([scripts / "run.py", QUICK, "--output", case, *settings(*COARSE, "Output/VTU = false")],
                               command("--output", self.output, *self.WAVES), [COMPARE, case, case]):
            done = self.watched(script, *words)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
        for name in ("figures", "report", "summary"):
            self.assertEqual(self.watched(scripts / f"{name}.py", case).stderr, "")
        # And none knows the words of such a file.
        for path in [*scripts.iterdir(), *(ROOT / "benchmarks").glob("*.py")]:
            if path.suffix in (".py", ".sh"):
                for word in ("subsection", '["prm"]'):
                    self.assertNotIn(word, path.read_text(encoding="utf-8"), path)

    def mesh_family(self, mesh):
        prm = self.folder / "mesh.prm"
        shutil.copy(ROOT / "prm" / "canon_ring_mesh.prm", prm)
        return Family(prm, {"Stator/Mesh file": str(mesh), "Accuracy/Mode": "fixed", "Accuracy/Polynomial degree": "2"},
                      self.output, PROGRAMS[0].parent, is_wave_only=True)

    def test_a_mesh_file_is_known_by_its_content(self):
        meshes = [ROOT / "meshes" / f"canon_{name}sector.msh" for name in ("half_", "")]
        mesh = self.folder / "sector.msh"
        keys = []
        for source in (meshes[0], meshes[1], meshes[0]):
            shutil.copy(source, mesh)
            motor = self.mesh_family(mesh).motor({"Wave/Amplitude": "1e-6"})
            keys.append(motor.key)
            self.assertEqual(motor.is_known(), len(keys) == 3)
            self.assertEqual(motor_task.find_wave(motor.wave).outcome, "certified")
        self.assertEqual(keys[0], keys[2])
        self.assertNotEqual(keys[0], keys[1])

    def test_one_that_changes_while_motors_are_computed(self):
        mesh = self.folder / "sector.msh"
        shutil.copy(ROOT / "meshes" / "canon_half_sector.msh", mesh)
        family = self.mesh_family(mesh)
        first, second = (family.motor({"Wave/Amplitude": text}) for text in ("1e-6", "2e-6"))
        self.assertEqual(motor_task.find_wave(first.wave).outcome, "certified")
        shutil.copy(ROOT / "meshes" / "canon_sector.msh", mesh)
        self.assertEqual(motor_task.find_wave(second.wave).outcome, "changed")
        self.assertFalse(second.is_known())
        prm = self.folder / "edited.prm"
        prm.write_text(QUICK.read_text().replace("= 141e9", "= 142e9"))
        third = self.family(prm).motor({"Wave/Amplitude": "2e-6"})
        prm.write_text(QUICK.read_text())
        self.assertEqual(motor_task.find_wave(third.wave).outcome, "changed")

    def test_damaged_ones_are_computed_again(self):
        self.sweep(*self.WAVES)
        note, other = sorted(self.output.glob("waves/*/wave.json"))
        text, times = note.read_text(), other.stat().st_mtime_ns
        rows = [(row["frequency_Hz"], row["outcome"]) for row in rows_of(self.output / "table.csv")]
        self.assertIsNotNone(known_outcome(note))
        fields = json.loads(text)
        for content in ("", text[:30], "null", "[]", "3", "{}", json.dumps({**fields, "outcome": "x"}), "\x00" * len(text),
                        json.dumps({**fields, "message": 3}), json.dumps({**fields, "seconds": "x"}), "\xff"):
            note.write_bytes(content.encode("latin-1"))
            self.assertIsNone(known_outcome(note), content)
        self.assertIn("1 motors are known already", self.sweep(*self.WAVES))
        for name in ("summary.json", "modes.h5", "frequencies.csv"):
            path = note.parent / "stator" / name
            path.write_bytes(path.read_bytes()[:-7] if name == "modes.h5" else b"")
            self.assertIsNone(known_outcome(note), name)
            self.assertIn("1 motors are known already", self.sweep(*self.WAVES))
        self.assertEqual(other.stat().st_mtime_ns, times)
        self.assertEqual([(row["frequency_Hz"], row["outcome"]) for row in rows_of(self.output / "table.csv")], rows)

    def test_a_damaged_record_of_a_search_is_named(self):
        self.output = self.folder / "what? {is} this%20&a=b"
        options = ("--vary", "Stator/Base thickness = 4e-3:5e-3", "--maximise", "frequency", "--trials", "2")
        self.sweep(*options)
        record = self.output / "optuna.db"
        self.assertEqual(list(self.folder.rglob("optuna.db")), [record])
        content = record.read_bytes()
        newer = sqlite3.connect(record)
        newer.execute("update alembic_version set version_num = 'v99.0.0'")
        newer.commit()
        newer.close()
        for damaged in (record.read_bytes(), b"nonsense" * 100, content[:5000], b"\x00" * 4096):
            record.write_bytes(damaged)
            done = run(*command("--output", self.output, *options))
            self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1), done.stderr)
            self.assertIn(f"{record} cannot be used", done.stderr)
            self.assertIn("remove it", done.stderr)
        record.unlink()
        before = {path: path.stat().st_mtime_ns for path in self.output.glob("waves/*/wave.json")}
        self.sweep(*options)
        self.assertEqual({path: path.stat().st_mtime_ns for path in before}, before)


@unittest.skipUnless(SUITE == "Mistakes", "another suite")
class Workers(InAFolder):
    def test_of_a_scheduler_are_waited_for_with_a_word(self):
        address, said = self.folder / "address.json", self.folder / "said"
        quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
        shells = [subprocess.Popen(["dask-scheduler", "--scheduler-file", address, "--port", "0", "--no-dashboard",
                                    "--interface", "lo"], **quiet)]
        try:
            while not address.exists():
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
        done = run(SWEEP, QUICK, "--programs", self.folder, *TWO_BY_TWO)
        self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1), done.stderr)
        self.assertIn("scripts/setup.sh", done.stderr)

    def test_quantities_that_no_motor_has(self):
        done = run(*command("--output", self.output, "--vary", "Stator/Base thickness = 4e-3:5e-3", "--maximise", "frequncy",
                            "--trials", "2"))
        self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1), done.stderr)
        self.assertIn("there are: frequency", done.stderr)


@unittest.skipUnless(SUITE == "Mistakes", "another suite")
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
