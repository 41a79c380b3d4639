/**
 * Tests the page zoomed, with the keyboard, for screen readers, on paper, and with high contrast.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  DESKTOP,
  failureText,
  openLevel,
  openVisitor,
  PHONE,
  runAxe,
  stepBy,
  untilRunning,
  untilTold,
} from "../support/page.mjs";
import { display } from "../support/contexts.mjs";
import { until, untilFigures, untilStill } from "../support/wait.mjs";

const visitor = openVisitor();

/** The viewport of a window of 1440 by 900 pixels at that zoom. */
const ZOOMED_TWICE = { viewport: { width: 720, height: 450 }, deviceScaleFactor: 2 };
const ZOOMED_FOUR_TIMES = { viewport: { width: 360, height: 225 }, deviceScaleFactor: 4 };
const SIZES = [
  ["page_zoomed_twice", ZOOMED_TWICE],
  ["page_zoomed_four_times", ZOOMED_FOUR_TIMES],
  ["small_lying_phone", { ...PHONE, viewport: { width: 640, height: 360 } }],
  ["small_tablet", { ...PHONE, viewport: { width: 768, height: 1024 } }],
];

async function open(search, options, prepare) {
  const opened = await visitor.open(`?scene=cradle&paused=1${search}`, options, prepare);
  const { page } = opened;
  await page.waitForFunction(() => document.title.endsWith(" · thud"));
  await untilFigures(page);
  if (search.includes("panel")) await page.waitForSelector("#dock-body > :not(.quiet)");
  await untilStill(page);
  return opened;
}

/** The controls that overlap each other or are outside of the window. */
function misplaced(page) {
  return page.evaluate(() => {
    const parts = [...document.querySelectorAll("#scenes-button, #hud, #rail > *, #controls")]
      .filter((element) => element.checkVisibility())
      .map((element) => {
        const { left, top, right, bottom } = element.getBoundingClientRect();
        return { name: element.id || element.innerText, left, top, right, bottom };
      });
    const outside = parts.filter(
      ({ left, top, right, bottom }) =>
        left < 0 || top < 0 || right > innerWidth || bottom > innerHeight,
    );
    const onOthers = parts.filter((a, i) => parts.slice(i + 1).some((b) =>
      Math.min(a.right, b.right) - Math.max(a.left, b.left) > 0.5 &&
      Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 0.5));
    return [...outside, ...onOthers].map(({ name }) => name);
  });
}

for (const [size, options] of SIZES)
  test(`controls_on_a_${size}_lie_in_sight_and_leave_the_scene_visible`, async () => {
    const { page, errors, close } = await open("", options);
    assert.deepEqual(await misplaced(page), []);
    const free = await page.evaluate(() => {
      const box = (selector) => document.querySelector(selector).getBoundingClientRect();
      return (box("#controls").top - box("#hud").bottom) / innerHeight;
    });
    assert.ok(free > 0.3, `the scene has ${free} of the height`);
    const scrolls = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    assert.equal(scrolls, 0);
    assert.deepEqual(errors, []);
    await close();
  });

test("scene_that_waits_for_who_wants_less_motion_says_so_and_how_it_runs", async () => {
  const still = { ...DESKTOP, reducedMotion: "reduce" };
  const { page, errors, close } = await visitor.open("?scene=cradle", still);
  await page.waitForSelector('#notice:has-text("press Play")');
  await until(
    () => page.textContent("#state"),
    (text) => /not begun: Space/.test(text) && !/asleep|overlap/.test(text),
    "words for who does not see it",
  );
  await page.click("#pause");
  await untilRunning(page);
  await page.waitForSelector("#notice", { state: "hidden" });
  await until(() => page.textContent("#state"), (text) => /running at/.test(text), "it runs");
  assert.deepEqual(errors, []);
  await close();
});

/** Whether two boxes overlap. */
const meet = (a, b) =>
  a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;

for (const [size, options] of [
  ["small_window", { viewport: { width: 800, height: 600 } }],
  ["page_zoomed_twice", ZOOMED_TWICE],
])
  test(`games_in_a_${size}_keep_their_buttons_and_titles`, async () => {
    const artillery = await visitor.open("?scene=artillery&paused=1", options);
    await stepBy(artillery.page, 1);
    await artillery.page.waitForSelector("#notice:not([hidden])");
    await untilStill(artillery.page);
    const notice = await artillery.page.locator("#notice").boundingBox();
    const message = await artillery.page.locator("#message").boundingBox();
    const { width, height } = options.viewport;
    // The two buttons are painted into the scene, left and right of its centre, in the upper half.
    const buttons = { x: 0.2 * width, y: message.y + message.height + 20, width: 0.6 * width };
    assert.ok(!meet(notice, { ...buttons, height: 0.5 * height - buttons.y }), "the notice is over them");
    await artillery.close();
    const { page, close } = await visitor.open("?scene=bridge_builder&paused=1", options);
    await stepBy(page, 1);
    await page.waitForSelector("#hud .gap:not([hidden])");
    const cut = await page.$eval("#scene-title", (title) => title.scrollWidth - title.clientWidth);
    assert.ok(cut <= 0, `the title is cut by ${cut} pixels`);
    await close();
  });

