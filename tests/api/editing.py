"""What an editor asks for: the faults of a text that is being written by POST /diagnose, and the words of a dialect. Nothing of it is stored or run."""

from client import ROLL, Client, HandControl, expect, hand_profile, in_folder, plain_program

GOOD = "%\nO0100 (PUMP)\nG21 G17 G90 G94 G54\nT5 M6\nN10 G0 X0. Y0.\nM98 P200\nN20 G1 X10. F100.\nGOTO20\nM30\n%\n"


def diagnose(client, text, **more):
    return client.must("POST", "/diagnose", {"text": text, **more}, role="programmer")


def faults(found):
    return [(one["line"], one["severity"], one["id"]) for one in found["faults"]]


def a_text_and_its_faults(client):
    good = diagnose(client, GOOD, dialect="fanuc")
    expect(good["dialect"] == "fanuc" and good["control"]["inferred"] and not [f for f in faults(good) if f[1] == "error"], good)
    bad = diagnose(client, GOOD.replace("X10. F100.", "X[10. F100."), dialect="fanuc")
    [fault] = [one for one in bad["faults"] if one["severity"] == "error"]
    expect(fault["line"] == 7 and fault["help"] and fault["end_line"] == 7 and fault["end_column_chars"] > fault["column_chars"], fault)
    expect(len(bad["outline"]) >= 1, "a text with a fault has no outline")
    expect(diagnose(client, "", dialect="fanuc")["outline"] == [], "an empty text")
    # What reading alone finds, without a run: there is no finding of a travel.
    expect(diagnose(client, plain_program(3).replace("X100.", "X99000."), dialect="fanuc")["faults"] == [], "a text that is written was run")


def a_fix_mends(client):
    """What is offered takes the fault away, where it is put in place by lines and characters alone."""
    text = GOOD.replace("N20 G1 X10. F100.", "(\u00e4\u00f6\u00fc) n20 G1 X10. F100.")
    found = diagnose(client, text, dialect="fanuc")
    fixes = [one for one in found["faults"] if one["fix"]]
    expect(len(fixes) == 1, found["faults"])
    fix, lines = fixes[0]["fix"], text.split("\n")
    expect(fix["line"] == fix["end_line"], fix)
    line = lines[fix["line"] - 1]
    lines[fix["line"] - 1] = line[: fix["column_chars"] - 1] + fix["text"] + line[fix["end_column_chars"] - 1 :]
    mended = diagnose(client, "\n".join(lines), dialect="fanuc")
    expect(fixes[0]["id"] not in [one["id"] for one in mended["faults"]], (fix, mended["faults"]))


def an_outline(client):
    rows = [(row["sort"], row["line"], row["text"]) for row in diagnose(client, GOOD, dialect="fanuc")["outline"]]
    expect(rows == [("program", 2, "O0100 (PUMP)"), ("tool", 4, "T5 M6"), ("call", 6, "M98 P200"), ("label", 7, "N20 G1 X10. F100."), ("stop", 9, "M30")], rows)
    siemens = diagnose(client, "DEF REAL A\nSTART: G0 X0\nGROOVE\nGOTOB START\nT=\"MILL\" M6\nM30\n", dialect="sinumerik-840d")
    expect([row["sort"] for row in siemens["outline"]] == ["label", "call", "tool", "stop"], siemens["outline"])
    many = diagnose(client, "".join(f"T{i % 90 + 1} M6\n" for i in range(600)) + "M30\n", dialect="fanuc")
    expect(many["outline_is_cut"] and len(many["outline"]) == 500, len(many["outline"]))


