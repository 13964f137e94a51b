"""Reads the Prometheus text format 0.0.4 strictly, as its specification says it, and nothing else. Debian's own reader of it, and promtool where
it is on the PATH, look at the same text."""

import math
import re
import shutil
import subprocess

from prometheus_client.parser import text_string_to_metric_families

from rig import expect

NAME = re.compile(r"[a-zA-Z_:][a-zA-Z0-9_:]*")
LABEL = re.compile(r'([a-zA-Z_][a-zA-Z0-9_]*)="((?:[^"\\\n]|\\["\\n])*)"')
TYPES = {"counter", "gauge", "histogram", "summary"}
UNITS = ("_seconds", "_bytes", "_ratio", "_info", "_celsius")
PARTS = {"histogram": ("_bucket", "_sum", "_count"), "summary": ("_sum", "_count")}


def read(text):
    """{family: (type, {(name, ((label, value), …)): number})}"""
    expect(text.endswith("\n"), "the last line is not ended")
    families, name, kind = {}, None, None
    lines = text.split("\n")[:-1]
    for at, line in enumerate(lines):
        if line.startswith("# HELP "):
            name = line.split(" ")[2]
            expect(NAME.fullmatch(name) and name not in families, f"{name} begins twice, or is not a name")
            expect(len(line.split(" ", 3)[3]) > 10 and line.endswith("."), f"no help: {line}")
            expect(lines[at + 1].startswith(f"# TYPE {name} "), f"no type after {line}")
        elif line.startswith("# TYPE "):
            _, _, typed, kind = line.split(" ")
            expect(typed == name and kind in TYPES, line)
            families[name] = (kind, {})
        else:
            add(families[name], name, line)
    for name, (kind, samples) in families.items():
        look_at(name, kind, samples)
    return families


def add(family, name, line):
    kind, samples = family
    sample, labels, value = split(line)
    expect(sample in ([name] if kind in ("counter", "gauge") else [name + part for part in PARTS[kind]]), f"{line} stands under {name}")
    key = (sample, labels)
    expect(key not in samples, f"twice: {line}")
    expect(len({label for label, _ in labels}) == len(labels), f"a label twice: {line}")
    samples[key] = float(value)
    expect(math.isfinite(samples[key]) and (kind == "gauge" or samples[key] >= 0), line)


def split(line):
    name = NAME.match(line).group()
    rest, labels = line[len(name):], []
    if rest.startswith("{"):
        rest = rest[1:]
        while not rest.startswith("}"):
            found = LABEL.match(rest)
            expect(found, f"no label at {rest!r} of {line}")
            value = re.sub(r"\\(.)", lambda m: "\n" if m.group(1) == "n" else m.group(1), found.group(2))
            labels.append((found.group(1), value))
            rest = rest[found.end():].removeprefix(",")
        rest = rest[1:]
    expect(re.fullmatch(r" \S+", rest), f"no value: {line}")
    return name, tuple(labels), rest[1:]


def look_at(name, kind, samples):
    expect(samples, f"{name} has no sample")
    expect((kind == "counter") == name.endswith("_total"), f"{name} is a {kind}")
    expect("second" not in name or "_seconds" in name, f"{name}: the unit is not written out")
    if kind == "histogram":
        look_at_histogram(name, samples)


def look_at_histogram(name, samples):
    series = {}
    for (sample, labels), value in samples.items():
        rest = tuple(label for label in labels if label[0] != "le")
        part = series.setdefault(rest, {"buckets": []})
        if sample.endswith("_bucket"):
            part["buckets"].append((dict(labels)["le"], value))
        else:
            part[sample[len(name):]] = value
    for labels, part in series.items():
        ends = [float(end) for end, _ in part["buckets"]]
        counts = [count for _, count in part["buckets"]]
        expect(ends == sorted(set(ends)) and ends[-1] == math.inf, f"{name} {labels}: the ends are {ends}")
        expect(counts == sorted(counts) and counts[-1] == part["_count"], f"{name} {labels}: {counts}, {part}")
        expect(part["_sum"] >= 0, f"{name} {labels}: no sum")


def look_with_others(text):
    """The readers of others see the same."""
    theirs = {}
    for family in text_string_to_metric_families(text):
        for sample in family.samples:
            theirs[(sample.name, tuple(sorted(sample.labels.items())))] = sample.value
    ours = {(name, tuple(sorted(labels))): value for _, samples in read(text).values() for (name, labels), value in samples.items()}
    expect(theirs == ours, f"others read {set(theirs.items()) ^ set(ours.items())}")
    if shutil.which("promtool"):
        done = subprocess.run(["promtool", "check", "metrics"], input=text, capture_output=True, text=True, timeout=30)
        expect(done.returncode == 0 and not done.stderr, f"promtool: {done.stderr}")


class Scrape:
    def __init__(self, text):
        self.families = read(text)

    def value(self, name, **labels):
        """None where there is no such sample."""
        for kind, samples in self.families.values():
            for (sample, of), value in samples.items():
                if sample == name and dict(of) == labels:
                    return value
        return None

    def labels(self, name, **some):
        """The labels of all samples of that name that have these."""
        return [dict(of) for _, samples in self.families.values() for (sample, of) in samples if sample == name and some.items() <= dict(of).items()]

    def counters(self):
        return {key: value for kind, samples in self.families.values() for key, value in samples.items()
                if kind == "counter" or (kind in PARTS and not key[0].endswith("_sum"))}
