"""The toolpath by GET /programs/{id}/path and POST /path: columns of numbers that fit each other, what is not drawn, and what is not known."""

import base64
import struct

from client import Client, HandControl, expect, hand_profile, in_folder

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


def run(folder):
    client = Client(folder).start()
    of_a_text(client)
    of_a_program(client)
    client.server.stop()


if __name__ == "__main__":
    in_folder(run)
