/**
 * Tests matches between browsers: over WebRTC, with packets that are late and lost, all players’
 * worlds stay the same.
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { DESKTOP, openVisitor, PHONE, runAxeInBothThemes } from "../support/page.mjs";
import { until } from "../support/wait.mjs";

/** The step up to which a match is played. */
const LAST = 240;

/** Sets a slider as a visitor does. */
function slide(page, id, value) {
  return page.locator(id).fill(String(value));
}

/** The last step of which all is known, with its hash, and the figures of the panel by their names. */
function figures(page) {
  return page.evaluate(() => {
    const list = document.querySelector("#match-figures");
    const texts = (tag) => [...list.querySelectorAll(tag)].map(({ textContent }) => textContent);
    const values = texts("dd");
    const rows = Object.fromEntries(texts("dt").map((name, i) => [name, values[i]]));
    return { step: Number(list.dataset.step ?? -1), hash: list.dataset.hash, rows };
  });
}

/** Opens two pages and connects them by a link and its answer, which are copied by hand. */
async function connect(first, second, scene = "sumo") {
  const host = await openVisitor({ browser: first }).open(`?scene=${scene}&panel=match`);
  await host.page.click("#match-invite");
  const link = await host.page.inputValue("#match-link");
  const { search, hash } = new URL(link);
  const guest = await openVisitor({ browser: second }).open(search + hash);
  await guest.page.click("#match-join");
  await host.page.fill("#match-answer", await guest.page.inputValue("#match-link"));
  await host.page.waitForSelector("#match-start:visible");
  await guest.page.waitForSelector("#match-leave:visible");
  return [host, guest];
}

test("chromium_and_firefox_play_a_match_over_a_bad_line_and_stay_the_same", async () => {
  const both = await connect("chromium", "firefox");
  const pages = both.map(({ page }) => page);
  for (const page of pages) {
    await slide(page, "#match-delay", 60);
    await slide(page, "#match-loss", 10);
  }
  await pages[0].click("#match-start");
  // Each drives to and fro by itself; what is final is compared step by step.
  const seen = pages.map(() => new Map());
  const common = () => [...seen[0].keys()].filter((step) => step > 0 && seen[1].has(step));
  let held = false;
  await until(
    async () => {
      held = !held;
      for (const page of pages) {
        await page.locator("#overlay").focus();
        await (held ? page.keyboard.down("ArrowRight") : page.keyboard.up("ArrowRight"));
      }
      const told = await Promise.all(pages.map(figures));
      told.forEach(({ step, hash }, i) => seen[i].set(step, hash));
      return told;
    },
    // What both have told of one step is compared, so that they have to tell of one.
    (told) => told.every(({ step }) => step >= LAST) && common().length > 0,
    `a match of ${LAST} steps`,
  );
  for (const step of common()) assert.equal(seen[0].get(step), seen[1].get(step), `step ${step}`);
  for (const { page, errors } of both) {
    const { rows } = await figures(page);
    assert.ok(Number(rows["Equal states"]) > 5, JSON.stringify(rows));
    assert.ok(Number(rows["Rollbacks"]) > 0, "nothing was late");
    assert.ok(Number.parseInt(rows["There and back"], 10) >= 100, JSON.stringify(rows));
    assert.equal(rows["Refused packets"], "0");
    assert.equal(await page.textContent(".match .bad"), "");
    assert.deepEqual(errors, []);
  }
  for (const { close } of both) await close();
});

test("answer_that_is_opened_as_a_link_reaches_the_tab_that_waits_and_who_leaves_is_missed", async () => {
  const visitor = openVisitor();
  const host = await visitor.open("?scene=sumo&panel=match");
  await host.page.click("#match-invite");
  await host.page.waitForSelector(".match .qr");
  assert.deepEqual(await runAxeInBothThemes(host.page, "#dock"), []);
  const { search, hash } = new URL(await host.page.inputValue("#match-link"));
  const guest = await visitor.open(search + hash, PHONE);
  await guest.page.tap("#match-join");
  const answer = new URL(await guest.page.inputValue("#match-link"));
  const tab = await host.page.context().newPage();
  await tab.goto(answer.href);
  await tab.waitForSelector('#match-offer:has-text("The answer has arrived")');
  await tab.close();
  await host.page.click("#match-start");
  // On a phone the panel makes room for the buttons.
  await guest.page.waitForSelector("#dock", { state: "hidden" });
  await guest.page.waitForSelector('#message:has-text("Yours is the blue car")');
  await until(() => figures(host.page), ({ step }) => step >= 30, "the match runs");
  assert.deepEqual(await runAxeInBothThemes(host.page, "#dock"), []);
  await guest.page.tap("[data-panel=match]");
  await guest.page.tap("#match-leave");
  await host.page.waitForSelector('#message:has-text("The match is over")');
  await host.page.click("#match-leave");
  // Both play alone again.
  for (const { page, errors, close } of [host, guest]) {
    await page.waitForSelector("#match-invite:visible");
    await page.waitForSelector('#figures:has-text("Computer")');
    assert.deepEqual(errors, []);
    await close();
  }
});

