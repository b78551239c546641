#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Opens a case in ParaView, in up to five views, or writes their pictures.

Usage: scripts/paraview_view.py CASE_DIR [--view NAME] [--torque T] [--png DIR]
e.g.   scripts/paraview_view.py output/canon_ring

  motor           the whole motor at an operating point, deformed, rotor cut open   (from contact/motor.pvd, contact.pvd)
  wave            the travelling wave on the whole ring; Play lets it run           (from stator/ring.pvd)
  contact_status  which points of the teeth are open, stick or slip, at a crest     (from contact/motor.pvd, contact.pvd)
  pressure        of the rotor on the teeth, at the same crest                      (from contact/motor.pvd, contact.pvd)
  loss_density    power lost inside the stator, per volume                          (from losses/loss_density.vtu)

A view whose files are missing is left out, with a line that says what to run.
  --view NAME  this view alone
  --torque T   the operating point whose torque is nearest to T mN m; by default, to the middle of the curve
  --png DIR    writes DIR/paraview_wave.png and so on, without a window
"""
import math
import os
import shutil
import sys
import tempfile

sys.dont_write_bytecode = True  # looking leaves nothing outside the folder that was asked for
from running import surroundings  # noqa: F401
from running.typed import problem_of_path

# Name -> the program it shows, its files in the folder of the case.
VIEWS = {"motor": ("contact", ["contact/motor.pvd", "contact/contact.pvd"]),
         "wave": ("stator", ["stator/ring.pvd"]),
         "contact_status": ("contact", ["contact/contact.pvd", "contact/motor.pvd"]),
         "pressure": ("contact", ["contact/contact.pvd", "contact/motor.pvd"]),
         "loss_density": ("losses", ["losses/loss_density.vtu"])}
USAGE = "usage: scripts/paraview_view.py CASE_DIR [--view NAME] [--torque T] [--png DIR]"
SCENES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "drawing", "paraview_scenes.py")


class ViewError(Exception):
    """A case that cannot be shown; the text is one line for the user."""


def read_arguments(arguments):
    """Folder of the case, names of views, torque in mN m or None, folder of the pictures or None."""
    values = {"--view": None, "--torque": None, "--png": None}
    folders = []
    rest = list(arguments)
    while rest:
        argument = rest.pop(0)
        name, has_value, value = argument.partition("=")
        if name in values:
            if not has_value and rest and not rest[0].startswith("--"):
                value = rest.pop(0)
            if not value:
                raise ViewError(f"{name} needs a value; {USAGE}")
            if name == "--view" and value not in VIEWS:
                raise ViewError(f'--view "{value}": there is no such view; there are: {", ".join(VIEWS)}')
            if name == "--png" and (problem := problem_of_path(value)):
                raise ViewError(f'{name} "{value}" {problem}')
            values[name] = value
        elif argument.startswith("-"):
            raise ViewError(f"unknown option {argument}; {USAGE}")
        else:
            folders.append(argument)
    if len(folders) != 1:
        raise ViewError(f"expected one folder, found {len(folders)}; {USAGE}")
    views = [values["--view"]] if values["--view"] else list(VIEWS)
    return folders[0], views, read_torque(values["--torque"]), values["--png"]


def read_torque(text):
    try:
        torque = None if text is None else float(text)
        if torque is None or math.isfinite(torque):
            return torque
    except ValueError:
        pass
    raise ViewError(f"--torque: '{text}' is not a torque; give a number in mN m")


def views_of(case_folder, asked):
    """Those of the views whose files are there; tells of the others what to run."""
    if not os.path.isdir(case_folder):
        raise ViewError(f"there is no folder {case_folder}; give that of a case, such as output/canon_ring")
    present = []
    for name in asked:
        program, files = VIEWS[name]
        missing = [file for file in files if not os.path.exists(os.path.join(case_folder, file))]
        if missing:
            print(f"paraview_view: no {name}, as {os.path.join(case_folder, missing[0])} is missing; run the program "
                  f"{program} with Output/VTU = true")
        else:
            present.append(name)
    if not present:
        raise ViewError(f"{case_folder} has nothing that can be shown; run scripts/run.sh with Output/VTU = true first")
    return present


def command(png_folder):
    """That which runs ParaView on the scenes, with a window or without one."""
    program = "paraview" if png_folder is None else "pvpython"
    if not shutil.which(program):
        raise ViewError(f"there is no program {program}; install ParaView: apt-get install paraview python3-paraview")
    has_display = "DISPLAY" in os.environ or "WAYLAND_DISPLAY" in os.environ
    if png_folder is None:
        if not has_display:
            raise ViewError("there is no display for a window; --png DIR writes pictures instead")
        return [program, f"--script={SCENES}"]
    # Debian's ParaView draws with the help of an X server even where nothing is shown.
    if has_display:
        return [program, "--force-offscreen-rendering", SCENES]
    if not shutil.which("xvfb-run"):
        raise ViewError("there is no display and no program xvfb-run to do without: apt-get install xvfb xauth")
    # ParaView looks at the server and leaves before it draws: without -noreset the server starts anew just then, and at
    # times is not there.
    return ["xvfb-run", "-a", "-s", "-screen 0 1280x1024x24 -noreset", program, SCENES]


def main(arguments):
    if arguments in (["-h"], ["--help"]):
        print(__doc__)
        return
    case_folder, asked, torque, png_folder = read_arguments(arguments)
    views = views_of(case_folder, asked)
    start = command(png_folder)
    if png_folder is not None:
        try:
            os.makedirs(png_folder, exist_ok=True)
            tempfile.TemporaryFile(dir=png_folder).close()
        except OSError as error:
            raise ViewError(f"cannot write into {png_folder} ({error.strerror or error})") from None
    # By the environment, as ParaView hands no arguments to a script that it runs in its window.
    os.environ.update(RINGMOTOR_CASE=os.path.abspath(case_folder), RINGMOTOR_VIEWS=" ".join(views),
                      RINGMOTOR_TORQUE="" if torque is None else str(torque),
                      RINGMOTOR_PNG="" if png_folder is None else png_folder,
                      PYTHONNOUSERSITE="1")  # the Python inside ParaView wants Debian's modules, too
    sys.stdout.flush()
    os.execvp(start[0], start)


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except ViewError as error:
        sys.exit(f"paraview_view: {error}")
