"""What the end-to-end tests share: a server with one lathe on a pseudo-terminal or a TCP port, and a program that is released for it. The tests
themselves are the other files of this folder; each is a ctest entry."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "deploy"))
import shop  # noqa: E402


def binary():
    return pathlib.Path(sys.argv[1]).resolve()


def sends(program, url, *arguments, ledger=None, **streams):
    """dripfeed send, running: JSON on its stdout, words on its stderr."""
    ledger = ledger or pathlib.Path(program).parent / f"{time.monotonic_ns()}.ledger"
    command = [binary(), "send", program, "--unreleased", "--json", "--link", url, "--ledger", ledger, *arguments]
    return subprocess.Popen(list(map(str, command)), **{"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True, **streams})


def verify(data, whole=True):
    """What dripfeed ledger verify says of a server's folder, running or not. Fails where that is not whole."""
    done = subprocess.run([str(binary()), "ledger", "verify", str(data), "--json"], capture_output=True, text=True, timeout=120)
    document = json.loads(done.stdout) if done.stdout else None
    expect(done.returncode == (0 if whole else 1), f"ledger verify ended with {done.returncode}: {done.stderr} {document}")
    return document


def expect(condition, sentence):
    if not condition:
        raise AssertionError(sentence)


def plain_program(blocks, name="O0042"):
    """A drip-feedable Fanuc lathe text: a finishing cut in many short moves."""
    lines = ["%", name, "G21 G18 G40 G99", "G55", "T0101", "G97 S500 M03", "G00 X100. Z10."]
    for i in range(blocks):
        lines.append(f"G01 X{50 + (i % 7) * 0.1:.3f} Z{-(i % 4000) * 0.05:.3f} F0.2")
    lines += ["G00 X100.", "M05", "M30", "%"]
    return "\n".join(lines) + "\n"


class Rig:
    """A server with one machine, `lathe`, and one released program of `blocks` blocks for it."""

    def __init__(self, folder, url, blocks=400, baud=9600, framing="7E2"):
        self.folder = pathlib.Path(folder)
        self.url = url
        self.profile = shop.preset("fanuc-0i-lathe", url=url, baud=baud, framing=framing, end_by_quiet_s=2.0)
        self.profile["name"] = "lathe"
        self.profile["buffer"]["bytes"] = 1024
        self.machine = self.folder / "lathe.json"
        self.machine.write_text(json.dumps(self.profile))
        self.server = shop.Server(binary(), self.folder / "data")
        self.text = plain_program(blocks)

    def start(self):
        self.server.start()
        self.server.add_machine(self.profile)
        program = self.server.post("/programs", {"name": "O0042", "dialect": "fanuc", "text": self.text})
        check = self.server.post("/checks", {"program": program["id"], "machine": "lathe", "delivery": "drip"})
        expect(check["verdict"] in ("pass", "warn"), f"verdict {check['verdict']}: {json.dumps(check)[:2000]}")
        self.release = self.server.release(program["id"], "lathe")
        return self

    def control(self, *arguments):
        link = self.url if self.url.startswith("pty:") else self.url.replace("tcp://127.0.0.1", "tcp-listen://127.0.0.1")
        return shop.Control(binary(), link, self.machine, "--operator", "0.5", *arguments).start()

    def arm_new_job(self):
        job = self.server.post("/jobs", {"release": self.release["id"]})["id"]
        self.server.wait_line("lathe", "idle")
        self.server.post(f"/jobs/{job}/arm", {})
        return job


def in_folder(test):
    with tempfile.TemporaryDirectory(prefix="dripfeed-e2e-", ignore_cleanup_errors=True) as folder:
        os.environ["DRIPFEED_LINES"] = f"{folder}/lines"  # the records of this test's lines end with it
        test(pathlib.Path(folder))
    print(f"ok {test.__name__}")
