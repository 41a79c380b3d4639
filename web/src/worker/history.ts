/**
 * The past of a running scene: snapshots of it every few steps, and the journal of what the visitor
 * did between them. A step of the past is the snapshot before it, run on with the same commands:
 * the engine is deterministic, so that it comes out the same to the bit.
 */
import type { Command } from "./commands";

/** What is kept of a moment. */
export interface Moment {
  step: number;
  world: Uint8Array;
  /** Plain data of the scene and of the visitor's hands. */
  rest: unknown;
}

/** Steps that can be gone back: twenty seconds. */
const SPAN = 1200;
/** Bytes that all moments may hold together. */
const MOST_BYTES = 128 * 2 ** 20;
/** Milliseconds that running on from a moment may take. */
const PATIENCE = 60;
/** Steps between two moments at most. */
const LONGEST = 60;

export class History {
  readonly #moments: Moment[] = [];
  readonly #journal = new Map<number, Command[]>();
  #last = 0;

  /** The oldest step that can be gone back to. */
  get first(): number {
    return this.#moments[0]?.step ?? 0;
  }

  /** The newest step that was made. */
  get last(): number {
    return this.#last;
  }

  /** Whether a moment should be kept at this step, if a step takes so long and a moment so much. */
  wants(step: number, stepMilliseconds: number, bytes: number): boolean {
    const previous = this.#moments.at(-1);
    if (!previous) return true;
    const byTime = PATIENCE / Math.max(0.001, stepMilliseconds);
    const byBytes = (SPAN * bytes) / MOST_BYTES;
    const every = Math.max(byBytes, Math.min(byTime, LONGEST));
    return step - previous.step >= Math.ceil(Math.max(1, every));
  }

  keep(moment: Moment): void {
    this.#moments.push(moment);
    // The span is counted from the newest, and at least one moment is left before its start.
    while (this.#moments.length > 1 && this.#moments[1].step <= moment.step - SPAN) {
      const [gone] = this.#moments.splice(0, 1);
      for (let step = gone.step; step < this.#moments[0].step; step++) this.#journal.delete(step);
    }
  }

  /** Notes what was done before the step that leads on from `step`; another future is forgotten. */
  note(step: number, commands: readonly Command[]): void {
    if (step < this.#last) this.#forgetAfter(step);
    if (commands.length > 0) this.#journal.set(step, [...commands]);
    this.#last = step + 1;
  }

  commandsAt(step: number): readonly Command[] {
    return this.#journal.get(step) ?? [];
  }

  /** The newest moment that is not after `step`. */
  before(step: number): Moment | undefined {
    let found: Moment | undefined;
    for (const moment of this.#moments) if (moment.step <= step) found = moment;
    return found;
  }

  #forgetAfter(step: number): void {
    while (this.#moments.length > 1 && this.#moments.at(-1)!.step > step) this.#moments.pop();
    for (const noted of this.#journal.keys()) if (noted >= step) this.#journal.delete(noted);
  }
}
