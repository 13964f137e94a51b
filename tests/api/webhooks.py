"""Webhooks against the real server and receivers on loopback: what comes, signed by whom, and what happens to it when a receiver fails, redirects,
hangs, is gone, or when the server is killed before it sent."""

import json
import subprocess
import sys
import time
import urllib.parse

from client import DC1, Client, HandControl, binary, contract, expect, hand_profile, in_folder, shop
from receiver import Receiver, types_of_the_docs, verify

ALL = ["*"]
SCHEMAS = {"job": "JobEvent", "line": "LineEvent", "alarm": "AlarmEvent", "release": "ReleaseEvent", "program": "ProgramEvent", "receipt": "ReceiptEvent",
           "webhook": "WebhookEvent"}
PLANS = {"job.scheduled": "JobPlanEvent", "job.end_confirmed": "JobPlanEvent", "job.stop_reason": "JobStopEvent"}
MOST_BYTES = 20_000


def bench(folder, *arguments):
    control = HandControl()
    client = Client(folder, *arguments).start()
    client.post("/machines", hand_profile(control))
    client.wait_line("lathe", "idle")
    return client, control


def add(client, url, types=ALL, **more):
    made = client.post("/webhooks", {"url": url, "types": types, "local": True} | more)
    expect(made["secret"].startswith("whsec_"), f"{made}")
    return made


def feed(client, control):
    """A whole job, from its text to its end; its id."""
    job = client.queue(client.release(client.add_program(10)["id"])["id"])
    client.post(f"/jobs/{job}/arm")
    control.say(DC1)
    client.wait_job(job, "done")
    return job


def wait(what, condition, seconds=20):
    return shop.wait_for(what, condition, seconds)


def deliveries(client, hook, query="limit=200"):
    return client.get(f"/webhooks/{hook['id']}/deliveries?{query}")["items"]


def hold(message, secret):
    """One message against the standard, CloudEvents and our description."""
    event = verify(secret, message.headers, message.body)
    expect(message.headers["content-type"] == "application/cloudevents+json; charset=utf-8", f"{message.headers}")
    expect(abs(time.time() - int(message.headers["webhook-timestamp"])) < 60, f"{message.headers}")
    expect(event["id"] == message.id and len(message.body) < MOST_BYTES, f"{event}")
    schema = PLANS.get(event["type"], SCHEMAS[event["type"].split(".")[0]])
    contract.require(contract.faults(f"#/components/schemas/{schema}", event), event["type"])
    expect(event["type"] in contract.document()["webhooks"], f"{event['type']} is not described")
    for member in ("id", "source", "specversion", "type"):  # CloudEvents 1.0, REQUIRED
        expect(isinstance(event[member], str) and event[member], f"{member} of {event}")
    expect(urllib.parse.urlparse(event["source"]).scheme, f"{event['source']} is no absolute URI")
    return event


def a_plan_and_the_confirmation_of_an_end_come(folder):
    client, control = bench(folder)
    receiver = Receiver()
    hook = add(client, receiver.url, ["job.scheduled", "job.end_confirmed", "job.stop_reason"])
    release = client.release(client.add_program(10)["id"])["id"]
    job = client.post("/jobs", {"release": release, "end_check": "part taken out", "not_before_ms": int(time.time() * 1000) + 3_600_000})["id"]
    client.must("POST", f"/jobs/{job}/schedule", {})
    client.post(f"/jobs/{job}/arm")
    control.say(DC1)
    client.wait_job(job, "done")
    expect([one.document["type"] for one in receiver.all()] == ["job.scheduled"], "the end was confirmed by itself")
    client.must("POST", f"/jobs/{job}/confirm-end", {"note": "measured"}, role="operator")
    wait("the confirmation", lambda: receiver.all("job.end_confirmed"))
    client.must("POST", f"/jobs/{job}/stop-reasons", {"reason": "tool broken", "note": "insert of T3"}, role="operator")
    wait("the reason", lambda: receiver.all("job.stop_reason"))
    planned, confirmed, reason = [hold(one, hook["secret"]) for one in receiver.all()]
    expect(planned["data"]["note"] == "at any time" and planned["data"]["job"] == job, f"{planned}")
    expect(confirmed["data"]["note"] == "measured" and confirmed["data"]["actor"] == "the operator" and confirmed["data"]["machine"] == "lathe", f"{confirmed}")
    expect(reason["data"]["reason"] == "tool broken" and reason["data"]["note"] == "insert of T3" and reason["data"]["actor"] == "the operator", f"{reason}")
    client.server.stop()
    control.close()


