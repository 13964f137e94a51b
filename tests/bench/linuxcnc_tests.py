#!/usr/bin/env python3
"""LinuxCNC's own interpreter tests as an oracle: each program is run here, and what it does is compared with what LinuxCNC expects.

  tests/bench/linuxcnc_tests.py FOLDER [--binary build/dev/dripfeed] [--verbose]

FOLDER is tests/interp of LinuxCNC's source; nothing of it is kept here. Compared are the ends of all moves, feeds per minute, dwells and messages,
in their order (canon.py). A test whose program LinuxCNC refuses agrees when the program is refused here, too. Tests that need what is not a program
(Python, an INI file, a user interface, an interpreter in a plug) are counted apart. A test that differs needs a reason in `linuxcnc_reasons.py`:
exits 1 when one has none, or when one that has a reason agrees.
"""

import argparse
import pathlib
import re
import subprocess
import sys
import tempfile

import canon
from linuxcnc_reasons import REASONS

ROOT = pathlib.Path(__file__).resolve().parents[2]
# What shows in a test's script or INI file that more than a program is looked at.
OUTSIDE = [
    (r"linuxcnc -r", "a running control and its user interface"),
    (r"\bg\+\+", "compiles a program against the interpreter's library"),
    (r"rs274[^\n]*-p ", "another interpreter in a plug"),
    (r"python3|PYTHONUNBUFFERED|PYTHON", "Python"),
    (r"-i [\w.-]+\.ini", "an INI file"),  # but for the folder of subprograms: see tests_of
    (r"\.var", "a file of parameters from an earlier run"),
]


class Test:
    def __init__(self, name, programs, expected, refused, strips):
        self.name, self.programs, self.expected, self.refused, self.strips = name, programs, expected, refused, strips


def tests_of(folder):
    """Tests (without events expected where only taking or refusing the program is tested), and the names of those that need more than a program, with what."""
    tests, outside = [], []
    for script in sorted(folder.rglob("test.sh")):
        name = str(script.parent.relative_to(folder))
        text = re.sub(r"^\s*#.*$", "", script.read_text(), flags=re.M)
        settings = "".join(ini.read_text() for ini in script.parent.glob("*.ini") if "python" in ini.read_text().lower())
        folders = [ini for ini in script.parent.glob("*.ini") if re.fullmatch(r"\s*\[RS274NGC\]\s*SUBROUTINE_PATH\s*=.*\s*", ini.read_text())]
        if folders:
            text = text.replace(f"-i {folders[0].name}", "")
        needs = next((why for pattern, why in OUTSIDE if re.search(pattern, text + settings)), None)
        programs = [script.parent / found for found in re.findall(r"rs274[^\n|>]*?([\w.-]+\.ngc)", text)]
        for program in sorted(script.parent.glob("test-*legal-*.ngc")):
            tests.append(Test(f"{name}/{program.name}", [program], None, "-illegal-" in program.name, False))
        if not programs and (name + "/") in "".join(test.name for test in tests):
            continue
        if needs or not programs:
            outside.append((name, needs or "no program of its own"))
            continue
        refused = bool(re.search(r"!\s*rs274|expected to fail", script.read_text()))
        expected = script.parent / "expected"
        tests.append(Test(name, programs, expected.read_text() if expected.exists() else "", refused, "awk" in text))
    for program in sorted((folder / "good").glob("*.ngc")):
        tests.append(Test(f"good/{program.name}", [program], pathlib.Path(f"{program}.expected").read_text(), False, False))
    for program in sorted((folder / "bad").glob("*.ngc")):
        tests.append(Test(f"bad/{program.name}", [program], "", True, False))
    return tests, outside


def run(binary, program):
    """With all work offsets at zero, as the stand-alone interpreter has them without a file of parameters."""
    with tempfile.NamedTemporaryFile("w", suffix=".state") as state:
        state.write("".join(f"#{5221 + 20 * system + axis}=0\n" for system in range(9) for axis in range(9)))
        state.flush()
        return run_with(binary, program, state.name)


def run_with(binary, program, state):
    # A loop without end is stopped: what it did until then is compared.
    command = [binary, "run", "--dialect", "linuxcnc", "--seconds", "20", "--state", state, "--path", program.parent / "subs", program]
    return subprocess.run(command, capture_output=True, text=True)


def difference(binary, test):
    """None, or how the test differs, with what the run itself said that it does not interpret."""
    events, said = [], []
    for program in test.programs:
        ended = run(binary, program)
        if ended.returncode > 1:
            raise SystemExit(f"{program}: {ended.stderr}")
        refused = re.search(r"error\[(.*?)\]: (.*)", ended.stderr)
        if test.refused:
            if refused:
                continue
            return "LinuxCNC refuses it, here it runs", []
        if refused:
            return f"refused here: {refused[2]}", []
        events += canon.ours(ended.stdout)
        said += re.findall(r"(?:not interpreted|input not known): (.*)", ended.stderr)
    if test.refused or test.expected is None:
        return None
    theirs = canon.peers(test.expected)
    if test.strips:  # the script cuts the first word off each line
        events = [(e[0], e[1].partition(" ")[2], None) if is_print(e, theirs) else e for e in events]
    tolerance = canon.TOLERANCE_INCH if "UNITS_INCHES" in test.expected else canon.TOLERANCE
    found = canon.first_difference(events, theirs, tolerance)
    return (found, said) if found else None


def is_print(event, theirs):
    return event[0] == "message" and not any(canon.same(event, other) for other in theirs)


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("folder", type=pathlib.Path)
    options.add_argument("--binary", default=ROOT / "build/dev/dripfeed")
    options.add_argument("--verbose", action="store_true", help="also the first difference of those that have a reason")
    given = options.parse_args()
    tests, outside = tests_of(given.folder)
    agree, surprises, by_class = [], 0, {}
    for test in tests:
        found = difference(given.binary, test)
        reason = REASONS.get(test.name)
        if found is None:
            agree.append(test)
            if reason:
                surprises += 1
                print(f"{test.name}: agrees, though it has a reason not to")
            continue
        if reason:
            by_class.setdefault(reason[0], []).append((test.name, reason[1]))
        else:
            surprises += 1
        if not reason or given.verbose:
            print(f"{test.name}: {found[0]}{''.join('; said: ' + name for name in found[1])}")
    refusals = sum(test.refused for test in agree)
    print(f"{len(tests)} tests of programs: {len(agree)} agree ({len(agree) - refusals} in all they do, {refusals} in the refusal)")
    for name, members in sorted(by_class.items()):
        print(f"  {name}: {len(members)}")
        for test, why in members:
            print(f"    {test}: {why}")
    print(f"{len(outside)} tests need more than a program:")
    for why in sorted({why for _, why in outside}):
        print(f"  {why}: {', '.join(test for test, other in outside if other == why)}")
    return 1 if surprises else 0


if __name__ == "__main__":
    sys.exit(main())
