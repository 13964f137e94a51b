#!/usr/bin/env python3
"""Random programs with calls, arguments, empty variables, types and structures, translated and run: the moves must be the same.

  tests/bench/translate_random.py [--count 500] [--seed 1] [--binary build/release/dripfeed] [--keep FOLDER]

Half of the programs are macros of letters (Fanuc, to SINUMERIK and Mazak), half have parameters by position (SINUMERIK, to the three others).
Moves of no length do not count. What is refused is counted; what moves differently is a fault, written to --keep, and the exit is 1. Values that
two controls compare with other tolerances (1e-12 of the value, 1e-7 in its translation) may differ by chance, once in some hundred programs.
"""

import argparse
import collections
import pathlib
import random
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
LETTERS = {1: "A", 2: "B", 4: "I", 7: "D", 9: "F", 11: "H", 24: "X", 25: "Y", 26: "Z"}
LOCALS = sorted(LETTERS)


def macro_condition(rng, depth=0):
    kind, number = rng.random(), rng.choice(LOCALS)
    if depth < 2 and kind < 0.3:
        return f"[{macro_condition(rng, depth + 1)}{rng.choice(['AND', 'OR'])}{macro_condition(rng, depth + 1)}]"
    if kind < 0.6:
        return f"[#{number}{rng.choice(['EQ', 'NE'])}#0]"
    return f"[#{number}{rng.choice(['EQ', 'NE', 'LT', 'GT', 'GE', 'LE'])}{rng.choice([0, 1, 2, 5])}.]"


def macro_body(rng):
    out, label, waiting = [], 10, []
    for _ in range(rng.randint(3, 10)):
        kind = rng.random()
        if kind < 0.3:
            out.append(f"IF{macro_condition(rng)}THEN #{rng.choice(LOCALS)}={rng.randint(0, 5)}.")
        elif kind < 0.5:
            out.append(f"IF{macro_condition(rng)}GOTO{label}")
            waiting.append(label)
            label += 10
        elif kind < 0.8:
            values = ["#%d", "-#%d", "[#%d+1.]", "[#%d*2.]"]
            words = [axis + rng.choice(values) % rng.choice(LOCALS) for axis in rng.sample("XYZ", rng.randint(1, 3))]
            out.append("G01 " + " ".join(words) + rng.choice(["", " F50."]))
        elif kind < 0.9:
            out.append("#%d=[#%d+#%d]*2." % tuple(rng.choice(LOCALS) for _ in range(3)))
        if waiting and rng.random() < 0.5:
            out.append(f"N{waiting.pop()} G01 X{rng.randint(0, 9)}.")
    return out + [f"N{number}" for number in waiting]


def macro_program(rng):
    lines = ["%", "O0001", "G17 G21 G90 G94", "G00 X0 Y0 Z0", "F10."]
    for _ in range(rng.randint(1, 4)):
        given = sorted(rng.sample(LOCALS, rng.randint(0, 6)))
        lines.append("G65 P9010" + "".join(f" {LETTERS[number]}{rng.randint(0, 5)}." for number in given))
    return lines + ["M30", "O9010"] + macro_body(rng) + ["M99", "%"]


def expression(rng, names, depth=0):
    kind = rng.random()
    if depth > 2 or kind < 0.4:
        return rng.choice(names)
    if kind < 0.55:
        return str(rng.choice([0, 1, 2, 0.5, -1, 2.5, -2.5, 7]))
    if kind < 0.8:
        return f"({expression(rng, names, depth + 1)}{rng.choice('+-*')}{expression(rng, names, depth + 1)})"
    functions = ["ROUND(%s)", "ABS(%s)", "TRUNC(%s)", "POT(%s)", "ROUNDUP(%s)", "MINVAL(%s,2)", "MAXVAL(%s,-1)", "SIN(%s)"]
    return rng.choice(functions) % expression(rng, names, depth + 1)


def condition(rng, names, truths):
    kind = rng.random()
    if truths and kind < 0.2:
        return rng.choice(truths)
    if kind < 0.3:
        return f"NOT ({condition(rng, names, truths)})"
    if kind < 0.45:
        return f"({condition(rng, names, truths)}) {rng.choice(['AND', 'OR', 'XOR'])} ({condition(rng, names, truths)})"
    return expression(rng, names, 1) + rng.choice(["==", "<>", "<", ">", "<=", ">="]) + expression(rng, names, 1)


def body(rng, names, truths, calls, depth=0):
    out = []
    for _ in range(rng.randint(1, 4)):
        kind = rng.random()
        if kind < 0.3:
            out.append("G1 " + " ".join(f"{axis}={expression(rng, names)}" for axis in rng.sample("XYZ", rng.randint(1, 2))))
        elif kind < 0.5:
            out.append(f"{rng.choice(names)}={expression(rng, names)}")
        elif kind < 0.6 and truths:
            out.append(f"{rng.choice(truths)}={condition(rng, names, truths)}")
        elif kind < 0.75 and depth < 2:
            other = ["ELSE"] + body(rng, names, truths, calls, depth + 1) if rng.random() < 0.5 else []
            out += ["IF " + condition(rng, names, truths)] + body(rng, names, truths, calls, depth + 1) + other + ["ENDIF"]
        elif kind < 0.85 and depth < 2:
            counter = f"K{depth}_"
            out += [f"FOR {counter}={rng.randint(-1, 1)} TO {rng.randint(0, 3)}"] + body(rng, names, truths, calls, depth + 1)
            out += [f"G1 Z={counter}", "ENDFOR"]
        elif calls:
            out.append(rng.choice(calls)())
        else:
            out.append(f"G1 X={expression(rng, names)}")
    return out


