"""People: signing in by password and PIN, locks, roles by groups of machines, tokens with a scope and an end, the second pair of eyes, and the
audit, exported and verified offline."""

import collections
import http.client
import json
import subprocess
import sys
import threading
import time

from client import Client, binary, expect, in_folder, plain_program, shop, whole

GOOD = "correct horse battery"


def command(client, *arguments, secret=None, good=True):
    done = subprocess.run([str(binary()), *arguments, "--data", str(client.server.data)], capture_output=True, text=True, timeout=30, input=secret)
    expect((done.returncode == 0) == good, f"{arguments}: {done.returncode} {done.stderr}")
    return done.stdout


def add(client, name, role, **more):
    return client.post("/users", {"name": name, "role": role} | more)


def sign_in(client, body, status=204):
    answer = client.call("POST", "/session", body, role=None)
    expect(answer.status == status, f"{body}: {answer}")
    return answer.headers["Set-Cookie"].split(";")[0] if status == 204 else answer


def who(client, cookie):
    answer = client.call("GET", "/session", role=None, headers={"Cookie": cookie})
    return answer.document if answer.status == 200 else None


def secrets_and_sessions(folder):
    client = Client(folder).start()
    add(client, "olga", "programmer")
    sign_in(client, {"name": "olga", "password": GOOD}, 401)
    client.refuse(422, "PUT", "/users/olga/password", {"secret": "short"}, words=["10"])
    client.refuse(422, "PUT", "/users/olga/password", {"secret": ""})
    for weak in ("123", "1111", "1234", "98765", "12a4", "1" * 13):
        client.refuse(422, "PUT", "/users/olga/pin", {"secret": weak})
    client.refuse(404, "PUT", "/users/nobody/password", {"secret": GOOD})
    client.must("PUT", "/users/olga/password", {"secret": GOOD})
    client.must("PUT", "/users/olga/pin", {"secret": "4711"})
    cookie = sign_in(client, {"name": "olga", "password": GOOD})
    expect(who(client, cookie) == {"name": "olga", "role": "programmer", "by": "password", "scope": [], "machines": {}}, f"{who(client, cookie)}")
    pin = sign_in(client, {"name": "olga", "pin": "4711"})
    expect(who(client, pin)["role"] == "operator", "a PIN gives more than the role operator")
    for wrong in ({"name": "olga"}, {"password": GOOD}, {"token": "x", "name": "olga", "password": GOOD}, {"name": "olga", "pin": "4711", "password": GOOD}, {}):
        sign_in(client, wrong, 422)
    client.restart()
    expect(who(client, cookie)["name"] == "olga", "a restart signs out")
    same_site = {"Cookie": cookie, "Sec-Fetch-Site": "same-origin"}
    answer = client.call("PUT", "/session/password", {"current": "another one", "secret": GOOD + "!"}, role=None, headers=same_site)
    expect(answer.status == 403, f"{answer}")
    answer = client.call("PUT", "/session/password", {"current": GOOD, "secret": GOOD + "!"}, role=None, headers=same_site)
    expect(answer.status == 204, f"{answer}")
    expect(who(client, cookie) is None and who(client, pin) is None, "a new password leaves old sessions")
    sign_in(client, {"name": "olga", "password": GOOD}, 401)
    fresh = sign_in(client, {"name": "olga", "password": GOOD + "!"})
    client.must("PUT", "/users/olga", {"role": "programmer", "disabled": True}, headers={"If-Match": '"1"'})
    expect(who(client, fresh) is None, "a disabled user goes on")
    sign_in(client, {"name": "olga", "password": GOOD + "!"}, 401)
    client.refuse(412, "PUT", "/users/olga", {"role": "admin"}, headers={"If-Match": '"1"'})
    kept = client.server.data.joinpath("dripfeed.db").read_bytes() + client.server.data.joinpath("dripfeed.db-wal").read_bytes()
    expect(GOOD.encode() not in kept, "a password is in the store")
    client.server.stop()


