/**
 * Tests the laboratory's scene of priced detections: its errors against closed forms that are worked
 * out here, and against those that were measured for docs/catalogue.md.
 */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { importTypeScript, openSession } from "../../../web/tools/scenes.mjs";
import { createMotion, errorOf } from "../../../web/public/scenes/lab_prices/motions.js";
import { thud } from "../support/package.mjs";

const engine = await thud.load();
const { describe, setUp } = await importTypeScript("src/worker/stage.ts");
const { USUAL } = await importTypeScript("src/page/url.ts");

const rowOf = (paint, control, name) =>
  paint.readings[control].find(([label]) => label === name)?.[1];
const numberOf = (...asked) => Number.parseFloat(rowOf(...asked));
const near = (actual, expected, tolerance, what) =>
  assert.ok(Math.abs(actual - expected) <= tolerance, `${what}: ${actual}, not ${expected}`);

const { prices } = JSON.parse(readFileSync(new URL("../../../docs/catalogue.json", import.meta.url)));

/** The catalogue was measured by native worlds, whose walls are rounded otherwise. */
const NEAR = 0.01;

for (const motion of ["shuttle", "hop"])
  test(`errors_of_${motion}_are_those_of_the_catalogue`, () => {
    for (const { detection, rate, error } of prices.filter(({ scene }) => scene === motion)) {
      const made = createMotion(engine, motion, detection, rate);
      for (let i = 0; i < 2 * rate; i++) made.world.step();
      near(errorOf(made, motion, 2), error, NEAR * error, `${detection} at ${rate}`);
      made.world.close();
    }
  });

/** Where a ball of the shuttle is, by reflecting it from wall to wall. */
function shuttleAt(ball, time) {
  let [x, left, speed] = [0, (3 + 0.11 * ball) * time, 1];
  while (left > 0) {
    const room = speed > 0 ? 2 - x : x;
    const way = Math.min(room, left);
    x += speed * way;
    left -= way;
    speed = -speed;
  }
  return 0.1 + x;
}

test("errors_told_are_the_mean_distance_of_the_balls_from_the_closed_form", async () => {
  const session = await openSession(engine, "lab_prices");
  for (let i = 0; i < 90; i++) session.makeStep();
  const time = 90 / 60;
  for (const name of ["overlap", "swept"]) {
    const world = engine.createWorld({ gravity: [0, 0], detection: name, sleeping: false });
    const material = { friction: 0, restitution: 1 };
    for (const x of [-1, 3.2])
      world.createAabb(world.createBody({ position: [x, 0] }), { halfWidth: 1, halfHeight: 1000, ...material });
    const balls = Array.from({ length: 64 }, (_, i) => {
      const ball = world.createBody({ kind: "dynamic", position: [0.1, i], velocity: [3 + 0.11 * i, 0] });
      world.createCircle(ball, { radius: 0.1, group: -1, ...material });
      return ball;
    });
    for (let i = 0; i < 90; i++) world.step();
    const sum = balls.reduce((total, ball, i) => {
      const [x, y] = world.bodyStateOf(ball).position;
      return total + Math.hypot(x - shuttleAt(i, time), y - i);
    }, 0);
    near(numberOf(session.paint, "errors", name), (1000 * sum) / 64, 0.006, name);
    world.close();
  }
  assert.equal(rowOf(session.paint, "ends", "overlap"), "not yet");
  session.close();
});

test("errors_at_the_end_stay_and_going_back_in_time_shows_what_was_there", async () => {
  const session = await openSession(engine, "lab_prices");
  session.do({ kind: "set", name: "motion", value: "hop" });
  session.do({ kind: "set", name: "rate", value: "120" });
  const seen = [];
  for (let i = 0; i < 130; i++) {
    session.makeStep();
    seen.push(JSON.stringify(session.paint));
  }
  const known = prices.filter(({ scene, rate }) => scene === "hop" && rate === 120);
  for (const { detection, error } of known)
    near(numberOf(session.paint, "ends", detection), 1000 * error, 1000 * NEAR * error + 0.006, detection);
  assert.ok(session.seek(60));
  assert.equal(JSON.stringify(session.paint), seen[59]);
  assert.ok(session.seek(128));
  assert.equal(JSON.stringify(session.paint), seen[127]);
  session.close();
});

test("scene_tells_which_panel_opens_with_it_and_one_that_is_not_there_is_refused", async () => {
  const request = { name: "own", seed: 0, choices: USUAL };
  const open = (panel) => {
    const scene = ({ createWorld }) => ({ world: createWorld(), ...(panel && { panel }) });
    return setUp(1, { default: scene }, engine, request, () => "", { loadMover: async () => thud.Mover });
  };
  for (const panel of ["trade", "contacts", undefined]) {
    const session = await open(panel);
    assert.equal(describe(session).panel, panel ?? null);
    session.close();
  }
  await assert.rejects(open("drawer"), /panel is one of trade, contacts/);
});
