#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks that the rooms of the library include each other in one direction only.

Usage: scripts/development/check_layers.py [root of the project]
Prints file:line of every include that the table below does not allow, and then exits with 1.
"""

import re
import sys
from pathlib import Path

# Each room may include itself and the rooms before it.
ORDER = ["parameters", "results", "mesh", "elements", "algebra", "structure", "condensation", "contact", "contact/solve",
         "motor", "wave", "points", "pictures", "balance", "output", "programs"]
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


def main():
    root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).resolve().parents[2]).resolve()
    n_files = sum(1 for p in (root / "source").rglob("*.cc"))
    if n_files == 0:
        sys.exit(f"{root} has no source files to check")
    found = list(violations(root))
    for line in found:
        print(line)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
