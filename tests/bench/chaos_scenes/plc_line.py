"""A line to a PLC by Modbus TCP: the repository's simulated PLC takes the blocks, and this program reads over a connection of its own what the PLC says that it
has: how many characters, and their check sum."""

import json
import random
import socket
import struct
import threading
import time
import zlib

import shop

from chaos_scenes.served import ServerGone

STATUS, WORDS, SIZE_AT, SUM_AT = 128, 19, 13, 15
ENDED = ("done", "failed", "cancelled", "interrupted", "queued")


def registers(port, first, count, unit=1):
    """Holding registers, by one request of our own."""
    with socket.create_connection(("127.0.0.1", port), 5) as plc:
        plc.sendall(struct.pack(">HHHBBHH", 1, 0, 6, unit, 3, first, count))
        answer = b""
        while len(answer) < 9 + 2 * count:
            piece = plc.recv(512)
            if not piece:
                raise OSError(f"the PLC answers {answer!r}")
            answer += piece
    return struct.unpack(f">{count}H", answer[9:9 + 2 * count])


class PlcLine(threading.Thread):
    def __init__(self, name, served, judge, folder, seed):
        super().__init__(daemon=True, name=name)
        self.served, self.judge_of_all, self.folder = served, judge, folder
        self.chance = random.Random(f"{seed} {name}")
        self.over = threading.Event()
        self.port = shop.free_port()
        self.scene = "block transfer"
        self.job = self.died = self.plc = None
        self.text = ""

    def add(self, text):
        url = f"modbus-tcp://127.0.0.1:{self.port}/1?poll_ms=20"
        profile = shop.preset("fanuc-0i-lathe", url=url)
        profile["name"] = self.name
        machine = self.folder / f"{self.name}.json"
        machine.write_text(json.dumps(profile))
        self.plc = shop.Control(self.served.binary, url, machine, "--speed", "20", "--repeat").start()
        shop.wait_for("the PLC", lambda: shop.listens(self.port))
        self.text = text
        self.served.post("/machines", profile)
        program = self.served.post("/programs", {"name": "O0088", "dialect": "fanuc", "text": text})
        self.served.post("/checks", {"program": program["id"], "machine": self.name, "delivery": "drip"})
        release = self.served.post("/releases", {"program": program["id"], "machine": self.name, "delivery": "drip"})
        for step in ({"to": "in_review"}, {"to": "proving", "transfers": 1_000_000}):
            release = self.served.post(f"/releases/{release['id']}/transitions", step)
        self.release = release["id"]

    def at_plc(self):
        words = registers(self.port, STATUS, WORDS)
        return words[SIZE_AT] << 16 | words[SIZE_AT + 1], words[SUM_AT] << 16 | words[SUM_AT + 1]

    def server_died(self, how):
        self.died = how if self.job else None

    def run(self):
        while not self.over.is_set():
            if not self.served.up.wait(0.2):
                continue
            try:
                if self.died:
                    self.after_death()
                else:
                    self.judge_of_all.scene(self.scene, self.transfer())
            except ServerGone:
                while not self.over.is_set() and not self.served.up.is_set():
                    time.sleep(0.02)
            except shop.Refused as refused:
                self.judge_of_all.refused(f"plc: {str(refused)[:150]}")
                self.confirm()
            except (OSError, TimeoutError) as error:
                self.judge_of_all.refused(f"plc: {error}")
            time.sleep(self.chance.uniform(0.1, 0.5))

    def transfer(self):
        job = self.served.post("/jobs", {"release": self.release})["id"]
        self.served.post(f"/jobs/{job}/arm")
        self.job = job
        cancel_at = time.monotonic() + self.chance.uniform(0.2, 3) if self.chance.random() < 0.3 else None
        until = time.monotonic() + 20
        while time.monotonic() < until:
            state = self.served.get(f"/jobs/{job}")["state"]
            if state in ENDED:
                self.judge_job(job, state)
                self.job = None
                return state
            if cancel_at and time.monotonic() > cancel_at:
                cancel_at = None
                self.served.post(f"/jobs/{job}/cancel")
            time.sleep(0.05)
        self.served.post(f"/jobs/{job}/cancel")
        return "stuck"

    def judge_job(self, job, state):
        size, check_sum = self.at_plc()
        if state == "queued":
            return  # it never began: the PLC's words are those of an earlier transfer
        if zlib.crc32(self.text[:size].encode()) != check_sum:
            self.judge_of_all.violation(2, self.name, self.scene, f"the PLC's {size} characters are not the program's first")
        interval = self.served.get(f"/jobs/{job}/ledger?limit=1")["interval"]
        if interval["high"] > 0:
            self.judge_of_all.interval(self.name, self.scene, size, interval)
        if state == "done" and size != len(self.text):
            self.judge_of_all.violation(3, self.name, self.scene, f"done, and the PLC has {size} of {len(self.text)} characters")

    def after_death(self):
        how, self.died = self.died, None
        state = self.served.get(f"/jobs/{self.job}")["state"]
        self.scene = f"{how} during block transfer"
        self.judge_job(self.job, state)
        self.confirm()
        self.judge_of_all.scene(how, f"block transfer {state}")
        self.scene, self.job = "block transfer", None

    def confirm(self):
        status = self.served.get(f"/machines/{self.name}")["status"]
        if status["needs_confirmation"] or status["line"] == "torn":
            self.served.post(f"/machines/{self.name}/confirm-reset", {"reason": "the PLC was reset"})
