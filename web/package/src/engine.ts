/**
 * Compiles and starts a wasm module built from web/wasm, and wraps its instance: its memory, its
 * exports, and how results of calls become exceptions. All other files of the package call the
 * module through it. An "address" is a position in wasm memory here, in bytes.
 */
import { messageOf, RESULT_CODES, ThudError } from "./error.js";
import { RestFile, type RestSource } from "./rest.js";
import { CallbackTable } from "./rules/callbacks.js";
import type { Vec2, WorldOptions } from "./types.js";
import { World } from "./world.js";

/** A compiled module, its bytes, a response of fetch, or a URL; in Node.js also a path. */
export type WasmSource = WebAssembly.Module | BufferSource | Response | URL | string;

type Export = (...args: number[]) => number;

/** Numbers in `Engine.slots`: those of union api_slots in web/wasm/slots.h. */
const SLOT_COUNT = 64;

/** Made by `load`. Makes worlds, which share its memory. */
export class Engine {
  /**
   * The module's exported functions, for programs that link C code of their own with the engine.
   */
  readonly exports: Readonly<Record<string, Export>>;
  /**
   * 64 numbers in wasm memory, through which calls take and return what does not fit into their
   * arguments; web/wasm/slots.h has their places. Another array after the memory has grown.
   */
  slots: Float64Array;
  /**
   * How many threads share the large steps of worlds that are created from now on; 1: the calling
   * one alone. More than 1 only where `load` was asked for it and threads can share memory.
   */
  threads = 1;
  /** The names of the stages of a step in their order: the keys of `Stats.stageSeconds`. */
  readonly stageNames: readonly string[];
  readonly #memory: WebAssembly.Memory;
  readonly #slotsAddress: number;
  readonly #messageAddress: number;
  /** thud-rest.wasm, where the engine is in two files (rest.ts); null where it is in one. */
  readonly #restFile: RestFile | null;

  /**
   * Instantiates a compiled module: all of the engine, or thud-first.wasm, whose second file
   * thud-rest.wasm is then found by `rest`, or thud-threads.wasm, which imports the `memory`.
   * Rejects with a ThudError "load", or with the browser's LinkError, for a module that is not
   * thud's.
   */
  static async instantiate(
    module: WebAssembly.Module,
    rest?: RestSource,
    memory?: WebAssembly.Memory,
  ): Promise<Engine> {
    // The module's imports are made before the engine, and reach it through this object.
    const engine: { current?: Engine } = {};
    const callbacks = new CallbackTable();
    const env = {
      ...callbacks.imports(() => engine.current!.buffer),
      emscripten_notify_memory_growth: () => engine.current?.memoryGrew(),
      thud_clock: () => performance.now() / 1000,
      memory,
    };
    const restFile = rest === undefined ? null : new RestFile(rest);
    const imports = { env } as WebAssembly.Imports;
    // binaryen's wasm-split, which makes the two files, gives the module of these imports its name.
    if (restFile) imports.placeholder = restFile.placeholders;
    const instance = await WebAssembly.instantiate(module, imports);
    restFile?.attach(instance);
    engine.current = new this(instance, restFile, callbacks, memory);
    return engine.current;
  }

  protected constructor(
    instance: WebAssembly.Instance,
    restFile: RestFile | null,
    readonly callbacks: CallbackTable,
    shared?: WebAssembly.Memory,
  ) {
    const { memory = shared, _initialize } = instance.exports as {
      memory?: WebAssembly.Memory;
      _initialize?: () => void;
    };
    if (!memory || !_initialize || !instance.exports.api_slots_address)
      throw new ThudError("load", "this is not a wasm module of thud");
    this.#restFile = restFile;
    _initialize();
    this.exports = instance.exports as unknown as Record<string, Export>;
    this.#memory = memory;
    this.#slotsAddress = this.exports.api_slots_address();
    this.#messageAddress = this.exports.api_last_message();
    this.slots = new Float64Array(0);
    this.memoryGrew();
    // api_world_stats returns the number of stages, and needs a world. That one fits into the memory
    // that the module starts with, so that `slots` stays valid.
    const probe = this.createWorld();
    const stageCount = this.exports.api_world_stats(probe.address);
    probe.close();
    this.stageNames = Array.from({ length: stageCount }, (_, stage) =>
      this.text(this.exports.api_stage_name(stage)),
    );
  }

  /** The version of the wasm module, such as "0.2.0"; it may differ from that of the package. */
  get version(): string {
    const number = this.exports.api_version();
    return [number / 1e6, (number / 1e3) % 1e3, number % 1e3].map(Math.floor).join(".");
  }

  /**
   * Makes a world. Free it with `close`: no garbage collector frees its memory.
   * @throws {ThudError} "invalid" for an unknown option or a value out of range; "memory".
   */
  createWorld(options: WorldOptions = {}): World {
    return new World(this, options);
  }

