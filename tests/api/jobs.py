"""The life of a job, at a control that the test plays by hand: what is refused in each state, what each order does, what the ledger says of it; a
torn block; a kill in the middle; and one job to a simulated control on a pseudo-terminal."""

import hashlib
import json
import sys

from client import DC1, DC3, Client, HandControl, binary, expect, hand_profile, in_folder, plain_program, shop, verify

REASON = {"reason": "looked at the control"}
# The state of the job, the orders that are refused in it. What is not refused is taken in the walks below.
REFUSED = {
    "queued": ["stop", "resume"],
    "armed": ["arm", "stop", "resume"],
    "feeding": ["arm", "resume"],
    "held": ["arm"],
    "stopped": ["arm"],
    "draining": ["arm", "stop", "resume"],
    "done": ["arm", "stop", "cancel", "resume"],
    "cancelled": ["arm", "stop", "cancel", "resume"],
    "failed": ["arm", "stop", "cancel", "resume"],
    "interrupted": ["arm", "stop", "cancel", "resume"],
}


class Bench:
    """A server, one lathe that is played by hand, and a released program of `blocks` blocks."""

    def __init__(self, folder, blocks=150):
        self.control = HandControl()
        self.profile = hand_profile(self.control)
        self.profile["link"]["end_by_quiet_s"] = 1.0
        self.client = Client(folder).start()
        self.client.post("/machines", self.profile)
        self.text = plain_program(blocks)
        self.release = self.client.release(self.client.add_program(blocks)["id"])["id"]

    def order(self, job, command, body=None):
        return self.client.post(f"/jobs/{job}/{command}", body)

    def refuse(self, job, state):
        before = self.client.job(job)
        for command in REFUSED[state]:
            self.client.refuse(409, "POST", f"/jobs/{job}/{command}", REASON if command == "resume" else {})
        after = self.client.job(job)
        expect(after["state"] == before["state"] == ("held" if state == "stopped" else state), f"{before['state']} became {after['state']}, the row says {state}")

    def armed(self):
        job = self.client.queue(self.release)
        self.client.wait_line("lathe", "idle")
        armed = self.order(job, "arm")
        expect(armed["state"] == "armed" and armed["armed_by"] == "admin", f"{armed}")
        return job

    def feeding(self):
        job = self.armed()
        self.control.say(DC1)
        self.client.wait_job(job, "feeding")
        return job

    def feed_to_end(self, job):
        self.control.say(DC1)
        return self.client.wait_job(job, "done", "failed")

    def close(self):
        self.client.server.stop()
        self.control.close()


def from_the_queue_to_the_end(folder):
    bench = Bench(folder)
    client, control = bench.client, bench.control
    job = client.queue(bench.release)
    bench.refuse(job, "queued")
    other = client.queue(bench.release)
    client.wait_line("lathe", "idle")
    control.say(DC1)  # the control asks, nothing is armed
    bench.order(job, "arm", {"minutes": 5})
    bench.refuse(job, "armed")
    client.refuse(409, "POST", f"/jobs/{other}/arm", words=[f"job {job}"])
    expect(control.text() == b"", f"sent before the control asked: {control.text()}")
    control.say(DC1)
    client.wait_job(job, "feeding")
    bench.refuse(job, "feeding")
    control.hold_inside_block()
    client.wait_job(job, "held", stall="held by DC3")
    bench.refuse(job, "held")
    client.refuse(422, "POST", f"/jobs/{job}/resume", words=["/reason"])
    count = len(control.text())
    bench.order(job, "resume", REASON)
    control.wait_bytes(count + 1)
    bench.order(job, "stop")
    stopped = client.wait_job(job, "held", stall="stopped")
    expect(control.text().endswith(b"\n"), f"stopped inside a block: {control.text()[-30:]}")
    bench.refuse(stopped["id"], "stopped")
    bench.order(job, "resume")
    client.wait_job(job, "draining")
    bench.refuse(job, "draining")
    done = client.wait_job(job, "done")
    expect(control.text().decode().strip() == bench.text.strip(), "the text that came is not the text released")
    bench.refuse(job, "done")
    expect(done["bytes"] == len(control.text()) and not done["torn"] and done["started_at_ms"] <= done["ended_at_ms"], f"{done}")
    expect(client.get(f"/releases/{bench.release}")["transfers_done"] == 1, "one transfer is not counted as one")
    the_ledger(client, done)
    expect(client.job(other)["state"] == "queued", "the queue armed its next job")
    bench.order(other, "cancel")
    bench.refuse(other, "cancelled")
    bench.close()


