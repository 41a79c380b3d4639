/**
 * Tests scenes with joints in the page's session: going back in time, and the states that it
 * reports.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { importTypeScript, random } from "../../../web/tools/scenes.mjs";
import { buildLinkage } from "../support/linkage.mjs";
import { thud } from "../support/package.mjs";

const { setUp } = await importTypeScript("src/worker/stage.ts");
const { inspect } = await importTypeScript("src/worker/inspect.ts");
const { USUAL } = await importTypeScript("src/page/url.ts");
const { JointFrames } = await importTypeScript("src/worker/joint-frames.ts");
const engine = await thud.load();

// Opens a session that runs the scene function.
function open(scene) {
  const request = { name: "own", seed: 0, choices: USUAL };
  const module = { default: scene, title: "", about: "", menu: null };
  return setUp(1, module, engine, request, () => "", { loadMover: async () => thud.Mover });
}

/** A scene that creates, changes, breaks and destroys joints while it runs. */
function busy({ createWorld }) {
  const { world, wall, links, weld } = buildLinkage(createWorld());
  const state = { made: null };
  const update = ({ step }) => {
    if (step % 40 === 10) {
      const [bodyA, bodyB] = [wall, links[(step / 10) % 6 | 0]];
      state.made = world.createJoint({ kind: "distance", bodyA, bodyB, breakForce: 20 });
    }
    if (step % 40 === 30 && state.made && world.isValid(state.made)) world.destroy(state.made);
    if (step === 100 && world.isValid(weld)) world.setJointBreaking(weld, { breakForce: 0 });
    if (step % 50 === 0) world.setDrive(world.joints()[4], "along", { frequency: 1 + step / 50 });
  };
  return { world, state, update };
}

/** The hash and all readable values of the joints at the present step. */
function told({ world, hash }) {
  const joints = world.joints();
  const states = joints.map((joint) => [world.jointStateOf(joint), world.jointOptionsOf(joint)]);
  return [hash, joints, states, world.jointEvents(), world.stepError()];
}

test("every_step_of_a_past_with_joints_comes_out_as_it_was", async () => {
  const session = await open(busy);
  const chance = random(5);
  const past = new Map();
  while (session.step < 240) {
    if (session.step % 8 === 0) past.set(session.step, told(session));
    if (chance(0, 1) < 0.1)
      session.do({ kind: "grab", slot: 3, anchor: [0, 0], x: chance(-5, 5), y: chance(0, 9) });
    if (chance(0, 1) < 0.1) session.do({ kind: "release" });
    if (session.step === 120) session.do({ kind: "explode", x: 4, y: 8, radius: 6, speed: 10 });
    session.makeStep();
  }
  const counts = new Set([...past.values()].map(([, joints]) => joints.length));
  assert.ok(counts.size > 1, "joints come and go");
  for (let i = 0; i < 30; i++) {
    const step = 8 * Math.floor(chance(0, 30));
    assert.ok(session.seek(step));
    assert.deepEqual(told(session), past.get(step), `step ${step}`);
  }
  const { hash, again } = session.rerun(200);
  assert.equal(again, hash);
  session.close();
});

test("past_before_the_first_joint_of_a_scene_is_gone_back_to", async () => {
  const session = await open(({ createWorld }) => {
    const world = createWorld();
    const [bodyA, bodyB] = ["static", "dynamic"].map((kind, i) => {
      const body = world.createBody({ kind, position: [i, 5] });
      world.createCircle(body, { radius: 0.3 });
      return body;
    });
    const update = ({ step }) => {
      if (step === 90) world.createJoint({ kind: "hinge", bodyA, bodyB, at: [0, 5] });
    };
    return { world, update };
  });
  const past = [];
  for (let i = 0; i < 180; i++) {
    past.push(session.hash.hash);
    session.makeStep();
  }
  for (const step of [150, 20, 120, 89, 91]) {
    assert.ok(session.seek(step));
    assert.equal(session.hash.hash, past[step]);
    assert.equal(session.world.joints().length, step > 90 ? 1 : 0);
  }
  session.close();
});

test("body_is_inspected_with_its_joints", async () => {
  const session = await open(({ createWorld }) => buildLinkage(createWorld()));
  for (let i = 0; i < 30; i++) session.makeStep();
  const { world, step } = session;
  const { joints } = inspect(world, step, 1);
  const [hinge, weld] = world.joints();
  const tie = (joint, other) => {
    const { kind, gap, angleGap, force, torque } = world.jointStateOf(joint);
    const bears = { force: Math.hypot(...force), torque: Math.abs(torque) };
    return { kind, other, enabled: true, gap, angleGap, ...bears };
  };
  const byKind = (a, b) => a.kind.localeCompare(b.kind);
  assert.deepEqual(joints.sort(byKind), [tie(hinge, 0), tie(weld, 2)]);
  assert.ok(joints[0].force > 1, "it hangs");
  session.close();
});

test("joints_are_looked_at_again_soon_after_a_look_that_took_long", () => {
  let looks = 0;
  const jointTable = () => {
    for (const start = performance.now(); performance.now() - start < 40; );
    looks++;
    return { rows: new Float32Array(0), handles: new Uint32Array(0) };
  };
  const frames = new JointFrames({ world: { jointTable }, pull: null });
  for (let i = 0; i < 30; i++) frames.add({}, false, false);
  assert.ok(looks > 1, "what breaks is drawn for long");
});
