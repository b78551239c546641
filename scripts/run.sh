#!/usr/bin/env bash
# From a parameter file to a report: sets up and builds if needed, runs the programs stator and, on the wave that it
# finds, contact and losses; draws the figures and writes report.html (unless Output/Figures = false) and prints a
# one-page summary. Options are those of the programs. Without the motor's wave among the modes, contact and losses are
# left out.
# Usage: scripts/run.sh FILE.prm [--set 'Section/Entry = value']... [--output DIR] [--study] [--resume]
# With --study: what accuracy costs of stator and of contact, tables and figures, and nothing else. With --resume,
# contact takes over what an interrupted run has found; the others are computed again, which gives the same.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
bin=$root/build/bin
programs=("$bin/stator" "$bin/contact" "$bin/losses")

is_built() {
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

log=$(mktemp)
trap 'rm -f "$log"' EXIT
is_study=false
is_resumed=false
options=() # for all programs
for option in "$@"; do
  case $option in
    --study) is_study=true ;;
    --resume) is_resumed=true ;;
    *) options+=("$option") ;;
  esac
done
if $is_study && $is_resumed; then
  echo "run.sh: --resume does not go with --study, which computes everything anew; leave one of them out" >&2
  exit 1
fi

# The end of the line of the log that tells it, of the program that has run last.
told() {
  sed -n "s/^\[ *[0-9.]* s\] $1 in //p" "$log" | tail -n 1
}

if $is_study; then
  "$bin/stator" "${options[@]}" --study | tee "$log"
  study=$(told study)
  [[ -n $study ]] || exit 0
  # contact needs a wave, which a study leaves none of.
  "$bin/stator" "${options[@]}" | tee "$log"
  [[ ! -f $(told results)/ellipses.csv ]] || "$bin/contact" "$@"
  "$root/scripts/study_figure.py" "${study%/stator/study.csv}"
  exit
fi

"$bin/stator" "${options[@]}" | tee "$log"
# The program's last line says where the results are; --help and --version have none, and
# those of the rotor have no figures.
results=$(told results)
[[ $results == */stator/ ]] || exit 0
case_folder=${results%/stator/}

# Where a program fails, the results of those before it are shown all the same, but none that an earlier run of it may
# have left.
status=0
run_next() {
  "$bin/$1" "${@:2}" || status=$?
  ((status == 0)) && return
  [[ ! -e $case_folder/$1/summary.json ]] || exit "$status"
  return "$status"
}
# ellipses.csv is written with the motor's wave, which contact needs.
if [[ -f $results/ellipses.csv ]]; then
  run_next contact "$@" && run_next losses "${options[@]}" || true
fi

figures=$(sed -n '/^subsection Output/,/^end/s/^ *set Figures *= *//p' "$results/used.prm")
if [[ $figures == true ]]; then
  "$root/scripts/figures.py" "$case_folder"
  "$root/scripts/report.py" "$case_folder"
fi
echo
"$root/scripts/summary.py" "$case_folder"
exit "$status"
