"""Signing in by an OpenID Connect provider: what is asked of it, who is let in and what they may do then; and a provider that lies, is slow or is away:
each refused with its code, nothing stored, and no other sign-in waits."""

import hashlib
import hmac
import json
import subprocess
import sys
import threading
import time
import urllib.parse

import jwt
from cryptography.hazmat.primitives import hashes
from cryptography.hazmat.primitives import serialization as form
from cryptography.hazmat.primitives.asymmetric import padding, rsa

from client import DC1, Client, HandControl, binary, expect, hand_profile, in_folder, shop
from provider import CLIENT, SECRET, Liar, key_pair, part

BEGIN, END = "/session/provider/begin", "/session/provider"
PAGE = {"Sec-Fetch-Site": "same-origin"}


class Shop:
    def __init__(self, folder, *options, liar=None, seconds=2):
        self.liar = liar or Liar()
        (folder / "secret").write_text(SECRET + "\n")
        self.client = Client(folder, "--oidc", self.liar.issuer, "--oidc-client-id", CLIENT, "--oidc-client-secret-file", str(folder / "secret"),
                             "--oidc-page", "http://127.0.0.1:1", "--oidc-title", "Shop login", "--oidc-local", "--oidc-seconds", str(seconds), *options).start()

    def begin(self):
        """The address at the provider, and the cookie of a browser."""
        answer = self.client.call("POST", BEGIN, role=None, headers=PAGE)
        expect(answer.status == 200, f"{answer}")
        return answer.document["url"], {"Cookie": answer.headers["Set-Cookie"].split(";")[0]}

    def end(self, body, cookie):
        return self.client.call("POST", END, body, role=None, headers=PAGE | cookie)

    def sign_in(self, **changes):
        url, cookie = self.begin()
        return self.end(self.liar.grant(url) | changes, cookie)

    def signed_in(self):
        """The session's cookie."""
        answer = self.sign_in()
        expect(answer.status == 204, f"{answer}")
        cookies = answer.headers.get_all("Set-Cookie")
        expect([one for one in cookies if one.startswith("dripfeed_sign_in=;") and "Max-Age=0" in one], f"the sign-in's own cookie stays: {cookies}")
        return {"Cookie": next(one for one in cookies if one.startswith("dripfeed_session=")).split(";")[0]}

    def refused(self, answer, code, *words, status=409):
        expect(answer.status == status and answer.document["code"] == code, f"{answer}, not {code}")
        expect(all(word in answer.document["detail"] for word in words), f"{answer.document['detail']}: not {words}")
        expect("dripfeed_session=" not in str(answer.headers), "a session was given")
        return answer

    def stored(self):
        return [self.client.get("/users")["items"], self.client.get("/audit")["items"]]

    def close(self):
        self.client.server.stop()
        self.liar.end()


def what_is_asked(folder):
    shop_ = Shop(folder)
    client = shop_.client
    expect(client.must("GET", END, role=None) == {"title": "Shop login"}, "the button's name")
    expect(shop_.liar.asked == [], "it was asked before a person wanted to sign in")
    answer = client.call("POST", BEGIN, role=None, headers=PAGE)
    url = urllib.parse.urlsplit(answer.document["url"])
    asked = dict(urllib.parse.parse_qsl(url.query))
    expect(f"{url.scheme}://{url.netloc}{url.path}" == f"{shop_.liar.issuer}/authorize", answer.document["url"])
    kept = {"response_type": "code", "client_id": CLIENT, "redirect_uri": "http://127.0.0.1:1/sign-in", "scope": "openid profile", "code_challenge_method": "S256"}
    expect(kept.items() <= asked.items() and set(asked) == set(kept) | {"state", "nonce", "code_challenge"}, f"{asked}")
    expect(all(len(asked[name]) == 43 for name in ("state", "nonce", "code_challenge")), f"{asked}")
    cookie = answer.headers["Set-Cookie"]
    expect(all(word in cookie for word in ("HttpOnly", "SameSite=Strict", "Path=/api/v1/session/provider", "Max-Age=600")), cookie)
    expect(not any(asked[name] in cookie for name in ("state", "nonce")), "the cookie shows what is derived from it")
    other, _ = shop_.begin()
    expect(not set(asked.values()) & set(dict(urllib.parse.parse_qsl(urllib.parse.urlsplit(other).query)).values()) - set(kept.values()), "each sign-in is another one")
    for site in ({"Origin": "https://evil.example"}, {"Sec-Fetch-Site": "cross-site"}, {"Sec-Fetch-Site": "same-site"}):
        client.refuse(403, "POST", BEGIN, role=None, headers=site)
        client.refuse(403, "POST", END, {"state": "x", "code": "y"}, role=None, headers=site)
    client.refuse(422, "POST", END, {"code": "y"}, role=None)
    client.refuse(413, "POST", END, {"state": "x" * 9000}, role=None)
    shop_.close()


