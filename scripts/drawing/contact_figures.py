# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures of the contact between teeth and rotor at an operating point: shapes, forces, friction."""
import numpy as np
from drawing.basics import BLUE, GREEN, GREY, METAL, MICRO, MILLI, ORANGE, nice_factor, plt, start_figure
from results.contact_case import NORMAL, OPEN, RADIAL, STICK, TANGENTIAL
from results.node_history import BRAKES, DRIVES, STICKS, covers_a_period, history_from_fields, history_from_table, phases_of

PALE_BLUE, PALE_ORANGE, PALE_GREY = "#CFE3F1", "#F8DCC6", "#E3E3E3"


# ------------------------------------------------------------------------------ parts of figures
class Snapshot:
    """The contact at the last moment of an operating point, on teeth that follow each other.

    numbers, angles   of the teeth, angles of their centres in degrees
    force, tooth, rotor, status   by tooth, contact point, component, as in contact.h5
    """

    def __init__(self, case, point, first, last):
        """Teeth from angle `first` to `last`, in degrees; 0 is a crest, None stands for the ring from -180."""
        fields = case.fields(point)
        self.case = case
        self.crest = np.degrees(case.angular_frequency * fields["time"][-1] / case.n_waves)
        pitch = 360 / case.n_teeth
        if first is None:
            self.numbers = np.arange(case.n_teeth) - (case.n_teeth - 1) // 2
        else:
            self.numbers = np.arange(np.ceil((self.crest + first) / pitch - 1e-9),
                                     np.floor((self.crest + last) / pitch + 1e-9) + 1).astype(int)
        self.angles = pitch * self.numbers
        self.limits = (self.angles[0] - pitch / 2, self.angles[-1] + pitch / 2)
        for name in ("force", "tooth", "rotor", "status"):
            setattr(self, name, fields[name][-1][self.numbers % case.n_teeth])

    def angles_on(self, nodes):
        """In degrees, by tooth and contact point."""
        return self.angles[:, None] + np.degrees(self.case.angle[nodes])


def wave_degrees(case):
    return 360 / case.n_waves


def torque_text(case, point):
    torque = case.curve[point]["torque_mNm"]
    return "no load" if abs(torque) < 5e-3 else f"{torque:.3g} mN m"


def lines_of_lip(case):
    """(letter and name, contact points) of the lip's inner and outer line."""
    return [(f"({letter}) {name} line of the lip, $r$ = {radius / MILLI:.4g} mm", case.line(radius))
            for letter, name, radius in (("a", "inner", case.radius.min()), ("b", "outer", case.radius.max()))]


def tidy(axes):
    axes.spines[["top", "right"]].set_visible(False)


def panels_and_key(figure, n_panels):
    """Panels above each other, and an empty one below them for the legend."""
    *panels, key = figure.subplots(nrows=n_panels + 1, height_ratios=[1] * n_panels + [0.1])
    key.set_axis_off()
    return panels, key


def share_angles(panels):
    """One axis of angles for all panels; before anything is drawn."""
    for axes in panels[:-1]:
        axes.sharex(panels[-1])
        axes.tick_params(labelbottom=False)
    panels[-1].set_xlabel(r"angle $\theta$ in degrees")


def draw_key(key, axes, n_columns=5):
    key.legend(*axes.get_legend_handles_labels(), loc="center left", ncol=n_columns, frameon=False, fontsize=8,
               borderaxespad=0, borderpad=0, handlelength=1.8, columnspacing=1.5)


def draw_directions(axes):
    """The way of the wave and that of the rotor, above the right end of the axes."""
    axes.annotate("wave →     ← rotor", (1, 1), (0, 3), xycoords="axes fraction", textcoords="offset points",
                  ha="right", va="bottom", fontsize=8, color=GREY)


