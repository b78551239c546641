#!/usr/bin/env bash
# From a parameter file to figures: sets up and builds if needed, runs the programs stator and, on the wave that it
# finds, contact; draws the figures (unless Output/Figures = false) and prints a one-page summary. Options are those of
# the programs. Without the motor's wave among the modes, contact is left out.
# Usage: scripts/run.sh FILE.prm [--set 'Section/Entry = value']... [--output DIR] [--study] [--resume]
# With --study: what accuracy costs, a table and a figure; of stator alone. With --resume, contact takes over what
# an interrupted run has found; the stator is computed again, which gives the same wave.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
bin=$root/build/bin

is_built() {
  local program
  for program in "$bin/stator" "$bin/contact"; do
    [[ -x $program ]] || return 1
    [[ -z $(find "$root/CMakeLists.txt" "$root/source" "$root/include" -type f -newer "$program" -print -quit) ]] ||
      return 1
  done
}
# set -e does not reach into a command whose status is asked for: the set-up stands alone.
if ! is_built; then
  "$root/scripts/setup.sh"
  touch "$bin/stator" "$bin/contact" # a changed source that they do not depend on leaves them as they were
fi

log=$(mktemp)
trap 'rm -f "$log"' EXIT
stator_options=()
for option in "$@"; do
  [[ $option == --resume ]] || stator_options+=("$option")
done
"$bin/stator" "${stator_options[@]}" | tee "$log"

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

# ellipses.csv is written with the motor's wave, which contact needs. Where contact fails, the stator's results are
# shown all the same, but none of the contact that an earlier run may have left.
status=0
if [[ -f $results/ellipses.csv ]]; then
  "$bin/contact" "$@" || status=$?
  if ((status != 0)) && [[ -e $case_folder/contact/summary.json ]]; then
    exit "$status"
  fi
fi

figures=$(sed -n '/^subsection Output/,/^end/s/^ *set Figures *= *//p' "$results/used.prm")
if [[ $figures == true ]]; then
  "$root/scripts/figures.py" "$case_folder"
fi
echo
"$root/scripts/summary.py" "$case_folder"
exit "$status"
