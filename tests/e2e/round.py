"""A person's round in the browser against the real server: the demo shop runs, round.mjs arms a job on the page and sees it through, tour.mjs
takes the guided tour of what the demo has, and looks.mjs walks the views of each role on every size of screen. A file named after the binary is walked alone."""

import os
import pathlib
import signal
import subprocess
import sys
import tempfile

from rig import ROOT, binary, expect, shop


def main():
    with tempfile.TemporaryDirectory(prefix="dripfeed-round-") as name:
        data = pathlib.Path(name)
        port = shop.free_port()
        demo = subprocess.Popen([sys.executable, str(ROOT / "deploy/demo.py"), str(binary()), str(data), str(port)], stdout=subprocess.PIPE, text=True)
        try:
            shop.wait_for("the demo's address", lambda: demo.stdout.readline().startswith("Arm a queued job"), 60)
            token = (data / "first-token").read_text().strip()
            for name in sys.argv[2:] or ("tour.mjs", "round.mjs", "looks.mjs"):
                walk = subprocess.run(["node", str(ROOT / "tests/e2e/web" / name)], timeout=540,
                                      env={**os.environ, "DRIPFEED_URL": f"http://127.0.0.1:{port}", "DRIPFEED_TOKEN": token})
                expect(walk.returncode == 0, f"{name} ended with {walk.returncode}")
        finally:
            demo.send_signal(signal.SIGTERM)
            demo.wait(20)


if __name__ == "__main__":
    main()
