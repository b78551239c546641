# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures of the stator: elliptic paths, motion of the tooth's edge, natural frequencies."""
import numpy as np
from drawing.basics import BLUE, GREEN, GREY, KILO, METAL, MICRO, ORANGE, PURPLE, nice_factor, plt, start_figure
from drawing.curve_figures import CASE_STYLE
from drawing.response_figure import responses_of
from matplotlib.ticker import MaxNLocator
from results.case import with_error

FAMILY_STYLE = {
    "out-of-plane": (BLUE, "o", "-"),
    "in-plane": (ORANGE, "s", "--"),
    "torsion": (GREEN, "^", "-."),
    "cross-section": (PURPLE, "D", ":"),
}
RADIUS_NAME = {"inner": "inner edge", "mid": "middle", "outer": "outer edge"}


# ------------------------------------------------------------------------------ parts of figures
def wave_text(case):
    value, error = case.wave["natural_frequency_Hz"] / KILO, case.wave["natural_frequency_error_Hz"] / KILO
    return f"$n$ = {case.n_waves}, $f$ = {with_error(value, error)} kHz"


def motion_of(point, n_waves, time_angle):
    """Displacement in um towards r, theta, z at omega t, by the formulas of doc/files.md."""
    position, degree = n_waves * np.radians(point["theta_deg"]), np.pi / 180
    normal_angle = time_angle - position - point["phase_n_deg"] * degree
    return (point["A_r_um"] * np.cos(time_angle - position - point["phase_r_deg"] * degree),
            -point["A_t_um"] * np.sin(normal_angle - point["phi_deg"] * degree),  # drives along -theta
            point["A_n_um"] * np.cos(normal_angle))


def draw_path(axes, place, point, case, component, factor, color):
    """The path around a place in mm; `component` 0 shows r to the right, 1 theta; z is up."""
    def at(angle):
        motion = motion_of(point, case.n_waves, angle)
        return (place[0] + factor * motion[component] * 1e-3, place[1] + factor * motion[2] * 1e-3)

    axes.plot(*at(np.linspace(0, 2 * np.pi, 181)), color=color, lw=1.2)
    axes.plot(*place, "+", color=GREY, ms=4, mew=0.7)
    axes.plot(*at(0.0), "o", color=color, ms=3.5)
    if component == 1:  # paths in the radial section are too thin for arrows
        for angle in (0.45 * np.pi, 1.45 * np.pi):
            axes.annotate("", at(angle + 0.05), at(angle - 0.05),
                          arrowprops={"arrowstyle": "-|>", "color": color, "lw": 0.5, "mutation_scale": 9,
                                      "shrinkA": 0, "shrinkB": 0})


def draw_metal(axes, outline):
    """A section that goes on below its first and last corner."""
    horizontal, vertical = zip(*outline)
    axes.fill(horizontal, vertical, color=METAL, lw=0)
    axes.plot(horizontal, vertical, color=GREY, lw=0.8)


# ------------------------------------------------------------------------------------ the figures
def along_theta(point):
    return point["r_mm"] * np.radians(point["theta_deg"])


def half_pitch_at(case, radius):
    return np.pi / case.n_teeth * case.points[f"foot_{radius}_C"]["r_mm"]


def draw_tooth_from_outside(axes, case, radius, factor, bottom, reach):
    """The section at constant radius: the paths as the paper's Fig. 4 shows them."""
    points = {f"{level}_{side}": case.points[f"{level}_{radius}_{side}"]
              for level in ("top", "foot") for side in "LCR"}
    foot, half_pitch = points["foot_C"]["z_mm"], half_pitch_at(case, radius)
    corners = [(along_theta(points[name]), points[name]["z_mm"]) for name in ("foot_L", "top_L", "top_R", "foot_R")]
    draw_metal(axes, [(-half_pitch, bottom), (-half_pitch, foot), *corners, (half_pitch, foot), (half_pitch, bottom)])
    for name, point in points.items():
        draw_path(axes, (along_theta(point), point["z_mm"]), point, case, 1, factor,
                  BLUE if name.startswith("top") else ORANGE)
    top = points["top_C"]
    axes.set_title(f"{RADIUS_NAME[radius]}, $r$ = {top['r_mm']:.1f} mm\n"
                   f"centre of the top: $A_t/A_n$ = {top['A_t_um'] / top['A_n_um']:.3f}", fontsize=8)
    for side in "LCR":
        point = points[f"top_{side}"]
        phi = f"{round(point['phi_deg'], 1) + 0.0:.1f}°".replace("-", "−")  # + 0.0 makes 0 of -0
        axes.annotate(f"$\\phi$ = {phi}" if side == "L" else phi, (along_theta(point), point["z_mm"] + reach), (0, 5),
                      textcoords="offset points", ha="center", va="bottom", fontsize=7.5, color=BLUE)
    axes.set_xlabel(r"along the ring, $r\theta$ in mm")


