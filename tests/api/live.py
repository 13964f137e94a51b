"""What a browser has open: live events (numbered, resumable, `reset` where the ring has lost some), the session cookie and who may change things
with it, the page and its headers."""

import json
import subprocess
import sys
import time

from client import API, DC1, Client, HandControl, ask, binary, contract, expect, expect_problem, hand_profile, in_folder, shop

RING = 1024  # events that the server keeps


class Watch:
    """A stream of events, read as a browser reads it."""

    def __init__(self, client, last=None, role="viewer", path="/events"):
        self.connection = client.connect(timeout=20)
        headers = {"Authorization": f"Bearer {client.tokens[role]}"} | ({} if last is None else {"Last-Event-ID": str(last)})
        self.connection.request("GET", f"{API}{path}", headers=headers)
        self.response = self.connection.getresponse()
        expect(self.response.status == 200 and self.response.getheader("Content-Type") == "text/event-stream", f"{self.response.status}")
        expect(self.response.getheader("Cache-Control") == "no-store", "a stream of events may be cached")

    def next(self):
        """{"id", "event", "data"} of the next one; a comment has none of them."""
        event = {}
        while line := self.response.readline().decode().rstrip("\n"):
            name, _, value = line.partition(": ")
            if name:
                event[name] = json.loads(value) if name in ("data", "id") else value
        if "event" in event:
            contract.check_event(event["event"], event["data"])
        return event

    def numbered(self, count):
        """The next events that have a number."""
        found = []
        while len(found) < count:
            event = self.next()
            if "id" in event:
                found.append(event)
        return found

    def close(self):
        self.response.close()  # it has the socket, too
        self.connection.close()


def bench(folder, *arguments):
    control = HandControl()
    client = Client(folder, *arguments).start()
    client.post("/machines", hand_profile(control))
    client.wait_line("lathe", "idle")
    return client, control


def events_are_numbered_and_resumed(folder):
    client, control = bench(folder)
    release = client.release(client.add_program(150)["id"])["id"]
    watch = Watch(client)
    verdict = client.check(1)["id"]
    jobs = [client.queue(release) for _ in range(2)]
    client.post(f"/jobs/{jobs[1]}/cancel")
    seen = watch.numbered(4)
    numbers = [event["id"] for event in seen]
    expect(numbers == list(range(numbers[0], numbers[0] + 4)), f"the numbers are {numbers}")
    expect([event["event"] for event in seen] == ["verdict", "job", "job", "job"], f"{seen}")
    expect(seen[0]["data"]["id"] == verdict and seen[0]["data"]["machine"] == "lathe", f"{seen[0]}")
    expect([(e["data"]["id"], e["data"]["state"]) for e in seen[1:]] == [(jobs[0], "queued"), (jobs[1], "queued"), (jobs[1], "cancelled")], f"{seen}")
    expect(seen[3]["data"] == client.job(jobs[1]), "the event of a job is not the job")
    for known in range(4):
        again = Watch(client, last=numbers[known])
        client_sees = again.numbered(3 - known)
        expect(client_sees == seen[known + 1:], f"resumed after {known}: {client_sees}")
        again.close()
    a_feed_is_seen(client, control, watch, jobs[0])
    for wrong in ("x", "-1", "1.5", "99999999999999999999"):
        client.refuse(422, "GET", "/events", headers={"Last-Event-ID": wrong})
    for unknown in (1, numbers[0] - RING, numbers[0] + 10**6, 2**64 - 1):
        reset_first(client, unknown)
    last = watch_last(client)
    client.restart()
    reset_first(client, last)  # a number of the server before
    client.server.stop()
    control.close()


def a_feed_is_seen(client, control, watch, job):
    """Its states in their order; progress comes without numbers and at most five times a second."""
    client.post(f"/jobs/{job}/arm")
    control.say(DC1)
    begin, states, progress = time.monotonic(), [], 0
    while not states or states[-1] not in ("done", "failed"):
        event = watch.next()
        if event.get("event") == "job" and event["data"]["id"] == job:
            states.append(event["data"]["state"])
        if event.get("event") == "progress":
            progress += 1
            expect("id" not in event and event["data"]["machine"] == "lathe", f"{event}")
    expect(states == ["armed", "feeding", "draining", "done"], f"the states are {states}")
    expect(2 <= progress <= 5 * (time.monotonic() - begin) + 4, f"{progress} times progress in {time.monotonic() - begin:.1f} s")


