"""HTTPS by the server itself, with a certificate that is renewed while it runs, and behind the real nginx: with the block of docs/operating.md, and with
nothing but proxy_pass."""

import http.client
import json
import os
import pathlib
import re
import shutil
import socket
import ssl
import subprocess
import sys
import time

from rig import ROOT, binary, expect, in_folder, shop

NGINX = shutil.which("nginx") or "/usr/sbin/nginx"
PROGRAM = {"name": "O1", "dialect": "fanuc", "text": "%\nM30\n%\n"}


def make_certificate(folder, name):
    subprocess.run(["openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes", "-days", "2", "-subj", f"/CN={name}",
                    "-addext", "subjectAltName=DNS:dnc.shop,IP:127.0.0.1", "-keyout", str(folder / f"{name}.key"), "-out", str(folder / f"{name}.pem")],
                   check=True, capture_output=True, timeout=60)
    return folder / f"{name}.pem", folder / f"{name}.key"


def free_port():
    with socket.create_server(("127.0.0.1", 0)) as listener:
        return listener.getsockname()[1]


class Serving:
    """dripfeed serve with TLS, started by hand: what it says is read."""

    def __init__(self, folder, *arguments):
        self.data = folder / "data"
        self.log = folder / "serve.log"
        self.process = subprocess.Popen([str(binary()), "serve", "--data", str(self.data), "--listen", "127.0.0.1:0", *map(str, arguments)],
                                        stdout=self.log.open("wb"), stderr=subprocess.STDOUT)
        said = shop.wait_for("the server's address", lambda: re.search(r"(https?)://127\.0\.0\.1:(\d+)/", self.log.read_text()))
        self.scheme, self.port = said[1], int(said[2])
        self.token = (self.data / "first-token").read_text().strip()

    def stop(self):
        self.process.terminate()
        expect(self.process.wait(20) == 0, self.log.read_text())


def call(connection, method, path, body=None, headers=None):
    connection.request(method, path, body=None if body is None else json.dumps(body), headers={"Content-Type": "application/json"} | (headers or {}))
    answer = connection.getresponse()
    return answer.status, answer.headers, answer.read()


def secure(port, trusted, timeout=20):
    context = ssl.create_default_context(cafile=str(trusted))
    return http.client.HTTPSConnection("127.0.0.1", port, timeout=timeout, context=context)


def own_tls(folder):
    first, key = make_certificate(folder, "first")
    certificate, its_key = shutil.copy(first, folder / "cert.pem"), shutil.copy(key, folder / "key.pem")
    server = Serving(folder, "--tls-cert", certificate, "--tls-key", its_key)
    expect(server.scheme == "https", "it does not say https")
    bearer = {"Authorization": f"Bearer {server.token}"}
    connection = secure(server.port, first)
    text = "%\nO1\n" + "G01 X1.\n" * 500_000 + "M30\n%\n"
    status, _, body = call(connection, "POST", "/api/v1/programs", {"name": "O1", "dialect": "fanuc", "text": text}, bearer)
    expect(status == 201, f"{status} {body[:300]}")
    status, _, body = call(connection, "GET", f"/api/v1/programs/{json.loads(body)['id']}/text", headers=bearer)
    expect(status == 200 and body.decode() == text, f"{status}: {len(body)} bytes came back of {len(text)}")
    status, headers, _ = call(connection, "POST", "/api/v1/session", {"token": server.token})
    attributes = headers["Set-Cookie"].split("; ")[1:]
    expect(status == 204 and sorted(attributes) == ["HttpOnly", "Path=/", "SameSite=Strict", "Secure"], f"{status} {attributes}")
    watch(secure(server.port, first), bearer)
    no_plain_http(server.port)
    versions(server.port)
    renewed(folder, server, connection)
    server.stop()


def watch(connection, bearer):
    connection.request("GET", "/api/v1/events", headers=bearer)
    stream = connection.getresponse()
    expect(stream.status == 200 and stream.getheader("Content-Type") == "text/event-stream", f"{stream.status}")
    connection.close()


def no_plain_http(port):
    with socket.create_connection(("127.0.0.1", port), timeout=20) as link:
        link.sendall(b"GET /healthz HTTP/1.1\r\nHost: x\r\n\r\n")
        try:
            expect(b"200 OK" not in link.recv(4096), "plain HTTP is answered")
        except ConnectionResetError:
            pass