def draw_tooth_from_the_side(axes, case, factor, bottom):
    """The radial section through the tooth's centre."""
    points = {(level, radius): case.points[f"{level}_{radius}_C"]
              for level in ("top", "foot") for radius in RADIUS_NAME}

    def side(radius, height):  # the sides are straight
        top, foot = points["top", radius], points["foot", radius]
        slope = (foot["r_mm"] - top["r_mm"]) / (foot["z_mm"] - top["z_mm"])
        return (top["r_mm"] + slope * (height - top["z_mm"]), height)

    top = points["top", "inner"]["z_mm"]
    draw_metal(axes, [side("inner", bottom), side("inner", top), side("outer", top), side("outer", bottom)])
    for (level, _), point in points.items():
        draw_path(axes, (point["r_mm"], point["z_mm"]), point, case, 0, factor, BLUE if level == "top" else ORANGE)
    outer = points["top", "outer"]
    axes.set_title("radial section, $\\theta$ = 0\n"
                   f"outer edge of the top: $A_r/A_n$ = {outer['A_r_um'] / outer['A_n_um']:.3f}", fontsize=8)
    axes.set_xlabel("radius $r$ in mm")


def draw_key(axes, amplitude, factor):
    axes.set_axis_off()
    handles = [plt.Line2D([], [], color=BLUE, label="points of the tooth's top"),
               plt.Line2D([], [], color=ORANGE, label="points of the tooth's foot"),
               plt.Line2D([], [], color=GREY, marker="o", ms=3.5, ls="", label="at t = 0"),
               plt.Line2D([], [], color=GREY, marker="+", ms=5, ls="", label="at rest")]
    axes.legend(handles=handles, loc="upper left", fontsize=8, title_fontsize=8, frameon=False, alignment="left",
                title=f"motion drawn {factor:g} times larger:\n"
                      f"{amplitude * factor * 1e-3:g} mm stand for {amplitude:g} µm")


