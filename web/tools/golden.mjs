/**
 * The native engine's hashes of the scenes that demo/scenes has too: tests/golden/hashes.txt, which
 * tests/scenes/test_golden.c holds gcc's and clang's builds to.
 */
import { readFileSync } from "node:fs";

/** As in tests/scenes/test_golden.c; sizes are the C scenes' where those are small. */
export const GOLDEN_STEPS = 120;
const SMALL = {
  bullets: 15,
  broadphases: 90,
  cradle: 5,
  detection: 16,
  digging: 240,
  heavy_on_light: 5,
  minkowski: 2,
  pyramid: 100,
  slopes: 20,
  tall_stack: 30,
};
const SIZE_OF_OTHERS = 600;

const text = readFileSync(new URL("../../tests/golden/hashes.txt", import.meta.url), "utf8");

/** [{ name, size, hash }] */
export const GOLDEN = text
  .trim()
  .split("\n")
  .map((line) => {
    const [name, hash] = line.split(/\s+/);
    return { name, size: SMALL[name] ?? SIZE_OF_OTHERS, hash };
  });
