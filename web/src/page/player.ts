/**
 * The display's clock. It runs with the wall's through the steps that the worker makes, a fraction
 * at a time, whatever the display's rate is, and asks for the next ones just before they are
 * needed. Steps that come late are made up for; what is late by more than `LONGEST` is given up,
 * and the scene runs slower than the wall's clock. slow.ts tells that.
 */
import type { Frame } from "../scene/frame";

/** Seconds that one picture makes up for at most, and that the worker may be behind. */
const LONGEST = 0.1;
/** The part of the newest picture's time in the average of the last ones. */
const NEWEST = 0.2;
/** Seconds that `Player.lag` looks back; after as many without a picture nobody has looked. */
const LOOK_BACK = 3;

export class Player {
  /** In steps; whole numbers are the ends of steps. */
  #place = 0;
  /** Where the wall's clock would have the place. */
  #due = 0;
  /** Seconds between two pictures of the display, on average. */
  interval = 1 / 60;
  #run = 0;
  #frames: Frame[] = [];
  #secondsAStep = 1 / 60;
  paused = false;
  /** The scene waits for something that is to be there at its first step. */
  waiting = false;
  speed = 1;
  /** The part of the last seconds' time that was given up. */
  lag = 0;

  /** A scene begins; frames of the one before are dropped. */
  begin(run: number, secondsAStep: number): void {
    this.#run = run;
    this.#secondsAStep = secondsAStep;
    this.#frames = [];
    this.#place = this.#due = this.lag = 0;
  }

  take(frame: Frame): void {
    if (frame.run === this.#run) this.#frames.push(frame);
  }

  /** The scene stands at this frame now, wherever it was. */
  jump(frame: Frame): void {
    if (frame.run !== this.#run) return;
    for (const passed of this.#frames) if (passed !== frame) handOver(passed, frame);
    this.#frames = [frame];
    this.#place = this.#due = frame.step;
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
    const shown = Math.min(seconds, LONGEST);
    this.interval += NEWEST * (Math.min(seconds, 1) - this.interval);
    if (this.paused || this.waiting || this.empty) return;
    const before = this.#due;
    const due = before + shown * this.#stepsASecond;
    this.#due = Math.min(due, this.newest + LONGEST * this.#stepsASecond);
    this.#place = Math.min(this.#due, Math.max(this.#place, this.newest));
    if (seconds >= LOOK_BACK) return;
    const lost = 1 - (this.#due - before) / (Math.max(seconds, 1e-3) * this.#stepsASecond);
    this.lag += (seconds / LOOK_BACK) * (lost - this.lag);
  }

  get #stepsASecond(): number {
    return this.speed / this.#secondsAStep;
  }

  /** The step that the worker should reach by now: those ahead that the next picture needs. */
  get wanted(): number {
    if (this.paused || this.waiting) return this.newest;
    return Math.ceil(this.#due + Math.max(1, Math.min(this.interval, LONGEST) * this.#stepsASecond));
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
  // What joints bear follows the joints that they came with.
  if (!next.joints) next.bearings ??= passed.bearings;
  next.joints ??= passed.joints;
  // Awake flags follow the rows of the shapes that they came with.
  if (next.shapes === passed.shapes || !next.shapes) next.awake ??= passed.awake;
}