def which_language(client):
    expect(diagnose(client, GOOD)["dialect"] == "fanuc", "by its own looks")
    expect(diagnose(client, "DEF REAL A\nIF A>1 GOTOF E1\nE1: M30\n")["dialect"] == "sinumerik-840d", "by its own looks")
    control = HandControl()
    client.post("/machines", hand_profile(control))
    named = diagnose(client, GOOD, machine="lathe")
    expect(not named["control"]["inferred"] and named["control"]["kind"] == "lathe", named["control"])
    body = {"text": GOOD, "dialect": "sinumerik-840d", "machine": "lathe"}
    client.refuse(422, "POST", "/diagnose", body, words=["the machine is"])
    client.refuse(422, "POST", "/diagnose", {"text": GOOD, "dialect": "basic"}, words=["basic"])
    client.refuse(404, "POST", "/diagnose", {"text": GOOD, "machine": "nobody"})
    drip = diagnose(client, GOOD, machine="lathe", delivery="drip")
    expect(any(severity == "error" for _, severity, _ in faults(drip)), "a jump in a drip feed is no fault")
    control.close()


def words(client):
    for dialect, code, word, sort in [("fanuc", "G02", "WHILE", "keyword"), ("haas", "G02", "SQRT", "function"), ("mazak", "G02", "GOTO", "keyword"),
                                      ("mitsubishi-m80", "G02", "SIN", "function"), ("sinumerik-840d", "G500", "CYCLE81", "cycle")]:
        found = client.get(f"/dialects/{dialect}/words")
        by_name = {one["word"]: one for one in found["words"]}
        expect(len(by_name) == len(found["words"]) > 100, f"{dialect} has {len(found['words'])} words, each once")
        expect(by_name[code]["sort"] == "code" and by_name[word]["sort"] == sort, (by_name[code], by_name[word]))
        silent = [one["word"] for one in found["words"] if not one["about"]]
        expect(silent == [], f"{dialect} has nothing to say of {silent}")
    lathe, mill = ({one["word"]: one["about"] for one in client.get(f"/dialects/fanuc/words?kind={kind}")["words"]} for kind in ("lathe", "mill"))
    expect(lathe["G90"] != mill["G90"], "a lathe's G90 is a mill's")
    other = {one["word"]: one["about"] for one in client.get("/dialects/fanuc/words?kind=lathe&g_system=B")["words"]}
    expect(other["G90"] == mill["G90"], "G-code system B is A")
    client.refuse(404, "GET", "/dialects/basic/words")
    client.refuse(422, "GET", "/dialects/fanuc/words?kind=boat", words=["kind"])
    client.refuse(422, "GET", "/dialects/fanuc/words?g_system=D", words=["g_system"])


def a_translation(client):
    """By the text and by a stored program, to a dialect and to a machine; a refusal names its place, and nothing is stored."""
    text = "G21\nT1 M6\nG0 G54 G17 G90 X0 Y0\nS800 M3\nG0 G43 Z5. H1\nG1 Z-2. F100\nX40. F300\nG0 Z100.\nM30\n"
    before = len(client.get("/programs?shelf=all")["items"])
    found = client.must("POST", "/convert", {"text": text, "dialect": "fanuc", "to": "sinumerik-840d"}, role="programmer")
    expect(found["verified"] and "T1" in found["text"] and "G43" not in found["text"] and found["from"] == "fanuc", found)
    lines = found["text"].rstrip("\n").split("\n")
    expect(len(found["origins"]) == len(lines) and found["origins"][[n for n, line in enumerate(lines) if "F300" in line][0]] == 7, found)
    control = HandControl()
    client.post("/machines", hand_profile(control, "other"))
    stored = client.add_program(10)["id"]
    turned = client.must("POST", "/convert", {"program": stored, "to": "haas", "mode": "explicit"}, role="programmer")
    expect(turned["text"] and turned["mode"] == "explicit" and turned["to"] == "haas", turned)
    expect(client.must("POST", "/convert", {"program": stored, "to_machine": "other"}, role="programmer")["to"] == "fanuc", "a machine's dialect")
    refused = client.must("POST", "/convert", {"text": "N10 MSG(\"A\")\nR1=GETT(\"X\",1)\nG1 X=R1 F100\nM30\n", "dialect": "sinumerik-840d", "to": "fanuc"}, role="programmer")
    expect(refused["text"] is None and not refused["verified"] and any(one["severity"] == "error" and one["line"] == 2 for one in refused["diagnostics"]), refused)
    client.refuse(422, "POST", "/convert", {"text": "M30", "program": stored, "to": "fanuc"}, words=["either text or program"])
    client.refuse(422, "POST", "/convert", {"text": "M30"}, words=["to_machine"])
    client.refuse(422, "POST", "/convert", {"text": "M30", "to": "basic"}, words=["basic"])
    client.refuse(422, "POST", "/convert", {"text": "M30", "to": "haas", "to_machine": "other"}, words=["either to"])
    client.refuse(404, "POST", "/convert", {"text": "M30", "to_machine": "nobody"})
    client.refuse(404, "POST", "/convert", {"program": 999, "to": "fanuc"})
    expect(len(client.get("/programs?shelf=all")["items"]) == before + 1, "a translation is stored")
    control.close()


