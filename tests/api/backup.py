"""dripfeed backup while eight lines feed, dripfeed restore elsewhere: the same shop by every hash, and nothing that was on a line goes on by
itself. What a restore refuses leaves all as it was."""

import hashlib
import json
import os
import sqlite3
import subprocess
import sys
import time

from client import DC1, Client, HandControl, binary, expect, hand_profile, in_folder, plain_program, shop, verify
from exposition import Scrape

LINES = 8


def run(*arguments, code=0):
    done = subprocess.run([str(binary()), *map(str, arguments)], capture_output=True, text=True, timeout=120)
    expect(done.returncode == code, f"{arguments} ended with {done.returncode}: {done.stdout} {done.stderr}")
    return done


def feeding_shop(folder):
    """Every line is in the middle of a long program."""
    client = Client(folder).start()
    program = client.add_program(3000)["id"]
    for i in range(6):  # so that a copy takes a while
        client.post("/programs", {"name": f"LONG{i}", "dialect": "fanuc", "text": f"%\nO{i + 1}\n" + "".join(f"G01 X{n % 977}.{n % 10} Z-{n * 7919 % 1000003}.\n" for n in range(200_000)) + "M30\n%\n"})
    controls = [HandControl() for _ in range(LINES)]
    for i, control in enumerate(controls):
        client.post("/machines", hand_profile(control, f"lathe-{i}"))
        client.wait_line(f"lathe-{i}", "idle")
        job = client.queue(client.release(program, f"lathe-{i}")["id"])
        client.post(f"/jobs/{job}/arm")
        control.say(DC1)
    for control in controls:
        control.wait_bytes(200)
    return client, controls


def metrics(client):
    return Scrape(client.call("GET", "/metrics", role="viewer").body.decode())


def print_waits(before, after, seconds):
    """What the lines waited for the ledger while the copy was made: shown, and not asserted."""
    def grown(name, **labels):
        return (after.value(name, **labels) or 0) - (before.value(name, **labels) or 0)
    stalls = [grown("dripfeed_line_stalls_total", machine=f"lathe-{i}", stall="waiting for ledger") for i in range(LINES)]
    turns, took = (grown(f"dripfeed_store_write_seconds_{part}", turn="ledger") for part in ("count", "sum"))
    print(f"a backup of {seconds:.2f} s: stalls for the ledger {stalls}, {turns:.0f} turns of the ledger of {1000 * took / max(turns, 1):.1f} ms")


def the_same_shop(folder):
    client, controls = feeding_shop(folder)
    backup = folder / "shop.backup"
    before_it, began = metrics(client), time.monotonic()
    document = json.loads(run("backup", client.server.data, backup, "--json").stdout)
    seconds = time.monotonic() - began
    expect(document["whole"] and document["holds"]["machines"] == LINES and document["ledger"]["jobs"] == LINES, f"{document}")
    expect(document["bytes"] == backup.stat().st_size > 5_000_000 and backup.stat().st_mode & 0o077 == 0, f"{document}")
    expect([path.name for path in folder.glob("shop.backup*")] == ["shop.backup"], "something lies beside it")
    for i, control in enumerate(controls):
        before = len(control.text())
        shop.wait_for(f"line {i} to go on", lambda: len(control.text()) > before)
    print_waits(before_it, metrics(client), seconds)
    before = client.everything()
    texts = {one["id"]: client.call("GET", f"/programs/{one['id']}/text").body for one in before["programs"]}
    refused = run("restore", backup, client.server.data, "--replace", code=2).stderr
    expect("server" in refused, f"over a running server: {refused}")
    expect(client.get("/machines/lathe-0")["status"]["line"] == "feeding", "a refused restore stopped a feed")
    client.server.stop()
    os.environ["DRIPFEED_LINES"] = str(folder / "lines-elsewhere")
    elsewhere = folder / "elsewhere" / "data"
    said = run("restore", backup, elsewhere).stdout
    expect(f"{LINES} machines" in said and document["audit"]["head"] in said, said)
    expect(verify(elsewhere)["audit"]["head"] == document["audit"]["head"], "another audit")
    expect(elsewhere.stat().st_mode & 0o077 == 0, "the folder is open to others")
    sent = [control.calls for control in controls]
    other = Client(folder / "elsewhere")
    other.tokens = client.tokens  # those of the backup are valid
    other.server.start()
    after = other.everything()
    for kind in ("machines", "families", "parts", "programs", "checks", "releases"):
        expect(after[kind] == before[kind], f"the {kind} are others")
    for program, text in texts.items():
        now = other.call("GET", f"/programs/{program}/text").body
        expect(hashlib.sha256(now).digest() == hashlib.sha256(text).digest(), f"program {program} has another text")
    nothing_goes_on(other, controls, sent)
    other.server.stop()


def nothing_goes_on(other, controls, calls_before):
    for i, control in enumerate(controls):
        control.wait_called(calls_before[i] + 1)
        control.say(DC1)
    for i, control in enumerate(controls):
        expect(control.wait_quiet() == b"", f"lathe-{i}: something was sent after a restore")
        expect(other.get(f"/machines/lathe-{i}")["status"]["line"] == "torn", f"lathe-{i} may be armed, and what is at its control no one knows")
    expect({job["state"] for job in other.get("/jobs")["items"]} == {"interrupted"}, "the jobs are not interrupted")


def what_is_refused(folder):
    client = Client(folder).start()
    client.add_program(5)
    data, backup = client.server.data, folder / "a.backup"
    said = run("backup", data, backup).stdout
    expect("1 programs" in said and "schema" in said, said)
    whole = backup.read_bytes()
    run("backup", data, backup, code=2)
    run("backup", data, data / "dripfeed.db", code=2)
    run("backup", folder / "nowhere", folder / "b.backup", code=2)
    run("backup", data, folder / "no" / "folder", code=2)
    client.add_program(6, "O0043")
    client.server.stop()
    expect("--replace" in run("restore", backup, data, code=2).stderr, "it does not say how")
    newer = folder / "newer.backup"
    newer.write_bytes(whole)
    with sqlite3.connect(newer) as connection:
        connection.execute("INSERT INTO migration VALUES (9999, 'from the future', 'x')")
    connection.close()
    expect("9999" in run("restore", newer, data, "--replace", code=2).stderr, "it does not name the schema")
    altered = folder / "altered.backup"
    altered.write_bytes(whole)
    with sqlite3.connect(altered) as connection:
        connection.executescript("DROP TRIGGER audit_update; UPDATE audit SET actor = 'nobody' WHERE seq = 1")
    connection.close()
    expect("audit/1" in run("restore", altered, data, "--replace", code=1).stderr, "it does not name the fault")
    torn = folder / "torn.backup"
    torn.write_bytes(whole[:len(whole) // 2])
    expect(run("restore", torn, data, "--replace", code=1).stderr, "half a backup was taken")
    expect(backup.read_bytes() == whole, "the backup was changed")
    client.server.start()
    expect(len(client.get("/programs")["items"]) == 2, "a refused restore changed the store")
    client.server.stop()
    said = run("restore", backup, data, "--replace").stdout
    expect("dripfeed.db.replaced-1" in said and (data / "dripfeed.db.replaced-1").exists(), said)
    client.server.start()
    expect(len(client.get("/programs")["items"]) == 1, "it is not the state of the backup")
    client.server.stop()


if __name__ == "__main__":
    for test in (what_is_refused, the_same_shop):
        in_folder(test)
