/**
 * Tests that the places of the numbers that module and JavaScript exchange come from one list,
 * slots.h.
 */
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { test } from "node:test";
import { importTypeScript } from "../../../web/tools/scenes.mjs";
import { readStructs, STRUCTS, typescriptOf } from "../../../web/tools/slots.mjs";
import { root, thud } from "../support/package.mjs";

const at = (struct, name) => STRUCTS.get(struct).members.find((member) => member.name === name).at;

test("structs_of_c_become_places_and_option_names", () => {
  const structs = readStructs(`/* struct no { double x; }; */
struct part { double a, b; };
struct things_options { double first, two_of[2]; struct part parts[2], rest; double last; };`);
  assert.deepEqual(structs.get("things_options"), {
    members: [
      { name: "first", at: 0, length: 1, part: false },
      { name: "twoOf", at: 1, length: 2, part: false },
      { name: "parts", at: 3, length: 4, part: true },
      { name: "rest", at: 7, length: 2, part: true },
      { name: "last", at: 9, length: 1, part: false },
    ],
    length: 10,
  });
  const text = typescriptOf(structs);
  assert.match(text, /enum ThingsOptionsAt \{\n {2}first = 0,\n {2}twoOf = 1,\n {2}parts = 3,/);
  const names = text.slice(text.indexOf("THINGS_OPTIONS")).match(/"[^"]+"/g).map(JSON.parse);
  assert.deepEqual(names, ["first", "twoOf", ".", "last"]);
});

test("struct_that_cannot_be_read_is_refused", () => {
  assert.throws(() => readStructs("struct a { struct b c; };"), /b cannot be read/);
  assert.throws(() => readStructs("struct a { double *c; };"), /a: \*c cannot be read/);
});

test("package_was_built_from_the_slots_as_they_are", () => {
  const built = readFileSync(`${root}web/package/src/generated/slots.ts`, "utf8");
  assert.equal(built, typescriptOf(STRUCTS));
});

test("page_reads_the_rows_of_the_shape_table_where_they_are", async () => {
  const page = await importTypeScript("src/scene/shape-table.ts");
  assert.equal(page.ROW, STRUCTS.get("shape_row").length);
  assert.deepEqual(
    [page.SLOT, page.SHAPE, page.BODY, page.SENSOR, page.OFFSET, page.HALF, page.TURN],
    ["slot", "shape", "body", "sensor", "offset", "halfExtents", "cosine"].map((name) =>
      at("shape_row", name),
    ),
  );
});

test("every_call_of_the_package_is_a_function_of_the_module", async () => {
  const [engine, threaded] = [await thud.load(), await thud.load({ threads: 2 })];
  const recorded = await thud.load(new URL(`file://${root}web/package/dist/thud-recorded.wasm`));
  const folder = `${root}web/package/src`;
  const texts = readdirSync(folder)
    .filter((name) => name.endsWith(".ts"))
    .map((name) => readFileSync(`${folder}/${name}`, "utf8"));
  const called = new Set(texts.join("").match(/(?<=exports\.|")api_[a-z_]+/g));
  assert.ok(called.size > 50);
  const missingIn = ({ exports }) =>
    [...called].filter((name) => typeof exports[name] !== "function").sort();
  // Only thud-threads.wasm has a pool, and only thud-recorded.wasm records.
  const pool = ["api_thread_serve", "api_threads_end", "api_threads_set"];
  assert.deepEqual(missingIn(recorded), pool);
  const recording = missingIn(threaded);
  assert.ok(recording.length > 5 && recording.every((name) => /^api_(player|recorder)_/.test(name)), recording);
  assert.deepEqual(missingIn(engine), [...recording, ...pool].sort());
});