def locks(folder):
    client = Client(folder).start()
    add(client, "olga", "operator")
    client.must("PUT", "/users/olga/pin", {"secret": "4711"})
    for _ in range(4):
        sign_in(client, {"name": "olga", "pin": "0815"}, 401)
    sign_in(client, {"name": "olga", "pin": "4711"})
    for _ in range(5):
        sign_in(client, {"name": "olga", "pin": "0815"}, 401)
    locked = sign_in(client, {"name": "olga", "pin": "4711"}, 429)
    expect(0 < int(locked.headers["Retry-After"]) <= 61, f"{locked.headers['Retry-After']}")
    client.restart()
    sign_in(client, {"name": "olga", "pin": "4711"}, 429)
    expect(client.get("/users/olga")["locked_until_ms"] > time.time() * 1000, "the list does not show the lock")
    client.post("/users/olga/unlock")
    sign_in(client, {"name": "olga", "pin": "4711"})
    sign_in(client, {"name": "nobody", "pin": "4711"}, 401)
    client.server.stop()


def a_flood_of_sign_ins(folder):
    """From another address of this computer, with names that no account has: it gets its few places, and a person gets in between."""
    client = Client(folder).start()
    add(client, "olga", "operator")
    client.must("PUT", "/users/olga/password", {"secret": "a long enough one"})
    ends, statuses = threading.Event(), collections.Counter()

    def flood(number):
        while not ends.is_set():
            connection = http.client.HTTPConnection("127.0.0.1", client.server.port, timeout=60, source_address=("127.0.0.2", 0))
            connection.request("POST", whole("/session"), json.dumps({"name": f"nobody{number}", "password": "wrong"}), {"Content-Type": "application/json"})
            answer = connection.getresponse()
            statuses[answer.status] += 1
            expect(answer.status != 503 or int(answer.headers["Retry-After"]) > 0, "when to come again is not stated")
            connection.close()

    threads = [threading.Thread(target=flood, args=(number,), daemon=True) for number in range(40)]
    for thread in threads:
        thread.start()
    shop.wait_for("the flood to be refused", lambda: statuses[503] > 100)
    for _ in range(3):
        sign_in(client, {"name": "olga", "password": "a long enough one"})
    ends.set()
    for thread in threads:
        thread.join()
    expect(statuses[401] > 0 and set(statuses) == {401, 503}, f"{statuses}")
    client.server.stop()


