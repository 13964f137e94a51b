"""Every route with and without rights: without a token 401, with a role below its own 403, with its own an answer of 2xx; with a role in one group
of machines, what acts on those and nothing else. The rows are compared with /api/openapi.json, which the server writes from its own table, so that no route is without a row. Tokens of the roles are made with
`dripfeed token add`."""

import copy
import sys
import threading

from client import DC1, ROLES, ROLL, Client, HandControl, contract, expect, expect_problem, hand_profile, in_folder, plain_program, shop
from openapi_shape import differences, shape_faults

MATCH_1 = {"If-Match": '"1"'}
ROLL_VALUES = {"half_axis_x": "100 mm", "half_axis_z": "202.4 mm", "roll_length": "196 mm", "angle_step": "2 deg", "clearance": "25 mm", "cut_feed": "0.15 mm/rev"}
ROLL_2 = ROLL.replace("in 10..3000", "in 10..2500")


def rows(made):
    """(method, path of the route, role, {name in the path: value}, body, more): `made` holds what earlier rows and the preparation made. more:
    headers; query = of the path; keep = under which name the answer's id is kept; ready = what has to be so before."""
    return [
        ("GET", "/healthz", None, {}, None, {}),
        ("GET", "/metrics", "viewer", {}, None, {}),
        ("GET", "/api/openapi.json", None, {}, None, {}),
        ("GET", "/", None, {}, None, {}),
        ("GET", "/assets/{name}", None, {"name": "app.js"}, None, {}),
        ("GET", "/docs", None, {}, None, {}),
        ("GET", "/docs/{name}", None, {"name": "safety"}, None, {}),
        ("POST", "/api/v1/session", None, {}, lambda: {"token": made["token"]}, {}),
        ("GET", "/api/v1/session", "viewer", {}, None, {}),
        ("DELETE", "/api/v1/session", "viewer", {}, None, {}),
        ("GET", "/api/v1/session/provider", None, {}, None, {}),
        ("POST", "/api/v1/session/provider/begin", None, {}, None, {"refused": "no provider", "status": 404}),
        ("POST", "/api/v1/session/provider", None, {}, {"state": "x"}, {"refused": "no provider", "status": 404}),
        ("GET", "/api/v1/events", "viewer", {}, None, {}),
        ("GET", "/api/v1/machines", "viewer", {}, None, {}),
        ("POST", "/api/v1/machines", "admin", {}, lambda: made["mill_profile"], {}),
        ("GET", "/api/v1/machines/{name}", "viewer", {"name": "mill"}, None, {}),
        ("GET", "/api/v1/machines/{name}/utilisation", "viewer", {"name": "mill"}, None, {}),
        ("GET", "/api/v1/machines/{name}/wire", "viewer", {"name": "lathe"}, None, {"ready": "idle"}),
        ("POST", "/api/v1/machines/{name}/line-test", "operator", {"name": "lathe"}, None, {"ready": "idle"}),
        ("PUT", "/api/v1/machines/{name}", "admin", {"name": "mill"}, lambda: made["mill_profile"] | {"title": "Another"}, {"headers": MATCH_1, "ready": "of_the_hall"}),
        ("PUT", "/api/v1/session/password", "viewer", {}, {"current": "the first of olga", "secret": "the third of olga"}, {"ready": "olga"}),
        ("GET", "/api/v1/groups", "viewer", {}, None, {}),
        ("PUT", "/api/v1/groups/{name}", "admin", {"name": "lathes"}, {"machines": []}, {}),
        ("DELETE", "/api/v1/groups/{name}", "admin", {"name": "lathes"}, None, {}),
        ("GET", "/api/v1/users", "admin", {}, None, {}),
        ("POST", "/api/v1/users", "admin", {}, {"name": "bert", "role": "operator"}, {}),
        ("GET", "/api/v1/users/{name}", "admin", {"name": "bert"}, None, {}),
        ("PUT", "/api/v1/users/{name}", "admin", {"name": "bert"}, {"role": "viewer"}, {"headers": MATCH_1}),
        ("PUT", "/api/v1/users/{name}/password", "admin", {"name": "bert"}, {"secret": "a long enough one"}, {}),
        ("DELETE", "/api/v1/users/{name}/password", "admin", {"name": "bert"}, None, {}),
        ("PUT", "/api/v1/users/{name}/pin", "admin", {"name": "bert"}, {"secret": "7301"}, {}),
        ("DELETE", "/api/v1/users/{name}/pin", "admin", {"name": "bert"}, None, {}),
        ("POST", "/api/v1/users/{name}/unlock", "admin", {"name": "bert"}, {}, {}),
        ("GET", "/api/v1/tokens", "admin", {}, None, {}),
        ("POST", "/api/v1/tokens", "admin", {}, {"name": "wall", "role": "viewer"}, {"keep": "new_token"}),
        ("GET", "/api/v1/tokens/{id}", "admin", {"id": "new_token"}, None, {}),
        ("DELETE", "/api/v1/tokens/{id}", "admin", {"id": "new_token"}, None, {}),
        ("GET", "/api/v1/audit", "approver", {}, None, {}),
        ("GET", "/api/v1/store", "admin", {}, None, {}),
        ("POST", "/api/v1/store/verify", "admin", {}, None, {}),
        ("POST", "/api/v1/backups", "admin", {}, None, {}),
        ("GET", "/api/v1/backups", "admin", {}, None, {}),
        ("DELETE", "/api/v1/backups/{name}", "admin", {"name": "backup"}, None, {"ready": "backed_up"}),
        ("GET", "/api/v1/families", "viewer", {}, None, {}),
        ("POST", "/api/v1/families", "programmer", {}, {"text": ROLL}, {}),
        ("GET", "/api/v1/families/{name}", "viewer", {"name": "hyperbolic-roll"}, None, {}),
        ("PUT", "/api/v1/families/{name}", "programmer", {"name": "hyperbolic-roll"}, {"text": ROLL_2}, {"headers": MATCH_1}),
        ("GET", "/api/v1/parts", "viewer", {}, None, {}),
        ("POST", "/api/v1/parts", "programmer", {}, {"number": "R-1", "family": "hyperbolic-roll", "values": {}}, {}),
        ("GET", "/api/v1/parts/{number}", "viewer", {"number": "R-1"}, None, {}),
        ("PUT", "/api/v1/parts/{number}", "programmer", {"number": "R-1"}, {"values": {"angle_step": "1 deg"}}, {"headers": MATCH_1}),
        ("POST", "/api/v1/render", "programmer", {}, {"part": "R-1", "machine": "lathe", "name": "O0100"}, {}),
        ("GET", "/api/v1/programs", "viewer", {}, None, {}),
        ("POST", "/api/v1/programs", "programmer", {}, {"name": "O0042", "dialect": "fanuc", "text": plain_program(2000)}, {"keep": "program"}),
        ("GET", "/api/v1/programs/{id}", "viewer", {"id": "program"}, None, {}),
        ("GET", "/api/v1/programs/{id}/text", "viewer", {"id": "program"}, None, {}),
        ("GET", "/api/v1/programs/{id}/lines", "viewer", {"id": "program"}, None, {}),
        ("POST", "/api/v1/programs/{id}/revisions", "programmer", {"id": "program"}, {"text": plain_program(2001)}, {"headers": MATCH_1}),
        ("GET", "/api/v1/programs/{id}/revisions", "viewer", {"id": "program"}, None, {}),
        ("PATCH", "/api/v1/programs/{id}", "programmer", {"id": "program"}, {"tags": ["pump"], "folder": "acme"}, {}),
        ("POST", "/api/v1/attachments", "programmer", {}, b"%PDF-1.4", {"query": lambda: f"?name=sheet.pdf&program={made['program']}", "keep": "attachment"}),
        ("GET", "/api/v1/attachments", "viewer", {}, None, {}),
        ("GET", "/api/v1/attachments/{id}", "viewer", {"id": "attachment"}, None, {}),
        ("GET", "/api/v1/attachments/{id}/content", "viewer", {"id": "attachment"}, None, {}),
        ("POST", "/api/v1/attachments/{id}/remove", "programmer", {"id": "attachment"}, {"reason": "of another part"}, {}),
        ("POST", "/api/v1/programs/{id}/archive", "programmer", {"id": "program"}, {"reason": "sold"}, {}),
        ("POST", "/api/v1/programs/{id}/fetch-back", "programmer", {"id": "program"}, {"reason": "ordered again"}, {}),
        ("POST", "/api/v1/programs/{id}/delete", "approver", {"id": "old_program"}, {"reason": "sold"}, {"ready": "put_aside"}),
        ("GET", "/api/v1/programs/{id}/uses", "viewer", {"id": "program"}, None, {}),
        ("GET", "/api/v1/search", "viewer", {}, None, {"query": "?q=O0042"}),
        ("GET", "/api/v1/programs/{id}/compare", "viewer", {"id": "program"}, None, {"query": "?with_revision=1"}),
        ("GET", "/api/v1/programs/{id}/path", "viewer", {"id": "program"}, None, {}),
        ("GET", "/api/v1/programs/{id}/picture", "viewer", {"id": "program"}, None, {}),
        ("GET", "/api/v1/programs/{id}/stock", "viewer", {"id": "program"}, None, {"query": "?stock=cylinder+80+-100+2&machine=lathe"}),
        ("POST", "/api/v1/path", "programmer", {}, {"text": "M30"}, {}),
        ("POST", "/api/v1/stock", "programmer", {}, {"text": "G17 G90\nM30", "dialect": "fanuc", "stock": "box 0 1 0 1 0 1"}, {}),
        ("POST", "/api/v1/preview", "programmer", {}, {"part": "R-1", "machine": "lathe"}, {}),
        ("POST", "/api/v1/preview/verdict", "programmer", {}, {"part": "R-1", "machine": "lathe"}, {}),
        ("POST", "/api/v1/diagnose", "programmer", {}, {"text": "M30"}, {}),
        ("POST", "/api/v1/imports", "programmer", {}, b"%\nO7\nM30\n%\n", {"query": lambda: "?path=O7.nc"}),
        ("POST", "/api/v1/split", "programmer", {}, {"text": "%\nO1\nM30\nO2\nM30\n%\n"}, {}),
        ("POST", "/api/v1/programs/{id}/compare", "programmer", {"id": "program"}, {"text": "M30"}, {}),
        ("POST", "/api/v1/rewrite", "programmer", {}, {"text": "M30", "how": "renumber"}, {}),
        ("POST", "/api/v1/statistics", "programmer", {}, {"text": "M30"}, {}),
        ("POST", "/api/v1/convert", "programmer", {}, {"text": "M30", "to": "fanuc"}, {}),
        ("POST", "/api/v1/optimize", "programmer", {}, {"text": "M30"}, {}),
        ("GET", "/api/v1/dialects/{name}/words", "viewer", {"name": "fanuc"}, None, {}),
        ("POST", "/api/v1/checks", "programmer", {}, lambda: {"program": made["program"], "machine": "lathe"}, {"keep": "check"}),
        ("GET", "/api/v1/checks", "viewer", {}, None, {}),
        ("GET", "/api/v1/checks/{id}", "viewer", {"id": "check"}, None, {}),
        ("POST", "/api/v1/checks/{id}/waivers", "approver", {"id": "check"}, {"reason": "seen"}, {}),
        ("POST", "/api/v1/accuracy", "programmer", {}, lambda: {"program": made["program"], "machine": "lathe", "nominal": {"family": "hyperbolic-roll"}}, {}),
        ("POST", "/api/v1/gouge", "programmer", {}, lambda: {"program": made["program"], "machine": "lathe", "nominal": {"family": "hyperbolic-roll"}}, {}),
        ("POST", "/api/v1/timing", "programmer", {}, lambda: {"program": made["program"], "machine": "lathe"}, {}),
        ("POST", "/api/v1/sweep", "programmer", {}, {"family": "hyperbolic-roll", "machine": "lathe", "samples": 0, "values": ROLL_VALUES}, {}),
        ("POST", "/api/v1/releases", "programmer", {}, lambda: {"program": made["program"], "machine": "lathe"}, {"keep": "release"}),
        ("GET", "/api/v1/releases", "viewer", {}, None, {}),
        ("GET", "/api/v1/releases/{id}", "viewer", {"id": "release"}, None, {}),
        ("POST", "/api/v1/releases/{id}/transitions", "programmer", {"id": "release"}, {"to": "in_review"}, {}),
        ("POST", "/api/v1/releases/{id}/restart-preview", "operator", {"id": "release"}, {"line": 8}, {"ready": "proving"}),
        ("POST", "/api/v1/releases/{id}/restarts", "programmer", {"id": "release"}, lambda: {"line": 8, "shown_sha256": made["shown"]}, {"ready": "shown"}),
        ("POST", "/api/v1/releases/{id}/sign-off", "operator", {"id": "release"}, {"note": "all sizes good"}, {"refused": "no transfer"}),
        ("GET", "/api/v1/receipts", "viewer", {}, None, {"ready": "received"}),
        ("GET", "/api/v1/receipts/{id}", "viewer", {"id": "receipt"}, None, {}),
        ("GET", "/api/v1/receipts/{id}/text", "viewer", {"id": "receipt"}, None, {}),
        ("POST", "/api/v1/receipts/{id}/explain", "programmer", {"id": "rendered_receipt"}, {}, {"ready": "sent_back"}),
        ("POST", "/api/v1/receipts/{id}/accept", "programmer", {"id": "receipt"}, {}, {}),
        ("POST", "/api/v1/receipts/{id}/discard", "approver", {"id": "torn_receipt"}, {"reason": "torn"}, {}),
        ("GET", "/api/v1/requests", "viewer", {}, None, {}),
        ("GET", "/mtconnect/probe", "viewer", {}, None, {}),
        ("GET", "/mtconnect/current", "viewer", {}, None, {}),
        ("GET", "/mtconnect/sample", "viewer", {}, None, {}),
        ("GET", "/mtconnect/assets", "viewer", {}, None, {}),
        ("GET", "/mtconnect/{name}/probe", "viewer", {"name": "mill"}, None, {}),
        ("GET", "/mtconnect/{name}/current", "viewer", {"name": "mill"}, None, {}),
        ("GET", "/mtconnect/{name}/sample", "viewer", {"name": "mill"}, None, {}),
        ("GET", "/api/v1/event-types", "viewer", {}, None, {}),
        ("POST", "/api/v1/webhooks", "admin", {}, {"url": "http://127.0.0.1:9/in", "types": ["*"], "local": True}, {"keep": "webhook"}),
        ("GET", "/api/v1/webhooks", "admin", {}, None, {}),
        ("GET", "/api/v1/webhooks/{id}", "admin", {"id": "webhook"}, None, {}),
        ("PATCH", "/api/v1/webhooks/{id}", "admin", {"id": "webhook"}, {"description": "the MES"}, {}),
        ("POST", "/api/v1/webhooks/{id}/rotate", "admin", {"id": "webhook"}, {}, {}),
        ("POST", "/api/v1/webhooks/{id}/ping", "admin", {"id": "webhook"}, {}, {"note": "delivery"}),
        ("GET", "/api/v1/webhooks/{id}/deliveries", "admin", {"id": "webhook"}, None, {}),
        ("POST", "/api/v1/webhooks/{id}/deliveries/{delivery}/replay", "admin", {"id": "webhook", "delivery": "delivery"}, {}, {}),
        ("POST", "/api/v1/webhooks/{id}/replay", "admin", {"id": "webhook"}, {"since_ms": 0}, {}),
        ("DELETE", "/api/v1/webhooks/{id}", "admin", {"id": "webhook"}, None, {}),
        ("GET", "/api/v1/alarms", "viewer", {}, None, {"ready": "alarmed"}),
        ("GET", "/api/v1/alarms/{id}", "viewer", {"id": "alarm"}, None, {}),
        ("POST", "/api/v1/alarms/{id}/shelve", "operator", {"id": "alarm"}, {"minutes": 5, "reason": "the cable is ordered"}, {}),
        ("POST", "/api/v1/alarms/{id}/unshelve", "operator", {"id": "alarm"}, {}, {}),
        ("POST", "/api/v1/alarms/{id}/acknowledge", "operator", {"id": "alarm"}, {}, {}),
        ("POST", "/api/v1/orders", "operator", {}, {"number": "A-1", "part": "R-1", "quantity": 5}, {"keep": "order"}),
        ("GET", "/api/v1/orders", "viewer", {}, None, {}),
        ("GET", "/api/v1/orders/{id}", "viewer", {"id": "order"}, None, {}),
        ("PUT", "/api/v1/orders/{id}", "operator", {"id": "order"}, {"part": "R-1", "quantity": 6}, {"headers": MATCH_1}),
        ("POST", "/api/v1/orders/{id}/parts", "operator", {"id": "order"}, {"good": 2}, {}),
        ("POST", "/api/v1/orders/{id}/move", "operator", {"id": "order"}, {"to": "held", "reason": "no material"}, {}),
        ("POST", "/api/v1/groups/{name}/jobs", "operator", {"name": "hall"}, lambda: {"program": made["program"]}, {}),
        ("POST", "/api/v1/jobs", "operator", {}, lambda: {"release": made["release"], "end_check": "part taken out"}, {"keep": "job"}),
        ("GET", "/api/v1/jobs", "viewer", {}, None, {}),
        ("GET", "/api/v1/jobs/{id}", "viewer", {"id": "job"}, None, {}),
        ("GET", "/api/v1/jobs/{id}/forecast", "viewer", {"id": "job"}, None, {}),
        ("POST", "/api/v1/jobs/{id}/move", "operator", {"id": "job"}, {"before": None}, {}),
        ("POST", "/api/v1/jobs/{id}/schedule", "operator", {"id": "job"}, {}, {}),
        ("POST", "/api/v1/jobs/{id}/hold", "operator", {"id": "job"}, {"reason": "no material"}, {}),
        ("POST", "/api/v1/jobs/{id}/end-hold", "operator", {"id": "job"}, None, {}),
        ("GET", "/api/v1/history/sums", "viewer", {}, None, {}),
        ("GET", "/api/v1/stop-reasons", "viewer", {}, None, {}),
        ("GET", "/api/v1/jobs/{id}/stop-reasons", "viewer", {"id": "job"}, None, {}),
        ("POST", "/api/v1/jobs/{id}/arm", "operator", {"id": "job"}, {}, {"ready": "idle"}),
        ("POST", "/api/v1/jobs/{id}/stop", "operator", {"id": "job"}, {}, {"ready": "feeding"}),
        ("POST", "/api/v1/jobs/{id}/resume", "operator", {"id": "job"}, {"reason": "looked at it"}, {"ready": "stopped"}),
        ("POST", "/api/v1/jobs/{id}/cancel", "operator", {"id": "job"}, {}, {}),
        ("POST", "/api/v1/jobs/{id}/confirm-end", "operator", {"id": "job"}, {"note": "on the table"}, {"ready": "ended"}),
        ("POST", "/api/v1/jobs/{id}/retry", "operator", {"id": "job"}, None, {}),
        ("POST", "/api/v1/jobs/{id}/stop-reasons", "operator", {"id": "job"}, {"reason": "tool broken"}, {}),
        ("GET", "/api/v1/work", "viewer", {}, None, {}),
        ("DELETE", "/api/v1/work/{id}", "programmer", {"id": "work"}, None, {"ready": "working"}),
        ("GET", "/api/v1/jobs/{id}/ledger", "viewer", {"id": "job"}, None, {}),
        ("GET", "/api/v1/nodes", "viewer", {}, None, {}),
        ("POST", "/api/v1/machines/{name}/hand-over", "admin", {"name": "lathe"}, {"node": "b", "reason": "it moves"}, {"refused": "only one"}),
        ("POST", "/api/v1/machines/{name}/take-over", "admin", {"name": "lathe"}, {"reason": "a is off"}, {"refused": "only one"}),
        ("POST", "/api/v1/machines/{name}/confirm-reset", "operator", {"name": "lathe"}, {"reason": "RESET pressed"}, {"ready": "torn"}),
    ]


