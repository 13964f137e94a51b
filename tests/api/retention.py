"""What is deleted and what stays: an archived program goes for good after its time, its name is free, and jobs, ledger and audit say what they said.
And the limits of a shop: a text, a file, the whole store."""

import subprocess
import sys

from client import DC1, Client, HandControl, binary, expect, hand_profile, in_folder, plain_program


def archived(client, name, blocks=20):
    program = client.add_program(blocks, name)
    client.post(f"/programs/{program['id']}/archive", {"reason": "sold"})
    return program["id"]


def not_too_soon(folder):
    """Thirty days are the standard."""
    client = Client(folder / "soon").start()
    program = archived(client, "O0001")
    problem = client.refuse(409, "POST", f"/programs/{program}/delete", {"reason": "sold"}, "approver", words=["too short a time ago"])
    expect(problem["code"] == "wrong_state", f"{problem}")
    client.server.stop()


def deleted(folder):
    control = HandControl()
    client = Client(folder / "shop", "--delete-after-days", "0").start()
    client.post("/machines", hand_profile(control))
    unused = client.add_program(30, "O0030")["id"]
    client.refuse(409, "POST", f"/programs/{unused}/delete", {"reason": "sold"}, "approver", words=["archive it first"])
    client.post(f"/programs/{unused}/archive", {"reason": "sold"})
    client.refuse(422, "POST", f"/programs/{unused}/delete", {"reason": ""}, "approver")
    client.refuse(403, "POST", f"/programs/{unused}/delete", {"reason": "sold"}, "programmer")
    attachment = client.call("POST", f"/attachments?program={unused}&name=a.pdf", b"%PDF", headers={"Content-Type": "application/pdf"}).document
    gone = client.must("POST", f"/programs/{unused}/delete", {"reason": "no one makes it"}, "approver")
    expect(gone["deleted"]["reason"] == "no one makes it" and gone["deleted"]["by"] == "the approver" and gone["revision"] == 0, f"{gone}")
    expect(client.get(f"/programs/{unused}")["deleted"] == gone["deleted"], "what it was is forgotten")
    expect(client.get(f"/attachments/{attachment['id']}")["removed"]["reason"] == "no one makes it", "its file")
    client.refuse(404, "GET", f"/programs/{unused}/text")
    client.refuse(404, "GET", f"/programs/{unused}/lines")
    client.refuse(409, "POST", f"/programs/{unused}/fetch-back", {"reason": "again"})
    client.refuse(409, "PATCH", f"/programs/{unused}", {"folder": "acme"})
    client.refuse(409, "POST", f"/programs/{unused}/delete", {"reason": "again"}, "approver")
    client.refuse(409, "POST", f"/programs/{unused}/revisions", {"text": "M30"}, headers={"If-Match": '"0"'})
    client.refuse(409, "POST", f"/attachments?program={unused}&name=a.pdf", b"%PDF")
    for shelf in ("in_use", "archived", "all"):
        expect(client.get(f"/programs?shelf={shelf}")["items"] == [], f"it is still on the shelf {shelf}")
    expect(client.get("/search?q=O0030&shelf=all")["items"] == [], "it is still found")
    history_stays(client, control, unused)
    client.server.stop()
    control.close()


def history_stays(client, control, unused):
    program = client.add_program(20, "O0030")["id"]
    expect(program > unused, "its id came back")
    release = client.release(program)["id"]
    job = client.queue(release)
    client.refuse(409, "POST", f"/programs/{program}/archive", {"reason": "sold"}, words=[f"job {job}"])
    client.wait_line("lathe", "idle")
    client.post(f"/jobs/{job}/arm")
    control.say(DC1)
    client.wait_job(job, "done")
    client.post(f"/releases/{release}/transitions", {"to": "obsolete"})
    text = client.call("GET", f"/programs/{program}/text").body
    client.post(f"/programs/{program}/archive", {"reason": "sold"})
    before = {path: client.get(path) for path in (f"/jobs/{job}", f"/jobs/{job}/ledger", f"/releases/{release}")}
    client.must("POST", f"/programs/{program}/delete", {"reason": "sold"}, "approver")
    client.restart()  # drops texts that nothing refers to
    for path, answer in before.items():
        expect(client.get(path) == answer, f"{path} is another: {client.get(path)}")
    expect(client.call("GET", f"/programs/{program}/text").body == text, "what was fed is not known any more")
    expect(client.post("/store/verify")["faults"] == [], "the store has faults")
    rows = [row["action"] for row in client.get(f"/audit?subject=program/{program}")["items"]]
    expect(rows[0] == "program.delete" and rows[-1] == "program.add", f"the audit: {rows}")
    tree = client.server.data.parent / "tree"
    tree.mkdir()
    (tree / "O0030.NC").write_text(plain_program(5, "O0030"))
    done = subprocess.run([str(binary()), "import", str(tree), "--data", str(client.server.data)], capture_output=True, text=True, timeout=30)
    expect(done.returncode == 0 and done.stdout.startswith("added "), f"its name is not free: {done.stdout} {done.stderr}")


def limits(folder):
    client = Client(folder / "small", "--program-mb", "1", "--attachment-mb", "1", "--store-mb", "2").start()
    mega = 1 << 20
    program = client.post("/programs", {"name": "O1", "dialect": "fanuc", "text": "(" + "A" * (mega - 10) + ")"})["id"]
    for method, path, body, headers in (("POST", "/programs", {"name": "O2", "dialect": "fanuc", "text": "A" * (mega + 1)}, {}),
                                        ("POST", f"/programs/{program}/revisions", {"text": "A" * (mega + 1)}, {"If-Match": '"1"'}),
                                        ("POST", f"/attachments?program={program}&name=a.pdf", b"a" * (mega + 1), {})):
        problem = client.refuse(413, method, path, body, headers=headers, words=[str(mega)])
        expect(problem["code"] == "too_large", f"{problem}")
    first = client.call("POST", f"/attachments?program={program}&name=a.pdf", b"a" * mega)
    expect(first.status == 201, f"{first}")
    for path, body in ((f"/attachments?program={program}&name=b.pdf", b"b" * 100), ("/programs", {"name": "O3", "dialect": "fanuc", "text": "M30 (" + "B" * 100 + ")"})):
        problem = client.refuse(507, "POST", path, body, words=[str(2 * mega)])
        expect(problem["code"] == "over_quota", f"{problem}")
    report = client.must("POST", "/imports?path=O4.nc", b"M30 (" + b"C" * 100 + b")")
    expect(report["failed"] == 1 and str(2 * mega) in report["items"][0]["why"], f"{report}")
    expect(len(client.get("/programs")["items"]) == 1 and len(client.get("/attachments")["items"]) == 1, "something over the limit is stored")
    client.server.stop()


def main(folder):
    not_too_soon(folder)
    deleted(folder)
    limits(folder)


if __name__ == "__main__":
    in_folder(main)
    sys.exit(0)
