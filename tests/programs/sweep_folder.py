#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What tests of sweeps share: the first three arguments, STATOR CONTACT LOSSES, and a folder for each test."""
import pathlib
import shutil
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True  # a test leaves nothing in the source tree
from program import STATIC_ROTOR, ROOT, run, settings  # noqa: E402

sys.path.insert(0, str(ROOT / "scripts"))
from results.case import CaseError  # noqa: E402
from sweep import main  # noqa: E402

PROGRAMS = [pathlib.Path(sys.argv.pop(1)) for _ in range(3)]
SWEEP, COMPARE = ROOT / "scripts" / "sweep.py", ROOT / "scripts" / "compare.py"
# One operating point, coarse.
COARSE = ("Accuracy/Contact target = 0.2", "Loading/Values = 0.05")
TWO_BY_TWO = ("--vary", "Loading/Preload = 10, 14", "--vary", "Friction/Dynamic coefficient = 0.3:0.4:2")


def command(*options):
    return [SWEEP, STATIC_ROTOR, "--programs", PROGRAMS[0].parent, "--workers", "2", *settings(*COARSE), *options]


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
