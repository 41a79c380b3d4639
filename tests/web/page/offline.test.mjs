/**
 * Tests that the page works without a network after one visit, and that a new build replaces the
 * old one when the visitor agrees.
 */
import assert from "node:assert/strict";
import { readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { writeServiceWorker } from "../../../web/tools/offline-plugin.mjs";
import { createStaticServer } from "../../../web/tools/static-server.mjs";
import { copyOfPage, createPlainServer, serve, untilOffline } from "../support/built-page.mjs";
import { drawLightly } from "../support/contexts.mjs";
import { browserOf, PATIENCE, untilRunning } from "../support/page.mjs";
import { untilMeasured } from "../support/versus.mjs";
import { until } from "../support/wait.mjs";

/** A paused scene: Chromium looks for a newer build only while the page is idle. */
const STANDING = "?scene=cradle&paused=1";

/** A page in a new browser context, which has no data of earlier visits. */
async function newVisitor(t) {
  const context = await (await browserOf("chromium")).newContext();
  t.after(() => context.close());
  context.setDefaultTimeout(PATIENCE);
  await drawLightly(context);
  return context.newPage();
}

/** A page that was visited once and whose server is then closed. */
async function visitedOnce(t) {
  const { url, cut } = await serve(t, createStaticServer(copyOfPage(t)));
  const page = await newVisitor(t);
  await page.goto(url);
  await untilOffline(page);
  await cut();
  return { page, url };
}

test("page_without_network_after_one_visit_runs_other_scenes_and_levels_opens_panels_and_records", async (t) => {
  const { page, url } = await visitedOnce(t);
  for (const search of ["", "?scene=tumbler", "?level=towers"]) {
    await page.goto(url + search);
    await untilRunning(page);
  }
  assert.match(await page.title(), /Towers/i);
  for (const [key, name] of [["k", "code"], ["i", "inside"], ["t", "trade"], ["o", "options"]]) {
    await page.keyboard.press(key);
    await page.waitForSelector(`#dock[data-panel=${name}] #dock-body > :not(.quiet)`);
  }
  await page.click("#record");
  await until(() => page.textContent("#notice"), (text) => /^Recorded/.test(text), "it records");
});

test("page_of_the_site_that_was_visited_is_there_without_network_and_can_be_searched", async (t) => {
  const { url, cut } = await serve(t, createStaticServer(copyOfPage(t)));
  const page = await newVisitor(t);
  await page.goto(url + STANDING);
  await untilOffline(page);
  const search = async () => {
    await page.goto(`${url}docs/begin-c.html`);
    // The page shows its button before its script listens to it.
    const input = page.locator("#localsearch-input");
    const open = async () => {
      const button = page.locator(".DocSearch-Button");
      // The box may open meanwhile, and then lies over the button.
      if (!(await input.isVisible())) await button.click({ timeout: 1000 }).catch(() => {});
      return input.isVisible();
    };
    await until(open, Boolean, "the search is open");
    await page.fill("#localsearch-input", "Batch");
    await page.locator(".result:has-text('Begin in Python')").first().waitFor();
  };
  await search();
  await cut();
  await search();
});

test("page_kept_offline_is_isolated_even_from_a_plain_host", async (t) => {
  const { url } = await serve(t, createPlainServer(copyOfPage(t)));
  const page = await newVisitor(t);
  await page.goto(url);
  assert.equal(await page.evaluate(() => crossOriginIsolated), false);
  await untilOffline(page);
  await page.reload();
  assert.equal(await page.evaluate(() => crossOriginIsolated), true);
  await untilRunning(page);
});

test("page_without_network_after_one_visit_runs_box2d_beside_thud", async (t) => {
  const { page, url } = await visitedOnce(t);
  await page.goto(`${url}?scene=cradle&panel=versus`);
  await untilMeasured(page);
});

test("browser_with_simd_keeps_that_flavour_of_both_engines_alone", async (t) => {
  const { url } = await serve(t, createStaticServer(copyOfPage(t)));
  const page = await newVisitor(t);
  await page.goto(url);
  await untilOffline(page);
  const kept = await page.evaluate(async () => {
    const cache = await caches.open((await caches.keys())[0]);
    return (await cache.keys()).map((request) => request.url);
  });
  const engines = kept.flatMap((address) => /[^/]+(?=-[\w-]{8}\.wasm$)/.exec(address) ?? []);
  assert.deepEqual(engines.sort(), ["Box2D.deluxe", "thud-first", "thud-recorded", "thud-rest"], kept.join("\n"));
});

test("new_build_waits_for_the_visitor_and_then_replaces_the_old_one", async (t) => {
  const folder = copyOfPage(t);
  const { url } = await serve(t, createStaticServer(folder));
  const page = await newVisitor(t);
  await page.goto(url + STANDING);
  await untilOffline(page);
  const former = await page.evaluate(() => caches.keys());

  const index = join(folder, "index.html");
  writeFileSync(index, readFileSync(index, "utf8").replace("<html", '<html data-build="2"'));
  await writeServiceWorker(folder);
  await page.goto(url + STANDING);
  const reload = page.getByRole("button", { name: /reload/i });
  await reload.waitFor();
  assert.equal(await page.getAttribute("html", "data-build"), null, "a running page is left alone");
  await reload.click();
  await page.waitForSelector('html[data-build="2"]');
  const keys = () => page.evaluate(() => caches.keys());
  const present = await until(keys, ({ length }) => length === 1, "the old build's files are there");
  assert.notDeepEqual(present, former);
});

/** The policy of an earlier release, under which no worker can import modules in Firefox. */
const FORMER_POLICY =
  "default-src 'none'; script-src 'self' blob: 'unsafe-eval'; connect-src 'self'; worker-src 'none'";

test("policy_of_a_new_build_replaces_the_former_one_in_firefox", async (t) => {
  const folder = copyOfPage(t);
  await writeServiceWorker(folder, FORMER_POLICY);
  // The plain server sends no policy; only the service worker does.
  const { url } = await serve(t, createPlainServer(folder));
  const page = await (await browserOf("firefox")).newPage();
  t.after(() => page.close());
  page.setDefaultTimeout(PATIENCE);
  await page.goto(url + STANDING);
  await untilOffline(page);
  await page.goto(`${url}?scene=platformer_game`);
  await page.waitForSelector("#failure:not([hidden])");

  await writeServiceWorker(folder);
  await page.goto(url + STANDING);
  const again = page.waitForEvent("load");
  await page.getByRole("button", { name: /reload/i }).click();
  await again; // another page.goto would interrupt the reload
  await page.waitForFunction(() => caches.keys().then(({ length }) => length === 1));
  await page.goto(`${url}?scene=platformer_game`);
  await untilRunning(page);
  assert.ok(await page.isHidden("#failure"));
});

test("build_with_a_missing_file_is_not_kept_and_the_page_runs", async (t) => {
  const folder = copyOfPage(t);
  rmSync(join(folder, "icon.svg"));
  const { url } = await serve(t, createStaticServer(folder));
  const page = await newVisitor(t);
  await page.addInitScript(() => {
    const register = navigator.serviceWorker.register.bind(navigator.serviceWorker);
    navigator.serviceWorker.register = async (...args) => {
      window.registration = await register(...args);
      return window.registration;
    };
  });
  await page.goto(url);
  await page.waitForFunction(() => {
    const { installing, waiting, active } = window.registration ?? { installing: true };
    return !installing && !waiting && !active;
  });
  assert.equal(await page.evaluate(() => navigator.serviceWorker.controller), null);
  await untilRunning(page);
});

test("page_without_service_workers_runs_without_errors", async (t) => {
  const { url } = await serve(t, createStaticServer(copyOfPage(t)));
  const page = await newVisitor(t);
  const errors = [];
  page.on("pageerror", (error) => errors.push(error.message));
  await page.addInitScript(() => delete Navigator.prototype.serviceWorker);
  await page.goto(url);
  await untilRunning(page);
  assert.deepEqual(errors, []);
});
