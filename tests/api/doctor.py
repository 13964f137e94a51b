"""dripfeed doctor on folders that a test has made ill: each fault is named with what to do, and looking changes nothing."""

import json
import os
import pathlib
import pty
import sqlite3
import subprocess
import sys
import time

from client import Client, HandControl, binary, expect, hand_profile, in_folder, shop


def doctor(data, code=0, **environment):
    done = subprocess.run([str(binary()), "doctor", str(data), "--json"], capture_output=True, text=True, timeout=60, env=os.environ | environment)
    expect(done.returncode == code, f"it ended with {done.returncode}: {done.stdout} {done.stderr}")
    document = json.loads(done.stdout)
    findings = document["findings"]
    expect({one["health"] for one in findings} <= {"ok", "warning", "fault"}, f"{findings}")
    expect(document["faults"] == sum(one["health"] == "fault" for one in findings) and (document["faults"] > 0) == (code == 1), f"{document}")
    expect(all((one["cure"] is None) == (one["health"] == "ok") for one in findings), f"a fault without a cure, or a cure without a fault: {findings}")
    return findings


def find(findings, check, health, *words):
    for one in findings:
        if one["check"] == check and one["health"] == health and all(word in f"{one['text']} {one['cure']}" for word in words):
            return one
    raise AssertionError(f"no {health} of {check} with {words} in {json.dumps(findings, indent=1)}")


def serial_profile(name, url):
    profile = shop.preset("fanuc-0i-lathe", url=url)
    profile["name"] = name
    return profile


def a_healthy_shop(folder):
    control = HandControl()
    client = Client(folder).start()
    client.post("/machines", hand_profile(control))
    data = client.server.data
    os.chmod(data, 0o700)
    expect(not [one for one in doctor(data) if one["health"] == "fault"], "a healthy shop has faults")
    running = doctor(data)
    find(running, "owner", "ok", f"process {client.server.process.pid}", "dripfeed serve")
    find(running, "contents", "ok")
    find(running, "schema", "ok")
    find(running, "lines", "ok", os.environ["DRIPFEED_LINES"])
    text = subprocess.run([str(binary()), "doctor", str(data)], capture_output=True, text=True, timeout=60).stdout
    expect(text.count("\n") >= len(running) and "ok       owner" in text, text)
    client.server.stop()
    find(doctor(data), "owner", "ok", "no server")
    control.close()


def ports(folder):
    """A pseudo-terminal is a port that is there; the others are not."""
    ours, theirs = pty.openpty()
    there = os.ttyname(theirs)
    (folder / "text").write_text("no port")
    client = Client(folder).start()
    for name, path in (("there", there), ("gone", f"{folder}/gone"), ("text", f"{folder}/text")):
        client.post("/machines", serial_profile(name, f"serial:{path}"))
    client.wait_line("there", "idle")
    found = doctor(client.server.data, code=1)
    find(found, "port", "ok", "there", there, "may be used")
    find(found, "port", "ok", "there", f"in use by dripfeed serve", f"pid {client.server.process.pid}")
    find(found, "port", "fault", "gone", "is not there", "/dev/serial/by-id")
    find(found, "port", "fault", "text", "is not a serial port")
    before = client.get("/machines/there")["status"]
    expect(before["line"] == "idle", f"the look at its port changed the line: {before}")
    client.server.stop()
    expect(not [one for one in doctor(client.server.data, code=1) if "in use" in one["text"]], "no one has it now")
    os.close(ours)
    os.close(theirs)


def ill_folders(folder):
    find(doctor(folder / "nowhere", code=1), "folder", "fault", "nowhere")
    client = Client(folder).start()
    client.add_program()
    client.server.stop()
    data = client.server.data
    whole = {path.name: path.stat().st_mtime_ns for path in data.iterdir()}
    os.chmod(data, 0o755)
    find(doctor(data), "folder", "warning", "755", "chmod 700")
    os.chmod(data, 0o700)
    find(doctor(data, code=1, DRIPFEED_LINES="/proc/nowhere/lines") if os.geteuid() != 0 else doctor(data, DRIPFEED_LINES=f"{folder}/new"), "lines", "ok" if os.geteuid() == 0 else "fault")
    expect(not (folder / "new").exists(), "looking made a folder")
    expect({path.name: path.stat().st_mtime_ns for path in data.iterdir() if path.name in whole} == whole, "looking changed a file")
    damage(data, "DROP TRIGGER content_chunk_delete; DELETE FROM content_chunk")
    find(doctor(data, code=1), "contents", "fault", "ledger verify")
    damage(data, f"DROP TRIGGER audit_update; UPDATE audit SET at_ms = {int(time.time() * 1000) + 86_400_000} WHERE seq = 1")
    find(doctor(data, code=1), "clock", "fault", "rows of")
    damage(data, "INSERT INTO migration VALUES (9999, 'from the future', 'x')")
    find(doctor(data, code=1), "schema", "fault", "9999")
    for name in ("dripfeed.db-wal", "dripfeed.db-shm"):
        (data / name).unlink(missing_ok=True)
    (data / "dripfeed.db").write_bytes(b"x" * 8192)
    find(doctor(data, code=1), "store", "fault")
    (data / "dripfeed.db").unlink()
    find(doctor(data), "store", "warning", "first start")


def damage(data, sql):
    connection = sqlite3.connect(data / "dripfeed.db")
    connection.executescript(sql)
    connection.close()


if __name__ == "__main__":
    for test in (a_healthy_shop, ports, ill_folders):
        in_folder(test)
