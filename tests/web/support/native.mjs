/** What the native thud-run says, for tests that hold wasm to it. */
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { existsSync } from "node:fs";
import { root } from "./package.mjs";

const builds = ["release", "release-clang"].map((name) => `${root}build/${name}/demo/run/thud-run`);

/** The native thud-run, or null where it has not been built; THUD_RUN names one. */
export const thudRun = process.env.THUD_RUN || (builds.find(existsSync) ?? null);

/** Why tests of it are skipped, or false. */
export const skip = thudRun ? false : "thud-run is not built (./run test builds it)";

/** The hash of a scene or level file after so many steps. */
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
