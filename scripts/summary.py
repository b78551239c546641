#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Prints one page about a case: its results with their error bars, their cost, and where the files are.

Usage: scripts/summary.py CASE_DIR      e.g. scripts/summary.py output/canon_ring
"""
import os
import sys

sys.dont_write_bytecode = True
from case import Case, CaseError, with_error
from contact_case import ContactCase, has_contact

MOST_MODES = 12  # on one page
MOST_POINTS = 6

# name in summary.json -> how to say it, unit to print, what to multiply with
WAVE_QUANTITIES = {
    "A_t/A_n": ("A_t/A_n, tooth top, outer edge", "", 1),
    "A_r/A_n": ("A_r/A_n, the same place", "", 1),
    "phi_edge": ("phi, +theta edge of the tooth", "deg", 1),
    "modal_mass": ("modal mass", "g", 1e3),
    "strain_energy": ("strain energy of the wave", "mJ", 1e3),
}


def print_row(name, value, unit, remark=""):
    print(f"  {name:<32}{value:>24} {unit:<5}{remark}".rstrip())


def print_modes(case):
    modes = sorted(case.modes, key=lambda mode: (mode["n"] != case.n_waves, mode["n"], mode["frequency_Hz"]))
    for mode in modes[:MOST_MODES]:
        relative = 100 * mode["error_Hz"] / mode["frequency_Hz"]
        driving = case.wave and mode["frequency_Hz"] == case.wave["natural_frequency_Hz"]
        print_row(f"n = {mode['n']}, {mode['family']}",
                  with_error(mode["frequency_Hz"] / 1e3, mode["error_Hz"] / 1e3), "kHz",
                  f"({relative:.2g} %)" + ("  the motor's wave" if driving else ""))
    if len(modes) > MOST_MODES:
        print(f"  and {len(modes) - MOST_MODES} more in stator/frequencies.csv")


def print_wave(case):
    print(f"\nThe travelling wave, amplitude {case.wave['amplitude_m'] * 1e6:g} um")
    for quantity in case.summary["quantities"]:
        if quantity["name"] in WAVE_QUANTITIES:
            name, unit, scale = WAVE_QUANTITIES[quantity["name"]]
            print_row(name, with_error(scale * quantity["value"], scale * quantity["error"]), unit)
    frequency = case.wave["natural_frequency_Hz"]
    gaps = [mode["frequency_Hz"] / frequency - 1 for mode in case.modes
            if mode["n"] == case.n_waves and mode["frequency_Hz"] != frequency]
    if gaps:
        gap = min(gaps, key=abs)
        print_row("gap to the next mode of this n", f"{100 * abs(gap):.1f}", "%", "above" if gap > 0 else "below")


def print_cost(summary, detail=""):
    print(f"\nCost of {summary['program']}: {sum(summary['seconds'].values()):.2f} s{detail},"
          f" {summary['peak_memory_MB']:.0f} MB, {summary['dofs']} degrees of freedom")
    certificate = summary["certificate"]
    print(f"Certificate: {'holds' if certificate['holds'] else 'DOES NOT HOLD'}")
    for check in certificate["checks"]:
        print(f"  {'ok  ' if check['holds'] else 'FAIL'} {check['name']}: {check['value']:.2g}"
              f" (limit {check['limit']:.2g})")


def some_points(curve):
    """Numbers of the operating points to print: all of them or, of many, some from the first to the last."""
    n_shown = min(MOST_POINTS, len(curve))
    return sorted({round(i * (len(curve) - 1) / max(1, n_shown - 1)) for i in range(n_shown)})


def name_of(point):
    if point["control"] == "torque":
        return "no-load speed" if abs(point["torque_mNm"]) < 1e-6 else f"speed at {point['torque_mNm']:.4g} mN m"
    return "stall torque" if point["speed_rpm"] == 0 else f"torque at {point['speed_rpm']:.4g} rpm"


def print_contact(contact):
    summary = contact.summary
    print("\nThe contact of rotor and teeth")
    points = [contact.curve[i] for i in some_points(contact.curve)]
    for point in points:
        if point["control"] == "torque":
            print_row(name_of(point), with_error(point["speed_rpm"], point["speed_error_rpm"]), "rpm")
        else:
            print_row(name_of(point), with_error(point["torque_mNm"], point["torque_error_mNm"]), "mN m")
    print("  friction loss")
    for point in points:
        value, error = point["friction_loss_mW"], point["friction_loss_error_mW"]
        torque = round(point["torque_mNm"], 6) + 0.0  # + 0.0 makes 0 of -0
        print_row(f"  at {torque:.4g} mN m", with_error(value, error), "mW",
                  f"({point['tangential_loss_mW']:.1f} along, {point['radial_loss_mW']:.1f} across the ring)")
    if len(points) < len(contact.curve):
        print(f"  and {len(contact.curve) - len(points)} more points in contact/torque_speed.csv")
    teeth = [point["teeth_in_contact_per_wave"] for point in contact.curve]
    print_row("teeth in contact per wave", " to ".join(f"{value:.2f}" for value in sorted({min(teeth), max(teeth)})), "")
    seconds = sum(point["seconds"] for point in contact.curve) / len(contact.curve)
    print_cost(summary, f" ({seconds:.2g} s for an operating point)")


def print_summary(case, folder):
    summary = case.summary
    revision = f" ({summary['git']})" if summary["git"] else ""
    print(f"{case.motor}: {case.n_waves} waves, {case.n_teeth} teeth    [ringmotor {summary['version']}{revision}]")
    print("\nNatural frequencies")
    print_modes(case)
    if case.wave:
        print_wave(case)
    print_cost(summary)
    if has_contact(folder):
        contact = ContactCase(folder)
        if contact.belongs_to(case):
            print_contact(contact)
        else:
            print("\nThe contact was computed with another wave; run contact again")
    print("\nFiles (described in doc/files.md)")
    for room in ("stator", "contact", "figures"):
        path = os.path.join(folder, room)
        if os.path.isdir(path):
            print(f"  {path}/")


if __name__ == "__main__":
    try:
        if len(sys.argv) != 2:
            raise CaseError("expected one folder; usage: scripts/summary.py CASE_DIR")
        print_summary(Case(sys.argv[1]), sys.argv[1])
    except CaseError as error:
        sys.exit(f"summary: {error}")
