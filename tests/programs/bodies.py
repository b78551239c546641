#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The program contact with the bodies of other motors than its test motor: what belongs to which stator, bodies that are
drawn, and bodies that are meshes of half a sector.

Usage: tests/programs/bodies.py STATOR CONTACT [unittest arguments]
"""
import json
import pathlib
import shutil
import sys
import tempfile
import unittest

import h5py
import numpy as np

sys.dont_write_bytecode = True  # a test leaves nothing in the source tree
from program import STATIC_ROTOR, ROOT, run, settings, vtu_array  # noqa: E402
from sector_meshes import write_rotor, write_stator  # noqa: E402

STATOR, CONTACT = sys.argv.pop(1), sys.argv.pop(1)


class OtherStators(unittest.TestCase):
    """A wave is taken for the stator that it was found for, and for no other."""

    def test_parts_that_are_missing_in_the_parameters_are_named(self):
        mesh = ROOT / "meshes" / "canon_half_sector.msh"
        quickly = settings("Accuracy/Mode = fixed", "Time/Snapshots = 3", "Loading/Values = 0.05", "Output/VTU = false")
        for entry, said in (("Effects/Target plates = on", "Effects/Target plates = on there, off here"),
                            (f"Stator/Mesh file = {mesh}", " there, none here"),
                            ("Stator/Piezoceramic element = shell",
                             "Stator/Piezoceramic element = shell there, solid here")):
            with self.subTest(entry), tempfile.TemporaryDirectory() as case:
                def outcome(program, *options):
                    return run(program, STATIC_ROTOR, "--output", case, *quickly, *options)
                self.assertEqual(outcome(STATOR, "--set", entry).returncode, 0)
                refused = outcome(CONTACT)
                self.assertEqual(refused.returncode, 1, refused.stdout)
                self.assertEqual(len(refused.stderr.strip().splitlines()), 1, refused.stderr)
                for text in (said, entry.split(" = ")[0] + " = ", "belongs to another motor", "run the program stator"):
                    self.assertIn(text, refused.stderr)
                if "Mesh file" in entry:  # lines of that mesh do not follow the edges of the lip
                    continue
                taken = outcome(CONTACT, "--set", entry)
                self.assertEqual(taken.returncode, 0, taken.stderr)
                # The other way round: the wave of the plain stator.
                self.assertEqual(outcome(STATOR).returncode, 0)
                self.assertIn("belongs to another motor", outcome(CONTACT, "--set", entry).stderr)


class Sections(unittest.TestCase):
    """A motor whose bodies are drawn: prm/disc60.prm."""

    def test_turns(self):
        quickly = settings("Accuracy/Mode = fixed", "Accuracy/Polynomial degree = 2", "Accuracy/Refinement = 0",
                           "Accuracy/Interface refinement = 0", "Effects/Rotor inertia = off", "Effects/Damping = off",
                           "Effects/Tooth vibration = off", "Effects/Stator compliance = off",
                           "Loading/Values = 0.1", "Output/VTU = false")
        with tempfile.TemporaryDirectory() as case:
            for program in (STATOR, CONTACT, pathlib.Path(CONTACT).with_name("losses")):
                done = run(program, ROOT / "prm" / "disc60.prm", "--output", case, *quickly)
                self.assertEqual(done.returncode, 0, done.stderr)
            contact, losses = (json.loads((pathlib.Path(case) / program / "summary.json").read_text())
                               for program in ("contact", "losses"))
            self.assertTrue(contact["certificate"]["holds"])
            self.assertNotIn("clearance", [quantity["name"] for quantity in contact["quantities"]])  # of dimensions
            found = {quantity["name"]: quantity["value"] for quantity in contact["quantities"] + losses["quantities"]}
            # The rotor loses more than its metal alone would, as the lining has a larger loss factor.
            factor = found["internal_loss_rotor"] / found["rotor_power_per_loss_factor"]
            self.assertGreater(factor, 2e-3)
            self.assertLess(factor, 3e-2)
            with h5py.File(pathlib.Path(case) / "contact" / "contact.h5") as file:
                radii, forces = file["nodes/radius"][()], file["points/000/force"][()]
            self.assertAlmostEqual(radii.min(), 0.026, places=9)  # the lining, see meshes/disc60_rotor.geo
            self.assertAlmostEqual(radii.max(), 0.029, places=9)
            self.assertAlmostEqual(9 * forces[0, ..., 0].sum(), 160, places=6)  # nine repetitions

    def test_bodies_that_do_not_meet(self):
        for entries, said in (
                (["Rotor/Section file = none"], "missing Rotor/"),
                (["Wave/Amplitude = 1e-4"], "the height of Stator/Section file = 0.0053 m"),
                (["Output/History points = 0:0.0255"], "allowed: 0.026 to 0.029 m")):
            done = run(CONTACT, ROOT / "prm" / "disc60.prm", "--check", *settings(*entries))
            self.assertEqual(done.returncode, 1, done.stdout)
            self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
            self.assertIn(said, done.stderr)


class Sectors(unittest.TestCase):
    """A motor whose bodies are meshes of half a sector, and not of revolution."""

    @classmethod
    def setUpClass(cls):
        cls.case = pathlib.Path(tempfile.mkdtemp())
        write_stator(cls.case / "stator.msh")
        write_rotor(cls.case / "rotor.msh")
        cls.sectors = {"Stator/Section file": "none", "Rotor/Section file": "none",
                       "Stator/Mesh file": cls.case / "stator.msh", "Rotor/Mesh file": cls.case / "rotor.msh"}

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.case)

    def program(self, program, *options, **changes):
        """With entries of the bodies changed, "Stator_Mesh_file"."""
        changed = {name.replace("_", "/", 1).replace("_", " "): value for name, value in changes.items()}
        entries = [f"{name} = {value}" for name, value in {**self.sectors, **changed}.items()]
        return run(program, ROOT / "prm" / "disc60.prm", "--output", self.case / "case", *settings(*entries), *options)

    def test_turn_in_all_programs(self):
        quickly = settings("Accuracy/Mode = fixed", "Accuracy/Polynomial degree = 2", "Accuracy/Refinement = 0",
                           "Accuracy/Interface refinement = 1", "Effects/Rotor inertia = off", "Effects/Damping = off",
                           "Effects/Tooth vibration = off", "Effects/Stator compliance = off", "Loading/Values = 0.1")
        for program in (STATOR, CONTACT, pathlib.Path(CONTACT).with_name("losses")):
            done = self.program(program, *quickly)
            self.assertEqual(done.returncode, 0, done.stderr)
        folder = self.case / "case" / "contact"
        contact, losses = (json.loads((folder.parent / program / "summary.json").read_text())
                           for program in ("contact", "losses"))
        self.assertTrue(contact["certificate"]["holds"])
        found = {quantity["name"]: quantity["value"] for quantity in contact["quantities"] + losses["quantities"]}
        factor = found["internal_loss_rotor"] / found["rotor_power_per_loss_factor"]
        self.assertGreater(factor, 1.5e-3)  # the lining loses more than the metal, 1e-3
        self.assertLess(factor, 3e-2)
        with h5py.File(folder / "contact.h5") as file:
            radii, forces = file["nodes/radius"][()], file["points/000/force"][()]
        self.assertAlmostEqual(radii.min(), 0.026, places=9)
        self.assertAlmostEqual(radii.max(), 0.029, places=9)
        self.assertAlmostEqual(9 * forces[0, ..., 0].sum(), 160, places=6)  # nine repetitions
        place = vtu_array(folder / "rotor_000.vtu", "").reshape(-1, 3)
        self.assertAlmostEqual(place[:, 2].min(), 4.8e-3, delta=1e-8)  # the lining on the tooth tops
        radius = np.hypot(place[:, 0], place[:, 1])
        turned = np.remainder(np.arctan2(place[:, 1], place[:, 0]), 2 * np.pi / 90) / (2 * np.pi / 90)
        self.assertFalse(np.any((radius > 14e-3) & (radius < 16e-3) & (abs(turned - 0.5) < 0.05)))  # the holes

    def test_a_check_reads_both(self):
        done = self.program(CONTACT, "--check")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("from parallel", done.stdout)
        for changes, entries, said in (
                ({"Rotor_Mesh_file": "none"}, [], "missing Rotor/"),
                ({}, ["Output/History points = 0:0.0255"], "allowed: 0.026 to 0.029 m"),
                ({"Rotor_Mesh_file": self.case / "stator.msh"}, [], "Rotor/Mesh file"),
                ({"Rotor_Section_file": ROOT / "meshes" / "disc60_rotor.msh"}, [],
                 "describe the same body; allowed: one of them"),
                ({"Stator_Mesh_file": ROOT / "meshes" / "canon_sector.msh"}, [], "it is a whole sector"),
                ({}, ["Effects/Target plates = on"], "is incompatible with Stator/Mesh file")):
            done = self.program(CONTACT, "--check", *settings(*entries), **changes)
            self.assertEqual(done.returncode, 1, done.stdout)
            self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
            self.assertIn(said, done.stderr)


if __name__ == "__main__":
    unittest.main()
