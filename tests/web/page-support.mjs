/** A visitor's browser for the tests of the page. */
import assert from "node:assert/strict";
import { launchChromium, servePage } from "../../web/tools/browser.mjs";
import { axeSource } from "./support.mjs";

export const DESKTOP = { viewport: { width: 1440, height: 900 } };
export const PHONE = {
  viewport: { width: 390, height: 844 },
  deviceScaleFactor: 2,
  hasTouch: true,
  isMobile: true,
};

/** A browser and the served page; every page that is opened collects its errors. */
export async function openVisitor({ webgl = false } = {}) {
  const server = await servePage();
  const browser = await launchChromium({ webgl });
  return {
    async open(search = "", options = DESKTOP, prepare = async () => {}) {
      const context = await browser.newContext(options);
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
      await prepare(page);
      await page.goto(server.url + search);
      return { page, errors, close: () => context.close() };
    },
    async close() {
      await browser.close();
      await server.close();
    },
  };
}

export async function untilRunning(page) {
  await page.waitForFunction(() => Number(document.querySelector("#hud").dataset.steps) > 0);
}

/** Opens a level as a visitor does, by a file, and waits until it is there. */
export async function openLevel(page, name, text) {
  await page.waitForSelector("[data-entry]", { state: "attached" });
  const buffer = Buffer.from(text);
  await page.setInputFiles("#level-file", { name, mimeType: "application/json", buffer });
}

/** Makes steps by the key for a single one, once a scene is there, and waits for the last. */
export async function stepBy(page, count) {
  await page.waitForFunction(() => document.title.endsWith(" · thud"));
  const hud = page.locator("#hud");
  const before = await hud.evaluate(({ dataset }) => Number(dataset.steps ?? 0));
  await page.evaluate((presses) => {
    for (let i = 0; i < presses; i++)
      document.body.dispatchEvent(new KeyboardEvent("keydown", { key: ".", bubbles: true }));
  }, count);
  await page.waitForFunction(
    (least) => Number(document.querySelector("#hud").dataset.steps) >= least,
    before + count,
    { timeout: 60_000 },
  );
}

/** Where the drawn bodies are: the middle and the number of pixels that are not empty. */
export function drawn(page, id = "bodies", least = 128) {
  return page.evaluate(([canvasId, leastAlpha]) => {
    const canvas = document.getElementById(canvasId);
    const { width, height } = canvas;
    // Read from a copy, which the browser may keep where reading is quick.
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

export async function pressed(page, id) {
  return (await page.getAttribute(`#${id}`, "aria-pressed")) === "true";
}

export async function figure(page, name) {
  return Number((await page.textContent(`[data-value="${name}"]`)).replace(/,/g, ""));
}

export async function failureText(page) {
  await page.waitForSelector("#failure:not([hidden])");
  return page.innerText("#failure");
}

export function near(actual, expected, tolerance, what) {
  assert.ok(Math.abs(actual - expected) <= tolerance, `${what}: ${actual}, not ${expected}`);
}

/** Evaluated by the driver, so that the page's own policy need not allow it. */
export async function runAxe(page) {
  // What is still fading in has not the contrast that it will have.
  await page.evaluate(() =>
    Promise.allSettled(
      document
        .getAnimations()
        .filter((animation) => animation.effect.getTiming().iterations < Infinity)
        .map((animation) => animation.finished),
    ),
  );
  await page.evaluate(axeSource());
  return page.evaluate(async () => {
    const { violations } = await window.axe.run();
    return violations
      .filter(({ impact }) => impact === "serious" || impact === "critical")
      .map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html.slice(0, 120)).join(" | ")}`);
  });
}