def the_ledger(client, job):
    whole = client.get(f"/jobs/{job['id']}/ledger?limit=200")
    rows = whole["items"]
    expect([row["seq"] for row in rows] == list(range(1, len(rows) + 1)) and whole["next"] is None and len(rows) > 5, f"{[row['seq'] for row in rows]}")
    expect(rows[0]["note"].startswith("armed") and rows[0]["handed"] == 0, f"{rows[0]}")
    for before, row in zip(rows, rows[1:]):
        expect(row["reserve"] >= row["handed"] >= row["clocked"] >= row["confirmed"] == 0, f"{row}")
        expect(row["handed"] >= before["handed"] and row["clocked"] >= before["clocked"] and row["at_ms"] >= before["at_ms"], f"{before} then {row}")
        expect(row["handed"] <= before["reserve"], f"more was handed than {before} reserved: {row}")
    notes = "; ".join(row["note"] for row in rows)
    for note in ("held by DC3", "admin resumes as if DC1 had come: looked at the control", "stopped"):
        expect(note in notes, f"\"{note}\" is not in the ledger: {notes}")
    expect(whole["interval"] == {"low": job["bytes"], "high": job["bytes"], "known": "clocked"}, f"{whole['interval']} of {job['bytes']}")
    walked, after = [], ""
    while after is not None:
        page = client.get(f"/jobs/{job['id']}/ledger?limit=3{after}")
        expect(page["interval"] == whole["interval"], "the interval depends on the page")
        walked += page["items"]
        after = f"&after={page['next']}" if page["next"] else None
    expect(walked == rows, "the pages of the ledger are not the whole of it")


def cancelled_where_it_stands(folder):
    bench = Bench(folder)
    client, control = bench.client, bench.control
    armed = bench.armed()
    bench.order(armed, "cancel")
    client.wait_job(armed, "cancelled")
    control.say(DC1)
    client.wait_line("lathe", "idle")
    expect(control.text() == b"", "a cancelled job was sent")
    expect(client.get(f"/jobs/{armed}/ledger")["interval"]["high"] == 0, "bytes may have left a job that was never fed")

    fed = bench.feeding()
    bench.order(fed, "cancel")
    ended = client.wait_job(fed, "cancelled")
    expect(not ended["torn"] and control.text().endswith(b"\n"), f"cancelled inside a block: {control.text()[-30:]}")
    expect(b"M30" not in control.text() and control.text().count(b"%") == 1, "a cancelled text was ended")
    bench.refuse(fed, "cancelled")

    held = bench.feeding()
    control.hold_inside_block()
    client.wait_job(held, "held", stall="held by DC3")
    bench.order(held, "cancel")
    control.say(DC1)  # the rest of the block goes out, then it is over
    client.wait_job(held, "cancelled")
    expect(control.text().endswith(b"\n"), "cancelled inside a block")

    short = client.queue(bench.release)
    client.wait_line("lathe", "idle")
    bench.order(short, "arm", {"minutes": 0.01})
    expired = client.wait_job(short, "queued")
    expect("disarmed" in expired["reason"], f"{expired}")
    bench.order(short, "cancel")
    bench.close()


def nothing_after_a_torn_block(folder):
    bench = Bench(folder)
    client, control = bench.client, bench.control
    job = bench.feeding()
    control.hold_inside_block()
    got = len(control.text())
    control.cut()
    failed = client.wait_job(job, "failed")
    expect(failed["torn"] and failed["needs_confirmation"], f"{failed}")
    bench.refuse(job, "failed")
    interval = client.get(f"/jobs/{job}/ledger?limit=1")["interval"]
    expect(interval["low"] <= got <= interval["high"], f"{got} bytes came, the ledger has {interval}")
    next_job = client.queue(bench.release)

    def nothing_goes():
        status = client.wait_line("lathe", "torn")
        expect(status["needs_confirmation"]["job"] == job, f"{status}")
        client.refuse(409, "POST", f"/jobs/{next_job}/arm", words=["torn", f"job {job}"])
        client.refuse(422, "POST", "/machines/lathe/confirm-reset", {}, words=["/reason"])
        client.refuse(422, "POST", "/machines/lathe/confirm-reset", {"reason": ""}, words=["/reason"])
    nothing_goes()
    control.wait_called(2)
    control.say(DC1)
    client.restart()
    nothing_goes()
    control.wait_called(3)
    control.say(DC1)
    status = client.must("POST", "/machines/lathe/confirm-reset", {"reason": "RESET pressed"}, role="operator")
    expect(status["needs_confirmation"] is None, f"{status}")
    confirmed = client.job(job)
    expect((confirmed["confirmed_by"], confirmed["confirm_reason"], confirmed["needs_confirmation"]) == ("the operator", "RESET pressed", False), f"{confirmed}")
    client.refuse(409, "POST", "/machines/lathe/confirm-reset", {"reason": "again"})
    client.wait_line("lathe", "idle")
    expect(control.text() == b"", "bytes went out on a torn line")
    bench.order(next_job, "arm")
    expect(bench.feed_to_end(next_job)["state"] == "done", "the line does not work after the confirmation")
    bench.close()


