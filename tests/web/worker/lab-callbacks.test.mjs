/** Tests the laboratory's scene of prologue and epilogues by the numbers that it shows. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { ROW } from "../../../web/public/scenes/lab_callbacks/row.js";
import { openSession } from "../../../web/tools/scenes.mjs";
import { thud } from "../support/package.mjs";

const engine = await thud.load();
const [GRAVITY, RADIUS, HEIGHT] = [10, 0.5, 4.5];

/** The scene with these values; steps are made until `ends` of the scene is true. */
async function played(values, ends) {
  const session = await openSession(engine, "lab_callbacks");
  const { scene } = session;
  Object.assign(scene.state, values);
  let steps = 0;
  while (!ends(scene) && steps++ < 2000) session.makeStep();
  assert.ok(steps < 2000, "it comes to an end");
  const { readings, figures, message } = scene.paint();
  const row = (control, name) => readings[control].find(([label]) => label === name)[1];
  const velocity = (name) => row("asks", name).replace(" m/s", "").split(", ").map(Number);
  return { session, scene, message, row, velocity, counts: figures.map(({ value }) => Number(value)) };
}

/** The ball has met the pad and left it again. */
const parted = ({ state }) => state.fall.asked > 0 && !state.isAsked;
const near = (value, wanted, tolerance) =>
  assert.ok(Math.abs(value - wanted) <= tolerance, `${value}, not ${wanted}`);
/** At what speed a ball lands that has fallen freely from the scene's height, to a step's gain. */
const LANDING = Math.sqrt(2 * GRAVITY * (HEIGHT - RADIUS));

test("rows_of_the_scene_are_those_of_the_package", () => {
  for (const [name, at] of Object.entries(ROW)) assert.equal(at, thud.LISTENED_ROW[name], name);
});

test("kicker_gives_the_speed_that_is_set_and_says_what_energy_it_decided", async () => {
  for (const speed of [4, 9, 16]) {
    const { scene, velocity, row, counts, message } = await played({ answer: "kicker", speed }, parted);
    const [before, after] = [velocity("Velocity before"), velocity("Velocity after")];
    near(before[1], -LANDING, GRAVITY / 60);
    near(after[1], speed, 0.2); // less what gravity took since
    near(after[0], before[0], 0.01);
    const { mass } = scene.world.bodyStateOf(scene.world.bodies()[1]);
    const decided = 0.5 * mass * (speed ** 2 - before[1] ** 2);
    near(parseFloat(row("asks", "Energy that was decided")), decided, 0.05 * Math.abs(decided) + 0.1);
    near(parseFloat(row("toWorld", "Impulse that it was told")), mass * (speed - before[1]), 0.1);
    // A slow ball is asked about again while it parts; then nothing is decided.
    const [asked] = counts;
    assert.ok(asked === 1 || (asked === 2 && speed === 4));
    assert.deepEqual(counts, [asked, 1, asked, asked, asked]);
    assert.match(message, new RegExp(`${speed} m/s away from the pad. Told .*the world, the ball, the pads`));
    scene.world.close();
  }
});

test("another_answer_drops_the_ball_anew", async () => {
  const { session, scene } = await played({ answer: "kicker" }, parted);
  assert.ok(scene.state.fall.after[1] > 10);
  session.do({ kind: "set", name: "answer", value: "veto" });
  session.makeStep();
  assert.deepEqual([scene.state.fall.asked, scene.state.fall.after], [0, null]);
  assert.ok(scene.world.positionOf(scene.world.bodies()[1])[1] > HEIGHT - 0.1);
  assert.match(scene.paint().message, /^The ball falls/);
  scene.world.close();
});

test("surface_that_the_prologue_sets_bounces_by_its_restitution", async () => {
  for (const restitution of [0.5, 1, 1.4]) {
    const { scene, velocity, row } = await played({ answer: "surface", friction: 0, restitution }, parted);
    const [before, after] = [velocity("Velocity before"), velocity("Velocity after")];
    near(after[1] / -before[1], restitution, 0.03);
    near(after[0], 2, 0.01);
    assert.equal(row("asks", "Energy that was decided"), "0.00 J");
    scene.world.close();
  }
});

test("veto_lets_the_ball_pass_and_no_epilogue_is_told", async () => {
  const below = ({ world }) => world.positionOf(world.bodies()[1])[1] < -1.5;
  const { scene, velocity, counts, message } = await played({ answer: "veto" }, below);
  const [asked, changed, ...told] = counts;
  assert.ok(asked > 5 && asked === changed);
  assert.deepEqual(told, [0, 0, 0]);
  assert.ok(velocity("Velocity after")[1] < -LANDING);
  assert.match(message, /veto.*No epilogue is told/);
  scene.world.close();
});

test("portal_turns_the_velocity_and_leads_elsewhere", async () => {
  const turns = { 0: ([x, y]) => [x, y], 90: ([x, y]) => [-y, x], 180: ([x, y]) => [-x, -y], 270: ([x, y]) => [y, -x] };
  for (const [turn, by] of Object.entries(turns)) {
    const { scene, velocity } = await played({ answer: "portal", turn: Number(turn) }, parted);
    const wanted = by(velocity("Velocity before"));
    velocity("Velocity after").forEach((value, k) => near(value, wanted[k], 0.2));
    near(scene.world.positionOf(scene.world.bodies()[1])[0], -3.5, 0.5);
    scene.world.close();
  }
});

test("without_a_prologue_the_surfaces_decide_and_the_epilogues_are_told", async () => {
  const told = ({ state }) => state.fall.ball > 20;
  const { scene, counts, message } = await played({ asks: false, answer: "veto" }, told);
  assert.deepEqual(counts.slice(0, 2), [0, 0]);
  assert.ok(counts.slice(2).every((count) => count === scene.state.fall.ball));
  near(scene.world.positionOf(scene.world.bodies()[1])[1], RADIUS, 0.01);
  assert.match(message, /Nobody is asked/);
  scene.world.close();
});

test("only_what_is_ticked_is_told", async () => {
  for (const [toWorld, toBall, toPads] of [[true, false, false], [false, true, false], [false, false, true]]) {
    const { scene, counts } = await played({ answer: "surface", toWorld, toBall, toPads }, parted);
    assert.deepEqual(counts.slice(2), [toWorld, toBall, toPads].map(Number));
    scene.world.close();
  }
});

test("time_is_slow_near_the_pad_alone_and_a_fall_is_the_same_twice", async () => {
  const steps = [];
  const slow = 10;
  const near_ = ({ world, state }) => {
    const gap = Math.abs(world.positionOf(world.bodies()[1])[1] - RADIUS);
    if (state.time > 0) steps.push([gap, world.stepSettings().timeStep]);
    return state.fall.asked > 0 && gap > 1;
  };
  const first = await played({ slow }, near_);
  // The step was chosen before the ball moved by it.
  for (const [gap, step] of steps) {
    if (gap < 0.5) near(step, 1 / 60 / slow, 1e-9);
    if (gap > 0.95) near(step, 1 / 60, 1e-9);
  }
  assert.ok(steps.filter(([, step]) => step < 0.01).length > slow);
  const second = await played({ slow }, near_);
  assert.deepEqual(second.scene.state, first.scene.state);
  assert.equal(second.scene.world.hash(), first.scene.world.hash());
  first.scene.world.close();
  second.scene.world.close();
});
