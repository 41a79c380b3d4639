/** What the tests of the code panel share: opening it, typing into it, what it tells. */
import { deflateRawSync } from "node:zlib";
import { DESKTOP, untilRunning } from "./page-support.mjs";

/** The page with the code panel open and its editor filled; breaches of its policy are errors. */
export async function openCode(visitor, search, options = DESKTOP) {
  const opened = await visitor.open(search, options, async (page) => {
    await page.addInitScript(() =>
      addEventListener("securitypolicyviolation", ({ effectiveDirective, blockedURI }) =>
        console.error(`policy: ${effectiveDirective} ${blockedURI}`),
      ),
    );
  });
  await untilRunning(opened.page);
  await opened.page.waitForSelector(".code-editor .cm-line:not(:empty)");
  return opened;
}

/** As the editor has it; only for texts that are short enough to be drawn as a whole. */
export async function textOf(page) {
  const lines = await page.locator(".code-editor .cm-line").allTextContents();
  return lines.join("\n");
}

/** Puts another text in place of all that is in the editor, as a paste does. */
export async function type(page, text) {
  await page.locator(".code-editor .cm-content").focus();
  await page.keyboard.press("Control+a");
  await page.keyboard.insertText(text);
}

export async function run(page) {
  await page.click(".code-run");
}

/** A scene of some boxes that says which one it is. */
export function boxes(count, { message = "boxes", update = "" } = {}) {
  return `export default function ({ createWorld }) {
  const world = createWorld();
  for (let i = 0; i < ${count}; i++) {
    const body = world.createBody({ kind: "dynamic", position: [0, 2 * i] });
    world.createCircle(body, { radius: 0.5 });
  }
  return {
    world,
    paint: () => ({ message: "${message}" }),
    update() {
      ${update}
    },
  };
}
`;
}

export function untilBodies(page, count) {
  return page.waitForFunction(
    (wanted) => document.querySelector('[data-value="bodies"]')?.textContent === wanted,
    String(count),
  );
}

export function untilStatus(page, text) {
  return page.waitForFunction(
    (wanted) => document.querySelector(".code-status").textContent === wanted,
    text,
  );
}

export async function troubleOf(page) {
  await page.waitForSelector(".code-trouble:not([hidden])");
  return page.innerText(".code-trouble");
}

/** The number of the line that has a mark in the gutter. */
export async function markedLine(page) {
  const mark = await page.locator(".cm-lint-marker-error").boundingBox();
  for (const number of await page.locator(".cm-lineNumbers .cm-gutterElement").all()) {
    const box = await number.boundingBox();
    if (box && box.y <= mark.y && mark.y < box.y + box.height)
      return Number(await number.innerText());
  }
  return null;
}

export function linkOf(text, scene = "sketch") {
  return `?scene=${scene}#code=${deflateRawSync(text).toString("base64url")}`;
}
