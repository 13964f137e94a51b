"""Sums of the past: by machine, part, day and shift each figure equals the sum over the listed jobs, which this test adds up by itself; the CSV has the
same figures; filters and wrong words."""

import csv
import datetime
import io
import sys
import time
import zoneinfo

from client import DC1, DC3, Client, HandControl, expect, hand_profile, in_folder

ZONE = zoneinfo.ZoneInfo("Europe/Berlin")
SHIFTS = ["06:00", "14:30", "22:00"]
COUNTS = ["jobs", "done", "failed", "cancelled", "interrupted", "bytes", "fed", "held_jobs", "holds_jobs", "holds", "line_jobs", "forecast_jobs"]
TIMES = ["feeding_s", "held_s", "line_s", "line_free_s", "forecast_s", "forecast_took_s"]


def ms(seconds):
    return round(seconds * 1000)


def sums(jobs):
    """As docs/integrating.md has them, in ms."""
    fed = [job for job in jobs if job["started_at_ms"] is not None]
    took = lambda job: job["ended_at_ms"] - job["started_at_ms"]
    held = [job for job in fed if job["held_s"] is not None]
    counted = [job for job in fed if job["holds"] is not None]
    timed = [job for job in held if job["line_s"] is not None]
    expected = [job for job in fed if job["state"] == "done" and job["forecast_s"] is not None]
    found = {"jobs": len(jobs), **{state: sum(job["state"] == state for job in jobs) for state in ("done", "failed", "cancelled", "interrupted")}}
    found |= {"bytes": sum(job["bytes"] for job in jobs if job["state"] == "done"), "fed": len(fed), "held_jobs": len(held), "holds_jobs": len(counted),
              "holds": sum(job["holds"] for job in counted), "line_jobs": len(timed), "forecast_jobs": len(expected)}
    found |= {"feeding_s": sum(map(took, fed)), "held_s": sum(ms(job["held_s"]) for job in held), "line_s": sum(ms(job["line_s"]) for job in timed),
              "line_free_s": sum(max(0, took(job) - ms(job["held_s"])) for job in timed), "forecast_s": sum(ms(job["forecast_s"]) for job in expected),
              "forecast_took_s": sum(map(took, expected))}
    return found


def in_ms(row):
    return {name: ms(float(row[name])) if name in TIMES else int(row[name]) for name in COUNTS + TIMES}


def local(at_ms):
    return datetime.datetime.fromtimestamp(at_ms / 1000, ZONE)


def shift_of(at_ms):
    at = local(at_ms)
    begun = [begin for begin in SHIFTS if begin <= f"{at:%H:%M}"]
    day = at.date() if begun else at.date() - datetime.timedelta(days=1)
    return f"{day} {(begun or SHIFTS)[-1]}"


def parts(client):
    """The part of a job: of its order, or that its program was rendered from."""
    orders = {order["id"]: order["part"] for order in client.everything_of("/orders")}
    rendered = {}

    def part(job):
        if job["order"] is not None:
            return orders[job["order"]]
        if job["program"] not in rendered:
            rendered[job["program"]] = client.get(f"/programs/{job['program']}")["origin"].get("part") or ""
        return rendered[job["program"]]
    return part


class Shop(Client):
    def everything_of(self, path):
        rows, after = [], ""
        while True:
            page = self.get(f"{path}?limit=2{after}")
            rows += page["items"]
            if page["next"] is None:
                return rows
            after = f"&after={page['next']}"


def feed(client, control, release, machine="lathe", order=None, end="done", hold=False):
    job = client.must("POST", "/jobs", {"release": release} | ({"order": order} if order else {}))["id"]
    client.wait_line(machine, "idle")
    client.post(f"/jobs/{job}/arm")
    control.say(DC1)
    client.wait_job(job, "feeding", "draining", "done")
    if hold:
        control.say(DC3)
        client.wait_job(job, "held")
        time.sleep(0.3)
        if end == "cancelled":
            client.post(f"/jobs/{job}/cancel")
        control.say(DC1)  # the rest, or the rest of the block
    client.wait_job(job, end)