# What a role in a group of machines reaches: changes of a machine of the group, and what acts on no machine in particular.
ON_ONE_MACHINE = {
    ("PUT", "/api/v1/machines/{name}"), ("POST", "/api/v1/machines/{name}/line-test"), ("POST", "/api/v1/machines/{name}/confirm-reset"),
    ("POST", "/api/v1/machines/{name}/hand-over"), ("POST", "/api/v1/machines/{name}/take-over"),
    ("POST", "/api/v1/render"), ("POST", "/api/v1/preview"), ("POST", "/api/v1/preview/verdict"), ("POST", "/api/v1/checks"), ("POST", "/api/v1/checks/{id}/waivers"),
    ("POST", "/api/v1/accuracy"), ("POST", "/api/v1/gouge"), ("POST", "/api/v1/timing"), ("POST", "/api/v1/sweep"),
    ("POST", "/api/v1/releases"), ("POST", "/api/v1/releases/{id}/transitions"), ("POST", "/api/v1/releases/{id}/restart-preview"),
    ("POST", "/api/v1/releases/{id}/restarts"), ("POST", "/api/v1/releases/{id}/sign-off"), ("POST", "/api/v1/receipts/{id}/accept"), ("POST", "/api/v1/receipts/{id}/discard"), ("POST", "/api/v1/receipts/{id}/explain"),
    ("POST", "/api/v1/alarms/{id}/shelve"), ("POST", "/api/v1/alarms/{id}/unshelve"), ("POST", "/api/v1/alarms/{id}/acknowledge"),
    ("POST", "/api/v1/jobs"), ("POST", "/api/v1/jobs/{id}/move"), ("POST", "/api/v1/jobs/{id}/arm"), ("POST", "/api/v1/jobs/{id}/resume"),
    ("POST", "/api/v1/jobs/{id}/cancel"), ("POST", "/api/v1/jobs/{id}/schedule"), ("POST", "/api/v1/jobs/{id}/hold"), ("POST", "/api/v1/jobs/{id}/end-hold"),
    ("POST", "/api/v1/jobs/{id}/retry"), ("POST", "/api/v1/jobs/{id}/confirm-end"), ("POST", "/api/v1/jobs/{id}/stop-reasons"), ("POST", "/api/v1/groups/{name}/jobs"),
}
# Whoever operates one machine may stop them all, and try a text on no machine.
ON_ANY = {("POST", "/api/v1/jobs/{id}/stop"), ("POST", "/api/v1/path"), ("POST", "/api/v1/stock"), ("POST", "/api/v1/diagnose"), ("POST", "/api/v1/convert"),
          ("POST", "/api/v1/optimize"),
          ("POST", "/api/v1/rewrite"), ("POST", "/api/v1/statistics")}