def roles_by_groups(folder):
    client = Client(folder).start()
    for name in ("mill", "lathe"):
        client.post("/machines", shop.preset("fanuc-0i-mill", url=f"pty:{folder}/{name}") | {"name": name})
    client.must("PUT", "/groups/mills", {"machines": ["mill"], "four_eyes": True})
    rules = {"four_eyes": True, "operator_sign_off": True}
    expect(client.get("/groups")["items"] == [{"name": "mills", "machines": ["mill"]} | rules], f"{client.get('/groups')}")
    client.refuse(422, "PUT", "/groups/x", {"machines": ["nobody"]})
    client.refuse(422, "PUT", "/groups/mills", {}, words=["machines"])
    client.refuse(409, "PUT", "/groups/others", {"machines": ["mill"]}, words=["mill is in group mills"])
    client.must("PUT", "/groups/mills", {"machines": ["mill"], "operator_sign_off": False})
    kept = client.must("PUT", "/groups/mills", {"machines": ["mill"]})
    expect(kept["four_eyes"] and not kept["operator_sign_off"], f"a rule that is not stated is another now: {kept}")
    client.refuse(422, "POST", "/users", {"name": "x", "role": "viewer", "grants": [{"group": "nobody", "role": "admin"}]})
    add(client, "paul", "viewer", grants=[{"group": "mills", "role": "approver"}])
    client.tokens["paul"] = client.post("/tokens", {"name": "paul's", "role": "admin", "user": "paul"})["token"]
    expect(client.must("GET", "/session", role="paul")["machines"] == {"mill": "approver"}, "the roles by machine")
    program = client.add_program()["id"]
    client.refuse(403, "POST", "/programs", {"name": "O1", "dialect": "fanuc", "text": plain_program(3)}, role="paul", words=["programmer", "viewer"])
    client.refuse(403, "POST", "/checks", {"program": program, "machine": "lathe"}, role="paul")
    client.refuse(403, "POST", "/releases", {"program": program, "machine": "lathe"}, role="paul")
    client.check(program, "mill"), client.check(program, "lathe")
    on_mill = client.must("POST", "/releases", {"program": program, "machine": "mill"}, role="paul")["id"]
    on_lathe = client.post("/releases", {"program": program, "machine": "lathe"})["id"]
    client.refuse(403, "POST", f"/releases/{on_lathe}/transitions", {"to": "in_review"}, role="paul")
    proving = {"to": "proving", "transfers": 3}
    client.must("POST", f"/releases/{on_mill}/transitions", {"to": "in_review"}, role="paul")
    client.refuse(409, "POST", f"/releases/{on_mill}/transitions", proving, role="paul", words=["paul made the release"])
    client.must("POST", f"/releases/{on_mill}/transitions", proving, role="approver")
    for step in ({"to": "in_review"}, proving):
        client.post(f"/releases/{on_lathe}/transitions", step)
    job = client.must("POST", "/jobs", {"release": on_mill}, role="paul")["id"]
    client.refuse(403, "POST", "/jobs", {"release": on_lathe}, role="paul")
    other = client.queue(on_lathe)
    client.refuse(403, "POST", f"/jobs/{other}/cancel", role="paul")
    client.must("POST", f"/jobs/{job}/cancel", role="paul")
    approval = {"to": "approved", "note": "the first part is good"}
    client.refuse(409, "POST", f"/releases/{on_mill}/transitions", approval, role="paul", words=["paul made the release"])
    client.refuse(409, "POST", f"/releases/{on_mill}/transitions", approval, words=["wrote the text"])
    client.refuse(403, "POST", f"/releases/{on_mill}/transitions", approval, role="programmer", words=["approver"])
    client.must("POST", f"/releases/{on_mill}/transitions", approval, role="approver")
    client.must("DELETE", "/groups/mills")
    client.refuse(403, "POST", "/checks", {"program": program, "machine": "mill"}, role="paul")
    client.server.stop()


def scopes_and_ends(folder):
    client = Client(folder).start()
    client.post("/machines", shop.preset("fanuc-0i-mill", url=f"pty:{folder}/mill") | {"name": "mill"})
    release = client.release(client.add_program()["id"], "mill")["id"]
    made = client.post("/tokens", {"name": "mes", "role": "operator", "scope": ["queue"], "expires_at_ms": int(time.time() * 1000) + 4000})
    client.tokens["mes"] = made["token"]
    expect(made["scope"] == ["queue"] and made["token"] not in json.dumps(client.get("/tokens")), f"{made}")
    job = client.must("POST", "/jobs", {"release": release}, role="mes")["id"]
    client.refuse(403, "POST", f"/jobs/{job}/arm", role="mes", words=["queue", "line"])
    client.refuse(403, "POST", f"/jobs/{job}/cancel", role="mes")
    expect(client.must("GET", f"/jobs/{job}", role="mes")["state"] == "queued", "it may read")
    client.refuse(422, "POST", "/tokens", {"name": "x", "role": "viewer", "scope": ["everything"]}, words=["library"])
    client.refuse(422, "POST", "/tokens", {"name": "x", "role": "viewer", "user": "nobody"})
    twice = {"Idempotency-Key": "k"}
    first, second = (client.must("POST", "/tokens", {"name": "y", "role": "viewer"}, headers=twice)["token"] for _ in range(2))
    expect(first != second, "an answer with a secret was kept")
    cookie = sign_in(client, {"token": client.tokens["mes"]})
    shop.wait_for("the token to end", lambda: client.call("GET", "/session", role="mes").status == 401)
    expect(who(client, cookie) is None, "the session of a token that ended")
    sign_in(client, {"token": client.tokens["mes"]}, 401)
    client.server.stop()