def work(client, controls):
    for name, control in controls.items():
        client.post("/machines", hand_profile(control, name) | {"name": name})
    order = client.post("/orders", {"number": "A-1", "part": "=R,1", "quantity": 5})["id"]
    program = client.add_program(400)["id"]
    releases = {name: client.release(program, name)["id"] for name in controls}
    feed(client, controls["lathe"], releases["lathe"], order=order)
    feed(client, controls["lathe"], releases["lathe"], hold=True)
    feed(client, controls["second"], releases["second"], "second", order=order, hold=True, end="cancelled")
    waiting = client.queue(releases["second"])
    client.post(f"/jobs/{waiting}/cancel")
    client.queue(releases["lathe"])  # is over at no time


def as_csv(client, query):
    answer = client.call("GET", f"/history/sums?{query}", headers={"Accept": "text/csv"})
    expect(answer.headers["Content-Type"] == "text/csv; charset=utf-8" and answer.headers["Vary"] == "Accept", f"{answer.headers}")
    text = answer.body.decode("utf-8-sig")
    expect(text.count("\n") == text.count("\r\n") > 1, "the ends of the lines")
    return list(csv.DictReader(io.StringIO(text, newline="")))


def check(client, by, key, jobs, query=""):
    found = client.get(f"/history/sums?by={by}{query}")
    expect(found["by"] == by and in_ms(found["all"]) == sums(jobs), f"by {by}{query}: {found['all']}\n{sums(jobs)}")
    groups = {}
    for job in jobs:
        groups.setdefault(key(job), []).append(job)
    expect({group["name"]: in_ms(group) for group in found["groups"]} == {name: sums(some) for name, some in groups.items()}, f"{by}: {found['groups']}\n{groups}")
    for group in found["groups"]:
        use = group["line_use"]
        expect((use is None) == (group["line_free_s"] == 0) and (use is None or use == ms(group["line_s"]) / ms(group["line_free_s"])), f"{group}")
    rows = as_csv(client, f"by={by}{query}")
    quoted = lambda name: "'" + name if name[:1] in tuple("=+-@") else name
    expect([row[by] for row in rows] == [quoted(group["name"]) for group in found["groups"]] + ["all"], f"{rows}")
    expect([in_ms(row) for row in rows] == [in_ms(group) for group in found["groups"] + [found["all"]]], f"{rows}")
    return found


def sums_are_those_of_the_rows(folder):
    import os
    os.environ["TZ"] = "Europe/Berlin"
    controls = {"lathe": HandControl(), "second": HandControl()}
    client = Shop(folder, *[word for begin in SHIFTS for word in ("--shift", begin)]).start()
    work(client, controls)
    jobs = [job for job in client.everything_of("/jobs") if job["ended_at_ms"] is not None]
    expect(len(jobs) == 4 and sum(job["held_s"] is not None and job["held_s"] > 0.2 for job in jobs) == 2, f"{jobs}")
    expect(any(job["forecast_s"] for job in jobs if job["state"] == "done"), f"no forecast: {jobs}")
    check(client, "machine", lambda job: job["machine"], jobs)
    check(client, "part", parts(client), jobs)
    check(client, "day", lambda job: f"{local(job['ended_at_ms']):%Y-%m-%d}", jobs)
    shifts = check(client, "shift", lambda job: shift_of(job["ended_at_ms"]), jobs)["groups"]
    expect(all(shift["from_ms"] <= job["ended_at_ms"] < shift["to_ms"] for shift in shifts[:1] for job in jobs if shift_of(job["ended_at_ms"]) == shift["name"]), f"{shifts}")
    ends = sorted(job["ended_at_ms"] for job in jobs)
    some = [job for job in jobs if ends[1] <= job["ended_at_ms"] < ends[3]]
    check(client, "machine", lambda job: job["machine"], some, f"&from_ms={ends[1]}&to_ms={ends[3]}")
    check(client, "part", parts(client), [job for job in jobs if job["machine"] == "second" and job["state"] == "cancelled"], "&machine=second&state=cancelled")
    check(client, "day", None, [], "&machine=none")
    client.refuse(422, "GET", "/history/sums?by=hour", words=["hour"])
    client.refuse(422, "GET", "/history/sums?state=queued", words=["queued"])
    client.refuse(422, "GET", "/history/sums?from_ms=x")
    client.server.stop()
    for control in controls.values():
        control.close()


if __name__ == "__main__":
    sys.exit(in_folder(sums_are_those_of_the_rows))
