"""Every field that names a thing, at its limits: 200 bytes are taken, and lead back to the thing by their Location; 201 bytes, 65,520 bytes, controls
and what is not UTF-8 are refused with the field's pointer, and the server goes on."""

import json
import subprocess
import sys
import urllib.parse

from client import ROLL, Client, HandControl, binary, expect, hand_profile, in_folder, plain_program, shop

LONGEST = "ä" * 98 + "/%?x"  # 200 bytes
WRONG = ["", " a", "a ", "a\u0007b", "a\nb", "a\rSet-Cookie: x=y", "\u001b[31m", "a\u0085", "a\u202eb", ".", "..", "x" * 201, "ä" * 101, "x" * 65520]


def fields():
    """(what, path, the body for a name, pointer, where the thing is found by its name)"""
    return [
        ("machine", "/machines", lambda name: hand_profile(HandControl(), name), "/name", "/machines/"),
        ("part", "/parts", lambda name: {"number": name, "family": "hyperbolic-roll", "values": {}}, "/number", "/parts/"),
        ("program", "/programs", lambda name: {"name": name, "dialect": "fanuc", "text": plain_program(3)}, "/name", None),
        ("rendered program", "/render", lambda name: {"family": "hyperbolic-roll", "machine": "lathe", "name": name}, "/name", None),
    ]


def each_field(client):
    for what, path, body, pointer, found in fields():
        may_be_empty = what == "rendered program"
        for name in WRONG:
            if name == "" and may_be_empty:
                continue
            problem = client.refuse(422, "POST", path, body(name))
            expect(pointer in [error.get("pointer") for error in problem["errors"]], f"{what} {name[:20]!r}: {problem}")
        raw = json.dumps(body("@@")).encode().replace(b"@@", b"a\xff")
        client.refuse(400, "POST", path, raw, headers={"Content-Type": "application/json"})
        if may_be_empty:
            continue
        answer = client.call("POST", path, body(LONGEST))
        expect(answer.status == 201, f"{what} with a name of 200 bytes: {answer}")
        if found:
            expect(answer.headers["Location"] == "/api/v1" + found + urllib.parse.quote(LONGEST, safe=""), f"{what}: {answer.headers['Location']}")
        expect(client.call("GET", answer.headers["Location"]).status == 200, f"{what} is not where its Location says")


def a_family(client):
    """Its name stands in its text, where the language takes letters, digits and marks."""
    for length, status in ((200, 201), (201, 422), (65520, 422)):
        answer = client.call("POST", "/families", {"text": ROLL.replace("family hyperbolic-roll", "family " + "f" * length)})
        expect(answer.status == status, f"a family's name of {length} bytes: {answer}")
        expect(status == 201 or "/text" in json.dumps(answer.document), f"{answer}")


def a_receipt(client, control):
    client.wait_line("lathe", "idle")
    control.say(b"%\nO0700\nM30\n%\n")
    shop.wait_for("a receipt", lambda: client.get("/receipts")["items"])
    receipt = client.get("/receipts")["items"][0]["id"]
    for name in WRONG[1:]:
        problem = client.refuse(422, "POST", f"/receipts/{receipt}/accept", {"name": name})
        expect("/name" in [error.get("pointer") for error in problem["errors"]], f"{name[:20]!r}: {problem}")
    accepted = client.post(f"/receipts/{receipt}/accept", {"name": LONGEST})
    expect(client.get(f"/programs/{accepted['program']}")["name"] == LONGEST, f"{accepted}")


def a_token(client):
    for name in [*WRONG, b"a\xff"]:
        if len(name) > 60000 or name == "":
            continue
        done = subprocess.run([str(binary()), "token", "add", name, "--role", "viewer", "--data", str(client.server.data)], capture_output=True, text=True, timeout=30)
        expect(done.returncode == 2 and done.stdout == "" and "the name of a token must" in done.stderr, f"token add {name[:20]!r}: {done}")
    headers = {"Authorization": f"Bearer {client.add_token('viewer', LONGEST)}"}
    expect(client.must("GET", "/session", role=None, headers=headers)["name"] == LONGEST, "a token with a name of 200 bytes")


def names(folder):
    control = HandControl()
    client = Client(folder).start()
    client.post("/machines", hand_profile(control))
    client.post("/families", {"text": ROLL})
    pid = client.server.process.pid
    each_field(client)
    a_family(client)
    a_receipt(client, control)
    a_token(client)
    expect(client.server.process.pid == pid and client.server.alive(), "the server has ended")
    client.server.stop()
    control.close()


if __name__ == "__main__":
    in_folder(names)
    sys.exit(0)
