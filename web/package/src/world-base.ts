/**
 * The lowest layer of World: it makes a world in the module from options, and steps, sets, saves,
 * restores and frees it; and the calls of the module by handle, which all layers use.
 */
/// <reference lib="esnext.disposable" preserve="true" />
import { checkElapsed, checkStep, explained } from "./checks/hook.js";
import type { Engine } from "./engine.js";
import { ThudError } from "./error.js";
import {
  AdvanceAt,
  HandleAt,
  ListAt,
  StepSettingsAt,
  WORLD_OPTIONS,
  WorldOptionsAt,
} from "./generated/slots.js";
import { fill, flagOf, numbersOf, qualityNumbers, rowsOf, shapeAt, xOf } from "./numbers.js";
import { generationOf, index1Of, type Kind } from "./plain/handles.js";
import { repack, restoreSnapshot, takeSnapshot } from "./snapshot.js";
import type { BodyRef, JointRef, Quality, QualityOptions, ShapeId, ShapeRef, StepCalls, Vec2, WorldOptions } from "./types.js";

type AnyRef = BodyRef | ShapeRef | JointRef;

/** Logs a warning for each world that was garbage collected without having been closed. */
const forgotten =
  typeof FinalizationRegistry === "function"
    ? new FinalizationRegistry<null>(() =>
        console.warn("thud: a world was forgotten that was never closed; its memory stays taken"),
      )
    : null;

/**
 * The largest coordinate of a body, length scales: THUD_PLACE_MAX, 1e9, less 0.1 percent for
 * rounding.
 */
const EVERYWHERE = 0.999e9;

/** The lowest layer of World, see the head of this file. */
export class WorldBase {
  readonly engine: Engine;
  #address: number;
  /** The largest coordinate of a body, in length units. */
  protected readonly reach: number;
  protected shapesRevision = 0;
  protected terrainsRevision = 0;

  /**
   * Called by `Engine.createWorld`. With an `address` it takes over a world that other code in the
   * module made; of the options only the length scale counts then.
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

  /**
   * The length scale that the world was made with (WorldOptions.lengthScale); 1 for the world of a
   * `Player`.
   */
  get lengthScale(): number {
    return this.reach / EVERYWHERE;
  }

  /**
   * Writes the options to the slots, over the defaults of api_world_defaults; also for programs
   * whose own code in the module makes the world. Throws "invalid" for an unknown option.
   */
  static writeOptions(engine: Engine, options: WorldOptions): void {
    const numbers = numbersOf("createWorld", options, WORLD_OPTIONS);
    const [base, ...changes] = qualityNumbers(options.quality);
    numbers[WorldOptionsAt.quality] = base;
    engine.exports.api_world_defaults();
    fill(engine.slots, numbers);
    fill(engine.slots, changes, WorldOptionsAt.changes);
  }

