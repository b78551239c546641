#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes doc/parameters.md from what `stator --help` says of each entry.

Usage: scripts/development/parameters_doc.py PROGRAM [--check]
PROGRAM is any of the three programs (they declare the same entries), e.g. build/bin/stator.
--check compares with the file instead of writing it, and exits with 1 where they differ.
"""

import json
import re
import subprocess
import sys
from pathlib import Path

TARGET = Path(__file__).resolve().parents[2] / "doc" / "parameters.md"

HEAD = """# Parameters

<!-- Written by scripts/development/parameters_doc.py from `stator --help`; do not edit. -->

All entries of a parameter file, the same for `stator`, `contact` and `losses`, in SI units. An entry
without a default is required: a file has to give it, if its motor has the part.
`--set 'Section/Entry = value'` changes an entry for one run.

A file may hold only what differs from another one: a line such as `set Base file = canon_ring.prm`
outside of all sections names it, and the entries of the file take precedence.
The path is relative to the folder of the file. The base may have a base of its own. Results of the
base are not overwritten: its `Output/Directory` does not count. The page of a run lists the
differences, also those of `--set`.
"""

# The label, its text, a full stop; of the value all up to the end or to the next label.
LABELS = r"(?: Units: (?P<units>.+?)\.)?(?: Allowed: (?P<allowed>.+?)\.)?(?P<required> Required\.)?$"


def entries_of(declared, section=""):
    """Yields (section, entry, default, documentation); sections as `Materials/Stator metal`."""
    for name, found in declared.items():
        if isinstance(found.get("documentation"), str):
            yield section, name, found["default_value"], found["documentation"]
        else:
            yield from entries_of(found, f"{section}/{name}" if section else name)


def row(name, default, documentation):
    found = re.fullmatch(r"(?P<sentence>.+?)" + LABELS, documentation)
    if not found or not found["allowed"]:
        sys.exit(f"the entry {name} does not say what is allowed: {documentation}")
    units = "" if found["units"] in (None, "none") else found["units"]
    cells = [name, "required" if found["required"] else f"`{default}`", units, found["allowed"], found["sentence"]]
    return "| " + " | ".join(cell.replace("|", r"\|") for cell in cells) + " |"


def document(declared):
    lines, last = [HEAD.rstrip()], None
    for section, name, default, documentation in entries_of(declared):
        if section != last:
            lines += ["", f"## {section}", "", "| entry | default | unit | allowed | meaning |", "|---|---|---|---|---|"]
            last = section
        lines.append(row(name, default, documentation))
    if last is None:
        sys.exit("the help has no entries")
    return "\n".join(lines) + "\n"


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    text = document(json.loads(subprocess.run([sys.argv[1], "--help=json"], check=True, capture_output=True).stdout))
    if "--check" not in sys.argv[2:]:
        TARGET.write_text(text, encoding="utf-8")
        return 0
    if TARGET.is_file() and TARGET.read_text(encoding="utf-8") == text:
        return 0
    print(f"{TARGET} is not what the program says; run scripts/development/parameters_doc.py {sys.argv[1]}")
    return 1


if __name__ == "__main__":
    sys.exit(main())
