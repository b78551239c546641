# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a worker does for one motor of many. Of the standard library alone: workers receive this file and no other."""
import ctypes
import json
import os
import pathlib
import shutil
import signal
import subprocess
import threading
import time
from dataclasses import asdict, dataclass

TERMINATE_WITH_PARENT = 1  # PR_SET_PDEATHSIG
OUTCOMES = {0: "certified", 1: "refused", 2: "failed"}


@dataclass(frozen=True)
class Task:
    """A parameter file with the entries that differ from it, (entry, text) each, and the folder of its results."""

    programs: str
    prm: str
    entries: tuple
    folder: str


@dataclass(frozen=True)
class Outcome:
    """How a program ended: certified, refused (a mistake in the input) or failed; seconds of all that was done for it."""

    outcome: str
    program: str
    seconds: float
    message: str = ""


def die_with_parent():
    """A program must not go on, and lock its folder, when its worker is killed."""
    ctypes.CDLL(None).prctl(TERMINATE_WITH_PARENT, signal.SIGKILL)


def run_program(name, task, *words):
    command = [os.path.join(task.programs, name), task.prm, "--output", task.folder, *words]
    for entry, value in task.entries:
        command += ["--set", f"{entry} = {value}"]
    begin = time.monotonic()
    done = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, encoding="utf-8", errors="replace",
                          preexec_fn=die_with_parent, check=False,
                          env=dict(os.environ, OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1"))
    said = [line for line in done.stderr.splitlines() if line.strip()]
    speaker, _, message = said[-1].partition(": ") if said and done.returncode else (name, "", "")
    if done.returncode not in OUTCOMES:  # killed: not an outcome, the engine tries again
        raise RuntimeError(f"{name} ended with status {done.returncode} {message}")
    return Outcome(OUTCOMES[done.returncode], speaker, time.monotonic() - begin, message)


def known_outcome(path):
    """What an earlier run has noted in a file; None if there is nothing, or the limit of time was exceeded."""
    if not path.exists():
        return None
    found = Outcome(**json.loads(path.read_text(encoding="utf-8")))
    return None if "Accuracy/Time limit" in found.message else found


def once(path, compute):
    """The outcome that is known or that of compute(), which is noted when it is there."""
    if found := known_outcome(path):
        return found
    found = compute()
    path.parent.mkdir(parents=True, exist_ok=True)
    part = path.with_suffix(f".{os.getpid()}.{threading.get_ident()}.part")
    part.write_text(json.dumps(asdict(found)), encoding="utf-8")
    part.replace(path)
    return found


def find_wave(task):
    """The wave of a stator, on which several motors may run."""
    return once(pathlib.Path(task.folder) / "wave.json", lambda: run_program("stator", task))


def run_on_wave(task, wave_folder):
    folder = pathlib.Path(task.folder)
    part = folder / "stator.part"
    shutil.rmtree(part, ignore_errors=True)
    shutil.rmtree(folder / "stator", ignore_errors=True)
    shutil.copytree(pathlib.Path(wave_folder) / "stator", part)
    part.rename(folder / "stator")
    kept = folder / "contact" / "kept"
    found = run_program("motor", task, "--from", "contact", *(["--resume"] if kept.is_dir() else []))
    if found.outcome == "certified":
        shutil.rmtree(kept, ignore_errors=True)  # large, and of no use to any other motor
    return found


def run_motor(task, wave_folder, wave):
    """Contact and losses of a motor whose wave find_wave() has looked for; its outcome with all seconds but those of
    the wave."""
    if wave.outcome != "certified":
        return Outcome(wave.outcome, wave.program, 0., wave.message)
    return once(pathlib.Path(task.folder) / "motor.json", lambda: run_on_wave(task, wave_folder))
