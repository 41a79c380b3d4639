/**
 * Tests the packed npm package without a bundler: in Node and its workers, Deno, Bun, and browsers
 * with an import map. Parcel, Deno and Bun are tested if they are on the path or installed here.
 */
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { createHash } from "node:crypto";
import { cpSync, existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { after, test } from "node:test";
import { BROWSERS } from "../../../web/tools/browser.mjs";
import { bundlers, expectedIn, host, makeProject, openBrowser, POLICY, recipeOf, tell, write } from "../support/packed.mjs";
import { root } from "../support/package.mjs";

const project = makeProject();
const { folder } = project;
const expected = tell(process.execPath, ["node.js"], folder);
after(project.remove);

/** The command, or null if it does not run. */
function find(name) {
  const here = `${bundlers}node_modules/.bin/${name}`;
  const command = existsSync(here) ? here : name;
  return spawnSync(command, ["--version"]).status === 0 ? command : null;
}

const IN_WORKER = `import { Worker } from "node:worker_threads";

new Worker(new URL("./posting.js", import.meta.url)).on("message", (told) => {
  console.log(JSON.stringify(told));
});
`;
const POSTING = `import { parentPort } from "node:worker_threads";
import { run } from "./run.js";

run().then((told) => parentPort.postMessage(told));
`;
write(folder, { "in-worker.js": IN_WORKER, "posting.js": POSTING });

test("tarball_has_every_file_that_the_package_exports_and_no_source", () => {
  const { exports } = JSON.parse(readFileSync(`${root}web/package/package.json`, "utf8"));
  const named = Object.values(exports).flatMap((target) =>
    typeof target === "string" ? [target] : Object.values(target),
  );
  for (const file of named) assert.ok(project.files.includes(file.slice(2)), file);
  for (const file of project.files)
    assert.match(file, /^(dist\/[\w/-]+\.(js|d\.ts|wasm)|LICENSE|README\.md|package\.json)$/);
});

test("two_threads_share_the_steps_of_a_large_world_with_the_same_bits", () => {
  assert.deepEqual(expected.shared, { threads: 2, same: true, helped: true });
});

test("ball_has_fallen_onto_the_box", () => {
  assert.ok(expected.height > 1.4 && expected.height < 2, String(expected.height));
  assert.match(expected.hash, /^[0-9a-f]{16}$/);
});

test("worker_of_node_says_the_same_bits", () => {
  assert.deepEqual(tell(process.execPath, ["in-worker.js"], folder), expected);
});

/** The arguments with which each runtime is started, as the README says. */
const RUNTIMES = { Deno: recipeOf("Deno")[0].split(" ").slice(1), Bun: ["run"] };

for (const [name, words] of Object.entries(RUNTIMES)) {
  const command = find(name.toLowerCase());
  const skip = command ? false : `${name} is not on the path, and npm brought none`;
  for (const file of ["node.js", "in-worker.js"])
    test(`${name}_runs_${file}_with_the_same_bits`, { skip }, () => {
      assert.deepEqual(tell(command, [...words, file], folder), expected);
    });
}

/** A page with an import map; workers do not get the map, so the worker imports paths. */
test("page_with_an_import_map_and_its_worker_say_the_same_bits", async (t) => {
  const [map] = recipeOf("import map");
  const { imports } = JSON.parse(map);
  const page = readFileSync(join(folder, "index.html"), "utf8");
  const direct = Object.entries(imports).reduce(
    (text, [name, path]) => text.replace(`"${name}"`, `"${path}"`),
    readFileSync(join(folder, "run.js"), "utf8"),
  );
  const worker = readFileSync(join(folder, "worker.js"), "utf8").replace("run.js", "direct.js");
  const out = join(folder, "bare");
  cpSync(join(folder, "node_modules"), join(out, "node_modules"), { recursive: true });
  for (const name of ["run.js", "main.js"]) cpSync(join(folder, name), join(out, name));
  write(out, {
    "index.html": page.replace("<script", `<script type="importmap">${map}</script>\n<script`),
    "direct.js": direct,
    "worker.js": worker,
  });
  const hash = createHash("sha256").update(map).digest("base64");
  const { url, close } = await host(out, POLICY.replace("'self'", `'self' 'sha256-${hash}'`));
  t.after(close);
  for (const name of BROWSERS) {
    const browser = await openBrowser(name);
    t.after(browser.close);
    const { told, troubles } = await browser.tell(url);
    assert.deepEqual(told, expectedIn(name, expected), name);
    assert.deepEqual(troubles, [], name);
  }
});

const parcel = process.env.PARCEL ?? find("parcel");
const noParcel = parcel ? false : "Parcel, of 110 MB, is not on the path; PARCEL names one";

test("page_bundled_by_Parcel_says_the_same_bits", { skip: noParcel }, async (t) => {
  const settings = JSON.parse(`{ ${recipeOf("Parcel")[0]} }`);
  write(folder, { "package.json": JSON.stringify({ private: true, name: "try", ...settings }) });
  const words = ["build", "index.html", "--dist-dir", "parcel", "--no-cache", "--public-url", "./"];
  const { status, stderr } = spawnSync(parcel, words, { cwd: folder, encoding: "utf8" });
  assert.equal(status, 0, stderr);
  // Parcel writes an inline import map into the page.
  const policy = POLICY.replace("'self'", "'self' 'unsafe-inline'");
  const { url, close } = await host(join(folder, "parcel"), policy);
  t.after(close);
  const browser = await openBrowser("chromium");
  t.after(browser.close);
  const { told, troubles } = await browser.tell(url);
  assert.deepEqual(told, [expected, expected]);
  assert.deepEqual(troubles, []);
});
