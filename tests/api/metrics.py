"""GET /metrics against a line that the test plays by hand: what is scraped is what happened, in a text that others read, too."""

import os
import pathlib
import sys
import time

from client import DC1, DC3, Client, HandControl, expect, hand_profile, in_folder, plain_program, shop
from exposition import Scrape, look_with_others
from live import Watch


def scrape(client, role="viewer"):
    answer = client.call("GET", "/metrics", role=role)
    expect(answer.status == 200, f"{answer}")
    expect(answer.headers["Content-Type"] == "text/plain; version=0.0.4; charset=utf-8", answer.headers["Content-Type"])
    text = answer.body.decode()
    look_with_others(text)
    return Scrape(text)


def wait_scrape(client, what, reached):
    def look():
        now = scrape(client)
        return now if reached(now) else None
    return shop.wait_for(what, look)


def bench(folder):
    control = HandControl()
    client = Client(folder).start()
    client.post("/machines", hand_profile(control))
    client.wait_line("lathe", "idle")
    return client, control


def state_of(seen, machine="lathe"):
    on = [labels["state"] for labels in seen.labels("dripfeed_line_state", machine=machine) if seen.value("dripfeed_line_state", **labels) == 1]
    expect(len(on) == 1, f"{machine} is in the states {on}")
    return on[0]


def a_line(folder):
    client, control = bench(folder)
    before = wait_scrape(client, "the line", lambda seen: seen.labels("dripfeed_line_state") and state_of(seen) == "idle")
    of = {"machine": "lathe"}
    expect(len(before.labels("dripfeed_line_state")) == 9, "a line has nine states")
    expect(before.value("dripfeed_line_link_up", **of) == 1, "the link is up")
    for name in ("sent_bytes", "sent_blocks", "holds", "hold_seconds", "unarmed_starts", "receptions"):
        expect(before.value(f"dripfeed_line_{name}_total", **of) == 0, f"{name} before anything was sent")
    for name in ("confirmed_bytes_total", "job_info", "job_sent_bytes", "last_sent_timestamp_seconds", "stall", "use_ratio"):
        expect(not before.labels(f"dripfeed_line_{name}"), f"{name} is claimed before there is any")
    release = client.release(client.add_program(150)["id"])["id"]
    jobs = [client.queue(release) for _ in range(2)]
    client.post(f"/jobs/{jobs[0]}/arm")
    armed = wait_scrape(client, "the arming", lambda seen: state_of(seen) == "armed")
    expect(armed.labels("dripfeed_line_stall") == [of | {"stall": "waiting for DC1"}], f"{armed.labels('dripfeed_line_stall')}")
    begun = time.time()
    control.say(DC1)
    control.wait_bytes(300)
    control.say(DC3)
    sent = len(control.wait_quiet())
    held = wait_scrape(client, "the hold", lambda seen: seen.value("dripfeed_line_holds_total", **of) == 1 and seen.value("dripfeed_line_sent_bytes_total", **of) == sent)
    expect(state_of(held) == "held" and held.labels("dripfeed_line_stall") == [of | {"stall": "held by DC3"}], "it is held by DC3")
    expect(held.labels("dripfeed_line_job_info") == [of | {"job": str(jobs[0])}], f"{held.labels('dripfeed_line_job_info')}")
    text = control.text()
    expect(held.value("dripfeed_line_job_sent_bytes", **of) == sent == held.value("dripfeed_line_sent_bytes_total", **of), f"{sent} bytes were sent")
    lines = text.count(b"\n")
    expect((held.value("dripfeed_line_job_block", **of), held.value("dripfeed_line_sent_blocks_total", **of)) == (lines + 1, lines), f"{lines} blocks were sent whole")
    expect(held.value("dripfeed_line_job_size_bytes", **of) == len(plain_program(150)), "the job's size")
    expect(begun - 1 < held.value("dripfeed_line_last_sent_timestamp_seconds", **of) < time.time() + 1, "when a byte left last")
    expect(held.value("dripfeed_line_stalls_total", machine="lathe", stall="held by DC3") == 1, "one stall by DC3")
    control.say(DC1)
    client.wait_job(jobs[0], "done")
    first = scrape(client)
    expect(first.value("dripfeed_line_hold_seconds_total", **of) > 0.1, "it was held for a time")
    expect(first.value("dripfeed_line_sent_bytes_total", **of) == len(plain_program(150)), "all of one job")
    expect(not first.labels("dripfeed_line_job_info") and not first.labels("dripfeed_line_job_sent_bytes"), "the job is over")
    client.post(f"/jobs/{jobs[1]}/arm")
    control.say(DC1)
    client.wait_job(jobs[1], "done")
    second = scrape(client)
    expect(second.value("dripfeed_line_sent_bytes_total", **of) == 2 * len(plain_program(150)), "both jobs")
    expect(second.value("dripfeed_line_sent_blocks_total", **of) == 2 * plain_program(150).count("\n"), f"blocks of both jobs: {second.value('dripfeed_line_sent_blocks_total', **of)}")
    expect(second.value("dripfeed_line_holds_total", **of) == 1, "the second was not held")
    grown(before, armed, held, first, second)
    control.say(DC1)  # nothing is armed
    wait_scrape(client, "a start that no one armed", lambda seen: seen.value("dripfeed_line_unarmed_starts_total", **of) == 1)
    control.close()
    control.cut()
    control.wait_called(1)
    wait_scrape(client, "the link's loss", lambda seen: seen.value("dripfeed_line_link_up", **of) == 0 and state_of(seen) == "disconnected")
    client.server.stop()


