#!/usr/bin/env python3
"""Gouges and accuracy of the shipped families at the corners of what their ranges and conditions allow.

family_corners.py BINARY [--families NAME ...] [--corners N] [--machine NAME] [--seed N]: for each family, its numbers at the least or
largest value of each range, all combinations or N of them (200) by a seeded choice. Where a condition refuses one, the line from the usual
values to it is bisected, and the last point that is allowed is measured. A point fails where gouges or accuracy do; what the machine refuses
(travel, speed, the length of its tools) is counted apart. A corner with many small steps takes minutes: 60 s are waited for each."""
import argparse
import collections
import itertools
import json
import pathlib
import random
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
MACHINES = {"lathe": "fanuc-0i-lathe", "mill": "fanuc-0i-mill"}
OTHER = {"worm": "mazak-vcn", "worm-turned": "mazak-integrex", "turning-cycle": "sinumerik-840d-lathe", "seal-ring": "sinumerik-810d-lathe"}
NUMBER = r"-?[0-9.]+(?:e-?[0-9]+)?"
PARAM = re.compile(rf"^param (\w+)\s+(length|angle|feed|speed|count|ratio|time)\s+({NUMBER})\s*([a-z/]*)\s+in ({NUMBER})\.\.({NUMBER})")
BISECTIONS = 8


class Family:
    def __init__(self, path):
        self.path, self.name = path, path.stem
        text = path.read_text()
        self.machine = OTHER.get(self.name) or MACHINES[re.search(r"^machine ([a-z]+)", text, re.M).group(1)]
        found = [PARAM.match(line) for line in text.splitlines()]
        self.params = [(m.group(1), m.group(2), float(m.group(3)), m.group(4), float(m.group(5)), float(m.group(6))) for m in found if m]

    def values(self, corner, part):
        """Of the point `part` of the distance from the usual values to the corner."""
        out = []
        for (name, kind, usual, unit, low, high), end in zip(self.params, corner):
            value = usual + part * ((low, high)[end] - usual)
            out.append(f"{name}={round(value) if kind == 'count' else f'{value:.6f}'} {unit}".strip())
        return out


def trial(binary, family, values, machine):
    """pass, condition, machine or family, and the first finding."""
    words = [word for value in values for word in ("--set", value)]
    try:
        done = subprocess.run([binary, "check", family.path, "--machine", machine, "--json", *words], capture_output=True, text=True, timeout=60)
    except subprocess.TimeoutExpired:
        return "long", "more than 60 s"
    if not done.stdout:
        sys.exit(f"{family.name}: {done.stderr.strip()}")
    report = json.loads(done.stdout)["files"][0]
    said = [one for one in report["diagnostics"] if one["severity"] == "error"]
    if any(one["id"].startswith("family-") for one in said) or not report["ran"]:
        return "condition", said[0]["text"] if said else done.stderr.strip()
    if "which counts" in done.stdout:  # the profile has the tool, of another diameter
        return "machine", "its tool has another diameter"
    for part in ("gouge", "accuracy"):
        for one in (report[part] or {}).get("findings", []):
            # How long its tools are, the machine's profile states.
            return ("machine" if one["id"] == "holder-in-workpiece" else "family"), f"{one['id']}: {one['text']}"
    beyond = [one for one in said + (report["envelope"] or {}).get("findings", []) if one["severity"] == "error"]
    return ("machine", beyond[0]["text"]) if beyond else ("pass", "")


def measure(binary, family, machine, most, choice):
    counts, failures = collections.Counter(), []
    size = len(family.params)
    corners = list(itertools.product((0, 1), repeat=size)) if 2**size <= most else [tuple(choice.choices((0, 1), k=size)) for _ in range(most)]
    for corner in corners:
        values = family.values(corner, 1.0)
        verdict, text = trial(binary, family, values, machine)
        if verdict == "condition":
            counts["refused"] += 1
            low, high, best = 0.0, 1.0, None
            for _ in range(BISECTIONS):
                middle = (low + high) / 2
                values_there = family.values(corner, middle)
                there = trial(binary, family, values_there, machine)
                if there[0] == "condition":
                    high = middle
                else:
                    low, best = middle, (values_there, *there)
            if best is None:
                counts["no point"] += 1
                continue
            values, verdict, text = best
        counts[verdict] += 1
        if verdict in ("family", "long"):
            failures.append((values, text))
    return len(corners), counts, failures


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("binary")
    parser.add_argument("--families", nargs="*", default=[])
    parser.add_argument("--corners", type=int, default=200)
    parser.add_argument("--machine")
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    failed = False
    for path in sorted((ROOT / "deploy/families").glob("*.family")):
        if options.families and path.stem not in options.families:
            continue
        family = Family(path)
        machine = options.machine or family.machine
        tried, counts, failures = measure(options.binary, family, machine, options.corners, random.Random(options.seed))
        print(f"{family.name} on {machine}: {len(family.params)} numbers, {tried} of {2**len(family.params)} corners, {counts['refused']} refused by "
              f"a condition and replaced by the last point before them, {counts['no point']} of them by none: {counts['pass']} pass, "
              f"{counts['machine']} are beyond the machine, {counts['family']} fail, {counts['long']} take too long", flush=True)
        for values, text in failures[:3]:
            print(f"  {text}\n    {' '.join(repr(one) for one in values)}", flush=True)
        failed = failed or bool(failures)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
