"""Wrong input at every door: the command, the REST API, a family, a profile. Each answer states what is wrong and where, nothing is stored, nothing
crashes."""

import json
import subprocess
import sys

from rig import Rig, binary, expect, in_folder, shop

ROLL = (shop.ROOT / "deploy/families/hyperbolic-roll.family").read_text()


def command(*arguments, stdin=""):
    done = subprocess.run([str(binary()), *map(str, arguments)], input=stdin, capture_output=True, text=True, timeout=60)
    return done.returncode, done.stdout, done.stderr


def expect_command(code, words, *arguments, stdin=""):
    returned, _, errors = command(*arguments, stdin=stdin)
    expect(returned == code, f"{arguments}: exit {returned}, expected {code}: {errors}")
    for word in words:
        expect(word in errors, f"{arguments}: \"{word}\" is not in: {errors}")


def at_the_command(folder):
    expect_command(2, ["no-such-file.nc"], "check", folder / "no-such-file.nc")
    expect_command(2, ["folder"], "run", folder)
    expect_command(2, ["klingon"], "check", "-", "--dialect", "klingon", stdin="M30\n")
    expect_command(2, ["--control"], "check", "-", "--dialect", "fanuc", "--control", "kind=boat", stdin="M30\n")
    expect_command(2, ["is not a preset"], "check", "-", "--machine", "no-such-machine", stdin="M30\n")
    expect_command(1, ["PS0124"], "check", "-", "--dialect", "fanuc", stdin="%\nO1\nWHILE[#1LT3]DO1\n#1=#1+1\nM30\n%\n")
    expect_command(2, [], "check")
    expect_command(2, [], "frobnicate")
    expect_command(2, ["blocks=N"], "run", "-", "--dialect", "fanuc", "--limit", "blocks=x", stdin="M30\n")
    expect_command(2, ["--unreleased"], "send", "-", "--link", "pty:/nowhere", stdin="%\nM30\n%\n")
    expect_command(2, ["port"], "send", "-", "--unreleased", "--link", "tcp://host:99999", stdin="%\nM30\n%\n")
    expect_command(1, [":"], "send", "-", "--unreleased", "--link", "pty:/nowhere", stdin="%\nO1\nG00 X1.\n%\n")
    expect_command(2, ["nowhere"], "ledger", "verify", "/nowhere")
    (folder / "dripfeed.db").write_bytes(b"no database at all, but long enough to be taken for one" * 100)
    expect_command(2, ["dripfeed.db"], "ledger", "verify", folder)
    expect_command(2, ["frequency"], "simulate", "--link", "pty:/tmp/x?frequency=3", "--machine", "fanuc-0i-lathe")
    subprogram = "%\nO0010\nG98\nG01 X20. Z-5. F100.\nM99\n%\n"
    to_sinumerik = ("convert", "-", "--from", "fanuc", "--to", "sinumerik-840d", "--control", "kind=lathe")
    expect_command(1, ["surface speed", "caller"], *to_sinumerik, stdin=subprogram)
    expect_command(0, ["not verified", "only its caller can run"], *to_sinumerik, "--modes", "G97 G18 G99", stdin=subprogram)
    no_unit = "%\nO0001\nG18 G99 G97\nG00 X20. Z5.\nM30\n%\n"
    expect_command(1, ["inch or millimetre", "--modes"], *to_sinumerik, stdin=no_unit)
    for modes, unit in [("G20", "G700"), ("G21", "G710")]:
        _, text, errors = command(*to_sinumerik, "--modes", modes, "--json", stdin=no_unit)
        answer = json.loads(text)
        expect(answer["verified"] and answer["not_verified"] is None and unit in answer["text"], f"{answer} {errors}")
    expect_command(2, ["--modes", "X10."], *to_sinumerik, "--modes", "G97 X10.", stdin=subprogram)
    profile = json.loads((shop.ROOT / "deploy/machines/fanuc-0i-mill.json").read_text())
    machine = folder / "listed.json"
    program = "%\nO1\nG21 G17 G90 G94\nG00 X0. Y0. Z5.\nM15\nM55\nM30\n%\n"
    for functions, said in [("10-19, 25", "M55 is not in the machine's list"), ("10-55", ""), ("10-", "machine_functions")]:
        profile["control"]["machine_functions"] = functions
        machine.write_text(json.dumps(profile))
        _, _, errors = command("check", "-", "--machine", machine, stdin=program)
        expect(said in errors and (bool(said) or "list" not in errors), f"{functions}: {errors}")
        expect("M15 is not" not in errors, errors)
    expect(errors.count("/control/machine_functions") == 1, f"one fault is one line: {errors}")
    profile.update(speed=1, weight=2)
    machine.write_text(json.dumps(profile))
    _, _, errors = command("check", "-", "--machine", machine, stdin=program)
    expect(all(f"\n  /{member}" in errors for member in ("speed", "weight")), f"several are listed: {errors}")
    family = folder / "roll.family"
    for wrong, words in [
        (ROLL.replace("length 100 mm ", "length 100 "), ["family", ":"]),
        (ROLL.replace("cos(t)", "cosine(t)"), ["cosine"]),
        (ROLL.replace("half_axis_z*tan(t)", "half_axis_z + tan(t)"), [":"]),
        (ROLL.rstrip().removesuffix("end"), ["no 'end'"]),
    ]:
        expect(wrong != ROLL, "the family is not the one that this test was written for")
        family.write_text(wrong)
        expect_command(1, words, "render", family, "--dialect", "fanuc")
    family.write_text(ROLL)
    expect_command(1, ["roll_length"], "render", family, "--dialect", "fanuc", "--set", "roll_length=200")
    expect_command(1, ["roll_length"], "render", family, "--dialect", "fanuc", "--set", "roll_length=5000 mm")
    expect_command(1, ["roll_lenght"], "render", family, "--dialect", "fanuc", "--set", "roll_lenght=200 mm")