def draw_elliptic_paths(case):
    points = case.points
    largest = {key: max(point[key] for point in points.values()) for key in ("A_t_um", "A_n_um")}
    spacing = along_theta(points["top_inner_R"])  # mm, between neighbouring paths
    tooth_height = points["top_inner_C"]["z_mm"] - points["foot_inner_C"]["z_mm"]
    factor = nice_factor(1e3 * min(0.55 * spacing / largest["A_t_um"], 0.45 * tooth_height / largest["A_n_um"]))
    reach = factor * largest["A_n_um"] * 1e-3
    bottom, top = points["foot_inner_C"]["z_mm"] - 1.5 * reach, points["top_inner_C"]["z_mm"]

    # All sections have one scale: the sizes of the panels follow from what they show, in mm.
    half_widths = [max(half_pitch_at(case, radius),
                       along_theta(points[f"top_{radius}_R"]) + factor * largest["A_t_um"] * 1e-3) + 0.1
                   for radius in RADIUS_NAME]
    radii = (points["foot_inner_C"]["r_mm"] - 0.4, points["foot_outer_C"]["r_mm"] + 0.4)
    width = max(2 * sum(half_widths), 1.4 * (radii[1] - radii[0]))
    inch_per_mm = 6.5 / width
    heights = (top + reach + 0.7 / inch_per_mm - bottom, top + 1.2 * reach - bottom)

    figure = start_figure(case, f"paths of points on a tooth, {wave_text(case)}",
                          (7.4, inch_per_mm * sum(heights) + 2.2))
    rows = figure.add_gridspec(2, 1, height_ratios=heights, hspace=0.06)
    upper = rows[0].subgridspec(1, 3, width_ratios=half_widths)
    lower = rows[1].subgridspec(1, 2, width_ratios=(radii[1] - radii[0], width - (radii[1] - radii[0])))
    panels = [figure.add_subplot(place) for place in (*upper, *lower)]
    for axes, radius, half_width in zip(panels, RADIUS_NAME, half_widths):
        draw_tooth_from_outside(axes, case, radius, factor, bottom, reach)
        axes.set(xlim=(-half_width, half_width), ylim=(bottom, bottom + heights[0]))
    draw_tooth_from_the_side(panels[3], case, factor, bottom)
    panels[3].set(xlim=radii, ylim=(bottom, bottom + heights[1]))
    draw_key(panels[4], nice_factor(largest["A_n_um"]), factor)

    arrow = {"arrowstyle": "-|>", "color": "black", "lw": 1, "shrinkA": 0, "shrinkB": 0}
    for axes, direction, text in ((panels[0], 1, "the wave travels"), (panels[2], -1, "the rotor is driven")):
        height, length = top + reach + 0.42 / inch_per_mm, 0.7 * half_widths[0]
        axes.annotate("", (direction * length, height), (-direction * length, height), arrowprops=arrow)
        axes.text(0, height + 0.04 / inch_per_mm, text, ha="center", va="bottom", fontsize=8)
    for axes in panels[:4]:
        axes.set_aspect("equal")
        axes.set_ylabel("height $z$ in mm")
        axes.label_outer()
        axes.spines[["top", "right"]].set_visible(False)
    for axes in panels[:3]:  # label_outer() takes the lowest row only for the outer one
        axes.xaxis.set_tick_params(labelbottom=True)
        axes.set_xlabel(r"along the ring, $r\theta$ in mm")
    return figure


def outer_edge(trace):
    """Angles in rad and u_r, u_theta, u_z in m along the outer edge of a surface, finely sampled.

    The lattice of a face determines the finite-element function on it, so its edges are read with
    the Lagrange polynomials of their points. An edge is the outer one if all of it lies there.
    """
    n_nodes = trace["order"] + 1
    nodes, fine = np.linspace(0, 1, n_nodes), np.linspace(0, 1, 4 * n_nodes)
    basis = np.array([np.prod([(fine - other) / (node - other) for other in nodes if other != node], axis=0)
                      for node in nodes]).T
    radius = np.hypot(trace["points"][..., 0], trace["points"][..., 1])
    outermost = radius.max() - 0.01 * (radius.max() - radius.min())
    lattice = np.arange(n_nodes**2).reshape(n_nodes, n_nodes)
    angles, motions = [], []
    for face in range(len(radius)):
        for edge in (lattice[0], lattice[-1], lattice[:, 0], lattice[:, -1]):
            if np.all(radius[face, edge] > outermost):
                angle = basis @ np.arctan2(trace["points"][face, edge, 1], trace["points"][face, edge, 0])
                rising = np.argsort(angle)
                angles.append(angle[rising])
                motions.append((basis @ trace["u"][face, edge])[rising])
    order = np.argsort([angle[0] for angle in angles])
    return np.concatenate([angles[i] for i in order]), np.concatenate([motions[i] for i in order])


