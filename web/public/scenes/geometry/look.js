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
  const bounds = Object.fromEntries(VOLUMES.map((kind) => {
    const [first, second] = [a, b].map((shape) => geometry.volumeAround(thud, kind, shape));
    return [kind, { first, second, overlap: geometry.volumesOverlap(thud, first, second) }];
  }));
  return {
    shapes: [a, b],
    ways: [wayA, wayB],
    closest: geometry.closestPoints(thud, a, b),
    collision: geometry.timeOfCollision(thud, ...moving, 2 ** -HALVINGS),
    impact,
    least: leastSeparation(thud, geometry, moving),
    sum: sumOf(thud, geometry, a, b),
    crossing: geometry.castInSum(thud, ...moving),
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
    const { least, leastTime } = geometry.circlesApproach(thud, ...moving);
    return { distance: least - a.radius - b.radius, time: leastTime, closed: true };
  }
  const distanceAt = (time) =>
    geometry.closestPoints(thud, along(a, wayA, time), along(b, wayB, time)).distance;
  let [from, to] = [0, 1];
  for (let i = 0; i < 40; i++) {
    const third = (to - from) / 3;
    if (distanceAt(from + third) <= distanceAt(to - third)) to -= third;
    else from += third;
  }
  return { distance: distanceAt(from), time: from, closed: false };
}

/** What a clock that may be as coarse as a millisecond takes for long enough. */
const LONG_ENOUGH = 8;

/**
 * Measures tests per microsecond, each once for every two kinds of shapes, and one test a picture, so
 * that the picture does not stand still for it.
 */
export function addClock(thud, geometry) {
  const known = new Map();
  const measure = (a, b, exact) => {
    for (let count = 2 ** 14; ; count *= 4) {
      const start = performance.now();
      geometry.overlapOften(thud, a, b, exact, count);
      const milliseconds = performance.now() - start;
      if (milliseconds >= LONG_ENOUGH) return count / (1000 * milliseconds);
    }
  };
  return {
    /** By the test’s name; what is not measured yet is undefined. */
    costs({ shapes: [a, b], bounds }) {
      const keyOf = (name) => [name, a.kind, b.kind].join();
      const missing = ["exact", ...VOLUMES].find((name) => !known.has(keyOf(name)));
      if (missing) {
        const { first, second } = bounds[missing] ?? { first: a, second: b };
        known.set(keyOf(missing), measure(first, second, missing === "exact"));
      }
      return Object.fromEntries(
        ["exact", ...VOLUMES].map((name) => [name, known.get(keyOf(name))]),
      );
    },
  };
}