def program_with_parameters(rng):
    def call():
        given = [rng.choice(["", "R1", "2.5", "-2.5", "R2*2", "1"]) for _ in range(rng.randint(1, 3))]
        return f"SUBA_({','.join(given if any(given) else ['1'])})"

    def head(name, kind):
        return [f"%_N_{name}_{kind}", f";$PATH=/_N_{kind}_DIR"]

    parameters = ", ".join(f"{kind} {name}{rng.choice(['', '=1'])}" for kind, name in [("REAL", "PA_"), ("INT", "PB_"), ("BOOL", "PC_")])
    lines = head("MAIN", "MPF") + ["DEF REAL U_=1,V_", "DEF INT I_,K0_,K1_", "DEF BOOL B_", "G17 G710 G90 G94"]
    lines += [f"R1={rng.choice([1, 2.5, -2.5])} R2={rng.choice([3, 0, -1])}", "G0 X0 Y0 Z0", "F100"]
    lines += body(rng, ["U_", "V_", "R1", "R2", "I_"], ["B_"], [call, lambda: "SUBB_", lambda: "L20 P2"]) + ["G1 X=U_ Y=V_ Z=I_", "M30"]
    lines += head("SUBA_", "SPF") + [f"PROC SUBA_({parameters})", "DEF REAL U_=3", "DEF INT I_,K0_,K1_"]
    lines += body(rng, ["U_", "PA_", "PB_", "R1", "I_"], ["PC_"], [lambda: "SUBB_"]) + ["G1 X=U_ Y=PA_ Z=PB_+PC_", "M17"]
    lines += head("SUBB_", "SPF") + ["PROC SUBB_", "DEF REAL W_=2", "DEF INT K0_,K1_"]
    lines += body(rng, ["W_", "R2"], [], []) + ["G1 Y=W_", "M17"]
    return lines + head("L20", "SPF") + ["R2=R2+1", "G1 Z=R2", "M17"]


def moves_of(binary, path, dialect):
    command = [binary, "run", path, "--dialect", dialect, "--control", "kind=mill", "--trace", "motions"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60)
    moves = []
    for line in done.stdout.splitlines():
        words = line.split(" ")[1:]
        if words and words[0] in ("rapid", "linear") and (not moves or words != moves[-1]):
            moves.append(words)
    return moves if done.returncode == 0 else None


def same(first, second):
    def close(a, b):
        if a == b:
            return True
        if a[0] != b[0] or not a[1:] or "/" in a:
            return False
        return abs(float(a[1:]) - float(b[1:])) <= 0.0002 * max(1.0, abs(float(a[1:])))

    if first is None or second is None or len(first) != len(second):
        return False
    return all(len(a) == len(b) and a[0] == b[0] and all(map(close, a[1:], b[1:])) for a, b in zip(first, second))


def main():
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("--count", type=int, default=500)
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--binary", default=str(ROOT / "build/release/dripfeed"))
    options.add_argument("--keep", type=pathlib.Path)
    options = options.parse_args()
    rng, counts = random.Random(options.seed), collections.Counter()
    with tempfile.TemporaryDirectory() as folder:
        for number in range(options.count):
            by_letter = number % 2 == 0
            origin = "fanuc" if by_letter else "sinumerik-840d"
            target = rng.choice(["sinumerik-840d", "mazak"] if by_letter else ["fanuc", "mazak", "mitsubishi-m80"])
            text = "\n".join(macro_program(rng) if by_letter else program_with_parameters(rng)) + "\n"
            source, there = pathlib.Path(folder) / "source", pathlib.Path(folder) / "there"
            source.write_text(text)
            expected = moves_of(options.binary, source, origin)
            if expected is None:
                counts[origin, "does not run"] += 1
                continue
            command = [options.binary, "convert", source, "--from", origin, "--to", target]
            done = subprocess.run(command, capture_output=True, text=True, timeout=60)
            if done.returncode != 0:
                counts[origin, "refused"] += 1
                continue
            there.write_text(done.stdout)
            if same(expected, moves_of(options.binary, there, target)):
                counts[origin, "same"] += 1
                continue
            counts[origin, "moves differently"] += 1
            print(f"program {number} of seed {options.seed}, {origin} to {target}, moves differently")
            if options.keep:
                options.keep.mkdir(parents=True, exist_ok=True)
                (options.keep / f"{options.seed}-{number}-{origin}-{target}.nc").write_text(text)
    for (origin, outcome), count in sorted(counts.items()):
        print(f"{origin:16} {outcome:16} {count}")
    return 1 if any(outcome == "moves differently" for _, outcome in counts) else 0


if __name__ == "__main__":
    sys.exit(main())