class Stage:
    """Brings the shop to where a row can be taken."""

    def __init__(self, client, control, made):
        self.client, self.control, self.made = client, control, made

    def proving(self):
        self.client.post(f"/releases/{self.made['release']}/transitions", {"to": "proving", "transfers": 9})

    def shown(self):
        self.made["shown"] = self.client.post(f"/releases/{self.made['release']}/restart-preview", {"line": 8})["sha256"]

    def put_aside(self):
        self.made["old_program"] = self.client.add_program(5, "O0005")["id"]
        self.client.post(f"/programs/{self.made['old_program']}/archive", {"reason": "sold"})

    def received(self):
        self.idle()
        for wire in (b"%\nO0700\nM30\n%\n", b"\x12%\nO0701\nG0 X\x14"):
            before = len(self.client.get("/receipts")["items"])
            self.control.say(wire)
            shop.wait_for("a receipt", lambda: len(self.client.get("/receipts")["items"]) > before)
        self.made["torn_receipt"], self.made["receipt"] = (item["id"] for item in self.client.get("/receipts")["items"])

    def working(self):
        endless = "%\nO7001\n#100=0\nWHILE[#100GE0]DO1\n#1=" + "+".join(["SIN[#1]"] * 40) + "\nEND1\nM30\n%\n"
        program = self.client.post("/programs", {"name": "O7001", "dialect": "fanuc", "text": endless})["id"]
        threading.Thread(target=self.client.call, args=("POST", "/checks", {"program": program, "machine": "lathe"}, "programmer"), daemon=True).start()
        self.made["work"] = shop.wait_for("a check to run", lambda: [one["id"] for one in self.client.get("/work")["items"] if one["actor"] != "dripfeed"])[0]

    def alarmed(self):
        self.made["alarm"] = shop.wait_for("an alarm", lambda: next((one["id"] for one in self.client.get("/alarms")["items"] if one["kind"] == "quarantined"), None))

    def backed_up(self):
        self.made["backup"] = self.client.get("/backups")["items"][0]["name"]

    def sent_back(self):
        """The control sends the rendered program as it has it."""
        rendered = next(one for one in self.client.get("/programs?part=R-1")["items"])
        text = self.client.call("GET", f"/programs/{rendered['id']}/text").body
        self.idle()
        before = len(self.client.get("/receipts")["items"])
        self.control.say(b"\x12" + text.replace(b"\r", b"") + b"\x14")
        self.made["rendered_receipt"] = shop.wait_for("a receipt", lambda: (lambda rows: rows[0]["id"] if len(rows) > before else None)(self.client.get("/receipts")["items"]))

    def olga(self):
        """The viewer is a person from now on."""
        self.client.post("/users", {"name": "olga", "role": "viewer"})
        self.client.must("PUT", "/users/olga/password", {"secret": "the first of olga"})
        self.client.tokens["viewer"] = self.client.post("/tokens", {"name": "olga's tablet", "role": "viewer", "user": "olga"})["token"]

    def of_the_hall(self):
        """The mill that a row has added belongs to the same group as the lathe."""
        self.client.must("PUT", "/groups/hall", {"machines": ["lathe", "mill"]})

    def idle(self):
        self.client.wait_line("lathe", "idle")

    def feeding(self):
        self.control.say(DC1)
        self.client.wait_job(self.made["job"], "feeding")

    def stopped(self):
        self.client.wait_job(self.made["job"], "held", stall="stopped")

    def ended(self):
        self.client.wait_job(self.made["job"], "cancelled")

    def torn(self):
        job = self.client.queue(self.made["release"])
        self.idle()
        self.client.post(f"/jobs/{job}/arm")
        self.control.say(DC1)
        self.control.hold_inside_block()
        self.control.cut()
        expect(self.client.wait_job(job, "failed")["needs_confirmation"], "the block is not known as torn")


