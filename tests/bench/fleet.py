"""Many simulated controls on one server, in real time: N lathes at 9600 baud on pseudo-terminals, each fed a program that lasts, for so many
seconds. With --load a million-block check, a backup of the data and a watcher of the page run at the same time. Shown are the processor time of the
server and of the fleet, the server's memory, what came after the DC3s (worst, 99th percentile), the line use while not held, and how often a
line was seen to stand for a reason of ours. With --never-held the controls run their blocks in no time, so that all lines send all the time.
By hand: fleet.py build/release/dripfeed [--controls 512] [--seconds 300] [--load] [--never-held]"""

import argparse
import collections
import json
import os
import pathlib
import random
import sqlite3
import subprocess
import sys
import tempfile
import threading
import time
import urllib.request

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "deploy"))
import shop  # noqa: E402

BAUD, BITS = 9600, 11
THEIRS = {None, "", "held by DC3", "waiting for DC1", "waiting for end"}  # why a line may stand without our fault
LOOKS = 64  # lines that are looked at each second


def text(seconds):
    """Long enough, and quick enough to run that the line is the bottleneck now and the motion then: so there are holds."""
    lines = ["%", "O0001", "G21 G18 G40 G99", "G55", "T0101", "G97 S500 M03", "G00 X100. Z10."]
    size = 0
    while size < seconds * BAUD / BITS:
        i = len(lines)
        lines.append(f"G01 X{50 + i % 7 * (3 if i // 200 % 2 else 0.02):.3f} Z{-(i % 4000) * 0.05:.3f} F0.9")
        size += len(lines[-1]) + 1
    return "\n".join(lines + ["G00 X100.", "M05", "M30", "%"]) + "\n"


def processor_s(pid):
    fields = pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def memory_mib(pid):
    rows = dict(line.split(":", 1) for line in pathlib.Path(f"/proc/{pid}/status").read_text().splitlines())
    return int(rows["VmRSS"].split()[0]) / 1024


def watch(server, until):
    """A page that stays open: the live stream is read as it comes."""
    call = urllib.request.Request(f"http://127.0.0.1:{server.port}/api/v1/events", headers={"Authorization": f"Bearer {server.token()}", "Accept": "text/event-stream"})
    try:
        with urllib.request.urlopen(call, timeout=30) as stream:
            while time.monotonic() < until and stream.readline():
                pass
    except OSError as error:
        print(f"the watcher ended: {error}")


def load(server, folder, until, checked):
    """A check of a million blocks, again and again, copies of the database, and a page. `checked` gets what each check took, in seconds."""
    blocks = "".join(f"G01X{i % 90}.Z{-(i % 70)}.F0.3\n" for i in range(1_000_000))
    big = server.post("/programs", {"name": "O0002", "dialect": "fanuc", "text": f"%\nO0002\nG21 G18 G40 G99\n{blocks}M30\n%\n"})

    def check():
        while time.monotonic() < until:
            begin = time.monotonic()
            try:
                server.post("/checks", {"program": big["id"], "machine": "m1", "delivery": "memory"})
            except OSError:
                if time.monotonic() < until:  # after it the server is ended
                    raise
            checked.append(time.monotonic() - begin)

    def backup():
        while time.monotonic() < until:
            source = sqlite3.connect(next(folder.glob("data/*.db")))
            copy = sqlite3.connect(folder / "copy.db")
            source.backup(copy, pages=64, sleep=0.01)
            copy.close()
            source.close()
            time.sleep(2)

    return [threading.Thread(target=work, daemon=True) for work in (check, backup, lambda: watch(server, until))]


