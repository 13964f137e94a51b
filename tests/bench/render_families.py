#!/usr/bin/env python3
"""The time of a core for rendering each shipped family, as macro and as plain blocks, without the start of the process.

render_families.py BINARY [RUNS]: the least of RUNS runs (20), less the least of as many of `dripfeed --version`.
"""
import pathlib
import resource
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
LATHE = "machine lathe"
RUNNING_ON = {"lathe": "fanuc-0i-lathe", "mill": "fanuc-0i-mill"}
OTHER = {"worm": "mazak-vcn", "worm-turned": "mazak-integrex", "turning-cycle": "sinumerik-840d-lathe",
         "seal-ring": "sinumerik-810d-lathe"}


def least_ms(command, runs):
    best = None
    for _ in range(runs):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        done = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, check=False)
        if done.returncode != 0:
            raise SystemExit(f"{' '.join(map(str, command))}: {done.stderr.decode()}")
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        taken = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        best = taken if best is None else min(best, taken)
    return best * 1000.0


def main():
    binary = sys.argv[1]
    runs = int(sys.argv[2]) if len(sys.argv) > 2 else 20
    start = least_ms([binary, "--version"], runs)
    print(f"start of the process {start:.1f} ms")
    for family in sorted((ROOT / "deploy/families").glob("*.family")):
        kind = "lathe" if LATHE in family.read_text() else "mill"
        machine = OTHER.get(family.stem, RUNNING_ON[kind])
        taken = [least_ms([binary, "render", family, "--machine", machine, "--mode", mode], runs) - start
                 for mode in ("macro", "explicit")]
        print(f"{family.stem:20} {machine:24} macro {taken[0]:5.1f} ms  explicit {taken[1]:5.1f} ms")


if __name__ == "__main__":
    main()
