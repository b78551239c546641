#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The programs in the hands of a designer: folders, interruptions, what follows from what, what is kept.

Usage: tests/programs/designer.py STATOR CONTACT LOSSES [unittest arguments]
"""
import fcntl
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

sys.dont_write_bytecode = True  # a test leaves nothing in the source tree
from program import STATIC_ROTOR, WithWave, rows_of, run, settings  # noqa: E402

STATOR, CONTACT, LOSSES = (sys.argv.pop(1) for _ in range(3))
QUIET = settings("Output/VTU = false")


class Designer(WithWave):
    stator = STATOR

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def refused(self, program, *options, file=STATIC_ROTOR):
        done = run(program, file, *options)
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        return done.stderr

    def test_a_file_without_a_rotor(self):
        text = re.sub(r"subsection Rotor\n.*?\nend\n", "", STATIC_ROTOR.read_text(), flags=re.DOTALL)
        file = self.folder / "stator_only.prm"
        file.write_text(text)
        done = run(STATOR, file, "--output", self.folder / "case", *QUIET)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("Ring outer radius  ", (self.folder / "case" / "stator" / "used.prm").read_text())
        for program in (CONTACT, LOSSES):
            said = self.refused(program, "--output", self.folder / "case", file=file)
            self.assertIn("missing Rotor/", said)

    def test_entries_that_follow_others(self):
        nine = self.folder / "nine.prm"
        text = STATIC_ROTOR.read_text().replace("Number of waves = 7", "Number of waves = 9")
        nine.write_text(re.sub(r"subsection Modes\n.*?\nend\n", "", text, flags=re.DOTALL))
        case = self.folder / "nine"
        done = run(STATOR, nine, "--output", case, *QUIET)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual({row["n"] for row in rows_of(case / "stator" / "frequencies.csv")}, {"9"})

    def test_a_felt_follows_the_base(self):
        """A felt that is not told of lies under all of the base."""
        losses = []
        for entries in ((), ("Support/Felt inner radius = 0.0300", "Support/Felt outer radius = 0.0360"),
                        ("Support/Felt inner radius = 0.0330",)):
            if not losses:
                self.assertEqual(run(CONTACT, STATIC_ROTOR, "--output", self.case, *QUIET).returncode, 0)
            done = run(LOSSES, STATIC_ROTOR, "--output", self.case, *QUIET, *settings(*entries))
            self.assertEqual(done.returncode, 0, done.stderr)
            losses.append(float(rows_of(self.case / "losses" / "losses.csv")[0]["support_loss_mW"]))
        self.assertEqual(losses[0], losses[1])
        self.assertLess(losses[2], 0.9 * losses[0])

    def test_a_byte_order_mark(self):
        file = self.folder / "marked.prm"
        file.write_bytes(b"\xef\xbb\xbf" + STATIC_ROTOR.read_bytes())
        self.assertEqual(run(STATOR, file, "--check").returncode, 0)

    def test_what_contact_certifies_losses_certify(self):
        """Near no load and near stall, where powers are hard to balance, and in between."""
        for entries in (("Loading/Values = 0, 0.002",), ("Loading/Control = speed", "Loading/Values = 0.01, 4"),
                        ("Friction/Law = coulomb", "Loading/Preload = 3")):
            done = run(CONTACT, STATIC_ROTOR, "--output", self.case, *QUIET, *settings(*entries))
            self.assertEqual(done.returncode, 0, done.stderr)
            done = run(LOSSES, STATIC_ROTOR, "--output", self.case, *QUIET, *settings(*entries))
            self.assertEqual(done.returncode, 0, done.stderr)

    def test_nothing_has_no_sign_and_no_digits(self):
        for entries in (("Loading/Values = 0",), ("Loading/Control = speed", "Loading/Values = 0"),
                        ("Loading/Preload = 1000", "Wave/Amplitude = 2e-8")):
            case = self.folder / "case"
            for program in (STATOR, CONTACT, LOSSES):
                done = run(program, STATIC_ROTOR, "--output", case, *QUIET, *settings(*entries))
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertNotRegex(done.stdout, r"-0\.?0*[ ,]")
            for path in case.rglob("*.csv"):
                for row in rows_of(path):
                    for name, value in row.items():
                        is_measure = name in ("certificate", "power_imbalance") or "error" in name
                        if path.name != "history.csv" and not is_measure and re.fullmatch(r"-?[\d.]+(e-?\d+)?", value):
                            self.assertTrue(float(value) == 0 or abs(float(value)) > 1e-15, f"{path.name} {name} {value}")
                            self.assertNotEqual(value, "-0", f"{path.name} {name}")

    def test_a_folder_is_for_one_program_at_a_time(self):
        other = os.open(self.case, os.O_RDONLY)
        try:
            fcntl.flock(other, fcntl.LOCK_EX)
            before = sorted(self.case.rglob("*"))
            for program in (STATOR, CONTACT, LOSSES):
                said = self.refused(program, "--output", self.case)
                self.assertIn("another program is running", said)
                self.assertIn("--output DIR", said)
            self.assertEqual(sorted(self.case.rglob("*")), before)
        finally:
            os.close(other)
        # Two that are started together: one works, the other leaves it alone.
        case = self.folder / "together"
        slow = settings("Modes/Nodal diameters = 0-45", "Output/VTU = false")  # longer than a program takes to start
        runs = [subprocess.Popen([STATOR, str(STATIC_ROTOR), "--output", str(case), *slow], stderr=subprocess.PIPE, text=True,
                                 stdout=subprocess.DEVNULL) for _ in range(2)]
        said = [started.communicate()[1] for started in runs]
        self.assertEqual(sorted(started.returncode for started in runs), [0, 1], said)
        self.assertIn("another program is running", "".join(said))

    def test_losses_of_another_wave(self):
        case = self.folder / "case"
        for program in (STATOR, CONTACT, LOSSES, STATOR, LOSSES):  # the same wave once more is the same
            done = run(program, STATIC_ROTOR, "--output", case, *QUIET)
            self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(run(STATOR, STATIC_ROTOR, "--output", case, *QUIET, *settings("Accuracy/Target = 1e-3")).returncode, 0)
        self.assertIn("run the program contact again", self.refused(LOSSES, "--output", case))

    def test_what_a_failure_leaves(self):
        case = self.folder / "case"
        done = run(STATOR, STATIC_ROTOR, "--output", case, *QUIET, *settings("Accuracy/Time limit = 1e-3"))
        self.assertEqual(done.returncode, 2)
        self.assertIn("Accuracy/Time limit = 0.001 s exceeded; choose a larger limit", done.stderr)
        self.assertEqual(sorted(path.name for path in case.rglob("*")), ["stator", "stator_failed.txt"])
        shutil.rmtree(case)
        shutil.copytree(self.case / "stator", case / "stator")
        done = run(CONTACT, STATIC_ROTOR, "--output", case, *QUIET, *settings("Accuracy/Time limit = 1e-3"))
        self.assertEqual(done.returncode, 2)
        self.assertEqual(f"contact: {(case / 'contact_failed.txt').read_text()}", done.stderr)
        self.assertEqual(run(CONTACT, STATIC_ROTOR, "--output", case, *QUIET).returncode, 0)
        self.assertFalse((case / "contact_failed.txt").exists())

    def test_a_mistake_leaves_no_folder(self):
        case = self.folder / "nowhere"
        self.assertIn("does not exist", self.refused(CONTACT, "--output", case))
        self.assertFalse(case.exists())

    def test_an_interruption_says_what_is_kept(self):
        case = self.folder / "case"
        shutil.copytree(self.case / "stator", case / "stator")
        command = [CONTACT, str(STATIC_ROTOR), "--output", str(case), *settings("Loading/Number of curve points = 1000")]
        started = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        points = case / "contact" / "kept" / "points"
        end = time.monotonic() + 60
        while not (points.exists() and len(list(points.iterdir())) > 3) and time.monotonic() < end:
            time.sleep(0.05)
        started.send_signal(signal.SIGINT)
        said = started.communicate(timeout=60)[1]
        self.assertEqual(started.returncode, -signal.SIGINT)
        for words in ("contact: interrupted", str(case / "contact" / "kept"), "--resume"):
            self.assertIn(words, said)
        self.assertGreater(len(list(points.iterdir())), 3)

    def test_what_is_kept_is_told_and_cleared(self):
        case = self.folder / "case"
        shutil.copytree(self.case / "stator", case / "stator")
        done = run(CONTACT, STATIC_ROTOR, "--output", case, *QUIET)
        self.assertEqual(done.returncode, 0, done.stderr)
        told = re.search(r"kept for later runs: ([\d.]+) MB", done.stdout)
        kept = case / "contact" / "kept"
        size = sum(path.stat().st_size for path in kept.rglob("*") if path.is_file())
        self.assertAlmostEqual(float(told[1]), 1e-6 * size, delta=0.06)
        done = run(CONTACT, STATIC_ROTOR, "--output", case, "--clear")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(f"removed {told[1]} MB", done.stdout)
        self.assertFalse(kept.exists())
        self.assertTrue(json.loads((case / "contact" / "summary.json").read_text())["certificate"]["holds"])
        self.assertIn("--clear is not available", self.refused(STATOR, "--output", case, "--clear"))
        self.assertIn("--resume cannot be combined with --clear", self.refused(CONTACT, "--output", case, "--clear", "--resume"))


if __name__ == "__main__":
    unittest.main()
