"""A PLC's machine words and doorbell with the real binary at both ends and mbpoll as the person at the PLC: state, alarm and stall are shown, a ring is
acted on once and answered, also over restarts; and the same registers over RTU on pseudo-terminals, with faults."""

import subprocess
import sys
import time

from modbus_status import mbpoll, registers
from rig import Rig, binary, expect, in_folder, plain_program, verify
import shop

ANSWER, WORDS, PANEL, BELL = 121, 147, 192, 195
ARMED, QUEUED, ANSWERED, REFUSED = 2, 3, 1, 4
LOAD, DRIP, CALL, PARTS, SCRAP = 1, 2, 4, 5, 6
NOT_ALLOWED, NO_ORDER = 4, 8


def poke(port, first, *values):
    done = mbpoll(port, "-t", "4", "-r", first, write=values)
    expect(done.returncode == 0, f"mbpoll: {done.stdout[-500:]}{done.stderr[-500:]}")


def answer_to(port, count, seconds=10.0):
    """Outcome, reason and job of the answer to this ring."""
    def answered():
        words = registers(port, ANSWER, 7)
        return (words[1], words[2], words[3] << 16 | words[4]) if words[0] == count else None
    return shop.wait_for(f"the answer to ring {count}", answered, seconds)


def ring(port, count, request, program=0):
    poke(port, BELL, request, program >> 16, program & 0xFFFF, count)
    return answer_to(port, count)


def plc_of(rig, *expected):
    return shop.wait_for(f"the machine to be {expected}", lambda: (lambda plc: plc if plc and plc["state"] in expected else None)(rig.server.status("lathe")["plc"]))


def requests(rig):
    return [(row["verb"], row["outcome"]) for row in rig.server.get("/requests")["items"]]


def words_and_doorbell(folder):
    port = shop.free_port()
    rig = Rig(folder, f"modbus-tcp://127.0.0.1:{port}/1?poll_ms=100", blocks=300)
    rig.profile["receive"] = {"remote_drip": True}
    record = folder / "plc.txt"
    plc = shop.Control(binary(), rig.url, rig.machine, "--speed", "100000", "--repeat", "--record", record).start()
    shop.wait_for("the PLC", lambda: shop.listens(port))
    rig.start()
    program = rig.server.get("/programs?name=O0042")["items"][0]["id"]
    rig.server.post("/checks", {"program": program, "machine": "lathe", "delivery": "memory"})
    rig.server.release(program, "lathe", "memory")
    plc_of(rig, "idle")

    poke(port, PANEL, 4, 0, 1010)
    expect(plc_of(rig, "alarm")["alarm"] == 1010, f"{rig.server.status('lathe')}")
    poke(port, PANEL, 0, 0, 0)
    plc_of(rig, "idle")
    expect("machine alarm 1010" in (folder / "data/server.log").read_text(), "the alarm is not in the log")

    outcome, reason, job = ring(port, 1, LOAD, 42)
    expect((outcome, reason) == (ARMED, 0), f"load: {outcome}, {reason}")
    rig.server.wait_job(job, "done")
    expect(rig.server.job(job)["armed_by"] == "operator at lathe", f"{rig.server.job(job)}")
    outcome, reason, job = ring(port, 2, DRIP, 42)
    expect((outcome, reason) == (QUEUED, 0) and rig.server.job(job)["state"] == "queued", f"drip: {outcome}, {reason}")
    machine_that_stands(rig, port, job)
    expect(ring(port, 3, LOAD, 4711)[:2] == (REFUSED, 1), "an unknown program is not refused")
    expect(ring(port, 4, CALL)[:2] == (ANSWERED, 0), "a call is not answered")
    asked = requests(rig)
    expect(asked == [("call", "answered"), ("load", "refused"), ("drip", "queued"), ("load", "armed")], f"{asked}")
    restarts(rig, port, asked)
    rig.server.stop()
    plc.stop()
    expect(record.read_text() == rig.text, "the PLC's text is not the program")


