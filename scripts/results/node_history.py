# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a contact node goes through while a crest passes: the time course of Fig. 11 of the paper, and its phases in words."""
import itertools

import numpy as np
from results.contact_case import NORMAL, OPEN, STICK, TANGENTIAL

MICRO = 1e-6
STATUS = {"open": OPEN, "stick": STICK}
BRAKES, STICKS, DRIVES, RELEASES = "brakes", "sticks", "drives", "releases"  # friction on the rotor, at a node


def covers_a_period(case, rows):
    times = [row["time_us"] for row in rows]
    return max(times) - min(times) > 0.85 * case.period / MICRO


def history_from_table(case, point):
    """Of the chosen point that is pressed most: time in us, force in N, slip in um, status; steady states only."""
    rows = case.history(point)
    most = max(rows, key=lambda row: row["force_n_N"])
    rows = [row for row in rows if (row["tooth"], row["node"]) == (most["tooth"], most["node"])]
    column = {key: np.array([row[key] for row in rows]) for key in rows[0] if key != "status"}
    status = np.array([STATUS.get(row["status"], STICK + 1) for row in rows])
    time, period = column["time_us"], case.period / MICRO
    # One period is a circle: cut it in the middle of the longest time without contact.
    touching = np.flatnonzero(status != OPEN)
    pauses = np.diff(time[touching], append=time[touching[0]] + period)
    cut = (time[touching[np.argmax(pauses)]] + pauses.max() / 2) % period
    angle = np.radians(column["theta_deg"][0]) + 2 * np.pi * most["tooth"] / case.n_teeth
    crest = angle * case.n_waves / case.angular_frequency / MICRO
    order = np.argsort((time - cut) % period)
    shown = cut + (time[order] - cut) % period - crest
    shown -= period * np.round(np.mean(shown[status[order] != OPEN]) / period)
    force = np.stack([column[f"force_{c}_N"] for c in "ntr"], axis=1)
    return shown, force[order], column["slip_t_um"][order], status[order]


def history_from_fields(case, point):
    """The same of a marched motor: the tooth whose time in contact lies best within the marched time."""
    fields = case.fields(point)
    time = fields["time"]
    nodes = case.line(case.radius.max())
    touching = fields["status"][:, :, nodes] != OPEN  # by moment, tooth, node
    is_whole = ~touching[0] & ~touching[-1]
    pressed = np.where(touching.any(axis=0), fields["force"][:, :, nodes, NORMAL].max(axis=0), 0)
    score = pressed * (1 + 2 * is_whole) * (1 + ~touching[-1])
    tooth, place = np.unravel_index(np.argmax(score), score.shape)
    node = nodes[place]
    angle = case.angle[node] + 2 * np.pi * tooth / case.n_teeth
    lag = (case.n_waves * angle / case.angular_frequency) % case.period  # when the crest comes by
    shown = (time - lag) / MICRO
    shown -= case.period / MICRO * np.round(shown.mean() * MICRO / case.period)
    return (shown, fields["force"][:, tooth, node], fields["gap_and_slip"][:, tooth, node, TANGENTIAL] / MICRO,
            fields["status"][:, tooth, node])


def phases_of(slip, status):
    """What friction does at a node in each step. A node of the rotor that slips forwards is braked."""
    return [RELEASES if state == OPEN else STICKS if state == STICK else BRAKES if moved > 0 else DRIVES
            for moved, state in zip(slip, status)]


def pass_of_node(case, point):
    """The phases of the node that is pressed most, one after the other, up to "releases"; nothing if none is pressed or
    the node never breaks contact."""
    rows = case.history(point)
    if not (covers_a_period(case, rows) and any(row["force_n_N"] > 0 for row in rows)):
        return []
    _, _, slip, status = history_from_table(case, point)
    phases = [phase for phase, _ in itertools.groupby(phases_of(slip, status))]
    return phases[1:] if phases[0] == RELEASES and phases[-1] == RELEASES else []