  /** The world's address in wasm memory. Throws "stale" after `close`. */
  get address(): number {
    if (this.#address === 0) throw new ThudError("stale", "the world has been destroyed");
    return this.#address;
  }

  /**
   * Frees the world's memory. Every later call throws "stale".
   * @throws {ThudError} "locked" inside a callback of the world, which then stays open.
   */
  close(): void {
    this.engine.check(this.engine.exports.api_world_destroy(this.address));
    this.engine.callbacks.forget(this.#address);
    this.#address = 0;
    forgotten?.unregister(this);
    this.freeRoom();
  }

  /** Closes the world unless it is closed; `using world = thud.createWorld()` calls it. */
  [Symbol.dispose](): void {
    if (this.#address !== 0) this.close();
  }

  /** Ends the use of a world that the module has freed by itself. */
  static disown(world: WorldBase): void {
    world.engine.callbacks.forget(world.#address);
    world.#address = 0;
    world.freeRoom();
  }

  /** Frees the memory of the module that a layer above this one keeps. */
  protected freeRoom(): void {}

  // ---- snapshots ----

  /**
   * The whole state of the world as bytes, a copy. thud_snapshot.h says what it contains.
   * @throws {ThudError} "locked" inside a callback; "memory".
   */
  snapshot(): Uint8Array<ArrayBuffer> {
    return takeSnapshot(this.engine, this.address);
  }

  /**
   * Restores the state of a snapshot of this world, or of another with the same options: from there
   * the same calls give the same results, bit for bit, and the same handles.
   * @throws {ThudError} "invalid" for bytes that are damaged, of another version, or of a world
   * with other options, and where the snapshot has joints or rules that this world never had
   * (`useJoints`, `useRules`, `useTextures`); "locked" inside a callback; "memory".
   */
  restore(snapshot: Uint8Array): void {
    restoreSnapshot(this.engine, this.address, snapshot);
    WorldBase.noteChanges(this);
  }

  /**
   * Makes a snapshot small, to be sent or kept: alone, or against an earlier snapshot of the same
   * world, the base, as a delta. `unpack` gives the same bytes again. Any world can make the call.
   * @throws {ThudError} "invalid" for bytes that are no whole snapshot of this build; "locked"
   * inside a callback; "memory".
   * @example const small = world.pack(world.snapshot());
   */
  pack(snapshot: Uint8Array, base?: Uint8Array): Uint8Array<ArrayBuffer> {
    return repack(this.engine, this.address, "api_world_pack", snapshot, base);
  }

  /**
   * The snapshot that was packed. `base` is the one that it was packed against.
   * @throws {ThudError} "invalid" for bytes that are damaged or of another version, and for another
   * base than that with which they were packed; "locked" inside a callback; "memory".
   * @example const snapshot = world.unpack(world.pack(world.snapshot()));
   */
  unpack(packed: Uint8Array, base?: Uint8Array): Uint8Array<ArrayBuffer> {
    return repack(this.engine, this.address, "api_world_unpack", packed, base);
  }

  /**
   * Calls a function that steps and changes this world, restores the state before the call, and
   * returns the function's result: to look ahead, for a computer player or to draw a trajectory. An
   * exception of the function is passed on.
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
   * Two counters. `shapes` increases when a body or shape was created, destroyed, enabled,
   * disabled, resized, made a sensor or given another kind, `terrains` when the line of a terrain changed; `restore`
   * increases both, as do steps of a `Player` in which that may have happened. A renderer reads the
   * shape table, or the terrains, again when they have changed.
   */
  get revision(): { readonly shapes: number; readonly terrains: number } {
    return { shapes: this.shapesRevision, terrains: this.terrainsRevision };
  }

  /**
   * Increases both counters of a world's `revision`: for calls that the module has made by itself.
   */
  static noteChanges(world: WorldBase): void {
    world.shapesRevision++;
    world.terrainsRevision++;
  }

  // ---- time ----

  /**
   * Runs one step of `timeStep` seconds. It takes no argument; `advance` runs steps for an elapsed
   * time.
   * @throws {ThudError} "memory": no body has then moved, and the step can be tried again; "locked"
   * inside a callback; "invalid" for an argument. An exception of a callback is thrown after the
   * step.
   */
  step(): void {
    if (arguments.length > 0) checkStep(arguments[0]);
    this.engine.check(this.engine.exports.api_world_step(this.address));
  }

  /**
   * Runs the whole steps that fit into the elapsed seconds (0 to 10⁹) and the time that earlier
   * calls left over, at most `maxSteps` (1 or more; default 4), and drops the time of further steps; call it
   * once a frame. `alpha`, in [0, 1), is the time left over as a fraction of a step, for `poses`.
   * The motion does not depend on the frame rate.
   *
   * Afterwards `events`, `eventPairs`, `impulseEvents` and `jointEvents` are those of all its
   * steps, none where it ran none. Forces that were applied since the last call act over all of the elapsed
   * time; forces for a single step are applied in `calls.before`. In `calls.before` and
   * `calls.after` the world may be changed, but not stepped, restored or closed; an exception of
   * them is thrown after the steps.
   *
   * @throws {ThudError} "memory" where a step runs out of memory: the steps before it have been
   * run, `stats().steps` counts them, and the rest of the time waits for the next call. "invalid"
   * for a value out of range, also for milliseconds in place of seconds; "locked" inside a
   * callback.
   */
  advance(elapsed: number, maxSteps = 4, calls: StepCalls = {}): { steps: number; alpha: number } {
    const { engine } = this;
    if (elapsed > 1) {
      this.onWorld("api_world_step_settings");
      checkElapsed(this, elapsed, maxSteps * engine.slots[StepSettingsAt.timeStep]);
    }
    const { before, after } = calls;
    const called = Number(before !== undefined) + 2 * Number(after !== undefined);
    if (called) engine.callbacks.set(this.address, { before, after });
    this.onWorld("api_world_advance", elapsed, maxSteps, called);
    return { steps: engine.slots[AdvanceAt.steps], alpha: engine.slots[AdvanceAt.alpha] };
  }

  /**
   * Sets gravity, length/s², from the next step on. Wakes all bodies.
   * @throws {ThudError} "invalid" for numbers that are not finite; "locked" inside a callback.
   * @example world.setGravity([0, 10])
   */
  setGravity(gravity: Vec2): void {
    this.onWorld("api_world_set_gravity", xOf(gravity, "gravity"), gravity?.[1]);
  }

  /**
   * Sets the length of a step, seconds in (0, 1], from the next step on.
   * @throws {ThudError} "invalid"; "locked" inside a callback.
   */
  setTimeStep(seconds: number): void {
    this.onWorld("api_world_set_time_step", seconds);
  }

  /**
   * Sets the quality from the next step on. For experts: `substeps`, 1 to 64; 0, the default, takes
   * the quality's. Substeps, contact stiffness, contact damping and detection that the options of
   * the world named keep their values. Wakes all bodies.
   * @throws {ThudError} "invalid"; "locked" inside a callback.
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

  /**
   * Sets the penetration depth, a length from 0 to 10⁹, beyond which an island is solved directly;
   * 0: none. See WorldOptions.maxError.
   * @throws {ThudError} "invalid"; "locked" inside a callback.
   */
  setMaxError(maxError: number): void {
    this.onWorld("api_world_set_max_error", maxError);
  }

  /**
   * Sets whether bodies at rest may sleep. False wakes all bodies.
   * @throws {ThudError} "invalid" for a value that is no boolean; "locked" inside a callback.
   */
  setSleeping(sleeping: boolean): void {
    this.onWorld("api_world_set_sleeping", flagOf(sleeping, "sleeping"));
  }

  /**
   * Throws the exception of a callback, or the error of `result` with the argument or option that
   * was wrong. `call` and `given`: see Explainer in checks/hook.ts.
   */
  protected refuse(result: number, call: string, given: object): void {
    this.engine.callbacks.rethrow(); // not explained, even where it is a ThudError
    try {
      this.engine.check(result);
    } catch (refused) {
      throw explained(refused, call, given, this.lengthScale);
    }
  }

  /**
   * Calls the module's function `name` with the world, a handle of this kind and the arguments, and
   * throws where it fails. The arguments are not a rest parameter, which would allocate a list;
   * WebAssembly ignores those that the function does not have.
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
    if (isOther(a) || isOther(b) || isOther(c) || isOther(d) || isOther(e) || isOther(f))
      this.#wantNumbers(name, [a, b, c, d, e, f]);
    const result = call(this.address, index1, generationOf(id), a!, b!, c!, d!, e!, f!);
    if (result !== 0 || this.engine.callbacks.hasThrown)
      this.refuse(result, name, [a, b, c, d, e, f]);
  }

  /** As `on`, for functions of the world, without a handle. */
  protected onWorld(name: string, a?: number, b?: number, c?: number): void {
    if (isOther(a) || isOther(b)) this.#wantNumbers(name, [a, b]);
    const result = this.engine.exports[name](this.address, a!, b!, c!);
    if (result !== 0 || this.engine.callbacks.hasThrown) this.refuse(result, name, [a, b]);
  }

  /** Throws "invalid" for arguments that are no numbers. */
  #wantNumbers(name: string, given: unknown[]): never {
    throw explained(new ThudError("invalid", "numbers are wanted"), name, given, this.lengthScale);
  }

  /** The shape handles of the list that the last call of the module has left in the slots. */
  protected shapeIds(): ShapeId[] {
    const { buffer, slots } = this.engine;
    return rowsOf(Uint32Array, buffer, slots, ListAt.address, HandleAt.length, shapeAt);
  }
}

/** Whether an argument is no number. WebAssembly would convert it: "1" to 1, [2] to 2. */
function isOther(value: unknown): boolean {
  return typeof value !== "number" && value !== undefined;
}
