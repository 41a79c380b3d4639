/**
 * Tests the scene lab_latency in the page: its controls by keyboard, and the numbers that the panel
 * shows, in each browser and on a phone.
 */
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { MEASURED } from "../../../web/public/scenes/lab_latency/measured.js";
import { BROWSERS, DESKTOP, leftOut, openVisitor, PHONE, runAxeInBothThemes, stepBy } from "../support/page.mjs";
import { until } from "../support/wait.mjs";

/** The value with that name in the list under a ticked box. */
function reading(page, control, name) {
  return page.evaluate(([list, wanted]) => {
    const terms = [...document.querySelectorAll(`[data-readings="${list}"] dt`)];
    return terms.find(({ textContent }) => textContent === wanted)?.nextSibling.textContent;
  }, [control, name]);
}

for (const browser of BROWSERS)
  describe(browser, () => {
    const visitor = openVisitor({ browser });
    const sized = ({ isMobile, hasTouch, ...rest }) =>
      browser === "firefox" ? rest : { isMobile, hasTouch, ...rest };

    for (const [name, options, where] of [
      ["desktop", DESKTOP, {}],
      ["phone", PHONE, { skip: leftOut(browser) }],
    ])
      test(`methods_and_delay_are_set_by_keys_and_their_errors_read_on_a_${name}`, where, async () => {
        const { page, errors, close } = await visitor.open("?scene=lab_latency&paused=1", sized(options));
        await page.waitForSelector("[data-readings=errors] dd");
        // No delay: every method is exact, and no packet is old.
        await page.focus("input[name=set-delay]");
        await page.keyboard.press("Home");
        for (let i = 0; i < 3; i++) await stepBy(page, 100);
        for (const method of ["Last known place", "Dead reckoning", "Swept prediction", "Rollback"])
          await until(() => reading(page, "errors", method), (value) => value === "0.00", method);
        assert.equal(await reading(page, "truth", "Newest packet"), "0 steps old");
        assert.equal(await reading(page, "errors", "Steps run again"), "0");
        // The whole delay, 400 ms: 24 steps, and errors near to those that were measured.
        await page.focus("input[name=set-delay]");
        await page.keyboard.press("End");
        for (let i = 0; i < 7; i++) await stepBy(page, 100);
        await until(() => reading(page, "truth", "Newest packet"), (value) => value === "24 steps old", "packet");
        const told = {};
        for (const method of ["Last known place", "Dead reckoning", "Swept prediction", "Rollback"])
          told[method] = Number(await reading(page, "errors", method));
        const { "Last known place": last, "Dead reckoning": reckoned, "Swept prediction": swept, Rollback: rollback } = told;
        assert.ok(last > swept && reckoned > swept && swept > rollback, JSON.stringify(told));
        assert.ok(Math.abs(last - MEASURED.last[4]) < 1, JSON.stringify(told));
        assert.equal(Number(await reading(page, "errors", "Drawn now")), reckoned);
        await page.focus("input[name=set-method]:checked");
        await page.keyboard.press("ArrowRight");
        await until(() => reading(page, "errors", "Drawn now"), (value) => Number(value) === swept, "drawn");
        assert.match(await page.innerText("#message"), /first wall/);
        if (browser === "chromium" && name === "desktop") await runAxeInBothThemes(page);
        assert.deepEqual(errors, []);
        await close();
      });
  });
