"""Every shipped family on every shipped machine that it is for, as macro and as plain blocks: rendered, checked, run, and the moves compared with each
other. A machine that it is not for and each kind of wrong value are refused by name, with no program. `tests/e2e/families.py BINARY`."""

import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

BINARY = sys.argv[1]
ROOT = pathlib.Path(__file__).resolve().parents[2]
FAMILIES = sorted((ROOT / "deploy/families").glob("*.family"))
MACHINES = {path.stem: json.loads(path.read_text()) for path in sorted((ROOT / "deploy/machines").glob("*.json"))}
MODES = ("macro", "explicit")

# A macro computes with the control's digits, plain blocks are written with three decimals; both are printed with four.
MACRO_MM, EXPLICIT_MM = 1e-4, 6e-4

# What the check of a rendered program may leave open: the text alone has no stock, no one knows where the machine stands at the start, a rotary axis
# has no travel in its profile.
OPEN = re.compile(r"a move starts at a position that is not known: its length is not counted|gouges and accuracy: stock and nominal are not known|"
                  r"with tool radius compensation the travel is that of the programmed path|the travel of [ABC] is not known")
# The stock cannot be described: a cylinder along x.
NO_STOCK = {"worm", "worm-turned"}
# No curve is given that an accuracy could be measured along.
NO_CURVE = {"bezier-surface", "bolt-circle", "engrave-text", "face-mill", "island-pocket", "nurbs-surface", "rectangular-pocket", "seal-ring", "slot", "thread-mill",
            "turning-cycle", "worm", "worm-turned"}
# A spindle that is an axis stands; the checks cannot distinguish it from one that was forgotten.
WARNED = {("seal-ring", "sinumerik-810d-lathe"): {"spindle-not-turning"}, ("worm-turned", "sinumerik-810d-lathe"): {"spindle-not-turning"}}

# Values that are in their ranges and do not go together.
BROKEN = {
    "bezier-surface": ["ball_diameter=30 mm"], "bolt-circle": ["holes=7"], "engrave-text": ["plate_width=10 mm"],
    "hyperbolic-roll": ["half_axis_z=40 mm"], "island-pocket": ["pocket_corner=5 mm"],
    "nurbs-profile": ["weight=1, 1, 1, 1"], "nurbs-surface": ["scallop=0.9 mm", "ball_diameter=1.2 mm"], "rectangular-pocket": ["corner_radius=5 mm"], "round-pocket": ["cutter_diameter=70 mm"],
    "seal-ring": ["cone_angle=44 deg", "tilt=19 deg"], "slot": ["slot_width=8 mm"], "stepped-shaft": ["journal_diameter=120 mm"],
    "thread-mill": ["cutter_diameter=19.5 mm"], "turning-cycle": ["turned_diameter=110 mm"], "worm": ["ball_diameter=12 mm"], "worm-turned": ["ball_diameter=12 mm"]}
FREE = {"face-mill"}  # no condition


def expect(condition, text):
    if not condition:
        raise AssertionError(text)


def ask(*arguments):
    return subprocess.run([BINARY, *map(str, arguments)], capture_output=True, text=True, timeout=120)


class Family:
    def __init__(self, path):
        self.path, self.name, self.text = path, path.stem, path.read_text()
        self.kind = re.search(r"^machine ([a-z-]+)", self.text, re.M).group(1)
        native = re.search(r"^native (\S+)", self.text, re.M)
        self.language = native.group(1) if native else None
        program = self.text if self.language else self.text[re.search(r"^(sub|program) ", self.text, re.M).start():]
        self.axes = set() if self.language else {
            axis.upper() for line in program.splitlines() if re.match(r"\s*(rapid|cut|retract|arc)\b", line)
            for axis in re.findall(r"(?<=\s)([xyzabc]) ", line.split("#")[0])}

    def fits(self, machine):
        return machine["kind"] == self.kind or (machine["kind"], self.kind) == ("mill-turn", "lathe")

    def lacks(self, machine):
        return self.axes - {axis["name"] for axis in machine["axes"]}


