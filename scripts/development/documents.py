#!/usr/bin/python3 -sE
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes and checks those parts of the pages that come from a run: printed lines, tables and figures.

Usage: scripts/development/documents.py --list | --check | --write [--dear] [PAGE ...] [--only TEXT] [--programs FOLDER]

Such a part stands between two comments in its page (page_blocks.py):

  <!-- cheap: COMMAND -->
  ...
  <!-- made DATE by REVISION, of INPUTS, as CONTENT -->

COMMAND runs in a shell in the root of the project. Its output becomes the part, or what it writes to the file $TABLE. A part
that is a figure keeps its text; its command writes $IMAGES/NAME.png. These words are available in it:

  motor FILE.prm [OPTIONS]    runs the program, once for all parts, and prints what it says, without the times in front
  case_of FILE.prm [OPTIONS]  does the same and prints the folder of the results
  figure NAME[:AS] FOLDER...  draws the figures of a folder of results, with others, and takes NAME as the image AS
  fenced                      puts what it reads between two lines of ```

INPUTS stands for what a part depends on: the parameters of all motors that its command and the script in it name (as the
programs read them: comments do not matter), the script, and for a dear part the values in the tables of operating points in
doc/walk.md, to two digits: a dear part that shows error bars has to be asked for (--only) where only these change.
CONTENT stands for the part itself, and its figures.

--check runs the cheap commands again and compares their numbers with the page within the error bars; of each part it checks
that nobody has changed it by hand, and that it was made after the last change of its inputs. The exit status is 1 if not.
--write makes those cheap parts again that --check would complain of, with --dear those of the others, too. A part that agrees
with its page within the error bars stays as it is. --only: parts whose command has this text; --write makes these again in any
case.
"""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from running import surroundings  # noqa: E402, F401  (first: see there)
import argparse
import ast
import datetime
import json
import os
import re
import subprocess
import tempfile

from page_blocks import blocks_of, difference, digest, split_numbers
from parameters_doc import entries_of
from running.programs import PROGRAMS, ROOT, CaseError, described

PAGES = [ROOT / "README.md", *sorted((ROOT / "doc").glob("*.md")), ROOT / "meshes" / "README.md"]
REFERENCE = ROOT / "doc" / "walk.md"  # the values in its tables tell whether results have changed
SHELL = r"""set -euo pipefail
case_of() {
  local folder; folder=$CASES/$(printf '%s\0' "$@" | md5sum | cut -c 1-12)
  if [[ ! -e $folder/said ]]; then
    mkdir -p "$folder"
    "$PROGRAMS/motor" "$@" --output "$folder" > "$folder/says" 2> "$folder/errors" || { cat "$folder/errors" >&2; return 1; }
    sed 's/^\[ *[0-9.]* s\] //' "$folder/says" > "$folder/said"
  fi
  echo "$folder"
}
motor() { cat "$(case_of "$@")/said"; }
figure() {
  local name=${1%%:*} as=${1##*:}
  scripts/figures.py "${@:2}" > /dev/null
  cp "$2/figures/$name.png" "$IMAGES/$as.png"
}
fenced() { echo '```'; cat; echo '```'; }
"""


def without_comments(path):
    """A Python script as far as it matters for what it computes."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    for node in ast.walk(tree):
        body = getattr(node, "body", None)
        if isinstance(body, list) and body and isinstance(body[0], ast.Expr) and isinstance(body[0].value, ast.Constant):
            body[0].value.value = ""
    return ast.dump(tree)


class Documents:
    def __init__(self, programs, cases):
        self.programs, self.cases, self.identities = pathlib.Path(programs), pathlib.Path(cases), {}
        self.defaults = {}

    def identity(self, prm):
        """Of a motor: its entries that are not the defaults, without those that name things."""
        if not self.defaults:
            declared = subprocess.run([self.programs / "stator", "--help=json"], check=True, capture_output=True).stdout
            self.defaults = {f"{section}/{name}": default for section, name, default, _ in entries_of(json.loads(declared))}
        if prm not in self.identities:
            entries = described(self.programs / "stator", ROOT / prm)["entries"]
            self.identities[prm] = repr([(entry, text.replace(f"{ROOT}/", "")) for entry, text in entries.items()
                                         if text != self.defaults[entry] and not entry.startswith(("Output/", "Motor/Name"))])
        return self.identities[prm]

    def inputs_of(self, block):
        scripts = [ROOT / name for name in re.findall(r"(?:scripts|benchmarks|tests)/[\w/]+\.py", block.command)]
        texts = [path.read_text(encoding="utf-8") for path in scripts]
        named = re.findall(r"\b(\w+\.prm)\b", " ".join([block.command, *texts]))
        motors = sorted({f"prm/{name}" for name in named if (ROOT / "prm" / name).exists()} or {"prm/soft_spring.prm"})
        parts = [block.command, *map(without_comments, scripts), *map(self.identity, motors)]
        if block.price == "dear":
            parts += [f"{value:.2g}" for one in blocks_of(REFERENCE) if "document_tables.py points" in one.command
                      for value, *_ in split_numbers(one.text)[1]]
        return digest(*parts)

    def made(self, block):
        """What the command of a block prints or writes. @throws CaseError"""
        with tempfile.TemporaryDirectory() as folder:
            table = pathlib.Path(folder) / "table.md"
            done = subprocess.run(["bash", "-c", SHELL + block.command], cwd=ROOT, capture_output=True, encoding="utf-8",
                                  env={**os.environ, "PROGRAMS": str(self.programs), "CASES": str(self.cases),
                                       "TABLE": str(table), "IMAGES": str(ROOT / "doc" / "images")})
            if done.returncode != 0:
                raise CaseError(f"{block.place}: the command ended with status {done.returncode}: "
                                f"{done.stderr.strip().splitlines()[-1:] or ['no message']}")
            if block.images:
                return block.text
            return table.read_text(encoding="utf-8") if table.exists() else done.stdout

    def problems(self, block):
        """What is wrong with a block, apart from its numbers."""
        if block.content != block.content_now():
            yield "was changed by hand"
        if block.inputs != self.inputs_of(block):
            yield "was made before the last change of what it depends on"

    def check(self, block):
        """What is wrong with a block, and the text that it has to have, if its command has run for that."""
        found, text = list(self.problems(block)), None
        if block.price == "cheap" and not block.images:
            text = self.made(block)
            apart = difference(block.text, text)
            found += [apart] if apart else []
        return found, text

    def written(self, block, text, in_any_case=False):
        """The block as it has to be in its page, with a text that its command has made; unless asked for in any case, its own
        where both agree and are made of the same: beyond that, what agrees within error bars may still be that of another
        motor."""
        is_same = not in_any_case and block.content == block.content_now() and block.inputs == self.inputs_of(block)
        if is_same and not difference(block.text, text):
            text = block.text
        revision = subprocess.run(["git", "-C", ROOT, "rev-parse", "--short=7", "HEAD"], capture_output=True, check=True,
                                  encoding="utf-8").stdout.strip()
        return block.marked(text, datetime.date.today().isoformat(), revision, self.inputs_of(block))


def write_page(documents, page, wanted, in_any_case):
    """Writes those wanted blocks again that are wrong, or all of them; the page is read again for each, as they change places."""
    for number in range(len(blocks_of(page))):
        block = blocks_of(page)[number]
        if not wanted(block):
            continue
        wrong, made = documents.check(block)
        if not wrong and not in_any_case:
            continue
        print(f"{block.place}: {block.command}", flush=True)
        new = documents.written(block, made or documents.made(block), in_any_case)
        text = page.read_text(encoding="utf-8")
        page.write_text(text[:block.span[0]] + new + text[block.span[1]:], encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0], usage=__doc__.split("Usage: ")[1].split("\n")[0])
    task = parser.add_mutually_exclusive_group(required=True)
    for name in ("list", "check", "write"):
        task.add_argument(f"--{name}", action="store_true")
    parser.add_argument("--dear", action="store_true")
    parser.add_argument("--only", default="")
    parser.add_argument("--programs", default=PROGRAMS)
    parser.add_argument("pages", nargs="*", type=pathlib.Path)
    options = parser.parse_args()
    pages = [page.resolve() for page in options.pages] or PAGES
    for page in pages:
        if not page.exists():
            raise CaseError(f"there is no page {page}; the pages are in {ROOT / 'doc'}")

    def wanted(block):
        return options.only in block.command and (options.check or options.dear or block.price == "cheap")

    n_wrong = 0
    with tempfile.TemporaryDirectory() as cases:
        documents = Documents(options.programs, cases)
        for page in pages:
            if options.write:
                write_page(documents, page, wanted, in_any_case=bool(options.only))
                continue
            for block in blocks_of(page):
                wrong = documents.check(block)[0] if options.check and wanted(block) else []
                n_wrong += len(wrong)
                for line in [f"{block.place}: {problem}" for problem in wrong] or [f"{block.place}: {block.price}"]:
                    print(f"{line}; made {block.date} by {block.revision}; {block.command}", flush=True)
    return 1 if n_wrong else 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except CaseError as error:
        sys.exit(str(error))
