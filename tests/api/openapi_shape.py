"""What is wrong with an OpenAPI 3.1 document, in sentences: its shape, and where it names other routes than a table does."""

import re

from jsonschema import Draft202012Validator

METHODS = {"get", "post", "put", "delete", "patch"}


def shape_faults(document):
    found = []
    if not re.fullmatch(r"3\.1\.\d+", document.get("openapi", "")):
        found.append("openapi is not 3.1.x")
    for member in ("title", "version"):
        if not document.get("info", {}).get(member):
            found.append(f"info has no {member}")
    schemes = document.get("components", {}).get("securitySchemes", {})
    seen = set()
    for path, item in document.get("paths", {}).items():
        if not path.startswith("/"):
            found.append(f"{path} does not begin with a slash")
        for method, operation in item.items():
            found += [f"{method} {path}: {fault}" for fault in operation_faults(path, method, operation, schemes, document.get("security"))]
            name = operation.get("operationId")
            if name in seen:
                found.append(f"{method} {path}: the operationId {name} is given twice")
            seen.add(name)
    for name, schema in document.get("components", {}).get("schemas", {}).items():
        found += members_without_meaning(schema, name)
    found += examples_that_are_none(document)
    found += [f"{reference} leads nowhere" for reference in references(document) if not resolves(document, reference)]
    return found


def operation_faults(path, method, operation, schemes, default_security):
    found = []
    if method not in METHODS:
        found.append("is no method of ours")
    for member in ("operationId", "summary"):
        if not isinstance(operation.get(member), str) or not operation[member]:
            found.append(f"no {member}")
    if not all(operation.get("tags") or [""]):
        found.append("belongs to no group")
    if not operation.get("responses"):
        found.append("no responses")
    for status, response in operation.get("responses", {}).items():
        if "$ref" in response:  # of the components; references() follows it
            continue
        if not re.fullmatch(r"default|[1-5](XX|\d\d)", status) or not response.get("description"):
            found.append(f"response {status} is none, or is not described")
    security = operation.get("security", default_security)
    if security is None:
        found.append("nothing is said of security")
    found += [f"the scheme {name} is not described" for one in security or [] for name in one if name not in schemes]
    in_path = [p["name"] for p in operation.get("parameters", []) if p.get("in") == "path"]
    if sorted(in_path) != sorted(re.findall(r"\{(\w+)\}", path)):
        found.append(f"the parameters {in_path} are not those of the path")
    for parameter in operation.get("parameters", []):
        if parameter.get("in") not in ("path", "query", "header") or "schema" not in parameter:
            found.append(f"the parameter {parameter.get('name')} has no place or no schema")
        if not parameter.get("description"):
            found.append(f"the parameter {parameter.get('name')} has no meaning")
        if parameter.get("in") == "path" and parameter.get("required") is not True:
            found.append(f"the parameter {parameter.get('name')} of the path is not required")
    if "requestBody" in operation:
        content = operation["requestBody"].get("content", {})
        if "$ref" not in content.get("application/json", {}).get("schema", {}) and "contentMediaType" not in content.get("*/*", {}).get("schema", {}):
            found.append("no body is described")
    if operation.get("responses") and not any(status.startswith("2") for status in operation["responses"]):
        found.append("no success is described")
    for response in operation.get("responses", {}).values():
        found += [f"{kind} is not described by a schema" for kind, content in response.get("content", {}).items() if not content.get("schema")]
    return found


def examples_that_are_none(document):
    """Examples that are not what their schema says, and what is sent and has none; the description itself is its own example."""
    schemas = document.get("components", {}).get("schemas", {})
    sent = sent_schemas(document.get("paths", {})) | sent_schemas(document.get("webhooks", {}))
    found = [f"the schema {name} has no example" for name in sorted(sent - {"OpenApi"}) if name in schemas and not schemas[name].get("examples")]
    for name, schema in schemas.items():
        valid = Draft202012Validator({"$ref": f"#/components/schemas/{name}", "components": closed({"schemas": schemas})})
        for example in schema.get("examples", []):
            found += [f"an example of {name}: {'/'.join(map(str, fault.absolute_path))}: {fault.message}" for fault in valid.iter_errors(example)]
    return found


def sent_schemas(node):
    """Names of the schemas that requests and answers are: not those that are a part of one."""
    if isinstance(node, list):
        return set().union(*map(sent_schemas, node))
    if not isinstance(node, dict):
        return set()
    if "$ref" in node:
        return {node["$ref"].split("/")[-1]} if "/schemas/" in node["$ref"] else set()
    return set().union(*map(sent_schemas, node.values()))


def closed(node):
    """The same schemas, where an object has no member but those that are named."""
    if isinstance(node, list):
        return [closed(one) for one in node]
    if not isinstance(node, dict):
        return node
    found = {key: value if key == "examples" else closed(value) for key, value in node.items()}
    if isinstance(node.get("properties"), dict) and "additionalProperties" not in node and node.get("type") is not None:
        found["additionalProperties"] = False
    return found


def members_without_meaning(schema, path):
    """Members that have no sentence on what they are; a reference has its own."""
    found = []
    for name, member in schema.get("properties", {}).items():
        if not member.get("description") and "$ref" not in member and "anyOf" not in member:
            found.append(f"{path}/{name} has no meaning")
        found += members_without_meaning(member, f"{path}/{name}")
    for inner in ("items", "additionalProperties"):
        if isinstance(schema.get(inner), dict):
            found += members_without_meaning(schema[inner], path)
    return found


def references(node):
    if isinstance(node, dict):
        return [value for key, value in node.items() if key == "$ref"] + [r for value in node.values() for r in references(value)]
    return [r for value in node for r in references(value)] if isinstance(node, list) else []


def resolves(document, reference):
    node = document
    for step in reference.removeprefix("#/").split("/"):
        if not isinstance(node, dict) or step not in node:
            return False
        node = node[step]
    return reference.startswith("#/")


def differences(rights, document):
    """Between {(method, path): role} and what the document says; a role of None is every caller's."""
    described = {}
    for path, item in document["paths"].items():
        for method, operation in item.items():
            described[method.upper(), path] = None if operation.get("security") == [] else operation.get("x-role")
    found = [f"{method} {path} is described and has no row" for method, path in described.keys() - rights.keys()]
    found += [f"{method} {path} has a row and is not described" for method, path in rights.keys() - described.keys()]
    found += [f"{method} {path} is documented to need {described[method, path]}, not {role}"
              for (method, path), role in rights.items() if (method, path) in described and described[method, path] != role]
    return sorted(found)
