# SPDX-License-Identifier: LGPL-2.1-or-later
"""What scripts/run.sh does when the programs are built, see there: from a parameter file to a report."""
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import types

sys.dont_write_bytecode = True
from running import surroundings  # noqa: F401
from motor_task import without_launcher
from results.page_file import refuse_foreign
from running.programs import PROGRAMS, CaseError, Refusal, described, refuse_pipe, without_wave

SCRIPTS = pathlib.Path(__file__).resolve().parent
MOST_RANKS = 4  # that share the work of a motor; a fifth one would find little left of it
PATIENCE = 60.  # seconds for mpirun to start
# What mpirun and the ranks are told, in variables: an MPI ignores those that it does not know. Ranks are not bound to cores
# that other runs may have been bound to, nproc counts more than the slots of mpirun, and containers forbid the fast way of
# copying between processes.
OPEN_MPI = ("OMPI_MCA_mpi_yield_when_idle=1",)
OPEN_MPI_4 = ("OMPI_MCA_hwloc_base_binding_policy=none", "OMPI_MCA_rmaps_base_oversubscribe=1",
              "OMPI_MCA_btl_vader_single_copy_mechanism=none")
OPEN_MPI_5 = ("PRTE_MCA_hwloc_default_binding_policy=none", "PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe",
              "OMPI_MCA_smsc=^cma")
AS_ROOT = ("OMPI_ALLOW_RUN_AS_ROOT=1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1")
# How launchers tell a process the number of processes and its own among them.
COPIES = (("OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_RANK"), ("PMI_SIZE", "PMI_RANK"),
          ("SLURM_STEP_NUM_TASKS", "SLURM_PROCID"))


class Interruption:
    """The programs end by themselves when they are interrupted; what would come after them does not begin."""

    def __init__(self):
        self.signal, self.process = None, None
        if signal.getsignal(signal.SIGINT) != signal.SIG_IGN:  # as in the background of a script
            signal.signal(signal.SIGINT, self.note)
        signal.signal(signal.SIGTERM, self.hand_on)

    def note(self, number, _):
        """Ctrl-C has reached the program as well."""
        self.signal = number

    def hand_on(self, number, _):
        self.signal = number
        if self.process:
            self.process.send_signal(number)

    def run(self, *command, stderr=None):
        """The exit status of a program, in our terminal."""
        sys.stdout.flush()
        self.process = subprocess.Popen([str(word) for word in command], env=without_launcher(os.environ), stderr=stderr)
        status = self.process.wait()
        if self.signal:
            sys.exit(128 + self.signal)
        return status if status >= 0 else 128 - status

    def run_on_ranks(self, launcher, folder, *command):
        """The same on several ranks. What they say of errors goes into a file of this folder, as mpirun adds to it, and
        loses it after Ctrl-C."""
        words, notices = folder / "words", folder / "notices"
        status = None
        try:
            with open(notices, "w", encoding="utf-8") as stderr:
                status = self.run(*launcher, "sh", "-c", 'exec "$@" 2>> "$0"', words, *command, stderr=stderr)
            return status
        finally:
            said = read(words) or ("" if status == 0 else without_words(self.signal, status, read(notices)))
            sys.stderr.write(said)

    def need(self, *command):
        """The same; ends with it if it fails."""
        status = self.run(*command)
        if status != 0:
            sys.exit(status)


def read(path):
    return path.read_text(encoding="utf-8", errors="replace") if path.exists() else ""


def without_words(is_interrupted, status, notices):
    """What is to be said of ranks that have ended before they could say anything."""
    if is_interrupted:
        return "\nrun.sh: interrupted; start it again, with --resume contact goes on at its last point\n"
    lines = [line for line in notices.splitlines() if line.strip("- ")]
    return f"run.sh: the computation ended with status {status}: {' '.join(' '.join(lines).split())}\n"


def refuse_copies():
    """Under mpirun or srun: the processes are started here. One of the copies says so."""
    size, rank = next(((size, rank) for size, rank in COPIES if size in os.environ and rank in os.environ), COPIES[0])
    if os.environ.get(size, "1") == "1":
        return
    if os.environ[rank] != "0":
        time.sleep(1)  # a launcher ends all when the first one ends
        sys.exit(1)
    raise CaseError(f"started {os.environ[size]} times ({size}); start it once, without mpirun or srun: it starts the "
                    "processes itself")


def number_of_ranks():
    return min(MOST_RANKS, int(subprocess.run(["nproc"], capture_output=True, encoding="utf-8", check=True).stdout))


def mpirun(n_ranks):
    return ["env", *OPEN_MPI, *OPEN_MPI_4, *OPEN_MPI_5, *(AS_ROOT if os.geteuid() == 0 else ()), "mpirun", "-n",
            str(n_ranks)]


