"""Wrong requests at every route: the status, a problem document with the place, and nothing stored. One row a request."""

import re
import sys

from client import ROLL, Client, HandControl, contract, expect, hand_profile, in_folder, plain_program

MATCH_1 = {"If-Match": '"1"'}
NOT_THERE = [
    ("GET", "/nothing", None), ("GET", "/machines/nobody", None), ("PUT", "/machines/nobody", "profile"), ("POST", "/machines/nobody/confirm-reset", {"reason": "x"}),
    ("GET", "/families/nobody", None), ("PUT", "/families/nobody", {"text": ROLL.replace("family hyperbolic-roll", "family nobody")}),
    ("GET", "/parts/nobody", None), ("PUT", "/parts/nobody", {"values": {}}), ("POST", "/parts", {"number": "P", "family": "nobody", "values": {}}),
    ("GET", "/programs/99", None), ("GET", "/programs/99/text", None), ("GET", "/programs/1/text?revision=9", None), ("GET", "/programs/99/revisions", None),
    ("POST", "/programs/99/revisions", {"text": "M30"}), ("POST", "/render", {"family": "nobody", "machine": "lathe"}), ("POST", "/render", {"part": "nobody", "machine": "lathe"}),
    ("POST", "/render", {"family": "hyperbolic-roll", "machine": "nobody"}), ("POST", "/checks", {"program": 99, "machine": "lathe"}),
    ("POST", "/checks", {"program": 1, "machine": "nobody"}), ("POST", "/checks", {"program": 1, "revision": 9, "machine": "lathe"}),
    ("POST", "/checks", {"program": 1, "machine": "lathe", "nominal": {"family": "nobody"}}), ("POST", "/accuracy", {"program": 99, "machine": "lathe"}),
    ("POST", "/gouge", {"program": 1, "machine": "nobody"}), ("POST", "/timing", {"program": 1, "revision": 9, "machine": "lathe"}),
    ("POST", "/sweep", {"family": "nobody", "machine": "lathe"}), ("POST", "/sweep", {"family": "hyperbolic-roll", "machine": "nobody"}),
    ("GET", "/checks/99", None), ("POST", "/checks/99/waivers", {"reason": "x"}), ("POST", "/releases", {"program": 99, "machine": "lathe"}),
    ("POST", "/releases", {"program": 1, "machine": "nobody"}), ("POST", "/releases", {"program": 1, "revision": 9, "machine": "lathe"}),
    ("GET", "/releases/99", None), ("POST", "/releases/99/transitions", {"to": "in_review"}), ("POST", "/jobs", {"release": 99}), ("GET", "/jobs/99", None),
    ("POST", "/jobs/99/arm", {}), ("POST", "/jobs/99/stop", {}), ("POST", "/jobs/99/cancel", {}), ("POST", "/jobs/99/resume", {"reason": "x"}), ("GET", "/jobs/99/ledger", None),
    ("GET", "/alarms/99", None), ("POST", "/alarms/99/acknowledge", {}), ("POST", "/alarms/99/shelve", {"minutes": 1, "reason": "x"}), ("POST", "/alarms/99/unshelve", {}),
    ("GET", "/programs/99/lines", None), ("GET", "/programs/1/lines?revision=9", None), ("GET", "/machines/nobody/utilisation", None), ("POST", "/jobs/99/move", {"before": None}),
    # What is no id at all.
    ("GET", "/jobs/one", None), ("GET", "/jobs/0", None), ("GET", "/jobs/-1", None), ("GET", "/jobs/1.0", None), ("GET", "/jobs/18446744073709551615", None),
    ("GET", "/jobs/18446744073709551617", None), ("GET", "/jobs/1/", None), ("GET", "/jobs//ledger", None), ("GET", "/api/v2/jobs", None), ("GET", "/assets/none.js", None),
    ("GET", "/assets/..%2findex.html", None), ("GET", "/assets/%2e%2e%2f%2e%2e%2fetc%2fpasswd", None),
]
NO_SUCH_METHOD = [  # and the methods that the path has
    ("DELETE", "/machines", "GET, POST"), ("POST", "/machines/lathe", "GET, PUT"), ("PATCH", "/parts/x", "GET, PUT"), ("GET", "/render", "POST"), ("GET", "/sweep", "POST"),
    ("PUT", "/jobs/1", "GET"), ("GET", "/jobs/1/arm", "POST"), ("POST", "/events", "GET"), ("OPTIONS", "/programs", "GET, POST"), ("TRACE", "/healthz", "GET"),
    ("PUT", "/session", "POST, GET, DELETE"),
]
NO_JSON = [b"{not json", b"{\"text\":\"x\"", b"{\"text\":\"x\"} more", b"text=x", b"\xff\xfe{}", b"{\"text\":\"\xe4\"}", b"{'text':'x'}", b"{\"text\":\"a\nb\"}", b"{\"text\":NaN}",
           b"{\"text\":\"x\",\"text\":\"y\"}", b"[" * 100000, b"{\"a\":" * 100000, b"[" * 65 + b"]" * 65]
