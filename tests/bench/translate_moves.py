#!/usr/bin/env python3
"""Programs of moves made by chance, translated and run on both sides: a translation is the same moves, or it is refused. (translate_random.py: calls.)

  tests/bench/translate_moves.py [--binary build/release/dripfeed] [--from KIND|all] [--programs 300] [--seed 1] [--keep FOLDER]

Each second program is a mill's: variables, arrays, conditions, loops, jumps, a subprogram with arguments, frames, arcs and drilling and boring cycles of its
control; the others are a lathe's: turning and thread cycles, taps, polar and cylindrical interpolation. It is run, translated to every other control (macro and explicit), and run there. Compared: the end points of all moves, their kinds and feeds; a rapid
that only stops on the path of the next one is no difference (cycles come down to their reference plane in one move or in two). Counts what is the
same, what is refused, what the source itself leaves open (not compared; its translation may not count as verified), and what differs, which is a fault:
exits 1 when there is any. --keep saves those.
"""

import argparse
import collections
import concurrent.futures
import math
import pathlib
import random
import re
import subprocess
import sys
import tempfile

from translate_cycles import CYCLES
from translate_mixed import MIXED

ROOT = pathlib.Path(__file__).resolve().parents[2]
DIALECTS = ("fanuc", "haas", "mazak", "mitsubishi-m80", "sinumerik-840d")
MOVES = {"rapid", "linear", "arc-cw", "arc-ccw", "thread", "spline"}
TAP_RPM = 500
TOLERANCE_MM = 0.004  # 0.0001 inch and a rounding; printed with three or four decimals, and added up by increments


class Maker:
    """What the languages share: chance, depth, lines."""

    kind = "mill"

    def __init__(self, seed):
        self.chance = random.Random(seed)
        self.lines, self.labels, self.depth = [], 0, 0

    def put(self, line):
        self.lines.append(line)

    def number(self, low=-40.0, high=40.0):
        return f"{self.chance.uniform(low, high):.3f}"

    def one_of(self, *choices):
        return self.chance.choice(choices)

    def body(self, count):
        for _ in range(count):
            self.statement()

    def nested(self, count):
        self.depth += 1
        self.body(self.chance.randint(1, count))
        self.depth -= 1

    def label(self):
        self.labels += 1
        return self.labels


