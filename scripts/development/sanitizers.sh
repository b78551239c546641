#!/usr/bin/env bash
# The programs with AddressSanitizer and UBSan, in build/sanitizers: on the motors of their tests, on hard motors and on
# 10 000 damaged input files; without them under Valgrind. About an hour.
# Usage: scripts/development/sanitizers.sh [ctest arguments]
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
"$root/scripts/setup.sh" -DRINGMOTOR_TESTS=ON
cmake -S "$root" -B "$root/build/sanitizers" -G Ninja -DRINGMOTOR_TESTS=ON -DRINGMOTOR_SANITIZERS=ON \
      -DRINGMOTOR_PLAIN_PROGRAMS="$root/build/bin"
cmake --build "$root/build/sanitizers" --target stator contact losses motor readers
ctest --test-dir "$root/build/sanitizers" --label-regex sanitizers --output-on-failure --parallel "$(nproc)" "$@"
