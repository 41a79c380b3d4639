/**
 * The series behind "Measure": thud and Box2D at several settings each, over the first seconds of
 * the same scene, for what a step takes and how far bodies overlap.
 *
 * Each setting runs once for the overlaps and some rounds for the times, always the same steps.
 * Rounds change their order, so that what else the machine does meets all settings alike.
 */
import { mean, percentile, START_UP, typical } from "../shared/step-times";
import { BOX2D, labelOf, type SeriesSetting, THUD } from "./measure-settings";
import { type Laboratory, Trial, warmUp } from "./measure-trial";
import type { SceneRequest } from "./protocol";

export interface SeriesRow {
  setting: SeriesSetting;
  /** Milliseconds of a step, with nothing asleep, after the scene's start. */
  typical: number;
  p99: number;
  /** Overlap in length scales: the deepest of all steps, and the mean depth of the contacts. */
  worst: number;
  mean: number;
  /** The deepest by thud's own report. */
  own: number | null;
  steps: number;
}

export interface Series {
  /** Of a step, in seconds. */
  timeStep: number;
  bodies: number;
  /** That each setting was to make; a slow one makes fewer. */
  steps: number;
  rows: SeriesRow[];
  /** What Box2D is not given of the scene: its rows are of another one then. */
  misses: string[];
  /** Why Box2D is not among them; "" if it is. */
  withoutBox2D: string;
}

export interface SeriesProgress {
  /** Of the whole, 0 to 1. */
  done: number;
  doing: string;
}

/** Of the scene, in seconds. */
const SPAN = 2;
/** Milliseconds after which a setting's first run is ended, with at least one step made. */
const PATIENCE = 4000;
const WARM_UP = 600;
/** Milliseconds that the rounds for the times may take together, beyond the least of them. */
const TIMING = 4000;
const LEAST_ROUNDS = 2;
const MOST_ROUNDS = 8;
/** Of the progress: the share of the runs for the overlaps. */
const FIRST_PART = 0.5;
/** Milliseconds between two messages. */
const OFTEN = 100;

interface Runs extends Pick<SeriesRow, "setting" | "worst" | "mean" | "own" | "steps"> {
  times: number[];
}

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
  return { ...series, rows, misses: [...misses], withoutBox2D };
}

/** Steps at the start whose times do not count; of a slow setting, which makes few, fewer. */
function startUpOf(steps: number): number {
  return Math.min(START_UP, Math.floor(steps / 4));
}

/** Detection and broadphase stay as the visitor has them; a largest error would mix qualities. */
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
