/** A world's life in the module: made from options, stepped, set, snapshotted and freed. */
/// <reference lib="esnext.disposable" preserve="true" />
import { explained } from "./checks/hook.js";
import type { Engine } from "./engine.js";
import { ThudError } from "./error.js";
import { AdvanceAt, HandleAt, ListAt, WORLD_OPTIONS, WorldOptionsAt } from "./generated/slots.js";
import { fill, numbersOf, qualityNumbers, rowsOf, shapeAt } from "./numbers.js";
import { generationOf, index1Of, type Kind } from "./plain/handles.js";
import { restoreSnapshot, takeSnapshot } from "./snapshot.js";
import type { BodyRef, JointRef, Quality, QualityOptions, ShapeId, ShapeRef, StepCalls, Vec2, WorldOptions } from "./types.js";

type AnyRef = BodyRef | ShapeRef | JointRef;

/** Tells, once each, of worlds that were forgotten and never closed. */
const forgotten =
  typeof FinalizationRegistry === "function"
    ? new FinalizationRegistry<null>(() =>
        console.warn("thud: a world was forgotten that was never closed; its memory stays taken"),
      )
    : null;

/** As far out as a body can be, in length scales; a little less, for rounding. */
const EVERYWHERE = 0.999e9;

export class WorldBase {
  readonly engine: Engine;
  #address: number;
  /** Nothing is further from the origin, in length units. */
  protected readonly reach: number;
  protected shapesRevision = 0;
  protected terrainsRevision = 0;

  /**
   * Made by `Engine.createWorld`. An address adopts a world that other code in the module made; of
   * the options only its length scale counts then.
   */
  constructor(engine: Engine, options: WorldOptions = {}, address = 0) {
    this.engine = engine;
    this.#address = address;
    this.reach = EVERYWHERE * (options.lengthScale ?? 1);
    if (address !== 0) return;
    WorldBase.writeOptions(engine, options);
    try {
      engine.check(engine.exports.api_world_create());
    } catch (refused) {
      throw explained(refused, "createWorld", options);
    }
    this.#address = engine.slots[ListAt.address];
    forgotten?.register(this, null, this);
  }

  /** Of the options. */
  protected get lengthScale(): number {
    return this.reach / EVERYWHERE;
  }

  /** Fills the slots of api_world_defaults, for code that makes worlds in the module itself. */
  static writeOptions(engine: Engine, options: WorldOptions): void {
    const numbers = numbersOf("createWorld", options, WORLD_OPTIONS);
    const [base, ...changes] = qualityNumbers(options.quality);
    numbers[WorldOptionsAt.quality] = base;
    engine.exports.api_world_defaults();
    fill(engine.slots, numbers);
    fill(engine.slots, changes, WorldOptionsAt.changes);
  }

