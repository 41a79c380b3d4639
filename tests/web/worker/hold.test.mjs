/**
 * Tests dragging in the page: a joint pulls the body, wakes it, pulls no harder than in proportion
 * to its weight, and is removed cleanly.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { importTypeScript, openSession } from "../../../web/tools/scenes.mjs";
import { near } from "../support/joints.mjs";
import { thud } from "../support/package.mjs";

const { setUp } = await importTypeScript("src/worker/stage.ts");
const { USUAL } = await importTypeScript("src/page/url.ts");
const engine = await thud.load();

/**
 * Opens a session with bodies of the test: `build` gets the world, and `use` gets its return value.
 */
async function withSession(build, use, { update, options = {} } = {}) {
  let built;
  const module = {
    default({ createWorld }) {
      const world = createWorld(options);
      built = build(world);
      return { world, update: update && (() => update(world, built)) };
    },
  };
  const request = { name: "own", seed: 0, choices: USUAL };
  const loaders = { loadMover: async () => thud.Mover };
  const session = await setUp(1, module, engine, request, () => "", loaders);
  use(session, built);
  session.close();
}

function ballOnGround(world, x = 0) {
  if (world.stats().bodies === 0) world.createTerrain(world.createBody(), { kind: "flat" });
  const body = world.createBody({ kind: "dynamic", position: [x, 0.5] });
  world.createCircle(body, { radius: 0.5 });
  return body;
}

const grab = (session, { index }, [x, y], anchor = [0, 0]) =>
  session.do({ kind: "grab", slot: index, anchor, x, y });

function run(session, steps) {
  for (let i = 0; i < steps; i++) session.makeStep();
}

test("sleeping_body_is_woken_and_follows", () =>
  withSession(ballOnGround, (session, ball) => {
    run(session, 240);
    assert.equal(session.world.bodyStateOf(ball).awake, false);
    grab(session, ball, [0, 0.5]);
    session.do({ kind: "drag", x: 2, y: 4 });
    run(session, 60);
    const [x, y] = session.world.bodyStateOf(ball).position;
    near(x, 2, 0.02);
    near(y, 4 - 10 / (10 * Math.PI) ** 2, 0.02);
  }));

test("body_far_from_the_pointer_comes_straight", () =>
  withSession(
    (world) => ballOnGround(world),
    (session, ball) => {
      grab(session, ball, [0, 0.5]);
      session.do({ kind: "drag", x: 8, y: 2.5 });
      run(session, 12);
      const [x, y] = session.world.bodyStateOf(ball).position;
      assert.ok(x > 1 && x < 7, `${x}`);
      near((y - 0.5) / x, 0.25, 0.02);
    },
    { options: { gravity: [0, 0] } },
  ));

test("light_body_does_not_drag_a_heavy_one_along_that_it_is_tied_to", () =>
  withSession(
    (world) => {
      const light = ballOnGround(world);
      const heavy = world.createBody({ kind: "dynamic", position: [-5, 2] });
      world.createAabb(heavy, { halfWidth: 2, halfHeight: 2, density: 100 });
      world.createJoint({ kind: "distance", bodyA: heavy, bodyB: light, from: [-3, 0.5], to: [0, 0.5] });
      return { light, heavy };
    },
    (session, { light, heavy }) => {
      run(session, 30);
      const [start] = session.world.bodyStateOf(heavy).position;
      grab(session, light, [0, 0.5]);
      session.do({ kind: "drag", x: 8, y: 0.5 });
      run(session, 120);
      near(session.world.bodyStateOf(heavy).position[0], start, 0.01);
    },
  ));

test("hand_is_gone_when_it_lets_go_when_its_body_is_and_when_it_takes_another", () =>
  withSession(
    (world) => [0, 3].map((x) => ballOnGround(world, x)),
    (session, [first, second]) => {
      const { world } = session;
      const held = () => [world.joints().length, world.stats().bodies];
      grab(session, first, [0, 0.5]);
      run(session, 2);
      assert.deepEqual(held(), [1, 4]);
      grab(session, second, [3, 0.5]);
      run(session, 2);
      assert.deepEqual(held(), [1, 4]);
      session.do({ kind: "release" });
      run(session, 2);
      assert.deepEqual(held(), [0, 3]);
      grab(session, first, [0, 0.5]);
      run(session, 1);
      world.destroy(first);
      run(session, 2);
      assert.equal(session.pull, null);
      assert.deepEqual(held(), [0, 2]);
    },
  ));

test("past_in_which_a_body_was_held_comes_out_the_same", () =>
  withSession(ballOnGround, (session, ball) => {
    run(session, 10);
    grab(session, ball, [0, 0.5], [0.2, 0.1]);
    const hashes = [];
    for (let i = 0; i < 150; i++) {
      if (i % 7 === 0) session.do({ kind: "drag", x: 0.1 * i, y: 2 + 0.01 * i });
      if (i === 100) session.do({ kind: "release" });
      hashes.push(session.hash);
      session.makeStep();
    }
    for (const { step, hash } of [hashes[80], hashes[5], hashes[140]]) {
      assert.ok(session.seek(step));
      assert.equal(session.hash.hash, hash, `step ${step}`);
    }
    const { hash, again } = session.rerun(100);
    assert.equal(again, hash);
  }));

test("what_does_not_move_cannot_be_taken", async () => {
  const session = await openSession(engine, "tall_stack");
  const { world } = session;
  const { rows, count } = world.shapeTable();
  const fixed = Array.from({ length: count }, (_, i) => 10 * i).find((at) => rows[at + 2] === 0);
  session.do({ kind: "grab", slot: rows[fixed], anchor: [0, 0], x: 0, y: 0 });
  assert.equal(session.pull, null);
  assert.equal(world.joints().length, 0);
  session.close();
});
