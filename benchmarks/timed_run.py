# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs a program on one thread for each rank and times it from outside, for the benchmarks."""
import os
import pathlib
import signal
import subprocess
import sys
import threading
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
MOTOR = ROOT / "prm" / "canon_ring.prm"


def program(name):
    """The path of a program; ends the benchmark if it is not built."""
    path = ROOT / "build" / "bin" / name
    if not path.exists():
        sys.exit(f"build/bin/{name} is missing: run scripts/setup.sh")
    return path


def timed_run(name, folder, entries, n_ranks=1, most_seconds=None):
    """One run on the reference motor; returns wall seconds and largest resident set in MB (of the launcher
    where there are several ranks). Ends the benchmark if it fails; raises TimeoutError if it takes too long."""
    command = [str(program(name)), str(MOTOR), "--output", folder]
    for entry, value in entries.items():
        command += ["--set", f"{entry} = {value}"]
    environment = dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1")
    if n_ranks > 1:
        environment.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
        command = ["mpirun", "--oversubscribe", "-n", str(n_ranks)] + command
    begin = time.perf_counter()
    process = subprocess.Popen(command, env=environment, stdout=subprocess.DEVNULL)
    killer = threading.Timer(most_seconds, process.kill) if most_seconds else None
    if killer:
        killer.start()
    _, status, usage = os.wait4(process.pid, 0)
    if killer:
        killer.cancel()
    if status == signal.SIGKILL and most_seconds:
        raise TimeoutError(f"more than {most_seconds} s: {' '.join(command)}")
    if status != 0:
        sys.exit(f"failed: {' '.join(command)}")
    return time.perf_counter() - begin, usage.ru_maxrss / 1000.0