test("full_screen_and_the_whole_scene_are_two_buttons", async () => {
  const { page, close } = await open("", DESKTOP);
  const paths = await page.$$eval("#fit svg, #full svg", (icons) => icons.map((icon) => icon.innerHTML));
  assert.notEqual(paths[0], paths[1]);
  await page.click("#full");
  await page.waitForSelector("#full[aria-pressed=true]");
  assert.ok(await page.evaluate(() => document.fullscreenElement === document.documentElement));
  await page.click("#full");
  await page.waitForSelector("#full[aria-pressed=false]");
  await close();
});

/** The names of all elements that Tab reaches from the scene until it returns to the scene. */
async function tabAround(page) {
  const names = [];
  await page.focus("#overlay");
  for (let presses = 0; presses < 60; presses++) {
    await page.keyboard.press("Tab");
    // A row that scrolls is in place two animation frames later.
    const stop = await page.evaluate(async () => {
      await new Promise(requestAnimationFrame);
      await new Promise(requestAnimationFrame);
      const element = document.activeElement;
      if (element === document.body) return null;
      const label = element.closest(".choices label");
      const ring = getComputedStyle(label ? label.querySelector("span") : element);
      const { left, top, width, height } = (label ?? element).getBoundingClientRect();
      const above = document.elementFromPoint(left + width / 2, top + height / 2);
      return {
        name: element.ariaLabel || element.name || element.id || element.textContent,
        seen: element.contains(above) || Boolean(label?.contains(above)),
        ringed: ring.outlineStyle !== "none" && parseFloat(ring.outlineWidth) >= 2,
      };
    });
    if (stop === null) return names;
    assert.ok(stop.seen, `“${stop.name}” has the focus and lies under something else`);
    assert.ok(stop.ringed, `“${stop.name}” has the focus and does not show it`);
    names.push(stop.name);
  }
  return assert.fail("Tab does not come around");
}

for (const [size, options] of [["page_zoomed_four_times", ZOOMED_FOUR_TIMES], ["phone", PHONE]])
  test(`tab_on_a_${size}_reaches_everything_and_always_in_sight`, async () => {
    const { page, close } = await open("&panel=trade", options);
    const names = await tabAround(page);
    for (const name of ["Close the panel", "quality", "substeps", "broadphase", "rate"])
      assert.ok(names.includes(name), `${name} is not reached: ${names}`);
    await page.keyboard.press("Escape");
    await page.waitForSelector("#dock", { state: "hidden" });
    assert.ok((await tabAround(page)).includes("Show the whole scene"));
    assert.deepEqual(await runAxe(page), []);
    await close();
  });

test("focus_returns_to_where_it_was_when_panel_or_hint_closes", async () => {
  const { page, close } = await open("");
  const focused = (selector) =>
    page.waitForFunction((wanted) => document.activeElement.matches(wanted), selector);
  await page.focus("#overlay");
  await page.keyboard.press("o");
  await focused("#dock-title");
  await page.keyboard.press("Escape");
  await focused("#overlay");
  await page.focus("[data-panel=options]");
  await page.keyboard.press("Enter");
  await focused("#dock-title");
  await page.keyboard.press("Tab");
  await focused("#dock .close");
  await page.keyboard.press("Enter");
  await focused("[data-panel=options]");
  // A focus that is elsewhere stays there.
  await page.keyboard.press("Enter");
  await focused("#dock-title");
  await page.focus("#restart");
  await page.keyboard.press("Escape");
  await page.waitForSelector("#dock", { state: "hidden" });
  await focused("#restart");
  await page.focus("#hint .close");
  await page.keyboard.press("Enter");
  await focused("#overlay");
  await close();
});

test("failure_comes_over_an_open_dialog_and_gives_the_focus_back", async () => {
  const { page, close } = await open("");
  await page.focus("#restart");
  await page.keyboard.press("h");
  await page.waitForSelector("#help[open]");
  await openLevel(page, "broken.tmj", "{");
  assert.match(await failureText(page), /not JSON/);
  assert.equal(await page.locator("#help").isVisible(), false);
  await page.waitForFunction(() => document.activeElement.closest("#failure"));
  const described = await page.getAttribute("#failure", "aria-describedby");
  assert.match(await page.innerText(`#${described}`), /not JSON/);
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => document.activeElement.id === "restart");
  await close();
});