class Sinumerik(Maker):
    def variable(self):
        return self.one_of("R1", "R2", "R3", "V1", "V2", "I1", "A[2]", "A[I1 MOD 4]" if self.in_range else "A[1]")

    def value(self, depth=0):
        if depth > 2 or self.chance.random() < 0.35:
            return self.one_of(self.variable(), self.number(0, 9), str(self.chance.randint(1, 7)))
        a, b = self.value(depth + 1), self.value(depth + 1)
        return self.one_of(f"({a}+{b})", f"({a}-{b})", f"({a}*{self.number(0.1, 1.5)})", f"({a}/{self.chance.randint(2, 6)})", f"SIN({a})", f"COS({a})",
                           f"SQRT(ABS({a}))", f"ABS({a})", f"ROUND({a})", f"TRUNC({a})", f"MINVAL({a},{b})", f"MAXVAL({a},{b})", f"BOUND(-9,9,{a})",
                           f"(I1 DIV {self.chance.randint(2, 4)})", f"(I1 MOD {self.chance.randint(2, 4)})", f"POT(BOUND(-3,3,{a}))", f"ATAN2({a},7)")

    def bounded(self):
        return f"BOUND(-60,60,{self.value()})" if self.chance.random() < 0.2 else f"50*SIN(9*{self.value()})"

    def condition(self):
        one = f"({self.value(1)}{self.one_of('<', '>', '<=', '>=')}{self.value(1)})"
        return self.one_of(one, one, f"{one} AND (I1<>2)", f"{one} OR (I1==1)", f"NOT {one}")

    def assignment(self):
        name = self.one_of("R1", "R2", "R3", "V1", "V2", "I1", "A[0]", "A[3]")
        value = self.bounded()
        self.put(f"{name}=" + (f"BOUND(0,9,{value})" if name == "I1" else value))

    def move(self):
        axes = self.chance.sample("XYZ", self.chance.randint(1, 3))
        words = " ".join(f"{axis}={self.bounded()}" if self.chance.random() < 0.5 else f"{axis}{self.number()}" for axis in axes)
        self.put(self.one_of("G0 ", "G1 ", "") + words)

    def arc(self):
        if self.stands and self.depth == 0:
            self.put("G0 Z30\nG1 " + self.one_of(f"X{self.number()} Y{self.number()}", "Y=IC(3)"))
            space = self.one_of("", f" Z{self.number()} K1={self.number()}")
            self.put(f"CIP X{self.number()} Y{self.number()} I1={self.number()} J1={self.number()}{space}\n" + self.one_of("G1", f"CT X{self.number()} Y{self.number()}\nG1", f"X{self.number()} Y{self.number()} I1={self.number()} J1={self.number()}\nG0"))
            return
        radius = self.number(2, 9)
        self.put("G91")
        self.put(self.one_of(f"G2 X{2 * float(radius):.3f} Y0 I{radius} J0", f"G3 X{radius} Y{radius} CR={radius}", f"G2 X0 Y0 I{radius} J0"))
        self.put("G90 G1")

    def choice(self):
        self.put(f"IF {self.condition()}")
        self.nested(2)
        if self.chance.random() < 0.5:
            self.put("ELSE")
            self.nested(2)
        self.put("ENDIF")

    def loop(self):
        counter = f"C{self.depth}"
        kind = self.chance.randrange(4)
        if kind == 0:
            self.put(f"FOR {counter}={self.chance.randint(0, 2)} TO {self.chance.randint(2, 4)}")
        else:
            self.put(f"{counter}=0")
            self.put((f"WHILE {counter}<3", "REPEAT", "LOOP")[kind - 1])
        self.nested(3)
        if kind != 0:
            self.put(f"{counter}={counter}+1")
        if kind == 3:
            label = f"OUT{self.label()}"
            self.put(f"IF {counter}>2 GOTOF {label}")
        self.put(("ENDFOR", "ENDWHILE", f"UNTIL {counter}>2", "ENDLOOP")[kind])
        if kind == 3:
            self.put(f"{label}:")

    def jump(self):
        label = f"ON{self.label()}"
        self.put(f"IF {self.condition()} GOTOF {label}")
        self.nested(2)
        self.put(f"{label}:")

    def repeat(self):
        """A part that is run once, then again by its REPEAT, or by one from elsewhere after it."""
        label = f"PART{self.label()}"
        self.put(f"{label}A: R3=R3+1")
        self.nested(2)
        self.put(self.one_of(f"REPEAT {label}A P={self.chance.randint(1, 2)}", f"{label}B: G1 X=IC(1)\nREPEAT {label}A {label}B P={self.chance.randint(1, 2)}",
                             f"{label}B: G0 Y=IC(1)\nREPEATB {label}B P=I1"))

    def polar(self):
        x, y, radius, angle = self.number(), self.number(), self.number(3, 20), self.chance.randint(0, 350)
        self.put(f"G111 X{x} Y{y}")
        self.put(f"G1 AP={angle} RP={radius}")
        self.put(self.one_of(f"G3 AP=IC({self.chance.randint(10, 350)}) RP={radius}\nG1", f"AP=IC({self.chance.randint(-90, 90)})", f"AP=R1 RP={radius}", f"G112 X1 Y=R1\nAP=R2*10 RP={radius}"))

    def frame(self):
        self.put(self.one_of(f"TRANS X{self.number()} Y{self.number()}", f"TRANS Y{self.number()}\nATRANS X{self.number()} Y{self.number()}", f"TRANS X{self.number()}\nAROT RPL={self.number()}", "TRANS"))
        self.put(f"G0 X{self.number()} Y{self.number()} Z30")  # what an increment after a change of the frame ends at, setting data decides

    def drill(self):
        self.put(f"TRANS\nG0 X{self.number()} Y{self.number()} Z30")
        depth, peck = self.number(-20, -4), self.number(1, 4)
        cycle = self.one_of(f"CYCLE81(30,2,1,{depth})", f"CYCLE82(30,2,1,{depth},,0.5)", f"CYCLE83(30,2,0,{depth},,,{peck},0,,,1,1,,,,,1)", f"CYCLE85(30,2,1,{depth},,,90,180)", f"CYCLE86(30,2,1,{depth},,0.3,3,{self.number(-1, 1)},{self.number(-1, 1)},0.1)", f"CYCLE88(30,2,1,{depth},,0.3,4)")
        if self.chance.random() < 0.5:
            self.put(cycle)
            return
        self.put("MCALL " + cycle)
        for _ in range(2):
            self.put(f"X{self.number()} Y{self.number()}")
        self.put("MCALL")

    def call(self):
        self.put(f"PART({self.bounded()},{self.number()})")

    def statement(self):
        kinds = [self.assignment, self.assignment, self.move, self.move, self.arc, self.jump]
        if self.depth < 3:
            kinds += [self.choice, self.loop]
        if self.depth < 2:
            kinds += [self.repeat, self.polar]
        if self.depth == 0 and not self.stands:
            kinds += [self.frame, self.drill]
            if self.calls:
                kinds += [self.call, self.call]
        self.chance.choice(kinds)()

    def text(self):
        self.in_range, self.calls = self.chance.random() < 0.5, self.chance.random() < 0.5
        self.stands = not self.calls and self.chance.random() < 0.3  # nothing but its own blocks decides
        head = ["DEF INT I1=1, C0, C1, C2, C3", "DEF REAL V1=2, V2=3, A[4]=SET(1,2,3,4)", "G17 G710 G90 G94 G40", "G54", "T1 D1 M6", "S900 M3", "F300", "R1=1 R2=2 R3=3",
                "G0 X0 Y0 Z30"]
        self.body(self.chance.randint(6, 14))
        lines = head + self.lines + ["TRANS", "G0 Z50", "M30"]
        if not self.calls:
            return "\n".join(lines) + "\n"
        part = ["PROC PART(REAL P1, REAL P2)", "DEF REAL Q", "Q=P1*2", "IF Q>P2", "Q=P2", "ENDIF", "G1 X=Q Y=P2", "G0 Z=P1+40", "RET"]
        return "%_N_MAIN_MPF\n" + "\n".join(lines) + "\n%_N_PART_SPF\n" + "\n".join(part) + "\n"


