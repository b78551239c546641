#!/usr/bin/env bash
# Builds the last commit on another release of Debian and runs its tests there. The system lies in a folder that chroot
# takes for its root; it is installed once, by debootstrap, and found again. Needs root rights; takes an hour the first time.
# Usage: scripts/development/other_system.sh RELEASE [--folder DIR] [arguments of scripts/test.sh]; e.g. RELEASE = trixie
# Without --folder: build/RELEASE. RINGMOTOR_CMAKE_ARGUMENTS counts as in scripts/setup.sh.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
stop() {
  echo "other_system: $*" >&2
  exit 1
}
(($#)) && [[ $1 != -* ]] || stop "which release? For example: scripts/development/other_system.sh trixie"
((EUID == 0)) || stop "needs root rights: debootstrap and chroot do"
# What is mounted below is mounted for this script alone, and gone when it ends, however it ends.
[[ ${RINGMOTOR_OWN_MOUNTS:-} ]] || RINGMOTOR_OWN_MOUNTS=1 exec unshare --mount "${BASH_SOURCE[0]}" "$@"

release=$1 system=$root/build/$1
shift
if [[ ${1:-} == --folder ]]; then
  system=${2:?--folder DIR}
  shift 2
fi

# As this system is told to fetch packages, by the same proxies.
install_system() {
  local mirror http_proxy=
  command -v debootstrap > /dev/null || apt-get install -y -q --no-install-recommends debootstrap
  mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Origin: Debian' 'Label: Debian' 'Created-By: Packages' | head -n 1)
  [[ $mirror ]] || stop "the sources of apt name no mirror of Debian (apt-get update may be needed)"
  eval "$(apt-config shell http_proxy Acquire::http::Proxy)"
  [[ -z $(ls -A "$system" 2> /dev/null) ]] || stop "$system has no finished system, and is not empty: remove it"
  mkdir -p "$system"
  http_proxy=$http_proxy debootstrap --variant=minbase --include=ca-certificates,git "$release" "$system" "$mirror"
  touch "$system/installed"
}
[[ -e $system/installed ]] || install_system
apt-config dump | grep -E '^Acquire::(http|https|Check|Retries)' > "$system/etc/apt/apt.conf.d/99as_outside" || true
cp /etc/resolv.conf /etc/hosts "$system/etc/"

# The last commit, not what is being changed. Unchanged files keep their time: only what has changed is built again.
sources=$system/ringmotor
[[ -d $sources/.git ]] || git init --quiet "$sources"
git -C "$sources" fetch --quiet "$root" HEAD
git -C "$sources" checkout --quiet --force --detach FETCH_HEAD

mount --bind /proc "$system/proc"
mount --rbind /sys "$system/sys"
mount --rbind /dev "$system/dev"
inside() {
  chroot "$system" /usr/bin/env -i HOME=/root LANG=C.UTF-8 PATH=/usr/sbin:/usr/bin:/sbin:/bin TERM="${TERM:-dumb}" \
    RINGMOTOR_CMAKE_ARGUMENTS="${RINGMOTOR_CMAKE_ARGUMENTS:-}" CMAKE_BUILD_PARALLEL_LEVEL="$(nproc)" \
    OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "$@"
}
SECONDS=0 status=0
inside /ringmotor/scripts/setup.sh -DRINGMOTOR_TESTS=ON
built=$SECONDS
inside /ringmotor/scripts/test.sh "$@" || status=$?
inside dpkg-query -W -f='${Package} ${Version}\n' libdeal.ii-dev g++ libopenmpi-dev
echo "other_system: Debian $(cat "$system/etc/debian_version"), set up in $built s, tested in $((SECONDS - built)) s"
exit "$status"
