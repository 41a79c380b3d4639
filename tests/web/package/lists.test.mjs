/**
 * Tests the lists of a world in the npm package: bodies, shapes, moved bodies, overlaps of sensors,
 * pairs of events.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { thud } from "../support/package.mjs";

const engine = await thud.load();

function balls(count, options = {}) {
  const world = engine.createWorld(options);
  const floor = world.createBody();
  const ground = world.createAabb(floor, { halfWidth: 100, halfHeight: 1, offset: [0, -1] });
  const bodies = Array.from({ length: count }, (_, i) => {
    const body = world.createBody({ kind: "dynamic", position: [2 * i, 0.5], userData: i });
    world.createCircle(body, { radius: 0.5, userData: 100 + i });
    return body;
  });
  return { world, floor, ground, bodies };
}

test("lists_have_what_lives_in_the_order_of_slots", () => {
  const { world, floor, ground, bodies } = balls(5);
  assert.deepEqual(world.bodies(), [floor, ...bodies]);
  assert.deepEqual(world.shapes(), [ground, ...bodies.flatMap((body) => world.shapesOf(body))]);
  world.destroy(bodies[2]);
  assert.deepEqual(world.bodies(), [floor, ...bodies.filter((_, i) => i !== 2)]);
  assert.deepEqual(world.awakeBodies(), bodies.filter((_, i) => i !== 2));
  for (let i = 0; i < 120; i++) world.step();
  assert.deepEqual(world.awakeBodies(), []);
  assert.deepEqual(engine.createWorld().bodies(), []);
});

test("slots_name_their_body_and_shape", () => {
  const { world, bodies } = balls(3);
  assert.deepEqual(world.bodyAt(bodies[1].index), bodies[1]);
  const [shape] = world.shapesOf(bodies[1]);
  assert.deepEqual(world.shapeAt(shape.index), shape);
  world.destroy(bodies[1]);
  assert.equal(world.bodyAt(bodies[1].index), null);
  assert.equal(world.shapeAt(shape.index), null);
  for (const slot of [-1, 4, 0.5 + 1e9, NaN])
    assert.throws(() => world.bodyAt(slot), { code: "invalid" });
});

test("moved_bodies_are_those_that_are_elsewhere", () => {
  const { world, floor, bodies } = balls(3, { gravity: [0, 0] });
  assert.deepEqual(world.movedBodies(), [floor, ...bodies]);
  assert.deepEqual(world.movedBodies(), []);
  world.setVelocity(bodies[1], [1, 0]);
  assert.deepEqual(world.movedBodies(), []);
  world.step();
  assert.deepEqual(world.movedBodies(), [bodies[1]]);
  world.setTransform(floor, [0, -5]);
  assert.deepEqual(world.movedBodies(), [floor]);
  const snapshot = world.snapshot();
  world.step();
  assert.deepEqual(world.movedBodies(), [bodies[1]]);
  world.restore(snapshot);
  assert.deepEqual(world.movedBodies(), [bodies[1]]);
  world.destroy(bodies[1]);
  assert.deepEqual(world.movedBodies(), []);
});

test("moved_bodies_grow_with_the_world_and_forget_nobody", () => {
  const { world, floor } = balls(1, { gravity: [0, 0] });
  world.movedBodies();
  for (let n = 0; n < 8; n++) {
    const made = Array.from({ length: 200 }, () => world.createBody({ kind: "dynamic" }));
    assert.deepEqual(world.movedBodies(), made);
  }
  world.setTransform(floor, [1, 0]);
  assert.deepEqual(world.movedBodies(), [floor]);
  world.close();
  assert.throws(() => world.movedBodies(), { code: "stale" });
});

test("sensor_tells_what_it_overlaps_now", () => {
  const { world, floor, bodies, ground } = balls(4);
  const options = { halfWidth: 1.2, halfHeight: 3, offset: [1, 3.1], sensor: true };
  const sensor = world.createAabb(floor, options);
  world.step();
  const inside = [bodies[0], bodies[1]].flatMap((body) => world.shapesOf(body));
  assert.deepEqual(world.sensorOverlapsOf(sensor), inside);
  world.setTransform(bodies[0], [50, 0.5]);
  world.step();
  world.step();
  assert.deepEqual(world.sensorOverlapsOf(sensor), inside.slice(1));
  assert.throws(() => world.sensorOverlapsOf(ground), { code: "invalid" });
});

test("pair_of_an_event_has_bodies_and_both_user_data", () => {
  const { world, floor, ground, bodies } = balls(2);
  world.step();
  const [event] = world.events().begin;
  const { a, b } = world.pairOf(event);
  assert.deepEqual(a, { body: floor, bodyData: 0, shapeData: 0, sensor: false });
  assert.deepEqual(b, { body: bodies[0], bodyData: 0, shapeData: 100, sensor: false });
  world.destroy(bodies[0]);
  assert.equal(world.pairOf(event).b, null);
  assert.deepEqual(event.a, ground);
});

test("views_of_events_and_contacts_have_what_the_copies_have", () => {
  const { world, floor, bodies } = balls(3, { hitSpeed: 0.1 });
  const options = { halfWidth: 9, halfHeight: 3, offset: [1, 3.1], sensor: true };
  world.createAabb(floor, options);
  for (const body of bodies) world.setVelocity(body, [0, -3]);
  world.step();
  const events = world.events();
  const handle = (rows, at) => [rows[at] - 1, rows[at + 1]];
  const pairs = (rows) =>
    Array.from({ length: rows.length / 4 }, (_, i) => [handle(rows, 4 * i), handle(rows, 4 * i + 2)]);
  const told = (list) => list.map(({ a, b }) => [a, b].map((id) => [id.index, id.generation]));
  const views = world.eventViews();
  assert.ok(events.begin.length === 3 && events.sensorBegin.length === 3 && events.hit.length === 3);
  for (const name of ["begin", "end", "sensorBegin", "sensorEnd"])
    assert.deepEqual(pairs(views[name]), told(events[name]), name);
  assert.deepEqual([...views.sensorBeginTime], events.sensorBegin.map(({ time }) => time));
  const { HIT_ROW, CONTACT_ROW } = thud;
  assert.equal(views.hit.length, 3 * HIT_ROW.length);
  for (const [i, { point, normal, speed }] of events.hit.entries()) {
    const row = views.hit.subarray(i * HIT_ROW.length);
    assert.deepEqual([...row.subarray(HIT_ROW.point, HIT_ROW.speed + 1)], [...point, ...normal, speed]);
  }
  const [contact] = world.contactsOf(bodies[1]);
  const view = world.contactViewOf(bodies[1]);
  assert.equal(view.length, CONTACT_ROW.length);
  assert.deepEqual([...view.subarray(CONTACT_ROW.normal, CONTACT_ROW.normal + 2)], contact.normal);
  assert.equal(view[CONTACT_ROW.pointCount], contact.points.length);
  assert.deepEqual(handle(view, CONTACT_ROW.bodyB), [bodies[1].index, bodies[1].generation]);
  const [x, y, separation] = view.subarray(CONTACT_ROW.points);
  assert.deepEqual([x, y, separation], [...contact.points[0].point, contact.points[0].separation]);
});

test("sensors_tell_when_in_the_step_they_were_passed", () => {
  const world = engine.createWorld({ gravity: [0, 0], detection: "swept" });
  const gate = world.createAabb(world.createBody(), { halfWidth: 0.05, halfHeight: 1, sensor: true });
  const ball = world.createBody({ kind: "dynamic", position: [-2, 0], velocity: [300, 0] });
  world.createCircle(ball, { radius: 0.1 });
  world.step();
  const { sensorBegin, sensorEnd } = world.events();
  assert.deepEqual([...sensorBegin, ...sensorEnd].map(({ a }) => a), [gate, gate]);
  assert.ok(Math.abs(sensorBegin[0].time - 1.85 / 5) < 1e-3, `${sensorBegin[0].time}`);
  assert.ok(Math.abs(sensorEnd[0].time - 2.15 / 5) < 1e-3, `${sensorEnd[0].time}`);
});
