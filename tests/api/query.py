"""Query parameters that take words: openapi.json names the words, the server takes each of them and refuses another one. And numbers of answers:
each is written in the shortest form that reads back the same."""

import re
import sys

from client import Client, HandControl, contract, expect, hand_profile, in_folder

NUMBER = re.compile(r'(?<![\w."])-?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?(?![\w."])')


def described():
    """(method, path, name, words) of each parameter with words."""
    for method, path, _, operation in contract.routes():
        for parameter in operation["parameters"]:
            words = parameter["schema"].get("enum")
            if parameter["in"] == "query" and words:
                yield method, path, parameter["name"], words


def words_are_taken(folder):
    client = Client(folder).start()
    control = HandControl()
    client.post("/machines", hand_profile(control))
    ids = {"/api/v1/webhooks/{id}/deliveries": client.post("/webhooks", {"url": "http://127.0.0.1:9/in", "types": ["*"], "local": True})["id"]}
    client.add_program()
    names = {"{name}": "fanuc", "{id}": "1"}
    rows = list(described())
    expect(len(rows) >= 12, f"parameters with words: {[row[:3] for row in rows]}")
    tried = 0
    for method, path, name, words in rows:
        if method != "GET" or path == "/api/v1/receipts/{id}/text" or path.endswith("/stock"):  # figures and stock need a family's program, a receipt its punch
            continue
        tried += 1
        url = path
        for place, value in names.items():
            url = url.replace(place, str(ids.get(path, value)))
        more = {"/api/v1/search": "&q=x", "/api/v1/dialects/{name}/words": "&g_system=A" if name == "kind" else "&kind=mill"}.get(path, "")
        for word in words:
            answer = client.call("GET", f"{url}?{name}={word}{more}")
            expect(answer.status == 200, f"{path}?{name}={word}: {answer}")
        client.refuse(422, "GET", f"{url}?{name}=nonsense{more}")
    expect(tried >= 8, f"{tried} were tried")
    client.server.stop()


def shortest(text):
    """The numbers in a JSON text that are longer than they have to be."""
    bare = re.sub(r'"(?:[^"\\]|\\.)*"', '""', text)  # what stands in strings is not a number
    return [one for one in NUMBER.findall(bare) if "." in one and len(one.rstrip("0")) > len(repr(float(one)))]


def numbers_are_short(folder):
    expect(shortest('{"a":0.10000000000000001,"b":[1.5],"c":"0.30000000000000004"}') == ["0.10000000000000001"], "the test can fail")
    client = Client(folder).start()
    control = HandControl()
    control.is_bridged = True
    client.post("/machines", hand_profile(control))
    client.wait_line("lathe", "idle")
    tested = client.call("POST", "/machines/lathe/line-test")
    control.is_bridged = False
    job = client.queue(client.release(client.add_program(60)["id"])["id"])
    for path in ("/machines", "/machines/lathe", "/machines/lathe/utilisation", f"/jobs/{job}", f"/jobs/{job}/forecast", "/checks/1"):
        found = shortest(client.call("GET", path).body.decode())
        expect(not found, f"{path}: {found}")
    expect(not shortest(tested.body.decode()), f"the line test: {shortest(tested.body.decode())}")
    # What is a decimal fraction in the server's own units is one in the answer, too.
    long = [one for one in NUMBER.findall(re.sub(r'"[^"]*"', "", tested.body.decode())) if len(one) > 12]
    expect(not long, f"nanoseconds as milliseconds have six places: {long}")
    client.server.stop()


if __name__ == "__main__":
    for test in (words_are_taken, numbers_are_short):
        in_folder(test)
    sys.exit(0)