def grown(*scrapes):
    """No counter falls."""
    for before, after in zip(scrapes, scrapes[1:]):
        now = after.counters()
        fallen = [key for key, value in before.counters().items() if now.get(key, -1) < value]
        expect(not fallen, f"fallen, or gone: {fallen}")


def alarms(folder):
    client, control = bench(folder)
    severities = {severity: wait_scrape(client, "the line", lambda seen: seen.labels("dripfeed_line_state")).value("dripfeed_alarms_open", machine="lathe", severity=severity)
                  for severity in ("critical", "warning", "notice")}
    expect(set(severities.values()) == {0}, f"{severities}")
    control.say(b"\x12%\nO0701\nG0 X\x14")
    wait_scrape(client, "an alarm", lambda seen: seen.value("dripfeed_alarms_open", machine="lathe", severity="warning") == 1)
    expect(scrape(client).value("dripfeed_line_receptions_total", machine="lathe") == 1, "one reception")
    alarm = client.get("/alarms?state=open")["items"][0]["id"]
    client.must("POST", f"/alarms/{alarm}/acknowledge", {}, role="operator")
    expect(scrape(client).value("dripfeed_alarms_open", machine="lathe", severity="warning") == 0, "it is closed")
    client.server.stop()
    control.close()


def the_server(folder):
    client = Client(folder).start()
    expect(client.call("GET", "/metrics", role=None).status == 401, "without a token")
    first = scrape(client)
    expect(first.value("dripfeed_http_requests_total", method="GET", route="/metrics", status="4xx") == 1, "the one without a token")
    version = client.must("GET", "/healthz")["version"]
    expect(first.labels("dripfeed_build_info")[0]["version"] == version, f"{first.labels('dripfeed_build_info')}")
    for _ in range(3):
        client.call("GET", "/nowhere/at/all")
    client.call("GET", "/programs/99")
    client.post("/programs", {"name": "O1", "dialect": "fanuc", "text": plain_program(3)})
    second = scrape(client)
    requests = "dripfeed_http_requests_total"
    expect(second.value(requests, method="none", route="none", status="4xx") == 3, "three of no route")
    expect(second.value(requests, method="GET", route="/api/v1/programs/{id}", status="4xx") == 1, "one of a program that is not there")
    expect(second.value(requests, method="POST", route="/api/v1/programs", status="2xx") == 1, "one program")
    expect(second.value("dripfeed_http_request_duration_seconds_count", lane="bulk") == 1, "it went through the lane for texts")
    all_of = sum(second.value(requests, **labels) for labels in second.labels(requests))
    timed = sum(second.value("dripfeed_http_request_duration_seconds_count", **labels) for labels in second.labels("dripfeed_http_request_duration_seconds_count"))
    expect(all_of == timed, f"{all_of} requests, {timed} durations")
    for turn in ("ledger", "others"):
        expect(second.value("dripfeed_store_waiting_writes", turn=turn) == 0, "no one waits")
    expect(second.value("dripfeed_store_write_seconds_count", turn="others") > first.value("dripfeed_store_write_seconds_count", turn="others"), "the program was written")
    process = pathlib.Path(f"/proc/{client.server.process.pid}")
    resident = int((process / "statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE")
    expect(abs(second.value("process_resident_memory_bytes") - resident) < 4e6, f"{second.value('process_resident_memory_bytes')} bytes, the system says {resident}")
    expect(abs(second.value("process_open_fds") - len(list((process / "fd").iterdir()))) <= 5, f"{second.value('process_open_fds')} files")
    expect(abs(second.value("process_start_time_seconds") - time.time()) < 120, "it was started in these two minutes")
    expect(0 < second.value("process_open_fds") < second.value("process_max_fds"), "open files")
    grown(first, second)
    watches = [Watch(client) for _ in range(3)]
    expect(scrape(client).value("dripfeed_event_streams") == 3, "three watch")
    for watch in watches:
        watch.close()
    wait_scrape(client, "the end of the watchers", lambda seen: seen.value("dripfeed_event_streams") == 0)
    an_upload(client)
    client.server.stop()


def an_upload(client):
    """A long body that does not come to its end."""
    connection = client.connect()
    connection.putrequest("POST", "/api/v1/programs")
    connection.putheader("Authorization", f"Bearer {client.tokens['programmer']}")
    connection.putheader("Content-Type", "application/json")
    connection.putheader("Content-Length", str(8 << 20))
    connection.endheaders()
    connection.send(b"{" + b" " * (1 << 20))
    seen = wait_scrape(client, "the upload", lambda now: now.value("dripfeed_http_uploads") == 1)
    expect(seen.value("dripfeed_http_upload_bytes") == 8 << 20, f"{seen.value('dripfeed_http_upload_bytes')}")
    connection.close()
    wait_scrape(client, "its end", lambda now: now.value("dripfeed_http_uploads") == 0 and now.value("dripfeed_http_upload_bytes") == 0)


if __name__ == "__main__":
    for test in (the_server, a_line, alarms):
        in_folder(test)
