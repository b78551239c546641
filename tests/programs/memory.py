#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The programs under tools that watch how they use memory.

Usage: tests/programs/memory.py Leaks|Valgrind STATOR CONTACT LOSSES

Leaks: of programs built with -DRINGMOTOR_SANITIZERS=ON, no memory that ringmotor has allocated is lost; MPI keeps some
of its own. Valgrind: programs built without read no memory that was not written, which those tools do not see.
"""
import os
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True  # a test leaves nothing in the source tree
from program import STATIC_ROTOR, settings  # noqa: E402

SUITE, PROGRAMS = sys.argv.pop(1), [sys.argv.pop(1) for _ in range(3)]
# Small: a program takes thirty times as long. Steps are as short as a certificate needs.
SMALLEST = settings("Accuracy/Mode = fixed", "Accuracy/Polynomial degree = 2", "Accuracy/Interface refinement = 0",
                    "Loading/Values = 0.1", "Time/Snapshots = 2", "Output/VTU = false")


def run_all(case, prefix=(), options=(), **environment):
    """Status and standard error of each program, one after the other."""
    for program in PROGRAMS:
        done = subprocess.run([*prefix, program, STATIC_ROTOR, "--output", case, *options], capture_output=True, text=True,
                              env=dict(os.environ, **environment))
        yield done.returncode, done.stderr


class Memory(unittest.TestCase):
    @unittest.skipUnless(SUITE == "Leaks", "another suite")
    def test_nothing_of_ours_is_lost(self):
        with tempfile.TemporaryDirectory() as case:
            for _, said in run_all(case, ASAN_OPTIONS="detect_leaks=1", LSAN_OPTIONS="exitcode=0"):
                self.assertNotIn("ringmotor::", said)

    @unittest.skipUnless(SUITE == "Valgrind", "another suite")
    def test_what_is_read_was_written(self):
        with tempfile.TemporaryDirectory() as case:
            # Valgrind does not know the widest vector instructions.
            for status, said in run_all(case, ("valgrind", "-q", "--error-exitcode=9"), SMALLEST,
                                        OPENBLAS_CORETYPE="Haswell", HWLOC_COMPONENTS="-x86"):
                self.assertEqual(status, 0, said)


if __name__ == "__main__":
    unittest.main()