class Fanuc(Maker):
    def variable(self):
        return self.one_of("#1", "#2", "#3", "#101", "#102")

    def value(self, depth=0):
        if depth > 1 or self.chance.random() < 0.35:
            return self.one_of(self.variable(), self.number(0, 9), f"{self.chance.randint(1, 7)}.")
        a, b = self.value(depth + 1), self.value(depth + 1)
        return self.one_of(f"[{a}+{b}]", f"[{a}-{b}]", f"[{a}*{self.number(0.1, 1.5)}]", f"[{a}/{self.chance.randint(2, 6)}.]", f"SIN[{a}]", f"COS[{a}]",
                           f"SQRT[ABS[{a}]]", f"ABS[{a}]", f"ROUND[{a}]", f"FIX[{a}]", f"FUP[{a}]", f"ATAN[{a}]/[7.]", f"[FIX[{a}] MOD 5.]")

    def bounded(self):
        return f"[50.*SIN[{self.value()}*7.]]"

    def condition(self):
        return f"{self.value(1)} {self.one_of('LT', 'GT', 'LE', 'GE')} {self.value(1)}"

    def assignment(self):
        self.put(f"{self.one_of('#1', '#2', '#3', '#101', '#102')}={self.bounded()}")

    def move(self):
        axes = self.chance.sample("XYZ", self.chance.randint(1, 3))
        words = " ".join(f"{axis}{self.bounded()}" if self.chance.random() < 0.5 else f"{axis}{self.number()}" for axis in axes)
        self.put(self.one_of("G00 ", "G01 ", "") + words)

    def arc(self):
        radius = self.number(2, 9)
        self.put("G91")
        self.put(self.one_of(f"G02 X{2 * float(radius):.3f} Y0. I{radius} J0.", f"G03 X{radius} Y{radius} R{radius}", f"G02 X0. Y0. I{radius} J0."))
        self.put("G90 G01")

    def jump(self):
        label = 100 + self.label()
        self.put(f"IF[{self.condition()}]GOTO{label}")
        self.nested(2)
        self.put(f"N{label}")

    def branch(self):
        """To one of three blocks, by its number."""
        first = 100 + self.label()
        numbers = [first, 100 + self.label(), 100 + self.label()]
        self.put(f"#19={self.chance.choice(numbers)}")
        self.put("GOTO#19")
        for number in numbers:
            self.put(f"N{number}")
            self.nested(1)

    def polar(self):
        self.put("G16")
        for _ in range(self.chance.randint(1, 3)):
            self.put(self.one_of("G00 ", "G01 ") + self.one_of(f"X{self.number(3, 20)} Y{self.chance.randint(0, 350)}.", f"X{self.number(3, 20)} Y[#1*10.]"))
        self.put("G15")

    def loop(self):
        counter = f"#{20 + self.depth}"
        self.put(f"{counter}=0")
        self.put(f"WHILE[{counter} LT 3]DO{self.depth + 1}")
        self.nested(3)
        self.put(f"{counter}={counter}+1")
        self.put(f"END{self.depth + 1}")

    def frame(self):
        self.put(self.one_of(f"G52 X{self.number()} Y{self.number()}", "G52 X0. Y0.", f"G68 X{self.number()} Y{self.number()} R{self.number()}\nG01 X{self.number()} Y{self.number()}\nG69"))

    def drill(self):
        self.put("G52 X0. Y0. Z0.\nG00 Z30.")
        depth, peck = self.number(-20, -4), self.number(1, 4)
        level = self.one_of("G98", "G99")
        self.put(f"{level} " + self.one_of(f"G81 X{self.number()} Z{depth} R2. F120.", f"G82 X{self.number()} Z{depth} R2. P500 F120.", f"G83 X{self.number()} Z{depth} R2. Q{peck} F120.",
                                           f"G85 X{self.number()} Z{depth} R2. F120.", f"G89 X{self.number()} Z{depth} R2. P300 F120.", f"G76 X{self.number()} Z{depth} R2. I{self.number(-1, 1)} J0.4 P300 F120.",
                                           f"G86 X{self.number()} Z{depth} R2. F120.") if self.chance.random() < 0.9 else f"G98 G87 X{self.number()} Z{depth} R-25. I{self.number(-1, 1)} F120.")
        for _ in range(2):
            self.put(f"X{self.number()} Y{self.number()}")
        self.put("G80")
        self.put("G00 Z30.")

    def pattern(self):
        """Holes by increments, many of one block; numbers without a point."""
        self.put("G52 X0. Y0. Z0.\nG00 X5. Y5. Z30.\nG91")
        many = self.one_of("K", "L") + str(self.chance.randint(2, 4))
        self.put(self.one_of("G98", "G99") + " " + self.one_of("G81 X10. Y2000 Z-30. R-20.", "G83 Y-3. Z-28. R-18. Q4000", "G82 X5. Z-30. R-20. P250", "G85 X-5. Z-30. R-20.") + f" {many} F120.")
        self.put(self.one_of(f"X7. {many}", f"Y-4000 {many}", "X3. Y3."))
        self.put("G80\nG90\nG00 Z30.")

    def tap(self):
        self.put(f"G52 X0. Y0. Z0.\nG00 Z30.\nS{TAP_RPM} M03")
        self.put(self.one_of(f"M29 S{TAP_RPM}\n", "") + self.one_of("G98", "G99") + f" G84 X{self.number()} Z{self.number(-15, -4)} R5. P100 F{self.one_of('500.', '750.')}\nX{self.number()}\nG80")
        self.put("G00 Z30.\nM03 F250.")

    def helix(self):
        radius = self.number(2, 9)
        self.put("G91 G01")
        self.put(self.one_of(f"G02 X{2 * float(radius):.3f} Z-1.5 R{radius}", f"G03 X{radius} Y{radius} Z1. R-{radius}", f"G03 I-{radius} Z-2.", "G18 G02 X3000 Z3000 R3.\nG17", "G19 G03 Y2. Z2. K2.\nG17"))
        self.put("G90 G01 F300.")

    def units(self):
        self.put(self.one_of("G20\nG00 Z1.5\nG01 X1. Y0.5 F12.\nG02 X1.5 Y0.5 I0.25 J0.\nG21\nG00 Z30.\nG01 F300.", "G04 X1.5", "G04 P500", "G93\nG01 X5. F2.\nX9. F4.\nG94 F300.", "G09 G01 X4.", "G53 G00 Z0.\nG00 Z30.",
                             "M08\nG01 X1.\nM09", "G01 X1000 Y-2500", "G00 Z30000", "G10 L2 P1 X1. Y2. Z0.\nG00 X0. Y0. Z30."))

    def call(self):
        self.put(f"G65 P9001 A{self.number()} B{self.bounded()}")

    def sub(self):
        self.put("M98 P9002")

    def statement(self):
        kinds = [self.assignment, self.assignment, self.move, self.move, self.arc, self.jump]
        if self.depth < 3:
            kinds.append(self.loop)
        if self.depth == 0:
            kinds += [self.frame, self.drill, self.branch, self.polar, self.pattern, self.tap, self.helix, self.units]
            if self.calls:
                kinds.append(self.call)
            if self.shares:
                kinds.append(self.sub)
        self.chance.choice(kinds)()

    def text(self):
        kind = self.chance.randrange(3)
        self.calls, self.shares = kind == 1, kind == 2
        head = ["%", "O0001", "G21 G17 G90 G94 G40 G49 G80", "G54", "T1 M06", "S900 M03", "F300.", "#1=1.", "#2=2.", "#3=3.", "#101=4.", "#102=5.", "G00 X0. Y0. Z30."]
        self.body(self.chance.randint(6, 14))
        lines = head + self.lines + ["G52 X0. Y0. Z0.", "G00 Z50.", "M30"]
        if self.calls:
            lines += ["O9001", "#5=#1*2.", "IF[#5 LE #2]GOTO1", "#5=#2", "N1 G01 X#5 Y#2 F200.", "G00 Z[#1+40.]", "M99"]
        if self.shares:
            lines += ["O9002", "G01 X7. Y8. F200.", "G00 Z31.", "M99"]
        return "\n".join(lines) + "\n%\n"


