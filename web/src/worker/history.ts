/**
 * The past of a running scene: a snapshot ("moment") every few steps, and a journal of the
 * visitor's commands between them. A step of the past is restored from the snapshot before it, by
 * running on with the same commands. The engine is deterministic, so the result is the same to the
 * bit.
 */
import type { Command } from "./commands";

/** A snapshot of a scene after a step. */
export interface Moment {
  step: number;
  /** The world's snapshot. */
  world: Uint8Array;
  /** The scene's state and what the visitor held (session.ts), as plain data. */
  rest: unknown;
}

/** Number of steps that the visitor can go back: 30 s at 60 steps a second. Chosen. */
const SPAN = 1800;
/** Bytes that the moments of SPAN steps may take together, each counted as the memory of its world.
 * Chosen. */
const MOST_BYTES = 128 * 2 ** 20;
/** Milliseconds that running on from a moment to a step before the next one may take. Chosen. */
const PATIENCE = 60;
/** Largest number of steps between two moments, unless MOST_BYTES needs more. Chosen. */
const LONGEST = 60;

export class History {
  /** Moments in the order of their steps, oldest first. */
  readonly #moments: Moment[] = [];
  /** By step, the commands that were applied before the step that follows it. */
  readonly #journal = new Map<number, Command[]>();
  #last = 0;

  /** The oldest step that can be gone back to. */
  get first(): number {
    return this.#moments[0]?.step ?? 0;
  }

  /** The number of the newest step that was made. */
  get last(): number {
    return this.#last;
  }

  /**
   * Whether a moment should be kept after this step. `stepMilliseconds` is what a step takes, and
   * `bytes` is the memory of the world, which is taken for the size of a moment.
   */
  wants(step: number, stepMilliseconds: number, bytes: number): boolean {
    const previous = this.#moments.at(-1);
    if (!previous) return true;
    const byTime = PATIENCE / Math.max(0.001, stepMilliseconds);
    const byBytes = (SPAN * bytes) / MOST_BYTES;
    const every = Math.max(byBytes, Math.min(byTime, LONGEST));
    return step - previous.step >= Math.ceil(Math.max(1, every));
  }

  /** Adds a moment, and drops those that are older than SPAN. */
  keep(moment: Moment): void {
    this.#moments.push(moment);
    // The oldest moment kept is at or before the start of the span, so that all of it can be
    // restored.
    while (this.#moments.length > 1 && this.#moments[1].step <= moment.step - SPAN) {
      const [gone] = this.#moments.splice(0, 1);
      for (let step = gone.step; step < this.#moments[0].step; step++) this.#journal.delete(step);
    }
  }

  /**
   * Notes the commands that are applied before the step that follows `step`. If `step` is in the
   * past, moments and commands after it are dropped: another future begins.
   */
  note(step: number, commands: readonly Command[]): void {
    if (step < this.#last) this.#forgetAfter(step);
    if (commands.length > 0) this.#journal.set(step, [...commands]);
    this.#last = step + 1;
  }

  /** The commands that were applied before the step that follows `step`. */
  commandsAt(step: number): readonly Command[] {
    return this.#journal.get(step) ?? [];
  }

  /** The newest moment that is not after `step`; undefined if there is none. */
  before(step: number): Moment | undefined {
    let found: Moment | undefined;
    for (const moment of this.#moments) if (moment.step <= step) found = moment;
    return found;
  }

  /** Drops the moments after a step, and the commands from that step on. */
  #forgetAfter(step: number): void {
    while (this.#moments.length > 1 && this.#moments.at(-1)!.step > step) this.#moments.pop();
    for (const noted of this.#journal.keys()) if (noted >= step) this.#journal.delete(noted);
  }
}
