#!/usr/bin/env bash
# Sets up and builds if needed, then runs the tests on all cores. Usage: scripts/test.sh [ctest arguments, e.g. -L quick]
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
"$root/scripts/setup.sh" -DRINGMOTOR_TESTS=ON
ctest --test-dir "$root/build" --output-on-failure --parallel "$(nproc)" "$@"