class Figures(Fanuc):
    """Mazak and Mitsubishi mills drill hole patterns."""

    def pattern(self):
        if self.chance.random() < 0.5:
            return super().pattern()
        self.put("G52 X0. Y0. Z0.\nG00 X5. Y5. Z30.")
        self.put(self.one_of("G98", "G99") + f" {self.one_of('G81', 'G82', 'G85')} Z{self.number(-15, -4)} R2. L0 F120.")
        for _ in range(self.chance.randint(1, 2)):
            self.put(self.one_of(f"G34 X{self.number()} Y{self.number()} I{self.number(5, 20)} J{self.number(0, 90)} K{self.chance.randint(2, 6)}", f"G35 X{self.number()} Y{self.number()} I{self.number(3, 9)} J{self.number(0, 180)} K3",
                                 f"G36 X{self.number()} Y{self.number()} I{self.number(5, 20)} J10. P15. K{self.chance.randint(2, 5)}", f"G37.1 X{self.number()} Y{self.number()} I5. P3 J{self.one_of('4.', '-4.')} K2"))
        self.put("G80\nG00 Z30.")


class FanucLathe(Maker):
    """Turning cycles, threads, the face and the cylinder, between moves, loops and jumps."""

    kind = "lathe"

    def at(self, x, z):
        self.put(f"G00 X{x}. Z{z}.")

    def move(self):
        self.put(self.one_of("G00 ", "G01 ") + self.one_of(f"X{self.number(20, 90)}", f"Z{self.number(-40, 5)}", f"U{self.number(-3, 3)} W{self.number(-3, 3)}", "X[40.+#1]"))

    def single(self):
        self.at(60, 5)
        cycle = self.one_of("G92", "G92", "G90")
        feed = self.one_of("1.5", "2.", "0.75")
        self.put(f"{cycle} X{self.number(40, 55)} Z{self.number(-30, -5)}{self.one_of('', ' R-0.8')} F{feed}")
        for _ in range(self.chance.randint(0, 3)):
            self.put(self.one_of(f"X{self.number(30, 50)}", f"U{self.number(-20, -5)}", f"X{self.number(30, 50)} Z{self.number(-30, -5)}", "M08", "X[40.-#1]"))
        self.put("G00 X62.")

    def face(self):
        self.at(60, 5)
        self.put(f"G94 X{self.number(10, 40)} Z{self.number(-5, 3)}{self.one_of('', ' R-1.')} F0.2")
        self.put(f"Z{self.number(-9, -5)}")
        self.put("G00 Z6.")

    def stepped(self):
        self.at(60, 5)
        self.put(f"WHILE[#1 LT {self.chance.randint(3, 6)}.]DO1")
        self.put(f"G92 X[55.-#1] Z{self.number(-30, -5)} F1.5")
        self.put("#1=#1+0.7")
        self.put("END1")
        self.put("G00 X70.")

    def many(self):
        self.at(34, 4)
        if self.chance.random() < 0.6:
            self.put(f"G76 P0{self.chance.randint(1, 3)}{self.one_of('00', '10', '05')}{self.one_of('60', '55', '29', '00')} Q{self.chance.randint(20, 120)} R0.0{self.chance.randint(1, 9)}")
            self.put(f"G76 X{self.number(26, 30)} Z{self.number(-30, -10)}{self.one_of('', ' R-0.4')} P{self.chance.randint(700, 1500)} Q{self.chance.randint(150, 500)} F{self.one_of('1.5', '2.')}")
        elif self.chance.random() < 0.4:
            self.put(f"G76 X{self.number(26, 30)} Z{self.number(-30, -10)} K{self.number(0.7, 1.5)} D{self.chance.randint(150, 500)} A{self.one_of('60', '55', '29')} F1.5")
        else:
            self.put(self.one_of(f"G74 R{self.number(0.2, 1)}\nG74 X30. Z{self.number(-15, -5)} P{self.chance.randint(800, 2000)} Q{self.chance.randint(2000, 6000)} F0.1",
                                 f"G75 R{self.number(0.2, 1)}\nG75 X20. Z{self.number(-3, 3)} P{self.chance.randint(1500, 4000)} Q{self.chance.randint(800, 1500)} F0.1"))

    def hole(self):
        self.at(0, 5)
        self.put(self.one_of(f"G83 Z{self.number(-30, -10)} R-3. Q{self.chance.randint(2000, 6000)} F0.1", f"G85 Z{self.number(-30, -10)} R-2. P500 F0.1"))
        self.put("G80\nG00 Z20.\nX60. Z-5.")
        self.put(f"G87 X{self.number(30, 50)} R-2. Q{self.chance.randint(2000, 6000)} F0.05\nZ{self.number(-20, -8)}\nG80")

    def rigid(self, cycle, words):
        return f"M29 S{TAP_RPM}\n{cycle} {words}"

    def tap(self):
        cycle, feed = self.one_of("G84", "G84", "G88"), self.one_of("1.5", "0.75", "2.")
        self.put("G00 X60. Z5.") if cycle == "G88" else self.at(0, self.one_of(5, 20))
        level = self.one_of("R-2.", "R-3.5", "R0", "R1.", "") if cycle == "G84" else self.one_of("R-2.", "R-4.")
        words = (f"X{self.number(20, 45)}" if cycle == "G88" else f"Z{self.number(-30, -10)}") + f" {level}{self.one_of('', ' P500')} F{feed}"
        by_time = self.chance.random() < 0.3
        if by_time:
            self.put("G98 G01 " + ("Z4.9" if cycle == "G88" else "X0.") + " F100.")
        plain = words.replace(f"F{feed}", f"F{float(feed) * TAP_RPM:g}.") if by_time else words
        self.put(self.rigid(cycle, words if by_time and "R1" in self.rigid("", "") else plain) if self.chance.random() < 0.5 else f"{cycle} {plain}")
        for _ in range(self.chance.randint(0, 2)):
            self.put(self.one_of(f"Z{self.number(-9, -5)}", "W-1.5 K2") if cycle == "G88" else f"Z{self.number(-25, -8)}")
        self.put("G80" + self.one_of("\nG00 Z20.", "\nG00 Z20.\nG01 Z19.", "\nG01 X61." if cycle == "G88" else "\nG01 Z21."))
        if by_time:
            self.put("G99 F0.3")

    def removal(self):
        self.at(62, 2)
        first = 100 + self.label()
        last = 100 + self.label()
        d, z = self.chance.randint(10, 30), self.chance.randint(5, 15)
        shape = [f"N{first} G00 X{d}.", f"G01 Z-{z}. F0.1", self.one_of(f"X{d + 12}. Z-{z + 8}.", f"G02 X{d + 12}. Z-{z + 6}. R6.", f"G03 X{d + 12}. Z-{z + 6}. R6."), "G01 X55.", f"N{last} X62. Z-{z + 20}."]
        if self.chance.random() < 0.4:
            shape = [f"N{first} G00 Z-{z + 15}.", "G01 X60. F0.1", f"X{d + 12}. Z-{z}.", f"X{d}.", f"N{last} Z2."]
            self.put(f"G72 W{self.number(1, 3)} R0.5\nG72 P{first} Q{last} U0.4 W0.1 F0.3")
        elif self.chance.random() < 0.3:
            self.put(f"G73 U{self.number(2, 6)} W2. R{self.chance.randint(2, 4)}\nG73 P{first} Q{last} U0.4 W0.1 F0.3")
        else:
            self.put(f"G71 U{self.number(1, 3)} R0.5\nG71 P{first} Q{last} U0.4 W0.1 F0.3")
        self.lines += shape
        if self.chance.random() < 0.7:
            self.put(f"G70 P{first} Q{last}")
        self.put(self.one_of("G01 X64.", "G00 X64.", "X64."))

    def plain(self):
        self.at(40, 5)
        self.put(f"G32 Z{self.number(-30, -5)} F{self.one_of('1.5', '2.')}" + self.one_of("", f"\nX44. Z{self.number(-40, -30)}"))
        self.put(self.one_of("G00 X60.", "G01 X60.", "G01 X60. F0.25", "F0.3\nG00 X60."))

    def changing(self):
        self.at(40, 5)
        self.put(f"G34 Z{self.number(-30, -10)} F{self.one_of('1.5', '2.')} K{self.one_of('0.05', '-0.02', '0.1')}" + self.one_of("", "\nG34 X48. Z-45. F2. K0.05"))
        self.put(self.one_of("G00 X60.\nG01 X61. F0.2", "G01 X60. F0.25"))

    def polar(self):
        self.at(50, 5)
        self.put("G98\nC0.\nG12.1")
        for _ in range(self.chance.randint(1, 4)):
            self.put("G01 " + self.one_of(f"X{self.number(10, 40)} C{self.number(3, 20)} F100.", f"X{self.number(-40, -10)} C{self.number(3, 9)} F90.", f"U{self.number(1, 4)} H{self.number(1, 4)} F80."))
        self.put("G13.1\nG99\nG00 X60.")

    def cylinder(self):
        self.at(60, 5)
        self.put(f"G98\nC{self.number(0, 90)}\nG07.1 C{self.one_of('20.', '33.5')}")
        for _ in range(self.chance.randint(1, 4)):
            self.put("G01 " + self.one_of(f"Z{self.number(-30, 0)} C{self.number(-90, 90)} F100.", f"W{self.number(-3, 3)} H{self.number(-30, 30)} F80.", "C[#1*7.] F60."))
        self.put("G07.1 C0.\nG99")

    def jump(self):
        label = 100 + self.label()
        self.put(f"IF[#1 {self.one_of('LT', 'GT')} {self.number(1, 5)}]GOTO{label}")
        self.nested(2)
        self.put(f"N{label}")

    def statement(self):
        kinds = [self.move, self.move, self.single, self.single, self.face, self.many, self.many, self.plain, self.changing]
        if self.depth == 0:
            kinds += [self.stepped, self.jump] + ([self.removal, self.hole, self.tap, self.tap] if self.stands else [self.polar, self.cylinder])
        self.chance.choice(kinds)()

    def text(self):
        self.stands = self.chance.random() < 0.5  # no other coordinate system
        self.body(self.chance.randint(4, 9))
        if any("C" in line for line in self.lines):
            self.kind = "mill-turn"
        return "\n".join(["%", "O0001", "G21 G18 G99 G97 G40", "S500 M03", "#1=1.", "G00 X60. Z5.", "G01 F0.3"] + self.lines + ["G00 X100. Z50.", "M30", "%"]) + "\n"


