"""deploy/run --smoke's script, on the binary that was built. Safety is asserted, speed is not: a test machine is shared."""

import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.exit(subprocess.run([sys.executable, str(ROOT / "deploy/smoke.py"), sys.argv[1], "--without-speed"]).returncode)
