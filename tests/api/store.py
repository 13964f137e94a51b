"""The store as a whole, by the API: its room, a verification that finds what was altered, backups that restore to the same shop. A line feeds meanwhile
and does not notice."""

import json
import os
import sqlite3
import subprocess
import threading

from client import DC1, Client, HandControl, binary, expect, expect_problem, hand_profile, in_folder, plain_program, shop


def run(*arguments, code=0):
    done = subprocess.run([str(binary()), *map(str, arguments)], capture_output=True, text=True, timeout=120)
    expect(done.returncode == code, f"{arguments} ended with {done.returncode}: {done.stdout} {done.stderr}")
    return done


def shop_with_programs(folder, *arguments):
    client = Client(folder, *arguments).start()
    for i in range(3):
        client.post("/programs", {"name": f"O{i + 1:04}", "dialect": "fanuc", "text": plain_program(20_000 + i)})
    return client


def a_backup_is_the_same_shop(folder):
    client = shop_with_programs(folder)
    room = client.get("/store")
    expect(room["engine"] == "sqlite" and room["bytes"] > 100_000 and room["free_bytes"] > 0 and room["why_no_backups"] is None, f"{room}")
    expect(client.get("/backups")["items"] == [], "a shop without a backup lists one")
    answer = client.call("POST", "/backups")
    made = answer.document
    expect(answer.status == 201 and answer.headers["Location"] == f"/api/v1/backups/{made['backup']}", f"{answer}")
    expect(made["whole"] and made["holds"]["programs"] == 3 and made["kept"] is None, f"{made}")
    listed = client.get("/backups")["items"]
    expect([(one["name"], one["bytes"]) for one in listed] == [(made["backup"], made["bytes"])], f"{listed}")
    file = client.server.data / "backups" / made["backup"]
    expect(file.stat().st_mode & 0o077 == 0 and file.parent.stat().st_mode & 0o077 == 0, "others may read the backup")
    rows = client.get("/audit?action=backup.add")["items"]
    expect([row["subject"] for row in rows] == [f"backup/{made['backup']}"] and json.loads(rows[0]["detail"])["bytes"] == made["bytes"], f"{rows}")

    elsewhere = folder / "elsewhere"
    run("restore", file, elsewhere)
    names = {row["name"] for row in client.get("/programs")["items"]}
    verified = json.loads(run("ledger", "verify", elsewhere, "--json").stdout)
    expect(verified["whole"] and verified["contents"]["count"] == made["contents"]["count"], f"{verified}")
    with sqlite3.connect(elsewhere / "dripfeed.db") as store:
        expect({name for name, in store.execute("SELECT name FROM program")} == names, "the restored shop has other programs")

    expect(client.call("DELETE", f"/backups/{made['backup']}").status == 204 and not file.exists(), "the backup is still there")
    expect_problem(client.call("DELETE", f"/backups/{made['backup']}"), 404, "a backup that is not there")
    expect_problem(client.call("DELETE", "/backups/..%2Fdripfeed.db"), 404, "a file that is no backup")
    expect((client.server.data / "dripfeed.db").exists(), "the store is gone")
    client.server.stop()


def an_altered_row_is_found(folder):
    client = shop_with_programs(folder)
    expect(client.post("/store/verify")["whole"], "a sound store is not")
    client.server.stop()
    with sqlite3.connect(client.server.data / "dripfeed.db") as store:
        (kept,), = store.execute("SELECT sql FROM sqlite_master WHERE name = 'audit_update'")
        store.executescript("DROP TRIGGER audit_update; UPDATE audit SET actor = 'mallory' WHERE seq = 2;" + kept)
    client.start()
    found = client.post("/store/verify")
    expect(not found["whole"] and [fault["subject"] for fault in found["faults"]] == ["audit/2"], f"{found}")
    problem = client.refuse(409, "POST", "/backups", words=["audit/2"])
    expect(problem["said"]["id"] == "store_has_faults" and client.get("/backups")["items"] == [], f"a backup of a store with a fault was made: {problem}")
    client.server.stop()


def a_line_does_not_notice(folder):
    client = shop_with_programs(folder)
    control = HandControl()
    client.post("/machines", hand_profile(control, "lathe"))
    client.wait_line("lathe", "idle")
    program = client.add_program(3000)["id"]
    job = client.queue(client.release(program, "lathe")["id"])
    client.post(f"/jobs/{job}/arm")
    control.say(DC1)
    control.wait_bytes(200)
    answers = []
    asking = [threading.Thread(target=lambda path=path: answers.append(client.call("POST", path))) for path in ("/backups", "/store/verify")]
    for thread in asking:
        thread.start()
    control.wait_bytes(2000)
    for thread in asking:
        thread.join()
    expect(all(answer.status in (200, 201, 409) for answer in answers) and any(answer.status < 300 for answer in answers), f"{answers}")
    expect(client.server.job(job)["state"] == "feeding", f"{client.server.job(job)}")
    client.server.stop()
    control.close()


def what_refuses_a_backup(folder):
    blocked = folder / "a file"
    blocked.write_text("no folder")
    client = Client(folder, "--backups", str(blocked / "backups")).start()
    problem = expect_problem(client.call("POST", "/backups"), 503, "a folder that cannot be made")
    expect(str(blocked) in problem["detail"], f"{problem}")
    client.server.stop()
    unfinished = client.server.data / "backups"
    unfinished.mkdir()
    (unfinished / "dripfeed-2026-01-01T000000Z.backup.unfinished").write_text("what a killed process left")
    (unfinished / "notes.txt").write_text("a person's")
    client.server.arguments = []
    client.start()
    made = client.post("/backups")
    expect(sorted(os.listdir(unfinished)) == sorted([made["backup"], "notes.txt"]), f"{os.listdir(unfinished)}")
    client.server.stop()


if __name__ == "__main__":
    for test in (a_backup_is_the_same_shop, an_altered_row_is_found, a_line_does_not_notice, what_refuses_a_backup):
        in_folder(test)
