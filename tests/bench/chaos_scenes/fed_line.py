"""One line whose control is the test's own: a thread that plays one scene after the other, and what is due after the server died. The thread is the person and
the operator; what may come over the line it says to the judge beforehand."""

import random
import threading
import time

import shop

from chaos_scenes.judge import Permit
from chaos_scenes.served import ServerGone

STUCK_S = 8.0


class Stuck(Exception):
    """What had to come did not."""


class FedLine(threading.Thread):
    def __init__(self, name, loop, served, judge, control, scenes, seed):
        super().__init__(daemon=True, name=name)
        self.loop, self.served, self.judge_of_all, self.control = loop, served, judge, control
        self.scenes = scenes
        self.chance = random.Random(f"{seed} {name}")
        self.permit = Permit(judge, self)
        control.judge = self.permit
        self.scene = "setup"
        self.job = None  # that was armed and did not end yet
        self.died = None  # how the server did, while this line did something
        self.measured = False
        self.generation = 0
        self.over = threading.Event()
        self.release = None
        self.text = ""

    # --- setting up
    def add(self, text, baud, framing, **link):
        profile = shop.preset("fanuc-0i-lathe", url=self.control.url(), baud=baud, framing=framing, end_by_quiet_s=0.3, **link)
        profile["name"] = self.name
        profile["receive"] = {"quiet_s": 0.4, "quiet_after_end_s": 0.1}
        self.text = text
        self.served.post("/machines", profile)
        program = self.served.post("/programs", {"name": f"O{self.chance.randrange(1000, 7000)}", "dialect": "fanuc", "text": text})
        self.served.post("/checks", {"program": program["id"], "machine": self.name, "delivery": "drip"})
        release = self.served.post("/releases", {"program": program["id"], "machine": self.name, "delivery": "drip"})
        for step in ({"to": "in_review"}, {"to": "proving", "transfers": 1_000_000}):
            release = self.served.post(f"/releases/{release['id']}/transitions", step)
        self.release = release["id"]

    # --- waiting
    def wait(self, what, condition, seconds=STUCK_S, step=0.02):
        until = time.monotonic() + seconds
        while not condition():
            self.look()
            if time.monotonic() > until:
                raise Stuck(f"waited {seconds:g} s for {what}")
            time.sleep(step)

    def look(self):
        if self.served.generation != self.generation or not self.served.up.is_set():
            raise ServerGone

    def rest(self, seconds):
        until = time.monotonic() + seconds
        while time.monotonic() < until:
            self.look()
            time.sleep(min(0.02, seconds))

    def status(self):
        return self.served.get(f"/machines/{self.name}")["status"]

    def wait_line(self, *states, seconds=STUCK_S):
        self.wait(f"the line to be {' or '.join(states)}", lambda: self.status()["line"] in states, seconds, 0.05)

    def job_state(self):
        return self.served.get(f"/jobs/{self.job}")

    def wait_job(self, *states, seconds=STUCK_S):
        self.wait(f"job {self.job} to be {' or '.join(states)}", lambda: self.job_state()["state"] in states, seconds, 0.05)

    # --- what people and the operator do
    def arm(self):
        self.wait_line("idle")
        self.job = self.served.post("/jobs", {"release": self.release})["id"]
        self.control.begin()
        self.permit.set("armed", "the control did not start")
        self.served.post(f"/jobs/{self.job}/arm")

    def cycle_start(self):
        # After a break the server may see its connection before this end has taken it: a start would go nowhere.
        self.wait("the link", self.control.up)
        self.permit.set("sending")
        self.control.start()

    def feed_until(self, count):
        self.wait(f"{count} bytes", lambda: self.control.count() >= count, step=0.005)

    def somewhere(self, low=0.1, high=0.9):
        return int(len(self.text) * self.chance.uniform(low, high))

    def whole(self):
        text = self.control.text().strip("\0")
        return text.count("%") >= 2 and text.rstrip("\0\n").endswith("%")

    def finish(self):
        """The rest of the program; the control ends the tape by DC3."""
        self.wait("the end of the program", self.whole, step=0.01)
        self.control.hold()
        self.wait_job("done", "failed", "cancelled")
        self.permit.set("silent", "the program is over")
        job, self.job = self.job_state(), None
        if job["state"] == "done" and self.control.text().strip("\0\n") != self.text.strip("\n"):
            self.judge_of_all.violation(3, self.name, self.scene, f"done, but another text arrived ({self.control.count()} bytes)")
        self.check_interval(job["id"])

    def check_interval(self, job, slack=0):
        interval = self.served.get(f"/jobs/{job}/ledger?limit=1")["interval"]
        self.judge_of_all.interval(self.name, self.scene, self.control.count(), interval, slack)

    def stop(self):
        self.control.expect_nothing()
        self.served.post(f"/jobs/{self.job}/stop")
        self.permit.set("stopping", "stop", blocks_left=2)
        self.ends_at_block("stop")

    def ends_at_block(self, what):
        last = self.control.count()
        until = time.monotonic() + 3
        while time.monotonic() < until:
            self.rest(0.25)
            now = self.control.count()
            if now == last:
                break
            last = now
        self.permit.set("silent", f"after a person's {what}")
        if self.control.inside_block():
            self.judge_of_all.violation(1, self.name, self.scene, f"a person's {what} left a torn block: {self.control.text()[-30:]!r}")

    def cancel(self):
        self.control.expect_nothing()
        self.served.post(f"/jobs/{self.job}/cancel")
        self.permit.set("stopping", "cancel", blocks_left=2)
        self.ends_at_block("cancel")
        self.wait_job("cancelled", "done", "failed")
        self.check_interval(self.job)
        self.job = None

    def provoke(self, torn):
        """What an operator does at a control that waits: nothing of it may bring a byte. A line that is not torn answers a request, so none is made there."""
        if not torn:
            self.control.send(b"\x11")
            return self.rest(0.3)
        for act in self.chance.sample([lambda: self.control.send(b"\x11"), lambda: self.control.punch("%\nO9999(DIR)\n%\n"),
                                       lambda: self.control.punch("%\nO9999(STATUS)\n%\n"), lambda: self.control.send(b"\x93\x11")], 3):
            act()
            self.rest(self.chance.uniform(0.05, 1.0))
        self.rest(0.7)
        self.control.send(b"\x11")
        self.rest(0.3)

    def drop_answer(self):
        """One that a request brought about and no person wants."""
        if self.status()["line"] != "answering":
            return
        self.permit.set("answer")
        self.control.start()
        self.wait("the answer", self.whole)
        self.control.hold()
        self.wait_line("idle")
        self.control.begin()

    # --- torn blocks
    def torn(self, why):
        self.permit.set("torn", why)

    def after_break(self, job, why, slack=0):
        """The line broke or the server died; the control is there again. Judges what the books say, then the person confirms."""
        torn = self.control.inside_block()
        if torn:
            self.torn(why)
        else:
            self.permit.set("silent", why)
        state = self.served.get(f"/jobs/{job}") if job else None
        if job and state["state"] not in ("done", "queued"):
            self.check_interval(job, slack)
        if job and state["state"] == "queued" and self.control.count() > 0:
            self.judge_of_all.violation(3, self.name, self.scene, f"{self.control.count()} bytes arrived, and the job waits as if none had")
        if job and state["state"] in ("done", "queued") and torn:
            self.judge_of_all.violation(3, self.name, self.scene, f"a block is torn at the control, and the job is {state['state']}")
        self.job = None
        self.wait("the link", self.control.up, 20)
        status = self.status()
        if torn and status["line"] != "torn":
            self.judge_of_all.violation(2, self.name, self.scene, f"a block is torn at the control, and the line is {status['line']}")
        if self.control.up():
            self.provoke(torn)
        status = self.status()
        if status["needs_confirmation"] or status["line"] == "torn":
            self.control.begin()
            self.permit.set("silent", "the control was reset, and nothing is armed")
            self.served.post(f"/machines/{self.name}/confirm-reset", {"reason": "the test pressed RESET"})
        elif torn:
            self.judge_of_all.violation(2, self.name, self.scene, "a block is torn at the control, and no one is asked to confirm")
        self.control.begin()
        self.drop_answer()
        self.permit.set("silent", "the control was reset, and nothing is armed")

    # --- the thread
    def run(self):
        while not self.over.is_set():
            if not self.served.up.wait(0.2):
                continue
            self.generation = self.served.generation
            try:
                if self.died:
                    self.after_death()
                else:
                    self.play()
            except ServerGone:
                self.wait_for_settled()

    def wait_for_settled(self):
        while not self.over.is_set() and not self.served.up.is_set():
            time.sleep(0.02)

    def play(self):
        names = list(self.scenes)
        self.scene = self.chance.choices(names, [self.scenes[name][0] for name in names])[0]
        self.measured = False
        try:
            self.scenes[self.scene][1](self)
            outcome = "ended"
        except shop.Refused as refused:
            self.judge_of_all.refused(f"{self.scene}: {str(refused)[:150]}")
            outcome = "refused"
            self.recover()
            self.rest(1.5 if refused.status == 503 else 0.2)
        except Stuck as stuck:
            outcome = "stuck"
            self.look()
            waited = self.control.expected_since is not None and self.measured
            if waited and self.job and self.job_state()["state"] == "queued":
                outcome = "disarmed"
            elif waited:
                self.judge_of_all.violation(4, self.name, self.scene, f"{stuck}; {self.control.count()} bytes came; {self.stall()}")
            else:
                self.judge_of_all.refused(f"{self.scene}: {stuck}")
            self.recover()
        if self.measured and self.control.timed:
            with self.loop.lock:
                delays, self.control.delays = self.control.delays, []
            self.judge_of_all.delays(self.name, self.scene, delays)
        self.control.delays = []
        self.judge_of_all.scene(self.scene, outcome)

    def stall(self):
        status = self.status()
        return f"the server says {status['line']}, {status['stall']}"

    def recover(self):
        """Back to an idle line, as a person would."""
        self.permit.set("sending", "recovering")
        self.control.expect_nothing()
        try:
            if self.job:
                state = self.job_state()["state"]
                if state not in ("done", "failed", "cancelled", "interrupted"):
                    try:
                        self.served.post(f"/jobs/{self.job}/cancel")
                    except shop.Refused:
                        pass
                    self.control.send(b"\x11")
                    self.rest(0.5)
                    self.control.cut()
                    self.rest(0.5)
            status = self.status()
            if status["needs_confirmation"] or status["line"] == "torn":
                self.served.post(f"/machines/{self.name}/confirm-reset", {"reason": "the test recovers"})
        except shop.Refused as refused:
            self.judge_of_all.refused(f"recover: {str(refused)[:150]}")
        self.job = None
        self.control.begin()
        self.permit.set("silent", "the control was reset, and nothing is armed")

    def server_died(self, how):
        """Called by the test's main thread between two runs, once nothing can arrive any more."""
        busy = self.job is not None or self.scene == "answer"
        torn = self.control.inside_block()
        self.control.expect_nothing()
        self.control.delays = []
        if torn:
            self.torn(f"{how} inside a block, in {self.scene}")
        else:
            self.permit.set("silent", f"after {how}: no one armed anything")
        self.died = how if busy or torn else None
        if hasattr(self.control, "free"):
            self.control.free()
        if not self.died:
            self.control.begin()

    def after_death(self):
        how = self.died
        self.scene = f"{how} during {self.scene.split(' during ')[-1]}"
        outcome = "inside a block" if self.control.inside_block() else "at rest"
        try:
            self.after_break(self.job, how)
        except Stuck as stuck:
            self.judge_of_all.refused(f"{self.scene}: {stuck}")
            self.recover()
        except shop.Refused as refused:
            self.judge_of_all.refused(f"{self.scene}: {str(refused)[:150]}")
            self.recover()
        self.died = None
        self.judge_of_all.scene(how, outcome)
