// The world’s ground, which follows the state, and the box that slides over it again and again.

import { lift } from "./hands.js";
import { ENDS, lineOf, textureOf } from "./line.js";

export const BOX = { halfWidth: 0.35, halfHeight: 0.2, friction: 1 };
export const START = -7.2;
/** Steps after which a box that rests has stopped, and after which it slides again. */
const RESTED = 20;
const AGAIN = 110;
const SLOW = 0.02; // metres a second

export function addRunner(world, state) {
  const body = world.createBody();
  for (const x of [ENDS[0] - 0.5, ENDS[1] + 0.5])
    world.createAabb(world.createBody({ position: [x, 0.5] }), { halfWidth: 0.5, halfHeight: 3.6 });
  const box = world.createBody({ kind: "dynamic", position: [START, 3] });
  world.createObb(box, BOX);
  Object.assign(state, { ground: null, made: "", woven: "", still: AGAIN, stop: null, fired: false });
  follow(world, body, state);

  return {
    /** Before each step. */
    update(now, { held }) {
      const move = Number(held.right) - Number(held.left);
      if (move) now.x = Math.round(20 * Math.min(7.9, Math.max(-7.9, now.x + 0.05 * move))) / 20;
      const rise = Number(held.up) - Number(held.down);
      if (rise) lift(now, 0.05 * rise);
      follow(world, body, now);
      const fires = held.fire && !now.fired;
      now.fired = held.fire;
      if (fires || now.still >= AGAIN) start(world, box, now);
      const { velocity, position } = world.bodyStateOf(box);
      now.still = Math.hypot(...velocity) < SLOW ? now.still + 1 : 0;
      if (now.still === RESTED) now.stop = position[0];
    },
    /** Where the box is, how fast, and the frictions under it. */
    look(now) {
      const { position, velocity } = world.bodyStateOf(box);
      const ground = world.frictionAt(now.ground, position[0]);
      return { position, speed: Math.hypot(...velocity), ground, pair: Math.sqrt(ground * BOX.friction) };
    },
  };
}

/** Makes or changes the world’s line and its texture where the state’s are others. */
function follow(world, body, state) {
  const line = lineOf(state);
  const [made, woven] = [JSON.stringify(line), JSON.stringify(textureOf(state))];
  if (made !== state.made) {
    const isEdit = state.ground && line.kind !== "flat" && line.kind === JSON.parse(state.made).kind;
    if (isEdit && line.kind === "uniform") world.setHeights(state.ground, 0, line.heights);
    else if (isEdit) world.replaceRange(state.ground, ...ENDS, line.points);
    else {
      if (state.ground) world.destroy(state.ground);
      state.ground = world.createTerrain(body, line);
    }
    state.woven = "";
    state.made = made;
  }
  // An edit leaves the texture where it lay; here it goes with the vertices.
  if (woven !== state.woven) world.setTexture(state.ground, textureOf(state));
  state.woven = woven;
}

/** Puts the box on the left end, along the ground. */
function start(world, box, state) {
  const { height, normal: [nx, ny] } = world.groundAt(state.ground, START);
  const up = BOX.halfHeight;
  world.setTransform(box, [START + up * nx, height + up * ny], Math.atan2(-nx, ny));
  world.setVelocity(box, [state.speed * ny, -state.speed * nx], 0);
}
