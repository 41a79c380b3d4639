/**
 * One instance of a wasm module built from web/wasm: its memory, its exports, and the way results
 * become exceptions. Everything else in the package stands on it.
 */
import { messageOf, RESULT_CODES, ThudError } from "./error.js";
import { Rest, type RestSource } from "./rest.js";
import { CallbackTable } from "./rules/callbacks.js";
import type { WorldOptions } from "./types.js";
import { World } from "./world.js";

/** Where a module can come from. */
export type WasmSource = WebAssembly.Module | BufferSource | Response | URL | string;

type Export = (...args: number[]) => number;

/** Made by `load`. Makes worlds; several share its memory. */
export class Engine {
  /** The module's flat functions, for those who link code of their own beside the engine. */
  readonly exports: Readonly<Record<string, Export>>;
  /** The numbers that a call takes or gives beyond its arguments; see web/wasm. */
  slots: Float64Array;
  /** The stages of a step, in their order: the names in `Stats.stageSeconds`. */
  readonly stageNames: readonly string[];
  readonly #memory: WebAssembly.Memory;
  readonly #slotsAddress: number;
  readonly #messageAddress: number;
  readonly #rest: Rest | null;

  /** Instantiates a compiled module; with `source`, the first file of an engine in two. */
  static async instantiate(module: WebAssembly.Module, source?: RestSource): Promise<Engine> {
    const engine: { current?: Engine } = {};
    const callbacks = new CallbackTable();
    const env = {
      ...callbacks.imports(() => engine.current!.buffer),
      emscripten_notify_memory_growth: () => engine.current?.memoryGrew(),
      thud_clock: () => performance.now() / 1000,
    };
    const rest = source === undefined ? null : new Rest(source);
    const imports: WebAssembly.Imports = { env };
    if (rest) imports.placeholder = rest.placeholders;
    const instance = await WebAssembly.instantiate(module, imports);
    rest?.attach(instance);
    engine.current = new Engine(instance, rest, callbacks);
    return engine.current;
  }

  private constructor(
    instance: WebAssembly.Instance,
    rest: Rest | null,
    readonly callbacks: CallbackTable,
  ) {
    const { memory, _initialize } = instance.exports as {
      memory?: WebAssembly.Memory;
      _initialize?: () => void;
    };
    if (!memory || !_initialize || !instance.exports.api_slots_address)
      throw new ThudError("load", "this is not a wasm module of thud");
    this.#rest = rest;
    _initialize();
    this.exports = instance.exports as unknown as Record<string, Export>;
    this.#memory = memory;
    this.#slotsAddress = this.exports.api_slots_address();
    this.#messageAddress = this.exports.api_last_message();
    this.slots = new Float64Array(0);
    this.memoryGrew();
    const probe = this.createWorld();
    const stages = this.exports.api_world_stats(probe.address);
    probe.close();
    this.stageNames = Array.from({ length: stages }, (_, stage) =>
      this.text(this.exports.api_stage_name(stage)),
    );
  }

  /** Of the engine, such as "0.1.0"; the module's, where that is another one than the package's. */
  get version(): string {
    const number = this.exports.api_version();
    return [number / 1e6, (number / 1e3) % 1e3, number % 1e3].map(Math.floor).join(".");
  }

  /** Throws, and leaves nothing behind, for options out of range. Free it with `close`. */
  createWorld(options: WorldOptions = {}): World {
    return new World(this, options);
  }

  /** Brings the second file of an engine in two; resolves at once where there is but one. */
  async complete(): Promise<void> {
    await this.#rest?.load();
  }

  /** The whole memory; another buffer after it grew. */
  get buffer(): ArrayBuffer {
    return this.#memory.buffer;
  }

  /** Throws unless `result` is THUD_OK. */
  check(result: number): void {
    this.callbacks.rethrow();
    if (result === 0) return;
    const code = RESULT_CODES[result] as ThudError["code"] | undefined;
    const summary = this.text(this.exports.api_result_text(result));
    // Of defs it tells in C's spelling.
    const message = this.text(this.#messageAddress).replace(/_([a-z])/g, (_, letter) =>
      letter.toUpperCase(),
    );
    new Uint8Array(this.buffer)[this.#messageAddress] = 0;
    throw new ThudError(code ?? "invalid", message ? `${summary}: ${message}` : summary);
  }

  /** A C string. */
  text(address: number): string {
    const bytes = new Uint8Array(this.buffer, address);
    return new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0)));
  }

  /** Hands `use` the address of a copy of the numbers, which lives as long as the call. */
  withDoubles<T>(count: number, fill: (doubles: Float64Array) => void, use: (at: number) => T): T {
    const address = this.exports.malloc(Math.max(8, count * 8));
    if (address === 0) throw new ThudError("memory", "out of memory");
    try {
      fill(new Float64Array(this.buffer, address, count));
      return use(address);
    } finally {
      this.exports.free(address);
    }
  }

  private memoryGrew(): void {
    this.slots = new Float64Array(this.#memory.buffer, this.#slotsAddress, 64);
  }
}

/**
 * The thud.wasm that lies beside this file, or beside what a bundler made of it: written so that
 * bundlers see what is meant.
 */
export function besideModule(): URL {
  try {
    return new URL("./thud.wasm", import.meta.url);
  } catch (cause) {
    const why = "a script does not know where it lies";
    throw new ThudError("load", `${why}: give load the address of thud.wasm, or its bytes`, { cause });
  }
}

/** Compiles and starts a module from wherever it is. Files are added to that by node.ts. */
export async function instantiate(
  source: Exclude<WasmSource, URL | string>,
  rest?: RestSource,
): Promise<Engine> {
  if (typeof WebAssembly !== "object")
    throw new ThudError("load", "WebAssembly is missing or switched off here");
  let module: WebAssembly.Module;
  try {
    if (source instanceof WebAssembly.Module) module = source;
    else if (typeof Response === "function" && source instanceof Response)
      module = await compileResponse(source);
    else module = await WebAssembly.compile(source as BufferSource);
  } catch (cause) {
    if (cause instanceof ThudError) throw cause;
    const why = messageOf(cause);
    throw new ThudError("load", `the wasm module cannot be compiled: ${why}`, { cause });
  }
  return Engine.instantiate(module, rest);
}

async function compileResponse(response: Response): Promise<WebAssembly.Module> {
  if (!response.ok)
    throw new ThudError("load", `${response.url}: ${response.status} ${response.statusText}`);
  const type = response.headers.get("content-type") ?? "";
  if (type.startsWith("text/html"))
    throw new ThudError("load", `${response.url || "the source"} is a page (text/html), no wasm module`);
  // Streaming refuses any other type, which simple hosts are wont to send.
  if (type.startsWith("application/wasm")) return WebAssembly.compileStreaming(response);
  return WebAssembly.compile(await response.arrayBuffer());
}
