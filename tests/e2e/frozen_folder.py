"""A folder whose file server hangs: the feed of another line goes on, the API answers, the server stops; and once the folder answers again the file lies there
whole. The folder is a FUSE file system that the test stops answering; where none can be mounted, the test says why and does nothing."""

import json
import sys
import time

from rig import ROOT, Rig, expect, in_folder, plain_program, shop

sys.path.insert(0, str(ROOT / "tests/support"))
from freezing_folder import FreezingFolder, why_not  # noqa: E402
from own_control import ControlLoop, TcpControl  # noqa: E402

BAUD, BITS = 9600, 11
AT_MOST_MS = 50


def two_machines(folder, control, share):
    rig = Rig(folder, control.url(), blocks=300, baud=BAUD).start()
    profile = shop.preset("fanuc-0i-mill", url=f"dir:{share.path}")
    profile["name"] = "fetches"
    rig.server.add_machine(profile)
    rig.drop_text = plain_program(20, "O0077").replace("G21 G18 G40 G99", "G21 G17 G40 G94").replace("G55", "G54").replace("T0101", "T01 M06").replace(
        "G97 S500 M03", "S500 M03").replace("F0.2", "F200.").replace("X100. Z10.", "X100. G43 H01 Z50.")
    program = rig.server.post("/programs", {"name": "O0077", "dialect": "fanuc", "text": rig.drop_text})
    check = rig.server.post("/checks", {"program": program["id"], "machine": "fetches", "delivery": "memory"})
    expect(check["verdict"] in ("pass", "warn"), f"verdict {check['verdict']}: {json.dumps(check)[:1500]}")
    rig.drop_release = rig.server.release(program["id"], "fetches", delivery="memory")
    rig.server.wait_line("fetches", "idle")
    return rig


def health_ms(server):
    before = time.monotonic()
    server.request("GET", "/healthz")
    return (time.monotonic() - before) * 1000


def nothing_waits_for_it(folder):
    loop = ControlLoop()
    control = TcpControl(loop, BITS / BAUD)
    share = FreezingFolder(folder / "share")
    rig = None
    try:
        rig = two_machines(folder, control, share)
        server = rig.server
        rig.arm_new_job()
        control.start()
        shop.wait_for("the feed", lambda: control.count() > 300)
        share.freeze()
        drop = server.post("/jobs", {"release": rig.drop_release["id"]})["id"]
        server.post(f"/jobs/{drop}/arm", {})
        until = time.monotonic() + 3.0
        slowest = 0.0
        while time.monotonic() < until:
            slowest = max(slowest, health_ms(server))
            server.status("lathe")
            time.sleep(0.02)
        expect(slowest < AT_MOST_MS, f"/healthz took {slowest:.0f} ms while a folder hung")
        expect(max(control.delays) * 1000 < AT_MOST_MS, f"the feed waited {max(control.delays) * 1000:.0f} ms")
        expect(control.count() > 300 + 2.5 * BAUD / BITS, f"only {control.count()} characters came")
        reported = server.status("fetches")
        expect("does not answer" in json.dumps(reported), f"no one says that the folder hangs: {reported}")

        share.thaw()
        done = server.wait_job(drop, "done", "failed", "queued")
        expect(done["state"] == "done", f"{done}")
        expect((folder / "share/O0077").read_text() == rig.drop_text, "the file is another one")

        share.freeze()
        time.sleep(1.5)
        before = time.monotonic()
        server.stop()
        expect(time.monotonic() - before < 10, "the server did not stop while a folder hung")
    finally:
        share.close()
        if rig and rig.server.process and rig.server.alive():
            rig.server.kill()
        loop.close()


if __name__ == "__main__":
    reason = why_not()
    if reason:
        print(f"skipped: {reason}")
    else:
        in_folder(nothing_waits_for_it)
    sys.exit(0)
