// The players that play by themselves. A player sees where everything truly is, however late it is
// for the peers’ pictures: so the game is the same at each setting, and pictures can be compared.

/** A number in [-1, 1) of two whole numbers: the last lines of MurmurHash3, by Austin Appleby. */
export function chance(a, b) {
  let h = Math.imul(a, 0x9e3779b1) ^ Math.imul(b + 1, 0x85ebca6b);
  h = Math.imul(h ^ (h >>> 16), 0x85ebca6b);
  h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
  return ((h ^ (h >>> 16)) | 0) / 0x80000000;
}

/** Steps between two whims. */
const WHIM = 24;

/**
 * Where a player makes for, relative to the rink’s middle: behind the puck and through it while it
 * is slow and near, else to its own goal. `puck`: x, y and both velocities, relative as well.
 */
export function wish(side, puck, mallet, step, seed) {
  const own = side === 0 ? 1 : -1; // from here on both play to the right
  const [x, y, vx, vy] = [own * puck[0], puck[1], own * puck[2], puck[3]];
  const whim = chance(Math.floor(step / WHIM), 7 * seed + side);
  // Now and then a player draws back, or both would hold the puck between them for ever.
  const rests = chance(Math.floor(step / WHIM), 7 * seed + side + 3) < -0.6;
  const home = [-3.9 + 0.4 * whim, Math.max(-1.1, Math.min(1.1, 0.7 * y + 0.4 * whim))];
  if (x > 0.6 || vx > 4 || rests) return [own * home[0], home[1]];
  const [aheadX, aheadY] = [x + 0.06 * vx, y + 0.06 * vy];
  // From the side it goes round the puck; from behind it strikes towards a place on the goal line.
  if (own * mallet[0] > aheadX - 0.2)
    return [own * (aheadX - 1.3), aheadY + (mallet[1] > aheadY ? 0.9 : -0.9)];
  const [goX, goY] = [5 - aheadX, 1.6 * whim - aheadY];
  const length = Math.hypot(goX, goY) || 1;
  return [own * (aheadX + (0.9 * goX) / length), aheadY + (0.9 * goY) / length];
}
