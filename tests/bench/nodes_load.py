"""What several servers on one PostgreSQL database carry: so many servers, each with so many simulated controls that are fed at 9600 baud, watchers of the
live events spread over them, and programs that queue jobs at any of them, as many as are answered. Shown are the processor time of the servers and of
the database, its transactions, what an order took, what watchers got, and what the controls saw: characters after DC3 and the use of the lines.
By hand: nodes_load.py build/release/dripfeed [--nodes 2] [--controls 64] [--watchers 100] [--askers 4] [--seconds 60]"""

import argparse
import json
import os
import pathlib
import random
import statistics
import subprocess
import sys
import tempfile
import threading
import time
import urllib.request

sys.path[:0] = [str(pathlib.Path(__file__).resolve().parents[1] / "api"), str(pathlib.Path(__file__).resolve().parents[2] / "deploy")]
import shop  # noqa: E402
from fleet import Fleet, memory_mib, processor_s, said  # noqa: E402
from postgresql import BIN, Database  # noqa: E402


class Watcher:
    """Reads the live events of one server and counts them."""

    def __init__(self, server, until):
        self.events, self.ended = 0, None
        self.call = urllib.request.Request(f"http://127.0.0.1:{server.port}/api/v1/events", headers={"Authorization": f"Bearer {server.token()}", "Accept": "text/event-stream"})
        self.thread = threading.Thread(target=self.read, args=(until,), daemon=True)
        self.thread.start()

    def read(self, until):
        try:
            with urllib.request.urlopen(self.call, timeout=30) as stream:
                while time.monotonic() < until and (line := stream.readline()):
                    self.events += line.startswith(b"event:")
        except OSError as error:
            self.ended = str(error)


class Asker:
    """Queues a job for any machine at any server, and takes it back, one order after the other."""

    def __init__(self, servers, releases, until):
        self.took_s = []
        self.thread = threading.Thread(target=self.ask, args=(servers, releases, until), daemon=True)
        self.thread.start()

    def ask(self, servers, releases, until):
        while time.monotonic() < until:
            server, begin = random.choice(servers), time.monotonic()
            job = server.post("/jobs", {"release": random.choice(releases)})["id"]
            self.took_s.append(time.monotonic() - begin)
            server.post(f"/jobs/{job}/cancel", {})


def transactions(database, name):
    asked = subprocess.run([BIN / "psql", "-h", database.folder, "-U", "dnc", "-At", "-c", f"SELECT xact_commit FROM pg_stat_database WHERE datname = '{name}'", name],
                           check=True, capture_output=True, timeout=30)
    return int(asked.stdout)


def database_s(database):
    """Of all its processes that there are now; what has ended meanwhile is small."""
    return sum(processor_s(pid) for pid in [database.process.pid, *database.children()])


def start(given, folder, url):
    """[(server, its fleet)]; each has its own records of lines, as another computer would."""
    binary, found = pathlib.Path(given.binary).resolve(), []
    for n in range(given.nodes):
        own = folder / f"n{n}"
        own.mkdir()
        os.environ["DRIPFEED_LINES"] = f"{own}/lines"
        fleet = Fleet(binary, own, given.controls)
        fleet.names = [f"n{n}-{name}" for name in fleet.names]
        server = shop.Server(binary, own / "data", arguments=["--store", url, "--node", f"hall-{n}"]).start()
        if found:
            server.token = found[0][0].token
        fleet.add_machines(server)
        found.append((server, fleet))
    return found


def run(given, folder, database):
    name = "load"
    halls = start(given, folder, database.add(name))
    servers = [server for server, _ in halls]
    releases = []
    for server, fleet in halls:
        of = fleet.release(server, given.seconds * 1.2 + 60)
        releases += of.values()
        fleet.feed(server, of)
    print(f"{given.nodes} servers with {given.controls} lines each are fed", flush=True)
    until = time.monotonic() + given.seconds
    watchers = [Watcher(servers[n % len(servers)], until) for n in range(given.watchers)]
    askers = [Asker(servers, releases, until) for _ in range(given.askers)]
    before, wall = [processor_s(server.process.pid) for server in servers], time.monotonic()
    before_database, before_count = database_s(database), transactions(database, name)
    time.sleep(max(0.0, until - time.monotonic()))
    span = time.monotonic() - wall
    cores = [(processor_s(server.process.pid) - one) / span for server, one in zip(servers, before)]
    of_database = (database_s(database) - before_database) / span
    count = (transactions(database, name) - before_count) / span
    mib = [memory_mib(server.process.pid) for server in servers]
    lost = [line for server, fleet in halls for line in fleet.names if server.status(line)["line"] not in ("feeding", "held", "draining", "idle")]
    print(f"{span:.0f} s: servers {', '.join(f'{one:.2f}' for one in cores)} cores and {', '.join(f'{one:.0f}' for one in mib)} MiB; "
          f"database {of_database:.2f} cores, {count:.0f} transactions a second")
    took = sorted(one for asker in askers for one in asker.took_s)
    if took:
        print(f"{len(took) / span:.0f} jobs a second queued and taken back: median {statistics.median(took) * 1e3:.1f} ms, p99 {took[int(len(took) * 0.99)] * 1e3:.0f} ms")
    if watchers:
        events = [one.events / span for one in watchers]
        print(f"{len(watchers)} watchers: {min(events):.0f} to {max(events):.0f} events a second each; ended early: {[one.ended for one in watchers if one.ended] or 'none'}")
    alarms = 0
    for server, fleet in halls:
        reports, total = fleet.finish()
        alarms += sum(1 for report in reports if report["alarm"])
        print(said(reports, total))
        server.kill()
    print(f"lines in another state: {json.dumps(lost)}")
    return 1 if lost or alarms else 0


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("binary")
    for name, usual in (("nodes", 2), ("controls", 64), ("watchers", 100), ("askers", 4), ("seconds", 60)):
        options.add_argument(f"--{name}", type=int, default=usual)
    given, database = options.parse_args(), Database()
    try:
        with tempfile.TemporaryDirectory(prefix="nodes-", ignore_cleanup_errors=True) as folder:
            sys.exit(run(given, pathlib.Path(folder), database))
    finally:
        database.end()


if __name__ == "__main__":
    main()
