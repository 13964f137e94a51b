"""Several servers on one database and one broker: each state and each event comes from one of them, also when a line changes hands and when the server
that did something is killed before the broker has it."""

import json
import time

from client import expect, in_folder, shop
from mqtt import Broker, Subscriber, options
from nodes import Shop
from postgresql import Database


class Hall(Shop):
    """Nodes a and b with the same broker and prefix."""

    def __init__(self, folder, database, name):
        self.broker = Broker(folder).start()
        self.subscriber = Subscriber(self.broker)
        super().__init__(folder, database, name, options(self.broker, folder))

    def states(self, machine):
        return [json.loads(payload) for _, _, _, payload in self.subscriber.all(f"{machine}/state")]

    def events(self, kind):
        return [event for event in self.subscriber.events() if event["type"] == kind]

    def end(self):
        super().end()
        self.subscriber.end()
        self.broker.end()


def each_message_comes_once(folder, database):
    hall = Hall(folder, database, "out_once")
    for name in ("a", "b"):
        shop.wait_for(f"the connection of {name}", lambda name=name: hall.subscriber.last(f"dripfeed/{name}/connection") == "online")
    for machine in ("lathe", "mill"):
        shop.wait_for(f"that the {machine} is idle", lambda machine=machine: hall.states(machine) and hall.states(machine)[-1]["line"] == "idle")
    program = hall.b.add_program(30)["id"]
    release = hall.b.release(program)["id"]
    job = hall.b.queue(release)  # at b, for the lathe of a
    hall.a.post(f"/jobs/{job}/arm")
    hall.lathe.say(b"\x11")
    hall.a.wait_job(job, "done")
    shop.wait_for("its end", lambda: hall.events("job.done"))
    hall.b.wait_job(hall.feed(hall.b, hall.mill, "mill", number="O0043"), "done")
    shop.wait_for("the end of the other", lambda: len(hall.events("job.done")) == 2)
    time.sleep(2)
    ids = [event["id"] for event in hall.subscriber.events()]
    expect(len(ids) == len(set(ids)), f"an event came twice: {[event['type'] for event in hall.subscriber.events()]}")
    of_job = [event["type"] for event in hall.subscriber.events() if event["data"].get("job") == job and event["type"].startswith("job.")]
    expect(sorted(of_job) == ["job.armed", "job.done", "job.feeding", "job.queued"], f"{of_job}")
    for machine, control in (("lathe", hall.lathe), ("mill", hall.mill)):
        lines = {state["link_error"] for state in hall.states(machine)}
        expect(not any(line and "node" in line for line in lines), f"{machine}: {lines}")
    hall.end()


def a_line_that_goes_over_is_published_by_who_has_it(folder, database):
    hall = Hall(folder, database, "out_over")
    shop.wait_for("the state", lambda: hall.states("lathe") and hall.states("lathe")[-1]["line"] == "idle")
    hall.a.post("/machines/lathe/hand-over", {"node": "b", "reason": "it moves"})
    hall.lathe.wait_called(2)
    hall.b.wait_line("lathe", "idle")
    shop.wait_for("the last word of a", lambda: any("node b" in (state["link_error"] or "") for state in hall.states("lathe")))
    # Whichever came last: b states its own again.
    shop.wait_for("what b states", lambda: hall.states("lathe")[-1]["line"] == "idle", seconds=75)
    job = hall.feed(hall.b, hall.lathe, "lathe", number="O0050")
    hall.b.wait_job(job, "done")
    shop.wait_for("its end", lambda: [event for event in hall.events("job.done") if event["data"]["job"] == job])
    time.sleep(2)
    ids = [event["id"] for event in hall.subscriber.events()]
    expect(len(ids) == len(set(ids)), "an event came twice")
    hall.end()


def what_a_killed_server_did_is_published_when_it_is_back(folder, database):
    hall = Hall(folder, database, "out_killed")
    shop.wait_for("the state", lambda: hall.states("lathe"))
    hall.broker.end()
    program = hall.a.add_program(20, "O0777")["id"]
    hall.a.server.kill()
    hall.subscriber.end()
    hall.broker.start()
    hall.subscriber = Subscriber(hall.broker)
    hall.b.add_program(20, "O0778")
    shop.wait_for("what b did", lambda: hall.events("program.added"), seconds=40)
    expect([event["data"]["program"] for event in hall.events("program.added")] != [program], "b published what a did")
    hall.a.start()
    shop.wait_for("what a did", lambda: program in [event["data"]["program"] for event in hall.events("program.added")], seconds=40)
    expect(len(hall.events("program.added")) == 2, f"{hall.events('program.added')}")
    hall.end()


if __name__ == "__main__":
    made = Database()
    try:
        for test in (each_message_comes_once, a_line_that_goes_over_is_published_by_who_has_it, what_a_killed_server_did_is_published_when_it_is_back):
            def run(folder, test=test):
                test(folder, made)
            run.__name__ = test.__name__
            in_folder(run)
    finally:
        made.end()
