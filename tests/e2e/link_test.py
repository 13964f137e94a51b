"""dripfeed link test on a line whose data wires are bridged: a pseudo-terminal that echoes each character after its line time. And
on a line where nothing comes back."""

import collections
import json
import os
import subprocess
import threading
import time
import tty

import rig

CHAR_S = 11 / 9600


class Plug:
    """Echoes what is written to a pty, each character one line time after the one before; `delay_s` more for the return."""

    def __init__(self, folder, delay_s=0.0, echoes=True):
        self.master, slave = os.openpty()
        tty.setraw(slave)
        self.path = folder / "line"
        self.path.symlink_to(os.ttyname(slave))
        self.slave = slave
        self.delay_s = delay_s
        self.echoes = echoes
        self.alive = True
        self.thread = threading.Thread(target=self.run, daemon=True)
        os.set_blocking(self.master, False)
        self.thread.start()

    def run(self):
        waiting = collections.deque()
        free_at = 0.0
        while self.alive:
            now = time.monotonic()
            try:
                for byte in os.read(self.master, 4096):
                    free_at = max(free_at, now) + CHAR_S
                    waiting.append((free_at + self.delay_s, byte))
            except BlockingIOError:
                pass
            while waiting and waiting[0][0] <= time.monotonic():
                _, byte = waiting.popleft()
                if self.echoes:
                    os.write(self.master, bytes([byte]))
            time.sleep(0.0002)

    def close(self):
        self.alive = False
        self.thread.join()
        os.close(self.master)
        os.close(self.slave)


def run_test(plug, *arguments):
    command = [str(rig.binary()), "link", "test", "--link", f"pty:{plug.path}?baud=9600&framing=7E2", "--json", "--round-trips", "5", "--holds", "3", *arguments]
    return subprocess.run(command, capture_output=True, text=True, timeout=60)


def bridged(folder):
    plug = Plug(folder, delay_s=0.020)
    try:
        done = run_test(plug)
    finally:
        plug.close()
    rig.expect(done.stdout, f"exit {done.returncode}: {done.stderr}")
    result = json.loads(done.stdout)
    rig.expect(abs(result["char_ms"] - CHAR_S * 1e3) < 1e-3, f"{result}")
    rig.expect(result["latency_ms"]["median"] >= 19.0, f"20 ms of delay are seen: {result}")
    rig.expect(result["latency_chars"] >= 17, f"and are 18 characters: {result}")
    rig.expect(result["wrong"] == 0 and result["after_dc3"]["holds"] == 3, f"{result}")
    # What is below us when the DC3 comes back was written during its 20 ms, so it is more than a Fanuc's budget of 10.
    rig.expect(result["after_dc3"]["median"] > 10 and not result["kept"] and done.returncode == 1, f"{result}")


def not_bridged(folder):
    plug = Plug(folder, echoes=False)
    try:
        done = run_test(plug)
    finally:
        plug.close()
    rig.expect(done.returncode == 1 and "0 of 1 characters came back" in done.stderr, f"{done}")


if __name__ == "__main__":
    for test in (bridged, not_bridged):
        rig.in_folder(test)
