/**
 * Tests recordings on the page: one of thud-run plays, is sought in and forked; one that the page
 * made replays in thud-run; a difference is named; wrong files leave what runs alone.
 */
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, describe, test } from "node:test";
import { untilStatus } from "../support/code.mjs";
import { skip, thudRun } from "../support/native.mjs";
import { root, thud } from "../support/package.mjs";
import {
  BROWSERS,
  DESKTOP,
  drawn,
  failureText,
  figure,
  leftOut,
  openVisitor,
  PHONE,
  pressed,
  runAxeInBothThemes,
  stepBy,
  untilBodies,
  untilRunning,
} from "../support/page.mjs";
import { until, untilFigures, untilOverlay, untilStep } from "../support/wait.mjs";

const { Player, Recorder } = await import(`${root}web/package/dist/recording.js`);
const engine = await thud.load(new URL(`file://${root}web/package/dist/thud-recorded.wasm`));

const folder = mkdtempSync(join(tmpdir(), "thud-"));
after(() => rmSync(folder, { recursive: true }));

/** Steps of each recording here. */
const STEPS = 40;

/** A ball that falls beside others. With `tamper` its velocity changes after step 20 by no call,
 * so that the recording differs from then on. `shown`: the text that tells the page how to show it.
 * `calls`: in step 21 it is pushed and a ray is cast to it, and in step 31 a big ball joins it. */
function ballRecording({ tamper = false, shown = null, calls = false } = {}) {
  const world = engine.createWorld();
  for (let i = 0; i < 3; i++)
    world.createCircle(world.createBody({ kind: "dynamic", position: [3 * i, 5] }), { radius: 1 });
  const [, ball] = world.bodies();
  const recorder = new Recorder(world, { hashSteps: 1, bodyHashes: true, queries: true });
  if (shown !== null) recorder.chunk("thud-page", Buffer.from(shown));
  for (let step = 0; step < STEPS; step++) {
    if (tamper && step === 20) changeInMemory(world, ball);
    if (calls && step === 20) {
      world.setVelocity(ball, [0.5, 0]);
      world.castRay([3, 20], [0, -30]);
    }
    if (calls && step === 30)
      world.createCircle(world.createBody({ kind: "dynamic", position: [3, 12] }), { radius: 3 });
    world.step();
  }
  const bytes = Buffer.from(recorder.bytes());
  recorder.end();
  world.close();
  return bytes;
}

/** Changes the velocity of a body in the engine's memory. */
function changeInMemory(world, body) {
  const { velocity } = world.bodyStateOf(body);
  const numbers = new Float32Array(engine.buffer);
  const isAt = (i) => numbers[i] === velocity[0] && numbers[i + 1] === velocity[1];
  for (let i = 0; i < numbers.length && world.bodyStateOf(body).velocity[0] !== 5; i++) {
    if (!isAt(i)) continue;
    const before = numbers[i];
    numbers[i] = 5;
    if (world.bodyStateOf(body).velocity[0] !== 5) numbers[i] = before;
  }
  assert.equal(world.bodyStateOf(body).velocity[0], 5);
}

/** A recording of thud-run. */
function nativeRecording(scene) {
  const file = join(folder, `${scene}.rec`);
  execFileSync(thudRun, [scene, "--steps", String(STEPS), "--record", file], { cwd: root });
  return readFileSync(file);
}

/** Opens a file, as a visitor does. */
async function openFile(page, name, buffer) {
  await page.waitForSelector("[data-entry]", { state: "attached" });
  await page.setInputFiles("#level-file", { name, mimeType: "application/octet-stream", buffer });
}

/** Opens a recording and waits until it has played to its end. */
async function playToEnd(page, name, buffer) {
  await openFile(page, name, buffer);
  await untilStep(page, STEPS);
  await page.waitForSelector('#pause[aria-pressed="true"]');
}

/** Acts by keyboard in the middle of the view, with the tool of a key. */
async function act(page, tool) {
  await page.focus("#overlay");
  await page.keyboard.press(tool);
  // The first press shows the middle.
  await page.keyboard.press("Enter");
  await page.keyboard.press("Enter");
}

