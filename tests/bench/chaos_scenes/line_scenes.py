"""The scenes of one line: what person and operator do, and which rule each aims at. A scene that only waits for its own line is `measured`: no arrival may be
later than pacing explains."""

import time

import shop


def plain_feed(line):
    line.measured = True
    line.arm()
    line.rest(line.chance.uniform(0, 0.2))
    line.cycle_start()
    line.finish()


def feed_with_holds(line):
    line.measured = True
    line.arm()
    line.cycle_start()
    for place in sorted(line.somewhere() for _ in range(line.chance.randrange(1, 5))):
        if line.control.count() >= place:
            continue
        with line.loop.lock:
            line.control.hold_at = place
        line.wait("the hold", lambda: line.control.expected_since is None, step=0.005)
        line.rest(line.chance.uniform(0.01, 0.4))
        line.control.start()
    line.finish()


def start_with_nothing_armed(line):
    line.wait_line("idle")
    line.permit.set("silent", "nothing is armed")
    for _ in range(line.chance.randrange(1, 30)):
        line.control.send(b"\x11")
        line.rest(line.chance.uniform(0, 0.03))
    line.rest(0.2)


def flood_at_rest(line):
    line.wait_line("idle")
    line.permit.set("silent", "nothing is armed")
    flood(line, line.chance.uniform(0.3, 1.5))
    forget_flood(line)


def arm_after_a_flood(line):
    """What came before the arming is no start, though it was not read yet: the arming is refused, or waits for a start of its own."""
    line.wait_line("idle")
    line.permit.set("silent", "nothing is armed")
    flood(line, line.chance.uniform(0.3, 0.8))
    try:
        line.arm()
        line.rest(1.0)
        line.served.post(f"/jobs/{line.job}/cancel")
    except shop.Refused as refused:
        line.judge_of_all.refused(f"{line.scene}: {str(refused)[:150]}")
    line.permit.set("silent", "nothing is armed")
    forget_flood(line)
    line.recover()


def flood_in_a_feed(line):
    line.arm()
    line.cycle_start()
    line.feed_until(line.somewhere(0.1, 0.6))
    flood(line, line.chance.uniform(0.1, 0.5))
    line.rest(0.5)
    forget_flood(line)
    if line.job_state()["state"] in ("failed", "interrupted"):
        return line.after_break(line.job, "a flood broke the feed")
    line.recover()


def flood(line, seconds):
    until = time.monotonic() + seconds
    while time.monotonic() < until:
        line.look()
        if line.control.send(b"\x11" * 8192) == 0:
            time.sleep(0.005)


def forget_flood(line):
    """What sockets and terminals still hold of it would be a start for the next job."""
    line.control.unplug()
    line.rest(0.1)
    line.control.plug()
    line.wait("the link", line.control.up)
    line.wait_line("idle", "torn")


def stop_and_resume(line):
    line.arm()
    line.cycle_start()
    line.feed_until(line.somewhere(0.1, 0.7))
    line.stop()
    line.rest(line.chance.uniform(0, 0.4))
    if line.job_state()["state"] not in ("held", "feeding"):
        return line.recover()  # the program was over before
    line.permit.set("sending")
    line.served.post(f"/jobs/{line.job}/resume", {"reason": "the test goes on"})
    line.control.expect_bytes()
    line.finish()


def reset_while_stopped(line):
    """RESET and START at a control that a person stopped: it was reset, so the rest of the program must not go there."""
    line.arm()
    line.cycle_start()
    line.feed_until(line.somewhere(0.1, 0.6))
    line.stop()
    if line.job_state()["state"] not in ("held", "feeding"):
        return line.recover()
    line.permit.set("silent", "the operator pressed RESET and START while a person's stop was in force")
    line.control.send(b"\x11")
    line.rest(0.4)
    line.permit.set("sending", "what a resume to a control that was reset brings is one violation, and enough")
    try:
        line.served.post(f"/jobs/{line.job}/resume", {"reason": "the test resumes after a reset"})
        line.judge_of_all.violation(1, line.name, line.scene, "RESET and START came while stopped, and resume was taken")
    except shop.Refused:
        pass
    line.recover()


