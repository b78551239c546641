# SPDX-License-Identifier: LGPL-2.1-or-later
"""Quantities of a motor by their names, with error bars, from the folder of a case."""
import math
import re
from dataclasses import dataclass

from results.case import Case, CaseError
from results.losses_case import read_case

RPM = math.pi / 30
POINT_UNITS = {"rpm": "rpm", "mNm": "mN m", "mW": "mW"}
NOT_SHOWN = re.compile(r"strain_energy_.*|(tangential|radial)_loss|rotor_power_per_loss_factor")


@dataclass(frozen=True)
class Quantity:
    """A result and its error bar, in a unit as people use it: Hz, rpm, mN m, mW."""

    value: float
    error: float
    unit: str = ""

    def __str__(self):
        bar = f" +- {self.error:.2g}" if self.error else ""
        return f"{self.value:.5g}{bar} {self.unit}".rstrip()


def wave_quantities_of(folder):
    """Frequency and shape of the wave of a case. @throws CaseError"""
    return of_wave(Case(folder))


def of_wave(case):
    """The same of a case that has been read."""
    if not case.wave:
        raise CaseError(f"{case.folder}: the wave of the motor is not among the modes")
    found = {"frequency": Quantity(case.wave["natural_frequency_Hz"], case.wave["natural_frequency_error_Hz"], "Hz")}
    for quantity in case.summary["quantities"]:
        name = quantity["name"]
        if name != "frequency" and not NOT_SHOWN.fullmatch(name):
            unit = quantity["unit"] if quantity["unit"] != "1" else ""
            found[name] = Quantity(quantity["value"], quantity["error"], unit)
    return found


def of_rotor(contact):
    """Of the rotor alone: how its lip answers the wave, and its clearance."""
    found = {}
    for quantity in contact.of_rotor():
        unit, scale = ("mm", 1e3) if quantity["unit"] == "m" else ("", 1.)
        found[quantity["name"]] = Quantity(scale * quantity["value"], scale * quantity["error"], unit)
    return found


def of_point(row):
    """All quantities of an operating point that have an error bar, from a row of its tables."""
    found = {}
    for column, value in row.items():
        name, _, unit = column.rpartition("_")
        name, unit = (name, unit) if unit in POINT_UNITS else (column, "")
        error = f"{name}_error_{unit}" if unit else f"{name}_error"
        if error in row and not NOT_SHOWN.fullmatch(name):
            found[name] = Quantity(value, row[error], POINT_UNITS.get(unit, ""))
    return found


def place_of(row):
    """Where an operating point is, as behind the word "at" in the name of a quantity: N m or rad/s."""
    if row["control"] == "torque":
        return f"{row['torque_mNm'] * 1e-3:.6g}"
    return f"speed {row['speed_rpm'] * RPM:.6g}"


def quantities_of(folder):
    """All quantities of a case whose three programs have run: name -> Quantity. Those of operating points are called
    "efficiency at 0.1" if the torques were given; of a whole curve there are the speed without load, the torque at
    stall and the largest efficiency and output power. @throws CaseError"""
    case, contact, losses, notes = read_case(folder)
    if losses is None:
        raise CaseError("; ".join(notes) or f"{folder} has no results of the program losses")
    found, points = {**of_wave(case), **of_rotor(contact)}, losses.points_with(contact)
    is_curve = contact.parameters["Loading/Values"] == "curve"
    for row in points:
        here = of_point(row)
        if row["control"] == "torque" and row["torque_mNm"] == 0:
            found["no_load_speed"] = here["speed"]
        if row["control"] == "speed" and row["speed_rpm"] == 0:
            found["stall_torque"] = here["torque"]
        prescribed = row["control"]
        if not is_curve:
            found.update({f"{name} at {place_of(row)}": quantity for name, quantity in here.items()
                          if name != prescribed})
    for name in ("efficiency", "output_power"):
        found[f"peak_{name}"] = max((of_point(row)[name] for row in points), key=lambda quantity: quantity.value)
    return found
