# SPDX-License-Identifier: GPL-3.0-or-later
"""`brash schema` for editors: strict validators accept the schema, and the schema accepts the templates."""
import json
import os
import subprocess
import tomllib
import unittest

BRASH = os.environ["BRASH"]
LIMITS = {"minimum": "number", "maximum": "number", "exclusiveMinimum": "number", "exclusiveMaximum": "number",
          "maxLength": "string", "items": "array", "minItems": "array", "maxItems": "array", "properties": "object",
          "required": "object", "additionalProperties": "object"}
ANNOTATIONS = {"$schema", "$id", "title", "description", "default", "examples", "type", "enum", "anyOf"}


def brash(*words):
    return subprocess.run([BRASH, *words], check=True, capture_output=True, text=True).stdout


TYPES = {"object": dict, "array": list, "string": str, "boolean": bool, "integer": int, "number": (int, float)}


def allows(schema, value):
    """Whether a schema allows a value, by the keywords of ANNOTATIONS and LIMITS."""
    if "anyOf" in schema and not any(allows(part, value) for part in schema["anyOf"]):
        return False
    if "type" in schema and (not isinstance(value, TYPES[schema["type"]]) or
                             (isinstance(value, bool) and schema["type"] != "boolean")):
        return False
    if "enum" in schema and value not in schema["enum"]:
        return False
    if isinstance(value, dict):
        known = schema.get("properties", {})
        return (set(schema.get("required", ())) <= set(value) and
                (schema.get("additionalProperties", True) or set(value) <= set(known)) and
                all(allows(known[key], part) for key, part in value.items() if key in known))
    if isinstance(value, list):
        return (schema.get("minItems", 0) <= len(value) <= schema.get("maxItems", len(value)) and
                all(allows(schema.get("items", {}), item) for item in value))
    if isinstance(value, str):
        return len(value) <= schema.get("maxLength", len(value))
    return (schema.get("minimum", value) <= value <= schema.get("maximum", value) and
            not value <= schema.get("exclusiveMinimum", value - 1) and not value >= schema.get("exclusiveMaximum", value + 1))


def schemas_in(schema):
    yield schema
    for part in [*schema.get("properties", {}).values(), *schema.get("anyOf", ()), *filter(None, [schema.get("items")])]:
        yield from schemas_in(part)


class Schema(unittest.TestCase):
    def test_strict_validators_know_every_keyword_and_see_one_type(self):
        for options in ((), ("--plan",)):
            schema = json.loads(brash("schema", *options))
            for part in schemas_in(schema):
                self.assertIsInstance(part.get("type", ""), str)
                self.assertLessEqual(set(part), ANNOTATIONS | set(LIMITS))
                kinds = {"number", "integer"} if part.get("type") == "integer" else {part.get("type")}
                self.assertLessEqual({LIMITS[word] for word in set(part) & set(LIMITS)}, kinds, part)
                self.assertLessEqual(set(part.get("required", ())), set(part.get("properties", ())))

    def test_units_are_in_the_descriptions(self):
        ice = json.loads(brash("schema"))["properties"]["ice"]["properties"]
        self.assertTrue(ice["thickness"]["description"].endswith(" Unit: m."))

    def test_new_cases_name_the_schema_and_are_valid(self):
        schema = json.loads(brash("schema"))
        for words in (("schema", "--template"), ("new",), ("new", "--kind", "ship", "--ice", "baltic")):
            text = brash(*words)
            self.assertTrue(text.startswith("#:schema case.schema.json\n"), text[:40])
            self.assertTrue(allows(schema, tomllib.loads(text)), words)
        for key, value in (("thickness", 99.0), ("thicknes", 0.3)):
            wrong = tomllib.loads(brash("new"))
            wrong["ice"][key] = value
            self.assertFalse(allows(schema, wrong))


if __name__ == "__main__":
    unittest.main()