def a_job_is_reported_from_its_text_to_its_end(folder):
    client, control = bench(folder, "--event-source", "https://dnc.shop/a")
    receiver, jobs_only = Receiver(), Receiver()
    hook = add(client, receiver.url, description="the MES")
    some = add(client, jobs_only.url, ["job.done", "alarm.*"])
    job = feed(client, control)
    wait("the end of the job", lambda: receiver.all("job.done"))
    wait("the state of the line", lambda: [one for one in receiver.all("line.idle") if one.document["data"]["job"] == job], 10)
    events = [hold(one, hook["secret"]) for one in receiver.all()]
    expect(len({one["id"] for one in events}) == len(events), "an event came twice")
    expect(all(one["source"] == "https://dnc.shop/a" for one in events), f"{events[0]}")
    types = [one["type"] for one in events if not one["type"].startswith("line.")]
    expect(types == ["program.added", "release.draft", "release.in_review", "release.proving", "job.queued", "job.armed", "job.feeding", "job.done"], f"{types}")
    done = next(one for one in events if one["type"] == "job.done")
    expect(done["subject"] == f"job/{job}" and done["data"]["state"] == "done" and done["data"]["machine"] == "lathe", f"{done}")
    expect(next(one for one in events if one["type"] == "job.armed")["data"]["actor"] == "admin", f"{events}")
    numbers = [one["sequence"] for one in events]
    expect(numbers == sorted(numbers), f"they came in another order: {numbers}")
    expect([one.document["type"] for one in jobs_only.all()] == ["job.done"], "a webhook got what it did not ask for")
    hold(jobs_only.all()[0], some["secret"])
    for wrong in (hook["secret"], "whsec_" + "A" * 32):  # the check can fail
        try:
            verify(wrong, jobs_only.all()[0].headers, jobs_only.all()[0].body)
        except ValueError:
            continue
        raise AssertionError("a message is valid under another secret")
    wait("the notes of all that came", lambda: {one["state"] for one in deliveries(client, hook)} == {"delivered"})
    states = {one["type"]: one for one in deliveries(client, hook)}
    expect({one["state"] for one in states.values()} == {"delivered"} and states["job.done"]["last_status"] == 204 and states["job.done"]["attempts"] == 1, f"{states}")
    expect(states["job.done"]["event"] == done["id"], f"{states['job.done']} is not {done}")
    text = json.dumps([client.get("/webhooks"), client.get(f"/webhooks/{hook['id']}"), deliveries(client, hook)])
    expect("whsec_" not in text and "secret\"" not in text, "a secret is shown again")
    secrets_turn(client, receiver, hook)
    client.must("DELETE", f"/webhooks/{hook['id']}")
    client.refuse(404, "GET", f"/webhooks/{hook['id']}")
    client.refuse(404, "POST", f"/webhooks/{hook['id']}/ping")
    client.server.stop()


def secrets_turn(client, receiver, hook):
    def ping():
        before = len(receiver.all("webhook.ping"))
        client.post(f"/webhooks/{hook['id']}/ping")
        return wait("a ping", lambda: receiver.all("webhook.ping")[before:])[0]

    hold(ping(), hook["secret"])
    turned = client.post(f"/webhooks/{hook['id']}/rotate", {"keep_hours": 1})
    expect(turned["secret"] != hook["secret"] and turned["old_secret_until_ms"], f"{turned}")
    message = ping()
    expect(len(message.headers["webhook-signature"].split()) == 2, f"{message.headers}")
    hold(message, hook["secret"])
    hold(message, turned["secret"])
    last = client.post(f"/webhooks/{hook['id']}/rotate", {"keep_hours": 0})
    message = ping()
    expect(len(message.headers["webhook-signature"].split()) == 1, f"{message.headers}")
    hold(message, last["secret"])


