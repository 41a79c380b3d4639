/**
 * Support for the tests of the page: a browser with the served page, and what visitors do and see.
 */
import assert from "node:assert/strict";
import { after, afterEach, beforeEach } from "node:test";
import { DESKTOP, launch, servePage } from "../../../web/tools/browser.mjs";
import { contextsOf } from "./contexts.mjs";
import { answerLate } from "./late.mjs";
import { axeSource } from "./package.mjs";

export { BROWSERS, DESKTOP, PHONE, stepBy } from "../../../web/tools/browser.mjs";

/**
 * The timeout of waits, milliseconds. A wait ends as soon as its condition holds; a slow machine
 * needs long to compile the engine, fetch a panel or draw. Chosen.
 */
export const PATIENCE = 120_000;

/**
 * Why a test is left out in a browser, or false: a test of what the page's own code decides runs in
 * Chromium, and in Firefox, too, if THUD_FULL is 1 (./run test --full).
 */
export function leftOut(browser) {
  if (browser === "chromium" || process.env.THUD_FULL === "1") return false;
  return "in the second browser only with ./run test --full";
}

/** What all test files of this process share: launched browsers by their kind, and the server. */
const launched = new Map();
let served = null;

/**
 * Milliseconds after which a test is ended, by closing the browsers: what waits for their answer then
 * fails, and the next tests launch them anew. Many calls have no timeout of their own, and a browser
 * that never answers would hold up all tests. A test waits at most 300 s on purpose
 * (browsers.test.mjs). And the time for the browsers to close, after which the process ends. Chosen.
 */
const HANGS = 480_000;
const CLOSES = 30_000;
let hangs;

beforeEach(({ name }) => {
  clearTimeout(hangs);
  hangs = setTimeout(() => {
    console.error(`${name} does not end: the browsers are closed`);
    for (const browser of launched.values()) browser.then((open) => open.close()).catch(() => {});
    hangs = setTimeout(() => {
      console.error(`${name} does not end without browsers either: its process ends`);
      process.exit(1);
    }, CLOSES);
  }, HANGS);
  hangs.unref();
});

/** Functions that close the pages which tests have opened and not closed yet. */
const left = new Set();

// A test that fails before it closes its page would leave it running beside the tests after it.
afterEach(() => Promise.all([...left].map((close) => close())));

after(async () => {
  clearTimeout(hangs);
  for (const browser of launched.values()) await (await browser).close();
  await (await served)?.close();
});

/**
 * The browser of that name, with or without WebGL. It is launched when it is first asked for, and
 * once more if it has ended since.
 */
export async function browserOf(name, { webgl = false } = {}) {
  const key = `${name} ${webgl}`;
  if (launched.has(key) && !(await launched.get(key)).isConnected()) launched.delete(key);
  if (!launched.has(key)) {
    const browser = launch(name, { webgl, oneProcess: true });
    launched.set(key, browser);
    browser.catch(() => launched.delete(key));
  }
  return launched.get(key);
}

/** Contexts of each browser that was launched. */
const contexts = new WeakMap();

/**
 * A visitor, whose `open` opens the served page in a browser that all visitors of this process
 * share; every opened page collects its errors. A page with `prepare` has its own context, and so
 * has every page in Firefox, where sharing saves no time.
 */
export function openVisitor({ webgl = false, browser: name = "chromium" } = {}) {
  return {
    async open(search = "", options = DESKTOP, prepare = null) {
      const server = await (served ??= servePage("/", answerLate));
      const browser = await browserOf(name, { webgl });
      if (!contexts.has(browser)) contexts.set(browser, contextsOf(browser, server.url, PATIENCE));
      const kind = prepare || name === "firefox" ? "own" : "shared";
      const { context, giveBack } = await contexts.get(browser)[kind](options);
      const close = () => (left.delete(close) ? giveBack() : undefined);
      left.add(close);
      const page = await context.newPage();
      const errors = [];
      page.on("pageerror", (error) => errors.push(error.message));
      page.on("console", (message) => {
        if (["error", "warning"].includes(message.type())) errors.push(message.text());
      });
      page.on("request", (request) => {
        if (!request.url().startsWith(server.url) && !/^(data|blob):/.test(request.url()))
          errors.push(`request to ${request.url()}`);
      });
      await prepare?.(page);
      await page.goto(server.url + search);
      return { page, errors, close };
    },
  };
}

// Waits until the scene has made a step.
export async function untilRunning(page) {
  // A page that is being reloaded has no figures for a moment.
  await page.waitForFunction(() => Number(document.querySelector("#hud")?.dataset.steps) > 0);
}

/**
 * Milliseconds after which the page reports a worker that does not answer (web/src/page/client.ts),
 * and the shorter time in these tests.
 */
const STUCK = 8000;
const STUCK_HERE = 800;

