#!/usr/bin/env bash
# Installs the missing Debian packages of scripts/packages.txt, configures and builds Release into build/.
# Safe to repeat. Usage: scripts/setup.sh [further cmake arguments]
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

missing=() optional=()
while read -r package word _; do
  [[ -z $package || $package == \#* ]] && continue
  [[ $(dpkg-query -W -f='${Status}' "$package" 2>/dev/null) == "install ok installed" ]] && continue
  if [[ $word == optional ]]; then optional+=("$package"); else missing+=("$package"); fi
done < "$root/scripts/packages.txt"

sudo=()
may_install=true
if ((EUID != 0)); then
  sudo=(sudo)
  command -v sudo > /dev/null || may_install=false
fi
if ((${#missing[@]})); then
  $may_install || { echo "setup: these packages are missing and need root rights to install: ${missing[*]}" >&2; exit 1; }
  "${sudo[@]}" apt-get update -q
fi
for package in "${optional[@]}"; do
  if $may_install && apt-cache show "$package" &> /dev/null; then missing+=("$package"); fi
done
if ((${#missing[@]})); then
  echo "setup: installing ${missing[*]}"
  "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${missing[@]}"
fi

# shellcheck disable=SC2086
cmake -S "$root" -B "$root/build" -G Ninja ${RINGMOTOR_CMAKE_ARGUMENTS:-} "$@"
cmake --build "$root/build"
