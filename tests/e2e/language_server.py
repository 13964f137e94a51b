"""The language server as an editor meets it: what the protocol asks of every server, and answers that are those of the commands and of the page."""

import json
import random
import subprocess

from language_client import Client, frame
from rig import ROOT, binary, expect, in_folder

URI = "file:///tmp/part.nc"
FAULTY = "%\nO1\nG21 G90\nWHILE[#1LT3]DO1\n#1=#1+1\nM30\n%\n"
LOOPED = "%\nO0001(OUTER)\nG21 G90 G17 G94\nN10 G01 X1. F100.\nIF[#1GT2]GOTO10\nM98 P0002\nM98 P9010\nM30\nO0002(INNER)\nN10 X2.\nGOTO10\nM99\n%\n"


def position(text, part, after=0):
    """Line and character of a part of a text, counted as UTF-16."""
    at = text.index(part) + after
    line = text.count("\n", 0, at)
    begin = text.rfind("\n", 0, at) + 1
    return line, len(text[begin:at].encode("utf-16-le")) // 2


def applied(text, edits):
    """The text with edits of the server, in which characters are ASCII."""
    starts = [0]
    for line in text.splitlines(keepends=True):
        starts.append(starts[-1] + len(line))
    spot = lambda p: min(starts[min(p["line"], len(starts) - 1)] + p["character"], len(text))
    for edit in sorted(edits, key=lambda e: spot(e["range"]["start"]), reverse=True):
        text = text[: spot(edit["range"]["start"])] + edit["newText"] + text[spot(edit["range"]["end"]) :]
    return text


def wrong_messages(_):
    client = Client()
    client.raw(frame(b"this is not JSON"))
    expect(client.refused() == -32700, "no JSON")
    client.raw(frame(b'{"jsonrpc":"2.0","id":1,"method":"a","method":"b"}'))
    expect(client.refused() == -32700, "a member twice")
    client.raw(frame(b"[" * 100_000))
    expect(client.refused() == -32700, "nested too deep")
    for content in ([], 7, {"id": None, "method": "x"}, {"jsonrpc": "2.0"}, {"jsonrpc": "2.0", "method": 5}, {"jsonrpc": "2.0", "id": [], "method": "x"}):
        client.raw(frame(content))
        expect(client.refused() == -32600, f"no request: {content}")
    client.raw(b"Content-Type: text/plain\r\n\r\n{}")
    expect(client.refused() == -32700, "no length")
    client.raw(b"Content-Length: minus one\r\n\r\nGET / HTTP/1.1\r\n\r\n" + b"noise " * 5000 + b"\r\n\r\n" * 3)
    expect(client.request("textDocument/hover")["error"]["code"] == -32002, "before initialize, and after noise")
    client.raw(b"Content-Length: 99999999999\r\n\r\n")
    expect(client.refused() == -32600, "too long")
    expect(client.process.poll() is None, "wrong input ended the server")
    client.process.stdin.close()
    expect(client.process.wait(timeout=60) == 1, "the input ended without exit")


def too_long_is_skipped(_):
    client = Client()
    length = (64 << 20) + 1
    client.raw(b"Content-Length: %d\r\n\r\n" % length)
    expect(client.refused() == -32600, "too long")
    client.raw(b"x" * length)
    client.start()
    expect(client.end() == 0, "exit after shutdown")


