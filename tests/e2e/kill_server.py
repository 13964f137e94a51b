"""kill -9 of the server during a feed, again and again: after each restart the job is interrupted, and what the control really got lies in the
ledger's interval."""

import random
import sys
import time

from rig import Rig, expect, in_folder, verify

TIMES = 20
SEED = 20


def killed_in_a_feed(folder):
    rig = Rig(folder, f"pty:{folder}/lathe.tty", blocks=2000).start()
    server = rig.server
    chance = random.Random(SEED)
    for turn in range(TIMES):
        control = rig.control("--speed", "2000")
        job = rig.arm_new_job()
        server.wait_job(job, "feeding", "held")
        time.sleep(chance.uniform(0.05, 0.9))
        server.kill()
        time.sleep(0.1)
        got = control.stop()
        verify(server.data)  # what the killed server left
        server.start()
        after = server.job(job)
        expect(after["state"] == "interrupted", f"turn {turn}: the job is {after['state']}")
        interval = server.get(f"/jobs/{job}/ledger?limit=1")["interval"]
        expect(interval["low"] <= got["bytes"] <= interval["high"], f"turn {turn}: {got['bytes']} bytes arrived, the ledger has {interval}")
        print(f"turn {turn}: {interval['low']} <= {got['bytes']} <= {interval['high']}", flush=True)
        if after["needs_confirmation"]:
            server.post("/machines/lathe/confirm-reset", {"reason": "reset after the crash"})
    seen = verify(server.data)  # while it runs
    expect(seen["ledger"]["jobs"] == TIMES and seen["ledger"]["rows"] > TIMES and seen["audit"]["rows"] > TIMES, f"{seen}")
    server.stop()
    verify(server.data)


if __name__ == "__main__":
    in_folder(killed_in_a_feed)
    sys.exit(0)
