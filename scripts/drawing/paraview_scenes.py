# SPDX-License-Identifier: LGPL-2.1-or-later
"""The views that scripts/paraview_view.py opens; ParaView runs this file.

All that depends on the motor's size (scale factors, what is zoomed at, units) comes from its data.
"""
import json
import math
import os
import sys
import xml.etree.ElementTree

import numpy as np
from paraview import servermanager
from paraview.simple import *  # noqa: F403: as ParaView's own scripts do
from vtkmodules.util.numpy_support import vtk_to_numpy

SIZE = (1000, 560)  # of a picture, in pixels
VIEW_ANGLE = 18.0  # of the camera, in degrees, from top to bottom
METAL, STATOR = (0.86, 0.86, 0.86), (0.66, 0.71, 0.78)
BLUE, ORANGE, GREY = (0.0, 0.447, 0.698), (0.835, 0.369, 0.0), (0.62, 0.62, 0.62)
HEAT = [METAL, (0.99, 0.80, 0.35), (0.96, 0.49, 0.20), (0.74, 0.15, 0.22), (0.31, 0.03, 0.25)]
WAVE = [(0.23, 0.30, 0.75), (0.55, 0.69, 1.0), (0.87, 0.87, 0.87), (0.96, 0.60, 0.48), (0.71, 0.02, 0.15)]
STATUS = {0: ("open", GREY), 1: ("stick", BLUE), 2: ("slip", ORANGE)}


class SceneError(Exception):
    """A view that cannot be drawn; the text is one line for the user."""


def read(path, program, *fields):
    """ParaView's reader of a file that has these point fields."""
    try:
        reader = OpenDataFile(path, registrationName=os.path.basename(path))
    except RuntimeError:
        raise SceneError(f"{path} cannot be read; run the program {program} again") from None
    reader.UpdatePipeline()
    for field in fields:
        if field not in reader.PointData.keys():
            raise SceneError(f"{path} has no field {field}; run the program {program} again")
    return reader


def points_and(source, *fields):
    """Coordinates and point fields of all that a source puts out, as arrays."""
    data = servermanager.Fetch(source)
    return [vtk_to_numpy(data.GetPoints().GetData()),
            *(vtk_to_numpy(data.GetPointData().GetArray(field)) for field in fields)]


def ring_size(points):
    """Outer radius and the heights of bottom and top."""
    return np.hypot(points[:, 0], points[:, 1]).max(), points[:, 2].min(), points[:, 2].max()


def read_counts(folder):
    """Numbers of waves and of teeth around the ring."""
    path = os.path.join(folder, "summary.json")
    try:
        with open(path, encoding="utf-8") as file:
            entries = json.load(file)["entries"]
        return [int(entries[f"Motor/Number of {name}"]) for name in ("waves", "teeth")]
    except (OSError, LookupError, TypeError, ValueError):
        raise SceneError(f"{path} does not tell Motor/Number of waves and of teeth; run the program "
                         f"{os.path.basename(folder)} again") from None


def rounded(value):
    """To one digit, so that a factor is told in full."""
    return float(f"{value:.0e}")


def wave_scale(displacement, waves, radius):
    """Factor that makes a wave well seen: neither steep nor, of long waves, high."""
    largest = np.linalg.norm(displacement, axis=-1).max()
    return rounded(min(2 * math.pi / waves / 16, 1 / 18) * radius / largest) if largest > 0 else 1.0


def with_prefix(largest, unit):
    """Factor and unit in which a number has one to three digits before the point."""
    prefixes = {-9: "n", -6: "\u00b5", -3: "m", 0: "", 3: "k", 6: "M", 9: "G"}
    power = 3 * math.floor(math.log10(largest) / 3) if largest > 0 else 0
    power = min(max(power, min(prefixes)), max(prefixes))
    return 10.0 ** -power, prefixes[power] + unit


def upwards(value):
    """To two digits, not below the value."""
    step = 10.0 ** (math.floor(math.log10(value)) - 1) if value > 0 else 1.0
    return math.ceil(value / step - 1e-6) * step


