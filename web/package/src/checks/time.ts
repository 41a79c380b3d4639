/** Checks of times: milliseconds that are given to `advance`, and any argument of `step`. */
import { ThudError } from "../error.js";
import { show } from "./show.js";

/** Seconds (THUD_ADVANCE_MAX): the engine itself refuses more. */
const LONGEST = 1e9;

/**
 * The largest ratio of simulated to real time that is taken as meant. Chosen, above what a game
 * plays at and below 1000, the ratio where milliseconds are taken for seconds.
 */
const FASTEST = 100;

/** By world, when `advance` last dropped time: seconds on the host's clock. */
const leftOut = new WeakMap<object, number>();

/**
 * Throws "invalid" where `elapsed` seems to be in milliseconds: it is more than `made`, the seconds
 * that the steps of the call cover, so that time is dropped, and more than FASTEST times the time
 * on the clock since this world last dropped time (the first time: more than the program has run).
 * A page that returns to the foreground after a minute passes the test, and so does a game that
 * runs at ten times its speed.
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

/** Throws "invalid": `step` takes no argument, and `given` is one. */
export function checkStep(given: unknown): void {
  const why = "a step is as long as setTimeStep says, and takes no argument; advance takes seconds";
  throw new ThudError("invalid", `step: ${show(given)} is not taken: ${why}`);
}