def moves(text):
    """The moves of a trace without their lines: of each its kind, and its numbers by letter (a feed's with its mode). Without rapids of no length:
    controls differ in whether a cycle makes them."""
    out, place = [], None
    for line in text.splitlines():
        _, kind, *words = line.split()
        if kind in ("rapid", "linear", "arc-cw", "arc-ccw"):
            rest = [re.fullmatch(r"([A-Z])(-?[0-9.]+)(/\w+)?", word) for word in words]
            expect(all(rest), f"a trace has the line {line}")
            numbers = {m.group(1) + (m.group(3) or ""): float(m.group(2)) for m in rest}
            before, place = place, {letter: value for letter, value in numbers.items() if len(letter) == 1 and letter in "XYZABC"}
            if kind != "rapid" or place != before:
                out.append((kind, numbers))
    return out


def compare(a, b, tolerance, what):
    """A machine may have more axes than another: those never move."""
    expect(len(a) == len(b), f"{what}: {len(a)} and {len(b)} moves")
    for i, ((kind, numbers), (other_kind, others)) in enumerate(zip(a, b)):
        lone = numbers.keys() ^ others.keys()
        expect(kind == other_kind and lone <= set("YABC"), f"{what}: move {i} is {kind} {numbers} and {other_kind} {others}")
        for one in (numbers, others):
            expect(all(one.get(axis, 0) == 0 for axis in lone), f"{what}: move {i}: {one}")
        worst = max(abs(numbers[letter] - others[letter]) for letter in numbers.keys() & others.keys())
        expect(worst <= tolerance, f"{what}: move {i} differs by {worst}: {kind} {numbers} and {others}")


def ids(findings):
    return {one["id"] for one in findings if one["severity"] != "note"}


def render_and_run(family, name, mode, folder):
    what = f"{family.name} on {name}, {mode}"
    program = folder / f"{family.name}_{name}_{mode}.nc"
    done = ask("render", family.path, "--machine", name, "--mode", mode, "--output", program)
    expect(done.returncode == 0 and f"{mode}: " in done.stderr and len(done.stderr.splitlines()) == 1, f"{what}: {done.stderr}")
    done = ask("check", program, "--machine", name, "--json")
    report = json.loads(done.stdout)["files"][0]
    warned = WARNED.get((family.name, name), set())
    expect(report["verdict"] == ("warn" if warned else "pass"), f"{what}: {report}")
    expect(ids(report["diagnostics"]) == warned, f"{what}: {report}")
    opened = [re.sub(r" \(line.*\)$", "", one) for one in report["not_checked"]]
    expect(all(OPEN.fullmatch(one) for one in opened), f"{what}: {opened}")
    unlimited = {axis for axis in "ABC" if f"the travel of {axis} is not known" in opened}
    expect(unlimited == family.axes & set("ABC"), f"{what}: {opened}")
    done = ask("run", program, "--machine", name, "--trace", "motions")
    expect(done.returncode == 0, f"{what}: {done.stderr}")
    found = moves(done.stdout)
    expect(len(found) > 5, f"{what}: {len(found)} moves")
    return found


def nothing_measured(done, why, what):
    """With --json, one object as ever, which says so."""
    answer = json.loads(done.stdout)
    expect(done.returncode == 1 and why in done.stderr, f"{what}: {done.stderr}")
    expect(answer["measured"] is False and answer["ran"] is True and any(why in one for one in answer["not_checked"]), f"{what}: {answer}")


def measure(family, name, mode):
    """Gouges and accuracy of the family itself."""
    what = f"{family.name} on {name}, {mode}"
    done = ask("gouge", family.path, "--machine", name, "--mode", mode, "--json")
    if family.name in NO_STOCK:
        nothing_measured(done, "gouges: stock and nominal are not known", what)
    else:
        gouge = json.loads(done.stdout)
        expect(not gouge["findings"] and gouge["deepest_rapid_mm"] == 0, f"{what}: {gouge}")
        turned = any("a cut that turns" in one for one in gouge["not_checked"])
        expect(turned == bool(family.axes & set("ABC")), f"{what}: {gouge}")
    done = ask("accuracy", family.path, "--machine", name, "--mode", mode, "--json")
    if family.name in NO_CURVE:
        return nothing_measured(done, "accuracy: no nominal is known", what)
    accuracy = json.loads(done.stdout)
    in_family = accuracy["max_at_family_line"]
    expect(re.match(r"\s*(cut|arc)\b", family.text.splitlines()[in_family - 1]) if in_family else accuracy["max_mm"] == 0, f"{what}: line {in_family} is no cut")
    expect(not accuracy["findings"] and accuracy["covered"] and accuracy["blocks"] > 0, f"{what}: {accuracy}")


