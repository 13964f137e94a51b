#!/usr/bin/env python3
"""One macro, written by its author for a Fanuc and for a SINUMERIK, and the result that he printed: the same moves?

  tests/bench/macro_pair.py --fanuc O9123 --sinumerik CYCLE189.spf --printed RESULT [--binary build/dev/dripfeed]

The macro is the helical finishing of a bore: down in full circles, once round on the floor, out to the middle, in again, and up in full circles. The
Fanuc one (O9123, called by G65 with C0) and the SINUMERIK one (PROC CYCLE189) take the same values but for two: the Fanuc one counts its depth from
0.001 over the top, the SINUMERIK one from 0.025 over it, so the Fanuc one gets a bottom that is 0.024 deeper. Compared, in inches:

  SINUMERIK and print   every move: kind, end and center
  Fanuc and print       every full circle: direction, start, center, depth, in their order; the paths out of the bore and into it differ by
                        design (cutter compensation there). Comments are taken out of the Fanuc one.

Exits 1 when one is off by more than 1e-4 inch.
"""

import argparse
import math
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
TOLERANCE_INCH = 1e-4 + 1e-9  # the print has four decimals
INCH_MM = 25.4
# The values of the printed call.
BORE, X, Y, PLANE, TOP, FEED, BOTTOM, STEP = 0.5, 5.8883, 10.2375, 0.0947, -0.0053, 5.0, -0.3438, 0.1
FANUC_DEEPER = 0.025 - 0.001

FANUC_CALLER = f"""%
O0001 (CALLER)
G20 G17 G40 G49 G80 G90 G94 S6000 M3
G0 X{X} Y{Y}
G0 Z1.4182
G65 P9123 X{X} Y{Y} Z{TOP} W{BOTTOM - FANUC_DEEPER:.4f} R{PLANE} B{BORE} F{FEED} Q{STEP} C0 D1
M30
%
"""
SINUMERIK_CALLER = f"""G700 G17 G40 G90 G94 S6000 M3
G0 X{X} Y{Y}
G0 Z1.4182
CYCLE189({BORE},{X},{Y},{PLANE},{TOP},{FEED},{BOTTOM},{STEP})
M30
"""
KINDS = {0: "rapid", 1: "linear", 2: "arc-cw", 3: "arc-ccw"}


def without_comments(text):
    """Comments are nested in the author's file, which a control refuses; here each goes from its first "(" to the last ")" of its line."""
    return re.sub(rb"\(.*\)", b"", text)


def trace(binary, dialect, caller, called_name, called_text):
    """The moves of the caller's call: (kind, end, center as I J in inches or None)."""
    with tempfile.TemporaryDirectory() as folder:
        main = pathlib.Path(folder) / ("main.nc" if dialect == "fanuc" else "main.mpf")
        main.write_text(caller)
        (pathlib.Path(folder) / called_name).write_bytes(called_text)
        done = subprocess.run([binary, "run", str(main), "--dialect", dialect, "--path", folder], capture_output=True, text=True, check=False)
    moves = []
    for line in done.stdout.splitlines():
        found = re.match(r"@\d+:\d+ (rapid|linear|arc-cw|arc-ccw) (.*)", line)
        if not found:
            continue
        words = {name: float(value) / INCH_MM for name, value in re.findall(r"\b([XYZIJ])(-?[\d.]+)", found[2])}
        moves.append((found[1], tuple(words[axis] for axis in "XYZ"), (words["I"], words["J"]) if "I" in words else None))
    if not moves:
        sys.exit(f"{dialect}: no moves of the macro\n{done.stdout}{done.stderr}")
    return moves


def printed(path):
    """The moves of the print, in the same form. A word that is not there keeps its value; J without a word is 0."""
    at, kind, moves = {"X": X, "Y": Y, "Z": 1.4182}, None, []
    for line in path.read_text(encoding="latin-1").splitlines():
        words = re.findall(r"([A-Z])(-?[\d.]+)", line.split(";")[0])
        codes = [int(value) for letter, value in words if letter == "G" and int(value) in KINDS]
        axes = {letter: float(value) for letter, value in words if letter in "XYZIJ"}
        if codes:
            kind = KINDS[codes[-1]]
        if not axes:
            continue
        start = dict(at)
        at.update({axis: axes[axis] for axis in "XYZ" if axis in axes})
        center = (start["X"] + axes.get("I", 0.0), start["Y"] + axes.get("J", 0.0)) if kind.startswith("arc") else None
        moves.append((kind, tuple(at[axis] for axis in "XYZ"), center))
    return moves


def centered(moves, start):
    """The same moves with the absolute center of each arc in place of I and J, which count from its start."""
    out = []
    for kind, end, offset in moves:
        out.append((kind, end, (start[0] + offset[0], start[1] + offset[1]) if offset else None))
        start = end
    return out


def off_by(a, b):
    """The largest distance of one coordinate; infinite when the moves are of different kinds."""
    if a[0] != b[0] or (a[2] is None) != (b[2] is None):
        return math.inf
    pairs = list(zip(a[1], b[1])) + (list(zip(a[2], b[2])) if a[2] else [])
    return max(abs(x - y) for x, y in pairs)


def full_circles(moves, start):
    out = []
    for move in moves:
        if move[2] and math.dist(start[:2], move[1][:2]) < TOLERANCE_INCH:
            out.append(move)
        start = move[1]
    return out


def compare(name, ours, theirs):
    worst = max((off_by(a, b) for a, b in zip(ours, theirs)), default=math.inf)
    same = len(ours) == len(theirs) and worst <= TOLERANCE_INCH
    print(f"{name}: {len(ours)} moves, {len(theirs)} printed, worst {worst:.6f} inch: {'the same' if same else 'NOT the same'}")
    if not same:
        for a, b in zip(ours, theirs):
            print(f"  {off_by(a, b):.6f}  {a}  {b}")
    return same


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--fanuc", type=pathlib.Path, required=True)
    parser.add_argument("--sinumerik", type=pathlib.Path, required=True)
    parser.add_argument("--printed", type=pathlib.Path, required=True)
    parser.add_argument("--binary", default=str(ROOT / "build/dev/dripfeed"))
    given = parser.parse_args()

    start = (X, Y, 1.4182)
    wanted = printed(given.printed)
    siemens = centered(trace(given.binary, "sinumerik-840d", SINUMERIK_CALLER, "CYCLE189.spf", given.sinumerik.read_bytes()), start)
    # The macro stands after its own test caller in one file.
    macro = given.fanuc.read_bytes()
    macro = b"%\n" + without_comments(macro[macro.index(b"O9123") :])
    fanuc = centered(trace(given.binary, "fanuc", FANUC_CALLER, "O9123", macro), start)
    same = compare("SINUMERIK and print", siemens, wanted)
    same &= compare("Fanuc and print, full circles", full_circles(fanuc, start), full_circles(wanted, start))
    same &= compare("Fanuc and SINUMERIK, full circles", full_circles(fanuc, start), full_circles(siemens, start))
    return 0 if same else 1


if __name__ == "__main__":
    sys.exit(main())