class MazakLathe(FanucLathe):
    def rigid(self, cycle, words):
        return f"{cycle}.2 {words}"


class MitsubishiLathe(FanucLathe):
    def rigid(self, cycle, words):
        return f"{cycle} {words} ,R1"


class SinumerikLathe(Maker):
    kind = "lathe"

    def move(self):
        self.put(self.one_of("G0 ", "G1 ") + self.one_of(f"X{self.number(20, 90)}", f"Z{self.number(-40, 5)}", f"X=IC({self.number(-3, 3)}) Z=IC({self.number(-3, 3)})", "X=40+R1"))

    def thread(self):
        lead, end, taper = self.one_of("1.5", "2", "0.75"), self.number(-40, -10), self.one_of("20", "20", "24")
        depth, allowance, angle = self.number(0.5, 1.4), self.one_of("0", "0.05", ""), self.one_of("0", "29", "30")
        self.put(f"CYCLE97({lead},,0,{end},20,{taper},{self.number(1, 4)},{self.number(0, 3)},{depth},{allowance},{angle},0,{self.chance.randint(1, 6)},{self.chance.randint(0, 2)},{self.chance.randint(1, 4)},{self.chance.randint(1, 2)},1)")

    def plain(self):
        self.put("DIAMON\nG0 X40 Z5")
        self.put(f"G33 Z{self.number(-30, -5)} K{self.one_of('1.5', '2')}" + self.one_of("", f"\nX44 Z{self.number(-40, -30)} K2"))
        self.put(self.one_of("G0 X60", "G1 X60", "G1 X60 F0.25", "F0.3\nG0 X60"))

    def hole(self):
        self.put("DIAMON G17\nG0 X0 Z20")
        self.put(self.one_of(f"CYCLE81(10,0,2,{self.number(-20, -5)})", f"CYCLE83(10,0,2,{self.number(-30, -15)},,-6,,{self.number(1, 4)},0.5,0,1,{self.chance.randint(0, 1)})", f"CYCLE85(10,0,2,{self.number(-20, -5)},,0,0.1,0.2)"))
        self.put("G18")

    def tap(self):
        """By a call, once or modal, or by G331 or G63 and back; the spindle turns again after it."""
        side, lead, depth, dwell = self.chance.random() < 0.3, self.one_of("1.5", "0.75", "2"), self.number(-30, -5), self.one_of("", "0", "0.5")
        self.put("DIAMON\n" + ("G0 X60 Z-5" if side else "G0 X0 Z20"))
        place, start = ("60,45,2," + self.number(20, 40), "60") if side else ("10,0,2," + depth, "20")
        axis, letter = ("X", "I") if side else ("Z", "K")
        end = self.number(20, 40) if side else depth
        kind = self.chance.randrange(4)
        if kind < 2:
            call = (f"CYCLE84({place},,{dwell},{self.one_of(3, 3, 5)},,{lead},0,{TAP_RPM},{TAP_RPM})" if kind == 0 else
                    f"CYCLE840({place},,{dwell},{self.one_of(0, 4)},{self.one_of(3, 3, 4, 5)},{self.one_of(0, 20)},,{lead})")
            self.put("G19" if side else "G17")
            if self.chance.random() < 0.5:
                self.put(call)
            else:
                self.put("MCALL " + call)
                self.put("Z-7\nZ=IC(-2)" if side else f"X0\nX{self.number(0, 9)}")
                self.put("MCALL")
            self.put("G18")
        elif kind == 2:
            self.put(f"SPOS=0\nG331 {axis}{end} {letter}{lead} S{TAP_RPM}" + self.one_of("", "\nG4 F0.3") + f"\nG332 {axis}{start} {letter}{lead}")
        else:
            self.put(f"G63 {axis}{end} F{lead}" + self.one_of("", "\nG4 F0.3") + f"\nG63 {axis}{start} M4")
        self.put(f"G0 Z30 S{TAP_RPM} M3" + self.one_of("\nG1 Z29 F0.3", "\nG1 X61", "\nX60"))

    def removal(self):
        label = f"PART{self.label()}"
        d, z = self.chance.randint(10, 30), self.chance.randint(5, 15)
        self.put("DIAMON\nG0 X82 Z5")
        self.put(f'CYCLE95("{label}:{label}E",{self.number(2, 5)},0.1,0.2,0,0.3,0.2,0.15,{self.one_of(1, 9, 9, 5)})')
        self.shapes += [f"{label}:", f"G1 X{d} Z0", f"Z-{z}", self.one_of(f"X{d + 20} Z-{z + 8}", f"G3 X{d + 20} Z-{z + 10} CR=10", f"G2 X{d + 20} Z-{z + 10} CR=10"), f"{label}E: G1 X{d + 30}"]
        self.put(self.one_of("G1 X80", "G0 X80"))

    def switch(self):
        self.put(self.one_of("DIAMOF", "DIAMON", "G91\nG1 X0.1\nG90"))

    def transmit(self):
        self.put("DIAMON G94 G0 X50 Z5\nC0\nTRANSMIT\nG17")
        for _ in range(self.chance.randint(1, 4)):
            self.put("G1 " + self.one_of(f"X{self.number(10, 40)} Y{self.number(3, 20)} F100", f"X{self.number(-40, -10)} Y{self.number(3, 9)} F90", f"X=IC({self.number(1, 4)}) Y=IC({self.number(1, 4)}) F80"))
        self.put("TRAFOOF\nG18 G95 F0.3\nG0 X60")

    def tracyl(self):
        self.put(f"DIAMON G94 G0 X50 Z5\nC{self.number(0, 90)}\nTRACYL({self.one_of('40', '67')})\nG19")
        for _ in range(self.chance.randint(1, 4)):
            self.put("G1 " + self.one_of(f"Z{self.number(-30, 0)} Y{self.number(-40, 40)} F100", f"Z=IC({self.number(-3, 3)}) F80", "Y=R1*7 F60"))
        self.put("TRAFOOF\nG18 G95 F0.3")

    def jump(self):
        label = f"ON{self.label()}"
        self.put(f"IF R1{self.one_of('<', '>')}{self.number(1, 5)} GOTOF {label}")
        self.nested(2)
        self.put(f"{label}:")

    def statement(self):
        kinds = [self.move, self.move, self.thread, self.thread, self.plain, self.switch]
        if self.depth == 0:
            kinds += [self.jump] + ([self.removal, self.hole, self.tap, self.tap] if self.stands else [self.transmit, self.tracyl])
        self.chance.choice(kinds)()

    def text(self):
        self.stands, self.shapes = self.chance.random() < 0.5, []  # no other coordinate system
        self.body(self.chance.randint(4, 9))
        if any("TRA" in line for line in self.lines):
            self.kind = "mill-turn"
        return "\n".join(["G18 G90 G95 G71 DIAMON G40", "T1 D1", "S500 M3", "R1=2", "G0 X60 Z5", "G1 F0.3"] + self.lines + ["G0 X100", "M30"] + self.shapes) + "\n"


