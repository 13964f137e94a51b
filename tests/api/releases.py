"""The life of a release: every step that is allowed and every one that is not, what guards them, and what may be fed in which state."""

import hashlib
import pathlib
import sqlite3
import sys
import time

from client import DC1, Client, HandControl, expect, hand_profile, in_folder, plain_program

STATES = ["draft", "in_review", "proving", "approved", "obsolete"]
ALLOWED = {("draft", "in_review"), ("draft", "obsolete"), ("in_review", "draft"), ("in_review", "proving"), ("in_review", "obsolete"), ("proving", "in_review"),
           ("proving", "approved"), ("proving", "obsolete"), ("approved", "obsolete")}
STEPS_TO = {"draft": [], "in_review": ["in_review"], "proving": ["in_review", "proving"], "approved": ["in_review", "proving", "approved"], "obsolete": ["obsolete"]}
FED = {"proving", "approved"}


def move(state):
    return {"to": state, "note": "signed by a test", "transfers": 3}


class Texts:
    """Programs that differ, each checked, so that each has a release of its own."""

    def __init__(self, client, after=0):
        self.client, self.count = client, after

    def release_in(self, state):
        self.count += 1
        program = self.client.add_program(self.count + 2, f"O{self.count:04}")["id"]
        self.client.check(program)
        release = self.client.post("/releases", {"program": program, "machine": "lathe"})["id"]
        for step in STEPS_TO[state]:
            self.client.post(f"/releases/{release}/transitions", move(step))
        return release


def every_step(client):
    texts = Texts(client)
    for state in STATES:
        release = texts.release_in(state)
        for to in STATES:
            if (state, to) not in ALLOWED:
                client.refuse(409, "POST", f"/releases/{release}/transitions", move(to), words=[state, to])
        now = client.get(f"/releases/{release}")
        expect(now["state"] == state, f"a refused step moved {state} to {now['state']}")
        may_be_fed(client, release, state)
        for to in (to for at, to in ALLOWED if at == state):
            moving = texts.release_in(state)
            moved = client.post(f"/releases/{moving}/transitions", move(to))
            expect(moved["state"] == to and client.get(f"/releases/{moving}") == moved, f"{state} to {to}: {moved}")
            may_be_fed(client, moving, to)


def may_be_fed(client, release, state):
    if state in FED:
        expect(client.post("/jobs", {"release": release})["state"] == "queued", f"{state} is not fed")
    else:
        client.refuse(409, "POST", "/jobs", {"release": release}, words=[state])


def guards(client):
    unchecked = client.add_program(50, "O0050")["id"]
    release = client.post("/releases", {"program": unchecked, "machine": "lathe"})["id"]
    client.refuse(409, "POST", f"/releases/{release}/transitions", {"to": "in_review"}, words=["never checked"])
    client.check(unchecked)
    client.post(f"/releases/{release}/transitions", {"to": "in_review", "note": "now it was"})
    problem = client.refuse(422, "POST", f"/releases/{release}/transitions", {"to": "proving"})
    expect([e["pointer"] for e in problem["errors"]] == ["/transfers"], f"{problem}")
    client.post(f"/releases/{release}/transitions", {"to": "proving", "transfers": 1})
    client.refuse(409, "POST", f"/releases/{release}/transitions", {"to": "approved"}, words=["note"])
    approved = client.post(f"/releases/{release}/transitions", {"to": "approved", "note": "first part measured"})
    expect(approved["approved_by"] == "admin" and approved["sign_off"] == "first part measured", f"{approved}")
    client.refuse(409, "POST", "/releases", {"program": unchecked, "machine": "lathe"}, words=["exists"])
    client.post(f"/releases/{release}/transitions", {"to": "obsolete"})
    client.post("/releases", {"program": unchecked, "machine": "lathe"})  # the release is possible again


def a_programmer_hands_in(client):
    """And does no other step: not back from proving, not to a machine."""
    texts = Texts(client, after=200)
    client.must("POST", f"/releases/{texts.release_in('draft')}/transitions", {"to": "in_review"}, role="programmer")
    for state, to in ALLOWED - {("draft", "in_review")}:
        client.refuse(403, "POST", f"/releases/{texts.release_in(state)}/transitions", move(to), role="programmer", words=["approver"])
    client.refuse(404, "POST", "/releases/999999/transitions", {"to": "in_review"}, role="programmer")
    own = texts.release_in("draft")
    of = client.get(f"/releases/{own}")["program"]
    expect([one["id"] for one in client.get(f"/releases?program={of}")["items"]] == [own], "the list of one program's releases has others")
    client.refuse(422, "GET", "/releases?program=x", words=["program must be"])


