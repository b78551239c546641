# SPDX-License-Identifier: LGPL-2.1-or-later
"""Many motors on many cores or machines, by Dask: each through the three programs, once and for all in its folder."""
import difflib
import hashlib
import json
import logging
import pathlib
import shutil
import subprocess
import tempfile
from dataclasses import dataclass

import dask
import motor_task
from case import CaseError, entries_of
from distributed import Client, LocalCluster, UploadFile, as_completed
from motor_task import Task, find_wave, known_outcome, run_motor

# Sections of which the program stator reads nothing: motors that differ in these alone have the same wave. The program
# contact refuses a wave that is not its own.
AFTER_THE_WAVE = ("Rotor/", "Materials/Rotor metal/", "Loading/", "Friction/", "Initial deformation/", "Contact/", "Time/")
NO_FIELDS = {"Output/VTU": "false", "Output/Figures": "false"}
RETRIES = 2  # where a worker is lost


@dataclass(frozen=True)
class Motor:
    """One of many: entries that vary, and the tasks for its wave and for all the rest, which are the same if no more than
    the wave is asked for."""

    varied: tuple
    wave: Task
    task: Task

    @property
    def folder(self):
        return pathlib.Path(self.task.folder)

    @property
    def is_wave_only(self):
        return self.task == self.wave

    def is_known(self):
        """Whether an earlier run has computed it."""
        return known_outcome(self.folder / ("wave.json" if self.is_wave_only else "motor.json")) is not None


class Family:
    """Motors that have a parameter file and the options of the command line in common."""

    def __init__(self, prm, settings, output, programs):
        self.prm, self.settings = pathlib.Path(prm).resolve(), {**NO_FIELDS, **settings}
        self.output, self.programs = pathlib.Path(output).resolve(), pathlib.Path(programs).resolve()
        try:
            text = self.prm.read_text(encoding="utf-8")
            defaults = entries_of(self.said("--help").splitlines())
            self.entries = {**defaults, **entries_of(text.splitlines())}
            self.basis = self.said("--version") + text
        except (OSError, ValueError, LookupError, subprocess.CalledProcessError) as error:
            raise CaseError(f"{' '.join(str(error).split())}; check the name of the parameter file, and run "
                            "scripts/setup.sh if the programs are not built") from None
        for entry in settings:
            self.check_name("--set", entry)
        self.entries.update(self.settings)

    def said(self, option):
        return subprocess.run([self.programs / "contact", option], capture_output=True, encoding="utf-8", check=True).stdout

    def check_name(self, option, entry):
        """@throws CaseError if there is no such entry"""
        if entry not in self.entries:
            near = difflib.get_close_matches(entry, self.entries, 1)
            raise CaseError(f'{option} "{entry}": there is no such entry' + (f'; did you mean "{near[0]}"?' if near else
                            "; doc/parameters.md lists all"))

    def motor(self, varied, wave_only=False, **settings):
        """A motor with entries that vary (entry -> text), and further settings of its own."""
        entries = {**self.settings, **settings, **varied}
        wave = self.task("waves", {entry: text for entry, text in entries.items()
                                   if not entry.startswith(AFTER_THE_WAVE)})
        return Motor(tuple(varied.items()), wave, wave if wave_only else self.task("motors", entries))

    def task(self, kind, entries):
        """In a folder that is named by all that its results depend on, so that nothing is computed twice."""
        decisive = {entry: text for entry, text in entries.items() if entry != "Accuracy/Time limit"}
        name = hashlib.sha256((self.basis + json.dumps(decisive, sort_keys=True)).encode()).hexdigest()[:12]
        return Task(str(self.programs), str(self.prm), tuple(entries.items()), str(self.output / kind / name))


class Engine:
    """Workers on the cores of this machine, or those of a Dask scheduler that runs already."""

    def __init__(self, n_workers, scheduler=None):
        dask.config.set({"distributed.comm.timeouts.connect": "10s"})
        logging.getLogger("distributed").setLevel(logging.CRITICAL)
        self.cluster, self.scratch = None, None
        if not scheduler:
            self.scratch = tempfile.mkdtemp(prefix="ringmotor_workers_")
            self.cluster = LocalCluster(n_workers=n_workers, threads_per_worker=1, dashboard_address=":0",
                                        silence_logs=logging.CRITICAL, local_directory=self.scratch)
        try:
            self.client = Client(self.cluster or scheduler)
        except (OSError, ValueError) as error:
            raise CaseError(f'--scheduler "{scheduler}" does not answer ({" ".join(str(error).split())}); start it '
                            "with: dask-scheduler") from None
        self.client.register_worker_plugin(UploadFile(motor_task.__file__), name="motor_task")
        self.motors, self.done = {}, as_completed(raise_errors=False)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.client.close()
        if self.cluster:
            self.cluster.close()
            shutil.rmtree(self.scratch, ignore_errors=True)

    def n_workers(self):
        return max(1, sum(worker["nthreads"] for worker in self.client.scheduler_info()["workers"].values()))

    def submit(self, motor):
        # Dask would take an argument that is a key for the result of that key: keys are no folders.
        wave = self.client.submit(find_wave, motor.wave, key=f"find {motor.wave.folder}", retries=RETRIES)
        future = wave if motor.is_wave_only else self.client.submit(
            run_motor, motor.task, motor.wave.folder, wave, key=f"run {motor.task.folder}", retries=RETRIES)
        if future.key in self.motors:
            return
        self.motors[future.key] = motor
        self.done.add(future)

    def next_done(self):
        """Waits for one of the motors submitted; it, and its outcome. @throws CaseError if workers failed on it"""
        future = next(self.done)
        motor = self.motors.pop(future.key)
        try:
            return motor, future.result()
        except Exception as error:  # of whatever kind a worker meets
            raise CaseError(f"{motor.folder}: {type(error).__name__}: {' '.join(str(error).split())}") from None
