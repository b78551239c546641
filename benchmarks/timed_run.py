# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs a program on one thread for each rank and times it from outside, for the benchmarks."""
import os
import pathlib
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
MOTOR = ROOT / "prm" / "canon_ring.prm"


def program(name):
    """The path of a program; ends the benchmark if it is not built."""
    path = ROOT / "build" / "bin" / name
    if not path.exists():
        sys.exit(f"build/bin/{name} is missing: run scripts/setup.sh")
    return path


def timed_run(name, folder, entries, n_ranks=1):
    """One run on the reference motor; returns wall seconds and largest resident set in MB (of the launcher
    where there are several ranks)."""
    command = [str(program(name)), str(MOTOR), "--output", folder]
    for entry, value in entries.items():
        command += ["--set", f"{entry} = {value}"]
    environment = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")
    if n_ranks > 1:
        environment.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
        command = ["mpirun", "--oversubscribe", "-n", str(n_ranks)] + command
    begin = time.perf_counter()
    process = subprocess.Popen(command, env=environment, stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        sys.exit(f"failed: {' '.join(command)}")
    return time.perf_counter() - begin, usage.ru_maxrss / 1000.0