def part_of_ring(source, outwards, reach):
    """Cells up to an angle away from a direction, as they are: cutting them would smooth jumps between materials."""
    cosine = f"({outwards[0]}*coordsX+{outwards[1]}*coordsY)/sqrt(coordsX^2+coordsY^2)"
    turned = Calculator(Input=source, AttributeType="Point Data", ResultArrayName="cosine", Function=cosine)
    return Threshold(Input=turned, Scalars=("POINTS", "cosine"), LowerThreshold=math.cos(min(1.001 * reach, math.pi)),
                     UpperThreshold=2)


def new_view(title):
    view = CreateView("RenderView")
    view.ViewSize = SIZE
    view.UseColorPaletteForBackground = 0
    view.Background = (1, 1, 1)
    view.OrientationAxesVisibility = 0
    view.CameraViewAngle = VIEW_ANGLE
    shown = Show(Text(Text=title), view)
    shown.WindowLocation = "Upper Left Corner"
    shown.Color, shown.FontSize = (0.1, 0.1, 0.1), 14
    shown.Justification = "Left"
    return view


def look(view, focus, direction, width):
    """Sees a width across the focus; what the focus is at appears left of the middle, beside the colour bar."""
    focus, direction = np.asarray(focus, float), np.asarray(direction, float) / np.linalg.norm(direction)
    right = np.cross((0, 0, 1), direction)
    focus = focus + 0.07 * width * right / np.linalg.norm(right)
    distance = width * SIZE[1] / SIZE[0] / (2 * math.tan(math.radians(VIEW_ANGLE / 2)))
    view.CameraFocalPoint, view.CameraPosition, view.CameraViewUp = focus, focus + distance * direction, (0, 0, 1)
    view.CenterOfRotation = focus


def bar_style(view, colors, title):
    bar = GetScalarBar(colors, view)
    bar.Title, bar.ComponentTitle = title, ""
    bar.TitleColor = bar.LabelColor = (0.1, 0.1, 0.1)
    bar.TitleFontSize, bar.LabelFontSize = 14, 13
    bar.WindowLocation, bar.Position, bar.ScalarBarLength = "Any Location", (0.875, 0.25), 0.5
    bar.Orientation = "Vertical"
    bar.AddRangeLabels = 0
    return bar


def color_by(shown, view, field, palette, low, high, title, with_bar=True):
    """Colours from low to high by a point field that this view alone uses; a colour bar that other parts share is
    that of one of them."""
    ColorBy(shown, ("POINTS", field), separate=True)
    colors = GetColorTransferFunction(field, shown, separate=True)
    colors.ColorSpace = "Lab"
    colors.RGBPoints = [number for value, color in zip(np.linspace(low, high, len(palette)), palette)
                        for number in (value, *color)]
    if with_bar:
        bar_style(view, colors, title)
    shown.SetScalarBarVisibility(view, with_bar)


def scaled(source, field, factor, name):
    """With a point field more: another one times a factor, as colour bars show numbers as they are."""
    return Calculator(Input=source, AttributeType="Point Data", ResultArrayName=name, Function=f"{field}*{factor!r}")


def show(source, view):
    """As surface, in light that leaves its colours those of the colour bar nearly."""
    shown = Show(source, view)
    shown.Representation = "Surface"
    shown.Ambient, shown.Diffuse = 0.45, 0.6
    return shown


def show_plain(source, view, color=METAL):
    shown = show(source, view)
    shown.ColorArrayName = ("POINTS", "")
    shown.AmbientColor = shown.DiffuseColor = color


def smooth(source):
    """Its surface, curved cells drawn finely, shaded without facets but at edges."""
    surface = ExtractSurface(Input=source, NonlinearSubdivisionLevel=2)
    return GenerateSurfaceNormals(Input=surface, FeatureAngle=30.0, ComputeCellNormals=0)