test("browsers_meet_in_a_room_of_the_server", async () => {
  const visitor = openVisitor();
  const host = await visitor.open("?scene=sumo&panel=match");
  await host.page.fill("#match-room", "Our room");
  await host.page.click("#match-meet");
  await host.page.waitForSelector('#notice:has-text("letters from a to z")');
  await host.page.fill("#match-room", "our-room");
  await host.page.click("#match-meet");
  const { search, hash } = new URL(await host.page.inputValue("#match-link"));
  assert.equal(hash, "#invite=~our-room");
  // Who invites has to be in the room before the other comes, who would invite as well.
  await host.page.waitForResponse((response) => response.url().endsWith("our-room/answer"));
  const guest = await visitor.open(search + hash);
  await guest.page.click("#match-join");
  for (const { page } of [host, guest]) await page.waitForSelector("#match-leave:visible");
  assert.ok(await host.page.isVisible("#match-start"));
  assert.ok(await guest.page.isHidden("#match-start"));
  await guest.page.click("#match-leave");
  await host.page.waitForSelector("#match-leave", { state: "hidden" });
  for (const { errors, close } of [host, guest]) {
    assert.deepEqual(errors, []);
    await close();
  }
});

test("artillery_is_a_duel_of_chromium_and_firefox_over_a_bad_line", async () => {
  const both = await connect("chromium", "firefox", "artillery");
  const pages = both.map(({ page }) => page);
  for (const page of pages) {
    // Longer than a step takes where other tests leave little time, so that inputs do come late.
    await slide(page, "#match-delay", 240);
    await slide(page, "#match-loss", 10);
  }
  await pages[0].click("#match-start");
  await pages[0].waitForSelector('#message:has-text("Your turn")');
  await pages[1].waitForSelector('#message:has-text("Left aims")');
  const seen = pages.map(() => new Map());
  // Both hold keys, of which only those of whoever has the turn count.
  for (const page of pages) {
    await page.locator("#overlay").focus();
    await page.keyboard.down("ArrowUp");
    await page.keyboard.down("ArrowLeft");
  }
  await playOn(pages, seen, 60);
  for (const page of pages) {
    await page.keyboard.up("ArrowUp");
    await page.keyboard.up("ArrowLeft");
  }
  // The key is held until both have seen the shot, however slow they are.
  const fire = async (page) => {
    const seen = Promise.all(pages.map((one) => one.waitForSelector('#message:has-text("Fire!")')));
    await page.locator("#overlay").focus();
    await page.keyboard.down("Space");
    await seen;
    await page.keyboard.up("Space");
  };
  await pages[1].locator("#overlay").focus();
  await pages[1].keyboard.press("Space", { delay: 200 });
  await fire(pages[0]);
  await pages[1].waitForSelector('#message:has-text("Your turn")');
  await fire(pages[1]);
  await playOn(pages, seen, 120);
  for (const { page, errors } of both) {
    const { rows } = await figures(page);
    assert.ok(Number(rows["Equal states"]) > 5, JSON.stringify(rows));
    assert.ok(Number(rows.Rollbacks) > 0, "nothing was late");
    assert.deepEqual(errors, []);
  }
  for (const { close } of both) await close();
});

