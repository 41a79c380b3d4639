/**
 * Runs the program of the package's README as a user would, and compares what it prints with the
 * text.
 */
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import {
  copyFileSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { root } from "../support/package.mjs";

const readme = readFileSync(`${root}web/package/README.md`, "utf8");
const program = [...readme.matchAll(/^```js\n(.*?)^```/gms)].map(([, block]) => block).join("\n");
const folder = mkdtempSync(join(tmpdir(), "thud-readme-"));
after(() => rmSync(folder, { recursive: true }));

test("readme_blocks_together_print_what_their_comments_say", () => {
  mkdirSync(join(folder, "node_modules"));
  symlinkSync(`${root}web/package`, join(folder, "node_modules", "thud"), "dir");
  copyFileSync(`${root}assets/levels/quarry.tmj`, join(folder, "level.tmj"));
  writeFileSync(join(folder, "program.mjs"), program);
  const { status, stdout, stderr } = spawnSync(process.execPath, ["program.mjs"], {
    cwd: folder,
    encoding: "utf8",
  });
  assert.equal(status, 0, stderr);
  const comments = program.matchAll(/^console\.log\(.*\); \/\/ (.*)$/gm);
  const promised = [...comments].map(([, text]) => text);
  assert.ok(promised.length >= 5, "every part shows something");
  assert.deepEqual(stdout.trim().split("\n"), promised);
});

test("readme_names_every_file_that_the_package_exports", () => {
  const { exports } = JSON.parse(readFileSync(`${root}web/package/package.json`, "utf8"));
  for (const name of Object.keys(exports))
    assert.ok(readme.includes(name.replace(/^\./, "thud")), `${name} is not in the README`);
});
