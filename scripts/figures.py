#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws the figures of a case from the result files of the programs stator, contact and losses.

Usage: scripts/figures.py CASE_DIR [OTHER_CASE_DIR]...      e.g. scripts/figures.py output/canon_ring

Reads CASE_DIR/stator and writes, as PNG and SVG, into CASE_DIR/figures:
  sections         cross-sections of stator and rotor with dimensions, parts, supports and loads
  elliptic_paths   paths of 18 points of a tooth in the travelling wave (Fig. 4 of Maeno et al. 1992)
  tooth_edge       amplitudes and phase along the outer edge of the teeth (Fig. 5 of the same paper)
  dispersion       natural frequency against the number of waves, with error bars
  electrodes       the arcs of both phases, with a piezoelectric ceramic
  admittance       of each phase around the resonance, with a piezoelectric ceramic
The second and third need the motor's wave among the modes.
From CASE_DIR/contact, where it exists:
  contact_shape        teeth and rotor over one and a half waves, without load (Fig. 8)
  normal_displacement  of teeth and rotor over two waves, without load (Fig. 9)
  contact_forces       of each tooth, without load and at 50 mN m or the point nearest to it (Fig. 10)
  friction_history     forces at a point while a crest passes, with stick and slip (Fig. 11)
  torque_speed         speed and friction loss against torque (Fig. 12), with the curves of the other cases
  sensitivities        the entries that change each result most, after contact FILE.prm --sensitivities
  warped_displacement  normal displacement on the whole ring (Fig. 13), if it is warped at rest
From CASE_DIR/losses, where it exists:
  losses               friction, inside stator and rotor, support and total against torque (Fig. 14)
  efficiency           against torque (Fig. 15)
  energy               where the power goes against torque: output and each loss, stacked
  drive                voltage, current and electrical efficiency against torque, with a piezoelectric ceramic
"""
import functools
import pathlib
import sys

sys.dont_write_bytecode = True  # a drawing leaves nothing outside the folder of its case
from running import surroundings  # noqa: F401
from drawing.basics import FORMS, figures_folder, save_all
from drawing.contact_figures import (draw_contact_forces, draw_contact_shape, draw_friction_history,
                                     draw_normal_displacement, draw_warped_displacement, history_touches)
from drawing.curve_figures import draw_lip_amplification, draw_torque_speed
from drawing.loss_figures import draw_drive, draw_efficiency, draw_energy, draw_losses
from drawing.response_figure import draw_response
from drawing.section_figure import draw_sections
from drawing.sensitivity_figure import draw_sensitivities
from drawing.stator_figures import draw_admittance, draw_dispersion, draw_electrodes, draw_elliptic_paths, draw_tooth_edge
from results.case import CaseError, run_script
from results.contact_case import ContactCase
from results.losses_case import read_case

STATOR_FIGURES = {"sections": draw_sections, "elliptic_paths": draw_elliptic_paths, "tooth_edge": draw_tooth_edge, "dispersion": draw_dispersion,
                  "electrodes": draw_electrodes, "admittance": draw_admittance}
NEED_WAVE = (draw_elliptic_paths, draw_tooth_edge)
NEED_CIRCUITS = (draw_electrodes, draw_admittance)
CONTACT_FIGURES = {"contact_shape": draw_contact_shape, "normal_displacement": draw_normal_displacement,
                   "contact_forces": draw_contact_forces, "friction_history": draw_friction_history,
                   "warped_displacement": draw_warped_displacement, "torque_speed": draw_torque_speed,
                   "lip_amplification": draw_lip_amplification, "frequency_response": draw_response,
                   "sensitivities": draw_sensitivities}
LOSSES_FIGURES = {"losses": draw_losses, "efficiency": draw_efficiency, "energy": draw_energy, "drive": draw_drive}


def remove_figure(folder, name):
    """Of an earlier run that had what this one has not."""
    for form in FORMS:
        pathlib.Path(folder, f"{name}.{form}").unlink(missing_ok=True)


def figures_of_stator(case, contact, folder):
    figures = {}
    for name, draw in STATOR_FIGURES.items():
        if draw is draw_sections and not case.sections:
            remove_figure(folder, name)
        elif draw in NEED_CIRCUITS and not case.circuits:
            remove_figure(folder, name)
        elif draw in NEED_WAVE and not case.wave:
            remove_figure(folder, name)
            print(f"figures: no {name}, as the motor's wave is not among the modes of this run")
        else:
            figures[name] = functools.partial(draw, case, *([contact] if draw is draw_admittance else []))
    return figures


def figures_of_contact(case, others, folder):
    figures = {}
    needed = {draw_warped_displacement: case.warp, draw_lip_amplification: case.lip, draw_response: case.response,
              draw_sensitivities: case.sensitivities}
    for name, draw in CONTACT_FIGURES.items():
        if not needed.get(draw, True):
            remove_figure(folder, name)
        elif draw is draw_friction_history and not history_touches(case):
            remove_figure(folder, name)
            print(f"figures: no {name}, as none of Output/History points touches the rotor")
        else:
            figures[name] = functools.partial(draw, case, *([others] if draw is draw_torque_speed else []))
    return figures


def figures_of_losses(losses, contact, folder):
    figures = {name: functools.partial(draw, losses, contact) for name, draw in LOSSES_FIGURES.items()}
    if not losses.has_drive:
        remove_figure(folder, "drive")
        del figures["drive"]
    return figures


def remove_figures(folder, names):
    for name in names:
        remove_figure(folder, name)


def main(arguments):
    if arguments in (["-h"], ["--help"]):
        print(__doc__)
        return
    if not arguments:
        raise CaseError("expected a folder; usage: scripts/figures.py CASE_DIR [OTHER_CASE_DIR]...")
    case_folder, *other_folders = arguments
    case, contact, losses, left_out = read_case(case_folder)
    for reason in left_out:
        print(f"figures: {reason}")
    others = [ContactCase(folder) for folder in other_folders]
    with figures_folder(case_folder) as folder:
        figures = figures_of_stator(case, contact, folder)
        if contact:
            figures.update(figures_of_contact(contact, others, folder))
        else:
            remove_figures(folder, CONTACT_FIGURES)
        if losses:
            figures.update(figures_of_losses(losses, contact, folder))
        else:
            remove_figures(folder, LOSSES_FIGURES)
        failed = save_all(figures, folder)
        remove_figures(folder, failed)
    for name, reason in failed.items():
        print(f"figures: {name} cannot be drawn ({reason}), and is left out", file=sys.stderr)
    print(f"figures in {folder}/")
    if failed:
        sys.exit(1)


if __name__ == "__main__":
    run_script("figures", main)
