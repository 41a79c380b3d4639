// The line and the texture that the state stands for, as the engine takes them.

export const VERTICES = 9;
/** x of both ends; a uniform line has its vertices at equal distances between. */
export const ENDS = [-8, 8];
export const SPACING = (ENDS[1] - ENDS[0]) / (VERTICES - 1);
/** The vertices that have a neighbour on either side: of an irregular line they can be moved along x. */
export const INNER = Array.from({ length: VERTICES - 2 }, (_, i) => i + 1);
/** How near to each other two vertices of an irregular line may come. */
const GAP = 0.25;

const numbers = Array.from({ length: VERTICES }, (_, i) => i);

/** The places of the vertices: those of an irregular line keep their order, however they are set. */
export function pointsOf(state) {
  if (state.line === "flat") return ENDS.map((x) => [x, slopeOf(state) * x]);
  if (state.line === "uniform") return numbers.map((i) => [ENDS[0] + SPACING * i, state[`y${i}`]]);
  let last = -Infinity;
  return numbers.map((i) => {
    const room = ENDS[1] - GAP * (VERTICES - 1 - i);
    const isEnd = i === 0 || i === VERTICES - 1;
    last = isEnd ? ENDS[Number(i > 0)] : Math.min(room, Math.max(last + GAP, state[`x${i}`]));
    return [last, state[`y${i}`]];
  });
}

/** Flat ground goes through (0, 0); the last vertex says how steeply. */
export function slopeOf(state) {
  return state[`y${VERTICES - 1}`] / ENDS[1];
}

export function lineOf(state) {
  if (state.line === "flat") return { kind: "flat", slope: slopeOf(state) };
  const points = pointsOf(state);
  if (state.line === "irregular") return { kind: "irregular", points };
  return { kind: "uniform", x0: ENDS[0], spacing: SPACING, heights: points.map(([, y]) => y) };
}

/** The vertices that flat ground has for what is interpolated: at x = 0 and x = 1. */
export const FLAT_AT = [0, 1];

/**
 * Texture coordinates go from 0 at the left end to 1 at the right: of flat ground by x, of another
 * line from vertex to vertex in equal steps, so that the texture is stretched where they are far apart.
 */
export function coordinatesOf(state) {
  if (state.line === "flat") return FLAT_AT.map((x) => (x - ENDS[0]) / (ENDS[1] - ENDS[0]));
  return numbers.map((i) => i / (VERTICES - 1));
}

/** The texture: from its first to its last entry friction goes evenly. */
export function textureOf(state) {
  return { vertices: coordinatesOf(state), table: [state.left, state.right] };
}
