/** Calls from the module into JavaScript, by the address of the world that makes them. */
import { ListenedRowAt } from "../generated/slots.js";
import { shapeId } from "../numbers.js";
import type { StepCalls } from "../types.js";
import type { Listener, Listeners, PairFilter } from "./rule-types.js";

interface Callbacks extends Listeners, StepCalls {
  filter?: PairFilter;
}

/**
 * Of one engine. What a callback throws would leave its world locked if it went through the module:
 * it is kept, the others of the step are not called any more, and who called the module throws it.
 */
export class CallbackTable {
  readonly #worlds = new Map<number, Callbacks>();
  #thrown: { readonly cause: unknown } | null = null;
  #hear: (() => unknown) | null = null;

  /** Some of a world's; undefined takes one away. */
  set(world: number, callbacks: Callbacks): void {
    this.#worlds.set(world, { ...this.of(world), ...callbacks });
  }

  of(world: number): Readonly<Callbacks> {
    return this.#worlds.get(world) ?? {};
  }

  forget(world: number): void {
    this.#worlds.delete(world);
  }

  /** Casts, and `hear` is told of each hit; casts inside casts tell their own. */
  hearing(hear: () => unknown, cast: () => void): void {
    const before = this.#hear;
    this.#hear = hear;
    try {
      cast();
    } finally {
      this.#hear = before;
    }
  }

  get hasThrown(): boolean {
    return this.#thrown !== null;
  }

  /** Throws what a callback has thrown since. */
  rethrow(): void {
    if (this.#thrown === null) return;
    const { cause } = this.#thrown;
    this.#thrown = null;
    throw cause;
  }

  /** What the module imports. */
  imports(buffer: () => ArrayBuffer): WebAssembly.ModuleImports {
    const listen = (listener: Listener | undefined, address: number, count: number) =>
      this.#call(undefined, () =>
        listener?.(new Float64Array(buffer(), address, count * ListenedRowAt.length), count),
      );
    return {
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
      // What is thrown ends the cast.
      thud_met: () => this.#call(0, () => Number(this.#hear!() ?? 1)),
    };
  }

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
