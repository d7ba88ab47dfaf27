#!/usr/bin/python3
"""Reads what shadefit wrote as others would: check_findings.py FILE

Validates the file by sarif-schema-2.1.0.json, the schema of the standard, unchanged: SARIF 2.1.0 with errata 01,
https://github.com/oasis-tcs/sarif-spec, sarif-2.1/schema. Copyright OASIS Open; its policy lets the documents of a standard
be copied, https://www.oasis-open.org/policies-guidelines/ipr. The words of JSON Schema that the schema uses are here; one
that is not is an error, so that none is passed over.
Exit 1, with what is wrong, if something is.
"""
import json
import os
import re
import sys

SCHEMA = os.path.join(os.path.dirname(os.path.abspath(__file__)), "sarif-schema-2.1.0.json")
# Words that require nothing, and those that `faults` knows.
REMARKS = {"description", "default", "title", "$schema", "id", "definitions"}
KNOWN = {"type", "$ref", "items", "uniqueItems", "minItems", "additionalProperties", "properties", "required", "minimum",
         "maximum", "pattern", "format", "enum", "anyOf", "oneOf"}
TYPES = {"object": dict, "array": list, "string": str, "integer": int, "number": (int, float), "boolean": bool,
         "null": type(None)}
FORMATS = {  # RFC 3986, appendix A, as far as characters go; RFC 3339
    "uri": r"[A-Za-z][A-Za-z0-9+.-]*:([A-Za-z0-9._~:/?#\[\]@!$&'()*+,;=-]|%[0-9A-Fa-f]{2})*",
    "uri-reference": r"(([A-Za-z][A-Za-z0-9+.-]*:)|(?![^/?#]*:))([A-Za-z0-9._~:/?#\[\]@!$&'()*+,;=-]|%[0-9A-Fa-f]{2})*",
    "date-time": r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d(\.\d+)?(Z|[+-]\d\d:\d\d)"}


def has_type(value, names):
    """Whether a value is of a type, or of one of several. Python counts booleans as integers, JSON does not."""
    names = [names] if isinstance(names, str) else names
    return any(isinstance(value, TYPES[name]) and isinstance(value, bool) == (name == "boolean") for name in names)


def faults(value, schema, root, at):
    """What breaks the schema, each with its place."""
    unknown = set(schema) - REMARKS - KNOWN
    if unknown:
        raise NotImplementedError(f"the schema has {sorted(unknown)} at {at}")
    if "$ref" in schema:
        target = root
        for part in schema["$ref"].lstrip("#/").split("/"):
            target = target[part]
        yield from faults(value, target, root, at)
        return
    if "type" in schema and not has_type(value, schema["type"]):
        yield f"{at} is not of type {schema['type']}"
        return
    if "enum" in schema and value not in schema["enum"]:
        yield f"{at} is {value!r}: not one of {schema['enum']}"
    for word in ("anyOf", "oneOf"):
        fitting = [s for s in schema.get(word, []) if not list(faults(value, s, root, at))]
        if word in schema and (not fitting or (word == "oneOf" and len(fitting) > 1)):
            yield f"{at} fits {len(fitting)} of {word}"
    if isinstance(value, (int, float)) and not schema.get("minimum", value) <= value <= schema.get("maximum", value):
        yield f"{at} is {value}: out of range"
    if isinstance(value, str):
        if "pattern" in schema and not re.search(schema["pattern"], value):
            yield f"{at} is {value!r}: not {schema['pattern']}"
        if "format" in schema and not re.fullmatch(FORMATS[schema["format"]], value):
            yield f"{at} is {value!r}: no {schema['format']}"
    if isinstance(value, list):
        if len(value) < schema.get("minItems", 0):
            yield f"{at} has {len(value)} items"
        if schema.get("uniqueItems") and len({json.dumps(item, sort_keys=True) for item in value}) < len(value):
            yield f"{at} has an item twice"
        for i, item in enumerate(value):
            yield from faults(item, schema.get("items", {}), root, f"{at}[{i}]")
    if isinstance(value, dict):
        known = schema.get("properties", {})
        others = schema.get("additionalProperties", True)
        yield from (f"{at} lacks {key}" for key in schema.get("required", []) if key not in value)
        for key, item in value.items():
            if key in known:
                yield from faults(item, known[key], root, f"{at}.{key}")
            elif others is False:
                yield f"{at} has {key}, which the schema does not know"
            elif isinstance(others, dict):
                yield from faults(item, others, root, f"{at}.{key}")


def check_sarif(path):
    with open(SCHEMA, encoding="utf-8") as file:
        schema = json.load(file)
    with open(path, encoding="utf-8") as file:
        log = json.load(file)
    return list(faults(log, schema, schema, "log"))


def main():
    wrong = check_sarif(sys.argv[1])
    for fault in wrong:
        print(fault, file=sys.stderr)
    return 1 if wrong else 0


sys.exit(main())
