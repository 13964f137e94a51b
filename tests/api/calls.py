"""A program is checked with the programs that it calls, as the library has them: which one is meant, what is stated of it, and that a verdict does not
outlive them."""

import json

from client import Client, HandControl, expect, hand_profile, in_folder, shop

MAIN = "%\nO0012\nG21G18G99G97\nT0101\nS800M3\nG0X50.Z5.\nM98P42\nG0X100.Z100.\nM30\n%\n"
SUB = "%\nO0042\nG1X40.F0.2\nM98P0043\nM99\n%\n"
LEAF = "%\nO0043\nG1Z2.F0.1\nM99\n%\n"
BAD_LEAF = "%\nO0043\nG1Z2.F0.1\nG1X[1.\nM99\n%\n"


def add(client, name, text, folder=None):
    number = client.post("/programs", {"name": name, "dialect": "fanuc", "text": text})["id"]
    if folder:
        client.must("PATCH", f"/programs/{number}", {"folder": folder})
    return number


def revise(client, program, text):
    newest = client.get(f"/programs/{program}")["revision"]
    client.must("POST", f"/programs/{program}/revisions", {"text": text}, headers={"If-Match": f'"{newest}"'})


def check(client, program, machine="lathe"):
    return client.post("/checks", {"program": program, "machine": machine, "delivery": "memory"})


def not_checked(verdict):
    return " | ".join(one["text"] if isinstance(one, dict) else one for one in verdict["not_checked"])


def called(verdict):
    return {one["name"]: (one["program"], one["revision"]) for one in verdict["calls"]}


def a_chain(client):
    main = add(client, "O0012", MAIN)
    alone = check(client, main)
    expect(alone["verdict"] == "unknown" and called(alone) == {}, alone["verdict"])
    sub = add(client, "O0042", SUB)
    half = check(client, main)
    expect(called(half) == {"O42": (sub, 1)} and half["verdict"] == "unknown", called(half))
    leaf = add(client, "O0043", LEAF)
    whole = check(client, main)
    expect(called(whole) == {"O42": (sub, 1), "O43": (leaf, 1)}, called(whole))
    expect("unknown" != whole["verdict"] != "fail", json.dumps(whole)[:1500])
    expect("whether the control holds O42 as revision 1" in not_checked(whole), not_checked(whole))
    expect(client.get(f"/checks/{whole['id']}")["calls"] == whole["calls"], "the verdict as it is stored")
    # A fault is reported in the program that has it.
    revise(client, leaf, BAD_LEAF)
    bad = check(client, main)
    expect(called(bad)["O43"] == (leaf, 2) and bad["verdict"] in ("unknown", "fail"), bad["verdict"])
    expect("O43" in not_checked(bad) or any(one["file"] for one in bad["diagnostics"]), bad["diagnostics"])
    revise(client, leaf, LEAF.replace("Z2.", "Z1."))
    # The figures are made with them, too.
    timing = client.post("/timing", {"program": main, "machine": "lathe", "delivery": "memory"})
    expect(timing["blocks"] >= 9, timing)
    return main, sub, leaf


def a_verdict_that_is_over(client, main, sub, leaf):
    verdict = check(client, main)
    client.post(f"/checks/{verdict['id']}/waivers", {"reason": "a text of a test"})
    release = client.post("/releases", {"program": main, "machine": "lathe", "delivery": "memory"})["id"]
    move = {"note": "signed by a test", "transfers": 3}
    client.post(f"/releases/{release}/transitions", move | {"to": "in_review"})
    revise(client, leaf, LEAF.replace("Z2.", "Z3."))
    client.refuse(409, "POST", f"/releases/{release}/transitions", move | {"to": "proving"}, words=["O43", "check the text again"])
    client.post(f"/checks/{check(client, main)['id']}/waivers", {"reason": "a text of a test"})
    client.post(f"/releases/{release}/transitions", move | {"to": "proving"})
    job = client.post("/jobs", {"release": release})["id"]
    revise(client, sub, SUB.replace("X40.", "X41."))
    client.refuse(409, "POST", "/jobs", {"release": release}, words=["O42"])
    client.refuse(409, "POST", f"/jobs/{job}/arm", {}, words=["O42"])
    client.post(f"/checks/{check(client, main)['id']}/waivers", {"reason": "a text of a test"})
    client.post(f"/jobs/{job}/cancel")