def draw_edge_amplitudes(axes, case, top, foot):
    """Over three teeth; the amplitudes of a travelling wave are the same on each of them."""
    center, amplitude = case.points["top_outer_C"], case.wave["amplitude_m"] / MICRO
    pitch = 360 / case.n_teeth

    def draw(trace, component, label, **style):
        angle, motion = trace
        for tooth in (-1, 0, 1):
            axes.plot(np.degrees(angle) + tooth * pitch, abs(motion[:, component]) / MICRO, **style,
                      label=label if tooth == 0 else None)

    draw(top, 2, "normal $A_n$", color=BLUE, ls="-", lw=1.6)
    ratios = []
    for component, key, name, color, style in ((1, "t", "tangential", ORANGE, "--"), (0, "r", "radial", GREEN, "-.")):
        value, error = center[f"A_{key}_um"], case.errors[f"A_{key}/A_n"]
        draw(top, component, f"{name} $A_{key}$", color=color, ls=style, lw=1.6)
        axes.errorbar(0, value, error * amplitude, color=color, fmt="o", ms=3, capsize=3)
        ratios.append(f"$A_{key}/A_n$ = {with_error(value / center['A_n_um'], error)}")
    draw(foot, 1, "tangential at the foot", color=ORANGE, ls=":", lw=1.4)
    axes.set_title(f"centre of the tooth: {', '.join(ratios)}", fontsize=7.5)
    edges = np.degrees(top[0][[0, -1]])
    for tooth in (-1, 0, 1):
        axes.axvspan(*(edges + tooth * pitch), color=METAL, lw=0)
    axes.set(xlabel=r"angle $\theta$ in degrees (three teeth, grey)", ylabel="amplitude, zero to peak, in µm",
             xlim=(-1.5 * pitch, 1.5 * pitch), ylim=(0, 1.3 * axes.dataLim.ymax))
    axes.legend(fontsize=7.5, ncol=2, frameon=False, loc="upper center")


def draw_edge_phase(axes, case, top):
    angle, motion = top
    # w_t = -u_theta = A_t sin(omega t - n theta - phase_n - phi), a cosine that lags by a quarter
    phi = np.angle(motion[:, 2] / -motion[:, 1] / 1j, deg=True)
    axes.axvspan(np.degrees(angle[0]), np.degrees(angle[-1]), color=METAL, lw=0)
    axes.axhline(0, color=GREY, lw=0.6)
    axes.plot(np.degrees(angle), phi, color=BLUE, lw=1.6)
    edge, error = case.points["top_outer_R"], case.errors["phi_edge"]
    axes.errorbar(edge["theta_deg"], edge["phi_deg"], error, color=BLUE, fmt="o", ms=3, capsize=3)
    text = with_error(edge["phi_deg"], error).replace("-", "−")
    axes.set_title(f"+$\\theta$ edge: $\\phi$ = ({text})°", fontsize=7.5)
    half_pitch = 180 / case.n_teeth
    axes.set(xlabel=r"angle $\theta$ in degrees (one tooth)", ylabel=r"phase $\phi$ in degrees",
             xlim=(-half_pitch, half_pitch))


def draw_tooth_edge(case):
    figure = start_figure(case, f"motion of the outer edge of the tooth tops, {wave_text(case)}", (7.4, 3.5))
    left, right = figure.subplots(ncols=2, width_ratios=(1.7, 1))
    top, foot = outer_edge(case.wave["tooth_top"]), outer_edge(case.wave["tooth_foot"])
    draw_edge_amplitudes(left, case, top, foot)
    draw_edge_phase(right, case, top)
    for axes in (left, right):
        axes.spines[["top", "right"]].set_visible(False)
    return figure


def branches(case):
    """(family, rows of n, f, error in Hz) that a line may connect: k-th modes of a family at consecutive n."""
    # Rigid motions of the ring (n = 0 and 1) are no modes but do begin these branches.
    rank = {(n, family): 1 for n in (0, 1) for family in ("out-of-plane", "in-plane")}
    found = {}
    for mode in case.modes:
        n, family = mode["n"], mode["family"]
        rank[n, family] = rank.get((n, family), 0) + 1
        lines = found.setdefault((family, rank[n, family]), [[]])
        if lines[-1] and (n > lines[-1][-1][0] + 1 or not case.has_lowest_modes):
            lines.append([])
        lines[-1].append((n, mode["frequency_Hz"], mode["error_Hz"]))
    return [(family, np.array(line)) for (family, _), lines in sorted(found.items()) for line in lines]


def mark_wave(axes, case):
    frequency, error = case.wave["natural_frequency_Hz"] / KILO, case.wave["natural_frequency_error_Hz"] / KILO
    axes.plot(case.n_waves, frequency, "o", ms=11, mfc="none", mec="black", mew=1,
              label=f"the motor's wave, {with_error(frequency, error)} kHz")