def path_of(pattern, names, made):
    for name, value in names.items():
        pattern = pattern.replace("{" + name + "}", str(made.get(value, value)))
    return pattern


def try_row(client, stage, made, row):
    method, pattern, role, names, body, more = row
    if "ready" in more:
        getattr(stage, more["ready"])()
    query = more.get("query", "")
    path, body = path_of(pattern, names, made) + (query() if callable(query) else query), body() if callable(body) else body
    headers, what = more.get("headers", {}), f"{method} {pattern}"
    if role:
        for wrong in ({}, {"Authorization": "Bearer nonsense"}, {"Authorization": f"Basic {client.tokens['admin']}"}, {"Cookie": "dripfeed_session=nonsense"}):
            answer = client.call(method, path, body, None, headers | wrong)
            expect_problem(answer, 401, f"{what} with {wrong or 'no token'}")
            expect(answer.headers["WWW-Authenticate"] == "Bearer", f"{what}: a 401 without its WWW-Authenticate")
        for below in ROLES[: ROLES.index(role)]:
            expect_problem(client.call(method, path, body, below, headers), 403, f"{what} as {below}", [role, below])
    answer = client.call(method, path, body, by_group(client, row, path, body, headers) or role, headers)
    if "refused" in more:  # to all, for a reason that is no right
        expect_problem(answer, more.get("status", 409), f"{what} as {role or 'anybody'}", [more["refused"]])
        return
    expect(200 <= answer.status < 300, f"{what} as {role or 'anybody'}: {answer}")
    if "note" in more:
        made[more["note"]] = answer.document["id"]
    if "keep" in more:
        made[more["keep"]] = answer.document["id"]
        expect(answer.status == 201 and answer.headers["Location"] == f"{path.split('?')[0]}/{answer.document['id']}", f"{what}: {answer.headers['Location']}")
    if method == "GET" and role:
        for above in ROLES[ROLES.index(role):]:
            expect(client.call(method, path, None, above, headers).status == answer.status, f"{what} as {above}")


