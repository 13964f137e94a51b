"""The path of an order as a MES drives it, by the client that is generated from the description (web/test/mes.ts), against the server and a simulated
control."""

import hashlib
import json
import os
import subprocess
import sys
import tempfile

from rig import ROOT, Rig, binary, expect, plain_program, shop

CALLERS = {"MES": ("operator", "queue"), "PROGRAMMER": ("programmer", None), "APPROVER": ("approver", None), "OPERATOR": ("operator", None)}


def token(data, name, role, scope):
    """The operator's has the name that the arming has to bear."""
    command = [binary(), "token", "add", f"the {name.lower()}", "--role", role, "--data", data, *(["--scope", scope] if scope else [])]
    return subprocess.run(list(map(str, command)), capture_output=True, text=True, check=True, timeout=30).stdout.strip()


def bundle(into):
    """As one file that node runs."""
    esbuild = ROOT / "web/node_modules/.bin/esbuild"
    subprocess.run([esbuild, ROOT / "web/test/mes.ts", "--bundle", "--platform=node", "--format=esm", "--log-level=warning", f"--outfile={into}"], check=True)


def main():
    with tempfile.TemporaryDirectory(prefix="dripfeed-mes-") as folder:
        script = f"{folder}/mes.mjs"
        bundle(script)
        rig = Rig(folder, f"tcp://127.0.0.1:{shop.free_port()}", baud=19200)
        rig.server.start()
        control = rig.control()
        try:
            rig.server.add_machine(rig.profile)
            tokens = {f"TOKEN_{name}": token(rig.server.data, name, *what) for name, what in CALLERS.items()}
            text = plain_program(40)
            walk = subprocess.run(["node", script], timeout=200, env={**os.environ, **tokens, "DRIPFEED_URL": f"http://127.0.0.1:{rig.server.port}", "PROGRAM": text})
            expect(walk.returncode == 0, f"the path of the order ended with {walk.returncode}")
            report = control.stop()
            sent = hashlib.sha256(text[: text.rindex("%") + 1].encode()).hexdigest()
            expect(report["text_sha256"] == sent, f"another text arrived: {json.dumps(report)[:1000]}")
        finally:
            if rig.server.alive():
                rig.server.kill()


if __name__ == "__main__":
    sys.exit(main())
