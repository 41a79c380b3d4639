/** Tests that thud and Box2D run the same scene, or that the page reports what Box2D lacks. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { openSession, SCENES } from "../../../web/tools/scenes.mjs";
import {
  addBall,
  addBox,
  addGround,
  box2d,
  heightOf,
  near,
  rivalry,
  step,
  withRival,
} from "../support/box2d.mjs";
import { demoWasm, thud } from "../support/package.mjs";

const { Box2DWorld, recordOf, missesOf, Ruler, setUp, watchWorlds } = rivalry;
const watched = await thud.load(demoWasm);
watchWorlds(watched);

/** As on the page: the rival receives every change while it runs. */
function beside(options, build, use) {
  withRival(options, build, (world, rival, built, known) => {
    known.forwardTo(rival);
    use(world, rival, built, known);
  });
}

const bothAt = (world, rival, body) => [world.bodyStateOf(body).position[1], heightOf(rival, body)];

test("whatever_a_world_can_do_is_followed_or_harmless_or_told", () => {
  const world = watched.createWorld();
  const methods = [];
  for (let of = Object.getPrototypeOf(world); of !== Object.prototype; of = Object.getPrototypeOf(of))
    for (const [name, { value }] of Object.entries(Object.getOwnPropertyDescriptors(of)))
      if (typeof value === "function" && name !== "constructor") methods.push(name);
  const inside = ["on", "onWorld", "refuse", "freeRoom", "shapeIds", "makeSolid"];
  const told = missesOf(new Set(methods.filter((name) => !inside.includes(name))));
  assert.deepEqual(told.sort(), [
    "explosions with cover",
    "listeners of contacts",
    "rolling resistance",
    "rules between kinds",
    "the scene’s own filter of pairs",
    "the texture of the ground",
    "tyres",
    "velocities that a prologue decides",
    "water",
    "what advance does",
    "what restore does",
    "wind",
  ]);
  // The recorder does not know this method.
  assert.deepEqual(missesOf(new Set(["flyAway"])), ["what flyAway does"]);
  world.close();
});

test("method_that_the_recorder_does_not_know_is_a_miss_once_it_is_called", () => {
  beside({}, (world) => addBall(world, [0, 0]), (world, rival) => {
    assert.deepEqual(rival.misses, []);
    world.setListeners({ prologue: () => {} });
    assert.deepEqual(rival.misses, ["listeners of contacts"]);
    world.setBodyEpilogue(world.bodies()[0], () => {});
    world.setCategoryEpilogue(1, () => {});
    assert.deepEqual(rival.misses, ["listeners of contacts"]);
  });
});

for (const [name, change, [least, most]] of [
  ["filter", (world, ball, shape) => world.setFilter(shape, { mask: 0 }), [-30, -2]],
  ["gravity_scale", (world, ball) => world.setGravityScale(ball, -1), [2, 30]],
  ["kind", (world, ball) => world.setKind(ball, "static"), [0.49, 0.51]],
  ["radius", (world, ball, shape) => world.setRadius(shape, 1.5), [1.49, 1.55]],
  ["sensor", (world, ball, shape) => world.setSensor(shape, true), [-30, -2]],
])
  test(`${name}_that_is_changed_while_both_run_is_changed_in_the_rival`, () => {
    const build = (world) => [addGround(world), addBall(world, [0, 0.5])];
    beside({}, build, (world, rival, [, ball]) => {
      step(world, rival, 30);
      change(world, ball, world.shapesOf(ball)[0]);
      step(world, rival, 60);
      for (const height of bothAt(world, rival, ball))
        assert.ok(height > least && height < most, `at ${height}`);
      if (name === "kind") {
        world.setTransform(ball, [0, 5]);
        step(world, rival, 30);
        for (const height of bothAt(world, rival, ball)) near(height, 5, 1e-6);
      }
      assert.deepEqual(rival.misses, []);
    });
  });

