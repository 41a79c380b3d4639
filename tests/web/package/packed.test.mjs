/** Tests packed snapshots in the npm package: small, the same bytes again, and damage refused. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { buildScene, demoWasm, sceneNames, thud } from "../support/package.mjs";

const engine = await thud.load();
const demo = await thud.load(demoWasm);

function refusedWith(pattern, act) {
  assert.throws(act, (error) => error.code === "invalid" && pattern.test(error.message));
}

/** A heap of boxes. */
function heap() {
  const world = engine.createWorld();
  world.createAabb(world.createBody(), { halfWidth: 20, halfHeight: 1 });
  for (let i = 0; i < 60; i++) {
    const body = world.createBody({ kind: "dynamic", position: [i % 10, 2 + i / 10] });
    world.createObb(body, { halfWidth: 0.5, halfHeight: 0.4 });
  }
  return world;
}

test("snapshots_of_every_scene_unpack_to_the_same_bytes_alone_and_against_an_earlier_one", () => {
  sceneNames(demo).forEach((name, index) => {
    const world = buildScene(demo, index);
    if (world.stats().bodies < 3000) {
      for (let i = 0; i < 30; i++) world.step();
      const base = world.snapshot();
      world.step();
      const snapshot = world.snapshot();
      const alone = world.pack(snapshot);
      const delta = world.pack(snapshot, base);
      assert.deepEqual(world.unpack(alone), snapshot, name);
      assert.deepEqual(world.unpack(delta, base), snapshot, name);
      assert.ok(delta.length < alone.length && alone.length < snapshot.length / 2, name);
    }
    world.close();
  });
});

test("packed_world_is_restored_from_deltas_step_by_step", () => {
  const world = heap();
  const other = heap();
  let last = world.snapshot();
  let there = last.slice();
  for (let i = 0; i < 40; i++) {
    world.step();
    const now = world.snapshot();
    there = other.unpack(world.pack(now, last), there);
    other.restore(there);
    assert.equal(other.hash(), world.hash());
    last = now;
  }
  world.close();
  other.close();
});

test("bytes_that_cannot_be_packed_or_unpacked_throw_and_do_no_harm", () => {
  const world = heap();
  const base = world.snapshot();
  world.step();
  const snapshot = world.snapshot();
  const delta = world.pack(snapshot, base);
  const hash = world.hash();
  const damaged = delta.slice();
  damaged[60] ^= 1;
  refusedWith(/damaged/, () => world.unpack(damaged, base));
  refusedWith(/cut short/, () => world.unpack(delta.subarray(0, delta.length - 1), base));
  refusedWith(/not the base/, () => world.unpack(delta));
  refusedWith(/not the base/, () => world.unpack(delta, snapshot));
  refusedWith(/too short/, () => world.unpack(new Uint8Array(0)));
  refusedWith(/no packed snapshot/, () => world.unpack(snapshot));
  refusedWith(/no whole snapshot/, () => world.pack(delta));
  refusedWith(/no whole snapshot/, () => world.pack(snapshot, delta));
  refusedWith(/no whole snapshot/, () => world.pack(new Uint8Array(0)));
  refusedWith(/not empty/, () => world.pack(snapshot, new Uint8Array(0)));
  refusedWith(/Uint8Array/, () => world.pack("a world"));
  refusedWith(/Uint8Array/, () => world.unpack(delta, "a world"));
  assert.equal(world.hash(), hash);
  assert.deepEqual(world.unpack(delta, base), snapshot);
  world.close();
  assert.throws(() => world.pack(snapshot), { code: "stale" });
  assert.throws(() => world.unpack(delta, base), { code: "stale" });
});

test("world_in_a_callback_neither_packs_nor_unpacks", () => {
  const world = heap();
  const snapshot = world.snapshot();
  const packed = world.pack(snapshot);
  let asked = 0;
  world.setListeners({
    prologue: () => {
      assert.throws(() => world.pack(snapshot), { code: "locked" });
      assert.throws(() => world.unpack(packed), { code: "locked" });
      asked++;
    },
  });
  for (let i = 0; i < 30; i++) world.step();
  assert.ok(asked > 0);
  world.close();
});
