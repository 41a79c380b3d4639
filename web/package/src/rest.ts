/**
 * The second file of an engine in two. thud-first.wasm has what a first scene needs; thud-rest.wasm
 * has everything else and is brought a little later: when `Engine.complete` is called, or, if that
 * was not done in time, by the first call of something in it, which then waits for the network.
 *
 * Made by binaryen's wasm-split: functions of the second file are called through the table, whose
 * slots hold placeholders until that file is there and puts itself into them.
 */
import { ThudError } from "./error.js";

/** An address, or what stands there. */
export type RestSource = URL | string | BufferSource;

export class Rest {
  readonly #source: RestSource;
  #first: WebAssembly.Instance | null = null;
  #loading: Promise<void> | null = null;
  #done = false;

  constructor(source: RestSource) {
    this.#source = source;
  }

  /** What the first file imports: a function for each slot of the table that is still empty. */
  get placeholders(): WebAssembly.ModuleImports {
    return new Proxy(
      {},
      { get: (_, slot) => (...args: unknown[]) => this.#call(Number(slot), args) },
    );
  }

  attach(first: WebAssembly.Instance): void {
    this.#first = first;
  }

  load(): Promise<void> {
    this.#loading ??= this.#fetch().catch((cause) => {
      this.#loading = null;
      throw new ThudError("load", "the second file of the engine cannot be loaded", { cause });
    });
    return this.#loading;
  }

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

  #join(module: WebAssembly.Module): void {
    // A call may have brought it meanwhile.
    if (this.#done) return;
    new WebAssembly.Instance(module, { primary: this.#first!.exports });
    this.#done = true;
  }

  /** The engine is in the middle of a call: there is no way to wait but this. */
  #fetchAtOnce(): void {
    if (typeof this.#source !== "string" && !(this.#source instanceof URL)) {
      this.#join(new WebAssembly.Module(this.#source));
      return;
    }
    const request = new XMLHttpRequest();
    request.open("GET", this.#source, false);
    // Only workers may ask for bytes so; elsewhere each letter of the text stands for one.
    request.overrideMimeType("text/plain; charset=x-user-defined");
    request.send();
    if (request.status !== 200)
      throw new ThudError("load", "the second file of the engine is missing");
    const bytes = Uint8Array.from(request.responseText, (letter) => letter.charCodeAt(0) & 0xff);
    this.#join(new WebAssembly.Module(bytes));
  }

  #call(slot: number, args: unknown[]): unknown {
    if (!this.#done) this.#fetchAtOnce();
    const table = this.#first!.exports.__indirect_function_table as WebAssembly.Table;
    return (table.get(slot) as (...all: unknown[]) => unknown)(...args);
  }
}
