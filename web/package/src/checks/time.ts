/** Times that a world is given in the wrong unit, or where it takes none. */
import { ThudError } from "../error.js";
import { show } from "./show.js";

/** Seconds; the engine refuses more. */
const LONGEST = 1e9;

/** Nobody shows a game so many times as fast as it is, and milliseconds are a thousand times as many. */
const FASTEST = 100;

/** When a world last left out time, by the clock of the host. */
const leftOut = new WeakMap<object, number>();

/**
 * Refuses milliseconds, which are known by this: more time goes by than the clock says, and most of it
 * is left out, as steps make up for `made` at most. A page that comes back to the front after a minute
 * does not look so, nor does a game that runs ten times as fast. A world that never left out time is
 * taken to have begun with the program.
 */
export function checkElapsed(world: object, elapsed: number, made: number): void {
  if (elapsed <= made || !(elapsed <= LONGEST)) return;
  const now = performance.now() / 1000;
  const before = leftOut.get(world);
  const most = before === undefined ? now : FASTEST * (now - before);
  leftOut.set(world, now);
  if (elapsed <= most) return;
  const why = "s are more than have passed; milliseconds are to be divided by 1000";
  throw new ThudError("invalid", `advance: ${elapsed} ${why}`);
}

/** Refuses what a step is given. */
export function checkStep(given: unknown): void {
  const why = "a step is as long as setTimeStep says, and takes no argument; advance takes seconds";
  throw new ThudError("invalid", `step: ${show(given)} is not taken: ${why}`);
}
