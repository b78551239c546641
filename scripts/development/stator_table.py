#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the stator's compliance changes: a table of pairs of cases, each of a motor without and with it.

Usage: scripts/development/stator_table.py CASE_WITHOUT CASE_WITH ...

At least one of each pair knows the indicator of Effects/Stator compliance.
"""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from running import surroundings  # noqa: E402, F401  (first: see there)
import json

from development.document_tables import bar, table
from results.case import read_table
from results.contact_case import ContactCase


def indicator_of(case, effect):
    rows = json.loads((case / "contact" / "summary.json").read_text(encoding="utf-8"))["effects"]
    return next(row["indicator"] for row in rows if row["name"] == effect)


def stators(folders):
    rows = []
    for without, with_it in zip(folders[::2], folders[1::2]):
        indicators = [indicator_of(case, "Stator compliance") for case in (without, with_it)]
        indicator = next(value for value in indicators if value is not None)
        for said, case in (("off", without), ("on", with_it)):
            curve = read_table(case / "contact" / "torque_speed.csv", ("control",))
            rows.append([ContactCase(case).motor if said == "off" else "", said,
                         f"{100. * indicator:.1f} %" if said == "off" else "",
                         *(bar(curve[i][f"{name}_{unit}"], curve[i][f"{name}_error_{unit}"])
                           for i, name, unit in ((0, "speed", "rpm"), (-1, "torque", "mNm"), (0, "friction_loss", "mW")))])
    return table(["motor", "stator compliance", "indicator", "no-load speed, rpm", "stall torque, mN m",
                  "loss without load, mW"], rows)


if __name__ == "__main__":
    print(stators([pathlib.Path(name) for name in sys.argv[1:]]))
