/**
 * Runs the games in examples/games as a user would: played by their robots they must end by their
 * rules, and twice with the same output.
 */
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { cpSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { pathToFileURL } from "node:url";
import { deserialize, serialize } from "node:v8";
import { root, thud } from "../support/package.mjs";

const games = `${root}examples/games`;
const folder = mkdtempSync(join(tmpdir(), "thud-games-"));
after(() => rmSync(folder, { recursive: true }));
cpSync(games, folder, { recursive: true, filter: (path) => !path.includes("node_modules") });
mkdirSync(join(folder, "node_modules"));
symlinkSync(`${root}web/package`, join(folder, "node_modules", "thud"), "dir");

const engine = await thud.load();
const bring = (file) => import(pathToFileURL(join(folder, file)).href);
const { play } = await bring("run.js");
const { settingOf, stepOf } = await bring("step.js");

/** What each game prints in place of numbers, and a condition for these. */
const ENDS = {
  brick_breaker: [
    /^Bricks: 0, Balls: (\d), Capsules: (\d+)\nAll bricks are gone, \1 balls? (?:is|are) left\./,
    ([balls, caught]) => balls > 0 && caught > 0,
  ],
  car: [/^Lap: 2 of 2, Place: (\d) of 3, Time: ([\d.]+) s\n.*\bYou \2 s/, ([place]) => place >= 1 && place <= 3],
  platformer: [/^Coins: 6 of 6, Time: ([\d.]+) s\nThe flag, with 6 of 6 coins\./, ([time]) => time < 20],
  pool: [
    /^You: (-?\d+), Computer: (-?\d+)\nYou win, \1 to \2\./,
    ([you, computer]) => you > computer && you + computer <= 10,
  ],
  rollback: [
    /^You: (\d), Computer: (\d), Run again: (\d+) steps\n.* (?:wins?), \1 to \2\./,
    ([you, computer, again]) => Math.max(you, computer) === 5 && again > 1000,
  ],
  save_load: [/^Bombs: 0, Stones off: (\d+) of 12\nThe castle is yours: \1 stones are off\./, ([off]) => off >= 12],
};

function run(name) {
  const options = { cwd: folder, encoding: "utf8", timeout: 120_000 };
  const { status, stdout, stderr } = spawnSync(process.execPath, ["run.js", name], options);
  assert.equal(status, 0, `${name}: ${stdout}${stderr}`);
  assert.equal(stderr, "");
  return stdout;
}

for (const [name, [says, holds]] of Object.entries(ENDS))
  test(`${name}_ends_by_its_rules_and_twice_alike`, async () => {
    const said = run(name);
    assert.match(said, says);
    const [, ...found] = says.exec(said);
    assert.ok(holds(found.map(Number)), said);
    const { world } = await play(name);
    assert.ok(said.endsWith(`\n${world.stats().steps} steps, ${world.hash()}\n`), said);
  });

test("every_game_is_run", () => {
  const there = readdirSync(games).filter((file) => file.endsWith(".mjs"));
  assert.deepEqual(there.sort(), Object.keys(ENDS).map((name) => `${name}.mjs`).sort());
});

/** A game of the folder, and what plays a number of its steps by its robot. */
async function open(name) {
  const { default: setUp, robot } = await bring(`${name}.mjs`);
  const game = await setUp(settingOf(engine));
  let step = 0;
  return { game, play: (steps) => { for (let end = step + steps; step < end; step++) stepOf(game, step, robot(game)); } };
}

test("castle_saved_to_a_file_goes_on_in_another_game_to_the_same_bits", async () => {
  const one = await open("save_load");
  one.play(400);
  const file = join(folder, "castle.save");
  writeFileSync(file, serialize(one.game.save()));
  const two = await open("save_load");
  two.play(30);
  two.game.load(deserialize(readFileSync(file)));
  assert.equal(two.game.world.hash(), one.game.world.hash());
  for (const { play } of [one, two]) play(900);
  assert.equal(two.game.state.over, true);
  assert.equal(two.game.state.score, one.game.state.score);
  assert.equal(two.game.world.hash(), one.game.world.hash());
});

test("peers_of_the_rollback_have_the_same_hash_of_every_confirmed_step", async () => {
  const { game, play } = await open("rollback");
  play(600);
  assert.ok(game.state.replayed > 300, String(game.state.replayed));
  assert.equal(game.state.unlike, 0);
});
