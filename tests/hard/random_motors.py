#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random motors: each has to end with certified results or with a refusal in words, in its time.

usage: tests/hard/random_motors.py [--seed 1] [--count 200] [--seconds 120] [--workers N] [--invariances]
           [--csv FILE [--resume]] [--keep FOLDER] [--markdown FILE]

Motor number k is drawn from seed k alone, from --seed on: `--seed 17 --count 1` runs number 17 again. It is
tests/programs/static_rotor.prm with other dimensions, materials, loads, friction, and schemes, within the ranges that the
functions draw_...() below show; the command line of each motor that is not certified is printed. Results are checked by
contact_checks.py. Outcomes: certified; refused (exit status 1, a mistake in the input); failed (status 2, the programs
say why, which may be Accuracy/Time limit: three quarters of --seconds); hang (more than --seconds of processor time),
crash (any other end), silent wrong (status 0, but a check finds something). The exit status is 1 if one of the last
three has happened.

With --invariances each certified motor is also computed in millimetres, newtons and MPa, and on two ranks: speeds and
torques have to agree within rounding or, where another discretisation was chosen, within the sum of their error bars.
"""
import argparse
import concurrent.futures
import json
import math
import pathlib
import random
import shutil
import sys
import tempfile

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent.parent / "benchmarks"))
from contact_checks import ContactResults, disagreements  # noqa: E402
from motor_run import (COLUMNS, OUTPUT_OFF, RowFile, add_options, command_lines, is_acceptable,  # noqa: E402
                       run_contact, run_program, summary, write_markdown)
from timed_run import ROOT, entries_of  # noqa: E402

BASE = ROOT / "tests" / "programs" / "static_rotor.prm"
SHOWN = ("Motor/Number of waves", "Motor/Number of teeth", "Loading/Preload", "Wave/Amplitude", "Friction/Law",
         "Time/Scheme", "Loading/Control", "Contact/Formulation", "Effects/Friction lining",
         "Initial deformation/Amplitude", "Rotor/Flange element", "Stator/Piezoceramic element")


OWN_LIMIT = 0.75  # of the seconds, after which the program has to end itself


class Dice:
    """Draws from one seed. Only random() is used, which gives the same numbers in all versions of Python."""

    def __init__(self, seed):
        self.generator = random.Random(seed)

    def uniform(self, low, high):
        return low + (high - low) * self.generator.random()

    def log_uniform(self, low, high):
        return math.exp(self.uniform(math.log(low), math.log(high)))

    def integer(self, low, high):
        """Both ends included."""
        return low + int((high - low + 1) * self.generator.random())

    def chance(self, probability):
        return self.generator.random() < probability

    def pick(self, *choices):
        return choices[int(len(choices) * self.generator.random())]


def text(number):
    """Three digits are enough, and easy to type again."""
    return f"{number:.4g}"


def draw_stator(dice):
    """Entries and the lengths on which the rotor depends."""
    n_waves = dice.integer(3, 13)
    n_teeth = (n_waves * dice.integer(5, 13) if dice.chance(0.35) else  # the pattern repeats itself
               dice.integer(5 * n_waves, 13 * n_waves))
    outer = 0.036 * dice.log_uniform(0.3, 2.)
    width = outer * dice.uniform(0.1, 0.3)
    base_inner = outer - width
    tip_inner = base_inner + (width * dice.uniform(0., 0.2) if dice.chance(0.4) else 0.)
    tip_outer = outer - (width * dice.uniform(0., 0.4) if dice.chance(0.8) else 0.)
    pitch = 2. * math.pi * base_inner / n_teeth
    thickness = outer * dice.uniform(0.05, 0.15)
    piezoceramic = 0. if dice.chance(0.1) else thickness * dice.uniform(0.05, 0.3)
    is_shell = 0. < piezoceramic < 0.28 * width and dice.chance(0.4)
    return {"Motor/Number of waves": str(n_waves), "Motor/Number of teeth": str(n_teeth),
            "Modes/Nodal diameters": str(n_waves), "Modes/Number of modes": "3",
            "Stator/Base inner radius": text(base_inner), "Stator/Base outer radius": text(outer),
            "Stator/Tip inner radius": text(tip_inner), "Stator/Tip outer radius": text(tip_outer),
            "Stator/Base thickness": text(thickness),
            "Stator/Tooth height": text(pitch * dice.uniform(0.3, 1.5)),
            "Stator/Slot width": text(pitch * dice.uniform(0.1, 0.45)),
            "Stator/Piezoceramic thickness": text(piezoceramic),
            "Stator/Piezoceramic element": "shell" if is_shell else "solid"}, outer, tip_inner, tip_outer


def draw_rotor(dice, stator_outer, tip_inner, tip_outer):
    lip_outer = tip_outer
    if dice.chance(0.4):  # the lip ends on the teeth, or beyond their edge
        lip_outer += (tip_outer - tip_inner) * dice.uniform(-0.3, 0.1)
    lip_inner = lip_outer - (tip_outer - tip_inner) * dice.uniform(0.1, 0.6)
    ring_inner = max(stator_outer, lip_outer + 0.02 * stator_outer) * dice.uniform(1.005, 1.05)
    ring_outer = ring_inner + stator_outer * dice.uniform(0.05, 0.2)
    flange = (ring_inner - lip_inner) * dice.log_uniform(0.08, 0.6)
    is_shell = flange < 0.28 * (ring_inner - lip_inner) and flange < 1.8 * (ring_inner - lip_outer) and dice.chance(0.6)
    bar_height = 0.012 * stator_outer
    return {"Rotor/Ring inner radius": text(ring_inner), "Rotor/Ring outer radius": text(ring_outer),
            "Rotor/Ring lower face": text(-stator_outer * dice.uniform(0.01, 0.1)),
            "Rotor/Ring upper face": text(flange + bar_height + stator_outer * dice.uniform(0.01, 0.1)),
            "Rotor/Flange thickness": text(flange), "Rotor/Flange element": "shell" if is_shell else "solid",
            "Rotor/Lip inner radius": text(lip_inner), "Rotor/Lip outer radius": text(lip_outer),
            "Rotor/Radial bar stiffness": "0" if dice.chance(0.15) else text(dice.log_uniform(1e8, 1e10)),
            "Rotor/Radial bar height": text(bar_height)}


def draw_materials(dice):
    entries = {}
    for material, moduli, ratios, densities in (("Stator metal", (60e9, 220e9), (0.2, 0.4), (2500., 9000.)),
                                                ("Piezoceramic", (50e9, 100e9), (0.25, 0.4), (7000., 8000.)),
                                                ("Rotor metal", (3e9, 220e9), (0.25, 0.42), (1200., 9000.))):
        entries[f"Materials/{material}/Young modulus"] = text(dice.log_uniform(*moduli))
        entries[f"Materials/{material}/Poisson ratio"] = text(dice.uniform(*ratios))
        entries[f"Materials/{material}/Density"] = text(dice.uniform(*densities))
    return entries


def draw_friction(dice):
    law = dice.pick("coulomb", "static-dynamic", "velocity", "slip-weakening")
    dynamic = dice.log_uniform(0.05, 0.8)
    entries = {"Friction/Law": law, "Friction/Dynamic coefficient": text(dynamic),
               "Friction/Static coefficient": text(dynamic * dice.uniform(1., 1.5)),
               "Friction/Decay velocity": text(dice.log_uniform(0.01, 1.)),
               "Friction/Weakening length": text(dice.log_uniform(1e-8, 1e-6))}
    if dice.chance(0.2):
        normal = dice.log_uniform(1e12, 1e14)
        entries.update({"Effects/Friction lining": "on", "Friction/Lining normal stiffness": text(normal),
                        "Friction/Lining tangential stiffness": text(normal * dice.uniform(0.2, 0.6))})
    if dice.chance(0.2):
        normal = dice.log_uniform(1e6, 1e8)
        entries.update({"Contact/Formulation": "penalty", "Contact/Normal penalty": text(normal),
                        "Contact/Tangential penalty": text(normal * dice.uniform(0.2, 1.))})
    return entries


def draw_scene(dice):
    """Loads, warp and scheme: entries, and what has to wait until the wave's frequency is known."""
    entries = {"Loading/Preload": text(dice.log_uniform(0.01, 1000.)),
               "Wave/Amplitude": text(dice.log_uniform(0.02e-6, 3e-6)), "Loading/Number of curve points": "3",
               "Loading/Control": dice.pick("torque", "torque", "speed")}
    is_warped = dice.chance(0.25)
    if is_warped:
        entries.update({"Initial deformation/Amplitude": text(dice.log_uniform(1e-7, 1e-5)),
                        "Initial deformation/Number of waves": str(dice.integer(0, 4))})
    marches = is_warped or dice.chance(0.1)
    entries["Time/Scheme"] = dice.pick("auto", "marching") if is_warped else (
        "marching" if marches else dice.pick("auto", "steady"))
    if marches:  # its first steps are start-up, and hardly known better
        entries["Accuracy/Contact target"] = "0.3"
    later = {"steps": dice.pick(30, 60), "marches": marches, "speeds": None}
    if entries["Loading/Control"] == "speed" and dice.chance(0.5):
        later["speeds"] = [dice.uniform(-0.2, 0.5), dice.uniform(0.5, 1.3)]
    return entries, later