def show_status(tops, view, size, size_of_open):
    """Spheres that tell what the points of the teeth do; relative to the others, open ones have a size of their own."""
    sized = Calculator(Input=tops, AttributeType="Point Data", ResultArrayName="size",
                       Function=f"if(status > 0.5, 1, {size_of_open})")
    spheres = Glyph(Input=sized, GlyphType="Sphere", GlyphMode="All Points", ScaleArray=("POINTS", "size"),
                    OrientationArray=("POINTS", "No orientation array"), ScaleFactor=size)
    spheres.GlyphType.ThetaResolution = spheres.GlyphType.PhiResolution = 16
    shown = show(spheres, view)
    ColorBy(shown, ("POINTS", "status"), separate=True)
    colors = GetColorTransferFunction("status", shown, separate=True)
    colors.InterpretValuesAsCategories = 1
    states = {value: state for value, state in STATUS.items() if value or size_of_open}
    colors.Annotations = [text for value, (name, _) in states.items() for text in (str(value), name)]
    colors.IndexedColors = [number for _, color in states.values() for number in color]
    bar = bar_style(view, colors, "contact")
    bar.ScalarBarLength, bar.TextPosition = 0.25, "Ticks left/bottom, annotations right/top"
    shown.SetScalarBarVisibility(view, True)


def wave_view(case, _):
    reader = read(os.path.join(case, "stator", "ring.pvd"), "stator", "displacement")
    points, displacement = points_and(reader, "displacement")
    radius, bottom, top = ring_size(points)
    scale = wave_scale(displacement, read_counts(os.path.join(case, "stator"))[0], radius)
    largest = upwards(np.abs(displacement[:, 2]).max())
    factor, unit = with_prefix(largest, "m")
    view = new_view(f"Travelling wave, displacement {scale:g} times larger")
    warped = WarpByVector(Input=scaled(reader, "displacement_Z", factor, "axial displacement"),
                          Vectors=("POINTS", "displacement"), ScaleFactor=scale)
    shown = show(smooth(warped), view)
    color_by(shown, view, "axial displacement", WAVE, -largest * factor, largest * factor, f"axial displacement, {unit}")
    look(view, (0, 0, (bottom + top) / 2), (0, -1, 0.75), 3.0 * radius)
    return view


def motor_view(case, torque):
    folder = os.path.join(case, "contact")
    files = {part: point_file(os.path.join(folder, "motor.pvd"), torque, part) for part in ("base", "teeth", "rotor")}
    base, teeth, rotor = (read(file, "contact", "displacement") for _, file in files.values())
    tops = read(point_file(os.path.join(folder, "contact.pvd"), torque)[1], "contact", "displacement_tooth", "status")
    points, displacement = points_and(teeth, "displacement")
    rotor_points, rotor_displacement = points_and(rotor, "displacement")
    radius, bottom, top = ring_size(rotor_points)
    scale = wave_scale(displacement, read_counts(folder)[0], radius)
    factor, unit = with_prefix(np.abs(displacement[:, 2]).max(), "m")
    rise = float(np.median(rotor_displacement[:, 2]))
    view = new_view(f"The motor at {files['teeth'][0]:.4g} mN m, rotor cut open, displacement {scale:g} times larger\n"
                    f"The wave lifts the rotor by {rise * factor:.3g} {unit}")
    behind = part_of_ring(rotor, (0, 1), math.pi / 2)
    for source, color in ((base, STATOR), (teeth, STATOR), (behind, METAL)):
        show_plain(smooth(WarpByVector(Input=source, Vectors=("POINTS", "displacement"), ScaleFactor=scale)), view, color)
    spacing = 2 * math.pi * np.hypot(points[:, 0], points[:, 1]).max() / read_counts(folder)[1] / 3
    lifted = WarpByVector(Input=tops, Vectors=("POINTS", "displacement_tooth"), ScaleFactor=scale)
    show_status(lifted, view, spacing, 0)
    look(view, (0, 0, (bottom + top) / 2 - 0.05 * radius), (0, -1, 0.75), 2.9 * radius)
    return view


