#!/usr/bin/env bash
# From a parameter file to figures: sets up and builds if needed, runs the program stator, draws the figures
# (unless Output/Figures = false) and prints a one-page summary. Options are those of the program.
# Usage: scripts/run.sh FILE.prm [--set 'Section/Entry = value']... [--output DIR] [--study]
# With --study: what accuracy costs, a table and a figure.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
program=$root/build/bin/stator

is_built() {
  [[ -x $program ]] &&
    [[ -z $(find "$root/CMakeLists.txt" "$root/source" "$root/include" -type f -newer "$program" -print -quit) ]]
}
# set -e does not reach into a command whose status is asked for: the set-up stands alone.
if ! is_built; then
  "$root/scripts/setup.sh"
  touch "$program" # a changed source that it does not depend on leaves it as it was
fi

log=$(mktemp)
trap 'rm -f "$log"' EXIT
"$program" "$@" | tee "$log"

study=$(sed -n 's/^\[ *[0-9.]* s\] study in //p' "$log" | tail -n 1)
if [[ -n $study ]]; then
  "$root/scripts/study_figure.py" "${study%/stator/study.csv}"
  exit
fi

# The program's last line says where the results are; --help and --version have none, and
# those of the rotor have no figures.
results=$(sed -n 's/^\[ *[0-9.]* s\] results in //p' "$log" | tail -n 1)
[[ $results == */stator/ ]] || exit 0
case_folder=${results%/stator/}

figures=$(sed -n '/^subsection Output/,/^end/s/^ *set Figures *= *//p' "$results/used.prm")
if [[ $figures == true ]]; then
  "$root/scripts/figures.py" "$case_folder"
fi
echo
"$root/scripts/summary.py" "$case_folder"