def wait_events(watch, kinds):
    """Until each kind of event has come, 20 s at most: the stream itself never ends."""
    seen, until = set(), time.monotonic() + 20
    while not seen >= kinds:
        seen.add(watch.next().get("event"))
        expect(time.monotonic() < until, f"of {kinds} came {seen}")


def events_are_as_described(folder):
    """A receipt, a new machine and a DC1 that nothing waits for; then every kind of event of openapi.json has been compared with it."""
    client, control = bench(folder)
    watch = Watch(client)
    control.say(b"%\nO0700\nM30\n%\n")
    client.post("/machines", shop.preset("fanuc-0i-mill", url=f"pty:{folder}/nobody") | {"name": "mill"})
    wait_events(watch, {"receipt", "machine"})
    client.wait_line("lathe", "idle")
    wire = Watch(client, path="/machines/lathe/wire")
    control.say(DC1)
    wait_events(wire, {"wire"})
    wire.close()
    wait_events(watch, {"alarm"})
    missed = contract.events_never_validated()
    expect(not missed, f"no event was compared with openapi.json: {missed}")
    watch.close()
    client.server.stop()
    control.close()


def watch_last(client):
    watch = Watch(client)
    client.post(f"/jobs/{client.queue(1)}/cancel")
    last = watch.numbered(2)[1]["id"]
    watch.close()
    return last


def reset_first(client, last):
    watch = Watch(client, last=last)
    first = watch.next()
    expect(first["event"] == "reset" and first["data"] == {} and first["id"] > 0, f"after {last} came {first}")
    job = client.queue(1)
    after = watch.numbered(1)[0]
    expect(after["id"] == first["id"] + 1 and after["data"]["id"] == job, f"after the reset {first['id']} came {after}")
    watch.close()


