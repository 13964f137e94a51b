#!/usr/bin/env python3
"""A long program of plain moves, checked and translated: time and memory of the whole process, with those of interpreting it.

  tests/bench/long_program.py --binary build/dev/dripfeed [--blocks 1000000] [--runs 3] [--mixed]

The program is a spiral in G1 with a head and an end, or, mixed, what a CAM system writes: lines, half circles, rapids, feeds where they change. It is made
for each run, so that no figure is of a text that was chosen. Each command is run so many times; the median time and the largest memory (the resident set) are shown. Exits 1 where a command fails, a translation is not verified, or a
translation has another number of blocks."""

import argparse
import math
import os
import pathlib
import random
import statistics
import sys
import tempfile
import time

HEAD = "%\nO0001\nG21 G17 G90 G94 G40 G49 G80\nT1 M6\nG54\nS8000 M3\nG0 X0. Y0.\nG43 Z5. H1\nG1 Z-1. F500.\n"
END = "G0 Z5.\nM5\nM30\n%\n"


def write(path, blocks):
    with open(path, "w") as file:
        file.write(HEAD)
        for i in range(blocks):
            radius = 50 * (1 - i / (2 * blocks))
            file.write(f"X{radius * math.cos(i * 0.001):.3f} Y{radius * math.sin(i * 0.001):.3f}\n")
        file.write(END)


def write_mixed(path, blocks):
    pick = random.Random(blocks)
    x = y = 0  # hundredths of a millimetre, so that each arc is exact
    with open(path, "w") as file:
        file.write(HEAD)
        for _ in range(blocks):
            kind, feed = pick.randrange(12), f" F{pick.randrange(100, 900)}." if pick.random() < 0.1 else ""
            if kind < 2:
                i, j = pick.randrange(-200, 200), pick.randrange(-200, 200)
                x, y = x + 2 * i, y + 2 * j
                file.write(f"G0{2 + kind} X{x / 100:.2f} Y{y / 100:.2f} I{i / 100:.2f} J{j / 100:.2f}{feed}\n")
            elif kind == 2:
                file.write(f"G01 Z{-pick.random() - 1:.3f}{feed}\n")
            else:
                x, y = pick.randrange(-2000, 2000), pick.randrange(-2000, 2000)
                file.write(f"G00 X{x / 100:.2f} Y{y / 100:.2f}\n" if kind == 3 else f"G01 X{x / 100:.2f} Y{y / 100:.2f}{feed}\n")
        file.write(END)


def measure(arguments, messages):
    """Seconds, MiB and the exit code of one process, whose messages go into a file."""
    begun = time.monotonic()
    number = os.posix_spawn(arguments[0], arguments, os.environ, file_actions=[
        (os.POSIX_SPAWN_OPEN, 1, os.devnull, os.O_WRONLY, 0),
        (os.POSIX_SPAWN_OPEN, 2, str(messages), os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o600)])
    _, status, use = os.wait4(number, 0)
    return time.monotonic() - begun, use.ru_maxrss / 1024, os.waitstatus_to_exitcode(status)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--binary", required=True)
    parser.add_argument("--blocks", type=int, default=1_000_000)
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--mixed", action="store_true")
    given = parser.parse_args()
    failed = False
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        program, made, messages = folder / "long.nc", folder / "made", folder / "messages"
        (write_mixed if given.mixed else write)(program, given.blocks)
        lines = program.read_text().count("\n")
        commands = {"run": ["run", str(program), "--dialect", "fanuc"], "check": ["check", str(program), "--dialect", "fanuc"]}
        for target in ("sinumerik-840d", "mazak", "mitsubishi-m80", "haas"):
            commands[f"convert to {target}"] = ["convert", str(program), "--from", "fanuc", "--to", target, "--output", str(made)]
        base = None
        for name, words in commands.items():
            seen = [measure([given.binary, *words], messages) for _ in range(given.runs)]
            seconds, most, code = statistics.median(s for s, _, _ in seen), max(m for _, m, _ in seen), max(c for _, _, c in seen)
            base = base or seconds
            wrong = code != 0 or "not verified" in messages.read_text()
            wrong = wrong or (name.startswith("convert") and abs(made.read_text().count("\n") - lines) > 4)
            failed = failed or wrong
            print(f"{name:28} {seconds:6.2f} s  {most:6.0f} MiB  {seconds / base:5.2f} times run{'  FAILED' if wrong else ''}", flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
