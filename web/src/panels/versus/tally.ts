/**
 * `Tally`: collects the samples of thud and Box2D while they run side by side. It computes the
 * table's figures (time per step, overlap, energy, joint gaps), and keeps the curves of the plots.
 */
import { mean, percentile, START_UP } from "../../shared/step-times";
import type { Vec2 } from "thud";
import type { Sample } from "../../scene/frame";

export const ENGINES = ["thud", "box2d"] as const;
export type Engine = (typeof ENGINES)[number];
export const NAMES: Readonly<Record<Engine, string>> = { thud: "thud", box2d: "Box2D" };

/** Last steps of which the median, mean and percentile are computed: 4 s at 60 Hz. Chosen; the
 * table's hints say 240 too. */
const WINDOW = 240;
/** Points of a plot: ten seconds of steps at 60 Hz. Chosen. */
const COURSE = 600;
/** Steps over which the curve of times is averaged where the clock is too coarse to time a single
 * step. Chosen. */
const COARSE = 30;

/** Figures of one engine. */
export interface Figures {
  /** Milliseconds per step, over steps in which both engines have bodies awake: the median, or the
   * mean if the clock is coarse. Null as long as there are no such steps. */
  typical: number | null;
  /** The 99th percentile of the same times; null if the clock is too coarse for single steps. */
  p99: number | null;
  /** The deepest overlap of a step, in world units: of the last measured step, the mean over the
   * measured steps, and their maximum. */
  now: number;
  mean: number;
  ever: number;
  /** Change of kinetic and potential energy since the comparison began. */
  energyChange: number;
  bodies: number;
  awake: number;
  /** The joint that is open the most: its gap now in world units and radians, and the widest gap
   * so far. Null without joints. */
  joints: { gap: number; angle: number; ever: number } | null;
}

/** A curve of each engine over simulated seconds; `values` is in the order of ENGINES. */
export interface Course {
  seconds: number[];
  values: [number[], number[]];
}

/** What `Figures` are computed from. */
interface Sums {
  /** Milliseconds of the last WINDOW steps that count, oldest first. */
  times: number[];
  /** The deepest overlap: now, sum and number over the measured steps, and maximum. */
  now: number;
  sum: number;
  count: number;
  ever: number;
  firstEnergy: number;
  energy: number;
  bodies: number;
  awake: number;
  joints: Figures["joints"];
}

export class Tally {
  /** Curves of milliseconds per step, deepest overlap and change of energy. */
  readonly times: Course = newCourse();
  readonly penetrations: Course = newCourse();
  readonly energies: Course = newCourse();
  /** The step at which Box2D began; null before its first step. */
  since: number | null = null;
  /** The point of the world that is Box2D's origin. */
  origin: Vec2 = [0, 0];
  /** Parts of the scene that Box2D does not have; if there are any, nothing is comparable. */
  misses: readonly string[] = [];
  /** Steps since the comparison began. */
  #counted = 0;
  #sums: { [engine in Engine]: Sums } = { thud: newSums(), box2d: newSums() };

  /** `fineClock`: the clock is fine enough to time single steps. */
  constructor(private readonly fineClock: boolean) {}

  /** Begins a new comparison. */
  clear(): void {
    this.since = null;
    this.origin = [0, 0];
    this.misses = [];
    this.#counted = 0;
    this.#sums = { thud: newSums(), box2d: newSums() };
    for (const course of [this.times, this.penetrations, this.energies]) {
      course.seconds.length = 0;
      for (const values of course.values) values.length = 0;
    }
  }

  /** Adds the samples of new steps; those without Box2D are ignored. `timeStep` in seconds. */
  add(samples: readonly Sample[], timeStep: number): void {
    for (const { step, milliseconds, awake, box2d } of samples) {
      if (!box2d) continue;
      if (box2d.since !== this.since) this.clear();
      this.since = box2d.since;
      this.origin = box2d.origin;
      this.misses = box2d.misses;
      const seconds = step * timeStep;
      this.#sums.thud.awake = awake;
      this.#sums.box2d.awake = box2d.awake;
      this.#addTimes(seconds, [milliseconds, box2d.milliseconds]);
      if (box2d.compared) this.#compare(seconds, box2d.compared);
    }
  }

  /** The present figures of an engine. */
  figures(engine: Engine): Figures {
    const { times, sum, count, now, ever, bodies, awake, joints } = this.#sums[engine];
    const some = times.length > 0;
    return {
      typical: !some ? null : this.fineClock ? percentile(times, 0.5) : mean(times),
      p99: some && this.fineClock ? percentile(times, 0.99) : null,
      now,
      mean: count > 0 ? sum / count : 0,
      ever,
      energyChange: this.#energyChange(engine),
      bodies,
      awake,
      joints,
    };
  }

  /** Change of an engine's energy since the first measured step. */
  #energyChange(engine: Engine): number {
    const { energy, firstEnergy } = this.#sums[engine];
    return energy - firstEnergy;
  }

  /** Adds the milliseconds of a step, for thud and Box2D, at a simulated time in seconds. */
  #addTimes(seconds: number, pair: readonly [number, number]): void {
    // Times count only of steps in which both engines have bodies awake.
    const { thud, box2d } = this.#sums;
    const counts = ++this.#counted > START_UP && thud.awake > 0 && box2d.awake > 0;
    const shown = pair.map((milliseconds, i) => {
      const { times } = this.#sums[ENGINES[i]];
      if (counts) keep(times, milliseconds, WINDOW);
      return this.fineClock || !counts ? milliseconds : mean(times.slice(-COARSE));
    });
    addTo(this.times, seconds, shown);
  }

  /** Adds overlaps, energies and joint gaps, which are measured every few steps. */
  #compare(seconds: number, compared: NonNullable<NonNullable<Sample["box2d"]>["compared"]>): void {
    for (const engine of ENGINES) {
      const sums = this.#sums[engine];
      const { penetration, energy, bodies, jointGap } = compared[engine];
      if (sums.count === 0) sums.firstEnergy = energy;
      sums.count++;
      sums.sum += penetration;
      sums.now = penetration;
      sums.ever = Math.max(sums.ever, penetration);
      Object.assign(sums, { energy, bodies });
      const [gap, angle] = jointGap ?? [];
      const widest = Math.max(sums.joints?.ever ?? 0, gap ?? 0);
      sums.joints = gap === undefined ? null : { gap, angle: angle ?? 0, ever: widest };
    }
    const { thud, box2d } = compared;
    addTo(this.penetrations, seconds, [thud.penetration, box2d.penetration]);
    addTo(this.energies, seconds, ENGINES.map((engine) => this.#energyChange(engine)));
  }
}

function newSums(): Sums {
  const zeros = { now: 0, sum: 0, count: 0, ever: 0, firstEnergy: 0, energy: 0, bodies: 0 };
  return { times: [], ...zeros, awake: 0, joints: null };
}

function newCourse(): Course {
  return { seconds: [], values: [[], []] };
}

/** Appends a point to both engines' curves. */
function addTo({ seconds, values }: Course, at: number, [first, second]: readonly number[]): void {
  keep(seconds, at, COURSE);
  keep(values[0], first, COURSE);
  keep(values[1], second, COURSE);
}

/** Appends a value to a list of the last `most` values. */
function keep(list: number[], value: number, most: number): void {
  list.push(value);
  if (list.length > most) list.shift();
}
