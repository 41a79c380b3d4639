// The cars: a hull with a wedge at each end, on two sprung wheels that a motor turns.

import { partsOf } from "../joints/parts.js";

/** An input: the sum of these. */
const [LEFT, RIGHT, HOP] = [1, 2, 4];
/** The number of different inputs. */
export const INPUTS = 8;

export const HULL = { halfWidth: 0.85, halfHeight: 0.2 };
export const CABIN = { halfWidth: 0.42, halfHeight: 0.2, offset: [0, 0.38] };
const WEDGE = { halfWidth: 0.34, halfHeight: 0.06 };
/** Where the wedge at the right end stands, and its angle; the left one is its mirror image. */
const WEDGE_AT = { offset: [1.04, -0.16], angle: -0.42 };
/** Its end. */
export const TIP = [1.36, -0.31];
export const WHEEL = 0.34;

const SPEED = 8.5; // lengths a second
const LEAP = 6.2; // the same, upwards
const REST = 40; // steps from hop to hop
const AXLE = 0.58;
const DEEP = -40; // where a car lies that is out

export function inputOf(left, right, hop) {
  return (left ? LEFT : 0) + (right ? RIGHT : 0) + (hop ? HOP : 0);
}

export function buildCars(world, grid, arena, size) {
  const parts = partsOf(world, grid);
  /** Where one of so many cars begins, on a platform of this half length. */
  const spot = (half, i, count) => {
    const spread = half - 2.2;
    return count > 1 ? grid(-spread + (2 * spread * i) / (count - 1)) : 0;
  };
  return Array.from({ length: size }, (_, i) => buildCar(parts, [spot(arena.half, i, size), 0.75], -1 - i, spot));
}

function buildCar({ moving, addBox, wheel }, [x, y], group, spot) {
  const steel = { density: 20, friction: 0.15, group };
  const rubber = { density: 20, friction: 1.1, group };
  const hull = moving([x, y]);
  addBox(hull, HULL.halfWidth, HULL.halfHeight, steel);
  addBox(hull, CABIN.halfWidth, CABIN.halfHeight, { offset: CABIN.offset, ...steel });
  for (const side of [-1, 1]) {
    const offset = [side * WEDGE_AT.offset[0], WEDGE_AT.offset[1]];
    addBox(hull, WEDGE.halfWidth, WEDGE.halfHeight, { offset, angle: side * WEDGE_AT.angle, ...steel });
  }
  const weight = 14 * hull.mass;
  const turn = { motorSpeed: 0, motorForce: 0.55 * weight * WHEEL };
  const wheels = [-1, 1].map((side) =>
    wheel(hull, 2, [x + side * AXLE, y - 0.3], WHEEL, turn, rubber),
  );
  const all = [hull, ...wheels];
  return {
    hull: hull.body,
    wheels: wheels.map(({ body }) => body),
    joints: wheels.map(({ joint }) => joint),
    parts: all,
    /** Puts the car where one of so many begins, at rest. */
    place(world, half, i, count) {
      const way = spot(half, i, count) - x;
      for (const { body, x: home, y } of all) {
        world.setEnabled(body, true);
        world.setTransform(body, [home + way, y]);
        world.setVelocity(body, [0, 0]);
      }
    },
    /** Takes the car out of the world, and its springs out of sight. */
    remove(world) {
      for (const { body, x, y } of all) {
        world.setEnabled(body, false);
        world.setTransform(body, [x, y + DEEP]);
      }
    },
  };
}

/** Applies the players’ inputs. `state` has what each car was told last, and its rest from hopping. */
export function drive(world, cars, state, inputs) {
  const fights = state.phase === "fight";
  cars.forEach((car, i) => {
    const player = state.players[i];
    player.rest = Math.max(0, player.rest - 1);
    const input = fights && !player.out ? inputs[i] : 0;
    const wanted = (input & RIGHT ? 1 : 0) - (input & LEFT ? 1 : 0);
    if (wanted !== player.wanted) {
      player.wanted = wanted;
      const motorSpeed = (-wanted * SPEED) / WHEEL;
      for (const joint of car.joints) world.setDrive(joint, "turn", { motorSpeed });
    }
    if (input & HOP && player.rest === 0 && touches(world, car)) {
      player.rest = REST;
      hop(world, car);
    }
  });
}

const touches = (world, { hull, wheels }) =>
  [hull, ...wheels].some((body) => world.contactsOf(body).length > 0);

/** A leap; a car that lies on its roof turns over by it. */
function hop(world, car) {
  const { cosine, sine } = world.rotationOf(car.hull);
  const turn = cosine < 0.5 ? (sine > 0 ? -5 : 5) : 0;
  for (const body of [car.hull, ...car.wheels]) {
    const { velocity, angularVelocity } = world.velocityOf(body);
    const spin = body === car.hull ? angularVelocity + turn : angularVelocity;
    world.setVelocity(body, [velocity[0], Math.max(velocity[1], 0) + LEAP], spin);
  }
}
