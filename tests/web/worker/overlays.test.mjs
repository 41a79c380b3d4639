/**
 * Tests that overlays draw the engine's contacts, bounds, pairs, cells and islands in the right
 * places, by recording the page's strokes and fills.
 */
import assert from "node:assert/strict";
import { beforeEach, test } from "node:test";
import { importTypeScript, openSession } from "../../../web/tools/scenes.mjs";
import { demoWasm, thud } from "../support/package.mjs";

const { drawLists } = await importTypeScript("src/draw/debug.ts");
const { LIGHT } = await importTypeScript("src/draw/palette.ts");
const { Frames } = await importTypeScript("src/worker/frames.ts");
const engine = await thud.load(demoWasm);

/** CSS pixels per world unit. */
const SCALE = 16;
const ORIGIN = [1, 2];
// Half the width of the drawn region, world units.
const REACH = 100;

/**
 * Records the contours of a path in world units: a circle by its centre, other contours by their
 * corners.
 */
globalThis.Path2D = class {
  contours = [];
  moveTo(x, y) {
    this.contours.push([place(x, y)]);
  }
  lineTo(x, y) {
    this.contours.at(-1).push(place(x, y));
  }
  closePath() {}
  arc(x, y) {
    this.contours.pop();
    this.contours.push([place(x, y)]);
  }
  rect(x, y, width, height) {
    this.contours.push([place(x, y), place(x + width, y), place(x + width, y + height), place(x, y + height)]);
  }
};

const place = (x, y) => [x / SCALE + ORIGIN[0], -y / SCALE + ORIGIN[1]];

let session;
beforeEach(async (t) => {
  session = await openSession(engine, "pyramid", { size: 6 });
  for (let i = 0; i < 20; i++) session.makeStep();
});

/** All contours that the overlays stroke and fill. */
function drawnBy(...overlays) {
  const lower = ORIGIN.map((x) => x - REACH);
  const upper = ORIGIN.map((x) => x + REACH);
  const look = { origin: ORIGIN, lower, upper, overlays, focus: null };
  const { drawing } = new Frames(session).make(look);
  const found = [];
  if (!drawing) return found;
  const record = (path) => found.push(...path.contours);
  const context = { stroke: record, fill: record };
  drawLists(context, drawing, SCALE, LIGHT, new Set(overlays));
  return found;
}

/** The mean point and the normal of every contact. */
function contactPoints() {
  const { world } = session;
  const found = new Map();
  for (const body of world.bodies())
    for (const { a, b, normal, points } of world.contactsOf(body))
      found.set(`${a.index} ${b.index}`, { point: middle(points.map(({ point }) => point)), normal });
  return [...found.values()];
}

const middle = (places) => [0, 1].map((k) => places.reduce((sum, at) => sum + at[k], 0) / places.length);

const byPlace = ([ax, ay], [bx, by]) => ax - bx || ay - by;
const rounded = (places) => places.map((xy) => xy.map((x) => Math.round(100 * x) / 100)).sort(byPlace);

test("contacts_are_dots_where_the_engine_has_their_points", () => {
  const points = contactPoints().map(({ point }) => point);
  assert.ok(points.length > 30, `${points.length} points`);
  assert.deepEqual(rounded(drawnBy("contacts").flat()), rounded(points));
});

test("normals_begin_at_the_points_and_go_along_the_normals", () => {
  const lines = drawnBy("normals");
  const contacts = contactPoints();
  assert.deepEqual(rounded(lines.map(([from]) => from)), rounded(contacts.map(({ point }) => point)));
  for (const [from, to] of lines) {
    const { normal } = contacts.find(({ point }) => Math.hypot(point[0] - from[0], point[1] - from[1]) < 0.01);
    const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
    const length = Math.hypot(dx, dy);
    assert.ok(length > 0.05, `a normal of ${length}`);
    assert.ok(Math.abs((dx * normal[0] + dy * normal[1]) / length) > 0.99, "it goes elsewhere");
  }
});

test("bounds_go_around_every_shape_that_has_some", () => {
  const { world } = session;
  const boxes = drawnBy("bounds").map((corners) => ({
    lower: [0, 1].map((k) => Math.min(...corners.map((corner) => corner[k]))),
    upper: [0, 1].map((k) => Math.max(...corners.map((corner) => corner[k]))),
  }));
  const moving = world.bodies().filter((body) => world.bodyStateOf(body).kind === "dynamic");
  assert.equal(moving.length, 21);
  for (const body of moving) {
    const { lower, upper } = world.boundsOf(world.shapesOf(body)[0]);
    const around = boxes.filter(
      (box) =>
        [0, 1].every((k) => box.lower[k] <= lower[k] + 1e-3 && box.upper[k] >= upper[k] - 1e-3) &&
        box.upper[0] - box.lower[0] < 2 * (upper[0] - lower[0]),
    );
    assert.equal(around.length, 1, `${around.length} boxes around body ${body.index}`);
  }
});

test("pairs_join_the_middles_of_shapes_whose_bounds_overlap", () => {
  const { world } = session;
  const lines = drawnBy("pairs");
  assert.equal(lines.length, world.stats().pairs);
  const middles = world.bodies().map((body) => world.bodyStateOf(body).position);
  for (const line of lines)
    assert.ok(
      line.some(([x, y]) => middles.some((one) => Math.hypot(one[0] - x, one[1] - y) < 0.01)),
      "a pair of nobody",
    );
});

test("cells_lie_under_every_body", () => {
  const cells = drawnBy("cells");
  const { world } = session;
  const within = ([x, y], corners) =>
    [0, 1].every((k) => {
      const at = k === 0 ? x : y;
      const places = corners.map((corner) => corner[k]);
      return Math.min(...places) - 0.02 <= at && at <= Math.max(...places) + 0.02;
    });
  for (const body of world.bodies()) {
    const { kind, position } = world.bodyStateOf(body);
    if (kind !== "dynamic") continue;
    assert.ok(cells.some((corners) => within(position, corners)), `body ${body.index} is in none`);
  }
});

test("islands_fill_the_bodies_that_are_in_one", () => {
  const { world } = session;
  const filled = drawnBy("islands");
  const bodies = world.bodies().map((body) => world.bodyStateOf(body));
  const positions = bodies.filter(({ kind }) => kind === "dynamic").map(({ position }) => position);
  assert.deepEqual(rounded(filled.map(middle)), rounded(positions));
});

test("what_is_not_ticked_is_not_drawn", () => {
  assert.deepEqual(drawnBy(), []);
  assert.equal(drawnBy("contacts", "normals").length, 2 * contactPoints().length);
});
