#!/usr/bin/env bash
# From a parameter file to a report: sets up and builds if needed, looks at the parameters of all programs, runs stator,
# contact and losses one after the other; draws the figures and writes report.html (unless Output/Figures =
# false) and prints a one-page summary. Options are those of the programs.
# Usage: scripts/run.sh FILE.prm [--set 'Section/Entry = value']... [--output DIR] [--check] [--study] [--resume] [--sensitivities]
# With --check: looks at the parameters, draws the cross-sections of both bodies, and nothing else. With --study: what
# accuracy costs of stator and of contact, tables and figures, and nothing else. With --resume, contact and studies take
# over what an interrupted run has found; the rest is computed again, which gives the same. With --sensitivities: also how
# much each entry of the motor changes its results. With Modes/Body = rotor or tooth, or
# Modes/Domain = ring: the modes of that body alone.
# What is not set-up is in scripts/run.py.
set -euo pipefail
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
programs=("$root/build/bin/stator" "$root/build/bin/contact" "$root/build/bin/losses" "$root/build/bin/motor")

is_built() {
  [[ -e $root/CMakeLists.txt ]] || return 0 # installed: nothing to be built
  local program
  for program in "${programs[@]}"; do
    [[ -x $program ]] || return 1
    [[ -z $(find "$root/CMakeLists.txt" "$root/source" "$root/include" -type f -newer "$program" -print -quit) ]] ||
      return 1
  done
}
# set -e does not reach into a command whose status is asked for: the set-up stands alone.
if ! is_built; then
  "$root/scripts/setup.sh"
  touch "${programs[@]}" # a changed source that they do not depend on leaves them as they were
fi
exec /usr/bin/python3 -sE "$root/scripts/run.py" "$@"
