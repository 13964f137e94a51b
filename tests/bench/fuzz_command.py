#!/usr/bin/env python3
"""Mutated programs given to the command: no crash, no hang, no flood of output, no memory out of proportion.

  tests/bench/fuzz_command.py [CORPUS] [--minutes 10] [--seed 1] [--binary build/dev/dripfeed] [--keep FOLDER] [--count N]

The programs are those of CORPUS (or $DRIPFEED_CORPUS) and the repository's samples, seeds and presets of machines. Each turn cuts, joins, repeats and
changes one or two of them, writes it, and runs check, run, convert or time on it with options by chance. A turn fails where the command
  - ends by a signal, or with an exit code that it does not have (0, 1, 2),
  - computes for more than 5 s (a run that goes on for ever is stopped by --seconds 2, which is part of the options),
  - prints more than 64 times the input and 1 MB,
  - holds more than 64 bytes a byte of input and 256 MB (the largest resident set, by wait4).
What failed is written to --keep with its command line, and the exit is 1. The same seed makes the same turns.
"""

import argparse
import collections
import os
import pathlib
import random
import re
import resource
import signal
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
DIALECTS = ["fanuc", "sinumerik-840d", "mazak", "mitsubishi-m80"]
COMPUTING_S = 5
WALL_S = 120  # the machine may be busy with something else
LARGEST_SEED = 200_000
NOT_PROGRAMS = {".md", ".txt", ".json", ".py", ".pdf", ".png"}
# Words that mutations put in: what programs decide counts, places and loops by.
SPICE = [b"REP(5,", b"SET(1,,", b"WHILE[1EQ1]DO1\n", b"END1\n", b"GOTO1\n", b"N1", b"M98P1L9999\n", b"G83Z-99.R0Q0.0001F100\n", b"#[#1]=", b"R[R1]=",
         b"REPEATB A P=99999\n", b"FOR R1=0 TO 1E9\n", b"ENDFOR\n", b"LOOP\n", b"ENDLOOP\n", b"CYCLE83(", b"HOLES1(", b"POCKET3(", b"CYCLE95(", b"G76P999999Q1R0\n",
         b"EXECSTRING(\"X\"<<R1)\n", b"DEF REAL A[999,999]\n", b"DEF STRING[200] TX\n", b"TURN=9999", b"BSPLINE\n", b"POLY PO[X]=(1,2,3)\n", b"G34I10J0K9999\n", b"G71P1Q2U1.W1.\n",
         b"(", b")", b"[", b"]", b"\"", b"%", b"@", b"\x00", b"\xff", b"\xe2\x82", b"99999999999999999999", b"-0.", b"1E308", b".", b"=", b"<<", b"\n\n", b"\r", b";", b"/"]


def seeds(corpus):
    found = sorted(path for path in (ROOT / "tests/samples").rglob("*") if path.is_file() and path.suffix != ".family")
    found += sorted(path for name in ("fanuc", "sinumerik") for path in (ROOT / "tests/fuzz/corpus" / name).iterdir())
    if corpus:
        found += sorted(path for path in pathlib.Path(corpus).rglob("*") if path.is_file() and path.suffix.lower() not in NOT_PROGRAMS)
    return [path for path in found if path.stat().st_size <= LARGEST_SEED]


def dialect_of(path):
    folders = "/".join(path.parts)
    known = [dialect for dialect in DIALECTS if dialect.split("-", maxsplit=1)[0] in folders]
    return known[0] if known else "sinumerik-840d" if path.suffix.lower() in (".mpf", ".spf", ".def") else "fanuc"


def machine_of(rng, dialect, machines):
    fitting = [path for path in machines if path.name.startswith(dialect.split("-", maxsplit=1)[0])]
    return str(rng.choice(fitting if rng.random() < 0.85 else machines))


def piece(rng, text):
    first = rng.randrange(len(text) + 1)
    return text[first : first + rng.choice([1, 3, 10, 40, 200, 2000])]


def mutated(rng, text, other):
    for _ in range(rng.choice([1, 1, 2, 4, 8, 30])):
        at = rng.randrange(len(text) + 1)
        kind = rng.randrange(8)
        if kind == 0:
            text = text[:at] + text[at + len(piece(rng, text)) :]
        elif kind == 1:
            text = text[:at] + rng.choice(SPICE) + text[at:]
        elif kind == 2:
            text = text[:at] + piece(rng, other) + text[at:]
        elif kind == 3:
            text = text[:at] + bytes([rng.randrange(256)]) + text[at + 1 :]
        elif kind == 4:
            text = text[:at] + piece(rng, text) * rng.choice([2, 5, 50, 500]) + text[at:]
        elif kind == 5:
            text = text[:at] + str(rng.choice([0, -1, 1, 0.001, 999, 99999, 1e9, 4294967295])).encode() + text[at + rng.randrange(4) :]
        elif kind == 6:
            lines = text.splitlines(keepends=True)
            rng.shuffle(lines)
            text = b"".join(lines) if rng.random() < 0.1 else text
        else:
            text = text.replace(b"\n", b"", rng.choice([1, 10, 10**6])) if rng.random() < 0.3 else text[:at]
        text = text[: 2 * LARGEST_SEED]
    return text


