#!/usr/bin/env python3
"""How many real programs run to their end: `dripfeed run` on each file of a folder of repositories, called programs looked for in the file's own repository.

  tests/bench/run_real.py FOLDER --dialect D [--machine FILE] [--binary build/release/dripfeed] [--skip TEXT] [--state F] [--list F] [--jobs 2]

FOLDER holds one folder a repository. A folder NAME.d holds the programs cut from one memory dump, as NUMBER_O1234…: they call each other by the O number.
Counted apart: programs that call what is not in their repository (they cannot run here), those that stop by an alarm of their own (a macro without its
arguments, mostly), which is how they end on the control, too, those that go round for ever as they are written ("endless": until a person resets the
control), and those that are not read (errors of the text). --state gives each run the values of a state file (a probing macro that asks for the
active length offset needs one). --list writes one line a file that did not end: how, which, and what was missing.
"""

import argparse
import collections
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
TIMEOUT_S = 120
NOT_PROGRAMS = {".md", ".txt", ".json"}


def call_folders(repository, links):
    """Where calls of the repository's files are looked for."""
    folders = []
    for folder in sorted({path.parent for path in repository.rglob("*") if path.is_file()}):
        if folder.name.endswith(".d"):
            linked = links / str(len(list(links.iterdir())))
            linked.mkdir()
            for path in sorted(folder.iterdir()):
                name = re.match(r"\d+_(O\d+)", path.name)
                if name and not (linked / name[1]).exists():
                    os.symlink(path, linked / name[1])
            folders.append((folder, linked))
        folders.append((folder, folder))
    return folders


def kind_of(report):
    text = (report["alarm"] or {}).get("text", "")
    if report["ended"] == "limit" and "has no exit" in text:
        return "endless"
    if report["ended"] != "alarm":
        return str(report["ended"])
    if "its own alarm" in text:
        return "own alarm"
    return "call not found" if "is called and was not found" in text else "alarm"


def missing(report):
    """The alarm, and the inputs that the run lacked."""
    inputs = [one["name"] for one in report["not_interpreted"] if one["input"]]
    return json.dumps(report["alarm"]) + (" not given: " + " ".join(inputs) if inputs else "")


def run(binary, control, state, path, folders):
    # Files of an older state of the repository call those of that state.
    old = "@history" in path.parts
    mine = [f for source, f in folders if source == path.parent]
    others = [f for source, f in folders if source != path.parent and ("@history" in source.parts) == old]
    command = [binary, "run", str(path), *control, "--trace", "none", "--json", "--limit", "loops=1000000"]
    if state:
        command += ["--state", str(state)]
    for folder in (mine + others)[:300]:
        command += ["--path", str(folder)]
    try:
        done = subprocess.run(command, capture_output=True, timeout=TIMEOUT_S)
        report = json.loads(done.stdout)
    except subprocess.TimeoutExpired:
        return "no end in time", ""
    except ValueError:
        return "not read", done.stderr.decode(errors="replace")[-300:].replace("\n", " | ")
    return kind_of(report), missing(report)


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("folder", type=pathlib.Path)
    options.add_argument("--dialect", required=True)
    options.add_argument("--machine", type=pathlib.Path, help="profile, where the programs' machine is known to differ from its dialect's usual one")
    options.add_argument("--binary", default=str(ROOT / "build/release/dripfeed"))
    options.add_argument("--skip", help="leave out repositories whose name contains this")
    options.add_argument("--state", type=pathlib.Path)
    options.add_argument("--list", type=pathlib.Path)
    options.add_argument("--jobs", type=int, default=2)
    given = options.parse_args()
    control = ["--machine", str(given.machine)] if given.machine else ["--dialect", given.dialect]
    work = []
    with tempfile.TemporaryDirectory() as links:
        for repository in sorted(given.folder.iterdir()):
            if not repository.is_dir() or (given.skip and given.skip in repository.name):
                continue
            folders = call_folders(repository, pathlib.Path(links))
            work += [(path, folders) for path in sorted(repository.rglob("*")) if path.is_file() and path.suffix.lower() not in NOT_PROGRAMS]
        with concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
            results = list(pool.map(lambda one: (one[0], *run(given.binary, control, given.state, *one)), work))
    counts = collections.Counter(kind for _, kind, _ in results)
    if given.list:
        given.list.write_text("".join(f"{kind}\t{path.relative_to(given.folder)}\t{why}\n" for path, kind, why in results if kind not in ("end", "text_end")))
    able = len(results) - counts["call not found"]
    ended = sum(n for kind, n in counts.items() if kind in ("end", "text_end"))
    print(f"{given.dialect}: {len(results)} files, " + ", ".join(f"{n} {kind}" for kind, n in counts.most_common()))
    print(f"of {able} whose calls are found {ended} run to their end ({100 * ended / able:.1f} %), "
          f"{ended + counts['own alarm']} with those that end by an alarm of their own ({100 * (ended + counts['own alarm']) / able:.1f} %)")
    finite = able - counts["not read"] - counts["endless"]
    print(f"of {finite} that are read and do not go round for ever as written {ended} run to their end ({100 * ended / finite:.1f} %)")


if __name__ == "__main__":
    sys.exit(main())
