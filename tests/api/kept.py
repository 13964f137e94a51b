"""What the server keeps is never older than the store: a token that another process revokes, a change of any kind, and a line that moves on count with the
next request, however often the same was asked before."""

from client import DC1, Client, HandControl, expect, hand_profile, in_folder, shop


def a_revocation_counts_with_the_next_request(folder):
    client = Client(folder).start()
    name = "the wall"
    token = client.add_token("viewer", name)
    connection, headers = client.connect(), {"Authorization": f"Bearer {token}"}

    def status(path="/api/v1/machines"):
        connection.request("GET", path, headers=headers)
        answer = connection.getresponse()
        answer.read()
        return answer.status
    number = next(line.split()[0] for line in client.token_command("list").splitlines() if name in line)
    for path in ("/api/v1/machines", "/api/v1/programs", "/api/v1/session"):
        for _ in range(50):
            expect(status(path) == 200, f"{path} of a token that is good")
    client.token_command("revoke", number)
    for path in ("/api/v1/machines", "/api/v1/programs", "/api/v1/session"):
        expect(status(path) == 401, f"{path}: a revoked token is let in")
    client.server.stop()


def lists_follow_the_store(folder):
    client = Client(folder).start()

    def asked(path):
        answers = [client.call("GET", path, role="viewer") for _ in range(3)]
        expect(len({answer.body for answer in answers}) == 1, f"{path}: three answers")
        expect(len({answer.headers["ETag"] for answer in answers}) == 1, f"{path}: three tags")
        return answers[0]
    expect(asked("/programs").document["items"] == [], "programs of no one")
    for count in range(1, 6):
        made = client.add_program(10 + count, f"O004{count}")
        expect(len(asked("/programs").document["items"]) == count, "a new program is not in the list")
        expect(asked(f"/programs/{made['id']}").headers["ETag"] == '"1"', "a program's tag")
        client.must("POST", f"/programs/{made['id']}/revisions", {"text": "%\nO0041\nM30\n%\n"}, headers={"If-Match": '"1"'})
        expect(asked(f"/programs/{made['id']}").headers["ETag"] == '"2"', "a program's new tag")
    expect(len(asked("/programs?limit=2").document["items"]) == 2 and len(asked("/programs?limit=3").document["items"]) == 3, "another page")
    expect(client.call("GET", "/programs", role=None).status == 401, "what is kept is given to anybody")
    expect(client.call("HEAD", "/programs", role="viewer").body == b"", "a HEAD with a body")
    client.server.stop()


def the_list_of_machines_follows_lines(folder):
    control, client = HandControl(), Client(folder).start()
    expect(client.get("/machines")["items"] == [], "machines of no one")
    profile = hand_profile(control)
    client.post("/machines", profile)

    def row():
        listed = client.get("/machines")["items"][0]
        alone = client.get("/machines/lathe")
        return listed, alone["status"]

    def same(word, ready):
        """The row of the list says what the machine says, once it is so."""
        def reached():
            listed, status = row()
            return listed if listed["status"] == status and ready(status) else None
        return shop.wait_for(f"the list to say {word}", reached)
    same("idle", lambda status: status["line"] == "idle")
    release = client.release(client.add_program(300)["id"])["id"]
    job = client.queue(release)
    client.post(f"/jobs/{job}/arm")
    listed = same("armed", lambda status: status["line"] == "armed")
    expect(listed["status"]["program"] == "O0042", f"the job's program: {listed['status']}")
    control.say(DC1)
    shop.wait_for("a growing count in the list", lambda: client.get("/machines")["items"][0]["status"]["handed"] > 0)
    control.hold_inside_block()
    control.cut()
    expect(client.wait_job(job, "failed")["needs_confirmation"], "the block is not known as torn")
    same("torn", lambda status: status["line"] == "torn" and status["needs_confirmation"])
    client.post("/machines/lathe/confirm-reset", {"reason": "RESET pressed"})
    same("no more of it", lambda status: not status["needs_confirmation"])
    client.must("PUT", "/machines/lathe", profile | {"title": "Another"}, headers={"If-Match": '"1"'})
    expect(client.get("/machines")["items"][0]["title"] == "Another", "a changed title")
    client.server.stop()
    control.close()


if __name__ == "__main__":
    for test in (a_revocation_counts_with_the_next_request, lists_follow_the_store, the_list_of_machines_follows_lines):
        in_folder(test)
