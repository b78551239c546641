# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure of a driven motor against the frequency of its drive."""
import itertools

from drawing.basics import KILO, start_figure
from drawing.curve_figures import CASE_STYLE, columns_of, finish_axes


def responses_of(contact):
    """The rows of each torque, in the order along its curve, as columns."""
    for torque, rows in itertools.groupby(contact.response, key=lambda row: row["torque_mNm"]):
        columns = columns_of(list(rows))
        columns["frequency_kHz"] = columns["frequency_Hz"] / KILO
        yield torque, columns


def draw_branches(axes, columns, key, color):
    """Lines from point to point, dotted where one of both is unstable."""
    stable = columns["state"] == "stable"
    for i, solid in enumerate(stable[1:] & stable[:-1]):
        axes.plot(columns["frequency_kHz"][i:i + 2], columns[key][i:i + 2], color=color, lw=1.4, ls="-" if solid else ":")


def draw_response(contact):
    """Speed and amplitude against the frequency at a given voltage, for some torques."""
    voltage = float(contact.parameters["Wave/Voltage"])
    figure = start_figure(contact, f"response to the frequency at {voltage:g} V per phase", (6.6, 6.0))
    upper, lower = figure.subplots(nrows=2, sharex=True)
    for number, (torque, columns) in enumerate(responses_of(contact)):
        color, marker = CASE_STYLE[number % len(CASE_STYLE)]
        for axes, key, error in ((upper, "speed_rpm", columns["speed_error_rpm"]), (lower, "amplitude_um", None)):
            draw_branches(axes, columns, key, color)
            axes.errorbar(columns["frequency_kHz"], columns[key], error, columns["frequency_error_Hz"] / KILO,
                          color=color, marker=marker, ms=3.5, ls="", elinewidth=0.8, label=f"{torque:.4g} mN m")
    for axes in (upper, lower):
        finish_axes(axes)
        axes.set_ylim(0, 1.08 * axes.dataLim.ymax)
    upper.plot([], [], color="black", lw=1.2, ls=":", label="unstable")
    upper.legend(frameon=False, fontsize=8)
    upper.set_ylabel("speed in rpm")
    lower.set(xlabel="frequency of the drive in kHz", ylabel="amplitude of the wave in um")
    return figure
