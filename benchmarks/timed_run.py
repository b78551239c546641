# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs a program on one thread for each rank and times it from outside, for the benchmarks."""
import json
import os
import pathlib
import resource
import signal
import subprocess
import sys
import tempfile
import threading
import time
from dataclasses import dataclass

ROOT = pathlib.Path(__file__).resolve().parent.parent
PROGRAMS = ROOT / "build" / "bin"
MOTOR = ROOT / "prm" / "soft_spring.prm"
# That motor leaves its effects to the programs; the tables of the documents are those of the paper's model.
PAPERS_MODEL = {f"Effects/{name}": "off" for name in
                ("Rotor inertia", "Tooth inertia", "Tooth vibration", "Damping", "Stator back-reaction", "Spin convection",
                 "Target plates", "Felt support", "Friction lining")}
AUTO = {entry: "auto" for entry in PAPERS_MODEL if entry != "Effects/Target plates"}  # which are on or off
PAPERS_MODEL["Accuracy/Contact target"] = "0.03"


def program(name, programs=PROGRAMS):
    """The path of a program; ends the benchmark if it is not built."""
    path = pathlib.Path(programs) / name
    if not path.exists():
        sys.exit(f"{path} is missing: run scripts/setup.sh")
    return path


def entries_of(motor, programs=PROGRAMS):
    """All entries of a parameter file, as a program reads it: {'Section/Entry': 'value'}."""
    done = subprocess.run([program("stator", programs), motor, "--check=json"], check=True, stdout=subprocess.PIPE)
    return json.loads(done.stdout)["entries"]


def arguments(motor, folder, entries):
    """What stands on the command line behind the name of the program."""
    words = [str(motor)]
    if pathlib.Path(motor).resolve() == MOTOR:
        entries = {**PAPERS_MODEL, **entries}
    for entry, value in entries.items():
        words += ["--set", f"{entry} = {value}"]
    return words + ["--output", str(folder)]


def teeth(number):
    """Entries of the reference motor with another number of teeth; slots keep their share of the pitch."""
    return {"Motor/Number of teeth": str(number), "Stator/Slot width": repr(0.6e-3 * 90 / number)}


def on_ranks(n_ranks):
    """What stands before a program that runs on so many ranks."""
    return ["mpirun", "--oversubscribe", "--bind-to", "none", "-n", str(n_ranks)] if n_ranks > 1 else []


@dataclass
class Run:
    """How a run ended."""
    status: int  # exit status; minus the number of the signal that ended it
    seconds: float  # on the clock
    processor_seconds: float
    memory: float  # largest resident set, MB; of the launcher where there are several ranks
    message: str  # the last line that the program wrote: of an ended one to its error stream
    is_too_long: bool  # it was ended because it exceeded its limit


def _limit_processor_time(most_seconds):
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_CPU, (max(1, round(most_seconds)), round(most_seconds) + 5))


def _last_line(stream):
    stream.seek(0)
    lines = [line.strip() for line in stream.read().decode(errors="replace").splitlines() if line.strip()]
    return lines[-1] if lines else ""


def limited_run(command, most_seconds=None, most_clock_seconds=None, most_threads=1):
    """Runs a command to its end or up to a limit of processor time, of time on the clock, or both. The first
    does not depend on what else the machine does, the second also ends a process that waits for ever.
    @param most_threads None: as the command chooses"""
    environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    if most_threads:
        environment.update(OMP_NUM_THREADS=str(most_threads), OPENBLAS_NUM_THREADS=str(most_threads))
    with tempfile.TemporaryFile() as output, tempfile.TemporaryFile() as errors:
        begin = time.perf_counter()
        process = subprocess.Popen(command, env=environment, stdout=output, stderr=errors,
                                   preexec_fn=most_seconds and (lambda: _limit_processor_time(most_seconds)))
        killer = threading.Timer(most_clock_seconds, process.kill) if most_clock_seconds else None
        if killer:
            killer.start()
        _, status, usage = os.wait4(process.pid, 0)
        seconds = time.perf_counter() - begin
        if killer:
            killer.cancel()
        process.returncode = os.waitstatus_to_exitcode(status)  # known to Popen, which must not wait again
        said, complained = _last_line(output), _last_line(errors)
    is_too_long = process.returncode == -signal.SIGXCPU or (
        process.returncode == -signal.SIGKILL and
        (bool(most_clock_seconds) and seconds >= most_clock_seconds or
         bool(most_seconds) and usage.ru_utime + usage.ru_stime >= most_seconds))
    return Run(process.returncode, seconds, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1000.,
               "last line: " + said if is_too_long else complained, is_too_long)


def timed_run(name, folder, entries, n_ranks=1, most_seconds=None):
    """One run on the reference motor; returns wall seconds and largest resident set in MB (of the launcher
    where there are several ranks). Ends the benchmark if it fails; raises TimeoutError if it takes too long."""
    command = on_ranks(n_ranks) + [str(program(name))] + arguments(MOTOR, folder, entries)
    run = limited_run(command, most_clock_seconds=most_seconds)
    if run.is_too_long:
        raise TimeoutError(f"more than {most_seconds} s: {' '.join(command)}")
    if run.status != 0:
        sys.exit(f"failed: {' '.join(command)}\n{run.message}")
    return run.seconds, run.memory
