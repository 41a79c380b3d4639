/**
 * Tests restoring earlier states in the npm package: worlds by snapshots, movers by their state.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { buildScene, demoWasm, sceneNames, thud } from "../support/package.mjs";

const engine = await thud.load();
const demo = await thud.load(demoWasm);

function throwsCode(code, act) {
  assert.throws(act, (error) => error instanceof thud.ThudError && error.code === code);
}

function refusedWith(pattern, act) {
  assert.throws(act, (error) => error.code === "invalid" && pattern.test(error.message));
}

/** The hash and events of each step. */
function walk(world, steps) {
  return Array.from({ length: steps }, () => {
    world.step();
    return [world.hash(), world.events()];
  });
}

/** Hills with balls and boxes above them. */
function yard(options = {}) {
  const world = engine.createWorld(options);
  const points = Array.from({ length: 33 }, (_, i) => [i - 16, (i % 5) * 0.3]);
  const ground = world.createTerrain(world.createBody(), { kind: "irregular", points });
  const bodies = Array.from({ length: 20 }, (_, i) => {
    const body = world.createBody({ kind: "dynamic", position: [(i % 5) * 0.4, 2 + i] });
    if (i % 2 === 0) world.createCircle(body, { radius: 0.4 });
    else world.createObb(body, { halfWidth: 0.5, halfHeight: 0.3 });
    return body;
  });
  return { world, ground, bodies };
}

test("every_scene_restored_goes_the_same_way_in_the_same_and_another_world", () => {
  sceneNames(demo).forEach((name, index) => {
    const world = buildScene(demo, index);
    if (world.stats().bodies < 3000) {
      const other = buildScene(demo, index);
      for (let i = 0; i < 30; i++) world.step();
      const snapshot = world.snapshot();
      const first = walk(world, 30);
      for (const one of [world, other]) {
        one.restore(snapshot);
        assert.deepEqual(walk(one, 30), first, name);
      }
      other.close();
    }
    world.close();
  });
});

test("edits_after_the_snapshot_are_undone_and_give_the_same_handles_again", () => {
  const { world, ground, bodies } = yard();
  for (let i = 0; i < 60; i++) world.step();
  const snapshot = world.snapshot();
  const play = () => {
    world.dig(ground, [0, 0.5], 1.5);
    world.destroy(bodies[3]);
    const ball = world.createBody({ kind: "dynamic", position: [0, 9] });
    world.createCircle(ball, { radius: 0.6 });
    return [ball, walk(world, 40)];
  };
  const first = play();
  assert.equal(world.isValid(bodies[3]), false);
  world.restore(snapshot);
  assert.equal(world.isValid(bodies[3]), true);
  assert.equal(world.isValid(first[0]), false);
  assert.deepEqual(play(), first);
  world.close();
});

test("snapshot_is_a_copy_that_survives_growing_memory_and_its_world", () => {
  const { world } = yard();
  const snapshot = world.snapshot();
  const kept = snapshot.slice();
  const first = walk(world, 50);
  const crowd = engine.createWorld();
  for (let i = 0; i < 20000; i++) crowd.createBody({ kind: "dynamic", position: [i, 0] });
  crowd.close();
  world.close();
  assert.deepEqual(snapshot, kept);
  const other = engine.createWorld();
  other.restore(snapshot);
  assert.deepEqual(walk(other, 50), first);
  other.close();
});

test("bytes_that_are_no_snapshot_for_the_world_throw_and_change_nothing", () => {
  const { world } = yard();
  for (let i = 0; i < 30; i++) world.step();
  const snapshot = world.snapshot();
  const first = walk(world, 20);
  world.restore(snapshot);
  const damaged = snapshot.slice();
  damaged[damaged.length >> 1] ^= 4;
  refusedWith(/damaged/, () => world.restore(damaged));
  refusedWith(/cut short/, () => world.restore(snapshot.subarray(0, snapshot.length - 8)));
  refusedWith(/too short/, () => world.restore(new Uint8Array(0)));
  refusedWith(/no snapshot/, () => world.restore(new Uint8Array(snapshot.length)));
  refusedWith(/Uint8Array/, () => world.restore("a world"));
  const pixels = engine.createWorld({ lengthScale: 64 });
  refusedWith(/length scale/, () => pixels.restore(snapshot));
  pixels.close();
  const silent = engine.createWorld({ contactEvents: false });
  refusedWith(/other settings/, () => silent.restore(snapshot));
  silent.close();
  assert.deepEqual(walk(world, 20), first);
  world.close();
  throwsCode("stale", () => world.snapshot());
  throwsCode("stale", () => world.restore(snapshot));
});

/** A mover on a platform that moves up and to the right. */
function lift() {
  const world = engine.createWorld();
  const platform = world.createBody({ kind: "kinematic", velocity: [2, 1] });
  world.createAabb(platform, { halfWidth: 3, halfHeight: 0.5 });
  const mover = new thud.Mover(world, {
    shape: { kind: "circle", radius: 0.5 },
    position: [0, 1.2],
  });
  return { world, mover };
}

function ride({ world, mover }, steps) {
  return Array.from({ length: steps }, () => {
    world.step();
    const { ground, position, velocity } = mover.move([0.5, -1], 1 / 60);
    return { ground, position, velocity };
  });
}

test("mover_is_not_put_at_numbers_that_are_not_finite", async () => {
  const world = (await thud.load()).createWorld();
  const shape = { kind: "circle", radius: 0.5 };
  const mover = new thud.Mover(world, { shape, position: [3, 4] });
  const state = mover.state();
  const refused = { name: "ThudError", code: "invalid", message: /must be finite/ };
  assert.throws(() => mover.place([NaN, 0]), refused);
  for (const wrong of [{ position: [0, Infinity] }, { rise: NaN }, { drift: -Infinity }])
    assert.throws(() => mover.restore({ ...state, ...wrong }), refused);
  const ground = { normal: [0, 1], shape: {}, body: {}, point: [0, NaN], place: [0, 0], cosine: 1, sine: 0 };
  assert.throws(() => mover.restore({ ...state, ground }), refused);
  assert.deepEqual(mover.state(), state, "nothing has changed");
  mover.close();
  world.close();
});

test("mover_restored_with_its_world_rides_the_same_way", () => {
  const one = lift();
  const airborne = [one.world.snapshot(), structuredClone(one.mover.state())];
  assert.equal(airborne[1].ground, null);
  const all = ride(one, 30);
  const [world, mover] = [one.world.snapshot(), structuredClone(one.mover.state())];
  assert.notEqual(mover.ground, null);
  const first = ride(one, 30);
  assert.ok(first[29].position[0] > all[29].position[0] + 0.9);
  one.world.restore(world);
  one.mover.restore(mover);
  assert.deepEqual(one.mover.state(), mover);
  assert.deepEqual(ride(one, 30), first);
  one.world.restore(airborne[0]);
  one.mover.restore(airborne[1]);
  assert.deepEqual(ride(one, 30), all);
  one.mover.close();
  one.world.close();
});
