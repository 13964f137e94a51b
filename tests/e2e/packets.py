"""Packet protocols with the real binary: lrzsz at the other end of a pseudo-terminal (our sender to rx and rb, our receiver of sx and sb, the
simulated control as a receiver of sx), and our sender to our simulated controls. The bytes are compared; what fills the last block is not text."""

import contextlib
import json
import shutil
import signal
import subprocess
import time

from rig import Rig, binary, expect, in_folder, plain_program, shop

SPEED = "baud=115200"


@contextlib.contextmanager
def peer(folder, command, where=None, after=0):
    """A program of lrzsz with its two pipes at the other end of a pseudo-terminal; the path of our end. rx and rb ask every 10 s, and what they asked
    before our arming starts nothing, so they begin some seconds `after`."""
    link = folder / "line"
    socat = subprocess.Popen(["socat", f"PTY,link={link},raw,echo=0", f"SYSTEM:sleep {after}; {command}"], stderr=subprocess.DEVNULL, cwd=where)
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
    for protocol, command in [("xmodem", "rx"), ("xmodem-1k", "rx -c")]:
        target = folder / "got"
        with peer(folder, f"{command} {target}", after=1) as link:
            sent = send(path, f"pty:{link}?protocol={protocol}&{SPEED}")
            expect(sent.returncode == 0, f"{protocol} to {command}: {sent.stderr}")
        expect_text(path, target.read_bytes(), f"{protocol} to {command}")
        reported = json.loads(sent.stdout)
        expect(reported["confirmed"] == reported["bytes"] == path.stat().st_size, f"{protocol}: {reported}")
        target.unlink()


def lrzsz_takes_a_batch(folder):
    """YMODEM carries the name and the length: rb makes a file of that name and cuts what fills the last block."""
    path = program(folder)
    received = folder / "received"
    received.mkdir()
    with peer(folder, "rb -q", received, after=1) as link:
        sent = send(path, f"pty:{link}?protocol=ymodem&{SPEED}")
        expect(sent.returncode == 0, f"ymodem to rb: {sent.stderr}")
    files = list(received.iterdir())
    expect([file.name.upper() for file in files] == ["O0042.NC"], f"rb made {files}")
    expect(files[0].read_bytes() == path.read_bytes(), "rb has another text, or not its length")
    reported = json.loads(sent.stdout)
    expect(reported["confirmed"] == reported["bytes"] == path.stat().st_size, f"ymodem: {reported}")


def receive(link, output, *arguments):
    command = [binary(), "receive", "--json", "--timeout", "30", "-o", output, "--link", link, *arguments]
    return subprocess.run(list(map(str, command)), capture_output=True, text=True, timeout=60)


def lrzsz_punches_and_we_receive(folder):
    """sx and sb are the control that punches; the text arrives as it is, without what filled the last block."""
    path = program(folder)
    for protocol, command in [("xmodem", "sx"), ("xmodem-crc", "sx"), ("xmodem-1k", "sx -k"), ("ymodem", "sb"), ("ymodem", "sb -k")]:
        with peer(folder, f"{command} -q {path}") as link:
            done = receive(f"pty:{link}?protocol={protocol}&{SPEED}", folder / "got.nc")
        expect(done.returncode == 0, f"{protocol} from {command}: {done}")
        expect((folder / "got.nc").read_bytes() == path.read_bytes(), f"{protocol} from {command}: another text arrived")
        expect(json.loads(done.stdout)["name"] == "O0042", f"{done.stdout}")
        (folder / "got.nc").unlink()


def simulated_controls_punch_in_packets(folder):
    path = program(folder)
    for protocol in ["ymodem", "3964r", "remote-buffer-a"]:
        link, options = folder / f"punch-{protocol}", f"protocol={protocol}&{SPEED}"
        control = shop.Control(binary(), f"pty:{link}?{options}", "fanuc-0i-lathe", "--punch", path).start()
        done = receive(f"pty:{link}?{options}", folder / "got.nc")
        expect(done.returncode == 0, f"{protocol}: {done}")
        expect((folder / "got.nc").read_bytes() == path.read_bytes(), f"{protocol}: another text arrived")
        control.stop() if control.process.poll() is None else control.finish()


def what_breaks_is_kept_apart(folder):
    """A sender that is killed inside: named, and under no output's name. A batch of two files: the second is refused by name."""
    path = program(folder, 100_000)
    with peer(folder, f"timeout -s KILL 0.4 sx -q {path}") as link:
        done = receive(f"pty:{link}?protocol=xmodem&baud=9600", folder / "got.nc")
    expect(done.returncode == 1 and not (folder / "got.nc").exists(), f"{done}")
    small = folder / "O0043.nc"
    small.write_text(plain_program(3, "O0043"))
    program(folder)
    with peer(folder, f"sb -q {small} {path}") as link:
        done = receive(f"pty:{link}?protocol=ymodem&{SPEED}", folder / "got.nc")
    expect("a second file" in done.stderr, f"{done}")