def receivers_that_fail(folder):
    client, control = bench(folder, "--webhook-retry-s", "0.2", "--webhook-retry-s", "0.4")
    elsewhere = Receiver()

    def redirect(handler):
        handler.send_response(302)
        handler.send_header("Location", elsewhere.url)
        handler.send_header("Content-Length", "0")
        handler.end_headers()

    def endless(handler):
        handler.send_response(200)
        handler.end_headers()
        try:
            while True:
                handler.wfile.write(b"x" * 65536)
        except OSError:
            return  # cut by the server, as it should

    hanging, failing, redirecting, gone, well, talking = Receiver(lambda handler: time.sleep(30)), Receiver(500), Receiver(redirect), Receiver(410), Receiver(), Receiver(endless)
    hooks = {receiver: add(client, receiver.url, ["release.*"]) for receiver in (hanging, failing, redirecting, gone, well, talking)}
    begun = time.monotonic()
    client.release(client.add_program(10)["id"])
    wait("what goes well", lambda: len(well.all()) == 3, 5)
    expect(time.monotonic() - begun < 10, "one that hangs keeps another one from its events")
    wait("three tries of each", lambda: len(failing.all()) == 9 and len(redirecting.all()) == 9)
    ids = {one.id for one in failing.all()}
    expect(len(ids) == 3 and all(sum(one.id == i for one in failing.all()) == 3 for i in ids), f"{[one.id for one in failing.all()]}")
    for receiver, status in ((failing, 500), (redirecting, 302)):
        dead = wait("dead ones", lambda: (lambda rows: rows if len(rows) == 3 else None)(deliveries(client, hooks[receiver], "state=dead")))
        expect(all((one["last_status"], one["attempts"], one["next_at_ms"]) == (status, 3, None) for one in dead), f"{dead}")
    expect(not elsewhere.all(), "a redirect was followed")
    wait("an answer without an end", lambda: [one for one in deliveries(client, hooks[talking]) if one["state"] == "delivered" and one["last_status"] == 200])
    off = wait("the one that is gone", lambda: (lambda now: now if not now["enabled"] else None)(client.get(f"/webhooks/{hooks[gone]['id']}")))
    expect("410" in off["why_disabled"] and len(gone.all()) == 1, f"{off} {len(gone.all())}")
    client.refuse(409, "POST", f"/webhooks/{off['id']}/ping")
    what_is_dead_is_sent_again(client, hooks[failing], failing)
    late = wait("the end of a try that hangs", lambda: [one for one in deliveries(client, hooks[hanging]) if one["attempts"]], 25)[0]
    expect(late["last_status"] is None and "imed out" in late["last_error"], f"{late}")
    expect(18 < time.monotonic() - begun < 40, "the try did not end after 20 s")
    client.server.stop()
    control.close()


def what_is_dead_is_sent_again(client, hook, receiver):
    path = f"/webhooks/{hook['id']}"
    rows = deliveries(client, hook)
    receiver.always = 200
    again = client.post(f"{path}/deliveries/{rows[0]['id']}/replay")
    expect((again["state"], again["attempts"], again["event"]) == ("pending", 0, rows[0]["event"]), f"{again}")
    wait("its delivery", lambda: deliveries(client, hook)[0]["state"] == "delivered")
    expect(receiver.all()[-1].id == rows[0]["event"], "it came as another one")
    verify(hook["secret"], receiver.all()[-1].headers, receiver.all()[-1].body)
    expect(client.post(f"{path}/replay", {"since_ms": int(time.time() * 1000) + 60_000}) == {"replayed": 0}, "what is to come was sent again")
    expect(client.post(f"{path}/replay", {"since_ms": rows[-1]["happened_at_ms"]}) == {"replayed": 2}, "not the dead ones alone")
    wait("all", lambda: {one["state"] for one in deliveries(client, hook)} == {"delivered"})
    client.refuse(404, "POST", f"{path}/deliveries/999999/replay")
    client.refuse(404, "POST", f"/webhooks/{hook['id'] + 1}/deliveries/{rows[0]['id']}/replay")


