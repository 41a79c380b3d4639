/**
 * Tests the documentation site: its snippets in JavaScript, its links and anchors, and its sizes.
 * Those in C are compiled by tests/site, those in Python run by tests/python.
 */
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { gzipSync } from "node:zlib";
import { root } from "../support/package.mjs";
import { World } from "../../../web/package/dist/node.js";
import { sidebar } from "../../../web/site/.vitepress/sidebar.mjs";

/** Names of the class World that its typings do not offer. */
const INNER = new Set("constructor makeSolid freeRoom refuse on onWorld shapeIds".split(" "));

const sources = `${root}web/site/`;
const dist = `${root}web/dist/`;
const docs = `${dist}docs/`;
const pages = readdirSync(sources).filter((name) => name.endsWith(".md") && !name.includes("["));
const built = readdirSync(docs).filter((name) => name.endsWith(".html") && name !== "404.html");

const folder = mkdtempSync(join(tmpdir(), "thud-site-"));
after(() => rmSync(folder, { recursive: true }));
mkdirSync(join(folder, "node_modules"));
symlinkSync(`${root}web/package`, join(folder, "node_modules", "thud"), "dir");
mkdirSync(join(folder, "node_modules/@dimforge"));
for (const rival of ["planck", "matter-js", "chipmunk", "@dimforge/rapier2d-compat"])
  symlinkSync(`${root}web/node_modules/${rival}`, join(folder, "node_modules", rival), "dir");

/** The fenced blocks of a page: [{ info, text }]. */
function blocksOf(page) {
  const text = readFileSync(sources + page, "utf8");
  return [...text.matchAll(/^```([^\n]*)\n(.*?)^```$/gms)].map(([, info, block]) => ({ info, text: block }));
}

/** Runs a program, which must end well, and returns the lines that it prints. */
function run(name, program) {
  writeFileSync(join(folder, name), program);
  const { status, stdout, stderr } = spawnSync(process.execPath, [name], { cwd: folder, encoding: "utf8" });
  assert.equal(status, 0, `${name}: ${stderr}`);
  return stdout.trim().split("\n").filter(Boolean);
}

/** What the comments behind console.log say that it prints. */
function promisedBy(program) {
  return [...program.matchAll(/^ *console\.log\(.*\); \/\/ (.*)$/gm)].map(([, text]) => text);
}

/** A second of pictures, as the site makes them of an example that runs on its page. */
const PICTURES = `
if (typeof frame === "function") for (let i = 0; i < 60; i++) frame(1 / 60);
`;

/** What of a page a program for one uses: what it draws is counted, and `next` makes a picture. */
const BROWSER = `{
  let now = 0;
  const told = (globalThis.told = { drawn: 0, picture: null });
  globalThis.performance = { now: () => now };
  globalThis.requestAnimationFrame = (then) => (told.picture = then);
  told.next = (milliseconds) => told.picture((now += milliseconds));
  const pen = new Proxy({}, { get: (_, name) => () => (told.drawn += name === "arc") });
  const canvas = { width: 720, height: 480, style: {}, getContext: () => pen, addEventListener() {} };
  globalThis.document = { querySelector: () => canvas };
}
`;

for (const page of pages) {
  const together = blocksOf(page).filter(({ info }) => info === "js").map(({ text }) => text).join("\n");
  if (together)
    test(`snippets_of_${page.slice(0, -3)}_print_what_their_comments_say`, () =>
      assert.deepEqual(run(`${page}.mjs`, together), promisedBy(together)));
}

test("examples_that_run_on_the_page_run", () => {
  let count = 0;
  for (const page of pages)
    for (const { info, text } of blocksOf(page).filter(({ info: one }) => one.startsWith("js live"))) {
      assert.match(info, /^js live( view=-?[\d.]+,-?[\d.]+,[\d.]+)?( auto)?$/, page);
      const printed = run(`${page}-${++count}.mjs`, text + PICTURES);
      const promised = promisedBy(text);
      assert.deepEqual(printed.slice(0, promised.length), promised, page);
    }
  assert.ok(count > 0, "no page has an example");
});

test("cradle_of_the_guide_keeps_its_energy_to_one_percent_for_ten_seconds", () => {
  const [{ text }] = blocksOf("guide-joints.md").filter(({ text: one }) => one.includes("const balls ="));
  const energy = `
const energy = () => {
  const { kineticEnergy, potentialEnergy } = world.measure();
  return kineticEnergy + potentialEnergy - 50 * world.bodyStateOf(balls[0]).mass; // all balls at a height of 1
};
const before = energy();
for (let i = 0; i < 600; i++) world.step();
console.log(Math.abs(energy() / before - 1) < 0.01);
`;
  assert.deepEqual(run("cradle.mjs", text + energy), ["true"]);
});

