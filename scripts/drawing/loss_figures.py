# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures of the losses and the efficiency of a motor against its torque."""
import numpy as np
from drawing.basics import BLUE, GREEN, GREY, ORANGE, PURPLE, SKY, start_figure
from drawing.curve_figures import draw_points, draw_steps, finish_axes, is_fall, sorted_columns

BLACK = "#000000"
VISIBLE = 0.006  # of the height of a figure: smaller error bars would be blots
CURVES = (("total_loss_mW", "total", BLACK, "o", "-"),
          ("internal_loss_mW", "inside stator and rotor", BLUE, "s", "--"),
          ("friction_loss_mW", "friction", ORANGE, "^", "-"),
          ("support_loss_mW", "support", GREEN, "D", ":"))
INTERNAL = ("internal_loss_stator", "internal_loss_rotor")
LAYERS = (("output_power", "output", BLUE), ("friction_loss", "friction", ORANGE),
          ("internal_loss_stator_metal", "stator metal", GREY), ("internal_loss_piezoceramic", "piezoceramic", PURPLE),
          ("internal_loss_stator_vibration", "other modes of the stator", SKY),
          ("internal_loss_rotor", "rotor", BLACK), ("support_loss", "support", GREEN))


def loss_columns(losses, contact):
    """Columns of the operating points, with the internal losses of both bodies added up, and the squares of their errors,
    which are independent for the most part."""
    columns = sorted_columns(losses.points_with(contact))
    columns["internal_loss_mW"] = sum(columns[name + "_mW"] for name in INTERNAL)
    columns["internal_loss_error_mW"] = np.hypot(*(columns[name + "_error_mW"] for name in INTERNAL))
    columns["efficiency_percent"] = 100 * columns["efficiency"]
    columns["efficiency_error_percent"] = 100 * columns["efficiency_error"]
    return columns


def start_axes(losses, title, size):
    figure = start_figure(losses, title, size)
    axes = figure.subplots()
    finish_axes(axes)
    axes.set_xlabel("torque in mN m")
    return figure, axes


def draw_losses(losses, contact):
    """Fig. 14 of the paper."""
    figure, axes = start_axes(losses, "power losses against torque", (6.2, 4.4))
    columns = loss_columns(losses, contact)
    for key, name, color, marker, style in CURVES:
        draw_steps(axes, columns, key, color, style, 1.4)
        draw_points(axes, columns, key, key.replace("_mW", "_error_mW"), color, marker)
        axes.plot([], [], color=color, marker=marker, ms=4, ls=style, lw=1.4, label=name)
    axes.set(ylabel="power loss in mW", ylim=(0, 1.08 * axes.dataLim.ymax))
    axes.legend(frameon=False, fontsize=8, loc="best", handlelength=3)
    return figure


def draw_efficiency(losses, contact):
    """Fig. 15 of the paper."""
    figure, axes = start_axes(losses, "efficiency against torque", (6.2, 3.8))
    columns = loss_columns(losses, contact)
    draw_steps(axes, columns, "efficiency_percent", BLUE, "-", 1.4)
    draw_points(axes, columns, "efficiency_percent", "efficiency_error_percent", BLUE, "o")
    axes.set(ylabel="efficiency in %", ylim=np.array([-0.03, 1.1]) * max(1, axes.dataLim.ymax))
    return figure


def range_text(values):
    low, high = (f"{round(value)}" if value > 100 or value < 1e-3 else f"{value:.3g}"
                 for value in (values.min(), values.max()))
    return f"{low} mW" if low == high else f"{low} to {high} mW"


def runs_and_falls(columns):
    """Numbers of operating points that follow each other, and the pairs between which the speed breaks down."""
    falls = np.flatnonzero(is_fall(columns))
    runs = np.split(np.arange(len(columns["torque_mNm"])), falls + 1)
    return [(run, 1.0) for run in runs] + [(np.array([i, i + 1]), 0.35) for i in falls]


