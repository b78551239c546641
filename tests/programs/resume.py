#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs of the program contact that go on where another one was interrupted.

Usage: tests/programs/resume.py STATOR CONTACT [unittest arguments]

What is compared: their results with those of a run that was not interrupted, to the last bit.
"""
import subprocess
import sys
import time
import unittest

import h5py

sys.dont_write_bytecode = True  # a test leaves nothing in the source tree
from program import STATIC_ROTOR, WithWave, on_ranks, rows_of, run  # noqa: E402

STATOR, CONTACT = sys.argv.pop(1), sys.argv.pop(1)


class Resume(WithWave):
    """What an interrupted run has found is there for the next one."""

    stator = STATOR

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.folder = cls.case / "contact"
        cls.points = cls.folder / "kept" / "points"

    def resume(self, *options, ranks=1):
        done = run(*on_ranks(ranks), CONTACT, STATIC_ROTOR, "--output", self.case, *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def results(self):
        """All numbers but the seconds."""
        rows = [{name: value for name, value in row.items() if name != "seconds"}
                for row in rows_of(self.folder / "torque_speed.csv")]
        with h5py.File(self.folder / "contact.h5") as file:
            arrays = {}
            file.visititems(lambda name, item: arrays.update({name: item[()].tobytes()})
                            if isinstance(item, h5py.Dataset) else None)
        return rows, arrays, (self.folder / "history.csv").read_bytes()

    def kill_after(self, n_points, *options):
        """Kills a run as soon as it has kept so many points; returns how many it has left."""
        process = subprocess.Popen([str(part) for part in (CONTACT, STATIC_ROTOR, "--output", self.case, *options)],
                                   stdout=subprocess.DEVNULL)
        while process.poll() is None and len(self.finished()) < n_points:
            time.sleep(0.002)
        process.kill()
        process.wait()
        return len(self.finished())

    def finished(self):
        return list(self.points.glob("????????-????-????-????-????????????"))

    def test_an_interrupted_run_goes_on_to_the_same_results(self):
        self.assertNotIn("resum", self.resume())
        expected, n_points = self.results(), len(self.finished())
        for n_killed in (2, 6):
            for path in self.finished():
                path.unlink()
            n_left = self.kill_after(n_killed, "--resume")
            self.assertTrue(n_killed <= n_left < n_points, "the run was over before it was killed")
            said = self.resume("--resume")
            self.assertIn("resuming with the operating points in", said)
            self.assertIn(f"; {n_points - n_left} were computed", said)
            self.assertEqual(self.results(), expected)

    def test_a_finished_run_has_nothing_to_do(self):
        self.resume()
        expected = self.results()
        for ranks in (1, 2):
            said = self.resume("--resume", ranks=ranks)
            self.assertIn("nothing was left to compute", said)
            self.assertIn("condensation of interface mesh 1 read from", said)
            self.assertEqual(self.results(), expected)
        self.assertIn("were computed", self.resume("--resume", "--set", "Friction/Dynamic coefficient = 0.39"))

    def test_what_is_damaged_is_computed_anew(self):
        self.resume()
        expected = self.results()
        cut, changed = sorted(self.finished())[:2]
        cut.write_bytes(cut.read_bytes()[:1000])
        for path in (changed, self.folder / "kept" / "interface_mesh_0"):
            content = bytearray(path.read_bytes())
            content[len(content) // 2] ^= 1
            path.write_bytes(content)
        said = self.resume("--resume")
        self.assertIn("2 kept operating points were damaged: computed anew", said)
        self.assertIn("interface_mesh_0 is damaged: computed anew", said)
        self.assertIn("; 2 were computed", said)
        self.assertEqual(self.results(), expected)

    def test_options_that_do_not_go_together(self):
        for program, options, said in ((STATOR, ["--resume"], "--resume is not available for the program stator"),
                                       (CONTACT, ["--resume", "--check"], "--resume cannot be combined with --check")):
            done = run(program, STATIC_ROTOR, *options, "--output", self.case)
            self.assertEqual(done.returncode, 1)
            self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
            self.assertIn(said, done.stderr)


if __name__ == "__main__":
    unittest.main()
