"""What is planned of jobs: a time before which one is not armed, a choice of machines of which one is armed, and an end that a person confirms before
the next job. And what no plan does: nothing is armed, begun or resumed by one."""

import sys
import time

from client import DC1, Client, HandControl, expect, hand_profile, in_folder

HOUR_MS = 3_600_000


class Shop:
    """Machines that the test plays, and one program that is released for those that are named."""

    def __init__(self, folder, *names, released=None, **profile):
        self.controls = {name: HandControl() for name in names}
        self.client = Client(folder).start()
        for name, control in self.controls.items():
            self.client.post("/machines", hand_profile(control, name) | profile)
        self.program = self.client.add_program(150)["id"]
        self.releases = {name: self.client.release(self.program, name)["id"] for name in (released or names)}
        for name in names:
            self.client.wait_line(name, "idle")

    def add(self, machine="lathe", **plan):
        return self.client.must("POST", "/jobs", {"release": self.releases[machine]} | plan, role="operator")

    def arm(self, job, role="operator", **words):
        return self.client.must("POST", f"/jobs/{job}/arm", words, role=role)

    def refuse_arming(self, job, code, role="operator", words=(), status=409, **body):
        answer = self.client.refuse(status, "POST", f"/jobs/{job}/arm", body, role=role, words=words)
        expect(answer["code"] == code, f"{answer}")
        return answer

    def feed(self, job, machine="lathe"):
        self.arm(job)
        self.controls[machine].say(DC1)
        self.client.wait_job(job, "done")

    def audited(self, job):
        return [row["action"] for row in self.client.get(f"/audit?subject=job/{job}")["items"]]

    def close(self):
        self.client.server.stop()
        for control in self.controls.values():
            control.close()


def now_ms():
    return round(time.time() * 1000)


def no_job_is_armed_before_its_time(folder):
    shop = Shop(folder, "lathe")
    client = shop.client
    job = shop.add(not_before_ms=now_ms() + HOUR_MS)["id"]
    planned = client.job(job)
    expect(planned["state"] == "queued" and planned["not_before_ms"] > now_ms(), f"{planned}")
    shop.refuse_arming(job, "too_early", words=[f"job {job} not before 20"])
    shop.refuse_arming(job, "role_missing", early_reason="the part is missing", status=403, words=["approver"])
    shop.refuse_arming(job, "too_early", role="approver")
    expect(client.job(job)["state"] == "queued" and client.job(job)["armed_by"] is None, "a refused arming left something")
    # The queue keeps its order: a time is no place.
    other = shop.add()["id"]
    expect([one["id"] for one in sorted(client.get("/jobs?state=queued")["items"], key=lambda one: (one["rank"], one["id"]))] == [job, other], "the queue")
    client.refuse(403, "POST", f"/jobs/{job}/schedule", {"not_before_ms": 1}, role="viewer")
    client.refuse(422, "POST", f"/jobs/{job}/schedule", {"not_before_ms": -1})
    client.refuse(422, "POST", "/jobs", {"release": shop.releases["lathe"], "not_before_ms": "soon"})
    soon = now_ms() + 1200
    expect(client.must("POST", f"/jobs/{job}/schedule", {"not_before_ms": soon}, role="operator")["not_before_ms"] == soon, "the new time")
    shop.controls["lathe"].say(DC1)  # the control asks meanwhile, and gets nothing
    shop.controls["lathe"].wait_quiet()
    time.sleep(max(0, soon - now_ms()) / 1000 + 0.6)
    expect(client.job(job)["state"] == "queued", "it armed itself when its time came")
    expect(shop.controls["lathe"].text() == b"", "bytes left")
    shop.arm(job)
    client.refuse(409, "POST", f"/jobs/{job}/schedule", {"not_before_ms": None})
    client.post(f"/jobs/{job}/cancel")
    client.must("POST", f"/jobs/{other}/schedule", {"not_before_ms": now_ms() + HOUR_MS})
    expect(shop.arm(other, role="approver", early_reason="the customer waits")["state"] == "armed", "with a reason")
    expect(shop.audited(other)[:2] == ["job.move", "job.arm-early"] and "the customer waits" in client.get(f"/audit?subject=job/{other}")["items"][1]["detail"], "the audit")
    client.post(f"/jobs/{other}/cancel")
    free = shop.add(not_before_ms=now_ms() + HOUR_MS)["id"]
    expect(client.must("POST", f"/jobs/{free}/schedule", {})["not_before_ms"] is None, "at any time")
    shop.feed(free)
    shop.close()


