// The ground of the duel: a stretch of a real mountain profile that two tanks can fight over.

const FILES = [100, 200, 300].map((row) => `terrain/jacksboro_${row}.csv`);
const RISE = 1.5 / 74.4; // metres up for one there; along, samples 74.4 m apart stand 1 m apart
const FINER = 4; // vertices from one sample to the next, so that craters are round

/** Half the width of the field, in metres. */
export const REACH = 60;

/** One of the stretches that play well: the first for `share` 0, the last for almost 1. */
export async function chooseGround(readText, share) {
  const texts = await Promise.all(FILES.map((file) => readText(file)));
  const profiles = texts.map((text, i) => readProfile(FILES[i], text));
  const stretches = profiles.flatMap((profile) =>
    profile.slice(2 * REACH).map((_, i) => readStretch(profile.slice(i, i + 2 * REACH + 1))),
  );
  const good = stretches.filter(playsWell);
  if (good.length === 0) throw new Error("no stretch has two level places with a hill between");
  return good[Math.floor(share * good.length)];
}

/** Makes the terrain, with a wall at either end so that nothing rolls off. */
export function buildGround(world, { heights }) {
  const body = world.createBody();
  const line = { kind: "uniform", x0: -REACH, spacing: 1 / FINER, heights };
  for (const side of [-1, 1]) {
    const wall = world.createBody({ position: [side * (REACH + 1), 0] });
    world.createAabb(wall, { halfWidth: 1, halfHeight: 60 });
  }
  return world.createTerrain(body, line, { friction: 0.8 });
}

/** Heights above the sea, in metres. */
function readProfile(file, text) {
  const heights = text
    .trim()
    .split("\n")
    .slice(1) // the names of the columns
    .map((row) => Number(row.split(",")[1]));
  if (heights.length <= 2 * REACH || !heights.every(Number.isFinite))
    throw new Error(`${file} is not a profile of more than ${2 * REACH} heights`);
  return heights;
}

/** Metres above the sea become heights of vertices, and the two most level sites are found. */
function readStretch(elevations) {
  const lowest = Math.min(...elevations);
  const samples = elevations.map((metres) => (metres - lowest) * RISE);
  const heights = Array.from({ length: 2 * REACH * FINER + 1 }, (_, i) => {
    const left = Math.min(Math.floor(i / FINER), 2 * REACH - 1);
    return samples[left] + (i / FINER - left) * (samples[left + 1] - samples[left]);
  });
  return { samples, heights, sites: [levelSite(samples, -19, -14), levelSite(samples, 14, 19)] };
}

function levelSite(samples, from, to) {
  let best = { slope: Infinity };
  for (let x = from; x <= to; x++) {
    const [left, middle, right] = samples.slice(x + REACH - 1, x + REACH + 2);
    const slope = Math.max(Math.abs(middle - left), Math.abs(right - middle));
    if (slope < best.slope) best = { x, y: middle, slope };
  }
  return best;
}

/** Level sites, neither far above the other, with a hill between them but no wall. */
function playsWell({ samples, sites: [left, right] }) {
  const hill = Math.max(...samples.slice(left.x + REACH, right.x + REACH + 1));
  const rise = hill - Math.max(left.y, right.y);
  const around = Math.max(...samples.slice(REACH - 24, REACH + 25));
  return (
    Math.max(left.slope, right.slope) < 0.25 &&
    Math.abs(left.y - right.y) < 4 &&
    rise > 1.5 &&
    rise < 7 &&
    around - Math.min(left.y, right.y) < 9
  );
}
