"""Device servers that others wrote between us and a simulated control: ser2net as RFC 2217 and as raw TCP, pyserial's RFC 2217 port as
the server, and pyserial as the client of ours. What the control ran is what was sent, to the byte."""

import pathlib
import json
import subprocess
import sys
import threading
import socket

import rig

BUDGET = 200  # characters: counterparts and this machine's other work may be slow, and speed is not what is tried


def profile(folder, url):
    document = rig.shop.preset("fanuc-0i-mill", url=url, end_by_quiet_s=3.0, overrun_budget=BUDGET, latency_chars=40, unsent=4)
    document["name"] = "mill"
    path = folder / "mill.json"
    path.write_text(json.dumps(document))
    return path


def program(folder, blocks=120):
    path = folder / "O0042.nc"
    lines = ["%", "O0042", "G21 G17 G90 G94 G40", "G00 X0. Y0."]
    lines += [f"G01 X{i % 9}.5 Y{i % 7}.25 F2000." for i in range(blocks)]
    path.write_text("\n".join(lines + ["M30", "%"]) + "\n")
    return path


def control_on_pty(folder, *arguments):
    pty = folder / "cnc"
    machine = profile(folder, f"pty:{pty}")
    return pty, machine, rig.shop.Control(rig.binary(), f"pty:{pty}?framing=7E2", machine, "--operator", "0.5", "--speed", "50", *arguments).start()


def send(folder, machine, text, link):
    command = [str(rig.binary()), "send", str(text), "--link", link, "--machine", str(machine), "--unreleased", "--json",
               "--ledger", str(folder / "ledger")]
    done = subprocess.run(command, capture_output=True, text=True, timeout=120)
    rig.expect(done.returncode == 0, f"send to {link} ended with {done.returncode}: {done.stderr}")
    return json.loads(done.stdout)


def compare(sent, control):
    report = control.finish()
    rig.expect(report["alarm"] in ("", None), f"the control raised {report['alarm']}")
    rig.expect(report["parity_errors"] == 0, f"{report['parity_errors']} parity errors")
    rig.expect(report["text_sha256"] == sent["text_sha256"], f"the text differs: {sent} {report}")


