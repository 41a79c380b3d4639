/** The code panel: the running scene's text, changed, run again, and sent with a link. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { deflateRawSync, inflateRawSync } from "node:zlib";
import { launchChromium } from "../../web/tools/browser.mjs";
import { copyOfPage, createPlainServer, serve } from "./built-page.mjs";
import { DESKTOP, openVisitor, PHONE, untilRunning } from "./page-support.mjs";
import { axeSource, root } from "./support.mjs";

const SIZES = { desktop: DESKTOP, phone: PHONE };
const SKETCH = readFileSync(`${root}web/public/scenes/sketch.js`, "utf8");

let visitor;
before(async () => {
  visitor = await openVisitor();
});
after(() => visitor.close());

/** The page with the code panel open and its editor filled; breaches of its policy are errors. */
async function openCode(search, options = DESKTOP) {
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
async function textOf(page) {
  const lines = await page.locator(".code-editor .cm-line").allTextContents();
  return lines.join("\n");
}

/** Puts another text in place of all that is in the editor, as a paste does. */
async function type(page, text) {
  await page.locator(".code-editor .cm-content").focus();
  await page.keyboard.press("Control+a");
  await page.keyboard.insertText(text);
}

async function run(page) {
  await page.click(".code-run");
}

/** A scene of some boxes that says which one it is. */
function boxes(count, { message = "boxes", update = "" } = {}) {
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

function untilBodies(page, count) {
  return page.waitForFunction(
    (wanted) => document.querySelector('[data-value="bodies"]')?.textContent === wanted,
    String(count),
  );
}

function untilStatus(page, text) {
  return page.waitForFunction(
    (wanted) => document.querySelector(".code-status").textContent === wanted,
    text,
  );
}

async function troubleOf(page) {
  await page.waitForSelector(".code-trouble:not([hidden])");
  return page.innerText(".code-trouble");
}

/** The number of the line that has a mark in the gutter. */
async function markedLine(page) {
  const mark = await page.locator(".cm-lint-marker-error").boundingBox();
  for (const number of await page.locator(".cm-lineNumbers .cm-gutterElement").all()) {
    const box = await number.boundingBox();
    if (box && box.y <= mark.y && mark.y < box.y + box.height)
      return Number(await number.innerText());
  }
  return null;
}

function linkOf(text, scene = "sketch") {
  return `?scene=${scene}#code=${deflateRawSync(text).toString("base64url")}`;
}

for (const [name, options] of Object.entries(SIZES)) {
  test(`number_changed_and_run_changes_the_world_on_${name}`, async () => {
    const { page, errors, close } = await openCode("?scene=sketch&panel=code", options);
    assert.match(await page.innerText(".code-status"), /Runs as it comes/);
    await untilBodies(page, 14);
    await page.locator(".cm-line", { hasText: "export const size" }).click();
    await page.keyboard.press("End");
    await page.keyboard.press("Control+a");
    await page.keyboard.insertText(SKETCH.replace("usual: 12", "usual: 20"));
    await untilStatus(page, "Changed, not run yet");
    await run(page);
    await untilStatus(page, "Your code runs");
    await untilBodies(page, 22);
    assert.deepEqual(errors, []);
    await close();
  });

  test(`syntax_error_is_told_at_its_line_and_the_scene_goes_on_on_${name}`, async () => {
    const { page, errors, close } = await openCode("?scene=sketch&panel=code", options);
    await type(page, "const a = 1;\nconst b = = 2;\nexport default function () {}\n");
    await run(page);
    assert.match(await troubleOf(page), /Line 2[\s\S]*Unexpected token/);
    assert.equal(await markedLine(page), 2);
    await untilStatus(page, "Does not run");
    const steps = () => page.evaluate(() => Number(document.querySelector("#hud").dataset.steps));
    const then = await steps();
    await page.waitForFunction(
      (n) => Number(document.querySelector("#hud").dataset.steps) > n,
      then,
    );
    assert.ok(await page.isHidden("#failure"));
    assert.deepEqual(errors, []);
    await close();
  });

  test(`axe_finds_no_serious_violation_in_the_code_panel_on_${name}`, async () => {
    for (const colorScheme of ["dark", "light"]) {
      const { page, close } = await openCode("?scene=artillery&panel=code", {
        ...options,
        colorScheme,
      });
      await type(page, "export default 1 +;\n");
      await run(page);
      await troubleOf(page);
      await page.click(".code-help summary");
      await page.evaluate(axeSource());
      const violations = await page.evaluate(async () => {
        const found = await window.axe.run();
        return found.violations
          .filter(({ impact }) => impact === "serious" || impact === "critical")
          .map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html).join(" | ")}`);
      });
      assert.deepEqual(violations, []);
      await close();
    }
  });
}

test("buttons_of_the_code_panel_are_large_enough_on_a_phone", async () => {
  const { page, close } = await openCode("?scene=sketch&panel=code", PHONE);
  for (const button of await page.locator(".code button:visible, .code summary").all()) {
    const { height } = await button.boundingBox();
    assert.ok(height >= 40, `${await button.innerText()}: ${height}`);
  }
  const dock = await page.locator("#dock").boundingBox();
  assert.ok(dock.height <= 0.46 * 844 + 1, "the scene stays visible");
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
  await close();
});

test("error_while_building_is_told_at_its_line", async () => {
  const { page, close } = await openCode("?scene=sketch&panel=code");
  await type(page, boxes(3).replace("  return {", "  world.nothing.here();\n  return {"));
  await run(page);
  assert.match(await troubleOf(page), /Line 7[\s\S]*undefined/);
  assert.equal(await markedLine(page), 7);
  await untilBodies(page, 14);
  await close();
});

test("error_in_update_is_told_at_its_line_and_the_next_run_goes_on", async () => {
  const { page, close } = await openCode("?scene=sketch&panel=code");
  await type(page, boxes(3, { update: "world.nothing.here();" }));
  await run(page);
  assert.match(await troubleOf(page), /Line 11[\s\S]*undefined/);
  assert.equal(await markedLine(page), 11);
  await type(page, boxes(4));
  await run(page);
  await untilBodies(page, 4);
  await untilRunning(page);
  assert.ok(await page.isHidden(".code-trouble"));
  await close();
});

test("error_in_update_is_told_when_the_panel_was_closed", async () => {
  const { page, close } = await openCode("?scene=sketch&panel=code");
  await type(page, boxes(3, { update: "if (world.stats().steps > 150) throw new Error('late');" }));
  await run(page);
  await untilStatus(page, "Your code runs");
  await page.click("#dock .close");
  assert.match(await troubleOf(page), /Line 11[\s\S]*late/);
  await close();
});

test("import_that_is_not_there_is_told_at_its_line", async () => {
  const { page, close } = await openCode("?scene=sketch&panel=code");
  const told = async (line) => {
    await type(page, `// an import\n${line}\n${boxes(1)}`);
    await run(page);
    await page.waitForFunction(() => document.querySelector(".code-trouble p"));
    return troubleOf(page);
  };
  assert.match(await told('import { x } from "./sketch.js";'), /Line 2[\s\S]*'x'/);
  assert.match(await told('import "three";'), /Line 2[\s\S]*“three” is no file of this page/);
  await close();
});

test("loop_without_an_end_leads_back_and_keeps_the_text", { timeout: 90_000 }, async () => {
  const { page, close } = await openCode("?scene=sketch&panel=code");
  const text = boxes(3, { update: "for (;;);" });
  await type(page, text);
  await run(page);
  await page.waitForSelector("#failure:not([hidden])", { timeout: 40_000 });
  assert.match(await page.innerText("#failure"), /does not answer/);
  // No frame has come of the loop, so that the figures are still those of the scene before it.
  await page.evaluate(() => (document.querySelector("#hud").dataset.steps = "none"));
  await page.click("#failure button");
  await untilRunning(page);
  await untilBodies(page, 14);
  assert.match(await troubleOf(page), /did not answer/);
  assert.equal(await textOf(page), text);
  await type(page, boxes(5));
  await run(page);
  await untilBodies(page, 5);
  await close();
});

test("text_is_kept_when_another_scene_was_opened_and_the_page_loaded_again", async () => {
  const { page, close } = await openCode("?scene=sketch&panel=code");
  const text = boxes(6);
  await type(page, text);
  await page.click("#scenes-button");
  await page.click('[data-entry="cradle"]');
  await page.waitForSelector('[role="tab"]:text-is("cradle.js")');
  await page.reload();
  await page.waitForSelector(".code-editor .cm-line:not(:empty)");
  await page.click("#scenes-button");
  await page.click('[data-entry="sketch"]');
  await page.waitForSelector('[role="tab"]:text-is("sketch.js")');
  assert.equal(await textOf(page), text);
  await close();
});

test("code_goes_with_the_address_with_letters_of_any_language", async () => {
  const { page, errors, close } = await openCode("?scene=sketch&panel=code");
  await type(page, boxes(7, { message: "Kugeln — пять ⚽ 球" }));
  await page.keyboard.press("Control+Enter");
  await untilBodies(page, 7);
  await page.waitForFunction(() => location.hash.startsWith("#code="));
  const address = page.url().slice(page.url().indexOf("?"));
  // One's own code runs again; somebody else is asked first.
  await page.reload();
  await untilBodies(page, 7);
  const other = await openCode(address);
  await other.page.click(".code-offer button");
  await untilBodies(other.page, 7);
  assert.equal(await other.page.innerText("#message"), "Kugeln — пять ⚽ 球");
  assert.deepEqual([...errors, ...other.errors], []);
  await other.close();
  await close();
});

for (const [name, options] of Object.entries(SIZES))
  test(`code_of_a_link_is_offered_and_not_run_on_${name}`, async () => {
    const link = linkOf(boxes(9));
    const { page, errors, close } = await openCode(link, options);
    await page.waitForSelector(".code-offer:not([hidden])");
    assert.match(await page.innerText(".code-offer"), /by somebody else/);
    assert.equal(await textOf(page), boxes(9));
    await untilBodies(page, 14);
    const kept = new URL(page.url()).hash.replace("#code=", "");
    assert.equal(String(inflateRawSync(Buffer.from(kept, "base64url"))), boxes(9));
    await page.click(".code-offer button");
    await untilBodies(page, 9);
    assert.ok(await page.isHidden(".code-offer"));
    assert.deepEqual(errors, []);
    await close();
  });

test("code_of_a_link_is_asked_about_twice_where_nothing_confines_it", async (t) => {
  const { url } = await serve(t, createPlainServer(copyOfPage(t)));
  const browser = await launchChromium({ webgl: false });
  t.after(() => browser.close());
  const page = await browser.newPage();
  await page.addInitScript(() => delete Navigator.prototype.serviceWorker);
  await page.goto(url + linkOf(boxes(9)));
  await page.click(".code-offer button");
  await page.waitForFunction(() =>
    /reaching other hosts here/.test(document.querySelector(".code-offer").textContent),
  );
  await untilBodies(page, 14);
  await page.click(".code-offer button");
  await untilBodies(page, 9);
});

test("code_of_a_link_can_be_left_out", async () => {
  const { page, close } = await openCode(linkOf(boxes(9)));
  await page.click(".code-offer button:nth-child(2)");
  await untilStatus(page, "Runs as it comes");
  assert.ok(await page.isHidden(".code-offer"));
  await page.waitForFunction(() => location.hash === "");
  await untilBodies(page, 14);
  await close();
});

test("damaged_code_of_a_link_is_told", async () => {
  const { page, close } = await visitor.open("?scene=cradle#code=nonsense");
  await page.waitForFunction(() =>
    /code in this link is damaged/.test(document.querySelector("#notice").textContent),
  );
  await untilRunning(page);
  await close();
});

test("original_comes_back_and_undoing_brings_the_text_again", async () => {
  const { page, close } = await openCode("?scene=sketch&panel=code");
  await type(page, boxes(4));
  await run(page);
  await untilBodies(page, 4);
  await page.click(".code-bar button:nth-child(2)");
  await untilBodies(page, 14);
  await untilStatus(page, "Runs as it comes");
  await page.locator(".code-editor .cm-content").focus();
  await page.keyboard.press("Control+z");
  await untilStatus(page, "Changed, not run yet");
  assert.equal(await textOf(page), boxes(4));
  await close();
});

test("camera_and_choices_stay_when_code_runs", async () => {
  const { page, close } = await openCode(
    "?scene=sketch&size=5&quality=high&view=1,2,50&panel=code",
  );
  await untilBodies(page, 7);
  await type(page, SKETCH.replace("2 + i", "3 + i"));
  await run(page);
  await untilStatus(page, "Your code runs");
  await page.waitForFunction(() => location.hash.startsWith("#code="));
  const params = new URL(page.url()).searchParams;
  assert.deepEqual([params.get("size"), params.get("quality")], ["5", "high"]);
  assert.deepEqual(params.get("view").split(",").map(Number), [1, 2, 50]);
  await close();
});

test("imported_files_are_shown_read_only_in_tabs", async () => {
  const { page, close } = await openCode("?scene=artillery&panel=code");
  await page.click('[role="tab"]:has-text("tanks.js")');
  assert.match(await page.innerText(".code-status"), /Read only/);
  const before = await textOf(page);
  await page.locator(".code-editor .cm-content").focus();
  await page.keyboard.type("x");
  assert.equal(await textOf(page), before);
  await page.focus('[role="tab"][aria-selected="true"]');
  await page.keyboard.press("Home");
  assert.equal(await page.innerText('[role="tab"][aria-selected="true"]'), "artillery.js");
  await close();
});

test("keyboard_alone_opens_types_runs_and_leaves", async () => {
  const { page, errors, close } = await visitor.open("?scene=sketch");
  await untilRunning(page);
  await page.keyboard.press("k");
  await page.waitForSelector(".code-editor .cm-line:not(:empty)");
  const inEditor = () =>
    page.evaluate(() => document.activeElement?.classList.contains("code-editor") ?? false);
  for (let i = 0; i < 12 && !(await inEditor()); i++) await page.keyboard.press("Tab");
  assert.ok(await inEditor(), "Tab reaches the editor");
  await page.keyboard.press("Control+Home");
  // Letters are no shortcuts here, and Tab indents.
  await page.keyboard.type("// pause, reset: p r l");
  await page.keyboard.press("Enter");
  await page.keyboard.press("Tab");
  assert.ok(await inEditor());
  assert.match(await textOf(page), /^\/\/ pause, reset: p r l\n/);
  assert.equal(await page.getAttribute("#pause", "aria-pressed"), "false");
  await page.keyboard.press("Control+Enter");
  await untilStatus(page, "Your code runs");
  await page.keyboard.press("Escape");
  await page.waitForSelector("#status:has-text('Tab leaves')", { state: "attached" });
  await page.keyboard.press("Tab");
  assert.ok(!(await inEditor()), "Escape, then Tab, leaves the editor");
  await page.keyboard.press("Shift+Tab");
  assert.ok(await inEditor());
  await page.keyboard.press("Escape");
  await page.keyboard.press("Escape");
  await page.waitForSelector("#dock", { state: "hidden" });
  assert.deepEqual(errors, []);
  await close();
});

/** Tells what it reached, each by its name. */
const PROBE = `
  const reached = [];
  for (const name of ["XMLHttpRequest", "WebSocket", "EventSource", "WebTransport", "Worker",
    "BroadcastChannel", "indexedDB", "caches", "importScripts", "FontFace"])
    if (name in globalThis) reached.push(name);
  if ("storage" in navigator) reached.push("storage");
  if (WorkerGlobalScope.prototype.fetch) reached.push("the prototype's fetch");
  const elsewhere = "http://127.0.0.1:9/";
  for (const target of [elsewhere, new URL(elsewhere), new Request(elsewhere), "data:,x"]) {
    const refused = await fetch(target).then(() => "", ({ message }) => message);
    if (!refused.includes("not a file of this page")) reached.push(String(target));
  }
  const home = (await readText("levels/towers.tmj")).length > 1000;`;

test("code_that_reaches_out_fails_and_reads_its_own_page", async () => {
  const { page, close } = await openCode("?scene=sketch&panel=code");
  const text = boxes(2)
    .replace("function ({ createWorld }) {", `async function ({ createWorld, readText }) {${PROBE}`)
    .replace('message: "boxes"', "message: JSON.stringify({ reached, home })");
  await type(page, text);
  await run(page);
  await page.waitForFunction(() => /reached/.test(document.querySelector("#message").textContent));
  assert.deepEqual(JSON.parse(await page.innerText("#message")), { reached: [], home: true });
  await close();
});