def make_groups(client, folder):
    """HALL-ROLE has the role on the lathe and the mill, OTHER on a third machine, and is a viewer elsewhere."""
    client.post("/machines", shop.preset("fanuc-0i-mill", url=f"pty:{folder}/other") | {"name": "other"})
    client.must("PUT", "/groups/hall", {"machines": ["lathe"]})
    client.must("PUT", "/groups/others", {"machines": ["other"]})
    for name, group, role in [(f"hall-{role}", "hall", role) for role in ROLES] + [("others", "others", "admin")]:
        client.post("/users", {"name": name, "role": "viewer", "grants": [{"group": group, "role": role}]})
        client.tokens[name] = client.post("/tokens", {"name": name, "role": "admin", "user": name})["token"]


def by_group(client, row, path, body, headers):
    """Tries a change with roles in groups of machines; by whose token it may be made, where a group's role is enough."""
    method, pattern, role = row[:3]
    what = f"{method} {pattern}"
    if method == "GET" or role in (None, "viewer"):
        return None
    if (method, pattern) in ON_ANY:
        expect_problem(client.call(method, path, body, "hall-viewer", headers), 403, f"{what} as viewer in a group")
        return "others"
    if (method, pattern) not in ON_ONE_MACHINE:
        expect_problem(client.call(method, path, body, "hall-admin", headers), 403, f"{what} as admin of a group")
        return None
    expect_problem(client.call(method, path, body, "others", headers), 403, f"{what} as admin of another group")
    below = ROLES[ROLES.index(role) - 1]
    expect_problem(client.call(method, path, body, f"hall-{below}", headers), 403, f"{what} as {below} in the group")
    return f"hall-{role}"


