"""Simulated controls in one process and faults by name, with `dripfeed send` as their host: three at a time, one program in two rounds, a flipped
parity bit, and a cable that is out for two seconds."""

import json
import os
import select
import subprocess
import time

from rig import binary, expect, in_folder, plain_program, shop
from torn_send import DC1


def prepare(folder, blocks):
    profile = shop.preset("fanuc-0i-lathe", baud=38400, framing="7E2", end_by_quiet_s=2.0, url="pty:/dev/null")
    profile["buffer"]["bytes"] = 1024
    (folder / "m.json").write_text(json.dumps(profile))
    (folder / "p.nc").write_text(plain_program(blocks))


def send(folder, link, *arguments):
    command = [binary(), "send", folder / "p.nc", "--link", link, "--machine", folder / "m.json", "--unreleased", "--json", "--ledger",
               folder / f"{os.path.basename(link)}.ledger", *arguments]
    return subprocess.Popen(list(map(str, command)), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def simulate(folder, last, *arguments):
    control = shop.Control(binary(), f"pty:{folder}/line", folder / "m.json", "--speed", "100", "--operator", "0.5", *arguments)
    control.link = f"pty:{folder}/{last}"
    return control.start()


def three_controls_in_one_process(folder):
    prepare(folder, 40)
    fleet = simulate(folder, "line-3", "--count", "3")
    hosts = [send(folder, f"pty:{folder}/line-{n}") for n in (1, 2, 3)]
    sent = [json.loads(host.communicate(timeout=90)[0]) for host in hosts]
    report = fleet.finish(60)
    expect(len(report["controls"]) == 3 and report["total"]["ended"] == 3, f"not all ended: {report}")
    for host, control in zip(sent, report["controls"]):
        expect(host["text_sha256"] == control["text_sha256"], f"another text arrived at {control['link']}")
    expect(report["total"]["bytes"] == sum(c["bytes"] for c in report["controls"]), "the total is no sum")
    expect(report["total"]["alarms"] == 0, f"alarms: {report}")


def two_rounds_by_two_starts(folder):
    prepare(folder, 30)
    control = simulate(folder, "line", "--repeat")
    host = send(folder, f"pty:{folder}/line", "--rounds", "2")
    out, err = host.communicate(timeout=90)
    expect(host.returncode == 0, f"send ended with {host.returncode}: {err}")
    sent = json.loads(out)
    report = control.stop()
    expect(sent["handed"] == report["bytes"], f"handed {sent['handed']}, arrived {report['bytes']}")
    text = len((folder / "p.nc").read_text())  # a round's trailer may be cut by the control's end of reading
    expect(2 * text <= report["bytes"] <= sent["bytes"], f"{report['bytes']} are no two rounds of {text}")
    expect("waiting for DC1" in err, f"the wait between the rounds is not named: {err}")


def a_flipped_parity_bit_is_an_alarm(folder):
    prepare(folder, 60)
    control = simulate(folder, "line", "--fault", "parity=300")
    host = send(folder, f"pty:{folder}/line")
    report = control.finish(60)
    _, err = host.communicate(timeout=90)
    expect(report["alarm"] == "001 TH PARITY" and report["parity_errors"] == 1, f"{report}")
    expect(host.returncode == 3 and "link_lost" in err, f"send: {host.returncode} {err}")


def a_cable_that_was_out_resumes_nothing(folder):
    prepare(folder, 60)
    control = simulate(folder, "line", "--fault", "unplug=300")
    host = send(folder, f"pty:{folder}/line")
    _, err = host.communicate(timeout=90)
    expect(host.returncode == 3 and "link_lost" in err, f"send: {host.returncode} {err}")
    shop.wait_for("the cable", lambda: os.path.exists(f"{folder}/line"), 10)
    report = control.stop()
    expect(report["bytes"] == 300, f"{report['bytes']} arrived: something was sent after the break")


def the_operator_waits_for_a_program_that_is_held(folder):
    """Inside a program RESET is pressed late, as its rest would be lost; when the host has left, it is pressed soon."""
    prepare(folder, 1)
    control = simulate(folder, "line")
    host = os.open(folder / "line", os.O_RDWR | os.O_NOCTTY)
    expect(os.read(host, 1) == DC1, "the operator did not press START")
    os.write(host, with_even_parity("%\nO0042\nG21\n"))
    expect(not select.select([host], [], [], 1.5)[0], "the operator reset a program that is held")
    os.close(host)
    time.sleep(0.3)
    host = os.open(folder / "line", os.O_RDWR | os.O_NOCTTY)
    expect(select.select([host], [], [], 10)[0] and os.read(host, 1) == DC1, "the operator waits for a host that has left")
    os.close(host)
    control.stop()


def with_even_parity(text):
    return bytes(byte | (byte.bit_count() % 2) << 7 for byte in text.encode())


if __name__ == "__main__":
    for test in (three_controls_in_one_process, two_rounds_by_two_starts, a_flipped_parity_bit_is_an_alarm, a_cable_that_was_out_resumes_nothing,
                 the_operator_waits_for_a_program_that_is_held):
        in_folder(test)
