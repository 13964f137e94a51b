"""dripfeed serve --config: the file's members are the options, the command line wins, what is wrong is named with its line and column, and --check
starts nothing."""

import json
import re
import subprocess
import sys

from jsonschema import Draft202012Validator

from client import Client, HandControl, binary, expect, hand_profile, in_folder


def serve(*arguments, code):
    done = subprocess.run([str(binary()), "serve", *map(str, arguments)], capture_output=True, text=True, timeout=30)
    expect(done.returncode == code, f"{arguments} ended with {done.returncode}: {done.stdout} {done.stderr}")
    return done.stdout if code == 0 else done.stderr


def check(folder, content, *arguments, code=0):
    file = folder / "dripfeed.json"
    file.write_text(content if isinstance(content, str) else json.dumps(content))
    return serve("--config", file, "--check", *arguments, code=code)


def what_it_says(folder):
    said = check(folder, {"data": f"{folder}/store", "listen": "127.0.0.1:1"})
    expect(f"{folder}/store" in said and "127.0.0.1:1" in said, said)
    said = check(folder, {"data": f"{folder}/store", "listen": "127.0.0.1:1"}, "--listen", "127.0.0.1:2")
    expect(f"{folder}/store" in said and "127.0.0.1:2" in said, f"the command line does not win: {said}")
    expect(not (folder / "store").exists(), "a check made the folder")
    wrong = '{\n  "data": "/srv/d",\n  "listn": ":80",\n  "check_seconds": "long",\n  "proxy": [1]\n}\n'
    said = check(folder, wrong, code=2)
    for words in ("line 3, column 3: /listn", "line 4, column 3: /check_seconds", "line 5, column 3: /proxy entry 1", "dripfeed.json"):
        expect(words in said, f"\"{words}\" is not in {said}")
    expect("line 2, column 1" in check(folder, '{\n,}', code=2), "no place of what is not JSON")
    expect("go together" in check(folder, {"tls_cert": "/nothing.pem"}, code=2), "half a pair")
    expect("/nothing.pem" in check(folder, {"tls_cert": "/nothing.pem", "tls_key": "/nothing.key"}, code=2), "a certificate that is not there")
    expect("--insecure" in check(folder, {"listen": "0.0.0.0:80"}, code=2), "no TLS")
    check(folder, {"listen": "0.0.0.0:80", "insecure": True})
    expect("named twice" in check(folder, {"modbus_unit": {"a": 1, "b": 1}}, code=2), "a unit twice")
    expect("--store" in check(folder, {"node": "hall-1"}, code=2), "a node without a store that is shared")
    expect("not 0..65535" in check(folder, {"modbus_listen": ":x"}, code=2), "no address")
    expect("\"6:00\" is not a time of day" in check(folder, {"shift": ["6:00"]}, code=2), "no time of day")
    expect("there twice" in check(folder, {"stop_reason": ["a", "a"]}, code=2), "a reason twice")
    expect("colon" in check(folder, {"stop_reason": ["a: b"]}, code=2), "a reason with a colon")
    expect("same time" in check(folder, {"shift": ["06:00", "06:00"]}, code=2), "a shift twice")
    expect("go together" in check(folder, {"arming_hook": "https://erp.shop/may-i"}, code=2), "a hook without its secret")
    expect("refuse or warn" in check(folder, {"arming_hook_unanswered": "arm"}, code=2), "no word for it")
    for part, words in [({"oidc": "https://login.shop"}, "needs --oidc-client-id"), ({"oidc_client_id": "dnc"}, "give --oidc"), ({"oidc": "http://login.shop", "oidc_client_id": "dnc", "oidc_page": "https://dnc.shop"}, "--oidc must be https"),
                        ({"oidc": "https://login.shop", "oidc_client_id": "dnc", "oidc_page": "https://dnc.shop/"}, "--oidc-page must be scheme and host"),
                        ({"oidc": "https://login.shop", "oidc_client_id": "dnc", "oidc_page": "http://dnc.shop"}, "--oidc-page must be https"), ({"oidc_group": ["dnc=boss"]}, "use GROUP=ROLE"),
                        ({"oidc_group": ["=admin"]}, "use GROUP=ROLE"), ({"oidc_group": ["dnc=admin@"]}, "use GROUP=ROLE")]:
        expect(words in check(folder, part, code=2), f"{part}: {words}")
    expect("text or json" in check(folder, {"log": "xml"}, code=2), "no form of a log")
    serve("--config", folder / "none.json", "--check", code=2)


