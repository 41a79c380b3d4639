/** What the tests of the panel Inside share. */
import { ballLevel } from "./package.mjs";
import { choose, DESKTOP, drawn, openLevel, stepBy } from "./page.mjs";

/** Steps until the ball of a level rests. */
export const RESTING = 240;

/** Opens the panel beside a scene that stands still, at one of its parts. */
export async function openPanel(visitor, part, search, options) {
  const opened = await visitor.open(`?${search}&panel=inside`, options);
  await opened.page.waitForSelector("[name=inside]", { state: "attached" });
  await show(opened.page, part);
  return opened;
}

export function show(page, part) {
  return choose(page, "inside", part);
}

/** The one ball of a level, at rest, with the pointer over it; `extra` is in the level as well. */
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

/** Names and values of a list. */
export function listed(page, selector) {
  return page.$$eval(`${selector} > div`, (rows) =>
    Object.fromEntries(rows.map((row) => [...row.children].map((cell) => cell.textContent))),
  );
}
