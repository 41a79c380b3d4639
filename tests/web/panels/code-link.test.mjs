/**
 * Tests code in a link: the page asks before it runs code from another person, and such code cannot
 * reach other hosts.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { inflateRawSync } from "node:zlib";
import { copyOfPage, createPlainServer, serve } from "../support/built-page.mjs";
import { boxes, linkOf, openCode, run, type, untilStatus, untilText } from "../support/code.mjs";
import {
  browserOf,
  DESKTOP,
  openVisitor,
  PATIENCE,
  PHONE,
  untilBodies,
  untilRunning,
} from "../support/page.mjs";

const SIZES = { desktop: DESKTOP, phone: PHONE };

const visitor = openVisitor();

test("code_goes_with_the_address_with_letters_of_any_language", async () => {
  const { page, errors, close } = await openCode(visitor, "?scene=sketch&panel=code");
  await type(page, boxes(7, { message: "Kugeln — пять ⚽ 球" }));
  await page.keyboard.press("Control+Enter");
  await untilBodies(page, 7);
  await page.waitForFunction(() => location.hash.startsWith("#code="));
  const address = await page.evaluate(() => location.search + location.hash);
  // The visitor's own code runs again without a question; another visitor is asked first.
  await page.reload();
  await untilBodies(page, 7);
  const other = await openCode(visitor, address);
  await other.page.click(".code-offer button");
  await untilBodies(other.page, 7);
  await other.page.waitForSelector('#message:text-is("Kugeln — пять ⚽ 球")');
  assert.deepEqual([...errors, ...other.errors], []);
  await other.close();
  await close();
});

for (const [name, options] of Object.entries(SIZES))
  test(`code_of_a_link_is_offered_and_not_run_on_${name}`, async () => {
    const link = linkOf(boxes(9));
    const { page, errors, close } = await openCode(visitor, link, options);
    await page.waitForSelector(".code-offer:not([hidden])");
    assert.match(await page.innerText(".code-offer"), /by somebody else/);
    await untilText(page, boxes(9));
    await untilBodies(page, 14);
    // The address may at first be that of the scene without the code.
    await page.waitForFunction(() => location.hash.startsWith("#code="));
    const kept = await page.evaluate(() => location.hash.replace("#code=", ""));
    assert.equal(String(inflateRawSync(Buffer.from(kept, "base64url"))), boxes(9));
    await page.click(".code-offer button");
    await untilBodies(page, 9);
    assert.ok(await page.isHidden(".code-offer"));
    assert.deepEqual(errors, []);
    await close();
  });

test("code_of_a_link_is_asked_about_twice_where_nothing_confines_it", async (t) => {
  const { url } = await serve(t, createPlainServer(copyOfPage(t)));
  const page = await (await browserOf("chromium")).newPage();
  t.after(() => page.close());
  page.setDefaultTimeout(PATIENCE);
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
  const { page, close } = await openCode(visitor, linkOf(boxes(9)));
  await page.click(".code-offer button:nth-child(2)");
  await untilStatus(page, "Runs unchanged");
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

/** Scene code that collects the names of everything it could reach. */
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
  const { page, close } = await openCode(visitor, "?scene=sketch&panel=code");
  const text = boxes(2)
    .replace("function ({ createWorld }) {", `async function ({ createWorld, readText }) {${PROBE}`)
    .replace('message: "boxes"', "message: JSON.stringify({ reached, home })");
  await type(page, text);
  await run(page);
  await page.locator("#message", { hasText: "reached" }).waitFor();
  assert.deepEqual(JSON.parse(await page.innerText("#message")), { reached: [], home: true });
  await close();
});
