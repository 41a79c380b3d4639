/**
 * The measurement "Measure": the first seconds of one scene, by thud and by Box2D at several
 * settings each. Measured are the time of a step and how far bodies overlap.
 *
 * Each setting runs once for the overlaps, and then several rounds for the times, always the same
 * steps. Every other round takes the settings in reverse order, so that slow drifts of the
 * machine's speed affect all settings alike.
 */
import { mean, percentile, START_UP, typical } from "../shared/step-times";
import { BOX2D, labelOf, type SeriesSetting, THUD } from "./measure-settings";
import { type Laboratory, Trial, warmUp } from "./measure-trial";
import { countUses, type SceneUses } from "./measure-uses";
import type { SceneRequest } from "./protocol";

export interface SeriesRow {
  setting: SeriesSetting;
  /**
   * The time of a step in ms, without sleep and without the scene's first steps: see `typical` of
   * step-times.ts, and the 99th percentile.
   */
  typical: number;
  p99: number;
  /**
   * Overlap in length scales: the deepest of all steps, and the mean over steps of the mean depth.
   */
  worst: number;
  mean: number;
  /** The deepest overlap by thud's own report, in length scales; null for Box2D. */
  own: number | null;
  steps: number;
}

export interface Series {
  /** The length of a step, in seconds. */
  timeStep: number;
  bodies: number;
  /** The number of steps planned for each setting; a slow setting makes fewer. */
  steps: number;
  rows: SeriesRow[];
  /** What the scene used at the visitor's settings; null where it came with a link. */
  uses: SceneUses | null;
  /**
   * What the scene has and Box2D is not given: where not empty, Box2D's rows are of another scene.
   */
  misses: string[];
  /** Why there are no rows of Box2D; "" if there are. */
  withoutBox2D: string;
}

export interface SeriesProgress {
  /** Share of the whole measurement that is done, 0 to 1. */
  done: number;
  doing: string;
}

/** Length of a run, in seconds of the scene. Chosen. */
const SPAN = 2;
/**
 * Milliseconds after which a setting's run for the overlaps is ended, with at least one step made.
 * Chosen.
 */
const PATIENCE = 4000;
/** Milliseconds that each engine runs before it is measured; see warmUp. */
const WARM_UP = 600;
/**
 * Milliseconds that the rounds for the times are planned to take together. Chosen, as are the
 * bounds on the number of rounds, which take precedence.
 */
const TIMING = 4000;
const LEAST_ROUNDS = 2;
const MOST_ROUNDS = 8;
/** Share of the progress bar that the runs for the overlaps get. */
const FIRST_PART = 0.5;
/** Smallest time between two progress messages, in ms. Chosen. */
const OFTEN = 100;

/** The runs of one setting: its overlaps, and the times of its steps in ms. */
interface Runs extends Pick<SeriesRow, "setting" | "worst" | "mean" | "own" | "steps"> {
  times: number[];
}

/** Measures the scene at all settings. `withoutBox2D` says why Box2D is missing, or "". */
export async function measure(
  laboratory: Laboratory,
  request: SceneRequest,
  withoutBox2D: string,
  report: (progress: SeriesProgress) => void,
): Promise<Series> {
  const settings = laboratory.box2d ? [...THUD, ...BOX2D] : THUD;
  let reported = -Infinity;
  const tell = (done: number, doing: string) => {
    const now = performance.now();
    if (now - reported < OFTEN) return;
    reported = now;
    report({ done, doing });
  };

  tell(0, "Warming up");
  await warmUp(laboratory, request, WARM_UP);
  tell(0, "What the scene uses");
  const uses = await countUses(laboratory, request, SPAN, PATIENCE);
  const runs: Runs[] = [];
  const series = { timeStep: 0, bodies: 0, steps: 0 };
  const misses = new Set<string>();
  const began = performance.now();
  for (const [i, setting] of settings.entries()) {
    const trial = await openFor(laboratory, request, setting);
    try {
      series.timeStep = trial.timeStep;
      series.bodies = Math.max(series.bodies, trial.bodies);
      series.steps = Math.round(SPAN / trial.timeStep);
      runs.push(
        runForError(trial, setting, series.steps, (part) =>
          tell((FIRST_PART * (i + part)) / settings.length, `Overlap of ${labelOf(setting)}`),
        ),
      );
      for (const miss of trial.misses) misses.add(miss);
    } finally {
      trial.close();
    }
  }
  const fitting = Math.floor(TIMING / (performance.now() - began));
  const rounds = Math.min(MOST_ROUNDS, Math.max(LEAST_ROUNDS, fitting));
  for (let round = 0; round < rounds; round++)
    for (const [i, run] of (round % 2 === 0 ? runs : [...runs].reverse()).entries()) {
      const trial = await openFor(laboratory, request, run.setting);
      const done = (round + i / runs.length) / rounds;
      tell(FIRST_PART + (1 - FIRST_PART) * done, `Time of ${labelOf(run.setting)}`);
      try {
        for (let k = 0; k < run.steps; k++) {
          const time = trial.step();
          if (k >= startUpOf(run.steps)) run.times.push(time);
        }
      } finally {
        trial.close();
      }
    }
  const rows = runs.map(({ times, ...rest }) => ({
    ...rest,
    typical: typical(times),
    p99: percentile(times, 0.99),
  }));
  return { ...series, rows, uses, misses: [...misses], withoutBox2D };
}

/**
 * Number of steps at the start of a run whose times are left out: START_UP, or a quarter of the
 * steps of a slow setting, which makes few.
 */
function startUpOf(steps: number): number {
  return Math.min(START_UP, Math.floor(steps / 4));
}

/**
 * Opens the scene at a setting. Detection and broadphase are those that the visitor has chosen. The
 * largest error (maxError) is off, because it would make a quality do more work than its name says.
 */
function openFor(
  laboratory: Laboratory,
  request: SceneRequest,
  setting: SeriesSetting,
): Promise<Trial> {
  if (setting.engine === "box2d") {
    const choices = { ...request.choices, quality: "draft" as const, substeps: 0, maxError: 0 };
    return Trial.open(laboratory, { ...request, choices }, setting);
  }
  const { quality, substeps } = setting;
  const choices = { ...request.choices, quality, substeps, maxError: 0 };
  return Trial.open(laboratory, { ...request, choices });
}

/** Makes up to `most` steps and measures the overlap after each. */
function runForError(
  trial: Trial,
  setting: SeriesSetting,
  most: number,
  tell: (part: number) => void,
): Runs {
  const end = performance.now() + PATIENCE;
  const means: number[] = [];
  let worst = 0;
  let own: number | null = null;
  do {
    trial.step();
    const overlap = trial.overlap();
    worst = Math.max(worst, overlap.worst);
    means.push(overlap.mean);
    const report = trial.ownReport;
    if (report !== null) own = Math.max(own ?? 0, report);
    tell(means.length / most);
  } while (means.length < most && performance.now() < end);
  return { setting, worst, mean: mean(means), own, steps: means.length, times: [] };
}
