#!/usr/bin/env python3
"""The main job, headless: a part family is rendered for simulated controls, checked, released, armed and fed over serial lines and Modbus; then
what arrived is compared with what was rendered. Prints a table; exits 0 when all of it is as it should be."""

import hashlib
import json
import os
import pathlib
import sys
import tempfile

import shop

# What each simulated control is and how its line speaks. Speeds are those of the simulated motion, so that a roll of half an hour takes seconds; the
# line's time is real.
STATIONS = [
    {"machine": "fanuc-roll", "preset": "fanuc-0i-lathe", "line": {"baud": 9600, "framing": "7E2"}, "name": "O0100", "speed": 20},
    {"machine": "sinumerik-roll", "preset": "sinumerik-840d-lathe", "line": {"baud": 19200, "framing": "8N1"}, "name": "ROLL_1", "speed": 40},
    {"machine": "plc-roll", "preset": "fanuc-0i-lathe", "line": None, "name": "O0200", "speed": 2000},
]
LEAST_LINE_USE = 0.97
MOST_AFTER_DC3 = 10


def write_profile(folder, station):
    """The station's profile for the server, and the one for the simulated control."""
    line = station["line"]
    url = f"pty:{folder}/{station['machine']}" if line else f"modbus-tcp://127.0.0.1:{shop.free_port()}/1"
    profile = shop.preset(station["preset"], url=url, end_by_quiet_s=2.0, **(line or {}))
    profile["name"] = station["machine"]
    # A small buffer, so that the control holds the line many times.
    profile["buffer"]["bytes"] = 512
    path = folder / f"{station['machine']}.json"
    path.write_text(json.dumps(profile))
    return profile, path, url


def feed(server, binary, folder, station):
    """Render, check, release, arm and feed one station; the row of the table."""
    machine = station["machine"]
    profile, path, url = write_profile(folder, station)
    control = shop.Control(binary, url, path, "--operator", "2", "--speed", station["speed"], "--record", folder / f"{machine}.wire").start()
    server.add_machine(profile)
    rendered = server.post("/render", {"part": "ROLL-196", "machine": machine, "mode": "auto", "delivery": "drip", "name": station["name"]})
    check = server.post("/checks", {"program": rendered["program"], "machine": machine, "delivery": "drip"})
    if check["verdict"] not in ("pass", "warn"):
        raise AssertionError(f"{machine}: verdict {check['verdict']}: {json.dumps(check, indent=1)[:3000]}")
    release = server.release(rendered["program"], machine)
    job = server.post("/jobs", {"release": release["id"]})
    server.wait_line(machine, "idle")
    server.post(f"/jobs/{job['id']}/arm", {})
    ended = server.wait_job(job["id"], "done", "failed", "cancelled", seconds=180)
    report = control.finish(60)
    text = server.request("GET", f"/api/v1/programs/{rendered['program']}/text", text=True)
    ledger = server.get(f"/jobs/{job['id']}/ledger?limit=200")
    return {
        "machine": machine, "line": f"{profile['link']['baud']} {profile['link']['framing']}" if station["line"] else "Modbus TCP",
        "mode": rendered["mode"], "blocks": rendered["blocks"], "bytes": rendered["bytes"], "verdict": check["verdict"], "job": ended["state"], "reason": ended["reason"],
        # A text is what lies between the first and the last '%'; the EOB after it is the tape's.
        "rendered": hashlib.sha256(text[: text.rindex(b"%") + 1] if station["line"] else text).hexdigest(), "received": report["text_sha256"], "report": report, "interval": ledger["interval"], "serial": bool(station["line"]),
    }


def faults(row, with_speed):
    """What is not as it should be, in words; line use only where the machine is ours alone."""
    report = row["report"]
    found = []
    if row["job"] != "done":
        found.append(f"the job is {row['job']}: {row['reason']}")
    if row["received"] != row["rendered"]:
        found.append("the text received is not the text rendered")
    if report["alarm"]:
        found.append(f"alarm {report['alarm']}")
    if report["blocks_run"] == 0:
        found.append("no block was run")
    if row["serial"]:
        if report["after_dc3_max"] > MOST_AFTER_DC3:
            found.append(f"{report['after_dc3_max']} characters after DC3")
        if report["holds"] == 0:
            found.append("the control never held the line, so nothing was tried")
        if with_speed and report["line_use"] < LEAST_LINE_USE:
            found.append(f"line use {report['line_use']:.3f}")
        if report["parity_errors"]:
            found.append(f"{report['parity_errors']} parity errors")
    return found


def print_table(rows):
    head = f"{'machine':15} {'line':11} {'mode':9} {'blocks':>6} {'bytes':>6} {'verdict':8} {'job':5} {'text':5} {'holds':>5} {'after DC3':>9} {'line use':>8}"
    print(head)
    print("-" * len(head))
    for row in rows:
        report = row["report"]
        serial = row["serial"]
        print(f"{row['machine']:15} {row['line']:11} {row['mode']:9} {row['blocks']:6} {row['bytes']:6} {row['verdict']:8} {row['job']:5} "
              f"{'same' if row['received'] == row['rendered'] else 'OTHER':5} {report['holds'] if serial else '-':>5} "
              f"{'<= ' + str(report['after_dc3_max']) if serial else '-':>9} {format(report['line_use'], '.3f') if serial else '-':>8}")
    for row in rows:
        if row["serial"]:
            counts = ", ".join(f"{n}: {count}" for n, count in enumerate(row["report"]["after_dc3_histogram"]) if count)
            print(f"{row['machine']}: characters after its DC3 (count of holds)  {counts or 'none'}")


def main():
    binary = pathlib.Path(sys.argv[1])
    with tempfile.TemporaryDirectory(prefix="dripfeed-smoke-") as name:
        os.environ["DRIPFEED_LINES"] = f"{name}/lines"
        folder = pathlib.Path(name)
        server = shop.Server(binary, folder / "data").start()
        try:
            server.add_family(shop.ROOT / "deploy/families/hyperbolic-roll.family")
            server.post("/parts", {"number": "ROLL-196", "family": "hyperbolic-roll", "values": {"roll_length": "196 mm", "angle_step": "0.2 deg"}})
            rows = [feed(server, binary, folder, station) for station in STATIONS]
        finally:
            server.stop()
    print_table(rows)
    wrong = [f"{row['machine']}: {fault}" for row in rows for fault in faults(row, "--without-speed" not in sys.argv)]
    for sentence in wrong:
        print(f"WRONG {sentence}")
    print("smoke: all as it should be" if not wrong else "smoke: failed")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
