/**
 * The measurement "Heavier": the largest size of a scene at which an engine makes its steps in
 * time. An engine "holds" a size if the median time of its steps stays within the budget in every
 * second of the scene; else it "misses" the size.
 *
 * The size is doubled until it is missed; then the range between the largest size that was held and
 * the smallest that was missed is narrowed, by trying the geometric mean of both. Other load of the
 * device can only slow a try, so a size that was missed is tried a second time; and the largest
 * size must be held once more at the end, else the next smaller one that was held is tried.
 */
import { percentile } from "../shared/step-times";
import type { Box2DSetting } from "./measure-settings";
import { type Laboratory, Trial, warmUp } from "./measure-trial";
import type { SceneRequest } from "./protocol";
import type { SceneSize } from "../scene/scene";

/** A size that was tried, and what its steps took. */
export interface Load {
  engine: "thud" | "box2d";
  size: number;
  bodies: number;
  /** The largest median over one second of steps, in ms. No body sleeps. */
  milliseconds: number;
}

/** The result for one engine: the largest size that it holds lies between the two. */
export interface Holding {
  engine: Load["engine"];
  /**
   * The largest size that was held, also when tried again at the end; null: not even the smallest.
   */
  held: Load | null;
  /**
   * The smallest size that was missed during the search; null: the scene's largest size was held.
   */
  missed: Load | null;
}

export interface Heaviest {
  holdings: Holding[];
  /** What the scene has and Box2D is not given, in a few words each. */
  misses: string[];
}

export interface HeavierProgress {
  /** The size that is being tried, with its slowest second so far. */
  trying: Load;
  /** The results so far. */
  holdings: Holding[];
}

/** Length of a try, in seconds of the scene. Chosen: long enough for bodies to fall and pile up. */
const SPAN = 4;
/** Milliseconds that each engine runs before the first try; see warmUp. */
const WARM_UP = 600;
/**
 * The search ends when the number of bodies at the missed size is at most this times that at the
 * held one. Chosen.
 */
const NEAR = 1.1;
/** Smallest time between two progress messages, in ms. Chosen. */
const OFTEN = 150;

/**
 * Finds the largest size that each engine holds. `sizes` are those of the scene; `hertz` is the
 * number of steps that must be made per second, so the budget of a step is 1000 / `hertz` ms.
 */
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
    /** The sizes that were held at least once, smallest first. */
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

/**
 * Tries the largest held size again; if it is missed now, the next smaller one, and so on. Sets
 * `holding.held` to the size that was held again, or to null.
 */
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

/** The size to try next; null when the range is narrow enough or has no size within it. */
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

/** Runs the scene at a size until it ends or the median of one second exceeds 1000 / `hertz` ms. */
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
