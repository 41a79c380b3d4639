/** Which of the package's WebAssembly modules this browser runs. */
import firstUrl from "thud/thud-first.wasm?url";
import restUrl from "thud/thud-rest.wasm?url";
import scalarUrl from "thud/thud-scalar.wasm?url";
import { hasSimd } from "./simd";

export interface ChosenWasm {
  wasm: string;
  /** The second file of an engine in two, for a quick first visit. */
  rest?: string;
  simd: boolean;
}

/** Both give the same results; without SIMD (before about 2021 to 2023) it takes longer. */
export function chooseWasm(): ChosenWasm {
  const simd = hasSimd();
  return simd ? { wasm: firstUrl, rest: restUrl, simd } : { wasm: scalarUrl, simd };
}
