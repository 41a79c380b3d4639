/**
 * Tests the parts of thud/canvas, thud/pixi, thud/three and thud/phaser that need no browser; their pages are
 * tested in tests/web/bundlers/adapters.test.mjs.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { root, thud } from "../support/package.mjs";

const bring = (name) => import(`${root}web/package/dist/${name}.js`);
const [{ CanvasView }, { PixiView }, { ThreeView }, { PhaserView }] = await Promise.all(["canvas", "pixi", "three", "phaser"].map(bring));
const engine = await thud.load();

/** A world without gravity that is closed at the end of the test. */
function makeWorld(t) {
  const world = engine.createWorld({ gravity: [0, 0] });
  t.after(() => world.close());
  return world;
}

const crate = (position, kind = "dynamic") => ({ kind, position, angle: 0.5, shapes: [thud.obb(0.5, 0.5)] });

/** Views with what stands for the objects of their libraries; `gone` lists those that were removed. */
function viewsOf(world) {
  const gone = [];
  const group = { addChild() {}, add() {} };
  const flat = () => ({ x: 0, y: 0, rotation: 0, destroy: () => gone.push("flat") });
  const mesh = () => ({ position: { x: 0, y: 0 }, rotation: { z: 0 }, removeFromParent: () => gone.push("mesh") });
  return { gone, views: [
    [new PixiView(world, group, { scale: 10 }), flat()],
    [new PhaserView(world, {}, { scale: 10 }), flat()],
    [new ThreeView(world, group), mesh()],
  ] };
}

test("objects_are_placed_and_turned_as_their_library_counts", (t) => {
  const world = makeWorld(t);
  const body = world.createBody(crate([3, 4]));
  const { views } = viewsOf(world);
  const [pixi, phaser, three] = views.map(([view, object]) => {
    assert.equal(view.add(body, object), object);
    view.update(1);
    return object;
  });
  for (const { x, y, rotation } of [pixi, phaser])
    assert.deepEqual([x, y, rotation.toFixed(4)], [30, -40, "-0.5000"]); // y down, clockwise
  const { position, rotation } = three;
  assert.deepEqual([position.x, position.y, rotation.z.toFixed(4)], [3, 4, "0.5000"]);
});

test("object_of_a_destroyed_body_is_removed_and_not_given_to_the_next_in_its_slot", (t) => {
  const world = makeWorld(t);
  const body = world.createBody(crate([3, 4]));
  const { views, gone } = viewsOf(world);
  for (const [view, object] of views) view.add(body, object);
  world.destroy(body);
  world.step(); // from then on the slot may be used again
  assert.equal(world.createBody(crate([7, 7])).index, body.index);
  for (const [view] of views) view.update(1);
  for (const [view] of views) view.update(1);
  assert.deepEqual(gone, ["flat", "flat", "mesh"]);
  assert.throws(() => views[0][0].add(body, views[0][1]), { code: "stale" });
});

/** A canvas of 200 by 100 pixels that a page shows in half that size, at [10, 20]; `calls`: of its context. */
function makeCanvas() {
  const calls = [];
  const context = new Proxy({}, { get: (_, name) => (...args) => calls.push([name, ...args]), set: () => true });
  return Object.assign(new EventTarget(), {
    width: 200,
    height: 100,
    style: {},
    calls,
    getContext: () => context,
    getBoundingClientRect: () => ({ left: 10, top: 20, width: 100, height: 50 }),
    setPointerCapture() {},
  });
}

test("canvas_is_painted_in_the_frame_of_each_body_relative_to_the_view", (t) => {
  const world = makeWorld(t);
  const canvas = makeCanvas();
  const view = new CanvasView(world, canvas, { scale: 10, center: [3, 1] });
  view.add(world.createBody(crate([3, 4])), (context) => context.fill());
  view.draw(1);
  const [, ...frame] = canvas.calls.find(([name]) => name === "transform");
  assert.deepEqual(frame.map((value) => value.toFixed(4)), [Math.cos(0.5), Math.sin(0.5), -Math.sin(0.5), Math.cos(0.5), 0, 3].map((value) => value.toFixed(4)));
  assert.ok(canvas.calls.some((call) => `${call}` === "setTransform,10,0,0,-10,100,50"));
  assert.deepEqual(view.placeOf({ clientX: 60, clientY: 45 }), [3, 1]);
  assert.deepEqual(view.placeOf({ clientX: 110, clientY: 20 }), [13, 6]);
});

