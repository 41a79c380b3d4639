/**
 * Tests the panel Inside: overlays, the state of a body, the stages of a step, and the comparison
 * of the state's hashes.
 */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { buildScene, runScene, USUAL_OPTIONS } from "../../../web/tools/scenes.mjs";
import {
  DESKTOP,
  figure,
  near,
  openVisitor,
  PHONE,
  runAxeInBothThemes,
  stepBy,
} from "../support/page.mjs";
import { hoverBall, listed, openPanel, RESTING, show } from "../support/inside.mjs";
import { ballLevel, root, thud } from "../support/package.mjs";
import { overlay, until, untilOverlay } from "../support/wait.mjs";

const SIZES = [["desktop", DESKTOP], ["phone", PHONE]];

const visitor = openVisitor();

const openInside = (part, search, options) => openPanel(visitor, part, search, options);

const OF_STACK = ["bounds", "cells", "pairs", "stages", "contacts", "normals", "impulses", "islands", "colours"];

for (const [size, options] of SIZES)
  test(`ticked_overlay_is_drawn_until_it_is_unticked_on_a_${size}`, async () => {
    const { page, errors, close } = await openInside("show", "scene=tall_stack&paused=1", options);
    await stepBy(page, 5);
    for (const name of OF_STACK) {
      await page.check(`[name=overlay-${name}]`);
      await untilOverlay(page, (count) => count > 20, `${name} ticked`);
      await page.uncheck(`[name=overlay-${name}]`);
      await untilOverlay(page, (count) => count === 0, `${name} unticked`);
    }
    assert.deepEqual(errors, []);
    await close();
  });

test("overlays_of_other_scenes_draw_and_follow_their_keys", async () => {
  for (const [name, key, search, steps] of [
    ["motions", "m", "scene=bullets", 3],
    ["axes", "8", "scene=broadphases&broadphase=sweep", 3],
    ["sums", "y", "scene=minkowski", 1],
  ]) {
    const { page, errors, close } = await openInside("show", `${search}&paused=1`, DESKTOP);
    const box = page.locator(`[name=overlay-${name}]`);
    await page.$$eval(".overlays input:checked", (inputs) => inputs.forEach((input) => input.click()));
    await stepBy(page, steps);
    // The pixels that the scene itself draws in the overlay.
    const { count: plain } = await overlay(page);
    await page.keyboard.press(key);
    assert.ok(await box.isChecked(), `${name} is not ticked by its key`);
    await untilOverlay(page, (count) => count > plain + 100, `${name} by its key`);
    await box.uncheck();
    await untilOverlay(page, (count) => count === plain, `${name} unticked`);
    assert.deepEqual(errors, []);
    await close();
  }
});

test("body_that_is_kept_is_shown_with_its_nearest_neighbour_s_sum", async () => {
  const { page, errors, close } = await openInside("show", "scene=tall_stack&paused=1", DESKTOP);
  await stepBy(page, 1);
  await page.focus("#overlay");
  await page.keyboard.press("q");
  const outline = await untilOverlay(page, (count) => count > 20, "the body's outline");
  await page.keyboard.press("y");
  await untilOverlay(page, (count) => count > 2 * outline.count, "the sum beside the outline");
  assert.deepEqual(errors, []);
  await close();
});

test("sleeping_bodies_are_dimmed_while_that_is_ticked", async () => {
  const { page, close } = await openInside("show", "scene=asleep&size=100&paused=1", DESKTOP);
  await stepBy(page, 120);
  /**
   * The summed redness of the drawn bodies; the sleeping bodies have colours from red to yellow
   * while they are awake.
   */
  const light = () =>
    page.evaluate(() => {
      const { width, height } = document.getElementById("bodies");
      const context = Object.assign(document.createElement("canvas"), { width, height }).getContext("2d");
      context.drawImage(document.getElementById("bodies"), 0, 0);
      const { data } = context.getImageData(0, 0, width, height);
      let sum = 0;
      for (let i = 0; i < data.length; i += 4) sum += Math.max(0, data[i] - data[i + 2]);
      return sum;
    });
  await until(() => figure(page, "awake"), (awake) => awake === 100, "bodies awake");
  const dimmed = await light();
  await page.uncheck("[name=overlay-sleeping]");
  await until(light, (lit) => lit > 1.3 * dimmed, `as light as what sleeps, ${dimmed}`);
  await close();
});

