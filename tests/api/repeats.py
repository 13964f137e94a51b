"""Changes that collide, requests that are repeated, lists that are walked: If-Match and ETag, Idempotency-Key (also over a restart), pages."""

import concurrent.futures
import sys

from client import LISTS, ROLL, Client, HandControl, expect, hand_profile, in_folder, plain_program


ONLY_FROM_A_CONTROL = {"receipts", "requests", "alarms"}  # their pages are walked by receipts.py and alarms.py


def changes(profile):
    """(where it is read, method and path of the change, body by turn)"""
    return [
        ("/machines/lathe", "PUT", "/machines/lathe", lambda n: dict(profile, title=f"turn {n}")),
        ("/families/hyperbolic-roll", "PUT", "/families/hyperbolic-roll", lambda n: {"text": ROLL + f"# turn {n}\n"}),
        ("/parts/R-1", "PUT", "/parts/R-1", lambda n: {"values": {"angle_step": f"0.{n} deg"}}),
        ("/orders/1", "PUT", "/orders/1", lambda n: {"part": "R-1", "quantity": n + 1}),
        ("/users/olga", "PUT", "/users/olga", lambda n: {"role": "viewer", "disabled": n % 2 == 1}),
        ("/programs/1", "POST", "/programs/1/revisions", lambda n: {"text": plain_program(n)}),
    ]


def prepare(folder, control):
    client = Client(folder).start()
    client.post("/machines", hand_profile(control))
    client.post("/families", {"text": ROLL})
    client.post("/parts", {"number": "R-1", "family": "hyperbolic-roll", "values": {}})
    client.post("/orders", {"number": "A-1", "part": "R-1", "quantity": 1})
    client.post("/users", {"name": "olga", "role": "viewer"})
    client.add_program()
    return client


def a_change_names_what_it_changes(folder):
    control = HandControl()
    client = prepare(folder, control)
    described = client.call("GET", "/api/openapi.json").document["paths"]
    taking = {(m.upper(), p) for p, item in described.items() for m, o in item.items() if any(x["name"] == "If-Match" for x in o["parameters"])}
    expect(taking == {("PUT", "/api/v1/machines/{name}"), ("PUT", "/api/v1/families/{name}"), ("PUT", "/api/v1/parts/{number}"), ("PUT", "/api/v1/users/{name}"), ("PUT", "/api/v1/orders/{id}"), ("POST", "/api/v1/programs/{id}/revisions")},
           f"If-Match is described for {taking}")
    for read, method, path, body in changes(hand_profile(control)):
        expect(client.call("GET", read).headers["ETag"] == '"1"', f"{read}: the first ETag")
        client.refuse(428, method, path, body(2))
        for stale in ('"2"', '"0"', '"x"', "*", 'W/"1"', '"1", "2"', '"18446744073709551617"', "-1"):
            client.refuse(412, method, path, body(2), headers={"If-Match": stale})
        expect(client.call("GET", read).headers["ETag"] == '"1"', f"{read}: a refused change made a revision")
        for turn in (2, 3):
            changed = client.call(method, path, body(turn), headers={"If-Match": f'"{turn - 1}"'})
            expect(changed.status in (200, 201) and changed.headers["ETag"] == f'"{turn}"' and changed.document["revision"] == turn, f"{method} {path}: {changed}")
            now = client.call("GET", read)
            expect(now.headers["ETag"] == f'"{turn}"' and now.document["revision"] == turn, f"{read}: {now}")
        client.refuse(412, method, path, body(9), headers={"If-Match": '"2"'})
    expect(client.call("GET", "/programs/1/text?revision=2").body.decode() == plain_program(2), "an old revision changed")
    expect(client.call("GET", "/programs/1/text").headers["ETag"] == '"3"', "the ETag of a text")
    of_eight_one_wins(client)
    client.server.stop()
    control.close()


def of_eight_one_wins(client):
    """Eight people change the same revision at once."""
    def change(n):
        return client.call("PUT", "/parts/R-1", {"values": {"angle_step": f"0.{n} deg"}}, headers={"If-Match": '"3"'}).status
    with concurrent.futures.ThreadPoolExecutor(8) as people:
        statuses = sorted(people.map(change, range(1, 9)))
    expect(statuses == [200] + [412] * 7, f"eight changes of one revision: {statuses}")


