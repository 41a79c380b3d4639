/** Tests the gallery: search, keyboard navigation, and starting a scene from it. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { importTypeScript } from "../../../web/tools/scenes.mjs";
import { BROWSERS, DESKTOP, leftOut, openVisitor, PHONE, runAxe, untilRunning } from "../support/page.mjs";
import { root } from "../support/package.mjs";
import { until } from "../support/wait.mjs";

const visitor = openVisitor();

async function openGallery(options = DESKTOP, by = visitor) {
  const opened = await by.open("?scene=pyramid&size=10", options);
  await untilRunning(opened.page);
  await opened.page.click("#scenes-button");
  // The list is loaded after the first frame, and may be filled in after the dialog has opened.
  await untilFocused(opened.page, "pyramid");
  return opened;
}

/** The names of the visible scenes. */
function offered(page) {
  return page.evaluate(() =>
    [...document.querySelectorAll("[data-entry]")]
      .filter((card) => card.checkVisibility())
      .map((card) => card.dataset.entry),
  );
}

function focused(page) {
  return page.evaluate(() => document.activeElement.dataset.entry ?? document.activeElement.id);
}

/** Whether an element is within the part of the dock that is in view. */
function inDock(page, element) {
  return page.evaluate((selector) => {
    const { top, bottom } = document.querySelector(selector).getBoundingClientRect();
    const around = document.querySelector("#dock-body").getBoundingClientRect();
    return top >= around.top && bottom <= around.bottom;
  }, element);
}

function untilFocused(page, name) {
  return until(() => focused(page), (now) => now === name, `the focus is not at ${name}`);
}

for (const [size, options] of [["desktop", DESKTOP], ["phone", PHONE]])
  test(`gallery_search_leaves_what_has_every_word_and_enter_runs_it_on_a_${size}`, async () => {
    const { page, errors, close } = await openGallery(options);
    assert.ok((await offered(page)).length > 30);
    await page.fill("#scene-search", "DRUM boxes");
    const found = await offered(page);
    assert.ok(found.includes("tumbler") && found.length < 5, found.join());
    assert.equal(await page.locator("#scene-list h3:visible").count(), 1, "headings of nothing");
    await page.fill("#scene-search", "tumbler half");
    await page.press("#scene-search", "Enter");
    await page.waitForFunction(() => location.search.includes("scene=tumbler_half"));
    assert.equal(await page.locator("#scenes").isVisible(), false);
    await page.click("#scenes-button");
    await until(() => page.inputValue("#scene-search"), (text) => text === "", "the search's words");
    await until(() => offered(page), ({ length }) => length > 30, "the search is over");
    assert.deepEqual(errors, []);
    await close();
  });

/** What a lecture calls its ideas, and the scene that is among those found by it. */
const IDEAS = {
  "normal depth": "geometry",
  "time of collision": "lab_bisection",
  tunnelling: "lab_bisection",
  "overlap testing": "lab_bisection",
  tunneling: "bullets",
  "time of impact": "lab_swept",
  "times of impact": "lab_swept",
  projectile: "lab_swept",
  roots: "lab_swept",
  parabola: "lab_swept",
  "extruded circle": "lab_capsule",
  capsule: "lab_capsule",
  "dead reckoning": "lab_latency",
  rollback: "lab_latency",
  "complex shape": "lab_approximate",
  "circles and boxes": "lab_approximate",
  "simple shapes": "lab_approximate",
  "point against shape": "lab_minkowski",
  "false alarms": "lab_volumes",
  "cell size": "lab_broadphase",
  "plane sweep": "lab_broadphase",
  insertion: "lab_broadphase",
  "n^2": "lab_broadphase",
  "counts of tests": "lab_broadphase",
  irregular: "lab_terrain",
  weights: "lab_terrain",
  barycentric: "lab_terrain",
  "foot friction": "lab_terrain",
  kicker: "lab_callbacks",
  portal: "lab_callbacks",
  epilogue: "lab_callbacks",
  "pre-solve": "lab_callbacks",
  microscope: "lab_microscope",
  "960 hz": "lab_prices",
  priced: "lab_prices",
  advice: "detection",
  "trade accuracy": "detection",
  "model only what a scene requires": "detection",
  "stability extremes": "far_away",
};

test("gallery_search_finds_a_scene_by_what_a_lecture_calls_its_idea", async () => {
  const { page, errors, close } = await openGallery();
  const lost = [];
  for (const [words, name] of Object.entries(IDEAS)) {
    await page.fill("#scene-search", words);
    const found = await offered(page);
    if (!found.includes(name) || found.length > 6) lost.push(`${words}: ${found.join()}`);
  }
  assert.deepEqual(lost, []);
  assert.deepEqual(errors, []);
  await close();
});

