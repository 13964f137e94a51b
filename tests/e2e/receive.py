"""What a control punches, with the real binary at both ends: a simulated control punches into a server, asks it for its list and for a program;
a torn punch; `dripfeed receive` without a server; and a person who types at the other end of a pseudo-terminal."""

import json
import os
import pty
import socket
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
    for words, answered in [("DIR", "(O0042 DNC)"), ("LOAD 4711", "(NOT FOUND 4711)")]:
        record = rig.folder / "answer.nc"
        report = punch(rig, f"%\nO9999({words})\n%\n", "--then-read", "--record", str(record))
        answer = bytes(byte & 0x7F for byte in record.read_bytes()).decode()
        expect(not report["alarm"] and answered in answer, f"{report} {answer!r}")
    load(rig)
    rig.server.stop()


def eia_reaches_a_server(folder):
    rig = Rig(folder, f"tcp://127.0.0.1:{shop.free_port()}", blocks=20, baud=19200, framing="8N2")
    rig.profile["link"]["code"] = "eia"
    rig.profile["receive"] = {"quiet_s": 1.0}
    rig.machine.write_text(json.dumps(rig.profile))
    rig.start()
    punch(rig, "%\nO0356(BUSH)\nG0X135.6\nM30\n%\n")
    first = receipts(rig, 1)[0]
    expect((first["state"], first["name"], first["code"]) == ("stored", "O0356", "eia"), f"{first}")
    text = rig.server.request("GET", f"/api/v1/receipts/{first['id']}/text", text=True)
    expect(text == b"%\nO0356(BUSH)\nG0X135.6\nM30\n%\n", f"{text}")
    record = rig.folder / "answer.nc"
    report = punch(rig, "%\nO9999(DIR)\n%\n", "--then-read", "--record", str(record))
    expect(not report["alarm"] and bytes([0x1A, 0x46, 0x20, 0x20, 0x04, 0x02]) in record.read_bytes(), f"{report} {record.read_bytes()}")
    rig.server.stop()


def load(rig):
    program = rig.server.get("/programs?name=O0042")["items"][0]["id"]
    rig.server.post("/checks", {"program": program, "machine": "lathe", "delivery": "memory"})
    rig.server.release(program, "lathe", "memory")
    record = rig.folder / "loaded.nc"
    report = punch(rig, "%\nO9999(LOAD 42)\n%\n", "--then-read", "--speed", "1000", "--record", str(record))
    loaded = bytes(byte & 0x7F for byte in record.read_bytes()).decode().strip("\0")
    expect(not report["alarm"] and loaded == plain_program(20), f"{report} {loaded!r}")


def parts_are_counted(folder):
    """What a control counts goes to the order of the program that it got last, and nowhere else."""
    rig = Rig(folder, f"tcp://127.0.0.1:{shop.free_port()}", blocks=20, baud=19200)
    rig.profile["receive"] = {"quiet_s": 1.0}
    rig.start()
    order = rig.server.post("/orders", {"number": "4711", "part": "HUB-12", "quantity": 10, "machine": "lathe"})["id"]
    asked = []

    def count(words, outcome, detail):
        punch(rig, f"%\nO9999({words})\n%\n")
        asked.append(words)
        rows = shop.wait_for(f"{words} in the requests", lambda: (lambda rows: rows if len(rows) == len(asked) else None)(rig.server.get("/requests")["items"]))
        expect(rows[0]["outcome"] == outcome and detail in rows[0]["detail"], f"{words}: {rows[0]}")

    def feed(**of):
        control = rig.control()
        job = rig.server.post("/jobs", {"release": rig.release["id"]} | of)["id"]
        rig.server.wait_line("lathe", "idle")
        rig.server.post(f"/jobs/{job}/arm", {})
        rig.server.wait_job(job, "done")
        control.stop()

    count("PARTS 5", "refused", "nothing went to the machine yet")
    feed(order=order)
    count("PARTS 3", "answered", "order 4711: 3 good of 10, 0 scrap")
    count("SCRAP: 1", "answered", "order 4711: 3 good of 10, 1 scrap")
    count("PARTS 0", "refused", "use 1 to 100000")
    now = rig.server.get(f"/orders/{order}")
    expect((now["good"], now["scrap"], now["open"], now["transfers"]) == (3, 1, 7, 1), f"{now}")
    feed()
    count("PARTS 2", "refused", "is of no order")
    rig.server.post(f"/orders/{order}/move", {"to": "cancelled", "reason": "not wanted any more"})
    now = rig.server.get(f"/orders/{order}")
    expect((now["good"], now["scrap"]) == (3, 1), f"{now}")
    refused = [alarm["text"] for alarm in rig.server.get("/alarms")["items"] if alarm["kind"] == "request_failed"]
    expect(any("2 parts: not counted" in text for text in refused), f"{refused}")
    rig.server.stop()


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


