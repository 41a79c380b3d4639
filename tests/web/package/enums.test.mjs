/**
 * Tests that the lists of words in the package are the enumerators of the C headers, in their
 * order: a number that crosses to the module means the same on both sides.
 */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import * as fields from "../../../web/package/dist/fields/field-types.js";
import * as approximate from "../../../web/package/dist/geometry/approximate.js";
import * as joints from "../../../web/package/dist/joint-types.js";
import * as rules from "../../../web/package/dist/rules/rule-types.js";
import * as types from "../../../web/package/dist/types.js";
import * as views from "../../../web/package/dist/view-types.js";
import { root } from "../support/package.mjs";

const headers = ["thud", "thud_approximate", "thud_draw", "thud_fields", "thud_joint", "thud_rules"]
  .map((name) => readFileSync(`${root}engine/include/thud/${name}.h`, "utf8"))
  .join("\n")
  .replace(/\/\*[^]*?\*\//g, "");

/** The enumerators of a C enum without `prefix`, as words; counts are left out. */
function enumerators(name, prefix) {
  const [, body] = new RegExp(`typedef enum ${name} \\{([^}]*)\\}`).exec(headers);
  return body
    .split(",")
    .map((line) => line.trim().split(/\s|=/)[0])
    .filter((word) => word && !word.endsWith("_COUNT"))
    .map((word) => {
      assert.ok(word.startsWith(prefix), word);
      return word.slice(prefix.length).toLowerCase();
    });
}

const camel = (word) => word.replace(/_(.)/g, (_, letter) => letter.toUpperCase());

const TWINS = [
  ["thud_body_kind", "THUD_BODY_", types.BODY_KINDS],
  ["thud_joint_kind", "THUD_JOINT_", joints.JOINT_KINDS],
  ["thud_direction", "THUD_DIRECTION_", joints.DIRECTIONS],
  ["thud_rule_kind", "THUD_RULE_", rules.RULE_KINDS],
  ["thud_approximate_kind", "THUD_APPROXIMATE_", approximate.APPROXIMATE_KINDS],
  ["thud_cover", "THUD_COVER_", fields.COVERS],
];

for (const [name, prefix, words] of TWINS)
  test(`${name}_has_the_same_words_in_the_package`, () => {
    assert.deepEqual(enumerators(name, prefix).map(camel), [...words]);
  });

test("draw_styles_have_the_same_words_in_the_package", () => {
  const styles = enumerators("thud_style", "THUD_STYLE_").flatMap((word) => {
    if (word === "colour") return Array.from({ length: 16 }, (_, i) => `colour ${i}`);
    if (word === "direct") return ["solved directly"];
    return word === "colour_last" ? [] : [word.replaceAll("_", " ")];
  });
  assert.deepEqual([...views.DRAW_STYLES], styles);
});

test("draw_options_are_the_bits_of_the_draw_flags", () => {
  const bits = [...headers.matchAll(/THUD_DRAW_(\w+) = 1 << (\d+)/g)];
  bits.forEach(([, , bit], i) => assert.equal(Number(bit), i));
  const flags = bits.map(([, word]) => (word === "SHAPE_BOUNDS" ? "bounds" : camel(word.toLowerCase())));
  assert.deepEqual([...views.DRAW_FLAGS], flags);
});
