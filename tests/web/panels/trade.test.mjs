/**
 * Tests the panel Trade: its settings, the chart of time and overlap, the measured series, and the
 * search for the largest size at full speed.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  choose,
  DESKTOP,
  openVisitor,
  PHONE,
  pressed,
  runAxeInBothThemes,
  stepBy,
  untilRunning,
} from "../support/page.mjs";
import { until, untilStep } from "../support/wait.mjs";

const visitor = openVisitor();

/** For measurements of two engines at many sizes, which take minutes on a slow machine. */
const LONG = { timeout: 300_000 };

async function openTrade(search, options = DESKTOP) {
  const opened = await visitor.open(`${search}&panel=trade`, options);
  await opened.page.waitForSelector(".trade");
  return opened;
}

async function pressOn(page, selector, key) {
  await page.focus(selector);
  await page.keyboard.press(key);
}

function untilAddress(page, name, value) {
  return page.waitForFunction(
    ([key, wanted]) => new URLSearchParams(location.search).get(key) === wanted,
    [name, value],
  );
}

/** Waits until a running scene has made `steps` more steps. */
async function untilLater(page, steps) {
  const before = await page.evaluate(() => Number(document.querySelector("#hud").dataset.steps));
  await page.waitForFunction(
    (wanted) => Number(document.querySelector("#hud").dataset.steps) >= wanted,
    before + steps,
  );
}

/**
 * Waits until a figure is within bounds; "< 0.0001" is read as 0.0001. Figures are refreshed a few
 * times per second.
 */
function untilFigure(page, name, least, most) {
  return page.waitForFunction(
    ([key, from, to]) => {
      const { textContent } = document.querySelector(`[data-value="${key}"]`);
      const value = Number(textContent.replace(/[,< ]/g, ""));
      return value >= from && value <= to;
    },
    [name, least, most],
  );
}

test("quality_chosen_in_a_running_scene_changes_its_error_and_the_url", async () => {
  const { page, errors, close } = await openTrade("?scene=tall_stack&paused=1&quality=draft");
  await stepBy(page, 40);
  await untilFigure(page, "deepest", 0.005, 1);
  await choose(page, "quality", "high");
  await untilAddress(page, "quality", "high");
  await stepBy(page, 40);
  await untilFigure(page, "deepest", 0, 0.001);
  await untilStep(page, 80);
  assert.deepEqual(errors, []);
  await close();
});

test("steps_made_at_once_leave_their_point_although_nothing_follows_them", async () => {
  const { page, close } = await openTrade("?scene=tall_stack&paused=1");
  await stepBy(page, 30);
  await page.waitForSelector(".live-plane >> text=/ms a step, worst overlap/");
  await close();
});

test("substeps_and_largest_error_by_keys_are_in_the_url_and_change_the_error", async () => {
  const { page, errors, close } = await openTrade("?scene=tall_stack&paused=1&quality=draft");
  assert.ok(await page.isDisabled("#max-error"), "draft holds no largest error");
  await pressOn(page, "#substeps", "End");
  await untilAddress(page, "substeps", "64");
  await stepBy(page, 40);
  await untilFigure(page, "deepest", 0, 0.002);
  await choose(page, "quality", "default");
  await pressOn(page, "#max-error", "End");
  await untilAddress(page, "error", "0.001");
  assert.match(await page.innerText(".trade-controls"), /0\.001 length scales/);
  assert.deepEqual(errors, []);
  await close();
});

test("draft_with_a_largest_error_runs_without_it", async () => {
  const search = "?scene=tall_stack&error=0.01&quality=draft&paused=1";
  const { page, errors, close } = await openTrade(search);
  await stepBy(page, 3);
  await choose(page, "quality", "default");
  await stepBy(page, 3);
  await choose(page, "quality", "draft");
  await page.keyboard.press("r");
  await untilStep(page, 0);
  await stepBy(page, 3);
  assert.ok(await page.isHidden("#failure"));
  assert.doesNotMatch(await page.innerText("#notice"), /stopped/);
  assert.deepEqual(errors, []);
  await close();
});

for (const [name, value] of [["detection", "swept"], ["broadphase", "sweep"]])
  test(`${name}_starts_the_scene_anew_and_is_in_the_url`, async () => {
    const { page, errors, close } = await openTrade("?scene=cradle&paused=1");
    await stepBy(page, 3);
    await choose(page, name, value);
    await untilAddress(page, name, value);
    await untilStep(page, 0);
    assert.deepEqual(errors, []);
    await close();
  });