def nothing_is_lost_when_the_server_is_killed(folder):
    client, control = bench(folder)
    port = shop.free_port()
    hook = add(client, f"http://127.0.0.1:{port}/in", ["program.*", "release.*", "job.*"])
    job = feed(client, control)
    client.server.kill()  # nothing of it was delivered: no program listens there
    receiver = Receiver(port=port)
    client.server.start()
    for one in deliveries(client, hook):
        if one["state"] == "pending" and one["attempts"]:  # its next try is some time away
            client.post(f"/webhooks/{hook['id']}/deliveries/{one['id']}/replay")
    wanted = ["program.added", "release.draft", "release.in_review", "release.proving", "job.queued", "job.armed", "job.feeding", "job.done"]
    wait("all that happened", lambda: {one.document["type"] for one in receiver.all()} >= set(wanted))
    events = [hold(one, hook["secret"]) for one in receiver.all()]
    expect(len({one["id"] for one in events}) == len(wanted), f"{[one['type'] for one in events]}")
    expect({one["data"]["job"] for one in events if one["type"].startswith("job.")} == {job}, f"{events}")
    # Killed again and again while events come: each release that was answered has its event.
    made = []
    for _ in range(3):
        for _ in range(5):
            made.append(client.post("/programs", {"name": f"O{1000 + len(made)}", "dialect": "fanuc", "text": "%\nO1\nM30\n%\n"})["id"])
        client.server.kill()
        client.server.start()
    reported = lambda: {one.document["data"]["program"] for one in receiver.all("program.added")}  # noqa: E731
    wait("each program", lambda: reported() >= set(made))
    expect(reported() == set(made) | {1}, f"{reported()}")
    client.server.stop()
    control.close()


def certificate(folder, name):
    files = folder / f"{name}.crt", folder / f"{name}.key"
    subprocess.run(["openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes", "-days", "2", "-subj", f"/CN={name}",
                    "-addext", "subjectAltName=IP:127.0.0.1", "-out", files[0], "-keyout", files[1]], check=True, capture_output=True)
    return files


def only_where_it_was_meant(folder):
    known, unknown = certificate(folder, "known"), certificate(folder, "unknown")
    client, control = bench(folder, "--webhook-ca", str(known[0]), "--webhook-retry-s", "60")
    good, bad = Receiver(certificate=known), Receiver(certificate=unknown)
    hooks = {receiver: add(client, receiver.url) for receiver in (good, bad)}
    # A name that leads to this computer is found where it is connected to.
    hidden = client.post("/webhooks", {"url": f"https://localhost:{good.port}/in", "types": ALL})
    for hook in (*hooks.values(), hidden):
        client.post(f"/webhooks/{hook['id']}/ping")
    wait("the ping", lambda: good.all("webhook.ping"))

    def error(hook):
        return wait("the end of a try", lambda: [one["last_error"] for one in deliveries(client, hook) if one["last_error"]])[0]

    expect("certificate" in error(hooks[bad]), error(hooks[bad]))
    expect(not bad.all(), "a receiver with another certificate got it")
    expect("is not open to this call" in error(hidden) and len(good.all()) == 1, error(hidden))
    for url, word in [("http://mes.shop/in", "https"), ("https://127.0.0.1/in", "local"), ("https://10.1.2.3/in", "local"), ("https://[::1]/in", "local"),
                      ("https://[::ffff:192.168.1.1]/in", "local"), ("ftp://mes.shop/in", "https"), ("file:///etc/passwd", "https"), ("mes", "url"), ("", "url"),
                      ("https://user:word@mes.shop/in", "password"), ("https://mes.shop/in#top", "fragment"), ("https://2130706433/in", "local"), ("https://0x7f.1/in", "local")]:
        client.refuse(422, "POST", "/webhooks", {"url": url, "types": ALL}, words=[word])
    for url in ("http://169.254.169.254/latest/meta-data", "http://[fe80::1]/", "http://0.0.0.0/", "http://[fd00:ec2::254]/", "http://[::ffff:169.254.169.254]/"):
        client.refuse(422, "POST", "/webhooks", {"url": url, "types": ALL, "local": True}, words=["nothing is sent to"])
    what_is_refused(client, hooks[good])
    client.server.stop()
    control.close()


