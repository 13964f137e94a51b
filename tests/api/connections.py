"""HTTP/1.1 on the wire: what is no request is answered with one 400 and the connection is closed, so that nothing can hide after it; connections
are kept, and slow or vanishing clients hold up no other request."""

import re
import socket
import sys
import time

from client import API, Client, ask, expect, in_folder, plain_program

HOST = b"Host: x\r\n"
SECOND = b"GET /healthz HTTP/1.1\r\n" + HOST + b"\r\n"
POST = b"POST /api/v1/session HTTP/1.1\r\n" + HOST
BROKEN = [  # each followed by a request that must not be answered
    b"GARBAGE\r\n\r\n", b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03\r\n\r\n", b"GET\r\n\r\n", b"GET /healthz\r\n\r\n", b"GET /healthz HTTP/3.0\r\n\r\n", b"GET /healthz HTTP/1.1 x\r\n\r\n",
    b"GET /healthz http/1.1\r\n" + HOST + b"\r\n", b"GET  /healthz HTTP/1.1\r\n" + HOST + b"\r\n", b"GET /he\x01althz HTTP/1.1\r\n" + HOST + b"\r\n", b" GET /healthz HTTP/1.1\r\n" + HOST + b"\r\n",
    b"GET healthz HTTP/1.1\r\n" + HOST + b"\r\n", b"GET /a/../healthz HTTP/1.1\r\n" + HOST + b"\r\n", b"GET /%0 HTTP/1.1\r\n" + HOST + b"\r\n",
    b"GET /healthz HTTP/1.1\r\n\r\n", b"GET /healthz HTTP/1.1\r\nHost: a\r\nHost: b\r\n\r\n",
    b"GET /healthz HTTP/1.1\r\n" + HOST + b"No colon\r\n\r\n", b"GET /healthz HTTP/1.1\r\n" + HOST + b"A b: c\r\n\r\n", b"GET /healthz HTTP/1.1\r\n" + HOST + b"A : c\r\n\r\n",
    b"GET /healthz HTTP/1.1\r\n" + HOST + b"A: b\r\n c\r\n\r\n", b"GET /healthz HTTP/1.1\r\n" + HOST + b"A: b\r\n\tTransfer-Encoding: chunked\r\n\r\n", b"GET /healthz HTTP/1.1\r\n A: b\r\n" + HOST + b"\r\n",
    b"GET /healthz HTTP/1.1\r\n" + HOST + b"A: b\x00c\r\n\r\n", b"GET /healthz HTTP/1.1\n" + HOST + b"\n",
    POST + b"Content-Length: 5\r\nTransfer-Encoding: chunked\r\n\r\n0\r\n\r\n", POST + b"Transfer-Encoding: chunked\r\nContent-Length: 5\r\n\r\n0\r\n\r\n",
    POST + b"Content-Length: 2\r\nContent-Length: 40\r\n\r\n{}", POST + b"Content-Length: -1\r\n\r\n", POST + b"Content-Length: 2x\r\n\r\n{}", POST + b"Content-Length: +2\r\n\r\n{}",
    POST + b"Content-Length: 2, 40\r\n\r\n{}", POST + b"Content-Length: 99999999999999999999\r\n\r\n{}",
    POST + b"Transfer-Encoding: chunked\r\n\r\nzz\r\n{}\r\n0\r\n\r\n", POST + b"Transfer-Encoding: chunked\r\n\r\n2\r\n{}xx\r\n0\r\n\r\n", POST + b"Transfer-Encoding: chunked\r\n\r\n-2\r\n{}\r\n0\r\n\r\n",
    POST + b"Transfer-Encoding: chunked\r\n\r\nffffffffffffffff2\r\n{}\r\n0\r\n\r\n", POST + b"Transfer-Encoding: chunked, gzip\r\n\r\n2\r\n{}\r\n0\r\n\r\n",
    POST + b"Transfer-Encoding: gzip, chunked\r\n\r\n2\r\n{}\r\n0\r\n\r\n", POST + b"Transfer-Encoding: chunked\r\nTransfer-Encoding: chunked\r\n\r\n2\r\n{}\r\n0\r\n\r\n",
    POST + b"Transfer-Encoding: xchunked\r\n\r\n2\r\n{}\r\n0\r\n\r\n",
]
TOO_LARGE = [
    (413, POST + b"Content-Length: 67108865\r\n\r\n"), (413, POST + b"Transfer-Encoding: chunked\r\n\r\n4000001\r\n"),
    (431, b"GET /healthz HTTP/1.1\r\n" + HOST + b"A: " + b"x" * 20000 + b"\r\n\r\n"), (431, b"GET /healthz?" + b"x" * 20000 + b" HTTP/1.1\r\n" + HOST + b"\r\n"),
    (431, b"GET /healthz HTTP/1.1\r\n" + HOST + b"".join(b"A%d: x\r\n" % n for n in range(3000)) + b"\r\n"),
]


