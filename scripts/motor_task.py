# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a worker does for one motor of many. Of the standard library alone: workers receive this file and no other,
and import it by its name, so that it is in no folder of modules."""
import ctypes
import json
import os
import pathlib
import shutil
import signal
import subprocess
import threading
import time
from dataclasses import asdict, dataclass, field

TERMINATE_WITH_PARENT = 1  # PR_SET_PDEATHSIG
OUTCOMES = {0: "certified", 1: "refused", 2: "failed"}
RESULTS = ("stator", "contact", "losses")  # folders of the programs
# What mpirun, srun and their like tell the processes that they start.
LAUNCHERS = ("PMIX_", "PMI_", "ORTE_", "PRTE_LAUNCHED", "OMPI_COMM_", "MPI_LOCAL", "MV2_COMM_", "JSM_NAMESPACE_",
             "FLUX_", "PALS_", "SLURM_PROCID", "SLURM_NTASKS", "SLURM_STEP_")
OF_THE_USER = "OMPI_ALLOW_RUN_AS_ROOT"


@dataclass(frozen=True)
class Task:
    """A parameter file with the entries that differ from it, (entry, text) each, the folder of the results and what
    identifies them in the summary of the last program."""

    programs: str
    prm: str
    entries: tuple
    folder: str
    identity: str


@dataclass(frozen=True)
class Outcome:
    """How a program ended: certified, refused (a mistake in the input), failed, or changed (the input is not that of the
    task any more); seconds of all that was done for it; sizes of the files of results by their names."""

    outcome: str
    program: str
    seconds: float
    message: str = ""
    files: dict = field(default_factory=dict)


def without_launcher(environment):
    """The environment for a program that is started alone: it must not take itself for one of the processes that mpirun
    or srun has started, such as a worker."""
    mine = LAUNCHERS + (("OMPI_",) if "OMPI_COMM_WORLD_SIZE" in environment else ())
    return {name: text for name, text in environment.items() if name.startswith(OF_THE_USER) or not name.startswith(mine)}


def die_with_parent():
    """A program must not go on, and lock its folder, when its worker is killed."""
    ctypes.CDLL(None).prctl(TERMINATE_WITH_PARENT, signal.SIGKILL)


def run_program(name, task, *words):
    command = [os.path.join(task.programs, name), task.prm, "--output", task.folder, *words]
    for entry, value in task.entries:
        command += ["--set", f"{entry} = {value}"]
    begin = time.monotonic()
    done = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                          encoding="utf-8", errors="replace", preexec_fn=die_with_parent, check=False,
                          env=dict(without_launcher(os.environ), OMP_NUM_THREADS="1", OPENBLAS_NUM_THREADS="1"))
    said = [line for line in done.stderr.splitlines() if line.strip()]
    speaker, _, message = said[-1].partition(": ") if said and done.returncode else (name, "", "")
    if done.returncode not in OUTCOMES:  # killed: not an outcome, the engine tries again
        raise RuntimeError(f"{name} ended with status {done.returncode} {message}")
    return Outcome(OUTCOMES[done.returncode], speaker, time.monotonic() - begin, message)


def sizes_of(folder):
    """The files of the results in the folder of a motor."""
    return {str(path.relative_to(folder)): path.stat().st_size for name in RESULTS
            for path in sorted((folder / name).glob("*")) if path.is_file()}


def known_outcome(path):
    """What an earlier run has noted in a file; None if there is nothing, if this or a file of the results is damaged, or
    if the limit of time was exceeded."""
    try:
        found = Outcome(**json.loads(path.read_text(encoding="utf-8")))
        if found.outcome not in OUTCOMES.values() or "Accuracy/Time limit" in found.message or found.seconds < 0:
            return None
        return found if found.outcome != "certified" or found.files == sizes_of(path.parent) else None
    except (OSError, ValueError, TypeError):
        return None


def write(path, text):
    """All or nothing, also if the power fails."""
    part = path.with_suffix(f".{os.getpid()}.{threading.get_ident()}.part")
    with open(part, "w", encoding="utf-8") as file:
        file.write(text)
        file.flush()
        os.fsync(file.fileno())
    part.replace(path)


def checked(found, task, program, kind):
    """The outcome with the files that belong to it; "changed" if the program has read something else than the task was
    made for: the parameter file, a mesh file or the program is another one by now."""
    if found.outcome != "certified":
        return found
    folder = pathlib.Path(task.folder)
    if json.loads((folder / program / "summary.json").read_text(encoding="utf-8"))["identity"][kind] != task.identity:
        return Outcome("changed", program, found.seconds)
    return Outcome(found.outcome, found.program, found.seconds, found.message, sizes_of(folder))


def once(path, compute):
    """The outcome that is known or that of compute(), which is noted when it is there."""
    if found := known_outcome(path):
        return found
    found = compute()
    if found.outcome != "changed":
        path.parent.mkdir(parents=True, exist_ok=True)
        write(path, json.dumps(asdict(found)))
    return found


def find_wave(task):
    """The wave of a stator, on which several motors may run."""
    return once(pathlib.Path(task.folder) / "wave.json",
                lambda: checked(run_program("stator", task), task, "stator", "wave"))


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
    return checked(found, task, "losses", "motor")


def run_motor(task, wave_folder, wave):
    """Contact and losses of a motor whose wave find_wave() has looked for; its outcome with all seconds but those of
    the wave."""
    if wave.outcome != "certified":
        return Outcome(wave.outcome, wave.program, 0., wave.message)
    return once(pathlib.Path(task.folder) / "motor.json", lambda: run_on_wave(task, wave_folder))
