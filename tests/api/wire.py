"""What passes on a line, as people see it: the stream of a machine's wire; and the test of a line with a loopback plug in the control's place. The
control is played by hand: as a control that holds its tongue, and as a plug that gives back what comes."""

import sys
import threading
import time

from client import DC1, DC3, Client, HandControl, expect, hand_profile, in_folder, shop
from live import Watch

HARMLESS = {0x00, 0x7F}  # what every control skips


def plug():
    control = HandControl()
    control.is_bridged = True
    return control


def bench(folder, control, **link):
    client = Client(folder).start()
    profile = hand_profile(control)
    profile["link"].update(link)
    client.post("/machines", profile)
    client.wait_line("lathe", "idle")
    return client


def line_test(client):
    """It is refused where another thread of the server has the line for longer than the server waits: then it is asked again."""
    def tested():
        answer = client.call("POST", "/machines/lathe/line-test", role="operator")
        return None if answer.status == 409 and "is in use" in answer.document["detail"] else answer
    answer = shop.wait_for("the line to be free", tested)
    expect(answer.status == 200, f"{answer}")
    return answer.document


def runs_until(watch, enough):
    """The runs of a wire until there are enough of them."""
    runs = []
    while not enough(runs):
        event = watch.next()
        if event:
            runs += event["data"]["runs"]
    return runs


def text_of(runs, kind):
    return "".join(run["text"] for run in runs if run["kind"] == kind)


def the_wire_shows_what_passes(folder):
    control = HandControl()
    client = bench(folder, control)
    job = client.queue(client.release(client.add_program(40)["id"])["id"])
    control.say(DC3 * 7)  # before a person looks
    time.sleep(0.5)
    watch = Watch(client, path="/machines/lathe/wire")
    control.say(DC3)
    runs = runs_until(watch, lambda seen: seen)
    expect([(run["kind"], run["text"], run["hex"]) for run in runs] == [("in", "\u2413", "13")], f"{runs}")
    before = int(time.time() * 1000)
    client.post(f"/jobs/{job}/arm")
    control.say(DC1)
    runs = runs_until(watch, lambda seen: "M30" in text_of(seen, "out"))
    expect(runs[0]["text"] == "\u2411" and runs[0]["kind"] == "in", f"the control's start comes first: {runs[:2]}")
    sent = text_of(runs, "out")
    expect(sent.startswith("%\u240a") and sent.count("\u240a") > 40, f"block by block: {sent[:60]}")
    wire = bytes.fromhex("".join(run["hex"] for run in runs if run["kind"] == "out"))
    control.wait_bytes(len(wire))
    with control.lock:
        expect(wire == bytes(control.got)[: len(wire)], f"the same bytes as at the control: {wire[:40]} and {bytes(control.got)[:40]}")
    expect(all(before - 1000 <= run["at_ms"] <= run["to_ms"] <= time.time() * 1000 + 1000 for run in runs), "at the time when they passed")
    client.wait_job(job, "done")
    control.cut()
    runs_until(watch, lambda seen: any(run["kind"] == "lost" for run in seen))
    watch.close()
    client.refuse(404, "GET", "/machines/nobody/wire")
    client.server.stop()


def parity_is_seen(folder):
    control = HandControl()
    client = bench(folder, control, framing="7E2", baud=9600)
    watch = Watch(client, path="/machines/lathe/wire")
    control.say(b"\x93A\xC2")  # DC3 with parity; A (two holes); B with a wrong bit
    runs = runs_until(watch, lambda seen: len(text_of(seen, "in")) >= 3)
    expect(text_of(runs, "in") == "\u2413AB" and sum(run["wrong"] for run in runs) == 1, f"{runs}")
    watch.close()
    client.server.stop()


