#!/usr/bin/env python3
"""What comes after a control's DC3 while the machine is busy: feeds over TCP whose controls are this program's own, while so many busy loops run, with the links'
thread at real-time priority and without. Counted by the kernel's time of arrival and on line time, as a UART would see it. Shown are the worst and 99th percentile
of characters after DC3 against the budget, and what the lines lost of their time. By hand: tests/bench/overrun_under_load.py build/dev/dripfeed [--feeds 8]
[--busy 0 4 8] [--seconds 6] [--quota 20] [--page-out]"""

import argparse
import ctypes
import multiprocessing
import os
import pathlib
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
for folder in ("deploy", "tests/support"):
    sys.path.insert(0, str(ROOT / folder))
import own_control  # noqa: E402
import shop  # noqa: E402

BAUD, FRAMING, BITS = 9600, "7E2", 11
UNSENT, LATENCY, BUDGET = 3, 5, 10
WITHOUT_PRIORITY = ["setpriv", "--bounding-set=-sys_nice", "--inh-caps=-sys_nice", "prlimit", "--rtprio=0", "--nice=0"]
CGROUP = pathlib.Path("/sys/fs/cgroup/cpu/dripfeed-bench")
PROCESS_MADVISE, PIDFD_OPEN, MADV_PAGEOUT = 440, 434, 21


class Counting(own_control.TcpControl):
    """Says DC3 now and then; counts what arrives on line time after it."""

    def __init__(self, loop):
        super().__init__(loop, BITS / BAUD)
        self.line_at = 0.0
        self.stopped_at = None
        self.after = []
        self.late = 0

    def took(self, data, at):
        super().took(data, at)
        for _ in data:
            self.line_at = max(at, self.line_at + self.char_s)
            if self.stopped_at and self.line_at > self.stopped_at:
                self.late += 1

    def stop(self):
        with self.loop.lock:
            self.hold()
            self.stopped_at, self.late = time.time(), 0

    def go(self):
        with self.loop.lock:
            self.after.append(self.late)
            self.stopped_at = None
            self.start()


def program(characters):
    lines = ["%", "O0001", "G21 G18 G40 G99", "G55", "T0101", "G97 S500 M03", "G00 X100. Z10."]
    size = 0
    while size < characters:
        lines.append(f"G01 X{50 + len(lines) % 7 * 0.1:.3f} Z{-len(lines) * 0.02:.3f} F0.2")
        size += len(lines[-1]) + 1
    return "\n".join(lines + ["M30", "%"]) + "\n"


def spin():
    os.sched_setscheduler(0, os.SCHED_OTHER, os.sched_param(0))
    while True:
        pass


def page_out(process):
    """The system takes the process's pages away, as it does when memory is short."""
    libc = ctypes.CDLL(None, use_errno=True)
    file = libc.syscall(PIDFD_OPEN, process, 0)
    spans = []
    for line in pathlib.Path(f"/proc/{process}/maps").read_text().splitlines():
        begin, end = (int(part, 16) for part in line.split()[0].split("-"))
        if not line.endswith(("[vsyscall]", "[vvar]", "[vdso]", "[vvar_vclock]")):
            spans.append((begin, end - begin))
    for begin, length in spans:
        vector = (ctypes.c_size_t * 2)(begin, length)
        libc.syscall(PROCESS_MADVISE, file, ctypes.byref(vector), ctypes.c_size_t(1), MADV_PAGEOUT, 0)
    os.close(file)


def limit(process, percent):
    CGROUP.mkdir(exist_ok=True)
    (CGROUP / "cpu.cfs_period_us").write_text("100000")
    (CGROUP / "cpu.cfs_quota_us").write_text(str(percent * 1000))
    for task in os.listdir(f"/proc/{process}/task"):
        try:
            (CGROUP / "tasks").write_text(task)
        except OSError as error:  # a real-time thread where the group has no real-time share
            print(f"thread {task} stays outside the group: {error.strerror}")


