/** Which of the package's two WebAssembly modules this browser runs. */
import scalarUrl from "thud/thud-scalar.wasm?url";
import simdUrl from "thud/thud.wasm?url";
import { hasSimd } from "./simd";

/** Both give the same results; without SIMD (before about 2021 to 2023) it takes longer. */
export function chooseWasm(): { url: URL; simd: boolean } {
  const simd = hasSimd();
  return { url: new URL(simd ? simdUrl : scalarUrl, location.href), simd };
}
