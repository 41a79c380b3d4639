/** Tests the advice below a measured series in the panel Trade. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { BROWSERS, DESKTOP, leftOut, openVisitor, PHONE, runAxeInBothThemes, untilRunning } from "../support/page.mjs";

const visitor = openVisitor();

/** A measurement of two engines takes minutes on a slow machine. */
const LONG = { timeout: 300_000 };
const MEASURE = "[aria-labelledby=measure-heading]";

/** The rows of thud in the table: setting, ms, p99, worst, mean. */
async function rowsOf(page) {
  const rows = await page
    .locator(".result tbody tr.thud")
    .evaluateAll((all) => all.map((row) => [...row.children].map((cell) => cell.textContent)));
  return rows.map(([label, ms, , worst]) => ({
    label,
    ms: Number(ms),
    worst: worst === "none" ? 0 : Number(worst),
  }));
}

/** Checks that the text advises what follows from the table, whose figures are rounded. */
async function checkAdvice(page, maxError, budget) {
  const rows = await rowsOf(page);
  assert.equal(rows.length, 7);
  const text = await page.innerText(".advised");
  const meeting = rows.filter(({ ms, worst }) => worst <= maxError && ms <= budget);
  if (meeting.length === 0) {
    assert.match(text, /^No setting keeps to/);
    return;
  }
  const [, label, error, ms] = /^(.*) is the cheapest that keeps to (\S+) length scales: (\S+) ms/.exec(text);
  assert.equal(Number(error), maxError);
  const advised = rows.find((row) => row.label === label);
  assert.ok(meeting.includes(advised), `${label}: ${JSON.stringify(rows)}`);
  assert.equal(Number(ms), advised.ms);
  assert.ok(meeting.every((row) => row.ms >= advised.ms), JSON.stringify(rows));
  assert.equal(await page.innerText("#advice-take"), `Run ${label}`);
}

for (const browser of BROWSERS)
  test(
    `advice_follows_from_the_table_and_the_slider_and_runs_by_keys_in_${browser}`,
    { skip: leftOut(browser), ...LONG },
    async () => {
      const { page, errors, close } = await openVisitor({ browser }).open(
        "?scene=tall_stack&size=12&panel=trade",
        PHONE,
      );
      await untilRunning(page);
      await page.focus(`${MEASURE} .go`);
      await page.keyboard.press("Enter");
      await page.waitForSelector(".advice", LONG);
      await checkAdvice(page, 0.005, 1000 / 60);
      const used = await page.innerText("#advice-uses");
      assert.match(used, /0 circles, 1 upright boxes \(AABBs\), 12 oriented boxes \(OBBs\), 0 grounds/);
      assert.match(used, /Of 12 moving bodies 0 turned \(0 with an oriented box\), 0 bounced, 12 fell asleep/);
      await page.focus("#advice-error");
      await page.keyboard.press("Home");
      await checkAdvice(page, 0.05, 1000 / 60);
      await page.keyboard.press("End");
      await checkAdvice(page, 0.001, 1000 / 60);
      assert.match(await page.innerText("#advice-room"), /overlap has|time has|speed has|Beyond its room/);
      await page.focus("#advice-take");
      await page.keyboard.press("Enter");
      await page.waitForFunction(() => /quality=|substeps=/.test(location.search));
      assert.deepEqual(errors, []);
      await close();
    },
  );

test("advice_comes_with_a_link_and_is_accessible", LONG, async () => {
  const { page, close } = await visitor.open("?scene=cradle&size=4&panel=trade", DESKTOP);
  await untilRunning(page);
  await page.click(`${MEASURE} .go`);
  await page.waitForSelector(".advice", LONG);
  assert.deepEqual(await runAxeInBothThemes(page), []);
  const link = await page.getAttribute("#result-link[href]", "href");
  const other = await visitor.open(new URL(link).search + new URL(link).hash, PHONE);
  await other.page.waitForSelector(".advice");
  await checkAdvice(other.page, 0.005, 1000 / 60);
  // What the scene used is not in the link.
  assert.equal(await other.page.locator("#advice-uses").count(), 0);
  await other.close();
  await close();
});