class Crest:
    """Teeth around the crest with the largest pressure, at one operating point."""

    REACH = 0.35  # of what is shown to both sides, in wavelengths

    def __init__(self, case, torque):
        folder = os.path.join(case, "contact")
        self.torque, tops_file = point_file(os.path.join(folder, "contact.pvd"), torque)
        _, teeth_file = point_file(os.path.join(folder, "motor.pvd"), torque, "teeth")
        self.tops = read(tops_file, "contact", "displacement_tooth", "pressure", "status")
        self.teeth = read(teeth_file, "contact", "displacement")
        points, displacement, self.pressure = points_and(self.tops, "displacement_tooth", "pressure")
        self.radius, _, self.height = ring_size(points)
        waves, teeth = read_counts(folder)
        self.scale = wave_scale(displacement, waves, self.radius)
        self.wavelength = 2 * math.pi * self.radius / waves
        weight = self.pressure if self.pressure.max() > 0 else displacement[:, 2] == displacement[:, 2].max()
        is_near = np.linalg.norm(points - points[np.argmax(weight)], axis=1) < self.wavelength / 4
        middle = (weight[is_near, None] * points[is_near]).sum(axis=0)
        # From the middle of a tooth to slots on both sides: no tooth is cut.
        pitch = 2 * math.pi / teeth
        angle = pitch * round(math.atan2(middle[1], middle[0]) / pitch)
        self.outwards = np.array([math.cos(angle), math.sin(angle), 0])
        self.reach = min((max(round(self.REACH * teeth / waves), 1) + 0.5) * pitch, math.pi)
        inner_radius = np.hypot(points[:, 0], points[:, 1]).min()
        self.spacing = math.sqrt(math.pi * (self.radius**2 - inner_radius**2) / len(np.unique(points, axis=0)))

    def warped(self, source, vectors):
        """The part of it around the crest."""
        return WarpByVector(Input=part_of_ring(source, self.outwards, self.reach), Vectors=("POINTS", vectors),
                            ScaleFactor=self.scale)

    def view(self, title):
        return new_view(f"{title} at {self.torque:.4g} mN m, displacement {self.scale:g} times larger\n"
                        "The wave runs to the right")

    def look(self, view, upwards, slope):
        """From outside, downwards with a slope, at a height above the tooth tops at rest."""
        width = 2.7 * self.radius * math.sin(min(self.reach, math.pi / 2))
        focus = self.radius * self.outwards + np.array([0, 0, self.height + upwards])
        look(view, focus, self.outwards + np.array([0, 0, slope]), width)


def point_file(pvd, torque, part=""):
    """Torque and file of the operating point nearest to a torque, or to the middle of the curve; of a file whose name
    begins with that of the part."""
    try:
        points = [(float(entry.attrib["timestep"]), entry.attrib["file"])
                  for entry in xml.etree.ElementTree.parse(pvd).iter("DataSet")
                  if entry.attrib["file"].startswith(part)]
        middle = (min(points)[0] + max(points)[0]) / 2
    except (OSError, ValueError, LookupError, xml.etree.ElementTree.ParseError) as error:
        raise SceneError(f"{pvd} cannot be read ({error}); run the program contact again") from None
    time, file = min(points, key=lambda point: abs(point[0] - (middle if torque is None else torque)))
    return time, os.path.join(os.path.dirname(pvd), file)


def contact_status_view(case, torque):
    crest = Crest(case, torque)
    view = crest.view("Contact points")
    show_plain(crest.warped(crest.teeth, "displacement"), view)
    show_status(crest.warped(crest.tops, "displacement_tooth"), view, crest.spacing, 0.3)
    crest.look(view, 0, 1.1)
    return view


def pressure_view(case, torque):
    crest = Crest(case, torque)
    largest = upwards(crest.pressure.max())
    factor, unit = with_prefix(largest, "Pa")
    curtain = 0.2 * crest.wavelength
    view = crest.view("Pressure on the teeth")
    show_plain(crest.warped(crest.teeth, "displacement"), view)
    tops = scaled(crest.warped(crest.tops, "displacement_tooth"), "pressure", factor, "pressure on teeth")
    raised = WarpByScalar(Input=tops, Scalars=("POINTS", "pressure"), UseNormal=1, Normal=(0, 0, 1),
                          ScaleFactor=curtain / largest if largest > 0 else 0)
    shown = show(raised, view)
    color_by(shown, view, "pressure on teeth", HEAT, 0, largest * factor, f"pressure, {unit}")
    crest.look(view, curtain / 3, 0.35)
    return view


