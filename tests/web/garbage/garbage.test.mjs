/**
 * Tests that a loop of calls which reuse their numbers and lists creates no objects. It counts
 * bytes per call, in a heap so large that nothing is collected in between. What remains are the
 * boxes of 16 bytes in which V8 passes numbers that are not small integers; an additional object or
 * list would be at least 32 bytes.
 */
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { fileURLToPath } from "node:url";
import { test } from "node:test";

const program = fileURLToPath(new URL("calls.mjs", import.meta.url));
// Bytes of one boxed number in V8.
const BOX = 16;

/**
 * For each call the largest number of boxed numbers: those passed in and out, and one for each read
 * of an option.
 */
const BOXES = {
  step: 0,
  poses: 0,
  eventViews: 2,
  contactViewOf: 4,
  setVelocity: 5,
  applyCenterForce: 4,
  applyTorque: 3,
  applyImpulse: 7,
  applyForce: 7,
  applyTyre: 12,
  setTransform: 5,
  positionOf: 5,
  worldPoint: 7,
  motionOf: 12,
  userDataOf: 4,
  castRayInto: 12,
  spawnAndDestroy: 30,
};

test("calls_with_numbers_and_lists_that_are_kept_make_no_objects", () => {
  const flags = ["--expose-gc", "--min-semi-space-size=128", "--max-semi-space-size=128"];
  const { status, stdout, stderr } = spawnSync(process.execPath, [...flags, program], {
    encoding: "utf8",
  });
  assert.equal(status, 0, stderr);
  const bytes = JSON.parse(stdout);
  assert.deepEqual(Object.keys(bytes).sort(), [...Object.keys(BOXES), "castRay"].sort());
  for (const [name, boxes] of Object.entries(BOXES))
    assert.ok(bytes[name] < BOX * boxes + 12, `${name}: ${bytes[name]} bytes a call`);
  assert.ok(bytes.castRay > 300, "objects are seen where they are made");
});
