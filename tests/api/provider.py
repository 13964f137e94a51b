"""OpenID Connect providers for the tests of signing in: Glewlwyd, as its Debian package brings it, with a shop's users; and one that the test plays
by hand, which answers right until a test makes it lie. Neither runs before a test asks for it."""

import base64
import hashlib
import http.client
import http.server
import json
import pathlib
import shutil
import sqlite3
import ssl
import subprocess
import threading
import time
import urllib.parse

import jwt
from cryptography.hazmat.primitives import serialization as form
from cryptography.hazmat.primitives.asymmetric import ec, rsa

from client import expect, shop

CLIENT, SECRET = "dripfeed", "the secret of the client & more"
PLAIN_SECRET = "a-plain.secret_42"  # Glewlwyd compares what comes in the header as it is, without the decoding of RFC 6749, 2.3.1
TABLES = pathlib.Path("/usr/share/dbconfig-common/data/glewlwyd/install/sqlite3")
MODULES = ("user", "client", "scheme", "plugin")
WEBAPP, CONFIG = pathlib.Path("/usr/share/glewlwyd/webapp"), pathlib.Path("/etc/glewlwyd/config-2.7.json/config.json")
TYPES = {".html": "text/html", ".css": "text/css", ".js": "application/javascript", ".json": "application/json", ".woff2": "font/woff2"}