NO_OBJECT = [b"[]", b"1", b"null", b"\"text\"", b"true"]
BODIES = [  # the route, a body that is fine but for one thing, the place that the problem names
    ("POST", "/session", {}, "/token"), ("POST", "/session", {"token": 1}, "/token"), ("POST", "/session", {"token": ""}, "/token"), ("POST", "/session", {"token": "x", "name": "y"}, "/name"), ("POST", "/session", {"pin": "4711"}, "/name"),
    ("POST", "/orders", {"number": "x", "part": "y"}, "/quantity"), ("POST", "/orders", {"number": "x", "part": "y", "quantity": 0}, "/quantity"),
    ("POST", "/orders", {"number": "x", "part": "y", "quantity": 1, "metadata": [1]}, "/metadata"), ("POST", "/orders/1/move", {"to": "held"}, "/reason"),
    ("POST", "/orders/1/move", {"to": "lost"}, "/to"), ("POST", "/orders/1/parts", {"good": -1}, "/good"),
    ("POST", "/users", {"name": "x"}, "/role"), ("POST", "/users", {"name": "", "role": "viewer"}, "/name"), ("POST", "/users", {"name": "x", "role": "boss"}, "/role"),
    ("POST", "/users", {"name": "x", "role": "viewer", "grants": [{"group": "g"}]}, "/grants/0/role"), ("POST", "/tokens", {"name": "x", "role": "viewer", "scope": "queue"}, "/scope"),
    ("POST", "/tokens", {"name": "x", "role": "viewer", "expires_at_ms": 0}, "/expires_at_ms"), ("POST", "/tokens", {"name": "x", "role": "viewer", "scope": []}, "/scope"), ("PUT", "/groups/g", {"machines": [1]}, "/machines"), ("PUT", "/users/x/pin", {}, "/secret"),
    ("POST", "/families", {}, "/text"), ("POST", "/families", {"text": 5}, "/text"), ("POST", "/families", {"text": None}, "/text"), ("POST", "/families", {"text": ""}, "/text"),
    ("POST", "/families", {"text": ROLL, "nam/e": "x"}, "/nam~1e"), ("PUT", "/families/hyperbolic-roll", {"text": ["x"]}, "/text"),
    ("POST", "/parts", {"family": "hyperbolic-roll"}, "/number"), ("POST", "/parts", {"number": "", "family": "hyperbolic-roll"}, "/number"),
    ("POST", "/parts", {"number": 7, "family": "hyperbolic-roll"}, "/number"), ("POST", "/parts", {"number": "P"}, "/family"),
    ("POST", "/parts", {"number": "P", "family": "hyperbolic-roll", "values": []}, "/values"),
    ("POST", "/parts", {"number": "P", "family": "hyperbolic-roll", "values": {"angle_step": True}}, "/values"),
    ("POST", "/parts", {"number": "P", "family": "hyperbolic-roll", "value": {}}, "/value"),
    ("POST", "/parts", {"number": "..", "family": "hyperbolic-roll"}, "/number"), ("POST", "/parts", {"number": "a\x00b", "family": "hyperbolic-roll"}, "/number"),
    ("PUT", "/parts/R-1", {"values": "x"}, "/values"), ("PUT", "/parts/R-1", {"number": "R-2", "values": {}}, "/number"),
    ("POST", "/programs", {"dialect": "fanuc", "text": "M30"}, "/name"), ("POST", "/programs", {"name": "O1", "text": "M30"}, "/dialect"),
    ("POST", "/programs", {"name": "O1", "dialect": "fanuc"}, "/text"), ("POST", "/programs", {"name": "O1", "dialect": "klingon", "text": "M30"}, "/dialect"),
    ("POST", "/programs", {"name": "O1", "dialect": 1, "text": "M30"}, "/dialect"), ("POST", "/programs", {"name": "O1", "dialect": "fanuc", "text": {}}, "/text"),
    ("POST", "/programs", {"name": "O1", "dialect": "fanuc", "text": "M30", "id": 3}, "/id"), ("POST", "/programs/1/revisions", {}, "/text"),
    ("POST", "/render", {"family": "hyperbolic-roll"}, "/machine"), ("POST", "/render", {"machine": "lathe"}, "/part"),
    ("POST", "/render", {"part": "R-1", "family": "hyperbolic-roll", "machine": "lathe"}, "/part"), ("POST", "/render", {"part": "R-1", "machine": "lathe", "mode": "fast"}, "/mode"),
    ("POST", "/render", {"part": "R-1", "machine": "lathe", "delivery": "mail"}, "/delivery"), ("POST", "/render", {"part": "R-1", "machine": "lathe", "values": {"angle_step": "1 deg"}}, "/values"),
    ("POST", "/checks", {"machine": "lathe"}, "/program"), ("POST", "/checks", {"program": "1", "machine": "lathe"}, "/program"), ("POST", "/checks", {"program": 1.5, "machine": "lathe"}, "/program"),
    ("POST", "/checks", {"program": 0, "machine": "lathe"}, "/program"), ("POST", "/checks", {"program": -1, "machine": "lathe"}, "/program"),
    ("POST", "/checks", {"program": 2**64, "machine": "lathe"}, "/program"), ("POST", "/checks", {"program": 1}, "/machine"), ("POST", "/checks", {"program": 1, "machine": 1}, "/machine"),
    ("POST", "/checks", {"program": 1, "machine": "lathe", "revision": 0}, "/revision"), ("POST", "/checks", {"program": 1, "machine": "lathe", "delivery": 1}, "/delivery"),
    ("POST", "/checks", {"program": 1, "machine": "lathe", "nominal": {"values": {}}}, "/nominal/family"), ("POST", "/checks", {"program": 1, "machine": "lathe", "profile": "2-9"}, "/profile"),
    ("POST", "/accuracy", {"machine": "lathe"}, "/program"), ("POST", "/accuracy", {"program": 1, "machine": "lathe", "cmm": 5}, "/cmm"), ("POST", "/gouge", {"program": 1, "machine": "lathe", "cmm": "x"}, "/cmm"),
    ("POST", "/timing", {"program": 1, "machine": "lathe", "baud": 1}, "/baud"), ("POST", "/sweep", {"machine": "lathe"}, "/family"),
    ("POST", "/sweep", {"family": "hyperbolic-roll", "machine": "lathe", "samples": 1001}, "/samples"), ("POST", "/releases", {"program": 1, "machine": "lathe", "nominal": {"family": "hyperbolic-roll"}}, "/nominal"),
    ("POST", "/checks/1/waivers", {}, "/reason"), ("POST", "/checks/1/waivers", {"reason": ""}, "/reason"), ("POST", "/checks/1/waivers", {"reason": 1}, "/reason"),
    ("POST", "/releases", {"machine": "lathe"}, "/program"), ("POST", "/releases", {"program": 1}, "/machine"), ("POST", "/releases", {"program": 1, "machine": "lathe", "delivery": "tape"}, "/delivery"),
    ("POST", "/releases/1/transitions", {}, "/to"), ("POST", "/releases/1/transitions", {"to": "done"}, "/to"), ("POST", "/releases/1/transitions", {"to": 2}, "/to"),
    ("POST", "/releases/1/transitions", {"to": "proving", "transfers": 0}, "/transfers"), ("POST", "/releases/1/transitions", {"to": "proving", "transfers": "9"}, "/transfers"),
    ("POST", "/releases/1/transitions", {"to": "proving", "transfers": 10**9}, "/transfers"), ("POST", "/releases/1/transitions", {"to": "in_review", "note": 1}, "/note"),
    ("POST", "/jobs", {}, "/release"), ("POST", "/jobs", {"release": "1"}, "/release"), ("POST", "/jobs", {"release": 1, "machine": "mill"}, "/machine"),
    ("POST", "/jobs/1/arm", {"minutes": "5"}, "/minutes"), ("POST", "/jobs/1/arm", {"minutes": 0}, "/minutes"), ("POST", "/jobs/1/arm", {"minutes": -1}, "/minutes"),
    ("POST", "/jobs/1/arm", {"minutes": 61}, "/minutes"), ("POST", "/jobs/1/arm", {"minutes": 1e300}, "/minutes"), ("POST", "/jobs/1/arm", {"hours": 1}, "/hours"),
    ("POST", "/alarms/1/shelve", {"reason": "x"}, "/minutes"), ("POST", "/alarms/1/shelve", {"minutes": 0, "reason": "x"}, "/minutes"),
    ("POST", "/alarms/1/shelve", {"minutes": 481, "reason": "x"}, "/minutes"), ("POST", "/alarms/1/shelve", {"minutes": 1}, "/reason"),
    ("POST", "/alarms/1/shelve", {"minutes": 1, "reason": ""}, "/reason"), ("POST", "/alarms/1/shelve", {"minutes": 1, "reason": "x", "until": 2}, "/until"),
    ("POST", "/jobs/1/move", {"before": "1"}, "/before"), ("POST", "/jobs/1/move", {"before": 0}, "/before"), ("POST", "/jobs/1/move", {"before": -1}, "/before"),
    ("POST", "/jobs/1/move", {"before": 2**64}, "/before"), ("POST", "/jobs/1/resume", {"reason": 1}, "/reason"), ("POST", "/machines/lathe/confirm-reset", {"reason": []}, "/reason"),
]
PROFILES = [  # one member of the profile, its wrong value, the place
    ("name", "", "/name"), ("name", 5, "/name"), ("name", "..", "/name"), ("name", "a\nb", "/name"), ("dialect", "klingon", "/dialect"), ("kind", "boat", "/kind"), ("axes", [], "axes"),
    ("axes", [{"name": "X", "min_mm": "0", "max_mm": 1}], "/axes/0/min_mm"), ("color", "red", "/color"), ("link", None, "/link"), ("link.url", "ftp://x", "/link/url"), ("link.baud", "fast", "/link/baud"),
    ("link.framing", "9E9", "/link/framing"), ("link.unsent", 40, "/link"), ("link.bawd", 1, "/link/bawd"), ("link.start", "now", "/link/start"),
]
QUERIES = [  # wrong questions
    ("/machines?limit=0", 422), ("/parts?limit=201", 422), ("/programs?limit=-1", 422), ("/checks?limit=many", 422), ("/releases?limit=", 422), ("/jobs?limit=1e2", 422), ("/jobs?state=asleep", 422), ("/alarms?state=asleep", 422), ("/alarms?after=x", 422), ("/programs/1/lines?count=0", 422), ("/programs/1/lines?count=201", 422), ("/programs/1/lines?from=0", 422), ("/programs/1/lines?from=x", 422),
    ("/machines/lathe/utilisation?days=0", 422), ("/machines/lathe/utilisation?days=91", 422), ("/alarms?limit=0", 422), ("/jobs?machin=lathe", 400), ("/programs/1?revision=1", 400),
    ("/programs?after=x", 422), ("/checks?after=-1", 422), ("/releases?after=1.5", 422), ("/jobs?after=99999999999999999999", 422), ("/programs/1/revisions?after=x", 422),
    ("/programs?name=%zz", 400), ("/machines/%", 400), ("/machines/%00", 400), ("/../etc/passwd", 400), ("/machines/%2e%2e/x", 400),
]
FAMILIES = [  # a text that is not a family: the place in it
    (ROLL.replace("cos(t)", "cosine(t)"), ["line", "column", "cosine"]), (ROLL.replace("length 100 mm ", "length 100 "), ["line"]), ("", ["/text"]), ("M30\n", ["line"]),
]