  /** The world's address in wasm memory; throws after `close`. */
  get address(): number {
    if (this.#address === 0) throw new ThudError("stale", "the world has been destroyed");
    return this.#address;
  }

  /** Frees the world. Using it afterwards throws. Inside a callback of its own it is not closed. */
  close(): void {
    this.engine.check(this.engine.exports.api_world_destroy(this.address));
    this.engine.callbacks.forget(this.#address);
    this.#address = 0;
    forgotten?.unregister(this);
    this.freeRoom();
  }

  /** Closes it, if it is not closed: `using world = thud.createWorld()` does so by itself. */
  [Symbol.dispose](): void {
    if (this.#address !== 0) this.close();
  }

  /** Frees what a layer above this one keeps in wasm memory. */
  protected freeRoom(): void {}

  // ---- going back ----

  /** The whole state as bytes: a copy that stays as it is. thud_snapshot.h tells what it holds. */
  snapshot(): Uint8Array<ArrayBuffer> {
    return takeSnapshot(this.engine, this.address);
  }

  /**
   * Back to a snapshot of this world, or of another with the same options: from there on the same
   * calls give the same bits and the same handles. Throws, and changes nothing, for bytes that are
   * damaged, or of another version or kind of world.
   */
  restore(snapshot: Uint8Array): void {
    restoreSnapshot(this.engine, this.address, snapshot);
    this.shapesRevision++;
    this.terrainsRevision++;
  }

  /**
   * Returns what a function does that plays on in this world, which is then as it was before: to
   * look ahead, for a computer player or a line that shows the way. What it throws is thrown.
   * @example const points = world.whatIf(() => shoot(angle))
   */
  whatIf<T>(play: () => T): T {
    const before = this.snapshot();
    try {
      return play();
    } finally {
      this.restore(before);
    }
  }

  /**
   * Two numbers that rise when bodies or shapes came, went or were enabled or disabled, and when
   * the ground changed: whoever draws reads the shape table and the terrains anew then.
   */
  get revision(): { readonly shapes: number; readonly terrains: number } {
    return { shapes: this.shapesRevision, terrains: this.terrainsRevision };
  }

  // ---- time ----

  /** Runs one step of `timeStep` seconds. */
  step(): void {
    this.engine.check(this.engine.exports.api_world_step(this.address));
  }

  /**
   * Runs as many whole steps as the elapsed seconds allow, at most `maxSteps`; call it once a
   * picture. `alpha` tells how far the present lies between the last step and the next, for `poses`.
   * What happens does not depend on how often it is called: `events`, `meetings`, `impulses` and
   * `jointEvents` are of all steps that it made, none where it made none; forces that were applied
   * since the last call act for all of the elapsed time. What shall act in one step alone is done in
   * `calls.before`. There and in `calls.after` the world may be changed, but not stepped, restored or
   * closed; what they throw is thrown when the steps are made.
   *
   * Where a step runs out of memory this throws; the steps before it stand, `stats().steps` counts
   * them, and the time that is left waits for the next call.
   */
  advance(elapsed: number, maxSteps = 4, calls: StepCalls = {}): { steps: number; alpha: number } {
    const { engine } = this;
    const { before, after } = calls;
    const called = Number(before !== undefined) + 2 * Number(after !== undefined);
    if (called) engine.callbacks.set(this.address, { before, after });
    this.onWorld("api_world_advance", elapsed, maxSteps, called);
    return { steps: engine.slots[AdvanceAt.steps], alpha: engine.slots[AdvanceAt.alpha] };
  }

  /**
   * Sets gravity, length/s², from the next step on.
   * @example world.setGravity([0, 10])
   */
  setGravity(gravity: Vec2): void {
    this.onWorld("api_world_set_gravity", gravity?.[0], gravity?.[1]);
  }

  /** Sets the seconds of the steps from the next on; (0, 1]. */
  setTimeStep(seconds: number): void {
    this.onWorld("api_world_set_time_step", seconds);
  }

  /**
   * Sets the quality from the next step on. For experts: `substeps` from 1 to 64; 0 takes the
   * quality's.
   */
  setQuality(quality: Quality | QualityOptions, substeps = 0): void {
    const [base, own = 0, stiffness = 0, damping = 0, detection = -1, islands = -1] =
      qualityNumbers(quality);
    const set = this.engine.exports.api_world_set_quality;
    const made = substeps || own;
    const result = set(this.address, base, made, stiffness, damping, detection, islands);
    const given = substeps ? { substeps } : Object(quality);
    if (result !== 0) this.refuse(result, "setQuality", given);
  }

  /** Sets the overlap from which on islands are solved directly; see WorldOptions.maxError. */
  setMaxError(maxError: number): void {
    this.onWorld("api_world_set_max_error", maxError);
  }

  /** Whether bodies at rest may sleep. False wakes every one. */
  setSleeping(sleeping: boolean): void {
    this.onWorld("api_world_set_sleeping", Number(sleeping));
  }

  /** Throws what the engine refused, and tells which of the arguments or options was wrong. */
  protected refuse(result: number, call: string, given: object): void {
    this.engine.callbacks.rethrow(); // as it is, whatever it says
    try {
      this.engine.check(result);
    } catch (refused) {
      throw explained(refused, call, given, this.lengthScale);
    }
  }

  /**
   * Calls what is for handles of one kind. A list of arguments would be an object; what the module
   * does not take of them it passes over.
   */
  protected on(
    kind: Kind,
    name: string,
    id: AnyRef,
    a?: number,
    b?: number,
    c?: number,
    d?: number,
    e?: number,
    f?: number,
  ): void {
    const call = this.engine.exports[name];
    const index1 = index1Of(id, kind);
    const result = call(this.address, index1, generationOf(id), a!, b!, c!, d!, e!, f!);
    if (result !== 0 || this.engine.callbacks.hasThrown)
      this.refuse(result, name, [a, b, c, d, e, f]);
  }

  /** As `on`, of the world itself. */
  protected onWorld(name: string, a?: number, b?: number, c?: number): void {
    const result = this.engine.exports[name](this.address, a!, b!, c!);
    if (result !== 0 || this.engine.callbacks.hasThrown) this.refuse(result, name, [a, b]);
  }

  /** Those of the list that the last call gave. */
  protected shapeIds(): ShapeId[] {
    const { buffer, slots } = this.engine;
    return rowsOf(Uint32Array, buffer, slots, ListAt.address, HandleAt.length, shapeAt);
  }
}
