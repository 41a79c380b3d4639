/** Support for the tests of the panel Versus. */
import { DESKTOP, openLevel } from "./page.mjs";
import { ballLevel } from "./package.mjs";
import { until } from "./wait.mjs";

export const BOX2D = /\/Box2D\.[\w-]+\.(js|wasm)$/;

/**
 * The mean places of the two drawn bodies, one of thud and one of Box2D; empty if they are not
 * apart.
 */
export function middles(page) {
  return page.evaluate(async () => {
    // A WebGL canvas can be read only in the frame in which it was drawn.
    window.dispatchEvent(new Event("resize"));
    await new Promise(requestAnimationFrame);
    const canvas = document.getElementById("bodies");
    const { width, height } = canvas;
    const copy = Object.assign(document.createElement("canvas"), { width, height });
    const context = copy.getContext("2d", { willReadFrequently: true });
    context.drawImage(canvas, 0, 0);
    const { data } = context.getImageData(0, 0, width, height);
    const pixels = [];
    for (let i = 3; i < data.length; i += 4)
      if (data[i] >= 128) pixels.push([((i - 3) / 4) % width, Math.floor((i - 3) / 4 / width)]);
    // The widest gap, horizontal or vertical, separates the two bodies.
    let [gap, axis, part] = [0, 0, 0];
    for (const k of [0, 1]) {
      const places = [...new Set(pixels.map((pixel) => pixel[k]))].sort((a, b) => a - b);
      for (let i = 1; i < places.length; i++)
        if (places[i] - places[i - 1] > gap)
          [gap, axis, part] = [places[i] - places[i - 1], k, places[i]];
    }
    const ratio = width / innerWidth;
    return [pixels.filter((p) => p[axis] < part), pixels.filter((p) => p[axis] >= part)]
      .filter((some) => some.length > 0 && gap > 4)
      .map((some) => ({
        count: some.length,
        x: some.reduce((sum, [x]) => sum + x, 0) / some.length / ratio,
        y: some.reduce((sum, [, y]) => sum + y, 0) / some.length / ratio,
      }));
  });
}

// Waits until the panel has loaded Box2D.
export async function untilBox2D(page) {
  await page.waitForSelector("#versus .verdict");
  await page.waitForFunction(
    () => !/Loading/.test(document.querySelector("#versus .verdict").textContent),
  );
}

/** Opens the level of one ball above flat ground, paused, in both engines. */
export async function openBoth(visitor, options = DESKTOP) {
  const opened = await visitor.open("?scene=cradle&paused=1", options);
  await openLevel(opened.page, "ball.tmj", ballLevel());
  await opened.page.waitForFunction(() => document.title.startsWith("ball"));
  await opened.page.keyboard.press("x");
  await untilBox2D(opened.page);
  await untilTwo(opened.page);
  return opened;
}

/** Waits until two bodies are drawn. */
export function untilTwo(page) {
  return until(() => middles(page), ({ length }) => length === 2, "two bodies");
}

/** The table's rows by their heading: the texts of the cells of thud and Box2D. */
export function table(page) {
  return page.$$eval("#versus-table tbody tr", (rows) =>
    Object.fromEntries(
      rows.map((row) => [
        row.querySelector("th").textContent,
        [...row.querySelectorAll("td")].map((cell) => cell.textContent),
      ]),
    ),
  );
}

// Waits for `count` frames of the display.
export function drawnFrames(page, count) {
  return page.evaluate(
    (frames) =>
      new Promise((resolve) => {
        const next = () => (frames-- > 0 ? requestAnimationFrame(next) : resolve());
        next();
      }),
    count,
  );
}

// Waits until the panel's table has a step time.
export async function untilMeasured(page) {
  await page.waitForFunction(
    () => / ms$/.test(document.querySelector("#versus-table tbody td")?.textContent),
  );
}
