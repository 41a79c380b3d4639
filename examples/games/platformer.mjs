/**
 * A platformer: planks to jump through from below, a crate to push, a belt that runs against the
 * character, and a lift to the flag. A script plays it, and collects all coins.
 */
import { aabb, circle, load, Mover } from "thud";

const [PLANK, COIN, FLAG] = [2, 4, 8]; // categories
const COINS = [[5, 2.2], [5, 3.8], [11, 2], [16, 0.5], [22.5, 3], [28, 4.5]];

const thud = await load();
const world = thud.createWorld();

// All static shapes are of one body; each coin has a body of its own, which is destroyed when
// taken.
const belt = aabb(4.5, 0.5, { offset: [16.5, -0.5], surfaceSpeed: -2 });
const hill = aabb(5, 2.5, { offset: [30, 1.5] });
const planks = [1.6, 3.2].map((y) => aabb(1.5, 0.1, { offset: [5, y], category: PLANK }));
world.createBody({ shapes: [aabb(10, 0.5, { offset: [0, -0.5] }), belt, hill, ...planks] });
world.createBodies({ shapes: [circle(0.3, { category: COIN, sensor: true })] }, COINS);
world.createBody({ position: [33, 4.5], shapes: [circle(0.3, { category: FLAG, sensor: true })] });
// A crate, a lift, and the character, which is a mover and no body.
world.createBody({ kind: "dynamic", position: [2, 0.5], shapes: [aabb(0.5, 0.5)] });
const lift = world.createBody({ kind: "kinematic", position: [22.5, 0], shapes: [aabb(1.5, 0.2)] });
const hero = new Mover(world, {
  shape: circle(0.4),
  position: [-8, 0.5],
  gravityScale: 2,
  pushForce: 40,
  oneWay: PLANK,
  filter: { sensors: true },
});

let [coins, won] = [0, false];
while (!won && world.stats().steps < 3600) {
  world.setTarget(lift, [22.5, 1.9 - 2.1 * Math.cos(world.stats().steps / 60 - 0.9)]);
  world.step();
  const [x, y] = hero.position;
  const climbs = x > 4.8 && x < 5.2 && y < 3.5; // up through the planks
  const leaps = x > 9.5 && x < 12.5;
  const rides = x > 22 && x < 22.5 && y < 4.4; // on the lift
  const { sensors } = hero.walk({ speed: climbs || rides ? 0 : 5, jump: climbs || leaps ? 9 : 0 });
  for (const { body, category } of sensors.map((sensor) => world.shapeStateOf(sensor))) {
    won ||= category === FLAG;
    if (category === COIN) coins++;
    world.destroy(body);
  }
}
console.log(`${won ? "reached the flag" : "lost"} with ${coins} coins`);
console.log(`${(world.stats().steps / 60).toFixed(1)} s, ${world.hash()}`);
process.exitCode = won ? 0 : 1;