def on_its_machines(family, folder):
    traces = {}
    for name, machine in MACHINES.items():
        if not family.fits(machine) or family.lacks(machine) or family.language not in (None, machine["dialect"]):
            continue
        for mode in MODES:
            if not traces or not any(one == mode for _, one in traces):
                measure(family, name, mode)
            traces[name, mode] = render_and_run(family, name, mode, folder)
    expect(traces, f"{family.name} is for none of the machines")
    (first, _), *_ = traces
    for (name, mode), trace in traces.items():
        limit = MACRO_MM if mode == "macro" else EXPLICIT_MM
        compare(traces[first, "macro"], trace, limit, f"{family.name} on {name}, {mode}, beside {first}, macro")
    with_choices(family, folder)
    return len(traces)


def with_choices(family, folder):
    """Each word of each choice that is not the default, on one machine: both modes make the same moves, and others than the default."""
    machine = first_machine(family)
    plain = trace_of(family, machine, "macro", folder)
    for name, default, words in re.findall(r"^param (\w+)\s+choice (\w+) of ([a-z_]+(?:, [a-z_]+)*)", family.text, re.M):
        for word in set(words.split(", ")) - {default}:
            value = f"{name}={word}"
            macro, explicit = (trace_of(family, machine, mode, folder, value) for mode in MODES)
            compare(macro, explicit, EXPLICIT_MM, f"{family.name}, {value}")
            expect(macro != plain, f"{family.name}: {value} changes nothing")


def trace_of(family, machine, mode, folder, *values):
    program = folder / f"{family.name}_{mode}_choice.nc"
    done = ask("render", family.path, "--machine", machine, "--mode", mode, "--output", program, *(word for value in values for word in ("--set", value)))
    expect(done.returncode == 0, f"{family.name} {values}: {done.stderr}")
    report = json.loads(ask("check", program, "--machine", machine, "--json").stdout)["files"][0]
    expect(report["verdict"] == "pass", f"{family.name} {values}: {report['diagnostics']}")
    return moves(ask("run", program, "--machine", machine).stdout)


def first_machine(family):
    """One that it is for and that warns of nothing."""
    return next(name for name, one in MACHINES.items() if family.fits(one) and not family.lacks(one)
                and family.language in (None, one["dialect"]) and (family.name, name) not in WARNED)


def refused(family, machine, text, *values):
    arguments = [family.path, "--machine", machine, *(word for value in values for word in ("--set", value))]
    done = ask("render", *arguments)
    expect(done.returncode == 1 and done.stdout == "", f"{family.name} {values}: a program was rendered")
    document = ask("render", *arguments, "--json").stdout
    answer = json.loads(document) if document else None  # a table that is wrong is not a family
    expect(answer is None and any("=@" in one for one in values) or answer["text"] is None and any(one["severity"] == "error" for one in answer["diagnostics"]),
           f"{family.name} {values}: {answer}")
    for one in [text] if isinstance(text, str) else text:
        expect(one in done.stderr, f"{family.name} {values} on {machine}: expected {one}, not {done.stderr}")
    return done.stderr


def on_other_machines(family):
    count = 0
    for name, machine in MACHINES.items():
        if not family.fits(machine):
            wanted = ["error[family-other-machine]"]
        elif family.language not in (None, machine["dialect"]):
            wanted = [f"in the language {family.language}"]
        elif family.lacks(machine):
            wanted = ["error[translation-axis]", *(f"axis {axis}" for axis in family.lacks(machine))]
        else:
            continue
        refused(family, name, wanted)
        for command in ("gouge", "accuracy"):
            done = ask(command, family.path, "--machine", name)
            expect(done.returncode != 0 and done.stdout == "" and wanted[0] in done.stderr, f"{family.name}: {command} on {name}: {done.stderr}")
        count += 1
    return count


WRONG_UNIT = {"length": "3 deg", "angle": "3 mm", "feed": "3 mm", "speed": "3 mm", "time": "3 mm", "count": "3 mm", "ratio": "3 mm", "tool": "3 mm"}
PARAMETER = re.compile(r"^param (\w+)\s+(list of )?(\w+)\s+(.*?)\bin (-?[\d.]+)\.\.(-?[\d.]+)", re.M)