def limit_in_bulk(source, field, share=0.995):
    """What the means of cells do not exceed in a share of the volume: sharp corners have no largest value, and theirs
    would leave one colour for all the rest."""
    data = servermanager.Fetch(CellSize(Input=source, ComputeVertexCount=0, ComputeLength=0, ComputeArea=0))
    starts = vtk_to_numpy(data.GetCells().GetOffsetsArray())
    values = vtk_to_numpy(data.GetPointData().GetArray(field))[vtk_to_numpy(data.GetCells().GetConnectivityArray())]
    means = np.add.reduceat(values, starts[:-1]) / np.diff(starts)
    order = np.argsort(means)
    volume = np.cumsum(vtk_to_numpy(data.GetCellData().GetArray("Volume"))[order])
    return means[order[np.searchsorted(volume, share * volume[-1])]]


def loss_density_view(case, _):
    folder = os.path.join(case, "losses")
    reader = read(os.path.join(folder, "loss_density.vtu"), "losses", "loss_density")
    points, density = points_and(reader, "loss_density")
    radius, bottom, top = ring_size(points)
    reach = 1.5 * 2 * math.pi / read_counts(folder)[1]
    part = part_of_ring(reader, (1, 0), reach)
    largest = upwards(limit_in_bulk(part, "loss_density"))
    factor, unit = with_prefix(largest, "W/m\u00b3")
    peaks = "; the darkest places may exceed the scale" if density.max() > largest else ""
    view = new_view(f"Power lost inside the stator, mean of a period\nThree teeth, as all are alike{peaks}")
    shown = show(scaled(part, "loss_density", factor, "loss per volume"), view)
    color_by(shown, view, "loss per volume", HEAT, 0, largest * factor, f"loss density, {unit}")
    inner_radius = np.hypot(points[:, 0], points[:, 1]).min()
    size = math.hypot(2 * radius * math.sin(reach), top - bottom, radius - inner_radius)
    look(view, ((radius + inner_radius) / 2, 0, (bottom + top) / 2), (1, -0.9, 0.6), 1.8 * size)
    return view


def save(view, folder, name):
    """Writes beside the final name and renames: a failure leaves no half-written picture."""
    part = os.path.join(folder, f"paraview_{name}.part.png")
    SaveScreenshot(part, view, ImageResolution=SIZE, CompressionLevel="9")
    try:
        os.replace(part, os.path.join(folder, f"paraview_{name}.png"))
    except OSError:
        raise SceneError(f"ParaView could not write into {folder}") from None


def arrange(views):
    """Each in a tab of its own, the first one in front."""
    for name, view in views.items():
        RenameView(name, view)
        AssignViewToLayout(view, CreateLayout(name))
    SetActiveView(next(iter(views.values())))


def main():
    environment = os.environ
    torque = float(environment["RINGMOTOR_TORQUE"]) if environment["RINGMOTOR_TORQUE"] else None
    names = environment["RINGMOTOR_VIEWS"].split()
    RemoveViewsAndLayouts()  # an empty one that ParaView opens by itself
    views = {name: globals()[f"{name}_view"](environment["RINGMOTOR_CASE"], torque) for name in names}
    if folder := environment["RINGMOTOR_PNG"]:
        for name, view in views.items():
            save(view, folder, name)
        print(f"pictures in {folder}/")
    else:
        arrange(views)
        GetAnimationScene().PlayMode = "Snap To TimeSteps"
        GetAnimationScene().Loop = 1
        RenderAllViews()


try:
    main()
except SceneError as error:
    # ParaView's window, which closes now, has a sys.stderr of its own; taking views apart while leaving would end in
    # complaints of the X server.
    print(f"paraview_view: {error}", file=sys.__stderr__, flush=True)
    os._exit(1)
