# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks results of the program contact from its files alone, by laws that hold for any motor.

The program certifies its results itself. This is a second opinion, computed from the forces, gaps and slips
in contact.h5 without its code: bounds that no motor exceeds, balances of forces, and powers summed anew.
"""
import csv
import json
import math
import pathlib

import h5py
import numpy

RPM = math.pi / 30.
TINY = 1e-6  # relative: certified states fulfil their laws to 1e-8 and better
NO_POWER = 1e-6  # of what goes to and fro: rounding


class ContactResults:
    """What the program contact has written into a folder."""

    def __init__(self, folder):
        folder = pathlib.Path(folder)
        self.summary = json.loads((folder / "contact" / "summary.json").read_text())
        self.entries = self.summary["entries"]
        with open(folder / "contact" / "torque_speed.csv") as file:
            self.rows = [{key: value if key == "control" else float(value) for key, value in row.items()}
                         for row in csv.DictReader(file)]
        with open(folder / "stator" / "ellipses.csv") as file:
            self.angular_amplitude = max(1e-3 * float(row["A_t_um"]) / float(row["r_mm"])
                                         for row in csv.DictReader(file) if row["point"].startswith("top"))
        with h5py.File(folder / "contact" / "contact.h5") as file:
            self.attributes = dict(file.attrs)
            self.radius = file["nodes/radius"][:]
            self.angle = file["nodes/angle"][:]
            self.points = [{**point.attrs, **{name: item[:] for name, item in point.items() if isinstance(item, h5py.Dataset)}}
                           for _, point in sorted(file["points"].items())]
        self.n_repeats = int(self.attributes["n_teeth"]) // self.points[0]["force"].shape[1]

    def column(self, name):
        """Of torque_speed.csv."""
        return numpy.array([row[name] for row in self.rows])

    def number(self, entry):
        return float(self.entries[entry])

    def has_effect(self, name):
        """Whether an effect was included, by its entry or, if that is "auto", because of its size."""
        return any(effect["name"] == name and effect["choice"] == "on" for effect in self.summary["effects"])

    def has_springs(self):
        """Whether rotor and teeth may approach each other beyond the point where they touch."""
        return self.entries["Contact/Formulation"] == "penalty" or self.has_effect("Friction lining")

    def is_marched(self, point):
        """A marched point is a sequence of steps, at least two of them; its first is not averaged over."""
        return self.entries["Time/Scheme"] == "marching" or (
            self.entries["Time/Scheme"] == "auto" and self.has_effect("Initial deformation"))

    def window_errors(self):
        """Of the torque of each point (N m), what the choice of the averaged periods may change; zero where the torque
        is prescribed."""
        torques = iter([q for q in self.summary["quantities"] if q["name"] in ("torque", "stall_torque")])
        return [next(torques)["error_causes"].get("averaging window", 0.) if row["control"] == "speed" else 0.
                for row in self.rows]

    def keeps_last_period(self, point):
        """Whether a point was marched until its means were known, and has the fields of the last period only."""
        return self.is_marched(point) and self.entries["Time/Number of steps"] == "auto"

    def friction_bound(self):
        """The largest coefficient that the law of friction ever takes."""
        dynamic, static = (self.number(f"Friction/{kind} coefficient") for kind in ("Dynamic", "Static"))
        is_one = (self.entries["Friction/Law"] == "coulomb" or
                  not self.has_effect("Static friction excess"))
        return dynamic if is_one else max(dynamic, static)

    def averaged(self, point):
        """The moments that a point's values are means of, and what was one time step before them: two
        functions of a field with an axis of moments, then one of teeth; None if that is not kept."""
        if self.keeps_last_period(point):
            return (lambda field: field), None
        if self.is_marched(point):
            # A step may have been divided, to tell its error or to balance the powers.
            n_parts = len(point["force"]) // int(self.number("Time/Number of steps"))
            first = n_parts * (int(self.number("Time/Average from step")) - 1)
            last = n_parts * int(self.number("Time/Average to step"))
            return (lambda field: field[first:last]), (lambda field: field[first - 1:last - 1])
        # The steady pattern repeats itself: before the first moment a tooth was what another one, ahead of it
        # by one phase, is at the last moment.
        n_teeth = point["force"].shape[1]
        shift = pow(int(self.attributes["n_waves"]) // self.n_repeats, -1, n_teeth) if n_teeth > 1 else 0
        return (lambda field: field), (
            lambda field: numpy.concatenate([numpy.roll(field[-1:], -shift, axis=1), field[:-1]]))

    def touching(self):
        """The largest number of contact nodes on the ring that touch at a time, mean over the moments, of
        all operating points; and the number of all nodes."""
        most = max((self.averaged(p)[0](p["status"]) > 0).sum() / self.averaged(p)[0](p["status"]).shape[0]
                   for p in self.points)
        return most * self.n_repeats, len(self.radius) * self.attributes["n_teeth"]

    def most_torque(self):
        """What friction bears at most (N m)."""
        outer_radius = min(self.number("Rotor/Lip outer radius"), self.number("Stator/Tip outer radius"))
        return self.friction_bound() * self.number("Loading/Preload") * outer_radius

    def wave_speed(self):
        """Of the wave's surface (rad/s) where it is fastest."""
        return self.attributes["angular_frequency_rad_per_s"] * self.angular_amplitude

    def worst_error(self):
        """Largest error bar, of speeds over the fastest speed and of torques over the largest torque, or over
        half of what wave and friction allow for if that is more."""
        speed = max(0.5 * self.wave_speed() / RPM, max(abs(row["speed_rpm"]) for row in self.rows))
        torque = max(500. * self.most_torque(), max(abs(row["torque_mNm"]) for row in self.rows))
        return max(max(row["speed_error_rpm"] / speed, row["torque_error_mNm"] / torque) for row in self.rows)


