// What a look-up takes on lines of each kind, measured by a clock, and the steps of its search.

const KINDS = ["flat", "uniform", "irregular"];
/** Milliseconds that a clock which may be as coarse as one of them takes for long enough. */
const LONG_ENOUGH = 5;
/** The first batches run in code that the browser has not yet made fast. */
const BATCHES = 4;

/** A line of n vertices from x = 0 to x = n - 1. */
export function longLine(kind, n) {
  if (kind === "flat") return { kind, slope: 0.1 };
  const heights = Float64Array.from({ length: n }, (_, i) => Math.sin(0.3 * i));
  if (kind === "uniform") return { kind, x0: 0, spacing: 1, heights };
  const inside = (i) => i > 0 && i < n - 1;
  // Multiples of the golden ratio jitter without a random number.
  const points = Array.from(heights, (y, i) => [inside(i) ? i + 0.8 * (((0.618 * i) % 1) - 0.5) : i, y]);
  return { kind, points };
}

/** Comparisons of the search for one of n - 1 segments, as the engine halves them. */
export function halvings(n) {
  let [steps, candidates] = [0, n - 1];
  for (; candidates > 1; candidates -= Math.floor(candidates / 2)) steps++;
  return steps;
}

export function addClock(thud, geometry) {
  const known = new Map();
  const measure = (kind, n) => {
    const line = longLine(kind, n);
    const milliseconds = (count) => {
      const start = performance.now();
      geometry.terrainAtOften(thud, line, 0, n - 1, count);
      return performance.now() - start;
    };
    let [count, best] = [2 ** 14, Infinity];
    for (let batches = 0; batches < BATCHES; ) {
      // Both calls copy the line: their difference is that of the look-ups alone.
      const more = milliseconds(2 * count) - milliseconds(count);
      if (more < LONG_ENOUGH && count < 2 ** 24) count *= 2;
      else {
        best = Math.min(best, (1e6 * more) / count);
        batches++;
      }
    }
    return best;
  };
  return {
    /** Nanoseconds of a look-up by the kind of line; one more is measured with each picture. */
    costs(n) {
      const keyOf = (kind) => `${kind},${kind === "flat" ? 0 : n}`;
      const missing = KINDS.find((kind) => !known.has(keyOf(kind)));
      if (missing) known.set(keyOf(missing), measure(missing, n));
      return { n, halvings: halvings(n), ...Object.fromEntries(KINDS.map((kind) => [kind, known.get(keyOf(kind))])) };
    },
  };
}