def raw(client, sent, until_closed=True, seconds=10):
    with socket.create_connection(("127.0.0.1", client.server.port), timeout=seconds) as link:
        link.sendall(sent)
        if until_closed:
            link.shutdown(socket.SHUT_WR)
        got = b""
        try:
            while piece := link.recv(65536):
                got += piece
        except ConnectionResetError:
            pass  # the server closed while bytes of ours were in transit
        return got


def broken_requests(client):
    wrong = []
    for sent in BROKEN:
        got = raw(client, sent + SECOND)
        if not got.startswith(b"HTTP/1.1 400 ") or got.count(b"HTTP/1.1 ") != 1 or b"application/problem+json" not in got or b"Connection: close" not in got:
            wrong.append(f"{sent!r}: {got!r}")
    for status, sent in TOO_LARGE:
        got = raw(client, sent)
        if not got.startswith(b"HTTP/1.1 %d " % status) or got.count(b"HTTP/1.1 ") != 1 or b"application/problem+json" not in got:
            wrong.append(f"{sent[:60]!r}: {got!r}")
    expect(not wrong, f"{len(wrong)} rows:\n" + "\n".join(wrong))
    expect(raw(client, SECOND).startswith(b"HTTP/1.1 200 "), "the request after them is not one: the rows above show nothing")
    for sent in (b"", b"\r\n", b"GET /hea", POST + b"Content-Length: 100\r\n\r\n{", POST + b"Transfer-Encoding: chunked\r\n\r\n5\r\n{"):
        expect(not raw(client, sent).startswith(b"HTTP/1.1 2"), f"half a request was taken: {sent}")


def connections_are_kept(client):
    connection = client.connect()
    headers = {"Authorization": f"Bearer {client.tokens['viewer']}"}
    connection.connect()
    port = connection.sock.getsockname()[1]
    for path, status in [("/healthz", 200), (f"{API}/machines", 200), ("/nothing", 404), (f"{API}/jobs/x", 404), ("/healthz", 200)] * 10:
        for method in ("GET", "HEAD"):
            answer = ask(connection, method, path, None, headers)
            expect(answer.status == status, f"{method} {path}: {answer}")
            expect((answer.body == b"") == (method == "HEAD") and int(answer.headers["Content-Length"]) > 0, f"{method} {path}: {answer}")
    expect(ask(connection, "DELETE", f"{API}/session", None, headers).status == 204, "DELETE")
    refused = ask(connection, "POST", f"{API}/programs", b"x" * 50000, headers)
    expect(refused.status == 403, f"{refused}")
    expect(ask(connection, "GET", "/healthz").status == 200 and connection.sock.getsockname()[1] == port, "the connection was not kept")
    connection.close()
    pipelined = raw(client, SECOND + SECOND.replace(b"/healthz", b"/nothing") + SECOND)
    expect(re.findall(rb"HTTP/1\.1 (\d+) ", pipelined) == [b"200", b"404", b"200"], f"{pipelined}")
    for sent in (SECOND.replace(HOST, HOST + b"Connection: close\r\n"), b"GET /healthz HTTP/1.0\r\n\r\n"):
        answer = raw(client, sent + SECOND, until_closed=False)
        expect(answer.count(b"HTTP/1.1 ") == 1 and b"Connection: close" in answer, f"{answer}")


