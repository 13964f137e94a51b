"""The toolpath by GET /programs/{id}/path and POST /path: columns of numbers that fit each other, what is not drawn, and what is not known; of a machine
the times, and how far a family's program cuts from its nominal. The stock along it by GET /programs/{id}/stock and POST /stock."""

import base64
import json
import math
import pathlib
import struct

from client import Client, HandControl, expect, hand_profile, in_folder, shop

MILL = "%\nO0001\nG21 G17 G90 G94 G54\nG0 X0 Y0 Z5.\nG1 Z-1. F100.\nX10.\nG0 Z5.\nM30\n%\n"


def columns(path):
    """[(x, y, z, kind, line, feed)] of a ToolPath."""
    raw = {name: base64.b64decode(text) for name, text in path["columns"].items()}
    count = path["points"]
    points = struct.unpack(f"<{3 * count}f", raw["points_mm"])
    lines = struct.unpack(f"<{count}I", raw["lines"])
    feeds = struct.unpack(f"<{count}f", raw["feeds"])
    kinds = [path["kind_names"][kind] for kind in raw["kinds"]]
    return [(*points[3 * i : 3 * i + 3], kinds[i], lines[i], feeds[i]) for i in range(count)]


def of_a_text(client):
    path = client.must("POST", "/path", {"text": MILL, "dialect": "fanuc"}, role="programmer")
    expect(columns(path) == [(0, 0, 5, "begin", 4, 0), (0, 0, -1, "cut_per_min", 5, 100), (10, 0, -1, "cut_per_min", 6, 100), (10, 0, 5, "rapid", 7, 0)], columns(path))
    expect(path["segments"] == 3 and path["cut_mm"] == 16 and path["rapid_mm"] == 6, path)
    expect(path["low_mm"] == [0, 0, -1] and path["high_mm"] == [10, 0, 5], path)
    expect(path["not_drawn"] == [{"why": "unknown_place", "moves": 1, "first_line": 4}], path["not_drawn"])
    expect(path["ran"] and not path["not_known"] and path["work_offsets"] == [1], path)
    broken = client.must("POST", "/path", {"text": MILL.replace("X10.", "X[10."), "dialect": "fanuc"}, role="programmer")
    expect(broken["points"] == 0 and not broken["ran"] and broken["not_known"] and broken["diagnostics"], broken)
    unknown = client.must("POST", "/path", {"text": MILL.replace("X10.", "IF[#500GT1]GOTO9\nN9X10."), "dialect": "fanuc"}, role="programmer")
    expect("#500" in " ".join(unknown["not_known"]), unknown["not_known"])
    client.refuse(422, "POST", "/path", {"text": MILL, "dialect": "basic"}, words=["basic"])


def of_a_program(client):
    program = client.post("/programs", {"name": "O0001", "dialect": "fanuc", "text": MILL})["id"]
    client.must("POST", f"/programs/{program}/revisions", {"text": MILL.replace("X10.", "X20.")}, headers={"If-Match": '"1"'}, role="programmer")
    expect(client.get(f"/programs/{program}/path")["high_mm"][0] == 20, "the newest")
    expect(client.get(f"/programs/{program}/path?revision=1")["high_mm"][0] == 10, "an older one")
    control = HandControl()
    client.post("/machines", hand_profile(control))
    lathe = client.get(f"/programs/{program}/path?revision=1&machine=lathe")
    expect(lathe["x_is_diameter"] and lathe["high_mm"][0] == 5, "x of a lathe is a radius")
    client.refuse(404, "GET", f"/programs/{program}/path?machine=nobody")
    client.refuse(404, "GET", f"/programs/{program}/path?revision=9")
    client.refuse(404, "GET", "/programs/99999/path")
    control.close()


def pictures(client):
    """Of a milled and a turned program; and what has none."""
    def picture(text, name):
        program = client.post("/programs", {"name": name, "dialect": "fanuc", "text": text})["id"]
        return client.get(f"/programs/{program}/picture")
    milled = picture(MILL.replace("X10.", "X10.\nY10."), "O0101")
    expect(milled["view"] == "isometric" and milled["cut"].startswith("M") and milled["has_all_cuts"], milled)
    turned = picture(MILL, "O0102")
    expect(turned["view"] == "turning" and turned["width"] == 240 and turned["height"] == 180, turned)
    broken = picture(MILL.replace("X10.", "X[10."), "O0103")
    expect(not broken["cut"] and not broken["has_all_cuts"], broken)
    program = client.post("/programs", {"name": "O0104", "dialect": "fanuc", "text": MILL.replace("X10.", "X10.\n" * 300_000)})["id"]
    client.refuse(422, "GET", f"/programs/{program}/picture", words=["at most 1048576 bytes"])
    client.refuse(404, "GET", "/programs/99999/picture")


def floats(path, name):
    raw = base64.b64decode(path["columns"][name])
    return list(struct.unpack(f"<{len(raw) // 4}f", raw))