# ------------------------------------------------------------------------------ shapes, Figs. 8, 9, 13
def draw_teeth_as_blocks(axes, snapshot, nodes, factor, bottom):
    """Tooth tops along a line, and what is below them; the metal leans with its top."""
    radius = snapshot.case.radius[nodes[0]] / MILLI
    for tooth, angles in enumerate(snapshot.angles_on(nodes)):
        motion = snapshot.tooth[tooth, nodes]
        rest = radius * np.radians(angles)
        along, up = rest - factor * motion[:, TANGENTIAL] / MILLI, motion[:, NORMAL] / MICRO
        axes.fill([along[0], *along, along[-1]], [bottom, *up, bottom], color=METAL, lw=0)
        axes.plot([along[0], *along, along[-1]], [bottom, *up, bottom], color=GREY, lw=0.8)
        touching = snapshot.status[tooth, nodes] != OPEN
        axes.plot(along[touching], up[touching], "o", color=ORANGE, ms=3, zorder=4)


def draw_lip(axes, snapshot, nodes, factor, top):
    radius = snapshot.case.radius[nodes[0]] / MILLI
    motion = snapshot.rotor[:, nodes].reshape(-1, 3)
    along = radius * np.radians(snapshot.angles_on(nodes).ravel()) - factor * motion[:, TANGENTIAL] / MILLI
    up = motion[:, NORMAL] / MICRO
    axes.fill_between(along, up, top, color=PALE_BLUE, lw=0)
    axes.plot(along, up, color=BLUE, lw=1.2)


def draw_contact_shape(case):
    """Fig. 8 of the paper: one and a half waves of teeth and lip."""
    point, wave = case.point_near(0), wave_degrees(case)
    snapshot = Snapshot(case, point, -0.75 * wave, 0.75 * wave)
    gap = (2 * np.pi / case.n_teeth - np.ptp(case.angle)) * case.radius.min()
    across = abs(np.diff(snapshot.tooth[..., TANGENTIAL].mean(axis=1))).max()
    factor = nice_factor(0.5 * gap / across)
    lowest, highest = (limit(snapshot.tooth[..., NORMAL]) / MICRO for limit in (np.min, np.max))
    height = highest - lowest
    bottom, top = lowest - 0.4 * height, highest + 0.4 * height
    title = f"deformed teeth and rotor over one and a half waves, {torque_text(case, point)}"
    figure = start_figure(case, title, (7.4, 4.6))
    panels, key = panels_and_key(figure, 2)
    for axes, (name, nodes) in zip(panels, lines_of_lip(case)):
        draw_lip(axes, snapshot, nodes, factor, top)
        draw_teeth_as_blocks(axes, snapshot, nodes, factor, bottom)
        axes.set(xlim=case.radius.max() / MILLI * np.radians(snapshot.limits), ylim=(bottom, top),
                 ylabel="height over tooth\ntops at rest in µm",
                 xlabel=r"along the ring, $r\theta$ in mm")
        axes.set_title(name, loc="left", fontsize=8.5)
        tidy(axes)
    draw_directions(panels[0])
    handles = [plt.Rectangle((0, 0), 1, 1, fc=PALE_BLUE, ec=BLUE, label="lip of the rotor"),
               plt.Rectangle((0, 0), 1, 1, fc=METAL, ec=GREY, label="teeth of the stator"),
               plt.Line2D([], [], color=ORANGE, marker="o", ms=3, ls="", label="points that touch")]
    figure.canvas.draw()  # lays the panels out
    scale = [axes.bbox.height / (MICRO / MILLI * (top - bottom)), axes.bbox.width / np.diff(axes.get_xlim())[0]]
    magnified = float(f"{scale[0] / scale[1]:.2g}")
    key.legend(handles=handles, loc="center left", ncol=3, frameon=False, fontsize=8, title_fontsize=8,
               alignment="left", borderaxespad=0,
               title=f"Heights are drawn {magnified:g} times larger than lengths, "
                     f"motion along the ring {factor:g} times larger.")
    return figure