test("restitution_friction_and_belts_that_are_changed_while_both_run_act_in_both", () => {
  const build = (world) => {
    const ground = addGround(world, { kind: "flat" }, { friction: 0 });
    const ball = addBall(world, [-9, 5]);
    const box = addBox(world, [0, 0.5]);
    return { ground, ball, box };
  };
  beside({}, build, (world, rival, { ground, ball, box }) => {
    step(world, rival, 1);
    world.setRestitution(world.shapesOf(ball)[0], 1);
    world.setFriction(ground, 0.6);
    world.setSurfaceSpeed(ground, 2);
    step(world, rival, 110);
    const [thuds, rivals] = [world, rival].map((hands) => hands.bodyStateOf(ball));
    assert.ok(thuds.position[1] > 1.5 && rivals.position[1] > 1.5, "both bounce");
    for (const hands of [world, rival]) near(hands.bodyStateOf(box).velocity[0], 2, 0.05);
  });
});

test("damping_turning_and_weight_that_are_changed_while_both_run_act_in_both", () => {
  const build = (world) => [0, 5, 10].map((x) => addBox(world, [x, 0]));
  beside({ gravity: [0, 0] }, build, (world, rival, [damped, stiff, heavy]) => {
    world.setDamping(damped, 2, 3);
    world.setVelocity(damped, [4, 0], 4);
    world.setFixedRotation(stiff, true);
    world.setMass(heavy, { mass: 50, inertia: 9, center: [0.1, 0] });
    world.applyImpulse(heavy, [50, 0], [10.1, 0]);
    step(world, rival, 60);
    const both = (body) => [world, rival].map((hands) => hands.bodyStateOf(body));
    for (const { velocity, angularVelocity } of both(damped)) {
      near(velocity[0], 4 * Math.exp(-2), 0.05);
      near(angularVelocity, 4 * Math.exp(-3), 0.05);
    }
    for (const hands of [world, rival]) hands.applyImpulse(stiff, [0, 1], [5.5, 0]);
    step(world, rival, 1);
    for (const { angularVelocity } of both(stiff)) assert.equal(angularVelocity, 0);
    for (const { mass, inertia, velocity } of both(heavy)) {
      near(mass, 50, 1e-3);
      near(inertia, 9, 1e-3);
      near(velocity[0], 1, 1e-3);
    }
    assert.deepEqual(rival.misses, []);
  });
});

test("body_weighs_in_the_rival_what_it_was_set_to_before", () => {
  const build = (world) => {
    const boat = addBox(world, [0, 0]);
    world.setMass(boat, { mass: 90, inertia: 40, center: [0, -0.4] });
    return boat;
  };
  withRival({}, build, (world, rival, boat) => {
    const { mass, inertia, center } = rival.bodyStateOf(boat);
    near(mass, 90, 1e-3);
    near(inertia, 40, 1e-3);
    near(center[1], -0.4, 1e-6);
  });
});

test("locks_that_come_and_go_while_both_run_hold_in_both", () => {
  beside({}, (world) => addBall(world, [0, 0]), (world, rival, ball) => {
    step(world, rival, 1);
    world.setLocks(ball, { y: true });
    world.setVelocity(ball, [1, 0]);
    step(world, rival, 60);
    for (const hands of [world, rival]) {
      near(hands.bodyStateOf(ball).position[1], 0, 0.02);
      near(hands.bodyStateOf(ball).position[0], 1, 0.02);
    }
    world.setLocks(ball, {});
    step(world, rival, 30);
    for (const height of bothAt(world, rival, ball)) assert.ok(height < -1, `at ${height}`);
    assert.deepEqual(rival.misses, []);
  });
});

test("what_a_scene_tries_and_takes_back_is_not_done_to_the_rival", () => {
  beside({ gravity: [0, 0] }, (world) => addBall(world, [0, 0]), (world, rival, ball) => {
    world.whatIf(() => {
      world.setVelocity(ball, [9, 0]);
      world.setRule(1, 1, { kind: "ignore" });
      world.step();
    });
    assert.deepEqual(rival.bodyStateOf(ball).velocity, [0, 0]);
    assert.deepEqual(rival.misses, []);
  });
});

test("spring_of_a_wheels_turn_and_limits_of_a_weld_are_told", () => {
  const build = (world) => {
    const bodyA = world.createBody();
    const wheel = { kind: "wheel", bodyA, bodyB: addBall(world, [0, 0]), at: [0, 0] };
    world.createJoint({ ...wheel, turn: { motorForce: 3, motorSpeed: 1 } });
    const weld = { kind: "weld", bodyA, bodyB: addBall(world, [3, 0]), at: [3, 0] };
    return { wheel, weld, tie: world.createJoint({ ...weld, turn: { frequency: 2 } }) };
  };
  beside({}, build, (world, rival, { weld, tie }) => {
    assert.deepEqual(rival.misses, []);
    world.destroy(tie);
    const turn = { frequency: 2, motorForce: 5, motorSpeed: 1 };
    const driven = world.createJoint({ ...weld, turn });
    step(world, rival, 1);
    assert.deepEqual(rival.misses, ["motors of a weld (turn)"]);
    world.destroy(driven);
    step(world, rival, 1);
    assert.deepEqual(rival.misses, []);
  });
});

