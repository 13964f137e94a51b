"""A PLC's view by mbpoll: the job status of a running server and the registers of a simulated PLC are read, a write is refused, a foreign unit is not
answered for; a program reaches the PLC by `dripfeed send`,
and by a server that is killed again and again."""

import os
import random
import re
import subprocess
import sys
import time
import zlib

from rig import Rig, binary, expect, in_folder, verify
import shop

MAGIC = 0xDF02
IDLE = 1
KILLS = int(os.environ.get("DRIPFEED_KILLS", "5"))  # more by hand
SEED = 7


def mbpoll(port, *arguments, unit=1, write=()):
    command = ["mbpoll", "-m", "tcp", "-a", str(unit), "-p", str(port), "-0", "-1", "-o", "2", *map(str, arguments), "127.0.0.1", *map(str, write)]
    return subprocess.run(command, capture_output=True, text=True, timeout=30)


def registers(port, first, count, table="4:hex", unit=1):
    done = mbpoll(port, "-t", table, "-r", first, "-c", count, unit=unit)
    expect(done.returncode == 0, f"mbpoll: {done.stdout[-500:]}{done.stderr[-500:]}")
    values = [int(value, 16) for value in re.findall(r"^\[\d+\]:\s+0x([0-9A-Fa-f]{4})", done.stdout, re.M)]
    expect(len(values) == count, f"{count} registers asked for: {done.stdout}")
    return values


def refused(done, words):
    said = done.stdout + done.stderr
    expect(words in said, f"not refused: {said[-500:]}")


def status_is_read(folder):
    port = shop.free_port()
    rig = Rig(folder, f"pty:{folder}/lathe.tty", blocks=400)
    rig.server.arguments += ["--modbus-listen", f"127.0.0.1:{port}", "--modbus-unit", "lathe=7"]
    rig.start()
    control = rig.control("--speed", "2000")
    rig.server.wait_line("lathe", "idle")
    shop.wait_for("the idle line in the registers", lambda: registers(port, 3, 1, unit=7)[0] == IDLE)
    all_of_it = registers(port, 0, 37, unit=7)
    expect(all_of_it[0] == MAGIC and all_of_it[1] == 1, f"magic and version are {all_of_it[:2]}")
    name = b"".join(word.to_bytes(2, "big") for word in all_of_it[21:]).rstrip(b"\0").decode()
    expect(name == "lathe", f"the machine is named {name}")
    expect(registers(port, 0, 2, table="3:hex", unit=7) == [MAGIC, 1], "input registers are the holding registers")
    refused(mbpoll(port, "-t", "4", "-r", 3, unit=7, write=[5]), "Illegal function")
    refused(mbpoll(port, "-t", "4:hex", "-r", 36, "-c", 2, unit=7), "Illegal data address")
    refused(mbpoll(port, "-t", "4:hex", "-r", 0, "-c", 1, unit=8), "Target device failed to respond")

    job = rig.arm_new_job()
    rig.server.wait_job(job, "feeding", "held", "draining", "done")
    shop.wait_for("the job in the registers", lambda: registers(port, 6, 2, unit=7) == [job >> 16, job & 0xFFFF])
    control.finish()
    rig.server.wait_job(job, "done")
    end, total, handed = 0, 0, 1
    def ended():
        nonlocal end, total, handed
        words = registers(port, 5, 7, unit=7)
        end, total, handed = words[0], words[3] << 16 | words[4], words[5] << 16 | words[6]
        return end == 1
    shop.wait_for("the end in the registers", ended)
    trailer = rig.profile["link"]["trailer"]  # the control may end the reading inside it
    expect(400 < total - trailer <= handed <= total, f"{handed} of {total} bytes handed")
    rig.server.stop()


def plc_registers_are_read(folder):
    port = shop.free_port()
    rig = Rig(folder, f"modbus-tcp://127.0.0.1:{port}/1")
    record = folder / "plc.txt"
    plc = shop.Control(binary(), f"modbus-tcp://127.0.0.1:{port}/1", rig.machine, "--speed", "100000", "--repeat", "--record", record).start()
    shop.wait_for("the PLC", lambda: shop.listens(port))
    words = registers(port, 128, 19)
    expect(words[0] == 0xDF01 and words[3] == 1, f"the PLC's status is {words[:4]}")
    program = folder / "long.nc"
    program.write_text(rig.text)
    sent = subprocess.run([str(binary()), "send", str(program), "--link", f"modbus-tcp://127.0.0.1:{port}/1", "--unreleased", "--ledger",
                           str(folder / "ledger")], capture_output=True, text=True, timeout=60)
    expect(sent.returncode == 0, f"send: {sent.stderr}")
    words = registers(port, 128, 19)
    expect(words[13] << 16 | words[14] == len(rig.text), f"the PLC has {words[13] << 16 | words[14]} of {len(rig.text)} bytes")
    plc.stop()
    expect(record.read_text() == rig.text, "the PLC's text is not the program")


def server_is_killed(folder):
    """Whenever the server dies, the PLC holds the first bytes of the program, once and in order; the last job brings all of it."""
    port = shop.free_port()
    rig = Rig(folder, f"modbus-tcp://127.0.0.1:{port}/1", blocks=4000)
    record = folder / "plc.txt"
    plc = shop.Control(binary(), rig.url, rig.machine, "--speed", "1000", "--repeat", "--record", record).start()
    shop.wait_for("the PLC", lambda: shop.listens(port))
    rig.start()
    chance = random.Random(SEED)
    for turn in range(KILLS):
        job = rig.arm_new_job()
        rig.server.wait_job(job, "feeding", "draining", "done")
        time.sleep(chance.uniform(0.05, 0.6))
        rig.server.kill()
        verify(rig.server.data)
        words = registers(port, 128, 19)
        size, crc = words[13] << 16 | words[14], words[15] << 16 | words[16]
        expect(zlib.crc32(rig.text[:size].encode()) == crc, f"turn {turn}: the PLC's {size} bytes are not the program's first")
        rig.server.start()
        if rig.server.job(job)["needs_confirmation"]:
            rig.server.post("/machines/lathe/confirm-reset", {"reason": "the PLC was reset"})
        print(f"turn {turn}: {size} of {len(rig.text)} bytes at the PLC", flush=True)
    job = rig.arm_new_job()
    rig.server.wait_job(job, "done")
    rig.server.stop()
    plc.stop()
    expect(record.read_text() == rig.text, "the PLC's text is not the program")


if __name__ == "__main__":
    in_folder(server_is_killed)
    in_folder(status_is_read)
    in_folder(plc_registers_are_read)
    sys.exit(0)
