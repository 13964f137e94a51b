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
    notices is not the line of the fault (an end that is missing); "only": the same, and a fault only where the program has one such place. `offset`:
    how many lines after the place the fault stands. `head`: definitions that it needs at the program's start. `when`, `unless`: only in programs
    whose code has, or has not, this. `drip`: seen when the program is fed block by block. `only`: the control that has an alarm for it."""

    def __init__(self, name, ids, pattern, change, at="line", offset=0, head="", when="", unless="", drip=False, only=""):
        self.name, self.ids, self.at, self.offset, self.head, self.drip, self.only = name, set(ids.split()), at, offset, head, drip, only
        self.pattern, self.change = re.compile(pattern), change
        self.when, self.unless = re.compile(when), re.compile(unless) if unless else None

    def suits(self, code):
        return bool(self.when.search(code)) and not (self.unless and self.unless.search(code))


def before_a_move(name, ids, lines, offset=0, **more):
    """The lines are put in before a straight move; the fault stands in line `offset` of them."""
    return Fault(name, ids, r"^(?=\s*(?:N\d+)?\s*G0?[01](?![\d.])\s*[A-Z])", replace("\n".join(lines) + "\n"), offset=offset, **more)


def at_head(name, ids, lines, offset=0, **more):
    """The lines become the program's first."""
    return Fault(name, ids, "", replace("\n".join(lines) + "\n"), at="head", offset=offset, **more)


def replace(text):
    return lambda match: text


