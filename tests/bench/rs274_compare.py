#!/usr/bin/env python3
"""Plain mill programs here and in LinuxCNC's stand-alone interpreter: where every motion ends, compared point by point.

  tests/bench/rs274_compare.py --peer 'rs274 {file}' [--binary build/dev/dripfeed] [--language fanuc|linuxcnc] [--programs 500] [--seed 1]
      [--keep FOLDER]

linuxcnc: programs of LinuxCNC's own language (oword_programs.py), the same text for both; moves, feeds and messages in their order.

fanuc: each program is made from its seed: G0 to G3 in the three planes, arcs by R and by I J K, millimetres and inches, G90 and G91, and the drilling
cycles G81 to G83 with G98 and G99. The peer's command prints its canonical calls; {file} stands for the program. What the two write differently is
written twice: repeats (K here, L there), the end (M30, M2). What their cycles do differently by design is left out of both: how far a peck comes
back into the hole before it goes on. Exits 1 when a point is off by more than 1e-4 mm.
"""

import argparse
import math
import pathlib
import random
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

import canon
from oword_programs import OWordProgram

ROOT = pathlib.Path(__file__).resolve().parents[2]
TOLERANCE_MM = 1e-4
AXES = {17: "XY", 18: "ZX", 19: "YZ"}
CENTERS = {"X": "I", "Y": "J", "Z": "K"}
# rs274's canonical arcs name the two axes of the plane first.
ARC_ORDER = {"XY": "XYZ", "YZ": "YZX", "XZ": "ZXY"}


def word(letter, value):
    return f"{letter}{value:.4f}"


