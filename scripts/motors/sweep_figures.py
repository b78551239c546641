# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures of many motors: each quantity over one or two entries that vary, with error bars; Pareto fronts."""
import math
import os

from drawing.basics import BLUE, GREEN, GREY, ORANGE, PURPLE, SKY, literal, plt, save
from motors.sweep_table import names_of, unit_of

MOST_LINES = 5
COLORS = (BLUE, ORANGE, GREEN, PURPLE, SKY)


def is_number(text):
    try:
        return math.isfinite(float(text))
    except ValueError:
        return False


def label(name, unit):
    return f"{name.replace('_', ' ')}{f' ({unit})' if unit else ''}"


def start(title, n_columns, n_rows):
    figure, axes = plt.subplots(n_rows, n_columns, figsize=(3.4 * n_columns, 2.6 * n_rows), layout="constrained",
                                squeeze=False)
    figure.suptitle(literal(title), fontsize=10)
    for one in axes.flat:
        one.grid(color="#EEEEEE", lw=0.5)
        one.set_axisbelow(True)
        one.spines[["top", "right"]].set_visible(False)
    return figure, axes


def values_of(rows, name):
    return [row.quantities[name].value for row in rows], [row.quantities[name].error for row in rows]


class Axis:
    """An entry on the horizontal axis: numbers where they stand, words side by side."""

    def __init__(self, rows, entry):
        self.entry, texts = entry, list(dict.fromkeys(row.varied[entry] for row in rows))
        self.is_number = all(map(is_number, texts))
        self.texts = sorted(texts, key=float) if self.is_number else texts

    def place(self, row):
        text = row.varied[self.entry]
        return float(text) if self.is_number else self.texts.index(text)

    def show(self, axes):
        axes.set_xlabel(self.entry)
        if not self.is_number:
            axes.set_xticks(range(len(self.texts)), self.texts)


def draw_quantity(axes, rows, name, axis, other):
    """Over one entry; a line for each value of another one, if there are few."""
    groups = [(None, rows)]
    if other and len(other.texts) <= MOST_LINES:
        groups = [(text, [row for row in rows if row.varied[other.entry] == text]) for text in other.texts]
    is_sample = len(rows) > len(axis.texts) * len(groups) or (other and len(groups) == 1)
    for (text, group), color in zip(groups, COLORS):
        group = sorted(group, key=axis.place)
        values, errors = values_of(group, name)
        axes.errorbar([axis.place(row) for row in group], values, yerr=errors, fmt="o" if is_sample else "o-", color=color,
                      ms=2.5, lw=0.9, elinewidth=0.7, capsize=1.5, label=text)
    axis.show(axes)
    axes.set_ylabel(label(name, unit_of(rows, name)))
    if len(groups) > 1:
        axes.legend(title=other.entry, fontsize=6.5, title_fontsize=6.5, frameon=False)


def draw_quantities(output, title, rows):
    """A panel for each quantity and, where more than two entries vary or they were drawn, for each entry."""
    names, entries = names_of(rows), list(rows[0].varied)
    axes_of = {entry: Axis(rows, entry) for entry in entries}
    varying = [entry for entry in entries if len(axes_of[entry].texts) > 1] or entries[:1]
    is_grid = len(varying) == 1 or (len(varying) == 2 and min(len(axes_of[entry].texts) for entry in varying) <= MOST_LINES)
    if is_grid:
        first, *others = sorted(varying, key=lambda entry: -len(axes_of[entry].texts))
        pairs = [(first, others[0] if others else None)]
    else:
        pairs = [(entry, next(other for other in varying if other != entry)) for entry in varying]
    n_columns = min(3, len(names)) if is_grid else len(pairs)
    figure, axes = start(title, n_columns, math.ceil(len(names) * len(pairs) / n_columns))
    for one in axes.flat[len(names) * len(pairs):]:
        one.set_axis_off()
    for number, (name, (entry, other)) in enumerate((name, pair) for name in names for pair in pairs):
        having = [row for row in rows if name in row.quantities]
        draw_quantity(axes.flat[number], having, name, axes_of[entry], other and axes_of[other])
    save(figure, output, "quantities")


def pareto_front(rows, goodness):
    """Those of which no other one is better in both respects, in the order of the first.
    @param goodness two numbers of a row, the larger the better"""
    front, best = [], -math.inf
    for row in sorted(rows, key=lambda row: goodness(row), reverse=True):
        if goodness(row)[1] > best:
            front.append(row)
            best = goodness(row)[1]
    return front[::-1]


def draw_against(axes, groups, first, second):
    """Two quantities against each other, for each of (rows, colour, size, format)."""
    for rows, color, size, style in groups:
        x, x_error = values_of(rows, first)
        y, y_error = values_of(rows, second)
        axes.errorbar(x, y, xerr=x_error, yerr=y_error, fmt=style, color=color, ms=size, lw=0.9, elinewidth=0.6)
    rows = groups[0][0]
    axes.set(xlabel=label(first, unit_of(rows, first)), ylabel=label(second, unit_of(rows, second)))


def draw_optimum(output, title, staged, aim, best):
    """The search: the quantity of each motor in the order in which they were computed, and against the limited ones;
    grey where limits are not kept, the Pareto front of quantity and limit, the best one.
    @param staged (Contact target, row) of all motors @param best rows"""
    rows = [row for _, row in staged if row.quantities]
    possible = [row for row in rows if aim.is_possible(row)]
    figure, axes = start(f"{title}: {aim.name} of {len(staged)} motors", 1 + len(aim.limits), 1)
    for group, color, words in ((rows, GREY, "beyond a limit"), (possible, BLUE, "within the limits"),
                                (best[:1], ORANGE, "the best")):
        values, errors = values_of(group, aim.name)
        axes[0, 0].errorbar([rows.index(row) + 1 for row in group], values, yerr=errors, fmt="o", color=color, ms=2.5,
                            elinewidth=0.6, label=words)
    axes[0, 0].set(xlabel="motor", ylabel=label(aim.name, unit_of(rows, aim.name)))
    if aim.limits:
        axes[0, 0].plot([], [], "o-", color=GREEN, ms=2.5, lw=0.9, label="Pareto front")
        axes[0, 0].legend(fontsize=6, loc="lower right", framealpha=0.8, edgecolor="none")
    for panel, one in zip(axes[0, 1:], aim.limits):
        sign = -1 if one.low == -math.inf else 1  # less is better of what is limited from above
        front = pareto_front(possible, lambda row: (aim.of(row)[0], sign * row.quantities[one.name].value))
        draw_against(panel, [(rows, GREY, 2, "o"), (possible, BLUE, 2.5, "o"), (front, GREEN, 3, "o-"),
                             (best[:1], ORANGE, 4, "o")], aim.name, one.name)
        for end in (one.low, one.high):
            if math.isfinite(end):
                panel.axhline(end, color=GREY, lw=0.8, ls="--")
    folder = os.path.join(output, "figures")
    os.makedirs(folder, exist_ok=True)
    save(figure, folder, "optimum")


def draw_sweep(output, title, rows):
    """The figures of a sweep, of the motors that are certified. Returns their folder, None without such motors."""
    rows = [row for row in rows if row.quantities]
    if not rows:
        return None
    folder = os.path.join(output, "figures")
    os.makedirs(folder, exist_ok=True)
    draw_quantities(folder, title, rows)
    return folder