test("body_under_the_mouse_has_the_package_s_numbers", async () => {
  const { page, errors, close } = await hoverBall(visitor);
  const { scene } = await buildScene(await thud.load(), "own_level", {
    choices: USUAL_OPTIONS,
    readText: async () => ballLevel(),
  });
  runScene(scene, RESTING);
  const { world } = scene;
  const { count, rows, handles } = world.shapeTable();
  const ball = Array.from({ length: count }, (_, i) => i).find((i) => rows[10 * i + 2] === 2);
  const slot = handles[4 * ball + 2] - 1;
  const id = { kind: "body", index: slot, generation: handles[4 * ball + 3] };
  const state = world.bodyStateOf(id);
  const [contact] = world.contactsOf(id);

  const facts = await listed(page, "#body-state");
  const numbers = (name) => facts[name].split(",").map(Number);
  assert.equal(await page.textContent(".inside h3:has(+ p)"), `Body ${slot}, dynamic`);
  assert.equal(facts.state, state.awake ? "awake" : "asleep");
  near(numbers("position")[0], state.position[0], 1e-3, "x");
  near(numbers("position")[1], state.position[1], 1e-3, "y");
  near(Number(facts.mass), state.mass, 1e-3, "mass");
  near(Number(facts.inertia), state.inertia, 1e-3, "inertia");
  near(Number(facts.speed), Math.hypot(...state.velocity), 1e-4, "speed");
  const cells = await page.$$eval("#body-contacts tbody td", (found) => found.map((cell) => cell.textContent));
  const [points, depth, impulse] = cells.map(Number);
  assert.equal(points, contact.points.length);
  near(depth, -contact.points[0].separation, 1e-5, "depth");
  near(impulse, contact.points[0].normalImpulse, 1e-3 * impulse, "impulse");
  const card = await listed(page, "#body-card");
  assert.equal(card.mass, facts.mass);
  assert.deepEqual(errors, []);
  await close();
});

test("body_under_the_mouse_has_a_row_for_each_of_its_joints", async () => {
  const properties = [{ name: "b", type: "object", value: 2 }];
  const hinge = { id: 3, type: "hinge", point: true, x: 320, y: 160, properties };
  const { page, errors, close } = await hoverBall(visitor, [hinge]);
  const cells = await page.$$eval("#body-joints tbody tr *", (found) =>
    found.map((cell) => cell.textContent),
  );
  const [other, kind, gap, , force] = cells;
  assert.match(other, /^body \d$/);
  assert.equal(kind, "hinge");
  near(Number(gap), 0, 0.01, "gap");
  near(Number(force), Math.PI * 10, 0.5, "its weight");
  assert.equal(await page.isVisible("#body-contacts"), false);
  assert.deepEqual(errors, []);
  await close();
});

test("clicked_body_stays_in_the_panel_until_it_is_let_go", async () => {
  const { page, errors, ball, close } = await hoverBall(visitor);
  await page.mouse.move(ball.x - 250, ball.y - 250);
  await page.waitForSelector("#body-card", { state: "hidden" });
  assert.equal(await page.textContent(".inside section:not([hidden]) h3"), "No body");
  await page.mouse.click(ball.x, ball.y);
  await page.mouse.move(ball.x - 250, ball.y - 250);
  await page.waitForSelector("text=Let go of it");
  assert.match(await page.textContent(".inside section:not([hidden]) h3"), /dynamic/);
  await page.click("text=Let go of it");
  assert.equal(await page.textContent(".inside section:not([hidden]) h3"), "No body");
  assert.deepEqual(errors, []);
  await close();
});

for (const [size, options] of SIZES)
  test(`body_is_inspected_by_key_and_by_touch_on_a_${size}`, async () => {
    const { page, errors, close } = await visitor.open("?scene=tall_stack&paused=1", options);
    await stepBy(page, 1);
    await page.focus("#overlay");
    await page.keyboard.press("q");
    await page.waitForSelector("#body-state > div");
    assert.match(await page.textContent(".inside section:not([hidden]) h3"), /Body \d+, dynamic/);
    if (options.hasTouch) {
      const { x, y, width, height } = await page.locator("#crosshair").boundingBox();
      await page.click("text=Let go of it");
      await page.touchscreen.tap(x + width / 2, y + height / 2);
      await page.waitForSelector("text=Let go of it");
    }
    assert.deepEqual(errors, []);
    await close();
  });