class Glewlwyd:
    """The package's program on a port and a database of its own. Its users have groups, which are a claim of the ID token."""

    def __init__(self, folder, redirect):
        self.folder, self.port, self.cookie = folder / "glewlwyd", shop.free_port(), {}
        self.folder.mkdir()
        self.url = f"http://127.0.0.1:{self.port}"
        self.issuer = f"{self.url}/api/oidc"
        database = sqlite3.connect(self.folder / "store")
        database.executescript(TABLES.read_text())
        database.commit()
        database.close()
        # The package's page, with its configuration where the page looks for it: its own link leads to a folder.
        shutil.copytree(WEBAPP, self.folder / "page", ignore=lambda folder, names: [name for name in names if name == "config.json" or not (pathlib.Path(folder) / name).exists()])
        shutil.copy(CONFIG, self.folder / "page" / "config.json")
        (self.folder / "config").write_text(self._config())
        self.process = subprocess.Popen(["glewlwyd", "--config-file", str(self.folder / "config")])
        self._set_up(redirect)

    def _config(self):
        modules = {"user_auth_scheme_module_path" if name == "scheme" else f"{name}_module_path": f"/usr/lib/glewlwyd/{name}" for name in MODULES}
        words = {"bind_address": "127.0.0.1", "external_url": self.url, "login_url": "login.html", "api_prefix": "api", "static_files_path": f"{self.folder}/page/",
                 "log_mode": "file", "log_level": "WARNING", "log_file": f"{self.folder}/log", "session_key": "GLEWLWYD2_SESSION_ID", "admin_scope": "g_admin",
                 "profile_scope": "g_profile", "hash_algorithm": "SHA512"} | modules
        rows = [f"port={self.port}", "cookie_secure=0"] + [f'{name}="{value}"' for name, value in words.items()]
        types = ", ".join(f'{{extension = "{ending}"; mime_type = "{name}"}}' for ending, name in TYPES.items())
        return "\n".join(rows + [f'database = {{type = "sqlite3"; path = "{self.folder}/store"}};', f"static_files_mime_types = ({types})"]) + "\n"

    def call(self, method, path, body=None):
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=20)
        connection.request(method, f"/api{path}", json.dumps(body) if body is not None else None, {"Content-Type": "application/json"} | self.cookie)
        answer = connection.getresponse()
        text = answer.read()
        for value in answer.msg.get_all("Set-Cookie") or []:
            self.cookie = {"Cookie": value.split(";")[0]}
        connection.close()
        expect(answer.status == 200, f"{method} {path}: {answer.status} {text[:500]}")
        return json.loads(text) if text else None

    def _set_up(self, redirect):
        shop.wait_for("glewlwyd to answer", self._signs_in)
        users = self.call("GET", "/mod/user/database")
        many = {"multiple": True, "read": True, "write": True, "profile-read": True, "profile-write": False}
        users["parameters"]["data-format"]["groups"] = many
        self.call("PUT", "/mod/user/database", users)
        self.call("PUT", "/mod/user/database/reset", {})
        key = rsa.generate_private_key(65537, 2048)
        self.call("POST", "/mod/plugin/", {"module": "oidc", "name": "oidc", "display_name": "the shop", "order_rank": 0, "parameters": self._plugin(key)})
        self.call("POST", "/client/?source=database", {
            "client_id": CLIENT, "name": "dripfeed", "confidential": True, "enabled": True, "client_secret": PLAIN_SECRET, "password": PLAIN_SECRET,
            "redirect_uri": [redirect], "authorization_type": ["code"], "token_endpoint_auth_method": ["client_secret_basic"], "scope": []})

    def _signs_in(self):
        try:
            self.call("POST", "/auth/", {"username": "admin", "password": "password"})
            return True
        except OSError:
            return False

    def _plugin(self, key):
        def claim(name, of):
            return {"name": name, "user-property": of, "type": "string", "mandatory": True, "scope": []}

        private = key.private_bytes(form.Encoding.PEM, form.PrivateFormat.TraditionalOpenSSL, form.NoEncryption()).decode()
        public = key.public_key().public_bytes(form.Encoding.PEM, form.PublicFormat.SubjectPublicKeyInfo).decode()
        return {"iss": self.issuer, "jwt-type": "rsa", "jwt-key-size": "256", "key": private, "cert": public, "access-token-duration": 3600,
                "refresh-token-duration": 3600, "code-duration": 600, "refresh-token-rolling": True, "allow-non-oidc": False, "auth-type-code-enabled": True,
                "auth-type-code-revoke-replayed": True, "auth-type-token-enabled": False, "auth-type-id-token-enabled": True, "auth-type-none-enabled": False,
                "auth-type-password-enabled": False, "auth-type-client-enabled": False, "auth-type-device-enabled": False, "auth-type-refresh-enabled": False,
                "pkce-allowed": True, "pkce-method-plain-allowed": False, "pkce-required": True, "subject-type": "public", "scope": [],
                "claims": [claim("preferred_username", "username"), claim("groups", "groups")], "name-claim": "no", "email-claim": "no",
                "address-claim": {"type": "no"}, "scope-claim": "no", "request-parameter-allow": False, "jwks-show": True, "oauth-as-iss-id": True}

    def add_user(self, name, password, groups):
        self.call("POST", "/user/?source=database", {"username": name, "password": password, "name": name, "enabled": True, "scope": ["openid"], "groups": groups})

    def set_groups(self, name, groups):
        self.call("PUT", f"/user/{name}?source=database", {"username": name, "name": name, "enabled": True, "scope": ["openid"], "groups": groups})

    def end(self):
        self.process.terminate()
        self.process.wait(20)


def key_pair(kind="RS256", key_id="first"):
    key = ec.generate_private_key(ec.SECP256R1()) if kind.startswith("ES") else rsa.generate_private_key(65537, 2048)
    algorithm = jwt.algorithms.get_default_algorithms()[kind]
    public = json.loads(algorithm.to_jwk(key.public_key()))
    # The library leaves out zero bytes at the beginning, and RFC 7518 (6.2.1.2) wants all: one key of 128 was none.
    for coordinate in ("x", "y"):
        if coordinate in public:
            public[coordinate] = part(getattr(key.public_key().public_numbers(), coordinate).to_bytes(32, "big"))
    return {"key": key, "kid": key_id, "alg": kind, "public": public | {"kid": key_id, "use": "sig", "alg": kind}}


def part(value):
    return base64.urlsafe_b64encode(value if isinstance(value, bytes) else json.dumps(value).encode()).rstrip(b"=").decode()


