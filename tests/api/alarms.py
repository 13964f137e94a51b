"""Alarms against the real server: a torn block from its raise over a restart to its end, what people do about alarms, a link that is gone, and a
control that asks while nothing is armed, which is a state and no alarm."""

import json
import sys
import time

from client import DC1, Client, HandControl, binary, expect, hand_profile, in_folder, plain_program, shop
from live import Watch

STATES = {"acknowledged_by", "acknowledged_at_ms", "cleared_at_ms", "count", "id", "job", "kind", "last_at_ms", "machine", "raised_at_ms", "severity", "shelf_reason",
          "said", "shelved_by", "shelved_until_ms", "text"}


def bench(folder, blocks=150):
    control = HandControl()
    client = Client(folder).start()
    client.post("/machines", hand_profile(control))
    client.wait_line("lathe", "idle")
    return client, control


def alarms(client, query="state=open"):
    return client.get(f"/alarms?{query}")["items"]


def wait_alarm(client, kind, **members):
    def found():
        for alarm in alarms(client, "state=all"):
            if alarm["kind"] == kind and all(alarm[name] == value for name, value in members.items()):
                return alarm
        return None
    return shop.wait_for(f"an alarm {kind} with {members}", found)


def a_torn_block(folder):
    client, control = bench(folder)
    job = client.queue(client.release(client.add_program(150)["id"])["id"])
    watch = Watch(client)
    client.post(f"/jobs/{job}/arm")
    control.say(DC1)
    control.hold_inside_block()
    control.cut()
    client.wait_job(job, "failed")
    torn = wait_alarm(client, "torn_block")
    expect(set(torn) == STATES, f"{torn}")
    expect((torn["machine"], torn["job"], torn["severity"], torn["count"], torn["cleared_at_ms"], torn["acknowledged_by"]) == ("lathe", job, "critical", 1, None, None), f"{torn}")
    wait_alarm(client, "link_lost", job=job)  # at once, because a job was on it
    control.wait_called(2)
    wait_alarm(client, "link_lost", acknowledged_by=None)
    shop.wait_for("the end of the loss", lambda: wait_alarm(client, "link_lost")["cleared_at_ms"])
    seen = {}
    while "torn_block" not in seen or not seen.get("link_lost", {}).get("cleared_at_ms"):
        event = watch.next()
        if event.get("event") == "alarm":
            expect(set(event["data"]) == STATES, f"{event}")
            seen[event["data"]["kind"]] = event["data"]
    expect(seen["torn_block"] == torn, f"{seen} is not {torn}")
    watch.close()
    problem = client.refuse(409, "POST", f"/alarms/{torn['id']}/shelve", {"minutes": 5, "reason": "later"}, role="operator", words=["critical"])
    expect("shelved" in problem["detail"], f"{problem}")
    known = client.must("POST", f"/alarms/{torn['id']}/acknowledge", {}, role="operator")
    expect(known["acknowledged_by"] == "the operator" and known["acknowledged_at_ms"] and known["cleared_at_ms"] is None, f"{known}")
    client.restart()
    client.wait_line("lathe", "torn")
    time.sleep(1.5)  # the server looks at it again and again
    again = [one for one in alarms(client, "state=all") if one["kind"] == "torn_block"]
    expect(again == [known], f"after a restart there is {again}")
    client.server.kill()
    client.server.start()
    client.wait_line("lathe", "torn")
    expect([one for one in alarms(client, "state=all") if one["kind"] == "torn_block"] == [known], "after a kill it is another")
    client.must("POST", "/machines/lathe/confirm-reset", {"reason": "RESET pressed"}, role="operator")
    over = shop.wait_for("the end of the torn block", lambda: next((one for one in alarms(client, "state=all") if one["id"] == torn["id"] and one["cleared_at_ms"]), None))
    expect(over == known | {"cleared_at_ms": over["cleared_at_ms"]}, f"{over}")
    expect(torn["id"] not in [one["id"] for one in alarms(client)], "a closed alarm is listed as open")
    client.server.stop()
    control.close()


