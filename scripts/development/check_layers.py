#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks that the rooms of the library include each other in one direction only.

Usage: scripts/development/check_layers.py [root of the project]
Prints file:line of every include that the table below does not allow, and then exits with 1.
"""

import re
from pathlib import Path

from source_check import run_check

# Each room may include itself and the rooms before it.
ORDER = ["parameters", "results", "mesh", "elements", "algebra", "structure", "condensation", "contact", "contact/solve",
         "motor", "wave", "points", "pictures", "balance", "sensitivity", "output", "programs"]
MAY_INCLUDE = {room: set(ORDER[: place + 1]) for place, room in enumerate(ORDER)}

# Everyone may see these.
FREE_HEADERS = {"version.h"}

INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]ringmotor/([^>"]+)[>"]')


def room_of(path, base):
    """The room of a file below include/ringmotor or source: the innermost folder that is one; None without one."""
    folder = path.relative_to(base).parent
    return next((str(place) for place in [folder, *folder.parents] if str(place) in MAY_INCLUDE), None)


def violations(root):
    for base in (root / "include" / "ringmotor", root / "source"):
        for path in sorted(p for p in base.rglob("*") if p.suffix in (".h", ".cc")):
            room = room_of(path, base)
            place = path.relative_to(root)
            if room not in MAY_INCLUDE:
                yield f"{place}:1: '{path.parent.name}' is not a room, see the table in {Path(__file__).name}"
                continue
            for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
                found = INCLUDE.match(line)
                if found is None or found.group(1) in FREE_HEADERS:
                    continue
                other = room_of(base / found.group(1), base)
                if other not in MAY_INCLUDE[room]:
                    yield f"{place}:{number}: {room} may not include {other} (<ringmotor/{found.group(1)}>)"


if __name__ == "__main__":
    run_check(violations, "source", "*.cc")
