#!/usr/bin/env bash
# Sets up and builds if needed, then runs tests on all cores: those that cover every room in some minutes, or with --all
# all of them, which takes below an hour on two cores, or what ctest's own arguments select.
# Usage: scripts/test.sh [--all | ctest arguments, e.g. -L hard]
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
selection=("$@")
(($#)) || selection=(-L "quick|tour")
[[ ${1:-} != --all ]] || selection=("${@:2}")
"$root/scripts/setup.sh" -DRINGMOTOR_TESTS=ON
ctest --test-dir "$root/build" --output-on-failure --parallel "$(nproc)" "${selection[@]}"