def parts_by_doorbell(folder):
    port = shop.free_port()
    rig = Rig(folder, f"modbus-tcp://127.0.0.1:{port}/1?poll_ms=100", blocks=20)
    plc = shop.Control(binary(), rig.url, rig.machine, "--speed", "100000", "--repeat").start()
    shop.wait_for("the PLC", lambda: shop.listens(port))
    rig.start()
    order = rig.server.post("/orders", {"number": "4711", "part": "HUB-12", "quantity": 10})["id"]
    plc_of(rig, "idle")
    expect(ring(port, 1, PARTS, 7) == (REFUSED, NO_ORDER, 0), "parts of nothing are counted")
    job = rig.server.post("/jobs", {"release": rig.release["id"], "order": order})["id"]
    rig.server.wait_line("lathe", "idle")
    rig.server.post(f"/jobs/{job}/arm", {})
    rig.server.wait_job(job, "done")
    expect(ring(port, 2, PARTS, 7) == (ANSWERED, 0, job), f"{requests(rig)}")
    expect(ring(port, 3, SCRAP, 1) == (ANSWERED, 0, job), f"{requests(rig)}")
    expect(ring(port, 4, PARTS, 0)[:2] == (REFUSED, NOT_ALLOWED) and ring(port, 5, PARTS, 1 << 20)[:2] == (REFUSED, NOT_ALLOWED), f"{requests(rig)}")
    now = rig.server.get(f"/orders/{order}")
    expect((now["good"], now["scrap"]) == (7, 1), f"{now}")
    rig.server.post(f"/orders/{order}/move", {"to": "cancelled", "reason": "not wanted any more"})
    expect(ring(port, 6, PARTS, 1)[:2] == (REFUSED, NO_ORDER), "a cancelled order takes parts")
    rig.server.stop()
    plc.stop()


def machine_that_stands(rig, port, job):
    """A held machine is a named stall of the transfer, in the status and in the ledger."""
    poke(port, PANEL, 3)
    plc_of(rig, "held")
    rig.server.post(f"/jobs/{job}/arm", {})
    shop.wait_for("the stall", lambda: rig.server.status("lathe")["stall"] == "machine held")
    poke(port, PANEL, 0)
    rig.server.wait_job(job, "done")
    notes = [row["note"] for row in rig.server.get(f"/jobs/{job}/ledger")["items"]]
    expect(any("machine held" in note for note in notes), f"{notes}")


def restarts(rig, port, asked):
    """What was answered stays answered, what was rung while no server was there is missed, and the next ring counts."""
    rig.server.kill()
    verify(rig.server.data)
    rig.server.start()
    plc_of(rig, "idle", "running")
    time.sleep(0.5)
    expect(requests(rig) == asked, f"asked again: {requests(rig)}")
    expect(answer_to(port, 4)[0] == ANSWERED, "the answer changed")
    rig.server.kill()
    verify(rig.server.data)
    poke(port, BELL, CALL, 0, 0, 5)
    rig.server.start()
    expect(answer_to(port, 5)[:2] == (REFUSED, 6), "a ring that no one saw come is not missed")
    expect(requests(rig) == asked, f"acted on: {requests(rig)}")
    shop.wait_for("the missed ring to be reported", lambda: "doorbell 5 was missed" in (rig.server.status("lathe")["link_note"] or ""))
    expect(ring(port, 6, CALL)[:2] == (ANSWERED, 0), "the next ring does not count")


def send(folder, url, text):
    program = folder / "program.nc"
    program.write_text(text)
    return subprocess.run([str(binary()), "send", str(program), "--link", url, "--unreleased", "--ledger", str(folder / f"{time.monotonic_ns()}.ledger")],
                          capture_output=True, text=True, timeout=120)


def send_names_the_alarm(folder):
    """Without a server: the machine's alarm holds the transfer up, and the command and its ledger say so."""
    port = shop.free_port()
    url = f"modbus-tcp://127.0.0.1:{port}/1"
    record = folder / "plc.txt"
    plc = shop.Control(binary(), url, "fanuc-0i-lathe", "--speed", "100000", "--repeat", "--record", record).start()
    shop.wait_for("the PLC", lambda: shop.listens(port))
    poke(port, PANEL, 4, 0, 504)
    text = plain_program(1500)  # more than its buffer
    (folder / "program.nc").write_text(text)
    ledger = folder / "ledger"
    said = open(folder / "said", "w")
    sending = subprocess.Popen([str(binary()), "send", str(folder / "program.nc"), "--link", url, "--unreleased", "--ledger", str(ledger)], stderr=said)
    said.close()
    shop.wait_for("the alarm", lambda: "dripfeed: machine alarm 504" in (folder / "said").read_text())
    shop.wait_for("the stall", lambda: "dripfeed: machine alarm\n" in (folder / "said").read_text())
    expect(sending.poll() is None, "it ended at the alarm")
    poke(port, PANEL, 0)
    expect(sending.wait(60) == 0, (folder / "said").read_text())
    expect("machine alarm 504" in ledger.read_text(), ledger.read_text())
    plc.stop()
    expect(record.read_text() == text, "the PLC's text is not the program")


