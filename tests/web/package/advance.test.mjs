/**
 * Tests that a program which calls world.advance once per frame gets the same events and motion at
 * any display rate.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import * as thud from "../../../web/package/dist/node.js";

const engine = await thud.load();
const STEPS = 600;

/** Bouncing balls, one that a force pulls aside, and one in the wind. */
function makeGame() {
  const world = engine.createWorld({ gravity: [0, -10] });
  world.createBody({ shapes: thud.walls(8, 4.5, 1, { restitution: 0.9 }) });
  const balls = [-6, -4, -2, 0, 2, 4, 6].map((x, i) =>
    world.createBody({
      kind: "dynamic",
      position: [x, 0.3 * i],
      velocity: [i, 3],
      shapes: [thud.circle(0.4, { restitution: 0.9 })],
    }),
  );
  return { world, balls, begins: 0, hits: 0, before: 0, after: 0, inSteps: 0 };
}

const pull = ({ world, balls }) => {
  world.applyCenterForce(balls[0], [1.3, 0.2]);
  world.applyTorque(balls[0], 0.1);
};

function before(game) {
  game.before++;
  game.world.applyWind(game.balls[1], [-3, 1], { density: 0.5 });
}

function after(game) {
  game.after++;
  game.inSteps += game.world.events().begin.length;
}

function count(game) {
  const { begin, hit } = game.world.events();
  game.begins += begin.length;
  game.hits += hit.length;
}

test("events_and_forces_are_the_same_at_any_display_rate", () => {
  const steps = makeGame();
  for (let i = 0; i < STEPS; i++) {
    pull(steps);
    before(steps);
    steps.world.step();
    count(steps);
  }
  assert.ok(steps.begins > 50 && steps.hits > 20, `${steps.begins} begins, ${steps.hits} hits`);
  for (const rate of [20, 30, 60, 144]) {
    const game = makeGame();
    const calls = { before: () => before(game), after: () => after(game) };
    for (let made = 0; made < STEPS; ) {
      pull(game);
      made += game.world.advance(1 / rate, Math.min(4, STEPS - made), calls).steps;
      count(game);
    }
    assert.equal(game.world.hash(), steps.world.hash(), `at ${rate} pictures a second`);
    assert.deepEqual(
      [game.begins, game.hits, game.before, game.after, game.inSteps],
      [steps.begins, steps.hits, STEPS, STEPS, steps.begins],
      `at ${rate} pictures a second`,
    );
    game.world.close();
  }
  steps.world.close();
});

test("what_step_calls_throw_is_thrown_and_they_may_not_step", () => {
  const { world } = makeGame();
  const boom = new Error("boom");
  let calls = 0;
  const throws = () => {
    calls++;
    throw boom;
  };
  assert.throws(() => world.advance(3.5 / 60, 9, { before: throws }), (error) => error === boom);
  assert.equal(calls, 1);
  for (const forbidden of [
    () => world.step(),
    () => world.advance(1),
    () => world.restore(world.snapshot()),
    () => world.close(),
  ])
    assert.throws(() => world.advance(1 / 60, 1, { after: forbidden }), { code: "locked" });
  world.advance(1 / 60, 1, { after: () => world.setGravity([0, 0]) }); // edits other than steps are allowed
  const { steps } = world.advance(2 / 60);
  assert.equal(steps, 2);
  world.close();
});
