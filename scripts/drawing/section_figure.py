# SPDX-License-Identifier: LGPL-2.1-or-later
"""The drawing of the motor: cross-sections of stator and rotor with their parts, supports and loads."""
import collections

import numpy as np
from drawing.basics import BLUE, GREEN, GREY, METAL, MILLI, ORANGE, PURPLE, SKY, start_figure
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

PART_COLOR = {"base": METAL, "tooth": "#CFCFCF", "piezoceramic": "#F2D5C4", "rotor": "#DCE8F2", "lining": "#B9D9C9",
              "adhesive": "#F5EFC0"}
EDGE_COLOR = {"contact": ORANGE, "pressed": BLUE, "driven": GREEN, "clamped": "black", "bars": PURPLE, "felt": SKY}
EDGE_WORDS = {"contact": "contact", "pressed": "preload", "driven": "torque", "clamped": "clamped", "bars": "bars",
              "felt": "felt"}


def outline(cells):
    """The edges of cells that lie between different parts or outside."""
    parts_at = collections.defaultdict(list)
    for cell in cells:
        corners = [tuple(corner) for corner in cell["corners"]]
        for one, other in zip(corners, corners[1:] + corners[:1]):
            parts_at[tuple(sorted((one, other)))].append(cell["part"])
    return [edge for edge, parts in parts_at.items() if len(parts) == 1 or parts[0] != parts[1]]


def corners_of(lines):
    """The points at which an outline turns."""
    directions = collections.defaultdict(list)
    for one, other in lines:
        direction = np.subtract(other, one) / np.hypot(*np.subtract(other, one))
        directions[one].append(direction)
        directions[other].append(-direction)
    return [point for point, at in directions.items()
            if len(at) != 2 or abs(at[0][0] * at[1][1] - at[0][1] * at[1][0]) > 0.02]


def shell_outline(shell):
    """The line of a shell with its thickness, as a polygon."""
    points = np.array(shell["points"])
    along = np.gradient(points, axis=0)
    across = np.stack([-along[:, 1], along[:, 0]], axis=1) / np.linalg.norm(along, axis=1)[:, None]
    half = 0.5 * shell["thickness"] * across
    return np.concatenate([points + half, (points - half)[::-1]])


def draw_body(axes, body):
    """Draws one body; the places of its corners."""
    cells = body["cells"]
    polygons = [np.array(cell["corners"]) / MILLI for cell in cells]
    axes.add_collection(PolyCollection(polygons, facecolors=[PART_COLOR[cell["part"]] for cell in cells], lw=0))
    lines = outline(cells)
    axes.add_collection(LineCollection(np.array(lines) / MILLI, colors=GREY, lw=0.8))
    for edge in body["edges"]:
        ends = np.array(edge["ends"]) / MILLI
        axes.plot(*ends.T, color=EDGE_COLOR[edge["name"]], lw=2.6, solid_capstyle="butt", zorder=3)
    corners = corners_of(lines)
    if "shell" in body:
        polygon = shell_outline(body["shell"])
        axes.fill(*(polygon / MILLI).T, facecolor=PART_COLOR["rotor"], edgecolor=GREY, lw=0.8)
        n = body["shell"]["segments_in_contact"]
        low = polygon[::-1][:n + 1] / MILLI
        axes.plot(*low.T, color=EDGE_COLOR["contact"], lw=2.6, solid_capstyle="butt", zorder=3)
        corners += [tuple(point) for point in polygon[[0, -1]]] + [tuple(low[-1] * MILLI)]
    return corners


def ticks_of(places, other_places):
    """Distinct places in mm, no closer to each other than labels need; both axes have one scale."""
    length = max(np.ptp(places), 0.7 * np.ptp(other_places)) / MILLI
    ticks = []
    for place in sorted({round(place / MILLI, 4) for place in places}):
        if not ticks or place - ticks[-1] > 0.027 * length:
            ticks.append(place)
    return ticks


def words_of_slots(slots):
    walls = f"{slots['width'] / MILLI:g} mm wide between parallel walls" if slots["angle"] is None else \
        f"{np.degrees(slots['angle']):g}° between radial walls"
    return f"{slots['number']} slots, {walls}"


def draw_sections(case):
    bodies = case.sections
    figure = start_figure(case, "cross-sections, dimensions in mm", (7.2, 5.4))
    axes = figure.subplots()
    corners = [corner for body in bodies.values() for corner in draw_body(axes, body)]
    radii, heights = np.array(corners).T
    axes.set_xticks(ticks_of(radii, heights))
    axes.set_yticks(ticks_of(heights, radii))
    axes.tick_params(axis="x", labelrotation=90)
    axes.tick_params(labelsize=7)
    axes.grid(color="#EFEFEF", lw=0.6)
    axes.set_axisbelow(True)
    axes.set(aspect="equal", xlabel="$r$", ylabel="$z$")
    axes.margins(0.04)
    axes.autoscale_view()
    parts = [part for part in PART_COLOR if any(cell["part"] == part for body in bodies.values() for cell in body["cells"])]
    names = [name for name in EDGE_WORDS if any(edge["name"] == name for body in bodies.values() for edge in body["edges"])]
    key = [Patch(facecolor=PART_COLOR[part], edgecolor=GREY, lw=0.5, label=part) for part in parts]
    key += [Line2D([], [], color=EDGE_COLOR[name], lw=2.6, label=EDGE_WORDS[name]) for name in names]
    axes.legend(handles=key, loc="upper center", bbox_to_anchor=(0.5, -0.22), ncols=6, frameon=False, fontsize=7.5)
    slots = bodies.get("stator", {}).get("slots")
    if slots:
        axes.set_title(words_of_slots(slots), fontsize=8.5)
    return figure
