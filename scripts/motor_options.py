# SPDX-License-Identifier: LGPL-2.1-or-later
"""Options that all programs for many motors have."""
import argparse
import os
import pathlib

from case import CaseError
from many_motors import Family
from typed import problem_of_path
from variation import entry_and_value

ROOT = pathlib.Path(__file__).resolve().parent.parent
# Installed, the programs are not beside the sources.
PROGRAMS = ROOT / "build" / "bin" if (ROOT / "CMakeLists.txt").exists() else ROOT.parent.parent / "bin"


def motors_parser(documentation):
    """A parser with these options and a text of three parts: a sentence, the usage, the rest."""
    first, usage, rest = documentation.split("\n\n", 2)
    parser = argparse.ArgumentParser(description=first, usage=usage[7:], epilog=rest,
                                     formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("prm", metavar="FILE.prm")
    parser.add_argument("--set", action="append", default=[], metavar="'Section/Entry = value'", dest="settings",
                        help="an entry for all motors")
    parser.add_argument("--seed", type=int, default=1, help="of a sample or a search")
    parser.add_argument("--workers", type=int, default=os.cpu_count(), metavar="N",
                        help="motors at the same time on this machine, by default as many as it has cores")
    parser.add_argument("--scheduler", metavar="ADDRESS", help="of a Dask scheduler with workers of its own")
    parser.add_argument("--output", metavar="DIR")
    parser.add_argument("--programs", metavar="DIR", default=PROGRAMS, help="where stator, contact and losses are")
    return parser


def family_of(options, kind, **settings):
    """The motors of the parameter file, in output/FILE_kind if no folder is given; with settings of the program's own."""
    if options.output and (problem := problem_of_path(options.output)):
        raise CaseError(f'--output "{options.output}" {problem}')
    options.output = options.output or f"output/{pathlib.Path(options.prm).stem}_{kind}"
    given = dict(entry_and_value("--set", text) for text in options.settings)
    return Family(options.prm, {**given, **settings}, options.output, options.programs)
