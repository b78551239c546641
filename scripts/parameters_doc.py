#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes doc/parameters.md from what `stator --help` says of each entry.

Usage: scripts/parameters_doc.py PROGRAM [--check]
PROGRAM is any of the three programs (they declare the same entries), e.g. build/bin/stator.
--check compares with the file instead of writing it, and exits with 1 where they differ.
"""

import re
import subprocess
import sys
from pathlib import Path

TARGET = Path(__file__).resolve().parent.parent / "doc" / "parameters.md"

HEAD = """# Parameters

<!-- Written by scripts/parameters_doc.py from `stator --help`; do not edit. -->

All entries of a parameter file, the same for `stator`, `contact` and `losses`, in SI units. Defaults are those of the
reference motor; `prm/canon_ring.prm` says where each comes from. "(required)": a file has to give the entry.
`--set 'Section/Entry = value'` changes an entry for one run.
"""

# The label, its text, a full stop; of the value all up to the end or to the next label.
LABELS = r"(?: Units: (?P<units>.+?)\.)?(?: Allowed: (?P<allowed>.+?)\.)?(?P<required> Required\.)?$"


def entries_of(help_text):
    """Yields (section, entry, default, comment); sections as `Materials/Stator metal`."""
    sections, comment = [], []
    for line in map(str.strip, help_text.splitlines()):
        words = line.split(maxsplit=1)
        if not words:
            comment = []
        elif words[0] == "subsection":
            sections.append(words[1])
            comment = []
        elif words[0] == "end":
            sections.pop()
        elif words[0] == "#":
            comment.append(line[1:].strip())
        elif words[0] == "set":
            name, default = (part.strip() for part in words[1].split("=", 1))
            yield "/".join(sections), name, default, " ".join(comment)
            comment = []
        else:
            sys.exit(f"the help has a line that is not understood: {line}")


def row(name, default, comment):
    found = re.fullmatch(r"(?P<sentence>.+?)" + LABELS, comment)
    if not found or not found["allowed"]:
        sys.exit(f"the entry {name} does not say what is allowed: {comment}")
    units = "" if found["units"] in (None, "none") else found["units"]
    allowed = found["allowed"] + (" (required)" if found["required"] else "")
    cells = [name, f"`{default}`", units, allowed, found["sentence"]]
    return "| " + " | ".join(cell.replace("|", r"\|") for cell in cells) + " |"


def document(help_text):
    lines, last = [HEAD.rstrip()], None
    for section, name, default, comment in entries_of(help_text):
        if section != last:
            lines += ["", f"## {section}", "", "| entry | default | unit | allowed | meaning |", "|---|---|---|---|---|"]
            last = section
        lines.append(row(name, default, comment))
    if last is None:
        sys.exit("the help has no entries")
    return "\n".join(lines) + "\n"


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    help_text = subprocess.run([sys.argv[1], "--help"], check=True, capture_output=True, encoding="utf-8").stdout
    text = document(help_text)
    if "--check" not in sys.argv[2:]:
        TARGET.write_text(text, encoding="utf-8")
        return 0
    if TARGET.is_file() and TARGET.read_text(encoding="utf-8") == text:
        return 0
    print(f"{TARGET} is not what the program says; run scripts/parameters_doc.py {sys.argv[1]}")
    return 1


if __name__ == "__main__":
    sys.exit(main())