def killed_in_the_middle(folder):
    bench = Bench(folder)
    client = bench.client
    job = bench.feeding()
    client.server.kill()
    verify(client.server.data)
    client.server.start()
    interrupted = client.job(job)
    expect(interrupted["state"] == "interrupted" and interrupted["needs_confirmation"], f"{interrupted}")
    bench.refuse(job, "interrupted")
    bench.close()


def transfers_of_a_proving(folder):
    bench = Bench(folder, blocks=4)
    client = bench.client
    release = client.post(f"/releases/{bench.release}/transitions", {"to": "in_review"})["id"]
    client.post(f"/releases/{release}/transitions", {"to": "proving", "transfers": 1})
    job, more = client.queue(release), client.queue(release)
    client.wait_line("lathe", "idle")
    problem = client.refuse(409, "POST", f"/releases/{release}/sign-off", {"note": "good"})
    expect(problem["code"] == "not_proved", f"{problem}")
    bench.order(job, "arm")
    expect(bench.feed_to_end(job)["state"] == "done", "the first transfer")
    client.wait_line("lathe", "idle")
    client.refuse(409, "POST", f"/jobs/{more}/arm", words=["used up"])
    client.refuse(409, "POST", "/jobs", {"release": release}, words=["used up"])
    approval = {"to": "approved", "note": "measured"}
    problem = client.refuse(409, "POST", f"/releases/{release}/transitions", approval)
    expect(problem["code"] == "not_signed_off", f"{problem}")
    sign_off = f"/releases/{release}/sign-off"
    client.refuse(422, "POST", sign_off, {"note": ""})
    client.refuse(403, "POST", sign_off, {"note": "good"}, role="viewer")
    proved = client.must("POST", sign_off, {"note": "all sizes good"}, role="operator")
    expect((proved["state"], proved["proved_by"], proved["proof"]) == ("proving", "the operator", "all sizes good"), f"{proved}")
    client.must("POST", f"/releases/{release}/transitions", approval, role="approver")
    bench.order(more, "arm")
    expect(bench.feed_to_end(more)["state"] == "done", "an approved text is not fed")
    client.post(f"/releases/{release}/transitions", {"to": "obsolete"})
    client.refuse(409, "POST", "/jobs", {"release": release}, words=["obsolete"])
    bench.close()


def to_a_simulated_control(folder):
    profile = shop.preset("fanuc-0i-lathe", url=f"pty:{folder}/lathe.tty", baud=9600, framing="7E2", end_by_quiet_s=1.0)
    profile["name"] = "lathe"
    machine = folder / "lathe.json"
    machine.write_text(json.dumps(profile))
    client = Client(folder).start()
    client.post("/machines", profile)
    release = client.release(client.add_program(40)["id"])["id"]
    control = shop.Control(binary(), profile["link"]["url"], machine, "--operator", "0.3", "--speed", "1000").start()
    job = client.queue(release)
    client.wait_line("lathe", "idle")
    client.post(f"/jobs/{job}/arm")
    ended = client.wait_job(job, "done", "failed")
    report = control.finish()
    text = plain_program(40)
    expect(ended["state"] == "done" and report["alarm"] is None, f"{ended} {report}")
    expect(report["text_sha256"] == hashlib.sha256(text[: text.rindex("%") + 1].encode()).hexdigest(), "another text came than was released")
    interval = client.get(f"/jobs/{job}/ledger?limit=1")["interval"]
    # A control that stops reading at the end leaves the trailer unsent.
    expect(interval["low"] == interval["high"] == report["bytes"] <= ended["bytes"], f"{interval}, {report['bytes']} came, {ended['bytes']} were to come")
    client.server.stop()


if __name__ == "__main__":
    for test in (from_the_queue_to_the_end, cancelled_where_it_stands, nothing_after_a_torn_block, killed_in_the_middle, transfers_of_a_proving, to_a_simulated_control):
        in_folder(test)
    sys.exit(0)