def cancel_in_a_feed(line):
    line.arm()
    line.cycle_start()
    line.feed_until(line.somewhere(0.05, 0.8))
    line.cancel()


def disarm(line):
    line.arm()
    line.rest(line.chance.uniform(0, 0.3))
    line.permit.set("silent", "the job was cancelled before its start")
    line.served.post(f"/jobs/{line.job}/cancel")
    line.control.send(b"\x11")
    line.rest(0.3)
    line.job = None


def cut_inside_a_block(line):
    line.arm()
    line.cycle_start()
    line.feed_until(line.somewhere())
    line.wait("the inside of a block", lambda: cut_if(line, line.control.inside_block), step=0)
    broken(line, "the link was cut inside a block")


def cut_if(line, condition):
    """Under the lock: nothing arrives between the look and the cut."""
    with line.loop.lock:
        if not condition():
            return False
        line.permit.set("sending", "what was in transit")
        line.control.unplug()
        if line.control.inside_block():
            line.torn("the link was cut inside a block")
        return True


def cut_while_armed(line):
    line.arm()
    with line.loop.lock:
        line.permit.set("silent", "the link of an armed job was cut")
        line.control.unplug()
    line.rest(line.chance.uniform(0, 0.4))
    line.control.plug()
    line.wait_line("idle", "torn", "armed", seconds=20)
    line.control.send(b"\x11")
    line.rest(0.4)
    line.served.post(f"/jobs/{line.job}/cancel")
    line.job = None


def broken(line, why):
    """The server sees it, then the cable is there again."""
    line.wait("the end of the job", lambda: line.job is None or line.job_state()["state"] in ("failed", "done", "cancelled", "interrupted"), 12, 0.05)
    line.rest(line.chance.uniform(0, 0.3))
    line.control.plug()
    # What the server wrote after our last read was lost with the connection: it is not counted, and may be as much as the socket took.
    line.after_break(line.job, why, slack=64)


def answer(line):
    """The operator asks for the list, and reads it."""
    line.wait_line("idle")
    line.control.begin()
    line.permit.set("armed", "the operator did not start the reading of an answer")
    line.control.punch("%\nO9999(DIR)\n%\n")
    line.wait_line("answering", seconds=4)
    line.permit.set("answer")
    line.control.start()
    line.wait("the answer", line.whole, step=0.01)
    line.control.hold()
    line.wait_line("idle")
    line.permit.set("silent", "the answer is over")


def cut_inside_an_answer(line):
    line.wait_line("idle")
    line.control.begin()
    line.permit.set("armed", "the operator did not start the reading of an answer")
    line.control.punch("%\nO9999(DIR)\n%\n")
    line.wait_line("answering", seconds=4)
    line.permit.set("answer")
    line.control.start()
    line.wait("the inside of a block", lambda: line.control.count() > 56 and cut_if(line, line.control.inside_block), 3, step=0)
    line.rest(0.3)
    line.control.plug()
    line.after_break(None, "the link was cut inside an answer")


# name: (weight, what it does, the rule that it aims at)
SCENES = {
    "plain feed": (5, plain_feed, 4),
    "feed with holds": (4, feed_with_holds, 4),
    "start, nothing armed": (2, start_with_nothing_armed, 1),
    "flood at rest": (1, flood_at_rest, 4),
    "arm after a flood": (1, arm_after_a_flood, 1),
    "flood in a feed": (1, flood_in_a_feed, 2),
    "stop and resume": (2, stop_and_resume, 1),
    "reset while stopped": (1, reset_while_stopped, 1),
    "cancel in a feed": (2, cancel_in_a_feed, 1),
    "disarm": (1, disarm, 1),
    "cut inside a block": (3, cut_inside_a_block, 2),
    "cut while armed": (1, cut_while_armed, 1),
    "answer": (1, answer, 1),
    "cut inside an answer": (1, cut_inside_an_answer, 2),
}
