#!/usr/bin/env node
/** Renders the page's icons from public/icon.svg in Chromium and writes them to public/icons. */
import { mkdirSync, readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { launchChromium } from "./browser.mjs";

/**
 * `size`: pixels. `drawing`: the size of the drawing over that of the icon. `filled`: with a
 * background to the edges, for systems that cut icons to a shape of their own; of a maskable icon
 * only a circle of four fifths of the width is certain to remain.
 */
const ICONS = [
  { name: "icon-192", size: 192, drawing: 1, filled: false },
  { name: "icon-512", size: 512, drawing: 1, filled: false },
  { name: "maskable-512", size: 512, drawing: 0.8, filled: true },
  { name: "apple-touch", size: 180, drawing: 0.9, filled: true },
];
const BACKGROUND = "#131a27";

const web = new URL("..", import.meta.url);
const source = readFileSync(new URL("public/icon.svg", web), "utf8");
const folder = fileURLToPath(new URL("public/icons/", web));
mkdirSync(folder, { recursive: true });
const browser = await launchChromium({ webgl: false });
for (const { name, size, drawing, filled } of ICONS) {
  const page = await browser.newPage({ viewport: { width: size, height: size } });
  await page.setContent(`<style>
    body { margin: 0; display: grid; place-items: center; height: 100vh;
      background: ${filled ? BACKGROUND : "transparent"} }
    svg { width: ${100 * drawing}vw; height: ${100 * drawing}vw }
  </style>${source}`);
  await page.screenshot({ path: `${folder}${name}.png`, omitBackground: !filled });
  console.log(`web/public/icons/${name}.png`);
  await page.close();
}
await browser.close();
