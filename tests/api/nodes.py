"""Several servers on one database: each has the lines of its machines, a line goes from one to another by a person alone, and a server that lost a
line moves no job on it. Each server has a folder and records of lines of its own, as on computers of their own."""

import functools
import os
import signal
import threading
import time

from client import DC1, DC3, Client, HandControl, expect, hand_profile, in_folder, plain_program, shop
from postgresql import Database, serve


class Node(Client):
    """A server with its own folder of records of lines."""

    def __init__(self, folder, url, name, of=None, more=()):
        os.environ["DRIPFEED_LINES"] = str(folder / f"lines-{name}")
        super().__init__(folder / name, "--store", url, "--node", name, *more)
        self.name, self.lines = name, os.environ["DRIPFEED_LINES"]
        if of:
            self.tokens = dict(of.tokens)
        self.start()

    def start(self):
        os.environ["DRIPFEED_LINES"] = self.lines
        return super().start()

    def machine(self, name="lathe"):
        return self.get(f"/machines/{name}")["status"]

    def nodes(self):
        return {node["name"]: node for node in self.get("/nodes")["items"]}


class Shop:
    """Nodes a and b; a has the lathe, b the mill."""

    def __init__(self, folder, database, name, more=()):
        self.url, self.folder = database.add(name), folder
        self.lathe, self.mill = HandControl(), HandControl()
        self.a = Node(folder, self.url, "a", more=more)
        self.a.post("/machines", hand_profile(self.lathe))
        self.b = Node(folder, self.url, "b", self.a, more)
        self.b.post("/machines", hand_profile(self.mill, "mill"))
        shop.wait_for("a to know of the mill", lambda: "node b" in (self.a.machine("mill")["link_error"] or ""))

    def feed(self, node, control, machine, blocks=400, number="O0042"):
        release = node.release(node.add_program(blocks, number)["id"], machine)["id"]
        job = node.queue(release)
        node.wait_line(machine, "idle")
        node.post(f"/jobs/{job}/arm")
        control.say(DC1)
        control.wait_bytes(600)
        return job

    def end(self):
        for node in (self.a, self.b):
            if node.server.alive():
                node.server.stop()


def each_has_the_lines_of_its_machines(folder, database):
    s = Shop(folder, database, "nodes_each")
    expect("node a" in s.b.machine("lathe")["link_error"], f"{s.b.machine('lathe')}")
    nodes = s.b.nodes()
    expect({name: [m["name"] for m in node["machines"]] for name, node in nodes.items()} == {"a": ["lathe"], "b": ["mill"]}, f"{nodes}")
    expect(nodes["b"]["this"] and not nodes["a"]["this"] and all(node["answers"] and node["url"].startswith("http://") for node in nodes.values()), f"{nodes}")
    first, second = s.feed(s.a, s.lathe, "lathe"), s.feed(s.b, s.mill, "mill", number="O0043")
    seen = s.b.get(f"/jobs/{first}")
    expect(seen["state"] == "feeding", f"what a feeds is not seen at b: {seen}")
    refused = s.b.call("POST", f"/jobs/{s.a.queue(seen['release'])}/arm")
    expect(refused.status == 409 and "node a" in refused.document["detail"], f"b arms a machine of a: {refused}")
    expect(s.b.call("POST", f"/jobs/{first}/stop").status == 409, "b stops a line that it has not")
    profile = s.b.call("GET", "/machines/lathe")
    changed = s.b.call("PUT", "/machines/lathe", hand_profile(s.lathe) | {"title": "other"}, headers={"If-Match": profile.headers["ETag"]})
    expect(changed.status == 409, f"b changes a profile whose line is at a: {changed}")
    for node, job in ((s.a, first), (s.b, second)):
        expect(not node.wait_job(job, "done")["torn"], "a job of two nodes is torn")
    expect(s.lathe.text().decode().strip() == plain_program(400).strip(), "another text at the lathe")
    # A restart of one interrupts nothing of the other.
    third = s.feed(s.b, s.mill, "mill", number="O0045")
    s.a.restart()
    expect(s.b.job(third)["state"] in ("feeding", "held", "draining"), f"{s.b.job(third)}")
    s.b.wait_job(third, "done")
    s.end()


def names_are_taken_once(folder, database):
    s = Shop(folder, database, "nodes_names")
    again = serve(folder / "again", "--store", s.url, "--node", "a")
    expect(again.returncode == 2 and "as node a" in again.stderr, f"{again}")
    alone = serve(folder / "alone", "--store", s.url)
    expect(alone.returncode == 2, f"{alone}")
    s.end()
    alone = serve(folder / "alone", "--store", s.url)
    expect(alone.returncode == 2 and "--node" in alone.stderr, f"{alone}")
    expect(serve(folder / "file", "--node", "a").returncode == 2, "a node without a store that is shared")


def a_person_hands_a_line_over(folder, database):
    s = Shop(folder, database, "nodes_hand_over")
    job = s.feed(s.a, s.lathe, "lathe")
    s.a.refuse(409, "POST", "/machines/lathe/hand-over", {"node": "b", "reason": "it moves"})
    s.a.wait_job(job, "done")
    s.b.refuse(409, "POST", "/machines/lathe/hand-over", {"node": "b", "reason": "it is not b's to give"})
    s.a.refuse(404, "POST", "/machines/lathe/hand-over", {"node": "nobody", "reason": "it moves"})
    s.a.refuse(422, "POST", "/machines/lathe/hand-over", {"node": "b", "reason": ""})
    s.b.refuse(409, "POST", "/machines/lathe/take-over", {"reason": "its node answers"})
    s.a.post("/machines/lathe/hand-over", {"node": "b", "reason": "the lathe moves to hall b"})
    s.lathe.wait_called(2)
    s.b.wait_line("lathe", "idle")
    expect("node b" in s.a.machine()["link_error"], f"{s.a.machine()}")
    expect(s.a.nodes()["b"]["machines"][0] | {"since_ms": 0} == {"name": "lathe", "lease": 2, "since_ms": 0, "given_by": "admin",
                                                                "reason": "the lathe moves to hall b"}, f"{s.a.nodes()['b']}")
    s.b.wait_job(s.feed(s.b, s.lathe, "lathe", number="O0050"), "done")
    spare = HandControl()
    s.a.post("/machines", hand_profile(spare, "spare"))
    s.a.post("/machines/spare/hand-over", {"node": "b", "reason": "before b knew of it"})
    s.b.wait_line("spare", "idle")
    s.end()


