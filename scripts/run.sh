#!/usr/bin/env bash
# From a parameter file to a report: sets up and builds if needed, looks at the parameters of all programs, runs stator,
# contact and losses one after the other; draws the figures and writes report.html (unless Output/Figures =
# false) and prints a one-page summary. Options are those of the programs.
# Usage: scripts/run.sh FILE.prm [--set 'Section/Entry = value']... [--output DIR] [--check] [--study] [--resume]
# With --check: looks at the parameters, and nothing else. With --study: what accuracy costs of stator and of contact,
# tables and figures, and nothing else. With --resume, contact and studies take over what an interrupted run has found;
# the rest is computed again, which gives the same. With Modes/Body = rotor or tooth: the modes of that body alone.
set -euo pipefail
root=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)
bin=$root/build/bin
[[ -e $root/CMakeLists.txt ]] || bin=$(cd "$root/../../bin" && pwd) # installed: nothing to be built
programs=("$bin/stator" "$bin/contact" "$bin/losses" "$bin/motor")

is_built() {
  [[ -e $root/CMakeLists.txt ]] || return 0
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

mode=run
is_resumed=false
options=() # for all programs
for option in "$@"; do
  case $option in
    --study | --check) mode=${option#--} ;;
    --resume) is_resumed=true ;;
    --help | --version) exec "$bin/contact" "$option" ;;
    *) options+=("$option") ;;
  esac
done
resume=()
! $is_resumed || resume=(--resume)

[[ $mode != check ]] || exec "$bin/motor" "${options[@]}" --check

# Before the first second is spent: what is wrong with the parameters of any program.
checked=$("$bin/motor" "${options[@]}" --check)
results=${checked##* to } # where they would be
if [[ $results == */rotor/ || $results == */tooth/ ]]; then # which have no figures
  [[ $mode == run ]] || exec "$bin/stator" "${options[@]}" --study "${resume[@]}"
  exec "$bin/stator" "${options[@]}"
fi
case_folder=${results%/}

if [[ $mode == study ]]; then
  "$bin/stator" "${options[@]}" --study "${resume[@]}"
  "$bin/stator" "${options[@]}" # contact needs a wave, which a study leaves none of
  "$bin/contact" "${options[@]}" --study "${resume[@]}"
  exec "$root/scripts/study_figure.py" "$case_folder"
fi

# Ranks share the work of a motor; a fifth one would find little left of it. They are not bound to cores that other runs
# may have been bound to, nproc counts more than the slots of mpirun, containers forbid the fast way of copying
# between processes, and mpirun adds nothing to what the program says.
n_ranks=$(($(nproc) < 4 ? $(nproc) : 4))
launcher=()
if ((n_ranks > 1)) && command -v mpirun > /dev/null; then
  launcher=(mpirun --quiet --bind-to none --oversubscribe --mca mpi_yield_when_idle 1
            --mca btl_vader_single_copy_mechanism none -n "$n_ranks")
  ((EUID != 0)) || launcher+=(--allow-run-as-root)
  "${launcher[@]}" true &> /dev/null || launcher=() # mpirun does not work here
fi

trap 'exit 130' INT # mpirun does not end as by the signal, and bash would go on

# Where a program fails, the page tells so beside the results of those before it.
rm -f "$case_folder/report.html"
status=0 shown=0 begun=$EPOCHSECONDS
"${launcher[@]}" "$bin/motor" "${options[@]}" "${resume[@]}" || status=$?
used=$case_folder/stator/used.prm
(($(stat -c %Y "$used" 2> /dev/null || echo 0) >= begun)) || exit "$status" # stator has failed, or another run is there

figures=$(sed -n '/^subsection Output/,/^end/s/^ *set Figures *= *//p' "$used")
if [[ $figures == true ]]; then
  # What cannot be drawn is missing on the page, which is there in any case.
  "$root/scripts/figures.py" "$case_folder" || shown=$?
  "$root/scripts/report.py" "$case_folder" || shown=$?
fi
echo
"$root/scripts/summary.py" "$case_folder" || shown=$?
exit $((status == 0 ? shown : status))
