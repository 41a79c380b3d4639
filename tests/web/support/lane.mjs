/**
 * The files that test the page, dealt to lanes: processes that run side by side, each with one
 * browser of a kind for all its files. Launching a browser and compiling the page and the engine in
 * it costs as much as several tests. Each file also runs alone, by `node --test FILE`.
 */
import { readdirSync, statSync } from "node:fs";
import { test } from "node:test";
import { fileURLToPath } from "node:url";

/** The number of lanes: those of tests/web/lanes. More than processors, because tests also wait. */
const LANES = 3;

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

/** The files of one lane: dealt there and back, so that no lane gets the largest of each round. */
function filesOf(lane) {
  return testFiles().filter((_, i) => {
    const place = i % (2 * LANES);
    return (place < LANES ? place : 2 * LANES - 1 - place) === lane;
  });
}

/**
 * Runs the files of a lane, `lane` from 0. The first test ends when all files are imported: tests
 * that are registered later than the end of all tests before them would not run.
 */
export function runLane(lane) {
  const imported = Promise.all(filesOf(lane).map((file) => import(file)));
  test(`files_of_lane_${lane}_are_imported`, () => imported);
}
