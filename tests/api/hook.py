"""The system that is asked before an arming: what it is asked, signed as webhooks are; its refusal in its words; no answer in all its kinds, which
refuses or warns; and that a feed and a stop do not wait for it."""

import http.server
import json
import re
import sys
import threading
import time

from client import DC1, Client, HandControl, expect, hand_profile, in_folder
from receipts import PROGRAM, Bench
from receiver import DOCS, verify

SECRET = "whsec_" + "c2VjcmV0IG9mIHRoZSBhcm1pbmcgaG9vaw=="
ASK_S = 2


class Planner:
    """Answers what `say` gives: (status, body), or None: nothing until the test lets it."""

    def __init__(self):
        self.asked, self.let_go = [], threading.Event()
        self.say = lambda question: (200, {"allow": True})
        planner = self

        class Handler(http.server.BaseHTTPRequestHandler):
            def do_POST(self):
                body = self.rfile.read(int(self.headers["Content-Length"]))
                question = verify(SECRET, {name.lower(): value for name, value in self.headers.items()}, body)
                planner.asked.append(question)
                answer = planner.say(question)
                if answer is None:
                    planner.let_go.wait(20)
                    return
                status, said = answer
                data = said if isinstance(said, bytes) else json.dumps(said).encode()
                self.send_response(status)
                self.send_header("Content-Length", str(len(data)))
                self.end_headers()
                self.wfile.write(data)

            def log_message(self, *arguments):
                pass

        self.server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler)
        self.server.daemon_threads = True
        self.url = f"http://127.0.0.1:{self.server.server_address[1]}/may-i"
        threading.Thread(target=self.server.serve_forever, kwargs={"poll_interval": 0.02}, daemon=True).start()

    def close(self):
        self.let_go.set()
        self.server.shutdown()
        self.server.server_close()


class Shop:
    def __init__(self, folder, planner, *options):
        (folder / "secret").write_text(SECRET + "\n")
        self.controls = {"lathe": HandControl(), "second": HandControl()}
        self.client = Client(folder, "--arming-hook", planner.url, "--arming-hook-secret-file", str(folder / "secret"), "--arming-hook-local",
                             "--arming-hook-seconds", str(ASK_S), *options).start()
        for name, control in self.controls.items():
            self.client.post("/machines", hand_profile(control, name))
        program = self.client.add_program(400)
        self.program, self.releases = program["id"], {name: self.client.release(program["id"], name)["id"] for name in self.controls}
        for name in self.controls:
            self.client.wait_line(name, "idle")

    def add(self, machine="lathe", **more):
        return self.client.must("POST", "/jobs", {"release": self.releases[machine]} | more)["id"]

    def refuse(self, job, code, *words):
        answer = self.client.refuse(409, "POST", f"/jobs/{job}/arm", {}, role="operator", words=words)
        expect(answer["code"] == code and self.client.job(job)["state"] == "queued", f"{answer}")

    def close(self):
        self.client.server.stop()
        for control in self.controls.values():
            control.close()


def is_like(shown, real):
    """Whether the document of the page has members of the real one alone, of the same kinds."""
    if isinstance(shown, dict) and isinstance(real, dict):
        return all(name in real and is_like(value, real[name]) for name, value in shown.items())
    return type(shown) is type(real)


def it_is_as_the_docs_show(question):
    shown = next(one for one in map(json.loads, re.findall(r"```json\n(.*?)```", DOCS, re.S)) if one["type"] == question["type"])
    expect(shown.keys() == question.keys() and is_like(shown, question), f"docs/integrating.md shows {shown}, the question is {question}")
    for wrong in ({**question, "job": "1"}, {**question, "order": {}}):  # the check can fail
        expect(not is_like(shown, wrong), f"{wrong} is like the block of the docs")


def it_is_asked_and_its_words_are_shown(folder):
    planner = Planner()
    shop = Shop(folder, planner)
    client = shop.client
    order = client.post("/orders", {"number": "4711", "operation": "20", "part": "R-1", "quantity": 5, "metadata": {"plant": "A7"}})["id"]
    job = shop.add(order=order)
    expect(planner.asked == [], "it was asked before a person armed")
    expect(client.must("POST", f"/jobs/{job}/arm", {}, role="operator")["state"] == "armed", "it allowed")
    question, row = planner.asked[0], client.job(job)
    expect((question["type"], question["job"], question["machine"], question["operator"]) == ("dripfeed.job.arming", job, "lathe", "the operator"), f"{question}")
    it_is_as_the_docs_show(question)
    expect((question["sha256"], question["release"], question["delivery"]) == (row["sha256"], row["release"], "drip"), f"{question}")
    expect(question["program"] == {"id": shop.program, "name": "O0042", "revision": 1}, f"{question}")
    expect((question["order"]["number"], question["order"]["operation"], question["order"]["metadata"]) == ("4711", "20", {"plant": "A7"}), f"{question}")
    client.refuse(409, "POST", f"/jobs/{job}/arm", {})
    expect(len(planner.asked) == 1, "it was asked of a job that is armed")
    client.post(f"/jobs/{job}/cancel")
    other = shop.add()
    for answer, words in [
            ((200, {"allow": False, "reason": "the fixture is at the wash"}), "the fixture is at the wash"),
            ((409, {"detail": "order 4711 is blocked in SAP"}), "order 4711 is blocked in SAP"),
            ((403, b"no"), "it gives no reason"),
            ((200, {"allow": False, "reason": "a\nb"}), "it gives no reason"),
            ((200, {"allow": False, "reason": "x" * 900}), "x" * 200)]:
        planner.say = lambda question, answer=answer: answer
        shop.refuse(other, "hook_refused", "refuses", words)
    expect(planner.asked[-1]["order"] is None and len({one["id"] for one in planner.asked}) == len(planner.asked), "each question is another one")
    planner.say = lambda question: (200, {"allow": True})
    expect(client.must("POST", f"/jobs/{other}/arm", {})["state"] == "armed", "it allows again")
    shop.close()
    planner.close()