class Ser2net:
    """ser2net with one device on a port, as RFC 2217 or raw."""

    def __init__(self, folder, device, accepter):
        self.port = rig.shop.free_port()
        config = folder / "ser2net.yaml"
        config.write_text(
            "%YAML 1.1\n---\nconnection: &one\n"
            f"  accepter: {accepter},127.0.0.1,{self.port}\n"
            f"  connector: serialdev(nouucplock=true),{device},9600n82,local\n"
            "  options:\n    chardelay: false\n")
        self.process = subprocess.Popen(["/usr/sbin/ser2net", "-n", "-d", "-c", str(config), "-P", str(folder / "ser2net.pid")],
                                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        rig.shop.wait_for("ser2net", lambda: rig.shop.listens(self.port))

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.terminate()
        self.process.wait(10)


def through_ser2net(folder, accepter, scheme):
    pty, machine, control = control_on_pty(folder)
    with Ser2net(folder, pty, accepter) as server:
        sent = send(folder, machine, program(folder), f"{scheme}://127.0.0.1:{server.port}?framing=7E2&baud=9600")
        compare(sent, control)


def ser2net_rfc2217(folder):
    through_ser2net(folder, "telnet(rfc2217),tcp", "rfc2217")


def ser2net_raw(folder):
    through_ser2net(folder, "tcp(nodelay=true)", "tcp")


def ser2net_is_taken(folder):
    """A second client gets ser2net's own words, and they are reported instead of taken for a control's."""
    pty, machine, control = control_on_pty(folder)
    try:
        with Ser2net(folder, pty, "telnet(rfc2217),tcp") as server:
            with socket.create_connection(("127.0.0.1", server.port)) as first:
                first.recv(64)
                command = [str(rig.binary()), "send", str(program(folder)), "--machine", str(machine), "--unreleased", "--ledger", str(folder / "ledger"),
                           "--link", f"rfc2217://127.0.0.1:{server.port}?framing=7E2"]
                done = subprocess.run(command, capture_output=True, text=True, timeout=120)
                rig.expect(done.returncode == 1, f"exit {done.returncode}")
                rig.expect("Port already in use" in done.stderr, done.stderr)
    finally:
        control.stop()


class PySerialServer:
    """pyserial's own RFC 2217 port manager in front of a pty, as its example server does it."""

    def __init__(self, device):
        import serial
        import serial.rfc2217

        class Pty(serial.Serial):
            """A pseudo-terminal has no modem lines; they are taken as on, and setting them does nothing."""
            cts = dsr = cd = property(lambda self: True)
            ri = property(lambda self: False)

            def _update_dtr_state(self):
                pass

            def _update_rts_state(self):
                pass

        self.serial = Pty(str(device), timeout=0.05)
        self.listener = socket.create_server(("127.0.0.1", 0))
        self.port = self.listener.getsockname()[1]
        self.alive = True
        self.manager = None
        self.peer = None
        self.threads = [threading.Thread(target=self.from_network, daemon=True), threading.Thread(target=self.from_device, daemon=True)]

    def write(self, data):  # the manager answers through this
        self.peer.sendall(data)

    def __enter__(self):
        for thread in self.threads:
            thread.start()
        return self

    def __exit__(self, *_):
        self.alive = False
        self.listener.close()
        if self.peer:
            self.peer.close()
        self.serial.close()

    def from_network(self):
        import serial.rfc2217
        self.peer, _ = self.listener.accept()
        self.manager = serial.rfc2217.PortManager(self.serial, self)
        while self.alive:
            try:
                data = self.peer.recv(1024)
            except OSError:
                return
            if not data:
                return
            self.serial.write(b"".join(self.manager.filter(data)))

    def from_device(self):
        while self.alive:
            try:
                data = self.serial.read(self.serial.in_waiting or 1)
                if data and self.manager:
                    self.write(b"".join(self.manager.escape(data)))
            except (OSError, TypeError):
                return


def pyserial_as_server(folder):
    pty, machine, control = control_on_pty(folder)
    with PySerialServer(pty) as server:
        sent = send(folder, machine, program(folder), f"rfc2217://127.0.0.1:{server.port}?framing=7E2&baud=9600")
        compare(sent, control)


def pyserial_as_client(folder):
    """pyserial sets our simulated device server's port (it insists on every answer), reads its lines, and feeds the control at its port."""
    import serial
    port = rig.shop.free_port()
    machine = profile(folder, "pty:/unused")
    control = rig.shop.Control(rig.binary(), f"rfc2217-listen://127.0.0.1:{port}?framing=7E2", machine, "--operator", "0.5", "--speed", "50").start()
    try:
        line = serial.serial_for_url(f"rfc2217://127.0.0.1:{port}", baudrate=4800, bytesize=7, parity="E", stopbits=2, timeout=5)
        rig.expect(line.cts and line.dsr, "the control's lines are on")
        line.dtr, line.rts = False, True
        line.dtr = True
        rig.expect(line.read(1) == b"\x11", "the control asks with DC1")
        for text in ("%\nO1\nM30\n%\n",):
            line.write(bytes(c | (0x80 if bin(c).count("1") % 2 else 0) for c in text.encode()))
        rig.expect(line.read(1) in (b"\x13", b"\x93"), "the control ends with DC3")
        line.close()
    finally:
        report = control.stop()
    rig.expect(report["parity_errors"] == 0 and report["bytes"] == 11, f"{report}")


if __name__ == "__main__":
    for test in (ser2net_rfc2217, ser2net_raw, ser2net_is_taken, pyserial_as_server, pyserial_as_client):
        rig.in_folder(test)
