/** Runs the native thud-run, for tests that compare wasm with it. */
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync } from "node:fs";
import { root } from "./package.mjs";

const builds = ["release", "release-clang"].map((name) => `${root}build/${name}/demo/run/thud-run`);

/** The path of thud-run, from THUD_RUN or a build; null if it is not built. */
export const thudRun = process.env.THUD_RUN || (builds.find(existsSync) ?? null);

/** The reason to skip tests that need thud-run, or false. */
export const skip = thudRun ? false : "thud-run is not built (./run test builds it)";

/** The hash of a scene or level file after `steps` steps. */
export function nativeHash(what, steps, ...options) {
  const args = [what, "--steps", String(steps), "--json", ...options];
  const output = execFileSync(thudRun, args, {
    encoding: "utf8",
    cwd: root,
    stdio: ["ignore", "pipe", "ignore"],
  });
  const report = JSON.parse(output);
  assert.equal(report.steps, steps);
  return String(report.hash).replace(/^0x/, "");
}
