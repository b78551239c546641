# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the checks of the project's sources share: which project they look at, and how they end."""
import sys
from pathlib import Path


def run_check(violations, folder, pattern):
    """Prints what a check finds in the project that the first argument names, or in this one, and exits with 1 if that is
    anything. A project without files of this pattern in a folder is none."""
    root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).resolve().parents[2]).resolve()
    if next((root / folder).rglob(pattern), None) is None:
        sys.exit(f"{root} has no {folder} to check")
    found = list(violations(root))
    for line in found:
        print(line)
    sys.exit(1 if found else 0)
