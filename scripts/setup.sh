#!/usr/bin/env bash
# Installs the missing Debian packages of scripts/packages.txt, configures and builds Release into build/.
# Safe to repeat. Usage: scripts/setup.sh [further cmake arguments]
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

missing=()
while read -r package _; do
  [[ -z $package || $package == \#* ]] && continue
  [[ $(dpkg-query -W -f='${Status}' "$package" 2>/dev/null) == "install ok installed" ]] || missing+=("$package")
done < "$root/scripts/packages.txt"

if ((${#missing[@]})); then
  echo "setup: installing ${missing[*]}"
  sudo=()
  if ((EUID != 0)); then
    command -v sudo > /dev/null || { echo "setup: these packages are missing and need root rights to install: ${missing[*]}" >&2; exit 1; }
    sudo=(sudo)
  fi
  "${sudo[@]}" apt-get update -q
  "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${missing[@]}"
fi

# shellcheck disable=SC2086
cmake -S "$root" -B "$root/build" -G Ninja ${RINGMOTOR_CMAKE_ARGUMENTS:-} "$@"
cmake --build "$root/build"
