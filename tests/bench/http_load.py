#!/usr/bin/env python3
"""What the HTTP side takes: requests a second, and nginx's static rate in the same run (wrk), how long a text and a job take, how long others wait
during an upload of 60 MB with a key, how long the largest families take, and what watchers cost.
tests/bench/http_load.py build/dev/dripfeed [rates texts jobs families upload watchers]"""

import json
import os
import pathlib
import re
import selectors
import shutil
import socket
import sqlite3
import subprocess
import sys
import threading
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "api"))
from client import API, DC1, Client, HandControl, exchange, hand_profile, in_folder, plain_program  # noqa: E402
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "e2e"))
from tls import Nginx, free_port  # noqa: E402

WANTED = set(sys.argv[2:]) or {"rates", "texts", "jobs", "families", "upload", "watchers"}
FAMILY_BYTES = 1_040_000  # as JSON; the limit is 1 MiB
UPLOAD_BYTES = 60_000_000


def milliseconds(times):
    times = sorted(times)
    return f"{len(times)} times, median {times[len(times) // 2] * 1e3:.2f} ms, p99 {times[int(len(times) * 0.99)] * 1e3:.2f} ms, worst {times[-1] * 1e3:.1f} ms"


def bearer(client, role):
    return {"Authorization": f"Bearer {client.tokens[role]}"}


def rate(name, url, token, process):
    """Requests a second, which others on this machine slow down, and the time of a core for each, which they hardly do."""
    before = cpu_s(process)
    printed = subprocess.run(["wrk", "-t1", "-c16", "-d4", url, "-H", f"Authorization: Bearer {token}"], capture_output=True, text=True, check=True).stdout
    count, second = int(re.search(r"(\d+) requests in", printed)[1]), float(re.search(r"Requests/sec:\s+([\d.]+)", printed)[1])
    print(f"{name}: {second:.0f} a second, {1e6 * (cpu_s(process) - before) / count:.1f} us of a core each")


def rates(client, control, folder):
    if not shutil.which("wrk"):
        return print("rates: wrk is not installed")
    page, port = folder / "static", free_port()
    page.mkdir()
    folder.chmod(0o755)
    (page / "machines").write_text(json.dumps(client.get("/machines")))
    nginx = Nginx(folder, f"server {{ listen 127.0.0.1:{port}; root {page}; }}")
    time.sleep(1)
    master = nginx.process.pid
    worker = int(pathlib.Path(f"/proc/{master}/task/{master}/children").read_text().split()[0])
    rate("nginx, the same answer as a file", f"http://127.0.0.1:{port}/machines", client.tokens["viewer"], worker)
    for path in ("/healthz", f"{API}/machines", f"{API}/programs/1"):
        rate(path, f"http://127.0.0.1:{client.server.port}{path}", client.tokens["viewer"], client.server.process.pid)
    nginx.stop()
    fed = feed(client, control, "O79")  # which changes the store ten times a second, and its line with each piece
    for path in (f"{API}/machines", f"{API}/programs/1"):
        rate(f"{path}, beside a feed", f"http://127.0.0.1:{client.server.port}{path}", client.tokens["viewer"], client.server.process.pid)
    client.post(f"/jobs/{fed}/cancel")
    client.wait_job(fed, "cancelled")


def texts(client, program):
    connection, times = client.connect(), []
    for _ in range(200):
        begin = time.perf_counter()
        exchange(connection, "GET", f"{API}/programs/{program}/text", None, bearer(client, "viewer"))
        times.append(time.perf_counter() - begin)
    print("a text of 4 kB:", milliseconds(times))


def feed(client, control, name):
    """A long program that is being sent to the control."""
    job = client.queue(client.release(client.add_program(6000, name)["id"])["id"])
    client.wait_line("lathe", "idle")
    client.post(f"/jobs/{job}/arm")
    control.say(DC1)
    client.wait_job(job, "feeding")
    return job