def fail_is_never_released(client):
    text = plain_program(3, "O0900").replace("G00 X100. Z10.", "G00 X9000. Z10.")
    program = client.post("/programs", {"name": "O0900", "dialect": "fanuc", "text": text})["id"]
    verdict = client.post("/checks", {"program": program, "machine": "lathe"})
    expect(verdict["verdict"] == "fail", f"a move beyond the travel is {verdict['verdict']}")
    release = client.post("/releases", {"program": program, "machine": "lathe"})["id"]
    client.refuse(409, "POST", f"/releases/{release}/transitions", {"to": "in_review"}, words=["fail"])
    client.refuse(409, "POST", f"/checks/{verdict['id']}/waivers", {"reason": "it will be fine"}, words=["never waived"])
    client.refuse(409, "POST", f"/releases/{release}/transitions", {"to": "in_review"}, words=["fail"])
    client.refuse(409, "POST", "/jobs", {"release": release})


def unknown_needs_a_waiver(client):
    text = plain_program(3, "O0910").replace("M05", "M123\nM05")
    program = client.post("/programs", {"name": "O0910", "dialect": "fanuc", "text": text})["id"]
    verdict = client.post("/checks", {"program": program, "machine": "lathe"})
    expect(verdict["verdict"] in ("unknown", "warn"), f"a code that only the machine knows is {verdict['verdict']}")
    release = client.post("/releases", {"program": program, "machine": "lathe"})["id"]
    client.refuse(409, "POST", f"/releases/{release}/transitions", {"to": "in_review"}, words=[verdict["verdict"]])
    waived = client.must("POST", f"/checks/{verdict['id']}/waivers", {"reason": "M123 is the chip conveyor"}, role="approver")
    expect([(w["name"], w["reason"]) for w in waived["waivers"]] == [("the approver", "M123 is the chip conveyor")], f"{waived['waivers']}")
    client.post(f"/releases/{release}/transitions", {"to": "in_review"})


def each_point_is_waived(client):
    """One by one, and one for a time: then it counts no longer, and the refusal says so."""
    text = plain_program(3, "O0911").replace("M05", "M123\nM05").replace("F0.2", "F0.2 F0.3", 2)
    program = client.post("/programs", {"name": "O0911", "dialect": "fanuc", "text": text})["id"]
    verdict = client.post("/checks", {"program": program, "machine": "lathe"})
    expect(len(verdict["points"]) > 1, f"{verdict['points']}")
    release = client.post("/releases", {"program": program, "machine": "lathe"})["id"]
    waivers = f"/checks/{verdict['id']}/waivers"
    client.refuse(422, "POST", waivers, {"reason": "no", "point": "line 1: nothing of it"}, words=["point"])
    client.refuse(422, "POST", waivers, {"reason": "no", "expires_at_ms": 1000}, words=["over"])
    for point in verdict["points"][:-1]:
        client.must("POST", waivers, {"reason": "as meant", "point": point}, role="approver")
        client.refuse(409, "POST", f"/releases/{release}/transitions", {"to": "in_review"}, words=[verdict["verdict"]])
    end_ms = int(time.time() * 1000) + 1500
    client.must("POST", waivers, {"reason": "for now", "point": verdict["points"][-1], "expires_at_ms": end_ms}, role="approver")
    client.post(f"/releases/{release}/transitions", {"to": "in_review"})
    time.sleep(1.6)
    client.refuse(409, "POST", f"/releases/{release}/transitions", {"to": "proving", "transfers": 1}, words=["the approver has ended"])
    waived = client.must("POST", waivers, {"reason": "all of it"}, role="approver")
    expect(waived["waivers"][-1]["point"] is None and waived["waivers"][-2]["expires_at_ms"] == end_ms, waived["waivers"])
    client.post(f"/releases/{release}/transitions", {"to": "proving", "transfers": 1})


def another_text_is_not_released(client):
    release = Texts(client)
    release.count = 60
    old = client.get(f"/releases/{release.release_in('approved')}")
    program = old["program"]
    client.must("POST", f"/programs/{program}/revisions", {"text": plain_program(70)}, headers={"If-Match": '"1"'})
    new = client.post("/releases", {"program": program, "machine": "lathe"})
    expect(new["revision"] == 2 and new["sha256"] != old["sha256"], f"{new}")
    client.refuse(409, "POST", "/jobs", {"release": new["id"]}, words=["draft"])
    client.refuse(409, "POST", f"/releases/{new['id']}/transitions", {"to": "in_review"}, words=["never checked"])
    job = client.post("/jobs", {"release": old["id"]})
    expect((job["revision"], job["sha256"]) == (1, old["sha256"]), f"the release of one text feeds another: {job}")


