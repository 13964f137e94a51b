#!/usr/bin/env python3
"""Gouges and accuracy of the shipped families at the corners of what their ranges and conditions allow.

family_corners.py BINARY [--families NAME ...] [--corners N] [--machine NAME] [--seed N]: for each family, its numbers and those of its lists at the
least or largest value of each range with each word of its choices, all combinations or N of them (200) by a seeded choice. Where a condition refuses
one, the line from the usual values to it is bisected, and the last point that is allowed is measured. The machine is the preset with tools
of whatever diameter the family asks for, and long enough. A point fails where gouges or accuracy do, where it cannot be rendered, or where
something is not checked that is checked at the usual values; what the machine refuses (travel, speed) is counted apart: gouges and accuracy
pass there, too. A corner with many small steps takes minutes, or more blocks than are interpreted: 60 s are waited for each."""
import argparse
import collections
import concurrent.futures
import itertools
import json
import math
import pathlib
import random
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
MACHINES = {"lathe": "fanuc-0i-lathe", "mill": "fanuc-0i-mill"}
OTHER = {"worm": "mazak-vcn", "worm-turned": "mazak-integrex", "turning-cycle": "sinumerik-840d-lathe", "seal-ring": "sinumerik-810d-lathe"}
NUMBER = r"-?[0-9.]+(?:e-?[0-9]+)?"
PARAM = re.compile(rf"^param (\w+)\s+(length|angle|feed|speed|count|ratio|time)\s+({NUMBER})\s*([a-z/]*)\s+in ({NUMBER})\.\.({NUMBER})", re.M)
# Not knots, which rise.
LIST = re.compile(rf"^param (?!knot)(\w+)\s+list of (length|ratio) ([-0-9., a-z]+?)\s+in ({NUMBER})\.\.({NUMBER})", re.M)
CHOICE = re.compile(r"^param (\w+)\s+choice (\w+) of ([a-z_]+(?:, [a-z_]+)*)", re.M)


class Family:
    def __init__(self, path):
        self.path, self.name = path, path.stem
        text = path.read_text()
        self.machine = OTHER.get(self.name) or MACHINES[re.search(r"^machine ([a-z]+)", text, re.M).group(1)]
        self.params = [(name, kind, float(usual), unit, float(low), float(high)) for name, kind, usual, unit, low, high in PARAM.findall(text)]
        self.lists = []
        for name, kind, numbers, low, high in LIST.findall(text):
            usual = [float(one.removesuffix("mm")) for one in numbers.split(",")]
            self.lists.append((name, "mm" if kind == "length" else "", usual, float(low), float(high)))
        self.choices = [(name, words.split(", ")) for name, _, words in CHOICE.findall(text)]

    def corners(self, most, choice, kept=()):
        """All, or so many of them: the end of each number's range, by chance one for each of a list, and the word of each choice. What is kept has
        its usual value."""
        ends = [(0.0,) if name in kept else (low - usual, high - usual) for name, _, usual, _, low, high in self.params]
        ends += [words for _, words in self.choices]
        for name, _, usual, low, high in self.lists:
            ends.append([[0.0 if name in kept else choice.choice((low, high)) - one for one in usual] for _ in range(16)])
        if math.prod(map(len, ends)) <= most:
            return list(itertools.product(*ends))
        return [tuple(choice.choice(one) for one in ends) for _ in range(most)]

    def values(self, corner, part):
        """Of the point `part` of the distance from the usual values to the corner."""
        out = []
        for (name, kind, usual, unit, _, _), by in zip(self.params, corner):
            value = usual + part * by
            out.append(f"{name}={round(value) if kind == 'count' else f'{value:.6f}'} {unit}".strip())
        first = len(self.params) + len(self.choices)
        for (name, unit, usual, _, _), by in zip(self.lists, corner[first:]):
            out.append(f"{name}=" + ", ".join(f"{one + part * more:.6f} {unit}".strip() for one, more in zip(usual, by)))
        return out + [f"{name}={word}" for (name, _), word in zip(self.choices, corner[len(self.params):first])]


def with_any_tool(machine, folder):
    """The preset with tools that have the shape that the family states, and no holder."""
    profile = json.loads((ROOT / f"deploy/machines/{machine}.json").read_text())
    for tool in profile["tools"]:
        for key in ("diameter_mm", "corner_radius_mm", "holder"):
            tool.pop(key, None)
    path = pathlib.Path(folder) / f"{machine}.json"
    path.write_text(json.dumps(profile))
    return path


def opened(report):
    """What is left open, without its lines and figures."""
    texts = [one for part in ("gouge", "accuracy") for one in (report[part] or {}).get("not_checked", [])] + report["not_checked"]
    return {re.sub(r" \(line.*\)$|[0-9.]+", "", one) for one in texts}


