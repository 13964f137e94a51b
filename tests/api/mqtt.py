"""MQTT against a real broker (mosquitto) and its own client: what is retained, what comes as an event, what the broker says when the server is gone, and
that nothing is lost and nothing is held up while the broker is away."""

import json
import os
import shutil
import signal
import subprocess
import sys
import threading
import time

from client import DC1, Client, HandControl, binary, contract, expect, hand_profile, in_folder, shop

PREFIX = "plant/hall-2"
BROKER = shutil.which("mosquitto") or "/usr/sbin/mosquitto"


class Broker:
    """mosquitto on a port, with a user; `certificate`: (file, key), then it speaks TLS."""

    def __init__(self, folder, certificate=None):
        self.folder, self.port, self.process = folder, shop.free_port(), None
        (folder / "users").write_text("")
        subprocess.run(["mosquitto_passwd", "-b", str(folder / "users"), "dnc", "secret word"], check=True, capture_output=True)
        os.chmod(folder / "users", 0o644)
        lines = [f"listener {self.port} 127.0.0.1", "allow_anonymous false", f"password_file {folder}/users", "persistence false", "user root"]
        if certificate:
            lines += [f"certfile {certificate[0]}", f"keyfile {certificate[1]}"]
        (folder / "mosquitto.conf").write_text("\n".join(lines) + "\n")

    def start(self):
        self.process = subprocess.Popen([BROKER, "-c", str(self.folder / "mosquitto.conf")], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        shop.wait_for("the broker", lambda: shop.listens(self.port))
        return self

    def end(self):
        self.process.send_signal(signal.SIGKILL)
        self.process.wait()


class Subscriber:
    """mosquitto_sub on everything below the prefix."""

    def __init__(self, broker, *arguments):
        command = ["mosquitto_sub", "-h", "127.0.0.1", "-p", str(broker.port), "-u", "dnc", "-P", "secret word", "-q", "1", "-t", f"{PREFIX}/#", "-F", "%r|%q|%t|%p", *arguments]
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.lines, self.lock = [], threading.Lock()
        threading.Thread(target=self._read, daemon=True).start()
        shop.wait_for("the subscription", lambda: self._tried(broker, arguments), step=0.1)

    def _tried(self, broker, arguments):
        """What is not retained reaches only who has subscribed."""
        subprocess.run(["mosquitto_pub", "-h", "127.0.0.1", "-p", str(broker.port), "-u", "dnc", "-P", "secret word", "-t", f"{PREFIX}/try", "-m", "x", *arguments], timeout=10)
        return [line for line in self.lines if line[2].endswith("/try")]

    def _read(self):
        for line in self.process.stdout:
            retained, qos, topic, payload = line.rstrip("\n").split("|", 3)
            with self.lock:
                self.lines.append((retained == "1", int(qos), topic, payload))

    def all(self, part=""):
        with self.lock:
            return [line for line in self.lines if part in line[2] and not line[2].endswith("/try")]

    def events(self):
        return [json.loads(payload) for _, _, _, payload in self.all("/event/")]

    def last(self, topic):
        found = self.all(topic)
        return found[-1][3] if found else None

    def end(self):
        self.process.kill()
        self.process.wait()


def options(broker, folder):
    (folder / "word").write_text("secret word\n")
    return ["--mqtt", f"mqtt://127.0.0.1:{broker.port}", "--mqtt-user", "dnc", "--mqtt-password-file", str(folder / "word"), "--mqtt-prefix", PREFIX]


def feed(client, control):
    job = client.queue(client.release(client.add_program(10)["id"])["id"])
    client.post(f"/jobs/{job}/arm")
    control.say(DC1)
    client.wait_job(job, "done")
    return job


def states_and_events(folder):
    broker = Broker(folder).start()
    control = HandControl()
    client = Client(folder, *options(broker, folder)).start()
    client.post("/machines", hand_profile(control, "lathe +1/a"))
    client.wait_line("lathe%20%2B1%2Fa", "idle")
    subscriber = Subscriber(broker)
    shop.wait_for("the server's connection", lambda: subscriber.last("dripfeed/connection") == "online")
    shop.wait_for("the machine's state", lambda: subscriber.all("lathe %2B1%2Fa/state"))
    late = Subscriber(broker)
    shop.wait_for("what is retained", lambda: len(late.all()) >= 2)
    expect({topic.removeprefix(PREFIX + "/") for retained, _, topic, _ in late.all() if retained} == {"dripfeed/connection", "lathe %2B1%2Fa/state"}, f"{late.all()}")
    late.end()
    shop.wait_for("that it is idle", lambda: json.loads(subscriber.last("/state"))["line"] == "idle")
    contract.require(contract.faults("#/components/schemas/MachineStatus", json.loads(subscriber.last("/state"))), "a state")
    program = client.add_program(10)["id"]
    shop.wait_for("an event", lambda: subscriber.all("dripfeed/event/program/added"))
    event = json.loads(subscriber.last("dripfeed/event/program/added"))
    expect(event["specversion"] == "1.0" and event["data"]["program"] == program, f"{event}")
    contract.require(contract.faults("#/components/schemas/ProgramEvent", event), "an event")
    expect(all(qos == 1 for _, qos, _, _ in subscriber.all("/event/")), "an event came by another QoS than 1")
    # Nothing comes in: what is published to our own topics, or to one that looks like a command, changes nothing.
    before = client.everything()
    for topic in (f"{PREFIX}/lathe %2B1%2Fa/command", f"{PREFIX}/lathe %2B1%2Fa/event/job/done"):
        subprocess.run(["mosquitto_pub", "-h", "127.0.0.1", "-p", str(broker.port), "-u", "dnc", "-P", "secret word", "-t", topic, "-m", '{"arm":1}'], check=True, timeout=10)
    time.sleep(0.5)
    expect(client.everything() == before, "a message changed something")
    client.server.kill()
    shop.wait_for("the will", lambda: subscriber.last("dripfeed/connection") == "offline", 40)
    client.server.start()
    shop.wait_for("the server again", lambda: subscriber.last("dripfeed/connection") == "online")
    client.server.stop()
    shop.wait_for("its end", lambda: subscriber.last("dripfeed/connection") == "offline", 5)
    subscriber.end()
    broker.end()
    control.close()


def a_broker_that_is_away(folder):
    broker = Broker(folder)  # not started
    control = HandControl()
    client = Client(folder, *options(broker, folder)).start()
    client.post("/machines", hand_profile(control))
    client.wait_line("lathe", "idle")
    begun = time.monotonic()
    job = feed(client, control)
    print(f"a job without its broker: {time.monotonic() - begun:.1f} s")
    client.server.process.send_signal(signal.SIGSTOP)  # so that it does not connect before the subscriber
    subscriber = Subscriber(broker.start())
    client.server.process.send_signal(signal.SIGCONT)
    wanted = ["program.added", "release.draft", "release.in_review", "release.proving", "job.queued", "job.armed", "job.feeding", "job.done"]
    reported = lambda: [one["type"] for one in subscriber.events() if not one["type"].startswith("line.")]  # noqa: E731
    try:
        shop.wait_for("what happened meanwhile", lambda: reported() == wanted, 40)
    except TimeoutError as late:
        raise AssertionError(f"{late}: {reported()} {(client.server.data / 'server.log').read_text()[-1500:]}") from None
    shop.wait_for("the state", lambda: subscriber.last("lathe/state"))
    subscriber.end()
    time.sleep(2)  # the server notes what was confirmed
    broker.end()  # it forgets all
    second = client.add_program(10, "O0043")["id"]
    client.server.kill()
    subscriber = Subscriber(broker.start())
    client.server.start()
    shop.wait_for("an event from before the kill", lambda: [one for one in subscriber.events() if one["data"].get("program") == second], 40)
    shop.wait_for("the state again", lambda: subscriber.last("lathe/state"), 5)
    expect(not [one for one in subscriber.events() if one["data"].get("job") == job and one["type"].startswith("job.")], "what the broker had confirmed came again")
    client.server.stop()
    subscriber.end()
    broker.end()
    control.close()


def encrypted(folder):
    certificate = folder / "broker.crt", folder / "broker.key"
    subprocess.run(["openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes", "-days", "2", "-subj", "/CN=broker",
                    "-addext", "subjectAltName=IP:127.0.0.1", "-out", certificate[0], "-keyout", certificate[1]], check=True, capture_output=True)
    broker = Broker(folder, certificate).start()
    subscriber = Subscriber(broker, "--cafile", str(certificate[0]))
    given = options(broker, folder)
    given[1] = f"mqtts://127.0.0.1:{broker.port}"
    client = Client(folder, *given).start()
    time.sleep(2)
    expect(not subscriber.all(), "a broker that no one vouches for was believed")
    client.server.stop()
    client = Client(folder, *given, "--mqtt-ca", str(certificate[0])).start()
    shop.wait_for("the connection", lambda: subscriber.last("dripfeed/connection") == "online")
    client.server.stop()
    subscriber.end()
    broker.end()


def what_is_refused(folder):
    for arguments in (["--mqtt", "http://a"], ["--mqtt", "mqtt://"], ["--mqtt", "mqtt://u:p@a"], ["--mqtt", "mqtt://a:99999"], ["--mqtt", "mqtt://a", "--mqtt-prefix", "a/#"],
                      ["--mqtt", "mqtt://a", "--mqtt-prefix", "/a"], ["--mqtt", "mqtt://a", "--mqtt-user", "x", "--mqtt-password-file", str(folder / "none")],
                      ["--mqtt", "mqtts://a", "--mqtt-ca", str(folder / "none")]):
        done = subprocess.run([str(binary()), "serve", "--data", str(folder / "data"), "--listen", "127.0.0.1:0", *arguments], capture_output=True, text=True, timeout=20)
        expect(done.returncode == 2 and "--mqtt" in done.stderr, f"{arguments}: {done}")


if __name__ == "__main__":
    for test in (states_and_events, a_broker_that_is_away, encrypted, what_is_refused):
        begun = time.monotonic()
        in_folder(test)
        print(f"{test.__name__}: {time.monotonic() - begun:.1f} s")
    sys.exit(0)