def every_route(folder):
    web = folder / "web"
    (web / "assets").mkdir(parents=True)
    (web / "index.html").write_text("<!doctype html><title>page</title>")
    (web / "assets" / "app.js").write_text("'use strict';")
    (web / "docs").mkdir()
    for name in ("index", "safety"):
        (web / "docs" / f"{name}.html").write_text("<!doctype html><title>docs</title>")
    control = HandControl()
    client = Client(folder, "--web", str(web), "--delete-after-days", "0").start()
    client.post("/machines", hand_profile(control))
    mill = shop.preset("fanuc-0i-mill", url=f"pty:{folder}/nobody")
    make_groups(client, folder)
    made = {"token": client.tokens["viewer"], "mill_profile": mill | {"name": "mill"}}
    stage = Stage(client, control, made)
    for row in rows(made):
        try_row(client, stage, made, row)
    expect(client.server.alive(), "the server is gone")
    expect(client.call("GET", "/api/openapi.json", role=None).document == contract.document(), "the server describes itself otherwise than the command")
    refused = {(row[0], row[1]) for row in rows(made) if "refused" in row[5]}
    missed = [one for one in contract.never_validated() if tuple(one[:2]) not in refused]
    expect(not missed, f"no answer was compared with openapi.json: {missed}")
    client.server.stop()
    control.close()


