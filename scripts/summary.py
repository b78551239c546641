#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Prints one page about a case: its results with their error bars, their cost, and where the files are.

Usage: scripts/summary.py CASE_DIR      e.g. scripts/summary.py output/canon_ring
"""
import os
import sys

sys.dont_write_bytecode = True
from case import Case, CaseError, with_error

MOST_MODES = 12  # on one page

# name in summary.json -> how to say it, unit to print, what to multiply with
WAVE_QUANTITIES = {
    "A_t/A_n": ("A_t/A_n, tooth top, outer edge", "", 1),
    "A_r/A_n": ("A_r/A_n, the same place", "", 1),
    "phi_edge": ("phi, +theta edge of the tooth", "deg", 1),
    "modal_mass": ("modal mass", "g", 1e3),
    "strain_energy": ("strain energy of the wave", "mJ", 1e3),
}


def print_row(name, value, unit, remark=""):
    print(f"  {name:<32}{value:>24} {unit:<4}{remark}".rstrip())


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


def print_summary(case, folder):
    summary = case.summary
    revision = f" ({summary['git']})" if summary["git"] else ""
    print(f"{case.motor}: {case.n_waves} waves, {case.n_teeth} teeth"
          f"    [{summary['program']} of ringmotor {summary['version']}{revision}]")
    print("\nNatural frequencies")
    print_modes(case)
    if case.wave:
        print_wave(case)
    print(f"\nCost: {sum(summary['seconds'].values()):.2f} s, {summary['peak_memory_MB']:.0f} MB,"
          f" {summary['dofs']} degrees of freedom")
    certificate = summary["certificate"]
    print(f"Certificate: {'holds' if certificate['holds'] else 'DOES NOT HOLD'}")
    for check in certificate["checks"]:
        print(f"  {'ok  ' if check['holds'] else 'FAIL'} {check['name']}: {check['value']:.2g}"
              f" (limit {check['limit']:.2g})")
    print("Files (described in doc/files.md)")
    for room in ("stator", "figures"):
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
