"""Motions, dwells and messages of a run, read from dripfeed's trace and from LinuxCNC's canonical calls into one form.

An event is (kind, values): ("rapid", six ends), ("feed", six ends, feed or None), ("arc", six ends, centre or None, turn), ("dwell", seconds),
("message", text). Lengths are mm; ends are those of X Y Z A B C in the coordinates of the program. Moves that go nowhere are left out of both.
"""

import re

TOLERANCE = 2e-4  # both print four decimals
TOLERANCE_INCH = 1.4e-3  # … of an inch there
# Calls whose arguments are numbers.
NUMBERED = ("SET_FEED_RATE", "STRAIGHT_TRAVERSE", "STRAIGHT_FEED", "STRAIGHT_PROBE", "ARC_FEED", "DWELL")
PLANES = {"XY": "XYZ", "YZ": "YZX", "XZ": "ZXY"}
NUMBER = re.compile(r"[-+]?\d+(?:\.\d*)?(?:e[-+]?\d+)?|[-+]?\.\d+")


def ends_of(words):
    return [float(words[axis]) for axis in "XYZABC"]


def ours(trace):
    """Events of `dripfeed run --trace motions`."""
    events = []
    for line in trace.splitlines():
        found = re.match(r"(?:@\d+:)?\d+ (\S+) ?(.*)", line)
        if not found:
            continue
        kind, rest = found.groups()
        words = dict(re.findall(r"(?:^| )([A-Z])(-?[\d.]+)", rest))
        if kind == "rapid":
            events.append(("rapid", ends_of(words), None))
        elif kind in ("linear", "thread", "spline"):
            feed = re.search(r" F([\d.]+)/min", rest) if kind == "linear" else None
            events.append(("feed", ends_of(words), float(feed[1]) if feed else None))
        elif kind in ("arc-cw", "arc-ccw"):
            feed = re.search(r" F([\d.]+)/min", rest)
            events.append(("arc", ends_of(words), float(feed[1]) if feed else None))
        elif kind == "dwell":
            events.append(("dwell", float(words["P"]), None))
        elif kind == "message":
            events.append(("message", rest.strip().strip('"'), None))
    return events


class Canon:
    """The state that canonical calls count on: unit, plane, feed."""

    def __init__(self):
        self.unit, self.plane, self.feed, self.events = 1.0, "XY", None, []

    def ends(self, values):
        return [value * self.unit for value in values[:3]] + list(values[3:6])

    def call(self, name, text):
        values = [float(value) for value in text.split(",")] if name in NUMBERED else []
        if name == "USE_LENGTH_UNITS":
            self.unit = 25.4 if "INCH" in text else 1.0
        elif name == "SELECT_PLANE":
            self.plane = text.rsplit("_", 1)[1]
        elif name == "SET_FEED_RATE":
            self.feed = values[0] * self.unit
        elif name == "SET_FEED_MODE":
            self.feed = None
        elif name in ("STRAIGHT_TRAVERSE", "STRAIGHT_FEED", "STRAIGHT_PROBE"):
            kind = "rapid" if name == "STRAIGHT_TRAVERSE" else "feed"
            self.events.append((kind, self.ends(values), self.feed if kind == "feed" else None))
        elif name == "ARC_FEED":
            first, second, _, _, turns, normal = values[:6]
            ends = dict(zip(PLANES[self.plane], (first, second, normal)))
            # Further turns are arcs of their own in the trace: only the last end is compared.
            self.events.append(("arc", self.ends([ends[axis] for axis in "XYZ"]) + values[6:9], self.feed))
        elif name == "DWELL":
            self.events.append(("dwell", values[0], None))
        elif name == "MESSAGE":
            self.events.append(("message", text.strip('"'), None))


def peers(text):
    """Events of rs274's canonical calls."""
    canon = Canon()
    for line in text.splitlines():
        found = re.match(r"\s*(?:\d+)?\s*N\S*\s+([A-Z0-9_]+)\((.*)\)\s*$", line)
        if found:
            canon.call(found[1], found[2])
        elif line.strip():
            canon.events.append(("message", line.strip(), None))  # what PRINT writes
    return canon.events


def essential(events):
    """Without straight moves that go nowhere and dwells of no time."""
    kept, at = [], [0.0] * 6
    for event in events:
        if event[0] in ("rapid", "feed", "arc"):
            if event[0] != "arc" and max(abs(a - b) for a, b in zip(event[1], at)) < TOLERANCE:
                continue
            at = event[1]
        if event[0] != "dwell" or event[1] > 0.0:
            kept.append(event)
    return kept


def same_text(a, b):
    """Texts are alike when their words are and their numbers are as far as the coarser one is written."""
    numbers = [[found[0] for found in NUMBER.finditer(text)] for text in (a, b)]
    words = [" ".join(NUMBER.sub("0", text).split()) for text in (a, b)]
    if words[0] != words[1] or len(numbers[0]) != len(numbers[1]):
        return False
    for one, other in zip(*numbers):
        decimals = min(len(part.partition(".")[2]) for part in (one, other))
        if abs(float(one) - float(other)) > 0.51 * 10.0**-decimals:
            return False
    return True


def same(a, b, tolerance=TOLERANCE):
    if a[0] != b[0]:
        return False
    if a[0] == "message":
        return same_text(a[1], b[1])
    if a[0] == "dwell":
        return abs(a[1] - b[1]) < tolerance
    # A feed that either does not give per minute is not compared.
    feeds_differ = a[2] is not None and b[2] is not None and abs(a[2] - b[2]) > 1e-3 * max(1.0, abs(b[2]))
    return not feeds_differ and max(abs(x - y) for x, y in zip(a[1], b[1])) <= tolerance


def first_difference(mine, theirs, tolerance=TOLERANCE):
    """In words, or None."""
    mine, theirs = essential(mine), essential(theirs)
    for index, (a, b) in enumerate(zip(mine, theirs)):
        if not same(a, b, tolerance):
            return f"event {index}: {a} here, {b} there"
    if len(mine) != len(theirs):
        longer = mine if len(mine) > len(theirs) else theirs
        return f"{len(mine)} events here, {len(theirs)} there, the first beyond {longer[min(len(mine), len(theirs))]}"
    return None