/** The frequency (Hz) and damping ratio with which a constraint of matter.js swings. */
function swingOf(Matter, stiffness, damping) {
  const { Bodies, Composite, Constraint, Engine } = Matter;
  const engine = Engine.create();
  engine.gravity.y = 0;
  const body = Bodies.circle(300, 0, 10, { frictionAir: 0 });
  const constraint = Constraint.create({ pointA: { x: 0, y: 0 }, bodyB: body, length: 200, stiffness, damping });
  Composite.add(engine.world, [body, constraint]);
  const away = Array.from({ length: 600 }, () => (Engine.update(engine, 1000 / 60), body.position.x - 200));
  const peaks = away.filter((x, i) => i > 0 && x > away[i - 1] && x >= away[i + 1]);
  const zeros = away.flatMap((x, i) => (i > 0 && x <= 0 && away[i - 1] > 0 ? [i - x / (x - away[i - 1])] : []));
  const decrement = Math.log(peaks[0] / peaks[1]);
  const ratio = decrement / Math.hypot(2 * Math.PI, decrement);
  return [60 / (zeros[1] - zeros[0]) / Math.sqrt(1 - ratio ** 2), ratio];
}

test("springs_of_matter_swing_as_the_page_that_comes_from_there_says", async () => {
  const text = readFileSync(`${sources}from-matter.md`, "utf8");
  const [, rate] = /frequency = ([\d.]+) √stiffness Hz/.exec(text);
  const [, own, damper] = /damping = ([\d.]+) √stiffness \+ ([\d.]+) damping/.exec(text);
  const Matter = (await import(`${root}web/node_modules/matter-js/build/matter.js`)).default;
  for (const [stiffness, damping] of [[0.0005, 0], [0.001, 0.005], [0.02, 0.02], [0.1, 0]]) {
    const [frequency, ratio] = swingOf(Matter, stiffness, damping);
    const root = Math.sqrt(stiffness);
    assert.ok(Math.abs(frequency / (rate * root) - 1) < 0.06, `${stiffness}: ${frequency} Hz`);
    assert.ok(Math.abs(ratio / (own * root + (damper * damping) / root) - 1) < 0.06, `${stiffness}: ratio ${ratio}`);
  }
});

test("game_in_a_page_draws_every_ball_in_every_picture", () => {
  const [program] = blocksOf("begin-javascript.md").filter(({ info }) => info === "js game");
  const pictures = `
for (let i = 0; i < 30; i++) told.next(1000 / 144);
console.log(told.drawn);
`;
  assert.deepEqual(run("game.mjs", BROWSER + program.text + pictures), [String(30 * 40)]);
});

test("page_of_the_guide_to_drawing_paints_every_crate_in_every_picture", () => {
  const [program] = blocksOf("guide-drawing.md").filter(({ info }) => info === "js page");
  const pictures = `
for (let i = 0; i < 30; i++) told.next(1000 / 144);
console.log(told.drawn);
`;
  assert.deepEqual(run("page.mjs", BROWSER.replace('"arc"', '"fillRect"') + program.text + pictures), [String(30 * 10)]);
});

test("every_page_stands_in_the_list_of_pages", () => {
  const linksOf = ({ link, items = [] }) => [...(link ? [link] : []), ...items.flatMap(linksOf)];
  const listed = sidebar.flatMap(linksOf).map((link) => `${link.slice(1)}.html`);
  assert.deepEqual([...listed, "index.html"].sort(), [...built].sort());
});

