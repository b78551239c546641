#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figures, page and report of a motor whose losses are known, as their user meets them.

Usage: tests/programs/report.py STATOR CONTACT LOSSES [unittest arguments]

What is compared: the numbers on page and report with those in the result files, digit by digit.
"""
import base64
import html
import html.parser
import json
import os
import pathlib
import re
import shutil
import sys
import tempfile
import unittest
import urllib.parse
import xml.etree.ElementTree

sys.dont_write_bytecode = True  # a test leaves nothing in the source tree
from program import STATIC_ROTOR, ROOT, rows_of, run  # noqa: E402

STATOR, CONTACT, LOSSES = (sys.argv.pop(1) for _ in range(3))
MOTOR = 'Ring <i>&amp; "7" $x'  # has to be escaped in HTML, in SVG and in a formula
NUMBER = r"(-?\d+(?:\.\d+)?)"


def script(name, case):
    return run(ROOT / "scripts" / f"{name}.py", case)


class Elements(html.parser.HTMLParser):
    """Of an HTML document: tags with their attributes, cells of each table row, all other text; tags must match."""

    EMPTY = ("meta", "img", "link", "br", "hr", "input")

    def __init__(self, text):
        super().__init__()
        self.open, self.tags, self.rows, self.text = [], [], [], {}
        self.feed(text)
        self.close()
        assert not self.open, self.open

    def handle_starttag(self, tag, attributes):
        self.tags.append((tag, dict(attributes)))
        if tag == "tr":
            self.rows.append([])
        if tag in ("td", "th"):
            self.rows[-1].append("")
        if tag not in self.EMPTY:
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag, tag

    def handle_data(self, data):
        if "td" in self.open:
            self.rows[-1][-1] += data
        if self.open:
            self.text[self.open[-1]] = self.text.get(self.open[-1], "") + data


class WithMotor(unittest.TestCase):
    """Has a copy of a case of its own, in which the programs have run."""

    @classmethod
    def setUpClass(cls):
        if not hasattr(WithMotor, "kept"):
            WithMotor.kept = tempfile.TemporaryDirectory()
            for program in (STATOR, CONTACT, LOSSES):
                done = run(program, STATIC_ROTOR, "--output", cls.kept.name, "--set", f"Motor/Name = {MOTOR}", "--set",
                           "Output/VTU = false", "--set", "Accuracy/Mode = fixed", "--set", "Time/Snapshots = 4")
                assert done.returncode == 0, done.stderr
        cls.case = pathlib.Path(tempfile.mkdtemp())
        shutil.copytree(cls.kept.name, cls.case, dirs_exist_ok=True)

    @classmethod
    def tearDownClass(cls):
        shutil.rmtree(cls.case)


class Report(WithMotor):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.done = [script(name, cls.case) for name in ("figures", "report", "summary")]
        cls.page = cls.done[-1].stdout
        cls.losses = rows_of(cls.case / "losses" / "losses.csv")
        cls.efficiency = rows_of(cls.case / "losses" / "efficiency.csv")
        cls.curve = rows_of(cls.case / "contact" / "torque_speed.csv")
        path = cls.case / "report.html"
        cls.report = Elements(path.read_text(encoding="utf-8")) if path.exists() else None

    def page_table(self, title):
        """Cells of the lines below a title, without the notes."""
        lines = re.split(r"\n\n", self.page.split(f"\n{title}")[1])[0].splitlines()[1:]
        return [re.split(r"  +", line.strip()) for line in lines]

    def assert_shown(self, cell, value, error=0.0, scale=1.0):
        """A cell has the value and its error, each right to the last digit that is shown."""
        value, error = scale * float(value), scale * float(error)
        if max(abs(value), abs(error)) < 1e-9:
            self.assertEqual(cell, "0")
            return
        found = re.fullmatch(NUMBER + (f" ± {NUMBER}" if error else ""), cell)
        self.assertTrue(found, f"{cell} for {value} ± {error}")
        for text, true in zip(found.groups(), (value, error)):
            self.assertAlmostEqual(float(text), true, delta=0.5001 * 10 ** -len(text.partition(".")[2]))
            self.assertGreaterEqual(len(text.replace(".", "").lstrip("0-")), 2, "too few digits")

    def test_all_is_made_without_a_word_of_complaint(self):
        for done in self.done:
            self.assertEqual((done.returncode, done.stderr), (0, ""))
        for name in ("losses", "efficiency", "energy", "torque_speed"):
            self.assertEqual((self.case / "figures" / f"{name}.png").read_bytes()[:8], b"\x89PNG\r\n\x1a\n")
            xml.etree.ElementTree.parse(self.case / "figures" / f"{name}.svg")
        self.assertFalse([name for name in os.listdir(self.case) if name.endswith(".part")])

    def test_losses_on_the_page_are_those_of_the_files(self):
        head, _, *rows = self.page_table("Where the power is lost")[:2 + len(self.losses)]
        self.assertEqual(head, ["torque", "friction", "stator metal", "piezoceramic", "rotor", "support", "total"])
        parts = ("friction_loss", "internal_loss_stator_metal", "internal_loss_piezoceramic", "internal_loss_rotor",
                 "support_loss", "total_loss")
        for cells, row, point in zip(rows, self.losses, self.curve, strict=True):
            self.assert_shown(cells[0], point["torque_mNm"], point["torque_error_mNm"])
            for cell, part in zip(cells[1:], parts, strict=True):
                self.assert_shown(cell, row[f"{part}_mW"], row[f"{part}_error_mW"])

    def test_curve_and_efficiency_on_the_page_are_those_of_the_files(self):
        head, _, *rows = self.page_table("Torque and speed")[:2 + len(self.curve)]
        self.assertEqual(head[:5], ["torque", "speed", "output", "losses", "efficiency"])
        for cells, point, row, losses in zip(rows, self.curve, self.efficiency, self.losses, strict=True):
            self.assert_shown(cells[1], point["speed_rpm"], point["speed_error_rpm"])
            self.assert_shown(cells[2], row["output_power_mW"], row["output_power_error_mW"])
            self.assert_shown(cells[3], losses["total_loss_mW"], losses["total_loss_error_mW"])
            self.assert_shown(cells[4], row["efficiency"], row["efficiency_error"], 100)
        best = max(self.efficiency, key=lambda row: float(row["efficiency"]))
        shown = next(cells for cells in self.page_table("At a glance") if cells[0] == "efficiency")
        self.assert_shown(shown[1], best["efficiency"], best["efficiency_error"], 100)
        self.assertIn(f"{float(best['torque_mNm']):.4g} mN m", shown[-1])

    def test_certificates_effects_and_seconds_are_those_of_the_summaries(self):
        summaries = [json.loads((self.case / name / "summary.json").read_text())
                     for name in ("stator", "contact", "losses")]
        checks = [["ok", summary["program"], check["name"], f"{check['value']:.2g}", f"{check['limit']:.2g}"]
                  for summary in summaries for check in summary["certificate"]["checks"]]
        self.assertEqual(self.page_table("Certificates")[1:], checks)
        effects = [[effect["name"], ("auto: " if effect["automatic"] else "") + effect["choice"],
                    "-" if effect["indicator"] is None else f"{100 * effect['indicator']:+.2g} %", f"{effect['seconds']:.1f}",
                    str(effect["dofs"]), f"{effect['bytes'] / 1e6:.1f}", summary["program"]]
                   for summary in summaries for effect in summary["effects"]]
        self.assertEqual(self.page_table("Effects")[2:2 + len(effects)], effects)
        for cells, summary in zip(self.page_table("Cost")[2:], summaries, strict=True):
            self.assertEqual(cells[0], summary["program"])
            self.assertAlmostEqual(float(cells[1]), sum(summary["seconds"].values()), delta=0.0051)

    def test_report_says_what_the_page_says(self):
        for title in ("At a glance", "Torque and speed", "Where the power is lost", "Effects", "Certificates", "Cost"):
            for cells in self.page_table(title):
                rows = [[cell for cell in row if cell] for row in self.report.rows]
                is_body = cells in rows
                is_said = any(" ".join(cells) in text for text in self.report.text.values())  # notes
                is_head = all(cell in self.report.text["th"] + self.report.text.get("span", "") for cell in cells)
                self.assertTrue(is_body or is_said or is_head, cells)

    def test_report_stands_alone(self):
        tags = [tag for tag, _ in self.report.tags]
        self.assertNotIn("script", tags)
        self.assertNotIn("link", tags)
        self.assertNotIn("i", tags)  # of the motor's name
        self.assertEqual(self.report.text["h1"], MOTOR)
        self.assertEqual(self.report.text["title"], MOTOR)
        self.assertIn(MOTOR, self.report.text["pre"])
        self.assertNotIn("url(", self.report.text["style"])
        images = [attributes["src"] for tag, attributes in self.report.tags if tag == "img"]
        drawn = {path.read_bytes() for path in (self.case / "figures").glob("*.svg")}
        kind = "data:image/svg+xml;base64,"
        self.assertEqual({base64.b64decode(image.removeprefix(kind), validate=True) for image in images}, drawn)
        links = [attributes["href"] for tag, attributes in self.report.tags if tag == "a"]
        self.assertIn("losses/efficiency.csv", links)
        for link in links:
            self.assertTrue((self.case / urllib.parse.unquote(link)).exists(), link)


class Mistakes(WithMotor):
    def refused(self, name, *said):
        done = script(name, self.case)
        self.assertEqual(done.returncode, 1, done.stdout)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        for text in said:
            self.assertIn(text, done.stderr)
        self.assertFalse((self.case / "report.html").exists())

    def test_tables_that_are_missing_or_damaged_are_named(self):
        for name in ("losses.csv", "efficiency.csv"):
            path = self.case / "losses" / name
            kept = path.read_text()
            head, *rows = kept.splitlines()
            damages = {"cut in the last row": kept[:kept.rindex(",")],
                       "a row less": "\n".join([head, *rows[:-1]]),
                       "another column": kept.replace("torque_mNm", "load", 1).replace("power", "work").replace(
                           "friction_loss", "friction"),
                       "no number": "\n".join([head, *rows[:-1], re.sub("[^,]*", "nan", rows[-1], count=1)]),
                       "no number in another column": "\n".join([head, *rows[:-1], re.sub("[^,]*$", "nan", rows[-1],
                                                                                         count=1)]),
                       "empty": "", "binary": "\0\1\2"}
            try:
                for damage, content in damages.items():
                    with self.subTest(file=name, damage=damage):
                        path.write_text(content)
                        self.refused("summary", f"losses/{'efficiency.csv' if damage == 'a row less' else name}",
                                     "run the program losses again")
                for script_name in ("summary", "figures", "report"):
                    path.write_text(damages["cut in the last row"])
                    self.refused(script_name, str(path), "run the program losses again")
                    path.unlink()
                    self.refused(script_name, str(path), "is missing; run the program losses first")
            finally:
                path.write_text(kept)

    def test_losses_of_another_run_are_left_out(self):
        curve = self.case / "contact" / "torque_speed.csv"
        kept = curve.read_text()
        try:
            speed = rows_of(curve)[0]["speed_rpm"]
            curve.write_text(kept.replace(speed, "12.5", 1))
            done = script("summary", self.case)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertIn("run losses again", done.stdout)
            self.assertIn("12.50 ±", done.stdout)
            self.assertNotIn("Where the power is lost", done.stdout)
            self.assertNotIn("efficiency  ", done.stdout)
        finally:
            curve.write_text(kept)

    def test_figures_of_an_earlier_run_are_left_out(self):
        figure = self.case / "figures" / "losses.svg"
        figure.parent.mkdir()
        try:
            figure.write_text("<svg/>")
            os.utime(figure, (1e9, 1e9))
            done = script("report", self.case)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            report = (self.case / "report.html").read_text(encoding="utf-8")
            for text in (done.stdout, html.unescape(report)):
                self.assertIn(f"{figure} is older than the results and left out", text)
            self.assertNotIn("<img", report)
        finally:
            shutil.rmtree(figure.parent)
            (self.case / "report.html").unlink(missing_ok=True)


if __name__ == "__main__":
    unittest.main()