def a_faster_text(client):
    """The same moves in less time, by text and by stored program, with the words of the command; nothing is stored."""
    text = "#101=3.\n#102=0\nG21 G90 G94 G17\nG0 X0\nWHILE[#102 LT 5] DO1\n#103=SIN[#101]*COS[#101]\nG1 X[#103+#102] F100\n#102=#102+1\nEND1\nM30\n"
    before = len(client.get("/programs?shelf=all")["items"])
    order = {"text": text, "dialect": "fanuc", "own": ["#101-#103"]}
    found = client.must("POST", "/optimize", order, role="programmer")
    expect(found["after"]["total_ms"] < found["before"]["total_ms"] and found["not_verified"] is None and found["left_because"] is None, found)
    expect({one["rule"]: one["edits"] for one in found["passes"]} == {one: [two["rule"] for two in found["changes"]].count(one) for one in {two["rule"] for two in found["changes"]}}, found)
    expect(len(found["origins"]) == len(found["text"].rstrip("\n").split("\n")) and found["cost"]["source"] in ("assumed", "paper", "calibrated"), found)
    without = client.must("POST", "/optimize", order | {"without": ["invariants", "loops"]}, role="programmer")
    expect({"invariants", "loops"} & {one["rule"] for one in without["passes"]} == set() and without["text"] != found["text"], without)
    chords = "G21 G90 G94 G17 G40\nT1 M6\nG54\nS900 M3\nG0 X0 Y0 Z5.\nG1 Z-1. F100\nX1. Y1.\nX2. Y2.001\nX3. Y3.\nM30\n"
    merged = client.must("POST", "/optimize", {"text": chords, "dialect": "fanuc", "with": ["lines"], "tolerance_mm": 0.01}, role="programmer")
    expect("X2." not in merged["text"] and 0.0007 < merged["proved_max_mm"] < 0.00071 and [one["rule"] for one in merged["passes"]] == ["lines"], merged)
    after = "O2\nG1 X#100 F100.\nM99\nO3\nG1 Y#100\nM99\n"
    calls = {"text": f"O1\nG21 G90 G94 G17\nG0 X0\n#100=0\nWHILE[#100 LT 5]DO1\nM98 P2\nM98 P3 L2\n#100=#100+1\nEND1\nM30\n{after}", "dialect": "fanuc"}
    blocks = client.must("POST", "/optimize", calls, role="programmer")
    expect("\nM98 P2\n" not in blocks["text"] and blocks["text"].endswith(f"M30\n{after}") and [one["rule"] for one in blocks["changes"]] == ["inline"], blocks)
    expect(blocks["not_inlined"] == [{"line": 7, "program": "O0003", "why": "the call repeats it"}] and blocks["left_because"] is None, blocks)
    expect(client.must("POST", "/optimize", calls | {"without": ["inline"]}, role="programmer")["not_inlined"] == [], "a rule that is off says something")
    client.refuse(422, "POST", "/optimize", {"text": chords, "dialect": "fanuc", "with": ["lines"]}, words=["need a tolerance"])
    client.refuse(422, "POST", "/optimize", {"text": chords, "dialect": "fanuc", "with": ["lines"], "tolerance_mm": 9}, words=["tolerance_mm"])
    stored = client.add_program(10)["id"]
    plain = client.must("POST", "/optimize", {"program": stored}, role="programmer")
    expect(plain["text"] == client.call("GET", f"/programs/{stored}/text").body.decode() and plain["changes"] == [], plain)
    client.refuse(422, "POST", "/optimize", {"text": "M30", "program": stored}, words=["either text or program"])
    client.refuse(422, "POST", "/optimize", order | {"with": ["magic"]}, words=["there is no rule"])
    client.refuse(422, "POST", "/optimize", order | {"free": ["R1-#2"]}, words=["is not a range of variables"])
    client.refuse(422, "POST", "/optimize", order | {"own": "R1"}, words=["list of 64 texts"])
    client.refuse(422, "POST", "/optimize", order | {"dialect": "basic"}, words=["basic"])
    client.refuse(404, "POST", "/optimize", {"text": "M30", "machine": "nobody"})
    client.refuse(404, "POST", "/optimize", {"program": 999})
    expect(len(client.get("/programs?shelf=all")["items"]) == before + 1, "an optimized text is stored")


