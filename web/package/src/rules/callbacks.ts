/**
 * The functions that the module imports and calls: listeners, pair filters, step callbacks and cast
 * listeners, found by the address of the world that calls them.
 */
import { ListenedRowAt } from "../generated/slots.js";
import { shapeId } from "../numbers.js";
import type { StepCalls } from "../types.js";
import type { Listener, Listeners, ObjectListener, PairFilter } from "./rule-types.js";

/** The callbacks of a world. */
interface Callbacks extends Listeners, StepCalls {
  filter?: PairFilter;
  /** The epilogues of bodies, by index1, and of categories, by their bits. */
  bodies?: Map<number, ObjectListener>;
  categories?: Map<number, ObjectListener>;
}

/**
 * The callbacks of one engine. An exception must not pass through the module, which would leave its
 * world locked: it is kept, no further callback is called, and `rethrow` throws it after the call
 * of the module has returned.
 */
export class CallbackTable {
  readonly #worlds = new Map<number, Callbacks>();
  #thrown: { readonly cause: unknown } | null = null;
  #hear: (() => unknown) | null = null;

  /** Sets callbacks of a world; undefined removes one, and those that are not named stay. */
  set(world: number, callbacks: Callbacks): void {
    this.#worlds.set(world, { ...this.of(world), ...callbacks });
  }

  /** Sets the epilogue of an object of a world; null removes it. */
  setObject(world: number, of: "bodies" | "categories", key: number, epilogue: ObjectListener | null): void {
    const all = this.of(world)[of] ?? new Map<number, ObjectListener>();
    if (epilogue === null) all.delete(key);
    else all.set(key, epilogue);
    this.set(world, { [of]: all });
  }

  /** The callbacks of a world. */
  of(world: number): Readonly<Callbacks> {
    return this.#worlds.get(world) ?? {};
  }

  /** Removes all callbacks of a world that is closed. */
  forget(world: number): void {
    this.#worlds.delete(world);
  }

  /** Runs `cast`, during which `hear` is called for each hit. Casts may be nested. */
  hearing(hear: () => unknown, cast: () => void): void {
    const before = this.#hear;
    this.#hear = hear;
    try {
      cast();
    } finally {
      this.#hear = before;
    }
  }

  /** Whether a callback has thrown since the last `rethrow`. */
  get hasThrown(): boolean {
    return this.#thrown !== null;
  }

  /** Throws what a callback threw since the last `rethrow`, if one did. */
  rethrow(): void {
    if (this.#thrown === null) return;
    const { cause } = this.#thrown;
    this.#thrown = null;
    throw cause;
  }

  /** The functions that the module imports. `buffer` returns the module's memory at that time. */
  imports(buffer: () => ArrayBuffer): WebAssembly.ModuleImports {
    const listen = (listener: Listener | undefined, address: number, count: number) =>
      this.#call(undefined, () =>
        listener?.(new Float64Array(buffer(), address, count * ListenedRowAt.length), count),
      );
    const tell = (of: "bodies" | "categories") => (world: number, row: number, key: number, side: number) =>
      this.#call(undefined, () =>
        this.of(world)[of]?.get(key >>> 0)?.(
          new Float64Array(buffer(), row, ListenedRowAt.length),
          side as 0 | 1,
        ),
      );
    return {
      thud_told_body: tell("bodies"),
      thud_told_category: tell("categories"),
      thud_asked: (world: number, rows: number, count: number) =>
        listen(this.of(world).prologue, rows, count),
      thud_told: (world: number, rows: number, count: number) =>
        listen(this.of(world).epilogue, rows, count),
      thud_filtered: (world: number, a: number, ofA: number, b: number, ofB: number) => {
        const filter = this.of(world).filter;
        return this.#call(1, () =>
          Number(filter?.(shapeId(a, ofA >>> 0), shapeId(b, ofB >>> 0)) ?? true),
        );
      },
      thud_stepped: (world: number, after: number) => {
        const calls = this.of(world);
        this.#call(undefined, () => (after ? calls.after : calls.before)?.());
      },
      // Returns the cast's limit: 0 ends the cast after an exception.
      thud_cast_hit: () => this.#call(0, () => Number(this.#hear!() ?? 1)),
    };
  }

  /** Calls a callback, unless one has thrown; keeps its exception, and returns `otherwise` then. */
  #call<T>(otherwise: T, callback: () => T | undefined): T | undefined {
    if (this.#thrown !== null) return otherwise;
    try {
      return callback();
    } catch (cause) {
      this.#thrown = { cause };
      return otherwise;
    }
  }
}
