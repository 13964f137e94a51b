"""The shipped families as macros, made faster by the command: the text is one that the control takes, and its moves are those of the text before."""

import json
import math
import pathlib
import subprocess
import sys
import tempfile

BINARY = sys.argv[1]
ROOT = pathlib.Path(__file__).resolve().parents[2]
LATHES = ["sinumerik-810d-lathe", "fanuc-0i-lathe", "mazak-qtn"]
MILLS = ["sinumerik-840d-mill", "fanuc-0i-mill", "haas-vf2", "mitsubishi-m80-cvm800"]
FAMILIES = {"hyperbolic-roll": LATHES, "stepped-shaft": LATHES, "seal-ring": LATHES[:1], "round-pocket": MILLS, "bolt-circle": MILLS, "slot": MILLS,
            "thread-mill": MILLS, "rectangular-pocket": MILLS, "nurbs-profile": MILLS}


def run(*arguments):
    return subprocess.run([BINARY, *map(str, arguments)], capture_output=True, text=True)


def moves(path, machine):
    """The trace without lines and blocks."""
    answer = run("run", path, "--machine", machine)
    if answer.returncode != 0:
        raise AssertionError(f"{path} on {machine}: {answer.stderr}")
    return [line.split(None, 1)[-1] for line in answer.stdout.splitlines() if line.strip()]


def one(folder, family, machine):
    plain, faster = folder / "plain.nc", folder / "faster.nc"
    for path, more in ((plain, []), (faster, ["--optimize"])):
        answer = run("render", family, "--machine", machine, "--mode", "macro", *more, "--output", path)
        if answer.returncode != 0:
            raise AssertionError(f"{family} on {machine}: {answer.stderr}")
    if "left as it was" in answer.stderr or "not verified" in answer.stderr:
        raise AssertionError(f"{family} on {machine}: {answer.stderr}")
    figures = answer.stderr.split("moves: ")[1]
    before, after = float(figures.split()[0]), float(figures.split("before, ")[1].split()[0])
    if after > before:
        raise AssertionError(f"{family} on {machine}: {answer.stderr}")
    if moves(plain, machine) != moves(faster, machine):
        raise AssertionError(f"{family} on {machine}: other moves")
    verdicts = [json.loads(run("check", path, "--machine", machine, "--json").stdout)["files"][0]["verdict"] for path in (plain, faster)]
    if verdicts[0] != verdicts[1]:
        raise AssertionError(f"{family} on {machine}: {verdicts}")
    print(f"{family} on {machine}: {before} ms before, {after} ms after, verdict {verdicts[1]}")


def subprograms(folder):
    """A called program in a file next to the caller's: its blocks in the text, and a call that stays, by name."""
    program = folder / "row.mpf"
    program.write_text("G0 X0\nR1=0\nWHILE R1<5\nPOINT ; one\nMISSING\nR1=R1+1\nENDWHILE\nM30\n")
    (folder / "POINT.SPF").write_text("PROC POINT\nG1 X=R1 F100 ; cut\nRET\n")
    answer = run("optimize", program, "--machine", "sinumerik-840d-mill", "--own", "R2")
    if "; start of POINT ; one\nG1 X=R1 F100 ; cut\n; end of POINT\n" not in answer.stdout or "\nMISSING\n" not in answer.stdout:
        raise AssertionError(f"{answer}")
    if ":4: inline: the block of POINT takes the place of the call" not in answer.stderr or ":5: inline: MISSING stays a call: its text is not at hand" not in answer.stderr:
        raise AssertionError(f"{answer}")
    answer = run("optimize", program, "--machine", "sinumerik-840d-mill", "--without", "inline")
    if answer.stdout != program.read_text() or "inline" in answer.stderr:
        raise AssertionError(f"{answer}")