class Writer:
    """One program, written for both as it goes."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.inch = self.random.random() < 0.3
        self.scale = 1 / 25.4 if self.inch else 1.0
        self.at = {"X": 0.0, "Y": 0.0, "Z": 0.0}
        self.plane, self.absolute = 17, True
        self.ours, self.peers = [], []
        self.both(f"{'G20' if self.inch else 'G21'} G90 G94 G17 G40 G49 G80")
        self.both(f"F{self.number(50, 900) * self.scale:.1f}")
        self.both("G0 X0. Y0. Z0.")

    def both(self, line):
        self.ours.append(line)
        self.peers.append(line)

    def number(self, low, high):
        return self.random.uniform(low, high)

    def go(self, **to):
        """Words of the axes, in the present distance mode; keeps the place as both controls read it."""
        words = []
        for axis, value in to.items():
            written = value if self.absolute else value - self.at[axis]
            words.append(word(axis, written))
            rounded = round(written, 4)
            self.at[axis] = rounded if self.absolute else self.at[axis] + rounded
        return " ".join(words)

    def somewhere(self, axes):
        return {axis: self.number(-60, 60) * self.scale for axis in axes}

    def line(self):
        axes = self.random.sample("XYZ", self.random.randint(1, 3))
        self.both(f"G{self.random.randint(0, 1)} {self.go(**self.somewhere(sorted(axes)))}")

    def arc(self):
        """By its center, so that the end is on the circle as well as four decimals allow, or by R."""
        first, second = AXES[self.plane]
        code = self.random.choice(("G2", "G3"))
        if self.random.random() < 0.5:
            radius = self.number(5, 40) * self.scale
            chord, angle = radius * self.number(0.3, 1.7), self.number(0, math.tau)
            end = {first: self.at[first] + chord * math.cos(angle), second: self.at[second] + chord * math.sin(angle)}
            sign = self.random.choice((1, -1))
            return self.both(f"{code} {self.go(**end)} {word('R', sign * radius)}")
        # Quarters: both offsets are the same number, so that the end has the radius of the start exactly.
        leg = round(self.number(4, 30) * self.scale, 4)
        turn = 1 if code == "G3" else -1
        center = {first: 0.0, second: leg * turn}
        end = {first: self.at[first] + leg, second: self.at[second] + leg * turn}
        helix = next(axis for axis in "XYZ" if axis not in (first, second))
        if self.random.random() < 0.4:
            end[helix] = self.at[helix] + self.number(-3, 3) * self.scale
        self.both(f"{code} {self.go(**end)} {word(CENTERS[first], center[first])} {word(CENTERS[second], center[second])}")

    def drill(self):
        """From above the hole, in G17."""
        self.set_plane(17)
        start = 20 * self.scale
        self.set_absolute(True)
        self.both(f"G0 {self.go(Z=start)}")
        reference = round(self.number(1, 6) * self.scale, 4)
        depth = round(-self.number(3, 25) * self.scale, 4)
        code = self.random.choice((81, 82, 83))
        extra = {81: "", 82: " P100", 83: f" {word('Q', self.number(2, 8) * self.scale)}"}[code]
        peer_extra = extra.replace("P100", "P0.1")
        level = self.random.choice((98, 99))
        head = f"G{level} G{code} {self.go(**self.somewhere('XY'))} {word('Z', depth)} {word('R', reference)}"
        self.ours.append(head + extra)
        self.peers.append(head + peer_extra)
        for _ in range(self.random.randint(0, 3)):
            self.both(self.go(**self.somewhere("XY")))
        if self.random.random() < 0.5 and level == 98:
            self.set_absolute(False)
            # In G91 Z and R count from other planes, so both are stated again.
            again = f"{word('X', 7 * self.scale)} {word('Y', 2 * self.scale)} {word('Z', depth - reference)} {word('R', reference - start)}"
            self.ours.append(f"{again} K3")
            self.peers.append(f"{again} L3")
            for axis, by in (("X", 7), ("Y", 2)):
                self.at[axis] += 3 * round(by * self.scale, 4)
            self.set_absolute(True)
        self.both("G80")
        self.both(f"G0 {self.go(Z=start)}")

    def set_plane(self, plane):
        self.plane = plane
        self.both(f"G{plane}")

    def set_absolute(self, absolute):
        self.absolute = absolute
        self.both("G90" if absolute else "G91")

    def block(self):
        pick = self.random.random()
        if pick < 0.45:
            self.line()
        elif pick < 0.75:
            self.arc()
        elif pick < 0.83:
            self.set_plane(self.random.choice((17, 18, 19)))
        elif pick < 0.90:
            self.set_absolute(not self.absolute)
        else:
            self.drill()

    def texts(self, blocks):
        for _ in range(blocks):
            self.block()
        ours = "%\nO0001\n" + "\n".join(self.ours) + "\nM30\n%\n"
        return ours, "\n".join(self.peers) + "\nM2\n"


def our_points(binary, path):
    ended = subprocess.run([binary, "run", "--dialect", "fanuc", "--control", "kind=mill", path], capture_output=True, text=True)
    if ended.returncode != 0:
        raise AssertionError(f"dripfeed: {ended.stderr[:400]}")
    points = []
    for line in ended.stdout.splitlines():
        found = re.match(r"\d+ (rapid|linear|arc-cw|arc-ccw) X(\S+) Y(\S+) Z(\S+)", line)
        if found:
            points.append((found[1][:3], *map(float, found.groups()[1:])))
    return points


def peer_points(command, path, inch):
    ended = subprocess.run([part.replace("{file}", str(path)) for part in shlex.split(command)], capture_output=True, text=True)
    if ended.returncode != 0:
        raise AssertionError(f"the peer: {(ended.stderr or ended.stdout)[-400:]}")
    points, plane = [], "XY"
    unit = 25.4 if inch else 1.0
    for line in ended.stdout.splitlines():
        found = re.search(r"(STRAIGHT_TRAVERSE|STRAIGHT_FEED|ARC_FEED|SELECT_PLANE)\(([^)]*)\)", line)
        if not found:
            continue
        if found[1] == "SELECT_PLANE":
            plane = found[2].rsplit("_", 1)[1]
            continue
        values = [float(value) for value in found[2].split(",")]
        if found[1] == "ARC_FEED":
            ends = dict(zip(ARC_ORDER[plane], (values[0], values[1], values[5])))
            points.append(("arc", *(ends[axis] * unit for axis in "XYZ")))
        else:
            kind = "rap" if found[1] == "STRAIGHT_TRAVERSE" else "lin"
            points.append((kind, *(value * unit for value in values[:3])))
    return points


def essential(points):
    """Without moves that go nowhere, and without a peck's return into its hole: a rapid straight down between a rapid up and a cut."""
    kept = []
    for index, point in enumerate(points):
        before = points[index - 1][1:] if index else (0.0, 0.0, 0.0)
        if max(abs(a - b) for a, b in zip(point[1:], before)) < TOLERANCE_MM:
            continue
        straight_down = point[0] == "rap" and abs(point[1] - before[0]) < TOLERANCE_MM and abs(point[2] - before[1]) < TOLERANCE_MM and point[3] < before[2]
        after = points[index + 1] if index + 1 < len(points) else None
        into_hole = straight_down and index > 1 and points[index - 1][0] == "rap" and points[index - 2][0] == "lin" and after and after[0] == "lin"
        if not into_hole:
            kept.append(point)
    return kept


