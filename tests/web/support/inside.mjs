/** Support for the tests of the panel Inside. */
import { ballLevel } from "./package.mjs";
import { choose, DESKTOP, drawn, openLevel, stepBy } from "./page.mjs";

/** The number of steps after which the level's ball rests. */
export const RESTING = 240;

/** Opens the panel at one of its parts, beside a paused scene. */
export async function openPanel(visitor, part, search, options) {
  const opened = await visitor.open(`?${search}&panel=inside`, options);
  await opened.page.waitForSelector("[name=inside]", { state: "attached" });
  await show(opened.page, part);
  return opened;
}

export function show(page, part) {
  return choose(page, "inside", part);
}

/**
 * Opens the level of one ball, which rests, with the pointer over the ball; `extra` objects are
 * added to the level.
 */
export async function hoverBall(visitor, extra = []) {
  const opened = await openPanel(visitor, "body", "scene=cradle&paused=1", DESKTOP);
  const { page } = opened;
  await openLevel(page, "ball.tmj", ballLevel(extra));
  await page.waitForFunction(() => document.title.startsWith("ball"));
  await stepBy(page, RESTING);
  const ball = await drawn(page);
  await page.mouse.move(ball.x, ball.y);
  await page.waitForSelector("#body-card:not([hidden])");
  return { ...opened, ball };
}

/** The names and values of a list, as an object. */
export function listed(page, selector) {
  return page.$$eval(`${selector} > div`, (rows) =>
    Object.fromEntries(rows.map((row) => [...row.children].map((cell) => cell.textContent))),
  );
}