class Rows:
    """Tries every row and names all that were answered differently."""

    def __init__(self, client):
        self.client, self.faults = client, []

    def refuse(self, *arguments, places=None, **more):
        try:
            problem = self.client.refuse(*arguments, **more)
            named = [error.get("pointer") for error in problem.get("errors", [])]
            expect(places is None or named == places, f"{arguments}: the places are {named}, not {places}: {problem}")
        except AssertionError as fault:
            self.faults.append(str(fault))

    def finish(self):
        expect(not self.faults, f"{len(self.faults)} rows:\n" + "\n".join(self.faults))


def refuse_all(client, profile):
    client = Rows(client)
    for method, path, body in NOT_THERE:
        client.refuse(404, method, path, dict(profile, name="nobody") if body == "profile" else body, headers=MATCH_1)
    for method, path, allowed in NO_SUCH_METHOD:
        client.refuse(405, method, path, words=[allowed])
    for body in NO_JSON:
        client.refuse(400, "POST", "/families", body, headers={"Content-Type": "application/json"})
        client.refuse(400, "POST", "/machines", body)
    client.refuse(400, "POST", "/session", NO_JSON[0], role=None)
    for body in NO_OBJECT:
        client.refuse(422, "POST", "/families", body)
    for method, path, body, place in BODIES:
        client.refuse(422, method, path, body, headers=MATCH_1, places=[place])
    for member, value, place in PROFILES:
        client.refuse(422, "POST", "/machines", with_member(profile, member, value), words=[place])
        if member != "name":
            client.refuse(422, "PUT", "/machines/lathe", with_member(profile, member, value), headers=MATCH_1, words=[place])
    client.refuse(422, "PUT", "/machines/lathe", dict(profile, name="other"), headers=MATCH_1, words=["/name"])
    for query, status in QUERIES:
        client.refuse(status, "GET", query)
    for text, words in FAMILIES:
        client.refuse(422, "POST", "/families", {"text": text}, words=words)
    client.refuse(422, "PUT", "/families/hyperbolic-roll", {"text": ROLL.replace("family hyperbolic-roll", "family other")}, headers=MATCH_1, words=["other"])
    client.refuse(422, "POST", "/parts", {"number": "P", "family": "hyperbolic-roll", "values": {"roll_length": "5000 mm"}}, words=["roll_length", "line"])
    client.refuse(422, "POST", "/parts", {"number": "P", "family": "hyperbolic-roll", "values": {"roll_lenght": "200 mm"}}, words=["roll_lenght"])
    client.refuse(422, "POST", "/checks", {"program": 2, "machine": "lathe"}, words=["sinumerik"])
    client.refuse(401, "POST", "/session", {"token": "nonsense"}, role=None)
    client.finish()


