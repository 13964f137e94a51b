#!/usr/bin/env python3
"""The demo shop: the server on its own data folder, one simulated control per dialect on pseudo-terminals and a simulated PLC, the shipped families, and a
released roll to feed. Everything stays in the data folder; ends with Ctrl-C."""

import os
import pathlib
import signal
import sys
import time

import shop

# Name, preset, line (None: a PLC with a mailbox), part, name of the program.
MACHINES = [
    ("lathe-fanuc", "fanuc-0i-lathe", {"baud": 9600, "framing": "7E2"}, "ROLL-196", "O0100"),
    ("lathe-sinumerik", "sinumerik-840d-lathe", {"baud": 19200, "framing": "8N1"}, "ROLL-196", "ROLL_1"),
    ("lathe-mazak", "mazak-qtn", {"baud": 9600, "framing": "7E2"}, "ROLL-196", "O0300"),
    ("mill-m80", "mitsubishi-m80-cvm800", {"baud": 19200, "framing": "7E2"}, "POCKET-60", "O0400"),
    ("lathe-plc", "fanuc-0i-lathe", None, "ROLL-196", "O0200"),
]
PARTS = [
    {"number": "ROLL-196", "family": "hyperbolic-roll", "values": {"roll_length": "196 mm"}},
    {"number": "POCKET-60", "family": "round-pocket", "values": {}},
]


def add_once(call, *arguments):
    """Adds what is not there yet: the demo's data outlives it."""
    try:
        return call(*arguments)
    except shop.Refused as refused:
        if refused.status != 409:
            raise
        return None


def set_up(server, lines):
    for family in sorted((shop.ROOT / "deploy/families").glob("*.family")):
        add_once(server.add_family, family)
    is_new = [add_once(server.post, "/parts", part) is not None for part in PARTS]
    for name, profile, part, program in lines:
        profile["name"] = name
        add_once(server.add_machine, profile)
        if not all(is_new):
            continue
        rendered = server.post("/render", {"part": part, "machine": name, "delivery": "drip", "name": program})
        check = server.post("/checks", {"program": rendered["program"], "machine": name, "delivery": "drip"})
        if check["verdict"] == "fail":
            raise RuntimeError(f"{program} for {name}: {check}")
        if check["verdict"] != "pass":
            server.post(f"/checks/{check['id']}/waivers", {"reason": "the demo's simulated control takes it"})
        release = server.release(rendered["program"], name)
        server.post("/jobs", {"release": release["id"]})


def main():
    binary, data = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    port = int(sys.argv[3]) if len(sys.argv) > 3 else 8840
    data.mkdir(parents=True, exist_ok=True)
    os.environ.setdefault("DRIPFEED_LINES", str(data.resolve() / "lines"))
    lines, controls = [], []
    for index, (name, preset, line, part, program) in enumerate(MACHINES):
        url = f"pty:{data.resolve()}/{name}.tty" if line else f"modbus-tcp://127.0.0.1:{port + 1 + index}/1"
        profile = shop.preset(preset, url=url, **(line or {}))
        profile["buffer"]["bytes"] = 1024
        lines.append((name, profile, part, program))
        machine = shop.ROOT / "deploy/machines" / f"{preset}.json"
        link = url + (f"?baud={line['baud']}&framing={line['framing']}" if line else "")
        controls.append(shop.Control(binary, link, machine, "--speed", "100", "--operator", "4", "--repeat").start())
    server = shop.Server(binary, data, port).start()
    stopped = []
    signal.signal(signal.SIGTERM, lambda *_: stopped.append(True))
    try:
        set_up(server, lines)
        print(f"dripfeed is at   http://127.0.0.1:{port}/")
        print(f"first token      {server.token()}")
        print("machines         " + ", ".join(name for name, *_ in MACHINES) + " (simulated)")
        print("Arm a queued job on the page; the simulated operator presses START every few seconds. Ctrl-C ends the demo.", flush=True)
        while not stopped and server.alive():
            time.sleep(0.5)
    except KeyboardInterrupt:
        pass
    finally:
        if server.alive():
            server.stop()
        for control in controls:
            control.process.terminate()
    return 0


if __name__ == "__main__":
    sys.exit(main())
