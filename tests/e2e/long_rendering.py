"""Plain blocks of a long path, written while they are computed: the same text by file, by standard output and as JSON, in memory that does not grow with
it; nothing is written of a program that fails late. `tests/e2e/long_rendering.py BINARY`."""

import json
import os
import pathlib
import subprocess
import sys
import tempfile

BINARY = sys.argv[1]
FAMILY = """family long-path "A path of many short cuts"
machine mill
param cuts count 1000 in 10..20000000
param turn_by angle 0.01 deg in 0.001..1
program path
  feed 500 mm/min
  rapid x 0 mm  y 0 mm
  for n from 1 to cuts step 1
    cut x 40 mm*sin(n*turn_by)  y 30 mm*cos(n*turn_by)
  end
ENDING
end
"""


def expect(condition, text):
    if not condition:
        raise AssertionError(text)


def render(family, machine, cuts, *more):
    return subprocess.run([BINARY, "render", str(family), "--machine", machine, "--mode", "explicit", "--set", f"cuts={cuts}", *map(str, more)],
                          capture_output=True, text=True, timeout=120)


def with_little_room(family, output, most_bytes, cuts):
    """Where no file may grow beyond so many bytes, as on a full disk: the error's text."""
    limited = f"trap '' XFSZ; ulimit -f {most_bytes // 1024}; exec \"$0\" \"$@\""
    done = subprocess.run(["bash", "-c", limited, BINARY, "render", str(family), "--machine", "fanuc-0i-mill", "--mode", "explicit", "--set", f"cuts={cuts}", "--output", str(output)],
                          capture_output=True, text=True, timeout=120)
    expect(done.returncode == 2, f"it ended with {done.returncode}: {done.stderr}")
    return done.stderr


def memory_kb(family, output, cuts):
    arguments = [BINARY, "render", str(family), "--machine", "fanuc-0i-mill", "--mode", "explicit", "--set", f"cuts={cuts}", "--output", str(output)]
    child = os.posix_spawn(BINARY, arguments, os.environ, file_actions=[(os.POSIX_SPAWN_OPEN, 2, os.devnull, os.O_WRONLY, 0)])
    _, status, used = os.wait4(child, 0)
    expect(status == 0, f"{cuts} cuts: {status}")
    return used.ru_maxrss


with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    family, output = folder / "long.family", folder / "long.nc"
    family.write_text(FAMILY.replace("ENDING", "  retract z 50 mm"))
    for machine in ("fanuc-0i-mill", "sinumerik-840d-mill", "mitsubishi-m80-cvm800"):
        done = render(family, machine, 40_000, "--output", output)
        expect(done.returncode == 0, done.stderr)
        text = output.read_text()
        answer = json.loads(render(family, machine, 40_000, "--json").stdout)
        expect(text == answer["text"] and len(text) == answer["bytes"], f"{machine}: file and JSON differ")
        expect(f"{answer['blocks']} blocks, {answer['bytes']} bytes" in done.stderr, f"{machine}: {done.stderr}")
        expect(render(family, machine, 40_000).stdout == text, f"{machine}: standard output differs")
    # Steps below the least increment: many positions print as the one before.
    for machine in ("fanuc-0i-mill", "sinumerik-840d-mill"):
        fine = ("--set", "turn_by=0.001 deg")
        text = render(family, machine, 40_000, *fine).stdout
        expect(text == json.loads(render(family, machine, 40_000, "--json", *fine).stdout)["text"] and text.count("\n") > 10_000, f"{machine}: fine steps differ")
    for most_bytes, cuts in ((100 * 1024, 40_000), (4 * 1024, 300)):
        words = with_little_room(family, output, most_bytes, cuts)
        expect("File too large" in words and (not output.exists() or cuts == 40_000), f"{words}: {output.exists()}")
    small = memory_kb(family, output, 1000)
    large = memory_kb(family, output, 1_000_000)
    expect(output.stat().st_size > 14_000_000 and large < small + 8_000, f"{small} and {large} kB for {output.stat().st_size} bytes")
    output.write_text("before\n")
    family.write_text(FAMILY.replace("ENDING", "  cut x 1 mm/(cuts - cuts)"))
    done = render(family, "fanuc-0i-mill", 40_000, "--output", output)
    expect(done.returncode == 1 and output.read_text() == "before\n", f"a division by zero at the end: {done.stderr}")
    done = render(family, "fanuc-0i-mill", 40_000)
    expect(done.returncode == 1 and done.stdout == "", f"a division by zero at the end: {done.stderr}")
    done = render(folder / "long.family", "fanuc-0i-mill", 20_000_001)
    expect(done.returncode == 1 and "cuts" in done.stderr, done.stderr)
    family.write_text(FAMILY.replace("ENDING", "  retract z 50 mm"))
    done = render(family, "fanuc-0i-mill", 1000, "--output", folder / "no" / "such.nc")
    expect(done.returncode == 2 and "such.nc" in done.stderr, done.stderr)
print("ok")
