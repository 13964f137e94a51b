"""The unit of systemd: it is one, it is hardened, it has what docs/scheduling.md asks for, and no call of the server is forbidden by it, as far as a
run with a feed shows."""

import os
import pathlib
import re
import shutil
import subprocess
import sys

from rig import ROOT, Rig, binary, expect, in_folder, shop

UNIT = ROOT / "deploy/dripfeed.service"
EXPOSED_AT_MOST = 25  # tenths, of what systemd-analyze counts


def settings():
    """[(name, value)] of the section Service."""
    text = UNIT.read_text().split("[Service]")[1].split("[Install]")[0]
    return [tuple(line.split("=", 1)) for line in text.splitlines() if "=" in line and not line.startswith("#")]


def analyze(*arguments):
    return subprocess.run(["systemd-analyze", "--no-pager", *map(str, arguments)], capture_output=True, text=True, timeout=60)


def it_is_a_unit(folder):
    unit = folder / "dripfeed.service"
    unit.write_text(UNIT.read_text().replace("/usr/bin/dripfeed", str(binary())))
    done = analyze("verify", "--man=no", unit)
    expect(done.returncode == 0 and not done.stderr, f"systemd-analyze verify: {done.stderr}")


def it_is_hardened(folder):
    done = analyze("security", "--offline=true", f"--threshold={EXPOSED_AT_MOST}", UNIT)
    expect(done.returncode == 0, f"{done.stdout[-3000:]} {done.stderr}")
    print(re.search(r"Overall exposure level.*", done.stdout).group())


def it_has_what_a_feed_needs(folder):
    """The rows of the table, word for word."""
    rows = re.findall(r"^\| `(\w+)` \| `?([^|`]+)`? \|", (ROOT / "docs/scheduling.md").read_text().split("## What the systemd unit should set")[1].split("\n## ")[0], re.M)
    expect(len(rows) >= 6, f"the table is another one: {rows}")
    have = dict(settings())
    for name, value in rows:
        expect(have.get(name) == (None if value.strip() == "leave it out" else value.strip()), f"{name} is {have.get(name)}, the table says {value}")


def allowed_calls():
    """What the rows SystemCallFilter leave, in their order."""
    calls = set()
    for name, value in settings():
        if name != "SystemCallFilter":
            continue
        for word in value.lstrip("~").split():
            of = expand(word) if word.startswith("@") else {word}
            calls = calls - of if value.startswith("~") else calls | of
    return calls


def expand(name):
    calls = set()
    for line in analyze("syscall-filter", name).stdout.splitlines()[1:]:
        word = line.strip()
        if word.startswith("@"):
            calls |= expand(word)
        elif word and not word.startswith("#"):
            calls.add(word)
    return calls


def no_call_is_forbidden(folder):
    """A whole feed over a pseudo-terminal, a check in its worker process, a stop."""
    if not shutil.which("strace"):
        return print("skipped: there is no strace")
    traced = folder / "calls"
    rig = Rig(folder, f"pty:{folder}/lathe", blocks=40)
    rig.server.binary = folder / "traced"
    rig.server.binary.write_text(f'#!/bin/sh\nexec strace -D -f -qq -o {traced} -e trace=all {binary()} "$@"\n')
    rig.server.binary.chmod(0o700)
    rig.server.binary = str(rig.server.binary)
    rig.start()
    control = rig.control()
    job = rig.arm_new_job()
    shop.wait_for("the feed", lambda: rig.server.job(job)["state"] == "done", 60)
    control.stop()
    rig.server.request("GET", "/metrics", text=True)
    rig.server.stop()
    used = set(re.findall(r"^\d+ +(?:<\.\.\. )?(\w+)[( ]", traced.read_text(errors="replace"), re.M))
    expect({"write", "ioctl", "sched_setscheduler"} <= used, f"the trace is none: {sorted(used)}")
    as_root = {"fchown"} if os.geteuid() == 0 else set()  # by SQLite, for files next to the database; the unit's user is another
    forbidden = used - allowed_calls() - as_root - {"exited", "resumed", "killed"}
    expect(not forbidden, f"the unit forbids {sorted(forbidden)}")
    print(f"{len(used)} calls are used, all allowed")


if __name__ == "__main__":
    for test in (it_is_a_unit, it_is_hardened, it_has_what_a_feed_needs, no_call_is_forbidden):
        in_folder(test)
