"""The link is cut in the middle of a block: the job fails, the interval is named, nothing more goes out on that line until a person confirms that
the control was reset, and the server lives on."""

import os
import pty
import select
import sys
import time

from rig import Rig, expect, in_folder, sends, shop, verify
from torn_send import DC1


def cut(folder, url):
    rig = Rig(folder, url).start()
    server = rig.server
    # Somewhere inside a block: byte 1500 of the wire lies in no EOB (the blocks are longer than two bytes on both sides).
    control = rig.control("--fault", "cut=1503", "--speed", "1000")
    job = rig.arm_new_job()
    ended = server.wait_job(job, "failed", "interrupted", "done")
    report = control.finish(20)
    expect(ended["state"] == "failed", f"the job is {ended['state']}: {ended['reason']}")
    expect(ended["torn"] and ended["needs_confirmation"], "the block is not known as torn")
    expect("between wire byte" in ended["reason"], f"the interval is not named: {ended['reason']}")
    interval = server.get(f"/jobs/{job}/ledger")["interval"]
    expect(interval["low"] <= report["bytes"] <= interval["high"], f"{report['bytes']} bytes arrived, the ledger has {interval}")
    expect(server.alive(), "the server is gone")

    # A new control on the same line: nothing may come, and nothing can be armed.
    control = rig.control("--speed", "1000")
    waiting = server.wait_line("lathe", "torn")
    expect(verify(server.data)["torn_machines"] == 1, "the torn machine is not counted")
    expect(waiting["needs_confirmation"] is not None, "no one is asked to confirm")
    other = server.post("/jobs", {"release": rig.release["id"]})["id"]
    try:
        server.post(f"/jobs/{other}/arm", {})
        raise AssertionError("a torn line was armed")
    except shop.Refused as refused:
        expect(refused.status == 409, f"status {refused.status}")
    expect(control.stop()["bytes"] == 0, "bytes went out on a torn line")

    server.post("/machines/lathe/confirm-reset", {"reason": "RESET pressed, slide clear"})
    control = rig.control("--speed", "1000")
    server.wait_line("lathe", "idle")
    server.post(f"/jobs/{other}/arm", {})
    expect(server.wait_job(other, "done", "failed")["state"] == "done", "the line does not work after the confirmation")
    expect(control.finish(60)["alarm"] is None, "the control raised an alarm")
    verify(server.data)
    server.stop()


def pty_is_closed(folder):
    cut(folder, f"pty:{folder}/lathe.tty")


def tcp_is_reset(folder):
    cut(folder, f"tcp://127.0.0.1:{shop.free_port()}")


def a_dead_controls_link_leads_to_no_control(folder):
    """kill -9 of a simulated control leaves its link, and the system gives the number of its pseudo-terminal to the next one that asks."""
    rig = Rig(folder, f"pty:{folder}/lathe.tty", blocks=10)
    control = rig.control()
    device = os.readlink(folder / "lathe.tty")
    control.process.kill()
    control.process.wait()
    ends = [pty.openpty()]
    while os.ttyname(ends[-1][1]) != device and len(ends) < 50:
        ends.append(pty.openpty())
    stranger = ends[-1]
    expect(os.ttyname(stranger[1]) == device, "the number was not given out again: nothing is tested")
    program = folder / "O0042.nc"
    program.write_text(rig.text)
    sending = sends(program, rig.url, "--machine", rig.machine)
    time.sleep(0.5)
    os.write(stranger[0], DC1)  # whoever has it now may send anything
    _, said = sending.communicate(timeout=20)
    expect(sending.returncode == 1 and "has ended" in said, f"{sending.returncode}: {said}")
    expect(not select.select([stranger[0]], [], [], 0.2)[0], "bytes went to a stranger")
    control = rig.control()  # the next one takes the place of what is left
    shop.wait_for("a new link", lambda: os.readlink(folder / "lathe.tty") != device)
    control.stop()
    expect(not os.path.lexists(folder / "lathe.tty") and not os.path.lexists(folder / "lathe.tty.owner"), "a link is left")


if __name__ == "__main__":
    in_folder(a_dead_controls_link_leads_to_no_control)
    in_folder(pty_is_closed)
    in_folder(tcp_is_reset)
    sys.exit(0)
