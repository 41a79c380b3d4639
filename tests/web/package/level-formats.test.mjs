/**
 * Tests that all formats in which Tiled writes maps are read to the same bits in C and in
 * TypeScript. The maps in tests/levels/maps, as JSON and as XML, are made by
 * tools/make_test_levels.py.
 */
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { readdirSync, readFileSync } from "node:fs";
import { test } from "node:test";
import { nativeHash, skip, thudRun } from "../support/native.mjs";
import { level, root, thud } from "../support/package.mjs";

const engine = await thud.load();
const { buildLevel, LevelError, readLevel } = level;
const folder = `${root}tests/levels/maps/`;
const files = readdirSync(folder).filter((name) => /\.tm[jx]$/.test(name));
const open = (path) => readFileSync(folder + path);
const STEPS = 200;

async function hashOf(file, options = {}) {
  const read = await readLevel(file, open(file), { open, skip: true, engine, ...options });
  const world = buildLevel(engine, read);
  for (let i = 0; i < STEPS; i++) world.step();
  const hash = world.hash();
  world.close();
  return hash;
}

async function problemsOf(content, options) {
  try {
    return (await readLevel("test", content, options)).problems;
  } catch (error) {
    assert.ok(error instanceof LevelError, String(error.stack));
    return error.problems;
  }
}

/** The text of a problem, which must be the same in both languages. */
const wordsOf = ({ severity, text }) => `${severity}: ${text}`;

test("there_is_a_map_of_each_form", () => {
  assert.ok(files.length === 30, files.join(" "));
});

for (const file of files)
  test(`level_${file}_has_equal_hash_native_and_wasm`, { skip }, async () => {
    assert.equal(await hashOf(file), nativeHash(folder + file, STEPS, "--skip-unsupported"));
  });

for (const file of files)
  test(`level_${file}_has_the_same_problems_in_c_and_typescript`, { skip }, async () => {
    // Standard output is discarded, so that the report on standard error is all that remains.
    const script = `"$0" "$1" --steps 1 --json --skip-unsupported 2>&1 >/dev/null`;
    const args = ["-c", script, thudRun, `${folder}${file}`];
    const told = execFileSync("sh", args, { encoding: "utf8" }).split("\n").filter(Boolean);
    const native = told.map((line) =>
      line.slice(folder.length + file.length + 2).replace(/^unsupported/, "skip"),
    );
    const problems = await problemsOf(open(file), { open, skip: true, engine });
    assert.deepEqual(problems.map(wordsOf), native);
  });

for (const file of files.filter((name) => name.endsWith(".tmx")))
  test(`level_${file}_is_the_same_world_as_its_json`, async () => {
    assert.equal(await hashOf(file), await hashOf(file.replace(".tmx", ".tmj")));
  });

test("polygons_are_approximated_by_the_engine_alone", async () => {
  const problems = await problemsOf(open("polygons.tmj"), { open, skip: true });
  const needs = problems.filter(({ text }) => text.includes("needs the option 'engine'"));
  assert.equal(needs.length, 7);
});

test("layer_is_the_same_however_it_is_packed", async () => {
  const packings = ["csv", "base64", "zlib", "gzip", "zstd"];
  const hashes = await Promise.all(packings.map((packing) => hashOf(`${packing}.tmj`)));
  assert.equal(new Set(hashes).size, 1);
});

test("missing_files_are_told_and_what_stands_by_itself_is_read", async () => {
  const problems = await problemsOf(open("props.tmx"), { skip: true });
  const text = problems.map(wordsOf).join("\n");
  for (const path of ["tiles/ground.tsx", "tiles/things.tsj", "templates/crate.tx", "templates/plank.tj"])
    assert.match(text, new RegExp(`skip: \\w+ '${path}': it is not there`));
});

test("opener_that_throws_is_as_one_that_finds_nothing", async () => {
  const throws = () => {
    throw new Error("no");
  };
  assert.deepEqual(
    await problemsOf(open("props.tmx"), { open: throws }),
    await problemsOf(open("props.tmx")),
  );
});

