"""Times `dripfeed render --mode explicit` on a family of one long loop, and states the rate of the text and the greatest memory.

  tests/bench/explicit_output.py [--binary build/dev/dripfeed] [--machine fanuc-0i-mill] [--runs 3]

Whole process, with reading, computing and writing. Two sizes: what the second takes more than the first is the output alone.
"""

import argparse
import os
import pathlib
import tempfile
import time

FAMILY = """family long-path "A path of many short cuts, one formula a coordinate"
machine mill

param cuts count 1000 in 10..20000000

program path
  work offset 1
  tool 1  diameter 6 mm
  spindle 6000 rpm cw
  feed 500 mm/min
  rapid x 0 mm  y 0 mm
  rapid z 2 mm
  cut z -1 mm
  for n from 1 to cuts step 1
    cut x 40 mm*sin(n*0.01 deg)  y 30 mm*cos(n*0.013 deg)
  end
  retract z 50 mm
  spindle off
end
"""

parser = argparse.ArgumentParser()
parser.add_argument("--binary", default="build/dev/dripfeed")
parser.add_argument("--machine", default="fanuc-0i-mill")
parser.add_argument("--runs", type=int, default=3)
options = parser.parse_args()


def rendered(family, output, cuts):
    """Seconds, bytes and kB of the best run."""
    best = None
    for _ in range(options.runs):
        begin = time.perf_counter()
        arguments = [options.binary, "render", str(family), "--machine", options.machine, "--mode", "explicit", "--set", f"cuts={cuts}", "--output", str(output)]
        child = os.posix_spawn(options.binary, arguments, os.environ, file_actions=[(os.POSIX_SPAWN_OPEN, 2, os.devnull, os.O_WRONLY, 0)])
        _, status, used = os.wait4(child, 0)
        if status != 0:
            raise SystemExit(f"render ended with {status}")
        seconds = time.perf_counter() - begin
        if best is None or seconds < best[0]:
            best = (seconds, output.stat().st_size, used.ru_maxrss)
    return best


with tempfile.TemporaryDirectory() as folder:
    family, output = pathlib.Path(folder, "long.family"), pathlib.Path(folder, "long.nc")
    family.write_text(FAMILY)
    small, large = rendered(family, output, 50_000), rendered(family, output, 200_000)
    for seconds, size, memory in (small, large):
        print(f"{size / 1e6:.1f} MB in {seconds:.2f} s, {memory / 1e3:.0f} MB of memory")
    rate = (large[1] - small[1]) / 1e6 / (large[0] - small[0])
    grown = (large[2] - small[2]) * 1e3 / (large[1] - small[1])
    print(f"{rate:.1f} MB/s, {grown:.2f} bytes of memory for each byte of text")
