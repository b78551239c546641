# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws random motors from seeds: of any dimensions with a static rotor, or variations of the examples in prm/."""
import math
import random

from motor_run import OUTPUT_OFF
from timed_run import PAPERS_MODEL, ROOT

STATIC_ROTOR = ROOT / "tests" / "programs" / "static_rotor.prm"
EXAMPLES = tuple(ROOT / "prm" / f"{name}.prm" for name in
                 ("canon_ring", "ring60", "disc60", "soft_spring", "stiff_spring", "static_rotor"))


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


def draw_law(dice):
    return dice.pick("coulomb", "static-dynamic", "velocity", "slip-weakening")


def draw_coefficients(dice, dynamic, largest_ratio):
    """Entries of any law of friction. @param largest_ratio of the static to the dynamic coefficient"""
    return {"Friction/Dynamic coefficient": text(dynamic),
            "Friction/Static coefficient": text(dynamic * dice.uniform(1., largest_ratio)),
            "Friction/Decay velocity": text(dice.log_uniform(0.01, 1.)),
            "Friction/Weakening length": text(dice.log_uniform(1e-8, 1e-6))}


def draw_warp(dice):
    return {"Initial deformation/Amplitude": text(dice.log_uniform(1e-7, 1e-5)),
            "Initial deformation/Number of waves": str(dice.integer(0, 4))}


def draw_friction(dice):
    entries = {"Friction/Law": draw_law(dice), **draw_coefficients(dice, dice.log_uniform(0.05, 0.8), 1.5)}
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
        entries.update(draw_warp(dice))
    marches = is_warped or dice.chance(0.1)
    entries["Time/Scheme"] = dice.pick("auto", "marching") if is_warped else (
        "marching" if marches else dice.pick("auto", "steady"))
    if marches:  # its first steps are start-up, and hardly known better
        entries["Accuracy/Contact target"] = "0.3"
    later = {"steps": dice.pick(30, 60), "marches": marches, "speeds": None}
    if entries["Loading/Control"] == "speed" and dice.chance(0.5):
        later["speeds"] = [dice.uniform(-0.2, 0.5), dice.uniform(0.5, 1.3)]
    return entries, later


def draw_motor(seed):
    """A motor of any dimensions: the file it varies, its entries, and what entries_by_wave() needs."""
    dice = Dice(seed)
    stator, *lengths = draw_stator(dice)
    scene, later = draw_scene(dice)
    entries = {**stator, **draw_rotor(dice, *lengths), **draw_materials(dice), **draw_friction(dice), **scene}
    return STATIC_ROTOR, {**entries, **OUTPUT_OFF}, later


def draw_example(seed, values_of):
    """A variation of an example, with its effects, scheme and discretisation on "auto". @param values_of gives the
    entries of a file."""
    dice = Dice(seed)
    base = dice.pick(*EXAMPLES)
    values = values_of(base)

    def number(entry):
        return float(values.get(entry, 0.))  # a section of a mesh has no such dimensions
    entries = {entry: text(number(entry) * dice.uniform(*factors)) for entry, factors in (
        ("Materials/Stator metal/Young modulus", (0.8, 1.25)), ("Materials/Rotor metal/Young modulus", (0.7, 1.4)),
        ("Materials/Rotor metal/Density", (0.7, 1.4)), ("Rotor/Flange thickness", (0.75, 1.)),
        ("Rotor/Radial bar stiffness", (0.5, 2.)))
        if number(entry) > 0.}
    # As in the file, whatever benchmarks choose for it.
    entries.update({entry: values[entry] for entry in PAPERS_MODEL})
    dynamic = dice.log_uniform(0.05, 0.5)
    entries.update({"Friction/Law": draw_law(dice), **draw_coefficients(dice, dynamic, 1.4),
                    "Loading/Preload": text(dice.log_uniform(0.5, 150.)),
                    "Wave/Amplitude": text(dice.log_uniform(0.2e-6, 4e-6)),
                    "Loading/Number of curve points": dice.pick("3", "5", "11"),
                    "Accuracy/Contact target": "0.1"})
    if dice.chance(0.2):
        entries.update(draw_warp(dice))
    return base, {**entries, **OUTPUT_OFF}, {"marches": False, "speeds": None}
