"""Packet protocols with the real binary: lrzsz at the other end of a pseudo-terminal (our sender to rx, the simulated control as a receiver of sx),
and our sender to our simulated controls. The bytes are compared; what fills the last block is not text."""

import contextlib
import json
import shutil
import subprocess
import time

from rig import binary, expect, in_folder, plain_program, shop

SPEED = "baud=115200"


@contextlib.contextmanager
def peer(folder, command):
    """A program of lrzsz with its two pipes at the other end of a pseudo-terminal; the path of our end."""
    link = folder / "line"
    socat = subprocess.Popen(["socat", f"PTY,link={link},raw,echo=0", f"EXEC:{command}"], stderr=subprocess.DEVNULL)
    try:
        shop.wait_for("the pseudo-terminal of socat", link.exists)
        yield link
        socat.wait(30)
    finally:
        socat.kill()
        socat.wait()


def program(folder, blocks=60):
    path = folder / "O0042.nc"
    path.write_text(plain_program(blocks))
    return path


def send(path, link, *arguments):
    command = [binary(), "send", path, "--unreleased", "--json", "--link", link, "--ledger", path.parent / f"{time.monotonic_ns()}.ledger", *arguments]
    return subprocess.run(list(map(str, command)), capture_output=True, text=True, timeout=120)


def expect_text(path, got, what):
    text = path.read_bytes()
    expect(got[: len(text)] == text and not got[len(text) :].strip(b"\x1a"), f"{what}: another text arrived")


def lrzsz_receives_what_we_send(folder):
    path = program(folder)
    # rx asks every 10 s, and what it asked before the arming starts nothing: two of the four pairs are enough here.
    for protocol, command in [("xmodem", "rx"), ("xmodem-1k", "rx -c")]:
        target = folder / "got"
        with peer(folder, f"{command} {target}") as link:
            sent = send(path, f"pty:{link}?protocol={protocol}&{SPEED}")
            expect(sent.returncode == 0, f"{protocol} to {command}: {sent.stderr}")
        expect_text(path, target.read_bytes(), f"{protocol} to {command}")
        told = json.loads(sent.stdout)
        expect(told["confirmed"] == told["bytes"] == path.stat().st_size, f"{protocol}: {told}")
        target.unlink()


def we_receive_what_lrzsz_sends(folder):
    path = program(folder)
    machine = folder / "machine.json"
    machine.write_text(json.dumps(shop.preset("fanuc-0i-lathe", url="pty:/nowhere")))
    for protocol, command in [("xmodem", "sx"), ("xmodem-crc", "sx"), ("xmodem-1k", "sx -k")]:
        link = folder / f"control-{protocol}"
        record = folder / f"{protocol}.record"
        control = shop.Control(binary(), f"pty:{link}?protocol={protocol}&{SPEED}", machine, "--record", str(record), "--speed", "10000").start()
        subprocess.run(["socat", f"{link},raw,echo=0", f"EXEC:{command} {path}"], stderr=subprocess.DEVNULL, timeout=60)
        report = control.finish()
        expect_text(path, record.read_bytes(), f"{protocol} from {command}")
        expect(not report["alarm"], f"{protocol}: {report}")


def simulated_controls_read_in_packets(folder):
    path = program(folder, 200)
    machine = folder / "machine.json"
    profile = shop.preset("fanuc-0i-lathe", url="pty:/nowhere")
    profile["buffer"]["bytes"] = 2048
    machine.write_text(json.dumps(profile))
    for protocol in ["xmodem", "xmodem-crc", "xmodem-1k", "3964", "3964r", "3964r&counted=yes", "remote-buffer-a&payload=256"]:
        link = folder / f"sim-{protocol.replace('&', '-')}"
        options = f"protocol={protocol}&{SPEED}"
        control = shop.Control(binary(), f"pty:{link}?{options}", machine, "--speed", "40").start()
        sent = send(path, f"pty:{link}?{options}")
        report = control.finish()
        expect(sent.returncode == 0, f"{protocol}: {sent.stderr} {report}")
        told = json.loads(sent.stdout)
        expect(told["text_sha256"] == report["text_sha256"], f"{protocol}: another text arrived: {told} {report}")
        expect(told["confirmed"] == told["bytes"], f"{protocol}: {told}")
        expect(not report["alarm"] and report["holds"] > 0, f"{protocol}: {report}")


def what_cannot_be_is_refused(folder):
    path = program(folder)
    for options, word in [("protocol=xmodem&framing=7E2", "8 data bits"), ("protocol=xmodem&flow=xonxoff", "XON"), ("protocol=kermit", "xmodem")]:
        sent = send(path, f"pty:{folder}/nowhere?{options}")
        expect(sent.returncode == 2 and word in sent.stderr, f"{options}: {sent.returncode} {sent.stderr}")


if __name__ == "__main__":
    expect(shutil.which("rx") and shutil.which("socat"), "lrzsz or socat is not installed: deploy/install test")
    for test in [what_cannot_be_is_refused, lrzsz_receives_what_we_send, we_receive_what_lrzsz_sends, simulated_controls_read_in_packets]:
        in_folder(test)