def a_ring_that_went_round(folder):
    client, control = bench(folder)
    client.release(client.add_program()["id"])
    keen, slow = Watch(client), [Watch(client) for _ in range(20)]  # twenty who never read
    first = client.queue(1)
    connection, headers = client.connect(), {"Authorization": f"Bearer {client.tokens['admin']}"}
    for _ in range(RING // 2):
        job = ask(connection, "POST", f"{API}/jobs", {"release": 1}, headers).document["id"]
        ask(connection, "POST", f"{API}/jobs/{job}/cancel", {}, headers)
    seen = keen.numbered(1)
    while seen[0]["data"].get("id") != first:  # what was published before it may come after the watcher
        seen = keen.numbered(1)
    seen += keen.numbered(RING)
    numbers = [event["id"] for event in seen]
    expect(numbers == list(range(numbers[0], numbers[0] + 1 + RING)), "a watcher who reads has missed something")
    reset_first(client, numbers[0] - 1)  # the first of them is gone
    kept = Watch(client, last=numbers[2])
    expect(kept.numbered(RING - 2) == seen[3:], "what the ring still holds is not given")
    for watch in (keen, kept, *slow):
        watch.close()
    expect(client.call("GET", "/healthz", role=None).status == 200, "the server does not answer")
    client.server.stop()
    control.close()


def sign_in(client, role):
    answer = client.call("POST", "/session", {"token": client.tokens[role]}, role=None)
    expect(answer.status == 204 and answer.body == b"" and "Content-Type" not in answer.headers, f"{answer} {answer.headers}")
    cookie, *attributes = answer.headers["Set-Cookie"].split("; ")
    expect(sorted(attributes) == ["HttpOnly", "Path=/", "SameSite=Strict"], f"the cookie has {attributes}")
    return {"Cookie": f"other=1; {cookie}; more=2"}


def sessions(folder):
    client, control = bench(folder)
    here = {"Origin": f"http://127.0.0.1:{client.server.port}"}
    cookie = sign_in(client, "programmer")
    expect(client.must("GET", "/session", role=None, headers=cookie) == {"name": "the programmer", "role": "programmer", "by": "token", "scope": [], "machines": {}}, "who am I")
    expect(client.must("GET", "/session", role="viewer", headers=cookie)["role"] == "viewer", "a token counts before a cookie")
    program = {"name": "O1", "dialect": "fanuc", "text": "M30\n"}
    for origin, status in [
        ({}, 403), ({"Origin": "http://evil.example"}, 403), ({"Origin": "null"}, 403), ({"Origin": f"http://localhost:{client.server.port}"}, 403),
        ({"Origin": "http://127.0.0.1:1"}, 403), ({"Origin": f"http://evil.example/127.0.0.1:{client.server.port}"}, 403), ({"Sec-Fetch-Site": "cross-site"}, 403),
        ({"Sec-Fetch-Site": "same-site"}, 403), ({"Sec-Fetch-Site": "none"}, 403), (here | {"Sec-Fetch-Site": "cross-site"}, 403), (here | {"Sec-Fetch-Site": "same-site"}, 403),
        ({"Origin": "https://dnc.shop", "Sec-Fetch-Site": "same-origin"}, 201),  # a proxy that calls us by another name
        (here, 201), ({"Sec-Fetch-Site": "same-origin"}, 201),
    ]:
        answer = client.call("POST", "/programs", program, role=None, headers=cookie | origin)
        expect(answer.status == status, f"a change by cookie from {origin}: {answer}")
    expect(client.call("POST", "/jobs", {"release": 9}, role=None, headers=cookie | here).status == 404, "a programmer may do what an operator may")
    client.refuse(403, "POST", "/machines", {}, role=None, headers=cookie | here, words=["admin"])
    reading = client.call("GET", "/programs", role=None, headers=cookie | {"Origin": "http://evil.example"})
    expect(reading.status == 200 and "Access-Control-Allow-Origin" not in reading.headers, "another site may read")
    for origin in ("http://evil.example", "null"):
        client.refuse(403, "POST", "/session", {"token": client.tokens["viewer"]}, role=None, headers={"Origin": origin})
    client.refuse(413, "POST", "/session", {"token": "x" * 5000}, role=None)

    client.refuse(403, "DELETE", "/session", role=None, headers=cookie)
    other = sign_in(client, "programmer")
    gone = client.call("DELETE", "/session", role=None, headers=cookie | here)
    expect(gone.status == 204 and "Max-Age=0" in gone.headers["Set-Cookie"], f"{gone} {gone.headers}")
    client.refuse(401, "GET", "/session", role=None, headers=cookie)
    expect(client.call("GET", "/session", role=None, headers=other).status == 200, "one sign-out ended two sessions")
    client.restart()
    expect(client.call("GET", "/session", role=None, headers=other).status == 200, "a restart signed somebody out")
    client.refuse(401, "GET", "/session", role=None, headers=cookie)
    client.server.stop()
    control.close()


def the_name_that_the_page_shows(folder):
    """Two tabs share a cookie: a change under another's name is refused."""
    client, control = bench(folder)
    here = {"Origin": f"http://127.0.0.1:{client.server.port}"} | sign_in(client, "programmer")
    program = {"name": "O1", "dialect": "fanuc", "text": "M30\n"}
    for shown in ("the operator", "the%20operator", "The programmer", "%zz"):
        client.refuse(409, "POST", "/programs", program, role=None, headers=here | {"X-Dripfeed-User": shown}, words=["you are signed in as the programmer", "reload"])
    client.refuse(409, "POST", "/programs", program, role=None, headers=here | {"X-Dripfeed-User": "the%20operator"}, words=["the page shows the operator: reload"])
    client.refuse(409, "DELETE", "/session", role=None, headers=here | {"X-Dripfeed-User": "the operator"})
    client.refuse(409, "POST", "/programs", program, headers={"X-Dripfeed-User": "the operator"}, words=["admin"])
    expect(client.get("/programs")["items"] == [], "a refused change was made")
    expect(client.call("GET", "/programs", role=None, headers=here | {"X-Dripfeed-User": "the operator"}).status == 200, "reading is refused")
    for number, shown in enumerate(("the programmer", "the%20programmer")):
        expect(client.call("POST", "/programs", program, role=None, headers=here | {"X-Dripfeed-User": shown}).status == 201, f"{shown} is refused")
    token = client.add_token("programmer", "Jürgen 50%")
    shown = {"Authorization": f"Bearer {token}", "X-Dripfeed-User": "J%C3%BCrgen%2050%25"}
    expect(client.call("POST", "/programs", program, role=None, headers=shown).status == 201, "a name that needs its encoding")
    client.server.stop()
    control.close()


def tokens_of_a_running_server(folder):
    client = Client(folder).start()
    token = client.add_token("approver", "anna")
    headers = {"Authorization": f"bEaReR {token}"}
    expect(client.must("GET", "/session", role=None, headers=headers) == {"name": "anna", "role": "approver", "by": "token", "scope": [], "machines": {}}, "a new token")
    cookie = client.call("POST", "/session", {"token": token}, role=None).headers["Set-Cookie"].split(";")[0]
    listed = [line.split(maxsplit=3) for line in client.token_command("list").splitlines()]
    expect(listed[0][1:] == ["approver", "valid", "anna"] and len(listed) == 6, f"{listed}")
    expect(not any(token in " ".join(line) for line in listed), "the list shows a token")
    client.token_command("revoke", listed[0][0])
    client.refuse(401, "GET", "/session", role=None, headers=headers)
    client.refuse(401, "GET", "/session", role=None, headers={"Cookie": cookie})
    expect(client.token_command("list").splitlines()[0].split(maxsplit=3)[1:] == ["approver", "revoked", "anna"], "a revoked token")
    for wrong in (["add", "bert", "--role", "boss"], ["add", "", "--role", "viewer"], ["add", "bert"], ["revoke", "99"], ["list", "--data", str(folder / "nothing")], []):
        arguments = wrong if "--data" in wrong or not wrong else [*wrong, "--data", str(client.server.data)]
        done = subprocess.run([str(binary()), "token", *arguments], capture_output=True, text=True, timeout=30)
        expect(done.returncode == 2 and done.stdout == "" and done.stderr, f"token {wrong}: {done}")
    expect(not (folder / "nothing").exists() and len(client.token_command("list").splitlines()) == 6, "a wrong command made something")
    client.server.stop()


def the_page(folder):
    web = folder / "web"
    (web / "assets" / "folder").mkdir(parents=True)
    (web / "secret.txt").write_text("not of the page")
    files = {"/": ("index.html", "text/html; charset=utf-8"), "/assets/app.js": ("assets/app.js", "text/javascript; charset=utf-8"), "/assets/app.css": ("assets/app.css", "text/css; charset=utf-8"),
             "/assets/i.svg": ("assets/i.svg", "image/svg+xml"), "/assets/i.png": ("assets/i.png", "image/png"),
             "/docs": ("docs/index.html", "text/html; charset=utf-8"), "/docs/safety": ("docs/safety.html", "text/html; charset=utf-8"), "/docs/floor.png": ("docs/floor.png", "image/png")}
    (web / "docs").mkdir()
    for path, (name, _) in files.items():
        (web / name).write_text(f"{path} of a test")
    client = Client(folder, "--web", str(web)).start()
    for path, (_, kind) in files.items():
        for method in ("GET", "HEAD"):
            answer = client.call(method, path, role=None)
            expect(answer.status == 200 and answer.headers["Content-Type"] == kind, f"{method} {path}: {answer.status} {answer.headers['Content-Type']}")
            expect(answer.body.decode() == ("" if method == "HEAD" else f"{path} of a test"), f"{method} {path}: {answer}")
            expect(int(answer.headers["Content-Length"]) == len(f"{path} of a test"), f"{method} {path}: Content-Length {answer.headers['Content-Length']}")
            policy = answer.headers["Content-Security-Policy"]
            for rule in ("default-src 'none'", "script-src 'self'", "frame-ancestors 'none'", "base-uri 'none'"):
                expect(rule in policy, f"{path}: {rule} is not in {policy}")
            expect("unsafe" not in policy and answer.headers["Cache-Control"] == "no-cache" and answer.headers["X-Content-Type-Options"] == "nosniff", f"{path}: {answer.headers}")
    for path in ("/assets/folder", "/assets/", "/assets/..%2fsecret.txt", "/assets/%2e%2e%2fsecret.txt", "/assets/..%5csecret.txt", "/assets/.hidden", "/secret.txt", "/index.html", "//", "/assets/app.js/",
                 "/docs/none", "/docs/..%2fsecret.txt", "/docs/.hidden", "/docs//", "/docs/safety/"):
        expect_problem(client.call("GET", path, role=None), 404, path) if path.startswith(("/assets/", "/docs/")) else expect(client.call("GET", f"/api/..{path}", role=None).status in (400, 404), path)
    browser = {"Accept": "text/html,application/xhtml+xml,*/*;q=0.8"}
    for headers in ({}, browser):
        answer = ask(client.connect(), "GET", "/docs/", headers=headers)
        expect(answer.status == 200 and answer.body == b"/docs of a test", f"/docs/ is not the documentation: {answer}")
    for path in ("/jobs/3", "/machines/mill%201", "/nowhere"):
        answer = ask(client.connect(), "GET", path, headers=browser)
        expect(answer.status == 200 and answer.body == b"/ of a test", f"a browser at {path} is not shown the page: {answer}")
        expect_problem(ask(client.connect(), "GET", path), 404, path)
    for path in ("/api/v1/nothing", "/api/nothing", "/assets/nothing.js"):
        expect_problem(client.call("GET", path, headers=browser), 404, f"{path} for a browser")
    for path in ("/healthz", "/api/openapi.json", "/api/v1/machines", "/api/v1/nothing"):
        headers = client.call("GET", path).headers
        expect((headers["Cache-Control"], headers["X-Content-Type-Options"]) == ("no-store", "nosniff"), f"{path}: {headers}")
    client.server.stop()


def files_that_are_kept(folder):
    """Compressed twins, tags, and names that carry a hash."""
    web = folder / "web"
    (web / "assets").mkdir(parents=True)
    forever = "public, max-age=31536000, immutable"
    script, big = web / "assets" / "app-1A2B3C4D.js", "text of a test " * 10000
    script.write_text(big)
    for ending, content in ((".br", "as br"), (".gz", "as gzip")):
        (web / "assets" / f"app-1A2B3C4D.js{ending}").write_text(content)
    for name in ("index.html", "assets/app.css", "assets/font-ABCDEFGH.woff2", "assets/app-1a2b3c4d.js", "assets/app-1A2B3C4.js", "assets/w.webmanifest", "assets/d.json", "assets/x.unknown"):
        (web / name).write_text(f"{name} of a test")
    client = Client(folder, "--web", str(web)).start()

    def ask_for(path, method="GET", **headers):
        return client.call(method, path, role=None, headers={name.replace("_", "-"): value for name, value in headers.items()})
    tags = {}
    for accept, coding, body in [(None, None, big), ("gzip", "gzip", "as gzip"), ("gzip, deflate, br, zstd", "br", "as br"), ("BR;q=0.1, gzip;q=1", "br", "as br"), ("br;q=0, gzip", "gzip", "as gzip"),
                                 ("br;q=0.000", None, big), ("identity", None, big), ("brotli, xgzip", None, big), ("gzip ; q=0.5", "gzip", "as gzip")]:
        answer = ask_for("/assets/app-1A2B3C4D.js", **({"Accept_Encoding": accept} if accept else {}))
        expect(answer.status == 200 and answer.body.decode() == body and answer.headers.get("Content-Encoding") == coding, f"{accept}: {answer.headers.get('Content-Encoding')}")
        expect((answer.headers["Content-Type"], answer.headers["Vary"], answer.headers["Cache-Control"]) == ("text/javascript; charset=utf-8", "Accept-Encoding", forever), f"{answer.headers}")
        expect(tags.setdefault(coding, answer.headers["ETag"]) == answer.headers["ETag"], "one content has two tags")
    expect(len(set(tags.values())) == 3, f"two contents have one tag: {tags}")
    for path, kind, cache in [("/", "text/html; charset=utf-8", "no-cache"), ("/assets/app.css", "text/css; charset=utf-8", "no-cache"), ("/assets/font-ABCDEFGH.woff2", "font/woff2", forever),
                              ("/assets/app-1a2b3c4d.js", "text/javascript; charset=utf-8", "no-cache"), ("/assets/app-1A2B3C4.js", "text/javascript; charset=utf-8", "no-cache"),
                              ("/assets/w.webmanifest", "application/manifest+json", "no-cache"), ("/assets/d.json", "application/json", "no-cache"), ("/assets/x.unknown", "application/octet-stream", "no-cache")]:
        answer = ask_for(path)
        tag = answer.headers["ETag"]
        expect((answer.headers["Content-Type"], answer.headers["Cache-Control"], answer.headers["Vary"]) == (kind, cache, "Accept-Encoding"), f"{path}: {answer.headers}")
        for known in (tag, f"W/{tag}", f'"other", {tag}', "*"):
            for method in ("GET", "HEAD"):
                kept = ask_for(path, method, If_None_Match=known)
                expect((kept.status, kept.body, kept.headers["ETag"], kept.headers["Cache-Control"]) == (304, b"", tag, cache), f"{path} with {known}: {kept} {kept.headers}")
        expect(ask_for(path, If_None_Match='"other"').body == answer.body, f"{path}: another tag")
    before = ask_for("/").headers["ETag"]
    (web / "index.html").write_text("a new build")
    answer = ask_for("/", If_None_Match=before)
    expect(answer.status == 200 and answer.body == b"a new build" and answer.headers["ETag"] != before, f"an old page is kept: {answer}")
    client.server.stop()


if __name__ == "__main__":
    for test in (events_are_numbered_and_resumed, a_ring_that_went_round, events_are_as_described, sessions, the_name_that_the_page_shows, tokens_of_a_running_server, the_page, files_that_are_kept):
        in_folder(test)
    sys.exit(0)
