# SPDX-License-Identifier: LGPL-2.1-or-later
"""Numbers, lists and paths as users type them and spreadsheets write them: what is wrong with those that are none, as the end
of a sentence about the text. The programs say the same of parameter files. Of the standard library alone."""
import math
import re
import unicodedata

NUMBER = re.compile(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?", re.ASCII)
QUOTES = "\"'\u2018\u2019\u201A\u201C\u201D\u201E\u00AB\u00BB"


def foreign_character(text):
    """The first one outside ASCII, such as a no-break space or a minus sign that is no hyphen; empty if there is none."""
    for one in text:
        if not one.isascii():
            return f"has U+{ord(one):04X}, {unicodedata.name(one, 'a control character').lower()}; type plain characters"
    return ""


def problem_of_number(text):
    """Empty if the text is a finite number."""
    if not text:
        return "is empty; write a number"
    if NUMBER.fullmatch(text):
        return "" if math.isfinite(float(text)) else "is not finite"
    if re.search(r"[0-9],[0-9]", text):
        return "has a decimal comma; write a decimal point and no separators of thousands"
    if found := re.fullmatch(r"[-+]?[\d.]+(\s*[dDeEqQ]\s*[-+]?\s*\d*)", text, re.ASCII):
        return f'has the exponent "{found[1].strip()}"; write exponents as in 1.41e11'
    if text.lower().lstrip("+-") in ("nan", "inf", "infinity"):
        return "is not finite"
    return foreign_character(text) or "is not a number"


def problem_of_list(text):
    """Why values between commas may have decimal commas, or are not between commas; empty if not so."""
    if re.search(r"[0-9],[0-9]", text):
        return "has a comma between digits; write a decimal point, no separators of thousands, and a blank after each comma of " \
               "a list"
    if re.search(r"(^|,)\s*[-+]?0[0-9]", text):
        return "has a number with a leading zero, as behind a decimal comma; write a decimal point"
    return "has a semicolon; separate values by commas" if ";" in text else ""


def problem_of_path(text):
    """Why a text is refused as a path although a file could be called so; empty if it is not."""
    if text.startswith("~"):
        return "begins with ~, which only a shell replaces; write the whole path of the home folder"
    if "$" in text or "`" in text:
        return "has a $ or `, which only a shell replaces; write out what it stands for"
    if text and (text[0] in QUOTES or text[-1] in QUOTES):
        return "has quotes around it; leave them out"
    return "has a backslash; separate folders by /" if "\\" in text else ""
