"""What a control punches, with the real binary at both ends: a simulated control punches into a server, asks it for its list and for a program;
a torn punch; `dripfeed receive` without a server; and a person who types at the other end of a pseudo-terminal."""

import json
import os
import pty
import subprocess
import sys
import time

from rig import Rig, binary, expect, in_folder, plain_program, shop


def punch(rig, text, *arguments):
    """A simulated control comes up on the line, punches and goes; its report."""
    file = rig.folder / "punch.nc"
    file.write_text(text)
    return rig.control("--punch", str(file), *arguments).finish(60)


def receipts(rig, count):
    return shop.wait_for(f"{count} receipts", lambda: (lambda items: items if len(items) == count else None)(rig.server.get("/receipts")["items"]), 30)


def a_server_receives(folder):
    rig = Rig(folder, f"tcp://127.0.0.1:{shop.free_port()}", blocks=20, baud=19200)
    rig.profile["receive"] = {"quiet_s": 1.0}
    rig.start()
    punch(rig, "%\nO0077(BUSH)\nG0X1.\nM30\n%\n")
    first = receipts(rig, 1)[0]
    expect((first["state"], first["name"], first["code"]) == ("stored", "O0077", "iso"), f"{first}")
    text = rig.server.request("GET", f"/api/v1/receipts/{first['id']}/text", text=True)
    expect(text == b"%\nO0077(BUSH)\nG0X1.\nM30\n%\n", f"{text}")
    punch(rig, "%\nO0078\nG0X1")
    torn = receipts(rig, 2)[0]
    expect(torn["state"] == "quarantined" and torn["reason"], f"{torn}")
    for words, told in [("DIR", "(O0042 DNC)"), ("LOAD 4711", "(NOT FOUND 4711)")]:
        record = rig.folder / "answer.nc"
        report = punch(rig, f"%\nO9999({words})\n%\n", "--then-read", "--record", str(record))
        answer = bytes(byte & 0x7F for byte in record.read_bytes()).decode()
        expect(not report["alarm"] and told in answer, f"{report} {answer!r}")
    load(rig)
    rig.server.stop()


def load(rig):
    program = rig.server.get("/programs?name=O0042")["items"][0]["id"]
    rig.server.post("/checks", {"program": program, "machine": "lathe", "delivery": "memory"})
    rig.server.release(program, "lathe", "memory")
    record = rig.folder / "loaded.nc"
    report = punch(rig, "%\nO9999(LOAD 42)\n%\n", "--then-read", "--speed", "1000", "--record", str(record))
    loaded = bytes(byte & 0x7F for byte in record.read_bytes()).decode().strip("\0")
    expect(not report["alarm"] and loaded == plain_program(20), f"{report} {loaded!r}")


def one_transfer_without_a_server(folder):
    url = f"127.0.0.1:{shop.free_port()}"
    for text, code, name in [("%\nO5\nM30\n%\n", 0, "out.nc"), ("%\nO5\nM30\n", 1, "torn.nc")]:
        (folder / "in.nc").write_text(text)
        control = shop.Control(binary(), f"tcp-listen://{url}", "fanuc-0i-lathe", "--punch", str(folder / "in.nc")).start()
        done = subprocess.run([str(binary()), "receive", "--link", f"tcp://{url}", "--machine", "fanuc-0i-lathe", "-o", str(folder / name), "--timeout", "20", "--json"],
                              capture_output=True, text=True, timeout=60)
        control.stop() if control.process.poll() is None else control.finish()
        expect(done.returncode == code, f"{done}")
        document = json.loads(done.stdout)
        expect(document["whole"] == (code == 0) and document["name"] == "O5", f"{document}")
        kept = folder / (name if code == 0 else name + ".quarantine")
        expect(bytes(byte & 0x7F for byte in kept.read_bytes()).strip(b"\0") == text.encode(), f"{kept.read_bytes()}")
    expect(not (folder / "torn.nc").exists(), "a torn program lies under the output's name")


def a_person_types(folder):
    master, slave = pty.openpty()
    command = [str(binary()), "receive", "--link", f"serial:{os.ttyname(slave)}?baud=9600&framing=8N1", "-o", str(folder / "typed.nc"), "--timeout", "20"]
    receiver = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    time.sleep(1.0)
    for line in (b"G0 X1.\r", b"M30\r"):
        os.write(master, line)
        time.sleep(0.3)
    receiver.communicate(timeout=30)
    os.close(slave)
    os.close(master)
    expect(receiver.returncode == 0 and (folder / "typed.nc").read_bytes() == b"G0 X1.\nM30\n", "what was typed did not arrive")


if __name__ == "__main__":
    in_folder(one_transfer_without_a_server)
    in_folder(a_person_types)
    in_folder(a_server_receives)
    sys.exit(0)
