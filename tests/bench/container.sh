#!/bin/bash
# Makes the container of deploy/Containerfile from the package of a build and runs it: the page answers, a program is stored, the server ends well and
# finds the program again. Without a registry: the base is Debian 12 by debootstrap. Needs root, buildah, crun and debootstrap.
#   tests/bench/container.sh build/dev [FOLDER]      FOLDER has the base already, as an earlier run left it
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
build=$(cd "$1" && pwd)
base=${2:-$(mktemp -d)/base}
work=$(mktemp -d)
port=8947
export STORAGE_DRIVER=vfs BUILDAH_ISOLATION=chroot
trap 'pkill -KILL -f "^/usr/bin/dripfeed serve .*:$port" || true; rm -rf "$work"' EXIT

[ -d "$base/usr" ] || debootstrap --variant=minbase bookworm "$base" >"$work/debootstrap.log"
cmake --build "$build" --target package_words >/dev/null
(cd "$build" && cpack -G DEB --config CPackConfig.cmake -B "$work/package" >/dev/null)

made=$(buildah from scratch)
buildah add "$made" "$base" / >/dev/null
buildah commit -q "$made" dripfeed-base >/dev/null
buildah rm "$made" >/dev/null
buildah build -q --build-arg BASE=localhost/dripfeed-base -f "$root/deploy/Containerfile" -t dripfeed "$work/package" >/dev/null
box=$(buildah from dripfeed)
mount=$(buildah mount "$box")
mkdir -m 0700 "$work/data"
chown --reference="$mount/var/lib/dripfeed" "$work/data"

start() {
  buildah run --user dripfeed -v "$work/data:/var/lib/dripfeed" "$box" \
    /usr/bin/dripfeed serve --config /etc/dripfeed/dripfeed.json --listen "0.0.0.0:$port" --insecure >"$work/log" 2>&1 &
  server=$!
  for _ in $(seq 100); do
    curl -sf -o /dev/null "http://127.0.0.1:$port/healthz" && return
    sleep 0.1
  done
  cat "$work/log"
  exit 1
}
# The server itself, not what runs it.
stop() {
  kill -TERM "$(pgrep --newest -f "^/usr/bin/dripfeed serve .*:$port")"
  wait "$server"
}
ask() { curl -sf -H "Authorization: Bearer $(cat "$work/data/data/first-token")" "$@"; }
programs=http://127.0.0.1:$port/api/v1/programs

start
curl -sf -o /dev/null "http://127.0.0.1:$port/"
ask -X POST -H 'Content-Type: application/json' -d '{"name":"O1","dialect":"fanuc","text":"%\nO1\nM30\n%\n"}' "$programs" >/dev/null
stop
start
ask "$programs" | grep -q '"name":"O1"'
stop
buildah umount "$box" >/dev/null
buildah rm "$box" >/dev/null
echo "the container serves, ends well and keeps its data ($(buildah images --format '{{.Size}}' dripfeed))"