def a_dead_node_gives_nothing_back_by_itself(folder, database):
    s = Shop(folder, database, "nodes_dead")
    job = s.feed(s.a, s.lathe, "lathe", 3000)
    s.lathe.hold_inside_block()
    s.a.server.kill()
    arrived = len(s.lathe.text())
    s.b.refuse(409, "POST", "/machines/lathe/take-over", {"reason": "too soon"})
    shop.wait_for("a not to be heard of", lambda: not s.b.nodes()["a"]["answers"] or None, seconds=30)
    expect("node a" in s.b.machine()["link_error"], "b took a line by itself")
    s.b.refuse(422, "POST", "/machines/lathe/take-over", {"reason": ""})
    s.b.refuse(403, "POST", "/machines/lathe/take-over", {"reason": "no right"}, role="operator")
    taken = s.b.post("/machines/lathe/take-over", {"reason": "the computer of a is off, the cable is at b"})
    expect(taken["line"] == "torn" and taken["needs_confirmation"]["job"] == job, f"{taken}")
    known = s.b.get(f"/jobs/{job}/ledger")["interval"]
    expect(known["low"] <= arrived <= known["high"] and known["high"] == s.b.job(job)["bytes"], f"{arrived} arrived; {known}")
    expect(s.b.job(job)["state"] == "interrupted" and s.b.job(job)["torn"], f"{s.b.job(job)}")
    s.b.refuse(409, "POST", f"/jobs/{s.b.queue(s.b.job(job)['release'])}/arm")
    s.lathe.wait_called(2)
    before = len(s.lathe.text())
    s.lathe.say(DC1)
    time.sleep(1)
    expect(len(s.lathe.text()) == before, "bytes left on a line that may be torn")
    s.b.post("/machines/lathe/confirm-reset", {"reason": "RESET pressed"})
    s.b.wait_line("lathe", "idle")
    # What a has in its journal is booked when it comes again, and it has the line no longer.
    s.a.server.start()
    shop.wait_for("a to know that the lathe is b's", lambda: "node b" in (s.a.machine()["link_error"] or ""))
    s.b.wait_job(s.feed(s.b, s.lathe, "lathe", number="O0051"), "done")
    s.end()


def a_frozen_node_that_wakes_up_has_lost_the_line(folder, database):
    s = Shop(folder, database, "nodes_frozen")
    job = s.feed(s.a, s.lathe, "lathe", 3000)
    s.lathe.say(DC3)
    s.lathe.wait_quiet()
    os.kill(s.a.server.process.pid, signal.SIGSTOP)
    shop.wait_for("a not to be heard of", lambda: not s.b.nodes()["a"]["answers"] or None, seconds=30)
    s.b.post("/machines/lathe/take-over", {"reason": "a hangs, its cable is out"})
    os.kill(s.a.server.process.pid, signal.SIGCONT)
    shop.wait_for("a to leave the line", lambda: "node b" in (s.a.machine()["link_error"] or ""), seconds=30)
    s.lathe.wait_called(2)
    s.lathe.say(DC1)
    time.sleep(1)
    expect(s.lathe.text() == b"", "a byte left on a line that waits for a person's word")
    expect(s.a.job(job)["state"] == "interrupted", f"a moved a job of a line that it lost: {s.a.job(job)}")
    s.end()


def what_one_does_is_seen_at_the_other(folder, database):
    s = Shop(folder, database, "nodes_news")
    with Watched(s.b) as events:
        job = s.feed(s.a, s.lathe, "lathe", 60)
        s.a.wait_job(job, "done")
        seen = shop.wait_for("b's watchers to see the job of a", lambda: [one for one in events() if f'"id":{job},' in one and '"state":"done"' in one])
        expect(seen, "no event")
    s.end()


class Watched:
    """Events of a node as they come, read by a thread."""

    def __init__(self, node):
        self.connection = node.connect()
        self.connection.request("GET", "/api/v1/events", headers={"Authorization": f"Bearer {node.tokens['admin']}"})
        self.answer, self.lines = self.connection.getresponse(), []
        threading.Thread(target=self.read, daemon=True).start()

    def read(self):
        try:
            for line in self.answer:
                self.lines.append(line.decode())
        except (OSError, ValueError, AttributeError):
            pass  # the test ends

    def __enter__(self):
        return lambda: list(self.lines)

    def __exit__(self, *_):
        self.connection.close()


if __name__ == "__main__":
    made = Database()
    try:
        for test in (each_has_the_lines_of_its_machines, names_are_taken_once, a_person_hands_a_line_over, a_dead_node_gives_nothing_back_by_itself,
                     a_frozen_node_that_wakes_up_has_lost_the_line, what_one_does_is_seen_at_the_other):
            in_folder(functools.wraps(test)(lambda folder, test=test: test(folder, made)))
    finally:
        made.end()