def without_a_provider(folder):
    client = Client(folder).start()
    expect(client.must("GET", END, role=None) == {"title": None}, "a provider that is not there")
    client.refuse(404, "POST", BEGIN, role=None)
    client.refuse(404, "POST", END, {"state": "x"}, role=None)
    client.server.stop()


def a_new_person_waits_for_an_administrator(folder):
    shop_ = Shop(folder)
    client = shop_.client
    shop_.refused(shop_.sign_in(), "account_waits", "olga", "administrator")
    olga = client.get("/users/olga")
    expect((olga["provider"], olga["has_password"], olga["role"]) == (shop_.liar.issuer, False, "viewer") and olga["disabled_at_ms"], f"{olga}")
    shop_.refused(shop_.sign_in(), "account_waits")
    listed = subprocess.run([str(binary()), "user", "list", "--data", str(client.server.data)], capture_output=True, text=True, timeout=30, check=True).stdout
    expect(f"olga  signs in by {shop_.liar.issuer}" in listed, listed)
    client.must("PUT", "/users/olga", {"role": "programmer"}, headers={"If-Match": '"1"'})
    session = shop_.signed_in()
    who = client.must("GET", "/session", role=None, headers=session)
    expect((who["name"], who["role"], who["by"]) == ("olga", "programmer", "provider"), f"{who}")
    shop_.liar.person |= {"preferred_username": "olga.new", "groups": []}
    expect(client.must("GET", "/session", role=None, headers=shop_.signed_in())["name"] == "olga", "the subject is who she is")
    actions = [row["action"] for row in client.get("/audit?subject=user/olga")["items"]]
    expect(actions == ["user.sign-in", "user.sign-in", "user.change", "user.refused", "user.refused", "user.add"], f"{actions}")
    client.must("PUT", "/users/olga", {"role": "programmer", "disabled": True}, headers={"If-Match": '"2"'})
    shop_.refused(shop_.sign_in(), "account_waits")
    client.refuse(401, "GET", "/session", role=None, headers=session)
    client.restart()
    shop_.refused(shop_.sign_in(), "account_waits")
    shop_.close()


def no_account_is_taken_over(folder):
    shop_ = Shop(folder, "--oidc-group", "dnc=admin")
    client = shop_.client
    client.post("/users", {"name": "olga", "role": "viewer"})
    client.must("PUT", "/users/olga/password", {"secret": "a long enough one"})
    shop_.refused(shop_.sign_in(), "name_taken", "olga", "another account")
    expect(client.get("/users/olga")["role"] == "viewer" and client.get("/users/olga")["provider"] is None, "it was changed")
    expect(client.call("POST", "/session", {"name": "olga", "password": "a long enough one"}, role=None).status == 204, "her password")
    for name in ("dripfeed", "the operator"):
        shop_.liar.person |= {"preferred_username": name}
        shop_.refused(shop_.sign_in(), "name_taken", name)
    for name in ("", "a\nb", "x" * 300, 7, None):
        shop_.liar.person |= {"preferred_username": name}
        shop_.refused(shop_.sign_in(), "name_taken", "no name")
    shop_.liar.person |= {"preferred_username": "carl"}
    shop_.signed_in()
    shop_.liar.person |= {"sub": "s-2"}
    shop_.refused(shop_.sign_in(), "name_taken", "carl")
    expect([one["name"] for one in client.get("/users")["items"]] == ["carl", "olga"], "who is there")
    shop_.close()


