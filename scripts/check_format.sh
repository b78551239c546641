#!/usr/bin/env bash
# Fails if a source file is not formatted as .clang-format says. Repair: clang-format-14 -i FILE...
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
find include source tests benchmarks \( -name '*.h' -o -name '*.cc' \) -print0 |
  xargs -0 clang-format-14 --dry-run -Werror --style=file
