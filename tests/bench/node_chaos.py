"""Two servers on one PostgreSQL database, and what goes wrong between them: a server killed, the database killed, the network between them dead or
slow, a server's own disk slow (strace holds up each fsync), at random moments while a line is fed and programs are added.

    node_chaos.py DRIPFEED [ROUNDS] [SEED]

After each round: every acknowledged program is there; the bytes that the control got lie in the interval that the ledger states, and each character is
the next one of the text; a job that ended well arrived whole; after a take-over not one byte left before a
person's word. Prints what happened by kind, and ends with 1 at the first lie."""

import collections
import os
import pathlib
import random
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time

sys.path[:0] = [str(pathlib.Path(__file__).resolve().parents[1] / "api")]
from client import DC1, HandControl, expect, hand_profile, plain_program, shop  # noqa: E402
from nodes import Node  # noqa: E402
from postgresql import Database  # noqa: E402

BLOCKS = 250  # 3.5 s at 19200 baud
TEXT = plain_program(BLOCKS).strip().encode()


class Wire:
    """A socket at which one server finds the database; it can be cut, or be silent in both directions."""

    def __init__(self, database, name):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix=f"dripfeed_wire_{name}_"))
        self.target = str(database.folder / ".s.PGSQL.5432")
        self.open, self.links = threading.Event(), []
        self.open.set()
        listener = socket.socket(socket.AF_UNIX)
        listener.bind(str(self.folder / ".s.PGSQL.5432"))
        listener.listen(64)
        threading.Thread(target=self.accept, args=(listener,), daemon=True).start()

    def accept(self, listener):
        while True:
            near, _ = listener.accept()
            far = socket.socket(socket.AF_UNIX)
            try:
                far.connect(self.target)
            except OSError:
                near.close()
                continue
            self.links.append((near, far))
            for one, other in ((near, far), (far, near)):
                threading.Thread(target=self.pass_on, args=(one, other), daemon=True).start()

    def pass_on(self, one, other):
        try:
            while piece := one.recv(65536):
                self.open.wait()
                other.sendall(piece)
        except OSError:
            pass
        for end in (one, other):
            try:
                end.shutdown(socket.SHUT_RDWR)
            except OSError:
                pass

    def cut(self):
        links, self.links = self.links, []
        for near, far in links:
            for end in (near, far):
                try:
                    end.shutdown(socket.SHUT_RDWR)
                except OSError:
                    pass


class Control(HandControl):
    """What came is forgotten before each feed."""

    def next_session(self):
        with self.lock:
            self.got.clear()


