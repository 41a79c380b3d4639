/** Tests whether this browser runs WebAssembly with SIMD. */

/** A module of one function, () -> v128: i32.const 0, i8x16.splat, i8x16.popcnt. */
const PROBE = [
  0x00, 0x61, 0x73, 0x6d, 1, 0, 0, 0, // magic, version
  1, 5, 1, 0x60, 0, 1, 0x7b, // type 0: () -> v128
  3, 2, 1, 0, // function 0 is of type 0
  10, 10, 1, 8, 0, 0x41, 0, 0xfd, 0x0f, 0xfd, 0x62, 0x0b, // its code
];

export function hasSimd(): boolean {
  return typeof WebAssembly === "object" && WebAssembly.validate(new Uint8Array(PROBE));
}
