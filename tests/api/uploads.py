"""Long bodies lie in files until they are answered: what they cost in memory, which requests wait meanwhile, and what is left of them when the disk is full, when
it hangs, when the client leaves and when the server is killed."""

import contextlib
import http.client
import json
import os
import pathlib
import signal
import socket
import subprocess
import sys
import threading
import time

from client import API, Client, HandControl, ask, exchange, expect, expect_problem, hand_profile, in_folder, shop

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "support"))
from freezing_folder import FreezingFolder, why_not  # noqa: E402

JSON = {"Content-Type": "application/json"}
LONG_BYTES = 60_000_000


def program(name, size=LONG_BYTES):
    return json.dumps({"name": name, "dialect": "fanuc", "text": "G01 X1.\n" * (size // 9)}).encode()


def most_memory_mb(client):
    status = pathlib.Path(f"/proc/{client.server.process.pid}/status").read_text()
    return int(status.split("VmHWM:")[1].split()[0]) / 1024


def spooled(client):
    """Bytes of the files without a name that the server has open."""
    found = []
    for one in pathlib.Path(f"/proc/{client.server.process.pid}/fd").iterdir():
        with contextlib.suppress(OSError):
            target = os.readlink(one)
            if "/uploads/" in target and target.endswith("(deleted)"):
                found.append(os.stat(one).st_size)
    return found


def expect_gone(client):
    shop.wait_for("the files of the uploads to go", lambda: not spooled(client))
    uploads = client.server.data / "uploads"
    expect(not uploads.exists() or not list(uploads.iterdir()), f"left: {list(uploads.iterdir())}")


def begin_upload(client, body, sent):
    """An upload whose first `sent` bytes are on the wire."""
    link = socket.create_connection(("127.0.0.1", client.server.port), timeout=60)
    head = f"POST {API}/programs HTTP/1.1\r\nHost: x\r\nContent-Type: application/json\r\nAuthorization: Bearer {client.tokens['programmer']}\r\nContent-Length: {len(body)}\r\n\r\n"
    link.sendall(head.encode() + body[:sent])
    return link


def answer_on(link):
    response = http.client.HTTPResponse(link)
    response.begin()
    return response.status, response.read()


class Stops:
    """A stop and a read again and again on connections of their own."""

    def __init__(self, client):
        self.client, self.worst_s, self.count, self.over = client, 0.0, 0, threading.Event()
        self.thread = threading.Thread(target=self._repeat)

    def __enter__(self):
        self.thread.start()
        return self

    def __exit__(self, *_):
        self.over.set()
        self.thread.join()

    def _repeat(self):
        connection, headers = self.client.connect(), {"Authorization": f"Bearer {self.client.tokens['operator']}"}
        while not self.over.is_set():
            begin = time.monotonic()
            answer = ask(connection, "POST", f"{API}/jobs/99999/stop", {}, headers)
            self.worst_s, self.count = max(self.worst_s, time.monotonic() - begin), self.count + 1
            expect(answer.status == 404, f"a stop: {answer}")
            time.sleep(0.005)


def eight_at_once(folder):
    """480 MB in transit: the heap has none of it but what is answered now, and a stop does not wait for the disk."""
    client = Client(folder).start()
    bodies = [program(f"LONG{n}") for n in range(8)]
    before = most_memory_mb(client)
    links = [begin_upload(client, body, 50_000_000) for body in bodies]
    shop.wait_for("all of them to lie in files", lambda: sum(spooled(client)) > 8 * 45_000_000)
    waiting = most_memory_mb(client)
    expect(waiting - before < 64, f"{waiting - before:.0f} MB for eight bodies of which none is whole")
    with Stops(client) as stops:
        for link, body in zip(links, bodies):
            threading.Thread(target=link.sendall, args=(body[50_000_000:],)).start()
        answers = [answer_on(link) for link in links]
    expect(all(status == 201 for status, _ in answers), f"{answers}")
    for link in links:
        link.close()
    whole = most_memory_mb(client)
    print(f"eight uploads of 60 MB: {before:.0f} MB before, {waiting:.0f} MB with all of them in files, {whole:.0f} MB at the most; {stops.count} stops beside them, the longest {1000 * stops.worst_s:.0f} ms")
    expect(stops.count > 20 and stops.worst_s < 2, f"a stop took {stops.worst_s:.2f} s")
    connection = client.connect()
    _, text = exchange(connection, "GET", f"{API}/programs/{json.loads(answers[3][1])['id']}/text", None, {"Authorization": f"Bearer {client.tokens['viewer']}"})
    expect(text.body == json.loads(bodies[3])["text"].encode(), "the text came back as another one")
    expect_gone(client)
    client.server.stop()


def chunked(folder):
    """Without a length: whole, too long, and broken off."""
    client = Client(folder).start()
    headers = JSON | {"Authorization": f"Bearer {client.tokens['programmer']}"}

    def send(pieces):
        connection = client.connect(60)
        with contextlib.suppress(OSError):  # it is refused while it is sent
            connection.request("POST", f"{API}/programs", body=iter(pieces), headers=headers, encode_chunked=True)
        return connection.getresponse()

    body = program("CHUNKED", 3_000_000)
    answer = send([body[n:n + 100_001] for n in range(0, len(body), 100_001)])
    expect(answer.status == 201, f"{answer.status} {answer.read()}")
    answer = send([b"x" * 1_000_000] * 70)
    expect(answer.status == 413, f"70 MB: {answer.status} {answer.read()}")
    answer = send([b"{}"])
    expect(answer.status == 422, f"a short one: {answer.status} {answer.read()}")
    expect_gone(client)
    client.server.stop()


def a_client_that_leaves(folder):
    client = Client(folder).start()
    body = program("LEFT")
    links = [begin_upload(client, body, 20_000_000) for _ in range(4)]
    shop.wait_for("a part of all of them", lambda: len(spooled(client)) == 4)
    for link in links:
        link.close()
    expect_gone(client)
    expect(client.get("/programs")["items"] == [], "half a text was stored")
    client.server.stop()


def a_server_that_is_killed(folder):
    client = Client(folder).start()
    link = begin_upload(client, program("KILLED"), 20_000_000)
    shop.wait_for("a part of it", lambda: sum(spooled(client)) > 15_000_000)
    client.server.kill()
    left = [one for one in (client.server.data / "uploads").rglob("*")]
    expect(left == [], f"left after kill -9: {left}")
    link.close()
    client.server.start()
    expect(client.get("/programs")["items"] == [], "half a text was stored")
    client.server.stop()


def a_full_disk(folder):
    """The data folder on a disk of 340 MB, of which 64 are the reserve and 128 are kept for what feeds book."""
    data = folder / "data"
    data.mkdir()
    if os.geteuid() != 0 or subprocess.run(["mount", "-t", "tmpfs", "-o", "size=340m", "tmpfs", str(data)], capture_output=True).returncode != 0:
        return print("skipped: a full disk (mount needs root)")
    try:
        control, client = HandControl(), Client(folder).start()
        client.post("/machines", hand_profile(control))
        release = client.release(client.add_program()["id"])["id"]
        small = begin_upload(client, program("SMALL", 20_000_000), 15_000_000)
        others = [begin_upload(client, program(f"FULL{n}"), 1_000_000) for n in range(3)]
        answers = []

        def send(link, body):
            with contextlib.suppress(OSError):  # it is refused while it is sent
                link.sendall(body)
            answers.append(answer_on(link))

        with Stops(client) as stops:
            senders = [threading.Thread(target=send, args=(link, program(f"FULL{n}")[1_000_000:])) for n, link in enumerate(others)]
            for one in senders:
                one.start()
            for one in senders:
                one.join()
        full = [body for status, body in answers if status == 507]
        expect(full, f"three of 60 MB had room: {[status for status, _ in answers]}")
        for body in full:
            problem = json.loads(body)
            expect(problem["status"] == 507 and problem["title"] == "no room on the disk" and "no room is left" in problem["detail"], f"{problem}")
        expect(stops.worst_s < 2, f"a stop took {stops.worst_s:.2f} s")
        client.post("/jobs", {"release": release})  # the disk has room for what is not long
        for link in others:
            link.close()
        small.close()
        expect_gone(client)
        client.server.stop()
        control.close()
    finally:
        subprocess.run(["umount", "-l", str(data)], check=False)


def waits_for_disk(pid):
    """Whether the thread of uploads is in a system call that is no wait for work."""
    futex = "202 "  # on x86-64
    for task in pathlib.Path(f"/proc/{pid}/task").iterdir():
        if (task / "comm").read_text().strip() == "http spool":
            return not (task / "syscall").read_text().startswith((futex, "running"))
    return False


def a_disk_that_hangs(folder):
    """The folder of the uploads stops answering: they wait and fail, and no other request notices."""
    if missing := why_not():
        return print(f"skipped: a disk that hangs ({missing})")
    uploads = folder / "data" / "uploads"
    uploads.mkdir(parents=True)
    share = FreezingFolder(uploads)
    try:
        client = Client(folder).start()
        body = program("HANGS", 5_000_000)
        expect(client.call("POST", "/programs", body, headers=JSON).status == 201, "before")
        link = begin_upload(client, body, 3_000_000)
        shop.wait_for("a part of it", lambda: sum(spooled(client)) > 0)
        share.freeze()
        link.sendall(body[3_000_000:4_000_000])
        with Stops(client) as stops:
            others = [begin_upload(client, body, len(body)) for _ in range(3)]
            time.sleep(3)
            for one in others[1:]:
                one.close()  # they leave while the disk hangs
            time.sleep(1)
        expect(stops.count > 100 and stops.worst_s < 1, f"{stops.count} stops, the longest {stops.worst_s:.2f} s")
        status, document = answer_on(others[0])
        expect(status == 507 and "does not answer" in json.loads(document)["detail"], f"{status} {document}")
        share.thaw()
        expect(client.call("POST", "/programs", body, headers=JSON).status == 201, "after")
        share.freeze()
        link = begin_upload(client, body, 3_000_000)
        shop.wait_for("the server to wait for the disk", lambda: waits_for_disk(client.server.process.pid))
        # The server gives the upload up and ends. What the file system has read and does not answer holds its process in the kernel all the same.
        client.server.process.send_signal(signal.SIGTERM)
        log = client.server.data / "server.log"
        shop.wait_for("the end of the server", lambda: not client.server.alive() or "was given up" in log.read_text(), seconds=30)
        share.thaw()
        ended = client.server.process.wait(20)
        expect(ended == 0, f"the server ended with {ended}")
        link.close()
    finally:
        share.close()


if __name__ == "__main__":
    for test in (eight_at_once, chunked, a_client_that_leaves, a_server_that_is_killed, a_full_disk, a_disk_that_hangs):
        in_folder(test)