/** Runs `act` with the shorter time: the page reports a stuck worker ten times sooner. */
export async function impatiently(page, act) {
  await page.evaluate(
    ([usual, here]) => {
      window.patientTimeout = window.setTimeout;
      window.setTimeout = (then, after) => window.patientTimeout(then, after === usual ? here : after);
    },
    [STUCK, STUCK_HERE],
  );
  await act();
  await page.evaluate(() => (window.setTimeout = window.patientTimeout));
}

/** Opens a level from a file, as a visitor does, and waits until it is loaded. */
export async function openLevel(page, name, text) {
  await page.waitForSelector("[data-entry]", { state: "attached" });
  const buffer = Buffer.from(text);
  await page.setInputFiles("#level-file", { name, mimeType: "application/json", buffer });
}

/** The mean place and the number of the canvas's pixels whose alpha is at least `least`. */
export function drawn(page, id = "bodies", least = 128) {
  return page.evaluate(([canvasId, leastAlpha]) => {
    const canvas = document.getElementById(canvasId);
    const { width, height } = canvas;
    // Reads a copy, because the browser may keep the copy in memory where reading is fast.
    const copy = Object.assign(document.createElement("canvas"), { width, height });
    const context = copy.getContext("2d", { willReadFrequently: true });
    context.drawImage(canvas, 0, 0);
    const { data } = context.getImageData(0, 0, width, height);
    let [count, x, y] = [0, 0, 0];
    for (let i = 3; i < data.length; i += 4) {
      if (data[i] < leastAlpha) continue;
      count++;
      x += ((i - 3) / 4) % width;
      y += Math.floor((i - 3) / 4 / width);
    }
    const ratio = width / innerWidth;
    return { count, x: x / count / ratio, y: y / count / ratio };
  }, [id, least]);
}

/**
 * Chooses a radio button by its label, which covers it, as a visitor does. The press waits until
 * the label stands still, because panels move and grow.
 */
export function choose(page, name, value) {
  return page.check(`label:has(> [name="${name}"][value="${value}"])`);
}

// Whether the toggle button is pressed.
export async function pressed(page, id) {
  return (await page.getAttribute(`#${id}`, "aria-pressed")) === "true";
}

// A number in the page's figures, by its name.
export async function figure(page, name) {
  return Number((await page.textContent(`[data-value="${name}"]`)).replace(/,/g, ""));
}

/** Waits until the text is announced to screen readers. */
export function untilTold(page, text) {
  return page.waitForSelector(`#status:has-text("${text}")`, { state: "attached" });
}

/** Waits until the figures show so many bodies. */
export function untilBodies(page, count) {
  return page.waitForSelector(`[data-value=bodies]:text-is("${count}")`, { state: "attached" });
}

export async function failureText(page) {
  await page.waitForSelector("#failure:not([hidden])");
  return page.innerText("#failure");
}

export function near(actual, expected, tolerance, what) {
  assert.ok(Math.abs(actual - expected) <= tolerance, `${what}: ${actual}, not ${expected}`);
}

/**
 * Serious violations that axe finds in the page or a part of it. The driver evaluates axe, so the
 * page's policy need not allow it.
 */
export async function runAxe(page, within = "html", rules = null) {
  if (!(await page.evaluate(() => "axe" in window))) await page.evaluate(axeSource());
  return page.evaluate(async ([part, only]) => {
    // Elements that fade in do not have their final contrast yet.
    for (const animation of document.getAnimations())
      if (animation.effect.getComputedTiming().endTime < Infinity) animation.finish();
    const { violations } = await window.axe.run(part, {
      resultTypes: ["violations"],
      ...(only && { runOnly: { type: "rule", values: only } }),
    });
    return violations
      .filter(({ impact }) => impact === "serious" || impact === "critical")
      .map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html.slice(0, 120)).join(" | ")}`);
  }, [within, rules]);
}

/** The rules on colours among those that axe runs. */
const COLOUR_RULES = ["color-contrast", "link-in-text-block"];

/**
 * Runs all rules of axe in the light theme, and those on colours in the dark one: the themes differ
 * in nothing but the values of colours.
 */
export async function runAxeInBothThemes(page, within) {
  const found = [];
  for (const colorScheme of ["light", "dark"]) {
    await page.emulateMedia({ colorScheme });
    await page.waitForSelector(`html[data-theme=${colorScheme}]`);
    const rules = colorScheme === "dark" ? COLOUR_RULES : null;
    const violations = await runAxe(page, within, rules);
    found.push(...violations.map((text) => `${colorScheme}: ${text}`));
  }
  return found;
}

/** The rows below a control of the panel, by their names. */
export function rowsOf(page, name) {
  return page.evaluate((control) => {
    const list = document.querySelector(`[data-readings="${control}"]`);
    const texts = (tag) => [...(list?.querySelectorAll(tag) ?? [])].map((one) => one.textContent);
    const values = texts("dd");
    return Object.fromEntries(texts("dt").map((term, i) => [term, values[i]]));
  }, name);
}
