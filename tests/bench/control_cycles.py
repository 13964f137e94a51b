#!/usr/bin/env python3
"""Whether the standard cycles that dripfeed brings along move as the cycles of a control do: the texts of a control (CST.DIR of its archive, or any
folder with CYCLE83.SPF …) are run by dripfeed in the place of its own, with random parameters.

  tests/bench/control_cycles.py FOLDER [--binary build/release/dripfeed] [--count 200] [--seed 1] [CYCLE…]

Machine data and states that the texts ask for are put in as a control in millimetres without test mode has them. Compared are the moves and dwells; the
kind of the retract in CYCLE83 and the turns of the spindle between are left out, which the texts of different years do otherwise. A program's end
counts as the same when both stop by the same alarm.
"""

import argparse
import collections
import difflib
import pathlib
import random
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
HEAD = "G17 G90 G710 G94 G54\nT1 D1 M6\nG0 X0 Y0 Z50\nF100 S500 M3\n"
MOST_BLOCKS = 3000  # a factor that never comes to the depth
MEANT = [
    (r"\$MN_SCALING_VALUE_INCH", "25.4"),
    (r"\$MN_SCALING_SYSTEM_IS_METRIC", "TRUE"),
    (r"\$P_DRYRUN|\$P_ISTEST", "FALSE"),
    (r"ISAXIS\([^)]*\)", "1==1"),
    (r"\$P_ACTFRAME\[_Z,SC\]", "1"),
    (r"\$P_MC\b", "1"),
    (r"\$AN_NCK_VERSION", "430000"),
    (r"\$P_SMODE\[\$P_MSNUM\]", "2"),
    (r"\$MC_ROUNDAXIS_FOR_SPINDLE\[\$P_MSNUM\]", "-1"),
    (r"IP\[_Z\]=", "K="),
]
PATTERN = "MCALL CYCLE82(10,0,2,-5,,0)\n%s\nMCALL"
CALLS = {
    "CYCLE81": ("CYCLE81(%s)", [(30,), (0, 5), (0, 1, 2), (-27, -20, ""), ("", 27, 20)]),
    "CYCLE82": ("CYCLE82(%s)", [(30,), (0,), (0, 1, 2), (-27, -20, ""), ("", 27, 20), (0, 1, -3, "")]),
    "CYCLE83": (
        "CYCLE83(%s)",
        [(30,), (0,), (0, 1, 2), (-27, -20, -7.5, -31.3), ("",), ("",), (8, 5, 10, 30), (1, 2, 3, 0.5, -0.8, -0.5, -1), (0, 0.5, -2), (0, 0.3, -3)]
        + [(1, 0.7, 0.5), (0, 1), (3,), (1, 2, 4), (0, 0.5, 1), (0, 0.6, -2), (0, 0.8, 1.5)],
    ),
    "CYCLE84": (
        "CYCLE84(%s)",
        [(30,), (0,), (1, 2), (-12, -7.5, -21), ("",), (0, 0.5, ""), (3, 4, 5), ("",), (1, 1.25, -1.5), (0, 90), (200, 300), (0, 250, 400), (3,)]
        + [(0,), (0,), (0, 1, 2), (3, 5, 10), (0, 0.7)],
    ),
    "HOLES1": (PATTERN % "HOLES1(%s)", [(0, 10, -20), (0, 5, 30), (0, 30, 90, 200, -45), (0, 5, 20), (10, 5), (1, 2, 5)]),
    "HOLES2": (PATTERN % "HOLES2(%s)", [(0, 10, -20), (0, 5, 30), (10, 25), (0, 30, 90, 200, -45), (0, 45, 60, -30), (1, 2, 5, 6)]),
}


def trace(binary, program, folder=None):
    command = [binary, "run", program, "--dialect", "sinumerik-840d", "--control", "kind=mill", "--limit", f"blocks={MOST_BLOCKS}"]
    if folder:
        command += ["--path", folder]
    ran = subprocess.run(command, capture_output=True, text=True, check=False)
    if not ran.stdout:
        sys.exit(ran.stderr)
    alarm = re.search(r"\(alarm (\d+)\)", ran.stdout + ran.stderr)
    moves = []
    for line in ran.stdout.splitlines():
        what = re.match(r"(?:@\d+:)?\d+ (rapid|linear|thread|dwell) (.*)", line)
        if not what or line.endswith("dwell P0.0000"):
            continue
        kind = "move" if what[1] in ("rapid", "linear") else what[1]
        moves.append(kind + " " + re.sub(r" F\S+/min", "", what[2]))
    return moves, alarm and alarm[1]


def prepare(folder, into):
    names = set()
    for path in folder.iterdir():
        name = path.stem.upper()
        if path.suffix.upper() != ".SPF" or name not in CALLS:
            continue
        text = path.read_text(encoding="latin-1")
        for asked, answer in MEANT:
            text = re.sub(asked, answer, text)
        (into / f"{name}.SPF").write_text(text, encoding="latin-1")
        names.add(name)
    (into / "MELDUNG.SPF").write_text("PROC MELDUNG(INT NUMBER)\nM17\n", encoding="latin-1")
    return names


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("cycles", nargs="*")
    parser.add_argument("--binary", default=str(ROOT / "build/release/dripfeed"))
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    chance = random.Random(options.seed)
    found = collections.Counter()
    with tempfile.TemporaryDirectory() as made:
        texts = pathlib.Path(made) / "texts"
        texts.mkdir()
        present = prepare(options.folder, texts)
        program = pathlib.Path(made) / "CALLER.MPF"
        for name in options.cycles or sorted(present):
            form, values = CALLS[name]
            for _ in range(options.count):
                call = form % ",".join(str(chance.choice(each)) for each in values)
                program.write_text(f"{HEAD}{call}\nM30\n")
                ours, theirs = trace(options.binary, program), trace(options.binary, program, texts)
                same = ours == theirs
                found[name, same] += 1
                if not same and found[name, False] <= 2:
                    print(call)
                    print("\n".join(difflib.unified_diff(ours[0], theirs[0], "built in", "of the control", lineterm="", n=1)))
            print(f"{name}: {found[name, True]} the same, {found[name, False]} not")
    return 1 if any(not same for _, same in found) else 0


if __name__ == "__main__":
    sys.exit(main())
