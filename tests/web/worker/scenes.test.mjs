/**
 * Tests the page's scenes: those of demo/scenes draw the same random numbers as in C and after two
 * seconds have the native hashes of tests/golden/hashes.txt; the others behave as their
 * descriptions say.
 */
import assert from "node:assert/strict";
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { test } from "node:test";
import { gzipSync } from "node:zlib";
import { GOLDEN, GOLDEN_STEPS } from "../../../web/tools/golden.mjs";
import { drawScene } from "../../../web/tools/picture.mjs";
import { GAME_FILES, orderScenes, readSceneText, readSceneTexts } from "../../../web/tools/scene-texts.mjs";
import {
  ABOUTS,
  buildScene,
  importScene,
  random,
  runScene,
  sceneFile,
  SCENES,
  thumbnailFile,
  THUMBNAILS,
} from "../../../web/tools/scenes.mjs";
import { demoWasm, root, sceneNames, thud } from "../support/package.mjs";

const engine = await thud.load();

for (const { name, size, hash } of GOLDEN)
  test(`scene_${name}_has_the_native_hash`, async () => {
    const { scene, setting } = await buildScene(engine, name, { size });
    assert.equal(setting.size, size);
    runScene(scene, GOLDEN_STEPS);
    assert.equal(scene.world.hash(), hash);
    scene.world.close();
  });

test("random_numbers_are_those_of_the_C_scenes", () => {
  const first = (seed) => {
    const chance = random(seed);
    return [chance(0, 1), chance(0, 1), chance(0, 1)];
  };
  // Printed by demo/scene/random.h; the last seed is the largest safe integer.
  assert.deepEqual(first(0), [0.88331080821364261, 0.43152799704850997, 0.026433771592597743]);
  assert.deepEqual(first(1), [0.5665615751722809, 0.74578175726270113, 0.97100275358679622]);
  assert.deepEqual(
    first(Number.MAX_SAFE_INTEGER),
    [0.1434526250083874, 0.1904899463327181, 0.52937135741010444],
  );
});

test("registry_has_every_scene_module_and_no_other", () => {
  const files = readdirSync(`${root}web/public/scenes`).filter((file) => file.endsWith(".js"));
  // own_level, which runs a level from the visitor's file, is not in the list.
  const names = SCENES.map(({ name }) => name);
  const games = [...GAME_FILES.keys()].map((name) => `${name}.js`);
  assert.deepEqual([...names, "own_level"].map((name) => `${name}.js`).sort(), [...files, ...games].sort());
  for (const name of Object.keys(THUMBNAILS)) assert.ok(names.includes(name), name);
});

test("menu_has_what_the_modules_export_by_group_and_place", async () => {
  const texts = readSceneTexts();
  assert.deepEqual(SCENES, texts.map(({ name, title, group }) => ({ name, title, group })));
  assert.deepEqual(ABOUTS, Object.fromEntries(texts.map(({ name, about }) => [name, about])));
  for (const { name, ...read } of texts) {
    const { title, about, menu } = await importScene(name);
    assert.deepEqual(read, { title, about, ...menu }, name);
  }
});

test("scene_without_one_of_its_lines_is_refused_and_told_the_form", () => {
  const lines = [
    'export const title = "Pit";',
    'export const about =\n  "It fills.";',
    'export const menu = { group: "Piles", place: 310 };',
  ];
  const pit = { name: "pit", title: "Pit", about: "It fills.", group: "Piles", place: 310 };
  assert.deepEqual(readSceneText("pit", lines.join("\n")), pit);
  for (const missing of lines)
    assert.throws(
      () => readSceneText("pit", lines.filter((line) => line !== missing).join("\n")),
      { message: new RegExp(`scenes/pit.js lacks .* ${missing.slice(0, 20)}`) },
    );
  assert.equal(readSceneText("own", "export const menu = null;"), null);
});

test("places_are_told_apart_and_keep_groups_together", () => {
  const scene = (name, group, place) => ({ name, group, place });
  const names = orderScenes([scene("b", "Q", 20), scene("c", "Q", 30), scene("a", "P", 10)]);
  assert.deepEqual(names.map(({ name }) => name), ["a", "b", "c"]);
  const orderOf = (...scenes) => () => orderScenes(scenes);
  assert.throws(orderOf(scene("a", "P", 10), scene("b", "P", 10)), /a and b have one place, 10/);
  assert.throws(
    orderOf(scene("a", "P", 10), scene("b", "Q", 20), scene("c", "P", 30)),
    /c: place 30 lies outside of the group “P”/,
  );
});

