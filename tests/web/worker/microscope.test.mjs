/**
 * Tests the collision microscope: its formulas against figures worked out by hand, and what it
 * tells of collisions of a scene against what the engine does.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { importTypeScript, openSession } from "../../../web/tools/scenes.mjs";
import { geometry, thud } from "../support/package.mjs";

const engine = await thud.load();
const { resolve } = await importTypeScript("src/worker/collision.ts");
const { examine, listContacts, runToContact } = await importTypeScript("src/worker/microscope.ts");

const near = (actual, expected, tolerance = 1e-12, what = "") =>
  assert.ok(Math.abs(actual - expected) <= tolerance, `${what} ${actual}, not ${expected}`);
const still = (center) => ({ mass: 0, inertia: 0, center, velocity: [0, 0], spin: 0 });
const UP = [0, 1];

test("ball_on_a_floor_leaves_with_its_speed_times_the_restitution", () => {
  const ball = { mass: 2, inertia: 0.5, center: [0, 1], velocity: [0, -6], spin: 0 };
  const meeting = { point: [0, 0], normal: UP, restitution: 0.5, friction: 0 };
  const found = resolve(still([0, -1]), ball, meeting);
  assert.equal(found.normalSpeed, -6);
  assert.equal(found.response, 0.5);
  assert.equal(found.impulse, 18); // 1.5 · 6 · 2
  assert.equal(found.normalSpeedAfter, 3);
  assert.deepEqual(found.b.velocity, [0, 3]);
  assert.deepEqual(found.a.velocity, [0, 0]);
});

test("two_balls_head_on_keep_their_momentum", () => {
  const a = { mass: 1, inertia: 1, center: [-1, 0], velocity: [4, 0], spin: 0 };
  const b = { mass: 3, inertia: 1, center: [1, 0], velocity: [-2, 0], spin: 0 };
  const meeting = { point: [0, 0], normal: [1, 0], restitution: 0.5, friction: 0 };
  const found = resolve(a, b, meeting);
  near(found.impulse, 6.75); // 1.5 · 6 / (1 + 1/3)
  near(found.a.velocity[0], -2.75);
  near(found.b.velocity[0], 0.25);
  near(found.a.velocity[0] + 3 * found.b.velocity[0], 4 - 3 * 2);
  near(found.normalSpeedAfter, 3);
});

test("box_on_its_corner_is_turned_by_the_arm_of_the_impulse", () => {
  // A square of side 2 and mass 4: I = 4 · (4 + 4) / 12.
  const box = { mass: 4, inertia: 8 / 3, center: [0, 1], velocity: [0, -5.5], spin: 0 };
  const meeting = { point: [0.5, 0], normal: UP, restitution: 0.5, friction: 0 };
  const found = resolve(still([0, -1]), box, meeting);
  near(found.b.arm, 0.5);
  near(found.b.turning, 0.09375); // 0.25 / (8/3)
  near(found.response, 0.34375);
  near(found.impulse, 24);
  near(found.b.velocity[1], 0.5);
  near(found.b.spin, 4.5);
  near(found.normalSpeedAfter, 2.75);
});

test("friction_stops_a_sliding_ball_only_as_far_as_its_bound", () => {
  const ball = { mass: 1, inertia: 0.5, center: [0, 1], velocity: [3, -2], spin: 0 };
  const meet = (friction) =>
    resolve(still([0, -1]), ball, { point: [0, 0], normal: UP, restitution: 0, friction });
  const grips = meet(1); // k = 1 + 1/0.5: 3 / 3
  near(grips.frictionImpulse, -1);
  assert.equal(grips.slides, false);
  near(grips.b.velocity[0], 2);
  near(grips.b.spin, -2); // It rolls: the point at the floor stands still.
  const slides = meet(0.25);
  near(slides.frictionImpulse, -0.5);
  assert.equal(slides.slides, true);
  near(slides.b.velocity[0], 2.5);
  near(grips.tangentSpeedFinal, 0);
  near(slides.tangentSpeedFinal, 1.5); // 3 - 0.5 · 3
});

test("bodies_that_part_already_get_no_impulse", () => {
  const ball = { mass: 1, inertia: 0.5, center: [0, 1], velocity: [3, 2], spin: 0 };
  const meeting = { point: [0, 0], normal: UP, restitution: 1, friction: 1 };
  const found = resolve(still([0, -1]), ball, meeting);
  assert.deepEqual([found.impulse, found.frictionImpulse], [0, 0]);
  assert.deepEqual(found.b.velocity, [3, 2]);
});

const CHOICES = { quality: "default", substeps: 0, broadphase: "grid", maxError: 0 };

/** The first contact of the laboratory scene in a lane whose middle is x. */
async function meetIn(x, detection = "auto") {
  const session = await openSession(engine, "lab_microscope", { choices: { ...CHOICES, detection } });
  for (;;) {
    assert.ok(runToContact(session), "nothing met");
    for (const met of listContacts(session, null).contacts) {
      if (!met.began) continue;
      const { position } = session.world.bodyStateOf(session.world.bodyOf(met.b));
      if (Math.abs(position[0] - x) > 4) continue;
      const hash = session.world.hash();
      const found = examine(session, engine, geometry, met, session.step);
      assert.equal(session.world.hash(), hash, "the session is as before");
      assert.deepEqual(listContacts(session, null).contacts.find(({ a }) => a.index === met.a.index), met);
      return { session, met, found };
    }
  }
}

