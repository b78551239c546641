# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the programs left in the folder of a case, for the scripts that draw or print it: of all, and of stator."""
import csv
import json
import math
import os
import sys

import h5py
from running.programs import CaseError

SUMMARY_KEYS = ("program", "version", "git", "entries", "seconds", "peak_memory_MB", "dofs", "quantities", "effects",
                "certificate")


def words_of_failure(case_folder, program):
    """Why a program has failed when it ran last; nothing if it has not."""
    try:
        with open(os.path.join(case_folder, f"{program}_failed.txt"), encoding="utf-8", errors="replace") as file:
            return " ".join(file.read().split())
    except FileNotFoundError:
        return ""


def failures(case_folder):
    """The words of those programs after stator that have failed, by their names."""
    return {program: words for program in ("contact", "losses") if (words := words_of_failure(case_folder, program))}


def has_results(case_folder, program):
    """summary.json is written last: without it the run did not come to its end. What is there when the program has
    failed is of an earlier run."""
    return not words_of_failure(case_folder, program) and os.path.exists(os.path.join(case_folder, program, "summary.json"))


def run_script(name, main):
    """Ends a script with the one line of a mistake, or of an interruption after which it can go on."""
    try:
        main(sys.argv[1:])
        print(end="", flush=True)  # here, where an error is told in words
    except CaseError as problem:
        sys.exit(f"{name}: {problem}")
    except KeyboardInterrupt:
        sys.exit(f"{name}: interrupted; start it again to go on")


class Results:
    """Files of one program in the folder of a case; `program` is its name and that of its folder."""

    program = None

    def __init__(self, case_folder):
        self.folder = os.path.join(case_folder, self.program)

    def has(self, name):
        """Whether there is such a file."""
        return os.path.exists(os.path.join(self.folder, name))

    def load(self, name, read):
        path = os.path.join(self.folder, name)
        try:
            read(path)
        except FileNotFoundError:
            raise CaseError(f"{path} is missing; run the program {self.program} first") from None
        except (OSError, ValueError, TypeError, LookupError) as error:
            reason = " ".join(f"{type(error).__name__} {error}".split())
            raise CaseError(f"{path} cannot be read ({reason}); run the program {self.program} again") from None

    def read_summary(self, path):
        with open(path, encoding="utf-8") as file:
            self.summary = json.load(file)
        for key in SUMMARY_KEYS:
            self.summary[key]  # what is missing is told here, not in the middle of a page
        self.parameters = self.summary["entries"]
        self.motor = self.parameters["Motor/Name"]


def read_table(path, texts=()):
    """Rows of a CSV file as list of dict, numbers but for the columns `texts`."""
    with open(path, newline="", encoding="utf-8") as file:
        rows = [{key: text if key in texts else float(text) for key, text in row.items()}
                for row in csv.DictReader(file)]
    if not rows:
        raise ValueError("no row in it")
    return rows


class Case(Results):
    """What the program stator left in a folder.

    summary  content of summary.json
    parameters  "Section/Entry" -> text
    sections "stator" and "rotor", as far as they are known -> content of sections.json
    modes    list of dict: n, family, frequency_Hz, error_Hz
    wave     attributes and surface traces of the motor's wave, None if it is not among the modes
    points   with a wave: name of a point of the tooth -> dict of the columns of ellipses.csv
    errors   with a wave: name of a quantity of the wave -> error bar, in the unit of the summary
    circuits    with a piezoelectric ceramic: phase -> dict of the columns of circuits.csv, else False
    admittance  with circuits: column of admittance.csv -> list of numbers
    electrodes  with circuits: list of dict, the rows of electrodes.csv
    """

    program = "stator"

    def __init__(self, folder):
        super().__init__(folder)
        self.wave = None
        self.load("summary.json", self.read_summary)
        self.load("frequencies.csv", self.read_frequencies)
        self.load("modes.h5", self.read_modes)
        if self.wave:
            self.load("ellipses.csv", self.read_ellipses)
        self.sections = {}
        if self.has("sections.json"):
            self.load("sections.json", self.read_sections)
        self.circuits = self.has("circuits.csv")
        if self.circuits:
            self.load("circuits.csv", self.read_circuits)
            self.load("admittance.csv", self.read_admittance)
            self.load("electrodes.csv", self.read_electrodes)

    def read_summary(self, path):
        super().read_summary(path)
        self.errors = {quantity["name"]: quantity["error"] for quantity in self.summary["quantities"]
                       if quantity["name"] != "frequency"}
        checks = {check["name"]: check["limit"] for check in self.summary["certificate"]["checks"]}
        # Accuracy/Target if the mesh was refined until it was met, else None
        self.target = checks.get("largest relative error bar of a frequency")
        # not so if the modes nearest to a frequency were asked for
        self.has_lowest_modes = float(self.parameters["Modes/Frequency target"]) == 0

    def read_sections(self, path):
        with open(path, encoding="utf-8") as file:
            self.sections = json.load(file)

    def read_frequencies(self, path):
        with open(path, newline="", encoding="utf-8") as file:
            self.modes = [{"n": int(row["n"]), "family": row["family"], "frequency_Hz": float(row["frequency_Hz"]),
                           "error_Hz": float(row["error_Hz"])} for row in csv.DictReader(file)]

    def read_ellipses(self, path):
        with open(path, newline="", encoding="utf-8") as file:
            self.points = {row.pop("point"): {key: float(value) for key, value in row.items()}
                           for row in csv.DictReader(file)}

    def read_circuits(self, path):
        self.circuits = {row.pop("phase"): row for row in read_table(path, texts=("phase",))}

    def read_admittance(self, path):
        rows = read_table(path)
        self.admittance = {column: [row[column] for row in rows] for column in rows[0]}

    def read_electrodes(self, path):
        self.electrodes = read_table(path, texts=("phase", "poling"))

    def read_modes(self, path):
        with h5py.File(path, "r") as file:
            self.motor = file.attrs["motor"].decode(errors="replace")
            self.n_waves, self.n_teeth = int(file.attrs["n_waves"]), int(file.attrs["n_teeth"])
            if "wave" in file:
                self.wave = dict(file["wave"].attrs)
                self.wave.update({name: read_trace(file["wave"][name]) for name in ("tooth_top", "tooth_foot")})


def read_trace(group):
    """Points (face, place, xyz) in m and complex displacement (face, place, r/theta/z) in m."""
    displacement = group["displacement_real"][()] + 1j * group["displacement_imaginary"][()]
    return {"order": int(group.attrs["order"]), "points": group["points"][()], "u": displacement}


def with_error(value, error):
    """Both with the two leading digits of the error: '29.988 ± 0.026'."""
    digits = 3 if error <= 0 else max(0, 1 - math.floor(math.log10(float(f"{error:.1e}"))))
    return f"{value:.{digits}f} ± {error:.{digits}f}"


def known(value, error):
    """A result with its error, or without one if it has none: what is prescribed, and nothing at all."""
    if max(abs(value), error or 0) < 1e-9:
        return "0"
    return with_error(value, error) if error else f"{value:.4g}"
