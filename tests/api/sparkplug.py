"""Sparkplug B against a real broker (mosquitto), read by the codec of Eclipse Tahu: births, what changes, deaths, their numbers and order, and that a host
can ask for births and for nothing else."""

import json
import pathlib
import subprocess
import sys
import threading
import time

from client import Client, HandControl, expect, hand_profile, in_folder, shop
from mqtt import Broker, feed, options

CODEC = ["node", str(pathlib.Path(__file__).with_name("sparkplug_codec.mjs"))]
NODE = "spBv1.0/hall/{}/dnc 1"


class Host:
    """What a host application sees: each message with its payload, in the order in which they came."""

    def __init__(self, broker):
        self.broker, self.messages, self.lock = broker, [], threading.Lock()
        self.connect()

    def connect(self):
        command = ["mosquitto_sub", "-h", "127.0.0.1", "-p", str(self.broker.port), "-u", "dnc", "-P", "secret word", "-q", "1", "-t", "spBv1.0/#", "-t", "try", "-F", "%t %x"]
        self.listener = subprocess.Popen(command, stdout=subprocess.PIPE)
        self.decoder = subprocess.Popen(CODEC, stdin=self.listener.stdout, stdout=subprocess.PIPE, text=True)
        threading.Thread(target=self._read, args=(self.decoder,), daemon=True).start()
        shop.wait_for("the subscription", self._tried, step=0.1)

    def _tried(self):
        self.publish("try", written({"timestamp": 1, "metrics": []}))
        return [one for one in self.messages if one["topic"] == "try"]

    def _read(self, decoder):
        for line in decoder.stdout:
            with self.lock:
                self.messages.append(json.loads(line))

    def publish(self, topic, payload):
        command = ["mosquitto_pub", "-h", "127.0.0.1", "-p", str(self.broker.port), "-u", "dnc", "-P", "secret word", "-t", topic, "-s" if payload else "-n"]
        subprocess.run(command, input=payload, check=True, timeout=10)

    def of(self, word):
        with self.lock:
            return [one["payload"] for one in self.messages if one["topic"].split("/")[2:3] == [word]]

    def in_order(self):
        with self.lock:
            return [(one["topic"].split("/")[2], one["payload"]) for one in self.messages if one["topic"].startswith("spBv1.0/") and "NCMD" not in one["topic"] and "DCMD" not in one["topic"]]

    def end(self):
        for process in (self.listener, self.decoder):
            process.kill()
            process.wait()


def written(payload):
    return bytes.fromhex(subprocess.run([*CODEC, "write"], input=json.dumps(payload), capture_output=True, text=True, check=True).stdout.strip())


def metrics(payload):
    return {one["name"]: one.get("value") for one in payload["metrics"]}


def types(payload):
    return {one["name"]: one["type"] for one in payload["metrics"]}


def number(payload):
    return metrics(payload)["bdSeq"]


def serve(folder, broker):
    return Client(folder, *options(broker, folder), "--sparkplug-group", "hall", "--sparkplug-node", "dnc 1").start()


def check_order(messages):
    """Each session begins with a birth of number 0, and each message has the next number; a death has none."""
    wanted = None
    for word, payload in messages:
        if word == "NBIRTH":
            wanted = 0
        if word == "NDEATH":
            expect("seq" not in payload or payload["seq"] is None, f"a death has a number: {payload}")
            continue
        expect(wanted is not None, f"{word} before the node's birth")
        expect(payload["seq"] == wanted, f"{word} has the number {payload['seq']}, not {wanted}")
        wanted = (wanted + 1) % 256


def with_a_lathe(test):
    """A server with one machine, both born at the host; all of it ends after the test."""

    def scene(folder):
        broker = Broker(folder).start()
        host = Host(broker)
        control = HandControl()
        client = serve(folder, broker)
        client.post("/machines", hand_profile(control, "lathe"))
        client.wait_line("lathe", "idle")
        shop.wait_for("the births", lambda: host.of("NBIRTH") and host.of("DBIRTH"))
        test(host, client, control)
        check_order(host.in_order())
        client.server.stop()
        host.end()
        broker.end()
        control.close()

    scene.__name__ = test.__name__
    return scene


