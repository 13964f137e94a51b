"""A shop of twenty years: how long the answers take with 100,000 programs, 1,000,000 revisions and 10,000,000 ledger rows, while 64 lines are fed, and
what the lines notice of it. The rows are written past the server (shop_rows.py); the store is a new one in a folder, of SQLite or of PostgreSQL.
By hand: shop_scale.py build/dev/dripfeed [--engine postgresql] [--programs 100000] [--revisions 1000000] [--ledger 10000000] [--lines 64]
         [--asks 300] [--seconds 120] [--folder DIR]"""

import argparse
import http.client
import json
import os
import pathlib
import random
import sys
import tempfile
import time
import urllib.parse

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "api"), str(HERE.parents[1] / "deploy")]
import fleet  # noqa: E402
import shop_rows  # noqa: E402
from fleet import shop  # noqa: E402


class Caller:
    """One connection that is kept; each answer is timed whole."""

    def __init__(self, server):
        self.connection = http.client.HTTPConnection("127.0.0.1", server.port, timeout=300)
        self.headers = {"Authorization": f"Bearer {server.token()}"}

    def ask(self, path, body=None, method=None):
        send = dict(self.headers)
        data = None if body is None else json.dumps(body).encode()
        if data:
            send["Content-Type"] = "application/json"
        begun = time.perf_counter()
        self.connection.request(method or ("POST" if data else "GET"), f"/api/v1{path}", data, send)
        answer = self.connection.getresponse()
        content = answer.read()
        took_ms = (time.perf_counter() - begun) * 1000
        if answer.status >= 300:
            raise RuntimeError(f"{path}: {answer.status} {content[:300].decode(errors='replace')}")
        return took_ms, content


def search(words):
    return "/search?q=" + urllib.parse.quote(words)


class Kinds:
    """Each kind of question: its name and a path with other values each time."""

    def __init__(self, rows, seed=1):
        self.rows, self.pick = rows, random.Random(seed)
        self.after = {}
        day = shop_rows.DAY_MS
        program, job, pick = self.program, self.job, self.pick
        self.paths = {
            "search: a name": lambda: search(shop_rows.name_of(program())),
            "search: two words of names": lambda: search(f"{pick.choice(shop_rows.THINGS)} {pick.choice(shop_rows.THINGS)}"),
            "search: a program number": lambda: search(f"O{pick.randrange(1000, 10000)}"),
            "search: a name with a fault": lambda: search(self.misspelt()),
            "search: a word of the text": lambda: search(f"X{pick.randrange(400)}.{pick.randrange(1000):03}"),
            "search: a word that most texts have": lambda: search("drill"),
            "programs, page after page": lambda: self.next_page("/programs?limit=50"),
            "programs of a folder": lambda: f"/programs?limit=50&folder=customer{pick.randrange(200)}",
            "a program": lambda: f"/programs/{program()}",
            "its text": lambda: f"/programs/{program()}/text",
            "its revisions": lambda: f"/programs/{program()}/revisions?limit=50",
            "two revisions compared": lambda: f"/programs/{program()}/compare?revision={pick.randrange(1, rows.each)}&with_revision={rows.each}",
            "where it is used": lambda: f"/programs/{program()}/uses",
            "all machines": lambda: "/machines?limit=100",
            "a machine": lambda: f"/machines/{pick.choice(rows.machines)}",
            "jobs, newest first": lambda: self.next_page("/jobs?limit=50"),
            "jobs by state": lambda: f"/jobs?limit=50&state={pick.choice(['done', 'interrupted', 'feeding', 'queued'])}",
            "jobs of a machine": lambda: f"/jobs?limit=50&machine={pick.choice(rows.machines)}",
            "the ledger of a job": lambda: f"/jobs/{job()}/ledger?limit=200",
            "releases, page after page": lambda: self.next_page("/releases?limit=50"),
            "sums of 30 days by machine": lambda: self.sums(30 * day, "machine"),
            "sums of a year by day": lambda: self.sums(365 * day, "day"),
            "work that waits": lambda: "/work",
        }

    def program(self):
        return self.rows.first["program"] + self.pick.randrange(self.rows.programs)

    def job(self):
        return self.rows.first["job"] + self.pick.randrange(self.rows.jobs)

    def misspelt(self):
        word = self.pick.choice(shop_rows.THINGS)
        at = self.pick.randrange(len(word) - 1)
        return word[:at] + word[at + 1] + word[at] + word[at + 2:]

    def next_page(self, path):
        after = self.after.get(path)
        return f"{path}&after={after}" if after else path

    def sums(self, span_ms, by):
        to = self.rows.now_ms - self.pick.randrange(10 * 365) * shop_rows.DAY_MS
        return f"/history/sums?by={by}&from_ms={to - span_ms}&to_ms={to}"

    def ask(self, caller, kind):
        path = self.paths[kind]()
        took_ms, content = caller.ask(path)
        if "page after page" in kind or "newest first" in kind:
            self.after[path.split("&after=")[0]] = json.loads(content)["next"]
        return took_ms


