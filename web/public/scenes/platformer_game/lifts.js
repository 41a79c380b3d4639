// Lifts: kinematic boxes that travel, and turn back where they meet what stands still, sensors too.
import { findBodies } from "./bodies.js";

const STEP = 1 / 60; // seconds

// To be called before a figure is there, whose body is a kinematic box as well.
export function findLifts(world) {
  return findBodies(world, ({ kind, shape }) => kind === "kinematic" && shape.kind === "aabb");
}

// Before each step.
export function turnLifts(world, lifts) {
  for (const { body, shape } of lifts) {
    const { position, velocity } = world.bodyStateOf(body);
    const { halfWidth, halfHeight } = shape;
    const [dx, dy] = [2 * STEP * velocity[0], 2 * STEP * velocity[1]];
    const turns = world
      .castShapeAll({ kind: "aabb", halfWidth, halfHeight }, position, [dx, dy], { sensors: true })
      .some(({ shape: met, normal: [nx, ny] }) => nx * dx + ny * dy < 0 && isStatic(world, met));
    if (turns) world.setVelocity(body, [-velocity[0], -velocity[1]]);
  }
}

function isStatic(world, shape) {
  return world.bodyStateOf(world.shapeStateOf(shape).body).kind === "static";
}
