"""A restart at a line: it is shown, made of what was shown, released for one transfer by its hash, and a job of its own that a person arms.
What is not possible is refused with the nearest lines where it is."""

import hashlib
import sys

from client import DC1, Client, HandControl, expect, hand_profile, in_folder

TEXT = """%
O0070 (SHAFT)
G21 G40 G99
G28 U0. W0.
T0101
G50 S2500
G96 S150 M03
G00 X54. Z3.
G00 X48.
G01 Z-30. F0.2
G00 X54.
G00 Z3.
G00 X44.
G01 Z-25. F0.2
G02 X48. Z-27. R2.
G01 Z-28.
G00 X54.
G00 Z3.
G28 U0. W0.
M05
M30
%
"""
LINE = 13


def preview(client, release, line, role="operator"):
    return client.must("POST", f"/releases/{release}/restart-preview", {"line": line}, role=role)


def shown(client, release):
    made = preview(client, release, LINE)
    expect(made["possible"] and made["compared_moves"] > 0 and not made["diagnostics"], made)
    lines = made["text"].splitlines()
    expect(lines[made["preamble_line"] - 1] == f"(RESTART AT LINE {LINE})", lines)
    expect(lines[made["rest_line"] - 1:] == TEXT.splitlines()[LINE - 1:], "the rest is not that of the program")
    expect("T0101" in lines and "G96 S150 M03" in lines and lines[made["rest_line"] - 2] == "G00 Z3.", lines)
    expect(made["assumptions"] and made["not_held"], made)
    expect(hashlib.sha256(made["text"].encode()).hexdigest() == made["sha256"], "the hash is not that of the text")
    return made


def refused(client, release):
    arc = preview(client, release, 15)
    expect(not arc["possible"] and arc["text"] is None and arc["sha256"] is None, arc)
    expect([d["id"] for d in arc["diagnostics"]] == ["restart-inside"] and arc["diagnostics"][0]["line"] == 15, arc)
    expect(arc["safe_before"] == 14 and arc["safe_after"] == 16, arc)
    client.refuse(409, "POST", f"/releases/{release}/restarts", {"line": 15, "shown_sha256": "0" * 64}, words=["not possible"])
    client.refuse(409, "POST", f"/releases/{release}/restarts", {"line": LINE, "shown_sha256": "0" * 64}, words=["another text"])
    client.refuse(422, "POST", f"/releases/{release}/restarts", {"line": LINE})
    client.refuse(422, "POST", f"/releases/{release}/restart-preview", {"line": 0})
    client.refuse(404, "POST", "/releases/99/restart-preview", {"line": 3})
    client.refuse(403, "POST", f"/releases/{release}/restart-preview", {"line": LINE}, role="viewer")
    client.refuse(403, "POST", f"/releases/{release}/restarts", {"line": LINE, "shown_sha256": "0" * 64}, role="operator")


def made(client, release, sha256):
    restart = client.must("POST", f"/releases/{release}/restarts", {"line": LINE, "shown_sha256": sha256}, role="programmer")
    expect(restart["restart"] == {"release": release, "line": LINE} and restart["sha256"] == sha256, restart)
    expect(restart["state"] in ("draft", "in_review"), restart)
    steps = f"/releases/{restart['id']}/transitions"
    if restart["state"] == "draft":
        client.check(restart["program"])
        client.post(steps, {"to": "in_review"})
    client.refuse(409, "POST", "/jobs", {"release": restart["id"]}, words=["in_review"])
    client.refuse(403, "POST", steps, {"to": "proving", "transfers": 1, "shown_sha256": sha256}, role="programmer")
    for wrong in ({"transfers": 1}, {"transfers": 1, "shown_sha256": "0" * 64}, {"transfers": 2, "shown_sha256": sha256}):
        answer = client.call("POST", steps, wrong | {"to": "proving"}, "approver")
        expect(answer.status in (409, 422), answer)
    released = client.must("POST", steps, {"to": "proving", "transfers": 1, "shown_sha256": sha256, "note": "read it"}, role="approver")
    expect(released["transfers_allowed"] == 1 and released["approved_by"] == "the approver" and released["sign_off"] == "read it", released)
    client.refuse(409, "POST", steps, {"to": "approved", "note": "again"}, words=["one transfer"])
    return released


def sent(client, control, release, of):
    job = client.must("POST", "/jobs", {"release": release["id"]}, role="operator")
    expect(job["restart"] == {"release": of, "line": LINE} and job["state"] == "queued", job)
    control.wait_called(1)
    expect(control.text() == b"", "something was sent before a person armed it")
    client.wait_line("lathe", "idle")
    client.refuse(409, "POST", f"/jobs/{job['id']}/arm", {"rounds": 2}, words=["once"])
    client.post(f"/jobs/{job['id']}/arm")
    control.say(DC1)
    client.wait_job(job["id"], "done")
    expect(f"(RESTART AT LINE {LINE})".encode() in control.text(), control.text())
    note = client.get(f"/jobs/{job['id']}/ledger")["items"][0]["note"]
    expect(f"release {of} at line {LINE}" in note, note)
    client.refuse(409, "POST", "/jobs", {"release": release["id"]}, words=["1 of 1"])
    audit = client.get("/audit?limit=200")["items"]
    for action in ("release.add", "job.add"):
        expect(any(row["action"] == action and f"release {of} at line {LINE}" in row["detail"] for row in audit), f"{action}: {audit}")


def life_of_a_restart(folder):
    control = HandControl()
    client = Client(folder).start()
    client.post("/machines", hand_profile(control))
    program = client.post("/programs", {"name": "O0070", "dialect": "fanuc", "text": TEXT})["id"]
    draft = client.post("/releases", {"program": program, "machine": "lathe"})["id"]
    client.refuse(409, "POST", f"/releases/{draft}/restart-preview", {"line": LINE}, words=["draft"])
    client.post(f"/releases/{draft}/transitions", {"to": "obsolete"})
    of = client.release(program)["id"]
    seen = shown(client, of)
    refused(client, of)
    sent(client, control, made(client, of, seen["sha256"]), of)
    client.server.stop()
    control.close()


if __name__ == "__main__":
    in_folder(life_of_a_restart)
    sys.exit(0)
