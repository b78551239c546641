#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The three programs one after the other, interrupted again and again.

Usage: tests/programs/interruption.py STATOR CONTACT LOSSES [unittest arguments]

What is compared: every file that an interruption at a random moment has left is complete; what is resumed has the
numbers of a run that nobody has interrupted.
"""
import os
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time
import unittest

sys.dont_write_bytecode = True  # a test leaves nothing in the source tree
from complete_files import check_complete  # noqa: E402
from program import STATIC_ROTOR, rows_of  # noqa: E402

PROGRAMS = [sys.argv.pop(1) for _ in range(3)]


def start(folder, *options):
    """All programs, as long as none fails, in a process group of their own."""
    commands = [f'"{program}" "{STATIC_ROTOR}" --output "{folder}"' for program in PROGRAMS]
    commands[1] += " " + " ".join(options)
    return subprocess.Popen(["bash", "-c", " && ".join(commands)], stdout=subprocess.DEVNULL, start_new_session=True)


def numbers(folder):
    """All results but the seconds."""
    found = []
    for path in ("stator/frequencies.csv", "stator/ellipses.csv", "contact/torque_speed.csv", "contact/history.csv",
                 "losses/losses.csv", "losses/efficiency.csv"):
        found += [{key: value for key, value in row.items() if key != "seconds"} for row in rows_of(folder / path)]
    return found


class Interruption(unittest.TestCase):
    def test_leaves_complete_files_and_is_resumed(self):
        with tempfile.TemporaryDirectory() as scratch:
            undisturbed, disturbed = pathlib.Path(scratch) / "undisturbed", pathlib.Path(scratch) / "disturbed"
            begin = time.monotonic()
            self.assertEqual(start(undisturbed).wait(), 0)
            seconds = time.monotonic() - begin
            n_seen, seed = 0, random.randrange(10**6)
            print(f"moments of seed {seed}", file=sys.stderr)
            dice = random.Random(seed)
            for how in (signal.SIGINT, signal.SIGKILL) * 4:
                run = start(disturbed, "--resume")
                try:
                    run.wait(timeout=dice.uniform(0.1, 1.) * seconds)
                except subprocess.TimeoutExpired:
                    os.killpg(run.pid, how)
                run.wait()
                for path in (path for path in disturbed.rglob("*") if path.is_file()):
                    check_complete(path)
                    n_seen += 1
            self.assertGreater(n_seen, 10)
            self.assertEqual(start(disturbed, "--resume").wait(), 0)
            self.assertEqual(numbers(disturbed), numbers(undisturbed))
            self.assertEqual(list(disturbed.rglob("*.part")), [])


if __name__ == "__main__":
    unittest.main()
