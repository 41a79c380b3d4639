/** Tests the panel Versus: both engines are drawn, take commands, and are measured. */
import assert from "node:assert/strict";
import { test } from "node:test";
import {
  choose,
  DESKTOP,
  drawn,
  near,
  openVisitor,
  PHONE,
  runAxeInBothThemes,
  stepBy,
  untilRunning,
} from "../support/page.mjs";
import {
  BOX2D,
  middles,
  openBoth,
  table,
  untilBox2D,
  untilMeasured,
  untilTwo,
} from "../support/versus.mjs";
import { until, untilStep } from "../support/wait.mjs";

const visitor = openVisitor();

/** More than the 30 steps of the warm-up, and too few for resting bodies to fall asleep. */
const STEPS_THAT_COUNT = 45;
/** More than the 60 steps that may lie between two measurements of the overlap (web/src/box2d). */
const STEPS_TO_LOOK_AGAIN = 61;

for (const [size, options] of [["desktop", DESKTOP], ["phone", PHONE]])
  test(`ball_falls_and_rests_in_both_views_on_${size}`, async () => {
    const { page, errors, close } = await openBoth(visitor, options);
    const start = await untilTwo(page);
    near(start[0].count, start[1].count, 0.05 * start[0].count, "as large in both");
    await stepBy(page, 150);
    const rest = await untilTwo(page);
    const fallen = rest.map(({ y }, i) => y - start[i].y);
    assert.ok(fallen[0] > 20, `thud's fell ${fallen[0]} pixels`);
    near(fallen[1], fallen[0], 2, "Box2D's fell as far");
    near(rest[1].x - start[1].x, rest[0].x - start[0].x, 1, "neither rolled away");
    assert.deepEqual(errors, []);
    await close();
  });

for (const [scene, what] of [
  ["flags", "wind"],
  ["boats", "water"],
  ["clock", "gears"],
  ["planks", "rules between kinds"],
])
  test(`what_box2d_is_not_given_of_${scene}_is_told_first_and_nothing_is_compared`, async () => {
    const { page, errors, close } = await visitor.open(`?scene=${scene}&panel=versus&paused=1`);
    await untilBox2D(page);
    await stepBy(page, 45);
    await untilMeasured(page);
    const verdict = await page.textContent("#versus .verdict");
    assert.match(verdict, new RegExp(`^Not comparable: Box2D is not given ${what}\\.`));
    assert.doesNotMatch(verdict, /times/);
    assert.equal(await page.locator("#versus-table .better").count(), 0);
    if (scene === "planks") {
      const rows = await table(page);
      assert.ok(Number(rows["Overlap, worst"][0]) < 0.1, `${rows["Overlap, worst"]}`);
    }
    assert.deepEqual(errors, []);
    await close();
  });

for (const [name, view] of [["thud", 0], ["box2d", 1]])
  test(`dragging_in_the_view_of_${name}_moves_the_body_in_both`, async () => {
    const { page, errors, close } = await openBoth(visitor);
    const start = await untilTwo(page);
    const [dx, dy] = view === 0 ? [60, -90] : [-60, -90];
    await page.mouse.move(start[view].x, start[view].y);
    await page.mouse.down();
    await page.waitForSelector("#overlay[data-mode=pull]");
    await page.mouse.move(start[view].x + dx, start[view].y + dy, { steps: 4 });
    await stepBy(page, 90);
    const held = await untilTwo(page);
    for (const i of [0, 1]) {
      near(held[i].x - start[i].x, dx, 8, `x of view ${i}`);
      near(held[i].y - start[i].y, dy, 8, `y of view ${i}`);
    }
    assert.deepEqual(errors, []);
    await close();
  });

test("body_is_taken_where_box2d_has_it_in_the_view_of_box2d", async () => {
  // The explosion throws thud's ball alone.
  const body = `export default function ({ createWorld }) {
    const world = createWorld({ gravity: [0, 0] });
    const ball = world.createBody({ kind: "dynamic" });
    world.createCircle(ball, { radius: 2 });
    const blast = { center: [0, -4], radius: 9, impulse: 20 };
    return { world, update: ({ step }) => void (step === 1 && world.explode(blast)) };
  }`;
  const { page, errors, close } = await visitor.open("?scene=sketch&paused=1", DESKTOP, (page) =>
    page.route("**/scenes/sketch.js", (route) =>
      route.fulfill({ contentType: "text/javascript", body }),
    ),
  );
  await stepBy(page, 1);
  await page.keyboard.press("x");
  await untilBox2D(page);
  await stepBy(page, 30);
  const [thuds, box2ds] = await untilTwo(page);
  assert.ok(Math.abs(thuds.y - box2ds.y) > 220, `${thuds.y} and ${box2ds.y}`);
  await page.mouse.move(box2ds.x, box2ds.y);
  await page.mouse.down();
  await page.waitForSelector("#overlay[data-mode=pull]");
  assert.deepEqual(errors, []);
  await close();
});