def no_route_without_a_row(folder):
    client = Client(folder).start()
    document = client.call("GET", "/api/openapi.json", role=None).document
    client.server.stop()
    rights = {(method, pattern): role for method, pattern, role, *_ in rows({})}
    expect(len(rights) == len(rows({})), "a route has two rows")
    found = differences(rights, document) + shape_faults(document)
    expect(not found, "\n".join(found))
    the_comparison_can_fail(rights, document)
    the_shape_can_fail(document)


def the_comparison_can_fail(rights, document):
    job = ("GET", "/api/v1/jobs/{id}")
    for changed, sentence in [
        ({k: v for k, v in rights.items() if k != job}, "GET /api/v1/jobs/{id} is described and has no row"),
        (rights | {("GET", "/api/v1/nothing"): "viewer"}, "GET /api/v1/nothing has a row and is not described"),
        (rights | {job: "operator"}, "GET /api/v1/jobs/{id} is documented to need viewer, not operator"),
        (rights | {job: None}, "GET /api/v1/jobs/{id} is documented to need viewer, not None"),
    ]:
        found = differences(changed, document)
        expect(found == [sentence], f"expected \"{sentence}\", found {found}")


def the_shape_can_fail(document):
    def broken(word, change):
        wrong = copy.deepcopy(document)
        change(wrong, wrong["paths"]["/api/v1/jobs/{id}"]["get"])
        found = shape_faults(wrong)
        expect(found and all(word in one for one in found), f"expected faults with \"{word}\", found {found}")

    broken("operationId", lambda d, o: o.pop("operationId"))
    broken("given twice", lambda d, o: o.update(operationId="get_jobs"))
    broken("summary", lambda d, o: o.update(summary=""))
    broken("no responses", lambda d, o: o.pop("responses"))
    broken("response 99", lambda d, o: o["responses"].update({"99": {"description": "x"}}))
    broken("not those of the path", lambda d, o: o.update(parameters=[]))
    broken("has no meaning", lambda d, o: o["parameters"][0].pop("description"))
    broken("no group", lambda d, o: o.update(tags=[""]))
    broken("is not required", lambda d, o: o["parameters"][0].update(required=False))
    broken("scheme nobody", lambda d, o: o.update(security=[{"nobody": []}]))
    broken("leads nowhere", lambda d, o: d["components"]["schemas"].pop("Problem"))
    broken("3.1", lambda d, o: d.update(openapi="3.0.3"))
    broken("no version", lambda d, o: d["info"].pop("version"))
    broken("no body", lambda d, o: d["paths"]["/api/v1/jobs"]["post"]["requestBody"].pop("content"))
    broken("no success", lambda d, o: o["responses"].pop("200"))
    broken("not described by a schema", lambda d, o: o["responses"]["200"]["content"]["application/json"].pop("schema"))
    broken("an example of NewJob", lambda d, o: d["components"]["schemas"]["NewJob"]["examples"][0].update(release="17"))
    broken("no example", lambda d, o: d["components"]["schemas"]["Job"].pop("examples"))
    broken("no meaning", lambda d, o: d["components"]["schemas"]["Job"]["properties"]["state"].pop("description"))


if __name__ == "__main__":
    contract.the_check_can_fail()
    in_folder(no_route_without_a_row)
    in_folder(every_route)
    sys.exit(0)
