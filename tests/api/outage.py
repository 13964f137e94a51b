"""The database of the store goes away while a line is fed: killed, stopped, and frozen. The feed goes on to its end, what it did is booked when
the database is back, and a server that is killed meanwhile knows afterwards what may have left."""

import functools
import os
import signal
import subprocess
import threading
import time

from client import DC1, DC3, Client, HandControl, binary, expect, hand_profile, in_folder, plain_program, shop
from postgresql import Database, await_answers

BLOCKS = 500  # 7 s at 19200 baud
LONGEST_GAP_S = 1.5  # 0.41 s were seen while other tests ran; what waits for the database waits until it is back


class Fed:
    """A server on a database with one job that is being fed."""

    def __init__(self, folder, database, name):
        self.database, self.control = database, HandControl()
        self.client = Client(folder, "--store", database.add(name)).start()
        self.client.post("/machines", hand_profile(self.control))
        self.release = self.client.release(self.client.add_program(BLOCKS)["id"])["id"]
        self.job = self.begin()
        self.control.wait_bytes(1500)

    def begin(self):
        job = self.client.queue(self.release)
        self.client.wait_line("lathe", "idle")
        self.client.post(f"/jobs/{job}/arm")
        self.control.say(DC1)
        return job

    def rest_arrives_without_a_stop(self, check_gaps=True):
        """All of the text without a long pause: nothing waited for the database, which stays away until the text has arrived."""
        with self.control.lock:
            self.control.gaps_s = []
        text = plain_program(BLOCKS).strip()
        shop.wait_for("the end of the text", lambda: self.control.text().decode().strip().endswith("M30\n%"))
        expect(self.control.text().decode().strip() == text, "another text arrived")
        expect(not check_gaps or max(self.control.gaps_s) < LONGEST_GAP_S, f"the feed stood still for {max(self.control.gaps_s):.2f} s")

    def is_booked_whole(self):
        await_answers(self.client)
        done = self.client.wait_job(self.job, "done")
        expect(not done["torn"], f"{done}")
        rows = self.booked_rows(done)
        said = subprocess.run([str(binary()), "ledger", "verify", *self.client.store], capture_output=True, text=True, timeout=60)
        expect(said.returncode == 0 and "whole" in said.stdout, f"{said}")
        return rows

    def booked_rows(self, done):
        interval = self.client.get(f"/jobs/{self.job}/ledger")["interval"]
        expect(interval["low"] == interval["high"] == done["bytes"], f"before it is booked: {interval}")
        shop.wait_for("all rows to be booked", lambda: self.rows()[-1]["clocked"] == self.rows()[-1]["reserve"] == done["bytes"] or None)
        return self.rows()

    def rows(self):
        found, after = [], ""
        while True:
            page = self.client.get(f"/jobs/{self.job}/ledger?limit=200{after}")
            found += page["items"]
            if not page["next"]:
                return found
            after = f"&after={page['next']}"

    def log(self):
        return (self.client.server.data / "server.log").read_text()


def a_feed_outlives_a_killed_database(folder, database):
    fed = Fed(folder, database, "outage_killed")
    database.process.send_signal(signal.SIGQUIT)
    database.process.wait(60)
    fed.rest_arrives_without_a_stop()
    time.sleep(1)  # of the job's end nothing is in the database yet
    database.start()
    rows = fed.is_booked_whole()
    at_ms = [row["at_ms"] for row in rows]
    expect(at_ms == sorted(at_ms) and len(rows) > 20, f"rows of the outage are missing: {len(rows)}")
    expect("the database does not take it" in fed.log() and "takes it again" in fed.log(), "the log does not report it")
    fed.client.restart()
    expect(fed.rows() == rows, "a restart booked rows twice")
    fed.client.server.stop()


class Frozen:
    """The database takes connections and bytes, and answers nothing."""

    def __init__(self, database):
        self.database = database

    def __enter__(self):
        self.processes = [self.database.process.pid, *self.database.children()]
        for process in self.processes:
            os.kill(process, signal.SIGSTOP)

    def __exit__(self, *_):
        for process in self.processes:
            os.kill(process, signal.SIGCONT)


def a_feed_outlives_a_frozen_database(folder, database):
    fed = Fed(folder, database, "outage_frozen")
    with Frozen(database):
        fed.rest_arrives_without_a_stop()
    fed.is_booked_whole()
    fed.client.server.stop()


