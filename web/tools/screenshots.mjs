#!/usr/bin/env node
/** Takes screenshots of the built page for the documentation and writes them to docs/pictures. */
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { DESKTOP, launchChromium, PHONE, servePage, stepBy } from "./browser.mjs";
import { LEVELS, placeOf, VIEW } from "../public/scenes/bridge_builder/levels.js";
import { cleanCommit } from "./commit.mjs";

const USAGE = `usage: node screenshots.mjs [NAME...]

Writes docs/pictures/NAME.png of the page in web/dist; without a name, all of them. The commit of each
stands in docs/pictures/pictures.json, so that nothing may have changed since the last one.
`;

const LIGHT = { ...DESKTOP, colorScheme: "light" };

/**
 * The pictures. `search`: the query of the page's URL. `steps`: steps before the picture, so that
 * it is the same in every run. `options`: of the browser context. `prepare` and `after` are called
 * before and after the steps.
 */
const PICTURES = [
  { name: "versus", search: "scene=brick_wall&panel=versus", steps: 100, prepare: untilBoth },
  {
    name: "trade",
    search: "scene=heavy_on_light&panel=trade",
    steps: 60,
    prepare: untilPlane,
    after: measure,
  },
  {
    name: "inside",
    search: "scene=circle_pit&size=400&panel=inside",
    steps: 140,
    after: showInside,
  },
  { name: "code", search: "scene=dominoes&panel=code", steps: 150 },
  { name: "artillery", search: "scene=artillery", steps: 0, after: shoot },
  { name: "platformer", search: "scene=platformer_game", steps: 90, options: LIGHT },
  { name: "detection", search: "scene=detection", steps: 120 },
  {
    name: "geometry",
    search: "scene=geometry",
    steps: 12,
    options: { ...DESKTOP, viewport: { width: 1280, height: 800 } },
    prepare: untilRead,
    after: showSum,
  },
  { name: "textured", search: "scene=textured", steps: 240, options: LIGHT },
  { name: "phone", search: "scene=hourglass", steps: 90, options: PHONE },
  { name: "boats", search: "scene=boats", steps: 45, options: LIGHT },
  { name: "flags", search: "scene=flags", steps: 290 },
  { name: "joints", search: "scene=walker", steps: 90 },
  { name: "bridge", search: "scene=bridge_builder", steps: 0, options: PHONE, after: cross },
];

/** Waits until Box2D has been loaded and its table is shown. */
async function untilBoth(page) {
  await page.locator("#dock table").waitFor();
}

/** Waits until the trade panel is ready to measure steps. */
async function untilPlane(page) {
  await page.getByText("Run the scene for a moment").waitFor();
}

/** Waits until the panel beside the scene shows its values. */
async function untilRead(page) {
  await page.waitForSelector("[data-readings=closest] dd");
}

/** Shows the Minkowski sum and the AABBs, with their values at the end of the panel. */
async function showSum(page) {
  for (const name of ["sum", "aabb"]) await page.check(`[name=set-${name}]`);
  await stepBy(page, 1);
  const list = page.locator("[data-readings=sum]");
  await list.evaluate((element) => element.scrollIntoView({ block: "end" }));
}

/** Runs the measurement of all settings in the trade panel, and scrolls to its result. */
async function measure(page) {
  await page.getByRole("button", { name: "Measure this scene" }).click();
  await page.getByText("Copy as text").waitFor({ timeout: 600_000 });
  const result = page.getByRole("heading", { name: "powers of ten" });
  await result.evaluate((heading) => heading.scrollIntoView());
}

/** Switches on three of the drawings of the panel "inside" by their keys. */
async function showInside(page) {
  for (const key of ["4", "1", "2"]) await page.keyboard.press(key);
}

