# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the program losses left in the folder of a case, for the scripts that draw or print it."""
import math
import os

from results.case import Case, Results, failures, has_results, read_table
from results.contact_case import ContactCase

PARTS = ("friction_loss", "internal_loss_stator_metal", "internal_loss_piezoceramic",
         "internal_loss_stator_vibration", "internal_loss_rotor", "support_loss")
LOAD = ["torque_mNm", "speed_rpm"]
NUMBERS = {"losses.csv": LOAD + [f"{name}{end}" for name in (*PARTS, "total_loss") for end in ("_mW", "_error_mW")],
           "efficiency.csv": LOAD + ["input_power_mW", "output_power_mW", "output_power_error_mW", "efficiency",
                                     "efficiency_error"],
           "drive.csv": LOAD + [f"{name}{end}{unit}" for name, unit in (("amplitude", "_um"), ("voltage", "_V"),
                                                                       ("current", "_mA"), ("power_factor", ""),
                                                                       ("electrical_efficiency", ""))
                                for end in ("", "_error")]}


class LossesCase(Results):
    """What the program losses left in a folder.

    summary     content of summary.json
    parameters  "Section/Entry" -> text
    points      list of dict, one for each operating point: the columns of losses.csv and efficiency.csv and, where
                it exists, of drive.csv
    has_drive   whether it exists: the ceramic is piezoelectric
    """

    program = "losses"

    def __init__(self, folder):
        super().__init__(folder)
        self.points = []
        self.load("summary.json", self.read_summary)
        self.load("losses.csv", self.read_points)
        self.load("efficiency.csv", self.read_points)
        self.has_drive = self.has("drive.csv")
        if self.has_drive:
            self.load("drive.csv", self.read_points)

    def read_points(self, path):
        rows = read_table(path)
        for key in NUMBERS[os.path.basename(path)]:
            if not all(math.isfinite(row[key]) for row in rows):
                raise ValueError(f"{key} is not finite")
        self.points = self.points or [{} for _ in rows]
        if len(rows) != len(self.points):
            raise ValueError(f"{len(rows)} rows, but {len(self.points)} in losses.csv")
        for point, row in zip(self.points, rows):
            point.update(row)

    def belongs_to(self, contact):
        """Whether the operating points are those which the program contact has left in the folder."""
        columns = ("torque_mNm", "speed_rpm", "friction_loss_mW", "friction_loss_error_mW")
        return len(self.points) == len(contact.curve) and all(
            math.isclose(point[key], row[key], rel_tol=1e-9, abs_tol=1e-9)
            for point, row in zip(self.points, contact.curve) for key in columns)

    def points_with(self, contact):
        """The operating points with the columns of torque_speed.csv as well."""
        return [{**row, **point} for row, point in zip(contact.curve, self.points)]


def read_case(folder):
    """Results of the three programs, and list of what is left out: None for one that is not there, that has failed, or
    that does not belong to those before it."""
    case = Case(folder)
    notes = [f"The program {program} failed: {words}" for program, words in failures(folder).items()]
    contact = ContactCase(folder) if has_results(folder, "contact") else None
    if contact and not contact.belongs_to(case):
        return case, None, None, [*notes, "The contact was computed with another wave; run contact again"]
    losses = LossesCase(folder) if contact and has_results(folder, "losses") else None
    if losses and not losses.belongs_to(contact):
        return case, contact, None, [*notes, "The losses are those of other operating points; run losses again"]
    return case, contact, losses, notes
