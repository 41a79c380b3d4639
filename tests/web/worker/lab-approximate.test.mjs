/**
 * Tests the numbers of the laboratory's approximated polygon against areas and distances that are
 * sampled here, point by point, from the pieces that are drawn.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { yOf } from "../../../web/public/scenes/lab_approximate/picture.js";
import { near, numberOf, openLab, rowOf } from "../support/lab.mjs";
import { thud } from "../support/package.mjs";

const engine = await thud.load();

const open = (t, state) => openLab(engine, t, "lab_approximate", state);

const cornersOf = (state) => Array.from({ length: 12 }, (_, i) => [state[`x${i}`], state[`y${i}`]]);

/** Whether a point is in a polygon, by the edges that a ray to the right crosses. */
function isInside(points, x, y) {
  let inside = false;
  points.forEach(([x1, y1], i) => {
    const [x2, y2] = points[(i + 1) % points.length];
    if (y1 > y !== y2 > y && x < x1 + ((y - y1) / (y2 - y1)) * (x2 - x1)) inside = !inside;
  });
  return inside;
}

/** How far a point is outside of a piece as it is drawn; 0 inside. */
function fromPiece({ kind, x, y, radius, halfWidth, halfHeight, angle }, px, py) {
  const [dx, dy] = [px - x, py - y];
  if (kind === "circle") return Math.max(0, Math.hypot(dx, dy) - radius);
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const u = Math.max(0, Math.abs(c * dx + s * dy) - halfWidth);
  const v = Math.max(0, Math.abs(c * dy - s * dx) - halfHeight);
  return Math.hypot(u, v);
}

function fromPolygon(points, x, y) {
  if (isInside(points, x, y)) return 0;
  return Math.min(...points.map(([x1, y1], i) => {
    const [x2, y2] = points[(i + 1) % points.length];
    const [dx, dy] = [x2 - x1, y2 - y1];
    const part = Math.min(1, Math.max(0, ((x - x1) * dx + (y - y1) * dy) / (dx * dx + dy * dy)));
    return Math.hypot(x - x1 - part * dx, y - y1 - part * dy);
  }));
}

/** The pieces as they are drawn: filled circles and boxes of their ink. */
const piecesOf = ({ marks }) => marks.filter(({ ink, filled }) => ink === "rival" && filled);

const GRID = 0.04;

for (const [kinds, count] of [["both", 3], ["boxes", 12], ["circles", 8]])
  test(`areas_and_distance_of_${count}_${kinds}_are_those_of_points_sampled`, async (t) => {
    const scene = await open(t, { kinds, count });
    const paint = scene.paint();
    const points = cornersOf(scene.state);
    const pieces = piecesOf(paint);
    assert.ok(pieces.length > 0 && pieces.length <= count);
    const circles = pieces.filter(({ kind }) => kind === "circle").length;
    assert.equal(numberOf(paint, "missed", "Circles"), circles);
    assert.equal(numberOf(paint, "missed", "Boxes"), pieces.length - circles);
    let [area, missed, extra, twice, furthest] = [0, 0, 0, 0, 0];
    for (let x = -9; x < 9; x += GRID)
      for (let y = -5; y < 8; y += GRID) {
        const inside = isInside(points, x, y);
        const away = pieces.map((piece) => fromPiece(piece, x, y));
        const covering = away.filter((one) => one === 0).length;
        if (inside) area++;
        if (inside && covering === 0) missed++;
        if (!inside && covering > 0) extra++;
        twice += Math.max(0, covering - 1);
        if (inside) furthest = Math.max(furthest, Math.min(...away));
        else if (covering > 0) furthest = Math.max(furthest, fromPolygon(points, x, y));
      }
    near(numberOf(paint, "missed", "Area missed"), (100 * missed) / area, 0.3, "missed");
    near(numberOf(paint, "missed", "Area outside of the polygon"), (100 * extra) / area, 0.3, "outside");
    near(numberOf(paint, "missed", "Area that pieces share"), (100 * twice) / area, 0.5, "shared");
    // The engine tells a bound, at most a sixteenth and a five-hundredth of the width above it.
    const told = numberOf(paint, "missed", "Distance missed, at most");
    assert.ok(told >= furthest - 1e-3, `${told} below ${furthest}`);
    const room = Math.max(furthest / 16, 11.5 / 500);
    assert.ok(told <= furthest + room + 2 * GRID, `${told} far above ${furthest}`);
  });

test("curve_grows_from_picture_to_picture_and_never_rises_with_the_count", async (t) => {
  const scene = await open(t, { kinds: "circles", count: 4 });
  const counts = [1, 2, 4, 8, 16, 24];
  const told = (paint) => counts.map((n) => rowOf(paint, "curve", `${n} ${n === 1 ? "piece" : "pieces"}`));
  assert.ok(told(scene.paint()).includes("being searched"));
  let paint = null;
  for (const end = performance.now() + 30_000; performance.now() < end; ) {
    paint = scene.paint();
    if (!told(paint).includes("being searched")) break;
    await new Promise((done) => setTimeout(done, 2));
  }
  const rows = told(paint).map((text) => text.match(/[\d.]+/g).map(Number));
  rows.slice(1).forEach(([area, distance], i) => {
    assert.ok(area <= rows[i][0] && distance <= rows[i][1], `${counts[i + 1]}: ${area}, ${distance}`);
  });
  assert.ok(rows.at(-1)[0] < 0.5 * rows[0][0], "many circles miss less");
  // The row of a count is what the slider's count tells, and the curve is drawn through it.
  rows.forEach(([area, distance], i) => {
    scene.state.count = counts[i];
    const now = scene.paint();
    const sum = numberOf(now, "missed", "Area missed") + numberOf(now, "missed", "Area outside of the polygon");
    near(area, sum, 0.011, `area of ${counts[i]}`);
    near(distance, numberOf(now, "missed", "Distance missed, at most"), 1e-9, `distance of ${counts[i]}`);
    const drawn = now.marks.filter(({ kind, ink, filled }) => kind === "circle" && ink === "accent" && filled);
    near(drawn[0].y, yOf(distance), 0.01, `dot of ${counts[i]}`);
  });
});

test("corner_is_dragged_and_a_polygon_that_crosses_itself_is_refused_with_the_reason", async (t) => {
  const scene = await open(t, { kinds: "circles", curve: false });
  const { state } = scene;
  const missed = () => rowOf(scene.paint(), "missed", "Area missed");
  const before = missed();
  const drag = ([x, y], to) => {
    scene.pointed({ x, y, down: true });
    scene.pointed({ x: to[0], y: to[1], down: true });
    scene.paint();
    scene.pointed({ x: to[0], y: to[1], down: false });
  };
  drag([state.x9, state.y9], [2.5, 3.6]);
  assert.deepEqual([state.x9, state.y9], [2.5, 3.6]);
  assert.notEqual(missed(), before, "another polygon, another error");
  drag([state.x0, state.y0], [6, 2]);
  const refused = scene.paint();
  assert.match(refused.message, /refuses this polygon: .*cross/);
  assert.equal(piecesOf(refused).length, 0);
  drag([6, 2], [-5.7, 1.2]);
  assert.equal(scene.paint().message, undefined);
  assert.ok(piecesOf(scene.paint()).length > 0);
});
