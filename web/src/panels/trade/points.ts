/**
 * `TriedPoints`: the points of the settings that the visitor has tried, for the plot of the panel
 * Trade. While a setting runs, the samples of its steps update its point; each scene has its own.
 */
import type { App } from "../../page/app";
import type { Sample } from "../../scene/frame";
import { percentile, START_UP, typical } from "../../shared/step-times";
import type { Choices } from "../../worker/protocol";
import { choicesText } from "./text";

/** The point of a setting. */
export interface TriedPoint {
  key: string;
  engine: "thud" | "box2d";
  label: string;
  /** Null for Box2D, whose substeps are set in the panel Versus. */
  choices: Choices | null;
  /** Typical milliseconds per step. */
  typical: number;
  /** 99th percentile of the milliseconds; null while the scene's start leaves too few steps. */
  p99: number | null;
  /** The worst overlap in length scales. */
  worst: number;
  /** Steps from which the point was computed. */
  steps: number;
}

/** Last steps with bodies awake from which a point is computed: 4 s at 60 Hz. Chosen. */
const WINDOW = 240;
/** Steps that a point needs at least. Chosen. */
const LEAST = 20;
/** Steps that are ignored after a change, since they may have been made with the setting before.
 * Chosen. */
const SKIPPED = 8;

export class TriedPoints {
  readonly #app: App;
  /** Points by `#place`, then by setting. */
  readonly #all = new Map<string, Map<string, TriedPoint>>();
  /** Samples of the present setting's last WINDOW steps. */
  readonly #samples: Sample[] = [];
  /** The present choices as JSON, which is the key of their point. */
  #setting = "";
  #box2dSubsteps = 0;
  /** Steps that are still to be ignored. */
  #skip = SKIPPED;

  constructor(app: App) {
    this.#app = app;
    app.listen({
      run: () => this.#begin(),
      state: () => {
        const { choices, versus } = app.state;
        const changed = JSON.stringify(choices) !== this.#setting;
        if (changed || versus.substeps !== this.#box2dSubsteps) this.#begin();
      },
      samples: (samples) => this.#add(samples),
    });
    this.#begin();
  }

  /** The points of the running scene. */
  get points(): TriedPoint[] {
    return [...(this.#all.get(this.#place) ?? new Map<string, TriedPoint>()).values()];
  }

  /** The key of the present setting's point. */
  get current(): string {
    return this.#setting;
  }

  /** Removes the points of the running scene. */
  forget(): void {
    this.#all.delete(this.#place);
    this.#begin();
  }

  /** The key of the running scene with its size, seed, code, and level or recording: points are
   * comparable within it. */
  get #place(): string {
    const { scene, seed, code, level, recording } = this.#app.state;
    return JSON.stringify([scene, this.#app.scene?.size, seed, code, level?.name, recording?.name]);
  }

  /** A scene has started, or the setting has changed. */
  #begin(): void {
    const { choices, versus } = this.#app.state;
    this.#setting = JSON.stringify(choices);
    this.#box2dSubsteps = versus.substeps;
    this.#samples.length = 0;
    this.#skip = SKIPPED;
  }

  /** Updates the points of the present setting and of Box2D with the samples of new steps. */
  #add(samples: readonly Sample[]): void {
    for (const sample of samples) {
      if (this.#skip > 0) this.#skip--;
      else if (sample.awake > 0) this.#samples.push(sample);
    }
    this.#samples.splice(0, Math.max(0, this.#samples.length - WINDOW));
    if (this.#samples.length < LEAST) return;
    const choices = { ...this.#app.state.choices };
    const box2dSamples = this.#samples.flatMap(({ step, box2d }) =>
      box2d ? [{ step, ...box2d }] : [],
    );
    const compared = box2dSamples.flatMap(({ compared }) => compared ?? []);
    // While Box2D runs, the overlap of both engines is measured by the same code; else it is the
    // overlap that thud reports.
    const errors =
      compared.length > 0
        ? compared.map(({ thud }) => thud.penetration)
        : this.#samples.map(({ penetration }) => penetration);
    this.#put(this.#setting, "thud", choicesText(choices), choices, this.#samples, errors);
    if (box2dSamples.length < LEAST || compared.length === 0) return;
    // If Box2D lacks parts of the scene, its point would not be comparable with thud's.
    if (box2dSamples.some(({ misses }) => misses.length > 0)) return;
    const label = `Box2D ${this.#app.state.versus.substeps}`;
    const box2dErrors = compared.map(({ box2d }) => box2d.penetration);
    this.#put(label, "box2d", label, null, box2dSamples, box2dErrors);
  }

  /** Computes a point from samples and overlaps (world units), and stores it. */
  #put(
    key: string,
    engine: TriedPoint["engine"],
    label: string,
    choices: Choices | null,
    samples: readonly { step: number; milliseconds: number }[],
    errors: readonly number[],
  ): void {
    const place = this.#all.get(this.#place) ?? new Map<string, TriedPoint>();
    this.#all.set(this.#place, place);
    const times = samples.map(({ milliseconds }) => milliseconds);
    const later = times.filter((_, i) => samples[i].step > START_UP);
    const lengthScale = this.#app.scene?.lengthScale ?? 1;
    const worst = Math.max(0, ...errors);
    place.set(key, {
      key,
      engine,
      label,
      choices,
      typical: typical(times),
      p99: later.length < LEAST ? null : percentile(later, 0.99),
      worst: worst / lengthScale,
      steps: samples.length,
    });
  }
}
