"""A shop moves from the file of its store into a PostgreSQL database: `dripfeed backup`, then `dripfeed restore --store`. Every row of every table is
compared by the two engines' own programs; the server that starts there knows a torn line, goes on with its numbers, and feeds."""

import functools
import pathlib
import sqlite3
import subprocess

from client import DC1, Client, HandControl, binary, expect, hand_profile, in_folder, plain_program, shop
from postgresql import Database

SCHEMAS = pathlib.Path(__file__).resolve().parents[1] / "store" / "schema"


def run(*arguments, code=0):
    done = subprocess.run([str(binary()), *map(str, arguments)], capture_output=True, text=True, timeout=120)
    expect(done.returncode == code, f"{arguments} ended with {done.returncode}: {done.stdout} {done.stderr}")
    return done.stdout + done.stderr


def psql(url, sql):
    """Rows of texts; None for NULL."""
    out = subprocess.run(["psql", "-q", "-X", "-A", "-t", "-v", "ON_ERROR_STOP=1", "-F", "\x1f", "-R", "\x1e", "-P", "null=\x01", url, "-c", sql], check=True,
                         capture_output=True, text=True, timeout=60).stdout
    return [tuple(None if cell == "\x01" else cell for cell in row.split("\x1f")) for row in out.removesuffix("\n").split("\x1e")] if out.strip("\n") else []


def as_text(cell):
    if isinstance(cell, bytes):
        return "\\x" + cell.hex()
    return None if cell is None else str(cell)


def tables_are_equal(path, url):
    """All of the tables, also those that a later schema brings."""
    file = sqlite3.connect(path)
    tables = [name for name, in file.execute("SELECT name FROM sqlite_schema WHERE type = 'table' AND name NOT LIKE 'sqlite_%' AND name <> 'migration'")]
    rows = 0
    for table in tables:
        names = [row[1] for row in file.execute(f"SELECT * FROM pragma_table_xinfo('{table}')")]
        here = sorted(tuple(map(as_text, row)) for row in file.execute(f"SELECT {', '.join(names)} FROM {table}"))
        there = sorted(psql(url, f"SELECT {', '.join(names)} FROM {table}"))
        expect(here == there, f"{table}: {set(here) ^ set(there)}")
        rows += len(here)
    file.close()
    return len(tables), rows


def every_table_comes_over(folder, database):
    newest = max(SCHEMAS.glob("v*.sql"), key=lambda path: int(path.stem[1:]))
    (folder / "old").mkdir()
    store = sqlite3.connect(folder / "old" / "dripfeed.db")
    store.executescript(newest.read_text())
    store.close()
    run("backup", folder / "old", folder / "b")
    url = database.add("every_table")
    said = run("restore", folder / "b", folder / "new", "--store", url)
    expect("the database has the store of" in said and "3 programs" in said, said)
    tables, rows = tables_are_equal(folder / "old" / "dripfeed.db", url)
    expect(tables > 38 and rows > 100, f"{tables} tables, {rows} rows")
    for wrong, words in (((folder / "b", folder / "new", "--store", url), "the database has a shop already"),
                         ((folder / "b", folder / "old", "--store", database.add("nothing_there")), "is a store, too"),
                         ((folder / "b", folder / "new", "--store", url, "--replace"), "a database must be empty"),
                         ((folder / "b", folder / "new", "--store", "postgresql:///none?host=/nowhere"), "nowhere")):
        expect(words in run("restore", *wrong, code=2), f"{wrong}")
    expect(tables_are_equal(folder / "old" / "dripfeed.db", url) == (tables, rows), "a refused restore changed something")
    expect("name it with --store" in run("token", "list", "--data", folder / "new", code=2), "the folder is not marked")


def a_shop_goes_on(folder, database):
    client, control = Client(folder / "file").start(), HandControl()
    client.post("/machines", hand_profile(control))
    release = client.release(client.add_program(400)["id"])["id"]
    torn = client.queue(release)
    client.wait_line("lathe", "idle")
    client.post(f"/jobs/{torn}/arm")
    control.say(DC1)
    control.hold_inside_block()
    client.server.kill()
    path = client.server.data / "dripfeed.db"
    client.server.start()
    client.server.stop()  # it has noted what a kill left
    control.cut()
    run("backup", client.server.data, folder / "b")
    url = database.add("moved")
    run("restore", folder / "b", folder / "moved" / "data", "--store", url)
    tables_are_equal(path, url)
    moved = Client(folder / "moved", "--store", url)
    moved.tokens = dict(client.tokens)
    (moved.server.data / "first-token").write_text((client.server.data / "first-token").read_text())
    moved.start()
    seen = moved.get(f"/jobs/{torn}")
    expect(seen["state"] == "interrupted" and seen["torn"], f"{seen}")
    job = moved.queue(release)
    expect(job > torn, f"job {job} after job {torn}")
    refused = moved.call("POST", f"/jobs/{job}/arm")
    expect(refused.status == 409, f"armed on a torn line: {refused}")
    moved.post("/machines/lathe/confirm-reset", {"reason": "RESET pressed"})
    moved.wait_line("lathe", "idle")
    before = len(control.text())
    moved.post(f"/jobs/{job}/arm")
    control.say(DC1)
    moved.wait_job(job, "done")
    expect(control.text()[before:].decode().strip() == plain_program(400).strip(), "another text arrived")
    events = [int(row[0]) for row in psql(url, "SELECT seq FROM event ORDER BY seq")]
    expect(events == list(range(events[0], events[0] + len(events))), "a gap in the numbers of events")
    expect("another server has the database" in run("restore", folder / "b", folder / "third", "--store", url, code=2), "restored under a server")
    moved.server.stop()
    expect("whole" in run("ledger", "verify", *moved.store), "the ledger is not whole")


if __name__ == "__main__":
    made = Database()
    try:
        for test in (every_table_comes_over, a_shop_goes_on):
            in_folder(functools.wraps(test)(lambda folder, test=test: test(folder, made)))
    finally:
        made.end()
