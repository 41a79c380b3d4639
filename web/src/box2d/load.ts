/**
 * Box2D v3 as WebAssembly (npm box2d3-wasm), loaded when it is first asked for. Its own entry takes
 * the flavour with SIMD only on pages that are isolated from all others, because that one can also
 * run threads; without threads any page may have it, so the flavours are imported by their paths.
 */
import type { MainModule } from "../../node_modules/box2d3-wasm/build/dist/es/deluxe/Box2D.deluxe";
import { messageOf } from "../shared/error";
import { hasSimd } from "../wasm/simd";

export type Box2D = MainModule;

let loading: Promise<Box2D> | null = null;

/** The same module for every caller. After a failure the next call tries again. */
export function loadBox2D(): Promise<Box2D> {
  loading ??= load().catch((cause: unknown) => {
    loading = null;
    throw new Error(`Box2D could not be loaded: ${messageOf(cause)}`, { cause });
  });
  return loading;
}

/** After it trapped: the next call of `loadBox2D` starts a new one. */
export function forgetBox2D(): void {
  loading = null;
}

async function load(): Promise<Box2D> {
  const { default: start } = hasSimd()
    ? await import("../../node_modules/box2d3-wasm/build/dist/es/deluxe/Box2D.deluxe.mjs")
    : await import("../../node_modules/box2d3-wasm/build/dist/es/compat/Box2D.compat.mjs");
  return start({ pthreadCount: 0 });
}
