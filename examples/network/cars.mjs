/**
 * The game that is played over networks: two to eight cars push a ball and crates about a walled
 * field, seen from above, without gravity. It is the game of cars.c, to the bit: the same bodies are
 * made in the same order, and numbers that C has in single precision are rounded where C rounds them.
 */
import { aabb, circle, obb } from "thud";

export const CARS_MAX = 8;
/** Inputs are 3 * (drive + 1) + turn + 1, for drive and turn from -1 to 1; IDLE: hands off. */
export const [IDLE, INPUTS] = [4, 9];
/** The steps a second. */
export const RATE = 60;

/** Half the length and width of the field. */
export const [HALF_LENGTH, HALF_WIDTH] = [12, 8];
const CRATES = 6;
/** Accelerations of a car, length/s^2 and rad/s^2; the share of its sideways velocity that it loses in a step. */
const [DRIVE, TURN, GRIP] = [14, 24, 0.25];

const f = Math.fround;

/** A world for the game; `options`: of createWorld, such as another quality. */
export const createField = (thud, options = {}) =>
  thud.createWorld({ gravity: [0, 0], timeStep: 1 / RATE, ...options });

/** Builds the game in an empty world; returns the cars, the ball and the crates. */
export function buildCars(world, players) {
  const wall = { restitution: 0.6, friction: 0.2 };
  for (const side of [-1, 1]) {
    const [across, along] = [aabb(1, HALF_WIDTH + 2, wall), aabb(HALF_LENGTH + 2, 1, wall)];
    world.createBody({ position: [side * (HALF_LENGTH + 1), 0], shapes: [across] });
    world.createBody({ position: [0, side * (HALF_WIDTH + 1)], shapes: [along] });
  }
  const create = (options) => world.createBody({ kind: "dynamic", ...options });
  const cars = Array.from({ length: players }, (_, i) =>
    create({
      position: [i % 2 ? 9 : -9, ((Math.floor(i / 2) + 1) * HALF_WIDTH) / 3 - (HALF_WIDTH * 5) / 6],
      angle: i % 2 ? 3 : 0.1,
      linearDamping: 1.2,
      angularDamping: 6,
      shapes: [obb(0.8, 0.4, { restitution: 0.3, friction: 0.3 })],
    }),
  );
  const ball = create({
    velocity: [4, 3],
    linearDamping: 0.1,
    shapes: [circle(0.5, { restitution: 0.9, friction: 0.3, density: 0.2 })],
  });
  const crates = Array.from({ length: CRATES }, (_, i) =>
    create({
      position: [4 * (i % 3) - 4, i < 3 ? -3 : 3],
      angle: 0.3 * i,
      linearDamping: 1,
      angularDamping: 1,
      shapes: [obb(0.5, 0.5, { restitution: 0.2, density: 0.5 })],
    }),
  );
  return { cars, ball, crates };
}

/**
 * The state of the game beside its world: a hash of all inputs so far, and the handles of its bodies,
 * which somebody who joins takes over with the world; and its bytes, as C has them.
 */
export const newState = ({ cars, ball, crates }) => ({ sum: 1n, bodies: [...cars, ball, ...crates] });
const BODIES_MAX = CARS_MAX + 1 + CRATES;
export const stateBytes = {
  write({ sum, bodies }) {
    const view = new DataView(new ArrayBuffer(8 + 8 * BODIES_MAX));
    view.setBigUint64(0, sum, true);
    bodies.forEach(({ index, generation }, i) => {
      view.setUint32(8 + 8 * i, index + 1, true);
      view.setUint32(12 + 8 * i, generation, true);
    });
    return new Uint8Array(view.buffer);
  },
  read(bytes) {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
    const bodies = Array.from({ length: BODIES_MAX }, (_, i) => (
      { kind: "body", index: view.getUint32(8 + 8 * i, true) - 1, generation: view.getUint32(12 + 8 * i, true) }
    ));
    return { sum: view.getBigUint64(0, true), bodies: bodies.filter(({ index }) => index >= 0) };
  },
};
/** The cars, the ball and the crates of a state of a game with so many players. */
export const bodiesOf = ({ bodies }, players) => (
  { cars: bodies.slice(0, players), ball: bodies[players], crates: bodies.slice(players + 1) }
);

const motion = [];

/** The step of the game for a rollback. */
export const carsStep = (world) => (inputs, state) => {
  const { bodies: cars } = state;
  inputs.forEach((input, player) => {
    state.sum = BigInt.asUintN(64, state.sum * 31n + BigInt(input));
    const [drive, turn] = [Math.floor((input % INPUTS) / 3) - 1, (input % 3) - 1];
    const { cosine, sine } = world.rotationOf(cars[player]);
    const [, , , x, y, spin] = world.motionOf(cars[player], motion);
    const push = f(f(DRIVE * drive) / RATE);
    const along = f(f(f(x * cosine) + f(y * sine)) + push);
    const across = f(f(f(y * cosine) - f(x * sine)) * (1 - GRIP));
    const velocity = [
      f(f(along * cosine) - f(across * sine)),
      f(f(along * sine) + f(across * cosine)),
    ];
    world.setVelocity(cars[player], velocity, f(spin + f(f(TURN * turn) / RATE)));
  });
  world.step();
};

/** splitmix64 (Steele, Lea, Flood: Fast splittable pseudorandom number generators, 2014). */
function randomOf(state) {
  const mix = (x, by, times) => BigInt.asUintN(64, (x ^ (x >> by)) * times);
  const x = BigInt.asUintN(64, state + 0x9e3779b97f4a7c15n);
  const mixed = mix(mix(x, 30n, 0xbf58476d1ce4e5b9n), 27n, 0x94d049bb133111ebn);
  return mixed ^ (mixed >> 31n);
}

/** An input is drawn for each block of HOLD steps, and begins less than LATER steps after it. */
const [HOLD, LATER] = [32, 24];

/** What a player who drives at random does in a step, as cars_input of cars.c. */
export function carsInput(seed, player, step) {
  const drawn = (block) =>
    randomOf(BigInt(seed) ^ (BigInt(block * CARS_MAX + player) << 8n));
  const block = Math.floor(step / HOLD);
  let own = drawn(block);
  const begins = Number((own >> 32n) % BigInt(LATER));
  if (step % HOLD < begins) own = block ? drawn(block - 1) : BigInt(IDLE);
  const input = Number(own % BigInt(INPUTS + 3));
  return input < INPUTS ? input : input - 3;
}
