#!/usr/bin/env node
/**
 * Measures the time of a frame on the page's main thread: the duration of each callback of
 * requestAnimationFrame. The physics runs in a worker, and is not in it.
 */
import { launchChromium, servePage } from "./browser.mjs";

const USAGE = `usage: node frame-cost.mjs [SCENE [SIZE]]

Runs a scene of the page in web/dist in Chromium, gas with 10,000 circles unless another is named,
and prints the time that the page's thread spends on each picture and the worker on each step. How
many pictures a second there are depends on the graphics card, which a machine without a screen
mostly lacks: its drawing is not in these figures.
`;
/** Frames that are measured, the last ones. */
const PICTURES = 120;
/** The time of a frame at 60 frames a second, ms. */
const BUDGET = 1000 / 60;

const [scene = "gas", size = "10000"] = process.argv.slice(2);
if (scene.startsWith("-")) {
  process.stdout.write(USAGE);
  process.exit(/^(-h|--help)$/.test(scene) ? 0 : 2);
}
const server = await servePage();
const browser = await launchChromium({ webgl: true });
const page = await browser.newPage({ viewport: { width: 1440, height: 900 } });
await page.addInitScript(() => {
  const request = window.requestAnimationFrame.bind(window);
  window.pictureTimes = [];
  window.requestAnimationFrame = (draw) =>
    request((time) => {
      const before = performance.now();
      draw(time);
      window.pictureTimes.push(performance.now() - before);
    });
});
await page.goto(`${server.url}?scene=${scene}&size=${size}`);
await page.waitForFunction(
  (count) => document.title !== "thud" && window.pictureTimes.length > count,
  PICTURES,
  { timeout: 300_000 },
);
const { times, bodies, step } = await page.evaluate((count) => {
  const text = (name) => document.querySelector(`[data-value=${name}]`).textContent;
  return { times: window.pictureTimes.slice(-count), bodies: text("bodies"), step: text("ms") };
}, PICTURES);
times.sort((a, b) => a - b);
const at = (part) => times[Math.floor(part * times.length)].toFixed(2);
console.log(`${scene}, ${bodies} bodies: a picture takes the page's thread ${at(0.5)} ms (median), \
${at(0.9)} ms (9 of 10) of ${BUDGET.toFixed(1)}; a step takes the worker ${step}`);
await browser.close();
await server.close();
