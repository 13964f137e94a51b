"""Eight lines feed at 115,200 baud, and the peer of a ninth sends DC1 as fast as it can: no feed waits for it, and the line that floods is named."""

import socket
import sys
import threading
import time

from rig import ROOT, Rig, expect, in_folder, shop

sys.path.insert(0, str(ROOT / "tests/support"))
from own_control import ControlLoop, TcpControl  # noqa: E402

BAUD, BITS, LINES = 115_200, 11, 8
WINDOWS, SECONDS = 3, 1.5
LONGEST_MS = 50


class Flood:
    """Accepts the server and sends DC1 without end."""

    def __init__(self):
        self.listener = socket.create_server(("127.0.0.1", 0))
        self.over = False
        self.sent = 0
        self.thread = threading.Thread(target=self._run, daemon=True)
        self.begins = threading.Event()
        self.thread.start()

    def url(self):
        return f"tcp://127.0.0.1:{self.listener.getsockname()[1]}"

    def _run(self):
        peer, _ = self.listener.accept()
        peer.settimeout(0.1)
        self.begins.wait()
        while not self.over:
            try:
                self.sent += peer.send(b"\x11" * 65536)
            except TimeoutError:
                continue
        peer.close()

    def stop(self):
        self.over = True
        self.begins.set()
        self.thread.join()


def worst_delay_ms(loop, controls):
    """The longest wait of any feed within one window."""
    with loop.lock:
        for control in controls:
            control.delays.clear()
    time.sleep(SECONDS)
    with loop.lock:
        return max(max(control.delays) for control in controls) * 1000


def feeds_go_on(folder):
    loop = ControlLoop()
    flood = Flood()
    controls = [TcpControl(loop, BITS / BAUD) for _ in range(LINES)]
    rig = Rig(folder, flood.url(), blocks=6000, baud=BAUD)
    server = rig.start().server
    try:
        program = server.get("/programs?name=O0042")["items"][0]["id"]
        for i, control in enumerate(controls):
            profile = shop.preset("fanuc-0i-lathe", url=control.url(), baud=BAUD, framing="7E2", unsent=26, latency_chars=26, overrun_budget=52)
            profile["name"] = f"lathe{i}"
            server.add_machine(profile)
            server.post("/checks", {"program": program, "machine": profile["name"], "delivery": "drip"})
            release = server.release(program, profile["name"])
            server.wait_line(profile["name"], "idle")
            server.post(f"/jobs/{server.post('/jobs', {'release': release['id']})['id']}/arm", {})
        for control in controls:
            control.start()
        flood.begins.set()
        # A machine that does not run this process for a moment spoils one window; a feed that waits for the flood is late in each.
        worst_ms = [worst_delay_ms(loop, controls) for _ in range(WINDOWS)]
        counts = [control.count() for control in controls]
        sent = flood.sent
        named = server.status("lathe")
        alarms = server.get("/alarms?state=open&machine=lathe")["items"]
        print(f"flood {sent / WINDOWS / SECONDS / 1e6:.2f} MB/s taken; worst delay of each window {', '.join(f'{ms:.1f}' for ms in worst_ms)} ms; characters {min(counts)} to {max(counts)}")
        expect(min(worst_ms) < LONGEST_MS, f"in every window a feed waited for a line that floods: {worst_ms} ms")
        expect("floods the line" in named.get("link_note", ""), f"no one names the line that floods: {named}")
        expect(named["link_note_id"] == "line_flooded" and [one["kind"] for one in alarms] == ["line_flooded"], f"the flood is no alarm, or not the only one: {named} {alarms}")
        expect(alarms[0]["cleared_at_ms"] is None and alarms[0]["count"] == 1, f"a flood that lasts is one alarm that lasts: {alarms}")
    finally:
        flood.stop()
        server.kill()
        loop.close()


if __name__ == "__main__":
    in_folder(feeds_go_on)
    sys.exit(0)
