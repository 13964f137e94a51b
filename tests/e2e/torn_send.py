"""dripfeed send leaves a torn block, by whatever cause: it says so in words, in JSON and by its exit code; nothing goes out on that line
afterward, whatever ledger the next one has, until a person confirms the reset; and a line has one user at a time."""

import contextlib
import json
import os
import pty
import resource
import signal
import subprocess
import threading
import time
import tty

from rig import binary, expect, in_folder, plain_program, sends, shop

DONE, FAILED, WRONG_USE, TORN = 0, 1, 2, 3
LINE = "baud=9600&framing=8N1&code=ascii"
DC1, DC3 = b"\x11", b"\x13"


class HandControl:
    """A control by hand on a pseudo-terminal: it takes what comes, and asks for it when the test says so."""

    def __init__(self, path):
        self.path = path
        self.got = bytearray()
        self.master, slave = pty.openpty()
        tty.setraw(slave)
        with contextlib.suppress(FileNotFoundError):
            os.unlink(path)
        os.symlink(os.ttyname(slave), path)
        self.slave = slave  # held open: the master of a pty without a slave reads EIO
        self.reader = threading.Thread(target=self._read, daemon=True)
        self.reader.start()

    def _read(self):
        with contextlib.suppress(OSError):
            while chunk := os.read(self.master, 4096):
                self.got += chunk

    def say(self, characters):
        os.write(self.master, characters)

    def wait_for(self, count):
        shop.wait_for(f"{count} bytes at the control", lambda: len(self.got) >= count)

    def hold_inside_block(self):
        """Says DC3 so that the last character that came is inside a block, whatever the timing is."""
        for _ in range(20):
            self.wait_for(len(self.got) + 5)
            self.say(DC3)
            time.sleep(0.3)
            if self.got[-1:] != b"\n":
                return
            self.say(DC1)
        raise AssertionError("every hold came at a block end")


def program_in(folder, blocks=400):
    path = folder / "O0042.nc"
    path.write_text(plain_program(blocks))
    return path


def ended(process, code, *words, seconds=30):
    """The JSON document of a command that ended as expected; None where it printed none."""
    out, error = process.communicate(timeout=seconds)
    expect(process.returncode == code, f"exit {process.returncode}, not {code}: {error}")
    for word in words:
        expect(word in error, f"{word!r} is not in {error!r}")
    return json.loads(out) if out else None


def refuses_until_confirmed(folder, url, words):
    """The next ones on a torn line, each with a ledger of its own."""
    control = HandControl(folder / "line.tty") if url.startswith("pty:") else None
    program = program_in(folder, 40)
    document = ended(sends(program, url), TORN, "Nothing was sent", "--confirm-reset", *words)
    expect(document["torn"] is True and document["line"]["state"] in ("torn", "sending"), f"{document}")
    receiving = subprocess.Popen([binary(), "receive", "--link", url, "-o", folder / "got.nc", "--timeout", "1"], stderr=subprocess.PIPE, text=True)
    ended(receiving, TORN, *words)
    testing = subprocess.Popen([binary(), "link", "test", "--link", url], stderr=subprocess.PIPE, text=True)
    ended(testing, TORN, *words)
    ended(sends(program, url, "--confirm-reset", " "), WRONG_USE, "needs a reason")
    ended(sends(program, url), TORN)
    if control is None:
        return
    expect(bytes(control.got) == b"", f"{bytes(control.got)} came on a torn line")
    sending = sends(program, url, "--confirm-reset", "RESET pressed, slide clear")
    time.sleep(0.5)
    control.say(DC1)
    control.wait_for(len(program.read_bytes()))
    control.say(DC3)
    document = ended(sending, DONE, "the reset is confirmed")
    expect(document["torn"] is False and document["line"]["state"] == "clean", f"{document}")
    expect(bytes(control.got) == program.read_bytes(), "another text came over the line")
    # It is over for good: the next one needs no words.
    waiting = sends(program, url)
    time.sleep(0.3)
    waiting.send_signal(signal.SIGTERM)
    ended(waiting, FAILED)


def killed(folder):
    url = f"pty:{folder}/line.tty?{LINE}"
    control = HandControl(folder / "line.tty")
    sending = sends(program_in(folder), url)
    time.sleep(0.5)
    control.say(DC1)
    control.wait_for(500)
    sending.kill()
    sending.communicate()
    refuses_until_confirmed(folder, url, ["O0042.nc", "ended without a report of how"])


