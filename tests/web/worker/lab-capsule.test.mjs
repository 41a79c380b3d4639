/**
 * Tests the numbers of the laboratory's capsules against computations of their own: distances of
 * points along segments, and a circle that goes along its way in small steps.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { near, numberOf, openLab, rowOf } from "../support/lab.mjs";
import { thud } from "../support/package.mjs";

const engine = await thud.load();

const open = (t, state) => openLab(engine, t, "lab_capsule", state);

const along = ([x1, y1], [x2, y2], part) => [x1 + part * (x2 - x1), y1 + part * (y2 - y1)];

/** The least value of a convex function of [0, 1], by cutting off a third again and again. */
function least(value) {
  let [from, to] = [0, 1];
  for (let i = 0; i < 80; i++) {
    const third = (to - from) / 3;
    if (value(from + third) <= value(to - third)) to -= third;
    else from += third;
  }
  return value(from);
}

/** The distance of a point from what the state has as B; below 0 within a circle or capsule. */
function pointFromB(state, [x, y]) {
  const { kindB, xB1, yB1, xB2, yB2, radiusB, widthB, heightB } = state;
  if (kindB === "circle") return Math.hypot(x - xB1, y - yB1) - radiusB;
  if (kindB === "capsule")
    return least((part) => {
      const [u, v] = along([xB1, yB1], [xB2, yB2], part);
      return Math.hypot(x - u, y - v);
    }) - radiusB;
  const angle = kindB === "obb" ? (state.angleB * Math.PI) / 180 : 0;
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const [dx, dy] = [x - xB1, y - yB1];
  const u = Math.max(0, Math.abs(c * dx + s * dy) - widthB / 2);
  const v = Math.max(0, Math.abs(c * dy - s * dx) - heightB / 2);
  return Math.hypot(u, v);
}

const segmentFromB = (state) => {
  const { xA1, yA1, xA2, yA2 } = state;
  return least((part) => pointFromB(state, along([xA1, yA1], [xA2, yA2], part)));
};

/** Places of A: apart from B, and so near that it overlaps without its segment touching B. */
const PLACES = [
  { xA1: -5, yA1: -2, xA2: -1, yA2: 3, radiusA: 0.7 },
  { xA1: -3, yA1: 3.5, xA2: 5, yA2: 3, radiusA: 0.4 },
  { xA1: -3, yA1: -3, xA2: 5, yA2: -2.6, radiusA: 1.6 },
  { xA1: -1, yA1: 2, xA2: -1, yA2: 2, radiusA: 2 },
];
const KINDS = ["circle", "aabb", "obb", "capsule"];

test("distance_is_that_of_the_segment_less_the_radius_for_every_kind", async (t) => {
  const scene = await open(t);
  const seen = { yes: 0, no: 0 };
  for (const kindB of KINDS)
    for (const place of PLACES) {
      Object.assign(scene.state, { ...place, kindB });
      const { state } = scene;
      const what = `${kindB} ${JSON.stringify(place)}`;
      const segment = segmentFromB(state);
      const paint = scene.paint();
      near(numberOf(paint, "closest", "Segment of A from B"), segment, 6e-4, what);
      near(numberOf(paint, "closest", "Distance, segment − radius"), segment - state.radiusA, 6e-4, what);
      const overlaps = segment <= state.radiusA ? "yes" : "no";
      assert.equal(rowOf(paint, "closest", "They overlap"), overlaps, what);
      seen[overlaps]++;
      const depth = rowOf(paint, "closest", "Depth");
      if (overlaps === "no") assert.equal(depth, "none");
      else near(Number(depth), state.radiusA - segment, 6e-4, what);
      // From the point of A it is that far along the normal to the point of B.
      const [n, a, b] = ["Normal, A to B", "Point of A", "Point of B"].map((name) =>
        rowOf(paint, "closest", name).split(", ").map(Number));
      near(Math.hypot(...n), 1, 0.01, what);
      for (const k of [0, 1]) near(a[k] + n[k] * (segment - state.radiusA), b[k], 0.03, what);
    }
  assert.ok(seen.yes > 2 && seen.no > 2, JSON.stringify(seen));
});

test("capsule_overlaps_exactly_what_its_circle_hits_on_the_way", async (t) => {
  const scene = await open(t);
  for (const kindB of KINDS)
    for (const place of PLACES) {
      Object.assign(scene.state, { ...place, kindB });
      const { xA1, yA1, xA2, yA2, radiusA } = scene.state;
      const parts = Array.from({ length: 20001 }, (_, i) => i / 20000);
      const hit = parts.find((part) =>
        pointFromB(scene.state, along([xA1, yA1], [xA2, yA2], part)) <= radiusA);
      const paint = scene.paint();
      const told = rowOf(paint, "way", "The circle hits B");
      assert.equal(rowOf(paint, "way", "The capsule overlaps B"), hit === undefined ? "no" : "yes");
      if (hit === undefined) assert.equal(told, "never");
      else near(Number(told.match(/[\d.]+/)[0]), hit, 1.5e-4, kindB);
    }
});

test("pointer_drags_an_end_a_whole_capsule_and_turns_a_box", async (t) => {
  const scene = await open(t);
  const { state } = scene;
  const drag = (from, to) => {
    for (const [[x, y], down] of [[from, false], [from, true], [to, true], [to, false]])
      scene.pointed({ x, y, down });
  };
  drag([state.xA2, state.yA2], [-2, 3]);
  assert.deepEqual([state.xA2, state.yA2], [-2, 3]);
  const { xA1, yA1 } = state;
  const [x, y] = along([xA1, yA1], [-2, 3], 0.5);
  drag([x, y], [x + 1, y - 1]);
  [[state.xA1, xA1 + 1], [state.yA1, yA1 - 1], [state.xA2, -1], [state.yA2, 2]].forEach(([now, wanted]) =>
    near(now, wanted, 1e-9, "the capsule has moved as one"));
  // The knob stands 0.7 beyond the end of the box.
  const reach = state.widthB / 2 + 0.7;
  const turn = (25 * Math.PI) / 180;
  drag([state.xB1 + reach * Math.cos(turn), state.yB1 + reach * Math.sin(turn)], [state.xB1, state.yB1 + 3]);
  near(state.angleB, 90, 1, "the box is turned");
  // Nothing leaves the picture.
  drag([state.xA2, state.yA2], [40, -40]);
  assert.deepEqual([state.xA2, state.yA2], [6, -5]);
});
