/**
 * The files that test the page, shared out among lanes: processes that run side by side, each with one
 * browser of a kind for all its files. Launching a browser and compiling the page and the engine in
 * it costs as much as several tests. Each file also runs alone, by `node --test FILE`.
 */
import { mkdirSync, readdirSync, statSync } from "node:fs";
import { basename } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";

/**
 * What the lanes of a run have taken, a folder for each file: making a folder fails for all processes
 * but the first. `npm run test:page` empties it beforehand.
 */
const TAKEN = fileURLToPath(new URL("../../../build/lanes/", import.meta.url));

/** All files, from large to small: a file's size says roughly how long its tests take. */
function testFiles() {
  const folder = fileURLToPath(new URL("../", import.meta.url));
  const inFolders = ["page/", "panels/"].flatMap((name) =>
    readdirSync(folder + name).map((file) => `${folder}${name}${file}`),
  );
  return [`${folder}clock.test.mjs`, ...inFolders]
    .filter((file) => file.endsWith(".test.mjs"))
    .sort((a, b) => statSync(b).size - statSync(a).size || (a < b ? -1 : 1));
}

/** Whether this lane may run the file: no lane has taken it before. */
function take(file) {
  try {
    mkdirSync(TAKEN + basename(file));
    return true;
  } catch (error) {
    if (error.code !== "EEXIST") throw error;
    return false;
  }
}

/**
 * Runs files until none is left, the next one as soon as the tests of the one before have ended, so
 * that all lanes end at about the same time. Node.js takes no more tests once all that it knows of
 * have ended: therefore a test of its own stays open after those of each file, until the next file is
 * imported. The import itself happens outside of that test, which would take the tests of the file for
 * its own.
 */
export async function runLane() {
  mkdirSync(TAKEN, { recursive: true });
  let next = openTest();
  let took = 0;
  try {
    for (const file of testFiles()) {
      if (!take(file)) continue;
      took += 1;
      await import(file);
      const before = next;
      next = openTest();
      before.close();
      await next.begun;
    }
    if (took === 0) throw new Error(`${TAKEN} is left of another run: remove it`);
    next.close();
  } catch (error) {
    next.fail(error);
  }
}

/** A test that lasts until it is closed or failed, and a promise that is fulfilled when it begins. */
function openTest() {
  const open = {};
  const end = new Promise((close, fail) => Object.assign(open, { close, fail }));
  open.begun = new Promise((begin) => {
    test("the_next_file_is_imported", () => {
      begin();
      return end;
    });
  });
  return open;
}
