"""The shipped families as macros, made faster by the command: the text is one that the control takes, and its moves are those of the text before."""

import json
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


def the_command(folder):
    """Text, report and --json of `dripfeed optimize`, and what it refuses."""
    program = folder / "ring.mpf"
    program.write_text("DEF REAL DEPTH\nDEPTH=3\nG0 X0\nR1=0\nN10 R2=SIN(DEPTH)*COS(DEPTH)\nG1 X=R2+R1 F100\nR1=R1+1\nIF R1<5 GOTOB N10\nM30\n")
    answer = run("optimize", program, "--machine", "sinumerik-840d-mill", "--free", "R200-R209", "--own", "R1-R9", "--json")
    found = json.loads(answer.stdout)
    rules = {change["rule"] for change in found["changes"]}
    if not {"numbered", "loops", "invariants"} <= rules or found["after"]["total_ms"] >= found["before"]["total_ms"] or found["left_because"] is not None:
        raise AssertionError(f"{found}")
    if answer.stderr:
        raise AssertionError(f"--json says more: {answer.stderr}")
    text = run("optimize", program, "--machine", "sinumerik-840d-mill", "--free", "R200-R209", "--own", "R1-R9")
    if text.stdout != found["text"] or "cost model" not in text.stderr:
        raise AssertionError(f"{text}")
    for arguments, words in ((["--free", "R200-#9"], "is no range of variables"), (["--with", "magic"], 'there is no rule "magic"')):
        refused = run("optimize", program, *arguments)
        if refused.returncode != 2 or words not in refused.stderr or refused.stdout:
            raise AssertionError(f"{arguments}: {refused}")


with tempfile.TemporaryDirectory() as name:
    the_command(pathlib.Path(name))
    for family, machines in FAMILIES.items():
        for machine in machines:
            one(pathlib.Path(name), family, machine)
