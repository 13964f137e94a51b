#!/usr/bin/env python3
"""How fast programs are interpreted: the whole process `dripfeed run --trace none`, best of a few runs, with peers in the same run.

  tests/bench/interpret.py [--binary build/release/dripfeed] [--blocks 1000000] [--passes 1000000] [--runs 5] [--big 0]
                           [--peer 'rs274 {file}'] [--lua lua5.4]

A plain program of BLOCKS blocks (a raster of short moves, four decimals) for each control, with the peak memory of it and of one ten times as
long; a macro loop of PASSES passes. --peer runs a command on the same raster without '%' and O number, {file} standing for its name; --lua
runs the loop's arithmetic in that interpreter. --big N adds one plain program of N bytes, to see that its memory is the same.
"""

import argparse
import math
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
HEADS = {
    "fanuc": ("%\nO0001\nG21 G90 G94 G17 G40 G49\nF3000.\nG00 X0. Y0. Z5.\n", "M30\n%\n"),
    "sinumerik-840d": ("G71 G90 G94 G17 G40\nF3000\nG0 X0 Y0 Z5\n", "M30\n"),
    "peer": ("G21 G90 G94 G17 G40 G49\nF3000.\nG00 X0. Y0. Z5.\n", "M2\n"),
}
LOOP = {
    "fanuc": "%%\nO0002\nG21 G90 G94\n#1=0\n#5=0\nWHILE[#1LT%d]DO1\n#2=[100.0*SIN[#1*0.36]]\n#3=[100.0*COS[#1*0.36]]\n#4=[SQRT[#1+1.0]/1000.0]\n"
             "#5=[#5+[#2*#3]/[1.0+#4]]\n#1=[#1+1]\nEND1\nM30\n%%\n",
    "sinumerik-840d": "G71 G90 G94\nR1=0 R5=0\nWHILE R1<%d\nR2=100.0*SIN(R1*0.36)\nR3=100.0*COS(R1*0.36)\nR4=SQRT(R1+1.0)/1000.0\n"
                      "R5=R5+(R2*R3)/(1.0+R4)\nR1=R1+1\nENDWHILE\nM30\n",
}
LUA = """local n = %d; local a, b, c, d, e = 0, 0, 0, 0, 0; local rad = math.pi / 180
while a < n do
  b = 100.0 * math.sin(a * 0.36 * rad); c = 100.0 * math.cos(a * 0.36 * rad); d = math.sqrt(a + 1.0) / 1000.0
  e = e + (b * c) / (1.0 + d); a = a + 1
end
print(e)
"""


def raster(blocks, path, control):
    """Rows of 2000 points, 0.1 mm apart, on a wavy surface."""
    head, tail = HEADS[control]
    with open(path, "w", buffering=1 << 20) as out:
        out.write(head)
        for i in range(blocks):
            row, column = divmod(i, 2000)
            column = 1999 - column if row & 1 else column
            x, y = column * 0.1, row * 0.25
            z = 8.0 * math.sin(x * 0.04) * math.cos(y * 0.07) - 10.0
            out.write(f"G01 X{x:.4f} Y{y:.4f} Z{z:.4f} F{2500.0 + 400.0 * math.cos(i * 0.002):.4f}\n")
        out.write(tail)


def measure(command, runs):
    """(best seconds, peak MiB) of a whole process."""
    best, peak = math.inf, 0
    for _ in range(runs):
        begin = time.perf_counter()
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        said = process.stderr.read()
        _, status, usage = os.wait4(process.pid, 0)
        best = min(best, time.perf_counter() - begin)
        peak = max(peak, usage.ru_maxrss / 1024)
        if status != 0:
            sys.exit(f"{shlex.join(map(str, command))}: {said.decode(errors='replace')[:500]}")
    return best, peak


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--binary", default=ROOT / "build/release/dripfeed")
    options.add_argument("--blocks", type=int, default=1_000_000)
    options.add_argument("--passes", type=int, default=1_000_000)
    options.add_argument("--runs", type=int, default=5)
    options.add_argument("--big", type=int, default=0)
    options.add_argument("--peer")
    options.add_argument("--lua")
    given = options.parse_args()
    run = [str(given.binary), "run", "--trace", "none"]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        print(f"{'plain program':16} {'blocks':>10} {'s':>8} {'blocks/s':>12} {'peak MiB':>9}")
        ours = {}
        for control in ("fanuc", "sinumerik-840d"):
            for blocks in (given.blocks, 10 * given.blocks):
                path = folder / "plain.nc"
                raster(blocks, path, control)
                seconds, peak = measure([*run, "--dialect", control, path], given.runs)
                ours.setdefault(control, seconds)
                print(f"{control:16} {blocks:10} {seconds:8.3f} {blocks / seconds:12.0f} {peak:9.1f}", flush=True)
        if given.big:
            path = folder / "plain.nc"
            raster(given.big // 43, path, "fanuc")
            seconds, peak = measure([*run, "--dialect", "fanuc", path], 1)
            print(f"{'fanuc':16} {given.big // 43:10} {seconds:8.3f} {given.big // 43 / seconds:12.0f} {peak:9.1f}")
        if given.peer:
            path = folder / "peer.ngc"
            raster(given.blocks, path, "peer")
            seconds, peak = measure(shlex.split(given.peer.format(file=path)), min(given.runs, 3))
            print(f"{'peer':16} {given.blocks:10} {seconds:8.3f} {given.blocks / seconds:12.0f} {peak:9.1f}   {seconds / ours['fanuc']:.1f} times ours")
        print(f"{'macro loop':16} {'passes':>10} {'s':>8} {'passes/s':>12}")
        for control, text in LOOP.items():
            path = folder / "loop.nc"
            path.write_text(text % given.passes)
            seconds, _ = measure([*run, "--dialect", control, path], given.runs)
            ours[control] = seconds
            print(f"{control:16} {given.passes:10} {seconds:8.3f} {given.passes / seconds:12.0f}", flush=True)
        if given.lua:
            path = folder / "loop.lua"
            path.write_text(LUA % given.passes)
            seconds, _ = measure([given.lua, path], given.runs)
            print(f"{given.lua:16} {given.passes:10} {seconds:8.3f} {given.passes / seconds:12.0f}   {seconds / ours['fanuc']:.2f} times ours")


if __name__ == "__main__":
    main()