for (const browser of BROWSERS)
  for (const [size, options] of [["desktop", DESKTOP], ["phone", PHONE]])
    test(`gallery_leads_to_the_laboratory_from_its_head_in_${browser}_on_a_${size}`, async (t) => {
      if (leftOut(browser)) return t.skip(leftOut(browser));
      const { page, errors, close } = await openGallery(options, openVisitor({ browser }));
      const button = page.locator("#scenes nav button", { hasText: "Laboratory" });
      const inWindow = (locator) =>
        locator.evaluate((element) => {
          const { left, right, top, bottom } = element.getBoundingClientRect();
          return left >= 0 && top >= 0 && right <= innerWidth && bottom <= innerHeight;
        });
      assert.ok(await inWindow(button), "it is seen without scrolling");
      await button.focus();
      await page.keyboard.press("Enter");
      await untilFocused(page, "lab_bisection");
      const heading = page.locator("#scene-list h3", { hasText: "Laboratory" });
      await until(() => inWindow(heading), (seen) => seen, "the heading is in the window");
      const head = await page.locator("#scenes .head").boundingBox();
      const { y } = await heading.boundingBox();
      assert.ok(y >= head.y + head.height - 1, "the head does not cover it");
      await page.fill("#scene-search", "reckoning");
      assert.deepEqual(await page.locator("#scenes nav button:visible").allTextContents(), ["Laboratory"]);
      assert.deepEqual(await runAxe(page, "#scenes"), []);
      assert.deepEqual(errors, []);
      await close();
    });

test("gallery_opens_the_part_of_a_panel_that_was_searched_for", async () => {
  const { page, errors, close } = await openGallery();
  for (const [words, scene, panel, element] of [
    ["what does my scene require", "detection", "trade", "#measure-heading"],
    ["960 hz", "lab_prices", "trade", "#prices-heading"],
    ["manifold depth", "lab_microscope", "inside", "#next-contact"],
  ]) {
    await page.fill("#scene-search", words);
    assert.deepEqual(await offered(page), [scene], words);
    await page.press("#scene-search", "Enter");
    await page.waitForFunction((name) => location.search.includes(`scene=${name}`), scene);
    await page.waitForFunction((name) => location.search.includes(`panel=${name}`), panel);
    await page.waitForSelector(element);
    await until(() => inDock(page, element), (inside) => inside, `${element} is in view`);
    await page.click("#scenes-button");
  }
  // What is found by the scene's own words opens what the scene opens.
  await page.fill("#scene-search", "tunnelling bisection capsules");
  assert.deepEqual(await offered(page), ["detection"]);
  await page.press("#scene-search", "Enter");
  await page.waitForFunction(() => location.search.includes("scene=detection"));
  await page.waitForFunction(() => !location.search.includes("panel=trade"));
  assert.deepEqual(errors, []);
  await close();
});

test("gallery_shows_the_part_of_a_panel_that_is_open_and_still_loaded", async () => {
  let send;
  const held = new Promise((done) => (send = done));
  const slow = (page) =>
    page.route("**/assets/trade-*.js", async (route) => {
      await held;
      await route.continue();
    });
  const search = "?scene=pyramid&size=10&panel=trade";
  const { page, errors, close } = await visitor.open(search, DESKTOP, slow);
  await page.click("#scenes-button");
  await untilFocused(page, "pyramid");
  await page.fill("#scene-search", "what does my scene require");
  await page.press("#scene-search", "Enter");
  await page.waitForFunction(() => location.search.includes("scene=detection"));
  send();
  await page.waitForSelector("#measure-heading");
  await until(() => inDock(page, "#measure-heading"), (seen) => seen, "the part is in view");
  assert.deepEqual(errors, []);
  await close();
});

test("scene_that_is_chosen_runs_although_the_one_before_was_paused", async () => {
  const { page, errors, close } = await openGallery();
  await page.keyboard.press("Escape");
  await page.click("#pause");
  await page.waitForFunction(() => location.search.includes("paused=1"));
  await page.click("#scenes-button");
  await page.fill("#scene-search", "tumbler half");
  await page.press("#scene-search", "Enter");
  await page.waitForFunction(() => location.search.includes("scene=tumbler_half"));
  await page.waitForFunction(() => !location.search.includes("paused=1"));
  await page.waitForFunction(() => Number(document.querySelector("#hud").dataset.steps) > 5);
  assert.deepEqual(errors, []);
  await close();
  // Who asked for less motion starts each scene.
  const still = await openVisitor().open("?scene=pyramid&size=10", { ...DESKTOP, reducedMotion: "reduce" });
  await still.page.waitForSelector("[data-entry]", { state: "attached" });
  await still.page.evaluate(() => document.querySelector('[data-entry="tumbler_half"]').click());
  await still.page.waitForFunction(() => location.search.includes("scene=tumbler_half"));
  await still.page.waitForTimeout(500);
  assert.equal(await still.page.evaluate(() => document.querySelector("#hud").dataset.steps ?? "0"), "0");
  await still.close();
});