def on_hold_and_again(folder):
    """A queued job on hold is armed by no one; what ended is queued again for the same order, and says of which job."""
    shop = Shop(folder, "lathe")
    client = shop.client
    order = client.post("/orders", {"number": "A-1", "part": "R-1", "quantity": 5})["id"]
    job = shop.add(order=order, end_check="part taken out")["id"]
    client.refuse(422, "POST", f"/jobs/{job}/hold", {}, words=["reason"])
    client.refuse(409, "POST", f"/jobs/{job}/end-hold", words=["not on hold"])
    held = client.must("POST", f"/jobs/{job}/hold", {"reason": "no material"}, role="operator")
    expect(held["state"] == "queued" and held["on_hold"] == {"by": "the operator", "reason": "no material"}, f"{held}")
    shop.refuse_arming(job, "on_hold", words=["the operator: no material"])
    shop.refuse_arming(job, "on_hold", role="admin", early_reason="now")
    shop.controls["lathe"].say(DC1)  # the control asks meanwhile, and gets nothing
    shop.controls["lathe"].wait_quiet()
    expect(shop.controls["lathe"].text() == b"" and client.job(job)["state"] == "queued", "what is on hold was sent")
    client.refuse(409, "POST", f"/jobs/{job}/retry", words=["has not ended"])
    expect(client.must("POST", f"/jobs/{job}/end-hold", role="operator")["on_hold"] is None, "it is on hold")
    shop.feed(job)
    client.post(f"/jobs/{job}/confirm-end")
    client.refuse(409, "POST", f"/jobs/{job}/hold", {"reason": "too late"})
    key = {"Idempotency-Key": "again"}
    again, same = (client.must("POST", f"/jobs/{job}/retry", role="operator", headers=key) for _ in range(2))
    expect(again == same and again["state"] == "queued" and again["armed_by"] is None, f"{again} {same}")
    expect([again[name] for name in ("retry_of", "release", "order", "end_check")] == [job, shop.releases["lathe"], order, "part taken out"], f"{again}")
    shop.feed(again["id"])
    client.post(f"/orders/{order}/move", {"to": "cancelled", "reason": "not wanted"})
    client.refuse(409, "POST", f"/jobs/{again['id']}/retry", words=["order"])
    shop.close()


def of_a_choice_one_is_armed(folder):
    shop = Shop(folder, "lathe", "second", "third", released=["lathe", "second"])
    client = shop.client
    client.must("PUT", "/groups/lathes", {"machines": ["lathe", "second", "third"]})
    client.must("PUT", "/groups/empty", {"machines": []})
    order = client.post("/orders", {"number": "A-1", "part": "R-1", "quantity": 5})["id"]
    body = {"program": shop.program, "order": order, "end_check": "part taken out"}
    client.refuse(403, "POST", "/groups/lathes/jobs", body, role="viewer")
    client.refuse(404, "POST", "/groups/none/jobs", body)
    client.refuse(404, "POST", "/groups/lathes/jobs", body | {"program": 999})
    refused = client.refuse(409, "POST", "/groups/lathes/jobs", body | {"delivery": "memory"})
    expect(refused["code"] == "no_machine_of_group" and len(refused["errors"]) == 3, f"{refused}")
    client.refuse(409, "POST", "/groups/empty/jobs", body)
    expect(client.get("/jobs")["items"] == [], "a refused choice left jobs")
    key = {"Idempotency-Key": "one"}
    made = client.must("POST", "/groups/lathes/jobs", body, role="operator", headers=key)
    again = client.must("POST", "/groups/lathes/jobs", body, role="operator", headers=key)
    expect(made == again and len(client.get("/jobs")["items"]) == 2, "the same request twice is two choices")
    first, second = made["jobs"]
    expect([job["machine"] for job in made["jobs"]] == ["lathe", "second"] and {job["choice"] for job in made["jobs"]} == {made["choice"]} == {first["id"]}, f"{made}")
    expect([one["machine"] for one in made["left_out"]] == ["third"] and "never checked" in made["left_out"][0]["why"] or "no release" in made["left_out"][0]["why"], f"{made['left_out']}")
    expect(client.get(f"/orders/{order}")["waiting"] == 1, "it counts once against the order")
    alone = shop.add("second", order=order)["id"]
    expect(client.get(f"/orders/{order}")["waiting"] == 2, "a job that stands alone counts")
    listed = client.get(f"/jobs?choice={made['choice']}")["items"]
    expect([one["id"] for one in listed] == [second["id"], first["id"]], f"{listed}")
    # A line that is down takes nothing, and the choice stays.
    shop.controls["lathe"].cut()
    shop.controls["lathe"].listener.close()
    client.wait_line("lathe", "disconnected")
    client.refuse(409, "POST", f"/jobs/{first['id']}/arm", {})
    expect(client.job(second["id"])["state"] == "queued" and client.job(first["id"])["state"] == "queued", "a refused arming withdrew the others")
    shop.arm(second["id"])
    gone = client.job(first["id"])
    expect(gone["state"] == "cancelled" and gone["reason_id"] == "withdrawn" and gone["reason_said"]["id"] == "withdrawn", f"{gone}")
    expect(f"job {second['id']} of the same choice was armed on second" in gone["reason"], f"{gone}")
    expect(shop.audited(first["id"])[0] == "job.move" and client.job(alone)["state"] == "queued", "the audit, and who stands alone")
    shop.controls["second"].say(DC1)
    client.wait_job(second["id"], "done")
    expect(client.get(f"/orders/{order}")["transfers"] == 1 and client.get(f"/orders/{order}")["waiting"] == 1, "one transfer of one choice")
    shop.close()