def a_bridged_line_is_measured(folder):
    control = plug()
    client = bench(folder, control)
    tested = line_test(client)
    result = tested["result"]
    expect(tested["fault"] is None and result["wrong"] == 0 and result["after_dc3"]["holds"] == 20, f"{tested}")
    expect(result["characters"] >= 6 + 20 + 20 * 20, f"proof, round trips, streams: {result}")
    expect(abs(result["char_ms"] - 10 / 19.2) < 0.02, f"a character of 8N1 at 19200: {result}")
    expect(not control.text().count(b"\n") and b"%" not in control.text(), "no end of a block was sent")
    client.wait_line("lathe", "idle")
    noted = client.get("/audit?action=machine.line-test")["items"]
    expect(len(noted) == 1 and noted[0]["actor"] == "the operator", f"{noted}")
    # The line is as it was: a job goes over it.
    control.is_bridged = False
    job = client.queue(client.release(client.add_program(20)["id"])["id"])
    client.post(f"/jobs/{job}/arm")
    control.say(DC1)
    client.wait_job(job, "done")
    client.server.stop()


def a_control_gets_nothing_that_it_runs(folder):
    control = HandControl()
    client = bench(folder, control)
    calls = control.calls
    tested = line_test(client)
    expect(tested["result"] is None and tested["fault_id"] == "nothing_came", f"{tested}")
    client.wait_line("lathe", "idle")
    control.wait_called(calls + 2)  # the test and the line after it each have their own connection
    # One that answers by itself ends the test at once.
    threading.Thread(target=lambda: (control.wait_called(calls + 3), control.say(b"O")), daemon=True).start()
    tested = line_test(client)
    expect(tested["fault_id"] == "other_came", f"{tested}")
    with control.lock:
        expect(set(control.got) <= HARMLESS, f"what went to the control: {bytes(control.got)}")
    client.server.stop()


def no_test_during_anything_else(folder):
    control = HandControl()
    client = bench(folder, control)
    release = client.release(client.add_program(600)["id"])["id"]
    control.say(DC1)
    shop.wait_for("the control to ask", lambda: client.get("/machines/lathe")["status"]["asks_since_ms"])
    client.refuse(409, "POST", "/machines/lathe/line-test", role="operator", words=["asks for a program"])
    job = client.queue(release)
    client.post(f"/jobs/{job}/arm")
    client.refuse(409, "POST", "/machines/lathe/line-test", role="operator")
    expect(client.job(job)["state"] == "armed", "and what is armed stays armed")
    control.say(DC1)
    client.wait_job(job, "feeding")
    client.refuse(409, "POST", "/machines/lathe/line-test", role="operator", words=["in use"])
    expect(client.job(job)["state"] == "feeding", "a refused test disturbs nothing")
    control.hold_inside_block()
    control.cut()
    client.wait_job(job, "failed")
    client.refuse(409, "POST", "/machines/lathe/line-test", role="operator", words=["confirm"])
    client.refuse(404, "POST", "/machines/nobody/line-test", role="operator")
    client.server.stop()


def nothing_is_armed_meanwhile(folder):
    control = plug()
    client = bench(folder, control, baud=1200)
    job = client.queue(client.release(client.add_program(20)["id"])["id"])
    results = []
    test = threading.Thread(target=lambda: results.append(line_test(client)))
    test.start()
    shop.wait_for("the line to be taken out", lambda: "tested" in (client.get("/machines/lathe")["status"]["link_error"] or ""))
    client.refuse(409, "POST", f"/jobs/{job}/arm", {})
    machine = client.get("/machines/lathe")
    profile = machine["profile"]
    profile["link"]["baud"] = 2400
    client.refuse(409, "PUT", "/machines/lathe", profile, headers={"If-Match": f'"{machine["revision"]}"'}, words=["tested"])
    client.refuse(409, "POST", "/machines/lathe/line-test", role="operator", words=["tested"])
    test.join()
    expect(results and results[0]["result"], f"{results}")
    client.wait_line("lathe", "idle")
    client.post(f"/jobs/{job}/arm")
    client.server.stop()


if __name__ == "__main__":
    for test in (the_wire_shows_what_passes, parity_is_seen, a_bridged_line_is_measured, a_control_gets_nothing_that_it_runs,
                 no_test_during_anything_else, nothing_is_armed_meanwhile):
        in_folder(test)
    sys.exit(0)