def versions(port):
    for version, works in ((ssl.TLSVersion.TLSv1_1, False), (ssl.TLSVersion.TLSv1_2, True), (ssl.TLSVersion.TLSv1_3, True)):
        context = ssl.SSLContext(ssl.PROTOCOL_TLS_CLIENT)
        context.check_hostname, context.verify_mode = False, ssl.CERT_NONE
        context.set_ciphers("ALL:@SECLEVEL=0")
        context.minimum_version, context.maximum_version = version, version
        try:
            with socket.create_connection(("127.0.0.1", port), timeout=20) as link, context.wrap_socket(link):
                done = True
        except (ssl.SSLError, ConnectionError):
            done = False
        expect(done == works, f"{version}: {done}")


def renewed(folder, server, kept):
    """A pair that does not fit changes nothing; the new one is taken without a restart, and who is connected stays so."""
    second, key = make_certificate(folder, "second")
    server_says = lambda: ssl.get_server_certificate(("127.0.0.1", server.port))  # noqa: E731
    before = server_says()
    time.sleep(0.05)
    shutil.copy(second, folder / "cert.pem")
    shop.wait_for("the pair to be refused", lambda: "was not renewed" in server.log.read_text())
    expect(server_says() == before, "a certificate without its key is in use")
    shutil.copy(key, folder / "key.pem")
    shop.wait_for("the new certificate", lambda: server_says() != before)
    expect(call(secure(server.port, second), "GET", "/healthz")[0] == 200, "the new certificate is none")
    expect(call(kept, "GET", "/healthz")[0] == 200, "a connection that was open has ended")


def what_is_refused(folder):
    certificate, key = make_certificate(folder, "first")
    _, other = make_certificate(folder, "other")
    for arguments, word in ((["--tls-cert", certificate], "--tls-key go together"), (["--tls-cert", certificate, "--tls-key", other], f"{other} is not a key"),
                            (["--tls-cert", key, "--tls-key", key], f"{key} is not a certificate"), (["--proxy", "localhost"], "is not an IP address"),
                            (["--listen", "0.0.0.0:0"], "--tls-cert")):
        done = subprocess.run([str(binary()), "serve", "--data", str(folder / "data"), "--listen", "127.0.0.1:0", *map(str, arguments)][: 4 if arguments[0] == "--listen" else None]
                              + ([str(a) for a in arguments] if arguments[0] == "--listen" else []), capture_output=True, text=True, timeout=30)
        expect(done.returncode == 2 and word in done.stderr, f"{arguments}: {done}")
    process = subprocess.Popen([str(binary()), "serve", "--data", str(folder / "open"), "--listen", "0.0.0.0:0", "--tls-cert", str(certificate), "--tls-key", str(key)], stdout=subprocess.PIPE, text=True)
    expect(process.stdout.readline().startswith("dripfeed is at https://0.0.0.0:"), "TLS may not be offered to the network")
    process.terminate()
    expect(process.wait(20) == 0, "its end")


class Nginx:
    def __init__(self, folder, servers):
        self.log = folder / "error.log"
        config = folder / "nginx.conf"
        paths = "".join(f"{kind}_temp_path {folder}/{kind};\n" for kind in ("client_body", "proxy", "fastcgi", "uwsgi", "scgi"))
        config.write_text(f"daemon off; pid {folder}/nginx.pid; error_log {self.log}; worker_processes 1;\nevents {{}}\nhttp {{\naccess_log off;\n{paths}{servers}\n}}\n")
        user = ["-g", "user root;"] if os.geteuid() == 0 else []
        self.process = subprocess.Popen([NGINX, "-c", str(config), "-e", str(self.log), *user])

    def stop(self):
        self.process.terminate()
        self.process.wait(20)


def documented_block(folder, port, server):
    block = re.search(r"```nginx\n(.*?)```", (ROOT / "docs/operating.md").read_text(), re.S)[1]
    certificate, key = make_certificate(folder, "proxy")
    for old, new in (("listen 443 ssl", f"listen 127.0.0.1:{port} ssl"), ("/etc/ssl/dnc.pem", str(certificate)), ("/etc/ssl/dnc.key", str(key)), ("127.0.0.1:8840", f"127.0.0.1:{server.port}")):
        expect(old in block, f"the block of docs/operating.md has no {old}")
        block = block.replace(old, new)
    return block, certificate


