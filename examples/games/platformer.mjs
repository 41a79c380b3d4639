/**
 * A platformer: planks to jump through from below, a crate to push, a belt that runs against the
 * hero, and a lift to the flag. A script plays it, and takes every coin.
 */
import { load, Mover } from "thud";

const [PLANK, COIN, FLAG] = [2, 4, 8]; // categories
const WAY = [
  ["right", ({ x }) => x > 4.8],
  ["jump", ({ y }) => y > 3.5], // up through the planks
  ["right", ({ x }) => x > 9.5],
  ["right jump", ({ x }) => x > 12.5],
  ["right", ({ x }) => x > 22],
  ["", ({ y }) => y > 4.4], // on the lift
  ["right", ({ won }) => won],
];

const thud = await load();
const world = thud.createWorld();

function add(position, shape, options = {}) {
  return world.createBody({ position, ...options, shapes: [shape] });
}
const box = (halfWidth, halfHeight, material) => {
  return { kind: "aabb", halfWidth, halfHeight, ...material };
};
add([0, -0.5], box(10, 0.5));
add([16.5, -0.5], box(4.5, 0.5, { surfaceSpeed: -2 }));
add([30, 1.5], box(5, 2.5));
for (const y of [1.6, 3.2]) add([5, y], box(1.5, 0.1, { category: PLANK }));
add([2, 0.5], box(0.5, 0.5, { density: 0.5 }), { kind: "dynamic" });
const lift = add([22.5, -0.2], box(1.5, 0.2), { kind: "kinematic" });
const things = { kind: "circle", radius: 0.3, sensor: true };
for (const position of [[5, 2.2], [5, 3.8], [11, 2], [16, 0.5], [22.5, 3], [28, 4.5]])
  add(position, { ...things, category: COIN });
add([33, 4.5], { ...things, category: FLAG });

const hero = new Mover(world, {
  shape: { kind: "circle", radius: 0.4 },
  position: [-8, 0.5],
  pushForce: 20,
  oneWay: PLANK,
  filter: { sensors: true },
});

const at = { x: 0, y: 0, won: false };
let [coins, leg, vy, ground] = [0, 0, 0, null];
while (!at.won && world.stats().steps < 3600) {
  world.setTarget(lift, [22.5, 1.9 - 2.1 * Math.cos(world.stats().steps / 60 - 0.9)]);
  world.step();
  const [held, until] = WAY[leg];
  vy = ground && held.includes("jump") ? 9 : ground ? -1 : vy - 20 / 60;
  const report = hero.move([held.includes("right") ? 5 : 0, vy], 1 / 60);
  ({ ground, position: [at.x, at.y], velocity: [, vy] } = report);
  for (const shape of report.sensors) {
    const { body, category } = world.shapeState(shape);
    at.won ||= category === FLAG;
    if (category === COIN) coins++;
    world.destroy(body);
  }
  if (until(at)) leg++;
}
console.log(`${at.won ? "reached the flag" : "lost"} with ${coins} coins`);
console.log(`${(world.stats().steps / 60).toFixed(1)} s, ${world.hash()}`);
process.exitCode = at.won ? 0 : 1;
