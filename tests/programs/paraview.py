#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""scripts/paraview_view.py as its user meets it: messages, exit status and pictures.

Usage: tests/programs/paraview.py STATOR CONTACT LOSSES Mistakes|Pictures

What is compared: colours of pictures with those that the data must have, with and without inertia of the rotor.
"""
import base64
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import zlib

import h5py
import matplotlib.colors
import matplotlib.image
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

sys.dont_write_bytecode = True  # a test leaves nothing in the source tree
from program import STATIC_ROTOR, ROOT, run  # noqa: E402

STATOR, CONTACT, LOSSES = (sys.argv.pop(1) for _ in range(3))
SCRIPT = ROOT / "scripts" / "paraview_view.py"
FILES = ("stator/ring.pvd", "contact/contact.pvd", "contact/motor.pvd", "losses/loss_density.vtu")
VIEWS = ("motor", "wave", "contact_status", "pressure", "loss_density")
RED, ORANGE, BLUE = 0, 0.07, 0.6  # hues


def array_of(vtu, name):
    """A field of numbers in single precision, from one compressed block."""
    text = vtu.read_text(encoding="utf-8")
    block = re.search(f'<DataArray type="Float32" Name="{name}"[^>]*>([^<]*)<', text)[1].strip()
    return np.frombuffer(zlib.decompress(base64.b64decode(block[24:])), dtype="<f4")  # after its head


def points_of(vtu):
    """Points and displacements of a VTU file of any kind."""
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(vtu))
    reader.Update()
    grid = reader.GetOutput()
    return vtk_to_numpy(grid.GetPoints().GetData()), vtk_to_numpy(grid.GetPointData().GetArray("displacement"))


class WithFolder(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def assert_refused(self, done, *said):
        self.assertEqual(done.returncode, 1, done.stdout)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        for text in ("paraview_view: ", *said):
            self.assertIn(text, done.stderr)


class Mistakes(WithFolder):
    """With a ParaView that only tells how it was started."""

    def setUp(self):
        super().setUp()
        self.case, self.programs = self.folder / "case", self.folder / "programs"
        for file in FILES:
            (self.case / file).parent.mkdir(parents=True, exist_ok=True)
            (self.case / file).touch()
        self.programs.mkdir()
        for name in ("paraview", "pvpython", "xvfb-run"):
            (self.programs / name).write_text(f"#!/bin/sh\necho {name} \"$@\"\n"
                                              "echo \"$RINGMOTOR_CASE|$RINGMOTOR_VIEWS|$RINGMOTOR_TORQUE|$RINGMOTOR_PNG\"\n")
            (self.programs / name).chmod(0o755)

    def view(self, *arguments, display=None):
        environment = {"PATH": str(self.programs)}
        if display is not None:
            environment["DISPLAY"] = display
        return subprocess.run([SCRIPT, *map(str, arguments)], capture_output=True, text=True, timeout=60,
                              env=environment)

    def test_arguments_that_cannot_be_meant(self):
        usage = "usage: scripts/paraview_view.py CASE_DIR"
        for arguments, said in (([], "expected one folder, found 0"), ([self.case, self.case], "found 2"),
                                ([self.case, "--pgn", "x"], "unknown option --pgn"),
                                ([self.case, "--png"], "--png needs a value"),
                                ([self.case, "--png", "--torque", "1"], "--png needs a value"),
                                ([self.case, "--png="], "--png needs a value"),
                                ([self.case, "--torque"], "--torque needs a value"),
                                ([self.case, "--view"], "--view needs a value")):
            with self.subTest(arguments=arguments):
                self.assert_refused(self.view(*arguments), said, usage)
        self.assert_refused(self.view(self.case, "--view", "rotor"), '--view "rotor"', "there are: motor, wave")
        for torque in ("much", "nan", "inf"):
            self.assert_refused(self.view(self.case, "--torque", torque), f"'{torque}' is not a torque", "in mN m")

    def test_a_case_that_is_not_there(self):
        self.assert_refused(self.view(self.folder / "other"), f"there is no folder {self.folder / 'other'}")
        self.assert_refused(self.view(self.case / FILES[0]), f"there is no folder {self.case / FILES[0]}")
        self.assert_refused(self.view(self.programs), "nothing that can be shown", "scripts/run.sh")

    def test_no_paraview_or_no_display(self):
        self.assert_refused(self.view(self.case), "no display", "--png DIR")
        (self.programs / "xvfb-run").unlink()
        self.assert_refused(self.view(self.case, "--png", self.folder), "apt-get install xvfb")
        for name, options in (("paraview", []), ("pvpython", ["--png", self.folder / "pictures"])):
            (self.programs / name).unlink()
            self.assert_refused(self.view(self.case, *options, display=":0"), f"no program {name}",
                                "apt-get install paraview")
        self.assertFalse((self.folder / "pictures").exists())

    def test_a_folder_that_cannot_be_made(self):
        self.assert_refused(self.view(self.case, "--png", self.case / FILES[0], display=":0"), "cannot write into")

    def test_paraview_is_started_with_the_views_there_are(self):
        scenes = f"{ROOT}/scripts/drawing/paraview_scenes.py"
        self.assertEqual(self.view(self.case, display=":0").stdout,
                         f"paraview --script={scenes}\n{self.case}|{' '.join(VIEWS)}||\n")
        (self.case / "contact" / "motor.pvd").unlink()
        done = self.view(self.case, f"--png={self.folder}/new", "--torque", "-2e1")
        *left_out, start, told = done.stdout.splitlines()
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(start, f"xvfb-run -a -s -screen 0 1280x1024x24 -noreset pvpython {scenes}")
        self.assertEqual(told, f"{self.case}|wave loss_density|-20.0|{self.folder}/new")
        self.assertEqual(left_out, [f"paraview_view: no {view}, as {self.case}/contact/motor.pvd is missing; run the "
                                    "program contact with Output/VTU = true" for view in (VIEWS[0], *VIEWS[2:4])])
        done = self.view(self.case, "--png", self.folder / "new", display=":0")
        self.assertIn(f"\npvpython --force-offscreen-rendering {scenes}\n", done.stdout)
        done = self.view(self.case, "--view", "wave", display=":0")
        self.assertEqual(done.stdout, f"paraview --script={scenes}\n{self.case}|wave||\n")


class Pictures(WithFolder):
    @classmethod
    def setUpClass(cls):
        cls.case, cls.vibrating = (pathlib.Path(tempfile.mkdtemp()) for _ in range(2))
        for case in (cls.case, cls.vibrating):
            cls.addClassCleanup(shutil.rmtree, case)
        for program in (STATOR, CONTACT, LOSSES):
            cls.compute(program, cls.case, "Loading/Values = 0, 0.08", "Time/Snapshots = 4")
        (cls.vibrating / "stator").symlink_to(cls.case / "stator")
        cls.compute(CONTACT, cls.vibrating, "Loading/Values = 0", "Effects/Rotor inertia = on")

    @staticmethod
    def compute(program, case, *entries):
        options = [text for entry in (*entries, "Accuracy/Mode = fixed") for text in ("--set", entry)]
        done = run(program, STATIC_ROTOR, "--output", case, *options)
        assert done.returncode == 0, done.stderr

    def draw(self, *programs, options=(), of=None):
        """Of a case in which only these programs have run."""
        case = pathlib.Path(tempfile.mkdtemp(dir=self.folder))
        for program in programs:
            (case / program).symlink_to((of or self.case) / program)
        return run(SCRIPT, case, "--png", self.folder / "pictures", *options)

    def picture(self, view):
        return self.folder / "pictures" / f"paraview_{view}.png"

    def pixels(self, view):
        """Of the motor, left of the colour bar; by rows."""
        return matplotlib.image.imread(self.picture(view))[40:, :850, :3]

    def share(self, view, hue, rows=slice(None), width=0.2):
        """Of the pixels of the motor: those whose colour is strong and near a hue (0 red, 1/3 green, 2/3 blue)."""
        picture = self.pixels(view)[rows]
        seen = picture[(picture < 0.99).any(axis=-1)]
        self.assertGreater(len(seen), 0.05 * picture[..., 0].size, f"{view} is blank")
        tints = matplotlib.colors.rgb_to_hsv(seen)
        distance = np.abs((tints[:, 0] - hue + 0.5) % 1 - 0.5)
        return np.mean((distance < width / 2) & (tints[:, 1] > 0.4))

    def assert_has_colour_bar(self, view, n_colours):
        """Many colours in one column, and dark text beside it."""
        bar = matplotlib.image.imread(self.picture(view))[100:430, 870:960, :3]
        self.assertGreater(len(np.unique((bar[:, 12] * 20).round(), axis=0)), n_colours, view)
        self.assertGreater(np.mean((bar < 0.4).all(axis=-1)), 0.002, view)

    def test_files_have_what_is_drawn(self):
        for file, fields in (("stator/ring_00.vtu", "displacement m"), ("losses/loss_density.vtu", "loss_density W/m^3"),
                             ("contact/teeth_000.vtu", "displacement m|pressure Pa|status "),
                             ("contact/rotor_000.vtu", "displacement m"),
                             ("contact/contact_000.vtu", "displacement_tooth m|displacement_rotor m|pressure Pa|status ")):
            for case in (self.case, self.vibrating) if file.startswith("contact/") else (self.case,):
                text = (case / file).read_bytes().decode("latin-1")
                for field in fields.split("|"):
                    name, unit = field.split(" ")
                    found = re.search(f'<DataArray[^>]* Name="{name}"[^>]*>', text)
                    self.assertTrue(found, f"{file} has no {name}")
                    self.assertIn(f'units="{unit}"' if unit else "", found[0])

    def test_teeth_stand_on_the_base(self):
        """Where they meet, both files have the same motion: that of the wave at the time of the contact."""
        for case in (self.case, self.vibrating):
            (base, of_base), (teeth, of_teeth) = (points_of(case / "contact" / f"{part}_000.vtu") for part in ("base", "teeth"))
            top = base[:, 2].max()
            motions = {tuple(place): motion for place, motion in zip(np.round(base, 8), of_base) if place[2] > top - 1e-8}
            shared = [(motions[place], motion) for place, motion in zip(map(tuple, np.round(teeth, 8)), of_teeth)
                      if place in motions]
            self.assertGreater(len(shared), 4 * 90)
            ours, theirs = map(np.array, zip(*shared))
            self.assertGreater(np.abs(ours).max(), 1e-6)
            self.assertLess(np.abs(ours - theirs).max(), 1e-3 * np.abs(ours).max())

    def test_colours_are_those_of_the_data(self):
        done = self.draw("stator", "contact", "losses")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(set(self.picture("wave").parent.iterdir()), {self.picture(view) for view in VIEWS})
        for view in VIEWS:
            self.assertLess(self.picture(view).stat().st_size, 250e3)
            self.assert_has_colour_bar(view, 2 if view == "motor" else 3)
        for hue in (RED, BLUE):  # as many crests as troughs
            self.assertGreater(self.share("wave", hue), 0.2)
        for hue in (ORANGE, BLUE):  # nodes that touch
            self.assertGreater(self.share("motor", hue), 5e-4)
        # Teeth are grey; of the points that touch, which are coloured, one crest shows as much slip as all crests have.
        slip, stick = self.share("contact_status", ORANGE), self.share("contact_status", BLUE)
        self.assertTrue(0.001 < slip + stick < 0.1, (slip, stick))
        with h5py.File(self.case / "contact" / "contact.h5") as file:
            status = file["points/000/status"][-1]
        self.assertAlmostEqual(slip / (slip + stick), np.mean(status[status > 0] == 2), delta=0.25)
        self.assertGreater(self.share("pressure", ORANGE), 0.01)
        self.assertEqual(self.share("pressure", BLUE), 0)
        self.assertGreater(self.share("loss_density", ORANGE), 0.02)
        without_load = self.picture("pressure").read_bytes()
        self.assertEqual(self.draw("contact", options=["--torque", "60"]).returncode, 0)
        self.assertFalse(self.picture("pressure").read_bytes() == without_load, "the same picture at another torque")

    def test_a_rotor_with_inertia(self):
        """Its lip moves in the file as in the contact, and its picture shows that."""
        for case in (self.case, self.vibrating):
            with h5py.File(case / "contact" / "contact.h5") as file:
                lip = file["points/000/rotor"][-1, ..., 0]
            drawn = array_of(case / "contact" / "rotor_000.vtu", "displacement").reshape(-1, 3)[:, 2]
            for largest in (np.max, np.min):  # corners of cells and weighted means around them
                self.assertAlmostEqual(largest(drawn) / np.ptp(lip), largest(lip) / np.ptp(lip), delta=0.15)
            done = self.draw("contact", of=case)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertGreater(self.share("motor", ORANGE), 5e-4)
            shutil.copy(self.picture("motor"), self.folder / f"{len(list(self.folder.glob('*.png')))}.png")
        self.assertFalse((self.folder / "0.png").read_bytes() == (self.folder / "1.png").read_bytes())

    def test_files_that_are_damaged_are_named(self):
        for file, said in (("stator/ring.pvd", "cannot be read"), ("contact/summary.json", "Motor/Number of waves")):
            with self.subTest(file=file):
                path = self.case / file
                kept = path.read_bytes()
                try:
                    path.write_bytes(b"<VTKFile>")
                    self.assert_refused(self.draw(path.parent.name), file, said,
                                        f"run the program {path.parent.name} again")
                finally:
                    path.write_bytes(kept)


if __name__ == "__main__":
    unittest.main()
