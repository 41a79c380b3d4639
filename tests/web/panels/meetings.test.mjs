/**
 * Tests the table of rules between categories in the panel Values: by mouse, by keys, and with its
 * announcements for screen readers.
 */
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { DESKTOP, openVisitor, runAxeInBothThemes } from "../support/page.mjs";
import { until } from "../support/wait.mjs";

describe("chromium", () => {
  const visitor = openVisitor();

  test("buttons_of_the_table_take_the_next_word_and_say_so", async () => {
    const { page, close } = await visitor.open("?scene=meetings&size=16&paused=1", DESKTOP);
    await page.waitForSelector(".matrix button");
    assert.equal(await page.locator(".matrix button").count(), 10);
    const told = (title) =>
      page.evaluate((start) => {
        const all = [...document.querySelectorAll(".matrix button")];
        const one = all.find((button) => button.ariaLabel.startsWith(start));
        return `${one.ariaLabel} ${one.ariaPressed}`;
      }, title);
    const press = async (title, wanted) => {
      await page.locator(`.matrix button[aria-label^="${title}"]`).press("Enter");
      await until(() => told(title), (text) => text === `${title}: ${wanted}`, wanted);
    };
    assert.equal(await told("Orange and Blue"), "Orange and Blue: ignore true");
    await press("Orange and Blue", "one way mixed");
    await press("Orange and Blue", "collide false");
    await press("Blue among itself", "ignore true");
    await press("Blue among itself", "collide false");
    assert.deepEqual(await runAxeInBothThemes(page), []);
    await close();
  });
});