def label_modes(axes, modes):
    for mode in modes:
        text = with_error(mode["frequency_Hz"] / KILO, mode["error_Hz"] / KILO)
        axes.annotate(f"{text} kHz", (mode["n"], mode["frequency_Hz"] / KILO), (12, 0), textcoords="offset points",
                      fontsize=8, va="center", bbox={"facecolor": "white", "lw": 0, "pad": 1})


def draw_dispersion(case):
    figure = start_figure(case, "natural frequencies of the stator", (6.2, 5.2))
    upper, lower = figure.subplots(nrows=2, sharex=True, height_ratios=(2.2, 1))
    named = set()
    for family, line in branches(case):
        color, marker, style = FAMILY_STYLE[family]
        n, frequency, error = line.T
        upper.errorbar(n, frequency / KILO, error / KILO, color=color, marker=marker, ls=style, lw=1.2, ms=4.5,
                       capsize=3, label=None if family in named else family)
        lower.plot(n, 100 * error / frequency, color=color, marker=marker, ls=style, lw=1.2, ms=4.5)
        named.add(family)
    if case.wave:
        mark_wave(upper, case)
    if case.target is not None:
        lower.axhline(100 * case.target, color=GREY, lw=0.8, ls="--")
        lower.annotate("Accuracy/Target", (1, 100 * case.target), (-2, 2), xycoords=("axes fraction", "data"),
                       textcoords="offset points", ha="right", va="bottom", fontsize=7, color=GREY)
    every_n = [mode["n"] for mode in case.modes]
    lower.set(xlabel="number of waves around the ring, $n$", ylabel="error bar in % of $f$", yscale="log",
              xlim=(min(every_n) - 0.7, max(every_n) + 0.7))
    smallest, largest = lower.dataLim.intervaly
    lower.set_ylim(10 ** np.floor(np.log10(0.8 * smallest)), 2.5 * largest)
    lower.xaxis.set_major_locator(MaxNLocator(integer=True, min_n_ticks=1))
    lower.yaxis.set_major_formatter("{x:g}")
    lower.yaxis.set_minor_formatter("")
    upper.set_ylabel("frequency $f$ in kHz")
    if min(every_n) < max(every_n):
        upper.set_ylim(0, 1.05 * upper.dataLim.ymax)
    else:
        label_modes(upper, case.modes)
        upper.margins(y=0.3)
    upper.legend(fontsize=7.5, frameon=False, loc="lower left", bbox_to_anchor=(0, 1), ncol=3, borderpad=0.1)
    for axes in (upper, lower):
        axes.spines[["top", "right"]].set_visible(False)
        axes.grid(color="#DDDDDD", lw=0.5)
        axes.set_axisbelow(True)
    return figure


def draw_electrodes(case):
    """The arcs as one sees them from below the ceramic, where theta runs clockwise."""
    figure = start_figure(case, "electrode arcs under the ceramic, seen from below", (5.6, 5.6))
    axes = figure.subplots(subplot_kw={"projection": "polar"})
    axes.set_theta_direction(-1)
    inner, outer = (1e3 * float(case.parameters[f"Stator/Base {side} radius"]) for side in ("inner", "outer"))
    for arc in case.electrodes:
        begin, end = np.radians([arc["begin_deg"], arc["end_deg"]])
        color = BLUE if arc["phase"] == "A" else ORANGE
        axes.bar(begin, outer - inner, width=end - begin, bottom=inner, align="edge", color=color,
                 alpha=0.75 if arc["poling"] == "up" else 0.4, lw=0.8, edgecolor=GREY)
        axes.text(0.5 * (begin + end), 0.5 * (inner + outer), "+" if arc["poling"] == "up" else "−", ha="center",
                  va="center", fontsize=9)
    axes.set(ylim=(0, outer), yticks=[])
    axes.tick_params(axis="x", labelsize=8)
    axes.grid(False)
    axes.spines["polar"].set_visible(False)
    handles = [plt.Rectangle((0, 0), 1, 1, color=BLUE, alpha=0.75, label="phase A"),
               plt.Rectangle((0, 0), 1, 1, color=ORANGE, alpha=0.75, label="phase B")]
    axes.legend(handles=handles, loc="center", fontsize=8, frameon=False,
                title="+ poled up, − poled down", title_fontsize=8)
    return figure


