/** Chooses which of the package's WebAssembly modules this browser runs. */
import firstUrl from "thud/thud-first.wasm?url";
import restUrl from "thud/thud-rest.wasm?url";
import scalarUrl from "thud/thud-scalar.wasm?url";
import { hasSimd } from "./simd";

/** Addresses of the chosen module's files. */
export interface ChosenWasm {
  wasm: string;
  /** The second file of a module in two files, of which the first suffices for a first picture. */
  rest?: string;
  simd: boolean;
  /** Threads that the visitor has chosen in place of these files: thud-threads.wasm. */
  threads?: number;
}

/** The module with SIMD, or the scalar one in browsers without it (from before about 2021 to 2023).
 * Both give the same results; the scalar one is slower. */
export function chooseWasm(): ChosenWasm {
  const simd = hasSimd();
  return simd ? { wasm: firstUrl, rest: restUrl, simd } : { wasm: scalarUrl, simd };
}
