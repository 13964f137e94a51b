"""Orders: the same order twice is one, plans change by their revision, jobs belong to an order and wait while it is held, and parts are counted as they
are reported."""

import sys

from client import DC1, ROLL, Client, HandControl, expect, hand_profile, in_folder

ORDER = {"number": "A-4711", "operation": "20", "part": "R-1", "quantity": 5, "machine": "lathe", "due_at_ms": 1_800_000_000_000, "priority": 3, "metadata": {"customer": "ACME", "n": 1.5}}


def plans(client):
    made = client.must("POST", "/orders", ORDER, role="operator")
    expect({key: made[key] for key in ORDER} == ORDER and made["state"] == "open" and made["open"] == 5, f"{made}")
    expect(client.must("POST", "/orders", ORDER)["id"] == made["id"] and len(client.get("/orders")["items"]) == 1, "the same order twice is two")
    turned = ORDER | {"metadata": dict(reversed(ORDER["metadata"].items()))}
    expect(client.must("POST", "/orders", turned)["id"] == made["id"], "the same metadata in another order is another plan")
    client.refuse(409, "POST", "/orders", ORDER | {"metadata": {"customer": "ACME", "n": 2}}, words=["another plan"])
    client.refuse(409, "POST", "/orders", ORDER | {"quantity": 6}, words=["another plan"])
    other = client.must("POST", "/orders", ORDER | {"operation": "30"})["id"]
    client.refuse(422, "POST", "/orders", ORDER | {"number": "B", "machine": "nobody"}, words=["there is no machine nobody"])
    client.refuse(422, "PUT", f"/orders/{other}", {"part": "R-1", "quantity": 1, "machine": "nobody"}, headers={"If-Match": '"1"'}, words=["there is no machine nobody"])
    client.refuse(422, "POST", f"/orders/{other}/move", {"to": "held", "reason": " "}, words=["blank"])
    client.refuse(404, "GET", "/orders/99")
    plan = {key: value for key, value in ORDER.items() if key not in ("number", "operation")}
    client.refuse(428, "PUT", f"/orders/{other}", plan)
    changed = client.must("PUT", f"/orders/{other}", plan | {"quantity": 7, "machine": None, "due_at_ms": None}, headers={"If-Match": '"1"'})
    expect(changed["quantity"] == 7 and changed["machine"] is None and changed["due_at_ms"] is None and changed["revision"] == 2, f"{changed}")
    client.refuse(412, "PUT", f"/orders/{other}", plan, headers={"If-Match": '"1"'})
    client.post(f"/orders/{other}/move", {"to": "cancelled", "reason": "not wanted"})
    client.refuse(409, "PUT", f"/orders/{other}", plan, headers={"If-Match": '"2"'}, words=["cancelled"])
    client.refuse(409, "POST", f"/orders/{other}/move", {"to": "open"})
    client.refuse(409, "POST", f"/orders/{other}/parts", {"good": 1})
    listed = lambda query: [one["id"] for one in client.get(f"/orders?{query}")["items"]]
    expect(listed("state=open") == [made["id"]] and listed("number=A-4711") == [other, made["id"]] and listed("machine=lathe&part=R-1") == [made["id"]], "the filters")
    client.refuse(422, "GET", "/orders?state=lost")
    return made["id"]


def jobs_of_an_order(client, control, order):
    release = client.release(client.add_program()["id"])["id"]
    client.refuse(422, "POST", "/jobs", {"release": release, "order": 99})
    job = client.must("POST", "/jobs", {"release": release, "order": order})["id"]
    expect(client.job(job)["order"] == order and client.get(f"/orders/{order}")["waiting"] == 1, "the job does not know its order")
    expect([one["id"] for one in client.get(f"/jobs?order={order}")["items"]] == [job], "the jobs of the order")
    client.post(f"/orders/{order}/move", {"to": "held", "reason": "no material"})
    client.refuse(409, "POST", "/jobs", {"release": release, "order": order}, words=["held"])
    client.refuse(409, "POST", f"/jobs/{job}/arm", words=["held"])
    expect(client.job(job)["state"] == "queued", "a held order armed its job")
    client.post(f"/orders/{order}/move", {"to": "open"})
    expect(client.job(job)["state"] == "queued", "an order that is open again armed its job")
    client.wait_line("lathe", "idle")
    client.post(f"/jobs/{job}/arm")
    client.refuse(409, "POST", f"/orders/{order}/move", {"to": "done"}, words=["line"])
    client.refuse(409, "POST", f"/orders/{order}/move", {"to": "held", "reason": "measure first"}, words=[f"job {job} is armed on lathe"])
    control.say(DC1)
    client.wait_job(job, "feeding")
    client.post(f"/orders/{order}/move", {"to": "held", "reason": "measure first"})
    client.wait_job(job, "done")
    expect(client.get(f"/orders/{order}")["transfers"] == 1, "what is held does not stop a feed, and it is counted")
    client.post(f"/orders/{order}/move", {"to": "open"})