class IsoMill(Fanuc):
    """What stands between G291 and G290: no variables."""

    def value(self, depth=0):
        return self.number(0, 9)

    def bounded(self):
        return self.number()

    def put(self, line):
        super().put("\n".join(part for part in line.split("\n") if not part.startswith("G52")) or "G04 P100")

    def polar(self):
        self.put(f"G16\nG01 X{self.number(3, 20)} Y{self.chance.randint(0, 350)}.\nG15")

    def modes(self):
        self.put(self.one_of("G91\nG01 X1. Y-2.", "G90", "G20\nG01 X0.5 F12.", "G21 G01 X3. F300.", "G00", "G94", "G93\nG01 X5. F2.\nG94 F300.", "/G01 X4.", "(A COMMENT) G01 Z30. ; another", "M98 P9002" if self.shares else "G04 X1.", "N7 X5.", "g01 x7. y8.", "G28 X0. Y0. Z50.", "G43 H1 Z30.\nG49"))

    def part(self, alone, shares):
        self.shares = shares
        kinds = [self.move, self.move, self.arc, self.modes] + ([self.drill, self.polar, self.pattern, self.tap, self.helix, self.units] if alone else [])
        for _ in range(self.chance.randint(1, 4)):
            self.chance.choice(kinds)()
        return "G291\n" + "\n".join(self.lines) + "\nG290"