test("trade_tells_what_detection_missed_since_the_start_and_what_bisection_costs", async () => {
  const { page, errors, close } = await openTrade("?scene=bullets&size=3&detection=bisect&paused=1");
  assert.ok(await page.isHidden("#detection-count"));
  await stepBy(page, 5);
  await page.waitForSelector("#detection-count:has-text('faster than bisection’s limit of 1.20 a second')");
  // Costs are measured on this device; no text may state a cost measured on another one.
  for (const value of ["overlap", "continuous", "bisect", "swept", "auto"]) {
    const title = await page.getAttribute(`label:has(> [name="detection"][value="${value}"])`, "title");
    assert.doesNotMatch(title, /\d+(\.\d+)? times/, value);
  }
  await choose(page, "detection", "overlap");
  await page.waitForSelector("#detection-count", { state: "hidden" });
  assert.deepEqual(errors, []);
  await close();
});

test("bound_of_bisection_is_that_of_the_chosen_speed_and_step_rate_and_red_where_broken", async () => {
  const { page, errors, close } = await openTrade("?scene=bullets&size=3&paused=1");
  const bound = "#bisection-bound";
  await page.waitForSelector(`${bound}:has-text("sure up to 1.2 a second")`);
  await page.fill("#step-rate", "5");
  await page.dispatchEvent("#step-rate", "change");
  await untilAddress(page, "rate", "120");
  // The walls are 0.02 thick, and the step is 1/120 s.
  await page.waitForSelector(`${bound}:has-text("sure up to 2.4 a second")`);
  for (const [place, speed] of [["1", 1], ["2", 2]]) {
    await page.fill("#top-speed", place);
    await page.dispatchEvent("#top-speed", "change");
    await untilAddress(page, "top", String(speed));
    const broken = Math.SQRT2 * speed >= 2.4;
    await page.waitForSelector(`${bound}${broken ? ".broken" : ":not(.broken)"}:has-text("${broken ? "Broken" : "Kept"}")`);
    const product = String(Number(((Math.SQRT2 * speed) / 120).toPrecision(3)));
    assert.ok((await page.innerText(bound)).includes(`= ${product} `), product);
  }
  assert.deepEqual(errors, []);
  await close();
});

test("limit_of_bisection_that_comes_later_than_the_text_is_told_too", async () => {
  const late = (opening) =>
    opening.addInitScript(() => {
      const { Worker: Real } = window;
      window.Worker = class extends Real {
        postMessage(message) {
          if (message.name === "bisectionLimit") this.late = message.id;
          super.postMessage(message);
        }
        set onmessage(listener) {
          super.onmessage = (event) => {
            const isLate = event.data.kind === "answer" && event.data.id === this.late;
            setTimeout(() => listener(event), isLate ? 2000 : 0);
          };
        }
      };
    });
  const search = "?scene=bullets&size=3&detection=bisect&paused=1&panel=trade";
  const { page, errors, close } = await visitor.open(search, DESKTOP, late);
  await stepBy(page, 5);
  await page.waitForSelector("#detection-count:has-text('limit of 1.20 a second')");
  assert.deepEqual(errors, []);
  await close();
});

test("size_by_the_slider_starts_the_scene_with_as_many_bodies", async () => {
  const { page, errors, close } = await openTrade("?scene=cradle&paused=1", PHONE);
  await stepBy(page, 3);
  await untilFigure(page, "bodies", 17, 17);
  await pressOn(page, "#size", "End");
  await untilAddress(page, "size", "100");
  await untilStep(page, 0);
  assert.match(await page.innerText(".trade-controls"), /100 balls in a row/);
  await page.setViewportSize(DESKTOP.viewport);
  await untilFigure(page, "bodies", 302, 302);
  assert.deepEqual(errors, []);
  await close();
});

/**
 * Runs a stack that is awake for only about a second; the panel is open first so that it sees all
 * steps.
 */
async function runStack() {
  const opened = await openTrade("?scene=tall_stack&paused=1");
  await opened.page.click("#pause");
  return opened;
}