# What no machine is, where in its profile, and the value that the message repeats.
ABSURD = [
    (["axes", 0, "acceleration_mm_s2"], 0, "/axes/0/acceleration_mm_s2", "is 0"),
    (["axes", 0, "acceleration_mm_s2"], -2500, "/axes/0/acceleration_mm_s2", "is -2500"),
    (["axes", 1, "rapid_mm_min"], 1e300, "/axes/1/rapid_mm_min", "is 1"),
    (["axes", 0, "max_mm"], -999, "/axes/0/max_mm", "is -999"),
    (["feed_limit_mm_min"], -1, "/feed_limit_mm_min", "is -1"),
    (["spindle", "max_rpm"], 0, "/spindle/max_rpm", "is 0"),
    (["buffer"], {"bytes": 0, "blocks": 0}, "/buffer/bytes", "above 0"),
    (["timing", "cost"], {"block_ms": -3}, "/timing/cost/block_ms", "is -3"),
    (["link", "baud"], 0, "/link/baud", "is 0"),
    (["link", "url"], "serial:/dev/ttyS0?protocol=xmodem&baud=0", "/link", "baud 0"),
]


def absurd_profiles(profile):
    for path, value, pointer, said in ABSURD:
        wrong = json.loads(json.dumps(profile))
        wrong["name"] = "other"
        place = wrong
        for step in path[:-1]:
            place = place[step]
        place[path[-1]] = value
        yield wrong, [pointer, said]


def machines_at_the_command(folder):
    profile = shop.preset("fanuc-0i-mill", url="serial:/dev/ttyS0")
    machine = folder / "mill.json"
    program = folder / "hole.nc"
    head = "%\nO1\nG21 G17 G90 G94 G54\nT1 M6\nS500 M3\nG0 X0. Y0.\n"
    program.write_text(head + "G43 H1 Z200.\nG1 Z-5. F100.\nG0 Z200.\nM5\nM30\n%\n")
    for wrong, words in absurd_profiles(profile):
        machine.write_text(json.dumps(wrong))
        for verb in ("check", "time"):
            expect_command(2, words, verb, program, "--machine", machine)
    # Tool 1 is 100 mm long, and the work zero lies 300 mm below the top.
    machine.write_text(json.dumps(profile))
    expect_command(0, [], "check", program, "--machine", machine)
    program.write_text(head + "G43 H1 Z200.\nZ200.001\nM5\nM30\n%\n")
    expect_command(1, [":8: error[travel-exceeded]: Z moves to 0.001"], "check", program, "--machine", machine)
    program.write_text(head + "G43 H9 Z200.001\nM5\nM30\n%\n")
    expect_command(0, ["the tool length of offset 9 is not known"], "check", program, "--machine", machine)
    # What is long is run while it is read, and says so.
    moves = "".join(f"G1 X{i % 90}. Y{i % 70}.\n" for i in range(30000))
    program.write_text(head + "G43 H1 Z200.\nG1 Z100. F1000.\n" + moves + "M5\nM30\n%\n")
    code, out, errors = command("time", program, "--machine", machine, "--json")
    expect(code == 0 and json.loads(out)["validated"] is False and "not validated" in errors, f"{code} {out[:300]} {errors}")
    program.write_text(head + "G1 Z100. F1000.\n" + moves[:1000].rsplit("\n", 1)[0] + "\nM5\nM30\n%\n")
    code, out, errors = command("time", program, "--machine", machine, "--json")
    expect(code == 0 and json.loads(out)["validated"] is True and "not validated" not in errors, f"{code} {out[:300]} {errors}")


