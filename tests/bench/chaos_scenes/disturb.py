"""What goes on while the lines feed: large uploads, clients that vanish, checks that eat memory, SIGHUP. Each runs in a thread of its own while a run of the server
lasts; that the server is gone ends it."""

import json
import os
import signal
import socket
import threading
import time

import shop

from chaos_scenes.served import ServerGone

LARGE_BYTES = 60_000_000


def large_program():
    block = "G01 X10. Y10. F500.\n"
    return json.dumps({"name": "O0001", "dialect": "fanuc", "text": "%\nO0001\n" + block * (LARGE_BYTES // len(block)) + "M30\n%\n"}).encode()


LARGE = large_program()  # made before the first run: it would keep this process from everything else


def upload(served, chance, judge, **headers):
    served.post("/programs", LARGE, timeout=60, **headers)


def upload_once(served, chance, judge):
    """60 MB; the server answers for it by the key, however often it is sent."""
    upload(served, chance, judge, Idempotency_Key=f"large-{chance.randrange(1 << 60)}")


def vanish(served, chance, judge):
    """Clients that go in the middle of what they say, or say nothing."""
    opened = []
    for _ in range(chance.randrange(5, 40)):
        client = socket.create_connection(("127.0.0.1", served.port), 5)
        request = b"POST /api/v1/programs HTTP/1.1\r\nHost: x\r\nContent-Length: 5000000\r\n\r\n" + b"{" * 3000
        client.sendall(request[:chance.randrange(len(request))])
        opened.append(client)
    time.sleep(chance.uniform(0, 0.5))
    for client in opened:
        if chance.random() < 0.5:
            client.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, b"\1\0\0\0\0\0\0\0")
        client.close()


def hungry_check(served, chance, judge):
    """A block of some megabytes: what it needs is many times its length."""
    text = "%\nO0002\n" + "G01X1." * 300_000 + "\nM30\n%\n"
    program = served.post("/programs", {"name": "O0002", "dialect": "fanuc", "text": text}, timeout=60)
    served.post("/checks", {"program": program["id"], "machine": "line0", "delivery": "drip"}, timeout=60)


def hang_up(served, chance, judge):
    served.signal(signal.SIGHUP)
    time.sleep(0.3)
    if served.up.is_set() and not served.shows_life():
        judge.violation(4, "all", "SIGHUP", "the server died of it")


def disk_full(served, chance, judge):
    """Nothing more fits on the disk of the store, for a moment. Only where the store has a file system of its own."""
    if not served.own_disk:
        return
    filler = served.data / "filler"
    with open(filler, "wb") as file:
        free = os.statvfs(served.data)
        try:
            os.posix_fallocate(file.fileno(), 0, max(1, (free.f_bavail - chance.randrange(3)) * free.f_frsize))
        except OSError:
            pass  # another process took the last of it
        time.sleep(chance.uniform(0.3, 2.0))
    filler.unlink()
    until = time.monotonic() + 12  # as long as nothing new begins
    while served.up.is_set() and time.monotonic() < until:
        time.sleep(0.1)


DISTURBANCES = {"upload of 60 MB": upload, "upload with a key": upload_once, "clients vanish": vanish, "check of one large block": hungry_check, "SIGHUP": hang_up,
                "disk full": disk_full}


class Disturber(threading.Thread):
    """One disturbance after the other until the run is over."""

    def __init__(self, served, chance, judge, among):
        super().__init__(daemon=True)
        self.served, self.chance, self.judge, self.among = served, chance, judge, among
        self.start()

    def run(self):
        generation = self.served.generation
        while self.served.up.is_set() and self.served.generation == generation:
            name = self.chance.choice(self.among)
            try:
                DISTURBANCES[name](self.served, self.chance, self.judge)
                outcome = "ended"
            except shop.Refused as refused:
                outcome = "refused"
                self.judge.refused(f"{name}: {str(refused)[:150]}")
            except (ServerGone, OSError):
                outcome = "broken off"
                (self.served.data / "filler").unlink(missing_ok=True)
            self.judge.scene(name, outcome)
            time.sleep(self.chance.uniform(0.2, 2.0))
