/**
 * The native engine's hashes of the scenes that demo/scenes has too: tests/golden/hashes.txt, which
 * tests/scenes/test_golden.c holds gcc's and clang's builds to.
 */
import { existsSync, readFileSync } from "node:fs";

/** As in tests/scenes/test_golden.c, like the sizes. */
export const GOLDEN_STEPS = 120;
const LARGE = 1000;
const SIZE_OF_LARGE = 600;

async function goldenOf(row) {
  const [name, hash] = row.split(/\s+/);
  const file = new URL(`../public/scenes/${name}.js`, import.meta.url);
  if (!existsSync(file)) return []; // a scene of C alone
  const { usual } = (await import(file.href)).size;
  return [{ name, size: usual > LARGE ? SIZE_OF_LARGE : usual, hash }];
}

const text = readFileSync(new URL("../../tests/golden/hashes.txt", import.meta.url), "utf8");

/** [{ name, size, hash }] */
export const GOLDEN = (await Promise.all(text.trim().split("\n").map(goldenOf))).flat();