/** Plays so many steps, notes in `seen` what each page tells, and compares all that several have told. */
async function playOn(pages, seen, steps) {
  const common = () =>
    seen.flatMap((one, i) => [...one.keys()].filter((step) => step > 0 && seen[(i + 1) % seen.length].has(step)));
  const from = Math.max(...(await Promise.all(pages.map(figures))).map(({ step }) => step));
  await until(
    async () => {
      const told = await Promise.all(pages.map(figures));
      told.forEach(({ step, hash }, i) => seen[i].set(step, hash));
      return told;
    },
    // What several have told of one step is compared, so that they have to tell of one.
    (told) => told.every(({ step }) => step >= from + steps) && common().length > 0,
    `${steps} steps more`,
  );
  for (const [i, one] of seen.entries())
    for (const [step, hash] of one)
      for (const other of seen.slice(i + 1))
        if (step > 0 && other.has(step)) assert.equal(other.get(step), hash, `step ${step}`);
  for (const page of pages) {
    const { rows } = await figures(page);
    assert.equal(rows["Refused packets"], "0");
    assert.equal(await page.textContent(".match .bad"), "");
  }
}

/** Opens a page that invites to a room, and returns how others come into it. */
async function openRoom(name, browser = "chromium") {
  const host = await openVisitor({ browser }).open("?scene=sumo&panel=match");
  await host.page.fill("#match-room", name);
  await host.page.click("#match-meet");
  const { search, hash } = new URL(await host.page.inputValue("#match-link"));
  /** Who invites has to be in the room before another comes, who would invite as well. */
  const join = async (inviting, { button = "#match-join", browser = "chromium", options = DESKTOP } = {}) => {
    await inviting.page.waitForResponse((response) => response.url().endsWith(`${name}/answer`));
    const guest = await openVisitor({ browser }).open(search + hash, options);
    await guest.page.click(button);
    return guest;
  };
  return { host, join };
}

/**
 * Three browsers that connect twice take minutes beside other tests, or do not connect in time there.
 * What a match does without its host tests/web/worker/match.test.mjs tests, too.
 */
const skip = process.env.THUD_FULL !== "1" && "in ./run test --full";

test("match_goes_on_when_its_host_is_gone_for_who_plays_and_who_watches_and_the_host_comes_back", { skip }, async () => {
  const { host, join } = await openRoom("left-room");
  const guest = await join(host);
  await host.page.waitForSelector("#match-start:visible");
  await host.page.click("#match-start");
  await playOn([host.page, guest.page], [new Map(), new Map()], 30);

  const watcher = await join(host, { button: "#match-watch", options: PHONE });
  await host.page.waitForSelector('#notice:has-text("Somebody has come to watch")');
  await host.page.waitForSelector('.match .who:has-text("one other and one who watches")');
  await watcher.page.waitForSelector('#notice:has-text("You watch the match")');
  // On a phone the panel makes room.
  await watcher.page.waitForSelector("#dock", { state: "hidden" });
  await watcher.page.waitForSelector('.match .who:has-text("You watch the match")', { state: "attached" });
  // Who watches has no car, and no buttons for one.
  await watcher.page.waitForSelector('#figures:has-text("Orange"):has-text("Blue")');
  assert.doesNotMatch(await watcher.page.textContent("#figures"), /You|Green/);
  assert.equal(await watcher.page.locator("#pad button:visible").count(), 0);
  const pages = [host, guest, watcher].map(({ page }) => page);
  await playOn(pages, pages.map(() => new Map()), 60);

  await host.page.reload();
  await guest.page.waitForSelector('#notice:has-text("You carry the match on")');
  await watcher.page.waitForSelector('#notice:has-text("Player 2 carries the match on")');
  await guest.page.waitForSelector('.match .who:has-text("you carry the match on, alone")');
  await guest.page.waitForSelector('#message:has-text("Waiting for another player")');
  await playOn(pages.slice(1), pages.slice(1).map(() => new Map()), 60);
  assert.deepEqual(await runAxeInBothThemes(guest.page, "#dock"), []);

  await host.page.click("#match-join");
  await guest.page.waitForSelector('#notice:has-text("Player 1 has joined")');
  await host.page.waitForSelector('#figures:has-text("You"):has-text("Blue")');
  // Who comes has made up for what was played before, and nobody waits for it.
  const steps = () => Promise.all([host, guest].map(({ page }) => page.locator("#hud").getAttribute("data-steps")));
  await until(steps, ([joined, there]) => Math.abs(joined - there) < 45, "it is where the others are");
  await playOn(pages, pages.map(() => new Map()), 60);
  assert.match(await host.page.textContent("#figures"), /You.*Blue/);

  // Who is left without players can come back, and sees on a phone how, also when the page is loaded anew.
  await host.page.click("#match-leave");
  await guest.page.waitForSelector('#notice:has-text("Player 1 has left")');
  await guest.page.click("#match-leave");
  await watcher.page.waitForSelector('#match-join:visible:has-text("Come back")');
  await watcher.page.waitForSelector('#message:has-text("The match is over")');
  await watcher.page.reload();
  await watcher.page.waitForSelector('#match-join:visible:has-text("Come back")');
  for (const { errors, close } of [host, guest, watcher]) {
    assert.deepEqual(errors, []);
    await close();
  }
});

