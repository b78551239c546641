# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whose a report.html is: a page of somebody else is neither removed nor replaced."""
import os

from running.programs import CaseError

MARK = '<span class="origin">· ringmotor'
HEAD = 1 << 16  # letters within which the mark is


def refuse_foreign(path):
    """@throws CaseError if there is a file that report.py has not written"""
    if not os.path.lexists(path):
        return
    try:
        with open(path, encoding="utf-8", errors="replace") as file:
            if MARK in file.read(HEAD):
                return
    except OSError:
        pass
    raise CaseError(f"{path} is not a page of ringmotor, and stays: move it, or choose another folder for the results")
