"""Accuracy, gouges, time and sweeps over REST: the figures that the command prints for the same machine, pictures as SVG, a nominal for a text
that was not rendered, and a server that answers meanwhile."""

import json
import math
import subprocess
import sys
import threading
import time
import xml.dom.minidom

from client import ROLL, Client, binary, expect, in_folder, shop

GOUGE = shop.ROOT / "tests/samples/gouge"
POCKET = (GOUGE / "fanuc_pocket.nc").read_text()
FAULTY = POCKET.replace("N620 G0 Z5.", "N620 G0 Z-2.5")
FAULT_LINE = 1 + POCKET[: POCKET.index("N630")].count("\n")
NOMINAL = {"family": "pocket-with-slot"}
SAMPLES = 600  # a second or more, so that there is a while to ask for other things in
FIXED = {"half_axis_x": "100 mm", "half_axis_z": "202.4 mm", "roll_length": "196 mm", "clearance": "25 mm", "chord_error": "0.002 mm", "cut_feed": "0.15 mm/rev"}


class Shop(Client):
    def __init__(self, folder):
        super().__init__(folder)
        self.folder = folder
        self.start()
        self.profiles = {}
        for name, preset in (("mill", "fanuc-0i-mill"), ("other-mill", "fanuc-0i-mill"), ("lathe", "fanuc-0i-lathe")):
            profile = shop.preset(preset, url=f"pty:{folder}/{name}") | {"name": name}
            if name == "mill":
                profile["tools"] = [{"number": 4, "offset": 4, "diameter_mm": 12, "length_mm": 100}]
            self.profiles[name] = folder / f"{name}.json"
            self.profiles[name].write_text(json.dumps(profile))
            self.post("/machines", profile)
        for text in (ROLL, (GOUGE / "pocket.family").read_text()):
            self.post("/families", {"text": text})

    def program(self, text, name="O4001"):
        return self.post("/programs", {"name": name, "dialect": "fanuc", "text": text})["id"]

    def by_command(self, *arguments, code=0):
        done = subprocess.run([str(binary()), *map(str, arguments), "--json"], capture_output=True, text=True, timeout=120)
        expect(done.returncode == code, f"{arguments}: {done.returncode} {done.stderr}")
        return json.loads(done.stdout)

    def svg(self, path, body, words=()):
        answer = self.call("POST", path, body, "programmer")
        expect(answer.status == 200 and answer.headers["Content-Type"] == "image/svg+xml", f"{path}: {answer}")
        document = xml.dom.minidom.parseString(answer.body)
        expect(document.documentElement.tagName == "svg", f"{path} is no picture")
        for word in words:
            expect(word in answer.body.decode(), f"{path}: \"{word}\" is not in the picture")


def gouges(s):
    good, faulty = s.program(POCKET), s.program(FAULTY, "O4003")
    order = {"program": good, "machine": "mill", "nominal": NOMINAL}
    s.refuse(422, "POST", "/gouge", {"program": good, "machine": "mill"}, words=["stock and nominal are not known"])
    clean = s.post("/gouge", order)
    expect(clean["findings"] == [] and clean["deepest_cut_mm"] <= 0.05 and clean["cuts"] > 60, f"the good program: {clean}")
    expect(not [one for one in clean["not_checked"] if "compensation" in one], f"compensation was not followed: {clean['not_checked']}")
    found = s.post("/gouge", order | {"program": faulty})
    expect([one["line"] for one in found["findings"]] == [FAULT_LINE], f"the fault of line {FAULT_LINE}: {found['findings']}")
    expect(abs(found["findings"][0]["value"] - 2.5) < 1e-9, f"its depth: {found['findings']}")
    (s.folder / "faulty.nc").write_text(FAULTY)
    printed = s.by_command("gouge", s.folder / "faulty.nc", "--nominal", GOUGE / "pocket.family", "--machine", s.profiles["mill"], code=1)
    expect(printed == found, f"the command says {printed}, the server {found}")
    s.svg("/gouge?plot=stock", order | {"program": faulty}, [f"line {FAULT_LINE}"])
    s.refuse(422, "POST", "/gouge?plot=feed", order, words=["stock"])
    s.refuse(400, "POST", "/gouge?picture=stock", order)
    return order | {"program": faulty}