test("step_has_a_row_for_every_stage_and_the_page_s_figures", async () => {
  const { page, errors, close } = await openInside("step", "scene=pyramid&size=60&paused=1", DESKTOP);
  await stepBy(page, 20);
  await page.waitForFunction(() => document.querySelector("#step-numbers dd")?.textContent === "20");
  const rows = await page.$$eval("#stages tbody tr", (found) =>
    found.map((row) => [...row.cells].map((cell) => cell.textContent)),
  );
  const engine = await thud.load();
  assert.deepEqual(rows.map(([name]) => name), [...engine.stageNames, "all"]);
  const sum = (column) => rows.slice(0, -1).reduce((total, row) => total + Number(row[column]), 0);
  near(sum(1), Number(rows.at(-1)[1]), 0.006, "sum of the stages");
  assert.ok(sum(1) > 0);
  const facts = await listed(page, "#step-numbers");
  const figureText = (name) => page.textContent(`[data-value="${name}"]`);
  await until(
    async () => [
      `${await figureText("awake")} of ${await figureText("bodies")}`,
      await figureText("contacts"),
    ],
    ([awake, touching]) => awake === facts["bodies awake"] && touching === facts["pairs in contact"],
    "the figures over the scene, which follow those of the panel",
  );
  assert.equal(facts["allocations in the step"], "0");
  const { count } = await page.evaluate(() => {
    const canvas = document.querySelector(".areas");
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    return { count: data.filter((value, i) => i % 4 === 3 && value > 0).length };
  });
  assert.ok(count > 100, `${count} pixels of areas`);
  assert.deepEqual(errors, []);
  await close();
});

test("step_tells_what_bisection_missed_and_from_which_speed_on_it_may", async () => {
  const search = "scene=bullets&size=3&detection=bisect&paused=1";
  const { page, errors, close } = await openInside("step", search, DESKTOP);
  await stepBy(page, 5);
  const facts = await until(
    () => listed(page, "#step-numbers"),
    ({ step, "bisection’s speed limit": limit }) => step === "5" && Number(limit) > 0,
    "a limit",
  );
  // The walls are 2 cm thick, so the limit is 1.2 m/s at 60 Hz.
  near(Number(facts["bisection’s speed limit"]), 1.2, 0.01, "limit");
  assert.ok(Number(facts["bodies too fast for bisection"]) > 0);
  assert.equal(facts["bodies held back"], "0");
  assert.deepEqual(errors, []);
  await close();
});

test("step_of_the_panel_is_made_by_its_own_buttons_on_a_phone", async () => {
  const { page, errors, close } = await openInside("step", "scene=cradle&paused=1", PHONE);
  const untilShown = (least, most) =>
    page.waitForFunction(
      ([from, to]) => {
        const step = Number(document.querySelector("#step-numbers dd")?.textContent);
        return step >= from && step <= to;
      },
      [least, most],
    );
  await untilShown(0, 0);
  await page.tap("text=One step >> visible=true");
  await untilShown(1, 1);
  await page.tap("text=Go on >> visible=true");
  await untilShown(10, Infinity);
  await page.tap("text=Pause >> visible=true");
  await page.waitForSelector("text=Go on >> visible=true");
  assert.deepEqual(errors, []);
  await close();
});

test("part_chosen_while_the_scene_stands_shows_the_present", async () => {
  const { page, errors, close } = await openInside("show", "scene=cradle&paused=1", DESKTOP);
  await stepBy(page, 5);
  for (const [part, list] of [["step", "#step-numbers"], ["bits", "#hash-now"]]) {
    await show(page, part);
    await page.waitForFunction(
      (name) => document.querySelector(`${name} dd`)?.textContent === "5",
      list,
    );
  }
  assert.deepEqual(errors, []);
  await close();
});

async function verdict(page) {
  await page.waitForSelector("#verdict:not([data-verdict=open])");
  return page.innerText("#verdict");
}

for (const [size, options] of SIZES)
  test(`check_finds_the_same_bits_as_the_build_and_the_native_engine_on_a_${size}`, async () => {
    const { page, errors, close } = await openInside("bits", "scene=slopes&paused=1", options);
    await page.click("#check");
    assert.match(await verdict(page), /Same bits .* machine that built this page, and .* native x86-64/);
    assert.equal(await page.locator("#hashes tbody tr").count(), 5);
    assert.deepEqual(errors, []);
    await close();
  });