def which_one(client, main):
    """Several of one name: none is taken, but that of the caller's folder, or the one that is released for the machine."""
    other = add(client, "O0042", SUB.replace("X40.", "X30."), "customer/other")
    verdict = check(client, main)
    expect(called(verdict).get("O42", (0, 0))[0] != other, called(verdict))
    inside = add(client, "O0099", MAIN.replace("O0012", "O0099"), "customer/other")
    expect(called(check(client, inside))["O42"] == (other, 1), "the one in the caller's folder")
    third = add(client, "O0042", SUB.replace("X40.", "X20."))
    verdict = check(client, main)
    expect("O42" not in called(verdict) and verdict["verdict"] == "unknown", called(verdict))
    expect("several of this name" in not_checked(verdict), not_checked(verdict))
    client.post(f"/checks/{check(client, third)['id']}/waivers", {"reason": "a text of a test"})
    release = client.post("/releases", {"program": third, "machine": "lathe", "delivery": "memory"})["id"]
    for step in ("in_review", "proving"):
        client.post(f"/releases/{release}/transitions", {"to": step, "note": "signed by a test", "transfers": 3})
    revise(client, third, SUB.replace("X40.", "X21."))
    expect(called(check(client, main))["O42"] == (third, 1), "the revision that was released for the machine")


def a_dump(client):
    """A text of several programs: just the called one of it is run, and its lines are those of the text."""
    dump = add(client, "MACROS.TXT", "%\nO7001\nG1X999999.\nM99\nO7002\nG1X30.F0.2\nG1X[2.\nM99\n%\n")
    main = add(client, "O7000", MAIN.replace("O0012", "O7000").replace("P42", "P7002"))
    shop.wait_for("the library to be whole", lambda: client.get("/search?q=x")["waiting"] == 0)
    verdict = check(client, main)
    expect(called(verdict) == {"O7002": (dump, 1)}, called(verdict))
    expect(any(one["line"] == 7 and one["file"] for one in verdict["diagnostics"]), verdict["diagnostics"])


def a_translation(client):
    """A stored program is written out with what it calls, and its macros are those of the stored definition file. What is refused has its place there."""
    add_one = lambda name, text: client.post("/programs", {"name": name, "dialect": "sinumerik-840d", "text": text})["id"]  # noqa: E731
    add_one("UGUD.DEF", "DEF CHAN REAL SAFE_Z=55.\nM17\n")
    add_one("UMAC.DEF", "DEFINE AWAY AS 55\nM17\n")
    pocket = add_one("POCKET.SPF", "G1 Z-2 F200\nG0 Z=AWAY\nM17\n")
    main = add_one("MAIN.MPF", "G71 G17 G90 G54\nT1 D1\nS900 M3\nG0 X10 Y20 Z5\nPOCKET\nM30\n")
    shop.wait_for("the library to be whole", lambda: client.get("/search?q=x")["waiting"] == 0)
    made = client.post("/convert", {"program": main, "to": "fanuc", "mode": "explicit"})
    expect(made["text"] and "Z55." in made["text"] and "F200" in made["text"], made)
    revise(client, pocket, "G1 Z-2 F200\nG0 Z=SAFE_Z\nM17\n")
    refused = client.post("/convert", {"program": main, "to": "fanuc", "mode": "explicit"})
    expect(refused["text"] is None and [(one["file"], one["line"]) for one in refused["diagnostics"]] == [("POCKET.SPF", 2)] * 2, refused)


def run(folder):
    client = Client(folder).start()
    control = HandControl()
    client.post("/machines", hand_profile(control))
    main, sub, leaf = a_chain(client)
    a_verdict_that_is_over(client, main, sub, leaf)
    which_one(client, main)
    a_dump(client)
    a_translation(client)
    expect(client.server.alive(), "the server is gone")
    client.server.stop()
    control.close()


if __name__ == "__main__":
    in_folder(run)
