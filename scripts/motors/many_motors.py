# SPDX-License-Identifier: LGPL-2.1-or-later
"""Many motors on many cores or machines, by Dask: each through the three programs, once and for all in its folder."""
import collections
import difflib
import logging
import pathlib
import shutil
import tempfile
import time
from dataclasses import dataclass

import dask
import motor_task
from distributed import Client, LocalCluster, as_completed
from motor_task import Outcome, Task, find_wave, known_outcome, run_motor
from running.programs import CaseError, Identities, described, options_of, without_wave

NO_FIELDS = {"Output/VTU": "false", "Output/Figures": "false"}
RETRIES = 2  # where a worker is lost
PATIENCE = 0.02  # seconds between looks at what is done
INTERVAL = 2.  # seconds between looks at the workers


@dataclass(frozen=True, eq=False)
class Motor:
    """One of many: entries that vary, and the tasks for its wave and for all the rest, which are the same if no more than
    the wave is asked for; or what is wrong with the entries."""

    varied: tuple
    wave: Task = None
    task: Task = None
    refusal: Outcome = None

    @property
    def folder(self):
        """None of a motor that is refused."""
        return pathlib.Path(self.task.folder) if self.task else None

    @property
    def key(self):
        """Motors that have the same key are the same motor."""
        return str(self.folder or self.varied)

    @property
    def is_wave_only(self):
        return self.task == self.wave

    def is_known(self):
        """Whether an earlier run has computed it."""
        return not self.refusal and known_outcome(
            self.folder / ("wave.json" if self.is_wave_only else "motor.json")) is not None


class Family:
    """Motors that have a parameter file and the options of the command line in common. What these say is asked from a
    program: the stator if no more than the wave is wanted, which needs no rotor, else the motor.

    entries   of the parameter file and the options, entry -> text
    identity  of the motor that these describe
    output    folder of all motors
    """

    def __init__(self, prm, settings, output, programs, is_wave_only=False):
        self.prm, self.programs = pathlib.Path(prm).absolute(), pathlib.Path(programs).resolve()
        self.settings, self.is_wave_only = {**NO_FIELDS, **settings}, is_wave_only
        program = self.programs / ("stator" if is_wave_only else "motor")
        said = described(program, self.prm, "--output", output, *options_of(self.settings))
        self.entries, self.missing = said["entries"], said["missing"]
        if entry := without_wave(self.entries):
            raise CaseError(f"{entry} has no wave, without which there is no motor; allowed: Modes/Body = stator with "
                            "Modes/Domain = sector")
        self.identity, self.output = said["identity"], pathlib.Path(said["folder"]).resolve()
        self.identities = Identities(program, self.prm)

    def check_name(self, option, entry):
        """@throws CaseError if there is no such entry"""
        names = [*self.entries, *self.missing]
        if entry not in names:
            near = difflib.get_close_matches(entry, names, 1)
            raise CaseError(f'{option} "{entry}": there is no such entry' + (f'; did you mean "{near[0]}"?' if near else
                            "; doc/parameters.md lists all"))

    def motor(self, varied, **settings):
        """A motor with entries that vary (entry -> text), and further settings of its own."""
        entries = {**self.settings, **settings, **varied}
        found = self.identities.of(entries)
        if "error" in found:
            return Motor(tuple(varied.items()), refusal=Outcome("refused", found["program"], 0., found["error"]))
        wave = self.task("waves", entries, found["identity"]["wave"])
        return Motor(tuple(varied.items()), wave,
                     wave if self.is_wave_only else self.task("motors", entries, found["identity"]["motor"]))

    def task(self, kind, entries, identity):
        """In a folder that is named by what its results depend on, so that nothing is computed twice."""
        return Task(str(self.programs), str(self.prm), tuple(entries.items()), str(self.output / kind / identity), identity)


class Engine:
    """Workers on the cores of this machine, or those of a Dask scheduler that runs already."""

    def __init__(self, n_workers, scheduler=None):
        dask.config.set({"distributed.comm.timeouts.connect": "10s"})
        for name in ("distributed", "distributed.client"):  # what matters is told in our words
            logging.getLogger(name).setLevel(logging.CRITICAL)
        self.scheduler, self.cluster, self.scratch = scheduler, None, None
        if not scheduler:
            self.scratch = tempfile.mkdtemp(prefix="ringmotor_workers_")
            self.cluster = LocalCluster(n_workers=n_workers, threads_per_worker=1, dashboard_address=":0",
                                        silence_logs=logging.CRITICAL, local_directory=self.scratch)
        try:
            self.client = Client(self.cluster or scheduler)
        except (OSError, ValueError) as error:
            raise CaseError(f'--scheduler "{scheduler}" does not answer ({" ".join(str(error).split())}); start it '
                            "with: dask-scheduler") from None
        self.client.upload_file(motor_task.__file__)  # to the scheduler as well, and to workers to come
        self.running, self.done = {}, as_completed(raise_errors=False)  # motors, by the key of their future
        self.finished = collections.deque()
        self.is_waiting, self.next_look = False, time.monotonic()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.client.close()
        if self.cluster:
            self.cluster.close()
            shutil.rmtree(self.scratch, ignore_errors=True)

    def workers(self):
        """@throws CaseError if the scheduler has gone"""
        try:
            return self.client.scheduler_info()["workers"].values()
        except (OSError, LookupError):
            raise self.gone() from None

    def gone(self):
        return CaseError(f"the scheduler {self.scheduler or ''} does not answer any more; start it, and the sweep, again to "
                         "go on")

    def n_workers(self):
        return max(1, sum(worker["nthreads"] for worker in self.workers()))

    def submit(self, motor):
        """next_done() gives each motor once; those that are the same are computed once."""
        if motor.refusal:
            self.finished.append((motor, motor.refusal))
            return
        # Dask would take an argument that is a key for the result of that key: keys are no folders.
        wave = self.client.submit(find_wave, motor.wave, key=f"find {motor.wave.folder}", retries=RETRIES)
        future = wave if motor.is_wave_only else self.client.submit(
            run_motor, motor.task, motor.wave.folder, wave, key=f"run {motor.task.folder}", retries=RETRIES)
        if future.key not in self.running:
            self.running[future.key] = []
            self.done.add(future)
        self.running[future.key].append(motor)

    def tell_if_no_workers(self):
        if time.monotonic() < self.next_look:
            return
        self.next_look = time.monotonic() + INTERVAL
        was_waiting, self.is_waiting = self.is_waiting, not self.workers()
        if self.is_waiting and not was_waiting:
            how = f"start some with: dask-worker {self.scheduler}" if self.scheduler else "they are started again"
            print(f"waiting for workers, of which there are none: {how}", flush=True)

    def next_done(self):
        """Waits for one of the motors submitted; it, and its outcome. @throws CaseError if workers failed on it"""
        if not self.finished:
            while not self.done.has_ready():
                self.tell_if_no_workers()
                time.sleep(PATIENCE)
            future = next(self.done)
            motors = self.running.pop(future.key)
            self.finished += [(motor, self.outcome_of(future, motor)) for motor in motors]
        return self.finished.popleft()

    def outcome_of(self, future, motor):
        try:
            outcome = future.result()
        except Exception as error:  # of whatever kind a worker meets
            if self.client.status != "running":
                raise self.gone() from None
            raise CaseError(f"{motor.folder}: {type(error).__name__}: {' '.join(str(error).split())}") from None
        if outcome.outcome == "changed":
            raise CaseError("the parameter file, a file that it names, or the programs have changed meanwhile; start it "
                            "again to go on with what is there now")
        return outcome
