/**
 * Tests that the typings compile in projects with older JavaScript libraries (`lib`), and that they
 * report a wrong call.
 */
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { root } from "../support/package.mjs";

const folder = mkdtempSync(join(tmpdir(), "thud-typings-"));
after(() => rmSync(folder, { recursive: true }));
mkdirSync(join(folder, "node_modules"));
symlinkSync(`${root}web/package`, join(folder, "node_modules", "thud"), "dir");

/** Every module that the package exports. */
const { exports } = JSON.parse(readFileSync(`${root}web/package/package.json`, "utf8"));
const modules = Object.keys(exports).filter((name) => !name.endsWith(".wasm"));
const PROGRAM = `${modules
  .map((name, i) => `import * as part${i} from "thud${name.slice(1)}";\nvoid part${i};\n`)
  .join("")}import { type BodyId, ThudError, type World } from "thud";

export function play(world: World): BodyId | string {
  const ball: BodyId = world.createBody({ kind: "dynamic", position: [0, 5] });
  try {
    world.step();
  } catch (error) {
    return error instanceof ThudError ? error.code : "";
  }
  return ball;
}
`;

/** The compiler's messages for a program. */
function compile(lib, program) {
  const compilerOptions = {
    target: "ES2018",
    module: "ESNext",
    moduleResolution: "Bundler",
    lib: [lib, "DOM"],
    types: [],
    strict: true,
    noEmit: true,
    skipLibCheck: false,
  };
  writeFileSync(join(folder, "tsconfig.json"), JSON.stringify({ compilerOptions, files: ["main.ts"] }));
  writeFileSync(join(folder, "main.ts"), program);
  const tsc = `${root}web/node_modules/typescript/bin/tsc`;
  return spawnSync(process.execPath, [tsc, "-p", folder], { encoding: "utf8" }).stdout;
}

for (const lib of ["ES2018", "ESNext"])
  test(`typings_are_whole_with_the_library_of_${lib}`, () => assert.equal(compile(lib, PROGRAM), ""));

test("typings_are_checked", () => {
  const wrong = PROGRAM.replace("world.step()", "world.step(1)");
  assert.match(compile("ES2018", wrong), /Expected 0 arguments, but got 1/);
});