def through_nginx(folder):
    expect(pathlib.Path(NGINX).exists(), "nginx is missing: ./deploy/install test installs it")
    server = Serving(folder, "--proxy", "127.0.0.1")
    documented, plain = free_port(), free_port()
    block, certificate = documented_block(folder, documented, server)
    nginx = Nginx(folder, block + f"server {{ listen 127.0.0.1:{plain}; client_max_body_size 64m; location / {{ proxy_pass http://127.0.0.1:{server.port}; }} }}")
    try:
        shop.wait_for("nginx", lambda: answers(plain))
        connection = secure(documented, certificate)
        cookie = sign_in(connection, server, f"https://127.0.0.1:{documented}", {"HttpOnly", "Path=/", "SameSite=Strict", "Secure"})
        here = {"Cookie": cookie, "Origin": f"https://127.0.0.1:{documented}"}
        expect_write(connection, here, 201)
        expect_write(connection, {"Cookie": cookie, "Origin": "https://evil.example"}, 403)
        long = {"name": "O2", "dialect": "fanuc", "text": "G01 X1.\n" * 2_000_000}
        expect(call(connection, "POST", "/api/v1/programs", long, here)[0] == 201, "a long text does not come through")
        events_come_at_once(secure(documented, certificate), connection, server, here)
        connection = http.client.HTTPConnection("127.0.0.1", plain, timeout=20)
        by_browser = {"Cookie": cookie, "Origin": f"https://127.0.0.1:{plain}", "Sec-Fetch-Site": "same-origin"}
        expect_write(connection, by_browser, 201)
        expect_write(connection, by_browser | {"Sec-Fetch-Site": "cross-site"}, 403)
    finally:
        nginx.stop()
    forwarded_by_a_stranger(folder)
    server.stop()


def answers(port):
    try:
        return call(http.client.HTTPConnection("127.0.0.1", port, timeout=5), "GET", "/healthz")[0] == 200
    except OSError:
        return False


def sign_in(connection, server, origin, attributes):
    status, headers, body = call(connection, "POST", "/api/v1/session", {"token": server.token}, {"Origin": origin})
    expect(status == 204, f"{status} {body}")
    cookie, *others = headers["Set-Cookie"].split("; ")
    expect(set(others) == attributes, f"the cookie has {others}")
    return cookie


def expect_write(connection, headers, status):
    got = call(connection, "POST", "/api/v1/programs", PROGRAM, headers)
    expect(got[0] == status, f"{headers}: {got[0]} {got[2][:300]}")


def events_come_at_once(watching, connection, server, here):
    watching.request("GET", "/api/v1/events", headers={"Authorization": f"Bearer {server.token}"})
    stream = watching.getresponse()
    expect(stream.status == 200, f"{stream.status}")
    status, _, body = call(connection, "POST", "/api/v1/machines", dict(shop.preset("fanuc-0i-lathe", url="tcp://127.0.0.1:1"), name="lathe"), here)
    expect(status == 201, f"{status} {body[:300]}")
    begin = time.monotonic()
    while b"event: machine" not in stream.readline():
        expect(time.monotonic() - begin < 10, "no event came through the proxy")
    watching.close()


def forwarded_by_a_stranger(folder):
    """Who is not a named proxy says nothing of the host or of TLS."""
    (folder / "other").mkdir()
    server = Serving(folder / "other")
    connection = http.client.HTTPConnection("127.0.0.1", server.port, timeout=20)
    said = {"X-Forwarded-Host": "dnc.shop", "X-Forwarded-Proto": "https", "Origin": "https://dnc.shop"}
    expect(call(connection, "POST", "/api/v1/session", {"token": server.token}, said)[0] == 403, "a stranger's X-Forwarded-Host is believed")
    status, headers, _ = call(connection, "POST", "/api/v1/session", {"token": server.token}, {"X-Forwarded-Proto": "https"})
    expect(status == 204 and "Secure" not in headers["Set-Cookie"], f"{status} {headers}")
    server.stop()


if __name__ == "__main__":
    for test in (own_tls, what_is_refused, through_nginx):
        in_folder(test)
    sys.exit(0)
