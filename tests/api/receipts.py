"""What a control punches and what its operator asks for, at a control that the test plays by hand: receipts and their decisions, quarantine,
requests with their answers, a memory load that is read back, and the numbers that have a right of their own."""

import sys

from client import DC1, DC3, Client, HandControl, expect, hand_profile, in_folder, shop

PROGRAM = "%\nO0042\nG21 G18 G40 G99\nG55\nT0101\nG97 S500 M03\nG00 X100. Z10.\nG01 X50. F0.2\nM05\nM30\n%\n"


class Bench:
    def __init__(self, folder, options=(), **receive):
        self.control = HandControl()
        self.profile = hand_profile(self.control)
        self.profile["receive"] = {"quiet_s": 0.6, "quiet_after_end_s": 0.2, "read_back": True} | receive
        self.client = Client(folder, *options).start()
        self.client.post("/machines", self.profile)
        self.client.wait_line("lathe", "idle")

    def punch(self, wire):
        """The control punches; the newest receipt."""
        before = len(self.client.get("/receipts?limit=200")["items"])
        self.control.say(wire)
        shop.wait_for("a receipt", lambda: len(self.client.get("/receipts?limit=200")["items"]) > before)
        return self.client.get("/receipts?limit=1")["items"][0]

    def ask(self, words):
        """The operator punches a request; what is noted of it."""
        before = len(self.client.get("/requests?limit=200")["items"])
        self.control.say(b"\x12%\nO9999(" + words.encode() + b")\n%\n\x14")
        shop.wait_for("the request", lambda: len(self.client.get("/requests?limit=200")["items"]) > before)
        return self.client.get("/requests?limit=1")["items"][0]

    def read(self):
        """The operator presses READ: what comes, up to the quiet."""
        had = len(self.control.text())
        self.control.say(DC1)
        self.control.wait_bytes(had + 5)
        text = self.control.wait_quiet()[had:]
        self.control.say(DC3)
        self.client.wait_line("lathe", "idle")
        return text.decode()

    def answer(self, words):
        noted = self.ask(words)
        self.client.wait_line("lathe", "answering", "armed")
        return noted, self.read()

    def release(self, name, text, delivery="memory"):
        program = self.client.post("/programs", {"name": name, "dialect": "fanuc", "text": text})["id"]
        verdict = self.client.post("/checks", {"program": program, "machine": "lathe", "delivery": delivery})
        expect(verdict["verdict"] != "fail", f"{verdict}")
        if verdict["verdict"] != "pass":
            self.client.post(f"/checks/{verdict['id']}/waivers", {"reason": "a text of a test"})
        release = self.client.post("/releases", {"program": program, "machine": "lathe", "delivery": delivery})["id"]
        for step in ({"to": "in_review"}, {"to": "proving", "transfers": 9}):
            self.client.post(f"/releases/{release}/transitions", step)
        return release

    def end(self):
        expect(self.client.server.alive(), "the server is gone")
        self.client.server.stop()
        self.control.close()