# What only a mill, or only a program that is not called, reports.
LATHE = r"G50\s*S|G9[67]\s*S|G28\s*U|(?<![A-Z])[UW][-\d.#]"
CALLED = r"M99|G65|G66|M98"
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
    Fault("axis word twice", "duplicate-address", r"(?<=[ \d])([XYZ])[-+]?\d+\.\d*(?=\s*$)", lambda m: f"{m[0]} {m[1]}1.5", when=r"^\s*(?:N\d+)?\s*G0?1\s"),
    Fault("decimal point is missing", "missing-decimal-point", r"(?<=[XYZ])([-+]?[1-9]\d*)\.(?![\d])", lambda m: m[1]),
    Fault("unit is not stated", "unit-not-stated", r"G2[01](?![\d.])", replace(""), "only", unless=r"G65|G66|M98"),
    Fault("plane is not stated", "plane-not-stated", r"G1[789](?![\d.])", replace(""), "only", when=r"G0?[23]\s*[XYIJR]"),
    before_a_move("two codes of a group", "codes-of-one-group", ["G00 G01 X1. F100."]),
    before_a_move("corner in both forms", "addresses-exclude", ["G01 X5. ,R1. ,C1. F100."]),
    before_a_move("brackets too deep", "bracket-nesting-too-deep", ["#100=[[[[[[#101]]]]]]"]),
    before_a_move("reference in polar mode", "code-not-in-mode", ["G12.1", "G28 U0.", "G13.1"], 1, when=r"G50\s*S|G9[67]\s*S"),
    before_a_move("compensation begins on an arc", "comp-started-by-arc", ["G40", "G41 G02 X10. Y0. R5. D1 F100.", "G40"], 1),
    before_a_move("compensation without a number", "comp-without-number", ["G40", "G01 G41 X5. Y0. F100.", "G40"], 1, when=r"Y\s*[-\d.#\[]", unless=LATHE + "|" + CALLED + r"|D\s*[\d#\[]"),
    before_a_move("comparison together with AND", "comparison-with-logic", ["IF[#101EQ1AND#102EQ2]THEN#100=1"]),
    before_a_move("corner on a rapid", "corner-without-move", ["G00 X5. ,C1."]),
    before_a_move("hole under compensation", "cycle-in-comp", ["G40 G80", "G01 G41 D1 X5. Y0. F100.", "G81 X9. Y9. Z-5. R1.", "G80", "G40"], 2, when=r"Y\s*[-\d.#\[]", unless=LATHE),
    before_a_move("work offset that is not there", "data-setting-invalid", ["G10 L2 P7 X0."]),
    before_a_move("tool with a point", "decimal-point-not-allowed", ["T1."]),
    before_a_move("loop without an exit", "endless-loop loop-number-invalid nesting-too-deep", ["DO1", "#100=1", "END1"]),
    before_a_move("jump into a loop", "jump-into-loop", ["GOTO98765", "WHILE[#100LT5]DO3", "N98765#100=#100+1", "END3"]),
    before_a_move("block number twice", "label-defined-twice", ["IF[#100EQ1]GOTO98765", "N98765", "N98765"], 2),
    before_a_move("= is missing", "missing-equals syntax-error", ["#100 5."]),
    before_a_move("nothing before =", "missing-target syntax-error", ["=5."]),
    before_a_move("end of a modal call", "modal-call-not-open", ["G67"], unless=CALLED),
    before_a_move("name of a variable too long", "name-too-long", ["SETVN 101[CLEARANCE]"]),
    before_a_move("no name of a variable", "syntax-error", ["SETVN 101[A-B]"]),
    before_a_move("comment in a comment", "nested-comment", ["(OUTER (INNER) REST)"]),
    before_a_move("inverse time without F", "no-feed", ["G93", "G01 X5. F2.", "G01 Y5.", "G94"], 2, when=r"Y\s*[-\d.#\[]", unless=LATHE + "|" + CALLED),
    before_a_move("block number 0", "number-zero", ["N0 G90"]),
    before_a_move("pecks without Q", "peck-without-depth", ["G80", "G83 X2. Y1. Z-5. R1. F100.", "G80"], 1, when=r"Y\s*[-\d.#\[]", unless=LATHE, only="fanuc"),
    before_a_move("plane changed in compensation", "plane-changed-in-comp", ["G40 G17", "G41 G01 X10. D1 F100.", "G19", "G40 X0.", "G17"], 2),
    before_a_move("plane changed in a rotation", "plane-changed-in-rotation", ["G69 G17", "G68 X0. Y0. R30.", "G19", "G69", "G17"], 2, when=r"Y\s*[-\d.#\[]", unless=LATHE),
    before_a_move("reference in a cycle", "reference-in-cycle", ["G40 G80", "G81 X1. Z-1. R1. F100.", "G28 Z5.", "G80"], 2, when=r"Y\s*[-\d.#\[]", unless=LATHE),
    before_a_move("skip move in compensation", "skip-in-comp", ["G40", "G01 G41 D1 X5. Y0. F100.", "G31 X9. F100.", "G40 X0."], 2),
    before_a_move("tap without a speed", "tap-without-speed", ["G80", "G84 X1. Y1. Z-5. R1. F100.", "G80"], 1, when=r"Y\s*[-\d.#\[]", unless=LATHE + "|" + CALLED + r"|S\s*[\d#\[]"),
    before_a_move("tape mark in a comment", "tape-mark-in-comment", ["(50% OF IT)"]),
    before_a_move("bracket without a partner", "unbalanced-bracket", ["#100=#101+3.]"]),
    before_a_move("block that is never reached", "unreachable", ["GOTO98765", "#100=1.", "N98765"], 1),
    before_a_move("offset number too high", "value-out-of-range", ["G43 H1000 Z5."], when=r"Y\s*[-\d.#\[]", unless=LATHE),
    before_a_move("computed variable that is not there", "variable-out-of-range", ["#100=#[90000+9]"]),
    before_a_move("computed variable that is read only", "variable-write-protected", ["#[5040+1]=1."]),
    before_a_move("two arguments of SIN", "wrong-argument-count syntax-error", ["#100=SIN[1,2]"]),
    before_a_move("loops that cross", "wrong-nesting end-without-begin loop-number-invalid", ["WHILE[#100LT5]DO2", "WHILE[#100LT3]DO3", "END2", "END3"], at="any"),
    before_a_move("G as an argument", "wrong-type", ["G65 P9010 A1. G5."]),
    before_a_move("IF without GOTO", "syntax-error", ["IF[#100EQ1] #101=3."]),
    before_a_move("WHILE without DO", "syntax-error", ["WHILE[#100LT5]"]),
    before_a_move("two # in a row", "syntax-error", ["#100=##101"]),
    before_a_move("two calls in a block", "statement-not-alone", ["M98 P100 M98 P200"]),
    before_a_move("eleven groups of I J K", "wrong-argument-count", ["G65 P9010" + " I1. J1. K1." * 11]),
    before_a_move("file name too long", "name-too-long", ["M98 <ABCDEFGHIJKLMNOPQRSTUVWXYZABCDEFG>"]),
    before_a_move("character that is not read", "invalid-character", ["G00 X1. ~"]),
    before_a_move("shape of a cycle is missing", "cycle-shape-missing", ["G40", "G71 U1. R0.5", "G71 P9750 Q9760 U0.2 W0.1 F0.2"], 2, when=r"G50\s*S|G96\s*S"),
    before_a_move("arc in another plane", "axis-not-in-plane", ["G17 G00 X0. Y0. Z0.", "G02 X10. Z-10. I0. K-10. F100.", "G01 X0."], 1, when=r"Y\s*[-\d.#\[]", unless=LATHE),
    before_a_move("skip move without F", "no-feed", ["G40 G80 G94", "G31 X10. F0"], 1, unless=LATHE),
    before_a_move("two macro calls in a block", "statement-not-alone", ["G65 P100 A1. G65 P200"]),
    before_a_move("name that begins with a digit", "syntax-error", ["SETVN 101[1ABC]"]),
    before_a_move("name without a number", "syntax-error", ["SETVN [ABC]"]),
    before_a_move("one argument of POW", "wrong-argument-count syntax-error", ["#100=POW[2]"], only="fanuc"),
    before_a_move("measuring without an axis", "measuring-invalid", ["G43 H01 Z100.", "G37 R20. F100."], 1, when=r"Y\s*[-\d.#\[]", unless=LATHE, only="fanuc"),
    before_a_move("bytes that are not made", "not-interpreted", ["POPEN", "BPRNT[A*#100[3]]", "PCLOS"], 1, unless="BPRNT"),
    before_a_move("end of data that were not begun", "data-setting-not-open", ["G11"], unless=r"G10|M99|M98|G65|G66", only="mazak"),
    before_a_move("loop while fed", "not-in-drip-mode", ["WHILE[#100LT5]DO3", "#100=#100+1", "END3"], drip=True),
    before_a_move("jump while fed", "not-in-drip-mode", ["IF[#100EQ1]GOTO98765", "N98765"], drip=True),
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
    Fault("unit is not stated", "unit-not-stated", r"(?<![A-Z])G7[01]0?(?!\d)", replace(""), "only"),
    Fault("plane is not stated", "plane-not-stated", r"(?<![A-Z])G1[789](?!\d)", replace(""), "only", when=r"(?<![A-Z])G0?[23]\s"),
    Fault("parameter twice", "parameter-defined-twice name-defined-twice", r"(PROC\s+\w+\s*\(\s*(?:REAL|INT)\s+(\w+))", lambda m: f"{m[1]}, REAL {m[2]}", "any"),
    before_a_move("six M in a block", "address-too-often", ["M10 M11 M12 M13 M14 M15"]),
    before_a_move("corner in both forms", "addresses-exclude", ["G1 X10 CHF=2 RND=3 F100"]),
    before_a_move("no passes", "argument-out-of-domain", ["LABX98:", "REPEAT LABX98 P=0"], 1),
    before_a_move("array without an index", "array-element-missing", ["ARRX98=5"], head="DEF REAL ARRX98[3]"),
    before_a_move("block too long", "block-too-long", ["R1=1;" + "x" * 520]),
    before_a_move("two codes that want a block", "statement-not-alone code-with-function", ["G4 TRANS X10"]),
    before_a_move("compensation begins on an arc", "comp-started-by-arc comp-without-tool", ["G40", "G41 G2 X10 Y0 I5 J0 F100", "G40"], 1),
    before_a_move("compensation ends on an arc", "comp-started-by-arc", ["T1 D1", "G40", "G41 G1 X10 Y0 F100", "G40 G3 X0 Y0 I-5 J0"], 3),
    before_a_move("compensation with D0", "comp-without-tool", ["D0", "G1 G41 X10 F100", "G40"], 1),
    before_a_move("comparison together with AND", "comparison-with-logic", ["IF R1==10 AND R2==20 GOTOF LABX98", "LABX98:"]),
    before_a_move("definition after a block", "definition-not-at-start", ["R1=1", "DEF REAL DEFX98=1"], 1),
    before_a_move("axis word twice", "duplicate-address", ["G0 X1 X2"]),
    before_a_move("loop without an exit", "endless-loop", ["LOOP", "R1=R1+1", "ENDLOOP"]),
    before_a_move("character that is not read", "invalid-character", ["G0 X1 # Y2"]),
    before_a_move("jump into a loop", "jump-into-loop", ["GOTOF LABX98", "WHILE R1<3", "LABX98: R1=R1+1", "ENDWHILE"]),
    before_a_move("section without an end", "jump-target-missing", ["LABX98:", "R1=1", "REPEAT LABX98 LABX99 P=2"], 2),
    before_a_move("binary number with a 2", "malformed-number", ["R1='B1012'"]),
    before_a_move("hexadecimal number too long", "malformed-number", ["R1='H123456789'"]),
    before_a_move("nothing before =", "missing-target syntax-error", ["=5"]),
    before_a_move("structures too deep", "nesting-too-deep", ["IF R1==1"] * 17 + ["R2=1"] + ["ENDIF"] * 17, at="any"),
    before_a_move("feed 0", "no-feed", ["G1 X1 F0"]),
    before_a_move("frames and numbers chained", "operators-do-not-chain", ["FRX98=CTRANS(X,10):CROT(Z,45)+1"], head="DEF FRAME FRX98"),
    before_a_move("plane changed in compensation", "plane-changed-in-comp", ["T1 D1", "G40 G17", "G41 G1 X10 F100", "G19", "G40 G1 X30", "G17"], 3),
    before_a_move("skip level 10", "skip-level-invalid", ["/10 R1=1"]),
    before_a_move("IF together with a statement", "statement-not-alone", ["IF R1==1 R2=5", "ENDIF"]),
    before_a_move("dwell together with a move", "statement-not-alone", ["G4 F2 X10"]),
    before_a_move("frame together with a code", "statement-not-alone", ["G0 TRANS X10"]),
    before_a_move("message too long", "string-too-long", ['MSG("' + "x" * 210 + '")']),
    before_a_move("= as a comparison", "syntax-error", ["IF R1=5 GOTOF LABX98", "LABX98:"]),
    before_a_move("address that is not there", "unknown-address", ["G0 X1 Q5"]),
    before_a_move("tool number too high", "value-out-of-range", ["T40000"]),
    before_a_move("alarm that is not the user's", "value-out-of-range", ["SETAL(70001)"]),
    before_a_move("one argument of ATAN2", "wrong-argument-count", ["R1=ATAN2(1)"]),
    before_a_move("text as a number", "wrong-type", ['DEFX98="five"'], head="DEF REAL DEFX98"),
    before_a_move("number as an axis", "wrong-type", ["G1 AX[1.5]=10"]),
    before_a_move("system variable written", "variable-write-protected", ["$P_TOOLNO=5"]),
    before_a_move("block that is never reached", "unreachable", ["GOTOF LABX98", "G0 X1", "LABX98:"], 1),
    before_a_move("structures that cross", "wrong-nesting", ["WHILE R1<3", "IF R1==2", "ENDWHILE", "ENDIF"], at="any"),
    before_a_move("bracket without a partner", "unbalanced-bracket", ["R1=(1+2))"]),
    at_head("name defined twice", "name-defined-twice", ["DEF REAL DEFX98=1", "DEF INT DEFX98=2"], 1),
    at_head("name of the control defined", "name-defined-twice", ["DEF REAL SIN"]),
    at_head("name too long", "name-too-long", ["DEF REAL A23456789_123456789_123456789_12=1"]),
    at_head("frame with a value", "initial-value-not-allowed", ["DEF FRAME FRX98=CTRANS(X,10)"]),
    at_head("text too long", "string-too-long", ['DEF STRING[4] TEXTX98="12345"']),
    at_head("four dimensions", "too-many-dimensions", ["DEF REAL ARRX98[2,2,2,2]"]),
    at_head("too many initial values", "too-many-initial-values", ["DEF REAL ARRX98[2,2]=SET(1,2,3,4,5)"]),
    before_a_move("macro in a macro", "syntax-error", ["OUTX98"], at="any", head="DEFINE UPX98 AS G0 Z100\nDEFINE OUTX98 AS UPX98"),
    before_a_move("rotary direction of a linear axis", "addresses-exclude", ["G1 Z=ACN(1) F100"]),
    before_a_move("M function of tool management", "code-not-in-mode", ["TML(1)"], when=r"(?<![A-Z])M(30|0?2)(?!\d)", unless="PROC"),
    before_a_move("too many blocks without a move", "code-not-in-mode comp-without-tool", ["T1 D1", "G41 G1 X10 F100", "R1=1", "R1=2", "R1=3", "R1=4", "R1=5", "G40 X0"], at="any"),
    before_a_move("offset data with D0", "comp-without-tool", ["D0", "R1=$P_AD[3]"], 1),
    before_a_move("arc words together with G1", "syntax-error", ["G1 X20 I10 F100"]),
    before_a_move("number in a G group", "value-out-of-range", ["G[14]=3"]),
    before_a_move("tool type that is not there", "value-out-of-range", ["$TC_DP1[1,1]=-5"]),
    before_a_move("tool number below 0", "variable-out-of-range", ["R1=$TC_DP3[-1,1]"]),
    before_a_move("too many parameters of a cycle", "wrong-argument-count", ["LONGHOLE(" + ",".join("1" * 40) + ")"]),
    before_a_move("parameter where none is", "wrong-argument-count", ["STOPRE(1)"]),
    before_a_move("text as a parameter", "wrong-type", ['POCKET3("5",0,2,-5,20,10)']),
    before_a_move("text as an offset", "wrong-type", ['$P_UIFR[1,X,TR]="5"']),
    before_a_move("bracket of a predefined call", "missing-bracket", ["TRAILOF(B,C"]),
    before_a_move("text among numbers", "wrong-type", ["FILLX98(DEFX98)"], head="EXTERN FILLX98(VAR REAL[10])\nDEF REAL DEFX98"),
    at_head("procedure declared twice", "name-defined-twice", ["EXTERN DRILLX98(INT)", "EXTERN DRILLX98(REAL,REAL)"], 1),
    at_head("macro too long", "syntax-error", ["DEFINE LONGX98 AS " + " ".join(f"R{n}=1.0" for n in range(10, 50))]),
    before_a_move("loop while fed", "not-in-drip-mode", ["FOR R1=1 TO 5", "R2=R1", "ENDFOR"], drip=True),
    before_a_move("jump while fed", "not-in-drip-mode", ["LABX98: R1=R1+1", "IF R1<9 GOTOB LABX98"], 1, drip=True),
    Fault("string without end", "unterminated-string", r'"\s*(?=\)\s*$)', replace("")),
    Fault("program end is missing", "missing-program-end", r"(?<!\w)(M30|M17|RET|M2|M02)(?![\w(])", replace(""), "only"),
]


