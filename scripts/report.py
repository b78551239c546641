#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes CASE_DIR/report.html: the page of summary.py with the figures in it, one file for a browser or a printer.

Usage: scripts/report.py CASE_DIR      e.g. scripts/report.py output/canon_ring

The figures are those of scripts/figures.py, which is to be run first.
"""
import base64
import html
import os
import sys
import urllib.parse

sys.dont_write_bytecode = True
from running import surroundings  # noqa: F401
from results.case import CaseError, run_script
from results.page import Page
from results.page_file import MARK, refuse_foreign

MOST_POINTS = 60

# table of the page -> figures below it and what they show
FIGURES = {
    "glance": {
        "sections": "Cross-sections of stator and rotor, in mm.",
        "paraview_motor": "The motor in ParaView, its displacement enlarged, the rotor cut open. Where teeth touch it: blue "
                          "nodes stick, orange ones slip.",
    },
    "modes": {
        "dispersion": "Natural frequency against the number of waves around the ring.",
    },
    "wave": {
        "elliptic_paths": "Paths of 18 points of a tooth in the travelling wave.",
        "tooth_edge": "Amplitudes and phase along the outer edge of the teeth.",
    },
    "circuits": {
        "electrodes": "Electrode arcs of both phases under the ceramic.",
        "admittance": "Admittance of each phase around the resonance.",
    },
    "curve": {
        "torque_speed": "Speed and friction loss against torque. Thin lines: the speed breaks down, nothing is known "
                        "between the points.",
        "contact_shape": "Deformed teeth and rotor over one and a half waves, without load.",
        "normal_displacement": "Normal displacement of teeth and rotor over two waves, without load.",
        "warped_displacement": "Normal displacement on the whole ring, which is warped at rest.",
        "contact_forces": "Forces of the teeth on the rotor.",
        "friction_history": "Friction at a contact node while a crest passes.",
        "frequency_response": "Speed and amplitude against the frequency of the drive. Dotted: unstable.",
        "sensitivities": "What changes most by one percent of an entry, in percent; radii: one percent of their distance from "
                         "the next one.",
    },
    "losses": {
        "losses": "Power losses against torque.",
        "efficiency": "Efficiency against torque.",
        "energy": "Power balance: output and losses, stacked. Pale where the speed breaks down.",
    },
    "drive": {
        "drive": "Voltage that keeps the amplitude of the wave, or amplitude at the given voltage, current and "
                 "electrical efficiency.",
    },
}

STYLE = """
body { font: 15px/1.45 "DejaVu Sans", "Segoe UI", Helvetica, Arial, sans-serif; color: #222; background: #fff;
  max-width: 80rem; margin: 2rem auto; padding: 0 1.2rem; }
