#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The kernel of OpenBLAS suits the processor, whatever OpenBLAS takes it for.

Usage: tests/programs/blas_kernel.py RATE OLD_BLAS TESTS STATOR CONTACT LOSSES [unittest arguments]

RATE measures products of matrices, OLD_BLAS is a library that makes OpenBLAS take its oldest kernel, TESTS is a program of
GoogleTest. What is compared: the names of kernels with the instructions that the operating system lists. Rates are printed
beside those of all kernels that the processor can run, each chosen by the user's variable.
"""
import os
import pathlib
import platform
import subprocess
import sys
import unittest

RATE, OLD_BLAS, TESTS, *PROGRAMS = [sys.argv.pop(1) for _ in range(6)]
VARIABLE = "OPENBLAS_CORETYPE"
OLDEST = "Prescott"
TWO_RANKS = ("mpirun", "--oversubscribe", "-n", "2")
REFERENCE_BLAS = pathlib.Path("/usr/lib/x86_64-linux-gnu/blas")


def instructions():
    text = pathlib.Path("/proc/cpuinfo").read_text()
    return set(next(line for line in text.splitlines() if line.startswith("flags")).split())


def kernels():
    """Those that the processor can run, best last."""
    found = [OLDEST]
    if {"avx2", "fma"} <= instructions():
        found += ["Haswell"]
    if {"avx512f", "avx512cd", "avx512bw", "avx512dq", "avx512vl"} <= instructions():
        found += ["SkylakeX"]
    return found


def run(*command, **variables):
    """Runs a program where nobody has chosen a kernel but in `variables`."""
    environment = {name: value for name, value in os.environ.items() if not name.startswith("OPENBLAS_")}
    environment.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1", **variables)
    return subprocess.run(command, env=environment, capture_output=True, text=True, timeout=60)


def told(*command, **variables):
    done = run(*command, **variables)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def with_old_blas(kernel=OLDEST):
    return {"LD_PRELOAD": OLD_BLAS, "OLD_BLAS_KERNEL": kernel}


def rates(*command, **variables):
    """Of the slowest process for each size of matrices."""
    lines = [line.split()[1:] for line in told(*command, **variables).splitlines()]
    return [min(float(rate) for rate in of_one_size) for of_one_size in zip(*lines)]


@unittest.skipUnless(platform.machine() == "x86_64", "kernels are chosen on x86-64 only")
class Kernel(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        if not told(RATE)[0].isalpha():
            raise unittest.SkipTest("the BLAS is not OpenBLAS")

    def record_rates(self, *launcher, **variables):
        """Times are no test on a machine that others use: they are printed, and the kernel's name is compared."""
        self.assertEqual(told(*launcher, RATE, **variables).split()[0], kernels()[-1])
        print(*(f"{rate:.0f}" for rate in rates(*launcher, RATE, **variables)), "GFlop/s;",
              *(f"{kernel} " + " ".join(f"{rate:.0f}" for rate in rates(*launcher, RATE, **{VARIABLE: kernel}))
                for kernel in kernels()))

    def test_is_the_best_with_an_old_library(self):
        self.record_rates(**with_old_blas())

    def test_is_the_best_with_an_old_library_on_two_ranks(self):
        self.record_rates(*TWO_RANKS, **with_old_blas())

    def test_old_library_takes_the_oldest_by_itself(self):
        """Or nothing would be shown above."""
        self.assertEqual(told(RATE, **{VARIABLE: OLDEST}).split()[0], OLDEST)

    def test_of_the_programs_is_named_and_follows_the_processor(self):
        for program in PROGRAMS:
            with self.subTest(program):
                self.assertTrue(told(program, "--version", **with_old_blas()).endswith(
                    f", BLAS kernel {kernels()[-1]}\n"))
        found = told(PROGRAMS[0], "--version").rsplit(" ", 1)[1].strip()
        self.assertTrue(found and (len(kernels()) == 1 or found != OLDEST), found)

    def test_of_all_old_libraries_follows_the_processor(self):
        for old in kernels():
            self.assertEqual(told(RATE, **with_old_blas(old)).split()[0], kernels()[-1])

    def test_is_named_once_on_two_ranks(self):
        for program in PROGRAMS:
            with self.subTest(program):
                lines = told(*TWO_RANKS, program, "--version", **with_old_blas()).splitlines()
                self.assertEqual(len(lines), 1)
                self.assertTrue(lines[0].endswith(f", BLAS kernel {kernels()[-1]}"), lines)

    def test_chosen_by_the_user_stays(self):
        for kernel in kernels():
            self.assertEqual(told(RATE, **{VARIABLE: kernel}, **with_old_blas()).split()[0], kernel)
        for program in PROGRAMS:
            with self.subTest(program):
                self.assertTrue(told(program, "--version", **{VARIABLE: OLDEST}).endswith(f", BLAS kernel {OLDEST}\n"))

    def test_unknown_choice_starts_the_program_once(self):
        self.assertIn("BLAS kernel", told(PROGRAMS[0], "--version", **{VARIABLE: "nonsense"}, **with_old_blas()))

    def test_of_test_programs_follows_the_processor(self):
        for launcher in (), TWO_RANKS:
            with self.subTest(launcher):
                output = told(*launcher, TESTS, "--gtest_filter=BlasKernel.OfThisProcess*", **with_old_blas())
                self.assertIn("1 test from 1 test suite ran", output)
                self.assertNotIn("SKIPPED", output)

    def test_restart_keeps_the_arguments(self):
        done = run(PROGRAMS[0], "no such  file.prm", "--set", "", "--output", "a 'b'", **with_old_blas())
        self.assertEqual(done.returncode, 1)
        self.assertIn("no such  file.prm", done.stderr)

    @unittest.skipUnless(REFERENCE_BLAS.is_dir(), "needs Debian's reference BLAS")
    def test_of_another_library_is_none(self):
        """Its rates come first: there is no name."""
        self.assertTrue(told(RATE, LD_LIBRARY_PATH=str(REFERENCE_BLAS)).startswith(" "))


if __name__ == "__main__":
    unittest.main()
