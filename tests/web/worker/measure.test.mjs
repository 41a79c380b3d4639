/**
 * Tests the page's measurements, which run in a worker, and its comparison of two engines, in Node.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { importTypeScript, openSession } from "../../../web/tools/scenes.mjs";
import { thud } from "../support/package.mjs";

// The page uses a fine clock only when it is isolated from other origins.
globalThis.self = globalThis;
globalThis.crossOriginIsolated = true;

const { Trial } = await importTypeScript("src/worker/measure-trial.ts");
const { measure } = await importTypeScript("src/worker/measure.ts");
const { findHoldings } = await importTypeScript("src/worker/measure-heavier.ts");
const { Tally } = await importTypeScript("src/panels/versus/tally.ts");
const { resultText } = await importTypeScript("src/panels/trade/result.ts");
const { MEANING, verdict } = await importTypeScript("src/panels/versus/words.ts");
const engine = await thud.load();

/**
 * A laboratory with simulated worlds: a step takes secondsOf(step from 1, size, number of the
 * session) seconds.
 */
function laboratoryWith(secondsOf) {
  let opened = 0;
  const open = async ({ size = 1 }) => {
    let steps = 0;
    const number = ++opened;
    const world = {
      engine,
      step: () => steps++,
      setSleeping() {},
      stats: () => ({
        bodies: size,
        stepSeconds: secondsOf(steps, size, number),
        heldBodies: 0,
        impacts: 0,
        directIslands: 0,
        softIslands: 0,
      }),
      events: () => ({ hit: [] }),
      bisectionLimit: () => Infinity,
      jointTable: () => ({ count: 0 }),
      shapeTableAwake: () => new Uint8Array(0),
      stepError: () => ({ penetrationMax: 0 }),
      poses: () => new Float32Array(0),
      shapeTable: () => ({ count: 0, rows: new Float32Array(0), handles: new Uint32Array(0) }),
    };
    return { world, scene: {}, size, timeStep: 1 / 60, lengthScale: 1, close() {} };
  };
  return { engine, box2d: null, open };
}

test("trial_of_a_scene_at_rest_keeps_its_bodies_awake", async () => {
  const session = await openSession(engine, "pyramid", { size: 5 });
  const trial = await Trial.open({ engine, box2d: null, open: async () => session }, {});
  for (let i = 0; i < 240; i++) trial.step();
  assert.equal(session.world.stats().awakeBodies, 15);
  trial.close();
});

test("heavier_tells_the_slowest_second_of_what_is_held_and_not_the_last", async () => {
  const slow = (step) => (step > 60 && step <= 130 ? 0.012 : 0.0001);
  const sizes = { means: "bodies", usual: 8, least: 1, most: 8 };
  const { holdings: [{ held }] } = await findHoldings(laboratoryWith(slow), {}, sizes, 60, () => {});
  assert.equal(held.bodies, 8);
  assert.ok(Math.abs(held.milliseconds - 12) < 1e-9, `${held.milliseconds} ms`);
});

/** The first session is the warm-up; each try of a size opens one more. */
test("heavier_tries_a_miss_again_and_what_it_held_once_more", async () => {
  const sizes = { means: "bodies", usual: 64, least: 1, most: 64 };
  const heaviest = async (secondsOf) => {
    const { holdings: [{ held, missed }] } = await findHoldings(laboratoryWith(secondsOf), {}, sizes, 60, () => {});
    return [held?.size ?? null, missed?.size ?? null];
  };
  const fast = 0.0001;
  const slow = 1;
  assert.deepEqual(await heaviest(() => fast), [64, null]);
  // One slow try at 16, the third session; 8 was the second.
  assert.deepEqual(await heaviest((_, size, number) => (number === 3 ? slow : fast)), [64, null]);
  // 64 is held once by chance and not again.
  const once = (_, size, number) => (size === 64 && number > 5 ? slow : fast);
  assert.deepEqual(await heaviest(once), [32, 64]);
  assert.deepEqual(await heaviest(() => slow), [null, 1]);
});