def what_is_refused(client, hook):
    url, path = "https://mes.shop/in", f"/webhooks/{hook['id']}"
    for body in [{}, {"url": url}, {"types": ALL}, {"url": url, "types": []}, {"url": url, "types": "job.done"}, {"url": url, "types": [7]}, {"url": url, "types": ["job.finished"]},
                 {"url": url, "types": ["jo*"]}, {"url": url, "types": ALL, "secret": "x"}, {"url": url, "types": ALL, "enabled": "yes"}, {"url": 7, "types": ALL},
                 {"url": url + "x" * 2000, "types": ALL}]:
        client.refuse(422, "POST", "/webhooks", body)
    client.refuse(400, "POST", "/webhooks", b"{")
    for body in ({"keep_hours": -1}, {"keep_hours": 1.5}, {"keep_hours": 9999}, {"hours": 1}):
        client.refuse(422, "POST", f"{path}/rotate", body)
    for body in ({}, {"since_ms": -1}, {"since_ms": "yesterday"}):
        client.refuse(422, "POST", f"{path}/replay", body)
    client.refuse(422, "GET", f"{path}/deliveries?state=lost")
    client.refuse(422, "PATCH", path, {"types": ["nothing.*"]})
    client.refuse(422, "PATCH", path, {"local": False}, words=["local"])
    changed = client.must("PATCH", path, {"types": ["job.*"], "enabled": False})
    expect((changed["types"], changed["enabled"], changed["url"], changed["why_disabled"]) == (["job.*"], False, hook["url"], None), f"{changed}")
    for _ in range(32 - len(client.get("/webhooks")["items"])):
        client.post("/webhooks", {"url": url, "types": ALL, "enabled": False})
    client.refuse(409, "POST", "/webhooks", {"url": url, "types": ALL})
    types = client.get("/event-types")["items"]
    expect({one["name"] for one in types} == set(contract.document()["webhooks"]), f"{types}")
    expect(types_of_the_docs() | {"webhook.ping"} == {one["name"] for one in types}, f"docs/integrating.md has {types_of_the_docs()}")
    for one in types:
        expect(one["schema"] in contract.document()["components"]["schemas"], f"{one}")


def a_secret_is_in_no_log(folder):
    """What the audit and the log state of webhooks: their receivers, never what signs."""
    client, control = bench(folder)
    hook = add(client, "http://127.0.0.1:9/in")
    client.post(f"/webhooks/{hook['id']}/ping")
    wait("a failed try", lambda: [one for one in deliveries(client, hook) if one["last_error"]])
    client.server.stop()
    expect("whsec_" not in (client.server.data / "server.log").read_text(), "the log has a secret")
    wrong = subprocess.run([str(binary()), "serve", "--data", str(folder / "other"), "--webhook-ca", str(folder / "none.pem")], capture_output=True, text=True, timeout=30)
    expect(wrong.returncode == 2 and "--webhook-ca" in wrong.stderr, f"{wrong}")
    control.close()


if __name__ == "__main__":
    for test in (a_job_is_reported_from_its_text_to_its_end, a_plan_and_the_confirmation_of_an_end_come, receivers_that_fail, nothing_is_lost_when_the_server_is_killed, only_where_it_was_meant, a_secret_is_in_no_log):
        begun = time.monotonic()
        in_folder(test)
        print(f"{test.__name__}: {time.monotonic() - begun:.1f} s")
    sys.exit(0)
