"""Folders of programs into a library, and all of it out and in again: each file with what became of it, every text by its hash, while the server runs.
What is refused leaves nothing; a second import of the same changes nothing."""

import hashlib
import json
import os
import pathlib
import subprocess
import sys
import urllib.parse

from client import ROLL, Client, binary, expect, in_folder

LATIN_1 = b"%\nO0020 (B\xfcchse)\nG0 X10.\nM30\n%\n"
DUMP = b"%\nO0001 (A)\nG0 X1.\nM30\nO0002 (B)\nG0 X2.\nM30\n%\n"
AGAIN = b"%\nO0001\nG0 X1.\nM30\nO0001\nG0 X2.\nM30\nO0001\nG0 X1.\nM30\n%\n"  # one of them twice, under the name of another
PLAIN = b"%\nO0010\nG21 G90\nG0 X1.\nM30\n%\n"
SIEMENS = b"; shaft\nG71 G90\nR1=5\nDEF REAL LENGTH=10\nG0 X=R1\nM30\n"


def command(client, *arguments, data=None):
    place = ["--data", str(data)] if data else ["--data", str(client.server.data), *client.store]
    return subprocess.run([str(binary()), *map(str, arguments), *place], capture_output=True, timeout=120)


def imported(client, folder, *arguments, code=0, data=None):
    done = command(client, "import", folder, "--json", *arguments, data=data)
    expect(done.returncode == code, f"import {folder} {arguments} ended with {done.returncode}: {done.stdout.decode()} {done.stderr.decode()}")
    report = json.loads(done.stdout)
    counts = [sum(item["outcome"] == outcome for item in report["items"]) for outcome in OUTCOMES]
    expect(counts == [report[outcome] for outcome in OUTCOMES], f"the sums are others: {report}")
    return report


OUTCOMES = ("added", "revised", "same", "skipped", "failed")


def sums(report):
    return {outcome: report[outcome] for outcome in OUTCOMES if report[outcome]}


def write(folder, files):
    for name, body in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(body)


def library(client):
    """{(folder, name): (dialect, revision, tags, text)} of what is in use."""
    found = {}
    after = ""
    while after is not None:
        page = client.get(f"/programs?limit=200&shelf=all{after and '&after=' + after}")
        for item in page["items"]:
            text = client.call("GET", f"/programs/{item['id']}/text").body
            expect(hashlib.sha256(text).hexdigest() == item["sha256"], f"the text of {item['name']} is another")
            found[item["folder"], item["name"]] = (item["dialect"], item["revision"], tuple(item["tags"]), bool(item["archived"]), text)
        after = page["next"]
    return found


def a_tree(client, folder):
    tree = folder / "tree"
    write(tree, {"acme/pumps/O0010.NC": PLAIN, "acme/B20.txt": LATIN_1, "acme/shaft.mpf": SIEMENS, "dump/ALL.TXT": DUMP, "dump/AGAIN.TXT": AGAIN, "top.nc": PLAIN,
                 "acme/twice.nc": PLAIN, "acme/twice.tap": LATIN_1,
                 "acme/sheet.pdf": b"%PDF-1.4\n1 0 obj", "acme/photo.jpg": bytes(range(256)) * 40, "acme/empty.nc": b"", "acme/.hidden": PLAIN, "x" * 201: PLAIN})
    os.symlink("/etc/passwd", tree / "link.nc")
    looked = imported(client, tree, "--dry-run", code=1)
    expect(looked["only_looked"] and library(client) == {}, "a look stored something")
    report = imported(client, tree, code=1)
    rows = [{member: item[member] for member in ("file", "outcome", "name", "folder")} for item in report["items"]]
    expect(rows == [{member: item[member] for member in ("file", "outcome", "name", "folder")} for item in looked["items"]], "a look says another thing than the import")
    expect(sums(report) == {"added": 10, "same": 1, "skipped": 5, "failed": 1}, f"the report: {json.dumps(report, indent=1)}")
    why = {item["file"]: item["why"] for item in report["items"]}
    expect(why["link.nc"] == "is a link" and why["acme/.hidden"] == "is hidden" and why["acme/empty.nc"] == "is empty", f"{why}")
    expect("200" in why["x" * 201] and "not a text of a program" in why["acme/sheet.pdf"] and "not a text of a program" in why["acme/photo.jpg"], f"{why}")
    found = library(client)
    expect({place: (row[0], row[4]) for place, row in found.items()} == {
        ("acme/pumps", "O0010"): ("fanuc", PLAIN), ("acme", "B20"): ("fanuc", LATIN_1), ("acme", "shaft.mpf"): ("sinumerik-840d", SIEMENS), (None, "top"): ("fanuc", PLAIN),
        ("acme", "twice.nc"): ("fanuc", PLAIN), ("acme", "twice.tap"): ("fanuc", LATIN_1),
        ("dump/AGAIN", "O0001"): ("fanuc", b"%\nO0001\nG0 X1.\nM30\n%\n"), ("dump/AGAIN", "O0001 2"): ("fanuc", b"%\nO0001\nG0 X2.\nM30\n%\n"),
        ("dump/ALL", "O0001"): ("fanuc", b"%\nO0001 (A)\nG0 X1.\nM30\n%\n"), ("dump/ALL", "O0002"): ("fanuc", b"%\nO0002 (B)\nG0 X2.\nM30\n%\n")}, f"the library: {found}")
    again = imported(client, tree, code=1)
    expect(sums(again) == {"same": 11, "skipped": 5, "failed": 1} and library(client) == found, f"the same tree again: {sums(again)}")
    return tree


