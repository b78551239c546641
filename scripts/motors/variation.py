# SPDX-License-Identifier: LGPL-2.1-or-later
"""Entries of a parameter file that vary: what the options of sweep.py say, and the motors that follow from them."""
import itertools
import math
import re
from dataclasses import dataclass

from results.case import CaseError
from running.typed import problem_of_list, problem_of_number
from scipy.stats import qmc


@dataclass(frozen=True)
class Varied:
    """An entry with its values as texts, or with the two ends of a range of numbers, from which values are drawn."""

    entry: str
    values: tuple = ()
    low: float = math.nan
    high: float = math.nan
    is_logarithmic: bool = False

    def at(self, share):
        """The value, as a text, at a share of the range, 0 to 1."""
        if self.is_logarithmic:
            return number_text(self.low * (self.high / self.low) ** share)
        return number_text(self.low + (self.high - self.low) * share)

    def share_of(self, value):
        """The inverse of at()."""
        if self.is_logarithmic:
            return math.log(float(value) / self.low) / math.log(self.high / self.low)
        return (float(value) - self.low) / (self.high - self.low)


def number_text(number):
    """Eight digits: more than any dimension has, and easy to type again."""
    return f"{number:.8g}"


def entry_and_value(option, text):
    """'Section/Entry = value' in two."""
    entry, equals, value = text.partition("=")
    entry, value = entry.strip(), value.strip()
    if not equals or "/" not in entry or not value:
        raise CaseError(f'{option} "{text}": expected "Section/Entry = value"')
    return entry, value


def number_of(option, text, word):
    if problem := problem_of_number(word.strip()):
        raise CaseError(f'{option} "{text}": "{word.strip()}" {problem}')
    return float(word)


def ranged(option, text):
    """'Section/Entry = low:high', with ':log' behind it if equal ratios count, not equal differences."""
    entry, value = entry_and_value(option, text)
    words = value.split(":")
    is_logarithmic = words[-1].strip() == "log"
    ends = [number_of(option, text, word) for word in (words[:-1] if is_logarithmic else words)]
    if len(ends) != 2 or not ends[0] < ends[1] or (is_logarithmic and ends[0] <= 0):
        raise CaseError(f'{option} "{text}": expected a range "low:high" of increasing numbers, or "low:high:log" of '
                        "positive ones")
    return Varied(entry, (), *ends, is_logarithmic)


def varied(option, text):
    """'Section/Entry = 1, 2, 3' or '= low:high:count', with ':log' behind it for equal ratios."""
    entry, value = entry_and_value(option, text)
    found = re.fullmatch(r"(.*):\s*(\d+)\s*(:\s*log\s*)?", value)
    if found and ":" in found[1]:
        count = int(found[2])
        if count < 2:
            raise CaseError(f'{option} "{text}": a range needs at least 2 values')
        whole = ranged(option, f"{entry} = {found[1]}{':log' if found[3] else ''}")
        return Varied(entry, tuple(whole.at(k / (count - 1)) for k in range(count)), whole.low, whole.high,
                      whole.is_logarithmic)
    if ":" in value and "/" not in value:
        return ranged(option, text)
    if problem := problem_of_list(value):
        raise CaseError(f'{option} "{text}" {problem}')
    return Varied(entry, tuple(word.strip() for word in value.split(",")))


def combinations(all_varied):
    """Each value of each entry with each of the others: list of dict entry -> text."""
    for one in all_varied:
        if not one.values:
            raise CaseError(f'--vary "{one.entry}" has a range without a number of values: add one, as in low:high:11, '
                            "or draw a sample with --sample lhs=200")
    return [dict(zip([one.entry for one in all_varied], values))
            for values in itertools.product(*(one.values for one in all_varied))]


def latin_hypercube(all_varied, count, seed):
    """A sample in which each of `count` equal parts of each range has one value; lists of values are used evenly."""
    shares = qmc.LatinHypercube(len(all_varied), seed=seed).random(count)
    return [{one.entry: one.values[int(share * len(one.values))] if math.isnan(one.low) else one.at(share)
             for one, share in zip(all_varied, row)} for row in shares]