test("every_idea_of_the_lecture_has_its_cells_filled_and_names_scenes_that_there_are", async () => {
  const { SCENES } = await importTypeScript("src/scene/registry.ts");
  const page = readFileSync(`${root}docs/lecture.md`, "utf8");
  const lists = [...page.matchAll(/\bscenes? ((?:`\w+`(?:, )?)+)/g)].flatMap(([, list]) => list.match(/\w+/g));
  const levels = [...page.matchAll(/\blevel \*([^*]+)\*/g)].map(([, title]) => title);
  assert.ok(lists.length > 40 && levels.length > 0, `${lists.length} scenes, ${levels.length} levels`);
  const missing = [
    ...lists.filter((one) => !SCENES.some(({ name }) => name === one)),
    ...levels.filter((one) => !SCENES.some(({ title }) => title === one)),
  ];
  assert.deepEqual(missing, []);
  assert.deepEqual(page.split("\n").filter((line) => /\|\s*[—-]?\s*\|/.test(line)), []);
});

test("gallery_keywords_are_of_scenes_that_there_are", async () => {
  const { KEYWORDS, PARTS } = await importTypeScript("src/scene/keywords.ts");
  const { SCENES } = await importTypeScript("src/scene/registry.ts");
  const names = SCENES.map(({ name }) => name);
  assert.deepEqual([...Object.keys(KEYWORDS), ...Object.keys(PARTS)].filter((name) => !names.includes(name)), []);
});

for (const browser of BROWSERS)
  test(`gallery_types_into_the_search_what_is_typed_on_a_card_in_${browser}`, async (t) => {
    if (leftOut(browser)) return t.skip(leftOut(browser));
    const { page, errors, close } = await openGallery(DESKTOP, openVisitor({ browser }));
    await page.keyboard.type("reckoning");
    assert.equal(await page.inputValue("#scene-search"), "reckoning");
    assert.deepEqual(await offered(page), ["lab_latency"]);
    await page.keyboard.press("Enter");
    await page.waitForFunction(() => location.search.includes("scene=lab_latency"));
    assert.deepEqual(errors, []);
    await close();
  });

test("gallery_enter_runs_the_scene_whose_title_was_typed_before_the_first_found", async () => {
  const { page, errors, close } = await openGallery();
  await page.fill("#scene-search", "Bridge");
  assert.equal((await offered(page))[0], "bridge_builder");
  await page.press("#scene-search", "Enter");
  await page.waitForFunction(() => /scene=bridge(&|$)/.test(location.search));
  assert.deepEqual(errors, []);
  await close();
});

test("gallery_search_for_nothing_there_is_says_so", async () => {
  const { page, close } = await openGallery();
  await page.fill("#scene-search", "zebra");
  assert.deepEqual(await offered(page), []);
  assert.match(await page.textContent("#no-scene"), /No scene is found by “zebra”/);
  await page.press("#scene-search", "Enter");
  assert.equal(await page.locator("#scenes").isVisible(), true);
  await page.fill("#scene-search", "");
  assert.equal(await page.textContent("#no-scene"), "");
  await close();
});

test("gallery_opens_at_the_running_scene_and_arrows_go_from_card_to_card", async () => {
  const { page, errors, close } = await openGallery();
  assert.equal(await page.getAttribute('[data-entry="pyramid"]', "aria-current"), "true");
  assert.equal(await page.locator("[data-entry][aria-current]").count(), 1);
  const all = await offered(page);
  const at = all.indexOf("pyramid");
  await page.keyboard.press("ArrowRight");
  assert.equal(await focused(page), all[at + 1]);
  await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("ArrowLeft");
  assert.equal(await focused(page), all[at - 1]);
  // The first cards of all rows are below each other, in every group.
  for (let row = 0; row < all.length && (await focused(page)) !== all[0]; row++)
    await page.keyboard.press("ArrowUp");
  assert.equal(await focused(page), all[0]);
  await page.keyboard.press("ArrowUp");
  assert.equal(await focused(page), "scene-search");
  await page.keyboard.press("ArrowDown");
  assert.equal(await focused(page), all[0]);
  await page.keyboard.press("Enter");
  await page.waitForFunction((name) => location.search.includes(`scene=${name}`), all[0]);
  assert.deepEqual(errors, []);
  await close();
});

test("gallery_shows_a_picture_of_every_scene", async () => {
  const { page, close } = await openGallery();
  const missing = await page.evaluate(async () => {
    const pictures = [...document.querySelectorAll("[data-entry] img")];
    if (pictures.length === 0) return ["all"];
    for (const picture of pictures) picture.loading = "eager";
    await Promise.allSettled(pictures.map((picture) => picture.decode()));
    return pictures.filter(({ naturalWidth }) => naturalWidth === 0).map(({ src }) => src);
  });
  assert.deepEqual(missing, []);
  await close();
});
