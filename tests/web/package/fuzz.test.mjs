/** Plays some seeds of the random calls of `./run fuzz js`. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { CALLS, play } from "../../fuzz/calls.mjs";
import { geometry, thud } from "../support/package.mjs";

const SEEDS = 60;
/** Methods that are called under another name, or by all other methods. */
const NOT_PLAYED = new Set([
  "constructor",
  "shapeIds",
  "close",
  "freeRoom",
  "makeSolid",
  "refuse",
  "on",
  "onWorld",
  "lengthScale",
  "revision",
]);

test("random calls throw the package's own errors and tell finite numbers", async () => {
  const engine = await thud.load();
  for (let seed = 1; seed <= SEEDS; seed++) assert.equal(play(engine, seed), 300);
});

test("every method of a world has its call", () => {
  const names = [];
  let kind = thud.World.prototype;
  for (; kind !== Object.prototype; kind = Object.getPrototypeOf(kind))
    names.push(...Object.getOwnPropertyNames(kind));
  const missing = names.filter((name) => !CALLS[name] && !NOT_PLAYED.has(name) && name !== "address");
  assert.deepEqual(missing, []);
  for (const name of ["Mover", "Rollback", "minkowskiSum"]) assert.ok(CALLS[name] && thud[name]);
  for (const name of Object.keys(geometry)) assert.ok(CALLS[name], name);
});