test("body_that_a_scene_paints_itself_is_drawn_in_the_view_of_box2d", async () => {
  const body = `export default function ({ createWorld }) {
    const world = createWorld({ gravity: [0, 0] });
    const ball = world.createBody({ kind: "dynamic" });
    world.createCircle(ball, { radius: 2 });
    return { world, hidden: [ball.index] };
  }`;
  const { page, errors, close } = await visitor.open("?scene=sketch&paused=1", DESKTOP, (page) =>
    page.route("**/scenes/sketch.js", (route) =>
      route.fulfill({ contentType: "text/javascript", body }),
    ),
  );
  await stepBy(page, 1);
  assert.equal((await drawn(page)).count, 0, "thud's is the scene's to paint");
  await page.keyboard.press("x");
  await untilBox2D(page);
  await stepBy(page, 1);
  await until(() => drawn(page), ({ count }) => count >= 100, "a ball in the view of Box2D");
  assert.deepEqual(errors, []);
  await close();
});

test("box2d_is_fetched_when_the_panel_opens_and_not_before", async () => {
  const fetched = [];
  const { page, errors, close } = await visitor.open("?scene=tall_stack", DESKTOP, async (page) => {
    page.context().on("request", (request) => {
      if (BOX2D.test(request.url())) fetched.push(request.url());
    });
  });
  await untilRunning(page);
  assert.deepEqual(fetched, []);
  await page.click('[data-panel="versus"]');
  await untilBox2D(page);
  await until(() => fetched, (urls) => urls.some((url) => url.endsWith(".wasm")), "fetched");
  assert.deepEqual(errors, []);
  await close();
});

test("table_tells_times_overlap_energy_and_bodies_of_both", async () => {
  // So large that a step takes longer than the clock's resolution on any machine.
  const search = "?scene=pyramid&size=40&panel=versus&paused=1";
  const { page, errors, close } = await visitor.open(search);
  await untilBox2D(page);
  await stepBy(page, STEPS_THAT_COUNT);
  // The pyramid's boxes and the ground. Figures are refreshed a few times per second, from the
  // steps made since.
  const all = ({ Bodies, Awake }) => `${Bodies}; ${Awake}` === "821,821; 820,820";
  await untilMeasured(page);
  const rows = await until(() => table(page), all, "bodies of both");
  for (const name of ["Step, median", "Step, p99"])
    for (const text of rows[name]) {
      const value = Number(/^([\d.]+) ms$/.exec(text)?.[1]);
      assert.ok(value > 0, `${name}: ${text}`);
    }
  await page.locator("#versus .verdict", { hasText: /fast.*overlap/ }).waitFor();
  assert.equal(await page.locator("#versus .plots canvas").count(), 3);
  await stepBy(page, STEPS_TO_LOOK_AGAIN);
  const overlaps = async () => {
    const { "Overlap, mean": mean, "Overlap, worst": worst } = await table(page);
    return [...mean, ...worst].map(Number);
  };
  const seen = (found) => found.every((value) => value > 1e-4 && value < 0.1);
  await until(overlaps, seen, "overlaps of both, mean and worst");
  const marked = await page.$$eval("#versus-table tr:has(.better) td", (cells) =>
    cells.map((cell) => [parseFloat(cell.textContent), cell.classList.contains("better")]),
  );
  assert.ok(marked.length > 0, "no figure stands out");
  for (let i = 0; i < marked.length; i += 2) {
    const [better, other] = marked.slice(i, i + 2).sort(([a], [b]) => a - b);
    assert.deepEqual([better[1], other[1]], [true, false], `${marked}`);
  }
  assert.deepEqual(errors, []);
  await close();
});

test("world_far_from_the_origin_is_moved_for_box2d_and_the_panel_says_so", async () => {
  const { page, errors, close } = await visitor.open("?scene=far_away&size=7&panel=versus&paused=1");
  await untilBox2D(page);
  await stepBy(page, STEPS_THAT_COUNT);
  await untilMeasured(page);
  assert.match(await page.textContent("#versus .moved"), /10,000 km.* 1 m apart.*moved/);
  const [thud, box2d] = (await table(page)).Bodies;
  assert.equal(box2d, thud);
  await page.goto(`${page.url().split("?")[0]}?scene=far_away&size=2&panel=versus&paused=1`);
  await untilBox2D(page);
  await stepBy(page, STEPS_THAT_COUNT);
  await untilMeasured(page);
  assert.ok(await page.isHidden("#versus .moved"));
  assert.deepEqual(errors, []);
  await close();
});