def even(text):
    return bytes(c | 0x80 if bin(c).count("1") % 2 else c for c in text.encode())


def a_load_is_read_back_without_a_server(folder):
    text = "%\nO0042\nG00X1.\nM30\n%\n"
    (folder / "load.nc").write_text(text)
    for punched, code, result in [(text, 0, "equal"), (text.replace("X1.", "X7."), 1, "differs: line 3, column 5")]:
        with socket.create_server(("127.0.0.1", 0)) as server:
            command = [str(binary()), "send", str(folder / "load.nc"), "--link", f"tcp://127.0.0.1:{server.getsockname()[1]}", "--machine",
                       "fanuc-0i-lathe", "--unreleased", "--read-back", "--json", "--ledger", str(folder / f"ledger-{code}")]
            sender = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            server.settimeout(20)
            control = server.accept()[0]
            control.settimeout(1)
            got = b""
            while got.count(b"\xa5") < 2:
                if not got:
                    control.sendall(b"\x11")  # until the job is armed nothing answers it
                try:
                    got += control.recv(4096)
                except TimeoutError:
                    expect(sender.poll() is None, f"send is over: {sender.stderr.read() if sender.poll() is not None else ''}")
            control.sendall(b"\x93")
            while "waiting for read-back" not in sender.stderr.readline():
                expect(sender.poll() is None, "send did not wait for the punch")
            control.sendall(b"\x12" + even(punched) + b"\x14")
            out, _ = sender.communicate(timeout=30)
            control.close()
        expect(sender.returncode == code and json.loads(out)["read_back"].startswith(result), f"{sender.returncode} {out}")
        expect(f"read-back {result}" in (folder / f"ledger-{code}").read_text(), "the ledger does not say it")


def the_code_is_found(folder):
    """Punches in ISO, ASCII and EIA, with the same line at the receiver."""
    text = "%\nO3564\nG01X130.356Z-3.\nM30\n%\n"
    (folder / "in.nc").write_text(text)
    for code, framing in [("iso", "7E2"), ("ascii", "8N1"), ("eia", "8N2")]:
        port = shop.free_port()
        control = shop.Control(binary(), f"tcp-listen://127.0.0.1:{port}?framing={framing}&code={code}&eob=cr-lf", "fanuc-0i-lathe",
                               "--punch", str(folder / "in.nc")).start()
        command = [str(binary()), "receive", "--link", f"tcp://127.0.0.1:{port}?framing=8N1&code=auto", "--machine", "fanuc-0i-lathe",
                   "-o", str(folder / f"{code}.nc"), "--timeout", "20", "--json"]
        done = subprocess.run(command, capture_output=True, text=True, timeout=60)
        control.stop() if control.process.poll() is None else control.finish()
        expect(done.returncode == 0, f"{code}: {done}")
        document = json.loads(done.stdout)
        expect((document["whole"], document["code"], document["name"]) == (True, code, "O3564"), f"{document}")
        expect((folder / f"{code}.nc").read_text() == text, f"{code}: {(folder / f'{code}.nc').read_bytes()}")


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
    in_folder(the_code_is_found)
    in_folder(a_load_is_read_back_without_a_server)
    in_folder(a_person_types)
    in_folder(a_server_receives)
    in_folder(parts_are_counted)
    in_folder(eia_reaches_a_server)
    sys.exit(0)
