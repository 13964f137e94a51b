#!/usr/bin/env python3
"""Real programs with new block numbers: each must make the moves of the one that it came from, line by line.

  tests/bench/renumber_real.py DIR --dialect D [--binary build/dev/dripfeed]

What is refused is counted by its reason. A program that moves differently, or a command that ends by a signal, is a fault, and the exit is 1.
"""

import argparse
import collections
import pathlib
import re
import subprocess
import sys
import tempfile


def run(*command):
    return subprocess.run(command, capture_output=True, timeout=60)


# Lines stay where they are, so the moves are the same text; of what is printed with them the numbers of blocks are not.
def moves(options, path, folders):
    return run(options.binary, "run", str(path), "--dialect", options.dialect, *folders).stdout.splitlines()


def first_difference(before, after):
    return next((pair for pair in zip(before, after) if pair[0] != pair[1]), f"{len(before)} and {len(after)} lines")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--dialect", required=True)
    parser.add_argument("--binary", default="build/dev/dripfeed")
    options = parser.parse_args()
    counts, reasons, faults = collections.Counter(), collections.Counter(), []
    with tempfile.TemporaryDirectory() as folder:
        for file in sorted(path for path in options.folder.rglob("*") if path.is_file() and path.suffix != ".md"):
            folders = [arg for one in [file.parent, *sorted(file.parent.parent.iterdir())] if one.is_dir() for arg in ("--path", str(one))]
            for blocks in ("numbered", "all", "none"):
                out = pathlib.Path(folder) / "new.nc"
                out.unlink(missing_ok=True)
                made = run(options.binary, "renumber", str(file), "--dialect", options.dialect, "--blocks", blocks, "--step", "1", "--output", str(out))
                if made.returncode < 0:
                    faults.append(f"{file}: {blocks}: ended by {made.returncode}")
                if made.returncode != 0:
                    why = re.search(rb"not renumbered: (.*)", made.stderr)
                    counts["refused" if why else "not read"] += 1
                    if why:
                        reasons[re.sub(r'".*"|N?\d+', "…", why[1].decode(errors="replace"))[:70]] += 1
                    continue
                before, after = (moves(options, path, folders) for path in (file, out))
                counts["moves the same" if before == after else "moves differently"] += 1
                if before != after:
                    faults.append(f"{file}: {blocks}: {first_difference(before, after)}")
    for what, count in counts.most_common():
        print(f"{count:6} {what}")
    for why, count in reasons.most_common(12):
        print(f"{count:6} refused: {why}")
    print("\n".join(faults[:40]))
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
