# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a motor is asked for: quantities to be as large as possible, limits, values to be met."""
import math
import re
from dataclasses import dataclass

from motors.variation import number_of
from results.case import CaseError

NAME = r"\s*([A-Za-z_][\w/]*(?:\s+at\s+[-+.\deE]+)?)\s*"
NO_MOTOR = 1e6  # excess of a motor that was refused or failed
CURVE_ONLY = ("stall_torque", "peak_efficiency", "peak_output_power")


def name_of(option, text):
    """'efficiency at 0.1' as it is called in the results of a motor."""
    found = re.fullmatch(NAME, text)
    if not found:
        raise CaseError(f'{option} "{text}": expected the name of a quantity, such as no_load_speed or "efficiency at 0.1"')
    name, at, torque = re.sub(r"\s+", " ", found[1]).partition(" at ")
    return f"{name} at {number_of(option, text, torque):.6g}" if at else name


@dataclass(frozen=True)
class Limit:
    """low <= quantity <= high"""

    name: str
    low: float = -math.inf
    high: float = math.inf

    def excess(self, row):
        """How far a motor is outside, relative to the limit; negative inside."""
        value, size = row.quantities[self.name].value, max(abs(x) for x in (self.low, self.high, 0.) if math.isfinite(x))
        return max(self.low - value, value - self.high) / (size or 1.)

    def may_hold(self, row):
        """Within the error bar."""
        quantity = row.quantities[self.name]
        return self.low <= quantity.value + quantity.error and quantity.value - quantity.error <= self.high

    def __str__(self):
        if math.isinf(self.high):
            return f"{self.name} > {self.low:g}"
        return f"{self.name} < {self.high:g}" if math.isinf(self.low) else f"{self.name} = {self.low:g}:{self.high:g}"


def limit(option, text):
    """'frequency = 28e3:32e3', 'no_load_speed > 60' or 'stall_torque < 500'"""
    name, sign, value = re.fullmatch(r"([^<>=]*)([<>=]?)(.*)", text, re.S).groups()
    ends = [number_of(option, text, word) for word in value.split(":")] if sign else []
    if len(ends) != (2 if sign == "=" else 1) or ends != sorted(ends):
        raise CaseError(f'{option} "{text}": expected "QUANTITY > number", "QUANTITY < number" or "QUANTITY = low:high"')
    name = name_of(option, name)
    if sign == "=":
        return Limit(name, *ends)
    return Limit(name, low=ends[0]) if sign == ">" else Limit(name, high=ends[0])


def target(option, text):
    """'frequency = 43e3': name and value."""
    name, equals, value = text.partition("=")
    if not equals:
        raise CaseError(f'{option} "{text}": expected "QUANTITY = number"')
    return name_of(option, name), number_of(option, text, value)


def is_of_wave(name):
    """Whether the program stator alone computes it."""
    return " at " not in name and name not in ("no_load_speed", *CURVE_ONLY)


def loading_for(names):
    """Entries with which a motor has these quantities: torques of operating points, or the whole curve."""
    torques = sorted({float(name.partition(" at ")[2]) for name in names if " at " in name})
    of_curve = [name for name in names if name in CURVE_ONLY]
    if torques and of_curve:
        raise CaseError(f"{of_curve[0]} needs the whole curve, and quantities at given torques leave it out: ask for one kind")
    if not torques:
        return {"Loading/Control": "torque", "Loading/Values": "curve", "Loading/Number of curve points": "5" if any(
            name.startswith("peak") for name in of_curve) else "2"} if of_curve else {
            "Loading/Control": "torque", "Loading/Values": "0"}
    with_none = {0., *torques} if "no_load_speed" in names else set(torques)
    return {"Loading/Control": "torque", "Loading/Values": ", ".join(f"{torque:g}" for torque in sorted(with_none))}


def quantity_of(row, name):
    """@throws CaseError if the motor has no such quantity"""
    if name not in row.quantities:
        raise CaseError(f'there is no quantity "{name}"; there are: {", ".join(row.quantities)}')
    return row.quantities[name]


@dataclass(frozen=True)
class Aim:
    """The quantity to be maximised, or minimised if sign is -1, and the limits of others."""

    name: str
    sign: int
    limits: tuple

    def names(self):
        return [self.name, *(one.name for one in self.limits)]

    def is_of_wave(self):
        return all(map(is_of_wave, self.names()))

    def of(self, row):
        """Value, the larger the better, and error bar."""
        quantity = quantity_of(row, self.name)
        return self.sign * quantity.value, quantity.error

    def excesses(self, row):
        """Of each limit, negative inside; first whether there is a motor at all."""
        if row.outcome != "certified":
            return [NO_MOTOR] * (1 + len(self.limits))
        for one in self.limits:
            quantity_of(row, one.name)
        return [-1., *(one.excess(row) for one in self.limits)]

    def is_possible(self, row):
        """Whether it may keep all limits, within their error bars."""
        return row.outcome == "certified" and all(one.may_hold(row) for one in self.limits)
