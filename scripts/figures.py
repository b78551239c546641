#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws the figures of a case from the result files of the programs stator and contact.

Usage: scripts/figures.py CASE_DIR      e.g. scripts/figures.py output/canon_ring

Reads CASE_DIR/stator and writes, as PNG and SVG, into CASE_DIR/figures:
  elliptic_paths   paths of 18 points of a tooth in the travelling wave (Fig. 4 of Maeno et al. 1992)
  tooth_edge       amplitudes and phase along the outer edge of the teeth (Fig. 5 of the same paper)
  dispersion       natural frequency against the number of waves, with error bars
The first two need the motor's wave among the modes; without it only the third is drawn.
"""
import glob
import os
import sys

sys.dont_write_bytecode = True  # a drawing leaves nothing outside the folder of its case
from case import Case, CaseError
from drawing import figures_folder, save
from stator_figures import draw_dispersion, draw_elliptic_paths, draw_tooth_edge

FIGURES = {"elliptic_paths": draw_elliptic_paths, "tooth_edge": draw_tooth_edge, "dispersion": draw_dispersion}
NEED_WAVE = (draw_elliptic_paths, draw_tooth_edge)


def main(arguments):
    if arguments in (["-h"], ["--help"]):
        print(__doc__)
        return
    if len(arguments) != 1:
        raise CaseError("expected one folder; usage: scripts/figures.py CASE_DIR")
    case = Case(arguments[0])
    with figures_folder(arguments[0]) as folder:
        for name, draw in FIGURES.items():
            if draw in NEED_WAVE and not case.wave:
                for path in glob.glob(os.path.join(glob.escape(folder), f"{name}.*")):  # of an earlier run
                    os.remove(path)
                print(f"figures: no {name}, as the motor's wave is not among the modes of this run")
            else:
                save(draw(case), folder, name)
    print(f"figures in {folder}/")


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except CaseError as error:
        sys.exit(f"figures: {error}")
