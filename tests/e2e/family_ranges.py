"""Gouges and accuracy of the shipped families at some corners of what their ranges and conditions allow: two by chance a family, one as macro and one as
plain blocks, where what only makes a program longer keeps its usual value; and points that once failed. `tests/e2e/family_ranges.py BINARY`. All corners:
tests/bench/family_corners.py."""

import concurrent.futures
import pathlib
import random
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/bench"))
from family_corners import Family, Trials, with_any_tool  # noqa: E402

MODES, BISECTIONS, SEED = ("macro", "explicit"), 6, 3
# Of the steps of a program: their least value makes it thousands of times as long.
KEPT = {"layer_depth", "rough_width", "scallop", "points", "finish", "angle_step", "chord_error", "peck", "turn_points", "lead", "cuts", "cut_depth",
        "ramp_depth", "passes", "overlap", "thread_passes", "depth_of_cut", "entry_angle", "helix_angle", "flank_passes", "layer", "root_clearance", "weight"}
# The usual values of what is not named.
ONCE_FAILED = {"round-pocket": (("cutter_diameter=16 mm", "pocket_diameter=16.5 mm"), ("cutter_diameter=79.8 mm", "pocket_diameter=80 mm"))}
REFUSED = {"round-pocket": ("cutter_diameter=59.999 mm",), "nurbs-profile": ("steps=4",)}


def expect(condition, text):
    if not condition:
        raise AssertionError(text)


def at_corners(binary, path, folder):
    family = Family(path)
    own = pathlib.Path(folder) / family.name
    own.mkdir()
    machine = with_any_tool(family.machine, own)
    corners = family.corners(len(MODES), random.Random(f"{SEED} {family.name}"), KEPT)
    verdicts = []
    for mode, corner in zip(MODES, corners, strict=True):
        trials = Trials(binary, family, machine, mode, bisections=BISECTIONS)
        points = [trials.point(corner)[1:]] + [(list(values), *trials.check(values)) for values in ONCE_FAILED.get(family.name, ())]
        for values, verdict, text in points:
            # No point: a condition refuses whatever leads there from the usual values.
            expect(verdict in ("pass", "machine", "no point"), f"{family.name}, {mode}, {values}: {verdict}: {text}")
            verdicts.append(verdict)
        for value in REFUSED.get(family.name, ()):
            expect(not trials.is_allowed([value]), f"{family.name}: {value} is not refused")
    return f"{family.name} on {family.machine}: {', '.join(verdicts)}"


def main():
    binary = sys.argv[1]
    with tempfile.TemporaryDirectory() as name, concurrent.futures.ThreadPoolExecutor(2) as pool:
        jobs = [pool.submit(at_corners, binary, path, name) for path in sorted((ROOT / "deploy/families").glob("*.family"))]
        failed = [str(job.exception()) for job in jobs if job.exception()]
        print("\n".join(failed or [job.result() for job in jobs]))
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
