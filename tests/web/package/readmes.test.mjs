/**
 * Tests the code and commands in the READMEs, apart from the package's program (readme.test.mjs).
 */
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import {
  chmodSync,
  copyFileSync,
  cpSync,
  existsSync,
  mkdirSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  rmSync,
  writeFileSync,
} from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { readSceneText } from "../../../web/tools/scene-texts.mjs";
import { root } from "../support/package.mjs";

const folder = mkdtempSync(join(tmpdir(), "thud-readmes-"));
after(() => rmSync(folder, { recursive: true }));
const read = (file) => readFileSync(`${root}${file}`, "utf8");
const blocksOf = (file, language) =>
  [...read(file).matchAll(new RegExp(`^\`\`\`${language}\\n(.*?)^\`\`\``, "gms"))].map(([, text]) => text);

/**
 * The number of code blocks in each file that are tested here, or elsewhere: C by examples/check.py,
 * CMake and the one file by tests/package, JSON by tests/scenes/test_jobs.py.
 */
const BLOCKS = {
  "README.md": { sh: 1, c: 1, cmake: 1, js: 1 },
  "docs/embedding.md": { cmake: 1, sh: 1, c: 2, json: 1 },
  "web/README.md": { js: 1, c: 1 },
  "web/package/README.md": { ts: 2 },
};

test("every_block_of_code_is_known", () => {
  for (const [file, known] of Object.entries(BLOCKS)) {
    const languages = [...read(file).matchAll(/^```(\w*)\n.*?^```/gms)].map(([, name]) => name);
    const counts = {};
    for (const name of languages.filter((one) => file !== "web/package/README.md" || one !== "js"))
      counts[name] = (counts[name] ?? 0) + 1;
    assert.deepEqual(counts, known, file);
  }
});

test("program_of_the_readme_prints_where_the_ball_rests", () => {
  const [program] = blocksOf("README.md", "js");
  const place = join(folder, "ball.mjs");
  writeFileSync(place, program.replace('"thud"', JSON.stringify(`${root}web/package/dist/node.js`)));
  const { status, stdout, stderr } = spawnSync(process.execPath, [place], { encoding: "utf8" });
  assert.equal(status, 0, stderr);
  assert.equal(stdout, "the ball rests at y = 0.50\n");
});

test("verbs_of_the_readme_are_those_of_run", () => {
  const help = execFileSync(`${root}run`, ["help"], { encoding: "utf8" });
  const verbs = ["README.md", "docs/embedding.md", "web/README.md", "web/package/README.md"].flatMap((file) =>
    [...read(file).matchAll(/\.\/run ([a-z]+)/g)].map(([, verb]) => verb),
  );
  assert.ok(verbs.includes("package") && verbs.includes("demo"));
  for (const verb of new Set(verbs)) assert.match(help, new RegExp(`^  ${verb}\\b`, "m"), verb);
});

test("readmes_say_that_the_package_is_not_published_and_how_it_is_packed", () => {
  const { version } = JSON.parse(read("web/package/package.json"));
  for (const file of ["README.md", "web/README.md", "web/package/README.md"]) {
    const text = read(file);
    assert.match(text, /not published/, file);
    assert.match(text, /run package/, file);
    assert.ok(text.includes(`build/thud-${version}.tgz`), file);
  }
});

test("lines_of_a_scene_in_the_readme_are_read_as_a_scenes", () => {
  const [text] = blocksOf("web/README.md", "js");
  const { title, place } = readSceneText("pit", text);
  assert.deepEqual([title, place], ["Circle pit", 310]);
});

test("definition_of_a_scene_in_the_readme_is_that_of_scenes_in_c", () => {
  const [line] = blocksOf("web/README.md", "c");
  const scenes = `${root}demo/scenes/`;
  const same = readdirSync(scenes)
    .filter((file) => file.endsWith(".c"))
    .filter((file) => {
      const named = line.trim().replaceAll("NAME", file.slice(0, -2)).replace(/\d+/, "N");
      return readFileSync(`${scenes}${file}`, "utf8").replace(/\.place = \d+/, ".place = N").includes(named);
    });
  assert.ok(same.length > 5, `${same}`);
});

test("engine_in_two_files_begins_as_the_readme_has_it", () => {
  const text = blocksOf("web/package/README.md", "ts").find((block) => block.includes("thud-first.wasm"));
  // A bundler replaces the import by an address; `location` stands for the page's.
  const bundled = text.replace(/^import (\w+) from "thud\/(.*)\?url";$/gm, 'const $1 = "$2";');
  assert.match(bundled, /^const first = .*\nconst rest = /);
  const dist = `${root}web/package/dist`;
  const program = `import { createServer } from "node:http";
import { readFileSync } from "node:fs";
import { load } from ${JSON.stringify(`${dist}/node.js`)};
const types = { "content-type": "application/wasm" };
const server = createServer(({ url }, answer) =>
  answer.writeHead(200, types).end(readFileSync(${JSON.stringify(dist)} + url)));
await new Promise((done) => server.listen(0, "127.0.0.1", done));
const location = { href: \`http://127.0.0.1:\${server.address().port}/\` };
${bundled}
const world = thud.createWorld();
world.step();
console.log(world.hash().length);
server.closeAllConnections();
server.close();
`;
  writeFileSync(join(folder, "two.mjs"), program);
  const { status, stdout, stderr } = spawnSync(process.execPath, ["two.mjs"], { cwd: folder, encoding: "utf8" });
  assert.equal(status, 0, stderr);
  assert.equal(stdout.trim(), "16");
});

/** The games' folder, and the package's folder without what is built, as in a clone. */
function makeClone() {
  const clone = join(folder, "clone");
  mkdirSync(join(clone, "web"), { recursive: true });
  cpSync(`${root}examples/games`, join(clone, "examples/games"), {
    recursive: true,
    filter: (path) => !path.includes("node_modules"),
  });
  mkdirSync(join(clone, "web/package"));
  copyFileSync(`${root}web/package/package.json`, join(clone, "web/package/package.json"));
  // The verb that builds the package takes minutes; its result is copied instead.
  const dist = join(clone, "web/package/dist");
  writeFileSync(join(clone, "run"), `#!/bin/sh\n[ "$*" = package ] && cp -r ${root}web/package/dist ${dist}\n`);
  chmodSync(join(clone, "run"), 0o755);
  return clone;
}

test("games_run_on_a_fresh_clone_as_the_document_says", () => {
  const clone = makeClone();
  const [, command] = /`(npm install && node run\.js \w+)`/.exec(read("docs/embedding.md"));
  const offline = command.replace("npm install", "npm install --offline --omit=optional --no-audit --no-fund");
  const { status, stdout, stderr } = spawnSync("sh", ["-c", offline], {
    cwd: join(clone, "examples/games"),
    encoding: "utf8",
  });
  assert.equal(status, 0, `${stdout}${stderr}`);
  assert.match(stdout, /\d+ steps, \w{16}\n$/);
  assert.ok(existsSync(join(clone, "web/package/dist/thud.wasm")));
});