class IsoLathe(FanucLathe):
    def move(self):
        self.put(self.one_of("G00 ", "G01 ") + self.one_of(f"X{self.number(20, 90)}", f"Z{self.number(-40, 5)}", f"U{self.number(-3, 3)} W{self.number(-3, 3)}", "T0101", "X1.\nX40."))

    def part(self, alone, shares):
        kinds = [self.move, self.move, self.single, self.face, self.many, self.plain, self.changing] + ([self.removal, self.hole, self.tap] if alone else [])
        for _ in range(self.chance.randint(1, 3)):
            self.chance.choice(kinds)()
        lines = [line for line in self.lines if "#" not in line]
        return "G291\n" + "\n".join(lines) + self.one_of("\n", "\nG00 X60.\nG290\nG1 X61 F0.3\n").removesuffix("\n") + "\nG290"


class SinumerikIso(Sinumerik):
    """Parts in the control's other language."""

    def statement(self):
        if self.chance.random() < 0.7:
            return super().statement()
        self.put(IsoMill(self.chance.random()).part(self.depth == 0, self.calls))

    def frame(self):
        self.move()

    def drill(self):
        """How far above the last peck the next one begins, a parameter says where it does not stand in the cycle: in mm."""
        self.put("G710 F300")
        super().drill()

    def text(self):
        """A frame of one language together with one of the other is refused."""
        text = "\n".join(line for line in super().text().split("\n") if line != "TRANS")
        return text + "%_N_O9002_SPF\nG0 Z33\nM17\n" if self.calls else text


class SinumerikLatheIso(SinumerikLathe):
    def statement(self):
        if self.chance.random() < 0.6:
            return super().statement()
        made = IsoLathe(self.chance.random())
        made.labels = self.labels = self.labels + 20
        self.put("DIAMON\n" + made.part(self.depth == 0 and self.stands, False))


MAKERS = {"sinumerik-840d": [Sinumerik, SinumerikLathe], "iso-mode": [SinumerikIso, SinumerikLatheIso], "fanuc": [Fanuc, FanucLathe], "mazak": [Figures, MazakLathe], "mitsubishi-m80": [Figures, MitsubishiLathe]} | {name: [maker] for name, (_, maker) in (MIXED | CYCLES).items()}
LANGUAGES = {"iso-mode": "sinumerik-840d"} | {name: dialect for name, (dialect, _) in (MIXED | CYCLES).items()}
MACHINES = {"fanuc": "fanuc-0i-mill", "haas": "haas-vf2", "mazak": "mazak-vcn", "mitsubishi-m80": "mitsubishi-m80-cvm800", "sinumerik-840d": "sinumerik-840d-mill"}
LATHES = {"fanuc": "fanuc-0i-lathe", "mazak": "mazak-qtn", "sinumerik-840d": "sinumerik-840d-lathe"}


def dripfeed(binary, *arguments):
    done = subprocess.run([binary, *map(str, arguments)], capture_output=True, timeout=60)
    return done.returncode, done.stdout.decode(errors="replace"), done.stderr.decode(errors="replace")


OPEN = ("position that is not known", "whose frame has changed")  # where moves end then, the text does not state


def moves_of(binary, path, dialect, kind="mill", machine=None):
    """([(kind, words)], what the run leaves open), or (None, why it did not run)."""
    what = ["--machine", machine] if machine else ["--dialect", dialect, "--control", f"kind={kind}"]
    code, out, err = dripfeed(binary, "run", path, *what)
    if code != 0:
        return None, err
    moves, rpm, turns = [], TAP_RPM, ""
    for line in out.splitlines():
        words = line.split(" ")
        if len(words) > 3 and words[1] == "spindle" and words[3].endswith("/rpm"):
            rpm, turns = value(words[3][1:]) or rpm, words[2]
        if len(words) > 1 and words[1] in MOVES:
            moves.append((words[1], {"rpm": rpm, "turns": turns} | dict(("change", word) if word.endswith("/rev2") else (word[0], word[1:]) for word in words[2:] if word)))
    return moves, next((reason for reason in OPEN if reason in err), "")


def value(text):
    try:
        return float(text.split("/")[0])
    except ValueError:
        return None


def point(words):
    return tuple(value(words.get(axis, "0")) or 0.0 for axis in "XYZC")


def without_stops(moves, detour):
    """[(kind, words, start)], without moves of no length and without rapids that stop on the path of the next rapid."""
    out, at = [], (0.0, 0.0, 0.0, 0.0)
    for kind, words in moves:
        if kind == "spline":  # a chord of a curve
            kind = "linear"
        to, start = point(words), at
        if kind in ("rapid", "linear") and to == at:
            continue
        if kind == "rapid" and out and out[-1][0] == "rapid":
            before = out[-1][2]
            if math.dist(before, at) + math.dist(at, to) - math.dist(before, to) <= detour:
                start = out.pop()[2]
        out.append((kind, words, start))
        at = to
    return out


def is_short(move):
    return move[0] in ("rapid", "linear") and math.dist(move[2], point(move[1])) <= 2 * TOLERANCE_MM


def is_one_tap(one, other):
    """A feed a minute, or its lead, as a thread or a feed, or a lead below 0 and a spindle that turns counterclockwise: the same thread."""
    if not {one[0], other[0]} <= {"linear", "thread"} or math.dist(point(one[1]), point(other[1])) > TOLERANCE_MM:
        return False
    feeds = [move[1].get("F", "0") for move in (one, other)]
    signs = [value(feed) < 0 for feed in feeds]
    if one[0] == other[0] and feeds[0].rsplit("/", 1)[-1] == feeds[1].rsplit("/", 1)[-1]:
        right = other if signs[0] else one
        turns_in = sum(point(right[1])) < sum(right[2])  # and back out of the hole
        return one[0] == "thread" and signs[0] != signs[1] and right[1]["turns"] == ("ccw" if turns_in else "cw") and abs(value(feeds[0]) + value(feeds[1])) < 1e-4
    leads = [abs(value(feed)) / (1 if feed.endswith("/rev") else move[1]["rpm"]) for feed, move in zip(feeds, (one, other))]
    return abs(leads[0] - leads[1]) < 1e-4  # printed with four decimals


def difference(a, b, breaks_chips=False):
    """Rounded to the printed decimals a stop may lie on the path or just off it, and a short move may be none: either on both sides is no difference."""
    found = [difference_by(a, b, detour, breaks_chips) for detour in (1e-6, 1e-5, 1e-7)]
    return found[0] if all(found) else ""