def refuse_times_that_are_none(client, profile):
    client.refuse(422, "POST", "/tokens", {"name": "x", "role": "viewer", "expires_at_ms": 1_000}, words=["end before it is made"])
    for path in ("/history/sums", "/stop-reasons", "/audit"):
        client.refuse(422, "GET", f"{path}?from_ms=2000&to_ms=1000", words=["from_ms must be before to_ms"])


def refuse_states(client, profile):
    """What is there already, or is not allowed now."""
    expect(client.call("DELETE", "/machines").headers["Allow"] == "GET, POST", "a 405 without its Allow")
    client.refuse(409, "POST", "/machines", profile)
    client.refuse(409, "POST", "/families", {"text": ROLL})
    client.refuse(409, "POST", "/parts", {"number": "R-1", "family": "hyperbolic-roll", "values": {}})
    client.refuse(409, "POST", "/releases", {"program": 1, "machine": "lathe"})
    client.refuse(409, "POST", "/jobs", {"release": 1}, words=["draft"])
    client.refuse(409, "POST", "/machines/lathe/confirm-reset", {"reason": "nothing to confirm"})


def refuse_bodies_that_are_no_json(client):
    body = b'{"text":"x"}'
    for kind in ("text/plain", "text/plain; charset=utf-8", "application/xml", "multipart/form-data; boundary=x", "application/jsonx", "application/octet-stream"):
        client.refuse(415, "POST", "/families", body, headers={"Content-Type": kind})
    client.refuse(415, "POST", "/families", body, headers={"Content-Type": "application/json", "Content-Encoding": "gzip"})
    for kind in ("application/json", "Application/JSON; charset=utf-8", "application/json ;x=y", "application/x-www-form-urlencoded"):
        client.refuse(422, "POST", "/families", body, headers={"Content-Type": kind}, words=["line"])  # read, and no family
    client.refuse(422, "POST", "/families", body, words=["line"])


