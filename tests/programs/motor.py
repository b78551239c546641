#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The program motor, which runs the three others in one process, against those; and what the programs tell scripts.

Usage: tests/programs/motor.py STATOR CONTACT LOSSES MOTOR [unittest arguments]
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True  # a test leaves nothing in the source tree
from program import ROOT, STATIC_ROTOR, on_ranks, rows_of, run, settings  # noqa: E402

STATOR, CONTACT, LOSSES, MOTOR = (sys.argv.pop(1) for _ in range(4))
QUIET = settings("Output/VTU = false", "Loading/Values = 0, 0.05")
TABLES = ("stator/frequencies.csv", "stator/ellipses.csv", "contact/torque_speed.csv", "losses/losses.csv",
          "losses/efficiency.csv")


class Motor(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp())
        cls.one_by_one = cls.folder / "one_by_one"
        for program in (STATOR, CONTACT, LOSSES):
            done = run(program, STATIC_ROTOR, "--output", cls.one_by_one, *QUIET)
            assert done.returncode == 0, done.stderr

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    def assert_same_tables(self, case, tables=TABLES, relative=0.):
        for table in tables:
            for row, same in zip(rows_of(self.one_by_one / table), rows_of(case / table), strict=True):
                for name in row:
                    # Rounding decides on certificates and on errors, which are differences.
                    if name == "seconds" or relative and ("error" in name or name == "certificate"):
                        continue
                    try:
                        self.assertLessEqual(abs(float(row[name]) - float(same[name])), relative * abs(float(row[name])),
                                             f"{table}: {name}")
                    except ValueError:
                        self.assertEqual(row[name], same[name])

    def refused(self, *options):
        done = run(MOTOR, STATIC_ROTOR, "--output", self.folder / "refused", *options)
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        self.assertFalse((self.folder / "refused").exists())
        return done.stderr

    def test_is_the_three_programs(self):
        case = self.folder / "motor"
        done = run(MOTOR, STATIC_ROTOR, "--output", case, *QUIET)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_same_tables(case)
        files = [sorted(path.relative_to(folder) for path in folder.rglob("*") if path.is_file() and "kept" not in path.parts)
                 for folder in (self.one_by_one, case)]
        self.assertEqual(*files)
        for program in ("stator", "contact", "losses"):
            summary = json.loads((case / program / "summary.json").read_text())
            alone = json.loads((self.one_by_one / program / "summary.json").read_text())
            self.assertEqual(summary["program"], program)
            self.assertEqual(summary["seconds"].keys(), alone["seconds"].keys())
            self.assertEqual([check["name"] for check in summary["certificate"]["checks"]],
                             [check["name"] for check in alone["certificate"]["checks"]])

    def test_two_ranks(self):
        case = self.folder / "two_ranks"
        done = run(*on_ranks(2), MOTOR, STATIC_ROTOR, "--output", case, *QUIET)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_same_tables(case, ("stator/frequencies.csv", "contact/torque_speed.csv"), 1e-6)

    def test_begins_with_what_is_asked_for(self):
        case = self.folder / "from"
        shutil.copytree(self.one_by_one, case)
        wave = case / "stator" / "modes.h5"
        time = wave.stat().st_mtime_ns
        for table in ("contact/torque_speed.csv", "losses/losses.csv"):
            (case / table).unlink()
        done = run(MOTOR, STATIC_ROTOR, "--output", case, "--from", "contact", *QUIET)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(wave.stat().st_mtime_ns, time)
        self.assert_same_tables(case)

    def test_goes_on_after_an_interruption(self):
        case = self.folder / "resumed"
        shutil.copytree(self.one_by_one, case)
        done = run(MOTOR, STATIC_ROTOR, "--output", case, "--resume", *QUIET)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("resumed: ", done.stdout)
        self.assert_same_tables(case)

    def test_modes_of_a_rotor_have_no_motor(self):
        case = self.folder / "rotor"
        done = run(MOTOR, STATIC_ROTOR, "--output", case, *QUIET, "--set", "Modes/Body = rotor")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual([path.name for path in case.iterdir()], ["rotor"])

    def test_what_is_wrong_for_the_last_program_stops_the_first(self):
        self.assertIn("Friction/Dynamic coefficient", self.refused("--set", "Friction/Dynamic coefficient = 0"))

    def test_options(self):
        self.assertIn("--from stator: expected contact or losses", self.refused("--from", "stator"))
        self.assertIn("needs a value", self.refused("--from"))
        self.assertIn("--study is not available for the program motor", self.refused("--study"))
        done = run(CONTACT, STATIC_ROTOR, "--from", "losses")
        self.assertEqual(done.returncode, 1)
        self.assertIn("--from is not available for the program contact", done.stderr)

    def test_a_program_that_fails_is_named_and_the_last_one(self):
        case = self.folder / "fails"
        done = run(MOTOR, STATIC_ROTOR, "--output", case, "--set", "Output/VTU = false", "--set", "Loading/Values = 9")
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertTrue(done.stderr.startswith("contact: Loading/Values = 9"), done.stderr)
        self.assertIn("Loading/Values = 9", (case / "contact_failed.txt").read_text())
        self.assertTrue((case / "stator" / "summary.json").exists())
        self.assertFalse((case / "losses").exists())


