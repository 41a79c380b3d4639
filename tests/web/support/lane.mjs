/**
 * Files of tests, shared out among lanes: processes that run side by side, each with one engine, or
 * one browser of a kind, for all its files. Launching a browser and compiling the page and the engine
 * in it costs as much as several tests, and starting Node.js and compiling the engine as much as most
 * files without a page. Each file also runs alone, by `node --test FILE`.
 */
import { mkdirSync, readdirSync, statSync } from "node:fs";
import { test } from "node:test";
import { fileURLToPath } from "node:url";

const TESTS = fileURLToPath(new URL("../", import.meta.url));

/** All files, from large to small: a file's size says roughly how long its tests take. */
function testFiles(folders, files) {
  const inFolders = folders.flatMap((name) =>
    readdirSync(TESTS + name).map((file) => `${TESTS}${name}/${file}`),
  );
  return [...files.map((file) => TESTS + file), ...inFolders]
    .filter((file) => file.endsWith(".test.mjs"))
    .sort((a, b) => statSync(b).size - statSync(a).size || (a < b ? -1 : 1));
}

/** Whether this lane may run the file: no lane has taken it before. */
function take(taken, file) {
  try {
    // Making a folder fails for all processes but the first.
    mkdirSync(taken + file.slice(TESTS.length).replace("/", "-"));
    return true;
  } catch (error) {
    if (error.code !== "EEXIST") throw error;
    return false;
  }
}

/**
 * Runs files of these folders of tests/web, and further files, until none is left, the next one as soon as the tests of the one before have ended, so
 * that all lanes end at about the same time. Node.js takes no more tests once all that it knows of
 * have ended: therefore a test of its own stays open after those of each file, until the next file is
 * imported. The import itself happens outside of that test, which would take the tests of the file for
 * its own. `set`: the name of all lanes that share these files; build/lanes/`set` says which are
 * taken, and has to be removed before a run.
 */
export async function runLane(set, folders, files = []) {
  const taken = fileURLToPath(new URL(`../../../build/lanes/${set}/`, import.meta.url));
  mkdirSync(taken, { recursive: true });
  let next = openTest();
  let took = 0;
  try {
    for (const file of testFiles(folders, files)) {
      if (!take(taken, file)) continue;
      took += 1;
      await import(file);
      const before = next;
      next = openTest();
      before.close();
      await next.begun;
    }
    if (took === 0) throw new Error(`${taken} is left of another run: remove it`);
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
