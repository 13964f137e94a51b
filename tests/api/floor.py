"""What a shop floor looks at: the order of the jobs that wait, the lines of a program with those of its family, how a machine was used, and why a job is as
it is, as a word."""

import datetime
import sys
import time

from client import DC1, ROLL, Client, HandControl, expect, hand_profile, in_folder, plain_program, shop
from live import Watch


def bench(folder):
    control = HandControl()
    client = Client(folder).start()
    client.post("/machines", hand_profile(control))
    client.wait_line("lathe", "idle")
    return client, control


def order_of(client, machine="lathe"):
    jobs = client.get(f"/jobs?machine={machine}&state=queued&limit=200")["items"]
    return [job["id"] for job in sorted(jobs, key=lambda job: (job["rank"], job["id"]))]


def the_queue_has_an_order(folder):
    client, control = bench(folder)
    release = client.release(client.add_program(20)["id"])["id"]
    a, b, c = (client.queue(release) for _ in range(3))
    expect(order_of(client) == [a, b, c], f"{order_of(client)}")
    watch = Watch(client)
    moved = client.must("POST", f"/jobs/{c}/move", {"before": a}, role="operator")
    expect(moved == client.job(c) and order_of(client) == [c, a, b], f"{moved} {order_of(client)}")
    events = [(event["event"], event["data"]["id"], event["data"]["rank"]) for event in watch.numbered(3)]
    expect(events == [("job", c, 1), ("job", a, 2), ("job", b, 3)], f"{events}")
    watch.close()
    client.must("POST", f"/jobs/{c}/move", {"before": None}, role="operator")
    expect(order_of(client) == [a, b, c], f"{order_of(client)}")
    for wrong in (a, 99):
        client.refuse(422, "POST", f"/jobs/{a}/move", {"before": wrong}, words=[f"job {wrong}"])
    client.post(f"/jobs/{b}/arm")
    client.refuse(409, "POST", f"/jobs/{b}/move", {"before": None}, words=["queued"])
    client.refuse(422, "POST", f"/jobs/{a}/move", {"before": b})
    expect(client.job(b)["reason_id"] == "armed", f"{client.job(b)}")
    client.post(f"/jobs/{b}/cancel")
    expect(client.job(b)["reason_id"] == "cancelled", f"{client.job(b)}")
    client.restart()
    expect(order_of(client) == [a, c], "a restart lost the order")
    client.wait_line("lathe", "idle")
    client.post(f"/jobs/{a}/arm", {"minutes": 0.01})
    expired = client.wait_job(a, "queued")
    expect(expired["reason_id"] == "expired" and "expired" in expired["reason"] and expired["expires_at_ms"] is None, f"{expired}")
    expect(order_of(client) == [a, c], "who was disarmed lost its place")
    client.server.stop()
    control.close()


def lines_of_a_program(folder):
    client, control = bench(folder)
    client.post("/families", {"text": ROLL})
    rendered = client.post("/render", {"family": "hyperbolic-roll", "machine": "lathe", "mode": "explicit", "values": {"angle_step": "2 deg"}})
    program = rendered["program"]
    text = client.call("GET", f"/programs/{program}/text").body.decode().splitlines()
    family = ROLL.splitlines()
    found, start = [], 1
    while start <= len(text):
        page = client.get(f"/programs/{program}/lines?from={start}&count=7&revision=1")
        expect((page["from"], page["count_all"]) == (start, len(text)), f"{page}")
        found += page["lines"]
        start += 7
    expect([line["text"] for line in found] == text and [line["line"] for line in found] == list(range(1, len(text) + 1)), "the lines are not the text")
    with_family = [line for line in found if line["family_line"]]
    expect(len(with_family) > len(text) // 2, f"{len(with_family)} of {len(text)} lines have one of the family")
    for line in found:
        expect(set(line) == {"line", "text", "family_line", "family_text", "values"}, f"{line}")
        expect(line["family_text"] == (family[line["family_line"] - 1] if line["family_line"] else None), f"{line}")
    steps = [line["values"]["t"] for line in found if line["values"] and "t" in line["values"]]
    expect(len(set(steps)) > 10 and all(isinstance(step, (int, float)) for step in steps), f"the values of t are {steps}")
    expect(client.get(f"/programs/{program}/lines?from={len(text) + 1}")["lines"] == [], "lines after the end")
    plain = client.add_program(1000)["id"]
    page = client.get(f"/programs/{plain}/lines?from=500&count=200")
    expect([line["text"] for line in page["lines"]] == plain_program(1000).splitlines()[499:699], "the lines of an uploaded text")
    expect(all(line["family_line"] is line["family_text"] is line["values"] is None for line in page["lines"]), "something is guessed")
    client.server.stop()
    control.close()


def days_of_use(folder):
    client, control = bench(folder)
    release = client.release(client.add_program(20)["id"])["id"]
    job = client.queue(release)
    client.post(f"/jobs/{job}/arm")
    control.say(DC1)
    client.wait_job(job, "done")
    client.post(f"/jobs/{client.queue(release)}/cancel")
    days = client.get("/machines/lathe/utilisation?days=3")["days"]
    now = time.time() * 1000
    expect(len(days) == 3 and days[2]["from_ms"] <= now < days[2]["to_ms"], f"{days}")
    expect(days[2]["day"] == datetime.date.today().isoformat() and days[0]["to_ms"] == days[1]["from_ms"], f"{days}")
    done = client.job(job)
    today = days[2]
    expect(abs(today["feeding_s"] - (done["ended_at_ms"] - done["started_at_ms"]) / 1000) < 0.002 and today["held_s"] is not None, f"{today} of {done}")
    expect((today["jobs_done"], today["jobs_failed"], today["jobs_cancelled"], today["bytes"]) == (1, 0, 1, done["bytes"]), f"{today}")
    expect(days[0]["feeding_s"] == 0 and days[0]["held_s"] == 0 and days[0]["bytes"] == 0, f"{days[0]}")
    expect(len(client.get("/machines/lathe/utilisation")["days"]) == 7, "a week is the standard")
    client.server.stop()
    control.close()


if __name__ == "__main__":
    for test in (the_queue_has_an_order, lines_of_a_program, days_of_use):
        in_folder(test)
    sys.exit(0)