  /**
   * Loads thud-rest.wasm, the second file of an engine in two files, which has all functions that a
   * first scene does not need; resolves at once where the engine is in one file. Without this call,
   * the first call of one of those functions loads the file, and blocks until it has arrived.
   * Rejects with a ThudError "load" where the file cannot be loaded; call it again to retry.
   */
  async complete(): Promise<void> {
    await this.#restFile?.load();
  }

  /**
   * Ends the threads that `load` started; the worlds go on without them, and with the same results.
   * Without this call they end with the page or the process, and keep the engine's memory until
   * then. It does nothing where there are none.
   */
  endThreads(): void {}

  /**
   * The module's memory. When it grows, another buffer takes its place, and old views are empty.
   * With threads it is a SharedArrayBuffer.
   */
  get buffer(): ArrayBuffer {
    return this.#memory.buffer;
  }

  /**
   * Throws what a callback threw during the call, or, unless `result` is 0 (THUD_OK), a ThudError
   * with the engine's message.
   */
  check(result: number): void {
    this.callbacks.rethrow();
    if (result === 0) return;
    const code = RESULT_CODES[result] as ThudError["code"] | undefined;
    const summary = this.text(this.exports.api_result_text(result));
    // The engine names fields as C spells them: time_step for timeStep.
    const message = this.text(this.#messageAddress).replace(/_([a-z])/g, (_, letter) =>
      letter.toUpperCase(),
    );
    new Uint8Array(this.buffer)[this.#messageAddress] = 0;
    throw new ThudError(code ?? "invalid", message ? `${summary}: ${message}` : summary);
  }

  /** The C string (UTF-8) at an address. */
  text(address: number): string {
    const bytes = new Uint8Array(this.buffer, address);
    // A copy, since TextDecoder refuses shared memory.
    return new TextDecoder().decode(bytes.slice(0, bytes.indexOf(0)));
  }

  /**
   * Allocates `count` numbers in wasm memory, which `fill` writes, and returns what `use` returns
   * for their address. They are freed afterwards. Throws a ThudError "memory".
   */
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

  /** The same with x and y of each of a list of points; `use` also gets their number. */
  withPoints<T>(points: ArrayLike<Vec2>, use: (at: number, count: number) => T): T {
    const count = points.length;
    const fill = (doubles: Float64Array) => {
      for (let i = 0; i < count; i++) doubles.set(points[i], 2 * i);
    };
    return this.withDoubles(2 * count, fill, (at) => use(at, count));
  }

  private memoryGrew(): void {
    this.slots = new Float64Array(this.#memory.buffer, this.#slotsAddress, SLOT_COUNT);
  }
}

/**
 * The URL of thud.wasm beside this file. Bundlers recognise `new URL("…", import.meta.url)`: they
 * copy the file and put in its new URL. Throws a ThudError "load" where a bundler has made a
 * classic script of this file: import.meta.url is undefined there.
 */
export function defaultWasmUrl(): URL {
  try {
    return new URL("./thud.wasm", import.meta.url);
  } catch (cause) {
    const why = "a script does not know where it lies";
    throw new ThudError("load", `${why}: give load the URL of thud.wasm, or its bytes`, { cause });
  }
}

/**
 * Compiles and starts a module. Its source is no URL: `load` of first.ts fetches URLs, `load` of
 * node.ts reads files. `rest`: thud-rest.wasm, where `source` is thud-first.wasm. Rejects with a
 * ThudError "load".
 */
export async function instantiate(
  source: Exclude<WasmSource, URL | string>,
  rest?: RestSource,
): Promise<Engine> {
  if (typeof WebAssembly !== "object")
    throw new ThudError("load", "WebAssembly is missing or switched off here");
  try {
    let module: WebAssembly.Module;
    if (source instanceof WebAssembly.Module) module = source;
    else if (typeof Response === "function" && source instanceof Response)
      module = await compileResponse(source);
    else module = await WebAssembly.compile(source as BufferSource);
    return await Engine.instantiate(module, rest);
  } catch (cause) {
    if (cause instanceof ThudError) throw cause;
    const why = messageOf(cause);
    throw new ThudError("load", `the wasm module cannot be compiled or linked: ${why}`, { cause });
  }
}

/**
 * Compiles a response of fetch. Rejects with a ThudError "load" for an error status or an HTML
 * page, which some hosts send for a file that is missing.
 */
async function compileResponse(response: Response): Promise<WebAssembly.Module> {
  if (!response.ok)
    throw new ThudError("load", `${response.url}: ${response.status} ${response.statusText}`);
  const type = response.headers.get("content-type") ?? "";
  if (type.startsWith("text/html"))
    throw new ThudError("load", `${response.url || "the source"} is a page (text/html), no wasm module`);
  // compileStreaming refuses all other content types, also this one with parameters. Simple hosts
  // send another one.
  if (type === "application/wasm") return WebAssembly.compileStreaming(response);
  return WebAssembly.compile(await response.arrayBuffer());
}
