#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What each effect says it changes, what it changes, and what it costs, on two motors.

usage: benchmarks/effects.py [FILE.prm ...] [--markdown FILE]

Each effect of the contact alone against none of those that are off in the paper: speeds at no load and at half of the
stall torque, on interface mesh 0 with four moments. The indicator is that of the run that leaves the effect out (of
inertia: of one that has to choose). Effects of the stator: the frequency of the wave, elements of degree 3.
"""
import argparse
import json
import pathlib
import sys
import tempfile

sys.dont_write_bytecode = True
from motor_run import OUTPUT_OFF, certified_run, operating_points, table, write_markdown  # noqa: E402
from timed_run import PAPERS_MODEL as OFF, ROOT  # noqa: E402

MOTORS = [ROOT / "prm" / name for name in ("soft_spring.prm", "stiff_spring.prm")]
OF_CONTACT = {"Rotor inertia": {"Effects/Rotor inertia": "on", "Effects/Damping": "on"},
              "Damping (with inertia)": {"Effects/Rotor inertia": "on", "Effects/Damping": "on"},
              "Tooth inertia": {"Effects/Tooth inertia": "on"},
              "Tooth vibration": {"Effects/Tooth inertia": "on", "Effects/Tooth vibration": "on"},
              "Stator back-reaction": {"Effects/Stator back-reaction": "on"},
              "Static friction excess": {}, "Tooth shear": {}}
WITHOUT = {"Tooth vibration": {"Effects/Tooth inertia": "on"},
           "Damping (with inertia)": {"Effects/Rotor inertia": "on", "Effects/Damping": "off"},
           "Static friction excess": {"Effects/Static friction excess": "off"},
           "Tooth shear": {"Effects/Tooth shear": "off"}}
FIXED = {**OUTPUT_OFF, **OFF, "Accuracy/Mode": "fixed", "Accuracy/Interface refinement": "0", "Time/Snapshots": "4"}


def summary_of(name, folder):
    return json.loads((folder / name / "summary.json").read_text())


def speeds(motor, folder, entries, torques):
    rows, done = operating_points(motor, folder, {
        **FIXED, "Loading/Values": ", ".join(f"{torque:.6g}" for torque in torques), **entries})
    return [row["speed_rpm"] for row in rows], summary_of("contact", folder), done


def indicator(summary, effect):
    value = next(row["indicator"] for row in summary["effects"] if row["name"] == effect)
    return "" if value is None else f"{100 * value:.2g}"


def rows_of_contact(motor, folder):
    certified_run("stator", motor, folder, {**OUTPUT_OFF, **OFF, "Accuracy/Target": "1e-3"})
    (at_rest,), _ = operating_points(motor, folder, {**FIXED, "Loading/Control": "speed", "Loading/Values": "0"})
    stall = 1e-3 * at_rest["torque_mNm"]
    torques = [0., 0.5 * stall]
    base = speeds(motor, folder, {}, torques)
    for name, entries in OF_CONTACT.items():
        try:
            with_it = speeds(motor, folder, entries, torques)
        except RuntimeError:
            yield [motor.stem, name, indicator(base[1], name), "not certified with these steps", "", "", ""]
            continue
        without = speeds(motor, folder, WITHOUT[name], torques) if name in WITHOUT else base
        change = max(abs(a - b) for a, b in zip(with_it[0], without[0])) / base[0][0]
        if name == "Rotor inertia":
            certified_run("contact", motor, folder, {**FIXED, "Accuracy/Contact target": "0.5", "Loading/Values": "0",
                                                     "Effects/Rotor inertia": "auto"})
            says = indicator(summary_of("contact", folder), name)
        else:
            says = "" if "(" in name else indicator(without[1], name)
        cost = [row for row in with_it[1]["effects"] if row["name"] == name]
        yield [motor.stem, name, says, f"{100 * change:.2g}",
               f"{with_it[2].processor_seconds - without[2].processor_seconds:+.1f}",
               str(cost[0]["dofs"] if cost else 0), f"{(cost[0]['bytes'] if cost else 0) / 1e6:.2g}"]


def rows_of_stator(motor, folder):
    fixed = {**OUTPUT_OFF, **OFF, "Accuracy/Mode": "fixed", "Accuracy/Polynomial degree": "3",
             "Accuracy/Refinement": "1"}

    def frequency(entries):
        done = certified_run("stator", motor, folder, {**fixed, **entries})
        summary = summary_of("stator", folder)
        return next(q["value"] for q in summary["quantities"] if q["name"] == "frequency"), summary, done
    base = frequency({})
    for name in ("Target plates", "Felt support"):
        with_it = frequency({f"Effects/{name}": "on"})
        yield [motor.stem, name, indicator(base[1], name), f"{100 * (with_it[0] / base[0] - 1):.2g}",
               f"{with_it[2].processor_seconds - base[2].processor_seconds:+.1f}", "0", "0"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("motors", nargs="*", type=pathlib.Path, default=MOTORS, metavar="FILE.prm")
    parser.add_argument("--markdown", type=pathlib.Path, help="also write the tables to this file")
    options = parser.parse_args()
    rows = []
    for motor in options.motors or MOTORS:
        with tempfile.TemporaryDirectory() as scratch:
            for rows_of in (rows_of_contact, rows_of_stator):
                for row in rows_of(motor, pathlib.Path(scratch)):
                    rows.append(row)
                    print(" | ".join(row), flush=True)
    lines = table(["motor", "effect", "indicator, %", "change, %", "seconds", "modes", "MB"], rows)
    print("\n".join(lines))
    if options.markdown:
        write_markdown(options.markdown, lines)


if __name__ == "__main__":
    main()
