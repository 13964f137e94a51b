#!/bin/bash
# Proves that a clone works on a bare Debian 12: makes one with debootstrap (minbase and git), clones this repository into it
# and runs a command there. Wants root and the package debootstrap. The machine's mirror, proxy, certificates and npm settings
# are copied in at run time. All mounts live in a mount namespace of its own, and its processes end with it.
#   tests/bench/bare_debian.sh ./deploy/test
#   BARE=/var/tmp/bare tests/bench/bare_debian.sh ./deploy/run --smoke     keeps the folder and uses it again
set -euo pipefail
shopt -s nullglob

if (($# == 0)); then
  printf 'use: %s COMMAND [ARGUMENTS...]\n' "$0" >&2
  exit 2
fi
root=$(cd "$(dirname "$0")/../.." && pwd)
bare=${BARE:-}
if [[ -z $bare ]]; then
  bare=$(mktemp -d /var/tmp/bare_debian.XXXXXX)
  trap 'rm -rf --one-file-system "$bare"' EXIT
fi

sources=(/etc/apt/sources.list /etc/apt/sources.list.d/*.{list,sources})

make_debian() {
  local mirror
  mirror=$(cat "${sources[@]}" 2>/dev/null | grep -oE 'https?://[^ ]*/debian/?( |$)' | head -1 || true)
  debootstrap --variant=minbase --include=git bookworm "$bare" "${mirror:-http://deb.debian.org/debian}"
}

# copy_in DESTINATION FILES...: those of FILES that exist, into a folder of the bare Debian.
copy_in() {
  local folder=$bare$1 file
  shift
  mkdir -p "$folder"
  for file in "$@"; do
    if [[ -f $file ]]; then cp -L "$file" "$folder/"; fi
  done
}

# What this machine needs to reach its mirrors and registries; none of it belongs in the repository.
copy_network_settings() {
  local settings
  mapfile -t settings < <(grep -lE 'Acquire::(http|ftp|Check|AllowInsecure)' /etc/apt/apt.conf.d/* || true)
  rm -f "$bare/etc/apt/sources.list"
  copy_in /etc /etc/resolv.conf /etc/hosts /etc/npmrc
  copy_in /etc/apt /etc/apt/sources.list
  copy_in /etc/apt/sources.list.d "${sources[@]:1}"
  copy_in /etc/apt/auth.conf.d /etc/apt/auth.conf.d/*
  copy_in /etc/apt/apt.conf.d "${settings[@]}"
  copy_in /usr/share/keyrings /usr/share/keyrings/debian-archive-*
  copy_in /usr/local/share/ca-certificates /usr/local/share/ca-certificates/*.crt
  copy_in /root "$HOME/.npmrc"
}

# Runs in the namespaces of its own: mounts what a program may expect, then gives the terminal to the command.
# shellcheck disable=SC2016  # the inner shell expands these
inside='
  set -e
  bare=$1; shift
  mount -t proc proc "$bare/proc"
  mount -t sysfs -o ro sysfs "$bare/sys"
  mkdir -p "$bare/dev/pts" "$bare/dev/shm"
  mount -t devpts -o newinstance,ptmxmode=0666,mode=0620 devpts "$bare/dev/pts"
  ln -sf pts/ptmx "$bare/dev/ptmx"
  mount -t tmpfs tmpfs "$bare/dev/shm"
  exec chroot "$bare" /bin/sh -c "cd /root/dripfeed && exec \"\$@\"" sh "$@"
'

[[ -x $bare/usr/bin/git ]] || make_debian
copy_network_settings
rm -rf "$bare/root/dripfeed"
git clone -q --no-hardlinks "$root" "$bare/root/dripfeed"

keep=(HOME=/root PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8)
for name in http_proxy https_proxy no_proxy NODE_EXTRA_CA_CERTS DRIPFEED_JOBS; do
  if [[ -n ${!name:-} ]]; then keep+=("$name=${!name}"); fi
done
env -i "${keep[@]}" unshare --mount --pid --fork --kill-child sh -c "$inside" sh "$bare" "$@"