def creations(profile, made):
    """(list, path, body, another body)"""
    return [
        ("machines", "/machines", dict(profile, name="m-1"), dict(profile, name="m-2")),
        ("families", "/families", {"text": ROLL.replace("hyperbolic-roll", "f-1")}, {"text": ROLL.replace("hyperbolic-roll", "f-2")}),
        ("parts", "/parts", {"number": "P-1", "family": "hyperbolic-roll", "values": {}}, {"number": "P-2", "family": "hyperbolic-roll", "values": {}}),
        ("programs", "/programs", {"name": "O1", "dialect": "fanuc", "text": "M30\n"}, {"name": "O2", "dialect": "fanuc", "text": "M30\n"}),
        ("programs", "/render", {"part": "R-1", "machine": "lathe"}, {"part": "R-1", "machine": "lathe", "name": "O7"}),
        ("checks", "/checks", {"program": 1, "machine": "lathe"}, {"program": 1, "machine": "lathe", "delivery": "memory"}),
        ("releases", "/releases", {"program": 1, "machine": "lathe", "delivery": "memory"}, {"program": 2, "machine": "lathe"}),
        ("jobs", "/jobs", {"release": made["release"]}, {"release": made["release"] + 1}),
    ]


def a_key_acts_once(folder):
    control = HandControl()
    client = prepare(folder, control)
    release = client.release(1)["id"]
    other = client.add_program(21, "O0043")["id"]
    expect(client.release(other)["id"] == release + 1, "the second release")
    rows = creations(hand_profile(control), {"release": release})
    kept = [once(client, *row, key=f"key-{n}") for n, row in enumerate(rows)]
    eight_at_once(client)
    a_change_is_once(client)
    a_command_is_once(client, release)
    client.restart()
    for (name, path, body, another), answer, key in zip(rows, kept, [f"key-{n}" for n in range(len(rows))]):
        count = len(client.get(f"/{name}?limit=200")["items"])
        same(client.call("POST", path, body, headers={"Idempotency-Key": key}), answer, f"{path} after a restart")
        client.refuse(422, "POST", path, another, headers={"Idempotency-Key": key}, words=["key"])
        expect(len(client.get(f"/{name}?limit=200")["items"]) == count, f"{path} acted again after a restart")
    client.server.stop()
    control.close()


def once(client, name, path, body, another, key):
    headers = {"Idempotency-Key": key}
    before = len(client.get(f"/{name}?limit=200")["items"])
    first = client.call("POST", path, body, headers=headers)
    expect(first.status == 201, f"{path}: {first}")
    same(client.call("POST", path, body, headers=headers), first, path)
    client.refuse(422, "POST", path, another, headers=headers, words=["key"])
    after = len(client.get(f"/{name}?limit=200")["items"])
    expect(after == before + 1, f"{path}: one key made {after - before}")
    # Keys belong to a person and a route, and a refusal keeps none.
    client.refuse(403, "POST", path, body, role="viewer", headers=headers)
    return first


def eight_at_once(client):
    """One order that is sent eight times at once acts once; a request that comes too early is asked to come again."""
    before = len(client.get("/checks?limit=200")["items"])
    def send(_):
        return client.call("POST", "/checks", {"program": 1, "machine": "lathe"}, headers={"Idempotency-Key": "eight"})
    with concurrent.futures.ThreadPoolExecutor(8) as people:
        answers = list(people.map(send, range(8)))
    made = {answer.body for answer in answers if answer.status == 201}
    expect(len(made) == 1 and all(answer.status in (201, 409) for answer in answers), f"{[str(answer) for answer in answers]}")
    expect(len(client.get("/checks?limit=200")["items"]) == before + 1, "one key made several checks")


def same(answer, first, what):
    for member in ("Location", "ETag", "Content-Type"):
        expect(answer.headers[member] == first.headers[member], f"{what}: {member} was {first.headers[member]}, is {answer.headers[member]}")
    expect(answer.status == first.status and answer.body == first.body, f"{what}: was {first}, is {answer}")


def a_change_is_once(client):
    headers = {"If-Match": '"1"', "Idempotency-Key": "change"}
    first = client.call("PUT", "/parts/R-1", {"values": {"angle_step": "1 deg"}}, headers=headers)
    expect(first.status == 200, f"the change: {first}")
    same(client.call("PUT", "/parts/R-1", {"values": {"angle_step": "1 deg"}}, headers=headers), first, "PUT /parts/R-1")
    expect(client.get("/parts/R-1")["revision"] == 2, "a repeated change made another revision")
    # What was refused may be tried again under its key.
    retry = {"If-Match": '"1"', "Idempotency-Key": "retry"}
    client.refuse(412, "PUT", "/parts/R-1", {"values": {}}, headers=retry)
    expect(client.call("PUT", "/parts/R-1", {"values": {}}, headers=retry | {"If-Match": '"2"'}).status == 200, "a refusal was kept under its key")
    gone = client.call("DELETE", "/session", headers={"Idempotency-Key": "gone"})
    same(client.call("DELETE", "/session", headers={"Idempotency-Key": "gone"}), gone, "DELETE /session")


