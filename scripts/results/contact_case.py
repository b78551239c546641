# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the program contact left in the folder of a case, for the scripts that draw or print it."""
import csv

import h5py
import numpy as np
from results.case import Results, read_table

NORMAL, TANGENTIAL, RADIAL = 0, 1, 2  # components of forces and displacements: up, along -theta, outwards
OPEN, STICK, SLIP = 0, 1, 2


class ContactCase(Results):
    """What the program contact left in a folder.

    summary     content of summary.json
    parameters  "Section/Entry" -> text
    curve       list of dict, the rows of torque_speed.csv
    lip         list of dict, the rows of lip.csv; empty where inertia could not take part
    response    list of dict, the rows of response.csv; empty without Wave/Response torques
    sensitivities  list of dict, the rows of sensitivities.csv, "" where nothing is known; empty without --sensitivities
    radius, angle  of the contact points of a tooth, in m and rad from the tooth's centre
    """

    program = "contact"

    def __init__(self, folder):
        super().__init__(folder)
        self.load("summary.json", self.read_summary)
        self.load("torque_speed.csv", self.read_curve)
        self.load("contact.h5", self.read_contact_points)
        self.lip = []
        if self.has("lip.csv"):
            self.load("lip.csv", self.read_lip)
        self.response = []
        if self.has("response.csv"):
            self.load("response.csv", self.read_response)

        self.sensitivities = []
        if self.has("sensitivities.csv"):
            self.load("sensitivities.csv", self.read_sensitivities)

    def read_summary(self, path):
        super().read_summary(path)
        self.friction_coefficient = float(self.parameters["Friction/Dynamic coefficient"])
        is_left_out = self.parameters["Effects/Initial deformation"] == "off"
        self.warp = 0.0 if is_left_out else float(self.parameters["Initial deformation/Amplitude"])
        self.warp_waves = int(self.parameters["Initial deformation/Number of waves"])

    def read_curve(self, path):
        self.curve = read_table(path, texts=["control"])

    def read_lip(self, path):
        self.lip = read_table(path)

    def read_response(self, path):
        self.response = read_table(path, texts=["state"])

    def read_sensitivities(self, path):
        texts = ("entry", "unit", "remark")
        with open(path, newline="", encoding="utf-8") as file:
            self.sensitivities = [{key: text if key in texts or not text else float(text) for key, text in row.items()}
                                  for row in csv.DictReader(file)]

    def read_contact_points(self, path):
        with h5py.File(path, "r") as file:
            self.n_waves, self.n_teeth = int(file.attrs["n_waves"]), int(file.attrs["n_teeth"])
            self.angular_frequency = float(file.attrs["angular_frequency_rad_per_s"])
            self.radius, self.angle = file["nodes/radius"][()], file["nodes/angle"][()]

    @property
    def period(self):
        return 2 * np.pi / self.angular_frequency

    def of_rotor(self):
        """The quantities of the summary that belong to no operating point: of the rotor's lip, its clearance."""
        return [quantity for quantity in self.summary["quantities"]
                if "torque_Nm" not in quantity and "speed_rad_per_s" not in quantity]

    def belongs_to(self, stator):
        """Whether the wave is that which the program stator has left in the folder."""
        if not stator.wave or (self.n_waves, self.n_teeth) != (stator.n_waves, stator.n_teeth):
            return False
        return abs(self.angular_frequency / stator.wave["angular_frequency_rad_per_s"] - 1) < 1e-9

    def point_near(self, torque_mNm):
        """Number of the operating point whose torque is nearest to a value."""
        return min(range(len(self.curve)), key=lambda i: abs(self.curve[i]["torque_mNm"] - torque_mNm))

    def line(self, radius):
        """The contact points of a tooth at a radius, in the order of their angles."""
        nodes = np.flatnonzero(abs(self.radius - radius) < 1e-6 * radius)
        return nodes[np.argsort(self.angle[nodes])]

    def fields(self, point):
        """Moments, and by moment, tooth of the whole ring, contact point: forces in N, rest in m."""
        fields = {}

        def read(path):
            with h5py.File(path, "r") as file:
                group = file[f"points/{point:03d}"]
                fields["time"] = group["time"][()]
                for name in ("force", "gap_and_slip", "tooth", "rotor", "status"):
                    values = group[name][()]  # the steady pattern repeats where n and N have a common divisor
                    fields[name] = np.tile(values, (1, self.n_teeth // values.shape[1], *[1] * (values.ndim - 2)))

        self.load("contact.h5", read)
        return fields

    def history(self, point):
        """Of the chosen contact points: list of dict, the rows of history.csv."""
        rows = []

        def read(path):
            with open(path, newline="", encoding="utf-8") as file:
                for row in csv.DictReader(file):
                    if int(row["point"]) == point:
                        rows.append({key: text if key == "status" else float(text) for key, text in row.items()})

        self.load("history.csv", read)
        return rows