def rtu_with_faults(folder):
    text = plain_program(400)
    url = f"modbus-rtu:{folder}/plc?unit=3&timeout_ms=100"
    record = folder / "plc.txt"
    faults = [f"--fault={name}={every}" for name, every in [("plc-lose", 7), ("plc-silent", 11), ("plc-busy", 13), ("plc-damage", 17)]]
    plc = shop.Control(binary(), url, "fanuc-0i-lathe", "--speed", "100000", "--repeat", "--record", record, *faults).start()
    shop.wait_for("the PLC's line", (folder / "plc").is_symlink)
    sent = send(folder, url, text)
    expect(sent.returncode == 0, f"send: {sent.stderr}")
    plc.stop()
    expect(record.read_text() == text, "the PLC's text is not the program")
    plc = shop.Control(binary(), url, "fanuc-0i-lathe", "--speed", "100000", "--repeat", "--record", record, "--fault", "plc-restart=20").start()
    shop.wait_for("the PLC's line", (folder / "plc").is_symlink)
    sent = send(folder, url, text)
    expect(sent.returncode == 1 and "receiver_restarted" in sent.stderr, f"a restarted PLC: {sent.returncode}, {sent.stderr}")
    plc.stop()
    expect(text.startswith(record.read_text()), "the PLC's text is not the program's beginning")


def rtu_through_a_pair(folder):
    """socat's pseudo-terminals as the line: mbpoll reads the words at the one end, then a program follows on the same line."""
    ends = [folder / "host", folder / "machine"]
    pair = subprocess.Popen(["socat", *[f"pty,rawer,link={end}" for end in ends]])
    try:
        shop.wait_for("the pair", lambda: all(end.exists() for end in ends))
        record = folder / "plc.txt"
        plc = shop.Control(binary(), f"modbus-rtu:{ends[1]}?unit=9", "fanuc-0i-lathe", "--speed", "100000", "--repeat", "--record", record).start()
        command = ["mbpoll", "-m", "rtu", "-b", "19200", "-P", "even", "-a", "9", "-0", "-1", "-t", "4:hex", "-r", str(WORDS), "-c", "2", str(ends[0])]
        shop.wait_for("the words", lambda: "0xDF03" in subprocess.run(command, capture_output=True, text=True, timeout=30).stdout)
        text = plain_program(200)
        sent = send(folder, f"modbus-rtu:{ends[0]}?unit=9", text)
        expect(sent.returncode == 0, f"send: {sent.stderr}")
        plc.stop()
        expect(record.read_text() == text, "the PLC's text is not the program")
    finally:
        pair.terminate()
        pair.wait()


def four_units_on_a_line(folder):
    """Four machines share one RTU line; the fourth is not there. The others get their programs at the same time, and its job fails by name."""
    url = f"modbus-rtu:{folder}/line?timeout_ms=200&unit="
    record = folder / "plc.txt"
    rig = Rig(folder, url + "1", blocks=300)
    plc = shop.Control(binary(), rig.url, rig.machine, "--count", "3", "--speed", "100000", "--repeat", "--record", record).start()
    shop.wait_for("the PLCs' line", (folder / "line").is_symlink)
    rig.start()
    program = rig.server.get("/programs?name=O0042")["items"][0]["id"]
    jobs = [rig.server.post("/jobs", {"release": rig.release["id"]})["id"]]
    for unit in range(2, 5):
        name = f"press{unit}"
        rig.server.add_machine({**rig.profile, "name": name, "link": {**rig.profile["link"], "url": f"{url}{unit}"}})
        rig.server.post("/checks", {"program": program, "machine": name, "delivery": "drip"})
        jobs.append(rig.server.post("/jobs", {"release": rig.server.release(program, name)["id"]})["id"])
    rig.server.wait_line("press4", "disconnected")
    for job in jobs:
        rig.server.post(f"/jobs/{job}/arm", {})
    for job in jobs[:3]:
        rig.server.wait_job(job, "done")
    reason = rig.server.wait_job(jobs[3], "failed")["reason"]
    expect(reason.startswith("peer_gone"), reason)
    rig.server.stop()
    plc.stop()
    for unit in range(1, 4):
        expect((folder / f"plc.txt-{unit}").read_text() == rig.text, f"the text of unit {unit} is not the program")


if __name__ == "__main__":
    in_folder(words_and_doorbell)
    in_folder(parts_by_doorbell)
    in_folder(send_names_the_alarm)
    in_folder(rtu_with_faults)
    in_folder(rtu_through_a_pair)
    in_folder(four_units_on_a_line)
    sys.exit(0)
