/**
 * Tests the adapters of the package in the pages of examples/adapters, and the games of examples/games on
 * a plain canvas, bundled by Vite: what is drawn is at the
 * poses of the bodies, at a display's rate that is not the world's, and a pointer drags a body.
 */
import assert from "node:assert/strict";
import { cpSync, mkdirSync, mkdtempSync, readFileSync, rmSync, symlinkSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { launch } from "../../../web/tools/browser.mjs";
import { bring, bundlers, host } from "../support/packed.mjs";
import { near, PATIENCE } from "../support/page.mjs";
import { root } from "../support/package.mjs";

/** Pages of examples/adapters, and the libraries that they import. */
const PAGES = { canvas: [], pixi: ["pixi.js"], three: ["three"], phaser: ["phaser"] };

/** A folder that screenshots are written to, if any. */
const SHOTS = process.env.THUD_SCREENSHOTS;

const folder = mkdtempSync(join(tmpdir(), "thud-adapters-"));
after(() => rmSync(folder, { recursive: true }));
const out = join(folder, "out");
const [major, minor] = process.versions.node.split(".").map(Number);
const skip = (major < 20 || (major === 20 && minor < 19)) && "Vite 8 needs Node.js 20.19";

let browser;
let server;
before(async () => {
  if (skip) return;
  cpSync(`${root}examples/adapters`, folder, { recursive: true, filter: (path) => !path.includes("node_modules") });
  cpSync(`${root}examples/games`, join(folder, "games"), { recursive: true, filter: (path) => !path.includes("node_modules") });
  mkdirSync(join(folder, "node_modules"));
  symlinkSync(`${root}web/package`, join(folder, "node_modules/thud"), "dir");
  for (const name of new Set(Object.values(PAGES).flat()))
    symlinkSync(`${bundlers}node_modules/${name}`, join(folder, "node_modules", name), "dir");
  const { build } = await bring("vite");
  const input = [...Object.keys(PAGES), "games/index"].map((name) => join(folder, `${name}.html`));
  await build({
    root: folder,
    configFile: false,
    logLevel: "error",
    base: "./",
    build: { outDir: out, target: "es2022", minify: false, chunkSizeWarningLimit: 1e6, rollupOptions: { input } },
  });
  browser = await launch("chromium", { webgl: true });
  server = await host(out, "");
});
after(async () => {
  await browser?.close();
  await server?.close();
});

/** Makes pictures at 144 Hz; returns the mean place of red pixels, and where the ball is, in pixels; and how many are green. */
function pictures(page, count) {
  return page.evaluate(async (many) => {
    const { world, ball, canvas, picture } = globalThis.example;
    let alpha = 0;
    for (let i = 0; i < many; i++) alpha = picture(1 / 144);
    const { width, height } = canvas;
    const context = Object.assign(document.createElement("canvas"), { width, height }).getContext("2d");
    context.drawImage(canvas, 0, 0); // before the browser takes the picture, which may clear it
    const { data } = context.getImageData(0, 0, width, height);
    let [red, green, x, y] = [0, 0, 0, 0];
    for (let at = 0; at < data.length; at += 4)
      if (data[at + 1] > Math.max(data[at], data[at + 2]) + 20) green++;
      else if (data[at] > 200 && data[at + 1] < 50 && data[at + 2] < 50) {
        red++;
        x += (at / 4) % width;
        y += Math.floor(at / 4 / width);
      }
    const [ballX, ballY] = world.poses(alpha).subarray(4 * ball.index);
    const [drawnX, drawnY] = [x / red + 0.5, y / red + 0.5];
    return { red, green, drawn: [drawnX, drawnY], place: [width / 2 + 40 * ballX, height / 2 - 40 * ballY], alpha };
  }, count);
}

function assertDrawn({ red, drawn, place, alpha }) {
  assert.ok(red > 500, `${red} red pixels`);
  near(drawn[0], place[0], 1, `x, alpha ${alpha}`);
  near(drawn[1], place[1], 1, `y, alpha ${alpha}`);
}

for (const name of Object.keys(PAGES))
  test(`page_with_${name}_draws_bodies_where_they_are_and_lets_them_be_dragged`, { skip }, async () => {
    const page = await browser.newPage({ viewport: { width: 640, height: 480 } });
    page.setDefaultTimeout(PATIENCE);
    const errors = [];
    page.on("pageerror", (error) => errors.push(error.message));
    page.on("console", (message) => {
      if (message.type() === "error") errors.push(message.text());
    });
    await page.goto(`${server.url}${name}.html`);
    await page.waitForFunction(() => globalThis.example?.world.stats().steps > 0);
    await page.evaluate(() => (globalThis.example.running = false));

    // Pictures between two steps, of a ball that moves.
    const first = await pictures(page, 1);
    const second = await pictures(page, 1);
    assertDrawn(first);
    assertDrawn(second);
    assert.notEqual(first.alpha, second.alpha);
    assert.notDeepEqual(first.place, second.place);

    await page.mouse.move(...second.place);
    await page.mouse.down();
    await page.mouse.move(480, 100);
    const held = await pictures(page, 288);
    near(held.place[0], 480, 8, "x of a held ball");
    near(held.place[1], 100, 8, "y of a held ball");
    assertDrawn(held);
    if (SHOTS) await page.screenshot({ path: join(SHOTS, `${name}.png`) });
    await page.mouse.up();
    const fallen = await pictures(page, 288);
    assert.ok(fallen.place[1] > 300, `${fallen.place}`);
    assertDrawn(fallen);

    // The engine's debug drawing has the outlines of moving bodies in green.
    assert.equal(fallen.green, 0);
    await page.evaluate(() => history.replaceState(null, "", "?debug"));
    const { green } = await pictures(page, 1);
    if (SHOTS) await page.screenshot({ path: join(SHOTS, `${name}-debug.png`) });
    assert.ok(green > 100, `${green} green pixels`);
    assert.deepEqual(errors, []);
    await page.close();
  });

test("games_are_played_on_a_plain_canvas_of_one_s_own", { skip }, async () => {
  const page = await browser.newPage({ viewport: { width: 640, height: 480 } });
  page.setDefaultTimeout(PATIENCE);
  const errors = [];
  page.on("pageerror", (error) => errors.push(error.message));
  for (const name of ["pool", "platformer", "brick_breaker"]) {
    await page.goto(`${server.url}games/index.html?${name}`);
    await page.waitForFunction(() => globalThis.game?.world.stats().steps > 0);
    if (SHOTS) await page.screenshot({ path: join(SHOTS, `game-${name}.png`) });
  }
  await page.keyboard.down("Space");
  await page.waitForFunction(() => globalThis.game.state.left < 40);
  assert.match(await page.textContent("p"), /^Bricks 3\d · Balls 3/);
  await page.mouse.move(400, 300);
  await page.waitForFunction(() => globalThis.game.world.positionOf(globalThis.game.state.paddle)[0] > 3);
  assert.deepEqual(errors, []);
  await page.close();
});
