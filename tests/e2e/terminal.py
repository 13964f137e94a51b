"""A person at a terminal program in the place of a control: picocom on a pseudo-terminal, driven by its keyboard. Ctrl-Q is DC1, Ctrl-S is DC3,
Ctrl-R is DC2, Ctrl-T is DC4; what picocom logs is what came over the line."""

import contextlib
import hashlib
import json
import os
import pty
import select
import shutil
import signal
import subprocess
import threading
import time

from rig import binary, expect, in_folder, plain_program, shop

LINE = "baud=9600&framing=8N1&code=ascii"
DC1, DC2, DC3, DC4 = b"\x11", b"\x12", b"\x13", b"\x14"


@contextlib.contextmanager
def line(folder):
    """Two ends of a cable."""
    ours, theirs = folder / "ours", folder / "theirs"
    socat = subprocess.Popen(["socat", f"PTY,link={ours},raw,echo=0", f"PTY,link={theirs},raw,echo=0"], stderr=subprocess.DEVNULL)
    try:
        shop.wait_for("the pseudo-terminals of socat", lambda: ours.exists() and theirs.exists())
        yield ours, theirs
    finally:
        socat.kill()
        socat.wait()


class Terminal:
    """picocom with a keyboard and a screen; no person looks at the screen, but it must be read."""

    def __init__(self, device, log):
        self.log = log
        self.child, self.keyboard = pty.fork()
        if self.child == 0:
            command = ["picocom", "-q", "-b", "9600", "-f", "n", "--noreset", "--nolock", "-g", str(log), str(device)]
            os.execvp(command[0], command)
        self.screen = threading.Thread(target=self._read, daemon=True)
        self.screen.start()
        shop.wait_for("picocom's log", log.exists)

    def _read(self):
        with contextlib.suppress(OSError):
            while os.read(self.keyboard, 4096):
                pass

    def type(self, keys):
        select.select([], [self.keyboard], [], 5.0)
        os.write(self.keyboard, keys)

    def logged(self):
        return self.log.read_bytes()

    def close(self):
        os.kill(self.child, signal.SIGTERM)
        os.waitpid(self.child, 0)


def stands_still(terminal, seconds=0.7):
    """What has come, once nothing more comes."""
    size, since = -1, time.monotonic()
    while time.monotonic() < since + seconds:
        now = len(terminal.logged())
        if now != size:
            size, since = now, time.monotonic()
        time.sleep(0.02)
    return size


def a_person_reads_a_program(folder):
    path = folder / "O0042.nc"
    path.write_text(plain_program(60))
    with line(folder) as (ours, theirs):
        terminal = Terminal(theirs, folder / "log")
        said = open(folder / "said", "wb")
        command = [binary(), "send", path, "--unreleased", "--json", "--ledger", folder / "ledger", "--link", f"pty:{ours}?{LINE}"]
        sender = subprocess.Popen(list(map(str, command)), stdout=subprocess.PIPE, stderr=said)
        reported = lambda words: words in (folder / "said").read_bytes()  # noqa: E731
        shop.wait_for("the arming", lambda: reported(b"waiting for DC1"))
        expect(terminal.logged() == b"", f"something came before it was asked for: {terminal.logged()}")
        terminal.type(DC1)
        shop.wait_for("the first characters", lambda: len(terminal.logged()) > 300)
        terminal.type(DC3)
        held = stands_still(terminal)
        expect(reported(b"held by DC3"), f"held, and not said so: {(folder / 'said').read_bytes()}")
        expect(held < path.stat().st_size and sender.poll() is None, "the hold came too late to test anything")
        terminal.type(DC1)
        shop.wait_for("the end of the text", lambda: terminal.logged().rstrip(b"\r\n\0").endswith(b"M30\n%"))
        stands_still(terminal)
        terminal.type(DC3)
        out, _ = sender.communicate(timeout=30)
        said.close()
        document = json.loads(out)
        expect(sender.returncode == 0, f"{sender.returncode}: {(folder / 'said').read_bytes()}")
        expect(document["holds"] >= 1, f"{document}")
        expect(terminal.logged() == path.read_bytes(), "another text came over the line")
        expect(hashlib.sha256(terminal.logged()).hexdigest() == document["wire_sha256"], f"{document}")
        terminal.close()


def a_person_punches_a_program(folder):
    with line(folder) as (ours, theirs):
        terminal = Terminal(theirs, folder / "log")
        command = [binary(), "receive", "--json", "--timeout", "20", "-o", folder / "typed.nc", "--link", f"pty:{ours}?{LINE}"]
        receiver = subprocess.Popen(list(map(str, command)), stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        time.sleep(1.0)
        for keys in (DC2, b"%\n", b"O0007\n", b"G0X1.\n", b"M30\n", b"%\n", DC4):
            terminal.type(keys)
            time.sleep(0.05)
        out, error = receiver.communicate(timeout=30)
        expect(receiver.returncode == 0, f"{receiver.returncode}: {error}")
        expect((folder / "typed.nc").read_text() == "%\nO0007\nG0X1.\nM30\n%\n", f"{(folder / 'typed.nc').read_bytes()} {out}")
        terminal.close()


if __name__ == "__main__":
    expect(shutil.which("picocom") and shutil.which("socat"), "picocom or socat is not installed: deploy/install test")
    for test in [a_person_reads_a_program, a_person_punches_a_program]:
        in_folder(test)