def another_machine_is_not_released(client, control):
    profile = hand_profile(control)
    texts = Texts(client)
    texts.count = 80
    in_review, approved = texts.release_in("in_review"), texts.release_in("approved")
    queued = client.queue(approved)
    revision = client.get("/machines/lathe")["revision"]
    smaller = dict(profile, axes=[dict(axis, max_mm=axis["max_mm"] - 1) for axis in profile["axes"]])
    client.must("PUT", "/machines/lathe", smaller, headers={"If-Match": f'"{revision}"'})
    client.refuse(409, "POST", f"/releases/{in_review}/transitions", {"to": "proving", "transfers": 1}, words=["changed"])
    client.refuse(409, "POST", "/jobs", {"release": approved}, words=["changed"])
    client.wait_line("lathe", "idle")
    client.refuse(409, "POST", f"/jobs/{queued}/arm", words=["changed"])
    expect(client.job(queued)["state"] == "queued", "a refused arming moved the job")
    client.check(client.get(f"/releases/{approved}")["program"])  # a check for the machine as it is now
    client.post(f"/jobs/{client.queue(approved)}/cancel")
    client.post(f"/jobs/{queued}/arm")
    client.refuse(409, "PUT", "/machines/lathe", profile, headers={"If-Match": f'"{revision + 1}"'}, words=[f"job {queued}"])
    client.post(f"/jobs/{queued}/cancel")


def what_is_armed_is_not_withdrawn(client, control):
    """A job that was armed goes as soon as the control asks: its release is withdrawn before, or after its feed has begun."""
    release = client.release(client.add_program(400, "O0990")["id"])["id"]
    job = client.queue(release)
    client.wait_line("lathe", "idle")
    client.post(f"/jobs/{job}/arm")
    withdrawn = {"to": "obsolete", "note": "it crashed"}
    client.refuse(409, "POST", f"/releases/{release}/transitions", withdrawn, words=[f"job {job} is armed on lathe"])
    expect(client.get(f"/releases/{release}")["state"] in ("proving", "approved"), "it was withdrawn all the same")
    control.say(DC1)
    client.wait_job(job, "feeding")
    client.post(f"/releases/{release}/transitions", withdrawn)
    client.wait_job(job, "done")


def rules_of_the_sources():
    """The revision of the code that judges, made here of its sources a second time."""
    root = pathlib.Path(__file__).resolve().parents[2]
    paths = [path for folder in ("dialects", "checks", "server/app/checks", "server/machine") for path in (root / folder).rglob("*") if path.suffix in (".cpp", ".h")]
    paths += (root / "server/json").glob("profile_*")
    lines = "".join(f"{path.relative_to(root)} {hashlib.sha256(path.read_bytes()).hexdigest()}\n" for path in sorted(paths, key=str))
    return hashlib.sha256(lines.encode()).hexdigest()[:16]


def other_rules_than_those_of_the_verdict(folder):
    """After an upgrade that judges by other rules a verdict does not carry a release any further; one that was approved stays."""
    client = Client(folder).start()
    control = HandControl()
    client.post("/machines", hand_profile(control, "lathe"))
    client.waive_operators()
    texts = Texts(client)
    waiting, approved = texts.release_in("in_review"), texts.release_in("approved")
    verdicts = client.get("/checks")["items"]
    expect({row["rules"] for row in verdicts} == {rules_of_the_sources()} and not any(row["stale"] for row in verdicts), f"{verdicts}")
    client.server.stop()
    # As an older program would have left them: the store itself does not let them be changed.
    with sqlite3.connect(client.server.data / "dripfeed.db") as store:
        store.execute("DROP TRIGGER verdict_rules_update")
        store.execute("UPDATE verdict SET rules = 'older'")
    store.close()
    client.server.start()
    expect(all(row["stale"] and row["rules"] == "older" for row in client.get("/checks")["items"]), "verdicts by older rules are fresh")
    problem = client.refuse(409, "POST", f"/releases/{waiting}/transitions", {"to": "proving", "transfers": 1})
    expect(problem["code"] == "verdict_stale", f"{problem}")
    expect(client.post("/jobs", {"release": approved})["state"] == "queued", "an approval was taken back")
    client.check(client.get(f"/releases/{waiting}")["program"])
    client.post(f"/releases/{waiting}/transitions", {"to": "proving", "transfers": 1})
    client.server.stop()
    control.close()


def life_of_a_release(folder):
    control = HandControl()
    client = Client(folder).start()
    client.post("/machines", hand_profile(control))
    client.waive_operators()
    every_step(client)
    guards(client)
    a_programmer_hands_in(client)
    fail_is_never_released(client)
    unknown_needs_a_waiver(client)
    each_point_is_waived(client)
    another_text_is_not_released(client)
    another_machine_is_not_released(client, control)
    what_is_armed_is_not_withdrawn(client, control)
    client.server.stop()
    control.close()


if __name__ == "__main__":
    in_folder(life_of_a_release)
    in_folder(other_rules_than_those_of_the_verdict)
    sys.exit(0)