def stock_of(client, path, body=None):
    """The head and the columns of a stock's bytes."""
    answer = client.call("POST" if body else "GET", path, body)
    expect(answer.status == 200 and answer.headers["Content-Type"] == "application/octet-stream", f"{answer.status} {answer}")
    raw = answer.body
    expect(raw[:4] == b"DFS1", raw[:8])
    (length,) = struct.unpack_from("<I", raw, 4)
    head = json.loads(raw[8 : 8 + length])
    at, columns = 8 + length, {}
    for name, kind, count in head["arrays"]:
        columns[name] = struct.unpack_from(f"<{count}{'f' if kind == 'f32' else 'I'}", raw, at)
        at += 4 * count
    expect(at == len(raw), (at, len(raw)))
    return head, columns


def family_program(client, family, machine):
    """A stored program of a shipped family for a machine of that preset, and the machine's name."""
    profile = shop.preset(machine, url=f"tcp://127.0.0.1:{shop.free_port()}")
    client.post("/machines", profile)
    folder = pathlib.Path(__file__).resolve().parents[2] / "deploy" / "families"
    client.post("/families", {"text": (folder / f"{family}.family").read_text()})
    client.post("/parts", {"number": f"P-{family}", "family": family, "values": {}})
    return client.post("/render", {"part": f"P-{family}", "machine": profile["name"], "delivery": "drip"})["program"], profile["name"]


def of_a_machine(client):
    """A roll on a lathe: times, speeds, buffer, deviations and stock."""
    program, machine = family_program(client, "hyperbolic-roll", "fanuc-0i-lathe")
    address = f"/programs/{program}/path?machine={machine}"
    path = client.get(address)
    times, speeds, deviations = floats(path, "times_s"), floats(path, "speeds"), floats(path, "deviations_mm")
    expect(len(times) == len(speeds) == len(deviations) == path["points"], (len(times), len(speeds), path["points"]))
    expect(path["time"] and path["why_no_time"] is None and times == sorted(times) and times[-1] <= path["time"]["cycle_s"] * 1.0001, times[-5:])
    expect(path["time"]["is_fed"] is False and path["columns"]["buffer"] == "", path["time"])
    forecast = client.must("POST", "/timing", {"program": program, "machine": machine, "delivery": "memory"}, role="programmer")
    expect(math.isclose(path["time"]["cycle_s"], forecast["cycle_s"], rel_tol=1e-9), (path["time"], forecast["cycle_s"]))
    known = [one for one in deviations if not math.isnan(one)]
    accuracy = client.must("POST", "/accuracy", {"program": program, "machine": machine}, role="programmer")
    expect(math.isclose(max(abs(one) for one in known), abs(accuracy["max_mm"]), rel_tol=1e-3), (max(known), accuracy["max_mm"]))
    fed = client.get(f"{address}&delivery=drip")
    expect(fed["time"]["is_fed"] and len(base64.b64decode(fed["columns"]["buffer"])) == 4 * fed["points"], fed["time"])
    tool = path["tools"][path["tool_changes"][-1]["tool"]]
    expect(tool["shape"]["nose_radius_mm"] == 0.8 and tool["shape"]["tip"] == 3, tool)
    client.refuse(422, "GET", f"{address}&delivery=post", words=["delivery"])
    head, stock = stock_of(client, f"/programs/{program}/stock?machine={machine}")
    expect(head["kind"] == "bar" and head["ran"] and len(stock["start"]) == head["columns"] == len(stock["nominal"]), head)
    expect(list(stock["moments"]) == sorted(stock["moments"]) and stock["moments"][-1] <= path["points"], "in the order of the path")
    left = list(stock["start"])
    for place, height in zip(stock["places"], stock["heights"]):
        left[place] = height
    over = [left[i] - stock["nominal"][i] for i in range(len(left)) if not math.isnan(stock["nominal"][i])]
    expect(min(over) > -0.02 and max(over) < 0.05, f"the roll is its nominal: {min(over)} to {max(over)}")


def of_a_pocket(client):
    program, machine = family_program(client, "round-pocket", "fanuc-0i-mill")
    head, stock = stock_of(client, f"/programs/{program}/stock?machine={machine}")
    expect(head["kind"] == "map" and head["columns"] * head["rows"] == len(stock["start"]) <= 65536, head)
    left = list(stock["start"])
    for place, height in zip(stock["places"], stock["heights"]):
        left[place] = height
    expect(min(left) == -12 and max(left) == 0, (min(left), max(left)))
    below = [i for i in range(len(left)) if left[i] < stock["nominal"][i] - stock["tolerances"][i]]
    expect(len(below) < len(left) / 100, f"{len(below)} places below the nominal: but for the wall's cells there are none")


def stated_blank(client):
    order = {"text": MILL, "dialect": "fanuc"}
    client.refuse(422, "POST", "/stock", order, words=["no stock is known"])
    head, stock = stock_of(client, "/stock", {**order, "stock": "box 0 10 0 10 -5 0"})
    expect(not stock["places"] and any("without a known tool" in one for one in head["notes"]), head["notes"])
    client.refuse(422, "POST", "/stock", {**order, "stock": "box"}, words=["stock must be"])
    lathe = client.get("/programs?name=O0001")["items"][0]["id"]
    client.refuse(422, "GET", f"/programs/{lathe}/stock?machine=lathe&stock=box+0+1+0+1+0+1", words=["cylinder"])


def run(folder):
    client = Client(folder).start()
    of_a_text(client)
    of_a_program(client)
    pictures(client)
    of_a_machine(client)
    of_a_pocket(client)
    stated_blank(client)
    client.server.stop()


if __name__ == "__main__":
    in_folder(run)
