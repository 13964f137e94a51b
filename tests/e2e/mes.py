"""The path of an order as a MES drives it, by the client that is generated from the description (web/test/mes.ts), against the server and a simulated
control. Meanwhile a webhook's receiver and a subscriber of an MQTT broker take what the server reports: both the same events, each once."""

import hashlib
import json
import os
import pathlib
import subprocess
import sys
import tempfile

from rig import ROOT, Rig, binary, expect, plain_program, shop

sys.path.insert(0, str(ROOT / "tests/api"))
from mqtt import Broker, Subscriber, options  # noqa: E402
from receiver import Receiver, verify  # noqa: E402

CALLERS = {"MES": ("operator", "queue"), "PROGRAMMER": ("programmer", None), "APPROVER": ("approver", None), "OPERATOR": ("operator", None)}


def token(data, name, role, scope):
    """The operator's has the name that the arming has to bear."""
    command = [binary(), "token", "add", f"the {name.lower()}", "--role", role, "--data", data, *(["--scope", scope] if scope else [])]
    return subprocess.run(list(map(str, command)), capture_output=True, text=True, check=True, timeout=30).stdout.strip()


def bundle(into):
    """As one file that node runs."""
    esbuild = ROOT / "web/node_modules/.bin/esbuild"
    subprocess.run([esbuild, ROOT / "web/test/mes.ts", "--bundle", "--platform=node", "--format=esm", "--log-level=warning", f"--outfile={into}"], check=True)


# What a MES follows of an order that goes as it should, in its order.
PATH = ["order.added", "program.added", "release.draft", "release.in_review", "release.proving", "job.queued", "job.armed", "job.done", "release.signed_off", "release.approved",
        "order.parts", "order.done"]


def what_was_reported(receiver, hook, subscriber):
    """All events by both, signed, and the path of the order among them."""
    shop.wait_for("the last event at the webhook", lambda: receiver.all(PATH[-1]))
    shop.wait_for("the last event at the broker", lambda: PATH[-1] in [event["type"] for event in subscriber.events()])
    posted = [verify(hook["secret"], message.headers, message.body) for message in receiver.all()]
    published = subscriber.events()
    expect({event["id"] for event in posted} == {event["id"] for event in published}, f"{[event['type'] for event in posted]} and {[event['type'] for event in published]}")
    expect(len(posted) == len({event["id"] for event in posted}), "an event came twice, with nothing between that failed")
    by_id = {event["id"]: event for event in posted}
    expect(all(by_id[event["id"]] == event for event in published), "one event has two contents")
    for events in (posted, published):
        types = [event["type"] for event in events]
        places = [types.index(one) for one in PATH]
        expect(places == sorted(places), f"another order: {types}")
    print(f"{len(posted)} events, each by the webhook and by MQTT: {', '.join(event['type'] for event in posted)}")


def main():
    with tempfile.TemporaryDirectory(prefix="dripfeed-mes-") as folder:
        script = f"{folder}/mes.mjs"
        bundle(script)
        broker = Broker(pathlib.Path(folder)).start()
        subscriber, receiver = Subscriber(broker), Receiver()
        rig = Rig(folder, f"tcp://127.0.0.1:{shop.free_port()}", baud=19200)
        rig.server.arguments = options(broker, pathlib.Path(folder))
        rig.server.start()
        control = rig.control()
        try:
            rig.server.add_machine(rig.profile)
            tokens = {f"TOKEN_{name}": token(rig.server.data, name, *what) for name, what in CALLERS.items()}
            hook = rig.server.post("/webhooks", {"url": receiver.url, "types": ["*"], "local": True})
            shop.wait_for("the connection to the broker", lambda: subscriber.all("/connection"))
            text = plain_program(40)
            walk = subprocess.run(["node", script], timeout=200, env={**os.environ, **tokens, "DRIPFEED_URL": f"http://127.0.0.1:{rig.server.port}", "PROGRAM": text})
            expect(walk.returncode == 0, f"the path of the order ended with {walk.returncode}")
            report = control.stop()
            sent = hashlib.sha256(text[: text.rindex("%") + 1].encode()).hexdigest()
            expect(report["text_sha256"] == sent, f"another text arrived: {json.dumps(report)[:1000]}")
            what_was_reported(receiver, hook, subscriber)
        finally:
            if rig.server.alive():
                rig.server.kill()
            subscriber.end()
            broker.end()


if __name__ == "__main__":
    sys.exit(main())
