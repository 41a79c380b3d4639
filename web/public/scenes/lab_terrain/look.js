// What the engine is asked of the line: each answer is one call of the package’s "thud/geometry".

import { coordinatesOf, ENDS, FLAT_AT, pointsOf } from "./line.js";

import { BOX, START } from "./runner.js";

/** Width of a sole, and of a stripe of the texture, in world units. */
export const SOLE = 0.5;
export const STRIPE = 0.4;

export function look(thud, geometry, state, line, texture) {
  const { x, stance } = state;
  const ground = geometry.terrainAt(thud, line, x);
  const points = pointsOf(state);
  const feet = [-0.5, 0.5].map((side) => {
    const at = Math.min(ENDS[1], Math.max(ENDS[0], x + side * stance));
    return { at, ...geometry.footOn(thud, line, at, SOLE) };
  });
  const frictionAt = (at) => geometry.frictionAt(thud, line, at, texture);
  const stripes = Math.round((ENDS[1] - ENDS[0]) / STRIPE);
  return {
    x,
    ground,
    points,
    /** The two vertices that are weighted. */
    beside: state.line === "flat" ? FLAT_AT.map((at) => [at, line.slope * at]) : points.slice(ground.segment, ground.segment + 2),
    u: geometry.textureAt(thud, line, x, coordinatesOf(state).map((u) => [u, 0]))[0],
    friction: frictionAt(x),
    feet,
    stance: geometry.footOn(thud, line, x, stance),
    stop: state.box ? stopOf(thud, geometry, state.speed, line, frictionAt) : null,
    stripes: Array.from({ length: stripes }, (_, i) => {
      const at = ENDS[0] + STRIPE * (i + 0.5);
      const { height, normal } = geometry.terrainAt(thud, line, at);
      return { at, height, normal, friction: frictionAt(at) };
    }),
  };
}

const GRAVITY = 10;
/** Of the sum below, in world units. */
const PIECE = 0.1;

/**
 * Where a box stops that never leaves the ground: v dv = -g (friction + slope) dx, summed up from its
 * start on. Null: it reaches the end.
 */
function stopOf(thud, geometry, speed, line, frictionAt) {
  let left = speed * speed;
  for (let x = START; x < ENDS[1] - PIECE; x += PIECE) {
    const at = x + PIECE / 2;
    const [nx, ny] = geometry.terrainAt(thud, line, at).normal;
    const loss = 2 * GRAVITY * (Math.sqrt(frictionAt(at) * BOX.friction) - nx / ny);
    if (loss * PIECE > left) return x + left / loss;
    left -= loss * PIECE;
  }
  return null;
}