test("each_setting_leaves_its_point_and_a_click_goes_back_to_it", async () => {
  const { page, errors, close } = await runStack();
  await page.waitForSelector('.live-plane .dot[aria-label^="default:"]');
  await choose(page, "quality", "draft");
  await page.waitForSelector('.live-plane .dot[aria-label^="draft:"]');
  await page.click(".tried summary");
  assert.equal(await page.locator(".tried tbody tr").count(), 2);
  // Figures are refreshed a few times per second, also while the pointer is over the point or
  // pressed.
  const point = page.locator('.live-plane .dot[aria-label^="default:"] .reach');
  const detail = () => page.innerText(".live-plane .plane-detail");
  const pointAt = async () => {
    const { x, y, width, height } = await point.boundingBox();
    await page.mouse.move(x + width / 2, y + height / 2);
    return detail();
  };
  const told = (text) => /^default: .* a step, worst/.test(text);
  await until(pointAt, told, "told of the point");
  await untilLater(page, 30);
  assert.match(await detail(), /^default: /);
  // A change of the scales may have moved the point, and may do so again before the press.
  const pressOnPoint = async () => {
    await page.mouse.up();
    await pointAt();
    await page.mouse.down();
    return page.locator('.live-plane .dot[aria-label^="default:"]:active').count();
  };
  await until(pressOnPoint, (pressed) => pressed === 1, "the press misses the point");
  await untilLater(page, 30);
  await page.mouse.up();
  await page.waitForFunction(() => !location.search.includes("quality"));
  assert.ok(await page.isChecked('.trade [name=quality][value="default"]'));
  assert.deepEqual(errors, []);
  await close();
});

test("box2d_leaves_its_point_beside_thuds_while_it_is_wanted", async () => {
  // The tumbler never sleeps: steps in which either engine sleeps give no point.
  const { page, errors, close } = await openTrade("?scene=tumbler&size=60");
  await page.waitForSelector(".live-plane .dot.thud", LONG);
  assert.equal(await page.locator(".live-plane .dot.box2d").count(), 0);
  await page.check("#trade-box2d");
  await page.waitForSelector('.live-plane .dot.box2d[aria-label^="Box2D 4:"]', LONG);
  await page.click(".tried summary");
  const figures = () => page.locator(".tried tr.box2d td").allTextContents();
  const both = ([time, , worst]) => Number(time) > 0 && Number(worst) > 1e-4;
  await until(figures, both, "time and worst overlap of Box2D");
  await page.uncheck("#trade-box2d");
  assert.deepEqual(errors, []);
  await close();
});

test("points_are_one_stop_of_the_tab_key_and_arrows_go_between_them", async () => {
  const { page, close } = await runStack();
  await page.waitForSelector(".live-plane .dot");
  await choose(page, "quality", "draft");
  await page.waitForSelector('.live-plane .dot[aria-label^="draft:"]');
  await page.click("#pause");
  assert.equal(await page.locator('.live-plane .dot[tabindex="0"]').count(), 1);
  await page.focus('.live-plane .dot[tabindex="0"]');
  const focused = () => page.evaluate(() => document.activeElement.dataset.point);
  const first = await focused();
  await page.keyboard.press("ArrowRight");
  assert.notEqual(await focused(), first);
  await page.keyboard.press("ArrowRight");
  assert.equal(await focused(), first);
  await close();
});

const cells = (page) =>
  page.locator(".result tbody tr").evaluateAll((rows) => rows.map((row) => row.innerText));

// Selectors of two sections of the panel: the measured series, and the search for the largest size.
const MEASURE = "[aria-labelledby=measure-heading]";
const HEAVIER = "[aria-labelledby=heavier-heading]";

test("measure_compares_both_engines_and_its_link_shows_the_same_figures", async () => {
  const { page, errors, close } = await openTrade("?scene=cradle&size=4");
  await untilRunning(page);
  await page.click(`${MEASURE} .go`);
  await page.waitForSelector(".result table", LONG);
  const measured = await cells(page);
  assert.equal(measured.length, 14);
  assert.equal(measured.filter((row) => row.startsWith("Box2D")).length, 7);
  // Circles in a row touch and hardly overlap: thud's bounce before they overlap, Box2D's after.
  assert.ok(measured.some((row) => row.startsWith("Box2D") && !/none\s+none/.test(row)), measured.join());
  assert.equal(await pressed(page, "pause"), false);
  const download = page.waitForEvent("download");
  await page.click("#result-download");
  assert.equal((await download).suggestedFilename(), "thud-trade.json");
  const link = await page.getAttribute("#result-link[href]", "href");
  const other = await visitor.open(new URL(link).search + new URL(link).hash, PHONE);
  await other.page.waitForSelector(".result table");
  assert.deepEqual(await cells(other.page), measured);
  assert.match(await other.page.innerText(".result"), /Measured elsewhere: .*nobody has checked/);
  assert.deepEqual([...errors, ...other.errors], []);
  await other.close();
  await close();
});

test("without_Box2D_thud_is_measured_alone_and_told_so", async () => {
  const search = "?scene=cradle&size=4&panel=trade";
  const { page, close } = await visitor.open(search, DESKTOP, async (opened) => {
    await opened.context().route(/Box2D.*\.wasm/, (route) => route.abort());
  });
  await untilRunning(page);
  await page.click(`${MEASURE} .go`);
  await page.waitForSelector(".result table", LONG);
  assert.equal((await cells(page)).length, 7);
  assert.match(await page.innerText(`${MEASURE} .work`), /Without Box2D\. Box2D could not be loaded/);
  await close();
});

