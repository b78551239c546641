# SPDX-License-Identifier: LGPL-2.1-or-later
"""Options that all programs for many motors have."""
import argparse
import os
import pathlib

from motors.many_motors import Family
from motors.variation import entry_and_value
from running.programs import PROGRAMS, CaseError
from running.typed import problem_of_path


class Parser(argparse.ArgumentParser):
    """Mistakes are told in one line, as everywhere."""

    def error(self, message):
        raise CaseError(f"{message}; --help tells more")


def at_least(least):
    """The type of an option that is a whole number."""
    def read(text):
        try:
            number = int(text)
        except ValueError:
            number = least - 1
        if number < least:
            raise argparse.ArgumentTypeError(f'expected a whole number, at least {least}, found "{text}"')
        return number
    return read


def motors_parser(documentation):
    """A parser with these options and a text of three parts: a sentence, the usage, the rest."""
    first, usage, rest = documentation.split("\n\n", 2)
    parser = Parser(description=first, usage=usage[7:], epilog=rest,
                    formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("prm", metavar="FILE.prm")
    parser.add_argument("--set", action="append", default=[], metavar="'Section/Entry = value'", dest="settings",
                        help="an entry for all motors")
    parser.add_argument("--seed", type=at_least(0), default=1, help="of a sample or a search")
    parser.add_argument("--workers", type=at_least(1), default=os.cpu_count(), metavar="N",
                        help="motors at the same time on this machine, by default as many as it has cores")
    parser.add_argument("--scheduler", metavar="ADDRESS", help="of a Dask scheduler with workers of its own")
    parser.add_argument("--output", metavar="DIR")
    parser.add_argument("--programs", metavar="DIR", default=PROGRAMS, help="where stator, contact, losses and motor are")
    return parser


def family_of(options, kind, is_wave_only=False, **settings):
    """The motors of the parameter file, in output/FILE_kind if no folder is given; with settings of the program's own."""
    if options.output and (problem := problem_of_path(options.output)):
        raise CaseError(f'--output "{options.output}" {problem}')
    options.output = options.output or f"output/{pathlib.Path(options.prm).stem}_{kind}"
    given = dict(entry_and_value("--set", text) for text in options.settings)
    return Family(options.prm, {**given, **settings}, options.output, options.programs, is_wave_only)
