/** Times of single steps, in milliseconds: the budget, and statistics of many of them. */

/** Milliseconds that a step may take at 60 Hz. */
export const BUDGET = 1000 / 60;

/** Steps at the start of a scene that percentiles leave out: in them the world's arrays grow to
 * their size, and the browser compiles the code that runs often. Chosen. */
export const START_UP = 30;

/** Resolution of performance.now() in milliseconds. Browsers make it coarser on pages that are not
 * cross-origin isolated. */
const TICK = self.crossOriginIsolated ? 0.005 : 0.1;

/** The percentile of values in any order, `part` from 0 to 1; 0 if there are no values. */
export function percentile(values: readonly number[], part: number): number {
  if (values.length === 0) return 0;
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.min(sorted.length - 1, Math.floor(part * sorted.length))];
}

/**
 * A typical time: the median. If the median is below ten ticks of the clock, which round times to
 * few values, it is the mean without the slowest 2 %, in which the processor did something else.
 */
export function typical(times: readonly number[]): number {
  const median = percentile(times, 0.5);
  if (median >= 10 * TICK) return median;
  const sorted = [...times].sort((a, b) => a - b);
  return mean(sorted.slice(0, Math.ceil(0.98 * sorted.length)));
}

/** The mean; 0 if there are no values. */
export function mean(values: readonly number[]): number {
  return values.reduce((sum, value) => sum + value, 0) / Math.max(1, values.length);
}
