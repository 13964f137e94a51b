"""The server under test: started, stopped and killed by the test, one run after the other on the same data folder. A call that a dead server does not answer
raises ServerGone; so does whatever waits while the run it belongs to is over."""

import http.client
import json
import os
import pathlib
import signal
import subprocess
import threading
import time

import shop


DISK = "4g"
COMMANDS = ("/arm", "/stop", "/cancel", "/resume", "/confirm-reset")


class ServerGone(Exception):
    """The run of the server is over."""


class Served:
    def __init__(self, binary, data):
        self.binary, self.data = str(binary), pathlib.Path(data)
        self.data.mkdir(parents=True, exist_ok=True)
        self.own_disk = os.geteuid() == 0 and subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={DISK}", "chaos", str(self.data)], check=False).returncode == 0
        self.port = shop.free_port()
        self.up = threading.Event()
        self.generation = 0
        self.process = None
        self.token = None
        self.log_is_read = True
        self.commands_ms = []  # how long a person waited for the answer
        self.verifies = b"ledger" in subprocess.run([self.binary, "--help"], capture_output=True, check=False).stdout

    def start(self, log_is_read=True):
        """With a log that no process reads its pipe fills up."""
        self.log_is_read = log_is_read
        command = [self.binary, "serve", "--data", str(self.data), "--listen", f"127.0.0.1:{self.port}"]
        if log_is_read:
            with open(self.data / "server.log", "ab") as log:
                self.process = subprocess.Popen(command, stdout=log, stderr=log)
        else:
            self.process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        until = time.monotonic() + 60
        while True:
            if self.process.poll() is not None:
                raise RuntimeError(f"the server ended with {self.process.returncode}: {self.data / 'server.log'}")
            try:
                self.token = (self.data / "first-token").read_text().strip()
                if self._call("GET", "/healthz", None, {}, 5)[0] == 200:
                    break
            except (OSError, http.client.HTTPException):
                pass
            if time.monotonic() > until:
                raise RuntimeError("the server does not answer")
            time.sleep(0.02)
        self.generation += 1
        self.up.set()

    def _call(self, method, path, body, headers, timeout):
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=timeout)
        try:
            connection.request(method, path, body, headers)
            answer = connection.getresponse()
            return answer.status, answer.read()
        finally:
            connection.close()

    def request(self, method, path, body=None, timeout=30, **headers):
        send = {"Authorization": f"Bearer {self.token}", **{name.replace("_", "-"): value for name, value in headers.items()}}
        data = body if body is None or isinstance(body, bytes) else json.dumps(body).encode()
        generation = self.generation
        asked_at = time.monotonic()
        if not self.up.is_set():
            raise ServerGone
        try:
            status, content = self._call(method, f"/api/v1{path}", data, send, timeout)
        except (ConnectionError, http.client.HTTPException, BrokenPipeError):
            raise ServerGone from None
        except TimeoutError:
            if self.generation != generation or not self.up.is_set():
                raise ServerGone from None
            raise
        if path.endswith(COMMANDS):
            self.commands_ms.append((time.monotonic() - asked_at) * 1000)
        if status >= 400:
            try:
                document = json.loads(content)
            except ValueError:
                document = {"detail": content[:200].decode(errors="replace")}
            raise shop.Refused(status, document)
        return json.loads(content) if content else None

    def get(self, path, **more):
        return self.request("GET", path, **more)

    def post(self, path, body=None, **more):
        return self.request("POST", path, {} if body is None else body, **more)

    def signal(self, number):
        self.process.send_signal(number)

    def end(self, how):
        """Ends the run by SIGKILL or SIGTERM; the exit code, None where it did not stop in time and was killed."""
        self.up.clear()
        self.generation += 1
        self.process.send_signal(how)
        try:
            code = self.process.wait(1 if how == signal.SIGKILL else 20)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
            code = None
        if self.process.stdout:
            self.process.stdout.close()
        return code

    def verify(self):
        """What the server's own verification of its books finds; nothing where it finds no fault, or where there is no such command."""
        if not self.verifies:
            return None
        done = subprocess.run([self.binary, "ledger", "verify", str(self.data)], capture_output=True, text=True, check=False, timeout=120)
        return None if done.returncode == 0 else (done.stdout + done.stderr)[-500:]

    def close(self):
        if self.process and self.shows_life():
            self.process.kill()
            self.process.wait()
        if self.own_disk:
            subprocess.run(["umount", "-l", str(self.data)], check=False)

    def shows_life(self):
        return self.process.poll() is None
