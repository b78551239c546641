# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure of the torque-speed curve, of one case or of several together."""
import numpy as np
from drawing.basics import BLUE, GREEN, GREY, ORANGE, PURPLE, SKY, literal, start_figure

CASE_STYLE = ((BLUE, "o"), (ORANGE, "s"), (GREEN, "^"), (PURPLE, "D"), (SKY, "v"))
PARTS = {"friction_loss_mW": ("total", "-"), "tangential_loss_mW": ("along the ring", "--"),
         "radial_loss_mW": ("radial", ":")}


def columns_of(rows):
    """The rows of a table, by name of a column."""
    return {key: np.array([row[key] for row in rows]) for key in rows[0]}


def sorted_columns(points):
    """Of the rows of a table of operating points, by name of a column: along a curve from no load to stall, on which a
    driven wave may bear less at the end than before it, else in the order of their torques."""
    is_curve = all(one["speed_rpm"] > next_one["speed_rpm"] for one, next_one in zip(points, points[1:]))
    rows = points if is_curve else sorted(points, key=lambda row: row["torque_mNm"])
    return columns_of(rows)


def is_fall(curve):
    """Of each step from point to point: whether the speed breaks down in it, as at stall."""
    return abs(np.diff(curve["speed_rpm"])) > 0.4 * abs(curve["speed_rpm"]).max()


def draw_steps(axes, curve, key, color, style, width):
    """Lines from point to point; a thin one where the speed breaks down: nothing is known between."""
    values = np.where(curve[key] > 0, curve[key], np.nan) if "loss" in key else curve[key]
    for i, is_gap in enumerate(is_fall(curve)):
        axes.plot(curve["torque_mNm"][i:i + 2], values[i:i + 2], color=color, ls=style, lw=0.5 if is_gap else width)


def draw_points(axes, curve, key, error, color, marker, name=None):
    bars = [np.where(curve[name] > 0, curve[name], np.nan) if any(curve[name] > 0) else None
            for name in (error, "torque_error_mNm")]
    axes.errorbar(curve["torque_mNm"], curve[key], *bars, color=color, marker=marker,
                  ms=4, ls="", capsize=2.5, elinewidth=0.9, label=name)


def finish_axes(axes):
    axes.spines[["top", "right"]].set_visible(False)
    axes.grid(color="#DDDDDD", lw=0.5)
    axes.set_axisbelow(True)


def name_of(case):
    """The motor with what is given of its wave."""
    is_driven = case.parameters["Wave/Drive"] == "voltage"
    given = (f"{float(case.parameters['Wave/Voltage']):g} V" if is_driven
             else f"{1e6 * float(case.parameters['Wave/Amplitude']):g} um")
    return literal(case.motor) + ", " + given


def draw_torque_speed(case, others=()):
    """Fig. 12 of the paper, and the friction loss below it."""
    cases = [case, *others]
    figure = start_figure(case, "speed and friction loss against torque", (6.2, 5.4))
    upper, lower = figure.subplots(nrows=2, sharex=True, height_ratios=(1.3, 1))
    for number, one in enumerate(cases):
        color, marker = CASE_STYLE[number % len(CASE_STYLE)]
        curve = sorted_columns(one.curve)
        draw_points(upper, curve, "speed_rpm", "speed_error_rpm", color, marker, name_of(one))
        draw_points(lower, curve, "friction_loss_mW", "friction_loss_error_mW", color, marker)
        draw_steps(upper, curve, "speed_rpm", color, "-", 1.4)
        for key, (_, style) in PARTS.items():
            draw_steps(lower, curve, key, color, style, 1.3)
    if others:
        upper.legend(frameon=False, fontsize=8, loc="lower left")
    for name, style in PARTS.values():
        lower.plot([], [], color=GREY if others else CASE_STYLE[0][0], ls=style, lw=1.2, label=name)
    lower.legend(frameon=False, fontsize=8, loc="lower left", bbox_to_anchor=(0, 1), ncol=3, borderpad=0.1)
    upper.set(ylabel="speed in rpm", ylim=(-0.04 * upper.dataLim.ymax, 1.08 * upper.dataLim.ymax))
    lower.set(xlabel="torque in mN m", ylabel="friction loss in mW", yscale="log")
    lower.yaxis.set_major_formatter("{x:g}")
    for axes in (upper, lower):
        finish_axes(axes)
    return figure


def draw_lip_amplification(case):
    """What inertia makes of the lip's compliance, for the first harmonics of the wave; dots where it counts."""
    figure = start_figure(case, "dynamic over static compliance of the lip", (6.2, 3.6))
    axes = figure.subplots()
    frequency = case.angular_frequency / (2e3 * np.pi)
    for number, (color, _) in enumerate(CASE_STYLE, start=1):
        rows = [row for row in case.lip if row["harmonic"] == number]
        if not rows:
            continue
        x, y = (np.array([row[key] for row in rows]) for key in ("frequency_kHz", "amplification"))
        axes.plot(x, abs(y), color=color, lw=1.3, label=f"{rows[0]['nodal_diameter']:.0f} waves")
        axes.plot(number * frequency, abs(np.interp(number * frequency, x, y)), "o", color=color, ms=5)
    axes.axhline(1, color=GREY, lw=0.8, ls="--")
    axes.set(xlabel="frequency in kHz", ylabel="with inertia over without", yscale="log", ylim=(0.05, 100),
             xlim=(0, 5 * frequency))
    axes.yaxis.set_major_formatter("{x:g}")
    axes.legend(frameon=False, fontsize=8)
    finish_axes(axes)
    return figure
