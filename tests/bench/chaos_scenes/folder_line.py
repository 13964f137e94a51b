"""A line into a folder whose file system freezes now and then. The control fetches files: the whole program lies there under its name, or none does."""

import os
import random
import threading
import time

import shop

from chaos_scenes.served import ServerGone


class FolderLine(threading.Thread):
    def __init__(self, name, served, judge, share, seed):
        super().__init__(daemon=True, name=name)
        self.served, self.judge_of_all, self.share = served, judge, share
        self.chance = random.Random(f"{seed} {name}")
        self.over = threading.Event()
        self.release = None
        self.text = ""
        self.scene = "folder"

    def add(self, text):
        profile = shop.preset("fanuc-0i-lathe", url=f"dir:{self.share.path}?overwrite=yes")
        profile["name"] = self.name
        self.text = text
        self.served.post("/machines", profile)
        program = self.served.post("/programs", {"name": "O0077", "dialect": "fanuc", "text": text})
        self.served.post("/checks", {"program": program["id"], "machine": self.name, "delivery": "memory"})
        release = self.served.post("/releases", {"program": program["id"], "machine": self.name, "delivery": "memory"})
        for step in ({"to": "in_review"}, {"to": "proving", "transfers": 1_000_000}):
            release = self.served.post(f"/releases/{release['id']}/transitions", step)
        self.release = release["id"]

    def server_died(self, how):
        """Called between two runs."""

    def run(self):
        while not self.over.is_set():
            if not self.served.up.wait(0.2):
                continue
            frozen = self.chance.random() < 0.5
            outcome = "broken off"
            try:
                outcome = self.drop(frozen)
            except (ServerGone, TimeoutError):
                pass
            except shop.Refused as refused:
                outcome = "refused"
                self.judge_of_all.refused(f"folder: {str(refused)[:150]}")
                self.confirm()
            self.share.thaw()
            self.look_at_file(outcome)
            self.judge_of_all.scene("drop, folder freezes" if frozen else "drop", outcome)
            time.sleep(self.chance.uniform(0.2, 1.0))

    def confirm(self):
        try:
            if self.served.get(f"/machines/{self.name}")["status"]["needs_confirmation"]:
                self.served.post(f"/machines/{self.name}/confirm-reset", {"reason": "the folder was looked at"})
            time.sleep(1)
        except (ServerGone, shop.Refused, TimeoutError):
            pass  # the next drop says so again

    def drop(self, frozen):
        job = self.served.post("/jobs", {"release": self.release})["id"]
        self.served.post(f"/jobs/{job}/arm")
        if frozen:
            time.sleep(self.chance.uniform(0, 0.05))
            self.share.freeze()
            time.sleep(self.chance.uniform(0.5, 4.0))
            self.share.thaw()
        until = time.monotonic() + 10
        while time.monotonic() < until:
            state = self.served.get(f"/jobs/{job}")["state"]
            if state in ("done", "failed", "cancelled", "interrupted", "queued"):
                return state
            time.sleep(0.1)
        self.served.post(f"/jobs/{job}/cancel")
        return "stuck"

    def look_at_file(self, outcome):
        path = os.path.join(self.share.path, "O0077")
        there = open(path, encoding="latin-1").read() if os.path.exists(path) else None
        if outcome == "done" and there is None:
            self.judge_of_all.violation(3, self.name, self.scene, "the job is done, and no file lies there")
        if there is not None and there.replace("\r\n", "\n") != self.text:
            self.judge_of_all.violation(2, self.name, self.scene, f"a file of {len(there)} characters lies there that is not the program")
        if there is not None:
            os.unlink(path)
