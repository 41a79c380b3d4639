/** What two engines side by side took and got wrong: figures of the table, courses of the plots. */
import { mean, percentile, START_UP } from "../../shared/step-times";
import type { Vec2 } from "thud";
import type { Sample } from "../../scene/frame";

export const ENGINES = ["thud", "box2d"] as const;
export type Engine = (typeof ENGINES)[number];
export const NAMES: Readonly<Record<Engine, string>> = { thud: "thud", box2d: "Box2D" };

/** Steps of which times are told. */
const WINDOW = 240;
/** Points of a plot: ten seconds of steps. */
const COURSE = 600;
/** Steps over which times are averaged where the clock is too coarse for one. */
const COARSE = 30;

export interface Figures {
  /** Milliseconds of a step in which both have something awake; of the mean where the clock is
   * coarse. Null before any counts. */
  typical: number | null;
  /** Null where the clock is too coarse for single steps. */
  p99: number | null;
  /** Of the deepest overlap, in the world's lengths: at present, on average, at worst. */
  now: number;
  mean: number;
  ever: number;
  /** Since the comparison began. */
  energyChange: number;
  bodies: number;
  awake: number;
  /** Of the joint that is open the most: now a length and radians, and the length at worst. Null
   * without joints. */
  joints: { gap: number; angle: number; ever: number } | null;
}

/** Against simulated seconds; one array an engine, in the order of ENGINES. */
export interface Course {
  seconds: number[];
  values: [number[], number[]];
}

interface Sums {
  times: number[];
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
  readonly times: Course = newCourse();
  readonly penetrations: Course = newCourse();
  readonly energies: Course = newCourse();
  /** The step at which Box2D began; null before a step of it. */
  since: number | null = null;
  /** Box2D's origin in the world. */
  origin: Vec2 = [0, 0];
  /** What Box2D is not given: nothing is comparable then. */
  misses: readonly string[] = [];
  #counted = 0;
  #sums: { [engine in Engine]: Sums } = { thud: newSums(), box2d: newSums() };

  /** `fineClock`: single steps can be timed. */
  constructor(private readonly fineClock: boolean) {}

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

  #energyChange(engine: Engine): number {
    const { energy, firstEnergy } = this.#sums[engine];
    return energy - firstEnergy;
  }

  #addTimes(seconds: number, pair: readonly [number, number]): void {
    // Two steps are compared in which both engines have something to do.
    const { thud, box2d } = this.#sums;
    const counts = ++this.#counted > START_UP && thud.awake > 0 && box2d.awake > 0;
    const shown = pair.map((milliseconds, i) => {
      const { times } = this.#sums[ENGINES[i]];
      if (counts) keep(times, milliseconds, WINDOW);
      return this.fineClock || !counts ? milliseconds : mean(times.slice(-COARSE));
    });
    addTo(this.times, seconds, shown);
  }

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

function addTo({ seconds, values }: Course, at: number, [first, second]: readonly number[]): void {
  keep(seconds, at, COURSE);
  keep(values[0], first, COURSE);
  keep(values[1], second, COURSE);
}

function keep(list: number[], value: number, most: number): void {
  list.push(value);
  if (list.length > most) list.shift();
}