def what_people_do(folder):
    client, control = bench(folder)
    for _ in range(2):
        before = len(client.get("/receipts")["items"])
        control.say(b"\x12%\nO0701\nG0 X\x14")
        shop.wait_for("a receipt", lambda: len(client.get("/receipts")["items"]) > before)
    alarm = wait_alarm(client, "quarantined", count=2)
    expect(len(alarms(client)) == 1, f"equal ones are not one: {alarms(client)}")
    expect(alarm["cleared_at_ms"] and alarm["severity"] == "warning" and "quarantine" in alarm["text"], f"{alarm}")
    path = f"/alarms/{alarm['id']}"
    expect(client.get(path) == alarm, "one is not as it is listed")
    watch = Watch(client)
    before = int(time.time() * 1000)
    shelved = client.must("POST", f"{path}/shelve", {"minutes": 480, "reason": "the cable is ordered"}, role="operator")
    expect((shelved["shelved_by"], shelved["shelf_reason"]) == ("the operator", "the cable is ordered"), f"{shelved}")
    expect(0 <= shelved["shelved_until_ms"] - before - 480 * 60000 < 60000, f"{shelved} at {before}")
    expect(watch.numbered(1)[0]["data"] == shelved, "the event is not the alarm")
    free = client.must("POST", f"{path}/unshelve", {}, role="operator")
    expect(free == alarm and client.must("POST", f"{path}/unshelve", {}, role="operator") == alarm, f"{free}")
    key = {"Idempotency-Key": "a"}
    known = client.must("POST", f"{path}/acknowledge", {}, role="operator", headers=key)
    expect(known == client.must("POST", f"{path}/acknowledge", {}, role="operator", headers=key), "another answer under one key")
    expect(client.must("POST", f"{path}/acknowledge", {}, role="admin") == known, "acknowledged twice")
    expect([event["data"] for event in watch.numbered(2)] == [alarm, known], "the events of a person's decisions")
    watch.close()
    expect(alarms(client) == [] and alarms(client, "") == [known] == alarms(client, "state=all&machine=lathe"), "the lists")
    expect(alarms(client, "machine=nobody") == [], "an alarm of no machine")
    client.refuse(409, "POST", f"{path}/shelve", {"minutes": 1, "reason": "closed"}, words=["closed"])
    control.say(b"\x12%\nO0701\nG0 X\x14")
    other = wait_alarm(client, "quarantined", count=1)
    page = client.get("/alarms?limit=1")
    expect(page["items"] == [other] and client.get(f"/alarms?limit=1&after={page['next']}") == {"items": [known], "next": None}, f"{page}")
    client.server.stop()
    control.close()


def a_link_that_is_gone(folder):
    client, control = bench(folder)
    control.cut()  # no control was fed: it is back before a feed needs it
    control.wait_called(2)
    client.wait_line("lathe", "idle")
    time.sleep(1)
    expect(alarms(client, "") == [], f"a cable that was plugged is an alarm: {alarms(client, '')}")
    control.close()
    control.cut()
    control.wait_called(3)  # who waited for a call on the closed socket takes one more
    client.wait_line("lathe", "idle")
    control.cut()
    begun = time.monotonic()
    lost = wait_alarm(client, "link_lost")
    expect(time.monotonic() - begun > 4 and lost["cleared_at_ms"] is None and lost["job"] is None, f"{lost} after {time.monotonic() - begun:.1f} s")
    client.server.stop()


def asking_is_a_state(folder):
    """A simulated control that asks every two seconds, as the shipped one does."""
    profile = shop.preset("fanuc-0i-lathe", url=f"pty:{folder}/lathe.tty", baud=9600, framing="7E2", end_by_quiet_s=1.0)
    profile["name"] = "lathe"
    (folder / "lathe.json").write_text(json.dumps(profile))
    client = Client(folder).start()
    client.post("/machines", profile)
    before = int(time.time() * 1000)
    status = client.get("/machines/lathe")["status"]
    expect((status["asks"], status["asks_since_ms"]) == (0, None), f"{status}")
    control = shop.Control(binary(), profile["link"]["url"], folder / "lathe.json", "--operator", "0.5").start()

    def asks(at_least):
        now = client.get("/machines/lathe")["status"]
        return now if now["asks"] >= at_least else None
    status = shop.wait_for("the control to ask", lambda: asks(2))
    expect(status["line"] == "idle" and before <= status["asks_since_ms"] <= int(time.time() * 1000), f"{status}")
    watch, seen = Watch(client), None
    while not seen or seen["asks"] <= status["asks"]:
        event = watch.next()
        seen = event["data"] if event.get("event") == "progress" else seen
    expect(seen["asks_since_ms"] == status["asks_since_ms"], f"{seen} after {status}")
    watch.close()
    expect(alarms(client, "") == [], f"who asks is an alarm: {alarms(client, '')}")
    job = client.queue(client.release(client.add_program(20)["id"])["id"])
    client.post(f"/jobs/{job}/arm")
    status = shop.wait_for("a control that no longer asks", lambda: next((now for now in [client.get("/machines/lathe")["status"]] if now["asks"] == 0), None))
    expect(status["asks_since_ms"] is None, f"{status}")
    client.wait_job(job, "done")
    expect(alarms(client, "") == [], f"{alarms(client, '')}")
    control.stop()
    client.server.stop()


if __name__ == "__main__":
    for test in (a_torn_block, what_people_do, a_link_that_is_gone, asking_is_a_state):
        in_folder(test)
    sys.exit(0)
