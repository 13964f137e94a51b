"""A log that no process reads: the server's standard error is a pipe that is full. A feed goes through, the API answers, what did not fit is dropped
and counted, the count is in the log once it is read again; and a server with such a pipe ends in time."""

import fcntl
import os
import pty
import re
import select
import signal
import threading
import time

from rig import Rig, expect, in_folder

FILLER = b"#"


def fill(write):
    """The pipe takes nothing more."""
    flags = fcntl.fcntl(write, fcntl.F_GETFL)
    fcntl.fcntl(write, fcntl.F_SETFL, flags | os.O_NONBLOCK)
    for size in (4096, 1):
        try:
            while True:
                os.write(write, FILLER * size)
        except BlockingIOError:
            pass
    fcntl.fcntl(write, fcntl.F_SETFL, flags)  # the server writes to the same open pipe, and blocks


def lines_of(server, count):
    """Has the server log so many lines: signals of this kind are queued by the system, and each is named in the log."""
    for n in range(count):
        server.process.send_signal(signal.SIGRTMIN + 5)
        if n % 500 == 499:
            time.sleep(0.05)


def full_pipe(folder, blocks):
    rig = Rig(folder, f"pty:{folder}/lathe.tty", blocks=blocks)
    read, write = os.pipe()
    fill(write)
    rig.server.stderr = write
    rig.start()
    os.close(write)
    return rig, read


def a_feed_needs_no_reader_of_the_log(folder):
    rig, read = full_pipe(folder, blocks=150)
    control = rig.control("--speed", "1000")
    job = rig.arm_new_job()
    rig.server.wait_job(job, "feeding", "held")
    lines_of(rig.server, 6000)
    expect(rig.server.wait_job(job, "done", "failed", "interrupted")["state"] == "done", "the feed did not get through")
    expect(control.finish(30)["alarm"] is None, "the control raised an alarm")

    log = bytearray()

    def drain():
        while chunk := os.read(read, 65536):
            log.extend(chunk)

    reader = threading.Thread(target=drain)
    reader.start()
    time.sleep(0.5)
    rig.server.stop()
    reader.join(10)
    said = log.lstrip(FILLER).decode()
    dropped = re.findall(r"(\d+) lines of the log were dropped here", said)
    signals = said.count("signal")
    expect(len(dropped) >= 1 and sum(map(int, dropped)) > 1000, f"no count of what was dropped: {said[:400]}")
    expect(sum(map(int, dropped)) + said.count("\n") - len(dropped) >= 6000, f"{dropped} dropped, {signals} lines were logged: something is not counted")
    expect(f"job {job}" in said or sum(map(int, dropped)) > 0, "the log lost the job without a count")


def a_stopped_terminal_stops_no_feed(folder):
    """Ctrl-S at the server's terminal, and Ctrl-Q after the feed."""
    rig = Rig(folder, f"pty:{folder}/lathe.tty", blocks=60)
    keyboard, terminal = pty.openpty()
    os.write(keyboard, b"\x13")
    rig.server.stderr = terminal
    rig.start()
    control = rig.control("--speed", "1000")
    job = rig.arm_new_job()
    expect(rig.server.wait_job(job, "done", "failed", "interrupted")["state"] == "done", "the feed did not get through")
    expect(control.finish(30)["alarm"] is None, "the control raised an alarm")
    expect(not select.select([keyboard], [], [], 0.3)[0], "the terminal was not stopped: nothing is tested")
    os.write(keyboard, b"\x11")
    time.sleep(0.5)
    said = os.read(keyboard, 65536).decode()
    expect(f"job {job}" in said, f"the log did not go on: {said}")
    rig.server.stop()


def a_server_ends_although_its_log_hangs(folder):
    rig, read = full_pipe(folder, blocks=20)
    since = time.monotonic()
    rig.server.stop()
    took = time.monotonic() - since
    expect(took < 5.0, f"it took {took:.1f} s")
    os.close(read)


if __name__ == "__main__":
    for test in [a_feed_needs_no_reader_of_the_log, a_stopped_terminal_stops_no_feed, a_server_ends_although_its_log_hangs]:
        in_folder(test)
