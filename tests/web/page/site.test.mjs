/** Tests the documentation site in browsers: its examples, its search, its themes, and axe. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { BROWSERS, DESKTOP, openVisitor, PHONE, runAxe } from "../support/page.mjs";
import { until } from "../support/wait.mjs";

/** Opens a page of the site, and waits until its buttons listen. */
async function openSite(path, options = DESKTOP, prepare = null, browser = "chromium") {
  const opened = await openVisitor({ browser }).open(`docs/${path}`, options, prepare);
  await opened.page.waitForFunction(() => document.querySelector("#app")?.__vue_app__);
  return opened;
}

/** Waits until an example has drawn bodies. */
function untilDrawn(example) {
  const opaque = () =>
    example.locator("canvas").evaluate((canvas) => {
      const { width, height } = canvas;
      // Reads a copy, because the browser may keep the copy in memory where reading is fast.
      const copy = Object.assign(document.createElement("canvas"), { width, height });
      const context = copy.getContext("2d", { willReadFrequently: true });
      context.drawImage(canvas, 0, 0);
      const { data } = context.getImageData(0, 0, width, height);
      return data.filter((value, i) => i % 4 === 3 && value > 200).length;
    });
  return until(opaque, (count) => count > 1000, "bodies are drawn");
}

/** Puts a text in place of the code in an example's editor, and runs it. */
async function runOwn(page, example, code) {
  await example.locator(".cm-content").click();
  await page.keyboard.press("Control+a");
  await page.keyboard.insertText(code);
  await page.keyboard.press("Control+Enter");
}

for (const browser of BROWSERS)
  test(`example_runs_is_changed_and_told_of_its_error_in_${browser}`, async () => {
    const { page, errors, close } = await openSite("begin-javascript.html", DESKTOP, null, browser);
    const example = page.locator(".live").first();
    await example.getByRole("button", { name: "Run" }).first().click();
    await untilDrawn(example);
    await example.getByRole("button", { name: "Change the code" }).click();
    await runOwn(page, example, 'console.log("changed"); world.step()');
    await example.locator(".live-lines:has-text('changed')").waitFor();
    await example.locator(".live-trouble:has-text('world is not defined')").waitFor();
    assert.deepEqual(errors, []);
    await close();
  });

for (const name of ["chipmunk", "matter", "planck", "rapier"])
  test(`program_of_${name}_runs_beside_that_of_thud`, async () => {
    const { page, errors, close } = await openSite(`from-${name}.html`);
    for (const i of [0, 1]) {
      const example = page.locator(".live").nth(i);
      await example.getByRole("button", { name: "Run" }).first().click();
      await untilDrawn(example);
    }
    assert.deepEqual(errors, []);
    await close();
  });

test("example_whose_engine_is_long_on_its_way_says_so_and_runs", async () => {
  const slow = (page) =>
    page.route("**/*.wasm", async (route) => {
      // Longer than an example may go without an answer.
      await new Promise((done) => setTimeout(done, 7000));
      await route.continue();
    });
  const { page, errors, close } = await openSite("begin-javascript.html", DESKTOP, slow);
  const example = page.locator(".live").first();
  await example.getByRole("button", { name: "Run" }).first().click();
  await example.locator(".live-loading").waitFor();
  await untilDrawn(example);
  assert.equal(await example.locator(".live-loading, .live-trouble").count(), 0);
  assert.deepEqual(errors, []);
  await close();
});

test("example_without_an_end_is_ended_and_its_code_can_be_changed", async () => {
  const { page, errors, close } = await openSite("begin-javascript.html");
  const example = page.locator(".live").first();
  await example.getByRole("button", { name: "Change the code" }).click();
  await runOwn(page, example, "for (;;);");
  await example.locator(".live-trouble:has-text('does not answer')").waitFor();
  await runOwn(page, example, 'console.log("again")');
  await example.locator(".live-lines:has-text('again')").waitFor();
  assert.deepEqual(errors, []);
  await close();
});

test("search_finds_a_word_and_its_page_is_opened_from_the_one_before", async () => {
  const { page, errors, close } = await openSite("begin-c.html");
  await page.locator(".DocSearch-Button").click();
  await page.fill("#localsearch-input", "Batch");
  await page.locator(".result:has-text('Begin in Python')").first().click();
  await page.waitForURL(/\/docs\/begin-python\.html/);
  await page.getByRole("link", { name: "Play" }).first().click();
  await page.waitForSelector("#rail a");
  await page.click("#rail a");
  await page.waitForURL(/\/docs\/$/);
  await page.locator(".home h1").waitFor();
  assert.deepEqual(errors, []);
  await close();
});

for (const [name, colorScheme, size] of [
  ["", "light", DESKTOP],
  ["guide-quality.html", "dark", PHONE],
  ["how-collisions.html", "light", PHONE],
  ["c-thud_joint.html", "dark", DESKTOP],
  ["js-types.html", "light", DESKTOP],
])
  test(`axe_finds_nothing_serious_in_docs_${name || "index"}`, async () => {
    const options = { ...size, colorScheme, reducedMotion: "reduce" };
    const { page, errors, close } = await openSite(name, options);
    await page.waitForSelector(colorScheme === "dark" ? "html.dark .VPContent" : "html:not(.dark) .VPContent");
    assert.deepEqual(await runAxe(page), []);
    const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    assert.equal(wide, 0, "the page scrolls sideways");
    assert.deepEqual(errors, []);
    await close();
  });
