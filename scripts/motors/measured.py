# SPDX-License-Identifier: LGPL-2.1-or-later
"""A measured torque-speed curve from a CSV file, as spreadsheets write them."""
import csv
import io
import re

import numpy as np
from motors.calibration import Measured
from results.case import CaseError
from results.motor_results import RPM
from running.typed import problem_of_number

NEEDED = ("torque_mNm", "speed_rpm")
DEVIATIONS = ("torque_error_mNm", "speed_error_rpm")  # one of them may be left out
SEPARATORS = {";": "semicolons", "\t": "tabs"}
UTF16_MARKS = (b"\xff\xfe", b"\xfe\xff")


def text_of(path):
    """@throws ValueError if the file is no text"""
    with open(path, "rb") as file:
        content = file.read()
    if content.startswith(UTF16_MARKS):
        raise ValueError('it is in UTF-16; save it as "CSV UTF-8"')
    if b"\0" in content:
        raise ValueError("it is not a text file; save the table as CSV")
    return content.decode("utf-8-sig", errors="replace")  # remarks, which nobody needs, may have another encoding


def without_blanks(text):
    """Also no-break spaces, and marks of no width."""
    return re.sub(r"^[\s\ufeff\u200b]+|[\s\ufeff\u200b]+$", "", text)


def rows_of(text):
    """Number of the line and cells, of all rows that are not empty."""
    reader = csv.reader(io.StringIO(text, newline=""))
    for row in reader:
        cells = [without_blanks(cell) for cell in row]
        if any(cells) and not cells[0].lower() == "sep=":  # which tells a spreadsheet that commas separate
            yield reader.line_num, cells


def places_of(names):
    """Column -> its place among the names. @throws ValueError"""
    for name in NEEDED:
        for separator, word in SEPARATORS.items() if name not in names else ():
            if any(separator in one for one in names):
                raise ValueError(f"it is separated by {word}; save it separated by commas, and with decimal points")
        if name not in names:
            raise ValueError(f"it has no column {name}; it needs {' and '.join(NEEDED)}, and has "
                             f"{', '.join(name for name in names if name)}")
    for name in (*NEEDED, *DEVIATIONS):
        if names.count(name) > 1:
            raise ValueError(f"it has {names.count(name)} columns {name}; keep one of them")
    return {name: names.index(name) for name in (*NEEDED, *DEVIATIONS) if name in names}


def columns_of(text):
    """Column -> array of its numbers. @throws ValueError"""
    all_rows = list(rows_of(text))
    if len(all_rows) < 2:
        raise ValueError("it needs a line of names, and rows of numbers below")
    (_, names), *rows = all_rows
    places = places_of(names)
    columns = {name: [] for name in places}
    for line, cells in rows:
        if any(cells[len(names):]):
            raise ValueError(f"line {line} has {len(cells)} cells for {len(names)} names, as decimal commas make them, and commas "
                             "in a text without quotes; write decimal points")
        for name, place in places.items():
            cell = cells[place] if place < len(cells) else ""
            problem = problem_of_number(cell)
            if problem:
                raise ValueError(f'line {line}, {name}: "{cell}" {problem}')
            columns[name].append(float(cell))
    return {name: np.array(numbers) for name, numbers in columns.items()}


def read_measured(path):
    """Torques, speeds and their standard deviations; other columns are ignored. @throws CaseError that names the file and,
    where it can, line and column"""
    try:
        columns = columns_of(text_of(path))
    except OSError as error:
        raise CaseError(f"{path} cannot be read ({error.strerror or error})") from None
    except (ValueError, csv.Error) as error:
        raise CaseError(f"{path} cannot be read: {error}") from None
    torque, speed = (columns[name] for name in NEEDED)
    torque_error, speed_error = (columns.get(name, np.zeros(len(torque))) for name in DEVIATIONS)
    if np.any(torque_error < 0) or np.any(speed_error < 0):
        raise CaseError(f"{path} has negative deviations")
    if np.any(torque_error + speed_error <= 0):
        raise CaseError(f"{path} needs torque_error_mNm or speed_error_rpm above 0 for each point")
    return Measured(torque * 1e-3, speed * RPM, torque_error * 1e-3, speed_error * RPM)