def bodies_in_chunks(client):
    text = plain_program(3)
    body = (b'{"name":"O1","dialect":"fanuc","text":"' + text.replace("\n", "\\n").encode() + b'"}')
    pieces = b"".join(b"%x\r\n%s\r\n" % (len(piece), piece) for piece in (body[:1], body[1:50], body[50:])) + b"0\r\n\r\n"
    head = b"POST /api/v1/programs HTTP/1.1\r\n" + HOST + f"Authorization: Bearer {client.tokens['programmer']}\r\n".encode()
    answer = raw(client, head + b"Transfer-Encoding: chunked\r\n\r\n" + pieces)
    expect(answer.startswith(b"HTTP/1.1 201 "), f"{answer}")
    program = client.get("/programs")["items"][0]["id"]
    expect(client.call("GET", f"/programs/{program}/text").body.decode() == text, "a body in chunks came otherwise")


def long_bodies_are_for_those_who_may(client):
    """The answer comes at the head, before any of 60 MB is sent."""
    for path, role, status in [("/api/v1/programs", None, 401), ("/api/v1/programs", "viewer", 403), ("/api/v1/nothing", "admin", 404), ("/api/v1/machines/x", "admin", 405),
                               ("/api/v1/session", None, 413), ("/api/v1/session", "admin", 413)]:
        head = f"POST {path} HTTP/1.1\r\nHost: x\r\n" + (f"Authorization: Bearer {client.tokens[role]}\r\n" if role else "")
        answer = raw(client, f"{head}Content-Length: 60000000\r\n\r\n".encode(), until_closed=False)
        expect(answer.startswith(b"HTTP/1.1 %d " % status) and b"Connection: close" in answer, f"{path} as {role}: {answer}")
        chunked = f"{head}Transfer-Encoding: chunked\r\n\r\n".encode()
        answer = raw(client, chunked + b"20000\r\n", until_closed=False)
        expect(answer.startswith(b"HTTP/1.1 413 "), f"{path} as {role} in chunks: {answer}")
        answer = raw(client, chunked + b"2\r\n{}\r\n0\r\n\r\n")
        expect(answer.startswith(b"HTTP/1.1 %d " % (422 if status == 413 else status)), f"{path} as {role} in short chunks: {answer}")


def no_one_is_held_up(client):
    """Fifty who sent half a request, ten who do not read a large answer, ten who vanish in the middle of theirs."""
    text = plain_program(120000)
    large = client.post("/programs", {"name": "O9", "dialect": "fanuc", "text": text})["id"]
    ask_large = f"GET {API}/programs/{large}/text HTTP/1.1\r\nHost: x\r\nAuthorization: Bearer {client.tokens['viewer']}\r\n\r\n".encode()
    half = [socket.create_connection(("127.0.0.1", client.server.port)) for _ in range(50)]
    for link in half:
        link.sendall(b"GET /healthz HTTP/1.1\r\nHo")
    deaf = []
    for _ in range(10):
        link = socket.socket()
        link.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        link.connect(("127.0.0.1", client.server.port))
        link.sendall(ask_large)
        deaf.append(link)
    for _ in range(10):
        with socket.create_connection(("127.0.0.1", client.server.port)) as link:
            link.sendall(ask_large)
            link.recv(10)
    begin = time.monotonic()
    expect(client.call("GET", f"/programs/{large}/text").body.decode() == text, "a large text came otherwise")
    for _ in range(20):
        expect(client.call("GET", "/machines", role="viewer").status == 200, "others are held up")
    expect(time.monotonic() - begin < 20, f"twenty short requests took {time.monotonic() - begin:.1f} s")
    half[0].sendall(b"st: x\r\n\r\n")
    half[0].settimeout(10)
    expect(half[0].recv(100).startswith(b"HTTP/1.1 200"), "a slow request is not answered")
    expect(read_all(deaf[0]).endswith(b"%\n\r\n0\r\n\r\n"), "a slow reader does not get the end")
    for link in half + deaf:
        link.close()


def read_all(link):
    link.settimeout(10)
    got = b""
    while not got.endswith(b"\r\n0\r\n\r\n"):
        piece = link.recv(65536)
        expect(piece, f"the connection ended after {len(got)} bytes")
        got += piece
    return got


def on_the_wire(folder):
    client = Client(folder).start()
    for test in (broken_requests, connections_are_kept, bodies_in_chunks, long_bodies_are_for_those_who_may, no_one_is_held_up):
        test(client)
        expect(client.server.alive() and client.call("GET", "/healthz", role=None).status == 200, f"the server is gone after {test.__name__}")
    client.server.stop()


if __name__ == "__main__":
    in_folder(on_the_wire)
    sys.exit(0)