def wrong_values(family):
    machine = first_machine(family)
    count = 0
    for name, is_list, kind, default, low, high in PARAMETER.findall(family.text):
        first = re.split(r"[,\s]", default.strip(), maxsplit=1)
        unit = re.match(r"-?[\d.]+ ?([a-z/]*)", default).group(1)
        numbers = len(default.split(",")) if is_list else 1
        fill = lambda value: ", ".join([value] * numbers)
        for value in (float(low) - 1, float(high) + 1):
            refused(family, machine, ["error[family-value-out-of-range]", name], f"{name}={fill(f'{value:g} {unit}')}")
        refused(family, machine, ["error[family-wrong-unit]", name], f"{name}={fill(WRONG_UNIT[kind])}")
        refused(family, machine, [name], f"{name}=some")
        count += 4
        if unit:
            refused(family, machine, ["error[family-missing-unit]", name], f"{name}={fill(first[0])}")
            count += 1
    expect(count >= 20, f"{family.name}: {count} values")
    for name, words in re.findall(r"^param (\w+)\s+choice \w+ of ([a-z_]+(?:, [a-z_]+)*)", family.text, re.M):
        refused(family, machine, [name, *words.split(", ")], f"{name}=no_such_word")
    refused(family, machine, ["error[family-unknown-parameter]", "no_such_name"], "no_such_name=1 mm")
    expect((family.name in FREE) == (not re.search(r"^require", family.text, re.M)), f"{family.name}: has it a condition?")
    if family.name not in FREE:
        refused(family, machine, ["error[family-constraint-failed]"], *BROKEN[family.name])
    return count


def lists_from_tables(folder):
    """The points of a curve from the columns of a file: the same program as from their numbers. A wrong cell is named by its place."""
    family = next(Family(path) for path in FAMILIES if path.stem == "nurbs-profile")
    x, y = (re.search(rf"^param point_{axis} list of length (.*?) in ", family.text, re.M).group(1).split(", ") for axis in "xy")
    table = folder / "points.csv"
    rows = [f"{a.removesuffix(' mm')};{b}" for a, b in zip(x, y)]
    table.write_text("\n".join(["# from a drawing", "point_x mm; high mm", *rows]) + "\n")
    machine, values = first_machine(family), (f"point_x=@{table}", f"point_y=@{table}:high")
    expect(trace_of(family, machine, "macro", folder, *values) == trace_of(family, machine, "macro", folder), "the points of a table")
    table.write_text("\n".join(["point_x mm; high mm", *rows[:2], "70.7; tall", *rows[3:]]) + "\n")
    refused(family, machine, ["points.csv:4:7: error[family-syntax]", "'tall' is not a number"], *values)
    refused(family, machine, ["points.csv:1:1: error", "no column is called low"], values[0], f"point_y=@{table}:low")
    done = ask("render", family.path, "--machine", machine, "--set", f"point_x=@{folder}/no_such.csv")
    expect(done.returncode != 0 and not done.stdout and "no_such.csv" in done.stderr, f"a table that is not there: {done.stderr}")
    refused(family, machine, ["error[family-given-twice]", "weight"], f"weight={', '.join('1' * 7)}", f"weight={', '.join('1' * 7)}")


def points_beyond_the_variables(folder):
    """200 points of a worm on a machine with 150 variables: no macro, and plain blocks where the choice is free, with the reason; 20 fit in."""
    family = next(Family(path) for path in FAMILIES if path.stem == "worm")
    machine = folder / "few.json"
    profile = json.loads((ROOT / "deploy/machines/mazak-vcn.json").read_text())
    profile["control"]["variables"] = [{"first": 100, "last": 199}, {"first": 500, "last": 549}]
    machine.write_text(json.dumps(profile))
    place = lambda count: "place=" + ", ".join(f"({0.02 * i - 2:.2f} mm, {24 - 0.03 * i:.2f} mm)" for i in range(count))
    why = "the program needs 427 variables, the control has 150"
    values = ("--set", "flanks=points", "--set", place(200))
    done = ask("render", family.path, "--machine", machine, "--mode", "macro", *values)
    expect(done.returncode == 1 and not done.stdout and f"error[not-enough-variables]: {why}" in done.stderr, done.stderr)
    done = ask("render", family.path, "--machine", machine, *values)
    expect(done.returncode == 0 and f"explicit: it cannot be a macro: {why}" in done.stderr, done.stderr)
    expect(ask("render", family.path, "--machine", machine, "--mode", "macro", "--set", "flanks=points", "--set", place(20)).returncode == 0, "20 points")


def one_of(document):
    (file,) = json.loads(document)["files"]
    return file


