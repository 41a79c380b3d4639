/**
 * A race seen from above: three cars, two laps, an oil slick and cones on the track. The force of a
 * tyre is limited by its grip, so that a car that is too fast slides.
 */
import { aabb, circle, load, obb, walls } from "thud";

const [GATE, CAR] = [2, 4]; // categories
const LAPS = 2;
// The places of the gates, in the order in which cars must pass them.
const GATES = [[0, -14], [20, -12], [23, 0], [20, 12], [0, 14], [-20, 12], [-23, 0], [-20, -12]];
// The places of the tyres in the car's frame; the two in front are steered.
const TYRES = [[1.2, 0.7], [1.2, -0.7], [-1.2, 0.7], [-1.2, -0.7]];
const clamp = (value, most) => Math.max(-most, Math.min(most, value));

const thud = await load();
const world = thud.createWorld({ gravity: [0, 0] });

const gate = { category: GATE, sensor: true };
const gates = GATES.map((offset, userData) => circle(4, { ...gate, offset, userData }));
const track = world.createBody({ shapes: [aabb(14, 8), ...walls(29, 20, 2), ...gates] });
const oil = world.createCircle(track, { radius: 3, offset: [10, 15], sensor: true });

// Cones are light, and damping soon stops them.
const places = Array.from({ length: 12 }, (_, i) => [-22 + 4 * i, i % 2 ? 12 : -11]);
const cone = { linearDamping: 2, angularDamping: 2, shapes: [circle(0.4, { density: 0.2 })] };
world.createBodies({ kind: "dynamic", ...cone }, places);

const racers = ["Ada", "Bob", "Cyd"].map((name, i) => {
  const position = [-6 - 5 * i, i % 2 ? -12.5 : -15.5];
  const shapes = [obb(2, 0.9, { category: CAR, friction: 0.2 })];
  const options = { position, linearDamping: 0.4, userData: i, shapes };
  const car = world.createBody({ kind: "dynamic", ...options });
  return { name, car, power: 18 + 2 * i, passed: 0 };
});

/** A simple driver, who steers towards the next gate and brakes in bends. */
function drive({ car, power, passed }) {
  const [x, y] = world.localPoint(car, GATES[passed % GATES.length]);
  const steer = clamp(Math.atan2(y, x), 0.6);
  const thrust = power * (1 - Math.abs(steer));
  const brake = 8 * Math.abs(steer);
  for (const at of TYRES) {
    const grip = world.containsPoint(oil, world.worldPoint(car, at)) ? 4 : 40;
    world.applyTyre(car, { at, steer: at[0] > 0 ? steer : 0, thrust, brake, grip });
  }
}

const ranking = [];
while (ranking.length < racers.length && world.stats().steps < 3600) {
  racers.forEach(drive);
  world.step();
  for (const { a: gate, b: car } of world.eventPairs(GATE, CAR)) {
    const racer = racers[car.bodyData];
    if (gate.shapeData !== racer.passed % GATES.length) continue;
    if (racer.passed++ !== LAPS * GATES.length) continue;
    ranking.push(racer);
    console.log(`${ranking.length}. ${racer.name}, ${(world.stats().steps / 60).toFixed(2)} s`);
  }
}
console.log(world.hash());
process.exitCode = ranking.length === racers.length ? 0 : 1;