@with_a_lathe
def births_and_changes(host, client, control):
    birth, device = host.of("NBIRTH")[0], host.of("DBIRTH")[0]
    expect(types(birth) == {"bdSeq": "Int64", "Node Control/Rebirth": "Boolean", "Properties/Software": "String"}, f"{birth}")
    expect(metrics(birth)["Node Control/Rebirth"] is False and metrics(birth)["Properties/Software"].startswith("dripfeed "), f"{birth}")
    known = types(device)
    expect(known["Line/State"] == "String" and known["Line/Needs Confirmation"] == "Boolean" and known["Job/Bytes"] == "Int64" and known["Job/Line Use"] == "Double", f"{known}")
    expect(metrics(device)["Control/State"] is None and metrics(device)["Job/Known To Line"] is None, "what is not known is null")
    expect(abs(birth["timestamp"] / 1000 - time.time()) < 60, f"{birth['timestamp']}")
    job = feed(client, control)
    shop.wait_for("the end of the job", lambda: any(metrics(one).get("Job/End") == "done" for one in host.of("DDATA")))
    seen = {}
    for one in host.of("DDATA"):
        expect(set(types(one).items()) <= set(known.items()), f"{types(one)} was not born")
        seen |= metrics(one)
    status = client.get("/machines/lathe")["status"]
    expect(seen["Job/Id"] == job and seen["Job/Bytes"] == status["total"] == seen["Job/Bytes Sent"] and seen["Job/Known To Line"] == status["block"], f"{seen} {status}")
    count = len(host.of("DDATA"))
    time.sleep(2.5)
    expect(len(host.of("DDATA")) == count, "what has not changed was sent again")
    client.server.stop()
    shop.wait_for("the death", lambda: host.of("NDEATH"))
    expect(number(host.of("NDEATH")[0]) == number(birth), "a death of another session")


@with_a_lathe
def what_a_host_may_ask(host, client, control):
    client.queue(client.release(client.add_program(10)["id"])["id"])
    time.sleep(6)  # a host gets births every five seconds at most
    births, before = len(host.of("NBIRTH")), client.everything()
    again = written({"timestamp": 1, "metrics": [{"name": "Node Control/Rebirth", "type": "Boolean", "value": True}]})
    host.publish(NODE.format("NCMD"), again)
    shop.wait_for("the births again", lambda: len(host.of("NBIRTH")) == births + 1 and len(host.of("DBIRTH")) >= 2)
    expect(number(host.of("NBIRTH")[-1]) == number(host.of("NBIRTH")[0]), "a birth that was asked for belongs to its session")
    for _ in range(30):
        host.publish(NODE.format("NCMD"), again)
    time.sleep(1)
    expect(len(host.of("NBIRTH")) <= births + 2, f"{len(host.of('NBIRTH'))} births for 31 questions in a row")
    arm = written({"timestamp": 1, "metrics": [{"name": name, "type": "Boolean", "value": True} for name in ("Node Control/Reboot", "Job/Arm", "Line/Needs Confirmation")]})
    for topic, payload in ((NODE.format("NCMD"), arm), (NODE.format("DCMD") + "/lathe", arm), (NODE.format("NCMD"), b"\xff\xff no payload"), (NODE.format("NCMD"), b""), (NODE.format("NCMD"), b"x" * 100_000)):
        host.publish(topic, payload)
    time.sleep(1)
    expect(client.everything() == before, "a message changed something")
    expect(client.get("/machines/lathe")["status"]["line"] == "idle", "a message armed a line")


def sessions(folder):
    """A session has one number, in its birth and in the will that the broker keeps: after a kill, a start and a broker that went."""
    broker = Broker(folder).start()
    host = Host(broker)
    client = serve(folder, broker)
    shop.wait_for("the birth", lambda: host.of("NBIRTH"))
    client.server.kill()
    shop.wait_for("the will", lambda: host.of("NDEATH"), 40)
    expect(number(host.of("NDEATH")[-1]) == number(host.of("NBIRTH")[-1]), "the will of another session")
    client.server.start()
    shop.wait_for("the next birth", lambda: len(host.of("NBIRTH")) == 2)
    expect(number(host.of("NBIRTH")[1]) == (number(host.of("NBIRTH")[0]) + 1) % 256, f"the next session has the next number: {[number(one) for one in host.of('NBIRTH')]}")
    check_order(host.in_order())
    broker.end()
    host.end()
    broker.start()
    host = Host(broker)
    shop.wait_for("the birth over a new connection", lambda: host.of("NBIRTH"), 40)
    client.server.kill()
    shop.wait_for("its will", lambda: host.of("NDEATH"), 40)
    expect(number(host.of("NDEATH")[-1]) == number(host.of("NBIRTH")[-1]), "the will of another session")
    host.end()
    broker.end()


if __name__ == "__main__":
    for test in (births_and_changes, what_a_host_may_ask, sessions):
        begun = time.monotonic()
        in_folder(test)
        print(f"{test.__name__}: {time.monotonic() - begun:.1f} s")
    sys.exit(0)
