"""Checks bindings/api.json against the headers without the parser that makes it: every public function,
type and limit stands in it, with a comment that the header has, and it says what headers say of a value.

usage: test_api_json.py PROJECT"""

import json
import re
import sys
import unittest
from pathlib import Path

PROJECT = Path(sys.argv[1])
API = json.loads((PROJECT / "bindings/api.json").read_text(encoding="utf-8"))
TEXTS = {path.name: path.read_text(encoding="utf-8")
         for path in sorted((PROJECT / "engine/include/thud").glob("*.h"))
         if path.name != "thud_recorded.h"}   # which is made of api.json
CODE = {name: re.sub(r"/\*.*?\*/", " ", text, flags=re.DOTALL) for name, text in TEXTS.items()}


def named(kind):
    return {entry["name"]: entry for entry in API[kind]}


def found(pattern):
    """(name, header) of each match of a pattern in the headers' code."""
    return {(match, header) for header, text in CODE.items() for match in re.findall(pattern, text, re.M)}


def words(text):
    return re.sub(r"[\s*\\]+", " ", text).strip()


class ApiTest(unittest.TestCase):
    def check(self, kinds, expected, least):
        there = {(entry["name"], entry["header"]) for kind in kinds for entry in API[kind]}
        self.assertGreater(len(expected), least)
        self.assertEqual(expected - there, set(), "these lack in api.json")
        return there

    def test_functions(self):
        exported = found(r"THUD_API[^;{}()]*?\b(thud_\w+)\(")
        inline = found(r"^static inline [^;{}()]*?\b(thud_\w+)\(")
        there = self.check(["functions"], exported | inline, 240)
        self.assertEqual(there, exported | inline)
        self.assertEqual({(entry["name"], entry["header"]) for entry in API["functions"] if entry["inline"]},
                         inline)

    def test_types(self):
        types = found(r"^typedef (?:struct|enum) (thud_\w+)\b") | found(r"^typedef [^;{}]*?\*?\b(thud_\w+)\(") \
            | found(r"^\} (thud_\w+);")
        self.check(["structs", "enums", "aliases", "callbacks"], types, 90)

    def test_limits_and_variables(self):
        self.check(["constants"], found(r"^#define (THUD_\w+)[\s\\]+\(?-?[\d.]"), 65)
        variables = found(r"^extern THUD_API const \w+ (thud_\w+)[,;]")
        self.check(["variables"], variables, 9)

    def test_every_item_has_a_comment_of_its_header(self):
        for kind in API:
            for entry in API[kind]:
                text = words(TEXTS[entry.get("header", entry["name"])])
                self.assertTrue(entry["comment"], entry["name"])
                for part in entry["comment"].split("\n"):
                    self.assertIn(words(part), text, entry["name"])

    def test_no_comment_is_that_of_a_neighbour_or_of_the_header(self):
        heads = {entry["comment"] for entry in API["headers"]}
        shared = re.compile(r"\b(?:All|all) (?:return|calls|are|take)\b|\b(?:Both|All three|All four) calls\b")
        for kind in set(API) - {"headers"}:
            before = None
            for entry in API[kind]:
                self.assertFalse(entry["comment"] in heads, entry["name"])
                if before and before["header"] == entry["header"] and before["comment"] == entry["comment"] \
                        and len(entry["comment"].split()) > 3 and not entry["comment"].startswith("Maximum"):
                    self.assertRegex(entry["comment"], shared, entry["name"])
                before = entry

    def test_fields_share_a_comment_only_in_one_declaration(self):
        events = {field["name"]: field["comment"] for field in named("structs")["thud_events"]["fields"]}
        self.assertEqual(events["sensor_begin_time"], events["sensor_end_time"])
        self.assertNotEqual(events["hit_count"], events["sensor_end_time"])
        joint = {field["name"]: field["comment"] for field in named("structs")["thud_joint_def"]["fields"]}
        self.assertNotIn("breaks", joint["user_data"])

    def test_every_field_that_a_program_sets_has_a_comment(self):
        names = [name for name in named("structs")
                 if re.search(r"_(def|options|quality|drive|filter|rule|explosion|water)$", name)]
        self.assertGreater(len(names), 10)
        for name in names:
            for field in named("structs")[name]["fields"]:
                self.assertTrue(field["comment"], f"{name}.{field['name']}")

    def test_fields_are_those_of_the_structs(self):
        for name, entry in named("structs").items():
            body = re.search(rf"struct {name} \{{(.*?)\n\}}", CODE[entry["header"]], re.DOTALL)
            self.assertEqual(body is None, entry["opaque"], name)
            for field in entry["fields"]:
                self.assertRegex(body[1], rf"\b{field['name']}\b")

    def test_values_have_what_their_comments_say(self):
        world, body, shape = (
            {field["name"]: field for field in named("structs")[f"thud_{kind}_def"]["fields"]}
            for kind in ("world", "body", "shape"))
        self.assertEqual([world["time_step"][key] for key in ("type", "unit", "range", "default")],
                         ["double", "s", "(0, THUD_TIME_STEP_MAX]", "1/60"])
        self.assertEqual((world["gravity"]["default"], world["gravity"]["unit"]), ("(0, -10)", "length/s^2"))
        self.assertEqual((shape["friction"]["default"], shape["friction"]["range"]),
                         ("0.6", "[0, THUD_FRICTION_MAX]"))
        self.assertEqual((body["linear_damping"]["unit"], body["linear_damping"]["range"]), ("1/s", ">= 0"))
        self.assertEqual(named("constants")["THUD_TIME_STEP_MAX"]["value"], 1.0)
        self.assertEqual([value["value"] for value in named("enums")["thud_body_kind"]["values"]], [0, 1, 2, 3])

    def test_calls_have_their_errors_and_parameters(self):
        call = named("functions")["thud_body_set_velocity"]
        self.assertEqual([(part["type"], part["name"]) for part in call["parameters"]],
                         [("thud_world *", "world"), ("thud_body_id", "body"), ("thud_vec2", "velocity"),
                          ("float", "angular_velocity")])
        self.assertEqual(call["errors"], ["THUD_ERROR_INVALID", "THUD_ERROR_MEMORY", "THUD_ERROR_NULL",
                                          "THUD_ERROR_STALE"])
        self.assertIn("An edit wakes the body", call["group"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