def a_preview(client):
    """What rendering gives byte for byte, and nothing of it is there afterwards."""
    control = HandControl()
    client.post("/machines", hand_profile(control, "turning"))
    client.post("/families", {"text": ROLL})
    order = {"family": "hyperbolic-roll", "values": {"angle_step": "2 deg"}, "machine": "turning", "mode": "explicit"}
    before = len(client.get("/programs?shelf=all")["items"])
    seen = client.must("POST", "/preview", order, role="programmer")
    expect(len(client.get("/programs?shelf=all")["items"]) == before, "a preview is stored")
    made = client.post("/render", order)
    text = client.call("GET", f"/programs/{made['program']}/text").body.decode()
    expect(seen["text"] == text and {name: seen[name] for name in ("mode", "blocks", "bytes", "variables")} == {name: made[name] for name in ("mode", "blocks", "bytes", "variables")}, seen)
    judged = client.must("POST", "/preview/verdict", order, role="programmer")
    expect(not client.get(f"/checks?program={made['program']}")["items"], "the verdict of a preview is stored")
    checked = client.post("/checks", {"program": made["program"], "machine": "turning"})
    different = [name for name in judged if judged[name] != checked[name]]
    expect(not different and judged["timing"] and judged["accuracy"], (different, judged))
    client.refuse(422, "POST", "/preview/verdict", order | {"values": {"angle_step": "99 deg"}})
    problem = client.refuse(422, "POST", "/preview", order | {"values": {"angle_step": "99 deg"}})
    expect("angle_step" in problem["errors"][0]["text"], problem)
    client.refuse(404, "POST", "/preview", order | {"machine": "nobody"})
    control.close()


def a_dump_is_taken_apart(client):
    dump = "%\nO0001(HOUSING)\nM98P2\nM30\nO0002\nM99\n%\n"
    split = client.must("POST", "/split", {"text": dump}, role="programmer")["programs"]
    expect([(one["name"], one["comment"]) for one in split] == [("O0001", "HOUSING"), ("O0002", None)], split)
    expect([one["text"] for one in split] == ["%\nO0001(HOUSING)\nM98P2\nM30\n%\n", "%\nO0002\nM99\n%\n"], split)
    whole = client.must("POST", "/split", {"text": "M30"}, role="programmer")["programs"]
    expect(whole == [{"name": None, "comment": None, "text": "M30"}], whole)
    client.refuse(422, "POST", "/split", {})


