/**
 * A saved game: bombs explode in a castle, the game is saved to a file in the middle, and a new
 * world loads it, as a later run of the program would. Both continue, and end with the same bits.
 */
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { aabb, load, obb } from "thud";

const BOMBS = [[-3, 0.4], [2, 0.4], [0, 5], [5, 0.4], [-1, 0.4], [3, 3]]; // places
const STEPS_BETWEEN = 90; // steps from one bomb to the next
const STONE = 1; // user data

const thud = await load();

// User data is saved with the world: it marks the stones, and the island's is the score.
function createWorld() {
  const world = thud.createWorld();
  world.createBody({ shapes: [aabb(8, 0.5, { offset: [0, -0.5] })] });
  const addStone = (x, y, halfWidth, halfHeight) => {
    const shapes = [obb(halfWidth, halfHeight)];
    world.createBody({ kind: "dynamic", position: [x, y], userData: STONE, shapes });
  };
  for (const x of [-6, -2, 2, 6]) for (let y = 0.5; y < 4; y++) addStone(x, y, 0.5, 0.5);
  for (const x of [-4, 0, 4]) addStone(x, 4.2, 2, 0.2);
  return world;
}

const islandOf = (world) => world.bodies()[0];
const scoreOf = (world) => world.userDataOf(islandOf(world));

/** Plays up to step `last`; each stone that falls off the island is a point. */
function play(world, last) {
  for (let { steps } = world.stats(); steps < last; steps++) {
    const center = BOMBS[steps / STEPS_BETWEEN];
    if (center) world.explode({ center, radius: 1, falloff: 3, impulse: 20 });
    world.step();
    const stones = world.bodies().filter((body) => world.userDataOf(body) === STONE);
    const fallen = stones.filter((stone) => world.positionOf(stone)[1] < -10);
    fallen.forEach((stone) => world.destroy(stone));
    world.setUserData(islandOf(world), scoreOf(world) + fallen.length);
  }
}

const folder = mkdtempSync(join(tmpdir(), "castle-"));
const file = join(folder, "castle.save");
const world = createWorld();
play(world, 300);
writeFileSync(file, world.snapshot());
console.log(`saved with ${scoreOf(world)} points`);
play(world, 700);

const loaded = thud.createWorld();
loaded.restore(readFileSync(file));
rmSync(folder, { recursive: true });
console.log(`loaded with ${scoreOf(loaded)} points`);
play(loaded, 700);

for (const end of [world, loaded]) console.log(`${scoreOf(end)} points, ${end.hash()}`);
process.exitCode = world.hash() === loaded.hash() ? 0 : 1;
