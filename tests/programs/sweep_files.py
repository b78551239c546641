#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The files of many motors: those that are named, those that a sweep keeps, damaged and changed ones.

Usage: tests/programs/sweep_files.py STATOR CONTACT LOSSES [unittest arguments]

What is compared: identities of motors whose files say the same or not; tables before and after damage.
"""
import json
import shutil
import sqlite3
import sys
import unittest

sys.dont_write_bytecode = True  # a test leaves nothing in the source tree
from program import STATIC_ROTOR, ROOT, rows_of, run, settings  # noqa: E402
from sweep_folder import COARSE, COMPARE, PROGRAMS, InAFolder, command  # noqa: E402  (finds the scripts)
import motor_task  # noqa: E402
from motors.many_motors import Family  # noqa: E402
from motor_task import known_outcome  # noqa: E402


class Files(InAFolder):
    """Parameter files, mesh files, and the small files that a sweep keeps."""

    WAVES = ("--wave-only", "--vary", "Stator/Base thickness = 4.0e-3, 4.2e-3")

    def family(self, prm):
        return Family(prm, {}, self.output, PROGRAMS[0].parent, is_wave_only=True)

    def test_are_read_as_the_programs_read_them(self):
        text = STATIC_ROTOR.read_text()
        plain = self.family(STATIC_ROTOR)
        edits = {
            "a comment behind end": text.replace("\nend\n", "\nend # of it\n"),
            "blanks": text.replace("subsection ", "subsection   ").replace("set ", "   set   "),
            "tabs": text.replace("subsection ", "subsection\t").replace("set ", "set\t").replace(" = ", "\t=\t"),
            "comments behind values": text.replace("= 141e9", "= 141e9 # Invar"),
            "a mark of the byte order": "\ufeff" + text,
            "lines of DOS": text.replace("\n", "\r\n"),
            "a line in two": text.replace("set Young modulus = 141e9", "set Young \\\n modulus = 141e9"),
            "an empty comment": text.replace("= 141e9", "= 141e9#"),
            "comments beyond ASCII": "# Ma\xdfe des L\xe4ufers\n" + text}
        for name, edited in edits.items():
            with self.subTest(name):
                self.assertNotEqual(edited, text)
                path = self.folder / "edited.prm"
                path.write_bytes(edited.encode("utf-8"))
                family = self.family(path)
                self.assertEqual(family.identity, plain.identity)
                self.assertEqual(family.motor({"Wave/Amplitude": "1e-6"}).key, plain.motor({"Wave/Amplitude": "1.0e-6"}).key)

    def watched(self, script, *words):
        """A script that is ended as soon as it, or what it imports, opens a parameter file."""
        hook = ("import os, runpy, sys\n"
                "def look(event, words):\n"
                "    if event == 'open' and str(words[0]).endswith('.prm'):\n"
                "        print('opened', words[0], file=sys.stderr, flush=True)\n"
                "        os._exit(99)\n"
                "sys.addaudithook(look)\n"
                "sys.argv = sys.argv[1:]\n"
                "sys.path.insert(0, os.path.dirname(sys.argv[0]))\n"
                "runpy.run_path(sys.argv[0], run_name='__main__')\n")
        return run("/usr/bin/python3", "-c", hook, script, *words)

    def test_are_not_read_by_scripts(self):
        (self.folder / "reader.py").write_text(f"open({str(STATIC_ROTOR)!r})")
        self.assertEqual(self.watched(self.folder / "reader.py").returncode, 99)
        scripts = ROOT / "scripts"
        case = self.folder / "case"
        for script, *words in ([scripts / "run.py", STATIC_ROTOR, "--output", case, *settings(*COARSE, "Output/VTU = false")],
                               command("--output", self.output, *self.WAVES), [COMPARE, case, case]):
            done = self.watched(script, *words)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
        for name in ("figures", "report", "summary"):
            self.assertEqual(self.watched(scripts / f"{name}.py", case).stderr, "")
        # And none knows the words of such a file.
        for path in [*scripts.rglob("*"), *(ROOT / "benchmarks").glob("*.py")]:
            if path.suffix in (".py", ".sh"):
                for word in ("subsection", '["prm"]'):
                    self.assertNotIn(word, path.read_text(encoding="utf-8"), path)

    def mesh_family(self, mesh):
        prm = self.folder / "mesh.prm"
        shutil.copy(ROOT / "tests" / "programs" / "stator_mesh.prm", prm)
        return Family(prm, {"Stator/Mesh file": str(mesh), "Accuracy/Mode": "fixed", "Accuracy/Polynomial degree": "2"},
                      self.output, PROGRAMS[0].parent, is_wave_only=True)

    def test_a_mesh_file_is_known_by_its_content(self):
        meshes = [ROOT / "meshes" / f"canon_{name}sector.msh" for name in ("half_", "")]
        mesh = self.folder / "sector.msh"
        keys = []
        for source in (meshes[0], meshes[1], meshes[0]):
            shutil.copy(source, mesh)
            motor = self.mesh_family(mesh).motor({"Wave/Amplitude": "1e-6"})
            keys.append(motor.key)
            self.assertEqual(motor.is_known(), len(keys) == 3)
            self.assertEqual(motor_task.find_wave(motor.wave).outcome, "certified")
        self.assertEqual(keys[0], keys[2])
        self.assertNotEqual(keys[0], keys[1])

    def test_one_that_changes_while_motors_are_computed(self):
        mesh = self.folder / "sector.msh"
        shutil.copy(ROOT / "meshes" / "canon_half_sector.msh", mesh)
        family = self.mesh_family(mesh)
        first, second = (family.motor({"Wave/Amplitude": text}) for text in ("1e-6", "2e-6"))
        self.assertEqual(motor_task.find_wave(first.wave).outcome, "certified")
        shutil.copy(ROOT / "meshes" / "canon_sector.msh", mesh)
        self.assertEqual(motor_task.find_wave(second.wave).outcome, "changed")
        self.assertFalse(second.is_known())
        prm = self.folder / "edited.prm"
        prm.write_text(STATIC_ROTOR.read_text().replace("= 141e9", "= 142e9"))
        third = self.family(prm).motor({"Wave/Amplitude": "2e-6"})
        prm.write_text(STATIC_ROTOR.read_text())
        self.assertEqual(motor_task.find_wave(third.wave).outcome, "changed")

    def test_damaged_ones_are_computed_again(self):
        self.sweep(*self.WAVES)
        note, other = sorted(self.output.glob("waves/*/wave.json"))
        text, times = note.read_text(), other.stat().st_mtime_ns
        rows = [(row["frequency_Hz"], row["outcome"]) for row in rows_of(self.output / "table.csv")]
        self.assertIsNotNone(known_outcome(note))
        fields = json.loads(text)
        for content in ("", text[:30], "null", "[]", "3", "{}", json.dumps({**fields, "outcome": "x"}), "\x00" * len(text),
                        json.dumps({**fields, "message": 3}), json.dumps({**fields, "seconds": "x"}), "\xff"):
            note.write_bytes(content.encode("latin-1"))
            self.assertIsNone(known_outcome(note), content)
        self.assertIn("1 motors are known already", self.sweep(*self.WAVES))
        for name in ("summary.json", "modes.h5", "frequencies.csv"):
            path = note.parent / "stator" / name
            path.write_bytes(path.read_bytes()[:-7] if name == "modes.h5" else b"")
            self.assertIsNone(known_outcome(note), name)
            self.assertIn("1 motors are known already", self.sweep(*self.WAVES))
        self.assertEqual(other.stat().st_mtime_ns, times)
        self.assertEqual([(row["frequency_Hz"], row["outcome"]) for row in rows_of(self.output / "table.csv")], rows)

    def test_a_damaged_record_of_a_search_is_named(self):
        self.output = self.folder / "what? {is} this%20&a=b"
        options = ("--vary", "Stator/Base thickness = 4e-3:5e-3", "--maximise", "frequency", "--trials", "2")
        self.sweep(*options)
        record = self.output / "optuna.db"
        self.assertEqual(list(self.folder.rglob("optuna.db")), [record])
        content = record.read_bytes()
        newer = sqlite3.connect(record)
        newer.execute("update alembic_version set version_num = 'v99.0.0'")
        newer.commit()
        newer.close()
        for damaged in (record.read_bytes(), b"nonsense" * 100, content[:5000], b"\x00" * 4096):
            record.write_bytes(damaged)
            done = run(*command("--output", self.output, *options))
            self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1), done.stderr)
            self.assertIn(f"{record} cannot be used", done.stderr)
            self.assertIn("remove it", done.stderr)
        record.unlink()
        before = {path: path.stat().st_mtime_ns for path in self.output.glob("waves/*/wave.json")}
        self.sweep(*options)
        self.assertEqual({path: path.stat().st_mtime_ns for path in before}, before)


if __name__ == "__main__":
    unittest.main()