/** Lets the page keep what it offers as a file. */
const keepBlobs = (page) =>
  page.addInitScript(() => {
    const { createObjectURL } = URL;
    URL.createObjectURL = (blob) => createObjectURL.call(URL, (window.kept = blob));
  });

/** The bytes of the file that the page saves when `press` is done. The protocol that drives Firefox
 * tells of no downloads, so there it is what the page offers. */
async function savedBy(page, browser, press) {
  if (browser === "firefox") {
    await press();
    await page.waitForFunction(() => window.kept);
    const text = await page.evaluate(async () => {
      const bytes = new Uint8Array(await window.kept.arrayBuffer());
      return Array.from(bytes, (byte) => String.fromCharCode(byte)).join("");
    });
    return Buffer.from(text, "latin1");
  }
  const [download] = await Promise.all([page.waitForEvent("download"), press()]);
  assert.match(download.suggestedFilename(), /\.rec$/);
  return readFileSync(await download.path());
}

/** Moves the time slider to a step. */
async function seek(page, step) {
  await page.fill("#time", String(step));
  await untilStep(page, step);
}

const figures = (page) => page.innerText("#figures");

for (const browser of BROWSERS)
  describe(browser, () => {
    /** For tests of what the page's own code decides. */
    const LOGIC = { skip: leftOut(browser) };
    const visitor = openVisitor({ browser });

    test("recording_of_thud_run_plays_to_its_end_is_sought_in_and_forked", { skip }, async () => {
      const { page, errors, close } = await visitor.open("?scene=cradle");
      await untilRunning(page);
      await playToEnd(page, "chain.rec", nativeRecording("chain"));
      assert.match(await page.title(), /^chain/);
      assert.match(await figures(page), new RegExp(`${STEPS} of ${STEPS}`));
      await seek(page, 12);
      assert.match(await figures(page), /12 of 40/);
      await page.focus("#fork");
      await page.keyboard.press("Enter");
      await page.waitForFunction(() => /^chain, from step 12 on/.test(document.title));
      await page.waitForSelector("#to-recording:focus");
      assert.ok(await page.isHidden("#figures"), "nothing is compared with the recording any more");
      await page.focus("#overlay");
      await page.keyboard.press(".");
      await untilStep(page, 1);
      await page.click("#to-recording");
      await untilStep(page, 12);
      await page.click("#step");
      await untilStep(page, 13);
      assert.deepEqual(errors, []);
      await close();
    });

    test("recording_of_the_page_replays_in_thud_run_and_on_the_page", { skip }, async () => {
      const { page, errors, close } = await visitor.open("?scene=tall_stack", DESKTOP, keepBlobs);
      await untilRunning(page);
      await untilFigures(page);
      const before = await figure(page, "bodies");
      // What the visitor does is recorded, too.
      await act(page, "b");
      const stepsMade = () => page.evaluate(() => Number(document.querySelector("#hud").dataset.steps));
      const met = await stepsMade();
      await until(stepsMade, (steps) => steps > met + STEPS, "it has run");
      await page.click("#pause");
      await page.waitForSelector('#pause[aria-pressed="true"]');
      await untilBodies(page, before + 1);
      await page.keyboard.press("o");
      const file = join(folder, `${browser}.rec`);
      writeFileSync(file, await savedBy(page, browser, () => page.click("#record")));
      // The worker makes steps until it hears of the pause; the file comes after the last of them.
      const steps = await page.getAttribute("#hud", "data-steps");
      const replay = execFileSync(thudRun, ["--replay", file, "--json"], { encoding: "utf8" });
      const { steps: replayed, hashes } = JSON.parse(replay);
      assert.equal(String(replayed), steps);
      assert.ok(hashes > 10, `${hashes} hashes`);
      const player = new Player(engine, new Uint8Array(readFileSync(file)));
      player.step();
      const [{ name, bytes }] = player.chunks;
      player.close();
      assert.equal(name, "thud-page");
      const { view, lengthScale } = JSON.parse(Buffer.from(bytes).toString());
      assert.ok(view.height > 1 && lengthScale === 1, "it says how it was shown");
      await openFile(page, "again.rec", readFileSync(file));
      await page.waitForFunction(() => /^again/.test(document.title));
      await untilStep(page, Number(steps));
      await untilBodies(page, before + 1);
      assert.deepEqual(errors, []);
      await close();
    });

    test("difference_in_a_file_that_is_dropped_names_the_step_and_the_body", LOGIC, async () => {
      const { page, errors, close } = await visitor.open("?scene=cradle");
      // Dropped, and known by what is in it.
      await page.waitForSelector("[data-entry]", { state: "attached" });
      await page.evaluate((bytes) => {
        const dataTransfer = new DataTransfer();
        dataTransfer.items.add(new File([new Uint8Array(bytes)], "tampered.dat"));
        document.dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true }));
      }, [...ballRecording({ tamper: true })]);
      const told = /Step 21 is not what was recorded.*body that differs is number 1,/;
      await until(() => page.textContent("#message"), (text) => told.test(text), String(told));
      await page.waitForSelector('#pause[aria-pressed="true"]');
      await seek(page, 5);
      assert.ok(await page.isHidden("#message"), "up to there all is as it was recorded");
      assert.deepEqual(errors, []);
      await close();
    });

    test("recording_is_shown_as_it_says_and_nonsense_is_passed_over", LOGIC, async () => {
      const { page, errors, close } = await visitor.open("?scene=cradle");
      const view = { x: 1000, y: 5, height: 12, width: 12 };
      await playToEnd(page, "far.rec", ballRecording({ shown: JSON.stringify({ view }) }));
      await until(() => drawn(page), ({ count }) => count === 0, "the balls are out of sight");
      for (const shown of ["nonsense", '{"view":{"x":"far"}}', '{"view":null,"lengthScale":-1}']) {
        await playToEnd(page, "near.rec", ballRecording({ shown }));
        await until(() => drawn(page), ({ count }) => count > 100, `${shown}: all is in sight`);
      }
      assert.deepEqual(errors, []);
      await close();
    });

    test("calls_of_a_step_are_listed_and_drawn", LOGIC, async () => {
      for (const options of [DESKTOP, PHONE]) {
        const { page, errors, close } = await visitor.open("?scene=cradle", options);
        const view = { x: 3, y: 5, height: 30, width: 20 };
        const shown = JSON.stringify({ view });
        await playToEnd(page, "ball.rec", ballRecording({ calls: true, shown }));
        await seek(page, 21);
        await untilOverlay(page, (count) => count === 0, "nothing is drawn of calls");
        await page.click("#calls-button");
        const list = () => page.innerText("#played-calls");
        await until(list, (text) => text.startsWith("Calls of step 21: 2"), "step 21");
        assert.match(await list(), /body_set_velocity\(#1, 0.5, 0, 0\)\s+world_cast_ray\(3, 20, 0, -30, .*\): 1 hit/);
        await untilOverlay(page, (count) => count > 50, "the ray, its hit and a ring");
        assert.deepEqual(await runAxeInBothThemes(page, "#bottom"), []);
        const { x, width } = await page.locator("#played").boundingBox();
        assert.ok(x >= 0 && x + width <= options.viewport.width, `${x}, ${width}`);
        await seek(page, 20);
        await until(list, (text) => /step 20: 0\s+none/.test(text), "step 20");
        await untilOverlay(page, (count) => count === 0, "nothing in step 20");
        // The list goes with the recording, and comes back with it.
        await page.click("#fork");
        await page.waitForSelector("#played-calls", { state: "hidden" });
        await page.click("#to-recording");
        await page.waitForSelector("#played-calls");
        await page.click("#calls-button");
        await page.waitForSelector("#played-calls", { state: "hidden" });
        assert.deepEqual(errors, []);
        await close();
      }
    });

    test("body_that_comes_in_the_midst_of_a_recording_is_drawn_from_then_on", LOGIC, async () => {
      const { page, errors, close } = await visitor.open("?scene=cradle");
      const shown = JSON.stringify({ view: { x: 3, y: 5, height: 30, width: 20 } });
      await playToEnd(page, "ball.rec", ballRecording({ calls: true, shown }));
      const pixels = () => drawn(page).then(({ count }) => count);
      await untilBodies(page, 4);
      const all = await pixels();
      await seek(page, 30);
      // The big ball has three times the area of the three others.
      await until(pixels, (count) => count < all / 2, "it is not there in step 30");
      await seek(page, 31);
      await until(pixels, (count) => count > 0.8 * all, "it is there in step 31");
      assert.deepEqual(errors, []);
      await close();
    });

    test("video_of_what_was_seen_is_saved_and_the_scene_goes_on", async () => {
      const { page, errors, close } = await visitor.open("?scene=cradle&paused=1", DESKTOP, keepBlobs);
      await stepBy(page, STEPS);
      await page.keyboard.press("o");
      await page.click("#save-video");
      await page.waitForSelector("#stop-film:focus");
      assert.ok(await page.isHidden("#dock"), "the panel covers nothing");
      await page.waitForFunction(() => window.kept);
      await page.waitForSelector("#filming", { state: "detached" });
      await untilStep(page, STEPS);
      const [type, size, magic] = await page.evaluate(async () => {
        const { kept } = window;
        return [kept.type, kept.size, [...new Uint8Array(await kept.slice(0, 4).arrayBuffer())]];
      });
      assert.match(type, /^video\/webm/);
      // A container of Matroska begins so.
      assert.deepEqual(magic, [0x1a, 0x45, 0xdf, 0xa3]);
      assert.ok(size > 5000, `${size} bytes`);
      // It can be stopped, and what ran goes on.
      await page.click("#pause");
      await until(() => figure(page, "awake"), () => true, "it runs");
      await page.keyboard.press("o");
      await page.evaluate(() => (window.kept = null));
      await page.click("#save-video");
      await page.click("#stop-film");
      await page.waitForFunction(() => window.kept);
      await page.waitForSelector("#filming", { state: "detached" });
      await page.waitForSelector('#pause[aria-pressed="false"]');
      assert.deepEqual(errors, []);
      await close();
    });

    test("video_is_made_by_the_next_encoder_if_the_first_gives_nothing", LOGIC, async () => {
      /** Lets the first `count` recorders of the page give no bytes. */
      const mute = (count) => async (page) => {
        await keepBlobs(page);
        await page.addInitScript((mutes) => {
          window.recorders = 0;
          const { start } = MediaRecorder.prototype;
          MediaRecorder.prototype.start = function (slice) {
            if (window.recorders++ < mutes) this.ondataavailable = null;
            start.call(this, slice);
          };
        }, count);
      };
      for (const [mutes, recorders] of [
        [1, 2],
        [9, 1],
      ]) {
        const { page, errors, close } = await visitor.open("?scene=cradle&paused=1", DESKTOP, mute(mutes));
        await stepBy(page, STEPS);
        await page.keyboard.press("o");
        await page.click("#save-video");
        await page.waitForSelector("#stop-film");
        // Who stops it does not wait for another encoder.
        if (recorders === 1) await page.click("#stop-film");
        await page.waitForSelector("#filming", { state: "detached" });
        const [made, size] = await page.evaluate(() => [window.recorders, window.kept?.size ?? 0]);
        assert.equal(made, recorders);
        if (mutes === 1) {
          assert.ok(size > 5000, `${size} bytes`);
          await untilStep(page, STEPS);
        } else {
          assert.equal(size, 0, "a file without a picture is not saved");
          assert.match(await page.textContent("#notice"), /no video: the browser's encoder has given nothing/);
        }
        assert.deepEqual(errors, []);
        await close();
      }
    });

    test("scene_that_stops_by_an_error_offers_a_recording_of_what_led_to_it", LOGIC, async () => {
      const scene = `export const title = "Stops";
        export default function ({ createWorld }) {
          const world = createWorld();
          const ball = world.createBody({ kind: "dynamic", position: [0, 9], velocity: [0, 1] });
          world.createCircle(ball, { radius: 1 });
          const update = ({ step }) => {
            world.applyCenterForce(ball, [step % 3, 0]);
            if (step === 30) throw new Error("no more");
          };
          return { world, update, view: { x: 0, y: 0, height: 20 } };
        }`;
      const replace = async (page) => {
        await keepBlobs(page);
        await page.route("**/scenes/cradle.js*", (route) =>
          route.fulfill({ body: scene, contentType: "text/javascript" }),
        );
      };
      const { page, errors, close } = await visitor.open("?scene=cradle", DESKTOP, replace);
      await until(() => page.textContent("#notice"), (text) => /stopped: no more/.test(text), "it stops");
      const bytes = await savedBy(page, browser, () => page.click("#save-stopped"));
      const player = new Player(engine, new Uint8Array(bytes), { calls: true });
      player.seek(player.progress.end);
      assert.equal(player.progress.end, 30);
      assert.equal(player.progress.difference, null);
      player.close();
      assert.deepEqual(errors, []);
      await close();
    });

    test("recording_cannot_be_changed_and_says_so", LOGIC, async () => {
      const { page, errors, close } = await visitor.open("?scene=cradle");
      await playToEnd(page, "ball.rec", ballRecording());
      await seek(page, 10);
      await act(page, "n");
      const told = /plays as it was made/;
      await until(() => page.textContent("#message"), (text) => told.test(text), String(told));
      await page.keyboard.press("o");
      await page.click("#record");
      await until(
        () => page.textContent("#notice"),
        (text) => /a recording already/.test(text),
        "it is not recorded again",
      );
      await page.keyboard.press("k");
      await page.waitForSelector(".code-status");
      await untilStatus(page, "A recording has no code.");
      assert.deepEqual(errors, []);
      await close();
    });

    test("damaged_and_foreign_files_leave_what_runs_alone", LOGIC, async () => {
      const { page, close } = await visitor.open("?scene=cradle&paused=1");
      await openFile(page, "foreign.rec", Buffer.from("a text"));
      const told = /“foreign.rec” is no recording/;
      await until(() => page.textContent("#notice"), (text) => told.test(text), String(told));
      const damaged = ballRecording();
      damaged[damaged.length - 20] ^= 1;
      for (const bytes of [damaged, ballRecording().subarray(0, 200)]) {
        await openFile(page, "damaged.rec", bytes);
        assert.match(await failureText(page), /recording cannot be run[^]*damaged or cut short/);
        await page.click("#failure button");
        await page.waitForSelector("#failure", { state: "hidden" });
        assert.match(await page.title(), /^Rows of elastic/);
        assert.ok(await page.isHidden("#played"));
      }
      await page.click("#step");
      await untilStep(page, 1);
      await close();
    });

    test("bar_of_a_recording_is_accessible_fits_a_phone_and_goes_with_it", LOGIC, async () => {
      for (const options of [DESKTOP, PHONE]) {
        const { page, close } = await visitor.open("?scene=cradle", options);
        await playToEnd(page, "ball.rec", ballRecording());
        assert.deepEqual(await runAxeInBothThemes(page, "#bottom"), []);
        const { x, width } = await page.locator("#played").boundingBox();
        assert.ok(x >= 0 && x + width <= options.viewport.width, `${x}, ${width}`);
        await page.selectOption("#played-speed", "0.25");
        await page.waitForFunction(() => location.search.includes("speed=0.25"));
        await page.click("#restart");
        await untilStep(page, 0);
        assert.ok(await pressed(page, "pause"));
        await page.click("#scenes-button");
        await page.click('[data-entry="tumbler"]');
        await page.waitForSelector("#played", { state: "hidden" });
        await close();
      }
    });

    test("link_to_a_recording_says_that_it_holds_none", LOGIC, async () => {
      const { page, close } = await visitor.open("?scene=recording");
      assert.match(await failureText(page), /recording is not in this link/);
      await page.click("#failure button");
      await untilRunning(page);
      await close();
    });
  });