def compare(ours, peers):
    """The first difference in words, or None."""
    for index, (a, b) in enumerate(zip(ours, peers)):
        if a[0] != b[0] or max(abs(x - y) for x, y in zip(a[1:], b[1:])) > TOLERANCE_MM:
            return f"motion {index}: {a} here, {b} there"
    return None if len(ours) == len(peers) else f"{len(ours)} motions here, {len(peers)} there"


def peer_output(command, path):
    try:
        ended = subprocess.run([part.replace("{file}", str(path)) for part in shlex.split(command)], capture_output=True, text=True, timeout=20)
    except subprocess.TimeoutExpired:
        raise AssertionError("the peer does not end") from None
    if ended.returncode != 0:
        raise AssertionError(f"the peer: {(ended.stderr or ended.stdout)[-400:]}")
    return ended.stdout


def compare_language(given, name):
    """Programs and events of LinuxCNC's language that were compared, and the seeds of those that differ."""
    differ, compared = [], 0
    path = pathlib.Path(name) / "program.ngc"
    for seed in range(given.seed, given.seed + given.programs):
        path.write_text(OWordProgram(seed).text())
        ended = subprocess.run([given.binary, "run", "--dialect", "linuxcnc", path], capture_output=True, text=True)
        theirs = []
        try:
            theirs = canon.peers(peer_output(given.peer, path))
            fault = ended.stderr[:400] if ended.returncode else canon.first_difference(canon.ours(ended.stdout), theirs, TOLERANCE_MM)
        except AssertionError as refused:
            fault = None if ended.returncode else str(refused)
        compared += len(theirs)
        if fault:
            differ.append(seed)
            print(f"seed {seed}: {fault}")
            if given.keep:
                shutil.copy(path, pathlib.Path(given.keep) / f"{seed}.ngc")
    return compared, differ


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--peer", required=True)
    options.add_argument("--binary", default=ROOT / "build/dev/dripfeed")
    options.add_argument("--language", choices=("fanuc", "linuxcnc"), default="fanuc")
    options.add_argument("--programs", type=int, default=500)
    options.add_argument("--blocks", type=int, default=40)
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--keep", help="folder for the programs that differ")
    given = options.parse_args()
    differ, compared = 0, 0
    with tempfile.TemporaryDirectory(prefix="dripfeed-rs274-") as name:
        if given.language == "linuxcnc":
            compared, seeds = compare_language(given, name)
            print(f"{given.programs} programs, {compared} moves and messages, {len(seeds)} programs differ")
            return 1 if seeds else 0
        for seed in range(given.seed, given.seed + given.programs):
            writer = Writer(seed)
            texts = writer.texts(given.blocks)
            paths = [pathlib.Path(name) / f"{side}.ngc" for side in ("ours", "peers")]
            for path, text in zip(paths, texts):
                path.write_text(text)
            try:
                ours, peers = essential(our_points(given.binary, paths[0])), essential(peer_points(given.peer, paths[1], writer.inch))
                fault = compare(ours, peers)
                compared += len(ours)
            except AssertionError as refused:
                fault = str(refused)
            if fault:
                differ += 1
                print(f"seed {seed}: {fault}")
                if given.keep:
                    for path, text in zip(paths, texts):
                        (pathlib.Path(given.keep) / f"{seed}-{path.name}").write_text(text)
    print(f"{given.programs} programs, {compared} motions, {differ} programs differ by more than {TOLERANCE_MM} mm")
    return 1 if differ else 0


if __name__ == "__main__":
    sys.exit(main())