def check_table(results):
    """What is wrong with torque_speed.csv and summary.json: list of texts."""
    found = []
    if not results.summary["certificate"]["holds"]:
        found.append("exit status 0 although the certificate does not hold")
    for number, row in enumerate(results.rows):
        for column, value in row.items():
            if column != "control" and not math.isfinite(value):
                found.append(f"point {number}: {column} is {value}")
            elif "_error_" in column and value < 0.:
                found.append(f"point {number}: the error bar {column} is negative")
    if not all(math.isfinite(q["value"]) and math.isfinite(q["error"]) for q in results.summary["quantities"]):
        found.append("summary.json holds numbers that are not finite")
    return found


def check_bounds(results, point, row):
    """No more torque than friction bears, no faster than the wave, no negative loss."""
    found = []
    most_torque = results.most_torque()
    if abs(point["torque_Nm"]) > 1.01 * most_torque:
        found.append(f"torque {point['torque_Nm']:.4g} N m, but friction bears {most_torque:.4g} N m at most")
    fastest = results.wave_speed()
    if (point["torque_Nm"] > TINY * most_torque + 1e-3 * row["torque_error_mNm"] and
            point["speed_rad_per_s"] > 1.02 * fastest + RPM * row["speed_error_rpm"]):
        found.append(f"drives at {point['speed_rad_per_s']:.4g} rad/s, but the wave's surface moves at "
                     f"{fastest:.4g} rad/s at most")
    if abs(1e-3 * row["torque_mNm"] - point["torque_Nm"]) + abs(RPM * row["speed_rpm"] - point["speed_rad_per_s"]) > \
            TINY * (most_torque + fastest):
        found.append("torque_speed.csv and contact.h5 differ")
    control = point["control"].decode() if isinstance(point["control"], bytes) else point["control"]
    reached, scale = ((point["torque_Nm"], most_torque) if control == "torque" else
                      (point["speed_rad_per_s"], fastest))
    if abs(reached - point["asked_for"]) > TINY * scale:
        found.append(f"{control} {point['asked_for']:.6g} was asked for, {reached:.6g} was found")
    for name in ("tangential_loss_W", "radial_loss_W"):
        if point[name] < -TINY * most_torque * fastest - 1e-3 * row[name.replace("_W", "_error_mW")]:
            found.append(f"{name} is negative: {point[name]:.4g}")
    return found