def bytes_as_they_come(_):
    """One byte at a time, and several messages in one piece."""
    client = Client("--seconds", "0")
    messages = [{"id": 1, "method": "initialize", "params": {"capabilities": {}}}]
    messages += [{"id": number, "method": "textDocument/teleport"} for number in range(2, 9)]
    data = b"".join(frame({"jsonrpc": "2.0", **message}) for message in messages)
    for i in range(len(data) // 2):
        client.raw(data[i : i + 1])
    client.raw(data[len(data) // 2 :].replace(b"Content-Length", b"content-length"))
    answers = [client.wait(lambda m: "id" in m)["id"] for _ in messages]
    expect(answers == list(range(1, 9)), answers)
    client.end()


def order_of_a_session(_):
    client = Client()
    client.open(URI, FAULTY)  # too early: dropped without an answer
    expect(client.request("shutdown")["error"]["code"] == -32002, "shutdown before initialize")
    client.start()
    expect(client.request("initialize", capabilities={})["error"]["code"] == -32600, "initialize twice")
    expect(client.request("textDocument/teleport")["error"]["code"] == -32601, "a method that is not known")
    client.notify("$/setTrace", value="off")
    client.notify("textDocument/teleport")
    expect(client.request("textDocument/hover", textDocument={"uri": URI}, position={"line": 0, "character": 0})["error"]["code"] == -32602, "not open")
    client.open(URI, FAULTY)
    for wrong in ({}, {"line": -1, "character": 0}, {"line": "0", "character": 0}, {"line": 0, "character": 1e30}):
        code = client.request("textDocument/hover", textDocument={"uri": URI}, position=wrong)["error"]["code"]
        expect(code == -32602, f"{wrong}: {code}")
    expect(client.at("hover", URI, 4000, 4000) is None, "after the end of the text")
    client.result("shutdown")
    expect(client.request("textDocument/hover")["error"]["code"] == -32600, "after shutdown")
    client.notify("exit")
    expect(client.process.wait(timeout=60) == 0, "exit after shutdown")
    client = Client()
    client.start()
    expect(client.end(shutdown=False) == 1, "exit without shutdown")


def checked(path, *options):
    done = subprocess.run([str(binary()), "check", str(path), "--json", *options], capture_output=True, text=True, timeout=60)
    return json.loads(done.stdout)["files"][0]


def same_as_check(folder):
    """What is published is what `dripfeed check` reports, over the triggers of the diagnostics."""
    client = Client()
    client.start()
    names = sorted((ROOT / "tests/golden").glob("*/*/trigger.*"))
    programs = [path for path in names if path.suffix in (".nc", ".mpf", ".spf")][::4]
    expect(len(programs) > 20, f"{len(programs)} programs")
    compared = 0
    for path in programs:
        try:
            text = path.read_bytes().decode("utf-8")
        except UnicodeDecodeError:
            continue
        report = checked(path)
        wanted = {(d["id"], d["line"] - 1, d["severity"]) for d in report["diagnostics"]}
        uri = path.as_uri()
        client.open(uri, text)
        got = client.diagnostics(uri)
        words = {1: "error", 2: "warning", 3: "note"}
        found = {(d["code"], d["range"]["start"]["line"], words[d["severity"]]) for d in got}
        expect(wanted <= found, f"{path}: check has {wanted - found}, the editor {found}")
        for one in got:
            expect(one["source"] == "dripfeed" and one["codeDescription"]["href"].endswith("diagnostics.md#" + one["code"]), one)
        client.notify("textDocument/didClose", textDocument={"uri": uri})
        compared += 1
    expect(compared > 20, f"{compared} compared")
    expect(client.end() == 0, "exit")


def read_then_run(folder):
    """A change is read; the run's own findings come when the text is opened or saved."""
    program = "%\nO1\nG21 G17 G90 G94 G40\nG54\nT1 M6\nS500 M3\nG43 H1 Z50.\n#1=0\nG01 X[1./#1] F100.\nM30\n%\n"
    client = Client("--dialect", "fanuc")
    client.start()
    client.open(URI, program)
    codes = [d["code"] for d in client.diagnostics(URI)]
    expect("division-by-zero" in codes, f"opened: {codes}")
    client.change(URI, 2, {"text": program + "\n"})
    codes = [d["code"] for d in client.diagnostics(URI, 2)]
    expect("division-by-zero" not in codes, f"changed, not run: {codes}")
    client.notify("textDocument/didSave", textDocument={"uri": URI})
    codes = [d["code"] for d in client.diagnostics(URI, 2)]
    expect("division-by-zero" in codes, f"saved: {codes}")
    client.end()
    client = Client("--dialect", "fanuc", "--seconds", "0")
    client.start()
    client.open(URI, program)
    expect("division-by-zero" not in [d["code"] for d in client.diagnostics(URI)], "never run")
    client.end()


def endless_runs_yield(_):
    """A program that runs for long keeps no request waiting."""
    client = Client("--dialect", "fanuc", "--seconds", "600")
    client.start()
    client.open(URI, "%\nO1\nG21 G17 G90 G94\n#1=0\nN1 #1=#1+1\nG01 X[#1/1000000.] F100.\nIF[#1LT900000000]GOTO1\nM30\n%\n")
    client.wait(lambda m: m.get("method") == "textDocument/publishDiagnostics")
    for _ in range(5):
        expect(client.at("hover", URI, 2, 0) is not None, "no hover while it runs")
    client.end()


def positions(_):
    """Characters of two UTF-16 units before a fault, in both units; the range holds what it is about."""
    text = "%\nO1\n(\U0001F600\u00e4) G21 G90 G777\nM30\n%\n"
    line = text.split("\n")[2]
    for units, offered in ((None, "utf-16"), (["utf-16"], "utf-16"), (["utf-32", "utf-8"], "utf-8")):
        client = Client("--dialect", "fanuc")
        expect(client.start(units=units)["positionEncoding"] == offered, f"{units}")
        client.open(URI, text)
        found = [d for d in client.diagnostics(URI) if d["code"] == "unknown-code"]
        expect(len(found) == 1, found)
        encoding = {"utf-16": "utf-16-le", "utf-8": "utf-8"}[offered]
        width = 2 if offered == "utf-16" else 1
        data = line.encode(encoding)
        begin, end = (found[0]["range"][end]["character"] * width for end in ("start", "end"))
        expect(data[begin:end].decode(encoding) == "G777", f"{offered}: {data[begin:end]}")
        before = len(line[: line.index("G90")].encode(encoding)) // width
        hover = client.at("hover", URI, 2, before + 1)
        expect("absolute" in hover["contents"]["value"] and hover["range"]["start"]["character"] == before, hover)
        client.end()


def ends_of_lines(_):
    """LF CR CR is one block for a control and three lines for an editor."""
    client = Client("--dialect", "fanuc")
    client.start()
    client.open(URI, "%\n\r\rO1\n\r\rG21\n\r\rG777\n\r\rM30\n\r\r%\n\r\r")
    found = [d for d in client.diagnostics(URI) if d["code"] == "unknown-code"]
    expect([d["range"]["start"]["line"] for d in found] == [9], found)
    client.end()


def incremental_changes(_):
    """Any sequence of changes ends in the text that the client has."""
    rng = random.Random(4)
    pieces = ["G01", " X1.", "\n", "\r\n", "(\u00e4)", "(\U0001F600)", "N10 ", "GOTO10", "#5041", "M30\n", ""]
    client = Client("--dialect", "fanuc", "--seconds", "0")
    client.start()
    text, version = LOOPED, 1
    client.open(URI, text)
    for _ in range(150):
        begin, end = sorted(rng.sample(range(len(text) + 1), 2)) if rng.random() < 0.5 else [rng.randrange(len(text) + 1)] * 2
        end = min(end, begin + 6)
        if "\r\n" in (text[begin - 1 : begin + 1], text[end - 1 : end + 1]):
            continue  # an editor has no cursor there
        new = rng.choice(pieces)

        def spot(at):
            line = text.count("\n", 0, at)
            start = text.rfind("\n", 0, at) + 1
            return {"line": line, "character": len(text[start:at].encode("utf-16-le")) // 2}

        version += 1
        client.change(URI, version, {"range": {"start": spot(begin), "end": spot(end)}, "text": new})
        text = text[:begin] + new + text[end:]
    other = "file:///tmp/other.nc"
    client.open(other, text)
    for uri in (URI, other):
        client.number = 0
    a = client.diagnostics(URI, version)
    b = client.diagnostics(other)
    plain = lambda ds: sorted((d["code"], json.dumps(d["range"]), d["message"]) for d in ds)
    expect(plain(a) == plain(b) and len(a) > 0, f"{a}\n{b}")
    symbols = [client.result("textDocument/documentSymbol", textDocument={"uri": uri}) for uri in (URI, other)]
    expect(symbols[0] == symbols[1], f"{symbols}")
    client.end()


def hover(_):
    client = Client()
    client.start()
    text = "%\nO1\nG21 G17 G90 G94\nG00 X0. Y0.\nG2X1.Y0.I.5 F[#5041]\nG043.4H1\n(G90)\n#100=1\nGOTO1\nM30\n%\n"
    client.open(URI, text)
    for part, words in (("G2X", "**G02** arc"), ("#5041", "system variable"), ("5041", "**#5041**"), ("GOTO", "**GOTO**"), ("M30", "**M30**")):
        found = client.at("hover", URI, *position(text, part))
        expect(found is not None and words in found["contents"]["value"], f"{part}: {found}")
    for part in ("(G90", "#100", "X1."):
        found = client.at("hover", URI, *position(text, part, 1))
        expect(found is None, f"{part}: {found}")
    client.open("file:///tmp/part.mpf", mpf := "G17 G710 G90 DIAMON\nR1=SIN($P_EP[X])\nCYCLE83(10,0,1,-5)\nGOTOF EXIT\nEXIT: M30\n")
    for part, words in (("DIAMON", "diameter"), ("SIN", "**SIN**"), ("$P_EP", "system variable"), ("CYCLE83", "**CYCLE83**"), ("GOTOF", "**GOTOF**")):
        found = client.at("hover", "file:///tmp/part.mpf", *position(mpf, part, 1))
        expect(found is not None and words in found["contents"]["value"], f"{part}: {found}")
    listed = subprocess.run([str(binary()), "words", "--dialect", "fanuc"], capture_output=True, text=True, timeout=60).stdout
    about = next(line for line in listed.splitlines() if " G02 " in line).split(maxsplit=2)[2]
    found = client.at("hover", URI, *position(text, "G2X"))["contents"]["value"]
    expect(about.strip() in found, f"words has \"{about}\", hover {found}")
    client.open("file:///tmp/faulty.nc", FAULTY)
    found = client.at("hover", "file:///tmp/faulty.nc", *position(FAULTY, "WHILE"))["contents"]["value"]
    expect("`missing-end`" in found and "Close every loop" in found, found)
    client.end()


def symbols(_):
    for trees in (True, False):
        client = Client("--dialect", "fanuc")
        client.start(trees=trees)
        client.open(URI, LOOPED)
        found = client.result("textDocument/documentSymbol", textDocument={"uri": URI})
        if trees:
            expect([s["name"] for s in found] == ["O0001(OUTER)", "O0002(INNER)"], found)
            expect([s["name"] for s in found[0]["children"]] == ["N10 G01 X1. F100.", "M98 P0002", "M98 P9010", "M30"], found[0])
            expect(found[0]["range"]["end"] == {"line": 8, "character": 0}, found[0])
        else:
            expect(len(found) == 7 and all(s["location"]["uri"] == URI for s in found), found)
        client.end()


def definition(folder):
    (folder / "O9010.nc").write_text("%\nO9010\nM99\n%\n")
    (folder / "several.nc").write_text("%\nO7000\nM99\nO7001\nM99\n%\n")
    main = folder / "main.nc"
    text = LOOPED.replace("M98 P9010", "M98 P9010\nG65 P7001")
    client = Client("--dialect", "fanuc")
    client.start()
    client.open(main.as_uri(), text)

    def lines(part, after=0):
        return [(l["uri"], l["range"]["start"]["line"]) for l in client.at("definition", main.as_uri(), *position(text, part, after))]

    expect(lines("GOTO10") == [(main.as_uri(), 3)], lines("GOTO10"))
    expect(lines("GOTO10", 5) == [(main.as_uri(), 3)], "in the number")
    inner = text.rindex("GOTO10") - text.index("GOTO10")
    expect(lines("GOTO10", inner) == [(main.as_uri(), 10)], "the label of its own program")
    expect(lines("M98 P0002") == [(main.as_uri(), 9)], lines("M98 P0002"))
    expect(lines("M98 P9010", 5) == [((folder / "O9010.nc").as_uri(), 1)], lines("M98 P9010", 5))
    expect(lines("G65 P7001", 5) == [((folder / "several.nc").as_uri(), 3)], lines("G65 P7001", 5))
    expect(lines("G21") == [], "a code has none")
    client.end()
    client = Client("--dialect", "sinumerik-840d")
    client.start()
    part = folder / "part.mpf"
    mpf = "G710 G90\nMARK: G0 X1\nGOTOB MARK\nGOTOF MARK\nMARK: SHAFT(1)\nM30\n"
    (folder / "SHAFT.SPF").write_text("PROC SHAFT(REAL A)\nM17\n")
    client.open(part.as_uri(), mpf)
    at = lambda part_, after=0: [(l["uri"], l["range"]["start"]["line"]) for l in client.at("definition", part.as_uri(), *position(mpf, part_, after))]
    expect(at("GOTOB MARK", 6) == [(part.as_uri(), 1)], at("GOTOB MARK", 6))
    expect(at("GOTOF MARK", 6) == [(part.as_uri(), 4)], at("GOTOF MARK", 6))
    expect(at("SHAFT(1)") == [((folder / "SHAFT.SPF").as_uri(), 0)], at("SHAFT(1)"))
    client.end()


def completion(_):
    client = Client("--dialect", "fanuc")
    client.start()
    client.open(URI, "%\nO1\nG01G4\nGOT\n#504\nM30\n%\n")
    found = client.at("completion", URI, 2, 5)
    labels = [c["label"] for c in found]
    expect("G41" in labels and "G43" in labels and "G01" not in labels, labels)
    expect(found[0]["textEdit"]["range"] == {"start": {"line": 2, "character": 3}, "end": {"line": 2, "character": 5}}, found[0])
    expect([c["label"] for c in client.at("completion", URI, 3, 3)] == ["GOTO"], "GOT")
    expect("#5041" in [c["label"] for c in client.at("completion", URI, 4, 4)], "#504")
    expect(len(client.at("completion", URI, 6, 0)) > 100, "all words")
    mpf = "file:///tmp/part.mpf"
    client.notify("workspace/didChangeConfiguration", settings={"dripfeed": {"dialect": "sinumerik-840d"}})
    client.open(mpf, "CYCLE8\nR1=$P_E\n")
    labels = [c["label"] for c in client.at("completion", mpf, 0, 6)]
    expect("CYCLE83" in labels and all(one.startswith("CYCLE8") for one in labels), labels)
    expect("$P_EP" in [c["label"] for c in client.at("completion", mpf, 1, 7)], "$P_E")
    client.end()


def formatting(folder):
    """As `dripfeed renumber` writes it; what it refuses is an error with the line."""
    text = "%\nO1\nN3 G21 G90\nN7 G01 X1. F100.\nIF[#1GT2]GOTO7\nM30\n%\n"
    path = folder / "renumbered.nc"
    path.write_text(text)
    for options, arguments in (({}, []), ({"renumber": {"blocks": "all", "first": 100, "step": 5}}, ["--blocks", "all", "--first", "100", "--step", "5"])):
        wanted = subprocess.run([str(binary()), "renumber", str(path), "--dialect", "fanuc", *arguments], capture_output=True, text=True, timeout=60).stdout
        client = Client("--dialect", "fanuc")
        client.start(options=options)
        client.open(URI, text)
        edits = client.result("textDocument/formatting", textDocument={"uri": URI}, options={"tabSize": 4, "insertSpaces": True})
        expect(applied(text, edits) == wanted != text, f"{edits}\n{wanted}")
        client.change(URI, 2, {"text": text.replace("GOTO7", "GOTO#2")})
        refused = client.request("textDocument/formatting", textDocument={"uri": URI}, options={})
        expect(refused["error"]["code"] == -32803 and "line 5" in refused["error"]["message"], refused)
        client.end()


def code_actions(folder):
    """Each proposed edit alone, and all at once: as `dripfeed check --fix` writes the file."""
    text = "%\nO1\nG21 G90\nG01 X1. F100. \u041c03\nG00 Y\u041e.\n\u041c30\n%\n"
    path = folder / "fixed.nc"
    path.write_text(text)
    subprocess.run([str(binary()), "check", "--fix", str(path), "--dialect", "fanuc"], capture_output=True, timeout=60, check=False)
    wanted = path.read_text()
    client = Client("--dialect", "fanuc")
    client.start()
    client.open(URI, text)
    whole = {"start": {"line": 0, "character": 0}, "end": {"line": 9, "character": 0}}
    actions = client.result("textDocument/codeAction", textDocument={"uri": URI}, range=whole, context={"diagnostics": []})
    quick = [a for a in actions if a["kind"] == "quickfix"]
    expect(len(quick) == 3 and all(a["diagnostics"][0]["code"] == "homoglyph" for a in quick), actions)
    everything = [a for a in actions if a["kind"] == "source.fixAll"]
    fixed = applied(text, everything[0]["edit"]["changes"][URI])
    expect(fixed == wanted != text, f"{fixed}\n{wanted}")
    one_line = {"start": {"line": 5, "character": 0}, "end": {"line": 5, "character": 1}}
    quick = [a for a in client.result("textDocument/codeAction", textDocument={"uri": URI}, range=one_line, context={"diagnostics": []}) if a["kind"] == "quickfix"]
    expect(len(quick) == 1 and applied(text, quick[0]["edit"]["changes"][URI]) == text.replace("\n\u041c30", "\nM30"), quick)
    client.end()


def settings(folder):
    """What outranks what: settings, options, the text itself. A wrong setting is reported and changes nothing."""
    lathe = "%\nO1\nG21 G99\nG90 X20. Z-5. F.2\nM30\n%\n"
    client = Client("--dialect", "fanuc", "--control", "kind=lathe,g_system=A")
    client.start()
    client.open(URI, lathe)
    at = position(lathe, "G90")
    expect("turning cycle" in client.at("hover", URI, *at)["contents"]["value"], "by the options")
    client.notify("workspace/didChangeConfiguration", settings={"dripfeed": {"machine": "fanuc-0i-mill", "control": ""}})
    expect("absolute" in client.at("hover", URI, *at)["contents"]["value"], "by the settings")
    for wrong in ({"dialect": "klingon", "machine": ""}, {"machines": "x"}, {"seconds": -1}, {"renumber": {"blocks": "some"}}, {"path": "x"}):
        client.notify("workspace/didChangeConfiguration", settings={"dripfeed": wrong})
        shown = client.wait(lambda m: m.get("method") == "window/showMessage")["params"]
        expect(shown["type"] == 1, shown)
        expect("absolute" in client.at("hover", URI, *at)["contents"]["value"], f"{wrong} changed something")
    client.end()
    done = subprocess.run([str(binary()), "lsp", "--dialect", "klingon"], capture_output=True, text=True, timeout=60, stdin=subprocess.DEVNULL)
    expect(done.returncode == 2 and "klingon" in done.stderr and done.stdout == "", done)
    family = (ROOT / "deploy/families/hyperbolic-roll.family").read_text()
    client = Client()
    client.start()
    client.open("file:///tmp/roll.family", family)
    expect(client.diagnostics("file:///tmp/roll.family") == [], "a family is read as one")
    client.open("file:///tmp/bad.family", family.replace("work offset 2", "work offset two"))
    expect(len(client.diagnostics("file:///tmp/bad.family")) > 0, "a family's faults")
    client.end()


def called_programs(folder):
    """A fault of a called program stands where it is called, with its own place as a note."""
    (folder / "O0055.nc").write_text("%\nO0055\nWHILE[#1LT3]DO1\nM99\n%\n")
    main = folder / "calls.nc"
    client = Client("--dialect", "fanuc")
    client.start()
    client.open(main.as_uri(), "%\nO1\nG21 G90\nM98 P0055\nM30\n%\n")
    found = [d for d in client.diagnostics(main.as_uri()) if d["code"] == "missing-end"]
    expect(len(found) == 1 and found[0]["range"]["start"]["line"] == 3, found)
    related = found[0]["relatedInformation"][0]["location"]
    expect(related["uri"] == (folder / "O0055.nc").as_uri() and related["range"]["start"]["line"] == 2, found)
    client.end()


if __name__ == "__main__":
    tests = (wrong_messages, too_long_is_skipped, bytes_as_they_come, order_of_a_session, same_as_check, read_then_run, endless_runs_yield, positions,
             ends_of_lines, incremental_changes, hover, symbols, definition, completion, formatting, code_actions, settings, called_programs)
    for test in tests:
        in_folder(test)
