"""Holds what goes over the wire against openapi.json, as `dripfeed openapi` prints it: each answer and each request that was taken, whole. A member
that the document does not name is a fault here, though a client has to bear it. What was compared with it is counted."""

import atexit
import functools
import json
import re
import subprocess
import sys

from jsonschema import Draft202012Validator

from openapi_shape import closed
from rig import binary

validated = {}  # (method, path of the route, status): how often; ("event", its name): how often


OF_NO_ROUTE = {405, 431}  # another method; a header that is too long for any route
# Of the message and not of what it carries (RFC 9110 and 9112), and two that all have.
OF_MESSAGES = {"cache-control", "connection", "content-encoding", "content-length", "content-type", "date", "keep-alive", "server", "transfer-encoding", "x-content-type-options"}


class Drift(AssertionError):
    """The server and its description are not of one mind."""


@functools.cache
def document():
    return json.loads(subprocess.run([str(binary()), "openapi"], capture_output=True, check=True, timeout=30).stdout)


@functools.cache
def validator(reference):
    return Draft202012Validator({"$ref": reference, "components": closed(document()["components"])})


def faults(reference, value):
    """Sentences; none where the value is what the schema says."""
    return [f"{'/'.join(str(step) for step in error.absolute_path) or 'the whole'}: {error.message[:300]}"
            for error in validator(reference).iter_errors(value)]


@functools.cache
def routes():
    """[(method, path of the route, pattern, operation)]"""
    found = []
    for path, item in document()["paths"].items():
        pattern = re.compile(re.sub(r"\\\{\w+\\\}", "[^/]+", re.escape(path)))
        found += [(method.upper(), path, pattern, operation) for method, operation in item.items()]
    return found


def route_of(method, path):
    """(path of the route, operation); None where there is none."""
    plain, wanted = path.split("?")[0], "GET" if method == "HEAD" else method
    for of, route, pattern, operation in routes():
        if of == wanted and pattern.fullmatch(plain):
            return route, operation
    return None


def check(method, path, body, answer):
    """One request with its answer. `body` is what was sent: bytes, or None."""
    what = f"{method} {path} {answer.status}"
    kind = (answer.headers.get("Content-Type") or "").split(";")[0]
    route = route_of(method, path)
    if answer.status >= 400:
        if kind == "application/problem+json" and answer.body:
            require(faults("#/components/schemas/Problem", answer.document) or faults_of_code(answer), what)
            require(faults_of_headers(document()["components"]["responses"].get(f"Problem{answer.status}", {}), answer), what)
        if route and str(answer.status) not in route[1]["responses"] and answer.status not in OF_NO_ROUTE:
            raise Drift(f"{what}: the route is described with {', '.join(route[1]['responses'])}")
        return
    if answer.status == 304:  # what the client has already, RFC 9110, 15.4.5
        require([] if not answer.body and answer.headers.get("ETag") else ["a body, or no tag"], what)
        return
    if route is None and kind == "text/html" and not path.startswith("/api/"):
        return  # the page, for a browser that came by one of its addresses
    if route is None:
        raise Drift(f"{what}: openapi.json has no such route")
    pattern, operation = route
    response = operation["responses"].get(str(answer.status))
    if response is None:
        raise Drift(f"{what}: openapi.json says {', '.join(operation['responses'])}")
    require(faults_of_headers(response, answer) + undescribed_headers(response, answer), what)
    check_content(response.get("content", {}), kind, answer, what, is_head=method == "HEAD")
    check_taken(operation.get("requestBody"), body, what)
    count((method, pattern, answer.status))


def faults_of_headers(response, answer):
    """Those that are described are there, and as described."""
    found = []
    for name, header in response.get("headers", {}).items():
        value = answer.headers.get(name)
        if value is None:
            found.append(f"no {name}")
            continue
        wanted = header["schema"]
        typed = int(value) if wanted["type"] == "integer" and value.isdigit() else value
        found += [f"{name}: {error.message[:200]}" for error in Draft202012Validator(wanted).iter_errors(typed)]
    return found


def undescribed_headers(response, answer):
    described = OF_MESSAGES | {name.lower() for name in response.get("headers", {})}
    return [f"{name}: {value[:80]} is not described" for name, value in answer.headers.items() if name.lower() not in described]


def faults_of_code(answer):
    """A code stands for one status, and the answer states when to ask again where that may help."""
    code = answer.document["code"]
    about = document()["components"]["schemas"]["Problem"]["properties"]["code"]["x-enumDescriptions"][code]
    found = [] if about.startswith(f"{answer.status}: ") else [f"the code {code} is of {about}"]
    wait = answer.headers.get("Retry-After")
    if answer.status in (429, 503) and not (wait and wait.isdigit() and int(wait) > 0):
        found.append(f"Retry-After is {wait}")
    return found


def check_content(content, kind, answer, what, is_head):
    if not content and not answer.body and not kind:
        return
    if "*/*" in content:
        return
    if kind not in content:
        raise Drift(f"{what}: came as {kind or 'nothing'}, openapi.json says {', '.join(content) or 'nothing'}")
    reference = content[kind]["schema"].get("$ref")
    if reference and not is_head:
        require(faults(reference, answer.document), what)


def check_taken(described, body, what):
    """A body that the server took is one that the document describes."""
    if described is None:
        if body and json.loads(body) != {}:
            raise Drift(f"{what}: openapi.json has no body, and {body[:200]} was taken")
        return
    if not body:
        if described["required"]:
            raise Drift(f"{what}: was taken without its body")
        return
    if "*/*" in described["content"]:  # a file
        return
    require(faults(described["content"]["application/json"]["schema"]["$ref"], json.loads(body)), f"{what}, the request")


def check_event(name, data):
    require(faults(f"#/components/schemas/Event{name.capitalize()}", data), f"the event {name}")
    count(("event", name))


def require(found, what):
    if found:
        raise Drift(f"{what}: " + "; ".join(found[:5]))


def count(key):
    validated[key] = validated.get(key, 0) + 1


def never_validated():
    """Routes and their statuses of success that openapi.json has and no answer was compared with."""
    described = {(method, path, int(status)) for method, path, _, operation in routes() for status in operation["responses"] if status.startswith("2")}
    return sorted(described - validated.keys())


def events_never_validated():
    described = {name.removeprefix("Event").lower() for name in document()["components"]["schemas"] if name.startswith("Event")}
    return sorted(described - {key[1] for key in validated if key[0] == "event"})


def the_check_can_fail():
    """Answers that are wrong in one place are refused, each by that place."""
    job = document()["components"]["schemas"]["Job"]
    reference = "#/components/schemas/Health"
    for wrong, word in (({"status": "ok"}, "version"), ({"status": "well", "version": "1"}, "well"), ({"status": "ok", "version": 1}, "version"),
                        ({"status": "ok", "version": "1", "more": 1}, "more")):
        found = faults(reference, wrong)
        if not found or word not in " ".join(found):
            raise AssertionError(f"{wrong} is refused by {found}")
    if "additionalProperties" in job or faults(reference, {"status": "ok", "version": "1"}):
        raise AssertionError("answers are closed in the document, or a good one is refused")


@atexit.register
def report():
    pairs = [key for key in validated if key[0] != "event"]
    if pairs:
        print(f"contract: {sum(validated.values())} answers and events of {len(pairs)} routes with their status, "
              f"{len(validated) - len(pairs)} kinds of events", file=sys.stderr)