def receipts_are_decided_once(folder):
    bench = Bench(folder)
    client = bench.client
    first = bench.punch(b"\x12\0\0%\nO0007(SHAFT)\nG0X1.\nM30\n%\0\x14")
    expect((first["state"], first["name"], first["named_by"], first["ended_by"]) == ("stored", "O0007", "number", "punch_off"), f"{first}")
    expect(first["stored"] is None, "nothing of that name was stored before")
    text = client.call("GET", f"/receipts/{first['id']}/text").body
    expect(text == b"%\nO0007(SHAFT)\nG0X1.\nM30\n%\n", f"{text}")
    accepted = client.post(f"/receipts/{first['id']}/accept")
    expect(accepted["state"] == "accepted" and accepted["revision"] == 1, f"{accepted}")
    client.refuse(409, "POST", f"/receipts/{first['id']}/accept", {})
    client.refuse(409, "POST", f"/receipts/{first['id']}/discard", {"reason": "too late"})

    again = bench.punch(b"%\r\nO0007(SHAFT)\r\nG0X2.\r\nM30\r\n%\r\n")
    expect(again["stored"]["program"] == accepted["program"] and not again["stored"]["same"], f"{again}")
    expect("line 3, column 4" in again["stored"]["difference"], f"{again['stored']}")
    client.refuse(412, "POST", f"/receipts/{again['id']}/accept", {"program": accepted["program"], "revision": 9})
    revised = client.post(f"/receipts/{again['id']}/accept", {"program": accepted["program"], "revision": 1})
    expect((revised["program"], revised["revision"]) == (accepted["program"], 2), f"{revised}")
    old = client.call("GET", f"/programs/{accepted['program']}/text?revision=1").body
    expect(old == text, "the first revision was overwritten")

    torn = bench.punch(b"\x12%\nO0008\nG0X\x14")
    expect(torn["state"] == "quarantined" and torn["reason"], f"{torn}")
    expect(client.call("GET", f"/receipts/{torn['id']}/text").body == b"%\nO0008\nG0X", "the bytes are not kept as they came")
    client.refuse(422, "POST", f"/receipts/{torn['id']}/discard", {})
    expect(client.post(f"/receipts/{torn['id']}/discard", {"reason": "torn"})["state"] == "discarded", "it is not discarded")
    out_of_quarantine(bench)
    expect(len(client.get("/receipts?state=accepted")["items"]) == 3, "the filter by state")
    expect(client.get("/receipts?machine=other")["items"] == [], "the filter by machine")
    client.refuse(422, "GET", "/receipts?state=odd")

    many = bench.punch(b"%\nO0010\nM98P11\nM30\nO0011\nM99\n%\n")
    shop.wait_for("both programs", lambda: len(client.get("/receipts?state=stored")["items"]) == 2)
    expect({item["name"] for item in client.get("/receipts?state=stored")["items"]} == {"O0010", "O0011"}, f"{many}")
    bench.control.say(b"Port already in use\r\n")
    bench.control.cut()
    bench.control.wait_called(2)
    client.wait_line("lathe", "idle")
    words = shop.wait_for("the words of a device server", lambda: client.get("/receipts?state=quarantined")["items"])[0]
    expect("Port already in use" in words["reason"] and len(client.get("/receipts?limit=200")["items"]) == 7, f"{words}")
    pages_meet_each_once(client, "/receipts")
    bench.end()


def out_of_quarantine(bench):
    """A person with the right looks at what can be read and takes it for a program, with a reason that stays."""
    client = bench.client
    open_end = bench.punch(b"\x12\xA5\n\xCF9\n\xC7\x30X\xB1.\n\x14")
    path = f"/receipts/{open_end['id']}"
    expect((open_end["state"], open_end["code"]) == ("quarantined", "iso"), f"{open_end}")
    expect(client.call("GET", f"{path}/text?form=read").body == b"%\nO9\nG0X1.\n", "it cannot be read")
    expect(client.call("GET", f"{path}/text").body.startswith(b"\xA5\n"), "the bytes are not kept as they came")
    client.refuse(422, "GET", f"{path}/text?form=odd")
    client.refuse(403, "POST", f"{path}/accept", {"reason": "I think it is right"}, role="programmer")
    client.refuse(422, "POST", f"{path}/accept", {}, role="approver")
    taken = client.must("POST", f"{path}/accept", {"reason": "only its end is missing"}, role="approver")
    expect((taken["state"], taken["decided_reason"], taken["revision"]) == ("accepted", "only its end is missing", 1), f"{taken}")
    expect(client.call("GET", f"/programs/{taken['program']}/text").body == b"%\nO9\nG0X1.\n", "the program is another")
    client.refuse(409, "POST", f"{path}/discard", {"reason": "too late"})


