/**
 * The measurement “Detection, priced”: each detection at several step rates, on the two motions of
 * the scene lab_prices, which are known in closed form. The error is the mean distance of the balls
 * at the end from where the closed form puts them; the price is the time of the steps, the least of
 * several rounds.
 */
import type { Detection, Engine, World } from "thud";
import { type CallPrice, measureCalls } from "./measure-calls";

/** What this needs of web/public/scenes/lab_prices/motions.js. */
interface Motions {
  LANES: readonly Detection[];
  RATES: readonly number[];
  SECONDS: number;
  MOTIONS: Readonly<Record<string, unknown>>;
  createMotion(engine: Engine, name: string, detection: Detection, rate: number): Made;
  errorOf(made: Made, name: string, time: number): number;
}

interface Made {
  world: World;
  balls: readonly unknown[];
}

export interface Price {
  motion: string;
  detection: Detection;
  /** Steps a second. */
  rate: number;
  /** Milliseconds of the steps for a simulated second. */
  time: number;
  /** Metres. */
  error: number;
}

/** The results: those of detections in worlds, and those of single calls without a world. */
export interface Prices {
  worlds: Price[];
  calls: CallPrice[];
}

export interface PriceProgress {
  /** The share that is done, 0 to 1. */
  done: number;
  doing: string;
}

/**
 * Number of rounds; the result is the least time of all. During the first round the browser
 * compiles the code to a faster form.
 */
const ROUNDS = 5;

/** `base`: the page's address, from which the motions are imported as scenes are. */
export async function measurePrices(
  engine: Engine,
  base: string,
  report: (progress: PriceProgress) => void,
): Promise<Prices> {
  const { href } = new URL("scenes/lab_prices/motions.js", base);
  const motions = (await import(/* @vite-ignore */ href)) as Motions;
  const prices = Object.keys(motions.MOTIONS).flatMap((motion) =>
    motions.LANES.flatMap((detection) =>
      motions.RATES.map((rate): Price => ({ motion, detection, rate, time: Infinity, error: 0 })),
    ),
  );
  for (let round = 0; round < ROUNDS; round++)
    for (const [i, price] of prices.entries()) {
      const { motion, detection, rate } = price;
      const done = (round + i / prices.length) / ROUNDS;
      report({ done, doing: `${motion}, ${detection} at ${rate} steps a second` });
      const { time, error } = runOnce(engine, motions, price);
      price.time = Math.min(price.time, time);
      price.error = error;
    }
  report({ done: 1, doing: "one call, bisected and swept" });
  return { worlds: prices, calls: await measureCalls(engine) };
}

function runOnce(
  engine: Engine,
  { SECONDS, createMotion, errorOf }: Motions,
  { motion, detection, rate }: Price,
): Pick<Price, "time" | "error"> {
  const made = createMotion(engine, motion, detection, rate);
  try {
    const steps = Math.round(SECONDS * rate);
    const start = performance.now();
    for (let i = 0; i < steps; i++) made.world.step();
    const time = (performance.now() - start) / SECONDS;
    return { time, error: errorOf(made, motion, SECONDS) };
  } finally {
    made.world.close();
  }
}
