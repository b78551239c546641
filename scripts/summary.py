#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Prints one page about a case: its results with their error bars, their cost, and where the files are.

Usage: scripts/summary.py CASE_DIR      e.g. scripts/summary.py output/canon_ring
"""
import sys

sys.dont_write_bytecode = True
from running import surroundings  # noqa: F401
from results.case import CaseError, run_script
from results.page import Page

MOST_POINTS = 6  # on one page


def lines_of(table):
    """The table in columns as wide as their texts."""
    units = [unit for _, unit in table.head]
    rows = [*([[name for name, _ in table.head]] if table.head else []), *([units] if any(units) else []), *table.rows]
    widths = [max(map(len, column)) for column in zip(*rows)]
    for row in rows:
        cells = [cell.rjust(width) if side == "r" else cell.ljust(width)
                 for cell, width, side in zip(row, widths, table.align)]
        yield "  " + "  ".join(cells).rstrip()
    for note in table.notes:
        yield f"  {note}"


def print_page(page):
    print(f"{page.motor}: {page.motor_line}    [ringmotor {page.version}]")
    for note in page.notes:
        print(note)
    for table in page.tables.values():
        print(f"\n{table.title}")
        for line in lines_of(table):
            print(line)


def main(arguments):
    if len(arguments) != 1:
        raise CaseError("expected one folder; usage: scripts/summary.py CASE_DIR")
    print_page(Page(arguments[0], MOST_POINTS))


if __name__ == "__main__":
    run_script("summary", main)