def draw_with_rotor(magnitude, angle, case, contact):
    """The stable states of a driven motor with its rotor: that of the motion, and that of C0 in parallel."""
    for number, (torque, columns) in enumerate(responses_of(contact)):
        color, marker = CASE_STYLE[(number + 2) % len(CASE_STYLE)]
        parallel = 2e-9 * np.pi * columns["frequency_Hz"] * case.circuits["A"]["C0_nF"]
        admittance = columns["motional_conductance_S"] + 1j * (columns["motional_susceptance_S"] + parallel)
        error = np.hypot(columns["motional_conductance_error_S"], columns["motional_susceptance_error_S"])
        stable = np.flatnonzero(columns["state"] == "stable")
        label = f"with rotor, at {torque:.4g} mN m and {float(contact.parameters['Wave/Voltage']):g} V"
        for run in np.split(stable, np.flatnonzero(np.diff(stable) > 1) + 1):
            frequency = columns["frequency_kHz"][run]
            magnitude.errorbar(frequency, 1e3 * abs(admittance[run]), 1e3 * error[run], color=color, marker=marker, ms=3,
                               lw=1, elinewidth=0.8, label=label)
            angle.plot(frequency, np.angle(admittance[run], deg=True), color=color, marker=marker, ms=3, lw=1)
            label = None


def draw_admittance(case, contact=None):
    """Magnitude and phase for each electrical phase around the resonance, of the stator alone and, if its response is
    known, with the rotor."""
    with_rotor = contact is not None and contact.response
    figure = start_figure(case, f"admittance {'with and ' if with_rotor else ''}without rotor, {wave_text(case)}",
                          (6.4, 5.4 if with_rotor else 4.8))
    upper, lower = figure.subplots(nrows=2, sharex=True, height_ratios=(2, 1))
    frequency = np.array(case.admittance["frequency_Hz"]) / KILO
    for phase, color, style in (("A", BLUE, "-"), ("B", ORANGE, "--")):
        admittance = (np.array(case.admittance[f"conductance_{phase}_S"]) +
                      1j * np.array(case.admittance[f"susceptance_{phase}_S"]))
        circuit = case.circuits[phase]
        upper.semilogy(frequency, 1e3 * abs(admittance), color=color, ls=style, lw=1.6,
                       label=f"phase {phase}: $k_\\mathrm{{eff}}^2$ = {circuit['k_eff^2']:.5f}, "
                             f"$C_0$ = {circuit['C0_nF']:.3g} nF, $L_m$ = {circuit['Lm_H']:.3g} H, "
                             f"$C_m$ = {circuit['Cm_pF']:.3g} pF, $R_m$ = {circuit['Rm_ohm']:.3g} Ω")
        lower.plot(frequency, np.angle(admittance, deg=True), color=color, ls=style, lw=1.6)
    if with_rotor:
        draw_with_rotor(upper, lower, case, contact)
    for axes in (upper, lower):
        for name, side in (("short", "right"), ("open", "left")):
            place = case.circuits["A"][f"{name}_circuit_frequency_Hz"] / KILO
            axes.axvline(place, color=GREY, lw=0.8, ls=":")
            if axes is lower:
                axes.annotate(f"{name} circuit", (place, -88), (3 if side == "left" else -3, 0), ha=side, va="bottom",
                              textcoords="offset points", fontsize=7, color=GREY, rotation=90)
        axes.spines[["top", "right"]].set_visible(False)
        axes.grid(color="#DDDDDD", lw=0.5)
        axes.set_axisbelow(True)
    upper.set_ylabel("admittance of one phase,\nthe other grounded, in mS")
    upper.legend(fontsize=7, frameon=False, loc="lower left", bbox_to_anchor=(0, 1), borderpad=0.1)
    lower.set(xlabel="frequency in kHz", ylabel="phase in degrees", ylim=(-95, 95), yticks=(-90, -45, 0, 45, 90),
              xlim=frequency[[0, -1]])
    return figure
