"""The page in a real browser against the real server. This starts the server with machines whose controls the test plays by hand, and one on a
simulated PLC, and runs the browser tests of web/ (one file, named by the second argument). They ask this rig, by JSON over HTTP, for what a person at a control
or an administrator would do: say DC1, hold, cut the cable, kill the server, revoke a token."""

import http.server
import json
import os
import pathlib
import subprocess
import sys
import threading
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "api"))
from client import DC1, DC3, Client, HandControl, binary, expect, hand_profile, in_folder, shop  # noqa: E402

WEB = pathlib.Path(__file__).resolve().parent / "web"
CODES = {"dc1": DC1, "dc3": DC3, "dc4": b"\x14", "dc2": b"\x12"}


class Shop:
    """What a test may ask for: each method is a word of the rig."""

    def __init__(self, folder, client=None):
        self.folder = folder
        self.client = client or Client(folder).start()
        self.controls = {}
        self.releases = {}
        self.simulated = []

    def base(self):
        """Where the page is, and a token for each role."""
        return {"url": f"http://127.0.0.1:{self.client.server.port}", "tokens": self.client.tokens}

    def machine(self, name, blocks=400, jobs=1, baud=19200, **profile):
        """A machine with a hand-played control, a released program of so many blocks and queued jobs. Answers their numbers."""
        control = self.controls[name] = HandControl()
        document = hand_profile(control, name)
        document["link"]["baud"] = baud
        document.update(profile)
        self.client.post("/machines", document)
        return self._with_jobs(name, blocks, jobs)

    def plc(self, name, blocks=300, jobs=1):
        """A machine with a simulated PLC: blocks go over Modbus."""
        url = f"modbus-tcp://127.0.0.1:{shop.free_port()}/1"
        profile = shop.preset("fanuc-0i-lathe", url=url)
        profile["name"] = name
        profile["buffer"]["bytes"] = 1024
        machine = self.folder / f"{name}.json"
        machine.write_text(json.dumps(profile))
        self.simulated.append(shop.Control(binary(), url, machine, "--speed", "1", "--operator", "1", "--repeat").start())
        self.client.post("/machines", profile)
        return self._with_jobs(name, blocks, jobs)

    def _with_jobs(self, name, blocks, jobs):
        program = self.client.add_program(blocks, f"O{len(self.releases) + 1:04d}")["id"]
        self.releases[name] = self.client.release(program, name)["id"]
        self.client.wait_line(name, "idle")
        return [self.client.queue(self.releases[name]) for _ in range(jobs)]

    def say(self, machine, code):
        self.controls[machine].say(CODES[code])

    def punch(self, machine, text):
        """The control sends a program, as an operator's PUNCH does: DC2, the text, DC4."""
        self.controls[machine].say(CODES["dc2"] + text.encode() + CODES["dc4"])

    def bridge(self, machine, is_bridged=True):
        """A loopback plug in the control's place, or the control again."""
        self.controls[machine].is_bridged = is_bridged

    def got(self, machine):
        return len(self.controls[machine].text())

    def hold_often(self, machine, times, pause_s=0.05):
        """DC3 and DC1 in turn, as a control does whose buffer fills and empties."""
        for _ in range(times):
            self.controls[machine].say(DC3)
            time.sleep(pause_s)
            self.controls[machine].say(DC1)
            time.sleep(pause_s)

    def tear(self, machine):
        """The cable is cut inside a block."""
        self.controls[machine].hold_inside_block()
        self.controls[machine].cut()

    def wait_line(self, machine, *states):
        return self.client.wait_line(machine, *states)

    def job(self, job):
        return self.client.job(job)

    def queue(self, machine):
        return self.client.queue(self.releases[machine])

    def call(self, method, path, body=None, role="admin", headers=None):
        answer = self.client.call(method, path, body, role, headers)
        return {"status": answer.status, "body": answer.document if answer.body else None}

    def text(self, path):
        return self.client.call("GET", path).body.decode()

    def restart(self, hard=False):
        """The server ends and comes back on the same port."""
        server = self.client.server
        server.given_port = server.port
        if hard:
            server.kill()
        else:
            server.stop()
        server.start()

    def kill_server(self):
        """It is gone between two words: no page hears of an end."""
        self.client.server.given_port = self.client.server.port
        self.client.server.kill()

    def start_server(self):
        self.client.server.start()

    def token(self, role, name):
        return self.client.add_token(role, name)

    def revoke(self, name):
        row = next(line for line in self.client.token_command("list").splitlines() if f" {name} " in f" {line} ")
        self.client.token_command("revoke", row.split()[0])

    def watch_gaps(self, machine):
        """From now on the pauses between what arrives at the control are noted."""
        self.controls[machine].gaps_s = []

    def gaps(self, machine):
        """Those pauses, in seconds."""
        return self.controls[machine].gaps_s

    def cpu_s(self):
        """Seconds of a core that the server took so far."""
        fields = pathlib.Path(f"/proc/{self.client.server.process.pid}/stat").read_text().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def close(self):
        for control in self.simulated:
            control.process.terminate()
        self.client.end()


class Answering(http.server.BaseHTTPRequestHandler):
    shop = None

    def do_POST(self):
        order = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
        try:
            result = {"result": getattr(self.shop, order["do"])(*order.get("with", []), **order.get("named", {}))}
        except Exception as error:  # the browser test gets it, and fails there
            result = {"error": f"{type(error).__name__}: {error}"}
        body = json.dumps(result).encode()
        self.send_response(200)
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body)

    def log_message(self, *_):
        pass


def run(folder, make=Shop):
    Answering.shop = make(folder)
    rig = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Answering)
    threading.Thread(target=rig.serve_forever, daemon=True).start()
    try:
        ended = subprocess.run(["node", str(WEB / sys.argv[2]), *sys.argv[3:]], timeout=float(os.environ.get("PAGE_TIMEOUT_S", "600")),
                               env={**os.environ, "DRIPFEED_RIG": f"http://127.0.0.1:{rig.server_port}/"})
        expect(ended.returncode == 0, f"{sys.argv[2]} ended with {ended.returncode}")
    finally:
        Answering.shop.close()


if __name__ == "__main__":
    in_folder(run)
