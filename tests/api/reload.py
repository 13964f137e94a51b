"""SIGHUP: a running server takes options over from its file, names those that wait for the next start, and keeps all of them where the file is wrong."""

import http.client
import json
import signal
import socket
import sys

from client import Client, expect, in_folder, shop

PROXY = {"X-Forwarded-Proto": "https", "X-Forwarded-Host": "dnc.shop"}
LONG = "%\nO7002\n#100=0\nWHILE[#100LT900000000]DO1\n#1=SIN[#100]\n#100=#100+1\nEND1\nM30\n%\n"


class Served:
    """A server with its options in a file."""

    def __init__(self, folder):
        self.file = folder / "dripfeed.json"
        self.modbus = shop.free_port()
        self.options = {"modbus_listen": f"127.0.0.1:{self.modbus}", "check_seconds": 60}
        self.write()
        self.client = Client(folder, "--config", str(self.file)).start()

    def write(self, **changed):
        self.options |= changed
        self.file.write_text(json.dumps(self.options))

    def log(self):
        return (self.client.server.data / "server.log").read_text()

    def reload(self, said):
        """Sends the signal and waits for the sentence; what the log has got since."""
        before = len(self.log())
        self.client.server.process.send_signal(signal.SIGHUP)
        shop.wait_for(f"the log to say {said!r}", lambda: said in self.log()[before:])
        return self.log()[before:]


def session_cookie(client):
    """How the server sets the cookie for whoever comes as from a proxy."""
    connection = http.client.HTTPConnection("127.0.0.1", client.server.port, timeout=10)
    connection.request("POST", "/api/v1/session", json.dumps({"token": client.tokens["viewer"]}), {"Content-Type": "application/json"} | PROXY)
    cookie = connection.getresponse().headers["Set-Cookie"]
    connection.close()
    return cookie


def reads(modbus):
    """Whether a PLC gets an answer there: the exception of a unit that no machine has is one."""
    with socket.create_connection(("127.0.0.1", modbus), timeout=5) as plc:
        plc.sendall(bytes.fromhex("000100000006010400000001"))
        try:
            return len(plc.recv(64)) > 0
        except ConnectionError:
            return False


def what_is_taken_over(folder):
    served = Served(folder)
    client = served.client
    served.reload("no option has changed")

    expect("Secure" not in session_cookie(client), "a proxy that no one has named is believed")
    served.write(proxy=["127.0.0.1"])
    said = served.reload("proxy as the options state now")
    expect("next start" not in said, said)
    shop.wait_for("the proxy to be believed", lambda: "Secure" in session_cookie(client))

    kept = socket.create_connection(("127.0.0.1", served.modbus), timeout=5)
    expect(reads(served.modbus), "a PLC gets no answer")
    served.write(modbus_allow=["127.0.0.9"])
    served.reload("modbus_allow as the options state now")
    expect(not reads(served.modbus), "a PLC that may not read is answered")
    expect(kept.recv(1) == b"", "a PLC that may not read any more is still connected")
    served.write(modbus_allow=[])
    served.reload("modbus_allow as the options state now")
    expect(reads(served.modbus), "a PLC gets no answer any more")

    client.post("/machines", shop.preset("fanuc-0i-mill", url=f"pty:{folder}/mill") | {"name": "mill"})
    program = client.post("/programs", {"name": "O7002", "dialect": "fanuc", "text": LONG})["id"]
    served.write(check_seconds=1, check_memory=512)
    served.reload("check_seconds, check_memory as the options state now")
    verdict = client.post("/checks", {"program": program, "machine": "mill"})
    expect(verdict["verdict"] != "pass" and any("budget of" in one for one in verdict["not_checked"]), f"{verdict}")
    client.server.stop()


def what_waits(folder):
    served = Served(folder)
    served.write(listen="127.0.0.1:1", event_source="https://dnc.shop")
    said = served.reload("used from the next start on")
    expect("event_source" in said, said)
    # The command line wins over the file, so the address has not changed.
    expect("listen" not in said, said)
    served.reload("used from the next start on")  # as long as it has not been started
    served.client.server.stop()


def what_is_refused(folder):
    served = Served(folder)
    for wrong, words in [({"check_seconds": 0}, "check_seconds"), ({"proxy": ["nowhere"]}, '"nowhere" is not an IP address'), ({"modbus_allow": ["x"]}, "--modbus-allow"), ({"nothing": 1}, "nothing")]:
        good = dict(served.options)
        served.write(check_memory=256, **wrong)
        said = served.reload("no option is changed")
        expect(words in said and "as the options state" not in said, said)
        served.options = good
    served.write()
    served.reload("no option has changed")
    served.file.write_text("{")
    served.reload("no option is changed")
    served.file.unlink()
    served.reload("no option is changed")
    expect(served.client.get("/machines")["items"] == [], "the server does not answer any more")
    served.client.server.stop()


if __name__ == "__main__":
    for test in (what_is_taken_over, what_waits, what_is_refused):
        in_folder(test)
    sys.exit(0)
