# SPDX-License-Identifier: LGPL-2.1-or-later
"""Inputs that are not known exactly: samples of motors, and what they make of the quantities' error bars."""
import csv
import math
import os
from dataclasses import dataclass

import numpy as np
from drawing.basics import BLUE, GREY, ORANGE, literal, plt, save
from motors.variation import number_text
from results.case import CaseError
from scipy.stats import norm, qmc

# Of each material its own, of friction both together: as the section Uncertainty of a parameter file is read.
SOURCES = (("Uncertainty/Loss factors", "/Loss factor", True), ("Uncertainty/Young moduli", "/Young modulus", True),
           ("Uncertainty/Friction", "Friction/", False))
FRICTION = ("Friction/Dynamic coefficient", "Friction/Static coefficient")
LARGEST = {"Loss factor": 1.}


@dataclass(frozen=True)
class UncertainInput:
    """Entries that vary together: their logarithms with a standard deviation."""

    name: str
    entries: tuple
    deviation: float


def uncertain_inputs(entries):
    """What the section Uncertainty says of a motor. @throws CaseError if it says nothing"""
    found = []
    for source, ending, is_each in SOURCES:
        deviation = float(entries[source])
        names = [entry for entry in entries if entry.startswith("Materials/") and entry.endswith(ending)] if is_each else FRICTION
        used = tuple(entry for entry in names if is_used(entry, entries))
        if deviation > 0 and used:
            found += [UncertainInput(entry, (entry,), deviation) for entry in used] if is_each else [
                UncertainInput("Friction", used, deviation)]
    if not found:
        raise CaseError("--uncertainty: no input is uncertain; set some of " + ", ".join(source for source, *_ in SOURCES) +
                        ", relative standard deviations")
    return found


def is_used(entry, entries):
    """Whether a motor has the material, and the entry a value that can vary in proportion."""
    if entry.startswith("Materials/Target plate/") and entries["Effects/Target plates"] == "off":
        return False
    if entry.startswith("Materials/Piezoceramic/") and float(entries["Stator/Piezoceramic thickness"]) == 0.:
        return False
    return float(entries[entry]) > 0.


def sample_of(inputs, count, seed):
    """A Latin hypercube of standard normal numbers: one row for each motor, one column for each input."""
    return norm.ppf(qmc.LatinHypercube(len(inputs), seed=seed).random(count))


def motor_of(inputs, deviates, entries):
    """The entries of one motor, as texts; with no deviates those of the motor itself."""
    varied = {}
    for one, deviate in zip(inputs, deviates):
        for entry in one.entries:
            value = float(entries[entry]) * math.exp(one.deviation * deviate)
            varied[entry] = number_text(min(value, LARGEST.get(entry.rpartition("/")[2], math.inf)))
    return varied


@dataclass(frozen=True)
class Spread:
    """A quantity with its numerical error bar, the standard deviation that the inputs give it, and the share of each input
    in their variance."""

    name: str
    unit: str
    value: float
    error: float
    deviation: float
    shares: dict


def spreads_of(nominal, rows, inputs, deviates):
    """@param nominal row of the motor itself @param rows those of the sample @param deviates as of sample_of()"""
    certified = [number for number, row in enumerate(rows) if row.quantities]
    if len(certified) < len(inputs) + 2:
        raise CaseError(f"{len(certified)} motors of the sample are certified, too few for {len(inputs)} uncertain inputs; "
                        "the table has the words of the others")
    found = []
    for name, quantity in nominal.quantities.items():
        having = [number for number in certified if name in rows[number].quantities]
        values = np.array([rows[number].quantities[name].value for number in having])
        variances = variances_of(values, deviates[having])
        total = float(sum(variances))
        found.append(Spread(name, quantity.unit, quantity.value, quantity.error, math.sqrt(total),
                            {one.name: float(part / total) if total > 0 else 0. for one, part in zip(inputs, variances)}))
    return found


def variances_of(values, deviates):
    """Those that each input causes by itself, by regression, and, last, that of the rest, which is not linear."""
    system = np.column_stack([np.ones(len(values)), deviates])
    slopes = np.linalg.lstsq(system, values, rcond=None)[0]
    rest = np.sum((values - system @ slopes) ** 2) / (len(values) - len(slopes))
    return [*slopes[1:] ** 2, rest]


def write_spreads(path, spreads):
    part = f"{path}.part"
    with open(part, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(["quantity", "unit", "value", "numerical_error", "deviation_of_inputs",
                         *(f"share of {name}" for name in spreads[0].shares)])
        for one in spreads:
            writer.writerow([one.name, one.unit, one.value, one.error, one.deviation, *one.shares.values()])
    os.replace(part, path)


def in_words(spread):
    """A line for a reader."""
    main = max(spread.shares, key=spread.shares.get)
    mostly = f", {100 * spread.shares[main]:.0f} % of it from {main}" if spread.shares[main] > 0.5 else ""
    value, error, deviation = (f"{number:.{digits}g} {spread.unit}".rstrip() for number, digits in (
        (spread.value, 6), (spread.error, 3), (spread.deviation, 3)))
    return f"  {spread.name} = {value} +- {error} (numerical) +- {deviation} (inputs{mostly})"


def draw_spreads(output, title, spreads):
    """Both bars of each quantity, relative to its value."""
    shown = [one for one in spreads if one.value != 0. and (one.error > 0. or one.deviation > 0.)]
    figure, axes = plt.subplots(figsize=(6.4, 0.9 + 0.34 * len(shown)), layout="constrained")
    figure.suptitle(literal(title), fontsize=10)
    places = np.arange(len(shown))
    for shift, color, words, part in ((-0.18, BLUE, "numerical error", "error"),
                                      (0.18, ORANGE, "standard deviation by the inputs", "deviation")):
        axes.barh(places + shift, [abs(100 * getattr(one, part) / one.value) for one in shown], 0.34, color=color, label=words)
    axes.set_yticks(places, [one.name.replace("_", " ") for one in shown])
    axes.invert_yaxis()
    axes.set(xscale="log", xlabel="% of the value")
    axes.grid(axis="x", color=GREY, lw=0.3, alpha=0.4)
    axes.set_axisbelow(True)
    axes.spines[["top", "right"]].set_visible(False)
    axes.legend(frameon=False, loc="lower right", bbox_to_anchor=(1., 1.), ncol=2)
    folder = os.path.join(output, "figures")
    os.makedirs(folder, exist_ok=True)
    save(figure, folder, "uncertainty")
