#!/usr/bin/env python3
"""The other side of a corpus without false alarms: faults are put into programs that have none, and `dripfeed check` must find each at its line.

  tests/bench/mutate.py FOLDER --dialect fanuc [--files 200] [--seed 1] [--binary build/release/dripfeed] [--show-missed 20]

Takes up to --files programs below FOLDER that check without an error. For every fault of the table below that has a place in a program, one place
is chosen by the seed, the fault is written there, and the file is checked again: found means that there is now an error (or, where the table
says so, a warning) with one of the ids named, at the line of the fault. Prints a table, and exits 1 below 95 % found.
"""

import argparse
import collections
import json
import pathlib
import random
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]


def code_of(line, dialect):
    """The line's text without what the control does not read: comments become blanks."""
    if dialect.startswith("sinumerik"):
        line = re.sub(r'"[^"]*"', lambda m: '"' + " " * (len(m[0]) - 2) + '"', line)
        return re.sub(r";.*", lambda m: " " * len(m[0]), line)
    return re.sub(r"\([^)]*\)?", lambda m: " " * len(m[0]), line)


class Fault:
    """`pattern` finds places in the code of a line, `change` gives the new text of a match. `at`: "line"; "any" where the line at which a control
    notices is not the line of the fault (an end that is missing); "only": the same, and a fault only where the program has one such place."""

    def __init__(self, name, ids, pattern, change, at="line"):
        self.name, self.ids, self.at = name, set(ids.split()), at
        self.pattern, self.change = re.compile(pattern), change


def replace(text):
    return lambda match: text


MOVE = r"(?<![A-Z#\[(=$_\"])([XYZ])([-+]?\d+\.\d*|[-+]?\d+)(?![\d.])"
COMMON = [
    Fault("letter of another alphabet", "homoglyph", MOVE, lambda m: {"X": "Х", "Y": "У", "Z": "Ζ"}[m[1]] + m[2]),
    Fault("address without value", "address-without-value syntax-error missing-operand unknown-name", MOVE + r"(?=\s*([A-Z]|$))", lambda m: m[1]),
    Fault("two decimal points", "malformed-number syntax-error value-without-address", MOVE, lambda m: m[1] + m[2] + ".5.5" if "." not in m[2] else m[1] + m[2] + "5.5"),
    Fault("too many digits", "too-many-digits", MOVE, lambda m: m[1] + "123456789012.5"),
    Fault("code that is not there", "unknown-code", r"(?<![A-Z])G0?1(?!\d|\.)", replace("G777")),
    Fault("value without address", "value-without-address syntax-error", MOVE + r"\s", lambda m: m[0] + "12.5 "),
]
MACRO = [
    Fault("jump to nowhere", "jump-target-missing", r"GOTO\s*\d+", replace("GOTO987654")),
    Fault("END without DO", "end-without-begin wrong-nesting", r"^(?=\s*(?:N\d+)?\s*G0?1\s*X)", replace("END3\n"), "any"),
    Fault("END is missing", "missing-end end-without-begin wrong-nesting", r"^\s*END\s*[1-3]\s*$", replace(""), "any"),
    Fault("DO of a wrong number", "loop-number-invalid", r"(?<=\bDO)\s*[1-3](?=\s*$)", replace("9"), "any"),
    Fault("bracket is missing", "missing-bracket unbalanced-bracket syntax-error missing-operand", r"(?<=[\d\]])\]", replace("")),
    Fault("operand is missing", "missing-operand syntax-error", r"(?<=[\d\]])([-+*])#", lambda m: m[1] + m[1].replace("-", "*") + "#"),
    Fault("division by nothing", "division-by-zero", r"^#(\d+)=#?[\d.]+\s*$", lambda m: f"#{m[1]}=1/0"),
    Fault("move and macro statement", "statement-not-alone syntax-error", r"^(\s*(?:N\d+)?\s*G0?[01](?![\d.]).*\S)\s*$", lambda m: m[1] + " #100=1"),
    Fault("variable that is not there", "variable-out-of-range", r"#\d+(?=\s*=)", replace("#99999")),
    Fault("system variable written", "variable-write-protected", r"^#\d+(?=\s*=)", replace("#5041")),
    Fault("NC word without brackets", "expression-without-brackets syntax-error", r"([XYZ])#(\d+)\s*$", lambda m: f"{m[1]}#{m[2]}+5."),
    Fault("program end is missing", "missing-program-end", r"M30|M02|M99", replace(""), "only"),
    Fault("comment without end", "unterminated-comment", r"^(?=\s*(?:N\d+)?\s*G0?[01](?![\d.]))", replace("(ROUGH\n")),
    Fault("arc that does not close", "arc-radius-mismatch arc-without-center", r"(?<=[IJK])[-+]?\d+\.\d*", lambda m: "8765.4321"),
]
SIEMENS = [
    Fault("jump to nowhere", "jump-target-missing", r"GOTO[FB]\s+[A-Z_]\w+", lambda m: m[0].split()[0] + " NOT_THERE"),
    Fault("ENDIF is missing", "missing-end wrong-nesting", r"(?<!\w)ENDIF(?!\w)", replace(""), "any"),
    Fault("ENDWHILE is missing", "missing-end wrong-nesting", r"(?<!\w)(ENDWHILE|ENDFOR|ENDLOOP)(?!\w)", replace(""), "any"),
    Fault("end without begin", "end-without-begin wrong-nesting", r"^(?=\s*(N\d+\s*)?G0?1\s)", replace("ENDWHILE\n"), "any"),
    Fault("bracket is missing", "missing-bracket unbalanced-bracket syntax-error", r"(?<=[\w)])\)(?=\s*$)", replace("")),
    Fault("operand is missing", "missing-operand syntax-error", r"(?<=[\w)])\*(?=R\d)", replace("*/")),
    Fault("name that is not defined", "unknown-name", r"(?<==)R\d+(?=\s*$)", replace("NEVER_DEFINED")),
    Fault("label twice", "label-defined-twice", r"^\s*([A-Z_]\w+):(?!=)(.*)$", lambda m: f"{m[1]}:{m[2]}\n{m[1]}:", "any"),
    Fault("= is missing", "missing-equals syntax-error", r"^(\s*(?:N\d+\s*)?R\d+)\s*=\s*(?=[\d(])", lambda m: m[1] + " "),
    Fault("two codes of a group", "codes-of-one-group", r"(?<![A-Z])G0?1\s", replace("G1 G2 ")),
    Fault("division by nothing", "division-by-zero", r"^(\s*(?:N\d+\s*)?R\d+)=[\d.]+\s*$", lambda m: f"{m[1]}=1/0"),
    Fault("string without end", "unterminated-string", r'"\s*(?=\)\s*$)', replace("")),
    Fault("program end is missing", "missing-program-end", r"(?<!\w)(M30|M17|RET|M2|M02)(?![\w(])", replace(""), "only"),
]


