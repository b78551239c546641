# SPDX-License-Identifier: LGPL-2.1-or-later
"""Looks for the value of an entry with which a quantity has a given value."""
from motors.goals import loading_for, quantity_of
from motors.sweep_table import row_of
from motors.variation import number_text
from results.case import CaseError
from scipy.optimize import root_scalar

COARSE = {"Accuracy/Target": "1e-3", "Accuracy/Contact target": "0.1"}
MOST_CORRECTIONS = 6
NEAR = 1e-4  # of the range, to which the coarse search goes


class Search:
    """A quantity as a function of an entry."""

    def __init__(self, engine, family, one, name, goal):
        self.engine, self.family, self.one, self.name, self.goal = engine, family, one, name, goal
        self.loading = loading_for([name])

    def row(self, value, **settings):
        """@throws CaseError if the motor is not certified"""
        self.engine.submit(self.family.motor({self.one.entry: number_text(value)}, **self.loading, **settings))
        row = row_of(*self.engine.next_done())
        if row.outcome != "certified":
            raise CaseError(f"{self.one.entry} = {number_text(value)} is {row.outcome}: {row.message}")
        quantity = quantity_of(row, self.name)
        print(f"{self.one.entry} = {number_text(value)}: {self.name} = {quantity.value:.6g} +- {quantity.error:.2g} "
              f"{quantity.unit}", flush=True)
        return row

    def distance(self, value, **settings):
        return self.row(value, **settings).quantities[self.name].value - self.goal


def solve(engine, family, one, name, goal):
    """The row of the certified motor, the uncertainty of the entry due to the error bar, and whether the quantity
    meets its goal within the error bar. @throws CaseError if the ends of the range do not enclose the goal"""
    search = Search(engine, family, one, name, goal)
    ends = [search.distance(end, **COARSE) for end in (one.low, one.high)]
    if ends[0] * ends[1] > 0:
        raise CaseError(f'--for "{name} = {goal:g}": between the ends of the range of {one.entry} it goes from '
                        f"{ends[0] + goal:.6g} to {ends[1] + goal:.6g}: choose another range")
    range_size = one.high - one.low
    known = {one.low: ends[0], one.high: ends[1]}

    def coarse(value):
        if value not in known:
            known[value] = search.distance(value, **COARSE)
        return known[value]

    value = root_scalar(coarse, bracket=(one.low, one.high), method="brentq", xtol=NEAR * range_size).root
    near = sorted(known, key=lambda other: abs(other - value))[:2]
    slope = (known[near[0]] - known[near[1]]) / (near[0] - near[1])
    before = None
    for _ in range(MOST_CORRECTIONS):
        row = search.row(value)
        quantity = row.quantities[name]
        distance = quantity.value - goal
        if abs(distance) <= 0.1 * quantity.error:
            break
        if before and abs(value - before[0]) > 1e-12 * range_size:
            slope = (distance - before[1]) / (value - before[0])
        before = value, distance
        value = min(one.high, max(one.low, value - distance / slope))
    return row, abs(quantity.error / slope), abs(distance) <= quantity.error