def upload(caller, n):
    text = shop_rows.text_of(10**7 + n, 1).decode()
    return caller.ask("/programs", {"name": f"NEW-{n}", "dialect": "fanuc", "text": text})[0]


def show(kind, took):
    took = sorted(took)
    p99 = took[min(len(took) - 1, len(took) * 99 // 100)]
    print(f"| {kind} | {took[len(took) // 2]:.1f} | {p99:.1f} | {took[-1]:.1f} |{'' if took[len(took) // 2] < 20 and p99 < 100 else ' over the aim'}", flush=True)


def timed(what, work):
    begun = time.monotonic()
    result = work()
    print(f"{what}: {time.monotonic() - begun:.1f} s", flush=True)
    return result


def first_rows(server, lines):
    """One program, release and job that the written rows are like: the job is cancelled, so that no line waits for it."""
    releases = lines.release(server, 5)
    job = server.post("/jobs", {"release": releases["m1"]})["id"]
    server.post(f"/jobs/{job}/cancel", {"reason": "its row is copied"})


def questions(server, rows, asks):
    caller, kinds = Caller(server), Kinds(rows)
    print("\n| question | median ms | p99 ms | worst ms |\n|---|---|---|---|", flush=True)
    for kind in kinds.paths:
        show(kind, [kinds.ask(caller, kind) for _ in range(asks)])
    show("a program is added", [upload(caller, n) for n in range(asks)])
    mixed = [kinds.ask(caller, kinds.pick.choice(list(kinds.paths))) for _ in range(3 * asks)]
    show("all kinds mixed", mixed)


def run(given, folder):
    binary = pathlib.Path(given.binary).resolve()
    database = None
    arguments = []
    if given.engine == "postgresql":
        from postgresql import Database
        database = Database()
        arguments = ["--store", database.add("scale")]
    lines = fleet.Fleet(binary, folder, given.lines)
    try:
        server = shop.Server(binary, folder / "data", arguments=arguments).start()
        lines.add_machines(server)
        first_rows(server, lines)
        server.stop()
        sink = shop_rows.PostgresqlSink(arguments[1]) if database else shop_rows.SqliteSink(folder / "data")
        rows = shop_rows.Shop(sink, given.programs, given.revisions, given.ledger, 50, lines.names, int(time.time() * 1000))
        timed(f"{given.programs} programs, {rows.programs * rows.each} revisions, {rows.jobs} jobs, {rows.jobs * rows.rows_a_job} ledger rows written", rows.write)
        timed("the server starts", server.start)
        timed("the library has read all programs", lambda: shop.wait_for("the library", lambda: server.get("/search?q=x")["waiting"] == 0, 3600, 0.5))
        lines.feed(server, lines.release(server, given.seconds * 3))
        begin, wall = fleet.processor_s(server.process.pid), time.monotonic()
        questions(server, rows, given.asks)
        span = time.monotonic() - wall
        states = [server.status(name)["line"] for name in lines.names]
        print(f"\n{given.lines} lines during {span:.0f} s of questions: server {(fleet.processor_s(server.process.pid) - begin) / span:.2f} cores, "
              f"{fleet.memory_mib(server.process.pid):.0f} MiB; {fleet.said(*lines.finish())}; "
              f"lines in another state: {sum(state not in ('feeding', 'held') for state in states)}")
        server.kill()
    finally:
        lines.process.kill()
        if database:
            database.end()


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("binary")
    options.add_argument("--engine", choices=["sqlite", "postgresql"], default="sqlite")
    options.add_argument("--programs", type=int, default=100_000)
    options.add_argument("--revisions", type=int, default=1_000_000)
    options.add_argument("--ledger", type=int, default=10_000_000)
    options.add_argument("--lines", type=int, default=64)
    options.add_argument("--asks", type=int, default=300)
    options.add_argument("--seconds", type=float, default=120)
    options.add_argument("--folder", help="where the store lies, instead of the system's folder for what is temporary")
    given = options.parse_args()
    with tempfile.TemporaryDirectory(prefix="scale-", dir=given.folder, ignore_cleanup_errors=True) as folder:
        os.environ["DRIPFEED_LINES"] = f"{folder}/lines"
        run(given, pathlib.Path(folder))


if __name__ == "__main__":
    main()