test("result_names_first_what_box2d_is_not_given_and_only_then_figures", () => {
  const row = { typical: 1, p99: 2, worst: 0.1, mean: 0.01, own: null, steps: 9 };
  const rows = [{ ...row, setting: { engine: "box2d", substeps: 4 } }];
  const result = { title: "Boats", setUp: "", browser: "", processors: 2, date: "2026-01-01T00:00Z" };
  const series = { timeStep: 1 / 60, bodies: 9, steps: 9, rows, withoutBox2D: "" };
  const told = resultText({ ...result, ...series, misses: ["water", "wind"] });
  assert.match(told, /^Not comparable: Box2D is not given water and wind\./);
  assert.match(resultText({ ...result, ...series, misses: [] }), /^Boats/);
});

test("p99_of_a_measured_series_is_without_the_scene_s_start", async () => {
  const atFirst = (step) => (step <= 6 ? 0.05 : 0.001);
  const { rows, steps } = await measure(laboratoryWith(atFirst), { choices: {} }, "", () => {});
  assert.equal(steps, 120);
  for (const { p99, typical } of rows)
    assert.ok(p99 < 1.01 && typical < 1.01, `${typical} and ${p99} ms`);
});

const compared = (penetration) => ({ penetration, energy: 0, bodies: 100 });

/** `count` steps of samples, with times and numbers of awake bodies of each engine. */
function sampled(from, count, [thudTime, awake], [box2dTime, box2dAwake], depths = [0.001, 0.004]) {
  return Array.from({ length: count }, (_, i) => ({
    step: from + i,
    milliseconds: thudTime,
    penetration: 0,
    awake,
    box2d: {
      milliseconds: box2dTime,
      awake: box2dAwake,
      since: 0,
      origin: [0, 0],
      compared: { thud: compared(depths[0]), box2d: compared(depths[1]) },
    },
  }));
}

const words = (tally) => verdict(tally.figures("thud"), tally.figures("box2d"), 1);

test("versus_compares_steps_in_which_both_engines_have_bodies_awake_and_says_who_sleeps", () => {
  const tally = new Tally(true);
  tally.add(sampled(1, 100, [1, 99], [2, 99]), 1 / 60);
  assert.equal(words(tally), "thud is 2.0 times as fast, and its overlap is 4.0 times smaller.");
  tally.add(sampled(101, 300, [0.01, 0], [2, 99]), 1 / 60);
  assert.equal(tally.figures("thud").typical, 1);
  assert.match(words(tally), /2\.0 times as fast.* All bodies sleep in thud now: only steps before/);
  tally.add(sampled(401, 300, [0.01, 0], [0.02, 0]), 1 / 60);
  assert.equal(tally.figures("box2d").typical, 2);
  assert.match(words(tally), /All bodies sleep in both now/);
});

test("versus_says_where_one_engine_has_fewer_bodies_awake", () => {
  const tally = new Tally(true);
  tally.add(sampled(1, 100, [1, 10], [2, 99]), 1 / 60);
  assert.match(words(tally), /Not the same work: 10 bodies are awake in thud, 99 in Box2D\.$/);
});

test("versus_of_a_scene_that_sleeps_from_the_start_says_so", () => {
  const tally = new Tally(true);
  tally.add(sampled(1, 100, [0.01, 0], [0.01, 0]), 1 / 60);
  assert.match(words(tally), /^All bodies sleep in both/);
});

test("versus_names_the_overlap_that_it_measures_and_calls_nobody_accurate", () => {
  const [even, less, none] = [[0.001, 0.001], [0.002, 0.001], [0, 0]];
  const times = "is 2.0 times as fast";
  const verdicts = [
    [1, 2, less, `thud ${times}, but Box2D’s overlap is 2.0 times smaller.`],
    [2, 1, less, `Box2D ${times}, and its overlap is 2.0 times smaller.`],
    [1, 1, even, "Both are about as fast, and their overlap is about the same."],
    [1, 2, none, `thud ${times}, and bodies overlap in neither.`],
    [0, 0, less, "Both take next to no time, and Box2D’s overlap is 2.0 times smaller."],
  ];
  for (const [one, other, depths, expected] of verdicts) {
    const tally = new Tally(true);
    tally.add(sampled(1, 100, [one, 9], [other, 9], depths), 1 / 60);
    assert.equal(words(tally), expected);
  }
  assert.match(MEANING, /[Oo]verlap is how deep the worst pair/);
  assert.doesNotMatch(MEANING, /accura/i);
});
