"""Checks run in processes of their own: one that crashes, hangs, takes too much or is left by its client never touches the server or a feed."""

import http.client
import json
import os
import signal
import threading
import time

from client import DC1, Client, HandControl, binary, expect, expect_problem, hand_profile, in_folder, plain_program, shop, whole

ENDLESS = "%\nO7001\n#100=0\nWHILE[#100GE0]DO1\n#100=#100+1\nIF[#100GT1000]THEN#100=1\nEND1\nM30\n%\n"
PECKS = "%\nO7002\nG0Z5.\nWHILE[1EQ1]DO1\nG83X0Y0Z-99.R0Q0.0001F100\nEND1\nM30\n%\n"
FILL = "R[10]=REP(5,3)\nR[20]=REP(7)\nM30\n"
# Each distinct text that is executed is compiled and kept; each line of it has a name of its own in the machine's data.
LARGE = "%\nO7003\n" + "".join(f"#{100 + n % 400}=[[[[{n}+#1]*2+#2]*3+#3]*4]\n" for n in range(300_000)) + "M30\n%\n"


class Shop(Client):
    def __init__(self, folder, *arguments):
        super().__init__(folder, *arguments)
        self.start()
        self.control = HandControl()
        profile = hand_profile(self.control)
        self.post("/machines", profile)
        self.post("/machines", shop.preset("sinumerik-840d-mill", url=f"pty:{folder}/mill") | {"name": "mill"})

    def program(self, text, name, dialect="fanuc"):
        return self.post("/programs", {"name": name, "dialect": dialect, "text": text})["id"]

    def check_in_background(self, program):
        answers = []

        def ask():
            try:
                answers.append(self.call("POST", "/checks", {"program": program, "machine": "lathe"}))
            except (OSError, http.client.HTTPException):
                answers.append(None)  # the server was killed by the test
        thread = threading.Thread(target=ask)
        thread.start()
        return thread, answers

    def busy_worker(self):
        """The process of this server that computes; the one that is kept ready does not."""
        def found():
            for pid in children_of(self.server.process.pid):
                if cpu_ticks(pid) > 20:
                    return pid
            return None
        return shop.wait_for("a worker that computes", found)


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
    thread.join(20)
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
    shop.wait_for("the worker of a client that left to end", lambda: not is_alive(worker) or None)
    thread, _ = s.check_in_background(endless)
    worker = s.busy_worker()
    begun = time.monotonic()
    s.server.stop()
    expect(time.monotonic() - begun < 10, "the server waited for a check when it was stopped")
    expect(not is_alive(worker), "a worker outlived its server")
    thread.join(20)


def a_killed_server_leaves_no_worker(folder):
    s = Shop(folder)
    thread, _ = s.check_in_background(s.program(ENDLESS, "O7001"))
    worker = s.busy_worker()
    s.server.kill()
    shop.wait_for("the worker of a killed server to end", lambda: not is_alive(worker) or None)
    thread.join(20)


if __name__ == "__main__":
    for test in (a_crash_touches_no_feed, the_budget_of_time, the_budget_of_memory, who_leaves_is_not_waited_for, a_killed_server_leaves_no_worker):
        in_folder(test)