def groups_give_the_roles_at_each_sign_in(folder):
    shop_ = Shop(folder, "--oidc-group", "dnc=viewer", "--oidc-group", "cn=heads,ou=shop=approver", "--oidc-group", "hall-2=operator@mills", "--oidc-group", "hall-2=viewer@mills",
                 "--oidc-group", "x=admin@nowhere", "--oidc-groups-claim", "shop.groups")
    client, liar = shop_.client, shop_.liar
    client.must("PUT", "/groups/mills", {"machines": []})

    def roles(*groups):
        liar.person = {"sub": "s-1", "preferred_username": "olga", "shop": {"groups": list(groups)}}
        session = shop_.signed_in()
        olga = client.get("/users/olga")
        expect(client.must("GET", "/session", role=None, headers=session)["role"] == olga["role"], "of the session")
        return olga["role"], {one["group"]: one["role"] for one in olga["grants"]}

    expect(roles("dnc", "tennis") == ("viewer", {}), "one group")
    expect(roles("cn=heads,ou=shop", "dnc") == ("approver", {}), "the best role counts")
    expect(roles("hall-2") == ("viewer", {"mills": "operator"}), "on machines alone")
    before = client.get("/users/olga")["revision"]
    expect(roles("hall-2", "x") == ("viewer", {"mills": "operator"}) and client.get("/users/olga")["revision"] == before, "the same again is no change")
    session = shop_.signed_in()
    liar.person["shop"] = {"groups": ["tennis"]}
    shop_.refused(shop_.sign_in(), "no_role", "olga")
    client.refuse(401, "GET", "/session", role=None, headers=session)
    expect((client.get("/users/olga")["role"], client.get("/users/olga")["grants"]) == ("viewer", []), "her rights stayed")
    liar.person = {"sub": "s-9", "preferred_username": "carl", "groups": ["dnc"]}
    shop_.refused(shop_.sign_in(), "no_role", "carl")
    expect([one["name"] for one in client.get("/users")["items"]] == ["olga"], "a person without a role was added")
    expect(roles("dnc") == ("viewer", {}), "and in again")
    for _ in range(5):
        client.call("POST", "/session", {"name": "olga", "password": "wrong wrong wrong"}, role=None)
    shop_.refused(shop_.sign_in(), "account_waits", "locked")
    shop_.close()


