"""The package for Debian, in a copy of this system that is thrown away (an overlay in a mount namespace of its own): it installs, its server serves
as its own user, an upgrade keeps what the shop changed and lets the running server run, and a removal leaves the shop's data."""

import os
import pathlib
import re
import shutil
import subprocess
import sys

from rig import binary, expect, in_folder

# Runs as root of the namespace: mounts the copy, and in it the scene.
INSIDE = r"""
set -e
mount -t tmpfs tmpfs "$1"
mkdir "$1/upper" "$1/work" "$1/root"
mount -t overlay overlay -o "lowerdir=/,upperdir=$1/upper,workdir=$1/work" "$1/root"
mount -t proc proc "$1/root/proc"
mount -t tmpfs tmpfs "$1/root/run"
mount --bind /dev "$1/root/dev"
mount -t tmpfs tmpfs "$1/root/tmp"
rm -rf "$1/root/var/lib/dripfeed" "$1/root/etc/dripfeed"
cp "$2"/*.deb "$1/root/tmp/"
cp "$3" "$1/root/tmp/scene"
chroot "$1/root" bash -e /tmp/scene
"""

SCENE = r"""
cd /tmp
set -o pipefail
export DEBIAN_FRONTEND=noninteractive
ask() { curl -sS --max-time 5 -o /dev/null -w '%{http_code}' "$@" http://127.0.0.1:8849/"$path"; }
fails() { if "$@" >/dev/null 2>&1; then echo "not expected to do: $*"; exit 1; fi; }  # bash -e lets "! ..." and "... && ..." pass
await() { for _ in $(seq 100); do [ "$(path=healthz ask || true)" = 200 ] && return; sleep 0.1; done; echo "no answer"; exit 1; }

echo "== install"
dpkg -i dripfeed_0.1.0_*.deb
id -nG dripfeed | grep -qw dialout
dripfeed serve --config /etc/dripfeed/dripfeed.json --check
[ -s /usr/share/man/man1/dripfeed.1.gz ]
bash -n /usr/share/bash-completion/completions/dripfeed
fails curl -sS --max-time 5 http://127.0.0.1:8840/healthz

echo "== serve as the unit does"
install -d -o dripfeed -g dripfeed -m 0700 /var/lib/dripfeed
sed -i 's/8840/8849/' /etc/dripfeed/dripfeed.json
setpriv --reuid dripfeed --regid dripfeed --init-groups dripfeed serve --config /etc/dripfeed/dripfeed.json >/tmp/log 2>&1 &
server=$!
await
[ "$(path='' ask)" = 200 ]
[ "$(path=docs ask -L)" = 200 ]
token=$(cat /var/lib/dripfeed/data/first-token)
[ "$(path=api/v1/machines ask -H "Authorization: Bearer $token")" = 200 ]
[ "$(path=api/v1/machines ask -H "Authorization: Bearer $token" --data @/usr/share/dripfeed/machines/haas-vf2.json)" = 201 ]

echo "== upgrade"
dpkg -i dripfeed_0.1.1_*.deb | tee said
grep -q 'systemctl restart dripfeed' said
grep -q 8849 /etc/dripfeed/dripfeed.json
kill -0 $server
[ "$(path=healthz ask)" = 200 ]
kill -TERM $server
wait $server
setpriv --reuid dripfeed --regid dripfeed --init-groups dripfeed serve --config /etc/dripfeed/dripfeed.json >>/tmp/log 2>&1 &
server=$!
await
[ "$(path=api/v1/machines/haas-vf2 ask -H "Authorization: Bearer $token")" = 200 ]
kill -TERM $server
wait $server

echo "== remove"
dpkg -r dripfeed
[ ! -e /usr/bin/dripfeed ]
[ ! -e /usr/share/dripfeed ]
[ -e /etc/dripfeed/dripfeed.json ]
[ -e /var/lib/dripfeed/data ]
dpkg -P dripfeed | tee said
grep -q 'stay in /var/lib/dripfeed' said
[ ! -e /etc/dripfeed ]
[ -e /var/lib/dripfeed/data ]
rm -r /var/lib/dripfeed
dpkg -i dripfeed_0.1.0_*.deb
dpkg -P dripfeed
fails getent passwd dripfeed
echo "== whole"
"""


def run(*command, **more):
    done = subprocess.run(list(map(str, command)), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=240, **more)
    expect(done.returncode == 0, f"{' '.join(map(str, command))} ended with {done.returncode}:\n{done.stdout[-6000:]}")
    return done.stdout


def made(folder):
    """The package of the build that the binary belongs to, and one of the next version."""
    build = binary().parent
    run("cmake", "--build", build, "--target", "package_words")
    run("cpack", "-G", "DEB", "--config", build / "CPackConfig.cmake", "-B", folder)
    shutil.rmtree(folder / "_CPack_Packages", ignore_errors=True)
    (first,) = folder.glob("*.deb")
    tree = folder / "next"
    run("dpkg-deb", "-R", first, tree)
    control = tree / "DEBIAN/control"
    control.write_text(control.read_text().replace("Version: 0.1.0", "Version: 0.1.1"))
    run("dpkg-deb", "--root-owner-group", "-b", tree, folder / first.name.replace("0.1.0", "0.1.1"))
    shutil.rmtree(tree)
    return first


def what_it_is(package):
    fields = run("dpkg-deb", "-f", package)
    for name in ("libboost", "-dev"):
        expect(name not in fields, f"{name} in {fields}")
    for name in ("libc6", "libpq5", "libsqlite3-0", "libfmt9", "libssl3", "adduser"):
        expect(name in fields, f"no {name} in {fields}")
    lines = run("dpkg-deb", "-c", package).splitlines()
    for line in lines:
        mode, owner, _, _, _, path = line.split(maxsplit=5)
        expect(owner == "root/root", line)
        expect(re.match(r"drwxr-xr-x|-rw-r--r--|-rwxr-xr-x", mode), line)
        expect(("x" in mode) == (mode[0] == "d" or path == "./usr/bin/dripfeed"), line)
    print(f"{len(lines)} files and folders, {package.stat().st_size / 1e6:.1f} MB")


def main(folder):
    packages = folder / "packages"
    packages.mkdir()
    what_it_is(made(packages))
    scene = folder / "scene"
    scene.write_text(SCENE)
    root = folder / "root"
    root.mkdir()
    rise = [] if os.geteuid() == 0 else ["sudo", "-n"]
    said = run(*rise, "unshare", "--mount", "--pid", "--net", "--fork", "--kill-child", "bash", "-c", f"ip link set lo up\n{INSIDE}", "bash", root, packages, scene)
    expect("== whole" in said, said)
    print(said)


if __name__ == "__main__":
    in_folder(main)