def checked_and_timed(folder):
    """`check` and `time` take the family as `render` does: what they report is that of its rendered text, with the family's lines."""
    family = next(Family(path) for path in FAMILIES if path.stem == "hyperbolic-roll")
    machine = folder / "short.json"
    profile = json.loads((ROOT / "deploy/machines/fanuc-0i-lathe.json").read_text())
    next(axis for axis in profile["axes"] if axis["name"] == "X")["max_mm"] = 120
    machine.write_text(json.dumps(profile))
    for mode in MODES:
        program = folder / "roll_short.nc"
        options = ("--machine", machine, "--set", "clearance=30 mm")
        ask("render", family.path, *options, "--mode", mode, "--output", program)
        report = one_of(ask("check", family.path, *options, "--mode", mode, "--json").stdout)
        plain = one_of(ask("check", program, "--machine", machine, "--json").stdout)
        expect(report["file"] == str(family.path) and report["rendered"]["mode"] == mode, f"{mode}: {report}")
        expect(report["accuracy"]["covered"] and plain["accuracy"] is None, f"{mode}: {report['accuracy']}")
        found, wanted = report["envelope"]["findings"], plain["envelope"]["findings"]
        expect(found and [one["line"] for one in found] == [one["line"] for one in wanted], f"{mode}: {found} and {wanted}")
        lines = family.text.splitlines()
        expect(all(re.search(r"rapid|retract|cut", lines[one["family_line"] - 1]) for one in found), f"{mode}: {found}")
        spoken = ask("check", family.path, *options, "--mode", mode)
        expect(spoken.returncode == 1 and f"(rendered):{found[0]['line']}: error[travel-exceeded]" in spoken.stderr
               and f"from: {family.path}:{found[0]['family_line']}" in spoken.stderr, spoken.stderr)
        timed = json.loads(ask("time", family.path, *options, "--mode", mode, "--json").stdout)
        expect(timed == json.loads(ask("time", program, "--machine", machine, "--json").stdout), f"{mode}: {timed}")
    by_name = one_of(ask("check", "hyperbolic-roll", "--machine", "fanuc-0i-lathe", "--json").stdout)
    expect(by_name["verdict"] == "pass" and by_name["rendered"]["because"], f"{by_name}")
    piped = subprocess.run([BINARY, "check", "-", "--machine", "fanuc-0i-lathe", "--json"], input=family.text, capture_output=True, text=True, timeout=60)
    expect(one_of(piped.stdout)["file"] == "<stdin>" and one_of(piped.stdout)["rendered"], piped.stderr)
    done = ask("check", family.path, "--machine", "fanuc-0i-lathe", "--set", "half_axis_z=40 mm", "--json")
    failed = one_of(done.stdout)
    expect(done.returncode == 1 and failed["verdict"] == "fail" and failed["file"] == str(family.path) and "rendered" not in failed, f"{failed}")
    expect(failed["diagnostics"][0]["id"] == "family-constraint-failed" and failed["diagnostics"][0]["line"] > 1, f"{failed}")
    done = ask("time", family.path, "--machine", "fanuc-0i-lathe", "--set", "half_axis_z=40 mm", "--json")
    expect(done.returncode == 1 and json.loads(done.stdout)["measured"] is False and "family-constraint-failed" in done.stdout, done.stderr)
    for option in (("--fix",), ("--sarif",), ("--nominal", family.path)):
        done = ask("check", family.path, "--machine", "fanuc-0i-lathe", *option)
        expect(done.returncode == 2 and "is a family" in done.stderr, f"{option}: {done.stderr}")


def main():
    families = [Family(path) for path in FAMILIES]
    expect(len(families) >= 10, "the shipped families")
    with tempfile.TemporaryDirectory() as name, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        folder = pathlib.Path(name)
        jobs = [(family, pool.submit(on_its_machines, family, folder), pool.submit(on_other_machines, family), pool.submit(wrong_values, family))
                for family in families]
        failed = []
        lists_from_tables(folder)
        points_beyond_the_variables(folder)
        checked_and_timed(folder)
        for family, *parts in jobs:
            line = []
            for part in parts:
                try:
                    line.append(str(part.result()))
                except AssertionError as error:
                    failed.append(str(error)[:1500])
                    line.append("failed")
            print(f"{family.name:<20}{line[0]:>4} renderings, refused by {line[1]} machines, {line[2]} wrong values refused")
        expect(not failed, "\n".join(failed))


if __name__ == "__main__":
    main()