def no_lie_is_believed(folder):
    shop_ = Shop(folder, "--oidc-group", "dnc=admin")
    liar = shop_.liar
    first, now = liar.keys[0], int(time.time())
    elliptic, unknown = key_pair("ES256", "second"), key_pair()
    public = first["key"].public_key().public_bytes(form.Encoding.PEM, form.PublicFormat.SubjectPublicKeyInfo)

    def by_hand(header, claims, sign):
        signed = f"{part(header)}.{part(claims)}"
        return f"{signed}.{part(sign(signed.encode()))}"

    def hs256(claims, key):
        return by_hand({"alg": "HS256", "typ": "JWT", "kid": "first"}, claims, lambda text: hmac.new(key, text, hashlib.sha256).digest())

    before = shop_.stored()
    claims = [("another issuer", {"iss": "https://evil.example"}), ("another issuer", {"iss": None}), ("another client", {"aud": "other"}), ("another client", {"aud": []}),
              ("another client", {"aud": None}), ("several clients", {"aud": [CLIENT, "other"]}), ("another client", {"aud": [CLIENT, "other"], "azp": "other"}),
              ("another client", {"azp": 7}), ("expired", {"exp": now - 61}), ("no time", {"exp": None}), ("no time", {"exp": "tomorrow"}), ("no time", {"iat": None}),
              ("in the future", {"iat": now + 600}), ("too long ago", {"iat": now - 3600}), ("not valid yet", {"nbf": now + 600}), ("another sign-in", {"nonce": "x" * 43}),
              ("another sign-in", {"nonce": None}), ("no person", {"sub": None}), ("no person", {"sub": ""}), ("no person", {"sub": "x" * 256})]
    for words, change in claims:
        liar.claims = lambda good, change=change: {name: value for name, value in (good | change).items() if value is not None}
        shop_.refused(shop_.sign_in(), "id_token_refused", words)
    liar.claims = lambda good: good
    # Without words: the library or the list of algorithms refuses it, whichever looks first.
    signatures = [
        ("", lambda claims: by_hand({"alg": "none", "kid": "first"}, claims, lambda text: b"")), ("", lambda claims: f"{part({'alg': 'none'})}.{part(claims)}."),
        ("", lambda claims: by_hand({"alg": "NONE", "kid": "first"}, claims, lambda text: b"")), ("", lambda claims: by_hand({"kid": "first"}, claims, lambda text: b"")),
        ("algorithm", lambda claims: hs256(claims, public)), ("algorithm", lambda claims: hs256(claims, json.dumps(first["public"]).encode())),
        ("algorithm", lambda claims: hs256(claims, SECRET.encode())), ("key id", lambda claims: liar.signed(claims, unknown | {"kid": "never heard of"})),
        ("signature", lambda claims: liar.signed(claims, unknown)), ("signature", lambda claims: liar.signed(claims)[:-8] + "AAAAAAAA"),
        ("signature", lambda claims: liar.signed(claims).rsplit(".", 1)[0] + "."), ("key id", lambda claims: liar.signed(claims, elliptic | {"kid": "first"})),
        ("header", lambda claims: liar.signed(claims, crit=["b64"])), ("", lambda claims: "x"), ("none in the answer", lambda claims: ""),
        ("", lambda claims: "a.b.c.d.e"), ("JSON object", lambda claims: by_hand_claims(first, b"[1]")),
        ("JSON object", lambda claims: by_hand_claims(first, json.dumps(claims).encode()[:-1] + b', "iss": "x"}')),
        ("signature", lambda claims: swapped(liar.signed(claims), claims | {"preferred_username": "admin"}))]

    def by_hand_claims(key, text):
        signed = f"{part({'alg': 'RS256', 'kid': 'first'})}.{part(text)}"
        return f"{signed}.{part(key['key'].sign(signed.encode(), padding.PKCS1v15(), hashes.SHA256()))}"

    def swapped(token, claims):
        head, _, signature = token.split(".")
        return f"{head}.{part(claims)}.{signature}"

    for words, sign in signatures:
        liar.sign = sign
        shop_.refused(shop_.sign_in(), "id_token_refused", words)
    liar.sign = liar.signed
    expect(shop_.stored() == before, "a lie was stored")
    # Clocks may differ by a minute.
    liar.claims = lambda good: good | {"exp": int(time.time()) - 30, "iat": int(time.time()) + 30, "aud": [CLIENT, "other"], "azp": CLIENT}
    shop_.signed_in()
    shop_.close()


def keys_change(folder):
    shop_ = Shop(folder, "--oidc-group", "dnc=viewer")
    liar = shop_.liar
    shop_.signed_in()
    shop_.signed_in()
    expect(liar.asked.count("/keys") == 1, "keys are kept")
    old = liar.keys[0]
    liar.keys = [key_pair("ES256", "second")]
    shop_.signed_in()
    expect(liar.asked.count("/keys") == 2, "new ones are asked for")
    liar.sign = lambda claims: liar.signed(claims, old)
    shop_.refused(shop_.sign_in(), "id_token_refused", "key id")
    liar.sign = lambda claims: jwt.encode(claims, liar.keys[0]["key"], algorithm="ES256")
    shop_.signed_in()
    short = rsa.generate_private_key(65537, 1024)
    algorithm = jwt.algorithms.get_default_algorithms()["RS256"]
    liar.keys = [{"key": short, "kid": "short", "alg": "RS256", "public": json.loads(algorithm.to_jwk(short.public_key())) | {"kid": "short"}}, key_pair("RS256", "other")]
    liar.sign = lambda claims: liar.signed(claims)
    shop_.refused(shop_.sign_in(), "id_token_refused", "key id")
    liar.keys = [key_pair("PS256", "third"), key_pair("RS256", "other")]
    shop_.signed_in()
    shop_.close()


