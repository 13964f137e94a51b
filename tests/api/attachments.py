"""Files of programs, families, parts and orders: every byte comes back, none of it as a page; who may attach and remove; what is refused before it is
read or stored, and what a removed file leaves."""

import hashlib
import random
import sys

from client import ROLL, Client, expect, in_folder

LIMIT = 64 << 20


def attach(client, owner, name, body, kind="application/pdf", role="programmer", **headers):
    return client.call("POST", f"/attachments?name={name}&{owner}", body, role, {"Content-Type": kind} | {key.replace("_", "-"): value for key, value in headers.items()})


def attached(client, owner, name, body, kind="application/pdf", **headers):
    answer = attach(client, owner, name, body, kind, **headers)
    expect(answer.status == 201, f"{name} of {owner}: {answer}")
    return answer.document


def content(client, attachment, role="viewer"):
    answer = client.call("GET", f"/attachments/{attachment['id']}/content", role=role)
    expect(answer.status == 200, f"the content of {attachment}: {answer}")
    return answer


def names(client, owner=""):
    return [one["name"] for one in client.get(f"/attachments{owner}")["items"]]


def each_owner(client):
    program = client.add_program()["id"]
    client.post("/families", {"text": ROLL})
    client.post("/parts", {"number": "R-1", "family": "hyperbolic-roll", "values": {}})
    order = client.post("/orders", {"number": "A-1", "part": "R-1", "quantity": 5})["id"]
    owners = {f"program={program}": ("program", program), "family=hyperbolic-roll": ("family", "hyperbolic-roll"), "part=R-1": ("part", "R-1"), f"order={order}": ("order", order)}
    for n, (query, (member, key)) in enumerate(owners.items()):
        made = attached(client, query, f"{n}.pdf", b"%PDF-1.4 of " + query.encode())
        expect({owner: made[owner] for owner in ("program", "family", "part", "order")} == dict.fromkeys(("program", "family", "part", "order")) | {member: key}, f"{query}: {made}")
        expect(names(client, f"?{query}") == [f"{n}.pdf"], f"{query}: {names(client, '?' + query)}")
        expect(content(client, made).body == b"%PDF-1.4 of " + query.encode(), f"other bytes of {query}")
    expect(names(client) == ["3.pdf", "2.pdf", "1.pdf", "0.pdf"], f"the list: {names(client)}")
    expect(len(client.get("/attachments?limit=3")["items"]) == 3, "a page of three")
    return program


def every_byte(client, program):
    """Short ones come in memory, long ones through a file; both are read back as they were."""
    for size in (1, 65536, 65537, (1 << 20) + 1, 5 << 20):
        body = random.Random(size).randbytes(size)
        made = attached(client, f"program={program}", f"{size}.bin", body, "application/x-own", Idempotency_Key=f"of {size}")
        expect(made["bytes"] == size and made["sha256"] == hashlib.sha256(body).hexdigest(), f"{size} bytes: {made}")
        expect(content(client, made).body == body, f"{size} bytes came back otherwise")
        again = attached(client, f"program={program}", f"{size}.bin", body, "application/x-own", Idempotency_Key=f"of {size}")
        expect(again == made, f"the same again under its key: {again}")
        answer = attach(client, f"program={program}", f"{size}.bin", body[:-1] + b"x" if body[-1:] != b"x" else body + b"y", Idempotency_Key=f"of {size}")
        expect(answer.status == 422 and answer.document["code"] == "key_reused", f"another file under the key: {answer}")


