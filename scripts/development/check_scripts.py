#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks that Python scripts do not depend on the surroundings of their user.

Usage: scripts/development/check_scripts.py [root of the project]
Prints file:line of each first line that is not #!/usr/bin/python3 -sE, of each script that is not executable and, in scripts/
and its folders, of each script that does not begin with the module surroundings, and of each text that is read or written
without its encoding; and then exits with 1.
"""
import ast
import os
import sys
from pathlib import Path

from source_check import run_check

FIRST_LINE = "#!/usr/bin/python3 -sE"
STANDING_ALONE = ("check_layers.py", "check_scripts.py", "parameters_doc.py", "source_check.py")  # for developers, of the standard library alone
TEXT_FUNCTIONS = ("open", "fdopen", "read_text", "write_text", "NamedTemporaryFile", "TemporaryFile")
PROCESSES = ("run", "Popen", "check_output")


def value_of(call, name, place):
    """A constant argument, by its name or place, if the call has it."""
    by_name = [keyword.value for keyword in call.keywords if keyword.arg == name]
    found = by_name or call.args[place:place + 1]
    return found[0].value if found and isinstance(found[0], ast.Constant) else None


def lacks_encoding(call):
    """Whether a call may read or write text in the encoding of the locale."""
    name = getattr(call.func, "attr", getattr(call.func, "id", ""))
    if any(keyword.arg == "encoding" for keyword in call.keywords):
        return False
    if name in PROCESSES:
        return any(keyword.arg in ("text", "universal_newlines") for keyword in call.keywords)
    if name not in TEXT_FUNCTIONS or ast.unparse(call.func) == "os.open":
        return False
    is_method = isinstance(call.func, ast.Attribute) and ast.unparse(call.func.value) not in ("io", "os", "tempfile", "codecs")
    mode = value_of(call, "mode", 0 if is_method or "Temporary" in name else 1) or ("w+b" if "Temporary" in name else "")
    return "b" not in mode


def begins_well(tree):
    """Whether all imports before the module surroundings are of the standard library."""
    for node in tree.body:
        names = [one.name for one in node.names] if isinstance(node, ast.Import) else [
            f"{node.module}.{one.name}" for one in node.names] if isinstance(node, ast.ImportFrom) else []
        if "running.surroundings" in names:
            return True
        if any(name.partition(".")[0] not in sys.stdlib_module_names for name in names):
            return False
    return False


def violations(root):
    for path in sorted(path for folder in ("scripts", "benchmarks", "tests") for path in (root / folder).rglob("*.py")):
        text, place = path.read_text(encoding="utf-8"), path.relative_to(root)
        is_script = text.startswith("#!")
        if is_script and text.splitlines()[0] != FIRST_LINE:
            yield f"{place}:1: a script begins with {FIRST_LINE}"
        if is_script and not os.access(path, os.X_OK):
            yield f"{place}:1: a script is executable"
        if not path.is_relative_to(root / "scripts"):
            continue
        tree = ast.parse(text)
        if is_script and path.name not in STANDING_ALONE and not begins_well(tree):
            yield f"{place}:1: the first import of a module that is not of the standard library is not that of surroundings"
        yield from (f"{place}:{node.lineno}: no encoding" for node in ast.walk(tree)
                    if isinstance(node, ast.Call) and lacks_encoding(node))


if __name__ == "__main__":
    run_check(violations, "scripts", "*.py")