def a_sign_in_belongs_to_its_browser(folder):
    shop_ = Shop(folder, "--oidc-group", "dnc=admin")
    before = shop_.stored()
    mine, my_cookie = shop_.begin()
    theirs, their_cookie = shop_.begin()
    shop_.refused(shop_.end(shop_.liar.grant(theirs), my_cookie), "sign_in_not_begun", "this browser")
    shop_.refused(shop_.end(shop_.liar.grant(theirs), {}), "sign_in_not_begun")
    shop_.refused(shop_.end(shop_.liar.grant(mine) | {"state": "x" * 43}, my_cookie), "sign_in_not_begun")
    forged = {"Cookie": f"dripfeed_sign_in={int(time.time() * 1000)}.{'A' * 43}"}
    shop_.refused(shop_.end(shop_.liar.grant(mine), forged), "sign_in_not_begun")
    swapped = shop_.liar.grant(theirs) | {"state": shop_.liar.grant(mine)["state"]}  # a stolen code, in another browser's sign-in
    shop_.refused(shop_.end(swapped, my_cookie), "provider_refused", "invalid_grant")
    expect("/token" in shop_.liar.asked, "it was not the verifier that held")
    good = shop_.liar.grant(theirs)
    shop_.refused(shop_.end({"state": good["state"], "error": "access_denied"}, my_cookie), "sign_in_not_begun")
    expect(shop_.stored() == before, "something was stored")
    expect(shop_.end(good, their_cookie).status == 204, "the right one")
    shop_.refused(shop_.end(good, their_cookie), "sign_in_not_begun", "used before")
    url, cookie = shop_.begin()
    shop_.refused(shop_.end({"state": shop_.liar.grant(url)["state"], "error": "access_denied\n<b>"}, cookie), "provider_refused", "access_denied?<b>")
    url, cookie = shop_.begin()
    shop_.refused(shop_.end(shop_.liar.grant(url) | {"iss": "https://evil.example"}, cookie), "provider_refused", "another provider")
    url, cookie = shop_.begin()
    expect(shop_.end(shop_.liar.grant(url) | {"iss": shop_.liar.issuer}, cookie).status == 204, "it names itself")
    url, cookie = shop_.begin()
    shop_.client.restart()
    shop_.refused(shop_.end(shop_.liar.grant(url), cookie), "sign_in_not_begun")
    shop_.close()


def its_document_leads_nowhere_else(folder):
    shop_ = Shop(folder, "--oidc-group", "dnc=admin", seconds=2)
    liar, client = shop_.liar, shop_.client

    def begin_refused(*words):
        time.sleep(2.1)  # a failure is kept so long
        return shop_.refused(client.call("POST", BEGIN, role=None, headers=PAGE), "provider_unanswered", *words, status=503)

    for words, change in [("another issuer", {"issuer": "https://evil.example"}), ("token_endpoint must be https", {"token_endpoint": "http://evil.example/token"}),
                          ("jwks_uri must be https", {"jwks_uri": "http://127.0.0.1@evil.example/keys"}), ("authorization_endpoint must be https", {"authorization_endpoint": "javascript:alert(1)"}),
                          ("S256", {"code_challenge_methods_supported": ["plain"]}), ("no algorithm", {"id_token_signing_alg_values_supported": ["HS256", "none"]}),
                          ("answered 404", {"jwks_uri": f"{liar.issuer}/none"})]:
        liar.document = lambda document, change=change: document | change
        begin_refused(words)
    liar.document = lambda document: b"<html>welcome</html>"
    begin_refused("JSON object")
    liar.document = lambda document: document
    time.sleep(2.1)
    url, cookie = shop_.begin()
    liar.answer = (302, {}, [("Location", f"{liar.issuer}/elsewhere")])
    shop_.refused(shop_.end(liar.grant(url), cookie), "provider_unanswered", "answered 302", status=503)
    expect(not any("elsewhere" in one for one in liar.asked), "a redirect was followed")
    for answer, code, status in [((500, {}), "provider_unanswered", 503), ((401, {"error": "invalid_client"}), "provider_refused", 409), ((400, b"<html>"), "provider_refused", 409),
                                 ((200, b"x" * 200_000), "id_token_refused", 409), ((200, {"id_token": 7}), "id_token_refused", 409)]:
        liar.answer = answer
        shop_.refused(shop_.sign_in(), code, status=status)
    expect(client.get("/users")["items"] == [], "a user was stored")
    shop_.close()


