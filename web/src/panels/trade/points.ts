/** The points that settings leave in the plane while they run, for each scene that was run. */
import type { App } from "../../page/app";
import type { Sample } from "../../scene/frame";
import { percentile, START_UP, typical } from "../../shared/step-times";
import type { Choices } from "../../worker/protocol";
import { choicesText } from "./text";

export interface TriedPoint {
  key: string;
  engine: "thud" | "box2d";
  label: string;
  /** Null for Box2D, which the Versus panel sets. */
  choices: Choices | null;
  typical: number;
  /** Null while there are too few steps after the scene's start. */
  p99: number | null;
  worst: number;
  steps: number;
}

/** Steps that a point is of: the last four seconds in which something was awake. */
const WINDOW = 240;
/** Steps before it is shown. */
const LEAST = 20;
/** Steps after a change that may still be of the setting before. */
const SKIPPED = 8;

export class TriedPoints {
  readonly #app: App;
  /** By scene and size, then by setting. */
  readonly #all = new Map<string, Map<string, TriedPoint>>();
  readonly #samples: Sample[] = [];
  #setting = "";
  #box2dSubsteps = 0;
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

  /** Of the scene that runs. */
  get points(): TriedPoint[] {
    return [...(this.#all.get(this.#place) ?? new Map<string, TriedPoint>()).values()];
  }

  /** The key of the setting that runs. */
  get current(): string {
    return this.#setting;
  }

  forget(): void {
    this.#all.delete(this.#place);
    this.#begin();
  }

  get #place(): string {
    const { scene, seed, code } = this.#app.state;
    return JSON.stringify([scene, this.#app.scene?.size, seed, code]);
  }

  #begin(): void {
    const { choices, versus } = this.#app.state;
    this.#setting = JSON.stringify(choices);
    this.#box2dSubsteps = versus.substeps;
    this.#samples.length = 0;
    this.#skip = SKIPPED;
  }

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
    // Beside Box2D's, thud's overlap is what the same code measures, and not its own report.
    const errors =
      compared.length > 0
        ? compared.map(({ thud }) => thud.penetration)
        : this.#samples.map(({ penetration }) => penetration);
    this.#put(this.#setting, "thud", choicesText(choices), choices, this.#samples, errors);
    if (box2dSamples.length < LEAST || compared.length === 0) return;
    // A point beside thud's would be a comparison.
    if (box2dSamples.some(({ misses }) => misses.length > 0)) return;
    const label = `Box2D ${this.#app.state.versus.substeps}`;
    const box2dErrors = compared.map(({ box2d }) => box2d.penetration);
    this.#put(label, "box2d", label, null, box2dSamples, box2dErrors);
  }

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