def the_schema(folder):
    schema = json.loads(serve("--config-schema", code=0))
    Draft202012Validator.check_schema(schema)
    validator = Draft202012Validator(schema)
    whole = {"data": "/srv/d", "store": "postgresql://dnc@db.shop/dripfeed", "node": "hall-1", "backups": "/mnt/backups", "listen": ":80", "web": "", "log": "json", "insecure": True, "proxy": ["::1"], "modbus_listen": ":502",
             "modbus_allow": ["::1"], "modbus_unit": {"lathe": 1}, "shdr_listen": "127.0.0.1:7878", "shdr_allow": ["::1"], "event_source": "https://dnc.shop", "webhook_ca": "", "webhook_retry_s": [5, 300], "mqtt": "mqtt://broker.shop", "mqtt_user": "dnc",
             "mqtt_password_file": "", "mqtt_client_id": "", "mqtt_prefix": "plant/hall-2", "mqtt_ca": "", "sparkplug_group": "hall", "sparkplug_node": "dnc 1", "shift": ["05:30", "17:30"], "stop_reason": ["tool broken", "no material"],
             "arming_hook": "https://erp.shop/may-i", "arming_hook_secret_file": "/etc/dripfeed/hook", "arming_hook_unanswered": "warn", "arming_hook_local": True,
             "arming_hook_seconds": 2, "oidc": "https://login.shop", "oidc_client_id": "dnc", "oidc_client_secret_file": "", "oidc_page": "https://dnc.shop", "oidc_title": "the shop",
             "oidc_scope": "profile groups", "oidc_name_claim": "upn", "oidc_groups_claim": "roles", "oidc_group": ["dnc=admin", "cn=heads,ou=shop=operator@mills"], "oidc_ca": "", "oidc_local": True,
             "oidc_seconds": 2, "check_seconds": 1, "check_memory": 64,
             "program_mb": 1, "attachment_mb": 64, "store_mb": 0, "delete_after_days": 0}
    expect(set(schema["properties"]) == set(whole) | {"tls_cert", "tls_key"}, f"{sorted(schema['properties'])}")
    options = subprocess.run([str(binary()), "serve", "--help"], capture_output=True, text=True, timeout=30).stdout
    for name in schema["properties"]:
        expect(f"--{name.replace('_', '-')} " in options, f"{name} is no option")
    for good in (whole, {}):
        expect(not list(validator.iter_errors(good)), f"the schema refuses {good}")
        check(folder, good)
    for bad in ({"dat": ""}, {"check_seconds": 0}, {"proxy": "::1"}, {"proxy": [""]}, {"modbus_unit": {"a": 248}}, {"insecure": 1}, {"webhook_retry_s": [0]}, {"webhook_retry_s": ["5"]}, {"arming_hook_seconds": 16}, {"oidc_seconds": 16}, {"oidc_group": "dnc=admin"}, {"shift": "06:00"}, []):
        expect(list(validator.iter_errors(bad)), f"the schema takes {bad}")
        check(folder, bad, code=2)


def a_server_of_it(folder):
    """The client gives --data and --listen, which win; the rest is the file's."""
    (folder / "page").mkdir()
    (folder / "page" / "index.html").write_text("<title>of the file</title>")
    (folder / "s.json").write_text(json.dumps({"data": "/nowhere", "listen": "127.0.0.1:1", "web": f"{folder}/page"}))
    client = Client(folder, "--config", str(folder / "s.json")).start()
    expect(b"of the file" in client.call("GET", "/", role=None).body, "the page of the file")
    client.server.stop()


def a_log_of_objects(folder):
    """Each line of the log is one object, also where what it names has quotes and line ends; the address is no part of the log."""
    client = Client(folder, "--log", "json").start()
    control = HandControl()
    client.post("/machines", hand_profile(control, 'lathe "1"') | {"title": "two\nlines"})
    client.wait_line("lathe%20%221%22", "idle")
    client.server.stop()
    control.close()
    lines = [line for line in (client.server.data / "server.log").read_text().splitlines() if not line.startswith("dripfeed is at ")]
    rows = [json.loads(line) for line in lines]
    expect(len(rows) >= 2 and all(set(row) == {"time", "level", "text"} for row in rows), f"{rows}")
    for row in rows:
        expect(re.fullmatch(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d(\.\d+)?Z", row["time"]) and row["level"] in ("debug", "info", "warning", "error", "critical") and row["text"], f"{row}")


if __name__ == "__main__":
    for test in (what_it_says, the_schema, a_server_of_it, a_log_of_objects):
        in_folder(test)
