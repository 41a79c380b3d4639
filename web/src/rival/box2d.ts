/**
 * Box2D v3 as WebAssembly (npm box2d3-wasm), loaded when it is first asked for. Its own entry takes
 * the flavour with SIMD only on pages that are isolated from all others, because that one can also
 * run threads; without threads any page may have it, so the flavours are imported by their paths.
 */
import type { MainModule } from "../../node_modules/box2d3-wasm/build/dist/es/deluxe/Box2D.deluxe";

export type Box2D = MainModule;

/** A function that returns a vector of zeros: valid only where there is WebAssembly SIMD. */
const SIMD_MODULE = new Uint8Array([
  ...[0x00, 0x61, 0x73, 0x6d, 0x01, 0x00, 0x00, 0x00], // magic number and version
  ...[0x01, 0x05, 0x01, 0x60, 0x00, 0x01, 0x7b], // types: () -> v128
  ...[0x03, 0x02, 0x01, 0x00], // functions: one of that type
  ...[0x0a, 0x08, 0x01, 0x06, 0x00, 0x41, 0x00, 0xfd, 0x0f, 0x0b], // code: i32.const 0, i8x16.splat
]);

let loading: Promise<Box2D> | null = null;

/** The same module for every caller. After a failure the next call tries again. */
export function loadBox2D(): Promise<Box2D> {
  loading ??= load().catch((cause: unknown) => {
    loading = null;
    const why = cause instanceof Error ? cause.message : String(cause);
    throw new Error(`Box2D could not be loaded: ${why}`, { cause });
  });
  return loading;
}

async function load(): Promise<Box2D> {
  const { default: start } = WebAssembly.validate(SIMD_MODULE)
    ? await import("../../node_modules/box2d3-wasm/build/dist/es/deluxe/Box2D.deluxe.mjs")
    : await import("../../node_modules/box2d3-wasm/build/dist/es/compat/Box2D.compat.mjs");
  return start({ pthreadCount: 0 });
}
