/**
 * A scripted run through the level of the game Platformer that takes every coin. Each leg has the
 * keys that are held and the condition that ends it. The condition gets `at`: { x, y, vx, vy } of
 * the figure's centre, whether it is standing, the phase of the game, and the states of the lifts
 * from left to right.
 */
import { findLifts } from "../../../web/public/scenes/platformer_game/lifts.js";

const KEY_NAMES = ["left", "right", "up", "down", "fire", "restart"];
const LONGEST_LEG = 15 * 60; // steps

// (at) => at.x >= x; => Conditions that end a leg.
const after = (x) => (at) => at.x >= x;
const before = (x) => (at) => at.x <= x;
const above = (y) => (at) => at.y >= y;
const below = (y) => (at) => at.y <= y;
const lift = ({ lifts }, i) => {
  const [[x, y], [vx, vy]] = [lifts[i].position, lifts[i].velocity];
  return { x, y, vx, vy };
};
const stands = (at) => at.standing;

export const WAY = {
  firstSteps: [
    ["right", after(8)],
    ["right up", after(9.9)],
    ["up", stands],
    ["right", after(11.4)],
    ["right up", after(14.6)],
    ["up", stands],
    ["right", after(17.4)],
    ["right", stands],
    ["right", after(21)],
    ["right up", after(24)],
  ],
  // Jumps up the planks, with the one at the side, and drops down through one.
  planks: [
    ["right", after(35)],
    ["up", above(7)],
    ["", stands],
    ["right", after(36.7)],
    ["left", before(35.9)],
    ["left up", before(34.5)],
    ["up", stands],
    ["left", before(32.4)],
    ["left up", before(30.6)],
    ["up", stands],
    ["right", after(30.7)],
    ["right up", after(33)],
    ["", stands],
    ["right", after(34.7)],
    ["right up", after(36.8)],
    ["up", stands],
    ["right", after(38.6)],
    ["right up", after(40.3)],
    ["", stands],
    ["right", after(43.5)],
    ["", stands],
    ["down", below(5)],
  ],
  hills: [
    ["right", after(56)],
    ["right", after(71.8)],
    ["right", after(78.6)],
  ],
  liftAcross: [
    ["", (at) => lift(at, 0).x < 83 && lift(at, 0).vx < 0],
    ["right", after(82)],
    ["", after(82.6)],
    ["right up", after(83.9)],
    ["up", stands],
    ["", stands],
    ["right up", after(86.1)],
    ["up", stands],
    ["", after(87.3)],
    ["right up", after(88.3)],
    ["right", after(92.5)],
    ["right", stands],
  ],
  // Pushes the crate to the wall and climbs the wall from it.
  crate: [
    ["right", after(108.2)],
    ["left", before(106.5)],
    ["right", after(106.8)],
    ["right up", after(108.7)],
    ["", stands],
    ["up", above(8)],
    ["right up", after(110.4)],
    ["", stands],
    ["right", after(111)],
    ["left", before(110.5)],
    ["left up", before(107)],
    ["", stands],
    ["left", before(104.9)],
    ["right", after(106.3)],
  ],
  ontoLift: [
    ["right", after(110.4)],
    ["right", after(111.4)],
    ["", (at) => lift(at, 1).y < 7.5 && lift(at, 1).vy > 0],
    ["right", after(113.6)],
    ["", stands],
  ],
  liftUp: [
    ["right", after(116.2)],
    ["", above(12.5)],
    ["left", before(113.8)],
    ["", above(16.6)],
    ["right up", after(117.6)],
    ["", stands],
  ],
  // Climbs the cliff, crosses spikes on planks, and jumps over the chasm.
  cliff: [
    ["right", after(124)],
    ["right up", after(126)],
    ["up", stands],
    ["right", after(127.4)],
    ["right up", after(130)],
    ["up", stands],
    ["right", after(136.5)],
    ["", stands],
    ["", (at) => lift(at, 2).x < 141 && lift(at, 2).vx < 0],
    ["right", after(139.3)],
    ["", stands],
    ["", after(140.8)],
    ["right up", after(141.9)],
    ["up", stands],
    ["", after(143.9)],
    ["right up", after(145)],
    ["up", stands],
    ["", after(147)],
    ["right up", after(148.1)],
    ["up", stands],
    ["right up", after(153)],
  ],
  // Goes down, over the crates and the last spikes, and up the stairs to the flag.
  down: [
    ["right", after(159)],
    ["right", after(172.5)],
    ["right up", after(177)],
    ["right", after(181.6)],
    ["right up", after(185.2)],
    ["up", stands],
    ["right", after(187.6)],
    ["right up", after(193)],
    ["right", stands],
    ["right", after(193.6)],
    ["right up", after(196)],
    ["right", stands],
    ["right up", after(198.4)],
    ["right", (at) => at.phase === "won"],
  ],
};
export const RUN = Object.values(WAY).flat();

/** Makes `steps` steps with these keys held; their names are separated by spaces. */
export function hold(scene, keys, steps) {
  const names = keys.split(" ");
  const held = Object.fromEntries(KEY_NAMES.map((name) => [name, names.includes(name)]));
  for (let i = 0; i < steps; i++) {
    scene.update({ step: scene.world.stats().steps, held, pointer: null });
    scene.world.step();
  }
}

/** The state that the conditions of a run get. */
export function look(scene, lifts = liftsOf(scene)) {
  const { place, velocity, ground } = scene.state.figure;
  return {
    x: place[0],
    y: place[1],
    vx: velocity[0],
    vy: velocity[1],
    standing: ground !== null,
    phase: scene.state.phase,
    lifts: lifts.map(({ body }) => scene.world.bodyStateOf(body)),
  };
}

/** The lifts, without the figure's own body, which is hidden. */
function liftsOf({ world, hidden }) {
  return findLifts(world).filter(({ body }) => !hidden.includes(body.index));
}

/**
 * Plays a run; a leg that lasts longer than 15 s throws an error. Returns the keys of every step.
 */
export function drive(scene, run) {
  const lifts = liftsOf(scene);
  const inputs = [];
  run.forEach(([keys, done], leg) => {
    const end = inputs.length + LONGEST_LEG;
    do {
      if (inputs.length === end) throw new Error(`leg ${leg}, "${keys}", does not end`);
      hold(scene, keys, 1);
      inputs.push(keys);
    } while (!done(look(scene, lifts)));
  });
  return inputs;
}
