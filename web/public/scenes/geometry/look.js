// What the engine is asked of two shapes: each answer is one call of the package’s "thud/geometry".

export const LETTERS = ["A", "B"];
export const VOLUMES = ["circle", "aabb", "obb"];
/** Halvings of the ways until a collision is found. */
export const HALVINGS = 20;

const RADIANS = Math.PI / 180;

/** A shape as the calls take it. */
export function shapeOf(state, letter) {
  const [kind, width, height] = ["kind", "width", "height"].map((name) => state[name + letter]);
  const center = [state[`x${letter}`], state[`y${letter}`]];
  if (kind === "circle") return { kind, center, radius: width / 2 };
  const box = { kind, center, halfWidth: width / 2, halfHeight: height / 2 };
  return kind === "aabb" ? box : { ...box, angle: state[`angle${letter}`] * RADIANS };
}

export function wayOf(state, letter) {
  return [state[`wayX${letter}`], state[`wayY${letter}`]];
}

/** The shape a part of its way on. */
export function along(shape, [dx, dy], part) {
  const [x, y] = shape.center;
  return { ...shape, center: [x + part * dx, y + part * dy] };
}

export function look(thud, geometry, state) {
  const [a, b] = LETTERS.map((letter) => shapeOf(state, letter));
  const [wayA, wayB] = LETTERS.map((letter) => wayOf(state, letter));
  const moving = [a, { way: wayA }, b, { way: wayB }];
  const impact = geometry.timeOfImpact(thud, ...moving);
  const least = leastSeparation(thud, geometry, moving);
  const time = impact ?? least.time;
  const bounds = Object.fromEntries(VOLUMES.map((kind) => {
    const [first, second] = [a, b].map((shape) => geometry.volumeAroundShape(thud, kind, shape));
    return [kind, { first, second, overlap: geometry.volumesOverlap(thud, first, second) }];
  }));
  return {
    shapes: [a, b],
    ways: [wayA, wayB],
    closest: geometry.closest(thud, a, b),
    collision: geometry.timeOfCollision(thud, ...moving, 2 ** -HALVINGS),
    impact,
    least,
    /** At their impact, or where they pass each other. */
    passing: geometry.closest(thud, along(a, wayA, time), along(b, wayB, time)),
    sum: sumOf(thud, geometry, a, b),
    crossing: geometry.minkowskiCast(thud, ...moving),
    bounds,
  };
}

/** The sum of both about the first one’s centre. */
function sumOf(thud, geometry, { center: [x, y], ...a }, { center, ...b }) {
  return geometry.minkowskiSum(thud, a, b, [center[0] - x, center[1] - y]);
}

/**
 * How near two shapes come to each other on their ways, and when. Of circles that is a closed form.
 * Without turning, the distance of others has one valley along the way, because they are convex: it
 * is looked for between two times, of which the higher end is cut off by a third again and again.
 */
function leastSeparation(thud, geometry, moving) {
  const [a, { way: wayA }, b, { way: wayB }] = moving;
  if (a.kind === "circle" && b.kind === "circle") {
    const { minDistance, minDistanceTime } = geometry.approach(thud, ...moving);
    return { distance: minDistance - a.radius - b.radius, time: minDistanceTime, closed: true };
  }
  const distanceAt = (time) =>
    geometry.closest(thud, along(a, wayA, time), along(b, wayB, time)).distance;
  let [from, to] = [0, 1];
  for (let i = 0; i < 40; i++) {
    const third = (to - from) / 3;
    if (distanceAt(from + third) <= distanceAt(to - third)) to -= third;
    else from += third;
  }
  return { distance: distanceAt(from), time: from, closed: false };
}

/** Milliseconds that a clock which may be as coarse as one of them takes for long enough. */
const LONG_ENOUGH = 6;
/** The first batches run in code that the browser has not yet made fast. */
const BATCHES = 5;

/**
 * Measures tests per microsecond, each once for every two kinds of shapes, and one test a picture, so
 * that the picture does not stand still for it.
 */
export function addClock(thud, geometry) {
  const known = new Map();
  const measure = (a, b, exact) => {
    let [count, best] = [2 ** 12, 0];
    for (let batches = 0; batches < BATCHES; ) {
      const start = performance.now();
      geometry.overlapOften(thud, a, b, exact, count);
      const milliseconds = performance.now() - start;
      if (milliseconds < LONG_ENOUGH) count *= 2;
      else {
        best = Math.max(best, count / (1000 * milliseconds));
        batches++;
      }
    }
    return best;
  };
  return {
    /** By the test’s name; what is not measured yet is undefined. */
    costs({ shapes: [a, b], bounds }) {
      const keyOf = (name) => [name, a.kind, b.kind].join();
      const names = ["exact", ...Object.keys(bounds)];
      const missing = names.find((name) => !known.has(keyOf(name)));
      if (missing) {
        const { first, second } = bounds[missing] ?? { first: a, second: b };
        known.set(keyOf(missing), measure(first, second, missing === "exact"));
      }
      return Object.fromEntries(names.map((name) => [name, known.get(keyOf(name))]));
    },
  };
}