def the_command(folder):
    """Text, report and --json of `dripfeed optimize`, and what it refuses."""
    program = folder / "ring.mpf"
    program.write_text("DEF REAL DEPTH\nDEPTH=3\nG0 X0\nR1=0\nN10 R2=SIN(DEPTH)*COS(DEPTH)\nG1 X=R2+R1 F100\nR1=R1+1\nIF R1<5 GOTOB N10\nM30\n")
    answer = run("optimize", program, "--machine", "sinumerik-840d-mill", "--free", "R200-R209", "--own", "R1-R9", "--json")
    found = json.loads(answer.stdout)
    rules = {change["rule"] for change in found["changes"]}
    if not {"numbered", "loops", "invariants"} <= rules or found["after"]["total_ms"] >= found["before"]["total_ms"] or found["left_because"] is not None:
        raise AssertionError(f"{found}")
    saved = sum(one["saved"]["ms"] for one in found["passes"])
    if abs(saved - found["saved"]["ms"]) > 1e-9 or abs(saved - found["before"]["total_ms"] + found["after"]["total_ms"]) > 1e-9:
        raise AssertionError(f"the rules save {saved}: {found['passes']}, {found['saved']}")
    if any(not one["saved"]["least_ms"] <= one["saved"]["ms"] <= one["saved"]["most_ms"] for one in found["passes"]):
        raise AssertionError(f"{found['passes']}")
    if answer.stderr:
        raise AssertionError(f"--json says more: {answer.stderr}")
    text = run("optimize", program, "--machine", "sinumerik-840d-mill", "--free", "R200-R209", "--own", "R1-R9")
    if text.stdout != found["text"] or "cost model" not in text.stderr or "invariants saves " not in text.stderr or "all rules save " not in text.stderr:
        raise AssertionError(f"{text}")
    subprograms(folder)
    for arguments, words in ((["--free", "R200-#9"], "is not a range of variables"), (["--with", "magic"], 'there is no rule "magic"'),
                             (["--with", "lines"], "need a tolerance"), (["--tolerance", "0.01"], "a tolerance is for the rules table, lines and arcs")):
        refused = run("optimize", program, *arguments)
        if refused.returncode != 2 or words not in refused.stderr or refused.stdout:
            raise AssertionError(f"{arguments}: {refused}")


def merged(folder):
    """Plain blocks of a circle as chords: fewer of them, within the tolerance that is proved, and the rest byte for byte."""
    program = folder / "chords.nc"
    chords = [f"X{40 * math.cos(i * math.pi / 500):.4f} Y{40 * math.sin(i * math.pi / 500):.4f}" for i in range(1, 1001)]
    head = ["%", "O0007", "G21 G90 G94 G17 G40", "T1 M6", "G54", "G0 X40. Y0.", "G43 H1 Z5.", "S1000 M3", "G1 Z-1. F100."]
    program.write_text("\n".join([*head, *chords, "G0 Z50. (OUT)", "M30", "%", ""]))
    found = json.loads(run("optimize", program, "--machine", "fanuc-0i-mill", "--with", "lines", "--tolerance", "0.01", "--json").stdout)
    lines = found["text"].splitlines()
    kept = [line for line in lines if line in set(chords)]
    if not 0 < found["proved_max_mm"] <= 0.01 or len(kept) > 150 or lines[:9] != head or lines[-3:] != ["G0 Z50. (OUT)", "M30", "%"] or found["not_merged"]:
        raise AssertionError(f"{len(kept)} chords, {found['proved_max_mm']} mm, {lines[:12]}, {found['not_merged']}")
    if [one["rule"] for one in found["passes"]] != ["lines"] or found["after"]["moves"] >= found["before"]["moves"] or len(found["origins"]) != len(lines):
        raise AssertionError(f"{found['passes']}")
    print(f"1000 chords of a circle become {len(kept)}, {found['proved_max_mm']} mm off at most")


with tempfile.TemporaryDirectory() as name:
    merged(pathlib.Path(name))
    the_command(pathlib.Path(name))
    for family, machines in FAMILIES.items():
        for machine in machines:
            one(pathlib.Path(name), family, machine)