def draw_displacements(case, title, snapshot, marker_size):
    figure = start_figure(case, title, (7.4, 4.6))
    panels, key = panels_and_key(figure, 2)
    panels[0].sharey(panels[1])
    share_angles(panels)
    for axes, (name, nodes) in zip(panels, lines_of_lip(case)):
        angles = snapshot.angles_on(nodes)
        for tooth, over in enumerate(angles):
            axes.fill_between(over, 0, snapshot.tooth[tooth, nodes, NORMAL] / MICRO, color="#BDBDBD", lw=0,
                              label="teeth" if tooth == 0 else None)
        axes.axhline(0, color=GREY, lw=0.8)
        axes.plot(angles.ravel(), snapshot.rotor[:, nodes, NORMAL].ravel() / MICRO, color=BLUE, lw=1.4, label="rotor")
        touching = (snapshot.status[:, nodes] != OPEN).any(axis=1)
        axes.plot(snapshot.angles[touching], snapshot.rotor[touching][:, nodes, NORMAL].mean(axis=1) / MICRO, "o",
                  color=ORANGE, ms=marker_size, label="teeth that touch here")
        axes.set_title(name, loc="left", fontsize=8.5)
        axes.set(ylabel="displacement\nupwards in µm", xlim=snapshot.limits)
        tidy(axes)
    draw_directions(panels[0])
    return figure, panels, key


def draw_normal_displacement(case):
    """Fig. 9: two waves of normal displacement."""
    point, wave = case.point_near(0), wave_degrees(case)
    snapshot = Snapshot(case, point, -0.5 * wave, 1.5 * wave)
    title = f"normal displacement over two waves, {torque_text(case, point)}"
    figure, panels, key = draw_displacements(case, title, snapshot, 3.5)
    draw_key(key, panels[1])
    return figure


def draw_warped_displacement(case):
    """Fig. 13: the same on the whole ring, which is warped at rest."""
    point = case.point_near(0)
    snapshot = Snapshot(case, point, None, None)
    title = f"normal displacement on the whole ring, {torque_text(case, point)}"
    figure, panels, key = draw_displacements(case, title, snapshot, 2.5)
    angle = np.linspace(*snapshot.limits, 361)
    warp = case.warp / MICRO
    for axes in panels:
        axes.plot(angle, warp * np.cos(case.warp_waves * np.radians(angle)), color="black", lw=1, ls="--",
                  label=f"teeth at rest, {warp:g} µm · cos {case.warp_waves}θ")
        axes.set_xticks(range(-180, 181, 45))
    draw_key(key, panels[1])
    return figure


# ------------------------------------------------------------------------------------ forces, Fig. 10
def view_of_forces(case, point):
    """Two waves tell of a uniform ring, a warped one is shown whole."""
    wave = wave_degrees(case)
    return Snapshot(case, point, None, None) if case.warp > 0 else Snapshot(case, point, -0.5 * wave, 1.5 * wave)


def draw_tangential_forces(axes, snapshot, point, letter):
    case = snapshot.case
    width = 250 / case.n_teeth  # degrees, seven tenths of a pitch
    force = snapshot.force[..., TANGENTIAL].sum(axis=1)
    for sign, color, name in ((1, BLUE, "drives the rotor"), (-1, ORANGE, "brakes it")):
        part = np.where(sign * force > 0, force, 0)
        axes.bar(snapshot.angles, part, width, color=color, lw=0, label=name)
    axes.axhline(0, color=GREY, lw=0.8)
    whole = case.fields(point)["force"][-1][..., TANGENTIAL].sum(axis=1)
    driving, braking = whole[whole > 0].sum(), whole[whole < 0].sum()
    sums = f"{driving:.2f} N − {-braking:.2f} N = {round(driving + braking, 2) + 0.0:.2f} N"  # + 0.0 makes 0 of -0
    axes.set_title(f"({letter}) tangential, {torque_text(case, point)}; whole ring: {sums}".replace("-", "−"),
                   loc="left", fontsize=8.5)
    axes.set_ylabel("force of a tooth\non the rotor in N")