def a_command_is_once(client, release):
    job = client.queue(release)
    client.wait_line("lathe", "idle")
    headers = {"Idempotency-Key": "arm-it"}
    first = client.call("POST", f"/jobs/{job}/arm", {}, headers=headers)
    expect(first.status == 200 and first.document["state"] == "armed", f"arm: {first}")
    same(client.call("POST", f"/jobs/{job}/arm", {}, headers=headers), first, "arm")
    client.refuse(409, "POST", f"/jobs/{job}/arm", {})  # without the key it is another order
    client.must("POST", f"/jobs/{job}/cancel", {}, headers={"Idempotency-Key": "cancel-it"})
    client.wait_job(job, "cancelled")


def a_walk_meets_each_once(folder):
    control = HandControl()
    client = prepare(folder, control)
    profile = hand_profile(control)
    profile["link"] = dict(profile["link"], url=f"pty:{folder}/nobody")
    release = client.release(1)["id"]
    for n in range(6):
        client.post("/machines", dict(profile, name=f"m/{n} ä?"))
        client.post("/families", {"text": ROLL.replace("hyperbolic-roll", f"f-{n}")})
        client.post("/parts", {"number": f"P#{n} &+%", "family": "hyperbolic-roll", "values": {}})
        program = client.add_program(30 + n, f"O{n:04}")["id"]
        client.must("POST", "/programs/1/revisions", {"text": plain_program(40 + n)}, headers={"If-Match": f'"{n + 1}"'})
        client.post("/checks", {"program": program, "machine": "lathe"})
        client.post("/releases", {"program": program, "machine": "lathe"})
        job = client.queue(release)
    client.post(f"/jobs/{job}/cancel")
    for path, key in [(f"/{name}", {"machines": "name", "families": "name", "parts": "number"}.get(name, "id"))
                      for name in LISTS if name not in ONLY_FROM_A_CONTROL] + [("/programs/1/revisions", "revision")]:
        whole = [item[key] for item in client.get(f"{path}?limit=200")["items"]]
        expect(len(whole) == len(set(whole)) >= 6, f"{path}: {whole}")
        for limit in (1, 2, 5, len(whole), 200):
            expect(walk(client, path, key, limit) == whole, f"{path} by {limit}: {walk(client, path, key, limit)}, not {whole}")
        expect(client.get(path)["items"] == client.get(f"{path}?limit=50")["items"], f"{path}: a page has 50 items where nothing is said")
    for path, expected in [("/jobs?state=cancelled", 1), ("/jobs?state=queued", 5), ("/jobs?machine=lathe", 6), ("/jobs?machine=m/0%20%C3%A4?", 0), ("/releases?machine=lathe", 7), ("/checks?program=1", 1),
                           ("/programs?name=O0003", 1), ("/parts?family=f-1", 0), ("/parts?family=hyperbolic-roll", 7)]:
        found = len(client.get(path)["items"])
        expect(found == expected, f"{path}: {found} items, not {expected}")
    names_are_reached(client)
    a_walk_while_things_are_added(client)
    client.server.stop()
    control.close()


def walk(client, path, key, limit):
    found, after = [], ""
    while True:
        page = client.get(f"{path}?limit={limit}{after}")
        expect(0 < len(page["items"]) <= limit, f"{path}: a page of {len(page['items'])} items")
        found += [item[key] for item in page["items"]]
        if page["next"] is None:
            return found
        after = f"&after={quoted(page['next'])}"


def quoted(text):
    return "".join(f"%{byte:02X}" for byte in text.encode())


def names_are_reached(client):
    """A name with a slash, a blank, a letter beyond ASCII: its Location leads to it."""
    for body in ({"number": "A/B c%d", "family": "hyperbolic-roll", "values": {}}, {"number": "Walze Ü?x=1#2", "family": "hyperbolic-roll", "values": {}}):
        made = client.call("POST", "/parts", body)
        expect(made.status == 201 and client.get(made.headers["Location"])["number"] == body["number"], f"{body['number']}: {made.headers['Location']}")


def a_walk_while_things_are_added(client):
    """Newest first: what comes during the walk is not met, and nothing is met twice."""
    whole = [job["id"] for job in client.get("/jobs?limit=200")["items"]]
    found, after = [], ""
    while after is not None:
        page = client.get(f"/jobs?limit=2{after}")
        found += [job["id"] for job in page["items"]]
        after = f"&after={page['next']}" if page["next"] else None
        client.queue(1)
    expect(found == whole, f"{found}, not {whole}")


if __name__ == "__main__":
    in_folder(a_change_names_what_it_changes)
    in_folder(a_key_acts_once)
    in_folder(a_walk_meets_each_once)
    sys.exit(0)