def faults_of(dialect):
    faults = COMMON + (SIEMENS if dialect.startswith("sinumerik") else MACRO)
    return [fault for fault in faults if fault.only in ("", dialect)]


def check(binary, dialect, paths, options=()):
    """Diagnostics by file."""
    out = {}
    for begin in range(0, len(paths), 40):
        part = [str(path) for path in paths[begin: begin + 40]]
        said = subprocess.run([binary, "check", "--json", "--dialect", dialect, *options, *part], capture_output=True, timeout=300)
        for file in json.loads(said.stdout)["files"]:
            out[file["file"]] = file["diagnostics"]
    return out


def line_of(text, offset):
    return text[:offset].count("\n") + 1


def head_of(text, dialect):
    """Offset of the first line that may define something, None where the text is not one program."""
    if not dialect.startswith("sinumerik") or text.count("%_N_") > 1:
        return None
    begin = 0
    for line in text.split("\n"):
        code = code_of(line, dialect).strip().upper()
        if code and not code.startswith("%") and not re.match(r"(N\d+\s*)?PROC\b", code):
            return begin
        begin += len(line) + 1
    return None


def places(text, fault, dialect):
    """(begin, end, new text) of every place that the fault can have."""
    if not fault.suits("\n".join(code_of(line, dialect) for line in text.split("\n"))):
        return []
    head = head_of(text, dialect)
    if (fault.head or fault.at == "head") and head is None:
        return []
    if fault.at == "head":
        return [(head, head, fault.change(None))]
    found = []
    begin = 0
    for line in text.split("\n"):
        code = code_of(line.rstrip("\r"), dialect)
        for match in fault.pattern.finditer(code):
            new = fault.change(match)
            if new != match[0] and (not fault.head or begin > head):
                found.append((begin + match.start(), begin + match.end(), new))
        begin += len(line) + 1
    return found


