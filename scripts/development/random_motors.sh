#!/usr/bin/env bash
# Random motors on all cores: each must end certified or refused in words. Continues where it was interrupted.
# Usage: scripts/development/random_motors.sh [--seed S] [--count N] [further options of tests/hard/random_motors.py]
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
exec /usr/bin/python3 -sE "$root/tests/hard/random_motors.py" --workers "$(nproc)" --resume "$@"