def draw_contact_forces(case):
    """Fig. 10: forces of the teeth on the rotor without and with load."""
    free, loaded = case.point_near(0), case.point_near(50)
    snapshots = [view_of_forces(case, point) for point in (free, loaded)]
    is_loaded = loaded != free
    figure = start_figure(case, "forces of the teeth on the rotor", (7.4, 5.8 if is_loaded else 4.2))
    panels, key = panels_and_key(figure, 3 if is_loaded else 2)
    share_angles(panels)
    if is_loaded:
        panels[1].sharey(panels[2])
    normal = snapshots[0].force[..., NORMAL].sum(axis=1)
    panels[0].bar(snapshots[0].angles, normal, 250 / case.n_teeth, color=GREY, lw=0)
    total = case.fields(free)["force"][-1][..., NORMAL].sum()
    panels[0].set_title(f"(a) normal, {torque_text(case, free)}; whole ring: {total:.2f} N", loc="left", fontsize=8.5)
    panels[0].set_ylabel("force of a tooth\non the rotor in N")
    for axes, snapshot, point, letter in zip(panels[1:], snapshots, (free, loaded), "bc"):
        draw_tangential_forces(axes, snapshot, point, letter)
    panels[-1].set_xlim(snapshots[0].limits)
    if case.warp > 0:
        panels[-1].set_xticks(range(-180, 181, 45))
    for axes in panels:
        tidy(axes)
    draw_directions(panels[0])
    draw_key(key, panels[1])
    return figure


# ----------------------------------------------------------------------------------- friction, Fig. 11
def history_touches(case):
    """Whether one of the chosen points is pressed without load; of a marched motor others are drawn."""
    rows = case.history(case.point_near(0))
    return not covers_a_period(case, rows) or any(row["force_n_N"] > 0 for row in rows)


def draw_bands(axes, time, slip, status):
    """What the point did in the step that ends at each time."""
    step = np.min(np.diff(time))
    bands = {BRAKES: ("slips, friction brakes the rotor", PALE_ORANGE), STICKS: ("sticks to the tooth", PALE_GREY),
             DRIVES: ("slips, friction drives it", PALE_BLUE)}
    for end, doing in zip(time, phases_of(slip, status)):
        if doing in bands:
            axes.axvspan(end - step, end, color=bands[doing][1], lw=0)
    for said, color in bands.values():
        axes.fill_between([], [], color=color, lw=0, label=said)


def draw_friction_history(case):
    """Fig. 11: one point of the lip's outer line while a crest passes."""
    point = case.point_near(0)
    rows = case.history(point)
    is_steady = covers_a_period(case, rows)
    time, force, slip, status = (history_from_table if is_steady else history_from_fields)(case, point)
    touching = np.flatnonzero(status != OPEN)
    shown = slice(max(0, touching[0] - 2), touching[-1] + 3)
    time, force, slip, status = (values[shown] for values in (time, force, slip, status))
    figure = start_figure(case, f"friction at a point while a crest passes, {torque_text(case, point)}", (6.8, 4.0))
    (axes,), key = panels_and_key(figure, 1)
    draw_bands(axes, time, slip, status)
    limit = case.friction_coefficient * force[:, NORMAL]
    axes.axhline(0, color=GREY, lw=0.6)
    axes.plot(time, force[:, TANGENTIAL], color=BLUE, lw=1.6, marker="o", ms=3, label="along the ring, driving")
    axes.plot(time, force[:, RADIAL], color=GREEN, lw=1, ls="-.", label="radial, outwards")
    axes.plot(time, limit, color="black", lw=1, ls="--", label=f"limits ± µp, µ = {case.friction_coefficient:g}")
    axes.plot(time, -limit, color="black", lw=1, ls="--")
    axes.set(xlabel="time from the passing of the crest in µs", ylabel="force on the rotor in N",
             xlim=(time[0] - 0.5 * (time[1] - time[0]), time[-1]))
    tidy(axes)
    draw_key(key, axes, 2)
    return figure
