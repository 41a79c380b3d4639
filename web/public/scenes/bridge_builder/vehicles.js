// What has to cross: a body on wheels that have a suspension and a motor.

import { VEHICLE } from "./bridge.js";
import { ROAD_HALF } from "./levels.js";

const START = 1.6; // metres from its front to the gorge
const GRIP = 1.2;

/**
 * Boxes are [x, y, halfWidth, halfHeight, density] from the middle of the chassis, `wheels` are
 * where they are along it; metres, and metres a second.
 */
export const VEHICLES = {
  van: {
    boxes: [[0, 0, 1.6, 0.35, 1.4], [-0.5, 0.75, 1.1, 0.45, 0.8], [0.9, 0.6, 0.35, 0.3, 0.6]],
    inks: ["player", "player"],
    window: [0.3, 0.8, 0.28, 0.22],
    wheels: [-1, 1],
    radius: 0.42,
    speed: 4.5,
  },
  truck: {
    boxes: [[0, 0, 2, 0.3, 1.2], [1.4, 0.75, 0.55, 0.5, 0.8], [-0.65, 0.8, 1.3, 0.55, 1.5]],
    inks: ["rival", "gold"],
    window: [1.65, 0.9, 0.25, 0.24],
    wheels: [-1.5, -0.4, 1.4],
    radius: 0.42,
    speed: 4,
  },
  hauler: {
    boxes: [[0, 0, 2.9, 0.3, 0.8], [2.3, 0.8, 0.6, 0.55, 0.8], [-0.7, 0.9, 2.1, 0.6, 1]],
    inks: ["bad", "accent"],
    window: [2.55, 0.98, 0.28, 0.25],
    wheels: [-2.4, -1.4, 1.1, 2.2],
    radius: 0.42,
    speed: 3.5,
  },
};

/** Before its gorge, with the brakes on. */
export function buildVehicle(world, level) {
  const kind = VEHICLES[level.vehicle];
  const filter = { mask: ~VEHICLE >>> 0, category: VEHICLE };
  const middle = [level.x - START - kind.boxes[0][2], ROAD_HALF + kind.radius + 0.3];
  const chassis = world.createBody({ kind: "dynamic", position: middle });
  for (const [x, y, halfWidth, halfHeight, density] of kind.boxes)
    world.createObb(chassis, { halfWidth, halfHeight, offset: [x, y], density, ...filter });
  const wheels = kind.wheels.map((x) => {
    const position = [middle[0] + x, ROAD_HALF + kind.radius];
    const wheel = world.createBody({ kind: "dynamic", position });
    world.createCircle(wheel, { radius: kind.radius, density: 1, friction: GRIP, ...filter });
    return wheel;
  });
  const bodies = [chassis, ...wheels];
  const mass = bodies.reduce((sum, body) => sum + world.bodyStateOf(body).mass, 0);
  const axles = wheels.map((wheel) =>
    world.createJoint({
      kind: "wheel",
      bodyA: chassis,
      bodyB: wheel,
      at: world.bodyStateOf(wheel).position,
      along: { frequency: 3, damping: 0.7, lower: -0.2, upper: 0.2 },
      turn: { motorSpeed: 0, motorForce: (5 * mass * kind.radius) / wheels.length },
    }),
  );
  const places = bodies.map((body) => world.bodyStateOf(body).position);
  const rear = 0.3 - kind.wheels[0]; // behind the gorge's end it is across
  return { kind, bodies, chassis, wheels, axles, places, rear };
}

/** Forward, or with the brakes on. */
export function drive(world, { kind, axles }, forward) {
  const motorSpeed = forward ? -kind.speed / kind.radius : 0;
  for (const axle of axles) world.setDrive(axle, "turn", { motorSpeed });
}

/** Back to where it started. */
export function putBack(world, vehicle) {
  vehicle.bodies.forEach((body, i) => {
    world.setEnabled(body, false); // no contact is to remember where it was
    world.setEnabled(body, true);
    world.setTransform(body, vehicle.places[i]);
    world.setVelocity(body, [0, 0]);
  });
  drive(world, vehicle, false);
}