def no_answer_refuses(folder):
    planner = Planner()
    shop = Shop(folder, planner)
    job = shop.add()
    for answer, words in [((200, b"<html>welcome</html>"), "answered 200"), ((200, {"ok": 1}), "answered 200"), ((200, {"allow": "yes"}), "answered 200"),
                          ((201, {"allow": True}), "answered 201"), ((302, {"allow": True}), "answered 302"), ((500, {"allow": True}), "answered 500")]:
        planner.say = lambda question, answer=answer: answer
        shop.refuse(job, "hook_unanswered", "no answer", words)
    planner.say = lambda question: None
    began = time.monotonic()
    shop.refuse(job, "hook_unanswered", "no answer")
    took = time.monotonic() - began
    expect(ASK_S - 0.2 < took < ASK_S + 2, f"it was waited for {took:.1f} s")
    planner.close()
    shop.refuse(job, "hook_unanswered", "no answer")
    expect(not [row for row in shop.client.get(f"/audit?subject=job/{job}")["items"] if row["action"] not in ("job.add",)], "an arming was booked")
    shop.close()


def no_answer_warns_where_that_is_set(folder):
    planner = Planner()
    shop = Shop(folder, planner, "--arming-hook-unanswered", "warn")
    planner.say = lambda question: (200, {"allow": False, "reason": "not today"})
    job = shop.add()
    shop.refuse(job, "hook_refused", "not today")
    planner.say = lambda question: (500, {})
    expect(shop.client.must("POST", f"/jobs/{job}/arm", {})["state"] == "armed", "it arms without an answer")
    rows = shop.client.get(f"/audit?subject=job/{job}")["items"]
    expect([row["action"] for row in rows][:2] == ["job.move", "job.arm-unanswered"] and "answered 500" in rows[1]["detail"], f"{rows}")
    shop.close()
    planner.close()


def no_feed_and_no_stop_waits_for_it(folder):
    planner = Planner()
    shop = Shop(folder, planner)
    client = shop.client
    fed = shop.add("second")
    client.post(f"/jobs/{fed}/arm")
    planner.say = lambda question: None
    waiting = [shop.add() for _ in range(3)]
    refused = []
    threads = [threading.Thread(target=lambda job=job: refused.append(client.call("POST", f"/jobs/{job}/arm", {}).status)) for job in waiting]
    for thread in threads:
        thread.start()
    while len(planner.asked) < 1 + len(waiting):
        time.sleep(0.02)
    shop.controls["second"].say(DC1)
    client.wait_job(fed, "feeding")
    began = time.monotonic()
    client.post(f"/jobs/{fed}/stop")
    stopped = time.monotonic() - began
    expect(stopped < 1.0 and all(thread.is_alive() for thread in threads), f"a stop waited {stopped:.2f} s for the planner")
    client.post(f"/jobs/{fed}/cancel")
    client.wait_job(fed, "cancelled")
    for thread in threads:
        thread.join(10)
    expect(refused == [409] * len(waiting), f"{refused}")
    shop.close()
    planner.close()


def a_request_of_the_control_is_asked_for_too(folder):
    planner = Planner()
    (folder / "secret").write_text(SECRET)
    bench = Bench(folder, ("--arming-hook", planner.url, "--arming-hook-secret-file", str(folder / "secret"), "--arming-hook-local"))
    bench.release("O0042", PROGRAM)
    planner.say = lambda question: (200, {"allow": False, "reason": "NOT BEFORE MONDAY"})
    noted, text = bench.answer("LOAD 42")
    expect(noted["outcome"] == "refused" and "NOT BEFORE MONDAY" in noted["detail"] and "G01" not in text, f"{noted} {text!r}")
    expect(planner.asked[0]["operator"] == "operator at lathe" and planner.asked[0]["delivery"] == "memory", f"{planner.asked}")
    planner.say = lambda question: (200, {"allow": True})
    noted, text = bench.answer("LOAD 42")
    expect(noted["outcome"] == "armed" and text == PROGRAM, f"{noted} {text!r}")
    bench.end()
    planner.close()


if __name__ == "__main__":
    for test in (it_is_asked_and_its_words_are_shown, no_answer_refuses, no_answer_warns_where_that_is_set, no_feed_and_no_stop_waits_for_it, a_request_of_the_control_is_asked_for_too):
        in_folder(test)
    sys.exit(0)