def faults_of(dialect):
    return COMMON + (SIEMENS if dialect.startswith("sinumerik") else MACRO)


def check(binary, dialect, paths):
    """Diagnostics by file."""
    out = {}
    for begin in range(0, len(paths), 40):
        part = [str(path) for path in paths[begin: begin + 40]]
        said = subprocess.run([binary, "check", "--json", "--dialect", dialect, *part], capture_output=True, timeout=300)
        for file in json.loads(said.stdout)["files"]:
            out[file["file"]] = file["diagnostics"]
    return out


def line_of(text, offset):
    return text[:offset].count("\n") + 1


def places(text, fault, dialect):
    """(begin, end, new text) of every place that the fault can have."""
    found = []
    begin = 0
    for line in text.split("\n"):
        code = code_of(line.rstrip("\r"), dialect)
        for match in fault.pattern.finditer(code):
            new = fault.change(match)
            if new != match[0]:
                found.append((begin + match.start(), begin + match.end(), new))
        begin += len(line) + 1
    return found


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("folder", type=pathlib.Path)
    options.add_argument("--dialect", required=True)
    options.add_argument("--files", type=int, default=200)
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--binary", default=ROOT / "build/release/dripfeed")
    options.add_argument("--show-missed", type=int, default=20)
    given = options.parse_args()
    chance = random.Random(given.seed)
    binary = str(given.binary)
    every = sorted(path for path in given.folder.rglob("*") if path.is_file() and 40 < path.stat().st_size < 200_000)
    chance.shuffle(every)
    said = check(binary, given.dialect, every[: 4 * given.files])
    clean = [path for path in every if str(path) in said and not any(d["severity"] == "error" for d in said[str(path)])][: given.files]
    tried, found, missed = collections.Counter(), collections.Counter(), []
    with tempfile.TemporaryDirectory() as name:
        changed = {}
        for index, path in enumerate(clean):
            text = path.read_bytes().decode("latin-1")
            before = {(d["id"], d["line"]) for d in said[str(path)]}
            for number, fault in enumerate(faults_of(given.dialect)):
                choice = places(text, fault, given.dialect)
                if not choice or (fault.at == "only" and len(choice) > 1):
                    continue
                begin, end, new = chance.choice(choice)
                mutant = pathlib.Path(name) / f"{index}_{number}.nc"
                mutant.write_bytes(text[:begin].encode("latin-1") + new.encode() + text[end:].encode("latin-1"))
                changed[str(mutant)] = (fault, path, line_of(text, begin), before)
        after = check(binary, given.dialect, [pathlib.Path(path) for path in changed])
        for mutant, (fault, path, line, before) in changed.items():
            tried[fault.name] += 1
            hits = [d for d in after[mutant] if d["id"] in fault.ids and (d["id"], d["line"]) not in before]
            if any(fault.at != "line" or d["line"] == line for d in hits):
                found[fault.name] += 1
            else:
                missed.append(f"{path}:{line}: {fault.name}: said {[(d['id'], d['line']) for d in after[mutant] if d['severity'] == 'error'][:3]}")
    print(f"{len(clean)} programs of {given.folder}, {given.dialect}, seed {given.seed}")
    for fault in faults_of(given.dialect):
        if tried[fault.name]:
            print(f"  {fault.name:28} {found[fault.name]:5} of {tried[fault.name]:5}")
    total, hit = sum(tried.values()), sum(found.values())
    print(f"  {'all':28} {hit:5} of {total:5}  {100 * hit / max(total, 1):.1f} %")
    for line in missed[: given.show_missed]:
        print("  missed", line)
    sys.exit(0 if total and hit >= 0.95 * total else 1)


if __name__ == "__main__":
    main()