test("map_is_refused_whole_without_skip_and_lists_everything", async () => {
  await assert.rejects(readLevel("wrong", open("wrong.tmj"), { open }), ({ problems }) => {
    const objects = problems.map(({ object }) => object).filter((object) => object > 0);
    return new Set(objects).size === 11;
  });
});

/** A map with one layer of 2 by 2 cells and compressed data. */
const packed = (data, compression = "zlib", size = 2) =>
  JSON.stringify({
    type: "map",
    width: size,
    height: size,
    tilewidth: 32,
    tileheight: 32,
    tilesets: [{ firstgid: 1, tilewidth: 32, tileheight: 32 }],
    layers: [
      { type: "tilelayer", name: "t", width: size, height: size, encoding: "base64", compression, data },
    ],
  });
const xml = (body) => `<?xml version="1.0"?><map width="2" height="2" tilewidth="9" tileheight="9">${body}</map>`;
/** A layer of 33 by 33 tiles with 1024 shapes each. */
function crowded() {
  const objects = Array.from({ length: 1024 }, (_, i) => ({ id: i + 1, x: 0, y: 0, width: 9, height: 9 }));
  const map = JSON.parse(packed("", "", 33));
  map.tilesets[0].tiles = [{ id: 0, objectgroup: { objects } }];
  map.layers[0] = { type: "tilelayer", name: "t", width: 33, height: 33, data: Array(33 * 33).fill(1) };
  return JSON.stringify(map);
}
const zeros = "eJxjYGBgAAAABAAB"; // truncated
const bomb = (bytes) => Buffer.from(bytes).toString("base64");

for (const [name, content, expected] of [
  ["base64_with_other_letters", packed("ab!c"), /not in base64/],
  ["zlib_that_is_cut_short", packed(zeros), /do not unpack/],
  ["gzip_that_is_none", packed(zeros, "gzip"), /do not unpack/],
  ["zstd_that_is_none", packed(zeros, "zstd"), /do not unpack/],
  // A window of 2^41 bytes; a frame that claims to contain 2^32 - 1 bytes.
  ["zstd_of_a_giant_window", packed(bomb([0x28, 0xb5, 0x2f, 0xfd, 0, 0xf8, 1, 0, 0]), "zstd"), /do not unpack/],
  ["zstd_that_claims_more", packed(bomb([0x28, 0xb5, 0x2f, 0xfd, 0xa0, 255, 255, 255, 255, 1, 0, 0]), "zstd"), /do not unpack/],
  ["unknown_packing", packed(zeros, "lzma"), /packed in a way that is not known/],
  ["cells_without_end", packed("", "", 900000), /more cells than are read/],
  ["xml_layer_without_tiles", xml('<layer name="t" width="2" height="2"><data encoding="csv"> </data></layer>'), /layer 't': has no tiles/],
  ["shapes_without_end", crowded(), /layer 't': 65 tiles are left out: this map has more shapes and vertices than are read, 1048576 in all/],
  ["xml_that_is_cut_short", xml("").slice(0, -3), /XML cannot be read/],
  ["xml_of_something_else", "<html/>", /not a Tiled map/],
  ["xml_with_entities", '<!DOCTYPE m [<!ENTITY a "b">]><map>&a;</map>', /XML cannot be read/],
  ["xml_without_size", "<map/>", /width is missing/],
  ["xml_nested_deeply", xml("<group>".repeat(70) + "</group>".repeat(70)), /nested too deeply/],
  ["points_that_are_none", xml('<objectgroup><object id="3" x="0" y="0"><polyline points="0,0 a"/></object></objectgroup>'), /object 3: x is missing/],
])
  test(`${name}_is_told`, async () => {
    const problems = await problemsOf(content);
    assert.match(problems.map(wordsOf).join("\n"), expected);
  });

test("template_that_is_its_own_ends", async () => {
  const template = { type: "template", object: { template: "a.tj" } };
  const map = xml('<objectgroup><object id="3" x="0" y="0" template="a.tj"/></objectgroup>');
  const problems = await problemsOf(map, { open: () => JSON.stringify(template) });
  assert.match(problems.map(wordsOf).join("\n"), /object 3: its template has no object of its own/);
});
