/** Tests that a first visit loads less than a bound before it shows a running scene. */
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { gzipSync } from "node:zlib";
import { createStaticServer } from "../../../web/tools/static-server.mjs";
import { copyOfPage, serve } from "../support/built-page.mjs";
import { browserOf, PATIENCE, untilRunning } from "../support/page.mjs";
import { until } from "../support/wait.mjs";

/** Kilobytes of 1000 bytes, gzipped, without Box2D. Chosen. */
const BOUND = 150;

test(`first_picture_loads_less_than_${BOUND}_kB`, async (t) => {
  const folder = copyOfPage(t);
  const { url } = await serve(t, createStaticServer(folder));
  const context = await (await browserOf("chromium")).newContext();
  t.after(async () => {
    // The page may ask for the rest once more while it is closed.
    await context.unrouteAll({ behavior: "ignoreErrors" });
    await context.close();
  });
  context.setDefaultTimeout(PATIENCE);
  // Files that the service worker caches for later visits are fetched after the first picture and
  // do not count.
  await context.addInitScript(() => delete Navigator.prototype.serviceWorker);
  const page = await context.newPage();
  // Nor does the rest of the engine count. Its requests get no answer here: the first picture must
  // not need it.
  const held = new Set();
  const pictures = () => performance.getEntriesByName("first picture").length;
  const picturesBefore = [];
  await context.route("**/thud-rest-*.wasm", async (route) => {
    held.add(route.request().url());
    picturesBefore.push(await page.evaluate(pictures));
  });
  const requests = new Set();
  context.on("request", (request) => requests.add(request.url()));
  await page.goto(url);
  await untilRunning(page);
  assert.equal(await page.evaluate(pictures), 1);
  await until(() => picturesBefore, ({ length }) => length > 0, "the rest is asked for");
  // A browser that gets no answer may ask once more.
  assert.ok(picturesBefore.every((count) => count === 1), "and not before the first picture");
  const paths = [...requests].filter((one) => !held.has(one)).map((one) => new URL(one).pathname);
  const sizeOf = (file) => gzipSync(readFileSync(join(folder, file)), { level: 9 }).length;
  const sizes = paths.map((path) => {
    const file = path === "/" ? "/index.html" : path;
    return { file, size: sizeOf(file) };
  });
  sizes.sort((a, b) => b.size - a.size);
  const sum = sizes.reduce((total, { size }) => total + size, 0);
  const row = (name, bytes) => `${(bytes / 1000).toFixed(1).padStart(7)} kB  ${name}`;
  const table = [...sizes.map(({ file, size }) => row(file, size)), row("in all", sum)].join("\n");
  console.log(`first load, gzipped:\n${table}`);
  // This browser draws by one of two renderers; another browser loads the other one in its place.
  const chunks = readdirSync(join(folder, "assets")).filter((name) => /^(webgl|canvas2d)-.*\.js$/.test(name));
  assert.equal(chunks.length, 2);
  const own = chunks.filter((name) => paths.includes(`/assets/${name}`));
  assert.equal(own.length, 1, "one renderer is loaded");
  const [other] = chunks.filter((name) => !own.includes(name));
  // What only Canvas 2D needs besides.
  const paths2d = paths.filter((path) => /^\/assets\/paths-/.test(path) && own[0].startsWith("canvas2d"));
  const without = [`/assets/${own[0]}`, ...paths2d].reduce((all, file) => all + sizeOf(file), 0);
  const swapped = sum - without + sizeOf(`/assets/${other}`);
  console.log(`with ${other} in place of ${own[0]}: ${(swapped / 1000).toFixed(1)} kB`);
  assert.ok(swapped < BOUND * 1000, `${swapped} bytes with ${other}`);
  for (const part of ["thud-first", "worker", "index"])
    assert.ok(sizes.some(({ file }) => file.includes(part)), `${part} is among it`);
  assert.ok(sum < BOUND * 1000, table);
});
