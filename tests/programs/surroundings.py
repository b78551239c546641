#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What users type, the files of their spreadsheets, and their surroundings: language, fonts, modules, configuration, file systems.

Usage: tests/programs/surroundings.py STATOR CONTACT LOSSES [unittest arguments]

What is compared: figures with those drawn without the user's configuration, byte by byte; all else with what the
documentation promises.
"""
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True  # a test leaves nothing in the source tree
from program import STATIC_ROTOR, ROOT, run, settings  # noqa: E402

SCRIPTS = ROOT / "scripts"
sys.path.insert(0, str(SCRIPTS))
from running import surroundings  # noqa: E402
from drawing.basics import save_all, start_figure  # noqa: E402
from motors.measured import read_measured  # noqa: E402
from motors.variation import number_of, varied  # noqa: E402
from results.case import CaseError  # noqa: E402
from running.typed import problem_of_list, problem_of_number, problem_of_path  # noqa: E402

PROGRAMS = [sys.argv.pop(1) for _ in range(3)]
CHINESE = "超声波电机 № 1"
HEAD = "torque_mNm,speed_rpm,torque_error_mNm,speed_error_rpm"
ROWS = ("10,84.2,2,0.3", "50,81.5,2,0.3")
# As on a file system of a network without locks.
NO_LOCKS = "#include <errno.h>\nint flock(int file, int kind) { (void)file; (void)kind; errno = ENOLCK; return -1; }\n"


def run_with(environment, *command):
    return run("env", *(f"{name}={value}" for name, value in environment.items()), *command)


class Typed(unittest.TestCase):
    def test_numbers(self):
        for text in ("1", "-0.5", "+.5e-3", "3.", "141E9"):
            self.assertEqual(problem_of_number(text), "", text)
        for text, words in (("", "is empty"), ("84,2", "decimal comma"), ("30,000", "thousands"), ("1.41d11", 'exponent "d11"'),
                            ("1.41 e11", 'exponent "e11"'), ("−2", "U+2212, minus sign"), ("1\u00a0000", "U+00A0, no-break space"),
                            ("１", "U+FF11, fullwidth digit one"), ("nan", "not finite"), ("1e999", "not finite"),
                            ("-inf", "not finite"), ("84.2 rpm", "not a number"), ("1_000", "not a number")):
            self.assertIn(words, problem_of_number(text), text)
        with self.assertRaisesRegex(CaseError, 'speed > 60,5": "60,5" has a decimal comma'):
            number_of("--subject-to", "speed > 60,5", "60,5")

    def test_lists(self):
        for text in ("1, 2, 3", "0, 0.05", "0.2,.3", "solid,shell", "1e-6, 2e-6", "0"):
            self.assertEqual(problem_of_list(text), "", text)
        for text, words in (("0,2, 0,3", "comma between digits"), ("1,5", "decimal point"), ("0, 05", "leading zero"),
                            ("0.2; 0.3", "semicolon"), ("0,2; 0,3", "comma between digits")):
            with self.assertRaisesRegex(CaseError, words):
                varied("--vary", f"Friction/Dynamic coefficient = {text}")

    def test_paths(self):
        for text in ("/home/me/x y", "../a~", "Bob's", "größe"):
            self.assertEqual(problem_of_path(text), "", text)
        for text, words in (("~/x", "whole path"), ("$HOME/x", "only a shell"), ("a/${B}", "only a shell"), ('"x"', "quotes"),
                            ("C:\\x", "backslash")):
            self.assertIn(words, problem_of_path(text), text)
            done = run(SCRIPTS / "sweep.py", STATIC_ROTOR, "--vary", "Loading/Preload = 1, 2", f"--output={text}")
            self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1), done.stderr)
            self.assertIn(words, done.stderr)


class Measured(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.path = pathlib.Path(scratch.name) / "measured.csv"

    def read(self, content):
        self.path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return read_measured(self.path)

    def test_curves_as_spreadsheets_write_them(self):
        text = "\n".join([HEAD, *ROWS, ""])
        with_remarks = "\n".join([f"{HEAD},remark,", *(f'{row},"warm, dry",' for row in ROWS), ",,,,,", ""])
        for content in (text, b"\xef\xbb\xbf" + text.encode(), text.replace("\n", "\r\n"), text.replace("\n", "\r"),
                        text.replace(",", ", "), text.replace(",", "\u00a0,\u00a0"), "sep=,\n" + text, f"\n{text}\n\n",
                        with_remarks, with_remarks.replace("warm", "kühl").encode("latin-1"),
                        with_remarks.replace("warm", "warm\nor\nnot"), f'"{HEAD}"\n'.replace(",", '","') + "\n".join(ROWS)):
            with self.subTest(content):
                found = self.read(content)
                self.assertEqual([round(value, 9) for value in found.torque], [0.01, 0.05])
                self.assertAlmostEqual(found.speed[1] / found.speed[0], 81.5 / 84.2)
                self.assertAlmostEqual(found.torque_error[1], 2e-3)

    def test_mistakes_are_named(self):
        text = "\n".join([HEAD, *ROWS, ""])
        german = text.replace(",", ";").replace(".", ",")
        for content, words in (
                (german, "separated by semicolons"), ("sep=;\n" + german, "separated by semicolons"),
                (german.replace("rpm\n", "rpm;a, b\n", 1), "separated by semicolons"), (text.replace(",", "\t"), "by tabs"),
                (text.replace("84.2", '"84,2"'), 'line 2, speed_rpm: "84,2" has a decimal comma'),
                (text.replace(".", ","), "line 2 has 6 cells for 4 names, as decimal commas"),
                (text.replace("84.2", "−84.2"), "line 2, speed_rpm: .* U\\+2212, minus sign"),
                (text.replace("81.5", ""), 'line 3, speed_rpm: "" is empty'), (text + "100\n", "line 4, speed_rpm"),
                (text.replace("84.2", "nan"), "not finite"), (text.replace("84.2", "fast"), '"fast" is not a number'),
                (text.replace("torque_error_mNm", "torque_mNm"), "2 columns torque_mNm"),
                (text.replace("speed_rpm", "speed"), "no column speed_rpm; .* has torque_mNm, speed, torque_error_mNm"),
                (text.replace("2,0.3", "-2,0.3"), "negative"), (text.replace("2,0.3", "0,0"), "needs torque_error_mNm"),
                (HEAD, "rows of numbers"), ("", "rows of numbers"), (text.encode("utf-16"), "is in UTF-16"),
                (b"PK\x03\x04\0\0", "not a text file")):
            with self.subTest(content), self.assertRaisesRegex(CaseError, words) as caught:
                self.read(content)
            self.assertIn(str(self.path), str(caught.exception))
        with self.assertRaisesRegex(CaseError, "No such file"):
            read_measured(self.path.with_name("none.csv"))
        with self.assertRaisesRegex(CaseError, "Is a directory"):
            read_measured(self.path.parent)


class WithCase(unittest.TestCase):
    """Has a case in which the program `stator` has run, with a Chinese name."""

    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp())
        cls.case = cls.folder / "case"
        done = run(PROGRAMS[0], STATIC_ROTOR, "--output", cls.case, *settings(f"Motor/Name = {CHINESE}", "Output/VTU = false"))
        assert done.returncode == 0, done.stderr

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.folder)

    def pictures(self):
        return {path.name: path.read_bytes() for path in (self.case / "figures").iterdir()}


class Figures(WithCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.done = run(SCRIPTS / "figures.py", cls.case)
        cls.usual = cls.pictures(cls)

    def test_say_once_which_characters_no_font_has(self):
        self.assertEqual((self.done.returncode, self.done.stderr), (0, ""))
        self.assertLessEqual(self.done.stdout.count("\n"), 2, self.done.stdout)  # one line if there is a font

    def test_do_not_depend_on_the_configuration_of_their_user(self):
        mine = self.folder / "configuration"
        mine.mkdir(exist_ok=True)
        for name, content in (("of LaTeX", b"text.usetex: True\n"),
                              ("of colours and fonts", b"text.color: white\nfont.family: Helvetica\nbackend: nothing\n"),
                              ("damaged", b"# f\xfcr mich\nno colon\nfont.size: huge\n")):
            with self.subTest(name):
                (mine / "matplotlibrc").write_bytes(content)
                done = run_with({"MPLCONFIGDIR": mine, "MATPLOTLIBRC": mine, "MPLBACKEND": "garbage"},
                                "bash", "-c", 'cd "$1" && exec "$2" "$3"', "bash", mine, SCRIPTS / "figures.py", self.case)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                self.assertEqual(self.pictures(), self.usual)

    def test_that_cannot_be_drawn_leave_the_others(self):
        def motor(title):
            return lambda: start_figure(Case, title, (3, 2))

        def no_pen():
            raise RuntimeError("no\npen")

        class Case:
            motor = "no $formula$, no $x^{"
            summary = {"git": "", "version": "1", "program": "p"}

        with tempfile.TemporaryDirectory() as folder:
            failed = save_all({"good": motor("one"), "bad": no_pen, "better": motor("two")}, folder)
            self.assertEqual(failed, {"bad": "RuntimeError no pen"})
            self.assertEqual(sorted(os.listdir(folder)), ["better.png", "better.svg", "good.png", "good.svg"])
            failed = save_all({"killed": lambda: os.kill(os.getpid(), signal.SIGKILL)}, folder)
            self.assertIn("terminated", failed["killed"])


class Surroundings(WithCase):
    def user_with_modules(self):
        """The home of one who has other modules than Debian's."""
        home = self.folder / "home"
        modules = home / ".local" / "lib" / f"python3.{sys.version_info.minor}" / "site-packages"
        for name in ("numpy", "h5py", "matplotlib"):
            (modules / name).mkdir(parents=True, exist_ok=True)
            (modules / name / "__init__.py").write_text('raise ImportError("compiled for another numpy")\n', encoding="utf-8")
        return home, modules

    def test_modules_of_a_user_are_not_seen(self):
        home, modules = self.user_with_modules()
        for environment in ({"HOME": home}, {"PYTHONPATH": modules}):
            for script in ("summary.py", "figures.py", "report.py", "sweep.py"):
                done = run_with(environment, SCRIPTS / script, "--help" if script == "sweep.py" else self.case)
                self.assertEqual((done.returncode, done.stderr), (0, ""), script)

    def test_wrong_modules_are_told_in_words_that_fit(self):
        home, _ = self.user_with_modules()
        done = run_with({"HOME": home}, "/usr/bin/python3", SCRIPTS / "summary.py", self.case)
        self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1), done.stderr)
        self.assertIn("summary: ImportError compiled for another numpy; start the script itself", done.stderr)
        done = run("/usr/bin/python3", "-sE", "-c", "import sys; sys.path.insert(0, sys.argv[1]); "
                   "from running import surroundings; import nothing", SCRIPTS)
        self.assertRegex(done.stderr, "^[^\n]*install the Debian package python3-nothing[^\n]*\n$")

    def test_an_error_that_nobody_expects_is_one_line(self):
        self.assertEqual(surroundings.words_of(ValueError("a\nb")), "internal error: ValueError a b")
        done = run("bash", "-c", f"{SCRIPTS}/summary.py {self.case} | true; exit ${{PIPESTATUS[1]}}")
        self.assertEqual(done.stderr, "")

    def test_names_that_the_terminal_lacks_are_replaced(self):
        page = run(SCRIPTS / "summary.py", self.case).stdout
        self.assertTrue(page.startswith(CHINESE), page)
        ascii_only = {"LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"}
        done = run_with(ascii_only, SCRIPTS / "summary.py", self.case)  # by -E the last two say nothing
        self.assertEqual((done.returncode, done.stdout), (0, page), done.stderr)
        done = run_with(ascii_only, "/usr/bin/python3", SCRIPTS / "summary.py", self.case)
        self.assertEqual((done.returncode, done.stdout), (0, page.encode("ascii", "replace").decode()), done.stderr)
        for script in ("figures.py", "report.py"):
            done = run_with(ascii_only, "/usr/bin/python3", SCRIPTS / script, self.case)
            self.assertEqual((done.returncode, done.stderr), (0, ""), script)
        self.assertIn(f"<title>{CHINESE}</title>", (self.case / "report.html").read_text(encoding="utf-8"))

    def test_other_encodings_are_refused_before_anything_is_computed(self):
        for name, content in (("latin1", STATIC_ROTOR.read_text(encoding="utf-8").replace("Static rotor", "für").encode("latin-1")),
                              ("utf16", STATIC_ROTOR.read_text(encoding="utf-8").encode("utf-16"))):
            prm = self.folder / f"{name}.prm"
            prm.write_bytes(content)
            for program in PROGRAMS:
                done = run(program, prm, "--output", self.folder / "refused")
                self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1), done.stderr)
                self.assertIn("save it as UTF-8", done.stderr)
                self.assertFalse((self.folder / "refused").exists())

    def test_file_systems_without_locks(self):
        source, library = self.folder / "no_locks.c", self.folder / "no_locks.so"
        source.write_text(NO_LOCKS, encoding="utf-8")
        subprocess.run(["cc", "-shared", "-fPIC", "-o", library, source], check=True)
        case, output = self.folder / "no_locks", self.folder / "sweep"
        here = {"LD_PRELOAD": library, "HDF5_USE_FILE_LOCKING": "TRUE"}
        coarse = settings("Output/VTU = false", "Accuracy/Mode = fixed", "Time/Snapshots = 4", "Loading/Values = 0.05")
        for program in PROGRAMS:
            done = run_with(here, program, STATIC_ROTOR, "--output", case, *coarse)
            self.assertEqual((done.returncode, done.stderr.count("\n")), (0, 1), done.stderr)
            self.assertIn("cannot be locked", done.stderr)
        for script in ("figures.py", "report.py", "summary.py"):
            done = run_with(here, SCRIPTS / script, case)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
        done = run_with(here, SCRIPTS / "sweep.py", STATIC_ROTOR, "--vary", "Stator/Base thickness = 4e-3, 5e-3", "--wave-only",
                        "--output", output, "--programs", pathlib.Path(PROGRAMS[0]).parent, *settings("Accuracy/Mode = fixed"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue((output / "table.h5").exists())


if __name__ == "__main__":
    unittest.main()