def jobs(client, control, release):
    """During a feed. Each is followed by one write of the disk by itself, because disks of virtual machines change from one second to the next."""
    fed, connection, times, disk = feed(client, control, "O78"), client.connect(), [], []
    file = os.open(client.server.data / "probe", os.O_RDWR | os.O_CREAT)
    for n in range(2000):
        begin = time.perf_counter()
        _, answer = exchange(connection, "POST", f"{API}/jobs", {"release": release}, bearer(client, "operator") | {"Idempotency-Key": f"job-{n}"})
        times.append(time.perf_counter() - begin)
        assert answer.status == 201, answer
        begin = time.perf_counter()
        os.pwrite(file, bytes(4096), 0)
        os.fdatasync(file)
        disk.append(time.perf_counter() - begin)
    print(f"a job with a key beside a feed: {len(times) / sum(times):.0f} a second,", milliseconds(times))
    print(f"  fdatasync of 4 kB in between: {len(disk) / sum(disk):.0f} a second,", milliseconds(disk), f": a job has {100 * sum(disk) / sum(times):.0f} % of its rate")
    for callers in (1, 8):
        jobs_at_once(client, release, callers, file)
    os.close(file)
    client.post(f"/jobs/{fed}/cancel")
    client.wait_job(fed, "cancelled")


class RawCaller:
    """Asks for a job again and again on a connection of its own, with requests that are written before, so that the caller costs next to nothing."""

    def __init__(self, client, release, name, count):
        body = json.dumps({"release": release})
        head = f"POST {API}/jobs HTTP/1.1\r\nHost: x\r\nContent-Type: application/json\r\nAuthorization: Bearer {client.tokens['operator']}\r\nContent-Length: {len(body)}\r\n"
        self.waiting = [f"{head}Idempotency-Key: {name}-{n}\r\n\r\n{body}".encode() for n in range(count)]
        self.socket = socket.create_connection(("127.0.0.1", client.server.port))
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.got, self.begin, self.times = b"", 0.0, []

    def ask(self):
        self.begin = time.perf_counter()
        self.socket.sendall(self.waiting.pop())

    def take(self):
        """False when all its requests are answered."""
        self.got += self.socket.recv(65536)
        head, _, body = self.got.partition(b"\r\n\r\n")
        length = re.search(rb"Content-Length: (\d+)", head)
        if not length or len(body) < int(length[1]):
            return True
        assert head.startswith(b"HTTP/1.1 201 "), self.got
        self.times.append(time.perf_counter() - self.begin)
        self.got = b""
        if self.waiting:
            self.ask()
            return True
        return False


def disk_rate(file, seconds=0.5):
    count, begin = 0, time.perf_counter()
    while time.perf_counter() - begin < seconds:
        os.pwrite(file, bytes(4096), 0)
        os.fdatasync(file)
        count += 1
    return count / (time.perf_counter() - begin)