# Rows of MTConnect are answered in its own words; the page takes any address; those that any query reaches are asked without one.
OF_NO_API = ("/mtconnect/", "/assets/", "/docs", "/healthz", "/metrics", "/api/openapi.json")
NOT_STORED = {"id": "987654", "name": "nobody-of-this-name", "number": "nobody-of-this-name"}


def wrong_requests(method, path, operation):
    """Of a route of the description: (what is wrong, address, body)."""
    address = re.sub(r"\{(\w+)\}", lambda found: NOT_STORED.get(found[1], "987654"), path)
    body = operation.get("requestBody")
    takes_json = body and "application/json" in body["content"]
    yield "a query that it does not take", f"{address}?no_such_query=1", {} if takes_json else None
    if "{" in path and not takes_json and method != "PUT":
        yield "a thing that is not there", address, None
    if takes_json:
        for what, wrong in (("no object", b"[]"), ("no JSON", b"{"), ("a member that it does not take", b'{"no_such_member":1}'), ("bytes that are no text", b"\xff")):
            yield what, address, wrong


def refuse_at_each_route(client):
    """Made of the description, so that no route is without: each wrong request is refused with a code, and stores nothing."""
    asked = 0
    for method, path, _, operation in contract.routes():
        if path == "/" or path.startswith(OF_NO_API) or "text/event-stream" in str(operation["responses"].get("200", "")):
            continue
        for what, address, body in wrong_requests(method, path, operation):
            headers = MATCH_1 if any(one["name"] == "If-Match" for one in operation["parameters"]) else {}
            answer = client.call(method, address, body, headers=headers | ({"Content-Type": "application/json"} if body else {}))
            if what == "a thing that is not there" and 200 <= answer.status < 300:
                continue  # what is gone is gone: a removal that is asked for twice
            expect(400 <= answer.status < 500 and answer.document["code"], f"{method} {address}: {what}: {answer}")
            asked += 1
    print(f"{asked} wrong requests made of the description are refused")
    expect(asked > 400, f"only {asked}")


