"""A client of `dripfeed lsp`, as far as the tests need one: frames, requests, notifications, and what the server sends by itself."""

import json
import queue
import subprocess
import threading

from rig import binary, expect

SECONDS = 60


def frame(content):
    data = content if isinstance(content, bytes) else json.dumps(content).encode()
    return b"Content-Length: %d\r\n\r\n" % len(data) + data


class Client:
    def __init__(self, *options):
        self.process = subprocess.Popen([str(binary()), "lsp", *map(str, options)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.messages = queue.Queue()
        self.kept = []
        self.number = 0
        threading.Thread(target=self._read, daemon=True).start()

    def _read(self):
        stream = self.process.stdout
        while header := stream.readline():
            length = int(header.split(b":")[1])
            stream.readline()
            self.messages.put(json.loads(stream.read(length)))

    def raw(self, data):
        self.process.stdin.write(data)
        self.process.stdin.flush()

    def send(self, message):
        self.raw(frame({"jsonrpc": "2.0", **message}))

    def notify(self, method, **params):
        self.send({"method": method, "params": params})

    def wait(self, wanted):
        """The first message that is wanted; the others stay for later."""
        for message in self.kept:
            if wanted(message):
                self.kept.remove(message)
                return message
        while True:
            message = self.messages.get(timeout=SECONDS)
            if wanted(message):
                return message
            self.kept.append(message)

    def request(self, method, **params):
        self.number += 1
        number = self.number
        self.send({"id": number, "method": method, "params": params})
        return self.wait(lambda m: m.get("id") == number)

    def result(self, method, **params):
        answer = self.request(method, **params)
        expect("result" in answer, f"{method}: {answer}")
        return answer["result"]

    def refused(self):
        """The code of the next error without an id."""
        return self.wait(lambda m: "error" in m and m["id"] is None)["error"]["code"]

    def start(self, options=None, units=None, trees=True):
        capabilities = {"textDocument": {"documentSymbol": {"hierarchicalDocumentSymbolSupport": trees}}}
        if units:
            capabilities["general"] = {"positionEncodings": units}
        result = self.result("initialize", processId=None, rootUri=None, capabilities=capabilities, initializationOptions=options or {})
        self.notify("initialized")
        return result["capabilities"]

    def open(self, uri, text, version=1):
        self.notify("textDocument/didOpen", textDocument={"uri": uri, "languageId": "nc", "version": version, "text": text})

    def change(self, uri, version, *changes):
        self.notify("textDocument/didChange", textDocument={"uri": uri, "version": version}, contentChanges=list(changes))

    def at(self, method, uri, line, character):
        return self.result("textDocument/" + method, textDocument={"uri": uri}, position={"line": line, "character": character})

    def diagnostics(self, uri, version=1):
        """What the server says of that version once it has nothing more to do: the last message of several."""
        self.result("textDocument/documentSymbol", textDocument={"uri": uri})
        wanted = lambda m: m.get("method") == "textDocument/publishDiagnostics" and m["params"]["uri"] == uri and m["params"]["version"] == version
        found = self.wait(wanted)
        while True:
            self.result("textDocument/documentSymbol", textDocument={"uri": uri})
            try:
                while True:
                    self.kept.append(self.messages.get(timeout=0.5))
            except queue.Empty:
                pass
            later = [m for m in self.kept if wanted(m)]
            if not later:
                return found["params"]["diagnostics"]
            found = later[-1]
            self.kept = [m for m in self.kept if not wanted(m)]

    def end(self, shutdown=True):
        if shutdown:
            self.result("shutdown")
        self.notify("exit")
        return self.process.wait(timeout=SECONDS)