test("running_scene_says_nothing_by_itself_and_what_is_noticed_is_said", async () => {
  // A slow machine would make the page report slow motion: this display waits for it.
  const { page, close } = await open("", DESKTOP, display(60));
  // The scene's description is announced once, after the first frame.
  await untilTold(page, "As many balls leave");
  await page.evaluate(() => {
    window.changes = [];
    const live = "[aria-live], [role=status], [role=log], [role=alert], output";
    for (const region of document.querySelectorAll(live))
      new MutationObserver(() => window.changes.push(region.id || region.className))
        .observe(region, { childList: true, characterData: true, subtree: true });
  });
  await page.click("#pause");
  await page.waitForFunction(() => Number(document.querySelector("#hud").dataset.steps) > 20);
  assert.deepEqual(await page.evaluate(() => window.changes), ["status"], "only that it runs");
  await page.keyboard.press("]");
  await page.keyboard.press("]");
  const said = await page.locator("#status p").allInnerTexts();
  assert.deepEqual(said.slice(-3), ["Running", "Speed 2×", "Speed 4×"]);
  await close();
});

test("overlays_have_short_names_and_their_explanation_as_description", async () => {
  const { page, close } = await open("&panel=inside");
  const box = page.getByRole("checkbox", { name: "Grid cells", exact: true });
  const about = await box.getAttribute("aria-describedby");
  assert.match(await page.innerText(`#${about}`), /Cells of the grid/);
  await close();
});

test("reader_s_own_text_size_enlarges_controls_with_it", async () => {
  const { page, close } = await open("&panel=options", { viewport: { width: 2160, height: 1350 } });
  const sizes = () => page.evaluate(() =>
    ["#rail span", "#hud dd", "#dock legend", "#dock .choices", "#time-label"].map((selector) => {
      const element = document.querySelector(selector);
      return [parseFloat(getComputedStyle(element).fontSize), element.clientHeight];
    }));
  const before = await sizes();
  await page.evaluate(() => {
    const style = new CSSStyleSheet();
    // 93.75 % instead of the usual 62.5 %: half as large again.
    style.replaceSync(":root { font-size: 93.75% }");
    document.adoptedStyleSheets.push(style);
    dispatchEvent(new Event("resize"));
  });
  for (const [i, [text, height]] of (await sizes()).entries()) {
    assert.ok(text > 1.45 * before[i][0], `text ${i}: ${text} after ${before[i][0]}`);
    assert.ok(height >= 1.2 * before[i][1], `box ${i}: ${height} after ${before[i][1]}`);
  }
  assert.deepEqual(await misplaced(page), []);
  await close();
});

test("forced_colours_and_more_contrast_show_what_is_chosen", async () => {
  // With reduced motion, colours change without a transition.
  const { page, close } = await open("&panel=options", { ...DESKTOP, reducedMotion: "reduce" });
  const ground = (selector) =>
    page.evaluate((one) => getComputedStyle(document.querySelector(one)).backgroundColor, selector);
  assert.match(await ground("#dock"), /rgba|\/ 0/, "panels let the scene through as a rule");
  await page.emulateMedia({ contrast: "more" });
  assert.match(await ground("#dock"), /^rgb\(\d+, \d+, \d+\)$/);
  await page.emulateMedia({ contrast: "no-preference", forcedColors: "active" });
  assert.notEqual(await ground("button[data-tool=hand]"), await ground("button[data-tool=box]"));
  assert.notEqual(await ground("[data-panel=options]"), await ground("[data-panel=code]"));
  const [on, off] = ["#dock :checked + span", "#dock :not(:checked) + span"];
  assert.notEqual(await ground(on), await ground(off));
  await close();
});

test("paper_shows_the_picture_with_its_words_and_no_controls", async () => {
  const { page, close } = await open("&panel=options", { ...DESKTOP, colorScheme: "dark" });
  await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
  await page.emulateMedia({ media: "print" });
  assert.equal(await page.getAttribute("html", "data-theme"), "light");
  for (const part of ["#controls", "#rail", "#dock", "#hud"])
    assert.equal(await page.locator(part).isVisible(), false, part);
  const { width, height } = await page.locator("#bodies").boundingBox();
  assert.ok(Math.abs(width / height - 1440 / 900) < 0.01, `${width} by ${height}`);
  const words = await page.locator("#state").boundingBox();
  assert.ok(words.y >= height && words.width > 100, JSON.stringify(words));
  await page.evaluate(() => dispatchEvent(new Event("afterprint")));
  assert.equal(await page.getAttribute("html", "data-theme"), "dark");
  await close();
});