def requests_are_answered(folder):
    bench = Bench(folder)
    client = bench.client
    noted, text = bench.answer("LOAD 1234")
    expect((noted["verb"], noted["outcome"]) == ("load", "refused"), f"{noted}")
    expect(text == "%\nO9999(NOT FOUND 1234)\nM30\n%\n", f"{text!r}")
    noted, text = bench.answer("LOAD ../first-token")
    expect(noted["outcome"] == "refused" and "NAME NOT UNDERSTOOD" in text, f"{noted} {text!r}")
    bench.release("O0042", PROGRAM)
    bench.release("O0042", PROGRAM, "drip")
    noted, text = bench.answer("dir o00*")
    expect(noted["outcome"] == "answered" and "(O0042 LOAD)" in text and "(O0042 DNC)" in text, f"{text!r}")
    noted, text = bench.answer("DNC 42")
    expect(noted["outcome"] == "refused" and noted["job"] is None and "NOT ALLOWED" in text, f"{noted} {text!r}")
    noted, text = bench.answer("STATUS")
    expect("LINE IDLE" in text, f"{text!r}")

    noted, text = bench.answer("LOAD 42")
    expect(noted["outcome"] == "armed" and text == PROGRAM, f"{noted} {text!r}")
    job = client.wait_job(noted["job"], "done")
    expect(job["delivery"] == "memory" and job["armed_by"] == "operator at lathe", f"{job}")
    read_back(bench, job)

    first = bench.ask("LOAD 42")
    client.wait_line("lathe", "armed")
    noted, text = bench.answer("CANCEL")
    expect("CANCELLED" in text and client.job(first["job"])["state"] == "cancelled", f"{noted} {text!r}")
    real = bench.punch(b"%\nO9999(MY PROGRAM)\nM30\n%\n")
    expect(real["name"] == "O9999", "a real O9999 is lost")
    pages_meet_each_once(client, "/requests")
    bench.end()


def pages_meet_each_once(client, path):
    whole = [item["id"] for item in client.get(f"{path}?limit=200")["items"]]
    expect(len(whole) == len(set(whole)) >= 5, f"{path}: {whole}")
    for limit in (1, 2, len(whole)):
        found, after = [], ""
        while after is not None:
            page = client.get(f"{path}?limit={limit}{after}")
            found += [item["id"] for item in page["items"]]
            after = f"&after={page['next']}" if page["next"] else None
        expect(found == whole, f"{path} by {limit}: {found}, not {whole}")


def read_back(bench, job):
    """The operator punches what was loaded; first as it is, later with another number."""
    client = bench.client
    waits = shop.wait_for("the read-back to be expected", lambda: client.job(job["id"])["read_back"])
    expect(waits == "waiting for read-back", f"{waits}")
    expect(client.job(job["id"])["read_back_state"] == "waiting", "no word for programs")
    bench.control.say(b"\x12" + PROGRAM.replace("\n", "\n\r\r").encode() + b"\x14")
    shop.wait_for("the read-back", lambda: client.job(job["id"])["read_back"] == "equal")
    expect(client.get("/receipts")["items"] == [], "a read-back that is equal is no receipt")
    notes = [row["note"] for row in client.get(f"/jobs/{job['id']}/ledger")["items"]]
    expect("read-back equal" in notes, f"{notes}")

    second, _ = bench.answer("LOAD 42")
    client.wait_job(second["job"], "done")
    shop.wait_for("the read-back to be expected", lambda: client.job(second["job"])["read_back"])
    bench.punch(b"\x12" + PROGRAM.replace("X50.", "X51.").encode() + b"\x14")
    result = client.job(second["job"])["read_back"]
    expect(result.startswith("differs: line 8, column 7"), f"{result}")
    expect(client.job(second["job"])["read_back_state"] == "differs", "no word for programs")


def a_drip_feed_is_armed_by_a_person(folder):
    bench = Bench(folder, remote_drip=True)
    bench.release("O0042", PROGRAM, "drip")
    noted, text = bench.answer("DNC 42")
    expect(noted["outcome"] == "queued" and "QUEUED" in text, f"{noted} {text!r}")
    expect(bench.client.job(noted["job"])["state"] == "queued", "a request armed a drip-feed")
    had = len(bench.control.text())
    bench.control.say(DC1)
    expect(len(bench.control.wait_quiet()) == had, "something went out that no one armed")
    bench.end()


def some_numbers_have_a_right_of_their_own(folder):
    bench = Bench(folder)
    release = bench.release("O9001", PROGRAM.replace("O0042", "O9001"))
    job = bench.client.queue(release)
    bench.client.refuse(403, "POST", f"/jobs/{job}/arm", {}, role="approver")
    noted, text = bench.answer("LOAD 9001")
    expect(noted["outcome"] == "refused" and "PROTECTED" in text, f"{noted} {text!r}")
    expect(bench.client.must("POST", f"/jobs/{job}/arm", {})["state"] == "armed", "an admin may")
    bench.end()


if __name__ == "__main__":
    in_folder(receipts_are_decided_once)
    in_folder(requests_are_answered)
    in_folder(a_drip_feed_is_armed_by_a_person)
    in_folder(some_numbers_have_a_right_of_their_own)
    sys.exit(0)
