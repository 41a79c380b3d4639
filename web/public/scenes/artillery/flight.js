// How a shell flies: p = p0 + v t + a t^2 / 2, with gravity and wind as the acceleration a.

export const GRAVITY = 10;

/**
 * Cosine and sine of an angle from 0 to 180 degrees, by their series. Math.cos and Math.hypot may give
 * other last bits in another browser, and then two players over a network would have two games.
 */
export function directionOf(degrees) {
  const quarter = degrees > 135 ? 2 : degrees > 45 ? 1 : 0;
  const x = ((degrees - 90 * quarter) * Math.PI) / 180;
  let [cosine, sine, term] = [0, 0, 1];
  for (let n = 0; n < 16; n += 2) {
    cosine += term;
    term = (term * x) / (n + 1);
    sine += term;
    term = (-term * x) / (n + 2);
  }
  return [[cosine, sine], [-sine, cosine], [-cosine, -sine]][quarter];
}

/** The length of a vector, by operations that are rounded alike everywhere. */
export const lengthOf = ([x, y]) => Math.sqrt(x * x + y * y);

export function flightAt(from, velocity, wind, time) {
  return [
    from[0] + velocity[0] * time + 0.5 * wind * time * time,
    from[1] + velocity[1] * time - 0.5 * GRAVITY * time * time,
  ];
}

/**
 * The speed at which a shell in this direction meets the target, and after how many seconds; null
 * if it does at none. From v t u = d - a t^2 / 2: crossed with u it has t alone, dotted with u the
 * speed v.
 */
export function solveSpeed(from, direction, target, wind) {
  const [ux, uy] = direction;
  const [dx, dy] = [target[0] - from[0], target[1] - from[1]];
  const squared = (2 * (ux * dy - uy * dx)) / (-ux * GRAVITY - uy * wind);
  if (!(squared > 0)) return null;
  const time = Math.sqrt(squared);
  const along = ux * (dx - 0.5 * wind * squared) + uy * (dy + 0.5 * GRAVITY * squared);
  return along > 0 ? { speed: along / time, time } : null;
}

/** Whether nothing is in the way, but for the last metres. */
export function isClear(world, from, velocity, wind, time) {
  const shape = { kind: "circle", radius: 0.4 }; // a shell with room about it
  const step = 0.1;
  for (let t = 0; t + step < 0.9 * time; t += step) {
    const here = flightAt(from, velocity, wind, t);
    const next = flightAt(from, velocity, wind, t + step);
    if (world.castShape(shape, here, [next[0] - here[0], next[1] - here[1]])) return false;
  }
  return true;
}
