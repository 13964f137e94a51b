"""What a control sends back of a rendered program, as values of the part: in all four dialects, as macro and as blocks. The values that come out are
rendered here again, and must give what came."""

import re

from client import ROLL, Client, HandControl, expect, hand_profile, in_folder, shop

MACHINES = {"fanuc": "fanuc-0i-lathe", "mazak": "mazak-qtn", "sinumerik": "sinumerik-840d-lathe"}


def shop_with_a_roll(folder, preset="fanuc-0i-lathe"):
    client = Client(folder).start()
    control = HandControl()
    profile = shop.preset(preset, url=control.url) if preset != "fanuc-0i-lathe" else hand_profile(control)
    profile["name"] = "lathe"
    if preset != "fanuc-0i-lathe":
        profile["link"] |= {key: value for key, value in hand_profile(control)["link"].items() if key != "url"}
    client.post("/machines", profile)
    client.post("/families", {"text": ROLL})
    client.post("/parts", {"number": "R-1", "family": "hyperbolic-roll", "values": {"roll_length": "196 mm", "angle_step": "2 deg"}})
    client.wait_line("lathe", "idle")
    return client, control


def rendered(client, mode, name):
    program = client.post("/render", {"part": "R-1", "machine": "lathe", "mode": mode, "delivery": "memory", "name": name})["program"]
    return client.call("GET", f"/programs/{program}/text").body.decode()


def send_back(client, control, text):
    before = len(client.get("/receipts")["items"])
    control.say(b"\x12" + text.encode() + b"\x14")
    return shop.wait_for("a receipt", lambda: (lambda rows: rows[0]["id"] if len(rows) > before else None)(client.get("/receipts")["items"]))


def values_of(client, control, text):
    return client.post(f"/receipts/{send_back(client, control, text)}/explain")


def changed(found):
    return {one["name"]: one["after"] for one in found["values"]}


def a_macro_comes_back(folder):
    client, control = shop_with_a_roll(folder)
    text = rendered(client, "macro", "O0100")
    header = re.search(r"#\d+=196\.\(", text).group()
    found = values_of(client, control, text.replace(header, header.replace("196.", "188.5")))
    expect(found["explains_all"] and changed(found) == {"roll_length": "188.5 mm"} and found["values"][0]["before"] == "196 mm", f"{found}")
    expect((found["part"], found["part_revision"], found["family"], found["rest"], found["why_not"]) == ("R-1", 1, "hyperbolic-roll", [], None), f"{found}")
    speed = re.search(r"#\d+=500\.\(", text).group()
    found = values_of(client, control, text.replace(header, header.replace("196.", "190.")).replace(speed, speed.replace("500.", "620.")).replace("(ROLL", "(MY ROLL"))
    expect(found["explains_all"] and changed(found) == {"roll_length": "190 mm", "speed_rpm": "620 rpm"}, f"two values and a comment: {found}")
    found = values_of(client, control, text)
    expect(not found["explains_all"] and found["values"] == [] and "no number differs" in found["why_not"], f"{found}")
    found = values_of(client, control, text.replace(speed, speed.replace("500.", "62000.")))
    expect(not found["explains_all"] and changed(found) == {"speed_rpm": "62000 rpm"} and "refuses" in found["why_not"], f"out of its range: {found}")
    constant = re.search(r"\*\[?2\.", text) or re.search(r"2\.\*#", text)
    found = values_of(client, control, text.replace(constant.group(), constant.group().replace("2.", "2.01"), 1).replace(header, header.replace("196.", "190.")))
    expect(not found["explains_all"] and changed(found) == {"roll_length": "190 mm"} and len(found["rest"]) == 1, f"a formula was changed, too: {found}")
    found = values_of(client, control, text.replace("M30", "M00\nM30"))
    expect(not found["explains_all"] and "other words" in found["why_not"], f"a block was added: {found}")
    client.server.stop()
    control.close()


def blocks_come_back(folder):
    client, control = shop_with_a_roll(folder)
    text = rendered(client, "explicit", "O0101")
    found = values_of(client, control, text.replace("S500", "S480"))
    expect(found["explains_all"] and changed(found) == {"speed_rpm": "480 rpm"}, f"{found}")
    point = re.findall(r"\nX\d+\.\d* ?Z-?\d+\.\d*", text)[3]
    found = values_of(client, control, text.replace(point, re.sub(r"X(\d+)", lambda m: f"X{int(m[1]) + 1}", point)))
    expect(not found["explains_all"] and found["rest"] and found["rest"][0]["stored"] in text, f"a single point: {found}")
    client.server.stop()
    control.close()


def a_sinumerik_comes_back(folder):
    client, control = shop_with_a_roll(folder, MACHINES["sinumerik"])
    text = rendered(client, "macro", "ROLL_1_MPF")
    text = "%_N_ROLL_1_MPF\n" + text
    header = re.search(r"R\d+=196(?=[^\d.])", text).group()
    found = values_of(client, control, text.replace(header, header.replace("196", "180.25")))
    expect(found["explains_all"] and changed(found) == {"roll_length": "180.25 mm"}, f"{found}")
    client.server.stop()
    control.close()


def what_is_not_compared(folder):
    client, control = shop_with_a_roll(folder)
    client.post("/programs", {"name": "O0300", "dialect": "fanuc", "text": "%\nO0300\nG0X1.\nM30\n%\n"})
    for text, words in (("%\nO0300\nG0X2.\nM30\n%\n", "was not rendered"), ("%\nO0999\nG0X2.\nM30\n%\n", "no stored program has the name")):
        client.refuse(409, "POST", f"/receipts/{send_back(client, control, text)}/explain", words=[words])
    client.refuse(404, "POST", "/receipts/999/explain")
    client.server.stop()
    control.close()


if __name__ == "__main__":
    for test in (a_macro_comes_back, blocks_come_back, a_sinumerik_comes_back, what_is_not_compared):
        in_folder(test)
