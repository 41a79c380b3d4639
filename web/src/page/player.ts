/**
 * `Player`: the display's clock. It advances with real time through the steps that the worker
 * makes, in fractions of a step whatever the display's rate is, and says which step the worker must
 * reach next. After a short delay of the worker the display catches up; a delay beyond `LONGEST` is
 * given up, and the scene runs slower than real time. `lag` measures that, and slow.ts reports it.
 */
import type { Frame } from "../scene/frame";

/** Seconds of real time that one picture advances by at most, and seconds that `#due` may be ahead
 * of the worker's newest step. Chosen. */
const LONGEST = 0.1;
/** Weight of the newest value in the moving average `Player.interval`. Chosen. */
const NEWEST = 0.2;
/** Seconds over which `Player.lag` averages. An interval between two pictures that is as long (the
 * tab was hidden) does not count. Chosen. */
const LOOK_BACK = 3;

export class Player {
  /** The time that is shown, in steps: the whole number n is the end of step n. */
  #place = 0;
  /** Where `#place` would be if no step had come late; at most LONGEST ahead of `newest`. */
  #due = 0;
  /** Seconds between two pictures of the display, as a moving average. */
  interval = 1 / 60;
  #run = 0;
  /** Frames that are shown or to be shown, oldest first. */
  #frames: Frame[] = [];
  #secondsAStep = 1 / 60;
  paused = false;
  /** The clock waits before the first step for a panel that is still being opened. */
  waiting = false;
  /** Simulated seconds per second of real time that the visitor wants. */
  speed = 1;
  /** A factor of `speed` by which the clocks of a match's players are kept together. */
  pace = 1;
  /** The share of the last seconds' time that was given up: 0 in real time, 0.5 at half of it. */
  lag = 0;

  /** Scene number `run` begins; frames of the one before are dropped. */
  begin(run: number, secondsAStep: number): void {
    this.#run = run;
    this.#secondsAStep = secondsAStep;
    this.#frames = [];
    this.#place = this.#due = this.lag = 0;
  }

  /** Queues a frame. */
  take(frame: Frame): void {
    if (frame.run === this.#run) this.#frames.push(frame);
  }

  /** Shows this frame at once, and drops all others. */
  jump(frame: Frame): void {
    if (frame.run !== this.#run) return;
    for (const passed of this.#frames) if (passed !== frame) handOver(passed, frame);
    this.#frames = [frame];
    this.#place = this.#due = frame.step;
  }

  /** Shows this step, of which a frame has come, without playing up to it. */
  skipTo(step: number): void {
    this.#place = this.#due = step;
  }

  /** Shows the end of the newest step, so that a single step continues from what is shown. */
  settle(): void {
    const newest = this.#frames.at(-1);
    if (newest) this.jump(newest);
  }

  /** Whether no frame of the scene has come yet. */
  get empty(): boolean {
    return this.#frames.length === 0;
  }

  /** Number of the newest step of which a frame has come. */
  get newest(): number {
    return this.#frames.at(-1)?.step ?? 0;
  }

  /** The time that is shown, in steps. */
  get place(): number {
    return this.#place;
  }

  /** Advances by the seconds of real time since the last picture; updates `interval` and `lag`. */
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
    return (this.speed * this.pace) / this.#secondsAStep;
  }

  /** The step that the worker must have reached for the next picture, and at least one ahead. */
  get wanted(): number {
    if (this.paused || this.waiting) return this.newest;
    return Math.ceil(this.#due + Math.max(1, Math.min(this.interval, LONGEST) * this.#stepsASecond));
  }

  /** The frame to draw, and how far to interpolate from its `before` (0) to its `now` (1). Null
   * before the first frame. Drops frames that are past. */
  get shown(): { frame: Frame; alpha: number } | null {
    while (this.#frames.length > 1 && this.#frames[0].step < this.#place)
      handOver(this.#frames.shift()!, this.#frames[0]);
    const frame = this.#frames[0];
    if (!frame) return null;
    const alpha = Math.min(1, Math.max(0, this.#place - (frame.step - 1)));
    return { frame, alpha };
  }
}

/** Moves data that is sent only when it changes from a dropped frame to the next one. */
function handOver(passed: Frame, next: Frame): void {
  next.shapes ??= passed.shapes;
  next.terrains ??= passed.terrains;
  // `bearings` are in the order of the joints that came with or before them: newer joints, in
  // another order, make them invalid.
  if (!next.joints) next.bearings ??= passed.bearings;
  next.joints ??= passed.joints;
  // Likewise awake flags are in the order of the rows of `shapes`.
  if (next.shapes === passed.shapes || !next.shapes) next.awake ??= passed.awake;
}