def jobs_at_once(client, release, callers, file, count=2400, rounds=4):
    """In slices, each between two looks at the disk alone."""
    took, times, process, disk, used = 0.0, [], client.server.process.pid, [disk_rate(file)], 0.0
    for turn in range(rounds):
        asking, selector = [RawCaller(client, release, f"at-once-{callers}-{turn}-{n}", count // rounds // callers) for n in range(callers)], selectors.DefaultSelector()
        before, begin = cpu_s(process), time.perf_counter()
        for caller in asking:
            selector.register(caller.socket, selectors.EVENT_READ, caller)
            caller.ask()
        while selector.get_map():
            for key, _ in selector.select():
                if not key.data.take():
                    selector.unregister(key.fileobj)
        took, used = took + time.perf_counter() - begin, used + cpu_s(process) - before
        for caller in asking:
            times += caller.times
            caller.socket.close()
        disk.append(disk_rate(file))
    rate, alone = len(times) / took, sum(disk) / len(disk)
    print(f"jobs with a key from {callers} at once: {rate:.0f} a second, {1e6 * used / len(times):.0f} us of a core each,", milliseconds(times))
    print(f"  fdatasync of 4 kB before, between and after: {', '.join(f'{one:.0f}' for one in disk)} a second: jobs have {100 * rate / alone:.0f} % of its rate")


def families(client):
    """Families as long as may be, of what a reader could look at again and again."""
    head, end = "family f\nmachine mill\n", "program p\nend\n"
    for what, before, line, after in (("parameters", head, "param p# length 10 mm in 1..20\n", end), ("names", head, "let q#=#\n", end), ("names that are not known", head, "let q#=1\nlet r#=u#\n", end),
                                      ("a name given twice", head, "let q=1\n", end), ("a fault in each line", head, "x\n", end), ("blocks", head + "program p\n", "for t# from 1 to 2 step 1\nend\n", "end\n")):
        count = FAMILY_BYTES // (len(line) + line.count("\n") + 4 * line.count("#"))
        text = before.replace("family f", f"family f-{what.replace(' ', '-')}") + "".join(line.replace("#", str(n)) for n in range(count)) + after
        body, process = json.dumps({"text": text}).encode(), client.server.process.pid
        used, begin = cpu_s(process), time.perf_counter()
        answer = client.call("POST", "/families", body, headers={"Content-Type": "application/json"})
        print(f"a family of {len(body)} bytes, {what}: {answer.status} after {time.perf_counter() - begin:.2f} s, {cpu_s(process) - used:.2f} s of a core")


def upload(client, release):
    body = json.dumps({"name": "LONG", "dialect": "fanuc", "text": "G01 X1.\n" * (UPLOAD_BYTES // 9)}).encode()
    sender = threading.Thread(target=lambda: client.call("POST", "/programs", body, headers={"Content-Type": "application/json", "Idempotency-Key": "long"}))

    def repeat(name, method, path, sent, role):
        connection, times = client.connect(), []
        while sender.is_alive():
            begin = time.perf_counter()
            exchange(connection, method, path, sent, bearer(client, role))
            times.append(time.perf_counter() - begin)
        print(f"  {name}:", milliseconds(times))

    def lock_of_another_process():
        """What a writer that is not a part of the server waits for the lock of the database."""
        base, times = sqlite3.connect(client.server.data / "dripfeed.db", timeout=30, isolation_level=None), []
        while sender.is_alive():
            begin = time.perf_counter()
            base.execute("BEGIN IMMEDIATE")
            times.append(time.perf_counter() - begin)
            base.execute("ROLLBACK")
            time.sleep(0.01)
        print("  the lock of the database, for another process:", milliseconds(times))

    begin = time.perf_counter()
    sender.start()
    others = [threading.Thread(target=repeat, args=row) for row in (("GET /machines", "GET", f"{API}/machines", None, "viewer"), ("POST /jobs", "POST", f"{API}/jobs", {"release": release}, "operator"),
                                                                    ("a stop", "POST", f"{API}/jobs/99999/stop", {}, "operator"))] + [threading.Thread(target=lock_of_another_process)]
    for one in others:
        one.start()
    sender.join()
    print(f"{len(body)} bytes with a key took {time.perf_counter() - begin:.1f} s; meanwhile")
    for one in others:
        one.join()


def cpu_s(process):
    fields = pathlib.Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def watchers(client, control, count=500):
    tokens, selector, got, done = [client.add_token("viewer", f"wall {n}") for n in range(-(-count // 60))], selectors.DefaultSelector(), [0], threading.Event()
    for n in range(count):
        connection = client.connect()
        connection.request("GET", f"{API}/events", headers={"Authorization": f"Bearer {tokens[n % len(tokens)]}"})
        selector.register(connection.sock, selectors.EVENT_READ, connection)

    def drain():
        while not done.is_set():
            for key, _ in selector.select(0.2):
                got[0] += len(key.fileobj.recv(65536))

    threading.Thread(target=drain, daemon=True).start()
    feed(client, control, "O77")
    time.sleep(1)
    process, seconds = client.server.process.pid, 5
    before, bytes_before = cpu_s(process), got[0]
    time.sleep(seconds)
    print(f"{count} watchers of a feed: {100 * (cpu_s(process) - before) / seconds:.0f} % of a core for {(got[0] - bytes_before) / seconds / 1000:.0f} kB a second")
    done.set()


def load(folder):
    control, client = HandControl(), Client(folder).start()
    client.post("/machines", hand_profile(control))
    program = client.add_program(150)["id"]
    release = client.release(program)["id"]
    print(f"load of the machine before: {os.getloadavg()[0]:.1f} on {os.cpu_count()} cores")
    if "rates" in WANTED:
        rates(client, control, folder)
    if "texts" in WANTED:
        texts(client, program)
    if "jobs" in WANTED:
        jobs(client, control, release)
    if "families" in WANTED:
        families(client)
    if "upload" in WANTED:
        upload(client, release)
    if "watchers" in WANTED:
        watchers(client, control)
    client.end()


if __name__ == "__main__":
    in_folder(load)