def faults(process):
    fields = pathlib.Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()
    return int(fields[9])


def measure(given, folder, prefix, busy):
    loop = own_control.ControlLoop()
    controls = [Counting(loop) for _ in range(given.feeds)]
    wrapper = folder / "served"
    wrapper.write_text("#!/bin/sh\nexec chrt --other 0 " + " ".join([*prefix, str(pathlib.Path(given.binary).resolve())]) + ' "$@"\n')
    wrapper.chmod(0o755)
    server = shop.Server(wrapper, folder / "data").start()
    spinners = []
    try:
        program_id = server.post("/programs", {"name": "O0001", "dialect": "fanuc", "text": program(int((given.seconds + 2) * BAUD / BITS))})["id"]
        for i, control in enumerate(controls):
            profile = shop.preset("fanuc-0i-lathe", url=control.url(), baud=BAUD, framing=FRAMING, unsent=UNSENT, latency_chars=LATENCY, overrun_budget=BUDGET)
            profile["name"] = f"m{i}"
            server.add_machine(profile)
            server.post("/checks", {"program": program_id, "machine": f"m{i}", "delivery": "drip"})
            release = server.release(program_id, f"m{i}")
            server.wait_line(f"m{i}", "idle")
            server.post(f"/jobs/{server.post('/jobs', {'release': release['id']})['id']}/arm", {})
        if given.quota:
            limit(server.process.pid, given.quota)
        spinners = [multiprocessing.Process(target=spin, daemon=True) for _ in range(busy)]
        for spinner in spinners:
            spinner.start()
        before = faults(server.process.pid)
        began = time.time()
        for control in controls:
            control.start()
        until = began + given.seconds
        while time.time() < until:
            if given.page_out:
                page_out(server.process.pid)
            for control in controls:
                control.stop()
            time.sleep(0.05)
            for control in controls:
                control.go()
            time.sleep(0.15)
        after = sorted(count for control in controls for count in control.after)
        delays = sorted(delay for control in controls for delay in control.delays)
        major = faults(server.process.pid) - before
        scheduled = [line.split("the lines are served ")[1].split("\x1b")[0] for line in (folder / "data/server.log").read_text().splitlines() if "the lines are served" in line]
        print(f"{busy:5} {(scheduled or ['?'])[-1].strip():28} {len(after):6} {after[int(len(after) * 0.99)]:5} {after[-1]:6} of {BUDGET} "
              f"{delays[int(len(delays) * 0.99)] * 1000:8.1f} {delays[-1] * 1000:8.1f} {major:8}  load {os.getloadavg()[0]:.1f}", flush=True)
        return after[-1]
    finally:
        for spinner in spinners:
            spinner.terminate()
        server.process.kill()
        server.process.wait()
        loop.close()
        if given.quota:
            CGROUP.rmdir()


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("binary")
    options.add_argument("--feeds", type=int, default=8)
    options.add_argument("--busy", type=int, nargs="*", default=[0, 4, 8])
    options.add_argument("--seconds", type=float, default=6)
    options.add_argument("--quota", type=int, help="percent of a processor that a control group leaves the server")
    options.add_argument("--page-out", action="store_true", help="take the server's pages away five times a second")
    given = options.parse_args()
    # The counting must not be late itself: what is read late has the time of its last piece. All threads of this process inherit it.
    if os.geteuid() == 0:
        os.sched_setscheduler(0, os.SCHED_RR, os.sched_param(2))
    print(" busy links' thread                holds   p99  worst         late p99    worst ms  major faults")
    worst = 0
    for prefix in ([], WITHOUT_PRIORITY):
        for busy in given.busy:
            with tempfile.TemporaryDirectory(prefix="overrun-") as folder:
                worst = max(worst, measure(given, pathlib.Path(folder), prefix, busy))
    return 0 if worst <= BUDGET else 1


if __name__ == "__main__":
    sys.exit(main())
