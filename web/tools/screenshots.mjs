#!/usr/bin/env node
/** Takes the README's pictures of the built page and writes them to docs/pictures. */
import { mkdirSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { launchChromium, servePage } from "./browser.mjs";

const USAGE = `usage: node screenshots.mjs [NAME...]

Writes docs/pictures/NAME.png of the page in web/dist; without a name, all of them.
`;

const DESKTOP = { viewport: { width: 1440, height: 900 } };
const PHONE = {
  viewport: { width: 390, height: 844 },
  deviceScaleFactor: 2,
  hasTouch: true,
  isMobile: true,
};

/** Each after so many steps, so that a picture shows the same at every run. */
const PICTURES = [
  { name: "quarry", search: "level=quarry", steps: 240, options: DESKTOP },
  { name: "towers", search: "level=towers", steps: 150, options: DESKTOP },
  { name: "platform", search: "level=platform", steps: 150, options: DESKTOP },
  { name: "mountain", search: "level=mountain", steps: 200, options: DESKTOP },
  { name: "smash", search: "scene=smash", steps: 110, options: DESKTOP },
  { name: "tumbler", search: "scene=tumbler", steps: 400, options: { ...DESKTOP, colorScheme: "light" } },
  { name: "detection", search: "scene=detection", steps: 200, options: DESKTOP },
  { name: "minkowski", search: "scene=minkowski", steps: 5, options: DESKTOP },
  { name: "broadphases-grid", search: "scene=broadphases", steps: 60, options: DESKTOP },
  {
    name: "broadphases-sweep",
    search: "scene=broadphases&broadphase=sweep",
    steps: 60,
    options: DESKTOP,
  },
  { name: "circle-pit-phone", search: "scene=circle_pit", steps: 300, options: PHONE },
];

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
const server = await servePage();
const browser = await launchChromium();
for (const { name, search, steps, options } of PICTURES) {
  if (wanted.length > 0 && !wanted.includes(name)) continue;
  const context = await browser.newContext({ colorScheme: "dark", ...options });
  const page = await context.newPage();
  await page.goto(`${server.url}?${search}&paused=1`);
  await page.waitForFunction(() => document.title !== "thud");
  await page.evaluate((count) => {
    for (let i = 0; i < count; i++)
      document.body.dispatchEvent(new KeyboardEvent("keydown", { key: ".", bubbles: true }));
  }, steps);
  // Until the figures are those of the last step and the line about the scene has gone.
  await page.waitForSelector("#notice", { state: "hidden" });
  await page.screenshot({ path: `${folder}${name}.png` });
  console.log(`docs/pictures/${name}.png`);
  await context.close();
}
await browser.close();
await server.close();