def urgent_orders_come_first(client):
    """Each job is queued after those as urgent as its order, wherever a person put them; a person moves it as any other."""
    release = client.release(client.add_program(7, "O0007")["id"])["id"]
    order = lambda number, priority: client.must("POST", "/orders", {"number": number, "part": "R-1", "quantity": 1, "priority": priority})["id"]
    calm, urgent, most = order("calm", 0), order("urgent", 5), order("most", 9)
    queue = lambda: [job["id"] for job in sorted(client.get("/jobs?machine=lathe&state=queued")["items"], key=lambda job: job["rank"])]
    add = lambda **of: client.must("POST", "/jobs", {"release": release} | of)["id"]
    plain = add()
    of_calm, of_urgent, of_most = add(order=calm), add(order=urgent), add(order=most)
    again = add(order=urgent)
    expect(queue() == [of_most, of_urgent, again, plain, of_calm], f"{queue()}: not {[of_most, of_urgent, again, plain, of_calm]}")
    client.post(f"/jobs/{plain}/move", {"before": of_most})
    third = add(order=urgent)
    expect(queue() == [plain, of_most, of_urgent, again, third, of_calm], f"{queue()}: what a person put first stays there")
    for job in queue():
        client.post(f"/jobs/{job}/cancel", {})


def another_part_is_refused(client):
    client.post("/families", {"text": ROLL})
    client.post("/parts", {"number": "R-100", "family": "hyperbolic-roll", "values": {}})
    program = client.post("/render", {"part": "R-100", "machine": "lathe", "mode": "explicit"})["program"]
    client.check(program)
    release = client.release(program)["id"]
    order = lambda part: client.must("POST", "/orders", {"number": "of parts", "operation": part, "part": part, "quantity": 1})["id"]
    other, same = order("R-200"), order("R-100")
    client.refuse(409, "POST", "/jobs", {"release": release, "order": other}, words=["rendered from part R-100", "of part R-200"])
    job = client.must("POST", "/jobs", {"release": release, "order": same})["id"]
    client.must("PUT", f"/orders/{same}", {"part": "R-300", "quantity": 1}, headers={"If-Match": '"1"'})
    client.wait_line("lathe", "idle")
    client.refuse(409, "POST", f"/jobs/{job}/arm", words=["rendered from part R-100", "of part R-300"])
    client.post(f"/jobs/{job}/cancel", {})


def parts(client, order):
    client.refuse(422, "POST", f"/orders/{order}/parts", {})
    client.post(f"/orders/{order}/parts", {"good": 2, "scrap": 1, "note": "first shift"})
    now = client.post(f"/orders/{order}/parts", {"good": 4})
    expect((now["good"], now["scrap"], now["open"]) == (6, 1, 0), f"{now}")
    expect(client.post(f"/orders/{order}/move", {"to": "done"})["state"] == "done", "it is not closed")
    expect(client.post(f"/orders/{order}/parts", {"good": 1})["good"] == 7, "a late report is lost")
    rows = [row["action"] for row in client.get(f"/audit?subject=order/{order}")["items"]]
    expect(rows.count("order.parts") == 3 and rows[-1] == "order.add", f"{rows}")


def life_of_an_order(folder):
    control = HandControl()
    client = Client(folder).start()
    client.post("/machines", hand_profile(control))
    order = plans(client)
    jobs_of_an_order(client, control, order)
    parts(client, order)
    urgent_orders_come_first(client)
    another_part_is_refused(client)
    client.server.stop()
    control.close()


if __name__ == "__main__":
    in_folder(life_of_an_order)
    sys.exit(0)