def two_signals_end_a_transfer_that_is_not_answered(folder):
    """The receiver asks, takes a packet and says nothing more: the first signal waits for a block's end, the second ends the job by name and ends
    the receiver by CAN CAN."""
    path = program(folder)
    ours, theirs = folder / "ours", folder / "theirs"
    socat = subprocess.Popen(["socat", f"PTY,link={ours},raw,echo=0", f"PTY,link={theirs},raw,echo=0"], stderr=subprocess.DEVNULL)
    try:
        shop.wait_for("the pseudo-terminals", lambda: ours.exists() and theirs.exists())
        command = [binary(), "send", path, "--unreleased", "--json", "--ledger", folder / "ledger", "--link", f"pty:{ours}?protocol=xmodem&{SPEED}"]
        with open(folder / "said", "wb") as said, open(theirs, "r+b", buffering=0) as far:
            sender = subprocess.Popen(list(map(str, command)), stdout=subprocess.PIPE, stderr=said, text=True)
            reported = lambda words: words in (folder / "said").read_bytes()  # noqa: E731
            shop.wait_for("the arming", lambda: reported(b"waiting for the receiver's start"))
            far.write(b"\x15")
            came = b""
            while len(came) < 132:
                came += far.read(132 - len(came))
            shop.wait_for("the stall's name", lambda: reported(b"waiting for ACK"))
            sender.send_signal(signal.SIGINT)
            shop.wait_for("the first signal's answer", lambda: reported(b"stopping at the end of the block"))
            expect(sender.poll() is None, "the first signal ended it inside a block")
            sender.send_signal(signal.SIGINT)
            out, _ = sender.communicate(timeout=20)
            expect(far.read(8) == b"\x18" * 8, "the receiver was not cancelled")
        expect(sender.returncode == 3 and reported(b"person: the control may have between byte 0 and 128"), f"{(folder / 'said').read_bytes()} {out}")
    finally:
        socat.kill()
        socat.wait()


def a_server_feeds_a_batch(folder):
    """A released program over the server: rb makes a file of the program's own name."""
    ours, theirs, received = folder / "ours", folder / "theirs", folder / "received"
    received.mkdir()
    cable = subprocess.Popen(["socat", f"PTY,link={ours},raw,echo=0", f"PTY,link={theirs},raw,echo=0"], stderr=subprocess.DEVNULL)
    try:
        shop.wait_for("the pseudo-terminals", lambda: ours.exists() and theirs.exists())
        rig = Rig(folder, f"pty:{ours}?protocol=ymodem&{SPEED}", blocks=60, framing="8N1").start()
        job = rig.arm_new_job()
        subprocess.run(["socat", f"{theirs},raw,echo=0", "EXEC:rb -q"], stderr=subprocess.DEVNULL, cwd=received, timeout=60)
        rig.server.wait_job(job, "done")
        files = list(received.iterdir())
        expect([file.name.upper() for file in files] == ["O0042"], f"{files}")
        expect(files[0].read_bytes().strip(b"\0") == rig.text.encode(), "another text arrived, leader and trailer apart")
        rig.server.stop()
    finally:
        cable.kill()
        cable.wait()


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
    for protocol in ["xmodem", "xmodem-1k", "3964", "3964r", "3964r&counted=yes", "remote-buffer-a&payload=256", "ymodem"]:
        link = folder / f"sim-{protocol.replace('&', '-')}"
        options = f"protocol={protocol}&{SPEED}"
        control = shop.Control(binary(), f"pty:{link}?{options}", machine, "--speed", "40").start()
        sent = send(path, f"pty:{link}?{options}")
        report = control.finish()
        expect(sent.returncode == 0, f"{protocol}: {sent.stderr} {report}")
        reported = json.loads(sent.stdout)
        expect(reported["text_sha256"] == report["text_sha256"], f"{protocol}: another text arrived: {reported} {report}")
        expect(reported["confirmed"] == reported["bytes"], f"{protocol}: {reported}")
        expect(not report["alarm"] and report["holds"] > 0, f"{protocol}: {report}")


def what_cannot_be_is_refused(folder):
    path = program(folder)
    for options, word in [("protocol=xmodem&framing=7E2", "8 data bits"), ("protocol=xmodem&flow=xonxoff", "XON"), ("protocol=kermit", "xmodem")]:
        sent = send(path, f"pty:{folder}/nowhere?{options}")
        expect(sent.returncode == 2 and word in sent.stderr, f"{options}: {sent.returncode} {sent.stderr}")


if __name__ == "__main__":
    expect(shutil.which("rx") and shutil.which("socat"), "lrzsz or socat is not installed: deploy/install test")
    for test in [what_cannot_be_is_refused, lrzsz_receives_what_we_send, lrzsz_takes_a_batch, lrzsz_punches_and_we_receive, simulated_controls_punch_in_packets,
                 what_breaks_is_kept_apart, two_signals_end_a_transfer_that_is_not_answered, a_server_feeds_a_batch,
                 we_receive_what_lrzsz_sends, simulated_controls_read_in_packets]:
        in_folder(test)