def no_one_locks_the_shop_out(folder):
    client = Client(folder).start()
    command(client, "user", "add", "anna", "--role", "admin")
    command(client, "user", "password", "anna", secret=GOOD + "\n")
    command(client, "user", "password", "anna", secret="short\n", good=False)
    command(client, "user", "pin", "anna", secret="", good=False)
    command(client, "user", "add", "x", "--role", "boss", good=False)
    command(client, "user", "add", "x", "--grant", "nothing", good=False)
    cookie = {"Cookie": sign_in(client, {"name": "anna", "password": GOOD}), "Sec-Fetch-Site": "same-origin", "If-Match": '"1"'}
    for wrong in ({"role": "viewer"}, {"role": "admin", "disabled": True}):
        answer = client.call("PUT", "/users/anna", wrong, role=None, headers=cookie)
        expect(answer.status == 409, f"{answer}")
    expect("anna" in command(client, "user", "list") and "password" in command(client, "user", "list"), command(client, "user", "list"))
    command(client, "user", "disable", "anna")
    expect(who(client, cookie["Cookie"]) is None, "a disabled user goes on")
    command(client, "user", "enable", "anna")
    sign_in(client, {"name": "anna", "password": GOOD})
    command(client, "user", "password", "anna", "--remove")
    sign_in(client, {"name": "anna", "password": GOOD}, 401)
    client.server.stop()


def audit(folder):
    client = Client(folder).start()
    add(client, "olga", "operator")
    client.must("PUT", "/users/olga/pin", {"secret": "4711"})
    sign_in(client, {"name": "olga", "pin": "0815"}, 401)
    rows = client.get("/audit?subject=user/olga")["items"]
    expect([row["action"] for row in rows] == ["user.refused", "user.secret", "user.add"], f"{rows}")
    expect(client.get(f"/audit?action=user.add&from_ms={rows[2]['at_ms']}&to_ms={rows[2]['at_ms'] + 1}")["items"] == [rows[2]], "by time and action")
    expect(client.get("/audit?actor=nobody")["items"] == [], "by actor")
    client.refuse(422, "GET", "/audit?from_ms=-1")
    exported = folder / "audit.jsonl"
    command(client, "audit", "export", "--output", str(exported))
    lines = exported.read_text().splitlines()
    expect([json.loads(line)["seq"] for line in lines] == list(range(1, len(lines) + 1)), "not all rows, or not in their order")
    head = json.loads(lines[-1])["hash"]

    def verify(text, good, *arguments):
        exported.write_text(text)
        done = subprocess.run([str(binary()), "audit", "verify", str(exported), *arguments], capture_output=True, text=True, timeout=30)
        expect((done.returncode == 0) == good, f"{done.returncode} {done.stdout} {done.stderr}")
        return done.stdout + done.stderr

    whole = "\n".join(lines) + "\n"
    expect(head in verify(whole, True, "--head", head), "no head")
    expect(":2:" in verify(whole.replace("user.refused", "user.secrets", 1) if "user.refused" in lines[1] else "\n".join([lines[0], *lines[2:]]) + "\n", False), "a row that is missing")
    verify(whole.replace("user.refused", "user.unlock"), False)
    verify("\n".join(lines[:-1]) + "\n", False, "--head", head)
    verify(whole + "nonsense\n", False)
    client.server.stop()


if __name__ == "__main__":
    for test in (secrets_and_sessions, locks, a_flood_of_sign_ins, roles_by_groups, scopes_and_ends, no_one_locks_the_shop_out, audit):
        in_folder(test)
    sys.exit(0)
