# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of many motors: inputs, outcomes, quantities with errors, seconds; as CSV and HDF5."""
import csv
import os
import pathlib
from dataclasses import dataclass, field

import h5py
import numpy as np
from motor_task import known_outcome
from results.motor_results import quantities_of, wave_quantities_of

MOST_IN_LINE = 4


@dataclass(frozen=True)
class Row:
    """One motor: the entries that vary, how it ended, its folder if it was computed, its results if it is certified."""

    varied: dict
    outcome: str
    message: str
    folder: str
    seconds: float
    wave_seconds: float
    quantities: dict = field(default_factory=dict)

    def inputs(self):
        """The entries that vary on one line, with as much of their sections as tells them apart; if there are many, the
        folder, which is in the table."""
        if len(self.varied) > MOST_IN_LINE:
            return os.path.basename(self.folder) or "a motor"
        return ", ".join(f"{name} = {text}" for name, text in zip(short_names(self.varied), self.varied.values()))


def short_names(entries):
    """Names of entries without their sections, or with the last one if two have the same."""
    last = [entry.rpartition("/")[2] for entry in entries]
    return [name if last.count(name) == 1 else "/".join(entry.split("/")[-2:]) for entry, name in zip(entries, last)]


def row_of(motor, outcome):
    """@param outcome how the motor has ended"""
    words = f"{outcome.program}: {outcome.message}" if outcome.message else ""
    if motor.refusal:
        return Row(dict(motor.varied), outcome.outcome, words, "", 0., 0.)
    wave = known_outcome(pathlib.Path(motor.wave.folder) / "wave.json")
    read = wave_quantities_of if motor.is_wave_only else quantities_of
    quantities = read(motor.folder) if outcome.outcome == "certified" else {}
    seconds = 0. if motor.is_wave_only else outcome.seconds
    return Row(dict(motor.varied), outcome.outcome, words, str(motor.folder), seconds, wave.seconds if wave else 0.,
               quantities)


def names_of(rows):
    """The quantities that any of the motors has, in the order in which they appear."""
    return list(dict.fromkeys(name for row in rows for name in row.quantities))


def unit_of(rows, name):
    return next(row.quantities[name].unit for row in rows if name in row.quantities)


def heading(name, unit, word=""):
    """The name of a column: no_load_speed_rpm, no_load_speed_error_rpm."""
    name, at, place = name.partition(" at ")
    return "_".join(part for part in (name, word, unit.replace(" ", "")) if part) + at + place


def write_csv(path, rows):
    entries, names = list(rows[0].varied), names_of(rows)
    units = {name: unit_of(rows, name) for name in names}
    part = f"{path}.part"
    with open(part, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow([*entries, "outcome", *(heading(name, units[name], word) for name in names for word in ("", "error")),
                         "seconds", "wave_seconds", "folder", "message"])
        for row in rows:
            numbers = [getattr(row.quantities[name], part) if name in row.quantities else ""
                       for name in names for part in ("value", "error")]
            writer.writerow([*row.varied.values(), row.outcome, *numbers, f"{row.seconds:.2f}", f"{row.wave_seconds:.2f}",
                             row.folder, row.message])
    os.replace(part, path)


def write_h5(path, rows):
    """Groups inputs, quantities and errors with one dataset for each column, NaN where a motor has no result."""
    part = f"{path}.part"
    with h5py.File(part, "w") as file:
        for entry in rows[0].varied:
            texts = [row.varied[entry] for row in rows]
            try:
                values = np.array(texts, float)
            except ValueError:
                values = np.array(texts, h5py.string_dtype())
            file[f"inputs/{entry.replace('/', ': ')}"] = values
        for name in names_of(rows):
            for group in ("value", "error"):
                values = [getattr(row.quantities[name], group) if name in row.quantities else np.nan for row in rows]
                dataset = file.create_dataset(f"{group}s/{name.replace('/', ' over ')}", data=values)
                dataset.attrs["unit"] = unit_of(rows, name)
        for name in ("outcome", "message", "folder"):
            file[name] = np.array([getattr(row, name) for row in rows], h5py.string_dtype())
        for name in ("seconds", "wave_seconds"):
            file[name] = np.array([getattr(row, name) for row in rows])
    os.replace(part, path)


def write_table(output, rows):
    write_csv(os.path.join(output, "table.csv"), rows)
    write_h5(os.path.join(output, "table.h5"), rows)
