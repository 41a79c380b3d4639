/**
 * Reads tests/golden/hashes.txt, the world hashes that native builds of the engine reach in each
 * scene (tests/scenes/test_golden.c compares builds by gcc and clang with them), for the scenes
 * that also exist in JavaScript.
 */
import { existsSync, readFileSync } from "node:fs";

/** Steps after which the hash is taken, as in tests/scenes/test_golden.c. */
export const GOLDEN_STEPS = 120;
/** Scenes with a larger usual size than this have SIZE_OF_LARGE, also as in test_golden.c. */
const LARGE = 1000;
const SIZE_OF_LARGE = 600;

/** The entry of a row "NAME HASH" as a list; empty for a scene that exists in C only. */

async function goldenOf(row) {
  const [name, hash] = row.split(/\s+/);
  const file = new URL(`../public/scenes/${name}.js`, import.meta.url);
  if (!existsSync(file)) return [];
  const { usual } = (await import(file.href)).size;
  return [{ name, size: usual > LARGE ? SIZE_OF_LARGE : usual, hash }];
}

const text = readFileSync(new URL("../../tests/golden/hashes.txt", import.meta.url), "utf8");

/** [{ name, size, hash }] */
export const GOLDEN = (await Promise.all(text.trim().split("\n").map(goldenOf))).flat();
