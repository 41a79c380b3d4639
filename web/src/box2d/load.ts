/**
 * Loads Box2D v3 as WebAssembly (npm box2d3-wasm), when it is first asked for. The package has two
 * builds: "deluxe" with SIMD and threads, "compat" with neither. Its own entry module takes
 * "deluxe" only on pages that are cross-origin isolated, which threads need. Without threads any
 * page can run it, so the builds are imported by their paths here.
 */
import type { MainModule } from "../../node_modules/box2d3-wasm/build/dist/es/deluxe/Box2D.deluxe";
import { messageOf } from "../shared/error";
import { hasSimd } from "../wasm/simd";

export type Box2D = MainModule;

let loading: Promise<Box2D> | null = null;

/** Returns the same module to every caller. After a failure the next call tries again. */
export function loadBox2D(): Promise<Box2D> {
  loading ??= load().catch((cause: unknown) => {
    loading = null;
    throw new Error(`Box2D could not be loaded: ${messageOf(cause)}`, { cause });
  });
  return loading;
}

/** To be called after the module trapped: the next call of `loadBox2D` loads a new one. */
export function forgetBox2D(): void {
  loading = null;
}

async function load(): Promise<Box2D> {
  const { default: start } = hasSimd()
    ? await import("../../node_modules/box2d3-wasm/build/dist/es/deluxe/Box2D.deluxe.mjs")
    : await import("../../node_modules/box2d3-wasm/build/dist/es/compat/Box2D.compat.mjs");
  return start({ pthreadCount: 0 });
}