test("links_of_the_site_lead_to_files_and_anchors", () => {
  const texts = new Map(built.map((name) => [name, readFileSync(docs + name, "utf8")]));
  const ids = new Map([...texts].map(([name, text]) => [name, new Set([...text.matchAll(/ id="([^"]+)"/g)].map(([, id]) => id))]));
  const broken = [];
  let count = 0;
  for (const [name, text] of texts)
    for (const [, address] of text.matchAll(/ (?:href|src)="([^"]*)"/g)) {
      if (/^(https?|mailto):/.test(address)) continue;
      count++;
      const [, scene] = /^\.\.\/\?scene=(\w+)/.exec(address) ?? [];
      if (scene && !existsSync(`${dist}scenes/${scene}.js`)) broken.push(`${name}: no scene ${scene}`);
      const [path, anchor] = address.split("#");
      const file = path === "" ? `docs/${name}` : new URL(path, "http://host/docs/").pathname.slice(1);
      const whole = file === "" || file.endsWith("/") ? `${file}index.html` : file;
      const there = existsSync(dist + whole);
      const inSite = whole.startsWith("docs/") ? ids.get(whole.slice(5)) : null;
      if (!there || (anchor && inSite && !inSite.has(decodeURIComponent(anchor)))) broken.push(`${name}: ${address}`);
    }
  assert.deepEqual(broken, []);
  assert.ok(count > 10 * built.length, "pages have links");
});

test("reference_has_every_name_of_the_headers_and_typings", () => {
  const api = JSON.parse(readFileSync(`${root}bindings/api.json`, "utf8"));
  for (const { name, header } of [...api.functions, ...api.structs, ...api.enums, ...api.callbacks]) {
    const text = readFileSync(`${docs}c-${header.replace(/\.h$/, "")}.html`, "utf8");
    assert.ok(text.includes(` id="${name}"`), name);
  }
  const world = readFileSync(`${docs}js-world.html`, "utf8");
  for (let type = World.prototype; type !== Object.prototype; type = Object.getPrototypeOf(type))
    for (const name of Object.getOwnPropertyNames(type))
      if (!INNER.has(name)) assert.ok(world.includes(` id="${name}"`), name);
  const errors = readFileSync(`${docs}errors.html`, "utf8");
  for (const { name } of api.enums.find(({ name: one }) => one === "thud_result").values) assert.ok(errors.includes(name), name);
});

test("reference_has_what_draws_worlds_with_its_constructor_and_options", () => {
  const canvas = readFileSync(`${docs}js-canvas.html`, "utf8").replace(/<[^>]*>/g, "");
  for (const said of ["constructor(world: World, canvas: HTMLCanvasElement", "placeOf(pointer", "yDown?: boolean", "get bodies()", "end(): void", "strength?: number"])
    assert.ok(canvas.includes(said), said);
  for (const [page, name] of [["pixi", "PixiView"], ["three", "ThreeView"], ["phaser", "PhaserView"], ["recording", "Player"]])
    assert.ok(readFileSync(`${docs}js-${page}.html`, "utf8").includes(` id="${name}"`), name);
});

test("files_for_download_have_every_function_and_the_version_of_the_package", () => {
  const { functions } = JSON.parse(readFileSync(`${root}bindings/api.json`, "utf8"));
  const [header, source] = ["thud.h", "thud.c"].map((name) => readFileSync(`${docs}files/${name}`, "utf8"));
  for (const { name, inline } of functions) {
    assert.ok(header.includes(`${name}(`), name);
    assert.ok(inline || source.includes(`${name}(`), name);
  }
  const { version } = JSON.parse(readFileSync(`${root}web/package/package.json`, "utf8"));
  const packed = readFileSync(`${docs}files/thud-${version}.tgz`);
  assert.ok(packed.length > 500_000 && packed[0] === 0x1f && packed[1] === 0x8b, "an archive of gzip");
});

/** Beginnings of names that pages use in place of one name, and names of files. */
const PARTS = /^thud_(default_|X_|threads|body_|shape_|joint_|world_)?$|\.h$/;

test("names_of_c_on_the_pages_are_those_of_the_headers", () => {
  const api = JSON.parse(readFileSync(`${root}bindings/api.json`, "utf8"));
  const known = new Set(api.headers.map(({ name }) => name));
  // Defines that leave parts of the one file out.
  for (const [, part] of readFileSync(`${root}tools/parts.py`, "utf8").matchAll(/^ {4}"(\w+)": Part/gm)) known.add(`THUD_NO_${part}`);
  for (const kind of ["constants", "enums", "aliases", "callbacks", "structs", "variables", "functions"])
    for (const { name, values = [] } of api[kind]) for (const one of [name, ...values.map((value) => value.name)]) known.add(one);
  const unknown = [];
  for (const page of pages.filter((name) => !/^(c|js|python|binding)-/.test(name)))
    for (const [name] of readFileSync(sources + page, "utf8").matchAll(/(?<![-\w])(?:thud|THUD)_\w+(?:\.h\b)?/g))
      if (!known.has(name) && !PARTS.test(name)) unknown.push(`${page}: ${name}`);
  assert.deepEqual(unknown, []);
});

test("page_of_scenes_and_every_page_of_the_site_link_to_each_other", () => {
  assert.match(readFileSync(`${dist}index.html`, "utf8"), /<a href="docs\/"/);
  for (const name of built) assert.match(readFileSync(docs + name, "utf8"), /href="\.\.\/" target="_self"/, name);
});

/** Kilobytes of 1000 bytes, gzipped: what a page of the site loads before anything is asked of it. Chosen. */
const BOUND = 130;

test(`no_page_loads_more_than_${BOUND}_kB_by_itself`, () => {
  for (const name of built) {
    const text = readFileSync(docs + name, "utf8");
    const files = new Set([...text.matchAll(/<(?:script|link)[^>]* (?:src|href)="\.\/([^"]+)"/g)].map(([, path]) => path));
    const sizes = [name, ...files].map((file) => gzipSync(readFileSync(docs + file), { level: 9 }).length);
    const sum = sizes.reduce((a, b) => a + b, 0);
    assert.ok(sum < BOUND * 1000, `${name}: ${sum} bytes`);
  }
});
