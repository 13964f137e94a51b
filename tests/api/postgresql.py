"""A server whose store is on PostgreSQL: a job is fed and kept, the database is started again under it, a second server is refused, and a server that
is started without its store feeds nothing. The test starts a database server of its own, at a socket in its folder."""

import functools
import os
import pathlib
import pwd
import shutil
import signal
import subprocess
import tempfile

from client import DC1, Client, HandControl, binary, expect, hand_profile, in_folder, shop

BIN = sorted(pathlib.Path("/usr/lib/postgresql").glob("*/bin"))[-1]
USER = "postgres" if os.geteuid() == 0 else pwd.getpwuid(os.geteuid()).pw_name  # PostgreSQL refuses root


class Database:
    """initdb and postgres. Not below the test's folder, which its user may not enter."""

    def __init__(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="dripfeed_postgresql_"))
        shutil.chown(self.folder, USER)
        self.run("initdb", "-D", self.folder / "data", "-U", "dnc", "-A", "trust", "--no-sync", "-E", "UTF8", "--locale=C.UTF-8")
        self.process = None
        self.start()

    def add(self, name):
        """The address of a new one."""
        self.run("createdb", "-h", self.folder, "-U", "dnc", name)
        return f"postgresql:///{name}?host={self.folder}&user=dnc"

    def as_user(self):
        return {"user": USER, "group": pwd.getpwnam(USER).pw_gid, "extra_groups": []} if os.geteuid() == 0 else {}

    def run(self, name, *arguments):
        subprocess.run([BIN / name, *arguments], check=True, cwd=self.folder, stdout=subprocess.DEVNULL, timeout=120, **self.as_user())

    def start(self):
        log = open(self.folder / "log", "ab")
        self.process = subprocess.Popen([BIN / "postgres", "-D", self.folder / "data", "-k", self.folder, "-c", "listen_addresses="], cwd=self.folder,
                                        stdout=log, stderr=log, **self.as_user())
        log.close()
        shop.wait_for("the database", lambda: subprocess.run([BIN / "pg_isready", "-q", "-h", self.folder], timeout=30).returncode == 0)

    def children(self):
        with open(f"/proc/{self.process.pid}/task/{self.process.pid}/children", encoding="ascii") as file:
            return [int(one) for one in file.read().split()]

    def stop(self):
        self.process.send_signal(signal.SIGINT)  # it ends connections and itself
        self.process.wait(60)

    def end(self):
        self.process.send_signal(signal.SIGQUIT)
        self.process.wait(60)
        shutil.rmtree(self.folder)


def await_answers(client):
    """Until the server has found that its database answers again: till then it refuses what needs it."""
    shop.wait_for("the database to be asked again", lambda: client.call("GET", "/jobs").status == 200)


def feed(client, control, release):
    job = client.queue(release)
    client.wait_line("lathe", "idle")
    client.post(f"/jobs/{job}/arm")
    control.say(DC1)
    return job


def a_job_is_fed_and_kept(folder, database):
    control, client = HandControl(), Client(folder, "--store", database.add("kept")).start()
    client.post("/machines", hand_profile(control))
    release = client.release(client.add_program(30)["id"])["id"]
    client.wait_job(feed(client, control, release), "done")
    client.restart()
    before = client.everything()
    expect(before["jobs"][0]["state"] == "done", f"{before['jobs']}")
    database.stop()
    database.start()
    await_answers(client)
    expect(client.everything() == before, "another store after the database was started again")
    client.add_program(5, "O0099")
    said = subprocess.run([str(binary()), "ledger", "verify", *client.store], capture_output=True, text=True, timeout=60)
    expect(said.returncode == 0 and "whole" in said.stdout, f"{said}")
    expect("the viewer" in client.token_command("list"), "tokens of another store")
    client.server.kill()
    client.server.start()
    expect(len(client.get("/programs")["items"]) == 2, "a program is lost")
    client.server.stop()


def a_kill_while_it_feeds_leaves_a_torn_line(folder, database):
    control, client = HandControl(), Client(folder, "--store", database.add("torn")).start()
    client.post("/machines", hand_profile(control, "mill"))
    release = client.release(client.add_program(3000, "O0777")["id"], "mill")["id"]
    job = client.queue(release)
    client.wait_line("mill", "idle")
    client.post(f"/jobs/{job}/arm")
    control.say(DC1)
    control.wait_bytes(50)
    client.server.kill()
    client.server.start()
    ended = client.wait_job(job, "interrupted")
    expect(ended["torn"], f"{ended}")
    client.server.stop()


def one_server_has_it(folder, database):
    url = database.add("owned")
    client = Client(folder, "--store", url).start()
    other = serve(folder / "other", "--store", url)
    expect(other.returncode == 2 and "another server" in other.stderr, f"{other}")
    client.server.stop()


def a_folder_has_one_store(folder, database):
    url = database.add("elsewhere")
    Client(folder, "--store", url).start().server.stop()
    without = serve(folder / "data")
    expect(without.returncode == 2 and "--store" in without.stderr, f"{without}")
    own = Client(folder / "own").start()
    own.server.stop()
    both = serve(own.server.data, "--store", url)
    expect(both.returncode == 2 and "another folder" in both.stderr, f"{both}")


def serve(data, *arguments):
    """What a server says that does not start."""
    return subprocess.run([str(binary()), "serve", "--data", str(data), "--listen", "127.0.0.1:0", *arguments], capture_output=True, text=True, timeout=60)


if __name__ == "__main__":
    made = Database()
    try:
        for test in (a_job_is_fed_and_kept, a_kill_while_it_feeds_leaves_a_torn_line, one_server_has_it, a_folder_has_one_store):
            in_folder(functools.wraps(test)(lambda folder, test=test: test(folder, made)))
    finally:
        made.end()
