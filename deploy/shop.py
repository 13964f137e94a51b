"""A small shop for trying dripfeed: its server, simulated controls and a REST client, as the demo, the smoke test and the end-to-end tests use
them. Standard library only. What is tried with them is left to those scripts."""

import json
import os
import pathlib
import re
import signal
import socket
import subprocess
import time
import urllib.error
import urllib.request

ROOT = pathlib.Path(__file__).resolve().parent.parent


class Refused(Exception):
    """The server answered with a problem."""

    def __init__(self, status, document):
        super().__init__(f"{status}: {document.get('detail', document)}")
        self.status = status
        self.document = document


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def listens(port):
    """Whether a program of this machine listens there (asking by a connection would be taken for the peer)."""
    rows = [line.split() for line in pathlib.Path("/proc/net/tcp").read_text().splitlines()[1:]]
    return any(row[3] == "0A" and int(row[1].split(":")[1], 16) == port for row in rows)


def wait_for(what, condition, seconds=20.0, step=0.02, seen=lambda: None):
    """The first true value of condition(); fails with `what`, and what is `seen` instead, when it never comes."""
    until = time.monotonic() + seconds
    while time.monotonic() < until:
        value = condition()
        if value:
            return value
        time.sleep(step)
    instead = seen()
    raise TimeoutError(f"waited {seconds:g} s for {what}" + (f", there is {instead}" if instead else ""))


def preset(name, **link):
    """A machine profile of deploy/machines with another link."""
    profile = json.loads((ROOT / "deploy/machines" / f"{name}.json").read_text())
    profile["link"].update(link)
    return profile


class Server:
    """dripfeed serve on a port (without one the system chooses it at each start), with its data in a folder."""

    def __init__(self, binary, data, port=None, arguments=()):
        self.binary, self.data, self.arguments = str(binary), pathlib.Path(data), list(arguments)
        self.given_port, self.port = port or 0, port
        self.stdout = self.stderr = None  # of the server, in place of its log; a server without the log needs a port
        self.process = None

    def start(self):
        self.data.mkdir(parents=True, exist_ok=True)
        log = open(self.data / "server.log", "ab")
        said_before = log.tell()
        command = [self.binary, "serve", "--data", str(self.data), "--listen", f"127.0.0.1:{self.given_port}", *self.arguments]
        self.process = subprocess.Popen(command, stdout=self.stdout or log, stderr=self.stderr or log)
        log.close()
        if not self.stdout:
            self.port = wait_for("the server's address", lambda: self._port_said(said_before))
        wait_for("the server", self._answers)
        return self

    def _port_said(self, since):
        said = re.search(rb"http://127\.0\.0\.1:(\d+)/", (self.data / "server.log").read_bytes()[since:])
        self._check_runs()
        return int(said[1]) if said else None

    def _check_runs(self):
        if self.process.poll() is not None:
            raise RuntimeError(f"the server ended with {self.process.returncode}: {(self.data / 'server.log').read_text()[-2000:]}")

    def _answers(self):
        self._check_runs()
        try:
            return self.request("GET", "/healthz")["status"] == "ok"
        except (urllib.error.URLError, ConnectionError, TimeoutError):
            return False

    def token(self):
        return (self.data / "first-token").read_text().strip()

    def stop(self):
        self.process.send_signal(signal.SIGTERM)
        ended = self.process.wait(20)
        if ended != 0:
            raise RuntimeError(f"the server ended with {ended}: {(self.data / 'server.log').read_text()[-2000:]}")

    def kill(self):
        self.process.kill()
        self.process.wait()

    def alive(self):
        return self.process.poll() is None

    def request(self, method, path, body=None, headers=None, text=False):
        """The decoded answer; raises Refused for a problem."""
        send = {} if path == "/healthz" else {"Authorization": f"Bearer {self.token()}"}
        send.update(headers or {})
        data = None if body is None else (body if isinstance(body, bytes) else json.dumps(body).encode())
        call = urllib.request.Request(f"http://127.0.0.1:{self.port}{path}", data=data, headers=send, method=method)
        try:
            with urllib.request.urlopen(call, timeout=60) as answer:
                content = answer.read()
        except urllib.error.HTTPError as problem:
            raw = problem.read()
            try:
                raise Refused(problem.code, json.loads(raw)) from None
            except json.JSONDecodeError:
                raise Refused(problem.code, {"detail": raw.decode(errors="replace")}) from None
        if text:
            return content
        return json.loads(content) if content else None

    def get(self, path):
        return self.request("GET", f"/api/v1{path}")

    def post(self, path, body=None, **headers):
        return self.request("POST", f"/api/v1{path}", body if body is not None else {}, headers)

    def status(self, machine):
        return self.get(f"/machines/{machine}")["status"]

    def job(self, job):
        return self.get(f"/jobs/{job}")

    def add_machine(self, profile):
        return self.post("/machines", profile)

    def add_family(self, path):
        return self.post("/families", {"text": pathlib.Path(path).read_text()})

    def release(self, program, machine, delivery="drip", transfers=1000):
        """Walks a checked program to `proving`, where it may be fed."""
        release = self.post("/releases", {"program": program, "machine": machine, "delivery": delivery})
        for step in ({"to": "in_review"}, {"to": "proving", "transfers": transfers}):
            release = self.post(f"/releases/{release['id']}/transitions", step)
        return release

    def wait_job(self, job, *states, seconds=60.0):
        return wait_for(f"job {job} to be {' or '.join(states)}", lambda: (lambda j: j if j["state"] in states else None)(self.job(job)), seconds,
                        seen=lambda: {name: self.job(job)[name] for name in ("state", "reason", "bytes", "torn")})

    def wait_line(self, machine, *states, seconds=20.0):
        return wait_for(f"{machine} to be {' or '.join(states)}", lambda: (lambda s: s if s["line"] in states else None)(self.status(machine)), seconds,
                        seen=lambda: self.status(machine)["line"])


class Control:
    """dripfeed simulate at the other end of a link."""

    def __init__(self, binary, link, machine, *arguments):
        self.command = [str(binary), "simulate", "--link", link, "--machine", str(machine), "--json", *map(str, arguments)]
        self.link = link
        self.process = None

    def start(self):
        self.process = subprocess.Popen(self.command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        if self.link.startswith("pty:"):
            path = self.link.split("?")[0][4:]
            wait_for(f"the simulated control at {path}", lambda: os.path.exists(path) or self._over())
        elif self.link.startswith(("tcp-listen:", "rfc2217-listen:")):
            port = int(self.link.split("?")[0].rsplit(":", 1)[1])
            wait_for(f"the simulated control at port {port}", lambda: listens(port) or self._over())
        return self

    def _over(self):
        if self.process.poll() is not None:
            raise RuntimeError(f"the simulated control ended with {self.process.returncode}: {' '.join(self.command)}")
        return False

    def finish(self, seconds=60.0):
        """Waits for the end of the program; its report."""
        out, _ = self.process.communicate(timeout=seconds)
        return json.loads(out)

    def stop(self):
        """Ends it now; its report."""
        self.process.send_signal(signal.SIGTERM)
        return self.finish(10)
