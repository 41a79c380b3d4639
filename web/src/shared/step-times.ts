/** Times of single steps, in milliseconds: what they may take, and what many of them come to. */

/** That a step may take at 60 Hz. */
export const BUDGET = 1000 / 60;

/** Steps at the start of a scene that no extreme is told of: worlds grow to their size in them, and
 * browsers compile what runs often. */
export const START_UP = 30;

/** Of the clock; a browser's clock is coarser on pages that are not isolated from all others. */
const TICK = self.crossOriginIsolated ? 0.005 : 0.1;

/** Of values in any order; 0 where there are none. */
export function percentile(values: readonly number[], part: number): number {
  if (values.length === 0) return 0;
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.min(sorted.length - 1, Math.floor(part * sorted.length))];
}

/**
 * The median; of times below ten ticks of the clock, which it rounds to few values, the mean
 * without the slowest fiftieth, in which something else held the processor.
 */
export function typical(times: readonly number[]): number {
  const median = percentile(times, 0.5);
  if (median >= 10 * TICK) return median;
  const sorted = [...times].sort((a, b) => a - b);
  return mean(sorted.slice(0, Math.ceil(0.98 * sorted.length)));
}

export function mean(values: readonly number[]): number {
  return values.reduce((sum, value) => sum + value, 0) / Math.max(1, values.length);
}