class Questions(unittest.TestCase):
    """--check=json, --check=lines and --help=json; --check=sections is in stator.py."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())

    def tearDown(self):
        shutil.rmtree(self.folder)

    def answer(self, *words, program=MOTOR):
        done = run(program, *words, "--check=json")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return json.loads(done.stdout)

    def lines(self, asked, *words, program=MOTOR):
        done = subprocess.run([program, STATIC_ROTOR, *words, "--check=lines"], input="".join(f"{line}\n" for line in asked),
                              capture_output=True, text=True, check=True)
        return [json.loads(line) for line in done.stdout.splitlines()]

    def test_tell_what_the_results_will_tell(self):
        folder = self.folder / "up to rotor"
        said = self.answer(STATIC_ROTOR, "--output", folder, *QUIET)
        self.assertEqual([said["folder"], said["files"], said["ranks"]], [str(folder), [], 1])
        self.assertEqual([(one["name"], one["folder"]) for one in said["programs"]],
                         [(name, f"{folder}/{name}/") for name in ("stator", "contact", "losses")])
        self.assertFalse(folder.exists())
        done = run(STATOR, STATIC_ROTOR, "--output", folder, *QUIET)
        self.assertEqual(done.returncode, 0, done.stderr)
        summary = json.loads((folder / "stator" / "summary.json").read_text())
        self.assertEqual([summary["entries"], summary["identity"]], [said["entries"], said["identity"]])
        again = self.answer(folder / "stator" / "used.prm", "--output", self.folder / "elsewhere")
        self.assertEqual(again["identity"], said["identity"])
        self.assertEqual({**again["entries"], "Output/Directory": str(folder)}, said["entries"])

    def test_of_a_stator_alone(self):
        mesh = STATIC_ROTOR.parent / "stator_mesh.prm"
        said = self.answer(mesh, program=STATOR)
        self.assertEqual([pathlib.Path(file).name for file in said["files"]], ["canon_half_sector.msh"])
        self.assertIn("Loading/Preload", said["missing"])
        self.assertNotIn("Loading/Preload", said["entries"])
        self.assertEqual([one["name"] for one in said["programs"]], ["stator"])
        done = run(MOTOR, mesh, "--check=json")
        self.assertEqual((done.returncode, done.stdout, done.stderr.count("\n")), (1, "", 1))
        self.assertIn("for the modes of the stator alone, run the program stator", done.stderr)

    def test_of_a_motor_from_sections(self):
        files = [pathlib.Path(file).resolve() for file in self.answer(ROOT / "prm" / "disc60.prm")["files"]]
        self.assertEqual(files, [ROOT / "meshes" / f"disc60_{body}.msh" for body in ("stator", "rotor")])

    def test_of_the_modes_of_a_rotor(self):
        said = self.answer(STATIC_ROTOR, *settings("Modes/Body = rotor"), "--output", "x")
        self.assertEqual(said["programs"], [{"name": "stator", "folder": "x/rotor/"}])

    def test_of_many_motors(self):
        wave, *others = self.lines(['[]', '["Loading/Preload = 11"]', '["Wave/Amplitude = 1e-6"]',
                                    '["Loading/Preload = 14.0"]', '["Stator/Slot width = 3e-3"]', '["Friction/Dynamic coefficient = 0"]',
                                    '["Loading/Preloud = 3"]', '{"Loading/Preload": 3}', 'nonsense', ''])
        preload, amplitude, same, *mistakes = others
        self.assertEqual(wave["identity"], self.answer(STATIC_ROTOR)["identity"])
        self.assertEqual(same, wave)
        self.assertEqual(preload["identity"]["wave"], wave["identity"]["wave"])
        self.assertNotEqual(preload["identity"]["motor"], wave["identity"]["motor"])
        self.assertNotEqual(amplitude["identity"]["wave"], wave["identity"]["wave"])
        self.assertEqual([one["program"] for one in mistakes], ["stator", "contact", "motor", "motor", "motor", "motor"])
        for mistake, words in zip(mistakes, ("Stator/Slot width", "Friction/Dynamic coefficient = 0", "did you mean",
                                             "JSON list", "JSON list", "JSON list")):
            self.assertIn(words, mistake["error"])
        [of_stator] = self.lines(['["Friction/Dynamic coefficient = 0"]'], program=STATOR)
        self.assertEqual(of_stator["identity"]["wave"], wave["identity"]["wave"])

    def test_of_all_entries(self):
        declared = json.loads(run(CONTACT, "--help=json").stdout)
        self.assertEqual(declared["Materials"]["Stator metal"]["Density"]["default_value"], "")  # a file has to give it
        self.assertEqual(declared["Accuracy"]["Contact target"]["default_value"], "0.1")
        self.assertEqual(list(declared)[:3], ["Motor", "Stator", "Rotor"])

    def test_mistakes_in_options_are_told_by_their_words(self):
        for words, said in ((["-np", "2"], "unknown option -np;"), (["-n2"], "unknown option -n2;"),
                            (["-nh"], "unknown option -nh;"), (["--ranks=2"], "unknown option --ranks=2;"),
                            (["--ranks", "2"], "unknown option --ranks;"), (["--set"], "the option --set needs a value"),
                            (["--check=xml"], "--check=xml: expected --check or"), (["x.prm"], "more than one parameter file"),
                            (["--done", "x", "--check"], "--done is not available")):
            for order in ([STATIC_ROTOR, *words], [*words, STATIC_ROTOR]):
                if words == ["--set"] and order[-1] == STATIC_ROTOR:
                    continue
                done = run(MOTOR, *order)
                self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1), done.stderr)
                self.assertIn(said, done.stderr)
        self.assertEqual(run(MOTOR, "--", STATIC_ROTOR, "--check").returncode, 0)

    def test_programs_that_have_come_to_their_end(self):
        note = self.folder / "done.json"
        done = run(MOTOR, STATIC_ROTOR, "--output", self.folder / "case", "--done", note, *settings("Output/VTU = false",
                                                                                           "Loading/Values = 9"))
        self.assertEqual(done.returncode, 1)
        self.assertEqual(json.loads(note.read_text()), ["stator"])


class Launchers(unittest.TestCase):
    """Copies of a program that do not find each other, as they have an mpirun of another MPI."""

    def check(self, **environment):
        done = subprocess.run([MOTOR, STATIC_ROTOR, "--check"], capture_output=True, text=True, env={**os.environ, **environment},
                              check=False)
        return done.returncode, done.stderr

    def test_are_recognised(self):
        for size, rank in (("PMI_SIZE", "PMI_RANK"), ("MPI_LOCALNRANKS", "MPI_LOCALRANKID"),
                           ("SLURM_STEP_NUM_TASKS", "SLURM_PROCID"),
                           ("SLURM_NTASKS", "SLURM_PROCID"), ("OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_RANK")):
            status, said = self.check(**{size: "3", rank: "0"})
            self.assertEqual((status, said.count("\n")), (1, 1), said)
            self.assertIn(f"started 3 times ({size})", said)
            self.assertEqual(self.check(**{size: "3", rank: "2"}), (1, ""))
            self.assertEqual(self.check(**{size: "1", rank: "0"}), (0, ""))

    def test_the_script_of_a_job_runs_once(self):
        job = {"SLURM_NTASKS": "4", "SLURM_PROCID": "0", "ENVIRONMENT": "BATCH"}
        self.assertEqual(self.check(**job), (0, ""))
        self.assertEqual(self.check(**job, SLURM_STEP_NUM_TASKS="4")[0], 1)
        self.assertEqual(self.check(SLURM_NTASKS="4"), (0, ""))  # of salloc


if __name__ == "__main__":
    unittest.main()