def plan_and_launcher(options):
    """What the programs have read, and the words before a program on several ranks: none unless so many ranks answer as
    were asked for, as the mpirun that is found may not be that of the programs."""
    n_ranks = number_of_ranks()
    if n_ranks < 2:
        return described(PROGRAMS / "motor", *options), []
    try:
        launcher = mpirun(n_ranks)
        plan = described(PROGRAMS / "motor", *options, launcher=launcher, timeout=PATIENCE)
        if plan["ranks"] == n_ranks:
            return plan, launcher
        problem = "it belongs to another MPI"
    except CaseError as error:
        problem = error
    plan = described(PROGRAMS / "motor", *options)  # or the parameters are wrong
    print(f"run.sh: uses one core of {n_ranks}, as mpirun cannot be used ({problem})", file=sys.stderr)
    return plan, []


def is_flag(word, flags):
    return any(word == flag or word.startswith(f"{flag}=") for flag in flags)


def study(options, more):
    plan = described(PROGRAMS / "motor", *options)
    interruption = Interruption()
    interruption.need(PROGRAMS / "stator", *options, "--study", *more)
    if without_wave(plan["entries"]):
        return 0
    interruption.need(PROGRAMS / "stator", *options)  # contact needs a wave, which a study leaves none of
    interruption.need(PROGRAMS / "contact", *options, "--study", *more)
    return interruption.run(SCRIPTS / "study_figure.py", plan["folder"])


def run(options, more):
    plan, launcher = plan_and_launcher(options)
    interruption = Interruption()
    folder = pathlib.Path(plan["folder"])
    if without_wave(plan["entries"]):  # a rotor, a tooth or a whole ring, which have no figures
        return interruption.run(PROGRAMS / "stator", *options)
    # Where a program fails, the page tells so beside the results of those before it.
    page = folder / "report.html"
    refuse_foreign(page)
    page.unlink(missing_ok=True)
    with tempfile.TemporaryDirectory(prefix="ringmotor_") as scratch:
        done = pathlib.Path(scratch) / "done.json"
        command = (PROGRAMS / "motor", *options, *more, "--done", done)
        status = interruption.run_on_ranks(launcher, done.parent, *command) if launcher else interruption.run(*command)
        if not done.exists():  # the stator has failed, or another run is there
            return status
    # What cannot be drawn is missing on the page, which is there in any case.
    shown = []
    if plan["entries"]["Output/Figures"] == "true":
        shown.append(interruption.run(SCRIPTS / "figures.py", folder))
        if plan["entries"]["Output/VTU"] == "true" and status == 0 and shutil.which("pvpython"):
            # Says itself why it cannot draw, such as without a screen: no reason to call certified results a failure.
            interruption.run(SCRIPTS / "paraview_view.py", folder, "--view", "motor", "--png", folder / "figures")
        shown.append(interruption.run(SCRIPTS / "report.py", folder))
    print()
    shown.append(interruption.run(SCRIPTS / "summary.py", folder))
    return status or max(shown)


def check(words):
    """Looks at the parameters, and draws the bodies that they describe beside the results."""
    Interruption().need(PROGRAMS / "motor", *words)
    options = [word for word in words if word != "--check"]
    plan = described(PROGRAMS / "motor", *options)
    sections = described(PROGRAMS / "motor", *options, form="sections")
    if plan["entries"]["Output/Figures"] != "true" or not sections:
        return 0
    from drawing.basics import figures_folder, save  # which takes its time
    from drawing.section_figure import draw_sections
    motor = types.SimpleNamespace(motor=plan["entries"]["Motor/Name"], sections=sections,
                                  summary={**plan, "program": "motor"})
    with figures_folder(plan["folder"], "") as folder:
        save(draw_sections(motor), folder, "sections")
    print(f"drawing of the bodies: {folder}sections.png, sections.svg")
    return 0


def main(words):
    refuse_copies()
    if asked := [word for word in words if is_flag(word, ("--help", "--version"))]:
        os.execv(PROGRAMS / "contact", ["contact", asked[0]])
    for word in words:
        refuse_pipe(word)
    if "--check" in words:
        return check(words)
    if any(is_flag(word, ("--check", "--clear")) for word in words):
        os.execve(PROGRAMS / "motor", ["motor", *words], without_launcher(os.environ))
    more = [word for word in words if word in ("--resume", "--sensitivities")]
    options = [word for word in words if word not in ("--study", *more)]
    return (study if "--study" in words else run)(options, more)


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except CaseError as problem:
        sys.exit(str(problem) if isinstance(problem, Refusal) else f"run.sh: {problem}")
    except KeyboardInterrupt:
        sys.exit(128 + signal.SIGINT)