def difference_by(a, b, detour, breaks_chips):
    a, b = without_stops(a, detour), without_stops(b, detour)
    n, m = 0, 0
    while n < len(a) and m < len(b):
        why = difference_of(a[n], b[m], breaks_chips)
        if not why:
            n, m = n + 1, m + 1
        elif is_short(a[n]):
            n += 1
        elif is_short(b[m]):
            m += 1
        else:
            return f"{why} of move {n}: {a[n][:2]} / {b[m][:2]}"
    more, fewer = [move for move in a[n:] if not is_short(move)], [move for move in b[m:] if not is_short(move)]
    return f"{len(more)} moves less, {len(fewer)} moves more" if more or fewer else ""


def difference_of(one, other, breaks_chips):
    if is_one_tap(one, other):
        return ""
    if math.dist(point(one[1]), point(other[1])) > TOLERANCE_MM:
        return "end"
    # The translation says that it goes back between the pecks at the feed, and not at rapid.
    if breaks_chips and {one[0], other[0]} == {"rapid", "linear"}:
        return ""
    if one[0] != other[0]:
        return "kind"
    changes = [value(move[1].get("change", "0")) or 0.0 for move in (one, other)]
    if abs(changes[0] - changes[1]) > 1e-4:
        return "change of the lead"
    feeds = [value(move[1].get("F", "0")) or 0.0 for move in (one, other)]
    # A time is that of a length, and of a short one the printed decimals are more.
    share = 1e-2 if one[1].get("F", "").endswith("/inv") else 1e-3
    return "feed" if abs(feeds[0] - feeds[1]) > max(1e-3, share * abs(feeds[0])) else ""


def with_own_variables(text, dialect):
    """R parameters and #101 keep their values for other programs, which plain blocks refuse: variables that end with the program do not."""
    if dialect == "sinumerik-840d":
        declared = "DEF REAL V11, V12, V13\n"
        text = re.sub(r"\bR([123])\b", r"V1\1", text)
        return text.replace("%_N_MAIN_MPF\n", "%_N_MAIN_MPF\n" + declared, 1) if text.startswith("%") else declared + text
    return re.sub(r"#10([12])\b", r"#3\1", text)


MOST_MM = 99999.999  # what controls with numbers of eight digits can write at three places


def try_one(binary, dialect, seed, keep):
    """[(target, mode, what)] of one program."""
    makers = MAKERS[dialect]
    maker = makers[seed % len(makers)](seed)
    text = maker.text()
    if dialect in ("sinumerik-840d", "fanuc", "mazak", "mitsubishi-m80") and seed // 2 % 2 == 0:
        text = with_own_variables(text, dialect)
    named = dialect in MIXED and seed % 2 == 0  # translated for a named machine
    dialect = LANGUAGES.get(dialect, dialect)
    kind, results = maker.kind, []
    with tempfile.TemporaryDirectory() as name:
        source = pathlib.Path(name) / "program.nc"
        source.write_text(text)
        machine_of_source = getattr(maker, "machine", None)
        original, left_open = moves_of(binary, source, dialect, kind, machine_of_source)
        if original is None:
            return [("", "", "not run")]
        if any(abs(float(words[axis])) > MOST_MM for _, words in original for axis in "XYZ" if axis in words):
            return [("", "", "beyond eight digits")]
        for target in DIALECTS:
            for mode in ("macro", "explicit"):
                if target == dialect:
                    continue
                machine = (MACHINES if kind == "mill" else LATHES).get(target) if named else None
                for_whom = ["--machine", machine or machine_of_source] if machine or machine_of_source else []
                if not machine or kind != "mill":
                    for_whom += ["--control", f"kind={kind}"]
                code, out, err = dripfeed(binary, "convert", source, "--from", dialect, "--to", target, "--mode", mode, *for_whom)
                if code != 0:
                    why = [line for line in err.splitlines() if ": error[" in line]
                    results.append((target, mode, "refused", why[0].split(": ", 1)[-1] if why else err[:200]))
                    continue
                if left_open and "not verified" not in err:
                    results.append((target, mode, "DIFFERS", "verified, and the source leaves open: " + left_open))
                if left_open:
                    results.append((target, mode, "open", left_open))
                    continue
                if "not verified" in err:
                    results.append((target, mode, "unverified", "not verified: " + err.split("not verified by running it: ")[-1].split("\n")[0]))
                made = pathlib.Path(name) / "made.nc"
                made.write_text(out)
                translated, why = moves_of(binary, made, target, kind)
                fault = "does not run: " + why[:300] if translated is None else "leaves open: " + why if why and "not verified" not in err else difference(original, translated, "the retract between the pecks" in err)
                dropped = [number for number in getattr(maker, "written", []) if number not in out]
                if not fault and dropped:
                    fault = "drops what is written: " + ", ".join(dropped)
                results.append((target, mode, "DIFFERS" if fault else "same", fault))
                if fault and keep:
                    (keep / f"{dialect}_{seed}_{target}_{mode}.txt").write_text(text + "\n---- " + fault + "\n" + out)
    return results


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--binary", default=str(ROOT / "build/release/dripfeed"))
    options.add_argument("--from", dest="dialect", default="all", choices=[*MAKERS, "all"])
    options.add_argument("--programs", type=int, default=300)
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--keep", type=pathlib.Path)
    options.add_argument("--reasons", type=int, default=8, help="how many reasons of refusals are printed")
    given = options.parse_args()
    faults = 0
    for dialect in MAKERS if given.dialect == "all" else [given.dialect]:
        counts, refusals, examples = collections.Counter(), collections.Counter(), []
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            seeds = range(given.seed, given.seed + given.programs)
            for seed, results in zip(seeds, pool.map(lambda s: try_one(given.binary, dialect, s, given.keep), seeds)):
                for target, mode, what, *detail in results:
                    counts[(target, mode, what)] += 1
                    if what in ("refused", "unverified") and detail:
                        refusals[re.sub(r"\(.*\)|\d+(\.\d+)?", "#", detail[0])] += 1
                    if what == "DIFFERS":
                        examples.append(f"  seed {seed} to {target} {mode}: {detail[0]}")
        print(f"{given.programs} programs of {dialect}, from seed {given.seed}")
        for (target, mode, what), n in sorted(counts.items()):
            print(f"  {target:16} {mode:9} {what:10} {n:5}")
        for text, n in refusals.most_common(given.reasons):
            print(f"  refused {n:4}: {text[:150]}")
        print("\n".join(examples[:20]))
        faults += len(examples)
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
