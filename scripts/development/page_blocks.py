# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts of pages that a run makes: how they are marked, and how their numbers are compared."""
import hashlib
import re

# <!-- cheap: COMMAND -->  or  <!-- dear: COMMAND -->
#                       what the command prints
# <!-- made 2026-11-27 by 4be78b1, of 0123456789ab, as 0123456789ab -->
MARKED = re.compile(r"<!-- (?P<price>cheap|dear): (?P<command>.+?) -->\n(?P<text>.*?)"
                    r"<!-- made (?P<date>\S+) by (?P<revision>\S+), of (?P<inputs>\w+), as (?P<content>\w+) -->", re.S)
IMAGE = re.compile(r"!\[[^\]]*\]\(([^)]+\.png)\)")
NUMBER = re.compile(r"(?<![\w.])[-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")
BAR = re.compile(r"\s*(?:\+-|±)\s*$")
# Times and amounts of memory, which differ from machine to machine.
OF_THE_MACHINE = re.compile(NUMBER.pattern + r"(?=\s*(?:s|MB|GB)\b)")
RELATIVE = 0.03  # admissible difference of a number without error bar


def digest(*parts):
    """Twelve hexadecimal digits that stand for texts or bytes."""
    sums = hashlib.sha256()
    for part in parts:
        data = part if isinstance(part, bytes) else part.encode()
        sums.update(len(data).to_bytes(8, "big") + data)
    return sums.hexdigest()[:12]


class Block:
    """A marked part of a page."""

    def __init__(self, page, found):
        self.page = page
        self.price, self.command, self.text, self.date, self.revision, self.inputs, self.content = found.groups()
        self.span = found.span()

    @property
    def place(self):
        line = self.page.read_text(encoding="utf-8")[:self.span[0]].count("\n") + 1
        return f"{self.page.name}:{line}"

    @property
    def images(self):
        return [(self.page.parent / image).resolve() for image in IMAGE.findall(self.text)]

    def content_now(self):
        """What stands for the text and its figures."""
        return digest(self.text.strip(), *[path.read_bytes() if path.exists() else b"" for path in self.images])

    def marked(self, text, date, revision, inputs):
        """The block with a new text, stamped."""
        self.text = f"\n{text.strip()}\n\n"
        return (f"<!-- {self.price}: {self.command} -->\n{self.text}"
                f"<!-- made {date} by {revision}, of {inputs}, as {self.content_now()} -->")


def blocks_of(page):
    return [Block(page, found) for found in MARKED.finditer(page.read_text(encoding="utf-8"))]


def split_numbers(text):
    """The words between numbers, and the numbers as (value, place of the last digit, error bar or None)."""
    words, numbers, end = [], [], 0
    text = OF_THE_MACHINE.sub("", text)
    for found in NUMBER.finditer(text):
        between = text[end:found.start()]
        value = float(found.group())
        decimals = len(found.group().partition("e")[0].partition(".")[2])
        if BAR.search(between) and numbers:
            numbers[-1] = (*numbers[-1][:2], abs(value))
        else:
            numbers.append((value, 10.**-decimals, None))
        words.append(" ".join(re.sub(r"-{3,}|[|]", " ", between).split()))
        end = found.end()
    return words + [" ".join(text[end:].split())], numbers


def difference(old, new):
    """How two texts differ by more than the error bars of their numbers; "" if they do not."""
    (old_words, old_numbers), (new_words, new_numbers) = split_numbers(old), split_numbers(new)
    if len(old_words) != len(new_words):
        return f"{len(old_words) - 1} numbers in the page, {len(new_words) - 1} now"
    for before, after in zip(old_words, new_words):
        if before != after:
            return f"the words are '{before}' in the page, '{after}' now"
    for (before, place, bar), (after, _, other) in zip(old_numbers, new_numbers):
        allowed = bar + other if bar is not None else max(2.1 * place, RELATIVE * abs(after))
        if abs(before - after) > allowed:
            return f"{before:g} in the page, {after:g} now, more than {allowed:g} apart"
        if bar is not None and (bar > 2. * other + place or other > 2. * bar + place):
            return f"the error bar of {before:g} is {bar:g} in the page, {other:g} now"
    return ""