def to_cancel_one_leaves_the_others(folder):
    shop = Shop(folder, "lathe", "second")
    client = shop.client
    client.must("PUT", "/groups/lathes", {"machines": ["lathe", "second"]})
    made = client.must("POST", "/groups/lathes/jobs", {"program": shop.program})
    first, second = (job["id"] for job in made["jobs"])
    client.post(f"/jobs/{first}/cancel")
    expect(client.job(second)["state"] == "queued", "the other left, too")
    shop.feed(second, "second")
    # An order for one machine takes no others in.
    order = client.post("/orders", {"number": "A-1", "part": "R-1", "quantity": 5, "machine": "lathe"})["id"]
    only = client.must("POST", "/groups/lathes/jobs", {"program": shop.program, "order": order})
    expect([job["machine"] for job in only["jobs"]] == ["lathe"] and [one["machine"] for one in only["left_out"]] == ["second"], f"{only}")
    # A role on one machine queues there alone.
    client.refuse(409, "PUT", "/groups/own", {"machines": ["second"]}, words=["second is in group lathes"])
    client.must("PUT", "/groups/lathes", {"machines": ["lathe"]})
    client.must("PUT", "/groups/own", {"machines": ["second"]})
    client.post("/users", {"name": "olga", "role": "viewer", "grants": [{"group": "own", "role": "operator"}]})
    client.tokens["olga"] = client.post("/tokens", {"name": "olga's", "role": "operator", "user": "olga"})["token"]
    client.refuse(403, "POST", "/groups/lathes/jobs", {"program": shop.program}, role="olga")
    expect([job["machine"] for job in client.must("POST", "/groups/own/jobs", {"program": shop.program}, role="olga")["jobs"]] == ["second"], "her own machine")
    shop.close()


def an_end_is_confirmed_before_the_next_job(folder):
    shop = Shop(folder, "lathe", "second", end_check="chuck closed, door shut")
    client = shop.client
    expect(client.get("/machines/lathe")["profile"]["end_check"] == "chuck closed, door shut", "the profile")
    own, usual, next_job = shop.add(end_check="part taken out")["id"], shop.add()["id"], shop.add()["id"]
    expect(client.job(own)["end_check"] == "part taken out" and client.job(usual)["end_check"] == "chuck closed, door shut", "what is asked for")
    client.refuse(422, "POST", "/jobs", {"release": shop.releases["lathe"], "end_check": "x" * 201})
    client.post("/checks", {"program": shop.program, "machine": "lathe", "delivery": "memory"})
    client.post(f"/checks/{client.get('/checks')['items'][0]['id']}/waivers", {"reason": "a text of a test"})
    load = client.post("/releases", {"program": shop.program, "machine": "lathe", "delivery": "memory"})["id"]
    for step in ({"to": "in_review"}, {"to": "proving", "transfers": 9}):
        client.post(f"/releases/{load}/transitions", step)
    loads = [client.must("POST", "/jobs", {"release": load} | more) for more in ({}, {"end_check": "number noted"})]
    expect([job["end_check"] for job in loads] == [None, "number noted"], "a load makes no part")
    client.refuse(409, "POST", f"/jobs/{own}/confirm-end", {}, words=["no confirmation"])
    shop.arm(own)
    client.post(f"/jobs/{own}/cancel")
    expect(not client.job(own)["needs_end_confirmation"], "nothing of it was sent")
    shop.feed(usual)
    expect(client.job(usual)["needs_end_confirmation"], "its end waits")
    refused = shop.refuse_arming(next_job, "end_not_confirmed", words=[f"job {usual} on lathe", "chuck closed, door shut"])
    expect(refused["said"]["id"] == "store_end_not_confirmed", f"{refused}")
    shop.refuse_arming(next_job, "end_not_confirmed", role="admin")
    shop.feed(shop.add("second")["id"], "second")  # another machine is not concerned
    client.restart()
    client.wait_line("lathe", "idle")
    shop.refuse_arming(next_job, "end_not_confirmed")
    client.refuse(403, "POST", f"/jobs/{usual}/confirm-end", {}, role="viewer")
    done = client.must("POST", f"/jobs/{usual}/confirm-end", {"note": "on the table"}, role="operator")
    expect(not done["needs_end_confirmation"] and done["end_confirmed_by"] == "the operator" and done["end_note"] == "on the table" and done["end_confirmed_at_ms"], f"{done}")
    client.refuse(409, "POST", f"/jobs/{usual}/confirm-end")
    expect(shop.audited(usual)[0] == "job.confirm-end" and client.job(next_job)["state"] == "queued", "the audit; and nothing began")
    shop.feed(next_job)
    shop.close()


if __name__ == "__main__":
    for test in (no_job_is_armed_before_its_time, on_hold_and_again, of_a_choice_one_is_armed, to_cancel_one_leaves_the_others, an_end_is_confirmed_before_the_next_job):
        in_folder(test)
    sys.exit(0)
