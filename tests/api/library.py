"""The library of the shop: programs found by words, where a program is used, tags, folders and the archive. Programs of a store that an older version
wrote are found, too."""

import pathlib
import shutil
import sqlite3
import sys

from client import Client, HandControl, expect, hand_profile, in_folder, shop

SCHEMAS = pathlib.Path(__file__).resolve().parents[1] / "store" / "schema"


def program(client, name, text, dialect="fanuc"):
    return client.post("/programs", {"name": name, "dialect": dialect, "text": text})["id"]


def settled(client):
    """The search has seen everything that was changed."""
    shop.wait_for("the library to be whole", lambda: client.get("/search?q=x")["waiting"] == 0)


def found(client, words, more=""):
    return [item["program"]["id"] for item in client.get(f"/search?q={words}{more}")["items"]]


def by_words(client):
    pump = program(client, "PUMP-HOUSING", "%\nO0042(WELLE AUSSEN)\nT0505M06\nG01X12.5F100.\nM30\n%\n")
    macro = program(client, "O9010", "%\nO9010\nG04P100\nM99\n%\n")
    main = program(client, "O0012", "%\nO0012\nN10M98P42\nG65P9010A1.\nM98P77\nM30\n%\n")
    settled(client)
    for words, wanted in (("pump", [pump]), ("hous", [pump]), ("O42", [pump]), ("welle", [pump]), ("T505", [pump]), ("x12.5", [pump]), ("m99", [macro]),
                          ("%22welle%20aussen%22", [pump]), ("pump%20m99", []), ("PUMQ", [pump]), ("HUOSING", [pump])):
        expect(found(client, words) == wanted, f"{words}: {found(client, words)}, not {wanted}")
    item = client.get("/search?q=welle")["items"][0]
    expect([part["text"] for part in item["snippet"] if part["is_hit"]] == ["WELLE"] and not item["is_similar"], item)
    expect(client.get("/search?q=PUMQ")["items"][0]["is_similar"], "a name that is only similar is reported as right")
    client.must("POST", f"/programs/{macro}/revisions", {"text": "%\nO9010\nG04P200\n(SECOND)\nM99\n%\n"}, headers={"If-Match": '"1"'})
    settled(client)
    expect(found(client, "second") == [macro] and found(client, "P100") == [], "the newest revision counts")
    return pump, macro, main


def pages(client):
    for number in range(25):
        program(client, f"BRACKET-{number:02}", f"%\nO0100\nG0X{number}.\nM30\n%\n")
    settled(client)
    seen, after = [], ""
    while True:
        page = client.get(f"/search?q=bracket&limit=10{after}")
        seen += [item["program"]["id"] for item in page["items"]]
        if page["next"] is None:
            break
        after = f"&after={page['next']}"
    expect(len(seen) == 25 and len(set(seen)) == 25, f"{len(seen)} hits, {len(set(seen))} programs")
    client.refuse(422, "GET", "/search?q=bracket&after=nonsense")
    for nothing in ("", "%20", "---"):
        client.refuse(422, "GET", f"/search?q={nothing}")
    client.refuse(422, "GET", "/search?q=x&shelf=archived")


def used(client, pump, macro, main):
    uses = client.get(f"/programs/{macro}/uses")
    expect([(one["program"], one["line"], one["kind"], one["called"]) for one in uses["called_by"]] == [(main, 4, "macro", "O9010")], uses)
    expect(uses["calls"] == [] and uses["calls_not_known"] is None and uses["unread"] == 0, uses)
    uses = client.get(f"/programs/{main}/uses")
    expect([(one["called"], [of["program"] for of in one["programs"]]) for one in uses["calls"]] == [("O42", [pump]), ("O9010", [macro]), ("O77", [])], uses)
    control = HandControl()
    client.post("/machines", hand_profile(control))
    fed = client.add_program(40, "O0055")["id"]
    release = client.release(fed)
    job = client.queue(release["id"])
    uses = client.get(f"/programs/{fed}/uses")
    expect([one["id"] for one in uses["releases"]] == [release["id"]] and [one["id"] for one in uses["jobs"]] == [job], uses)
    expect(uses["machines"] == [{"machine": "lathe", "releases": 1, "jobs": 1}] and not uses["has_more_jobs"], uses["machines"])
    settled(client)
    expect(fed in found(client, "lathe"), "a program is not found by the machine that it is released for")
    broken = program(client, "O0066", "%\nO0066\nM98P[1\nM30\n%\n")
    settled(client)
    uses = client.get(f"/programs/{broken}/uses")
    expect("line 3" in (uses["calls_not_known"] or "") and uses["unread"] >= 1, uses)
    client.refuse(404, "GET", "/programs/999999/uses")
    return control, fed, job, release["id"]