def altered(rng, text):
    """Other numbers, whole lines more often, a line between: what is still read as a program, mostly."""
    numbers = [match.span() for match in re.finditer(rb"\d+\.?\d*", text)]
    for first, last in sorted(rng.sample(numbers, min(len(numbers), rng.choice([0, 1, 1, 3, 10]))), reverse=True):
        text = text[:first] + rng.choice([b"0", b"1.", b"0.001", b"99", b"9999", b"100000.", b"2", b"360.", b"0.0001", b"R1", b"#1"]) + text[last:]
    lines = text.splitlines(keepends=True)
    for _ in range(rng.choice([0, 1, 1, 2])):
        at = rng.randrange(len(lines) + 1)
        first = rng.randrange(len(lines) + 1)
        some = lines[first : first + rng.choice([1, 1, 2, 5, 20])]
        lines[at:at] = rng.choice([some, some * rng.choice([10, 300]), [rng.choice(SPICE) + b"\n"]])
    return b"".join(lines)[: 2 * LARGEST_SEED]


def command_line(rng, path, dialect, machines):
    name = rng.choice(["check", "check", "run", "convert", "time"])
    of = ["--machine", machine_of(rng, dialect, machines)] if name == "time" or rng.random() < 0.4 else ["--dialect", dialect]
    if name == "convert":
        line = ["convert", path, "--from", dialect, "--to", rng.choice(DIALECTS), "--mode", rng.choice(["macro", "macro", "explicit"])]
        return line + (["--machine", machine_of(rng, dialect, machines)] if rng.random() < 0.2 else [])
    line = [name, path, *of, "--seconds", "2"]
    if rng.random() < 0.3:
        line.append("--json")
    if name == "run":
        line += ["--trace", "none"] if rng.random() < 0.5 else ["--trace", "motions", "--limit", "motions=2000"]
        if rng.random() < 0.3:
            line += ["--skip", str(rng.randint(1, 9))]
    if name in ("check", "time") and rng.random() < 0.3:
        line.append("--drip")
    if "--dialect" in line and rng.random() < 0.3:
        line += ["--control", rng.choice(["kind=lathe", "kind=mill", "kind=lathe,g_system=B", "kind=mill-turn"])]
    return line


def limit_child():
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_CPU, (30, 30))


def run(command):
    """(exit code or -signal, seconds of computing, bytes of output, resident bytes, last lines)"""
    with tempfile.TemporaryFile() as output:
        child = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=output, stderr=output, preexec_fn=limit_child)
        begun = time.monotonic()
        while True:
            done, status, used = os.wait4(child.pid, os.WNOHANG)
            if done:
                break
            if time.monotonic() - begun > WALL_S:
                child.kill()
            time.sleep(0.002)
        child.returncode = os.waitstatus_to_exitcode(status)
        size = output.seek(0, os.SEEK_END)
        output.seek(max(0, size - 400))
        return child.returncode, used.ru_utime + used.ru_stime, size, used.ru_maxrss * 1024, output.read()


def faults(result, size):
    code, computing_s, printed, held, _ = result
    found = []
    if code < 0:
        found.append(f"ended by {signal.Signals(-code).name}")
    elif code > 2:
        found.append(f"exit code {code}")
    if computing_s > COMPUTING_S:
        found.append(f"computed for {computing_s:.1f} s")
    if printed > 64 * size + 2**20:
        found.append(f"printed {printed} bytes")
    if held > 64 * size + 2**28:
        found.append(f"held {held >> 20} MB")
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("corpus", nargs="?", default=os.environ.get("DRIPFEED_CORPUS"))
    parser.add_argument("--minutes", type=float, default=10)
    parser.add_argument("--count", type=int, default=10**9)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--binary", default=str(ROOT / "build/dev/dripfeed"))
    parser.add_argument("--keep", type=pathlib.Path, default=pathlib.Path("fuzz-failures"))
    options = parser.parse_args()
    paths = seeds(options.corpus)
    machines = sorted((ROOT / "deploy/machines").glob("*.json"))
    rng = random.Random(options.seed)
    until = time.monotonic() + 60 * options.minutes
    turns = failed = 0
    codes = collections.Counter()
    worst = {"computing_s": 0.0, "held_mb": 0, "output": 0}
    with tempfile.TemporaryDirectory(prefix="dripfeed-fuzz-") as folder:
        path = os.path.join(folder, "part.nc")
        while turns < options.count and time.monotonic() < until:
            turns += 1
            seed = rng.choice(paths)
            dialect = rng.choice(DIALECTS) if rng.random() < 0.15 else dialect_of(seed)
            text = altered(rng, seed.read_bytes()) if rng.random() < 0.6 else mutated(rng, seed.read_bytes(), rng.choice(paths).read_bytes())
            pathlib.Path(path).write_bytes(text)
            line = command_line(rng, path, dialect, machines)
            result = run([options.binary, *line])
            worst = {"computing_s": max(worst["computing_s"], result[1]), "held_mb": max(worst["held_mb"], result[3] >> 20), "output": max(worst["output"], result[2])}
            codes[result[0]] += 1
            found = faults(result, len(text))
            if not found:
                continue
            failed += 1
            options.keep.mkdir(parents=True, exist_ok=True)
            kept = options.keep / f"{options.seed}_{turns}.nc"
            kept.write_bytes(text)
            kept.with_suffix(".txt").write_text(" ".join(line).replace(path, kept.name) + f"\n{'; '.join(found)}\n{result[4].decode(errors='replace')}\n")
            print(f"turn {turns}, {len(text)} bytes of {seed.name}: {'; '.join(found)}: dripfeed {' '.join(line).replace(path, str(kept))}", flush=True)
    print(f"{turns} turns, {failed} failed, exit codes {dict(sorted(codes.items()))}; at most {worst['computing_s']:.1f} s, {worst['held_mb']} MB, {worst['output']} bytes of output")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
