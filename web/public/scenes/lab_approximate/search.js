// The calls of “approximate”: one for the count that is set, and for the curve one for each of its
// counts. A call takes longer than a picture, so that they are made one by one, with pauses.

/** The most pieces. */
export const MOST = 24;
/** The counts of the curve. */
export const COUNTS = [1, 2, 3, 4, 5, 6, 8, 10, 12, 16, 20, MOST];
/** A pause is so many times as long as the call before it. */
const PAUSE = 5;

export function createSearch(thud, geometry) {
  /** By count what is known of the polygon and the kinds of pieces that `key` stands for. */
  let [key, known] = ["", new Map()];
  /** What was found last, and the time from which on the next call may be made. */
  let [last, pausedUntil] = [null, 0];

  const find = (points, kinds, count) => {
    const start = performance.now();
    const found = geometry.approximate(thud, points, { shapes: count, kinds });
    const end = performance.now();
    pausedUntil = end + PAUSE * (end - start);
    known.set(count, { ...found, milliseconds: end - start });
  };
  return {
    /**
     * { found, known, reason }: the pieces of the count in the state; by count what is known of the
     * curve; and why these points are no polygon, else null. While a corner is dragged, the pieces
     * may be those of a moment ago, and the curve waits.
     */
    look(points, { kinds, count, curve }, dragged) {
      const wanted = JSON.stringify([points, kinds]);
      if (wanted !== key) {
        if (dragged && last && performance.now() < pausedUntil)
          return { found: last, known: new Map(), reason: null };
        [key, known] = [wanted, new Map()];
      }
      try {
        if (!known.has(count)) find(points, kinds, count);
        last = known.get(count);
        const next = COUNTS.find((n) => !known.has(n));
        if (curve && !dragged && next && performance.now() >= pausedUntil) find(points, kinds, next);
        return { found: last, known, reason: null };
      } catch (error) {
        last = null;
        return { found: null, known: new Map(), reason: error.message.replace("approximate: ", "") };
      }
    },
  };
}
