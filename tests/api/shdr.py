"""The adapter for an agent of MTConnect that a shop has already: what an agent keeps of its lines is what /mtconnect/current states, item by item, while
machines come, feed and lose their links; who does not read, or falls silent, is let go; and nothing that an agent sends changes anything."""

import re
import socket
import sys
import threading
import time
import xml.etree.ElementTree as tree

from client import DC1, Client, HandControl, expect, hand_profile, in_folder, shop

LINE = re.compile(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d\.\d{3}Z\|(m_\w+)\|(.*)")


class Agent:
    """Keeps what it reads, as an agent does: by data item the value, or of a condition what is active."""

    def __init__(self, port):
        self.socket = socket.create_connection(("127.0.0.1", port), timeout=10)
        self.socket.settimeout(None)
        self.comments, self.events, self.active, self.lines, self.is_over = [], {}, {}, 0, False
        self.thread = threading.Thread(target=self.read, daemon=True)
        self.thread.start()

    def read(self):
        try:
            for line in self.socket.makefile(encoding="utf-8", newline="\n"):
                self.take(line.rstrip("\n"))
        except OSError:
            pass
        self.is_over = True

    def take(self, line):
        if line.startswith("* "):
            self.comments.append(line)
            return
        item, rest = LINE.fullmatch(line).groups()
        fields = rest.split("|")
        self.lines += 1
        if item.endswith(("_sys", "_comm")):
            level, code, _severity, _qualifier, text = fields
            self.take_condition(item, level, code, text)
        elif item.endswith("_dnc"):
            native, text = fields
            expect(native == "", f"a message with a code: {line}")
            self.events[item] = text
        else:
            (self.events[item],) = fields

    def take_condition(self, item, level, code, text):
        """NORMAL with a code ends that one, NORMAL without one and UNAVAILABLE end all."""
        active = self.active.setdefault(item, {})
        if level == "NORMAL" and code:
            active.pop(code)
        elif level in ("NORMAL", "UNAVAILABLE"):
            active.clear()
        else:
            active[code] = (level, text)
        self.events[item] = "UNAVAILABLE" if level == "UNAVAILABLE" else ", ".join(f"{level} {code} {text}" for code, (level, text) in active.items()) or "NORMAL"

    def say(self, text):
        self.socket.sendall(text.encode())

    def close(self):
        self.socket.close()


def current(client):
    """{data item: value} of /mtconnect/current, a condition in the words of the agent above."""
    root = tree.fromstring(client.call("GET", "/mtconnect/current", role="viewer").body)
    found = {}
    for one in root.iter():
        item = one.get("dataItemId")
        if item is None:
            continue
        kind = one.tag.split("}")[1]
        if item.endswith(("_sys", "_comm")):
            found[item] = kind.upper() if kind in ("Normal", "Unavailable") else f"{kind.upper()} {one.get('nativeCode', '')} {one.text or ''}"
        else:
            found[item] = one.text
    return found


def port_of(client):
    return int(shop.wait_for("its address", lambda: re.search(r"SHDR at 127\.0\.0\.1:(\d+)", (client.server.data / "server.log").read_text()))[1])


def agrees(client, agent, what):
    shop.wait_for(f"the agent to have the values of {what}", lambda: (lambda now: now and now == agent.events)(current(client)))


def an_agent(folder):
    control = HandControl()
    client = Client(folder, "--shdr-listen", "127.0.0.1:0").start()
    agent = Agent(port_of(client))
    client.post("/machines", hand_profile(control))
    agrees(client, agent, "a machine that is new")
    expect(agent.comments[0] == "* shdrVersion: 2.0" and "* adapterVersion" not in agent.comments, f"{agent.comments}")
    client.wait_line("lathe", "idle")
    agrees(client, agent, "a line that is up")
    job = client.queue(client.release(client.add_program(40)["id"])["id"])
    client.post(f"/jobs/{job}/arm")
    agrees(client, agent, "an armed job")
    control.say(DC1)
    client.wait_job(job, "done")
    agrees(client, agent, "the end of a feed")
    second = Agent(port_of(client))
    agrees(client, second, "an agent that comes later")
    agent.say("* PING\r\n")
    shop.wait_for("an answer", lambda: "* PONG 10000" in agent.comments)
    before = agent.lines
    agent.say("2026-01-01T00:00:00Z|m_lathe_exec|ACTIVE\n* device: other\n" + "x" * 500 + "\n")
    control.listener.close()
    control.cut()
    shop.wait_for("the loss of the link", lambda: agent.events["m_lathe_avail"] == "UNAVAILABLE" and agent.events["m_lathe_comm"].startswith("FAULT"))
    agrees(client, agent, "a lost link")
    expect(agent.events["m_lathe_exec"] == "UNAVAILABLE" and agent.lines > before, "what an agent sent counts")
    agent.say("y" * 5000)  # no line
    shop.wait_for("an end", lambda: agent.is_over)
    agrees(client, second, "the other agent")
    second.close()
    client.server.stop()


def what_is_refused(folder):
    client = Client(folder, "--shdr-listen", "127.0.0.1:0", "--shdr-allow", "127.0.0.7").start()
    stranger = Agent(port_of(client))
    shop.wait_for("an end", lambda: stranger.is_over)
    expect(stranger.lines == 0 and not stranger.comments, "a stranger read something")
    many = [socket.create_connection(("127.0.0.1", port_of(client)), source_address=("127.0.0.7", 0), timeout=10) for _ in range(20)]
    time.sleep(0.5)
    greeted = [one for one in many if one.recv(10) == b"* shdrVers"]
    expect(len(greeted) == 16, f"{len(greeted)} agents at the same time")
    for one in many:
        one.close()
    client.server.stop()


def who_falls_silent_is_let_go(folder):
    """Whoever has asked once goes on asking; an agent that never asks stays."""
    client = Client(folder, "--shdr-listen", "127.0.0.1:0").start()
    silent, asks, quiet = (Agent(port_of(client)) for _ in range(3))
    silent.say("* PING\n")
    begin = time.monotonic()
    while not silent.is_over:
        asks.say("* PING\n")
        time.sleep(1)
        expect(time.monotonic() - begin < 60, "a silent agent stays")
    expect(time.monotonic() - begin > 29, f"it was let go after {time.monotonic() - begin:.0f} s")
    expect(not asks.is_over and not quiet.is_over, "others were let go with it")
    client.server.stop()


if __name__ == "__main__":
    for test in (an_agent, what_is_refused, who_falls_silent_is_let_go):
        in_folder(test)
    sys.exit(0)