def mutated(text, fault, dialect, chance):
    """The text with the fault at a place of chance and the line at which it stands; nothing where it has no place."""
    choice = places(text, fault, dialect)
    if not choice or (fault.at == "only" and len(choice) > 1):
        return None
    begin, end, new = chance.choice(choice)
    line = line_of(text, begin) + fault.offset
    text = text[:begin].encode("latin-1") + new.encode() + text[end:].encode("latin-1")
    if not fault.head:
        return text, line
    head = head_of(text.decode("latin-1"), dialect)
    return text[:head] + fault.head.encode() + b"\n" + text[head:], line + fault.head.count("\n") + 1


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
                made = mutated(text, fault, given.dialect, chance)
                if made is None:
                    continue
                mutant = pathlib.Path(name) / f"{index}_{number}.nc"
                mutant.write_bytes(made[0])
                changed[str(mutant)] = (fault, path, made[1], before)
        after = check(binary, given.dialect, [pathlib.Path(path) for path, (fault, *_) in changed.items() if not fault.drip])
        after |= check(binary, given.dialect, [pathlib.Path(path) for path, (fault, *_) in changed.items() if fault.drip], ["--drip"])
        for mutant, (fault, path, line, before) in changed.items():
            tried[fault.name] += 1
            hits = [d for d in after[mutant] if d["id"] in fault.ids and (d["id"], d["line"]) not in before]
            if any(fault.at not in ("line", "head") or d["line"] == line for d in hits):
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
