#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""What accuracy costs in the program stator: whole runs on the reference motor, timed from outside.

usage: benchmarks/stator_cost.py [--repeat 3] [--quick | --fixed | --thin-parts] [--markdown FILE]

Each case is run `--repeat` times in a folder of its own that is removed afterwards; the table quotes
medians. "whole" is the wall clock of the process, "modes" the time it gives itself for all passes (what
is left when start-up of the libraries and output are taken off), "memory" its largest resident set.
"""
import argparse
import json
import pathlib
import statistics
import sys
import tempfile

sys.dont_write_bytecode = True
from motor_run import write_markdown  # noqa: E402
from timed_run import program, timed_run  # noqa: E402

# Frequency of the motor's wave: what our own meshes converge to from above (30 001.68 Hz computed with
# elements of degree 6 and 99 579 degrees of freedom); against_calculix.py finds the same with CalculiX.
CONVERGED = 30001.6

ADAPTIVE = [("n = 7, target 1e-2", {"Accuracy/Target": "1e-2"}, 1),
            ("n = 7, target 1e-3", {"Accuracy/Target": "1e-3"}, 1),
            ("n = 7, target 3e-4", {"Accuracy/Target": "3e-4"}, 1),
            ("n = 7, target 1e-4", {"Accuracy/Target": "1e-4"}, 1),
            ("n = 7, target 1e-4, 2 ranks", {"Accuracy/Target": "1e-4"}, 2),
            ("n = 0-12, target 2.5e-4", {"Accuracy/Target": "2.5e-4", "Modes/Nodal diameters": "0-12"}, 1)]
FIXED = [(f"degree {degree}, refinement {level}",
          {"Accuracy/Mode": "fixed", "Accuracy/Polynomial degree": str(degree),
           "Accuracy/Refinement": str(level)}, 1)
         for degree in (2, 3, 4) for level in range(5) if not (degree == 4 and level > 3)]


# Thin parts in solid cells or as shells. There is no converged value to compare a shell with: it is
# another model, and what both converge to differs a little.
THIN = [(f"{part} {kind}, target {target}",
         {**entries, entry: kind, "Accuracy/Target": target}, 1)
        for part, entries, entry in (("flange", {"Modes/Body": "rotor"}, "Rotor/Flange element"),
                                     ("ceramic ring", {}, "Stator/Piezoceramic element"))
        for target in ("1e-3", "1e-4") for kind in ("solid", "shell")]
THIN += [("rotor without bars, n = 0-3 and 7, target 1e-3",
          {"Modes/Body": "rotor", "Rotor/Radial bar stiffness": "0", "Modes/Nodal diameters": "0-3, 7",
           "Accuracy/Target": "1e-3"}, 1)]


def run_once(entries, n_ranks):
    """One run; returns wall seconds, largest resident set in MB and the summary."""
    with tempfile.TemporaryDirectory() as folder:
        seconds, memory = timed_run("stator", folder, {"Output/VTU": "false", **entries}, n_ranks)
        body = entries.get("Modes/Body", "stator")
        summary = json.loads((pathlib.Path(folder) / body / "summary.json").read_text())
    return seconds, summary["peak_memory_MB"] if n_ranks > 1 else memory, summary


def measure(name, entries, n_ranks, repeat, converged):
    """A row of the table; with the true error if the converged frequency is known."""
    runs = [run_once(entries, n_ranks) for _ in range(repeat)]
    summary = runs[-1][2]
    wave = next(q for q in summary["quantities"]
                if q["name"] == "frequency" and q["n"] == 7 and q["family"] == "out-of-plane")
    modes = [sum(s for phase, s in run[2]["seconds"].items() if phase.startswith("modes")) for run in runs]
    row = [name, f"{summary['dofs']}", f"{statistics.median(r[0] for r in runs):.2f}",
           f"{statistics.median(modes):.2f}", f"{max(r[1] for r in runs):.0f}",
           f"{wave['value']:.2f}", f"{wave['error'] / wave['value']:.1e}"]
    return row + ([f"{abs(wave['value'] / converged - 1):.1e}"] if converged else [])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--quick", action="store_true", help="only the adaptive runs")
    parser.add_argument("--fixed", action="store_true", help="only those of a fixed discretisation")
    parser.add_argument("--thin-parts", action="store_true",
                        help="flange and ceramic ring in solid cells and as shells")
    parser.add_argument("--markdown", help="also write the tables to this file")
    options = parser.parse_args()
    program("stator")

    cases, converged = (THIN, None) if options.thin_parts else (ADAPTIVE, CONVERGED)
    if not (options.thin_parts or options.quick):
        cases = FIXED if options.fixed else ADAPTIVE + FIXED
    header = ["case", "dofs", "whole s", "modes s", "memory MB", "f(n = 7) Hz", "printed error"]
    header += ["true error"] if converged else []
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    print("\n".join(lines), flush=True)
    for case in cases:
        lines.append("| " + " | ".join(measure(*case, options.repeat, converged)) + " |")
        print(lines[-1], flush=True)
    if options.markdown:
        write_markdown(options.markdown, lines)


if __name__ == "__main__":
    main()
