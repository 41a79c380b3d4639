/**
 * The random numbers of scenes: SplitMix64 (Steele, Lea, Flood: Fast splittable pseudorandom number
 * generators, 2014). The numbers are the same as those of demo/scene/random.h. A 64-bit number is
 * kept as two halves of 32 bits, which is about twenty times as fast as a BigInt.
 */

const HALF = 2 ** 32;

/** The upper 32 bits of the product of two 32-bit numbers. */
function upperProduct(a: number, b: number): number {
  const [a0, a1, b0, b1] = [a & 0xffff, a >>> 16, b & 0xffff, b >>> 16];
  const middle = a1 * b0 + Math.floor((a0 * b0) / 65536); // at most 2^32 - 2^16
  const rest = (middle % 65536) + a0 * b1;
  return a1 * b1 + Math.floor(middle / 65536) + Math.floor(rest / 65536);
}

/**
 * Returns a generator of numbers uniform in [low, high), in steps of 2^-53 of the range. `seed` is
 * a whole number from 0 on.
 */
export function random(seed: number): (low: number, high: number) => number {
  let high32 = Math.floor(seed / HALF) >>> 0;
  let low32 = seed >>> 0;
  // One round of mixing is z = (z ^ (z >> shift)) * factor; `zh` and `zl` are the halves of z.
  let zh = 0;
  let zl = 0;
  const mix = (shift: number, factorHigh: number, factorLow: number) => {
    const h = (zh ^ (zh >>> shift)) >>> 0;
    const l = (zl ^ ((zl >>> shift) | (zh << (32 - shift)))) >>> 0;
    zh = (upperProduct(l, factorLow) + Math.imul(h, factorLow) + Math.imul(l, factorHigh)) >>> 0;
    zl = Math.imul(l, factorLow) >>> 0;
  };
  return (low, high) => {
    const sum = low32 + 0x7f4a7c15;
    high32 = (high32 + 0x9e3779b9 + (sum >= HALF ? 1 : 0)) >>> 0;
    low32 = sum >>> 0;
    zh = high32;
    zl = low32;
    mix(30, 0xbf58476d, 0x1ce4e5b9);
    mix(27, 0x94d049bb, 0x133111eb);
    const h = (zh ^ (zh >>> 31)) >>> 0;
    const l = (zl ^ ((zl >>> 31) | (zh << 1))) >>> 0;
    // The upper 53 bits, as a fraction.
    return low + (high - low) * ((h * 2 ** 21 + (l >>> 11)) * 2 ** -53);
  };
}