test("scenes_that_c_has_too_have_the_same_usual_size", async () => {
  const native = await thud.load(demoWasm);
  const names = sceneNames(native);
  assert.ok(names.length >= 20);
  for (const [i, name] of names.entries()) {
    if (!existsSync(`${root}web/public/${sceneFile(name)}`)) continue;
    const { size } = await import(`${root}web/public/${sceneFile(name)}`);
    assert.equal(size.usual, native.exports.api_scene_size(i), name);
  }
});

for (const { name } of SCENES)
  test(`scene_${name}_run_twice_does_the_same_and_stays_whole`, async () => {
    const hashes = [];
    for (let run = 0; run < 2; run++) {
      const { scene } = await buildScene(engine, name, { size: THUMBNAILS[name]?.size, seed: 7 });
      runScene(scene, 90);
      assert.deepEqual(scene.world.events().quarantined, []);
      hashes.push(scene.world.hash());
      scene.world.close();
    }
    assert.equal(hashes[0], hashes[1]);
  });

test("scene_of_another_seed_is_another_world", async () => {
  const hashOf = async (seed) => {
    const { scene } = await buildScene(engine, "circle_pit", { size: 50, seed });
    return scene.world.hash();
  };
  assert.notEqual(await hashOf(0), await hashOf(1));
});

test("size_out_of_range_is_brought_into_it", async () => {
  assert.equal((await buildScene(engine, "heavy_on_light", { size: 1e9 })).setting.size, 8);
  assert.equal((await buildScene(engine, "heavy_on_light", { size: -5 })).setting.size, 1);
});

test("dominoes_last_one_falls", async () => {
  const { scene } = await buildScene(engine, "dominoes");
  const [, y0] = lastBody(scene.world).position;
  runScene(scene, 1200);
  assert.ok(lastBody(scene.world).position[1] < 0.4 * y0);
});

test("galton_board_counts_every_ball_once_and_most_in_the_middle", async () => {
  const { scene, setting } = await buildScene(engine, "galton_board");
  runScene(scene, 6 * setting.size + 900);
  const { counts } = scene.state;
  const sum = (from, to) => counts.slice(from, to).reduce((a, b) => a + b, 0);
  assert.equal(sum(0, 15), setting.size);
  assert.ok(sum(5, 10) > 3 * (sum(0, 5) + sum(10, 15)));
});

test("far_away_world_stays_with_its_twin_also_after_going_back", async () => {
  const { scene } = await buildScene(engine, "far_away");
  const apart = () => Number.parseFloat(scene.paint().figures[1].value);
  runScene(scene, 120);
  assert.ok(apart() < 1e-8);
  scene.restored();
  assert.ok(apart() < 1e-8);
  scene.state.steps -= 60;
  scene.restored();
  assert.ok(apart() > 0.1);
});

test("hourglass_runs_out_and_is_turned_over", async () => {
  const { scene } = await buildScene(engine, "hourglass", { size: 400 });
  const upper = () => positions(scene.world).filter(([, y]) => y > 0).length;
  assert.ok(upper() >= 400);
  runScene(scene, 1700);
  assert.ok(upper() < 100);
  runScene(scene, 285, 1700);
  assert.ok(upper() > 200);
});

test("thumbnail_of_a_scene_is_small_and_shows_its_bodies", async () => {
  const { scene } = await buildScene(engine, "tall_stack", { size: 9 });
  const svg = drawScene(scene, ["red", "blue"]);
  assert.equal(svg.match(/M/g).length, 10);
  assert.match(svg, /fill="red".*fill="blue"/s);
  for (const { name } of SCENES) {
    const file = `${root}web/public/${thumbnailFile(name)}`;
    if (existsSync(file)) assert.ok(gzipSync(readFileSync(file)).length < 12_000, name);
  }
});

function positions(world) {
  const poses = world.poses();
  const slots = Array.from({ length: poses.length / 4 }, (_, slot) => slot);
  return slots.map((slot) => [poses[4 * slot], poses[4 * slot + 1]]);
}

// The state of the body whose shape is last in the shape table.
function lastBody(world) {
  const { count, handles } = world.shapeTable();
  const [index1, generation] = handles.slice(4 * count - 2);
  return world.bodyStateOf({ kind: "body", index: index1 - 1, generation });
}

test("bullet_beyond_its_walls_is_counted", async () => {
  const { scene } = await buildScene(engine, "bullets");
  const out = () => scene.paint().figures[0].value;
  runScene(scene, 60);
  assert.equal(out(), "0 of 15");
  const { x, y } = scene.paint().marks.find(({ kind }) => kind === "circle");
  const [shape] = scene.world.overlap({ kind: "circle", center: [x, y], radius: 0.01 });
  scene.world.setTransform(scene.world.shapeStateOf(shape).body, [x, y + 50]);
  assert.equal(out(), "1 of 15");
  scene.world.close();
});