def never_a_page(client, program):
    """What a browser would run is handed out as bytes to be saved."""
    rows = [("image/png", "image/png"), ("IMAGE/JPEG ; q=1", "image/jpeg"), ("text/plain; charset=latin1", "text/plain; charset=utf-8"), ("text/html", "application/octet-stream"),
            ("image/svg+xml", "application/octet-stream"), ("application/xhtml+xml", "application/octet-stream"), ("text/javascript", "application/octet-stream"),
            ("no type", "application/octet-stream"), ("a/b\tc", "application/octet-stream")]
    for n, (stated, served) in enumerate(rows):
        answer = content(client, attached(client, f"program={program}", f"type {n}".replace(" ", "%20"), b"<script>alert(1)</script>", stated))
        expect(answer.headers["Content-Type"] == served, f"{stated} is served as {answer.headers['Content-Type']}")
        expect(answer.headers["X-Content-Type-Options"] == "nosniff", f"{stated} may be guessed at")
        expect(answer.headers["Content-Disposition"].startswith("attachment;"), f"{stated}: {answer.headers['Content-Disposition']}")
        expect("sandbox" in answer.headers["Content-Security-Policy"], f"{stated}: {answer.headers['Content-Security-Policy']}")
    made = attached(client, f"program={program}", "Zeichnung%20%22M%C3%BCller%22%3B%20x.pdf", b"1")
    expect(made["name"] == 'Zeichnung "Müller"; x.pdf', f"the name: {made}")
    disposition = content(client, made).headers["Content-Disposition"]
    expect(disposition == "attachment; filename=\"Zeichnung _M__ller__ x.pdf\"; filename*=UTF-8''Zeichnung%20%22M%C3%BCller%22%3B%20x.pdf", disposition)


def what_is_refused(client, program):
    before = client.get("/attachments")
    for role in ("viewer", "operator"):
        expect(attach(client, f"program={program}", "a.pdf", b"1", role=role).status == 403, f"attached by a {role}")
    rows = [(422, "", "a.pdf", b"1"), (422, f"program={program}&part=R-1", "a.pdf", b"1"), (404, "program=999", "a.pdf", b"1"), (404, "part=R-9", "a.pdf", b"1"),
            (404, "family=none", "a.pdf", b"1"), (404, "order=999", "a.pdf", b"1"), (422, "program=x", "a.pdf", b"1"), (422, f"program={program}", "", b"1"),
            (422, f"program={program}", "..", b"1"), (422, f"program={program}", "a%2Fb", b"1"), (422, f"program={program}", "a%5Cb", b"1"), (422, f"program={program}", "a%0Ab", b"1"),
            (422, f"program={program}", "a.pdf", b""), (409, f"program={program}", "0.pdf", b"1"), (413, f"program={program}", "a.pdf", b"0" * (LIMIT + 1))]
    for status, owner, name, body in rows:
        answer = attach(client, owner, name, body)
        expect(answer.status == status, f"{name!r} of {owner!r} with {len(body)} bytes: expected {status}, got {answer}")
    expect(attach(client, f"program={program}", "a.pdf", b"1", Content_Encoding="gzip").status == 415, "an encoded file")
    expect(client.get("/attachments") == before, "something of it was stored")


def what_is_removed(client, program):
    made = client.get(f"/attachments?program={program}")["items"][-1]
    expect(made["name"] == "0.pdf" and made["removed"] is None, f"the first: {made}")
    client.refuse(422, "POST", f"/attachments/{made['id']}/remove", {"reason": ""})
    removed = client.must("POST", f"/attachments/{made['id']}/remove", {"reason": "of the old fixture"}, "programmer")
    expect(removed["removed"]["reason"] == "of the old fixture" and removed["removed"]["by"] == "the programmer", f"removed: {removed}")
    expect("0.pdf" not in names(client, f"?program={program}"), "it is still in the list")
    expect(client.get(f"/attachments/{made['id']}") == removed, "what it was is forgotten")
    client.refuse(404, "GET", f"/attachments/{made['id']}/content", words=["the old fixture", "the programmer"])
    client.refuse(409, "POST", f"/attachments/{made['id']}/remove", {"reason": "again"})
    again = attached(client, f"program={program}", "0.pdf", b"another")
    rows = client.get(f"/audit?subject=attachment/{made['id']}")["items"]
    expect([row["action"] for row in rows] == ["attachment.remove", "attachment.add"], f"the audit: {rows}")
    client.restart()  # drops bytes that nothing refers to
    expect(content(client, again).body == b"another", "the new one after a restart")
    expect(client.get(f"/attachments/{made['id']}")["sha256"] == made["sha256"], "the removed one after a restart")
    expect(client.post("/store/verify")["faults"] == [], "the store has faults")


def main(folder):
    client = Client(folder).start()
    program = each_owner(client)
    every_byte(client, program)
    never_a_page(client, program)
    what_is_refused(client, program)
    what_is_removed(client, program)
    client.server.stop()


if __name__ == "__main__":
    in_folder(main)
    sys.exit(0)
