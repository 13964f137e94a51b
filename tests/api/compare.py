"""Two revisions, or two programs, compared with each other by GET /programs/{id}/compare and by `dripfeed compare`: what is equal, what differs and where,
and what cannot be stated."""

import json
import subprocess
import sys

from client import Client, binary, expect, hand_profile, HandControl, in_folder

HEAD = "%\nO0100\nG21 G17 G90 G94 G54\n"
PLAIN = HEAD + "N10 G0 X0. Y0.\nN20 G1 X10. F100.\nN30 X20.\nM30\n%\n"
WRITTEN_OTHERWISE = "%\nO0100 (PUMP)\nG21G17G90G94G54\n(START)\nG00X0.0Y0.0\nG01X10.000F0100.\nX20.\nM30\n%\n"
MOVED = PLAIN.replace("X20.", "X20.25")


def answers(document):
    return [document[part]["answer"] for part in ("text", "meaning", "motions")]


def add(client, text, name="O0100", dialect="fanuc"):
    return client.post("/programs", {"name": name, "dialect": dialect, "text": text})["id"]


def revise(client, program, text, revision):
    client.must("POST", f"/programs/{program}/revisions", {"text": text}, headers={"If-Match": f'"{revision}"'})


def revisions_of_one(client):
    program = add(client, PLAIN)
    revise(client, program, WRITTEN_OTHERWISE, 1)
    revise(client, program, MOVED, 2)
    found = client.get(f"/programs/{program}/compare?revision=1&with_revision=2")
    expect(answers(found) == ["differs", "equal", "equal"], found)
    expect(found["first"] == {"program": program, "name": "O0100", "revision": 1} and found["second"]["revision"] == 2, found)
    expect(found["motions"]["moves"] == 3 and found["motions"]["deviation_mm"] == 0, found["motions"])
    found = client.get(f"/programs/{program}/compare?with_revision=1")  # the newest against the first
    expect(answers(found) == ["differs"] * 3, found)
    expect(found["meaning"]["changes"] == [{"first": [{"line": 6, "text": "N30 X20.25"}], "second": [{"line": 6, "text": "N30 X20."}]}], found["meaning"])
    motions = found["motions"]
    expect((motions["first_line"], motions["second_line"], motions["deviation_mm"]) == (6, 6, 0.25), motions)
    expect(answers(client.get(f"/programs/{program}/compare?with={program}")) == ["equal"] * 3, "a program is not equal to itself")
    return program


def a_text_that_is_not_stored(client, program):
    found = client.must("POST", f"/programs/{program}/compare", {"text": MOVED, "revision": 1}, role="programmer")
    expect(answers(found) == ["differs"] * 3 and found["motions"]["deviation_mm"] == 0.25, found)
    expect(found["first"]["revision"] == 1 and found["second"] == {"program": program, "name": "O0100", "revision": None}, found)
    expect(answers(client.must("POST", f"/programs/{program}/compare", {"text": MOVED})) == ["equal"] * 3, "the newest is what was saved last")
    expect(client.get(f"/programs/{program}")["revision"] == 3, "something was stored")
    client.refuse(404, "POST", f"/programs/{program}/compare", {"text": MOVED, "revision": 9})


def programs_of_two(client, program):
    other = add(client, PLAIN.replace("O0100", "O0200"), "O0200")
    expect(answers(client.get(f"/programs/{program}/compare?with={other}&revision=1")) == ["differs", "equal", "equal"], "the name is compared with it")
    open_end = add(client, PLAIN.replace("X20.", "X#500"))
    found = client.get(f"/programs/{open_end}/compare?with={open_end}")
    expect(answers(found) == ["equal", "equal", "not_compared"] and "#500" in json.dumps(found["motions"]) or "not known" in found["motions"]["why"], found)
    broken = add(client, PLAIN.replace("X20.", "X[20."))
    found = client.get(f"/programs/{broken}/compare?with={program}&with_revision=1")
    expect(answers(found) == ["differs", "not_compared", "not_compared"], found)
    expect("the first: line 6" in found["meaning"]["why"], found["meaning"])
    siemens = add(client, "G1 X10 F100\nM30\n", "P.MPF", "sinumerik-840d")
    expect(answers(client.get(f"/programs/{siemens}/compare?with={program}"))[1:] == ["not_compared"] * 2, "two languages are compared with each other")


def a_machine_decides(client, program):
    control = HandControl()
    client.post("/machines", hand_profile(control))
    expect(answers(client.get(f"/programs/{program}/compare?revision=1&with_revision=2&machine=lathe"))[0] == "differs", "with a machine")
    siemens = add(client, "G1 X10 F100\nM30\n", "P.MPF", "sinumerik-840d")
    client.refuse(422, "GET", f"/programs/{siemens}/compare?with={program}&machine=lathe", words=["sinumerik-840d"])
    client.refuse(404, "GET", f"/programs/{program}/compare?with={program}&machine=nobody")
    control.close()


def refusals(client, program):
    client.refuse(422, "GET", f"/programs/{program}/compare", words=["with"])
    client.refuse(404, "GET", f"/programs/{program}/compare?with=999999")
    client.refuse(404, "GET", f"/programs/{program}/compare?with_revision=99")
    client.refuse(422, "GET", f"/programs/{program}/compare?with_revision=x")
    client.refuse(400, "GET", f"/programs/{program}/compare?with={program}&what=1")


def by_command(folder):
    one, other, moved = folder / "one.nc", folder / "other.nc", folder / "moved.nc"
    one.write_text(PLAIN), other.write_text(WRITTEN_OTHERWISE), moved.write_text(MOVED)

    def run(*arguments):
        done = subprocess.run([str(binary()), "compare", *map(str, arguments), "--dialect", "fanuc"], capture_output=True, text=True, timeout=60)
        expect(done.returncode == 0, done.stderr)
        return done.stdout

    expect(answers(json.loads(run(one, other, "--json"))) == ["differs", "equal", "equal"], "the command finds something else")
    said = run(one, moved)
    for word in ("meaning: differs\n  -     6  N30 X20.\n  +     6  N30 X20.25\n", "motions: differ after 2 moves", "line 6, line X20.25 F100", "largest deviation 0.2500 mm"):
        expect(word in said, f"\"{word}\" is not in {said}")
    missing = subprocess.run([str(binary()), "compare", str(one), str(folder / "none.nc")], capture_output=True, text=True, timeout=60)
    expect(missing.returncode == 2 and "none.nc" in missing.stderr, missing.stderr)


def all_of_it(folder):
    by_command(folder)
    client = Client(folder).start()
    program = revisions_of_one(client)
    a_text_that_is_not_stored(client, program)
    programs_of_two(client, program)
    a_machine_decides(client, program)
    refusals(client, program)
    expect(client.server.alive(), "the server is gone")
    client.server.stop()


if __name__ == "__main__":
    in_folder(all_of_it)
    sys.exit(0)