class Trials:
    """Of a family on a machine."""
    def __init__(self, binary, family, machine, mode="auto", wait=60, bisections=8):
        self.family, self.wait, self.bisections = family, wait, bisections
        self.words = [family.path, "--machine", machine, "--json"]
        self.binary, self.mode = binary, mode
        self.usually_open = opened(json.loads(self.ask("check", mode, []).stdout)["files"][0])

    def ask(self, command, mode, values, wait=None):
        sets = [word for value in values for word in ("--set", value)]
        return subprocess.run([self.binary, command, *self.words, "--mode", mode, *sets], capture_output=True, text=True, timeout=wait)

    def is_allowed(self, values):
        """Whether no condition refuses the values, by the macro: rendering it takes no time."""
        answer = self.ask("render", "macro", values).stdout
        return not any(one["id"] == "family-constraint-failed" for one in json.loads(answer or '{"diagnostics": []}')["diagnostics"])

    def check(self, values):
        """pass, machine, family, open or long, and the first finding."""
        try:
            done = self.ask("check", self.mode, values, self.wait)
        except subprocess.TimeoutExpired:
            return "long", f"more than {self.wait} s"
        if not done.stdout:
            return "long" if "it was not looked at" in done.stderr else "family", done.stderr.strip()
        report = json.loads(done.stdout)["files"][0]
        said = [one for one in report["diagnostics"] if one["severity"] == "error"]
        if any(one["id"] == "limit-reached" for one in report["diagnostics"]):
            return "long", "more blocks than are interpreted"
        if not report["ran"] or any(one["id"].startswith("family-") for one in said):
            return "family", said[0]["text"] if said else done.stderr.strip()
        findings = [one for part in ("gouge", "accuracy") for one in (report[part] or {}).get("findings", [])]
        if findings:
            return "family", f"{findings[0]['id']}: {findings[0]['text']}"
        more = opened(report) - self.usually_open
        beyond = [one for one in said + (report["envelope"] or {}).get("findings", []) if one["severity"] == "error"]
        if beyond:
            return "machine", beyond[0]["text"]
        return ("open", f"not checked: {sorted(more)[0]}") if more else ("pass", "")

    def point(self, corner):
        """The corner, or the last point before it that no condition refuses: whether it is that, its values, and how it ends."""
        values = self.family.values(corner, 1.0)
        if self.is_allowed(values):
            return False, values, *self.check(values)
        low, high = 0.0, 1.0
        for _ in range(self.bisections):
            middle = (low + high) / 2
            if self.is_allowed(self.family.values(corner, middle)):
                low = middle
            else:
                high = middle
        if low == 0.0:
            return True, [], "no point", ""
        values = self.family.values(corner, low)
        return True, values, *self.check(values)

    def measure(self, corners, threads):
        with concurrent.futures.ThreadPoolExecutor(threads) as pool:
            points = list(pool.map(self.point, corners))
        counts = collections.Counter(verdict for _, _, verdict, _ in points)
        counts["refused"] = sum(refused for refused, *_ in points)
        return counts, [(verdict, values, text) for _, values, verdict, text in points]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("binary")
    parser.add_argument("--families", nargs="*", default=[])
    parser.add_argument("--corners", type=int, default=200)
    parser.add_argument("--machine")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--wait", type=int, default=60, help="seconds for each point")
    parser.add_argument("--mode", default="auto", help="macro, explicit or auto")
    parser.add_argument("--all", action="store_true", help="prints each point, not only those that fail")
    options = parser.parse_args()
    failed = False
    with tempfile.TemporaryDirectory() as folder:
        for path in sorted((ROOT / "deploy/families").glob("*.family")):
            if options.families and path.stem not in options.families:
                continue
            family = Family(path)
            machine = options.machine or family.machine
            corners = family.corners(options.corners, random.Random(options.seed))
            trials = Trials(options.binary, family, with_any_tool(machine, folder), options.mode, options.wait)
            counts, points = trials.measure(corners, options.threads)
            print(f"{family.name} on {machine}: {len(family.params)} numbers, {len(family.lists)} lists, {len(family.choices)} choices, {len(corners)} corners, {counts['refused']} "
                  f"refused by a condition and replaced by the last point before them, {counts['no point']} of them by none: {counts['pass']} pass, "
                  f"{counts['machine']} are beyond the machine, {counts['family'] + counts['open']} fail, {counts['long']} take too long", flush=True)
            bad = [one for one in points if one[0] in ("family", "open", "long")]
            for verdict, values, text in points if options.all else bad[:3]:
                print(f"  {verdict}: {text}\n    {' '.join(repr(one) for one in values)}", flush=True)
            failed = failed or bool(bad)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
