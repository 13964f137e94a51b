#!/usr/bin/env python3
"""Chaos: a server with many lines, whose controls are this program's own and count the bytes themselves, is disturbed, killed and started again in an order
that the seed decides. It judges by its own count: no motion starts or resumes by itself, no torn block is completed, nothing is claimed beyond what is known, and no
feed waits for anything but its own line. By hand: tests/bench/chaos.py --seed 1 --scenarios 1000 --binary build/dev/dripfeed"""

import argparse
import pathlib
import random
import signal
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
for folder in ("deploy", "tests/support", "tests/bench"):
    sys.path.insert(0, str(ROOT / folder))
import freezing_folder  # noqa: E402
import own_control  # noqa: E402
from chaos_scenes.disturb import DISTURBANCES, Disturber  # noqa: E402
from chaos_scenes.fed_line import FedLine  # noqa: E402
from chaos_scenes.folder_line import FolderLine  # noqa: E402
from chaos_scenes.judge import RULES, Judge  # noqa: E402
from chaos_scenes.line_scenes import SCENES  # noqa: E402
from chaos_scenes.plc_line import PlcLine  # noqa: E402
from chaos_scenes.served import Served  # noqa: E402

BAUD, FRAMING, BITS = 19200, "7E2", 11
LONGEST_RUN_S = 25.0


def program(blocks, number):
    lines = ["%", f"O{number:04}", "G21 G18 G40 G99", "G55", "T0101", "G97 S500 M03", "G00 X100. Z10."]
    lines += [f"G01 X{50 + i % 7 * 0.1:.3f} Z{-i * 0.05:.3f} F0.2" for i in range(blocks)]
    return "\n".join(lines + ["G00 X100.", "M05", "M30", "%"]) + "\n"


class Chaos:
    def __init__(self, given, folder):
        self.given = given
        self.chance = random.Random(given.seed)
        self.judge = Judge(given.seed)
        self.served = Served(pathlib.Path(given.binary).resolve(), folder / "data")
        self.loop = own_control.ControlLoop()
        self.lines = []
        self.share = None
        scenes = {name: SCENES[name] for name in SCENES if not given.only or given.only in name}
        self.served.start()
        for i in range(given.lines):
            char_s = BITS / BAUD
            is_pty = i % 5 == 4
            control = own_control.PtyControl(self.loop, char_s, folder / f"tty{i}") if is_pty else own_control.TcpControl(self.loop, char_s)
            line = FedLine(f"line{i}", self.loop, self.served, self.judge, control, scenes, given.seed)
            line.add(program(self.chance.randrange(30, 100), 1000 + i), BAUD, FRAMING)
            self.lines.append(line)
        reason = freezing_folder.why_not()
        if reason:
            print(f"no folder line: {reason}")
        elif not given.only:
            self.share = freezing_folder.FreezingFolder(folder / "share")
            line = FolderLine("folder", self.served, self.judge, self.share, given.seed)
            line.add(program(200, 77))
            self.lines.append(line)
        if not given.only:
            line = PlcLine("plc", self.served, self.judge, folder, given.seed)
            line.add(program(600, 88))
            self.lines.append(line)

    def run(self):
        for line in self.lines:
            line.start()
        began = time.monotonic()
        while self.judge.count() < self.given.scenarios:
            self.one_run()
            print(f"run {self.judge.run}: {self.judge.count()} scenes, {len(self.judge.violations)} violations, {time.monotonic() - began:.0f} s ({self.disturbed_by})", flush=True)
        self.served.end(signal.SIGTERM)

    def one_run(self):
        self.judge.run += 1
        self.disturbed_by = ""
        log_is_read = self.judge.run % 4 != 3
        if self.judge.run > 1:
            self.served.start(log_is_read)
            self.acknowledged_is_there()
        disturbs = [] if self.given.only else self.chance.sample(sorted(DISTURBANCES), 2)
        self.disturbed_by = ", ".join([*disturbs, *([] if log_is_read else ["log is not read"])])
        disturbers = [Disturber(self.served, random.Random(self.chance.random()), self.judge, disturbs)] if disturbs else []
        until = time.monotonic() + self.chance.uniform(4, LONGEST_RUN_S)
        while time.monotonic() < until and self.judge.count() < self.given.scenarios:
            time.sleep(0.05)
            if not self.served.shows_life():
                self.judge.violation(4, "all", "+".join(disturbs), f"the server ended by itself with {self.served.process.returncode}")
                break
        self.acknowledged = self.acknowledge()
        lived = self.served.shows_life()
        how = self.chance.choice([signal.SIGKILL, signal.SIGKILL, signal.SIGTERM])
        code = self.served.end(how)
        if lived and how == signal.SIGTERM and code != 0:
            self.judge.violation(4, "all", "SIGTERM", f"the server did not stop in 20 s, or ended with {code}")
        time.sleep(0.3)
        for line in self.lines:
            line.server_died({signal.SIGKILL: "kill -9", signal.SIGTERM: "SIGTERM"}[how])
        for disturber in disturbers:
            disturber.join(70)
        if fault := self.served.verify():
            self.judge.violation(3, "all", "ledger verify", fault)

    def acknowledge(self):
        """The last write before the end: what was acknowledged must be there after the restart."""
        if not self.served.shows_life():
            return None
        try:
            text = f"%\nO0003\n(RUN {self.judge.run})\nM30\n%\n"
            return self.served.post("/programs", {"name": "O0003", "dialect": "fanuc", "text": text}), text
        except Exception as error:  # noqa: BLE001: whatever it was, nothing was acknowledged
            print(f"  nothing acknowledged: {error}")
            return None

    def acknowledged_is_there(self):
        if not self.acknowledged:
            return
        program_, text = self.acknowledged
        status, content = self.served._call("GET", f"/api/v1/programs/{program_['id']}/text", None, {"Authorization": f"Bearer {self.served.token}"}, 30)
        if status != 200 or content.decode() != text:
            self.judge.violation(3, "all", "restart", f"an acknowledged write is lost: program {program_['id']} answers {status}")

    def close(self):
        for line in self.lines:
            line.over.set()
            if isinstance(line, PlcLine) and line.plc:
                line.plc.process.kill()
                line.plc.process.wait()
        self.served.close()
        if self.share:
            self.share.close()
        self.loop.close()


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--scenarios", type=int, default=1000)
    options.add_argument("--binary", default=str(ROOT / "build/dev/dripfeed"))
    options.add_argument("--lines", type=int, default=20)
    options.add_argument("--only", help="play only the scenes whose names contain this")
    options.add_argument("--list", action="store_true", help="print the table of scenes")
    given = options.parse_args()
    if given.list:
        for name, (weight, scene, rule) in SCENES.items():
            print(f"{name:24} weight {weight}  rule {rule}, {RULES[rule]}")
        for name in DISTURBANCES:
            print(f"{name:24}           rule 4, {RULES[4]}")
        return 0
    with tempfile.TemporaryDirectory(prefix="dripfeed-chaos-", ignore_cleanup_errors=True) as folder:
        chaos = Chaos(given, pathlib.Path(folder))
        try:
            chaos.run()
        finally:
            chaos.close()
        held = chaos.judge.report()
        waits = sorted(chaos.served.commands_ms)
        if waits:
            print(f"commands of people: {len(waits)}, median {waits[len(waits) // 2]:.0f} ms, p99 {waits[int(len(waits) * 0.99)]:.0f} ms, worst {waits[-1]:.0f} ms")
        print("the books were verified after each run" if chaos.served.verifies else "this server has no `ledger verify`: its books were not verified")
        return 0 if held else 1


if __name__ == "__main__":
    sys.exit(main())