test("third_player_joins_a_match_that_runs_and_one_whose_page_was_reloaded_comes_back", { skip }, async () => {
  const room = "?scene=sumo&panel=match";
  const host = await openVisitor({ browser: "chromium" }).open(room);
  await host.page.fill("#match-room", "late-room");
  await host.page.click("#match-meet");
  const { search, hash } = new URL(await host.page.inputValue("#match-link"));
  const join = async (browser) => {
    await host.page.waitForResponse((response) => response.url().endsWith("late-room/answer"));
    const guest = await openVisitor({ browser }).open(search + hash);
    await guest.page.click("#match-join");
    return guest;
  };
  const second = await join("chromium");
  await host.page.waitForSelector("#match-start:visible");
  await host.page.click("#match-start");
  const pages = [host.page, second.page];
  await playOn(pages, pages.map(() => new Map()), 60);
  assert.match(await host.page.textContent("#figures"), /You.*Blue/);
  assert.doesNotMatch(await host.page.textContent("#figures"), /Green/);

  const third = await join("firefox");
  await host.page.waitForSelector('#notice:has-text("Player 3 has joined")');
  pages.push(third.page);
  await host.page.waitForSelector('#figures:has-text("Green")');
  await playOn(pages, pages.map(() => new Map()), 120);
  assert.match(await third.page.textContent("#figures"), /Orange.*Blue.*You/);

  await second.page.reload();
  await host.page.waitForSelector('#notice:has-text("Player 2 has left")');
  await second.page.click("#match-join");
  await host.page.waitForSelector('#notice:has-text("Player 2 has come back")');
  await second.page.waitForSelector('#figures:has-text("You")');
  await playOn(pages, pages.map(() => new Map()), 120);
  assert.match(await second.page.textContent("#figures"), /Orange.*You.*Green/);
  for (const { errors, close } of [host, second, third]) {
    assert.deepEqual(errors, []);
    await close();
  }
});

test("three_play_on_when_the_host_of_four_is_gone_and_once_more_when_the_next_is", { skip }, async () => {
  const { host, join } = await openRoom("four-room");
  const guests = [];
  for (const browser of ["chromium", "chromium", "firefox"]) {
    guests.push(await join(host, { browser }));
    const count = guests.length === 1 ? "one other" : `${guests.length} others`;
    await host.page.waitForSelector(`.match .who:has-text("Connected: ${count}.")`);
  }
  await host.page.click("#match-start");
  const pages = guests.map(({ page }) => page);
  await playOn([host.page, ...pages], [host.page, ...pages].map(() => new Map()), 120);
  await host.close();
  await pages[0].waitForSelector('#notice:has-text("You carry the match on")');
  for (const page of pages.slice(1)) await page.waitForSelector('#notice:has-text("Player 2 carries the match on")');
  await playOn(pages, pages.map(() => new Map()), 120);
  assert.match(await pages[2].textContent("#figures"), /Blue.*Green.*You/);
  // Who leaves by the button has left, too.
  await pages[0].click("#match-leave");
  await pages[1].waitForSelector('#notice:has-text("You carry the match on")');
  await playOn(pages.slice(1), pages.slice(1).map(() => new Map()), 120);
  for (const { errors, close } of guests) {
    assert.deepEqual(errors, []);
    await close();
  }
});

test("damaged_invitation_says_so_and_an_answer_for_nobody_too", async () => {
  const visitor = openVisitor();
  const host = await visitor.open("?scene=sumo#invite=AAAA");
  await host.page.waitForSelector('#match-offer:has-text("damaged")');
  await host.page.click("#match-invite");
  await host.page.fill("#match-answer", "Hello");
  await host.page.waitForSelector('#notice:has-text("no answer")');
  const link = await host.page.inputValue("#match-link");
  await host.page.fill("#match-answer", link);
  await host.page.waitForSelector('#notice:has-text("another invitation")');
  assert.deepEqual(host.errors, []);
  await host.close();
});
