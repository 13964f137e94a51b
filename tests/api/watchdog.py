"""What the server reports to the service manager that started it: that it serves, that it stops, and in between a sign of life of the thread of the
lines, which ends with that thread and with no other. The service manager is a socket here; one thread is stopped as a debugger does it."""

import contextlib
import ctypes
import os
import pathlib
import socket
import time

from client import Client, expect, in_folder, shop

WANTED_EVERY_S = 3
SEIZE, INTERRUPT, DETACH, ANY_CHILD = 0x4206, 0x4207, 17, 0x40000000
libc = ctypes.CDLL(None, use_errno=True)


def ptrace(request, thread):
    if libc.ptrace(ctypes.c_long(request), ctypes.c_long(thread), None, None) != 0:
        raise OSError(ctypes.get_errno(), f"ptrace {request:#x} of thread {thread}")


@contextlib.contextmanager
def stopped(thread):
    """That thread alone stands still."""
    ptrace(SEIZE, thread)
    ptrace(INTERRUPT, thread)
    os.waitpid(thread, ANY_CHILD)
    try:
        yield
    finally:
        ptrace(DETACH, thread)


def thread_named(process, name):
    for task in pathlib.Path(f"/proc/{process}/task").iterdir():
        if (task / "comm").read_text().strip() == name:
            return int(task.name)
    raise AssertionError(f"no thread is named {name}")


class Manager:
    """The service manager: a socket that takes notices."""

    def __init__(self, folder):
        self.path = folder / "notify"
        self.socket = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
        self.socket.bind(str(self.path))
        os.environ.update(NOTIFY_SOCKET=str(self.path), WATCHDOG_USEC=str(WANTED_EVERY_S * 1_000_000))

    def close(self):
        for name in ("NOTIFY_SOCKET", "WATCHDOG_USEC"):
            del os.environ[name]
        self.socket.close()

    def next(self, within_s):
        """The next notice, or None."""
        self.socket.settimeout(within_s)
        try:
            return self.socket.recv(256).decode()
        except TimeoutError:
            return None

    def forget(self):
        self.socket.setblocking(False)
        with contextlib.suppress(BlockingIOError):
            while True:
                self.socket.recv(256)

    def lives(self):
        """Whether the next signs of life come as often as asked for."""
        self.forget()
        return all(self.next(WANTED_EVERY_S) == "WATCHDOG=1" for _ in range(3))


def it_reports_what_it_does(folder):
    manager = Manager(folder)
    client = Client(folder).start()
    process = client.server.process.pid
    log = client.server.data / "server.log"
    notices = []
    while "READY=1" not in notices:
        notices.append(manager.next(30))
        expect(notices[-1] is not None, f"it is never ready: {notices}")
    expect(manager.lives(), "no sign of life")

    with stopped(process):
        expect(manager.lives(), "the thread of the lines is at work, and its sign does not come because another thread stands still")

    with stopped(thread_named(process, "lines")):
        time.sleep(0.2)
        manager.forget()
        expect(manager.next(2 * WANTED_EVERY_S) is None, "the lines are not served, and a sign of life comes")
        shop.wait_for("the log to state it", lambda: "the lines have not been served for" in log.read_text())
        expect(client.get("/machines") is not None, "the other threads answer")
    expect(manager.lives(), "no sign of life of lines that are served again")
    shop.wait_for("the log to state it", lambda: "the lines are served again, after" in log.read_text())

    manager.forget()
    client.server.stop()
    notices = []
    while (notice := manager.next(1)) is not None:
        notices.append(notice)
    expect("STOPPING=1" in notices, f"its end: {notices}")
    manager.close()


def no_service_manager(folder):
    """A socket that is gone, and a name that is none, keep no server from its start."""
    for name in (str(folder / "gone"), "nonsense", "@" + "x" * 300):
        os.environ["NOTIFY_SOCKET"] = name
        client = Client(folder / str(len(name))).start()
        expect(client.get("/machines") is not None, name)
        client.server.stop()
    del os.environ["NOTIFY_SOCKET"]


if __name__ == "__main__":
    for test in (it_reports_what_it_does, no_service_manager):
        in_folder(test)
