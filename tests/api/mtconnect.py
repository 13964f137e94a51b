"""The MTConnect agent as a collector sees it: probe, current, sample, assets, their faults; and that it says no more than is known. With the schemas of
MTConnect in DRIPFEED_MTCONNECT_SCHEMAS each answer is validated by xmllint, too; they are too large to stand here."""

import os
import pathlib
import subprocess
import sys
import xml.etree.ElementTree as tree

from client import DC1, Client, HandControl, expect, hand_profile, in_folder, shop

SCHEMAS = os.environ.get("DRIPFEED_MTCONNECT_SCHEMAS")
validated = 0


def plain(element):
    """The same without namespaces."""
    for one in element.iter():
        one.tag = one.tag.split("}")[1]
    return element


def ask(client, path, status=200, role="viewer"):
    global validated
    answer = client.call("GET", f"/mtconnect/{path}", role=role)
    expect(answer.status == status and answer.headers["Content-Type"] == "application/xml", f"{path}: {answer}")
    root = tree.fromstring(answer.body)
    kind = root.tag.split("}")[1]
    expect(root.tag.startswith("{urn:mtconnect.org:" + kind + ":2.0}"), root.tag)
    if SCHEMAS:
        done = subprocess.run(["xmllint", "--noout", "--nonet", "--schema", str(pathlib.Path(SCHEMAS) / f"{kind}_2.0.xsd"), "-"], input=answer.body, capture_output=True, timeout=60)
        expect(done.returncode == 0, f"{path}: {done.stderr.decode()[:2000]}\n{answer.body.decode()[:3000]}")
        validated += 1
    return plain(root)


def values(root, machine):
    stream = next(one for one in root.iter("DeviceStream") if one.get("name") == machine)
    return {one.get("dataItemId").rsplit("_", 1)[1]: one for one in stream.iter() if one.get("dataItemId")}


def a_collector(folder):
    control, odd = HandControl(), HandControl()
    client = Client(folder, "--event-source", "https://dnc.shop/a").start()
    client.post("/machines", hand_profile(control))
    client.post("/machines", hand_profile(odd, 'mill "3" <ä> & co'))
    client.wait_line("lathe", "idle")
    probe = ask(client, "probe")
    devices = {one.get("name"): one for one in probe.iter("Device")}
    expect(set(devices) == {"lathe", 'mill "3" <ä> & co'}, f"{devices}")
    expect(devices["lathe"].get("uuid") == "https://dnc.shop/a/lathe" and devices["lathe"].get("id") == "m_lathe", f"{devices['lathe'].attrib}")
    ids = [one.get("id") for one in probe.iter() if one.get("id")]
    expect(len(ids) == len(set(ids)), f"an id stands twice: {ids}")
    items = {one.get("id") for one in probe.iter("DataItem")}
    current = ask(client, "current")
    expect({one.get("dataItemId") for one in current.iter() if one.get("dataItemId")} == items, "probe and current are not of one mind")
    now = values(current, "lathe")
    expect(now["avail"].text == "AVAILABLE" and now["dnc"].text == "idle", f"{now['dnc'].text}")
    for unknown in ("exec", "mode", "prog", "line"):  # a serial control says nothing of these
        expect(now[unknown].text == "UNAVAILABLE", f"{unknown}: {now[unknown].text}")
    expect(now["sys"].tag == "Unavailable" and now["comm"].tag == "Normal", f"{now['sys'].tag} {now['comm'].tag}")
    head = current.find("Header")
    begin = int(head.get("nextSequence"))
    expect(int(head.get("lastSequence")) == begin - 1 == len(items), f"{head.attrib}")
    release = client.release(client.add_program(10)["id"])
    job = client.queue(release["id"])
    client.post(f"/jobs/{job}/arm")
    shop.wait_for("armed", lambda: values(ask(client, "lathe/current"), "lathe")["dnc"].text.startswith("armed"))
    control.say(DC1)
    client.wait_job(job, "done")
    shop.wait_for("idle again", lambda: values(ask(client, "lathe/current"), "lathe")["dnc"].text == "idle")
    sample = ask(client, f"sample?from={begin}")
    states = [one.text for one in sample.iter("Message")]
    expect(any(one.startswith("armed") for one in states) and states[-1] == "idle", f"{states}")
    expect(values(ask(client, "lathe/current"), "lathe")["exec"].text == "UNAVAILABLE", "a feed is no execution")
    numbers = [int(one.get("sequence")) for one in sample.iter() if one.get("sequence")]
    expect(numbers == sorted(numbers) and numbers[0] == begin and sample.find("Header").get("nextSequence") == str(numbers[-1] + 1), f"{numbers}")
    pages(client, len(items))
    control.listener.close()
    control.cut()
    shop.wait_for("the loss", lambda: values(ask(client, "current"), "lathe")["avail"].text == "UNAVAILABLE")
    expect(values(ask(client, "current"), "lathe")["comm"].tag == "Fault", "a link that is gone is no fault")
    files(client, release)
    faults(client)
    client.server.stop()
    odd.close()


def pages(client, items):
    """Walked in small steps, a collector gets each observation once."""
    at, seen = 1, []
    for _ in range(200):
        page = ask(client, f"sample?from={at}&count=7")
        found = [int(one.get("sequence")) for one in page.iter() if one.get("sequence")]
        seen += found
        at = int(page.find("Header").get("nextSequence"))
        if not found:
            break
    expect(sorted(seen) == list(range(1, at)) and len(seen) > items, f"{seen}")


def files(client, release):
    client.waive_operators(release["machine"])
    client.post(f"/releases/{release['id']}/transitions", {"to": "approved", "note": "seen"})
    assets = ask(client, "assets")
    file = assets.find("Assets/File")
    expect(file.get("state") == "PRODUCTION" and file.get("name") == "O0042" and file.find("Signature").text == release["sha256"], f"{file.attrib}")
    text = client.call("GET", file.find("FileLocation").get("href"))
    expect(text.status == 200 and len(text.body) == int(file.get("size")), f"{text}")
    client.post(f"/releases/{release['id']}/transitions", {"to": "obsolete", "note": "old"})
    expect(ask(client, "assets").find("Assets/File") is None, "what may not go to a machine is shown")


def faults(client):
    for path, status, code in [("nobody/current", 404, "NO_DEVICE"), ("nobody/probe", 404, "NO_DEVICE"), ("sample?from=999999", 400, "OUT_OF_RANGE"), ("sample?from=0", 400, "OUT_OF_RANGE"),
                               ("sample?count=0", 400, "OUT_OF_RANGE"), ("sample?count=x", 400, "INVALID_REQUEST"), ("sample?from=-1", 400, "INVALID_REQUEST"),
                               ("sample?interval=1000", 400, "UNSUPPORTED"), ("current?at=1", 400, "UNSUPPORTED"), ("current?path=//Path", 400, "UNSUPPORTED")]:
        error = ask(client, path, status).find("Errors/Error")
        expect(error.get("errorCode") == code and error.text, f"{path}: {error.attrib}")
    client.refuse(401, "GET", "/mtconnect/probe", role=None)
    client.refuse(405, "POST", "/mtconnect/probe")


if __name__ == "__main__":
    in_folder(a_collector)
    print(f"{validated} answers were valid" if SCHEMAS else "without schemas: structure only")
    sys.exit(0)
