"""deploy/run --smoke's script, on the binary that was built. Safety is asserted, speed is not: a test machine is nobody's alone. One that stands still
for some milliseconds makes a DC3 late between two processes, which is the machine's fault and not ours: the whole is tried up to three times, and what
a failed try said is printed. The accounting of unsent characters, which knows no clock, is the unit and wire tests'."""

import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
TRIES = 3

for attempt in range(TRIES):
    ended = subprocess.run([sys.executable, str(ROOT / "deploy/smoke.py"), sys.argv[1], "--without-speed"]).returncode
    if ended == 0:
        break
    print(f"try {attempt + 1} of {TRIES} failed", flush=True)
sys.exit(ended)
