"""No signal that a terminal, a shell or a supervisor sends cuts a command off inside a block; and an output without a reader ends nothing."""

import json
import os
import signal
import subprocess
import time

from rig import Rig, binary, expect, in_folder, sends, shop
from torn_send import DC1, DC3, DONE, FAILED, LINE, HandControl, ended, program_in

# What would end or stop a process that does not take it, but for what asks it to stop.
ODD = [signal.SIGTSTP, signal.SIGTTIN, signal.SIGTTOU, signal.SIGUSR1, signal.SIGUSR2, signal.SIGALRM, signal.SIGVTALRM, signal.SIGPROF, signal.SIGPIPE,
       signal.SIGIO, signal.SIGPWR, signal.SIGSTKFLT, signal.SIGXCPU, signal.SIGXFSZ, signal.SIGRTMIN, signal.SIGRTMAX]


def a_transfer_goes_on_through_odd_signals(folder):
    control = HandControl(folder / "line.tty")
    program = program_in(folder, 150)
    sending = sends(program, f"pty:{folder}/line.tty?{LINE}")
    time.sleep(0.5)
    control.say(DC1)
    control.wait_for(300)
    for odd in ODD:
        sending.send_signal(odd)
        time.sleep(0.02)
    control.wait_for(len(program.read_bytes()))
    control.say(DC3)
    ended(sending, DONE, "SIGTSTP is ignored", "SIGUSR1 is ignored", "SIGXCPU is ignored")
    expect(bytes(control.got) == program.read_bytes(), "another text came over the line")


def a_closed_terminal_stops_a_transfer_at_the_end_of_its_block(folder, twice=True):
    control = HandControl(folder / "line.tty")
    sending = sends(program_in(folder), f"pty:{folder}/line.tty?{LINE}")
    time.sleep(0.5)
    control.say(DC1)
    control.wait_for(500)
    for _ in range(2 if twice else 1):  # the system sends it, and so does the shell
        sending.send_signal(signal.SIGHUP)
        time.sleep(0.005)
    document = ended(sending, FAILED, "stopping at the end of the block")
    expect(document["torn"] is False and document["line"]["state"] == "clean", f"{document}")
    time.sleep(0.2)
    expect(control.got[-1:] == b"\n", f"it ended inside a block: {bytes(control.got)[-40:]}")


def a_simulated_control_reports_when_its_terminal_closes(folder):
    machine = folder / "lathe.json"
    machine.write_text(json.dumps(shop.preset("fanuc-0i-lathe", url="serial:/dev/ttyS0")))
    control = shop.Control(binary(), f"pty:{folder}/line.tty", machine).start()
    control.process.send_signal(signal.SIGHUP)
    expect(control.finish(10)["bytes"] == 0, "no report")
    expect(not os.path.lexists(folder / "line.tty"), "the link of the pseudo-terminal is left")


def a_server_feeds_on_through_odd_signals(folder):
    rig = Rig(folder, f"pty:{folder}/lathe.tty", blocks=150).start()
    control = rig.control("--speed", "1000")
    job = rig.arm_new_job()
    rig.server.wait_job(job, "feeding", "held")
    for odd in [signal.SIGHUP, *ODD, signal.SIGHUP]:
        rig.server.process.send_signal(odd)
        time.sleep(0.02)
    expect(rig.server.wait_job(job, "done", "failed", "interrupted")["state"] == "done", "the feed did not get through")
    expect(control.finish(30)["alarm"] is None, "the control raised an alarm")
    log = (folder / "data/server.log").read_text()
    for word in ["SIGHUP: no option has changed", "SIGTSTP is ignored", "SIGUSR2 is ignored"]:
        expect(word in log, f"{word!r} is not in {log!r}")
    rig.server.stop()


def a_server_outlives_the_readers_of_its_outputs(folder):
    """serve | head -1"""
    rig = Rig(folder, f"pty:{folder}/lathe.tty", blocks=150)
    said = [os.pipe() for _ in range(2)]
    rig.server = shop.Server(binary(), folder / "data", shop.free_port())
    rig.server.stdout, rig.server.stderr = (write for _, write in said)
    rig.start()
    first = os.read(said[0][0], 4096)
    expect(b"dripfeed is at http://" in first, f"{first}")
    for read, write in said:
        os.close(read)
        os.close(write)
    control = rig.control("--speed", "1000")
    job = rig.arm_new_job()
    rig.server.process.send_signal(signal.SIGUSR1)  # writes a line
    expect(rig.server.wait_job(job, "done", "failed", "interrupted")["state"] == "done", "the feed did not get through")
    expect(control.finish(30)["alarm"] is None, "the control raised an alarm")
    rig.server.stop()


def a_transfer_outlives_the_readers_of_its_outputs(folder):
    control = HandControl(folder / "line.tty")
    program = program_in(folder, 100)
    reads, writes = os.pipe()
    sending = sends(program, f"pty:{folder}/line.tty?{LINE}", stdout=writes, stderr=writes)
    os.close(writes)
    time.sleep(0.5)
    control.say(DC1)
    control.wait_for(200)
    os.close(reads)
    control.wait_for(len(program.read_bytes()))
    control.say(DC3)
    sending.wait(20)
    # It is done; that it could not be reported is a failure of the command, and no crash.
    expect(sending.returncode == FAILED, f"{sending.returncode}")
    waiting = sends(program, f"pty:{folder}/line.tty?{LINE}")
    time.sleep(0.3)
    waiting.send_signal(signal.SIGQUIT)
    ended(waiting, FAILED, "stopping at the end of the block")  # not torn: the line is clean


def a_filter_ends_with_its_reader(folder):
    """What only computes keeps the system's meanings."""
    text = program_in(folder, 20000)
    piped = subprocess.run(["bash", "-c", f'"{binary()}" convert "{text}" --from fanuc --to fanuc | head -1; exit ${{PIPESTATUS[0]}}'], capture_output=True, timeout=60)
    expect(piped.returncode == 128 + signal.SIGPIPE and piped.stderr == b"", f"{piped}")


if __name__ == "__main__":
    for test in [a_transfer_goes_on_through_odd_signals, a_closed_terminal_stops_a_transfer_at_the_end_of_its_block,
                 a_simulated_control_reports_when_its_terminal_closes, a_server_feeds_on_through_odd_signals,
                 a_server_outlives_the_readers_of_its_outputs, a_transfer_outlives_the_readers_of_its_outputs, a_filter_ends_with_its_reader]:
        in_folder(test)
