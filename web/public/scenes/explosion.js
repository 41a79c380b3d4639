// Explosions between crates, of which one half stands behind a wall. What is in the open flies; the
// wall gives cover, and so does a crate to the one behind it. Click or tap to set off more.

import { partsOf } from "./joints/parts.js";
import { ring } from "./fields/act.js";

export const title = "Explosion";
export const about =
  "Crates in the open fly, and those behind the wall have cover: click or tap for more.";
export const menu = { group: "Water, wind, fire", place: 553 };
export const size = { means: "crates", usual: 40, least: 2, most: 2000 };

const [HALF, APART, NEAREST, ROWS] = [0.5, 1.2, 6, 4];
// By itself, after so many steps.
const BLASTS = [
  { at: 60, center: [0, 0.4], radius: 3, falloff: 14, impulse: 40 },
  { at: 240, center: [8, 6.5], radius: 3, falloff: 10, impulse: 20 },
  { at: 420, center: [-12, 0.4], radius: 3, falloff: 12, impulse: 20 },
];
const OF_VISITOR = { radius: 2, falloff: 9, impulse: 20 };
const SEEN = 40; // steps

export default function ({ createWorld, grid, size }) {
  const world = createWorld();
  const parts = partsOf(world, grid);
  const pairs = Math.floor((size + 1) / 2);
  const half = NEAREST + APART * Math.floor(pairs / ROWS) + 4;
  addGround(world, parts, half);
  for (let i = 0; i < pairs; i++) {
    const x = NEAREST + APART * Math.floor(i / ROWS);
    const y = HALF + 2 * HALF * (i % ROWS);
    for (const side of [-1, 1])
      if (i % 7 === 3) parts.circle([side * x, y], HALF, { friction });
      else parts.box([side * x, y], HALF, HALF, { friction });
  }

  const scene = {
    world,
    view: { x: 0, y: 4.6, height: 13, width: 2 * half + 2 },
    spawn: [0, 9],
    keys: { fire: "explode" },
    pointer: true,
    state: { step: 0, pressed: false, recent: [] },
    update,
    paint: () => ({ marks: marks(scene.state) }),
  };
  return scene;

  function update({ step, held, pointer }) {
    const { state } = scene;
    state.step = step;
    state.recent = state.recent.filter((blast) => step - blast.at <= SEEN);
    for (const { at, ...blast } of BLASTS)
      if (at === step) explode(blast);
    const pressed = held.fire || (pointer?.down ?? false);
    if (pressed && !state.pressed)
      explode({ ...OF_VISITOR, center: pointer ? [pointer.x, pointer.y] : [0, 0.4] });
    state.pressed = pressed;
  }

  function explode(explosion) {
    world.explode(explosion);
    scene.state.recent.push({ at: scene.state.step, center: explosion.center });
  }
}

function marks({ step, recent }) {
  return recent.flatMap(({ at, center }) => ring(center, (step - at) / SEEN));
}

const friction = 0.6;

function addGround(world, { fixed, addBar }, half) {
  const points = [
    [-half - 31, 60], [-half - 30, 14], [-half - 12, 4], [-half - 4, 0],
    [half + 4, 0], [half + 12, 4], [half + 30, 14], [half + 31, 60],
  ];
  world.createTerrain(fixed().body, { kind: "irregular", points }, { friction });
  world.createAabb(fixed([4, 2.2]).body, { halfWidth: 0.3, halfHeight: 2.2, friction });
  const shelter = fixed([half, 0]);
  addBar(shelter, [half - 2, 2.6], [half + 2, 2.6], 0.2, { friction });
  addBar(shelter, [half - 1.8, 0], [half - 1.8, 2.4], 0.2, { friction });
}
