/**
 * Tests the part Contacts of the panel Inside: its list, and the numbers and pictures of the
 * microscope, against figures worked out here.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { DESKTOP, near, openVisitor, PHONE, runAxeInBothThemes, stepBy } from "../support/page.mjs";
import { listed, openPanel, show } from "../support/inside.mjs";
import { until } from "../support/wait.mjs";

const SIZES = [["desktop", DESKTOP], ["phone", PHONE]];
const visitor = openVisitor();

/** Steps after which the balls that meet head on have met, in the scene as it begins. */
const MET = 20;

/** Opens the laboratory scene with the contact of the head-on balls in the microscope, by key. */
async function openHeadOn(options) {
  const opened = await openPanel(visitor, "contacts", "scene=lab_microscope&paused=1", options);
  const { page } = opened;
  await page.waitForSelector(".inside [role=status]:not(:empty)");
  // The first collision is that of the light ball, which begins on the ground.
  await page.focus("#next-contact");
  for (let i = 0; i < 2; i++) {
    const before = await page.textContent(".inside [role=status]");
    await page.keyboard.press("Enter");
    await until(
      () => page.textContent(".inside [role=status]"),
      (text) => text !== before,
      "the next collision",
    );
  }
  const button = page.locator("#contacts button").first();
  await button.focus();
  await page.keyboard.press("Enter");
  // The strongest new contact is opened without being asked for, but keeps the focus where it is.
  await until(
    () => page.evaluate(() => document.activeElement.tagName),
    (tag) => tag === "H3",
    "the focus at the head of the microscope",
  );
  return opened;
}

for (const [size, options] of SIZES)
  test(`head_on_collision_is_taken_apart_by_key_on_a_${size}`, async () => {
    const { page, errors, close } = await openHeadOn(options);
    // Two balls of radius 0.6 at 6 m/s each, the right one three times as dense, e = 0.5.
    const light = Math.PI * 0.36;
    const k = 1 / light + 1 / (3 * light);
    const j = (1.5 * 12) / k;
    const formula = await listed(page, "#scope-formula");
    const result = (name) => {
      const text = formula[Object.keys(formula).find((key) => key.startsWith(name))];
      return Number(text.split("=").at(-1));
    };
    near(result("v_n ="), -12, 0.01, "v_n");
    near(result("k ="), k, 0.001, "k");
    near(result("j ="), j, 0.01, "j");
    near(result("v_n′"), 6, 0.01, "v_n after");
    const rows = await page.$$eval("#scope-velocities tbody tr", (found) =>
      found.map((row) => [...row.cells].map((cell) => cell.textContent)),
    );
    const speeds = Object.fromEntries(rows.map(([name, ...cells]) => [name, cells.map(parseFloat)]));
    near(speeds.v_n[0], -12, 0.01, "before");
    near(speeds.v_n[1], 6, 0.01, "the engine's, after");
    for (const column of [1, 2]) {
      near(speeds.v_a[column], 6 - j / light, 0.01, "a after");
      near(speeds.v_b[column], -6 + j / (3 * light), 0.01, "b after");
    }
    // They meet after 3.8 m at 12 m/s: after exactly 19 steps.
    const pictures = await page.$$eval("#scope-pictures li", (items) => items.map((item) => item.textContent));
    assert.equal(pictures.length, 5);
    assert.match(pictures[2], /v_n from -12.00 to 6.000/);
    const sizes = await page.$$eval("#scope-pictures svg[role=img]", (found) =>
      found.map((one) => one.getBoundingClientRect()).map(({ width, height }) => [width, height]),
    );
    assert.equal(sizes.length, 5);
    for (const [width, height] of sizes) {
      assert.ok(width > 100, `${width}`);
      near(height, width, 1, "pictures are square");
    }
    const wide = await page.evaluate(() => {
      const body = document.querySelector("#dock-body");
      return body.scrollWidth - body.clientWidth;
    });
    assert.ok(wide <= 0, `${wide} px wider than the panel`);
    assert.deepEqual(errors, []);
    await close();
  });

for (const [size, options] of SIZES)
  test(`laboratory_scene_opens_at_its_contacts_and_takes_the_next_one_apart_on_a_${size}`, async () => {
    const { page, errors, close } = await visitor.open("?scene=lab_microscope&paused=1", options);
    await page.click("#next-contact");
    await page.waitForSelector("#scope-meeting > div");
    const [first] = await page.locator("#contacts tbody button").allTextContents();
    const [, a, b] = /^(\d+) and (\d+), new$/.exec(first);
    assert.match(await page.textContent("#microscope h3"), new RegExp(`^Bodies ${a} \\(a\\) and ${b} \\(b\\)`));
    const rows = await listed(page, "#scope-meeting");
    const normal = rows["normal n, from a to b"].split(", ").map(Number);
    near(Math.hypot(...normal), 1, 1e-3, "the normal");
    // An overlap that is there already is that of the step before.
    const came = "gap before the step" in rows ? "the step" : "the step before";
    assert.match(await page.textContent("#scope-pictures li"), new RegExp(`At the end of ${came} they are `));
    const order = await page.evaluate(() =>
      ["#scope-meeting", "#scope-pictures", "#scope-formula", "#scope-velocities"].map(
        (selector) => document.querySelector(selector).getBoundingClientRect().top,
      ),
    );
    assert.deepEqual(order, [...order].sort((one, other) => one - other), "pictures before formulas");
    assert.deepEqual(errors, []);
    await close();
  });

test("scene_goes_on_from_where_it_was_taken_apart", async () => {
  const hashOf = async (page) => {
    await show(page, "bits");
    await page.waitForSelector("#hash-now > div");
    return until(() => listed(page, "#hash-now"), ({ step }) => step === String(MET + 10), "the hash");
  };
  const { page, errors, close } = await openHeadOn(DESKTOP);
  const step = Number(/Step (\d+)/.exec(await page.textContent(".inside [role=status]"))[1]);
  await stepBy(page, MET + 10 - step);
  const after = await hashOf(page);
  await close();
  const plain = await openPanel(visitor, "contacts", "scene=lab_microscope&paused=1", DESKTOP);
  await stepBy(plain.page, MET + 10);
  assert.deepEqual(await hashOf(plain.page), after);
  assert.deepEqual(errors, []);
  await plain.close();
});

test("list_follows_the_step_and_can_be_of_one_body", async () => {
  const search = "scene=tall_stack&paused=1";
  const { page, errors, close } = await openPanel(visitor, "contacts", search, DESKTOP);
  await stepBy(page, 5);
  const count = (least) =>
    until(() => page.locator("#contacts tbody tr").count(), (rows) => rows >= least, "contacts");
  const all = await count(3);
  const impulses = await page.$$eval("#contacts td:last-child", (cells) =>
    cells.map((cell) => Number(cell.textContent)),
  );
  assert.deepEqual(impulses, [...impulses].sort((a, b) => b - a));
  assert.ok(await page.isDisabled("[name=contacts-only]"));
  await page.focus("#overlay");
  await page.keyboard.press("q");
  await page.waitForSelector("text=Let go of it");
  await show(page, "contacts");
  await page.check("[name=contacts-only]");
  await until(
    () => page.locator("#contacts tbody tr").count(),
    (rows) => rows > 0 && rows < all,
    "fewer contacts",
  );
  assert.deepEqual(errors, []);
  await close();
});

for (const [size, options] of SIZES)
  test(`axe_finds_no_serious_violation_in_the_microscope_on_a_${size}`, async () => {
    const { page, close } = await openHeadOn(options);
    assert.deepEqual(await runAxeInBothThemes(page, "#dock"), []);
    await close();
  });