test("canvas_shows_y_downwards_where_the_view_is_told_so", (t) => {
  const world = makeWorld(t);
  const canvas = makeCanvas();
  const view = new CanvasView(world, canvas, { scale: 10, center: [3, 1], yDown: true });
  view.add(world.createBody(crate([3, 4])), (context) => context.fill());
  view.draw(1);
  assert.ok(canvas.calls.some((call) => `${call}` === "setTransform,10,0,0,10,100,50"));
  assert.deepEqual(view.placeOf({ clientX: 60, clientY: 45 }), [3, 1]);
  assert.deepEqual(view.placeOf({ clientX: 110, clientY: 20 }), [13, -4]);
});

test("pointers_drag_bodies_of_pixels_as_bodies_of_metres", (t) => {
  const world = engine.createWorld({ lengthScale: 40, gravity: [0, -1000] });
  t.after(() => world.close());
  const canvas = makeCanvas();
  const view = new CanvasView(world, canvas, { scale: 0.25 });
  const rock = world.createBody({ kind: "dynamic", position: [0, 0], shapes: [thud.circle(20)] });
  const drag = view.drag();
  const point = (type, [x, y]) =>
    canvas.dispatchEvent(Object.assign(new Event(type), { pointerId: 1, button: 0, clientX: 60 + x / 8, clientY: 45 - y / 8 }));
  point("pointerdown", [26, 0]); // beside the rock, within the reach of 8
  assert.equal(drag.bodies.length, 1);
  point("pointerup", [26, 0]);
  point("pointerdown", [0, 0]);
  point("pointermove", [0, 120]);
  for (let i = 0; i < 120; i++) world.step();
  const [, y] = world.positionOf(rock);
  assert.ok(Math.abs(y - 120) < 4, `the rock is at ${y}, not at the pointer's 120`);
  drag.end();
});

test("pointers_hold_dynamic_bodies_until_they_end_and_leave_nothing_behind", (t) => {
  const world = makeWorld(t);
  const canvas = makeCanvas();
  const view = new CanvasView(world, canvas, { scale: 10 });
  const [left, right] = [[-5, 0], [5, 0]].map((place) => world.createBody(crate(place)));
  const wall = world.createBody(crate([0, 0], "static"));
  const drag = view.drag();
  const point = (type, pointerId, [x, y]) =>
    canvas.dispatchEvent(Object.assign(new Event(type), { pointerId, button: 0, clientX: 60 + 5 * x, clientY: 45 - 5 * y }));
  point("pointerdown", 1, [0, 0]);
  point("pointerdown", 2, [0, 4]);
  assert.deepEqual(drag.bodies, []);
  point("pointerdown", 1, [-5, 0]);
  point("pointerdown", 2, [5.3, 0]);
  assert.deepEqual(drag.bodies.map(({ index }) => index), [left.index, right.index]);
  point("pointermove", 1, [-5, 3]);
  point("pointermove", 2, [5.3, -3]);
  for (let i = 0; i < 120; i++) world.step();
  assert.ok(Math.abs(world.positionOf(left)[1] - 3) < 0.05, `${world.positionOf(left)}`);
  assert.ok(world.positionOf(right)[1] < -2.4, `${world.positionOf(right)}`);
  point("pointerup", 1, [-5, 3]);
  assert.deepEqual(drag.bodies.map(({ index }) => index), [right.index]);
  world.destroy(right); // in the pointer's hand
  point("pointermove", 2, [0, 0]);
  drag.end();
  point("pointerdown", 1, [-5, 3]);
  assert.deepEqual(drag.bodies, []);
  assert.deepEqual(world.bodies().map(({ index }) => index), [left.index, wall.index]);
});
