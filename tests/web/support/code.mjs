/** What the tests of the code panel share: opening it, typing into it, what it tells. */
import { deflateRawSync } from "node:zlib";
import { DESKTOP } from "./page.mjs";
import { until } from "./wait.mjs";

/** A scene with the code panel open and its editor filled; breaches of its policy are errors. */
export async function openCode(visitor, search, options = DESKTOP) {
  const opened = await visitor.open(search, options, async (page) => {
    await page.addInitScript(() =>
      addEventListener("securitypolicyviolation", ({ effectiveDirective, blockedURI }) =>
        console.error(`policy: ${effectiveDirective} ${blockedURI}`),
      ),
    );
  });
  await opened.page.waitForSelector(".code-editor .cm-line:not(:empty)");
  return opened;
}

/**
 * Until the editor has that text, or one that matches a pattern. Only for texts that are short enough
 * to be drawn as a whole.
 */
export function untilText(page, wanted) {
  const lines = () => page.locator(".code-editor .cm-line").allTextContents();
  const is = (text) => (typeof wanted === "string" ? text === wanted : wanted.test(text));
  return until(async () => (await lines()).join("\n"), is, `not ${wanted}`);
}

/** Puts another text in place of all that is in the editor, by a paste. */
export async function type(page, text) {
  await page.locator(".code-editor .cm-content").focus();
  await page.keyboard.press("Control+a");
  await page.locator(".code-editor .cm-content").evaluate((editor, pasted) => {
    const clipboardData = new DataTransfer();
    clipboardData.setData("text/plain", pasted);
    // What Firefox makes an event of it calls by other names.
    const firefox = { dataType: "text/plain", data: pasted };
    const init = { clipboardData, ...firefox, bubbles: true, cancelable: true };
    editor.dispatchEvent(new ClipboardEvent("paste", init));
  }, text);
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

/** Until the line of that number has a mark in the gutter. */
export function untilMarked(page, line) {
  return until(() => markedLine(page), (marked) => marked === line, `not ${line}`);
}

/** NaN where none has; all at one moment, as the editor may yet scroll to the place. */
function markedLine(page) {
  return page.locator(".code-editor").evaluate(({ shadowRoot }) => {
    const boxOf = (element) => element.getBoundingClientRect();
    const marker = shadowRoot.querySelector(".cm-lint-marker-error");
    if (!marker) return NaN;
    const mark = boxOf(marker);
    const numbers = [...shadowRoot.querySelectorAll(".cm-lineNumbers .cm-gutterElement")];
    const beside = numbers.find((number) => {
      const { top, bottom } = boxOf(number);
      return top <= mark.top && mark.top < bottom;
    });
    return Number(beside?.textContent);
  });
}

export function linkOf(text, scene = "sketch") {
  return `?scene=${scene}#code=${deflateRawSync(text).toString("base64url")}`;
}
