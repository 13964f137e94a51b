"""The torn block outlives the server: kill -9 inside a block of a job, or inside an answer to the operator, and nothing goes out on that line
before a person confirms, whatever the control says. The control is this file's own: a socket that counts bytes."""

import socket
import sys
import threading
import time

from rig import Rig, expect, in_folder, shop, verify

DC1, DC3, DC2, DC4 = b"\x11", b"\x93", b"\x12", b"\x14"


def even(text):
    return bytes(c | 0x80 if bin(c).count("1") % 2 else c for c in text.encode())


def refusal(server, path):
    """What a request was refused with."""
    try:
        server.post(path, {})
    except shop.Refused as refused:
        return str(refused)
    raise AssertionError(f"{path} was not refused")


class OwnControl:
    """Listens; keeps every byte that comes, over all connections."""

    def __init__(self):
        self.listener = socket.create_server(("127.0.0.1", 0))
        self.port = self.listener.getsockname()[1]
        self.got, self.socket, self.ended = b"", None, False
        self.changed = threading.Condition()
        threading.Thread(target=self._serve, daemon=True).start()

    def _serve(self):
        while not self.ended:
            connection, _ = self.listener.accept()
            with self.changed:
                self.socket = connection
                self.changed.notify_all()
            try:
                while piece := connection.recv(65536):
                    with self.changed:
                        self.got += piece
                        self.changed.notify_all()
            except OSError:
                pass
            with self.changed:
                self.socket = None

    def text(self):
        with self.changed:
            return bytes(c & 0x7F for c in self.got).decode()

    def say(self, signs):
        shop.wait_for("the line's connection", lambda: self.socket)
        self.socket.sendall(signs)

    def ask(self, words):
        self.say(DC2 + even(f"%\nO9999({words})\n%\n") + DC4)

    def wait_inside_a_block(self, at_least):
        """Until so many bytes are here and the last is no EOB."""
        def inside():
            text = self.text()
            return len(text) >= at_least and text[-1] not in "\n\r\0%"
        shop.wait_for("a byte inside a block", inside, 30)


def rig_for(folder, control, baud=9600):
    rig = Rig(folder, f"tcp://127.0.0.1:{control.port}", blocks=300, baud=baud)
    rig.profile["receive"] = {"quiet_s": 1.0, "requests": True}
    return rig.start()


def nothing_goes_out(control, server, what):
    """Everything that could tempt a server; then a person confirms, and the line lives again."""
    before = control.text()
    shop.wait_for("a torn line", lambda: server.status("lathe")["line"] == "torn", 10)
    for words in ("DIR", "LOAD 42", "STATUS"):
        control.ask(words)
        time.sleep(0.3)
        control.say(DC1)
        time.sleep(0.5)
    control.say(DC3 + DC1 + b"\x16" + DC1)
    time.sleep(1.0)
    expect(control.text() == before, f"{what}: {control.text()[len(before):]!r} went out on a torn line")
    server.post("/machines/lathe/confirm-reset", {"reason": "reset at the panel"})
    shop.wait_for("an idle line", lambda: server.status("lathe")["line"] == "idle", 10)
    control.ask("DIR")
    time.sleep(0.5)
    control.say(DC1)
    shop.wait_for("the answer", lambda: "PROGRAMS" in control.text()[len(before):], 30)
    time.sleep(1.0)
    control.say(DC3)


def killed_inside_a_job(folder):
    control = OwnControl()
    rig = rig_for(folder, control)
    job = rig.arm_new_job()
    control.say(DC1)
    control.wait_inside_a_block(40)
    rig.server.kill()
    rig.server.start()
    after = rig.server.job(job)
    expect(after["state"] == "interrupted" and after["needs_confirmation"], f"{after}")
    nothing_goes_out(control, rig.server, "a job")
    verify(rig.server.data)
    rig.server.stop()


def killed_inside_an_answer(folder):
    control = OwnControl()
    rig = Rig(folder, f"tcp://127.0.0.1:{control.port}", baud=300)
    rig.profile["receive"] = {"quiet_s": 1.0, "requests": True}
    rig.server.start()
    rig.server.add_machine(rig.profile)
    rig.server.wait_line("lathe", "idle")
    control.ask("STATUS")
    time.sleep(1.5)
    control.say(DC1)
    control.wait_inside_a_block(8)
    rig.server.kill()
    rig.server.start()
    waits = rig.server.get("/machines/lathe")["status"]["needs_confirmation"]
    expect(waits and waits["job"] is None and "answer" in waits["text"], f"no one is asked to confirm: {waits}")
    nothing_goes_out(control, rig.server, "an answer")
    verify(rig.server.data)
    rig.server.stop()


def killed_while_armed(folder):
    control = OwnControl()
    rig = rig_for(folder, control)
    job = rig.arm_new_job()
    rig.server.kill()
    rig.server.start()
    after = rig.server.job(job)
    expect(after["state"] == "interrupted" and not after["needs_confirmation"], f"{after}")
    interval = rig.server.get(f"/jobs/{job}/ledger?limit=1")["interval"]
    expect(interval["high"] == 0 and control.text() == "", f"{interval} {control.text()!r}")
    rig.server.stop()


def reset_while_stopped(folder):
    control = OwnControl()
    rig = rig_for(folder, control)
    job = rig.arm_new_job()
    control.say(DC1)
    control.wait_inside_a_block(40)
    rig.server.post(f"/jobs/{job}/stop", {})
    shop.wait_for("a block end", lambda: rig.server.status("lathe")["stall"] == "stopped", 20)
    before = control.text()
    control.say(DC1)  # RESET and START at the control
    shop.wait_for("the suspicion", lambda: "may have been reset" in rig.server.status("lathe")["stall"], 10)
    refused = refusal(rig.server, f"/jobs/{job}/resume")
    expect("reset" in refused, refused)
    notes = [row["note"] for row in rig.server.get(f"/jobs/{job}/ledger?limit=200")["items"]]
    expect(any("may have been reset" in note for note in notes), f"{notes}")
    rig.server.post(f"/jobs/{job}/cancel", {})
    time.sleep(1.0)
    expect(control.text() == before, "bytes went out after a suspected reset")
    rig.server.stop()


if __name__ == "__main__":
    in_folder(killed_inside_a_job)
    in_folder(killed_inside_an_answer)
    in_folder(killed_while_armed)
    in_folder(reset_while_stopped)
    sys.exit(0)