def a_tree_over_the_wire(folder, tree):
    """Each file in a request of its own: the reports together are the command's, but for what only who sees the folder knows."""
    by_command, by_request = Client(folder / "by_command").start(), Client(folder / "by_request").start()
    report = imported(by_command, tree, code=1)
    items = []
    for path in dict.fromkeys(item["file"] for item in report["items"] if item["why"] != "is a link"):
        ending = "&keep_ending=true" if path.startswith("acme/twice") else ""
        where = f"/imports?path={urllib.parse.quote(path)}{ending}"
        looked = by_request.must("POST", where + "&only_look=true", (tree / path).read_bytes(), role="programmer")
        done = by_request.must("POST", where, (tree / path).read_bytes(), role="programmer")
        expect(looked["only_looked"] and not done["only_looked"], f"{looked} {done}")
        expect([item["outcome"] for item in looked["items"]] == [item["outcome"] for item in done["items"]], f"a look states another thing: {looked} {done}")
        items += done["items"]

    def rows(items):
        no_rows = ("program", "revision", "bytes")  # ids are another store's; what the command does not read has no length there
        return [{member: value for member, value in item.items() if member not in no_rows} for item in items if item["why"] != "is a link"]
    expect(rows(items) == rows(report["items"]), f"{rows(items)}")
    expect(library(by_request) == library(by_command), "another library")
    again = by_request.must("POST", "/imports?path=top.nc&known=skip", b"%\nO10\nM30\n%\n", role="programmer")
    expect(sums(again) == {"skipped": 1} and again["items"][0]["program"], f"{again}")
    long = b"%\nO0099\n" + b"G01 X1.5 Y2.25 F100.\n" * 100_000 + b"M30\n%\n"  # a body that lies in a file
    done = by_request.must("POST", "/imports?path=long.nc", long, role="programmer")["items"][0]
    expect((done["outcome"], done["sha256"], done["bytes"]) == ("added", hashlib.sha256(long).hexdigest(), len(long)), f"{done}")
    below = by_request.must("POST", "/imports?path=a/b.nc&folder=old/works&dialect=mazak", PLAIN, role="programmer")["items"][0]
    expect((below["folder"], below["name"], below["dialect"]) == ("old/works/a", "b", "mazak"), f"{below}")
    outside = by_request.must("POST", "/imports?path=../../etc/b.nc", PLAIN, role="programmer")
    expect(outside["failed"] == 1 and "folder" in outside["items"][0]["why"], f"{outside}")
    for query, word in (("", "path"), ("path=a&known=maybe", "known"), ("path=a&dialect=cobol", "cobol"), ("path=a&folder=a//b", "folder"),
                        ("path=a&only_look=yes", "only_look"), ("path=a&keep_ending=1", "keep_ending")):
        by_request.refuse(422, "POST", f"/imports?{query}", PLAIN, role="programmer", words=[word])
    for client in (by_command, by_request):
        client.server.stop()


def what_differs(client, tree):
    changed = PLAIN.replace(b"X1.", b"X2.")
    write(tree, {"top.nc": changed, "acme/B20.txt": LATIN_1.replace(b"10.", b"11.")})
    skipped = imported(client, tree, "--known", "skip", code=1)
    expect(skipped["skipped"] == 7 and skipped["same"] == 9, f"skipped: {sums(skipped)}")
    client.post(f"/programs/{program_of(client, 'B20')}/archive", {"reason": "sold"})
    report = imported(client, tree, code=1)
    expect(sums(report) == {"revised": 1, "same": 9, "skipped": 6, "failed": 1}, f"revised: {sums(report)}")
    row = next(item for item in report["items"] if item["file"] == "acme/B20.txt")
    expect(row["why"].startswith("archived by ") and row["why"].endswith(": sold"), f"the archived one: {row}")
    expect(library(client)[None, "top"][1] == 2 and library(client)[None, "top"][4] == changed, "the revision")
    below = imported(client, tree, "--folder", "old/works", "--dialect", "mazak", code=1)
    expect(below["added"] == 10 and library(client)["old/works/acme/pumps", "O0010"][0] == "mazak", f"below a folder: {sums(below)}")
    for wrong in (["--folder", "a//b"], ["--dialect", "cobol"]):
        expect(command(client, "import", tree, *wrong).returncode == 2, f"{wrong} was taken")
    expect(command(client, "import", tree / "none").returncode == 2, "a folder that is not there")


