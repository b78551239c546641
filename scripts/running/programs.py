# SPDX-License-Identifier: LGPL-2.1-or-later
"""The programs, and what they say of a motor without computing anything. Scripts read no parameter file themselves."""
import contextlib
import json
import os
import pathlib
import stat
import subprocess
import weakref

from motor_task import without_launcher

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Installed, the programs are not beside the sources.
PROGRAMS = ROOT / "build" / "bin" if (ROOT / "CMakeLists.txt").exists() else ROOT.parent.parent / "bin"


class CaseError(Exception):
    """What cannot be done or shown; the text is one line for the user."""


class Refusal(CaseError):
    """The same in the words of a program, which begin with its name."""


def options_of(entries):
    """Entry -> text, as options of a program."""
    return [word for entry, text in entries.items() for word in ("--set", f"{entry} = {text}")]


def refuse_pipe(path):
    """@throws CaseError for a parameter file that vanishes while it is read: several programs read it"""
    try:
        mode = os.stat(path).st_mode
    except OSError:
        return  # the programs say what is wrong with it
    if stat.S_ISFIFO(mode) or stat.S_ISSOCK(mode):
        raise CaseError(f"{path} is a pipe, which can be read only once; write the parameters to a file first")


def started(program, words, **options):
    """The process of a program. @throws CaseError if there is none"""
    try:
        return subprocess.Popen([*map(str, words)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                encoding="utf-8", errors="replace", env=without_launcher(os.environ), **options)
    except OSError as error:
        raise CaseError(f"the program {program} cannot be started ({error.strerror}); scripts/setup.sh builds it") from None


def words_of(errors, status):
    """The line in which a program has told a mistake."""
    lines = [line for line in errors.splitlines() if line.strip()]
    return lines[-1] if lines else f"ended with status {status}"


def described(program, prm, *options, form="json", launcher=(), timeout=None):
    """What a program has read from a parameter file, or the sections in it, see --check=json and --check=sections in
    doc/files.md. @throws Refusal in its words, and CaseError if it does not answer"""
    refuse_pipe(prm)
    process = started(program, [*launcher, program, prm, *options, f"--check={form}"])
    try:
        said, errors = process.communicate(timeout=timeout)
    except subprocess.TimeoutExpired:
        process.terminate()  # so that mpirun ends what it has started
        with contextlib.suppress(subprocess.TimeoutExpired):
            process.communicate(timeout=5)
        process.kill()
        raise CaseError(f"{program} does not answer") from None
    if process.returncode != 0:
        raise Refusal(words_of(errors, process.returncode))
    try:
        return json.loads(said)
    except ValueError:  # of several processes at once, or of another program
        raise CaseError(f"{program} --check={form} has printed no JSON") from None


def without_wave(entries):
    """The entry with which `stator` finds no wave of a motor, or an empty text."""
    return next((f"{entry} = {entries[entry]}" for entry, needed in (("Modes/Body", "stator"), ("Modes/Domain", "sector"))
                 if entries[entry] != needed), "")


def end(process):
    """A program that reads lines ends when there are no more."""
    for stream in (process.stdin, process.stdout, process.stderr):
        with contextlib.suppress(OSError):
            stream.close()
    process.wait()


class Identities:
    """A program that says what identifies a motor with further entries, one after the other."""

    def __init__(self, program, prm, *options):
        refuse_pipe(prm)
        self.program = program
        self.process = started(program, [program, prm, *options, "--check=lines"])
        weakref.finalize(self, end, self.process)

    def of(self, entries):
        """@param entries entry -> text @return "identity", or "program" and "error" if something is wrong with them"""
        try:
            self.process.stdin.write(json.dumps([f"{entry} = {text}" for entry, text in entries.items()]) + "\n")
            self.process.stdin.flush()
            return json.loads(self.process.stdout.readline())
        except (OSError, ValueError):
            _, errors = self.process.communicate()
            raise Refusal(words_of(errors, self.process.returncode)) from None
