"""What the tests of the API share: a server with a token for each role, a client that shows every part of an answer, a control that the test
plays by hand on a socket, and a program that is released for it. The tests are the other files of this folder; each is a ctest entry with a
server of its own on a port that the system chooses."""

import atexit
import http.client
import json
import pathlib
import socket
import subprocess
import sys
import threading
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "e2e"))
from rig import binary, expect, in_folder, plain_program, shop, verify  # noqa: E402,F401

import contract  # noqa: E402

API = "/api/v1"
ROLES = ["viewer", "operator", "programmer", "approver", "admin"]  # each may do what those before it may
LISTS = ["machines", "families", "parts", "programs", "checks", "releases", "jobs", "receipts", "requests", "alarms"]
ROLL = (shop.ROOT / "deploy/families/hyperbolic-roll.family").read_text()
DC1, DC3 = b"\x11", b"\x13"


class Answer:
    def __init__(self, response, body):
        self.status, self.headers, self.body = response.status, response.headers, body

    @property
    def document(self):
        return json.loads(self.body)

    def __str__(self):
        return f"{self.status} {self.body[:500].decode(errors='replace')}"


def ask(connection, method, path, body=None, headers=None):
    """One request on an open connection, compared with openapi.json with its answer."""
    sent, answer = exchange(connection, method, path, body, headers)
    contract.check(method, path, sent, answer)
    return answer


def exchange(connection, method, path, body=None, headers=None):
    """The body as it was sent, and the answer, with nothing between: for what takes the time. A stream of events is not read."""
    send = dict(headers or {})
    if body is not None and not isinstance(body, bytes):
        body = json.dumps(body).encode()
        send.setdefault("Content-Type", "application/json")
    connection.request(method, path, body=body, headers=send)
    response = connection.getresponse()
    is_stream = response.getheader("Content-Type", "").startswith("text/event-stream")
    return body, Answer(response, b"" if is_stream else response.read())


class Client:
    """A server and its callers by role. Paths are given without /api/v1, or whole."""

    def __init__(self, folder, *arguments):
        self.server = shop.Server(binary(), folder / "data", arguments=arguments)
        self.store = list(arguments[arguments.index("--store"):][:2]) if "--store" in arguments else []  # where it is not in the folder
        self.tokens = {}
        atexit.register(self.end)  # also where a test fails

    def end(self):
        if self.server.process and self.server.alive():
            self.server.kill()

    def start(self):
        self.server.start()
        if not self.tokens:
            self.tokens = {role: self.add_token(role) for role in ROLES[:-1]} | {"admin": self.server.token()}
        return self

    def restart(self):
        self.server.stop()
        self.server.start()

    def token_command(self, *arguments):
        done = subprocess.run([str(binary()), "token", *arguments, "--data", str(self.server.data), *self.store], capture_output=True, text=True, timeout=30)
        expect(done.returncode == 0, f"token {arguments}: {done.stderr}")
        return done.stdout

    def add_token(self, role, name=None):
        return self.token_command("add", name or f"the {role}", "--role", role).strip()

    def connect(self, timeout=30):
        return http.client.HTTPConnection("127.0.0.1", self.server.port, timeout=timeout)

    def call(self, method, path, body=None, role="admin", headers=None):
        """The answer, whatever it is. Without a role there is no token."""
        send = {"Authorization": f"Bearer {self.tokens[role]}"} if role else {}
        connection = self.connect()
        try:
            return ask(connection, method, whole(path), body, send | (headers or {}))
        finally:
            connection.close()

    def must(self, method, path, body=None, role="admin", headers=None):
        """The document of an answer that has to be good."""
        answer = self.call(method, path, body, role, headers)
        expect(200 <= answer.status < 300, f"{method} {path}: {answer}")
        return answer.document if answer.body else None

    def get(self, path):
        return self.must("GET", path)

    def post(self, path, body=None):
        return self.must("POST", path, {} if body is None else body)

    def refuse(self, status, method, path, body=None, role="admin", headers=None, words=()):
        """The problem of a request that must be refused like this."""
        return expect_problem(self.call(method, path, body, role, headers), status, f"{method} {path} {body}", words)

    def everything(self):
        """All that is stored, as the lists have it; the state of lines is left out."""
        found = {}
        for name in LISTS:
            items = self.get(f"/{name}?limit=200")["items"]
            found[name] = [{k: v for k, v in item.items() if k != "status"} for item in items]
        for program in found["programs"]:
            program["revisions"] = self.get(f"/programs/{program['id']}/revisions")["items"]
        return found

    def add_program(self, blocks=20, name="O0042"):
        return self.post("/programs", {"name": name, "dialect": "fanuc", "text": plain_program(blocks, name)})

    def check(self, program, machine="lathe"):
        """A verdict that clears the text: what only warns is waived."""
        verdict = self.post("/checks", {"program": program, "machine": machine})
        expect(verdict["verdict"] != "fail", f"the text of this test fails: {json.dumps(verdict)[:2000]}")
        if verdict["verdict"] != "pass":
            self.post(f"/checks/{verdict['id']}/waivers", {"reason": "a text of a test"})
        return verdict

    def release(self, program, machine="lathe", transfers=100):
        """Checked and walked to `proving`, where it may be fed."""
        self.check(program, machine)
        release = self.post("/releases", {"program": program, "machine": machine})
        for step in ({"to": "in_review"}, {"to": "proving", "transfers": transfers}):
            release = self.post(f"/releases/{release['id']}/transitions", step)
        return release

    def waive_operators(self, machine="lathe"):
        """From here on no operator has to sign a proving of this machine off."""
        self.must("PUT", f"/groups/of-{machine}", {"machines": [machine], "operator_sign_off": False})

    def queue(self, release):
        return self.post("/jobs", {"release": release})["id"]

    def job(self, job):
        return self.get(f"/jobs/{job}")

    def wait_job(self, job, *states, stall=None):
        def reached():
            now = self.job(job)
            line = self.get(f"/machines/{now['machine']}")["status"]
            return now if now["state"] in states and (stall is None or line["stall"] == stall) else None
        return shop.wait_for(f"job {job} to be {' or '.join(states)}", reached)

    def wait_line(self, machine, *states):
        def reached():
            status = self.get(f"/machines/{machine}")["status"]
            return status if status["line"] in states else None
        return shop.wait_for(f"{machine} to be {' or '.join(states)}", reached)


