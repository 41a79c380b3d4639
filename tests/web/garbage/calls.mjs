/**
 * Prints the bytes of garbage that each call makes; garbage.test.mjs runs it with flags of Node.
 */
import { thud } from "../support/package.mjs";

const engine = await thud.load();
const world = engine.createWorld();
world.createTerrain(world.createBody(), { kind: "flat" });
const circle = { kind: "circle", radius: 0.5 };
const options = { kind: "dynamic", position: [0.5, 100.5], shapes: [circle] };
const ball = world.spawn({ ...options, position: [0.25, 2.5] });
const [force, point, origin, way] = [[0.25, 0.5], [0.125, 0.25], [0.25, 90.5], [0.125, -100.5]];
const tyre = { at: [0.25, 0.5], steer: 0.5, thrust: 2.5, brake: 0.5, grip: 4.5 };
const into = new Float64Array(8);

const CALLS = {
  step: () => world.step(),
  poses: () => world.poses(),
  eventViews: () => world.eventViews(),
  contactViewOf: () => world.contactViewOf(ball),
  setVelocity: () => world.setVelocity(ball, force, 0.5),
  applyCenterForce: () => world.applyCenterForce(ball, force),
  applyTorque: () => world.applyTorque(ball, 0.5),
  applyImpulse: () => world.applyImpulse(ball, force, point),
  applyForce: () => world.applyForce(ball, force, point),
  applyTyre: () => world.applyTyre(ball, tyre),
  setTransform: () => world.setTransform(ball, force, 0.5),
  positionOf: () => world.positionOf(ball, into),
  worldPoint: () => world.worldPoint(ball, point, into),
  motionOf: () => world.motionOf(ball, into),
  userDataOf: () => world.userDataOf(ball, "body"),
  castRayInto: () => world.castRayInto(origin, way, null, into),
  castRay: () => world.castRay(origin, way),
  spawnAndDestroy: () => world.destroy(world.spawn(options), "body"),
};

// The number of calls per round. Chosen.
const MANY = 40_000;
const bytes = {};
for (const [name, call] of Object.entries(CALLS)) {
  for (let i = 0; i < MANY; i++) call();
  // The minimum of four rounds: garbage of the just-in-time compiler is not in all of them.
  const rounds = Array.from({ length: 4 }, () => {
    globalThis.gc();
    const before = process.memoryUsage().heapUsed;
    for (let i = 0; i < MANY; i++) call();
    return Math.round((process.memoryUsage().heapUsed - before) / MANY);
  });
  bytes[name] = Math.min(...rounds);
}
console.log(JSON.stringify(bytes));
