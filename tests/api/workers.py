"""Checks run in processes of their own: one that crashes, hangs, takes too much or is left by its client never touches the server or a feed."""

import http.client
import json
import os
import signal
import threading
import time

from client import DC1, Client, HandControl, binary, expect, expect_problem, hand_profile, in_folder, plain_program, shop, whole

# Its budget of blocks lasts for minutes and Shop's budget of time for ten: it runs until a test ends it, on a busy machine too.
ENDLESS = "%\nO7001\n#100=0\nWHILE[#100GE0]DO1\n#1=" + "+".join(["SIN[#1]"] * 800) + "\nEND1\nM30\n%\n"
PECKS = "%\nO7002\nG0Z5.\nWHILE[1EQ1]DO1\nG83X0Y0Z-99.R0Q0.0001F100\nEND1\nM30\n%\n"
FILL = "R[10]=REP(5,3)\nR[20]=REP(7)\nM30\n"
# Each distinct text that is executed is compiled and kept; each line of it has a name of its own in the machine's data.
LARGE = "%\nO7003\n" + "".join(f"#{100 + n % 400}=[[[[{n}+#1]*2+#2]*3+#3]*4]\n" for n in range(300_000)) + "M30\n%\n"


def wait_for(what, condition):
    """Workers run at nice 19: while other tests run, starting and ending them takes time."""
    return shop.wait_for(what, condition, seconds=60)


class Shop(Client):
    def __init__(self, folder, *arguments):
        super().__init__(folder, *(arguments or ("--check-seconds", "600")))
        self.start()
        self.control = HandControl()
        profile = hand_profile(self.control)
        self.post("/machines", profile)
        self.post("/machines", shop.preset("sinumerik-840d-mill", url=f"pty:{folder}/mill") | {"name": "mill"})

    def program(self, text, name, dialect="fanuc"):
        return self.post("/programs", {"name": name, "dialect": dialect, "text": text})["id"]

    def check_in_background(self, program, role="admin"):
        answers = []

        def ask():
            try:
                answers.append(self.call("POST", "/checks", {"program": program, "machine": "lathe"}, role))
            except (OSError, http.client.HTTPException):
                answers.append(None)  # the server was killed by the test
        thread = threading.Thread(target=ask)
        thread.start()
        return thread, answers

    def busy_worker(self):
        """The process of this server that computes; the one that is kept ready does not."""
        def found():
            for pid in children_of(self.server.process.pid):
                if cpu_ticks(pid) > 10:
                    return pid
            return None
        return wait_for("a worker that computes", found)


def children_of(pid):
    found = []
    for task in os.listdir(f"/proc/{pid}/task"):
        with open(f"/proc/{pid}/task/{task}/children", encoding="ascii") as file:
            found += [int(one) for one in file.read().split()]
    return found


def cpu_ticks(pid):
    try:
        with open(f"/proc/{pid}/stat", encoding="ascii") as file:
            fields = file.read().rsplit(")", 1)[1].split()
        return int(fields[11]) + int(fields[12])
    except (FileNotFoundError, ProcessLookupError):
        return 0


def is_alive(pid):
    try:
        with open(f"/proc/{pid}/stat", encoding="ascii") as file:
            return file.read().rsplit(")", 1)[1].split()[0] != "Z"
    except (FileNotFoundError, ProcessLookupError):
        return False


def a_crash_touches_no_feed(folder):
    s = Shop(folder)
    text = plain_program(400)
    release = s.release(s.add_program(400)["id"])["id"]
    endless = s.program(ENDLESS, "O7001")
    job = s.queue(release)
    s.wait_line("lathe", "idle")
    s.post(f"/jobs/{job}/arm")
    s.control.say(DC1)
    s.wait_job(job, "feeding")
    thread, answers = s.check_in_background(endless)
    worker = s.busy_worker()
    with open(f"/proc/{worker}/stat", encoding="ascii") as file:
        expect(file.read().rsplit(")", 1)[1].split()[16] == "19", "a worker is not at nice 19")
    limits = open(f"/proc/{worker}/limits", encoding="ascii").read()
    expect("Max core file size        0 " in limits and "Max data size             unlimited" not in limits, limits)
    descriptors = {os.readlink(f"/proc/{worker}/fd/{fd}") for fd in os.listdir(f"/proc/{worker}/fd") if int(fd) > 2}
    expect(not descriptors, f"a worker holds {descriptors}")
    os.kill(worker, signal.SIGSEGV)
    thread.join(60)
    expect_problem(answers[0], 500, "a check that crashed", ["ended abnormally", "signal 11"])
    expect(s.job(job)["state"] in ("feeding", "held", "draining", "done"), "the feed did not go on")
    done = s.wait_job(job, "done")
    expect(not done["torn"] and s.control.text().decode().strip() == text.strip(), "the feed was disturbed")
    s.call("GET", "/healthz")
    s.server.stop()


def the_budget_of_time(folder):
    s = Shop(folder, "--check-seconds", "1")
    for text, name in ((ENDLESS, "O7001"), (PECKS, "O7002")):
        begun = time.monotonic()
        verdict = s.post("/checks", {"program": s.program(text, name), "machine": "lathe"})
        expect(time.monotonic() - begun < 15, "a check took much longer than its budget")
        expect(verdict["verdict"] in ("unknown", "fail"), f"{verdict['verdict']}")
        expect(any("budget of" in one for one in verdict["not_checked"]), f"{name}: what ended it is not said: {verdict['not_checked']}")
    verdict = s.post("/checks", {"program": s.program(FILL, "FILL", "sinumerik-840d"), "machine": "mill"})
    expect(verdict["verdict"] == "unknown", f"a fill whose count is not known: {verdict['verdict']}")
    s.server.stop()


