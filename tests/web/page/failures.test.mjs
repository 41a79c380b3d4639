/** Tests that failures show a clear message and a way to continue. */
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  DESKTOP,
  drawn,
  failureText,
  openLevel,
  openVisitor,
  stepBy,
  untilRunning,
} from "../support/page.mjs";
import { ballLevel } from "../support/package.mjs";
import { until } from "../support/wait.mjs";

const visitor = openVisitor();
const visitorWithWebgl = openVisitor({ webgl: true });

test("missing_wasm_file_is_said_and_loading_again_offered", async () => {
  const block = (page) =>
    page.route("**/*.wasm", (route) => route.fulfill({ status: 404, body: "not here" }));
  const { page, close } = await visitor.open("", DESKTOP, block);
  assert.match(await failureText(page), /engine cannot be loaded[\s\S]*404/);
  await page.unroute("**/*.wasm");
  await page.click("#failure button");
  await untilRunning(page);
  await close();
});

test("missing_webassembly_is_said", async () => {
  const remove = (page) => page.addInitScript(() => delete globalThis.WebAssembly);
  const { page, close } = await visitor.open("", DESKTOP, remove);
  assert.match(await failureText(page), /WebAssembly is missing/);
  await close();
});

test("browser_without_simd_is_told_and_runs_the_scalar_engine", async () => {
  const requests = [];
  const refuse = (page) => {
    page.on("request", (request) => requests.push(request.url()));
    return page.addInitScript(() => (WebAssembly.validate = () => false));
  };
  const { page, errors, close } = await visitor.open("?scene=cradle", DESKTOP, refuse);
  await page.waitForSelector('#notice:has-text("no WebAssembly SIMD")', { state: "attached" });
  await untilRunning(page);
  const engines = requests.flatMap((url) => /thud-(first|rest|scalar)/.exec(url)?.[1] ?? []);
  assert.deepEqual([...new Set(engines)], ["scalar"]);
  assert.deepEqual(errors, []);
  await close();
});

test("missing_second_file_of_the_engine_is_said_and_loading_again_offered", async () => {
  const block = (page) =>
    page.route("**/thud-rest*.wasm", (route) => route.fulfill({ status: 404, body: "not here" }));
  const { page, close } = await visitor.open("", DESKTOP, block);
  assert.match(await failureText(page), /part of the engine is missing/i);
  // The scene runs behind the message until it needs what is missing; it is not paused.
  await page.waitForSelector("#pause[aria-pressed=true]");
  assert.equal(await page.evaluate(() => location.search), "?scene=brick_wall");
  await page.unroute("**/thud-rest*.wasm");
  // Wait for a new page, not for a response to the old one.
  const loaded = page.waitForEvent("load");
  const rest = page.waitForResponse("**/thud-rest*.wasm");
  await page.click("#failure button");
  await loaded;
  assert.equal((await rest).status(), 200);
  await untilRunning(page);
  assert.ok(await page.isHidden("#failure"));
  await close();
});

test("unknown_scene_is_said_and_another_runs", async () => {
  const { page, errors, close } = await visitor.open("?scene=no-such");
  assert.match(await failureText(page), /no scene called “no-such”/);
  await page.click("#failure button");
  await untilRunning(page);
  assert.deepEqual(errors, []);
  await close();
});

test("level_that_is_no_json_is_refused_and_the_scene_goes_on", async () => {
  const { page, close } = await visitor.open("?scene=cradle");
  await untilRunning(page);
  await openLevel(page, "broken.tmj", "{");
  assert.match(await failureText(page), /not JSON/);
  const steps = () => page.evaluate(() => Number(document.querySelector("#hud").dataset.steps));
  const before = await steps();
  await page.click("#failure button");
  await until(steps, (now) => now > before, "it goes on");
  assert.match(await page.title(), /elastic balls/);
  await close();
});

test("level_with_a_polygon_runs_without_it_and_says_so", async () => {
  const { page, errors, close } = await visitor.open("?scene=cradle");
  await untilRunning(page);
  const polygon = { id: 9, x: 0, y: 0, polygon: [] };
  await openLevel(page, "some.tmj", ballLevel([polygon]));
  await page.waitForFunction(() => /object 9: a polygon/.test(document.querySelector("#notice").textContent));
  assert.deepEqual(errors, []);
  await close();
});

test("webgl2_draws_and_its_loss_leaves_canvas_2d", async () => {
  // A small viewport, because WebGL runs in software here.
  const options = { viewport: { width: 640, height: 480 } };
  const { page, errors, close } = await visitorWithWebgl.open("?scene=cradle&paused=1", options);
  await stepBy(page, 1);
  assert.equal(await page.getAttribute("#bodies", "data-renderer"), "webgl2");
  assert.deepEqual(errors, []);
  await page.evaluate(() => {
    const context = document.getElementById("bodies").getContext("webgl2");
    context.getExtension("WEBGL_lose_context").loseContext();
  });
  await page.waitForSelector('#bodies[data-renderer="canvas2d"]');
  await until(() => drawn(page), ({ count }) => count > 100, "Canvas 2D draws nothing");
  await close();
});