def checks_with_nominal(s, faulty):
    verdict = s.post("/checks", faulty)
    expect(verdict["verdict"] == "fail" and verdict["gouge"]["findings"][0]["line"] == FAULT_LINE, f"{verdict}")
    expect(any("pocket-with-slot, revision 1" in one for one in verdict["not_checked"]), "whose nominal it was is not kept")
    s.refuse(422, "POST", "/checks", faulty | {"nominal": {"family": "pocket-with-slot", "values": {"nothing": "1 mm"}}})
    printed = s.by_command("check", s.folder / "faulty.nc", "--nominal", GOUGE / "pocket.family", "--machine", s.profiles["mill"], code=1)
    expect(printed["files"][0]["gouge"] == verdict["gouge"], "the command finds something else than the server")
    answers = [s.call("POST", "/gouge?plot=stock", faulty, headers={"Idempotency-Key": "once"}) for _ in range(2)]
    expect(answers[0].body == answers[1].body and answers[1].headers["Content-Type"] == "image/svg+xml", "a repeated picture is another")


def a_line_later(figures):
    """The server's text names the family's revision in a line of its own, which the command's does not know; the command's figures name the
    family's lines, too."""
    if not isinstance(figures, dict):
        return figures
    return {name: value + 1 if name == "max_at_line" else a_line_later(value) for name, value in figures.items() if name != "max_at_family_line"}


def a_macro_made_faster(s):
    """The order's optimize: the answer says what it gained, and the profile's lines follow the text."""
    order = {"family": "hyperbolic-roll", "machine": "lathe", "mode": "macro", "delivery": "memory", "optimize": True}
    faster = s.post("/render", order)
    expect(" ms instead of " in faster["because"], f"{faster['because']}")
    figures = s.post("/accuracy", {"program": faster["program"], "machine": "lathe"})
    expect(0 < figures["max_mm"] < 0.0005, f"{figures}")
    blocks = s.post("/render", order | {"mode": "explicit"})
    expect("not optimized: plain blocks have nothing to compute" in blocks["because"], f"{blocks['because']}")
    s.refuse(422, "POST", "/render", order | {"optimize": "yes"}, words=["/optimize"])


def accuracy_of_a_roll(s):
    roll = s.post("/render", {"family": "hyperbolic-roll", "machine": "lathe", "values": {}, "mode": "explicit", "name": "O0100"})["program"]
    order = {"program": roll, "machine": "lathe"}
    s.refuse(422, "POST", "/accuracy", order | {"nominal": {"family": "hyperbolic-roll"}}, words=["/nominal"])
    figures = s.post("/accuracy", order)
    printed = s.by_command("accuracy", "hyperbolic-roll", "--machine", s.profiles["lathe"], "--mode", "explicit", "--name", "O0100", "--drip")
    expect(figures == a_line_later(printed), f"the command says {printed}, the server {figures}")
    expect(0 < figures["max_mm"] <= figures["chord_bound_mm"] < 0.0005, f"{figures}")
    # Points of the hyperbola, all of them 0.02 mm along z and 0.05 mm along the radius from their places.
    rows = [(2 * (100 * math.sqrt(1 + (z / 202.4) ** 2) + 0.05), z + 0.02) for z in range(-90, 91, 10)]
    csv = "x,z\n" + "".join(f"{x:.6f},{z:.6f}\n" for x, z in rows)
    cmm = s.post("/accuracy", order | {"cmm": csv, "best_fit": True})["cmm"]
    expect(cmm["points"] == 19 and 0.04 < cmm["rmse_mm"] < 0.06, f"{cmm}")
    expect(cmm["best_fit"]["rmse_mm"] < 1e-5, f"{cmm}")
    expect(abs(cmm["best_fit"]["shift_mm"][0] + 0.02) < 1e-3 and abs(cmm["best_fit"]["shift_mm"][1] + 0.05) < 1e-3, f"{cmm}")
    s.refuse(422, "POST", "/accuracy", order | {"cmm": "a,b\n1,2\n"})
    s.svg("/accuracy?plot=deviation", order)
    return order


