/**
 * The display's clock. It runs through the steps that the worker makes, a fraction at a time, and
 * asks for the next ones just before they are needed; where the worker cannot keep up the clock
 * waits, and the scene runs slower than the wall's.
 */
import type { Frame } from "../scene/frame";

/** Longest time that one frame makes up for, in seconds. */
const LONGEST_FRAME = 0.1;

export class Player {
  /** In steps; whole numbers are the ends of steps. */
  #place = 0;
  #run = 0;
  #frames: Frame[] = [];
  #secondsAStep = 1 / 60;
  paused = false;
  /** The scene waits for something that is to be there at its first step. */
  waiting = false;
  speed = 1;

  /** A scene begins; frames of the one before are dropped. */
  begin(run: number, secondsAStep: number): void {
    this.#run = run;
    this.#secondsAStep = secondsAStep;
    this.#frames = [];
    this.#place = 0;
  }

  take(frame: Frame): void {
    if (frame.run === this.#run) this.#frames.push(frame);
  }

  /** The scene stands at this frame now, wherever it was. */
  jump(frame: Frame): void {
    if (frame.run !== this.#run) return;
    for (const passed of this.#frames) if (passed !== frame) handOver(passed, frame);
    this.#frames = [frame];
    this.#place = frame.step;
  }

  /** Shows the newest step whole: a single step then leads on from what is seen. */
  settle(): void {
    const newest = this.#frames.at(-1);
    if (newest) this.jump(newest);
  }

  /** Whether nothing has come yet. */
  get empty(): boolean {
    return this.#frames.length === 0;
  }

  /** The newest step that has come. */
  get newest(): number {
    return this.#frames.at(-1)?.step ?? 0;
  }

  get place(): number {
    return this.#place;
  }

  /** Goes on by the time since the last frame of the display. */
  advance(seconds: number): void {
    const before = this.#place;
    if (!this.paused && !this.waiting)
      this.#place += (Math.min(seconds, LONGEST_FRAME) * this.speed) / this.#secondsAStep;
    this.#place = Math.min(this.#place, Math.max(before, this.newest));
  }

  /** The step that the worker should reach by now: one ahead, so that none is waited for. */
  get wanted(): number {
    if (this.paused || this.waiting) return this.newest;
    const perFrame = Math.max(1, Math.round(this.speed));
    return Math.ceil(this.#place) + perFrame;
  }

  /** What to draw: a frame, and how far between its two moments. */
  get shown(): { frame: Frame; alpha: number } | null {
    while (this.#frames.length > 1 && this.#frames[0].step < this.#place)
      handOver(this.#frames.shift()!, this.#frames[0]);
    const frame = this.#frames[0];
    if (!frame) return null;
    const alpha = Math.min(1, Math.max(0, this.#place - (frame.step - 1)));
    return { frame, alpha };
  }
}

/** What a frame tells only once must not be lost with it. */
function handOver(passed: Frame, next: Frame): void {
  next.shapes ??= passed.shapes;
  next.terrains ??= passed.terrains;
  // Awake flags follow the rows of the shapes that they came with.
  if (next.shapes === passed.shapes || !next.shapes) next.awake ??= passed.awake;
}
