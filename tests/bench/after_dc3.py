"""What comes in after a control's DC3 on this machine, in real time: one pseudo-terminal a rate (or a TCP socket with --tcp), one program, and
the simulated control's histogram. Shown are the holds, the worst and the 99th percentile of characters after DC3, and the share of line time
used while nothing held. By hand: after_dc3.py build/release/dripfeed [--seconds 30] [--tcp]"""

import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "deploy"))
import shop  # noqa: E402

# Half of what may lie below must last longer than the links' tick of 1 ms.
RATES = [(9600, "7E2", 4, 5), (38400, "8N1", 10, 12), (115200, "8N1", 26, 26)]


def program(characters):
    lines = ["%", "O0001", "G21 G18 G40 G98"]
    size = 0
    while size < characters:
        lines.append(f"G01 X{50 + len(lines) % 7 * 0.1:.3f} Z{-len(lines) * 0.05:.3f} F4000")
        size += len(lines[-1]) + 1
    return "\n".join(lines + ["M30", "%"]) + "\n"


def measure(binary, folder, rate, seconds, tcp):
    baud, framing, unsent, latency = rate
    profile = shop.preset("fanuc-0i-lathe", baud=baud, framing=framing, unsent=unsent, latency_chars=latency, overrun_budget=unsent + latency,
                          code="iso" if framing[1] == "E" else "ascii", url="pty:/dev/null")
    profile["buffer"]["bytes"] = 1024
    bits = 1 + int(framing[0]) + (framing[1] != "N") + int(framing[2])
    (folder / "m.json").write_text(json.dumps(profile))
    (folder / "p.nc").write_text(program(int(seconds * baud / bits)))
    if tcp:
        port = shop.free_port()
        host, far = f"tcp://127.0.0.1:{port}", f"tcp-listen://127.0.0.1:{port}"
    else:
        host = far = f"pty:{folder}/line"
    # So quick that at each rate the line and the motion take turns in being the slower one.
    control = shop.Control(binary, far, folder / "m.json", "--operator", "2", "--speed", str(0.15 * baud / 9600)).start()
    sent = subprocess.run([binary, "send", folder / "p.nc", "--link", host, "--machine", folder / "m.json", "--unreleased", "--json", "--ledger",
                           folder / "p.ledger"], capture_output=True, text=True, timeout=seconds * 60 + 120, check=False)
    report = control.finish(60)
    if sent.returncode != 0 or report["alarm"]:
        raise SystemExit(f"{baud}: {sent.stderr} {report['alarm']}")
    histogram = report["after_dc3_histogram"]
    holds = sum(histogram)
    p99 = next(i for i in range(len(histogram)) if sum(histogram[:i + 1]) * 100 >= holds * 99)
    print(f"{baud:7} {framing} {'tcp' if tcp else 'pty'}: {report['bytes']} characters, {holds} holds, budget {unsent + latency}, after DC3 worst "
          f"{report['after_dc3_max']}, p99 {p99}; line use {report['line_use']:.4f}; histogram {histogram}", flush=True)


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("binary")
    options.add_argument("--seconds", type=float, default=30)
    options.add_argument("--tcp", action="store_true")
    given = options.parse_args()
    for rate in RATES:
        with tempfile.TemporaryDirectory(prefix="after-dc3-") as folder:
            os.environ["DRIPFEED_LINES"] = f"{folder}/lines"
            measure(pathlib.Path(given.binary).resolve(), pathlib.Path(folder), rate, given.seconds, given.tcp)


if __name__ == "__main__":
    main()