def times(s, order):
    fed = s.post("/timing", order | {"delivery": "drip", "baud": 1200})
    quick = s.post("/timing", order | {"delivery": "drip"})
    expect(fed["line_s"] > 7 * quick["line_s"] > 0 and fed["cycle_s"] > 0, f"{fed['line_s']} s at 1200 baud, {quick['line_s']} s at 9600")
    s.svg("/timing?plot=feed", order)
    s.svg("/timing?plot=buffer", order | {"delivery": "drip"}, ["bytes"])


def sweeps(s, timed):
    order = {"family": "hyperbolic-roll", "machine": "lathe", "values": FIXED, "samples": SAMPLES, "seed": 3, "mode": "explicit", "delivery": "memory"}
    answers, others, refused = [], 0, 0
    worker = threading.Thread(target=lambda: answers.append(s.call("POST", "/sweep", order, "programmer")))
    worker.start()
    time.sleep(0.2)  # its request is the first
    while worker.is_alive():  # the pool works, the server answers: lists, checks, and that one sweep is enough
        s.post("/timing", timed)
        second = s.call("POST", "/sweep", order | {"samples": 0}, "programmer")
        refused += second.status == 409
        others += worker.is_alive()
    expect(answers[0].status == 200 and others > 0 and refused > 0, f"{others} other answers, {refused} refusals; {answers[0]}")
    report = answers[0].document
    printed = s.by_command("sweep", "hyperbolic-roll", "--machine", s.profiles["lathe"], "--samples", SAMPLES, "--seed", 3, "--mode", "explicit",
                        *[word for name, value in FIXED.items() for word in ("--set", f"{name}={value}")])
    expect(report == printed, f"the command says {printed}, the server {report}")
    expect([one["name"] for one in report["parameters"]] == ["angle_step", "speed_rpm"], f"{report['parameters']}")
    bounded = [side for one in report["parameters"] for side in (one["low_bound"], one["high_bound"]) if side]
    expect(bounded and all(side["check"] and side["text"] for side in bounded), f"nothing bounds: {report}")
    smallest = report["smallest_failure"]
    expect(len(smallest["changed"]) == 1 and smallest["check"], f"{smallest}")
    s.svg("/sweep?plot=region", order, ["angle_step", smallest["check"]])


def long_work_ends_with_the_server(s):
    def sweep():
        try:
            s.call("POST", "/sweep", {"family": "round-pocket", "machine": "other-mill", "samples": 1000})
        except OSError:
            pass  # the server went first
    s.post("/families", {"text": (shop.ROOT / "deploy/families/round-pocket.family").read_text()})
    worker = threading.Thread(target=sweep)
    worker.start()
    time.sleep(0.3)
    expect(worker.is_alive(), "the sweep is too short for this test")
    s.server.stop()
    worker.join(30)
    expect(not worker.is_alive(), "the sweep's caller still waits")


def all_of_it(folder):
    s = Shop(folder)
    checks_with_nominal(s, gouges(s))
    roll = accuracy_of_a_roll(s)
    a_macro_made_faster(s)
    times(s, roll)
    sweeps(s, roll)
    expect(s.server.alive(), "the server is gone")
    long_work_ends_with_the_server(s)


if __name__ == "__main__":
    in_folder(all_of_it)
    sys.exit(0)
