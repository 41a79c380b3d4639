/**
 * A platformer: planks to jump through from below, a crate to push, a belt that runs against the
 * character, and a lift to the flag.
 */
import { aabb, circle } from "thud";

export const title = "Run to the flag";
export const about = "Six coins on planks, a belt and a lift, on the way to a flag.";
export const menu = { group: "Games", place: 133 };

const [PLANK, COIN, FLAG] = [2, 4, 8]; // categories
const COINS = [[5, 2.2], [5, 3.8], [11, 2], [16, 0.5], [22.5, 3], [28, 4.5]];
const START = [-8, 0.5];
const END = [33, 4.5];
const LOWEST = -8; // who falls below this begins anew
const [SPEED, JUMP] = [5, 9];

export default function ({ createWorld, createMover }) {
  const world = createWorld();
  // All static shapes are of one body; each coin has a body of its own, which is destroyed when
  // taken.
  const belt = aabb(4.5, 0.5, { offset: [16.5, -0.5], surfaceSpeed: -2 });
  const hill = aabb(5, 2.5, { offset: [30, 1.5] });
  const planks = [1.6, 3.2].map((y) => aabb(1.5, 0.1, { offset: [5, y], category: PLANK }));
  const ground = world.createBody({ shapes: [aabb(10, 0.5, { offset: [0, -0.5] }), belt, hill, ...planks] });
  // The character is a mover and no body.
  const hero = createMover(world, {
    shape: circle(0.4),
    position: START,
    gravityScale: 2,
    pushForce: 40,
    oneWay: PLANK,
    filter: { sensors: true },
  });

  const game = {
    world,
    view: { x: START[0], y: 3, height: 13, width: 13 },
    keys: { left: "walk", right: "walk", up: "jump", restart: "begin anew" },
    pointer: true,
    state: begin(),

    update({ held, pointer }) {
      if (held.restart) Object.assign(game.state, begin());
      const { state } = game;
      state.held = pointer?.down ? towards(pointer) : held;
      state.steps += state.over ? 0 : 1;
      world.setTarget(state.lift, [22.5, 1.9 - 2.1 * Math.cos(state.lifted++ / 60 - 0.9)]);
    },

    /** The character walks after the step, on ground that has moved. */
    stepped() {
      const { state } = game;
      const { held } = state;
      const speed = state.over ? 0 : SPEED * (Number(held.right ?? 0) - Number(held.left ?? 0));
      if (speed) state.facing = Math.sign(speed);
      const { sensors } = hero.walk({ speed, jump: held.up && !state.over ? JUMP : 0 });
      for (const { body, category } of sensors.map((sensor) => world.shapeStateOf(sensor))) {
        state.over ||= category === FLAG;
        if (category === COIN) world.destroy(body);
      }
      state.coins = state.coins.filter((coin) => world.isValid(coin));
      if (hero.position[1] < LOWEST) {
        hero.place(START);
        state.falls++;
      }
      state.hero = hero.state();
    },

    /** Time has gone back: `state` is an earlier one. */
    restored: () => hero.restore(game.state.hero),

    paint() {
      const { state } = game;
      const [x, y] = hero.position;
      return {
        follow: [x, Math.max(y, 0) + 2.5],
        marks: [
          ...arrows(state.steps),
          ...planks.map(({ offset: [x, y] }) => ({ kind: "box", x, y, halfWidth: 1.5, halfHeight: 0.1, ink: "accent", filled: true })),
          ...state.coins.map((coin) => disc(...world.positionOf(coin), 0.3)),
          { kind: "line", points: [[END[0], 4], [END[0], 6.2]], ink: "ink", width: 3 },
          { kind: "line", points: [[END[0], 6.2], [END[0] + 1.2, 5.8], [END[0], 5.4]], ink: "good", filled: true },
          { kind: "figure", x, y, halfWidth: 0.4, halfHeight: 0.4, facing: state.facing, ink: "player" },
        ],
        figures: [
          { label: "Coins", value: `${COINS.length - state.coins.length} of ${COINS.length}` },
          { label: "Time", value: `${(state.steps / 60).toFixed(1)} s` },
        ],
        message: message(state),
      };
    },
  };
  return game;

  /** Puts everything that moves or is taken at its place. Returns the game's own data. */
  function begin() {
    for (const body of world.bodies()) if (body.index !== ground.index) world.destroy(body);
    const sensor = { sensor: true };
    const coins = world.createBodies({ shapes: [circle(0.3, { category: COIN, ...sensor })] }, COINS);
    world.createBody({ position: END, shapes: [circle(0.3, { category: FLAG, ...sensor })] });
    world.createBody({ kind: "dynamic", position: [2, 0.5], shapes: [aabb(0.5, 0.5)] }); // a crate
    const lift = world.createBody({ kind: "kinematic", position: [22.5, 0], shapes: [aabb(1.5, 0.2)] });
    hero.place(START);
    return { coins, lift, held: {}, lifted: 0, steps: 0, falls: 0, facing: 1, over: false, hero: hero.state() };
  }

  /** Keys that lead to where the pointer is held; it jumps to what is above. */
  function towards(pointer) {
    const [x, y] = hero.position;
    return { left: pointer.x < x - 0.2, right: pointer.x > x + 0.2, up: pointer.y > y + 1 };
  }
}

const disc = (x, y, radius) => ({ kind: "circle", x, y, radius, ink: "gold", filled: true });

/** Arrows that run along the belt. */
function arrows(steps) {
  const way = ((steps * 2) / 60) % 1.5;
  return Array.from({ length: 6 }, (_, i) => {
    const x = 20.6 - 1.5 * i - way;
    return { kind: "line", points: [[x + 0.15, -0.15], [x, -0.3], [x + 0.15, -0.45]], ink: "ink", width: 1.5, opacity: 0.6 };
  });
}

function message({ over, coins, falls, steps }) {
  const taken = COINS.length - coins.length;
  if (over) return `The flag, with ${taken} of ${COINS.length} coins. Restart to begin anew.`;
  if (falls > 0 && taken === 0) return "You fell. Hold jump before the gap.";
  return steps < 400 ? "Collect the coins and reach the flag." : "";
}

/** A computer player: what it holds in the next step. */
export function robot({ world, state }) {
  const [x, y] = state.hero.position;
  const climbs = x > 4.8 && x < 5.2 && y < 3.5; // up through the planks
  const leaps = x > 9.5 && x < 12.5;
  const rides = x > 22 && x < 22.5 && y < 4.4; // on the lift
  return { held: { right: !(climbs || rides), up: climbs || leaps } };
}
