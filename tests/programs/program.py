# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the tests of the programs share."""
import base64
import csv
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest
import zlib

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
STATIC_ROTOR = ROOT / "tests" / "programs" / "static_rotor.prm"


def run(*command, file_size_limit=None):
    if file_size_limit is not None:
        command = ("bash", "-c", f"ulimit -f {file_size_limit}; \"$@\"", "bash", *command)
    environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    return subprocess.run([str(part) for part in command], capture_output=True, text=True, timeout=250,
                          env=environment)


def on_ranks(n_ranks):
    """The words before those of a program that runs on so many ranks."""
    return ["mpirun", "--oversubscribe", "-n", n_ranks] if n_ranks > 1 else []


def rows_of(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def settings(*entries):
    """Options that change entries of the parameter file."""
    return [part for entry in entries for part in ("--set", entry)]


def vtu_array(path, name, dtype=np.float32):
    """An array of a VTU file by its name; "" for the positions."""
    text = path.read_text()
    tag = text.index(f'Name="{name}"' if name else "<Points>")
    code = text[text.index("\n", text.index("binary", tag)):].split(maxsplit=1)[0]
    return np.frombuffer(zlib.decompress(base64.b64decode(code[24:])), dtype)


class WithWave(unittest.TestCase):
    """Has a case in which the program `stator` has run."""

    stator = None  # the program, to be named by the tests

    @classmethod
    def setUpClass(cls):
        cls.case = pathlib.Path(tempfile.mkdtemp())
        done = run(cls.stator, STATIC_ROTOR, "--output", cls.case)
        assert done.returncode == 0, done.stderr

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.case)
