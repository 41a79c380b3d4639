/**
 * "Heavier": between which sizes of a scene an engine stops making its steps in time. The size is
 * doubled until it does not, and then halved in between. Whatever else the device does can only slow
 * a try, so that a miss is tried again; and the size that was held must hold once more at the end,
 * or a smaller one.
 */
import { percentile } from "../shared/step-times";
import type { Box2DSetting } from "./measure-settings";
import { type Laboratory, Trial, warmUp } from "./measure-trial";
import type { SceneRequest } from "./protocol";
import type { SceneSize } from "../scene/scene";

export interface Load {
  engine: "thud" | "box2d";
  size: number;
  bodies: number;
  /** Median of a step in the slowest second; nothing sleeps. */
  milliseconds: number;
}

/** A range: what an engine holds lies from one to the other. */
export interface Holding {
  engine: Load["engine"];
  /** The largest that was held each time it was tried; null: not even the smallest size. */
  held: Load | null;
  /** The smallest that was not held; null: none, the scene has no more. */
  missed: Load | null;
}

export interface Heaviest {
  holdings: Holding[];
  /** What Box2D is not given of the scene. */
  misses: string[];
}

export interface HeavierProgress {
  /** What is being tried; of the slowest second so far. */
  trying: Load;
  /** What has been found out. */
  holdings: Holding[];
}

/** Of the scene, in seconds: long enough for things to fall and pile up. */
const SPAN = 4;
const WARM_UP = 600;
/** The answer is this near: sizes at most so far apart, as a ratio. */
const NEAR = 1.1;
/** Milliseconds between two messages. */
const OFTEN = 150;

/** `sizes` are the scene's; `hertz` is how often a step must be ready. */
export async function findHoldings(
  laboratory: Laboratory,
  request: SceneRequest,
  sizes: SceneSize,
  hertz: number,
  report: (progress: HeavierProgress) => void,
): Promise<Heaviest> {
  const first = Math.max(1, sizes.least, Math.floor(sizes.usual / 8));
  await warmUp(laboratory, { ...request, size: first }, WARM_UP);
  const holdings: Holding[] = [];
  const misses = new Set<string>();
  for (const engine of laboratory.box2d ? (["thud", "box2d"] as const) : (["thud"] as const)) {
    const holding: Holding = { engine, held: null, missed: null };
    holdings.push(holding);
    const tell = (trying: Load) => report({ trying, holdings: structuredClone(holdings) });
    const tryOnce = (size: number) => tryLoad(laboratory, request, engine, size, hertz, misses, tell);
    /** Those that were held at least once, upwards. */
    const held: Load[] = [];
    for (let size: number | null = first; size !== null; size = nextSize(holding, sizes)) {
      let tried = await tryOnce(size);
      if (!tried.held) tried = await tryOnce(size);
      holding[tried.held ? "held" : "missed"] = tried.load;
      if (tried.held) held.push(tried.load);
    }
    await confirm(holding, held, tryOnce);
  }
  return { holdings, misses: [...misses] };
}

/** Down to a size that is held again. */
async function confirm(
  holding: Holding,
  held: Load[],
  tryOnce: (size: number) => Promise<{ load: Load; held: boolean }>,
): Promise<void> {
  while (held.length > 0) {
    const { load, held: again } = await tryOnce(held.at(-1)!.size);
    const milliseconds = Math.max(load.milliseconds, held.at(-1)!.milliseconds);
    holding.held = again ? { ...load, milliseconds } : null;
    if (again) return;
    holding.missed ??= load;
    held.pop();
  }
}

/** Null when it is known well enough. */
function nextSize({ held, missed }: Holding, { least, most }: SceneSize): number | null {
  if (!missed) {
    const size = Math.min(most, 2 * held!.size);
    return size > held!.size ? size : null;
  }
  if (!held) {
    const size = Math.max(1, least, Math.floor(missed.size / 2));
    return size < missed.size ? size : null;
  }
  if (missed.bodies <= NEAR * held.bodies) return null;
  const between = Math.round(Math.sqrt(held.size * missed.size));
  return between > held.size && between < missed.size ? between : null;
}

async function tryLoad(
  laboratory: Laboratory,
  request: SceneRequest,
  engine: Load["engine"],
  size: number,
  hertz: number,
  misses: Set<string>,
  report: (load: Load) => void,
): Promise<{ load: Load; held: boolean }> {
  const setting: Box2DSetting | undefined = engine === "box2d" ? { substeps: 4 } : undefined;
  const trial = await Trial.open(laboratory, { ...request, size }, setting);
  try {
    const second = Math.round(1 / trial.timeStep);
    const budget = 1000 / hertz;
    const recent: number[] = [];
    const load = { engine, size: trial.size, bodies: trial.bodies, milliseconds: 0 };
    let over = 0;
    let reported = -Infinity;
    for (let i = 0; i < SPAN * second; i++) {
      const now = performance.now();
      if (now - reported > OFTEN) {
        reported = now;
        report(load);
      }
      const time = trial.step();
      recent.push(time);
      if (time > budget) over++;
      if (recent.length > second && recent.shift()! > budget) over--;
      load.bodies = Math.max(load.bodies, trial.bodies);
      const median = percentile(recent, 0.5);
      load.milliseconds = i < second ? median : Math.max(load.milliseconds, median);
      // The median of a second is over the budget as soon as more than half of its steps are.
      if (over > second / 2) return { load, held: false };
    }
    return { load, held: true };
  } finally {
    for (const miss of trial.misses) misses.add(miss);
    trial.close();
  }
}