/** Starts a game against the computer, and fires one shot; the picture shows its impact. */
async function shoot(page) {
  const hold = async (key, steps) => {
    await page.keyboard.down(key);
    await stepBy(page, steps);
    await page.keyboard.up(key);
  };
  await page.focus("#overlay");
  await hold("ArrowLeft", 2);
  await stepBy(page, 30);
  await hold("ArrowUp", 20);
  await hold("Space", 2);
  await stepBy(page, 100);
}

/**
 * A truss for the first gorge of the bridge builder: the beams, from point to point of its grid.
 */
const TRUSS = [
  [[0, 0], [4, 0]], [[0, -1], [1, 0]], [[4, -1], [3, 0]], [[1, 0], [2, -1]], [[2, -1], [3, 0]],
  [[2, -1], [2, 0]],
];

/** Builds the truss with the mouse, and starts the van, until it is on the bridge. */
async function cross(page) {
  const [gorge] = LEVELS;
  const { top, bottom, width } = await page.evaluate(() => {
    const boxOf = (id) => document.getElementById(id).getBoundingClientRect();
    return { top: boxOf("top").bottom + 8, bottom: boxOf("bottom").top - 8, width: innerWidth };
  });
  const scale = Math.min((width - 32) / VIEW.width, (bottom - top) / VIEW.height);
  const moveTo = async (place) => {
    const [x, y] = placeOf(gorge, place);
    const across = scale * (x - gorge.x - gorge.width / 2);
    await page.mouse.move(width / 2 + across, (top + bottom) / 2 - scale * (y - VIEW.y));
    await stepBy(page, 1);
  };
  await stepBy(page, 30);
  for (const [from, to] of TRUSS) {
    await moveTo(from);
    await page.mouse.down();
    await stepBy(page, 1);
    await moveTo(to);
    await page.mouse.up();
    await stepBy(page, 1);
  }
  await page.locator("[data-key=fire]").hover();
  await page.mouse.down();
  await stepBy(page, 2);
  await page.mouse.up();
  await stepBy(page, 150);
}

const wanted = process.argv.slice(2);
if (wanted.includes("--help") || wanted.includes("-h")) {
  process.stdout.write(USAGE);
  process.exit(0);
}
const unknown = wanted.find((name) => !PICTURES.some((picture) => picture.name === name));
if (unknown) {
  process.stderr.write(`screenshots: there is no picture '${unknown}'\n${USAGE}`);
  process.exit(2);
}

const folder = fileURLToPath(new URL("../../docs/pictures/", import.meta.url));
mkdirSync(folder, { recursive: true });
const listed = `${folder}pictures.json`;
const commits = existsSync(listed) ? JSON.parse(readFileSync(listed, "utf8")) : {};
const commit = cleanCommit();
const server = await servePage();
const browser = await launchChromium({ webgl: true });
for (const { name, search, steps, options = DESKTOP, prepare, after } of PICTURES) {
  if (wanted.length > 0 && !wanted.includes(name)) continue;
  const context = await browser.newContext({ colorScheme: "dark", ...options });
  // The processor renders WebGL here, which may take minutes.
  context.setDefaultTimeout(300_000);
  const page = await context.newPage();
  // The hint that a first visit shows would cover a part of the picture.
  await page.addInitScript(() => localStorage.setItem("thud-hint-seen", "1"));
  await page.goto(`${server.url}?${search}&paused=1`);
  await page.waitForFunction(() => document.title.endsWith(" · thud"));
  await prepare?.(page);
  if (steps > 0) await stepBy(page, steps);
  await after?.(page);
  // Wait until the figures are those of the last step, and the description of the scene has gone.
  await page.waitForSelector("#notice", { state: "hidden", timeout: 60_000 });
  await page.screenshot({ path: `${folder}${name}.png` });
  commits[name] = { commit, date: new Date().toISOString().slice(0, 10) };
  writeFileSync(listed, `${JSON.stringify(commits, null, 1)}\n`);
  console.log(`docs/pictures/${name}.png`);
  await context.close();
}
await browser.close();
await server.close();