def filed(client, pump, macro):
    patch = {"tags": ["rush", "alu"], "folder": "acme/pumps"}
    labelled = client.must("PATCH", f"/programs/{pump}", patch)
    expect(labelled["tags"] == ["alu", "rush"] and labelled["folder"] == "acme/pumps" and labelled["revision"] == 1, labelled)
    client.must("PATCH", f"/programs/{macro}", {"folder": "acme"})
    listed = lambda query: sorted(item["id"] for item in client.get(f"/programs?limit=200&{query}")["items"])  # noqa: E731
    expect(listed("tag=rush") == [pump] and listed("folder=acme") == sorted([pump, macro]) and listed("folder=acme/pumps") == [pump], "filters")
    settled(client)
    expect(found(client, "rush%20acme") == [pump], "tags and folders are words")
    expect(client.must("PATCH", f"/programs/{pump}", {"tags": []})["tags"] == [] and client.get(f"/programs/{pump}")["folder"] == "acme/pumps", "what is not given stays")
    for wrong, word in (({"tags": [""]}, "/tags"), ({"tags": "rush"}, "/tags"), ({"tags": ["x" * 65]}, "64"), ({"folder": "a//b"}, "/folder"), ({"folder": "/a"}, "/folder"),
                        ({"labels": []}, "labels"), ({"tags": [f"t{n}" for n in range(33)]}, "32")):
        client.refuse(422, "PATCH", f"/programs/{pump}", wrong, words=[word])
    client.refuse(404, "PATCH", "/programs/999999", {"folder": "a"})


def archived(client, pump, fed, job, release):
    client.refuse(409, "POST", f"/programs/{fed}/archive", {"reason": "sold"}, words=[f"job {job}"])
    client.post(f"/jobs/{job}/cancel")
    client.wait_job(job, "cancelled")
    client.refuse(409, "POST", f"/programs/{fed}/archive", {"reason": "sold"}, words=[f"release {release}"])
    client.refuse(422, "POST", f"/programs/{pump}/archive", {"reason": ""})
    done = client.post(f"/programs/{pump}/archive", {"reason": "the customer is gone"})
    expect(done["archived"]["reason"] == "the customer is gone" and done["archived"]["by"], done)
    expect(pump not in [item["id"] for item in client.get("/programs?limit=200")["items"]], "an archived program is in the list")
    expect([item["id"] for item in client.get("/programs?shelf=archived")["items"]] == [pump], "the shelf of the archived")
    client.refuse(422, "GET", "/programs?shelf=nowhere")
    settled(client)
    expect(found(client, "pump") == [] and found(client, "pump", "&shelf=all") == [pump], "the search looks into the archive unasked")
    client.refuse(409, "POST", f"/programs/{pump}/revisions", {"text": "%\nO1\nM30\n%\n"}, headers={"If-Match": '"1"'}, words=["archived"])
    client.refuse(409, "POST", "/releases", {"program": pump, "machine": "lathe"}, words=["archived"])
    back = client.post(f"/programs/{pump}/fetch-back", {"reason": "it is ordered again"})
    expect(back["archived"] is None, back)
    client.refuse(409, "POST", f"/programs/{pump}/fetch-back", {"reason": "again"})


def after_a_restart(client, macro, main):
    settled(client)
    client.restart()
    expect(client.get("/search?q=second")["waiting"] == 0, "a restart reads all texts again")
    expect([one["program"] for one in client.get(f"/programs/{macro}/uses")["called_by"]] == [main], "calls are lost")
    client.server.stop()
    library = client.server.data / "dripfeed.db-library"
    library.write_bytes(b"no library" * 1000)
    client.server.start()
    settled(client)
    expect(found(client, "second") == [macro], "a damaged library is not rebuilt")


def all_of_it(folder):
    client = Client(folder).start()
    pump, macro, main = by_words(client)
    pages(client)
    control, fed, job, release = used(client, pump, macro, main)
    filed(client, pump, macro)
    archived(client, pump, fed, job, release)
    after_a_restart(client, macro, main)
    expect(client.server.alive(), "the server is gone")
    client.server.stop()
    control.close()


def stores_of_old(folder):
    """Every old schema: what it has is found without a person's help."""
    for version in sorted(int(path.stem[1:]) for path in SCHEMAS.glob("v*.sql")):
        data = folder / f"v{version}" / "data"
        data.mkdir(parents=True)
        store = sqlite3.connect(data / "dripfeed.db")
        store.executescript((SCHEMAS / f"v{version}.sql").read_text())
        may_be_deleted = any(column[1] == "deleted_at_ms" for column in store.execute("PRAGMA table_info(program)"))
        programs = [row[0] for row in store.execute(f"SELECT id FROM program {'WHERE deleted_at_ms = 0' if may_be_deleted else ''} ORDER BY id")]
        store.close()
        client = Client(folder / f"v{version}")
        client.server.start()
        client.tokens = {"admin": client.add_token("admin")}
        settled(client)
        everything = client.get("/search?q=M30&shelf=all")
        expect(sorted(item["program"]["id"] for item in everything["items"]) == programs and everything["programs"] == len(programs), f"v{version}: {everything}")
        client.server.stop()
        shutil.rmtree(folder / f"v{version}")


if __name__ == "__main__":
    in_folder(all_of_it)
    in_folder(stores_of_old)
    sys.exit(0)