test("overlap_of_bodies_asleep_is_the_same_over_the_scene_and_in_the_panel", async () => {
  const { page, errors, close } = await visitor.open("?scene=pyramid&size=20&panel=versus&paused=1");
  await untilBox2D(page);
  await stepBy(page, 120);
  const asleep = async () => {
    const value = (name) => page.textContent(`[data-value="${name}"]`);
    const { "Overlap now": [panel] } = await table(page);
    const verdict = await page.textContent("#versus .verdict");
    const [over, awake] = [Number(await value("deepest")), await value("awake")];
    return { verdict, awake, over, panel: Number(panel) };
  };
  // Either of the two texts may be refreshed first.
  const sleeps = ({ verdict, awake, over, panel }) =>
    /All bodies sleep in .* now/.test(verdict) &&
    awake === "0" &&
    over > 0.0005 &&
    Math.abs(over - panel) <= 0.00006;
  await until(asleep, sleeps, "all asleep, with the same overlap over the scene");
  assert.deepEqual(errors, []);
  await close();
});

test("restart_both_begins_both_at_the_start", async () => {
  const { page, errors, close } = await visitor.open("?scene=tall_stack&paused=1");
  await stepBy(page, 30);
  await page.keyboard.press("x");
  await untilBox2D(page);
  await stepBy(page, 2);
  const since = page.locator("#versus .quiet");
  await since.waitFor();
  assert.match(await since.textContent(), /began at 0\.50 s/);
  await page.click('#versus button:text-is("Restart both")');
  await untilStep(page, 0);
  await stepBy(page, 40);
  await since.waitFor({ state: "hidden" });
  await untilMeasured(page);
  assert.deepEqual(errors, []);
  await close();
});

test("going_back_in_time_begins_box2d_anew_where_thud_is", async () => {
  const { page, errors, close } = await openBoth(visitor);
  await stepBy(page, 60);
  await page.evaluate(() => {
    const slider = document.querySelector("#time");
    slider.value = "30";
    slider.dispatchEvent(new Event("input", { bubbles: true }));
  });
  await untilStep(page, 30);
  const back = await untilTwo(page);
  near(back[1].y, back[0].y, 1, "as high in both");
  await stepBy(page, 10);
  const on = await untilTwo(page);
  assert.ok(on[0].y > back[0].y + 3, "it falls on");
  near(on[1].y - back[1].y, on[0].y - back[0].y, 1.5, "in both");
  await page.locator("#versus .quiet", { hasText: "0.50 s" }).waitFor();
  assert.deepEqual(errors, []);
  await close();
});

test("layout_and_substeps_are_kept_in_the_url_and_closing_ends_the_comparison", async () => {
  const { page, errors, close } = await openBoth(visitor);
  await choose(page, "split", "over");
  await page.waitForFunction(() => document.querySelector("#versus-table .box2d"));
  await page.goto(`${page.url().split("?")[0]}?scene=tall_stack&panel=versus`);
  await untilBox2D(page);
  await choose(page, "split", "over");
  await choose(page, "box2d-substeps", "8");
  await page.waitForFunction(() => /split=over.*box2d=8/.test(location.search));
  await page.reload();
  await untilBox2D(page);
  assert.ok(await page.isChecked('[name="split"][value="over"]'));
  await page.locator("#versus-table .box2d", { hasText: "8 substeps" }).waitFor();
  await page.click("#dock .close");
  await page.waitForFunction(() => !/panel=/.test(location.search));
  assert.deepEqual(errors, []);
  await close();
});

test("closing_the_panel_shows_one_view_again", async () => {
  const { page, close } = await openBoth(visitor);
  await page.click("#dock .close");
  await page.waitForFunction(() => document.querySelector("#dock").hidden);
  await until(() => middles(page), ({ length }) => length === 0, "views beside each other");
  await close();
});

test("page_that_is_not_isolated_tells_of_means", async () => {
  const search = "?scene=tall_stack&panel=versus&paused=1";
  const { page, close } = await visitor.open(search, DESKTOP, async (page) => {
    await page.context().route("**/*", async (route) => {
      const response = await route.fetch();
      const headers = { ...response.headers() };
      delete headers["cross-origin-opener-policy"];
      delete headers["cross-origin-embedder-policy"];
      await route.fulfill({ response, headers });
    });
  });
  await untilBox2D(page);
  await page.keyboard.press("p");
  await untilMeasured(page);
  const rows = await table(page);
  assert.match(rows["Step, mean"][0], /ms$/);
  assert.equal(rows["Step, p99"], undefined);
  await close();
});

for (const [size, options] of [["desktop", DESKTOP], ["phone", PHONE]])
  test(`axe_finds_no_serious_violation_in_versus_on_${size}`, async () => {
    const { page, close } = await visitor.open("?scene=tall_stack&panel=versus&paused=1", options);
    // The stack is awake for only about a second, so it starts when Box2D is loaded.
    await untilBox2D(page);
    await page.keyboard.press("p");
    await untilMeasured(page);
    await page.keyboard.press("p");
    await page.click("#versus summary");
    assert.deepEqual(await runAxeInBothThemes(page, "#dock"), []);
    await close();
  });