def refused(status, words, call, *arguments, **more):
    try:
        call(*arguments, **more)
    except shop.Refused as problem:
        document = json.dumps(problem.document, ensure_ascii=False)
        expect(problem.status == status, f"status {problem.status}, expected {status}: {document}")
        for word in words:
            expect(word in document, f"\"{word}\" is not in: {document}")
        return
    raise AssertionError(f"{arguments} was taken")


def at_the_api(folder):
    rig = Rig(folder, f"pty:{folder}/lathe.tty", blocks=5).start()
    server = rig.server
    before = {name: server.get(f"/{name}") for name in ("machines", "families", "parts", "programs", "checks", "releases", "jobs")}

    refused(401, [], server.request, "GET", "/api/v1/machines", headers={"Authorization": "Bearer nonsense"})
    refused(404, [], server.get, "/nothing")
    refused(405, [], server.request, "DELETE", "/api/v1/machines")
    refused(400, ["JSON"], server.request, "POST", "/api/v1/families", b"{not json")
    refused(422, ["/text"], server.post, "/families", {"txt": "family"})
    refused(422, ["line", "column"], server.post, "/families", {"text": ROLL.replace("cos(t)", "cosine(t)")})
    for member, value, word in [("baud", "fast", "/link/baud"), ("framing", "9E9", "/link/framing"), ("url", "ftp://x", "/link/url"), ("unsent", 40, "budget"), ("bawd", 1, "/link/bawd")]:
        profile = json.loads(json.dumps(rig.profile))
        profile["name"] = "other"
        profile["link"][member] = value
        refused(422, [word], server.add_machine, profile)
    for profile, words in absurd_profiles(rig.profile):
        refused(422, words, server.add_machine, profile)
    refused(422, ["/dialect"], server.add_machine, dict(rig.profile, name="other", dialect="klingon"))
    refused(422, ["axes"], server.add_machine, dict(rig.profile, name="other", axes=[]))
    refused(409, [], server.add_machine, rig.profile)
    refused(428, [], server.request, "PUT", "/api/v1/machines/lathe", rig.profile)
    refused(412, [], server.request, "PUT", "/api/v1/machines/lathe", rig.profile, {"If-Match": "\"7\""})
    refused(404, [], server.post, "/parts", {"number": "P1", "family": "no-such", "values": {}})
    refused(404, [], server.post, "/render", {"family": "no-such", "machine": "lathe"})
    refused(422, ["/machine"], server.post, "/render", {"family": "x"})
    refused(404, [], server.post, "/checks", {"program": 99, "machine": "lathe"})
    refused(422, ["/program"], server.post, "/checks", {"program": "one", "machine": "lathe"})
    refused(422, ["/dialect"], server.post, "/programs", {"name": "x", "dialect": "klingon", "text": "M30"})
    refused(404, [], server.post, "/jobs", {"release": 99})
    refused(404, [], server.get, "/jobs/99")
    refused(404, [], server.get, "/jobs/one")
    refused(409, [], server.post, "/machines/lathe/confirm-reset", {"reason": "nothing to confirm"})

    after = {name: server.get(f"/{name}") for name in before}
    expect({k: v["items"] for k, v in after.items() if k != "machines"} == {k: v["items"] for k, v in before.items() if k != "machines"}, "something was stored")
    expect([m["name"] for m in after["machines"]["items"]] == ["lathe"], "a machine was stored")
    expect(server.alive(), "the server is gone")
    server.stop()


if __name__ == "__main__":
    in_folder(at_the_command)
    in_folder(machines_at_the_command)
    in_folder(at_the_api)
    sys.exit(0)
