/**
 * Tests the engine with threads, thud-threads.wasm: the same bits with any number of them, in a
 * process that ends by itself, and what `load` refuses.
 */
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { buildScene, runScene } from "../../../web/tools/scenes.mjs";
import { root, thud } from "../support/package.mjs";

const { loadThreads } = await import(`${root}web/package/dist/threads.js`);

/** Scenes that threads share with the option `shareFrom` below. */
const LARGE = { pyramid: 40, circle_pit: 3000 };
const SHARE_FROM = 512;
const STEPS = 20;

async function hashOf(engine, name) {
  const { scene, close } = await buildScene(engine, name, { size: LARGE[name] });
  runScene(scene, STEPS);
  const hash = scene.world.hash();
  // On a busy machine a thread may come late; the world does the same step until then, since one
  // that sleeps would leave the threads nothing to do.
  const busy = scene.world.snapshot();
  const end = Date.now() + 20_000;
  while (engine.threads > 1 && engine.exports.api_threads_helped() === 0 && Date.now() < end) {
    scene.world.restore(busy);
    scene.world.step();
  }
  close();
  return hash;
}

for (const name of Object.keys(LARGE))
  test(`scene_${name}_has_equal_hash_with_any_number_of_threads`, async () => {
    const expected = await hashOf(await thud.load(), name);
    for (const threads of [1, 2, 3]) {
      const engine = await thud.load({ threads, shareFrom: SHARE_FROM });
      assert.equal(engine.threads, threads);
      assert.equal(await hashOf(engine, name), expected, `${threads} threads`);
      if (threads > 1) assert.ok(engine.exports.api_threads_helped() > 0, "threads have worked");
      engine.endThreads();
      assert.equal(engine.threads, 1);
      assert.equal(await hashOf(engine, name), expected, "after the threads have ended");
    }
  });

test("module_with_threads_gives_the_same_bits_on_the_calling_thread_alone", async () => {
  const url = new URL(`file://${root}web/package/dist/thud-threads.wasm`);
  const engine = await thud.load(url).catch((error) => error);
  assert.equal(engine.code, "load", "it needs a memory");
  const alone = await loadThreads(1, { module: readFileSync(url) });
  assert.equal(await hashOf(alone, "pyramid"), await hashOf(await thud.load(), "pyramid"));
});

test("error_of_engine_with_threads_has_its_message_and_snapshot_is_no_shared_memory", async () => {
  const engine = await thud.load({ threads: 2 });
  const world = engine.createWorld();
  const nobody = { kind: "body", index: 5, generation: 1 };
  assert.throws(() => world.bodyStateOf(nobody), { name: "ThudError", code: "stale" });
  assert.ok(world.snapshot().buffer instanceof ArrayBuffer);
  world.restore(world.snapshot());
  world.close();
});

test("process_ends_while_its_threads_wait", () => {
  const code =
    `const { load } = await import(${JSON.stringify(`file://${root}web/package/dist/node.js`)});` +
    "console.log((await load({ threads: 3 })).threads);";
  const { stdout, status } = spawnSync(process.execPath, ["--input-type=module", "-e", code], {
    encoding: "utf8",
    timeout: 20_000,
  });
  assert.deepEqual([stdout, status], ["3\n", 0]);
});

test("step_with_too_little_to_do_is_left_to_the_calling_thread", async () => {
  const helped = async (options) => {
    const engine = await thud.load({ threads: 2, ...options });
    const { scene, close } = await buildScene(engine, "pyramid", { size: LARGE.pyramid });
    const end = Date.now() + 20_000;
    do runScene(scene, STEPS);
    while (options.shareFrom === 1 && !engine.exports.api_threads_helped() && Date.now() < end);
    close();
    const calls = engine.exports.api_threads_helped();
    engine.endThreads();
    return calls > 0;
  };
  assert.deepEqual([await helped({}), await helped({ shareFrom: 1 })], [false, true]);
});

for (const shareFrom of [0, -1, 2 ** 32, 1.5, NaN, "512", null])
  test(`load_with_${typeof shareFrom}_${shareFrom}_as_share_from_is_refused`, async () => {
    const message = /^load: shareFrom must be a whole number from 1 to 4294967295: /;
    await assert.rejects(thud.load({ threads: 2, shareFrom }), { name: "ThudError", code: "invalid", message });
  });

for (const threads of [0, -1, 65, 1.5, NaN, "2", null])
  test(`load_with_${typeof threads}_${threads}_of_threads_is_refused`, async () => {
    const message = /^load: threads must be a whole number from 1 to 64: /;
    await assert.rejects(thud.load({ threads }), { name: "ThudError", code: "invalid", message });
  });

test("load_names_the_option_that_was_meant", async () => {
  const message = /^load: no option is called "thread".*threads/;
  await assert.rejects(thud.load({ thread: 2 }), { code: "invalid", message });
});

test("load_without_shared_memory_gives_the_engine_without_threads", async (t) => {
  const { SharedArrayBuffer } = globalThis;
  t.after(() => Object.assign(globalThis, { SharedArrayBuffer }));
  delete globalThis.SharedArrayBuffer;
  const engine = await thud.load({ threads: 2 });
  assert.equal(engine.threads, 1);
  engine.createWorld().close();
});

test("load_names_a_module_with_threads_that_is_missing", async () => {
  const threadFiles = { module: "/nowhere/thud-threads.wasm" };
  await assert.rejects(thud.load({ threads: 2, threadFiles }), { code: "load", message: /nowhere/ });
});