class Fleet:
    """Controls on pseudo-terminals in a folder, and their machines m1, m2, … on a server."""

    def __init__(self, binary, folder, controls, speed="1"):
        self.folder, self.controls = folder, controls
        self.names = [f"m{n}" for n in range(1, controls + 1)]
        # A pty has no FIFO and no time-out of one, as the fleet's options state. But a thread of the kernel carries its characters, and has to share the
        # processors: the latency is for that.
        self.profile = shop.preset("fanuc-0i-lathe", baud=BAUD, framing="7E2", end_by_quiet_s=2.0, arming_minutes=60, unsent=4, latency_chars=6)
        self.profile["buffer"]["bytes"] = 2048
        self.profile["link"]["url"] = f"pty:{folder}/line-1"
        machine = folder / "m.json"
        machine.write_text(json.dumps(self.profile))
        self.process = subprocess.Popen([str(binary), "simulate", "--link", f"pty:{folder}/line-{{n}}", "--count", str(controls), "--machine", str(machine),
                                         "--operator", "1", "--uart", "ideal", "--speed", speed, "--json"],
                                        stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        shop.wait_for("the fleet", lambda: (folder / f"line-{controls}").is_symlink(), 60)

    def add_machines(self, server):
        for n, name in enumerate(self.names, 1):
            self.profile["name"], self.profile["link"]["url"] = name, f"pty:{self.folder}/line-{n}"
            server.add_machine(self.profile)

    def release(self, server, seconds):
        """Of a program that lasts so long, for each machine."""
        program = server.post("/programs", {"name": "O0001", "dialect": "fanuc", "text": text(seconds)})
        found = {}
        for name in self.names:
            check = server.post("/checks", {"program": program["id"], "machine": name, "delivery": "drip"})
            if check["verdict"] == "warn":  # a line of 9600 baud starves such a program, and here it is meant to
                server.post(f"/checks/{check['id']}/waivers", {"reason": "a program for the bench"})
            found[name] = server.release(program["id"], name)["id"]
        return found

    def feed(self, server, releases):
        for name in self.names:
            job = server.post("/jobs", {"release": releases[name]})["id"]
            server.post(f"/jobs/{job}/arm", {})
        shop.wait_for("all lines to be on", lambda: all(server.status(n)["line"] in ("feeding", "held") for n in self.names), 120, 1)

    def finish(self):
        """What the controls counted: each, and all together."""
        self.process.terminate()
        report = json.loads(self.process.communicate(timeout=120)[0])
        return (report["controls"], report["total"]) if self.controls > 1 else ([report], report)


def said(reports, total):
    return (f"{total['bytes']} characters, {total['holds']} holds, after DC3 worst {total['after_dc3_max']}, p99 {total.get('after_dc3_p99')}; "
            f"line use at least {min(r['line_use'] for r in reports):.4f}, mean {sum(r['line_use'] for r in reports) / len(reports):.4f}; "
            f"alarms {sum(1 for r in reports if r['alarm'])}")


def run(given, folder):
    binary = pathlib.Path(given.binary).resolve()
    fleet = Fleet(binary, folder, given.controls, "1000" if given.never_held else "1")
    server = shop.Server(binary, folder / "data").start()
    fleet.add_machines(server)
    releases = fleet.release(server, given.seconds * 1.2 + 60)
    print(f"{len(fleet.names)} machines are set up", flush=True)
    fleet.feed(server, releases)
    until = time.monotonic() + given.seconds
    checked = []
    loaders = load(server, folder, until, checked) if given.load else []
    for thread in loaders:
        thread.start()
    begin, wall = (processor_s(server.process.pid), processor_s(fleet.process.pid)), time.monotonic()
    most_mib, stood = 0.0, collections.Counter()
    while time.monotonic() < until:
        most_mib = max(most_mib, memory_mib(server.process.pid))
        stood.update(server.status(n)["stall"] for n in random.sample(fleet.names, min(LOOKS, len(fleet.names))))
        time.sleep(min(1.0, max(0.0, until - time.monotonic())))
    span = time.monotonic() - wall
    used = (processor_s(server.process.pid) - begin[0]) / span, (processor_s(fleet.process.pid) - begin[1]) / span
    states = [server.status(n) for n in fleet.names]
    reports, total = fleet.finish()
    server.kill()
    if checked:
        print(f"{len(checked)} checks of a million blocks at the same time, the longest {max(checked):.1f} s")
    ours = {stall: count for stall, count in stood.items() if stall not in THEIRS}
    lost = [s for s in states if s["line"] not in ("feeding", "held", "draining", "idle")]
    print(f"{given.controls} controls, {span:.0f} s: server {used[0]:.2f} cores, fleet {used[1]:.2f} cores, server {most_mib:.0f} MiB; "
          f"{said(reports, total)}; lines in another state: {len(lost)}; stood for us in {ours or 'none'} of {stood.total()} looks; "
          f"histogram {total['after_dc3_histogram']}")
    return 1 if lost or any(r["alarm"] for r in reports) else 0


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("binary")
    options.add_argument("--controls", type=int, default=512)
    options.add_argument("--seconds", type=float, default=300)
    options.add_argument("--load", action="store_true")
    options.add_argument("--never-held", action="store_true")
    with tempfile.TemporaryDirectory(prefix="fleet-", ignore_cleanup_errors=True) as folder:
        os.environ["DRIPFEED_LINES"] = f"{folder}/lines"
        sys.exit(run(options.parse_args(), pathlib.Path(folder)))


if __name__ == "__main__":
    main()
