#!/usr/bin/env bash
# Fails if a source file is not formatted as .clang-format says, or ends with 77 where clang-format 14 is missing: other
# versions format otherwise. Repair: clang-format-14 -i FILE...
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
for formatter in clang-format-14 clang-format; do
  [[ $($formatter --version 2> /dev/null) == *"version 14."* ]] && break
  formatter=
done
[[ $formatter ]] || { echo "check_format: skipped, there is no clang-format 14"; exit 77; }
find include source tests benchmarks \( -name '*.h' -o -name '*.cc' \) -print0 |
  xargs -0 "$formatter" --dry-run -Werror --style=file
