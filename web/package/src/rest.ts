/**
 * Loads the second file of an engine in two files. thud-first.wasm has the functions that a first
 * scene needs; thud-rest.wasm has all others. It is loaded when `Engine.complete` is called, or
 * else by the first call of one of its functions, which blocks until the file has arrived.
 *
 * binaryen's wasm-split makes both files: functions of the second file are called through the
 * module's table, whose entries are placeholders (imports of the first file) until the second file
 * is instantiated and writes its functions into them.
 */
import { ThudError } from "./error.js";

/** The URL of thud-rest.wasm, or its bytes. */
export type RestSource = URL | string | BufferSource;

/** thud-rest.wasm, the second file of one engine. */
export class RestFile {
  readonly #source: RestSource;
  #first: WebAssembly.Instance | null = null;
  #loading: Promise<void> | null = null;
  #done = false;

  constructor(source: RestSource) {
    this.#source = source;
  }

  /**
   * The imports of the first file: a placeholder for each entry of the table, named by its number.
   */
  get placeholders(): WebAssembly.ModuleImports {
    return new Proxy(
      {},
      { get: (_, slot) => (...args: unknown[]) => this.#call(Number(slot), args) },
    );
  }

  /** Sets the instance of the first file. */
  attach(first: WebAssembly.Instance): void {
    this.#first = first;
  }

  /** Loads the file once. Rejects with a ThudError "load"; a later call then tries again. */
  load(): Promise<void> {
    this.#loading ??= this.#fetch().catch((cause) => {
      this.#loading = null;
      throw new ThudError("load", "the second file of the engine cannot be loaded", { cause });
    });
    return this.#loading;
  }

  /** Fetches and compiles the file, and joins it to the first, unless that has been done. */
  async #fetch(): Promise<void> {
    if (this.#done) return;
    let bytes: BufferSource;
    if (typeof this.#source === "string" || this.#source instanceof URL) {
      const response = await fetch(this.#source);
      if (!response.ok) throw new Error(`${response.status} ${response.statusText}`);
      bytes = await response.arrayBuffer();
    } else bytes = this.#source;
    this.#join(await WebAssembly.compile(bytes));
  }

  /** Instantiates the second file, which writes its functions to the first file's table. */
  #join(module: WebAssembly.Module): void {
    // A call may have loaded it by #fetchAtOnce meanwhile.
    if (this.#done) return;
    new WebAssembly.Instance(module, { primary: this.#first!.exports });
    this.#done = true;
  }

  /**
   * Loads the file synchronously: a call of the module is under way, and cannot wait for a promise.
   * Throws a ThudError "load".
   */
  #fetchAtOnce(): void {
    if (typeof this.#source !== "string" && !(this.#source instanceof URL)) {
      this.#join(new WebAssembly.Module(this.#source));
      return;
    }
    const request = new XMLHttpRequest();
    request.open("GET", this.#source, false);
    // Outside of workers a synchronous request cannot return bytes: with this charset each
    // character of the text has one byte of the file in its lower 8 bits.
    request.overrideMimeType("text/plain; charset=x-user-defined");
    request.send();
    if (request.status !== 200)
      throw new ThudError("load", "the second file of the engine is missing");
    const bytes = Uint8Array.from(request.responseText, (letter) => letter.charCodeAt(0) & 0xff);
    this.#join(new WebAssembly.Module(bytes));
  }

  /** Calls the function of a table entry, after loading the file where it is not loaded. */
  #call(slot: number, args: unknown[]): unknown {
    if (!this.#done) this.#fetchAtOnce();
    const table = this.#first!.exports.__indirect_function_table as WebAssembly.Table;
    return (table.get(slot) as (...all: unknown[]) => unknown)(...args);
  }
}
