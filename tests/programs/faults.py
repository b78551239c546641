#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The programs on a machine that fails: a full disk, a folder that cannot be written, too little memory.

Usage: tests/programs/faults.py STATOR CONTACT LOSSES [unittest arguments]

Each run has to end with results, or with one line that says what is missing and with files that are complete. Disks are
made in a namespace of mounts of their own, where the system allows it. Interruptions: interruption.py, damaged
files: resume.py and tests/fuzz.
"""
import os
import pathlib
import shutil
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True  # a test leaves nothing in the source tree
from complete_files import check_complete  # noqa: E402
from program import STATIC_ROTOR, run  # noqa: E402

PROGRAMS = [pathlib.Path(sys.argv.pop(1)).resolve() for _ in range(3)]
MOUNTS = ("unshare", "--mount") if os.geteuid() == 0 else ("unshare", "--user", "--map-root-user", "--mount")


def in_shell(script, *words, prefix=()):
    return run(*prefix, "bash", "-c", script, "bash", *words)


def can_mount():
    return in_shell('mount -t tmpfs tmpfs "$1"', tempfile.gettempdir(), prefix=MOUNTS).returncode == 0


class Faults(unittest.TestCase):
    def setUp(self):
        self.scratch = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.scratch)

    def expect_words(self, done, status, *words):
        lines = done.stderr.strip().splitlines()
        self.assertEqual((done.returncode, len(lines)), (status, 1), done.stderr)
        for word in words:
            self.assertIn(word, lines[0])

    def finish(self, case):
        """All programs, now that nothing is missing."""
        for program in PROGRAMS:
            done = run(program, STATIC_ROTOR, "--output", case)
            self.assertEqual(done.returncode, 0, done.stderr)

    @unittest.skipUnless(can_mount(), "needs the right to mount file systems")
    def test_a_full_disk_leaves_complete_files(self):
        disk, copy, n_full = self.scratch / "disk", self.scratch / "copy", 0
        disk.mkdir()
        for kilobytes in (16, 100, 300, 600, 2000, 6000, 12000):
            script = ('mount -t tmpfs -o size="$1"k tmpfs "$2" && cd / || exit 99\n'
                      'for program in "${@:5}"; do "$program" "$4" --output "$2/case" || { status=$?; break; }; done\n'
                      'cp -r "$2" "$3"; exit ${status:-0}')
            done = in_shell(script, kilobytes, disk, copy, STATIC_ROTOR, *PROGRAMS, prefix=MOUNTS)
            files = [path for path in copy.rglob("*") if path.is_file()]
            for path in files:
                check_complete(path)
                self.assertNotEqual(path.suffix, ".part")
            shutil.rmtree(copy)
            if "No space left on device" in done.stderr:
                n_full += 1
                self.expect_words(done, 1, "Output/Directory", "No space left on device", "free some space")
        self.assertGreaterEqual(n_full, 4)

    @unittest.skipUnless(can_mount(), "needs the right to mount file systems")
    def test_a_read_only_disk_is_refused_at_once(self):
        case = self.scratch / "case"
        self.finish(case)
        before = sorted((path, path.stat().st_mtime) for path in case.rglob("*"))
        script = ('mount --bind "$1" "$1" && mount -o remount,bind,ro "$1" || exit 99\n'
                  'exec "$3" "$2" --output "$1"')
        for program in PROGRAMS:
            self.expect_words(in_shell(script, case, STATIC_ROTOR, program, prefix=MOUNTS), 1, "Output/Directory",
                              "Read-only file system")
        self.assertEqual(sorted((path, path.stat().st_mtime) for path in case.rglob("*")), before)

    def test_too_little_memory_is_said(self):
        case = self.scratch / "case"
        self.finish(case)
        least = self.memory_to_start()
        n_short = 0
        for program in PROGRAMS:
            for megabytes in range(least, least + 200, 25):
                done = in_shell('ulimit -v "$1"; exec "$2" "$3" --output "$4"', 1024 * megabytes, program, STATIC_ROTOR, case)
                if done.returncode != 0:
                    self.expect_words(done, 2, "out of memory")
                    n_short += 1
                for path in (path for path in case.rglob("*") if path.is_file()):
                    check_complete(path)
        self.assertGreaterEqual(n_short, 3)

    def memory_to_start(self):
        """MB of addresses with which libraries and MPI can be loaded: what happens below is not up to the programs."""
        for megabytes in range(300, 2000, 50):
            done = in_shell('ulimit -v "$1"; exec "$2" --version', 1024 * megabytes, PROGRAMS[1])
            if done.returncode == 0:
                return megabytes
        self.fail("the programs do not start")


if __name__ == "__main__":
    unittest.main()
