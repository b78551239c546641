# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure of what a designer turns first: how much each entry of a motor changes its results."""
from drawing.basics import BLUE, GREY, ORANGE, start_figure

MOST_BARS = 10
TITLES = {"frequency": "frequency of the wave", "no_load_speed": "speed without load", "stall_torque": "stall torque",
          "half_load_speed": "speed at half load", "half_load_friction_loss": "friction loss at half load",
          "half_load_efficiency": "efficiency at half load"}


def bars_of(rows, quantity):
    """(entry, percent per percent, error bar) of the entries that change a quantity most, the largest first; radii per
    percent of their distance from the next one."""
    bars = []
    for row in rows:
        if row[quantity] != "":
            factor = row["scale"] / abs(row["value"])
            bars.append((row["entry"], factor * row[quantity], factor * row[quantity + "_error"]))
    bars.sort(key=lambda bar: -abs(bar[1]))
    return bars[:MOST_BARS]


def short(entry):
    """The last two names of an entry, without words that its section repeats."""
    names = entry.split("/")
    return ": ".join(names[-2:])


def draw_panel(axes, bars, title):
    places = range(len(bars))
    for place, (_, value, error) in zip(places, bars):
        axes.barh(place, value, color=BLUE if value > 0 else ORANGE, height=0.7)
        axes.errorbar(value, place, xerr=error, color="black", elinewidth=0.8, capsize=2, ls="")
    axes.set_yticks(list(places), [short(entry) for entry, _, _ in bars], fontsize=7)
    axes.invert_yaxis()
    axes.axvline(0, color=GREY, lw=0.7)
    axes.set_title(title, fontsize=9)
    axes.tick_params(axis="y", length=0)
    axes.spines[["top", "right", "left"]].set_visible(False)


def draw_sensitivities(contact):
    """For each quantity the entries that change it most, with the sign of the change."""
    figure = start_figure(contact, "percent of change per percent of an entry", (9.6, 8.2))
    panels = figure.subplots(3, 2).flatten()
    for axes, (quantity, title) in zip(panels, TITLES.items()):
        draw_panel(axes, bars_of(contact.sensitivities, quantity), title)
    return figure
