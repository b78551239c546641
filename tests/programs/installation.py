#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a designer does with an installed ringmotor: run.sh, which is called ringmotor there, from a parameter file to
the page.

Usage: tests/programs/installation.py BUILD_DIR [unittest arguments]
"""
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

sys.dont_write_bytecode = True  # a test leaves nothing in the source tree
from program import ROOT, rows_of, run, settings  # noqa: E402

BUILD = pathlib.Path(sys.argv.pop(1))
NO_FIELDS = settings("Output/VTU = false", "Accuracy/Contact target = 0.2", "Loading/Values = 0, 0.05")
QUIET = settings("Output/VTU = false", "Output/Figures = false")


class Installed(unittest.TestCase):
    """Has an installed tree, away from sources and build."""

    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.scratch.name)
        cls.prefix = cls.folder / "installed"
        done = run("cmake", "--install", BUILD, "--prefix", cls.prefix)
        assert done.returncode == 0, done.stderr
        cls.quick = cls.prefix / "share" / "ringmotor" / "prm" / "static_rotor.prm"

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def ringmotor(self, *options, file=None):
        return run(self.prefix / "bin" / "ringmotor", file or self.quick, *options)


class FromFileToPage(Installed):
    def test_a_motor_of_ones_own(self):
        case = self.folder / "ring45"
        done = self.ringmotor("--output", case, *settings("Output/VTU = false"), file=ROOT / "tests/programs/ring45.prm")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("all hold", done.stdout)
        self.assertTrue((case / "report.html").exists())
        for program in ("stator", "contact", "losses"):
            self.assertTrue(json.loads((case / program / "summary.json").read_text())["certificate"]["holds"], program)
        # An efficiency as well known as torques and speeds; a ring of these dimensions has been driven at 43 kHz.
        best = max(rows_of(case / "losses" / "efficiency.csv"), key=lambda row: float(row["efficiency"]))
        self.assertLess(float(best["efficiency_error"]), 0.1 * float(best["efficiency"]))
        self.assertTrue(0.3 < float(best["efficiency"]) < 0.9)
        self.assertAlmostEqual(float(rows_of(case / "stator" / "frequencies.csv")[0]["frequency_Hz"]), 43e3, delta=1500)

    def test_the_curve_is_computed_where_it_bends(self):
        case = self.folder / "curve"
        done = self.ringmotor("--output", case, *QUIET, *settings("Loading/Number of curve points = 9"))
        self.assertEqual(done.returncode, 0, done.stderr)
        curve = rows_of(case / "contact" / "torque_speed.csv")
        torques, speeds = ([float(row[name]) for row in curve] for name in ("torque_mNm", "speed_rpm"))
        self.assertEqual((torques[0], speeds[-1]), (0, 0))
        steps = [(((b - a) / torques[-1]) ** 2 + (0.4 * (d - c) / speeds[0]) ** 2) ** 0.5
                 for a, b, c, d in zip(torques, torques[1:], speeds, speeds[1:])]
        self.assertLess(max(steps), 2.2 * min(steps))  # the shape is known from five points
        for row, torque, speed in list(zip(curve, torques, speeds))[1:-1]:
            if row["control"] == "torque":
                self.assertLess(torque, 0.97 * torques[-1])
            else:
                self.assertLess(speed, 0.9 * speeds[0])
        self.assertGreater(sum(row["control"] == "speed" for row in curve), 1)

    def test_a_program_that_fails_stays_on_page_and_report(self):
        case = self.folder / "failed"
        options = ("--output", case, *settings("Output/VTU = false"))
        self.assertEqual(self.ringmotor(*options).returncode, 0)
        # The contact fails, after an earlier run that did not.
        done = self.ringmotor(*options, *settings("Effects/Spin convection = auto", "Wave/Amplitude = 3e-5",
                                                  "Accuracy/Contact target = 4e-3"))
        self.assertEqual(done.returncode, 2, done.stderr)
        words = "Effects/Spin convection = auto: it would change the results by"
        self.assertIn(words, done.stderr)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)  # of all ranks, and of mpirun
        for text in (done.stdout, (case / "report.html").read_text()):
            self.assertIn("contact FAILED", text)
            self.assertIn(words, text)
            for other in ("all hold", "efficiency  ", "speed without load"):
                self.assertNotIn(other, text)
        # Losses that fail leave the contact on the page.
        self.assertEqual(self.ringmotor(*options).returncode, 0)
        (case / "losses_failed.txt").write_text("no power left\n")
        page = run(self.prefix / "share/ringmotor/scripts/summary.py", case).stdout
        for said in ("losses FAILED", "no power left", "speed without load"):
            self.assertIn(said, page)
        # A run that succeeds takes it back.
        done = self.ringmotor(*options)
        self.assertIn("all hold", done.stdout)
        self.assertNotIn("FAILED", done.stdout)

    def test_a_figure_that_fails_leaves_the_page(self):
        case, figures = self.folder / "no_pen", self.prefix / "share/ringmotor/scripts/drawing/stator_figures.py"
        usual = figures.read_text(encoding="utf-8")
        for drawn, said in (("def draw_dispersion(*_):\n    raise RuntimeError('no pen')\n",
                             "figures: dispersion cannot be drawn (RuntimeError no pen), and is left out"),
                            ("raise ImportError('no matplotlib')\n", "figures: ImportError no matplotlib; ")):
            figures.write_text(f"{usual}\n{drawn}", encoding="utf-8")
            try:
                done = self.ringmotor("--output", case, *settings("Output/VTU = false"))
            finally:
                figures.write_text(usual, encoding="utf-8")
            self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1), done.stderr)
            self.assertIn(said, done.stderr)
            self.assertIn("all hold", done.stdout)  # the page
            self.assertTrue((case / "report.html").exists())

    def test_an_interruption_ends_it(self):
        case = self.folder / "interrupted"
        process = subprocess.Popen([self.prefix / "bin" / "ringmotor", ROOT / "prm" / "canon_ring.prm", "--output", case],
                                   stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, start_new_session=True)
        while not case.exists():
            time.sleep(0.1)
        time.sleep(1)
        os.killpg(process.pid, signal.SIGINT)  # as by Ctrl-C
        _, said = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130)
        self.assertRegex(said, r"^\n(stator|contact|run\.sh): interrupted; [^\n]*\n$")
        self.assertFalse((case / "figures").exists())

    def test_mistakes_are_told_before_anything_is_computed(self):
        case = self.folder / "mistakes"
        for entry, said in (("Rotor/Lip inner radius = 0.035", "Rotor/Lip inner radius"),
                            ("Materials/Rotor metal/Young modulus = 68.9", "(68.9 GPa is 68.9e9)"),
                            ("Friction/Law = velocity", "Friction/Decay velocity"),
                            ("Support/Felt outer radius = 0.02", "Support/Felt outer radius"),
                            ("Modes/Nodal diameters = 5-6", "Modes/Nodal diameters")):
            done = self.ringmotor("--output", case, *settings(entry))
            self.assertEqual((done.returncode, done.stdout), (1, ""), entry)
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
            self.assertIn(said, done.stderr)
            self.assertFalse(case.exists())

    def test_a_check_draws_the_motor_and_computes_nothing(self):
        case = self.folder / "checked"
        for entry, drawing in (("Output/Figures = false", []), ("Output/Figures = true", ["sections.png", "sections.svg"])):
            done = self.ringmotor("--output", case, "--check", *settings(entry))
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertIn(f"would be written to {case}", done.stdout)
            self.assertEqual(sorted(path.name for path in case.rglob("*")), drawing)
            self.assertEqual(f"{case}/sections.png" in done.stdout, bool(drawing))

    def assert_whole_run(self, done, case, *files, said=r"\Z"):
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stderr, rf"\A{said}")
        self.assertIn("all hold", done.stdout)
        for name in ("losses/summary.json", *files):
            self.assertTrue((case / name).exists(), name)

    def test_names_of_folders_mean_nothing(self):
        elsewhere = self.folder / "elsewhere"
        (elsewhere / "date").mkdir(parents=True)
        (elsewhere / "date" / "report.html").write_text("of somebody else")
        for name in ("rotor", "up to date; 'x' \"y\" (1) > 2"):
            case = self.folder / "names" / name
            done = subprocess.run([self.prefix / "bin" / "ringmotor", self.quick, "--output", case, *NO_FIELDS], text=True,
                                  capture_output=True, cwd=elsewhere, check=False)
            self.assert_whole_run(done, case, "report.html", "figures/torque_speed.png")
        self.assertEqual((elsewhere / "date" / "report.html").read_text(), "of somebody else")

    def test_a_page_of_somebody_else_stays(self):
        case = self.folder / "page"
        case.mkdir()
        for content in ("<html>mine</html>", ""):
            (case / "report.html").write_text(content)
            done = self.ringmotor("--output", case, *NO_FIELDS)
            self.assertEqual((done.returncode, done.stdout, done.stderr.count("\n")), (1, "", 1))
            self.assertIn("is not a page of ringmotor", done.stderr)
            self.assertEqual([path.name for path in case.iterdir()], ["report.html"])
            self.assertEqual((case / "report.html").read_text(), content)

    def launched(self, case, *before, **environment):
        return subprocess.run([*before, self.prefix / "bin" / "ringmotor", self.quick, "--output", case, *NO_FIELDS,
                               *QUIET[-2:]], text=True, capture_output=True, env={**os.environ, **environment}, check=False)

    def test_an_mpirun_of_another_mpi(self):
        # It starts as many copies as it is asked for, of which each takes itself for the only one, or nothing at all.
        copies = 'while [[ $1 != -n ]]; do shift; done; for ((i = 0; i < $2; ++i)); do "${@:3:1}" "${@:4}" & done; wait'
        for number, script in enumerate((copies, f"export PMI_SIZE=2 PMI_RANK=0; {copies}", "echo no")):
            folder = self.folder / f"mpirun_{number}"
            folder.mkdir()
            (folder / "mpirun").write_text(f"#!/bin/bash\n{script}\n")
            (folder / "mpirun").chmod(0o755)
            case = folder / "case"
            self.assert_whole_run(self.launched(case, PATH=f"{folder}:{os.environ['PATH']}"), case,
                                  said=r"run\.sh: uses one core of \d+, as mpirun cannot be used \([^\n]+\)\n\Z")

    def test_under_mpirun(self):
        may = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
        case = self.folder / "under_mpirun"
        self.assert_whole_run(self.launched(case, "mpirun", "-n", "1", **may), case)
        done = self.launched(self.folder / "twice", "mpirun", "--oversubscribe", "-n", "2", **may)
        self.assertEqual(done.stderr.count("run.sh: started 2 times (OMPI_COMM_WORLD_SIZE); start it once"), 1, done.stderr)
        self.assertNotIn("ORTE", done.stderr)
        self.assertFalse((self.folder / "twice").exists())
        for rank, said in (("0", "run.sh: started 3 times (PMI_SIZE); start it once"), ("1", "")):
            done = self.launched(self.folder / "twice", PMI_SIZE="3", PMI_RANK=rank)
            self.assertEqual((done.returncode, done.stdout), (1, ""))
            self.assertTrue(done.stderr.startswith(said), done.stderr)

    def test_a_pipe_is_refused(self):
        done = subprocess.run(["bash", "-c", '"$1" <(cat "$2")', "bash", self.prefix / "bin" / "ringmotor", self.quick],
                              capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stdout, done.stderr.count("\n")), (1, "", 1))
        self.assertIn("is a pipe", done.stderr)

    def test_modes_of_the_rotor_alone(self):
        case = self.folder / "rotor"
        done = self.ringmotor("--output", case, *QUIET, *settings("Modes/Body = rotor", "Accuracy/Target = 0.1"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(sorted(path.name for path in case.iterdir()), ["rotor"])

    def test_modes_of_a_whole_ring_alone(self):
        case = self.folder / "ring"
        done = self.ringmotor("--output", case, *QUIET,
                              *settings("Modes/Domain = ring", "Accuracy/Target = 0.1", "Effects/Target plates = off",
                                        f"Stator/Mesh file = {ROOT}/tests/wave/ring_with_ears.msh"))
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(sorted(path.name for path in case.iterdir()), ["ring_of_stator"])


class Package(Installed):
    def test_the_links_of_the_readme_lead_somewhere(self):
        shared = self.prefix / "share" / "ringmotor"
        for name in ("README.md", "LICENSE", "doc/walk.md", "doc/images/torque_speed.png", "prm/canon_ring.prm",
                     "meshes", "scripts/report.py"):
            self.assertTrue((shared / name).exists(), name)
        for name in ("setup.sh", "development"):
            self.assertFalse((shared / "scripts" / name).exists(), name)
        done = run(self.prefix / "bin" / "ringmotor", "--version")
        self.assertRegex(done.stdout, r"ringmotor \d+\.\d+\.\d+")

    def test_the_debian_package_installs_and_runs(self):
        done = run("cpack", "--config", BUILD / "CPackConfig.cmake", "-B", self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        package, = self.folder.glob("*.deb")
        depends = run("dpkg-deb", "--field", package, "Depends").stdout
        for alternatives in depends.split(","):
            names = [name.split("(")[0].strip() for name in alternatives.split("|")]
            there = [run("dpkg-query", "-W", "-f=${Status}", name).stdout == "install ok installed" for name in names]
            self.assertTrue(any(there), f"not installed: {alternatives}")
        for needed in ("libdeal.ii", "libopenblas0", "python3-h5py", "libopenmpi"):
            self.assertIn(needed, depends)
        # Into a tree of its own, with dpkg's records there.
        root = self.folder / "root"
        records = root / "var" / "lib" / "dpkg"
        for folder in ("updates", "info"):
            (records / folder).mkdir(parents=True)
        (records / "status").touch()
        command = ["dpkg", "--force-not-root", "--force-depends", f"--root={root}", f"--log={self.folder}/log", "--install",
                   package]
        if os.geteuid() != 0:
            command.insert(0, "fakeroot")
        done = run(*command)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("install ok installed", (records / "status").read_text())
        case = self.folder / "packaged"
        done = run(root / "usr/bin/ringmotor", root / "usr/share/ringmotor/prm/quick.prm", "--output", case, *QUIET)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("all hold", done.stdout)


if __name__ == "__main__":
    unittest.main()