class Chaos:
    def __init__(self, folder, seed):
        self.random, self.database, self.control = random.Random(seed), Database(), Control()
        url = self.database.add("chaos")
        self.wires = {name: Wire(self.database, name) for name in "ab"}
        self.nodes = {}
        for name in "ab":
            self.nodes[name] = Node(folder, url.replace(str(self.database.folder), str(self.wires[name].folder)), name, self.nodes.get("a"))
            if name == "a":
                self.nodes[name].post("/machines", hand_profile(self.control))
        self.holder, self.known, self.happened = "a", [], collections.Counter()
        node = self.nodes["a"]
        self.program = node.add_program(BLOCKS)["id"]
        self.release = node.release(self.program, transfers=1_000_000)["id"]

    def other(self):
        return "b" if self.holder == "a" else "a"

    def add_programs(self, stop):
        """By the server that has no line; what it acknowledges must stay."""
        node, n = self.nodes[self.other()], 0
        while not stop.is_set():
            n += 1
            try:
                answer = node.call("POST", "/programs", {"name": f"P{time.monotonic_ns()}", "dialect": "fanuc", "text": f"%\nO0001\nN{n}G0X0\nM30\n%\n"})
            except OSError:
                time.sleep(0.05)
                continue
            if answer.status == 201:
                self.known.append(answer.document["id"])
            time.sleep(0.02)

    def round(self):
        node = self.nodes[self.holder]
        shop.wait_for("an idle line", lambda: self.machine(node)["line"] == "idle", seconds=60)
        self.control.next_session()
        job = shop.wait_for("a queued job", lambda: self.tried(node, "POST", "/jobs", {"release": self.release}), seconds=60)["id"]
        shop.wait_for("an armed job", lambda: self.tried(node, "POST", f"/jobs/{job}/arm"), seconds=60)
        stop = threading.Event()
        adding = threading.Thread(target=self.add_programs, args=(stop,))
        adding.start()
        self.control.say(DC1)
        time.sleep(self.random.uniform(0.0, 3.2))
        kind = self.random.choice([self.node_killed, self.database_killed, self.network_cut, self.network_silent, self.disk_slow, self.own_disk_slow, self.taken_over])
        arrived = kind(node)
        stop.set()
        adding.join(120)
        self.judge(job, arrived, kind.__name__)

    def machine(self, node):
        answer = node.call("GET", "/machines/lathe")
        return answer.document["status"] if answer.status == 200 else {"line": ""}

    @staticmethod
    def tried(node, method, path, body=None):
        try:
            answer = node.call(method, path, {} if body is None else body)
        except OSError:
            return None
        return answer.document if 200 <= answer.status < 300 else None

    # What goes wrong. Each returns what had arrived when its server could send no more; None: it could go on.

    def node_killed(self, node):
        node.server.kill()
        time.sleep(0.2)
        arrived = bytes(self.control.text())
        node.start()
        return arrived

    def database_killed(self, _):
        self.database.process.send_signal(self.random.choice([signal.SIGQUIT, signal.SIGKILL]))
        self.database.process.wait(60)
        time.sleep(self.random.uniform(0, 3))
        self.database.start()

    def network_cut(self, _):
        for _ in range(self.random.randint(1, 5)):
            self.wires[self.holder].cut()
            time.sleep(self.random.uniform(0, 0.5))

    def network_silent(self, _):
        wire = self.wires[self.holder]
        wire.open.clear()
        time.sleep(self.random.uniform(0.5, 5))
        wire.open.set()

    def disk_slow(self, _):
        """The database answers now and then."""
        processes = [self.database.process.pid, *self.database.children()]
        for _ in range(4):
            for sign in (signal.SIGSTOP, signal.SIGCONT):
                for process in processes:
                    try:
                        os.kill(process, sign)
                    except ProcessLookupError:
                        pass
                time.sleep(self.random.uniform(0.1, 0.6))

    def own_disk_slow(self, node):
        """What the server writes into its own folder is durable only after seconds; now and then it dies meanwhile."""
        delay_us = int(self.random.uniform(0.05, 3) * 1e6)
        slow = subprocess.Popen(["strace", "-f", "-qq", "-o", "/dev/null", "-e", "trace=fdatasync,fsync", "-e", f"inject=fdatasync,fsync:delay_exit={delay_us}",
                                 "-p", str(node.server.process.pid)], stderr=subprocess.PIPE)
        time.sleep(self.random.uniform(0.5, 4))
        expect(slow.poll() is None, f"strace: {slow.stderr.read() if slow.poll() is not None else ''}")
        arrived = self.node_killed(node) if self.random.random() < 0.3 else None
        slow.send_signal(signal.SIGINT)
        slow.wait(60)
        return arrived

    def taken_over(self, node):
        """The server dies, and a person takes its line to the other one."""
        node.server.kill()
        time.sleep(0.2)
        arrived = bytes(self.control.text())
        heir = self.nodes[self.other()]
        shop.wait_for("the dead server not to be heard of", lambda: heir.nodes()[node.name]["answers"] is False or None, seconds=60)
        expect("node" in (heir.machine()["link_error"] or ""), "a server took a line by itself")
        heir.post("/machines/lathe/take-over", {"reason": "its computer is off"})
        self.control.next_session()
        self.holder = heir.name
        shop.wait_for("the line at the heir", lambda: heir.machine()["line"] not in ("disconnected", ""), seconds=30)
        try:
            self.control.say(DC1)
        except OSError:
            pass
        time.sleep(0.3)
        if heir.machine()["needs_confirmation"]:
            expect(self.control.text() == b"", f"a byte left before a person's word: {self.control.text()[:40]}")
        node.start()
        return arrived

    def judge(self, job, arrived, kind):
        node = self.nodes[self.holder]
        ended = ("done", "failed", "cancelled", "interrupted", "queued")
        now = shop.wait_for("the end of the job", lambda: (lambda one: one if one and one["state"] in ended else None)(self.tried_get(node, f"/jobs/{job}")), seconds=90)
        text = arrived if arrived is not None else shop.wait_for("the text", lambda: self.settled(), seconds=60)
        expect(TEXT.startswith(text.strip(b"\r\n")) or text.startswith(TEXT), f"{kind}: other characters arrived: {text[-60:]}")
        known = shop.wait_for("the ledger", lambda: self.tried_get(node, f"/jobs/{job}/ledger"), seconds=60)["interval"]
        expect(known["low"] <= len(text) <= known["high"], f"{kind}: {len(text)} bytes arrived, the ledger states {known}")
        if now["state"] == "done":
            expect(len(text) == now["bytes"], f"{kind}: a job is done with {len(text)} of {now['bytes']} bytes")
        expect(now["state"] in ("done", "interrupted", "queued"), f"{kind}: {now}")
        self.happened[f"{kind}: {now['state']}"] += 1
        if now["needs_confirmation"] or node.machine()["line"] == "torn":
            node.post("/machines/lathe/confirm-reset", {"reason": "RESET pressed"})
        if now["state"] == "queued":
            node.post(f"/jobs/{job}/cancel")
        for program in self.known:
            expect(node.call("GET", f"/programs/{program}").status == 200, f"{kind}: program {program} was acknowledged and is lost")
        self.known = self.known[-20:]

    def settled(self):
        before = self.control.text()
        time.sleep(1.0)
        return bytes(before) if before == self.control.text() else None

    @staticmethod
    def tried_get(node, path):
        try:
            answer = node.call("GET", path)
        except OSError:
            return None
        return answer.document if answer.status == 200 else None


def main():
    rounds, seed = int(sys.argv[2]) if len(sys.argv) > 2 else 40, int(sys.argv[3]) if len(sys.argv) > 3 else 1
    with tempfile.TemporaryDirectory() as folder:
        chaos = Chaos(pathlib.Path(folder), seed)
        try:
            for n in range(rounds):
                chaos.round()
                print(f"{n + 1} of {rounds}: {dict(chaos.happened)}", flush=True)
        finally:
            for node in chaos.nodes.values():
                node.end()
            chaos.database.end()
    for what, count in sorted(chaos.happened.items()):
        print(f"{count:5} {what}")


if __name__ == "__main__":
    main()
