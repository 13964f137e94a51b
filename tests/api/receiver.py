"""A receiver of webhooks, as a customer would write it: it checks signatures with the code of docs/integrating.md, which is written by the words of
Standard Webhooks 1.0, and keeps what came."""

import http.server
import json
import pathlib
import re
import ssl
import threading
import time

DOCS = (pathlib.Path(__file__).resolve().parents[2] / "docs/integrating.md").read_text()


def of_the_docs():
    """verify(secret, headers, body) as docs/integrating.md has it: the document, or ValueError."""
    names = {}
    exec(re.search(r"```python\n(.*?)```", DOCS, re.S)[1], names)
    return names["verify"]


verify = of_the_docs()


def types_of_the_docs():
    """Every type in the table of docs/integrating.md."""
    found = set()
    for cell in re.findall(r"^\| (`\w+\.\w+`[^|]*) \|", DOCS, re.M):
        first, *others = re.findall(r"`([\w.]+)`", cell)
        found |= {first} | {first.split(".")[0] + other for other in others}
    return found


class Got:
    def __init__(self, headers, body):
        self.headers, self.body, self.at = headers, body, time.monotonic()

    @property
    def id(self):
        return self.headers["webhook-id"]

    @property
    def document(self):
        return json.loads(self.body)


class Receiver:
    """Listens on loopback. `statuses`: what it answers next, then `always`; a number, or a function of the handler. `certificate`: (file, key)."""

    def __init__(self, always=204, certificate=None, port=0):
        self.always, self.statuses, self.got, self.lock = always, [], [], threading.Lock()
        receiver = self

        class Handler(http.server.BaseHTTPRequestHandler):
            protocol_version = "HTTP/1.1"

            def do_POST(self):
                receiver._take(self)

            def do_GET(self):
                receiver._take(self)

            def log_message(self, *arguments):
                pass

        self.server = http.server.ThreadingHTTPServer(("127.0.0.1", port), Handler)
        self.server.daemon_threads = True
        self.port, scheme = self.server.server_address[1], "http"
        if certificate:
            context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
            context.load_cert_chain(*certificate)
            self.server.socket = context.wrap_socket(self.server.socket, server_side=True)
            scheme = "https"
        self.url = f"{scheme}://127.0.0.1:{self.port}/in"
        threading.Thread(target=self.server.serve_forever, kwargs={"poll_interval": 0.02}, daemon=True).start()

    def _take(self, handler):
        body = handler.rfile.read(int(handler.headers.get("Content-Length") or 0))
        with self.lock:
            self.got.append(Got({name.lower(): value for name, value in handler.headers.items()}, body))
            status = self.statuses.pop(0) if self.statuses else self.always
        if callable(status):
            return status(handler)
        handler.send_response(status)
        handler.send_header("Content-Length", "0")
        handler.end_headers()

    def all(self, kind=None):
        with self.lock:
            return [one for one in self.got if kind is None or one.document["type"] == kind]

    def close(self):
        self.server.shutdown()
        self.server.server_close()