class Liar:
    """A provider by the book, whose parts a test replaces: `document`, `keys`, `claims`, `sign`, `answer` of the token endpoint. With a certificate
    and its key it speaks TLS."""

    def __init__(self, certificate=None):
        self.keys, self.asked, self.codes, self.let_go = [key_pair()], [], {}, threading.Event()
        self.person = {"sub": "s-1", "preferred_username": "olga", "groups": ["dnc"]}
        self.claims = lambda claims: claims
        self.sign = self.signed
        self.document = lambda document: document
        self.answer = None  # (status, headers, body), or "hang"
        liar = self

        class Handler(http.server.BaseHTTPRequestHandler):
            def do_GET(self):
                liar.asked.append(self.path)
                if self.path == "/.well-known/openid-configuration":
                    return self.give(200, liar.document(liar.own_document()))
                if self.path == "/keys":
                    return self.give(200, {"keys": [one["public"] for one in liar.keys]})
                return self.give(404, {})

            def do_POST(self):
                liar.asked.append(self.path)
                form = dict(urllib.parse.parse_qsl(self.rfile.read(int(self.headers["Content-Length"])).decode()))
                if liar.answer == "hang":
                    liar.let_go.wait(30)
                    return None
                if liar.answer is not None:
                    return self.give(*liar.answer)
                return self.give(*liar.token(form, self.headers.get("Authorization", "")))

            def give(self, status, document, headers=()):
                data = document if isinstance(document, bytes) else json.dumps(document).encode()
                self.send_response(status)
                for name, value in headers:
                    self.send_header(name, value)
                self.send_header("Content-Type", "application/json")
                self.send_header("Content-Length", str(len(data)))
                self.end_headers()
                self.wfile.write(data)

            def log_message(self, *arguments):
                pass

        self.server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler)
        self.server.daemon_threads = True
        if certificate:
            tls = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
            tls.load_cert_chain(*certificate)
            self.server.socket = tls.wrap_socket(self.server.socket, server_side=True)
        self.issuer = f"{'https' if certificate else 'http'}://127.0.0.1:{self.server.server_address[1]}"
        threading.Thread(target=self.server.serve_forever, kwargs={"poll_interval": 0.02}, daemon=True).start()

    def own_document(self):
        return {"issuer": self.issuer, "authorization_endpoint": f"{self.issuer}/authorize", "token_endpoint": f"{self.issuer}/token", "jwks_uri": f"{self.issuer}/keys",
                "response_types_supported": ["code"], "subject_types_supported": ["public"], "id_token_signing_alg_values_supported": ["RS256", "ES256"]}

    def grant(self, url):
        """What the provider does when the person has signed in there: a code for what this address asked for."""
        asked = dict(urllib.parse.parse_qsl(urllib.parse.urlsplit(url).query))
        code = f"code {len(self.codes)} & more"
        self.codes[code] = asked
        return {"code": code, "state": asked["state"]}

    def token(self, form, authorization):
        """By the book: the client's name, its secret, the verifier of the challenge, the same address, each code once."""
        asked = self.codes.get(form.get("code"))
        wanted = "Basic " + base64.b64encode(f"{urllib.parse.quote(CLIENT, safe='')}:{urllib.parse.quote(SECRET, safe='')}".encode()).decode()
        verifier = form.get("code_verifier", "")
        right = asked and authorization == wanted and part(hashlib.sha256(verifier.encode()).digest()) == asked["code_challenge"] \
            and asked["code_challenge_method"] == "S256" and len(verifier) >= 43 and form.get("redirect_uri") == asked["redirect_uri"] \
            and form.get("grant_type") == "authorization_code"
        if not right:
            return 400, {"error": "invalid_grant"}
        now = int(time.time())
        claims = {"iss": self.issuer, "aud": CLIENT, "exp": now + 300, "iat": now, "nonce": asked["nonce"]} | self.person
        return 200, {"access_token": "x", "token_type": "Bearer", "id_token": self.sign(self.claims(claims))}

    def signed(self, claims, key=None, **header):
        key = key or self.keys[0]
        return jwt.encode(claims, key["key"], algorithm=key["alg"], headers={"kid": key["kid"]} | header)

    def end(self):
        self.let_go.set()
        self.server.shutdown()
        self.server.server_close()
