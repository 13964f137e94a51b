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
    for family in server.get("/families?limit=200")["items"]:
        add_once(server.post, "/parts", {"number": f"{family['name'].upper()}-1", "family": family["name"], "values": {}})
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
    if all(is_new):
        add_desk(server)


# A text that was not made here: its fault shows in the editor, and its second revision mends it.
FLANGE = """%
O0700 (PUMP FLANGE)
G21 G17 G90 G94 G54
T4 M06
G43 H4
M03 S1200
G00 X0. Y0. Z50.
G99 G81 X30. Y0. Z-12. R2. F180.
X0. Y30.
X-30. Y0.
{}G80
G00 Z100.
M30
%
"""


def add_desk(server):
    """What the desk shows: a text with two revisions in a folder, a release that waits for a decision, an order."""
    program = server.post("/programs", {"name": "O0700", "dialect": "mitsubishi-m80", "text": FLANGE.format("X0. Y-3O.\n")})
    server.post(f"/programs/{program['id']}/revisions", {"text": FLANGE.format("X0. Y-30.\n")}, **{"If-Match": '"1"'})
    server.request("PATCH", f"/api/v1/programs/{program['id']}", {"folder": "pumps", "tags": ["flange"]})
    server.post("/checks", {"program": program["id"], "machine": "mill-m80", "delivery": "drip"})
    release = server.post("/releases", {"program": program["id"], "machine": "mill-m80", "delivery": "drip"})
    server.post(f"/releases/{release['id']}/transitions", {"to": "in_review", "note": "drilled for the new pump"})
    server.post("/orders", {"number": "4711", "operation": "20", "part": "ROLL-196", "quantity": 12, "machine": "lathe-fanuc"})


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
