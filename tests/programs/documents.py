#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts of pages that a run makes: what scripts/development/documents.py finds wrong with them.

Usage: tests/programs/documents.py FOLDER_OF_THE_PROGRAMS [unittest arguments]

Pages of the test's own, whose commands print what the test says; and the identities of two parameter files.
"""
import pathlib
import shutil
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True  # a test leaves nothing in the source tree
from program import ROOT, run  # noqa: E402

sys.path.insert(0, str(ROOT / "scripts" / "development"))
import documents  # noqa: E402
from page_blocks import blocks_of, difference  # noqa: E402

PROGRAMS = pathlib.Path(sys.argv.pop(1))


class Numbers(unittest.TestCase):
    """Two texts with numbers agree or not."""

    def test_within_the_sum_of_both_error_bars(self):
        self.assertEqual(difference("77.6 +- 2.8 rpm", "79.0 +- 2.5 rpm"), "")
        self.assertEqual(difference("| 77.6 +- 2.8 | 5 |", "| 72.4 +- 2.5 | 5 |"), "")
        self.assertIn("more than 5.3 apart", difference("77.6 +- 2.8 rpm", "83.0 +- 2.5 rpm"))
        self.assertIn("error bar", difference("77.6 +- 2.8 rpm", "77.6 +- 0.8 rpm"))
        self.assertIn("'+-' in the page", difference("77.6 +- 2.8 rpm 3", "77.6 rpm 3 +- 0.1"))

    def test_without_an_error_bar(self):
        self.assertEqual(difference("29.946 kHz", "29.947 kHz"), "")
        self.assertNotEqual(difference("29.946 kHz", "31.5 kHz"), "")
        self.assertNotEqual(difference("f = 1.90", "f = -1.90"), "")

    def test_times_and_memory_are_of_the_machine(self):
        self.assertEqual(difference("found in 1.5 s, 271 MB", "found in 9.2 s, 318 MB"), "")
        self.assertNotEqual(difference("found in 1.5 steps", "found in 9.2 steps"), "")

    def test_words(self):
        self.assertIn("auto: off", difference("Tooth inertia = auto: on; 2.3 %", "Tooth inertia = auto: off; 2.3 %"))
        self.assertIn("2 numbers in the page, 3 now", difference("1, 2", "1, 2, 3"))


class Pages(unittest.TestCase):
    """A page is written, and then something is changed."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.page = self.folder / "page.md"
        self.said = self.folder / "said"  # what the commands print

    def tearDown(self):
        shutil.rmtree(self.folder)

    def documents(self, *options):
        return run(ROOT / "scripts" / "development" / "documents.py", *options, "--programs", PROGRAMS, self.page)

    def write(self, price, said="speed 77.6 +- 2.8 rpm", words=""):
        self.said.write_text(said)
        self.page.write_text(f"# A page\n\n<!-- {price}: cat {self.said} {words} -->\nold\n<!-- made 2026-01-01 by 0, of 0, as 0 -->\n\nEnd.\n")
        done = self.documents("--write", "--dear")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.documents("--check").returncode, 0)

    def assert_wrong(self, words):
        done = self.documents("--check")
        self.assertEqual(done.returncode, 1, done.stdout)
        self.assertIn("page.md:3: ", done.stdout)
        self.assertIn(words, done.stdout)

    def test_have_what_the_command_prints(self):
        self.write("cheap")
        text = self.page.read_text()
        self.assertTrue(text.startswith("# A page\n\n<!-- cheap: "))
        self.assertIn("-->\n\nspeed 77.6 +- 2.8 rpm\n\n<!-- made ", text)
        self.assertTrue(text.endswith(" -->\n\nEnd.\n"))

    def test_number_changed_by_hand(self):
        for price in ("cheap", "dear"):
            self.write(price)
            self.page.write_text(self.page.read_text().replace("77.6", "77.7"))
            self.assert_wrong("was changed by hand")

    def test_result_that_has_changed(self):
        self.write("cheap")
        before = self.page.read_text()
        self.said.write_text("speed 79.0 +- 2.8 rpm")
        self.assertEqual(self.documents("--check").returncode, 0)
        self.assertEqual(self.documents("--write").returncode, 0)
        self.assertEqual(self.page.read_text(), before)  # agrees within the error bars
        self.said.write_text("speed 99.0 +- 2.8 rpm")
        self.assert_wrong("77.6 in the page, 99 now")
        self.assertEqual(self.documents("--write").returncode, 0)
        self.assertIn("99.0 +- 2.8", self.page.read_text())

    def test_part_asked_for(self):
        """Of a dear part nobody notices that its error bars have changed."""
        self.write("dear")
        self.said.write_text("speed 77.6 +- 1.4 rpm")
        self.assertEqual(self.documents("--write", "--dear").returncode, 0)
        self.assertIn("77.6 +- 2.8", self.page.read_text())
        self.assertEqual(self.documents("--write", "--dear", "--only", "other").returncode, 0)
        self.assertIn("77.6 +- 2.8", self.page.read_text())
        self.assertEqual(self.documents("--write", "--dear", "--only", "cat").returncode, 0)
        self.assertIn("77.6 +- 1.4", self.page.read_text())
        self.assertEqual(self.documents("--check").returncode, 0)

    def test_script_that_has_changed(self):
        script = ROOT / "scripts" / "development" / "document_tables.py"
        self.write("dear", words="# scripts/development/document_tables.py")
        block = blocks_of(self.page)[0]
        made = documents.Documents(PROGRAMS, self.folder)
        self.assertEqual(made.inputs_of(block), block.inputs)
        with tempfile.TemporaryDirectory() as folder:
            copy = pathlib.Path(folder) / "copy.py"
            text = script.read_text(encoding="utf-8")
            copy.write_text("# another comment\n" + text.replace('"""Tables of the pages', '"""Some tables of the pages'))
            self.assertEqual(documents.without_comments(copy), documents.without_comments(script))
            copy.write_text(text.replace("if error > 0.", "if error > 1."))
            self.assertNotEqual(documents.without_comments(copy), documents.without_comments(script))

    def test_motor_that_has_changed(self):
        """Its parameters count, not its comments, its name and its folder."""
        self.write("dear", words="# prm/static_rotor.prm")
        made = documents.Documents(PROGRAMS, self.folder)
        text = (ROOT / "tests" / "programs" / "static_rotor.prm").read_text(encoding="utf-8")

        def identity(name, change):
            file = self.folder / name
            file.write_text(change(text))
            return made.identity(file)
        same = identity("a.prm", lambda text: text)
        self.assertEqual(identity("b.prm", lambda text: "# comment\n" + text.replace("Static rotor", "Other name")), same)
        self.assertNotEqual(identity("c.prm", lambda text: text.replace("Preload                = 14", "Preload = 15")), same)

    def test_figure(self):
        image = self.folder / "picture.png"
        self.page.write_text(f"<!-- dear: cp {self.said} {image} -->\n\n![A picture](picture.png)\n\n"
                             "<!-- made 2026-01-01 by 0, of 0, as 0 -->\n")
        self.said.write_text("pixels")
        self.assertEqual(self.documents("--write", "--dear").returncode, 0)
        self.assertIn("![A picture](picture.png)", self.page.read_text())
        self.assertEqual(self.documents("--check").returncode, 0)
        image.write_text("other pixels")
        self.assertEqual(self.documents("--check").returncode, 1)

    def test_command_that_fails(self):
        self.write("cheap")
        self.said.unlink()
        done = self.documents("--check")
        self.assertEqual(done.returncode, 1)
        self.assertIn("page.md:3: the command ended with status 1", done.stderr)


class OurPages(unittest.TestCase):
    def test_all_parts_are_as_they_have_to_be(self):
        done = run(ROOT / "scripts" / "development" / "documents.py", "--check", "--programs", PROGRAMS)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_tables_and_printed_lines_are_marked(self):
        """What is not marked has no error bar: a number that comes from a run."""
        for page in documents.PAGES:
            text = page.read_text(encoding="utf-8")
            for block in reversed(blocks_of(page)):
                text = text[:block.span[0]] + text[block.span[1]:]
            self.assertNotRegex(text, r"\d \+- \d[\d.]* (rpm|mN m|mW|kHz|%)", page)


if __name__ == "__main__":
    unittest.main()
