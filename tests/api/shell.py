"""What bash completes and what the manual page states, against the commands' own help."""

import re
import shutil
import subprocess
import sys

from client import binary, expect, in_folder


def run(*arguments):
    done = subprocess.run([str(binary()), *arguments], capture_output=True, text=True, timeout=30)
    expect(done.returncode == 0, f"{arguments}: {done.stderr}")
    return done.stdout


def commands_below(path=()):
    """Every command that the help names, from the help alone."""
    said = run(*path, "--help")
    if "Subcommands:" not in said:
        return [path]
    names = re.findall(r"^  (\w+)  ", said.split("Subcommands:")[1], re.M)
    expect(names, f"{path}: no command in {said}")
    return [path] + [one for name in names for one in commands_below((*path, name))]


def options_of(path):
    text = run(*path, "--help").split("Options:")[1].split("Subcommands:")[0]
    return set(re.findall(r"^  (?:-\w,)?(--[\w-]+)", text, re.M))


def complete(script, *words):
    """What bash proposes for the last word."""
    ask = 'source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _dripfeed; printf "%s\\n" "${COMPREPLY[@]}"'
    done = subprocess.run(["bash", "-euc", ask, "bash", str(script), "dripfeed", *words], capture_output=True, text=True, timeout=30, cwd=script.parent)
    expect(done.returncode == 0 and not done.stderr, f"{words}: {done.stderr}")
    return set(done.stdout.split())


def completion(folder):
    script = folder / "dripfeed.bash"
    script.write_text(run("completion", "bash"))
    (folder / "part.nc").write_text("M30")
    everything = commands_below()
    expect(len(everything) > 20 and ("ledger", "verify") in everything, f"{everything}")
    for path in everything:
        below = {one[len(path)] for one in everything if len(one) == len(path) + 1 and one[:len(path)] == path}
        if below:
            expect(complete(script, *path, "") == below, f"{path}: {complete(script, *path, '')} is not {below}")
        expect(complete(script, *path, "--") == options_of(path), f"{path}: {complete(script, *path, '--') ^ options_of(path)}")
    expect(complete(script, "ser") == {"serve"} and complete(script, "token", "re") == {"revoke"}, "a begun word")
    expect(complete(script, "check", "pa") == {"part.nc"}, "a file")
    expect(complete(script, "serve", "--insecure", "--conf") == {"--config", "--config-schema"}, "after a flag")
    expect(complete(script, "serve", "--config", "pa") == {"part.nc"}, "the value of an option")
    expect("worker" not in complete(script, ""), "worker is for the program itself")


def manual(folder):
    page = run("man")
    plain = page.replace("\\-", "-")
    for path in commands_below():
        title = " ".join(("dripfeed", *path))
        expect(f'.SS "{title}"\n' in plain, f"{title} is not in the page")
        section = plain.split(f'.SS "{title}"\n')[1].split("\n.SS ")[0]
        for option in options_of(path):
            expect(re.search(rf'^\.B ".*{option}[ ,"]', section, re.M), f"{option} of {title} is not in the page")
    if shutil.which("groff"):
        done = subprocess.run(["groff", "-man", "-ww", "-Tutf8", "-Kutf8"], input=page, capture_output=True, text=True, timeout=60)
        expect(done.returncode == 0 and not done.stderr, f"groff: {done.stderr[:1000]}")


if __name__ == "__main__":
    for test in (completion, manual):
        in_folder(test)