def with_member(profile, member, value):
    changed = dict(profile, name="other")
    if member.startswith("link."):
        changed["link"] = dict(profile["link"], **{member[5:]: value})
    else:
        changed[member] = value
    return changed


def nothing_is_stored(folder):
    control = HandControl()
    profile = hand_profile(control)
    client = Client(folder).start()
    client.post("/machines", profile)
    client.post("/families", {"text": ROLL})
    client.post("/parts", {"number": "R-1", "family": "hyperbolic-roll", "values": {}})
    client.add_program()
    client.post("/programs", {"name": "ROLL", "dialect": "sinumerik-840d", "text": "M30\n"})
    client.post("/checks", {"program": 1, "machine": "lathe"})
    client.post("/releases", {"program": 1, "machine": "lathe"})
    before = client.everything()
    for refuse in (lambda: refuse_all(client, profile), lambda: refuse_states(client, profile), lambda: refuse_times_that_are_none(client, profile), lambda: refuse_bodies_that_are_no_json(client), lambda: refuse_at_each_route(client)):
        refuse()
        after = client.everything()
        for name, items in before.items():
            expect(after[name] == items, f"{name} changed: {items} became {after[name]}")
    # The rows would be worthless if lists did not show what is stored.
    client.must("POST", "/programs/1/revisions", {"text": plain_program(3)}, headers=MATCH_1)
    expect(client.everything() != before, "a stored revision is not seen")
    expect(client.server.alive(), "the server is gone")
    client.server.stop()
    control.close()


if __name__ == "__main__":
    in_folder(nothing_is_stored)
    sys.exit(0)