def draw(seed):
    dice = Dice(seed)
    stator, *lengths = draw_stator(dice)
    scene, later = draw_scene(dice)
    return {**stator, **draw_rotor(dice, *lengths), **draw_materials(dice), **draw_friction(dice), **scene,
            **OUTPUT_OFF}, later


def entries_by_wave(folder, entries, later):
    """Entries that go with the wave: steps that resolve its period, speeds in the measure of its surface."""
    summary_of_stator = json.loads((pathlib.Path(folder) / "stator" / "summary.json").read_text())
    value = {q["name"]: q["value"] for q in reversed(summary_of_stator["quantities"])
             if q["name"] != "frequency" or q["family"] == "out-of-plane"}
    found = {}
    if "frequency" not in value:
        return found  # the wave is not among the modes: contact has to refuse
    if later["marches"]:
        steps = later["steps"]
        found.update({"Time/Time step": text(1. / (value["frequency"] * steps)),
                      "Time/Number of steps": str(steps), "Time/Average from step": str(steps // 2),
                      "Time/Average to step": str(steps)})
    if later["speeds"]:
        surface = (2. * math.pi * value["frequency"] * value["A_t/A_n"] * float(entries["Wave/Amplitude"]) /
                   float(entries["Stator/Tip outer radius"]))
        found["Loading/Values"] = ", ".join(text(share * surface) for share in later["speeds"])
    return found


# The power of length in the unit of an entry, of all entries of a section, or of one in its subsections.
LENGTHS = {"Stator": 1, "Stator/Target plate cross-section": 2, "Rotor": 1, "Rotor/Radial bar stiffness": -2,
           "Materials/Young modulus": -2, "Materials/Density": -4, "Wave/Amplitude": 1, "Friction/Decay velocity": 1,
           "Friction/Weakening length": 1, "Friction/Lining normal stiffness": -3,
           "Friction/Lining tangential stiffness": -3, "Contact/Normal penalty": -1, "Contact/Tangential penalty": -1,
           "Initial deformation/Amplitude": 1}
WORDS = ("solid", "shell", "none")  # values in these sections that are no numbers


def in_millimetres(entries, options):
    """The same motor in mm, N, s and therefore tonnes: its torques are in N mm."""
    changed = {**entries, "Motor/Unusual values": "accept"}
    for entry, value in {**entries_of(BASE, options.programs), **entries}.items():
        section, _, name = entry.rpartition("/")
        power = next((LENGTHS[key] for key in (entry, f"{section.partition('/')[0]}/{name}", section)
                      if key in LENGTHS), 0)
        if power and value not in WORDS:
            changed[entry] = f"{float(value) * 1e3 ** power:.15g}"
    return changed


def invariances(folder, entries, options):
    """What changes although it must not: list of texts."""
    millimetres, two_ranks, results = folder / "millimetres", folder / "two_ranks", ContactResults(folder)
    in_mm = in_millimetres(entries, options)
    row = run_program("stator", BASE, millimetres, in_mm, options)
    if row["outcome"] == "certified":
        row = run_contact(BASE, millimetres, in_mm, options, checks=False)
    shutil.copytree(folder / "stator", two_ranks / "stator")
    runs = (("in mm", row, millimetres, 1e-3),
            ("on two ranks", run_contact(BASE, two_ranks, entries, options, checks=False, n_ranks=2), two_ranks, 1.))
    found = []
    for what, row, other, torque_unit in runs:
        if row["outcome"] == "certified":
            found += [f"{what}: {text}" for text in disagreements(results, ContactResults(other), torque_unit)]
        elif "Time limit" not in row["message"]:
            found.append(f"{what}: {row['outcome']}: {row['message']}")
    return found


def run_motor(seed, folder, options):
    """Row of one motor, and its entries."""
    entries, later = draw(seed)
    entries["Accuracy/Time limit"] = f"{OWN_LIMIT * options.seconds:g}"
    row = run_program("stator", BASE, folder, entries, options)
    if row["outcome"] == "certified":
        entries.update(entries_by_wave(folder, entries, later))
        row = run_contact(BASE, folder, entries, options)
    if row["outcome"] == "certified" and options.invariances:
        if wrong := invariances(folder, entries, options):
            row.update(outcome="silent wrong", message="; ".join(wrong[:3]))
    return row, entries


def run_seed(seed, options):
    """The whole row of one motor."""
    with tempfile.TemporaryDirectory() as scratch:
        row, entries = run_motor(seed, pathlib.Path(options.keep or scratch) / str(seed), options)
    return {"seed": seed, **row, **{entry: entries.get(entry, "") for entry in SHOWN},
            "command": command_lines(BASE, f"output/random/{seed}", entries)}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seed", type=int, default=1, help="of the first motor")
    parser.add_argument("--count", type=int, default=200, help="of motors")
    parser.add_argument("--workers", type=int, default=1, help="motors that are computed at the same time")
    parser.add_argument("--invariances", action="store_true", help="also compute each in other units, on two ranks")
    add_options(parser, "random_motors.csv")
    options = parser.parse_args()

    print(f"motors {options.seed} to {options.seed + options.count - 1}, {options.seconds:g} s for each run", flush=True)
    file = RowFile(options.csv, ["seed", *COLUMNS, *SHOWN, "command"], options.resume)
    seeds = [seed for seed in range(options.seed, options.seed + options.count) if not file.find(seed=seed)]
    with concurrent.futures.ThreadPoolExecutor(options.workers) as pool:
        for done in concurrent.futures.as_completed([pool.submit(run_seed, seed, options) for seed in seeds]):
            row = done.result()
            file.add(row)
            print(f"{row['seed']}: {row['outcome']}, {row['program']}, {row['processor_seconds']} s", flush=True)
            if row["outcome"] != "certified":
                print(f"    {row['message']}\n    {row['command']}", flush=True)
    lines = summary(file.rows)
    print("\n" + "\n".join(lines))
    if options.markdown:
        write_markdown(options.markdown, lines)
    sys.exit(0 if is_acceptable(file.rows) else 1)


if __name__ == "__main__":
    main()
