#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Damaged parameter files, meshes and results: each has to be read or refused in words.

usage: tests/fuzz/fuzz.py READERS STATOR CONTACT [--first 1] [--count 10000] [--markdown FILE] [--found FOLDER]

READERS is the executable of readers.cc, best built with -DRINGMOTOR_SANITIZERS=ON; STATOR and CONTACT make the results
to be damaged. Input number k is drawn from k alone: `--first 17 --count 1` makes number 17 again. Before them come the
files in tests/fuzz/found, which earlier versions did not survive. What is not refused in words is copied to --found.
The exit status is 1 if there is any.
"""
import argparse
import collections
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile

import h5py
import numpy as np

sys.dont_write_bytecode = True
ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "benchmarks"))
from motor_run import table, write_markdown  # noqa: E402

MOTOR = ROOT / "tests" / "programs" / "static_rotor.prm"
MESHES = pathlib.Path(__file__).resolve().parent / "meshes"  # versions of Gmsh's format that meshes/ lacks
FOUND = MESHES.parent / "found"
NUMBERS = ("0", "-0", "-1", "1", "2", "1e-300", "1e300", "1e999", "nan", "inf", "-inf", "4294967295", "4294967296",
           "-2147483649", "18446744073709551616", "1e5", "0x10", "1,2", "1e", ".", "")
WORDS = ("set", "end", "subsection", "auto", "off", "on", "=", "#", "\\", "/", "$EndNodes", "$Elements", "\x00", "\xff",
         "%s%n", "'", '"', "a" * 5000, "é", "\u00a0", "\u2212", "~/x", "$HOME", "\ufeff")


class Dice(random.Random):
    def chance(self, probability):
        return self.random() < probability


def damaged_bytes(content, dice):
    """Bytes changed, cut out, doubled or zeroed; or the file cut off."""
    content = bytearray(content)
    for _ in range(dice.choice((1, 1, 1, 2, 5, 20))):
        begin = dice.randrange(len(content) + 1)
        end = min(len(content), begin + dice.choice((1, 1, 4, 8, 100, 5000)))
        how = dice.randrange(6)
        if how == 0:
            content[begin:end] = bytes(dice.randrange(256) for _ in range(end - begin))
        elif how == 1:
            del content[begin:end]
        elif how == 2:
            content[begin:begin] = content[begin:end]
        elif how == 3:
            content[begin:end] = bytes([dice.choice((0, 255))]) * (end - begin)
        elif how == 4 and begin < len(content):
            content[begin] ^= 1 << dice.randrange(8)
        elif how == 5 and dice.chance(0.3):
            del content[begin:]
    return bytes(content)


def damaged_text(content, dice):
    """Numbers, words and lines exchanged, doubled or removed."""
    if dice.chance(0.2):
        return damaged_bytes(content, dice)
    lines = content.decode().split("\n")
    for _ in range(dice.choice((1, 1, 1, 2, 5, 20))):
        place, how = dice.randrange(len(lines)), dice.randrange(7)
        if how == 0:
            del lines[place]
        elif how == 1:
            lines.insert(place, dice.choice(lines))
        elif how == 2:
            lines[place] = dice.choice(lines)
        elif how == 3:
            words = re.split(r"(\s+)", lines[place])
            words[dice.randrange(len(words))] = dice.choice(WORDS + NUMBERS)
            lines[place] = "".join(words)
        else:  # a number becomes another one
            numbers = list(re.finditer(r"[-+]?\d+(\.\d*)?([eE][-+]?\d+)?", lines[place]))
            if numbers:
                number = dice.choice(numbers)
                other = dice.choice(NUMBERS) if dice.chance(0.7) else str(float(number[0]) * 10 ** dice.uniform(-3, 3))
                lines[place] = lines[place][:number.start()] + other + lines[place][number.end():]
        lines = lines or [""]
    return "\n".join(lines).encode(errors="surrogateescape")


def damaged_values(path, dice):
    """An HDF5 file that is whole, but has other values, sizes or types, or lacks something."""
    with h5py.File(path, "r+") as file:
        names = ["/"]
        file.visit(names.append)
        for _ in range(dice.choice((1, 1, 2, 5))):
            name = dice.choice(names)
            if name not in file:
                continue
            item = file[name]
            if item.attrs and (not isinstance(item, h5py.Dataset) or dice.chance(0.3)):
                damage_attribute(item.attrs, dice)
            elif isinstance(item, h5py.Dataset):
                damage_dataset(file, name, dice)
            elif name != "/" and dice.chance(0.3):
                del file[name]
    return path.read_bytes()


def other_values(values, dice):
    values = np.array(values)
    if values.dtype.kind not in "iuf" or values.size == 0:
        return values
    bad = (float("nan"), float("inf"), -1., 0., 1e300, 1e-300) if values.dtype.kind == "f" else (
        0, 1, 2**31 - 1, int(np.iinfo(values.dtype).max), int(np.iinfo(values.dtype).min))
    if dice.chance(0.3):
        return values * values.dtype.type(dice.choice((0, 2)))
    flat = values.reshape(-1)
    for _ in range(dice.choice((1, 3, flat.size))):
        flat[dice.randrange(flat.size)] = dice.choice(bad)
    return values


def damage_attribute(attributes, dice):
    name = dice.choice(list(attributes))
    how = dice.randrange(4)
    if how == 0:
        del attributes[name]
    elif how == 1:
        attributes[name] = dice.choice((0., -1, "text", np.zeros(3), float("nan"), 2**32 - 1, np.bytes_(b"\xff"), ""))
    else:
        value = attributes[name]
        attributes[name] = value[:dice.randrange(len(value) + 1)] if isinstance(value, str) else other_values(value, dice)


def damage_dataset(file, name, dice):
    item, how = file[name], dice.randrange(5)
    values, attributes = item[()], dict(item.attrs)
    if how == 0:
        del file[name]
        return
    if how == 1 and np.ndim(values):
        values = values[:dice.randrange(len(values) + 1)]
    elif how == 2 and np.ndim(values):
        values = np.concatenate([values, values])
    elif how == 3:
        values = np.array(values).reshape(-1)
    else:
        values = other_values(values, dice)
    del file[name]
    file.create_dataset(name, data=values)
    for key, value in attributes.items():
        file[name].attrs[key] = value


class Inputs:
    """Makes the inputs from valid files."""

    def __init__(self, scratch, stator, contact):
        case = scratch / "case"
        for program in (stator, contact):
            subprocess.run([program, MOTOR, "--output", case, "--set", "Output/VTU = false"], check=True,
                           stdout=subprocess.DEVNULL)
        self.scratch, self.modes = scratch, case / "stator" / "modes.h5"
        self.files = {".prm": sorted((ROOT / "prm").glob("*.prm")),
                      ".msh": sorted([*(ROOT / "meshes").glob("*.msh"), *MESHES.glob("*.msh")]),
                      ".h5": [self.modes, case / "contact" / "contact.h5"],
                      "": sorted((case / "contact" / "kept").glob("interface_mesh_*"))[:1]}

    def make(self, number):
        """Input number k: its file."""
        dice = Dice(number)
        ending = dice.choice((".prm", ".prm", ".prm", ".msh", ".msh", ".h5", ".h5", ".h5", ".h5", ""))
        whole = dice.choice(self.files[ending])
        path = self.scratch / f"{number}_{whole.stem}{ending}"
        if ending == ".h5" and dice.chance(0.6):
            shutil.copyfile(whole, path)
            damaged_values(path, dice)
        else:
            damage = damaged_text if ending in (".prm", ".msh") else damaged_bytes
            path.write_bytes(damage(whole.read_bytes(), dice))
        return path


class Readers:
    """The executable of readers.cc, started again whenever it has ended."""

    def __init__(self, command):
        self.command, self.process = command, None

    def outcome_of(self, path):
        if self.process is None:
            self.process = subprocess.Popen(self.command, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                            stderr=subprocess.PIPE, text=True, errors="replace")
        self.process.stdin.write(f"{path}\n")
        self.process.stdin.flush()
        said = self.process.stdout.readline()
        if said:
            return said.strip()
        error = self.process.stderr.read()
        status, self.process = self.process.wait(), None
        lines = [line for line in error.splitlines() if "ERROR" in line or "error:" in line]
        return f"{'hang' if status == -14 else 'crash'}: status {status}, {(lines or error.splitlines() or [''])[0]}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("readers"), parser.add_argument("stator"), parser.add_argument("contact")
    parser.add_argument("--first", type=int, default=1, help="number of the first input")
    parser.add_argument("--count", type=int, default=10000, help="of inputs")
    parser.add_argument("--found", help="folder for inputs that are not refused in words")
    parser.add_argument("--markdown", help="also write the tables to this file")
    options = parser.parse_args()

    with tempfile.TemporaryDirectory() as folder:
        inputs = Inputs(pathlib.Path(folder), options.stator, options.contact)
        readers = Readers([options.readers, str(MOTOR), str(inputs.modes)])
        counts, wrong = collections.Counter(), 0
        corpus = sorted(FOUND.iterdir()) if FOUND.is_dir() else []
        for path in corpus + list(range(options.first, options.first + options.count)):
            path = path if isinstance(path, pathlib.Path) else inputs.make(path)
            outcome = readers.outcome_of(path)
            word = outcome.partition(":")[0]
            counts[path.suffix or "kept", word] += 1
            if word not in ("read", "refused"):
                wrong += 1
                print(f"{path.name}: {outcome}", flush=True)
                if options.found:
                    pathlib.Path(options.found).mkdir(parents=True, exist_ok=True)
                    shutil.copy(path, options.found)
            if path.parent == inputs.scratch:
                path.unlink()
    words = ("read", "refused", "not in words", "crash", "hang")
    lines = table(["inputs", "files", *words], [
        [kind, sum(counts[kind, word] for word in words), *(counts[kind, word] for word in words)]
        for kind in sorted({kind for kind, _ in counts})])
    print("\n".join(lines))
    if options.markdown:
        write_markdown(options.markdown, lines)
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
