/**
 * Runs the games in examples/games as a user would: they must end by their rules, and twice with
 * the same output.
 */
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { copyFileSync, mkdirSync, mkdtempSync, readdirSync, rmSync, symlinkSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { root } from "../support/package.mjs";

const games = `${root}examples/games`;
const folder = mkdtempSync(join(tmpdir(), "thud-games-"));
after(() => rmSync(folder, { recursive: true }));
mkdirSync(join(folder, "node_modules"));
symlinkSync(`${root}web/package`, join(folder, "node_modules", "thud"), "dir");

/** What each game prints, and a condition for its numbers. */
const ENDS = {
  "brick-breaker": [
    /^0 bricks and (\d) balls left, (\d+) capsules caught\n([\d.]+) s, \w{16}\n$/,
    ([balls, caught]) => balls > 0 && caught > 0,
  ],
  car: [
    /^1\. \w+, ([\d.]+) s\n2\. \w+, ([\d.]+) s\n3\. \w+, ([\d.]+) s\n\w{16}\n$/,
    ([first, second, third]) => first <= second && second <= third,
  ],
  platformer: [
    /^reached the flag with (\d) coins\n([\d.]+) s, \w{16}\n$/,
    ([coins]) => coins === 6,
  ],
  pool: [
    /^Ada (-?\d+), Bob (-?\d+) after (\d+) shots\n\w{16}\n$/,
    ([ada, bob, shots]) => ada + bob <= 10 && ada > bob && shots > 2,
  ],
  rollback: [
    /^score (\d+) : (\d+), (\d+) steps played again\n0 unlike hashes, \w{16}\n$/,
    ([one, two, replayed]) => one + two > 0 && replayed > 1800,
  ],
  "save-load": [
    /^saved with (\d+) points\nloaded with \1 points\n(\d+) points, (\w{16})\n\2 points, \3\n$/,
    ([saved, end]) => saved > 0 && saved < end,
  ],
};

function run(name) {
  copyFileSync(`${games}/${name}.mjs`, join(folder, `${name}.mjs`));
  const options = { cwd: folder, encoding: "utf8", timeout: 120_000 };
  const { status, stdout, stderr } = spawnSync(process.execPath, [`${name}.mjs`], options);
  assert.equal(status, 0, `${name}: ${stdout}${stderr}`);
  assert.equal(stderr, "");
  return stdout;
}

for (const [name, [says, holds]] of Object.entries(ENDS))
  test(`${name.replace("-", "_")}_ends_by_its_rules_and_twice_alike`, () => {
    const said = run(name);
    assert.match(said, says);
    const [, ...found] = says.exec(said);
    assert.ok(holds(found.map(Number)), said);
    assert.equal(run(name), said);
  });

test("every_game_is_run", () => {
  const there = readdirSync(games).filter((file) => file.endsWith(".mjs"));
  assert.deepEqual(there.sort(), Object.keys(ENDS).map((name) => `${name}.mjs`).sort());
});