def its_certificate_is_verified(folder):
    names = {name: (str(folder / f"{name}.pem"), str(folder / f"{name}.key")) for name in ("right", "other_name", "unknown")}
    for name, (certificate, key) in names.items():
        host = "IP:127.0.0.2" if name == "other_name" else "IP:127.0.0.1"
        subprocess.run(["openssl", "req", "-x509", "-newkey", "rsa:2048", "-nodes", "-days", "2", "-subj", "/CN=login", "-addext", f"subjectAltName={host}", "-out", certificate, "-keyout", key],
                       check=True, capture_output=True)
    for name in names:
        (folder / name).mkdir()
        believed = names["right" if name == "unknown" else name][0]
        shop_ = Shop(folder / name, "--oidc-group", "dnc=viewer", "--oidc-ca", believed, liar=Liar(names[name]))
        if name == "right":
            shop_.signed_in()
        else:
            shop_.refused(shop_.client.call("POST", BEGIN, role=None, headers=PAGE), "provider_unanswered", status=503)
            expect(shop_.liar.asked == [], "it was asked all the same")
        shop_.close()


def a_provider_that_is_slow_or_away_holds_no_one_up(folder):
    shop_ = Shop(folder, "--oidc-group", "dnc=viewer", seconds=2)
    client, liar = shop_.client, shop_.liar
    client.post("/users", {"name": "bert", "role": "operator"})
    client.must("PUT", "/users/bert/password", {"secret": "a long enough one"})
    control = HandControl()
    client.post("/machines", hand_profile(control, "lathe"))
    release = client.release(client.add_program(400)["id"], "lathe")["id"]
    client.wait_line("lathe", "idle")
    job = client.queue(release)
    client.post(f"/jobs/{job}/arm")
    control.say(DC1)
    client.wait_job(job, "feeding")
    liar.answer = "hang"
    begun = [shop_.begin() for _ in range(8)]
    took, refused = [], []

    def wait(url, cookie):
        began = time.monotonic()
        refused.append(shop_.end(liar.grant(url), cookie))
        took.append(time.monotonic() - began)

    threads = [threading.Thread(target=wait, args=one) for one in begun]
    for thread in threads:
        thread.start()
    shop.wait_for("four to wait", lambda: liar.asked.count("/token") >= 4)
    began = time.monotonic()
    expect(client.call("POST", "/session", {"name": "bert", "password": "a long enough one"}, role=None).status == 204, "a password")
    client.post("/users", {"name": "carl", "role": "viewer"})
    client.post(f"/jobs/{job}/stop")
    held = time.monotonic() - began
    expect(held < 1.5 and any(thread.is_alive() for thread in threads), f"others waited {held:.2f} s")
    client.post(f"/jobs/{job}/cancel")
    client.wait_job(job, "cancelled")
    for thread in threads:
        thread.join(20)
    expect(max(took) < 6 and all(answer.status == 503 for answer in refused), f"{took} {[str(one) for one in refused]}")
    expect({answer.document["code"] for answer in refused} <= {"provider_unanswered", "overloaded"}, f"{[str(one) for one in refused]}")
    liar.answer = None
    shop_.signed_in()
    liar.end()
    url, cookie = shop_.begin()
    shop_.refused(shop_.end(liar.grant(url), cookie), "provider_unanswered", status=503)
    client.restart()
    shop_.refused(client.call("POST", BEGIN, role=None, headers=PAGE), "provider_unanswered", status=503)
    expect(client.call("POST", "/session", {"name": "bert", "password": "a long enough one"}, role=None).status == 204, "a password while it is away")
    client.server.stop()
    control.close()


if __name__ == "__main__":
    for test in (what_is_asked, without_a_provider, a_new_person_waits_for_an_administrator, no_account_is_taken_over, groups_give_the_roles_at_each_sign_in, no_lie_is_believed,
                 keys_change, a_sign_in_belongs_to_its_browser, its_document_leads_nowhere_else, its_certificate_is_verified, a_provider_that_is_slow_or_away_holds_no_one_up):
        if len(sys.argv) < 3 or sys.argv[2] in test.__name__:
            in_folder(test)
    sys.exit(0)
