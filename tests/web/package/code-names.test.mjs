/**
 * Tests that the list of names beside the code editor, and its completion, contain everything in
 * the typings of package and page.
 */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { readCodeNames } from "../../../web/tools/code-names.mjs";
import { root } from "../support/package.mjs";

const GROUPS = readCodeNames();

function entriesOf(...titles) {
  const groups = GROUPS.filter(({ title }) => titles.some((start) => title.startsWith(start)));
  assert.ok(groups.length >= titles.length, `groups: ${titles}`);
  return groups.flatMap(({ entries }) => entries);
}

/** The lines within the braces of a declaration, found in the text without a compiler. */
function bodyOf(file, declaration) {
  const text = readFileSync(`${root}web/${file}`, "utf8").replace(/\/\*\*.*?\*\//gs, "");
  const [, after] = text.split(declaration);
  assert.ok(after, `${declaration} of ${file}`);
  return after.slice(after.indexOf("{"), after.indexOf("\n}")).split("\n");
}

// The names of an interface's properties in a TypeScript file.
function propertiesOf(file, type) {
  const step = file.endsWith(".d.ts") ? "    " : "  ";
  const property = new RegExp(`^${step}(?:readonly )?(\\w+)\\??[:(]`);
  return bodyOf(file, `export interface ${type} `).flatMap((line) => property.exec(line)?.[1] ?? []);
}

test("list_has_every_public_method_of_a_world", () => {
  const layers = ["base", "queries", "views", "joints", "edits", "forces", "fields", "lists", "shapes"];
  const files = ["world", "rules/world-rules", ...layers.map((layer) => `world-${layer}`)];
  const methods = files.flatMap((file) =>
    bodyOf(`package/dist/${file}.d.ts`, /export declare class \w+ /).flatMap(
      (line) => /^    (?!constructor)(\w+)(?:<\w+>)?\(/.exec(line)?.[1] ?? [],
    ),
  );
  assert.ok(methods.length > 50, `${methods}`);
  const listed = entriesOf("A world:").map(({ name }) => name);
  assert.deepEqual([...listed].sort(), methods.sort());
});

for (const [title, file, types] of [
  ["Options of createWorld", "package/dist/types.d.ts", ["WorldOptions"]],
  ["Options of createBody", "package/dist/types.d.ts", ["BodyOptions"]],
  [
    "Options of shapes",
    "package/dist/types.d.ts",
    ["ShapeOptions", "CircleOptions", "BoxOptions", "ObbOptions"],
  ],
  [
    "Options of createJoint",
    "package/dist/joint-types.d.ts",
    [
      "JointOptions",
      "PairOptions",
      "PlacedOptions",
      "DistanceOptions",
      "HingeOptions",
      "SliderOptions",
      "WeldOptions",
      "WheelOptions",
      "TargetOptions",
      "FilterOptions",
      "GearOptions",
    ],
  ],
  ["What drives a joint", "package/dist/joint-types.d.ts", ["Drive"]],
  ["The function is given", "src/scene/scene.ts", ["SceneSetting"]],
  ["The function returns", "src/scene/scene.ts", ["Scene"]],
  ["What update is given", "src/scene/scene.ts", ["Input"]],
  ["What paint returns", "src/scene/scene.ts", ["Paint"]],
])
  test(`list_has_every_member_of_${types.at(-1)}`, () => {
    const members = new Set(types.flatMap((type) => propertiesOf(file, type)));
    assert.ok(members.size > 2);
    const listed = entriesOf(title).map(({ name }) => name);
    assert.deepEqual([...listed].sort(), [...members].sort());
  });

test("list_has_every_kind_of_mark", () => {
  const text = readFileSync(`${root}web/src/scene/scene.ts`, "utf8");
  const kinds = [...text.matchAll(/^ {2}kind: "(\w+)";$/gm)].map(([, kind]) => kind);
  assert.equal(kinds.length, 5);
  assert.deepEqual(entriesOf("Marks").map(({ name }) => name), kinds);
});

test("list_has_every_kind_of_joint", async () => {
  const { JOINT_KINDS } = await import(`${root}web/package/dist/node.js`);
  assert.deepEqual(entriesOf("Kinds of joints").map(({ name }) => name).sort(), [...JOINT_KINDS].sort());
});

test("every_name_of_the_list_has_a_form_and_a_comment", () => {
  for (const { name, form, meaning } of GROUPS.flatMap(({ entries }) => entries)) {
    assert.ok(form.includes(name) || form.includes("{"), `${name}: ${form}`);
    assert.match(meaning, /^\S.*[.:)]$/, `${name} has no sentence in the typings`);
    assert.doesNotMatch(`${form}${meaning}`, /`|\n|@/, name);
  }
});

test("forms_come_from_examples_or_else_from_signatures_and_defaults", () => {
  const formOf = (group, wanted) => entriesOf(group).find(({ name }) => name === wanted)?.form;
  assert.equal(formOf("A world:", "setVelocity"), "world.setVelocity(ball, [3, 0])");
  assert.equal(formOf("A world:", "advance"), "world.advance(elapsed, maxSteps?, calls?)");
  assert.equal(formOf("Options of shapes", "friction"), "friction: 0.6");
  assert.equal(formOf("Options of shapes", "sensor"), "sensor: true");
  assert.equal(formOf("Options of createWorld", "sleeping"), "sleeping: false");
  assert.equal(formOf("The function returns", "update"), "update({ held, step }) { … }");
});
