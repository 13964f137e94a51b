"""What the commands show of diagnostics: help once a kind, the fix, `check --fix`, `check --sarif` and `explain`."""

import json
import stat
import subprocess

from client import binary, expect, in_folder

TWICE = "%\nO1\nG21 G90 G17 G94 G40\nG0 X#100+5. Y#101+5.\nМ5\nM30\n%\n"


def run(folder, *arguments, code):
    done = subprocess.run([str(binary()), *arguments], capture_output=True, text=True, timeout=30, cwd=folder)
    expect(done.returncode == code, f"{arguments}: {done.returncode}, {done.stderr}")
    return done


def help_and_fix(folder):
    (folder / "a.nc").write_text(TWICE)
    said = run(folder, "check", "a.nc", "--dialect", "fanuc", code=1).stderr
    expect(said.count("error[expression-without-brackets]") == 2, said)
    expect(said.count("  help: This control calculates inside brackets") == 1, said)
    expect("  fix: write `[#100+5.]` in the place of `#100+5.`\n" in said and "  fix: write `M` in the place of `М`\n" in said, said)
    expect((folder / "a.nc").read_text() == TWICE, "check alone writes nothing")


def fixed(folder):
    file = folder / "b.nc"
    file.write_text(TWICE)
    file.chmod(0o640)
    said = run(folder, "check", "--fix", "b.nc", "--dialect", "fanuc", code=0).stderr
    expect(file.read_text() == TWICE.replace("X#100+5.", "X[#100+5.]").replace("Y#101+5.", "Y[#101+5.]").replace("М5", "M5"), file.read_text())
    expect(stat.S_IMODE(file.stat().st_mode) == 0o640, "the permissions")
    expect(said.count("fixed[") == 3 and "error[" not in said, said)
    again = run(folder, "check", "--fix", "b.nc", "--dialect", "fanuc", code=0).stderr
    expect("fixed[" not in again, again)
    expect(list(folder.glob("*.fixed")) == [], "no file is left")
    run(folder, "check", "--fix", "-", "--dialect", "fanuc", code=2)
    (folder / "b.nc.fixed").write_text("mine")
    file.write_text(TWICE)
    run(folder, "check", "--fix", "b.nc", "--dialect", "fanuc", code=2)
    expect(file.read_text() == TWICE and (folder / "b.nc.fixed").read_text() == "mine", "another file of that name stays")


def sarif(folder):
    (folder / "c d.nc").write_text(TWICE)
    (folder / "e.nc").write_text("%\nO1\nG21 G90 G17 G94 G40\nM30\n%\n")
    log = json.loads(run(folder, "check", "--sarif", "c d.nc", "e.nc", "--dialect", "fanuc", code=1).stdout)
    expect(log["version"] == "2.1.0" and len(log["runs"]) == 1, f"{log}")
    (one,) = log["runs"]
    rules = one["tool"]["driver"]["rules"]
    for result in one["results"]:
        expect(rules[result["ruleIndex"]]["id"] == result["ruleId"] and result["message"]["text"], f"{result}")
    first = one["results"][0]
    place = first["locations"][0]["physicalLocation"]
    expect(place["artifactLocation"]["uri"] == "c%20d.nc", f"{place}")
    expect(place["region"] == {"startLine": 4, "startColumn": 4, "endLine": 4, "endColumn": 12}, f"{place}")
    expect(first["properties"]["alarm"] == "PS0114" and first["level"] == "error", f"{first}")
    (replacement,) = first["fixes"][0]["artifactChanges"][0]["replacements"]
    expect(replacement["insertedContent"]["text"] == "[#100+5.]" and replacement["deletedRegion"]["startColumn"] == 5, f"{replacement}")
    notes = [note["message"]["text"] for note in one["invocations"][0]["toolExecutionNotifications"]]
    expect("verdict fail" in notes and "verdict pass" in notes and any(note.startswith("not checked: ") for note in notes), f"{notes}")
    run(folder, "check", "--sarif", "--json", "e.nc", code=2)


def explained(folder):
    text = run(folder, "explain", "missing-end", code=0).stdout
    for wanted in ("error[missing-end]", "Close every loop", "PS0124", "12640", "example (fanuc)", "without it"):
        expect(wanted in text, f"{wanted}: {text}")
    near = run(folder, "explain", "mising-end", code=2)
    expect("missing-end" in near.stderr and near.stdout == "", near.stderr)
    expect("did you mean" not in run(folder, "explain", "elephants-and-whales", code=2).stderr, "nothing is near")
    names = run(folder, "explain", "--all", code=0).stdout.splitlines()
    page = run(folder, "explain", "--all", "--markdown", code=0).stdout
    expect(len(names) > 100 and page.count("\n## ") == len(names), f"{len(names)} names, {page.count(chr(10) + '## ')} sections")
    run(folder, "explain", code=2)


if __name__ == "__main__":
    for test in (help_and_fix, fixed, sarif, explained):
        in_folder(test)