def check_forces(results, point, window_error):
    """Forces at the nodes keep the laws of contact and friction, and balance the loads."""
    found = []
    preload, radius = results.number("Loading/Preload"), results.radius
    force, gap = point["force"], point["gap_and_slip"][..., 0]
    largest = force[..., 0].max()
    if force[..., 0].min() < -TINY * largest:
        found.append(f"rotor and teeth pull at each other with {-force[..., 0].min():.3g} N")
    sums = force[..., 0].sum(axis=(1, 2)) * results.n_repeats
    if numpy.abs(sums - preload).max() > TINY * preload:
        found.append(f"normal forces sum up to {sums.min():.8g} .. {sums.max():.8g} N instead of the preload")
    excess = numpy.hypot(force[..., 1], force[..., 2]) - results.friction_bound() * force[..., 0]
    if excess.max() > TINY * largest:
        found.append(f"friction exceeds its bound by {excess.max():.3g} N where {largest:.3g} N press most")
    if not results.has_springs() and gap.min() < -1e-4 * results.number("Wave/Amplitude"):
        found.append(f"teeth reach into the rotor by {-gap.min():.3g} m")
    if (force[..., 0] * (point["status"] == 0)).max() > TINY * largest:
        found.append("nodes that are open carry forces")
    now, _ = results.averaged(point)
    torque = (now(force)[..., 1] * radius).sum(axis=(1, 2)).mean() * results.n_repeats
    scale = results.friction_bound() * preload * radius.max()
    # Where means wander, the torque is that of many periods, of which the last alone is kept. Means of single periods
    # scatter about twice as far as the error of the mean of all, 95 % of which is given.
    allowed = TINY * scale + 6. * window_error
    if abs(torque - point["torque_Nm"]) > allowed:
        found.append(f"friction forces make {torque:.6g} N m, the torque is {point['torque_Nm']:.6g} N m")
    return found


def check_powers(results, point):
    """Powers summed anew from forces, slips and displacements at the nodes."""
    found = []
    now, before = results.averaged(point)
    if not before:
        return found
    mean = 0.5 * (now(point["force"]) + before(point["force"]))
    per_second = results.n_repeats / (mean.shape[0] * point["time_step_s"])
    slip = now(point["gap_and_slip"])[..., 1:]
    losses = -per_second * (mean[..., 1:] * slip).sum(axis=(0, 1, 2))
    loss = point["tangential_loss_W"] + point["radial_loss_W"]
    output = point["torque_Nm"] * point["speed_rad_per_s"]
    moved = now(point["tooth"]) - before(point["tooth"])
    gross = per_second * abs(mean * moved).sum()  # goes to and fro, also where a rotor that sticks takes no power
    scale = max(abs(loss), abs(output), abs(point["input_power_W"]), NO_POWER * gross)
    for name, value in zip(("tangential_loss_W", "radial_loss_W"), losses):
        if abs(value - point[name]) > TINY * scale:
            found.append(f"{name} is {point[name]:.6g}, forces and slips make {value:.6g}")
    if results.is_marched(point):
        return found  # what the bodies store changes from step to step
    # Over a period the teeth store nothing: the wave's work is that of the forces on the moving tooth tops.
    power = per_second * (mean * moved).sum()
    if abs(power - point["input_power_W"]) > TINY * scale:
        found.append(f"input_power_W is {point['input_power_W']:.6g}, forces and tooth motions make {power:.6g}")
    rest = point["input_power_W"] - output - loss - point["closing_work_W"] - point["modal_power_W"]
    if abs(rest) > TINY * scale:
        found.append(f"the powers leave {rest:.3g} W of {scale:.3g} W")
    return found


def check(folder):
    """Everything that is wrong with the results in a folder: list of texts, empty if nothing is."""
    results = ContactResults(folder)
    found = check_table(results)
    if len(results.rows) != len(results.points):
        return found + ["torque_speed.csv and contact.h5 have different numbers of points"]
    window_errors = results.window_errors()
    for number, (point, row) in enumerate(zip(results.points, results.rows)):
        fields = [point[name] for name in ("force", "gap_and_slip", "tooth", "rotor")]
        if not all(numpy.isfinite(field).all() for field in fields):
            found.append(f"point {number}: contact.h5 holds numbers that are not finite")
            continue
        for text in (check_bounds(results, point, row) + check_forces(results, point, window_errors[number]) +
                     check_powers(results, point)):
            found.append(f"point {number}: {text}")
    return found


def disagreements(one, other, torque_unit=1.):
    """Where the operating points of two results differ by more than the sum of their bars: list of texts. The torques
    of the other one are in units of torque_unit mN m."""
    found = []
    if len(one.rows) != len(other.rows):
        return [f"{len(other.rows)} operating points instead of {len(one.rows)}"]
    for quantity, unit, scale in (("speed", "rpm", 1.), ("torque", "mNm", torque_unit)):
        value, bar = f"{quantity}_{unit}", f"{quantity}_error_{unit}"
        difference = abs(one.column(value) - scale * other.column(value))
        allowed = one.column(bar) + scale * other.column(bar) + TINY * abs(one.column(value)).max()
        found += [f"{quantity} at point {i} differs by {difference[i]:.3g} {unit}, the bars allow {allowed[i]:.3g}"
                  for i in numpy.flatnonzero(difference > allowed)]
    return found