for (const detection of ["overlap", "continuous", "bisect", "swept"])
  test(`head_on_the_formula_is_what_the_engine_does_with_${detection}`, async () => {
    const { session, met, found } = await meetIn(-12, detection);
    const { formula, measured, bodyA, bodyB } = found;
    near(formula.normalSpeed, -12, 1e-6);
    near(found.bounce, 0.5, 1e-7);
    near(measured.normalBefore, -12, 1e-5);
    near(measured.normalAfter, 6, 2e-3, "v_n after");
    near(bodyA.after.velocity[0], formula.a.velocity[0], 2e-3, "a");
    near(bodyB.after.velocity[0], formula.b.velocity[0], 2e-3, "b");
    near(found.reported, 12, 1e-4);
    near(met.impulse, formula.impulse, 1e-3, "impulse in the list");
    const { resolution } = found;
    assert.equal(resolution.found, true);
    assert.ok(resolution.impact !== null && resolution.time <= resolution.impact + 1e-9);
    near(resolution.time, resolution.impact, 2 ** -19);
    // Circles of radius 0.6 that meet at the rate of 12 m/s from 5 m apart: after 3.8 m.
    near((session.step - (found.arriving ? 1 : 2) + resolution.impact) / 60, 3.8 / 12, 1e-4, "when");
    session.close();
  });

test("ball_on_a_slope_meets_it_along_the_slope_s_normal", async () => {
  const { session, found } = await meetIn(-4);
  near(Math.abs(found.normal[0]), Math.sin(0.4), 1e-5);
  near(found.friction, 0.4, 1e-6);
  near(found.measured.normalAfter, -0.5 * found.measured.normalBefore, 0.2, "v_n after");
  near(found.formula.normalSpeedAfter, -0.5 * found.formula.normalSpeed, 1e-9);
  session.close();
});

test("box_on_its_corner_turns_as_the_formula_says", async () => {
  const { session, found } = await meetIn(4);
  const box = found.bodyB;
  assert.ok(Math.abs(found.formula.b.arm) > 0.1, "the impulse has an arm");
  assert.ok(Math.abs(found.formula.b.spin) > 1, "it turns");
  // Friction at the corner takes away much of the speed that the normal impulse gave.
  assert.ok(found.formula.normalSpeedFinal < 0.5 * found.formula.normalSpeedAfter);
  near(box.after.spin, found.formula.b.spin, 0.15 * Math.abs(found.formula.b.spin), "spin");
  session.close();
});

test("what_met_is_listed_with_the_largest_impulse_first_and_by_body", async () => {
  const { session, met } = await meetIn(12);
  const { contacts, count } = listContacts(session, null);
  assert.equal(contacts.length, count);
  for (let i = 1; i < contacts.length; i++)
    assert.ok(contacts[i].impulse <= contacts[i - 1].impulse);
  const ofBody = listContacts(session, met.bodyB).contacts;
  assert.ok(ofBody.length > 0);
  assert.ok(ofBody.every(({ bodyA, bodyB }) => [bodyA, bodyB].includes(met.bodyB)));
  session.close();
});

test("step_that_was_not_made_and_a_shape_that_is_gone_are_refused", async () => {
  const { session, met } = await meetIn(-12);
  const hash = session.world.hash();
  assert.throws(() => examine(session, engine, geometry, met, session.step + 1), /not been made/);
  assert.throws(() => examine(session, engine, geometry, met, 0), /not kept/);
  const gone = { ...met, a: { ...met.a, generation: met.a.generation + 5 } };
  assert.throws(() => examine(session, engine, geometry, gone, session.step), /made or removed/);
  assert.equal(session.world.hash(), hash);
  session.close();
});

test("ball_that_rests_on_ground_is_taken_apart_too", async () => {
  const session = await openSession(engine, "slopes", { size: 6 });
  for (let i = 0; i < 30; i++) session.makeStep();
  const { contacts } = listContacts(session, null);
  assert.ok(contacts.length >= 8, `${contacts.length}`);
  for (const met of contacts) {
    const found = examine(session, engine, geometry, met, session.step);
    near(Math.hypot(...found.normal), 1, 1e-9);
    assert.ok(Math.abs(found.separation) < 0.01, `${found.separation}`);
    assert.equal(found.bounce, 0);
  }
  session.close();
});

test("earlier_step_gives_the_same_numbers_and_the_present_comes_back", async () => {
  const { session, met, found } = await meetIn(-12);
  const { step } = session;
  for (let i = 0; i < 30; i++) session.makeStep();
  const hash = session.world.hash();
  assert.deepEqual(examine(session, engine, geometry, met, step), found);
  assert.deepEqual([session.step, session.world.hash()], [step + 30, hash]);
  session.close();
});