def the_budget_of_memory(folder):
    s = Shop(folder, "--check-memory", "64")
    s.refuse(409, "POST", "/checks", {"program": s.program(LARGE, "O7003"), "machine": "lathe"}, words=["needs more than 64 MB"])
    s.check(s.add_program(20)["id"])
    s.server.stop()


def who_leaves_is_not_waited_for(folder):
    s = Shop(folder)
    endless = s.program(ENDLESS, "O7001")
    connection = http.client.HTTPConnection("127.0.0.1", s.server.port, timeout=30)
    body = json.dumps({"program": endless, "machine": "lathe"})
    connection.request("POST", whole("/checks"), body=body, headers={"Authorization": f"Bearer {s.tokens['admin']}", "Content-Type": "application/json"})
    worker = s.busy_worker()
    connection.close()
    wait_for("the worker of a client that left to end", lambda: not is_alive(worker) or None)
    thread, _ = s.check_in_background(endless)
    worker = s.busy_worker()
    begun = time.monotonic()
    s.server.stop()
    expect(time.monotonic() - begun < 10, "the server waited for a check when it was stopped")
    expect(not is_alive(worker), "a worker outlived its server")
    thread.join(60)


def work_of_people(s):
    """Without the reading for the library, which comes after every change of a program."""
    return [one for one in s.get("/work")["items"] if one["kind"] != "index"]


def work_is_seen_and_cancelled(folder):
    s = Shop(folder)
    endless = s.program(ENDLESS, "O7001")
    expect(work_of_people(s) == [], "work of no one")
    places = max(2, os.cpu_count() - 1)
    asked = [s.check_in_background(endless, "programmer") for _ in range(places + 2)]

    def seen():
        items = work_of_people(s)
        return items if len(items) == places + 2 and sum(one["state"] == "running" for one in items) == places else None
    items = wait_for("work that runs and work that waits", seen)
    running, waiting = [one for one in items if one["state"] == "running"], [one for one in items if one["state"] == "waiting"]
    expect([one["place"] for one in waiting] == [1, 2] and all(one["place"] is None for one in running), f"places: {items}")
    now_ms = time.time() * 1000
    for one in items:
        expect((one["kind"], one["subject"], one["machine"], one["actor"]) == ("check", f"program/{endless}", "lathe", "the programmer"), f"{one}")
        expect(now_ms - 60_000 < one["waiting_since_ms"] <= now_ms + 1000 and one["budget_s"] > 0, f"{one}")
        expect((one["running_since_ms"] is not None) == (one in running), f"{one}")
    s.tokens["stranger"] = s.add_token("programmer", "somebody else")
    s.refuse(403, "DELETE", f"/api/v1/work/{waiting[0]['id']}", role="stranger", words=["the programmer"])
    s.refuse(403, "DELETE", f"/api/v1/work/{waiting[0]['id']}", role="operator")
    s.refuse(404, "DELETE", "/api/v1/work/4711")
    s.refuse(404, "DELETE", "/api/v1/work/x")
    expect(len(work_of_people(s)) == places + 2, "work that was not to be cancelled is gone")

    def cancel(one, role):
        answer = s.call("DELETE", f"/api/v1/work/{one['id']}", role=role)
        expect(answer.status == 204 and answer.body == b"", f"cancelling: {answer}")
        wait_for("it to be gone", lambda: one["id"] not in [left["id"] for left in work_of_people(s)] or None)

    def answered():
        return [answers[0] for _, answers in asked if answers]
    cancel(waiting[0], "programmer")
    wait_for("the answer to who waited", lambda: len(answered()) == 1 or None)
    expect_problem(answered()[0], 409, "a check that was cancelled while it waited", ["cancelled by the programmer"])
    expect([one["place"] for one in work_of_people(s) if one["state"] == "waiting"] == [1], "who waits moves up")

    workers = children_of(s.server.process.pid)
    cancel(running[0], "admin")
    wait_for("the worker's process to end", lambda: any(not is_alive(pid) for pid in workers) or None)
    wait_for("the answer", lambda: any("cancelled by admin" in str(answer) for answer in answered()) or None)
    expect(len(answered()) == 2, f"more than what was cancelled has ended: {[str(one) for one in answered()]}")
    wait_for("the one that waited to run", lambda: all(one["state"] == "running" for one in work_of_people(s)) or None)
    for one in work_of_people(s):
        cancel(one, "admin")
    for thread, answers in asked:
        thread.join(60)
        expect(answers and answers[0].status == 409, f"{[str(one) for one in answers]}")
    expect(work_of_people(s) == [], "work that is left")
    expect(s.get("/checks")["items"] == [], "a verdict of what was cancelled")
    s.check(s.add_program(20)["id"])
    s.server.stop()


def a_killed_server_leaves_no_worker(folder):
    s = Shop(folder)
    thread, _ = s.check_in_background(s.program(ENDLESS, "O7001"))
    worker = s.busy_worker()
    s.server.kill()
    wait_for("the worker of a killed server to end", lambda: not is_alive(worker) or None)
    thread.join(60)


if __name__ == "__main__":
    for test in (a_crash_touches_no_feed, the_budget_of_time, the_budget_of_memory, who_leaves_is_not_waited_for, work_is_seen_and_cancelled, a_killed_server_leaves_no_worker):
        in_folder(test)