def a_text_laid_out_again(client):
    """The same program with other numbers, blanks or letters; or refused, with the line."""

    def rewrite(text, how, **more):
        return client.must("POST", "/rewrite", {"text": text, "dialect": "fanuc", "how": how, **more}, role="programmer")

    numbered = rewrite(GOOD, "renumber", numbering="all", first=100, step=100)
    expect("GOTO500\n" in numbered["text"] and "\nN500 G1 X10. F100.\n" in numbered["text"] and numbered["references"] == 1, numbered)
    bare = rewrite(numbered["text"], "renumber", numbering="none")
    expect(bare["text"].count("\nN") == 1 and bare["numbers"] == 1, bare)
    lost = rewrite(GOOD.replace("GOTO20", "GOTO30"), "renumber")
    expect(lost["text"] is None and [one["line"] for one in lost["refused"]] == [8], lost)
    close = rewrite(GOOD, "remove_blanks")["text"]
    expect("\nN20G1X10.F100.\n" in close and "O0100(PUMP)" in close, close)
    expect("\nN20 G1 X10. F100.\n" in rewrite(close, "add_blanks")["text"], "blanks come back")
    expect(rewrite(GOOD.lower(), "upper_case")["text"] == GOOD.replace("(PUMP)", "(pump)"), "capitals, but for the comment")
    small = rewrite(GOOD, "lower_case")
    expect(small["text"] is None and small["refused"][0]["line"] > 0, small)
    client.refuse(422, "POST", "/rewrite", {"text": GOOD, "how": "backwards"}, words=["how"])
    client.refuse(422, "POST", "/rewrite", {"text": GOOD, "how": "renumber", "step": 0}, words=["step"])


def what_it_amounts_to(client):
    """Lengths by tool; a time on a machine alone, whose axes decide it."""
    two = "O0100\nG21 G17 G90 G94 G54\nT1 M6\nG0 X0. Y0. Z5.\nG1 Z0. F100.\nX60.\nT2 M6\nG0 X0.\nM30\n"
    found = client.must("POST", "/statistics", {"text": two, "dialect": "fanuc"}, role="programmer")
    expect([(one["tool"], one["first_line"], one["cut_mm"], one["rapid_mm"], one["time_s"]) for one in found["tools"]] == [("T1", 3, 65, 0, None), ("T2", 7, 0, 60, None)], found["tools"])
    expect((found["cut_mm"], found["rapid_mm"], found["lines"], found["bytes"], found["blocks"]) == (65, 60, 9, len(two), 8), found)
    expect(found["time_s"] is None and "machine" in found["why_no_time"], found["why_no_time"])
    expect(found["low_mm"] == [0, 0, 0] and found["high_mm"] == [60, 0, 5], found)
    text = plain_program(40)
    timed = client.must("POST", "/statistics", {"text": text, "machine": "lathe"}, role="programmer")
    expect(timed["why_no_time"] is None and timed["time_s"] > 0 and abs(sum(one["time_s"] for one in timed["tools"]) - timed["time_s"]) < 1e-9, timed)
    program = client.post("/programs", {"name": "O0190", "dialect": "fanuc", "text": text})["id"]
    whole = client.must("POST", "/timing", {"program": program, "machine": "lathe", "delivery": "memory"})
    expect(abs(whole["motion_s"] - timed["time_s"]) < 1e-6 * whole["motion_s"], (whole["motion_s"], timed["time_s"]))


def run(folder):
    client = Client(folder).start()
    a_dump_is_taken_apart(client)
    a_text_and_its_faults(client)
    a_fix_mends(client)
    an_outline(client)
    which_language(client)
    words(client)
    a_translation(client)
    a_faster_text(client)
    a_text_laid_out_again(client)
    what_it_amounts_to(client)
    a_preview(client)
    expect(client.server.alive(), "the server is gone")
    client.server.stop()


if __name__ == "__main__":
    in_folder(run)
