"""Why transfers stood still: a reason of the shop's list for a job of which something was sent, kept in the audit, counted by machine and reason."""

from client import DC1, Client, HandControl, expect, hand_profile, in_folder, shop


def fed_job(client, control, release):
    job = client.queue(release)
    client.wait_line("lathe", "idle")
    client.post(f"/jobs/{job}/arm")
    control.say(DC1)
    shop.wait_for("bytes", lambda: len(control.text()) > 200)
    return job


def run(folder, arguments=(), offered=None):
    control = HandControl()
    client = Client(folder, *arguments).start()
    client.post("/machines", hand_profile(control))
    release = client.release(client.add_program(300)["id"])["id"]
    known = client.get("/stop-reasons")
    expect(known["counts"] == [] and (offered is None or known["offered"] == offered), f"{known}")
    first, other = known["offered"][:2]

    queued = client.queue(release)
    client.refuse(409, "POST", f"/jobs/{queued}/stop-reasons", {"reason": first}, words=["nothing of job", "was ever sent"])
    client.post(f"/jobs/{queued}/cancel")
    job = fed_job(client, control, release)
    client.post(f"/jobs/{job}/stop")
    client.wait_job(job, "held")
    before = client.job(job)
    client.refuse(403, "POST", f"/jobs/{job}/stop-reasons", {"reason": first}, role="viewer")
    client.refuse(422, "POST", f"/jobs/{job}/stop-reasons", {"reason": "no such"}, words=["no such", first])
    client.refuse(422, "POST", f"/jobs/{job}/stop-reasons", {})
    client.refuse(422, "POST", f"/jobs/{job}/stop-reasons", {"reason": first, "note": "two\nlines"})
    client.refuse(422, "POST", f"/jobs/{job}/stop-reasons", {"reason": first, "note": "x" * 501})
    client.refuse(404, "POST", "/jobs/99999/stop-reasons", {"reason": first})
    client.refuse(404, "GET", "/jobs/99999/stop-reasons")
    key = {"Idempotency-Key": "of the first"}
    made = client.must("POST", f"/jobs/{job}/stop-reasons", {"reason": first, "note": "insert: T3, second edge"}, role="operator", headers=key)
    again = client.must("POST", f"/jobs/{job}/stop-reasons", {"reason": first, "note": "insert: T3, second edge"}, role="operator", headers=key)
    expect(again == made and made["note"] == "insert: T3, second edge" and made["by"] == "the operator", f"{made} {again}")
    client.must("POST", f"/jobs/{job}/stop-reasons", {"reason": other}, role="operator")
    now = client.job(job)
    expect({**now, "revision": 0} == {**before, "revision": 0}, f"stating a reason changes the job: {before} {now}")
    expect([one["reason"] for one in client.get(f"/jobs/{job}/stop-reasons")["reasons"]] == [other, first], "both, the newest first")
    client.must("POST", f"/jobs/{job}/stop-reasons", {"reason": other}, role="operator")
    counts = client.get("/stop-reasons")["counts"]
    expect(counts == [{"machine": "lathe", "reason": other, "count": 2}, {"machine": "lathe", "reason": first, "count": 1}], f"{counts}")
    expect(client.get("/stop-reasons?machine=other")["counts"] == [], "of another machine")
    expect(client.get(f"/stop-reasons?to_ms={made['at_ms']}")["counts"] == [], "before the first")
    expect(client.get(f"/stop-reasons?from_ms={made['at_ms']}")["counts"] == counts, "from the first on")
    client.refuse(422, "GET", "/stop-reasons?from_ms=x")
    client.post(f"/jobs/{job}/cancel")
    client.restart()
    expect(client.get("/stop-reasons")["counts"] == counts, "they outlive a restart")
    client.server.stop()


def a_shops_own_list(folder):
    run(folder, ("--stop-reason", "no bar stock", "--stop-reason", "chip nest"), ["no bar stock", "chip nest"])


def the_usual_list(folder):
    run(folder)


if __name__ == "__main__":
    for test in (the_usual_list, a_shops_own_list):
        in_folder(test)