test("check_of_a_level_and_of_a_game_finds_the_same_bits", async () => {
  for (const name of ["towers", "artillery"]) {
    const { page, errors, close } = await openInside("bits", `scene=${name}&paused=1`, DESKTOP);
    await page.click("#check");
    assert.match(await verdict(page), /Same bits as on the machine that built this page\./);
    assert.deepEqual(errors, []);
    await close();
  }
});

test("check_of_another_choice_has_hashes_but_no_reference", async () => {
  const { page, close } = await openInside("bits", "scene=cradle&quality=high&paused=1", DESKTOP);
  await page.click("#check");
  await page.waitForSelector("#hashes tbody tr");
  assert.match(await page.innerText("#verdict"), /no reference/);
  await close();
});

test("check_tells_where_a_machine_begins_to_differ", async () => {
  // Simulates a machine with other results: the hashes in the workers' answers change from step 180
  // on.
  const prepare = (opening) =>
    opening.addInitScript(() => {
      const { Worker: Real } = window;
      window.Worker = class extends Real {
        set onmessage(listener) {
          super.onmessage = (event) => {
            const { value } = event.data;
            if (value?.hash && value.step >= 180) value.hash = value.hash.replace(/.$/, "x");
            listener(event);
          };
        }
      };
    });
  const search = "?scene=bounce&panel=inside&paused=1";
  const { page, close } = await visitor.open(search, DESKTOP, prepare);
  await page.waitForSelector("[name=inside]", { state: "attached" });
  await show(page, "bits");
  await page.click("#check");
  assert.match(await verdict(page), /same up to step 120, and no more at step 180/);
  assert.equal(await page.locator("#hashes [data-same=false]").count(), 3);
  await close();
});

test("link_with_a_hash_is_compared_and_a_wrong_one_differs", async () => {
  const { scenes } = JSON.parse(readFileSync(`${root}web/generated/hashes.json`, "utf8"));
  const right = scenes.cradle.hashes[4];
  for (const [hash, wanted] of [
    [right, /^Same bits as on the machine of whoever sent the link, after 300 steps/],
    [right.replace(/^./, (letter) => (letter === "0" ? "1" : "0")), /^Different from the machine/],
  ]) {
    const { page, errors, close } = await visitor.open(`?scene=cradle&paused=1&panel=inside&step=300&hash=${hash}`);
    await page.waitForSelector("#verdict", { state: "visible" });
    assert.match(await verdict(page), wanted);
    assert.match(page.url(), new RegExp(`step=300&hash=${hash}`));
    assert.deepEqual(errors, []);
    await close();
  }
});

test("link_to_compare_leads_a_friend_to_the_same_bits", async () => {
  const { page, close } = await openInside("bits", "scene=gas&size=60&seed=5&paused=1", {
    ...DESKTOP,
    permissions: ["clipboard-read", "clipboard-write"],
  });
  await page.click("#hash-link");
  const told = () => /^After 300 steps/.test(document.querySelector("#verdict").textContent);
  await page.waitForFunction(told);
  await page.waitForFunction(() => /clipboard/.test(document.querySelector("#notice").textContent));
  const link = await page.evaluate(() => navigator.clipboard.readText());
  assert.match(link, /scene=gas&size=60&seed=5.*step=300&hash=[0-9a-f]{16}/);
  await page.goto(link);
  await page.waitForSelector("#verdict", { state: "visible" });
  assert.match(await verdict(page), /^Same bits/);
  await close();
});

for (const [size, options] of SIZES)
  test(`axe_finds_no_serious_violation_in_the_panel_on_a_${size}`, async () => {
    const { page, close } = await openInside("show", "scene=tall_stack&paused=1", options);
    await stepBy(page, 5);
    const violations = [];
    for (const [part, content] of [
      ["show", ".overlays"],
      ["body", "#body-state > div"],
      ["step", "#step-numbers > div"],
      ["bits", "#hash-now > div"],
    ]) {
      await show(page, part);
      if (part === "body") await page.keyboard.press("q");
      await page.waitForSelector(content);
      violations.push(...(await runAxeInBothThemes(page, "#dock")));
    }
    assert.deepEqual(violations, []);
    await close();
  });