def a_person_stops_it_while_the_database_is_frozen(folder, database):
    """Who waits for the database when it falls silent gives up after some seconds; who comes later does not wait at all."""
    fed = Fed(folder, database, "outage_silent")

    def timed(*request):
        begun = time.monotonic()
        return fed.client.call(*request), time.monotonic() - begun
    with Frozen(database):
        # Reads that wait for the database do not keep the server from hearing of the stop.
        readers = [threading.Thread(target=fed.client.call, args=("GET", "/machines")) for _ in range(20)]
        for reader in readers:
            reader.start()
        answer, took_s = timed("POST", f"/jobs/{fed.job}/stop")
        expect(answer.status == 503 and "stops at a block end" in answer.document["detail"], f"{answer}")
        expect(took_s < 10, f"the stop took {took_s:.1f} s")
        stopped = fed.control.wait_quiet()
        expect(stopped.endswith(b"\n") and len(stopped) < 12_000, f"it was not stopped at a block end: {stopped[-40:]}")
        for reader in readers:
            reader.join()
        answer, took_s = timed("GET", "/jobs")
        expect(answer.status == 503 and "does not answer" in answer.document["detail"] and took_s < 2, f"{answer} after {took_s:.1f} s")
        expect(fed.client.call("POST", f"/jobs/{fed.job}/resume").status == 503, "it goes on without a row in the audit")
    await_answers(fed.client)
    fed.client.wait_job(fed.job, "held", "feeding")
    expect(fed.control.text() == stopped, "a line that was stopped goes on")
    fed.client.post(f"/jobs/{fed.job}/resume")
    fed.rest_arrives_without_a_stop(check_gaps=False)
    fed.is_booked_whole()
    fed.client.server.stop()


def a_server_killed_without_its_database_knows_what_left(folder, database):
    fed = Fed(folder, database, "outage_both")
    database.stop()
    fed.control.wait_bytes(len(fed.control.text()) + 3000)  # more than was reserved in the database
    fed.control.say(DC3)
    fed.control.wait_quiet()
    fed.client.server.kill()
    arrived = len(fed.control.text())
    database.start()
    fed.client.server.start()
    job = fed.client.wait_job(fed.job, "interrupted")
    last = fed.rows()[-1]
    expect(last["clocked"] <= arrived <= last["reserve"], f"{arrived} bytes arrived, the ledger knows {last}")
    expect(last["clocked"] > 3000, f"what left without the database is not booked: {last}")
    expect(job["torn"], f"{job}")
    expect(fed.client.get("/machines/lathe")["status"]["line"] == "torn", "a line that may be torn is ready")
    fed.client.server.stop()


def nothing_is_armed_without_the_database(folder, database):
    fed = Fed(folder, database, "outage_arming")
    second = fed.client.queue(fed.release)
    database.stop()
    answer = fed.client.call("POST", f"/jobs/{second}/arm")
    expect(answer.status == 503, f"{answer}")
    fed.rest_arrives_without_a_stop()
    database.start()
    fed.is_booked_whole()
    expect(fed.client.job(second)["state"] == "queued", "it was armed all the same")
    fed.client.server.stop()


def a_person_stops_it_without_the_database(folder, database):
    fed = Fed(folder, database, "outage_stop")
    fed.client.tokens["stranger"] = fed.client.add_token("operator", "who never called")
    database.stop()
    refused = fed.client.call("POST", f"/jobs/{fed.job}/stop", role="stranger")
    expect(refused.status == 503, f"the server claims to know a token: {refused}")
    answer = fed.client.call("POST", f"/jobs/{fed.job}/stop")
    expect(answer.status == 503 and "stops at a block end" in answer.document["detail"], f"{answer}")
    stopped = fed.control.wait_quiet()
    expect(stopped.endswith(b"\n") and len(stopped) < 12_000, f"it was not stopped at a block end: {stopped[-40:]}")
    expect(fed.client.call("POST", f"/jobs/{fed.job}/resume").status == 503, "it goes on without a row in the audit")
    time.sleep(0.5)
    expect(fed.control.text() == stopped, "a line that was stopped goes on")
    database.start()
    await_answers(fed.client)
    fed.client.wait_job(fed.job, "held", "feeding")
    fed.client.post(f"/jobs/{fed.job}/resume")
    fed.rest_arrives_without_a_stop(check_gaps=False)
    fed.is_booked_whole()
    fed.client.server.stop()


if __name__ == "__main__":
    made = Database()
    try:
        for test in (a_feed_outlives_a_killed_database, a_feed_outlives_a_frozen_database, a_person_stops_it_while_the_database_is_frozen,
                     a_server_killed_without_its_database_knows_what_left,
                     nothing_is_armed_without_the_database, a_person_stops_it_without_the_database):
            in_folder(functools.wraps(test)(lambda folder, test=test: test(folder, made)))
    finally:
        made.end()