def killed_while_it_waits(folder):
    """Nothing left before the control asked for it, and the record knows that."""
    url = f"pty:{folder}/line.tty?{LINE}"
    control = HandControl(folder / "line.tty")
    program = program_in(folder, 20)
    sending = sends(program, url)
    time.sleep(1.0)
    sending.kill()
    sending.communicate()
    expect(bytes(control.got) == b"", f"{bytes(control.got)} came before it was asked for")
    sending = sends(program, url)
    time.sleep(0.7)
    control.say(DC1)
    control.wait_for(len(program.read_bytes()))
    control.say(DC3)
    ended(sending, DONE)


def stopped_at_once(folder):
    url = f"pty:{folder}/line.tty?{LINE}"
    control = HandControl(folder / "line.tty")
    sending = sends(program_in(folder), url)
    time.sleep(0.5)
    control.say(DC1)
    control.wait_for(500)
    control.hold_inside_block()
    sending.send_signal(signal.SIGTERM)
    time.sleep(0.3)
    sending.send_signal(signal.SIGTERM)
    document = ended(sending, TORN, "a block is torn at the control", "--confirm-reset")
    expect(document["torn"] is True and document["line"]["state"] == "torn", f"{document}")
    refuses_until_confirmed(folder, url, ["O0042.nc", "broke off inside a block"])


def unplugged(folder):
    port = shop.free_port()
    url = f"tcp://127.0.0.1:{port}"
    machine = folder / "lathe.json"
    profile = shop.preset("fanuc-0i-lathe", url=url, baud=9600, framing="7E2", end_by_quiet_s=2.0)
    machine.write_text(json.dumps(profile))
    control = shop.Control(binary(), f"tcp-listen://127.0.0.1:{port}", machine, "--operator", "0.3", "--fault", "cut=1503").start()
    document = ended(sends(program_in(folder), url, "--machine", machine), TORN, "a block is torn at the control")
    control.finish(20)
    expect(document["torn"] is True and document["line"]["state"] == "torn", f"{document}")
    expect(document["line"]["what"].endswith("O0042.nc") and "send" in document["line"]["by"], f"{document}")
    # Whether a device server speaks Telnet there changes nothing: it is the same port.
    refuses_until_confirmed(folder, f"rfc2217://localhost:{port}?baud=9600&framing=7E2", ["O0042.nc", "broke off inside a block"])


def no_room_for_the_ledger(folder):
    """The ledger of a transfer cannot be written any more: it stops at once, and that it left a torn block is in the line's record, which needs no room."""
    url = f"pty:{folder}/line.tty?{LINE}"
    control = HandControl(folder / "line.tty")
    sending = sends(program_in(folder, 2000), url)
    time.sleep(0.5)
    resource.prlimit(sending.pid, resource.RLIMIT_FSIZE, (5200, 5200))  # the record is written in place, below it; the ledger grows
    control.say(DC1)
    document = ended(sending, TORN, "stopping at once", "a block is torn at the control", seconds=60)  # the limit may lie inside a row or between two
    expect(document["torn"] is True and document["line"]["state"] == "torn", f"{document}")
    last = (folder / next(name for name in os.listdir(folder) if name.endswith(".ledger"))).read_text().splitlines()[-2].split()
    time.sleep(0.3)
    expect(int(last[2]) <= len(control.got) <= int(last[4]), f"{len(control.got)} bytes arrived, the ledger says {last}")
    refuses_until_confirmed(folder, url, ["O0042.nc", "broke off inside a block"])


def two_at_once(folder):
    url = f"pty:{folder}/line.tty?{LINE}"
    HandControl(folder / "line.tty")
    program = program_in(folder)
    first = sends(program, url)
    time.sleep(0.5)
    second = sends(program, f"{url}&latency_chars=2")
    ended(second, FAILED, "is in use by", f"(pid {first.pid})", "dripfeed send")
    receiving = subprocess.Popen([binary(), "receive", "--link", url, "-o", folder / "got.nc"], stderr=subprocess.PIPE, text=True)
    ended(receiving, FAILED, "is in use by", f"(pid {first.pid})")
    first.send_signal(signal.SIGTERM)
    ended(first, FAILED)


if __name__ == "__main__":
    for test in [killed, killed_while_it_waits, stopped_at_once, unplugged, no_room_for_the_ledger, two_at_once]:
        in_folder(test)
