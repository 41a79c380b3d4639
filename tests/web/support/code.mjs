/** Support for the tests of the code panel: opening it, typing into it, reading its reports. */
import { deflateRawSync } from "node:zlib";
import { DESKTOP } from "./page.mjs";
import { until } from "./wait.mjs";

/**
 * Opens a scene with the code panel and waits until its editor is filled; violations of the policy
 * count as errors.
 */
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
 * Waits until the editor has that text, or one that matches a pattern. Only for texts short enough
 * to be rendered completely.
 */
export function untilText(page, wanted) {
  const lines = () => page.locator(".code-editor .cm-line").allTextContents();
  const is = (text) => (typeof wanted === "string" ? text === wanted : wanted.test(text));
  return until(async () => (await lines()).join("\n"), is, `not ${wanted}`);
}

/** Replaces all of the editor's text, by a paste event. */
export async function type(page, text) {
  await page.locator(".code-editor .cm-content").focus();
  await page.keyboard.press("Control+a");
  await page.locator(".code-editor .cm-content").evaluate((editor, pasted) => {
    const clipboardData = new DataTransfer();
    clipboardData.setData("text/plain", pasted);
    // Firefox's constructor of the event takes other names.
    const firefox = { dataType: "text/plain", data: pasted };
    const init = { clipboardData, ...firefox, bubbles: true, cancelable: true };
    editor.dispatchEvent(new ClipboardEvent("paste", init));
  }, text);
}

export async function run(page) {
  await page.click(".code-run");
}

/** The code of a scene with `count` circles that shows a message. */
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

// Waits until the code panel's status has exactly that text.
export function untilStatus(page, text) {
  return page.waitForFunction(
    (wanted) => document.querySelector(".code-status").textContent === wanted,
    text,
  );
}

// Waits for an error report of the code panel; returns its text.
export async function troubleOf(page) {
  await page.waitForSelector(".code-trouble:not([hidden])");
  return page.innerText(".code-trouble");
}

/** Waits until the line with that number has an error marker in the gutter. */
export function untilMarked(page, line) {
  return until(() => markedLine(page), (marked) => marked === line, `not ${line}`);
}

/**
 * The number of the line with a marker, NaN if there is none. It is read in one call, because the
 * editor may still scroll.
 */
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

// The address of a scene with code in it, as the page makes it.
export function linkOf(text, scene = "sketch") {
  return `?scene=${scene}#code=${deflateRawSync(text).toString("base64url")}`;
}