h1 { font-size: 1.7rem; line-height: 1.2; margin: 0; }
h2 { font-size: 1.15rem; margin: 2.2rem 0 0.6rem; padding-bottom: 0.25rem; border-bottom: 2px solid #0072B2; }
p { margin: 0.4rem 0; }
.origin, .note, figcaption { color: #555; font-size: 0.87rem; }
.warning { border-left: 4px solid #D55E00; background: #FDF1E8; padding: 0.5rem 0.8rem; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: 0.92rem; font-variant-numeric: tabular-nums; }
th, td { padding: 0.25rem 1.3rem 0.25rem 0; text-align: left; vertical-align: top; }
th { border-bottom: 1px solid #999; font-weight: 600; vertical-align: bottom; }
th span { display: block; font-weight: normal; color: #555; }
td { border-bottom: 1px solid #E3E3E3; }
.r { text-align: right; white-space: nowrap; }
.fail { color: #B00020; font-weight: 700; }
.figures { display: grid; grid-template-columns: repeat(auto-fit, minmax(34rem, 1fr)); gap: 1.6rem; margin-top: 1.2rem; }
figure { margin: 0; }
figure img { width: 100%; height: auto; }
code { font-family: "DejaVu Sans Mono", Menlo, Consolas, monospace; font-size: 0.9em; overflow-wrap: anywhere; }
details { margin-top: 2rem; }
pre { font-size: 0.8rem; overflow-x: auto; }
@media (max-width: 40rem) { .figures { grid-template-columns: 1fr; } }
@media print {
  @page { margin: 15mm; }
  body { font-size: 10pt; max-width: none; margin: 0; padding: 0; }
  h2 { break-after: avoid; margin-top: 1.2rem; }
  tr, figure { break-inside: avoid; }
  .figures { display: block; }
  figure { width: 135mm; margin: 0 auto 6mm; }
  .wide { overflow: visible; }
  table { font-size: 8.5pt; }
  th, td { padding-right: 0.6rem; }
  details { display: none; }
}
"""


def html_of_head(table):
    if not table.head:
        return ""
    cells = [f'<th scope="col" class="{side}">{html.escape(name)}<span>{html.escape(unit)}</span></th>'
             for (name, unit), side in zip(table.head, table.align)]
    return f"<thead><tr>{''.join(cells)}</tr></thead>\n"


def html_of_row(row, align):
    is_fail = "FAIL" in row or any("DO NOT HOLD" in cell or "FAILED" in cell for cell in row)
    cells = "".join(f'<td class="{side}">{html.escape(cell)}</td>' for cell, side in zip(row, align))
    return f'<tr class="fail">{cells}</tr>\n' if is_fail else f"<tr>{cells}</tr>\n"


def html_of_table(table):
    rows = "".join(html_of_row(row, table.align) for row in table.rows)
    notes = "".join(f'<p class="note">{html.escape(note)}</p>\n' for note in table.notes)
    return f'<h2>{html.escape(table.title)}</h2>\n<div class="wide"><table>\n{html_of_head(table)}<tbody>\n{rows}' \
           f"</tbody></table></div>\n{notes}"


def html_of_files(table):
    """Each a link, which works as long as the report is in the folder of its case."""
    rows = "".join(f'<tr><td><a href="{urllib.parse.quote(path)}"><code>{html.escape(path)}</code></a></td>'
                   f"<td>{html.escape(said)}</td></tr>\n" for path, said in table.rows if path != "report.html")
    return f"<h2>{html.escape(table.title)}</h2>\n<table><tbody>\n{rows}</tbody></table>\n"


def drawn(page, names):
    """Name -> path of the figures that are there, those of earlier results as well; of ParaView's there is a PNG alone."""
    return {name: path for name in names for kind in ("png", "svg")
            if os.path.exists(path := os.path.join(page.folder, "figures", f"{name}.{kind}"))}


def is_older(page, path):
    return os.path.getmtime(path) < page.newest_result()


def left_out(page):
    """A line for each figure of earlier results."""
    return [f"{path} is older than the results and left out; run scripts/figures.py and then scripts/report.py"
            for names in FIGURES.values() for path in drawn(page, names).values() if is_older(page, path)]


def html_of_figures(page, names):
    """Those that have been drawn; an image of its own each, so that names inside them do not meet."""
    figures = []
    for name, path in drawn(page, names).items():
        if is_older(page, path):
            continue
        caption = names[name]
        with open(path, "rb") as file:
            code = base64.b64encode(file.read()).decode()
        kind = "svg+xml" if path.endswith("svg") else "png"
        figures.append(f'<figure><img alt="{html.escape(caption)}" src="data:image/{kind};base64,{code}">'
                       f"<figcaption>{html.escape(caption)}</figcaption></figure>\n")
    return f'<div class="figures">\n{"".join(figures)}</div>\n' if figures else ""


def html_of_parameters(page):
    """All entries, as the option --set takes them."""
    lines = [f"{entry} = {text}" for entry, text in page.programs[-1].parameters.items()]
    return f"<details><summary>All parameters</summary>\n<pre>{html.escape(chr(10).join(lines))}</pre></details>\n"


def html_of(page):
    parts = []
    for name, table in page.tables.items():
        parts.append(html_of_files(table) if name == "files" else html_of_table(table))
        parts.append(html_of_figures(page, FIGURES.get(name, {})))
    warnings = "".join(f'<p class="warning">{html.escape(note)}</p>\n' for note in [*page.notes, *left_out(page)])
    return f"""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{html.escape(page.motor)}</title>
<style>{STYLE}</style>
</head>
<body>
<h1>{html.escape(page.motor)}</h1>
<p>{html.escape(page.motor_line)} {MARK} {html.escape(page.version)}</span></p>
{warnings}{"".join(parts)}{html_of_parameters(page)}</body>
</html>
"""


def main(arguments):
    if arguments in (["-h"], ["--help"]):
        print(__doc__)
        return
    if len(arguments) != 1:
        raise CaseError("expected one folder; usage: scripts/report.py CASE_DIR")
    path = os.path.join(arguments[0], "report.html")
    refuse_foreign(path)
    page = Page(arguments[0], MOST_POINTS)
    text = html_of(page)
    part = path + ".part"  # a failure leaves no half-written report
    try:
        with open(part, "w", encoding="utf-8") as file:
            file.write(text)
        os.replace(part, path)
    except OSError as error:
        raise CaseError(f"cannot write {path} ({error.strerror or error})") from None
    finally:
        if os.path.exists(part):
            os.remove(part)
    for line in left_out(page):
        print(f"report: {line}")
    print(f"report in {path}")


if __name__ == "__main__":
    run_script("report", main)