def draw_layer(axes, columns, below, name, color):
    torque = columns["torque_mNm"]
    above = below + np.maximum(0, columns[name + "_mW"])  # a load that drives the motor puts power in: no output
    for points, alpha in runs_and_falls(columns):
        for paint, strength in (("white", 1), (color, alpha)):  # white keeps the grid from showing through
            axes.fill_between(torque[points], below[points], above[points], color=paint, lw=0, alpha=strength)
    axes.plot(torque, above, color="white", lw=0.8)
    return above


def draw_energy(losses, contact):
    """Output and losses on top of each other; pale where the speed breaks down: nothing is known between."""
    figure, axes = start_axes(losses, "where the power goes, against torque", (7.4, 4.4))
    columns = loss_columns(losses, contact)
    if len(losses.points) == 1:  # a block around the only torque
        columns = {key: np.repeat(values, 2) for key, values in columns.items()}
        columns["torque_mNm"] = columns["torque_mNm"] + np.array([-1, 1])
    torque, highest = columns["torque_mNm"], columns["input_power_mW"].max()
    below = np.zeros_like(torque)
    for name, label, color in LAYERS:
        if name == "internal_loss_stator_vibration" and not columns[name + "_mW"].any():
            continue  # Effects/Stator compliance is off
        below = draw_layer(axes, columns, below, name, color)
        error = columns[name + "_error_mW"]
        shown = np.flatnonzero(error > VISIBLE * highest)
        axes.errorbar(torque[shown], below[shown], error[shown], color="black", ls="", capsize=2.5, elinewidth=0.9,
                      zorder=4, clip_on=False)
        axes.fill_between([], [], color=color, lw=0, label=f"{label}\n{range_text(columns[name + '_mW'])}")
    handles, names = axes.get_legend_handles_labels()
    axes.legend(handles[::-1], names[::-1], frameon=False, fontsize=8, loc="center left", bbox_to_anchor=(1.01, 0.5),
                labelspacing=0.9, title="error bars: of the\nlayer below them", title_fontsize=8, alignment="left")
    axes.set(ylabel="power in mW", ylim=(0, None), xlim=(torque[0], torque[-1]))
    if len(losses.points) == 1:
        axes.set_xticks([losses.points[0]["torque_mNm"]])
    return figure


def draw_drive(losses, contact):
    """What the phases need so that the wave keeps its amplitude, or the amplitude that they give it, and the efficiency
    of the electrical input."""
    figure = start_figure(losses, "drive of the phases against torque", (6.2, 5.0))
    upper, lower = figure.subplots(nrows=2, sharex=True)
    columns = loss_columns(losses, contact)
    columns["electrical_efficiency_percent"] = 100 * columns["electrical_efficiency"]
    columns["electrical_efficiency_error_percent"] = 100 * columns["electrical_efficiency_error"]
    current = upper.twinx()
    is_driven = losses.parameters["Wave/Drive"] == "voltage"
    found = ("amplitude_um", "amplitude_error_um") if is_driven else ("voltage_V", "voltage_error_V")
    for axes, key, error, color, marker, style in (
            (upper, *found, BLUE, "o", "-"),
            (current, "current_mA", "current_error_mA", ORANGE, "s", "--"),
            (lower, "electrical_efficiency_percent", "electrical_efficiency_error_percent", BLUE, "o", "-")):
        draw_steps(axes, columns, key, color, style, 1.4)
        draw_points(axes, columns, key, error, color, marker)
        axes.set_ylim(0, 1.12 * axes.dataLim.ymax)
    finish_axes(upper)
    finish_axes(lower)
    current.spines["top"].set_visible(False)
    upper.set_ylabel("amplitude of the wave in um" if is_driven else "voltage of a phase in V, peak", color=BLUE)
    current.set_ylabel("current of a phase in mA, peak", color=ORANGE)
    lower.set(xlabel="torque in mN m", ylabel="electrical efficiency in %")
    return figure
