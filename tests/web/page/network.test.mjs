/**
 * Tests the programs of examples/network: a native server that Node and Chromium join by WebSocket,
 * and native players over ENet. All of a game end with the same hash.
 */
import assert from "node:assert/strict";
import { spawn, spawnSync } from "node:child_process";
import { cpSync, existsSync, mkdirSync, mkdtempSync, rmSync, symlinkSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { WebSocket } from "../../../web/node_modules/ws/wrapper.mjs";
import { playMixed } from "../support/mixed.mjs";
import { root, thud } from "../support/package.mjs";
import { browserOf, PATIENCE } from "../support/page.mjs";

const engine = await thud.load();
const builds = ["release", "release-clang"].map((name) => `${root}build/${name}/examples/network/`);
const programOf = (name) => builds.map((folder) => folder + name).find(existsSync) ?? null;
const skipOf = (program, name) =>
  program ? false : `${name} is not built (./run test native, with what CMake says it needs)`;
const [server, meeting] = [programOf("thud-serve"), programOf("thud-meet")];
const withServer = { skip: skipOf(server, "thud-serve") };
const withMeeting = { skip: skipOf(meeting, "thud-meet") };

const mixed = programOf("../../tests/network/thud-mixed");

/** The examples as a user has them, with the package and ws. */
const folder = mkdtempSync(join(tmpdir(), "thud-network-"));
cpSync(`${root}examples/network`, folder, { recursive: true, filter: (from) => !from.includes("node_modules") });
mkdirSync(join(folder, "node_modules"));
symlinkSync(`${root}web/package`, join(folder, "node_modules", "thud"), "dir");
symlinkSync(`${root}web/node_modules/ws`, join(folder, "node_modules", "ws"), "dir");

const running = new Set();
after(() => {
  for (const process of running) process.kill();
  rmSync(folder, { recursive: true });
});

/** Starts a program. `says(pattern)` waits for a line; `ends()` for the end, and returns what it said. */
function start(program, ...args) {
  const child = spawn(program, args, { cwd: folder, stdio: ["ignore", "pipe", "pipe"] });
  running.add(child);
  let said = "";
  let heard = () => {};
  for (const stream of [child.stdout, child.stderr])
    stream.on("data", (text) => {
      said += text;
      heard();
    });
  const ended = new Promise((resolve) =>
    child.on("close", (code) => {
      running.delete(child);
      resolve(code);
      heard();
    }),
  );
  return {
    child,
    says: (pattern) =>
      new Promise((resolve, reject) => {
        heard = () => {
          const found = pattern.exec(said);
          if (found) resolve(found);
          else if (!running.has(child)) reject(new Error(`${pattern} was not said: ${said}`));
        };
        heard();
      }),
    ends: async () => ({ code: await ended, said }),
  };
}

const joinFromNode = (url, seed, ...more) =>
  start(process.execPath, "join_node.mjs", "--server", url, "--seed", `${seed}`, ...more);

async function serve(...args) {
  const serving = start(server, "--port", "0", "--address", "127.0.0.1", "--rate", "600", ...args);
  const [, url] = await serving.says(/waiting at (ws:\S+)/);
  return { ...serving, url };
}

/** The hash that a program printed, which has ended well. */
async function hashOf(program) {
  const { code, said } = await program.ends();
  assert.equal(code, 0, said);
  return /^hash (\w{16})$/m.exec(said)[1];
}

test("node_plays_with_the_native_server", withServer, async () => {
  const serving = await serve("--steps", "300");
  const hash = await hashOf(joinFromNode(serving.url, 2));
  assert.equal(await hashOf(serving), hash);
});

test("chromium_and_node_play_with_the_native_server", withServer, async () => {
  const files = ["--page", folder, "--package", `${root}web/package/dist`];
  const serving = await serve("--steps", "200", "--players", "3", ...files);
  const context = await (await browserOf("chromium")).newContext();
  const page = await context.newPage();
  await page.goto(`${serving.url.replace("ws:", "http:")}/?seed=3`);
  const hash = await hashOf(joinFromNode(serving.url, 2));
  const isOver = () => /has ended|is over/.test(document.querySelector("#state").textContent);
  await page.waitForFunction(isOver, null, { timeout: PATIENCE });
  assert.equal(await page.textContent("#state"), `The game is over after 200 steps, hash ${hash}`);
  await context.close();
  assert.equal(await hashOf(serving), hash);
});

/** A connection of a test's own, which says hello. */
async function greet(url, hello = thud.writeHello({ watches: false, token: 0n })) {
  const socket = new WebSocket(url, "thud");
  await new Promise((resolve) => socket.once("open", resolve));
  socket.send(hello);
  return socket;
}

test("others_play_on_without_one_who_left", withServer, async () => {
  const serving = await serve("--steps", "200", "--players", "3");
  const player = joinFromNode(serving.url, 2);
  await serving.says(/player 1 has joined/);
  // It plays nothing, so that the others wait until it has left.
  const idle = await greet(serving.url);
  await serving.says(/the game begins/);
  await new Promise((resolve) => idle.once("message", resolve));
  idle.close();
  await serving.says(/player 2 has left before step 0/);
  const hash = await hashOf(player);
  assert.equal(await hashOf(serving), hash);
});

test("who_joins_late_leaves_comes_back_and_watches_ends_with_the_same_hash", withServer, async () => {
  // Long enough for four processes that begin one after the other on a busy machine.
  const serving = await serve("--steps", "3000", "--players", "4", "--wait", "1", "--rate", "120");
  const first = joinFromNode(serving.url, 2);
  await serving.says(/the game begins/);
  const leaves = joinFromNode(serving.url, 3, "--token", "5", "--leave", "400");
  await serving.says(/player 2 has joined at step \d+/);
  const watching = joinFromNode(serving.url, 4, "--watch");
  const { code } = await leaves.ends();
  assert.equal(code, 0);
  const [, left] = await serving.says(/player 2 has left before step (\d+)/);
  const other = joinFromNode(serving.url, 6, "--token", "7");
  await serving.says(/player 3 has joined at step/);
  const back = joinFromNode(serving.url, 5, "--token", "5");
  await serving.says(/player 2 has come back at step/);
  const hashes = await Promise.all([first, watching, other, back, serving].map(hashOf));
  assert.deepEqual(hashes, Array(5).fill(hashes[0]));
  assert.ok(Number(left) >= 200, `it has played until step ${left}`);
});

test("who_sends_other_bytes_is_disconnected", withServer, async () => {
  const serving = await serve("--steps", "200", "--players", "3");
  const player = joinFromNode(serving.url, 2);
  await serving.says(/player 1 has joined/);
  const stranger = await greet(serving.url, new Uint8Array(17));
  await new Promise((resolve) => stranger.once("close", resolve));
  const rude = await greet(serving.url);
  await new Promise((resolve) => rude.once("message", resolve));
  rude.send(new Uint8Array(400));
  await new Promise((resolve) => rude.once("close", resolve));
  const hash = await hashOf(player);
  assert.equal(await hashOf(serving), hash);
});

test("two_players_meet_over_enet", withMeeting, async () => {
  const host = start(meeting, "--listen", "0", "--steps", "300", "--rate", "600");
  const [, port] = await host.says(/at port (\d+)/);
  const hash = await hashOf(start(meeting, "--join", `127.0.0.1:${port}`, "--seed", "2"));
  assert.equal(await hashOf(host), hash);
});

test("who_joins_late_leaves_and_comes_back_over_enet_ends_with_the_same_hash", withMeeting, async () => {
  const game = ["--steps", "1500", "--players", "4", "--wait", "1", "--rate", "120"];
  const host = start(meeting, "--listen", "0", ...game);
  const [, port] = await host.says(/at port (\d+)/);
  const join = (seed, ...more) => start(meeting, "--join", `127.0.0.1:${port}`, "--seed", `${seed}`, ...more);
  const first = join(2);
  await host.says(/player 1 has joined, 0 to come/);
  const leaves = join(3, "--token", "5", "--leave", "400");
  await host.says(/player 2 has joined at step \d+/);
  assert.equal((await leaves.ends()).code, 0);
  const [, left] = await host.says(/player 2 has left before step (\d+)/);
  assert.ok(Number(left) >= 200, `it has played until step ${left}`);
  const other = join(6, "--token", "7");
  await host.says(/player 3 has joined at step/);
  const back = join(5, "--token", "5");
  await host.says(/player 2 has come back at step/);
  // There is no place for one more.
  assert.equal((await join(8).ends()).code, 1);
  const hashes = await Promise.all([first, other, back, host].map(hashOf));
  assert.deepEqual(hashes, Array(4).fill(hashes[0]));
});

/** THUD_NETWORK_STEPS=100000 plays so many steps, and with each number of players. */
const stepsWanted = process.env.THUD_NETWORK_STEPS;
const withMixed = { skip: skipOf(mixed, "thud-mixed") };

for (const players of stepsWanted ? [2, 3, 4, 5, 6, 7, 8] : [2, 3, 8])
  test(`${players}_native_and_wasm_players_have_one_game_and_one_report`, withMixed, async (t) => {
    const [steps, seed] = [Number(stepsWanted ?? 150), 10 + players];
    const game = { program: mixed, examples: folder, thud: engine, players, steps, seed };
    const { code, hash, report, counts, ends, games } = await playMixed(game);
    t.diagnostic(JSON.stringify({ players, steps, ...counts, inWasm: ends.map(({ replayed }) => replayed) }));
    assert.equal(code, 0);
    assert.deepEqual([counts.differ, counts.refused], [0, 0]);
    assert.ok(counts.replayed > 0 && counts.lost > 0 && counts.overtaken > 0);
    for (const end of ends) {
      assert.deepEqual([end.hash, end.differs, end.difference.step], [hash, -1, -1]);
      assert.deepEqual(end.report, report);
      assert.ok(end.replayed > 0);
    }
    // Who joins has the same bytes to tell on, in either direction.
    assert.equal(games.hash, hash);
    assert.deepEqual(games.kept, games.native);
    assert.deepEqual(games.returned, games.given);
  });

for (const [program, name, options, wrong] of [
  [server, "thud-serve", withServer, [["--players", "9"], ["--steps", "many"], ["--port"], ["--fast"]]],
  [meeting, "thud-meet", withMeeting, [[], ["--join", "here"], ["--listen", "99999"], ["--rate", "0"]]],
  [process.execPath, "join_node", withServer, [["--seed", "-1"], ["--server", "here"], ["--fast"]]],
])
  test(`${name}_says_what_is_wrong`, options, () => {
    const before = name === "join_node" ? ["join_node.mjs"] : [];
    const run = (args) => spawnSync(program, [...before, ...args], { cwd: folder, encoding: "utf8" });
    const help = run(["--help"]);
    assert.equal(help.status, 0);
    assert.match(help.stdout, /^usage: .*--help/s);
    for (const args of wrong) {
      const { status, stdout, stderr } = run(args);
      assert.deepEqual([status, stdout], [2, ""], `${args}`);
      assert.match(stderr, new RegExp(`${name}: .*${(args[0] ?? "--join").slice(2)}`), `${args}`);
      assert.equal(stderr.trim().split("\n").length, 1);
    }
  });

test("who_finds_no_server_is_told", withServer, async () => {
  const { code, said } = await joinFromNode("ws://127.0.0.1:9", 1).ends();
  assert.equal(code, 1);
  assert.match(said, /no server answers at ws:\/\/127.0.0.1:9/);
});
