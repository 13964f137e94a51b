#!/usr/bin/env python3
"""What a feed at the line has of the desk's work: pauses between what arrives at a control that is fed at 19200 Bd, first alone and then while others ask for
toolpaths, stock, diagnoses, searches and previews without a pause. By hand: tests/bench/feed_beside_desk.py build/dev/dripfeed [SECONDS] [ASKERS]"""

import pathlib
import sys
import threading
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/api"))
from client import DC1, Client, HandControl, hand_profile, in_folder, plain_program  # noqa: E402

SECONDS = float(sys.argv[2]) if len(sys.argv) > 2 else 20
ASKERS = int(sys.argv[3]) if len(sys.argv) > 3 else 4
BAUD = 19200


def figures(gaps_s):
    ms = sorted(1000 * gap for gap in gaps_s)
    return f"{len(ms)} arrivals, pauses: median {ms[len(ms) // 2]:.2f} ms, 99 % {ms[int(0.99 * len(ms))]:.2f} ms, 99.9 % {ms[int(0.999 * len(ms))]:.2f} ms, longest {ms[-1]:.2f} ms"


def measured(control, seconds):
    with control.lock:
        control.gaps_s, before = [], len(control.got)
    time.sleep(seconds)
    with control.lock:
        gaps, control.gaps_s = control.gaps_s, None
        return gaps, (len(control.got) - before) / seconds


def run(folder):
    client = Client(folder)
    client.start()
    control = HandControl()
    profile = hand_profile(control, "fed")
    profile["link"]["baud"] = BAUD
    client.post("/machines", profile)
    family = "hyperbolic-roll"
    client.call("POST", "/families", {"text": (ROOT / f"deploy/families/{family}.family").read_text()})
    long = client.add_program(8000, "O0001")["id"]
    release = client.release(long, "fed")["id"]
    job = client.post("/jobs", {"release": release})["id"]
    client.wait_line("fed", "idle")
    client.post(f"/jobs/{job}/arm", {})
    control.say(DC1)
    control.wait_bytes(2000)
    alone, alone_rate = measured(control, SECONDS)
    text = plain_program(5000, "O0002")
    asks = [("POST", "/path", {"text": text, "dialect": "fanuc", "machine": "fed"}), ("POST", "/diagnose", {"text": text, "dialect": "fanuc", "machine": "fed"}),
            ("POST", "/statistics", {"text": text, "dialect": "fanuc", "machine": "fed"}), ("GET", "/search?q=X10", None), ("POST", "/stock", {"text": text, "dialect": "fanuc", "stock": "cylinder 100 -100 0"}),
            ("POST", "/preview", {"family": family, "values": {"angle_step": "0.1 deg"}, "machine": "fed", "delivery": "drip"})]
    stop, answers = threading.Event(), {}

    def ask(first):
        turn = first
        while not stop.is_set():
            method, path, body = asks[turn % len(asks)]
            status = client.call(method, path, body, role="programmer").status
            answers[path, status] = answers.get((path, status), 0) + 1
            turn += 1

    threads = [threading.Thread(target=ask, args=(n,), daemon=True) for n in range(ASKERS)]
    for thread in threads:
        thread.start()
    loaded, loaded_rate = measured(control, SECONDS)
    stop.set()
    for thread in threads:
        thread.join(60)
    print(f"alone: {alone_rate:.0f} characters/s, {figures(alone)}")
    print(f"beside {ASKERS} askers: {loaded_rate:.0f} characters/s, {figures(loaded)}")
    print(f"answered meanwhile: {', '.join(f'{path} {status}: {count}' for (path, status), count in sorted(answers.items()))}")
    client.end()


in_folder(run)