/** So large that no machine finishes the measurement before the test cancels it. */
const LONG_TO_MEASURE = "?scene=pyramid&size=100";

test("another_scene_ends_a_measurement", async () => {
  const { page, errors, close } = await openTrade(`${LONG_TO_MEASURE}&paused=1`);
  await stepBy(page, 1);
  await page.click(`${MEASURE} .go`);
  await page.keyboard.press("r");
  await page.waitForSelector(`${MEASURE} .go`);
  assert.match(await page.innerText(`${MEASURE} .work`), /Cancelled/);
  assert.deepEqual(errors, []);
  await close();
});

test("a_damaged_result_in_a_link_is_told", async () => {
  const { page, errors, close } = await visitor.open("?scene=cradle&panel=trade#result=AAAA");
  await page.locator(".result", { hasText: "damaged" }).waitFor();
  assert.deepEqual(errors, []);
  await close();
});

test("cancel_ends_a_measurement_and_the_scene_goes_on", async () => {
  const { page, errors, close } = await openTrade(LONG_TO_MEASURE, PHONE);
  await untilRunning(page);
  await page.click(`${MEASURE} .go`);
  assert.equal(await pressed(page, "pause"), true);
  await page.click(`${MEASURE} .running button`);
  await page.waitForSelector(`${MEASURE} .go`);
  assert.match(await page.innerText(`${MEASURE} .work`), /Cancelled/);
  assert.equal(await page.locator(".result table").count(), 0);
  assert.equal(await pressed(page, "pause"), false);
  assert.deepEqual(errors, []);
  await close();
});

const untilAnswered = (page) =>
  page.waitForFunction(() => document.querySelector(".answer").textContent !== "", null, LONG);

test("heavier_finds_what_each_engine_holds", async () => {
  const { page, errors, close } = await openTrade("?scene=one_spot&size=100&paused=1");
  await page.waitForSelector(`${HEAVIER} .go`);
  await choose(page, "rate", "240");
  await page.click(`${HEAVIER} .go`);
  await untilAnswered(page);
  const answer = await page.innerText(".answer");
  const number = "(not even )?[\\d,]+( to [\\d,]+)?( bodies)?";
  assert.match(answer, new RegExp(`^thud holds ${number} at 240 Hz, Box2D ${number} here\\.$`));
  assert.match(await page.innerText(HEAVIER), /[\d,]+ were too many/);
  assert.deepEqual(errors, []);
  await close();
});

test("heavier_of_a_scene_that_both_hold_says_so", async () => {
  const { page, errors, close } = await openTrade("?scene=cradle&paused=1", PHONE);
  await page.waitForSelector(`${HEAVIER} .go`);
  await page.click(`${HEAVIER} .go`);
  await untilAnswered(page);
  const answer = await page.innerText(".answer");
  assert.equal(answer, "thud holds all 302 bodies at 60 Hz, Box2D all 302 here.");
  assert.deepEqual(errors, []);
  await close();
});

test("a_scene_of_one_size_offers_others_to_make_heavier", async () => {
  const { page, close } = await openTrade("?scene=towers&paused=1");
  await page.waitForFunction(() => document.title.startsWith("Towers"));
  assert.ok(await page.isHidden("#size"));
  await page.click(`${HEAVIER} .actions button >> text=Pyramid`);
  await untilAddress(page, "scene", "pyramid");
  await page.waitForSelector(`${HEAVIER} .go`);
  await close();
});

for (const [size, options] of [["desktop", DESKTOP], ["phone", PHONE]])
  test(`axe_finds_no_serious_violation_in_trade_on_${size}`, async () => {
    const { page, close } = await openTrade("?scene=cradle", options);
    await page.waitForSelector(".live-plane .dot");
    await page.keyboard.press("p");
    await page.click(".tried summary");
    assert.deepEqual(await runAxeInBothThemes(page, "#dock"), []);
    await close();
  });

test("every_control_of_trade_is_large_enough_for_a_finger", async () => {
  const options = { ...PHONE, viewport: { width: 360, height: 640 } };
  const { page, close } = await openTrade("?scene=cradle&paused=1", options);
  const small = await page.evaluate(() =>
    [...document.querySelectorAll(".trade :is(button, .choices label, summary, input[type=range])")]
      .map((element) => [element.textContent || element.id, element.getBoundingClientRect()])
      .filter(([, { width, height }]) => width > 0 && height < 40)
      .map(([name, { height }]) => `${name}: ${height}`),
  );
  assert.deepEqual(small, []);
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 360);
  await close();
});