/** A ball that overlaps the ground; the two have different categories. */
function buildPair(world) {
  const ground = addGround(world, { kind: "flat" }, { category: 2 });
  return { ground, ball: addBall(world, [0, 0.2], { category: 4 }) };
}

for (const [name, allow] of [
  ["rule", (world) => world.setRule(2, 4, { kind: "ignore" })],
  ["one_way_rule", (world) => world.setRule(2, 4, { kind: "oneWay" })],
  ["filter", (world, pair) => world.setPairFilter((a, b) => !has(world, [a, b], pair.ball))],
  ["listener", (world) => world.setListeners({ prologue: vetoAll })],
])
  test(`overlap_leaves_out_what_a_${name}_lets_through`, () => {
    const build = (world) => {
      const pair = buildPair(world);
      allow(world, pair);
      // A box in the ground has no rule, so its overlap counts.
      pair.box = addBox(world, [5, 0.35]);
      return pair;
    };
    beside({ gravity: [0, 0] }, build, (world, rival) => {
      const ruler = new Ruler(world);
      step(world, rival, 1);
      ruler.sync();
      const overlap = ruler.penetration(world.poses(1, 0, 0), 0, 0);
      // The ball overlaps by 0.3, the box by at most 0.15; the listener lets both pass.
      if (name === "listener") assert.equal(overlap, 0);
      else assert.ok(overlap > 0.05 && overlap < 0.16, `overlap ${overlap}`);
      assert.equal(rival.misses.length, 1);
      ruler.close();
    });
  });

function has(world, shapes, body) {
  return shapes.some((shape) => world.bodyOf(shape).index === body.index);
}

// A prologue that lets all pairs of the rows pass.
function vetoAll(rows, count) {
  const { length, collide } = thud.LISTENED_ROW;
  for (let row = 0; row < count; row++) rows[row * length + collide] = 0;
}

test("overlap_counts_again_what_is_not_let_through_any_more", () => {
  const build = (world) => {
    const pair = buildPair(world);
    world.setRule(2, 4, { kind: "ignore" });
    return pair;
  };
  beside({ gravity: [0, 0] }, build, (world) => {
    const ruler = new Ruler(world);
    const overlap = () => {
      ruler.sync();
      return ruler.penetration(world.poses(1, 0, 0), 0, 0);
    };
    near(overlap(), 0, 1e-6);
    world.setRule(2, 4, null);
    near(overlap(), 0.3, 1e-3);
    const [shape] = world.shapesOf(world.bodies()[1]);
    world.setRadius(shape, 0.6);
    near(overlap(), 0.4, 1e-3);
    world.setFilter(shape, { mask: 0 });
    near(overlap(), 0, 1e-6);
    ruler.close();
  });
});

/** What Box2D lacks in each scene; all other scenes are the same in both. */
const LACKING = {
  boats: ["water"],
  clock: ["gears"],
  crane: ["greatest forces of springs of a slider (along)"],
  crates: ["rules between kinds"],
  flags: ["wind"],
  game_rollback: ["what restore does"],
  lab_callbacks: ["listeners of contacts"],
  lab_terrain: ["the texture of the ground"],
  meetings: ["rules between kinds"],
  planks: ["rules between kinds"],
  playground: ["gears"],
  textured: ["the texture of the ground"],
};

test("scenes_that_box2d_does_not_get_wholly_say_so_and_the_others_are_comparable", async () => {
  const found = {};
  for (const { name } of SCENES) {
    const session = await openSession(watched, name, {}, setUp);
    const known = recordOf(session.world);
    const rival = new Box2DWorld(box2d, session.world, known);
    known.forwardTo(rival);
    for (let i = 0; i < 5; i++) {
      session.makeStep();
      rival.sync();
    }
    if (rival.misses.length > 0) found[name] = rival.misses;
    rival.close();
    session.close();
  }
  assert.deepEqual(found, LACKING);
});