def whole(path):
    return path if path in ("/", "/healthz", "/metrics", "/docs") or path.startswith(("/api/", "/assets/", "/docs/", "/mtconnect/")) else API + path


def expect_problem(answer, status, what, words=()):
    expect(answer.status == status, f"{what}: expected {status}, got {answer}")
    kind = answer.headers.get("Content-Type")
    expect(kind == "application/problem+json", f"{what}: a problem comes as {kind}")
    problem = answer.document
    expect(problem.get("status") == status, f"{what}: the document says {problem.get('status')}, the answer {status}")
    for member in ("type", "title", "detail"):
        expect(isinstance(problem.get(member), str) and problem[member], f"{what}: no {member} in {problem}")
    expect(len(problem["title"]) <= 30 and problem["title"] != problem["detail"], f"{what}: the title is no title: {problem}")
    text = json.dumps(problem, ensure_ascii=False)
    for word in words:
        expect(word in text, f"{what}: \"{word}\" is not in {text}")
    return problem


class HandControl:
    """A control at the end of a TCP link that reads all and says DC1 and DC3 when the test lets it."""

    def __init__(self):
        self.listener = socket.create_server(("127.0.0.1", 0))
        self.url = f"tcp://127.0.0.1:{self.listener.getsockname()[1]}"
        self.link, self.got, self.calls, self.lock = None, bytearray(), 0, threading.Lock()
        self.is_bridged = False  # the data wires: what comes goes back, as with a loopback plug
        self.gaps_s = None  # pauses between what arrived, where a test wants them
        threading.Thread(target=self._accept, daemon=True).start()

    def _accept(self):
        while True:
            try:
                link, _ = self.listener.accept()
            except OSError:
                return
            with self.lock:
                self.link, self.got, self.calls = link, bytearray(), self.calls + 1
            threading.Thread(target=self._read, args=(link,), daemon=True).start()

    def _read(self, link):
        try:
            before = time.monotonic()
            while piece := link.recv(4096):
                now = time.monotonic()
                with self.lock:
                    self.got += piece
                    if self.gaps_s is not None:
                        self.gaps_s.append(now - before)
                if self.is_bridged:
                    link.sendall(piece)
                before = now
        except OSError:
            pass  # cut by the test

    def text(self):
        """What came since the link is up, without the parity of ISO code."""
        with self.lock:
            return bytes(byte & 0x7F for byte in self.got)

    def wait_called(self, times):
        shop.wait_for(f"call {times} of the server", lambda: self.calls >= times)

    def say(self, code):
        self.wait_called(1)
        self.link.sendall(code)

    def wait_bytes(self, count):
        return shop.wait_for(f"{count} bytes at the control", lambda: len(self.text()) >= count)

    def cut(self):
        """The cable is cut. SO_LINGER 0 makes it a reset, as a device server does."""
        self.wait_called(1)  # a cable that was never plugged cannot be cut
        self.link.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, b"\x01\x00\x00\x00\x00\x00\x00\x00")
        self.link.shutdown(socket.SHUT_RD)
        self.link.close()

    def hold_inside_block(self):
        """Says DC3 so that the last character that came is inside a block, whatever the timing is."""
        for _ in range(100):
            self.wait_bytes(len(self.text()) + 5)
            self.say(DC3)
            if not self.wait_quiet().endswith(b"\n"):
                return
            self.say(DC1)
        raise AssertionError("every hold came at a block end")

    def wait_quiet(self):
        seen = None
        while seen != self.text():
            seen = self.text()
            time.sleep(0.15)
        return seen

    def close(self):
        self.listener.close()


def hand_profile(control, name="lathe"):
    profile = shop.preset("fanuc-0i-lathe", url=control.url, baud=19200, framing="8N1", leader=0, trailer=0, end_by_quiet_s=0.3)
    profile["name"] = name
    return profile