def program_of(client, name):
    return client.get(f"/programs?name={name}")["items"][0]["id"]


def out_and_in_again(client, folder):
    client.post("/families", {"text": ROLL})
    client.post("/parts", {"number": "R-1", "family": "hyperbolic-roll", "values": {"angle_step": "2 deg"}})
    top = program_of(client, "top")
    client.must("PATCH", f"/programs/{top}", {"tags": ["pump", "alu"]})
    twin = client.post("/programs", {"name": "top", "dialect": "fanuc", "text": "%\nO9\nM30\n%\n"})["id"]  # a second one of its name and folder
    client.must("PATCH", f"/programs/{twin}", {"folder": "other/../.x%".replace("../", "")})
    sheet = bytes(range(256)) * 5000
    for owner in (f"program={top}", "part=R-1", "family=hyperbolic-roll"):
        expect(client.call("POST", f"/attachments?{owner}&name=sheet.pdf", sheet + owner.encode(), headers={"Content-Type": "application/pdf"}).status == 201, owner)
    for n, arguments in enumerate(([], ["--all-revisions"])):
        out = folder / f"out{n}"
        done = command(client, "export", out, *arguments)
        expect(done.returncode == 0, f"export: {done.stderr.decode()}")
        manifest = json.loads((out / "dripfeed-export.json").read_text())
        files = files_of(manifest)
        there = {str(path.relative_to(out)) for path in out.rglob("*") if path.is_file()} - {"dripfeed-export.json"}
        expect(there == set(files), f"other files than the manifest has: {there ^ set(files)}")
        for path, file in files.items():
            body = (out / path).read_bytes()
            expect(hashlib.sha256(body).hexdigest() == file["sha256"] and len(body) == file["bytes"], f"{path} is another")
        into_an_empty_shop(client, folder / f"empty{n}", out, n == 1)
    expect(command(client, "export", out).returncode == 2, "into a folder that is not empty")
    broken_exports(client, folder, out)


def files_of(manifest):
    lists = [of["revisions"] for kind in ("programs", "families", "parts", "machines") for of in manifest[kind]] + [[of["file"]] for of in manifest["attachments"]]
    return {file["path"]: file for files in lists for file in files}


def into_an_empty_shop(client, folder, out, all_revisions):
    other = Client(folder).start()
    report = imported(other, out)
    expect(report["failed"] == 0, f"into an empty shop: {report}")
    here, there = library(client), library(other)
    wanted = {place: row if all_revisions else (row[0], 1, *row[2:]) for place, row in here.items()}
    expect(there == wanted, f"the library is another: {there.keys() ^ wanted.keys()} {[place for place in there if there[place] != wanted.get(place)]}")
    expect(other.get("/families/hyperbolic-roll")["text"] == ROLL, "the family")
    expect(other.get("/parts/R-1")["values"] == client.get("/parts/R-1")["values"], "the part")
    files = [sorted((one["name"], one["sha256"], one["media_type"], one["family"], one["part"]) for one in of.get("/attachments")["items"]) for of in (client, other)]
    expect(files[0] == files[1] and len(files[0]) == 3, f"attached files: {files}")
    again = imported(other, out)
    expect(again["added"] == again["revised"] == again["failed"] == 0 and library(other) == there, f"the same again: {sums(again)}")
    expect(other.post("/store/verify")["faults"] == [], "the store has faults")
    other.server.stop()


def broken_exports(client, folder, out):
    """A manifest is believed in nothing that can be looked at."""
    path = out / "dripfeed-export.json"
    whole, before = json.loads(path.read_text()), library(client)
    program = whole["programs"][0]["revisions"][0]
    secret = folder / "secret"
    secret.write_bytes(b"M30\n")
    rows = [("path", "../secret", 2), ("path", "/etc/passwd", 2), ("path", "", 2), ("sha256", "x", 2), ("sha256", "0" * 64, 1), ("path", "linked/secret", 1)]
    os.symlink(folder, out / "linked")
    for member, value, code in rows:
        broken = json.loads(json.dumps(whole))
        broken["programs"][0]["revisions"][0][member] = value
        path.write_text(json.dumps(broken))
        done = command(client, "import", out, "--folder", "broken")
        expect(done.returncode == code, f"{member} {value}: {done.returncode} {done.stdout.decode()[-500:]} {done.stderr.decode()}")
        place = ("broken/" + whole["programs"][0]["folder"], whole["programs"][0]["name"])
        expect(place not in library(client), f"{member} {value} was imported: {program}")
    path.write_text("{")
    expect(command(client, "import", out).returncode == 2, "a manifest that is torn")
    expect(all(library(client)[place] == row for place, row in before.items()), "what was there has changed")


def main(folder):
    client = Client(folder).start()
    tree = a_tree(client, folder)
    a_tree_over_the_wire(folder, tree)
    what_differs(client, tree)
    out_and_in_again(client, folder)
    expect(client.post("/store/verify")["faults"] == [], "the store has faults")
    client.server.stop()


if __name__ == "__main__":
    in_folder(main)
    sys.exit(0)
