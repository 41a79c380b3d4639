/**
 * A race seen from above: three cars, two laps, an oil slick and cones in the way. Every wheel
 * grips across its way only so hard: who is too fast slides.
 */
import { load } from "thud";

const LAPS = 2;
const GATES = [[0, -14], [20, -12], [23, 0], [20, 12], [0, 14], [-20, 12], [-23, 0], [-20, -12]];
const WHEELS = [[1.2, 0.7], [1.2, -0.7], [-1.2, 0.7], [-1.2, -0.7]];
const clamp = (value, most) => Math.max(-most, Math.min(most, value));

const thud = await load();
const world = thud.createWorld({ gravity: [0, 0] });

const gate = { kind: "circle", radius: 4, sensor: true };
const track = world.createBody({
  shapes: [
    { kind: "aabb", halfWidth: 14, halfHeight: 8 },
    { kind: "aabb", halfWidth: 31, halfHeight: 1, offset: [0, 21] },
    { kind: "aabb", halfWidth: 31, halfHeight: 1, offset: [0, -21] },
    { kind: "aabb", halfWidth: 1, halfHeight: 20, offset: [30, 0] },
    { kind: "aabb", halfWidth: 1, halfHeight: 20, offset: [-30, 0] },
    ...GATES.map((offset, userData) => ({ ...gate, offset, userData })),
  ],
});
const slick = { radius: 3, offset: [10, 15], sensor: true, userData: GATES.length };
const oil = world.createCircle(track, slick);

for (let i = 0; i < 12; i++) {
  const position = [-22 + 4 * i, i % 2 ? 12 : -11];
  const shapes = [{ kind: "circle", radius: 0.4, density: 0.2 }];
  world.createBody({ kind: "dynamic", position, linearDamping: 2, angularDamping: 2, shapes });
}

const racers = ["Ada", "Bob", "Cyd"].map((name, i) => {
  const position = [-6 - 5 * i, i % 2 ? -12.5 : -15.5];
  const shapes = [{ kind: "obb", halfWidth: 2, halfHeight: 0.9, friction: 0.2 }];
  const options = { linearDamping: 0.4, maySleep: false, userData: i + 1, shapes };
  const car = world.createBody({ kind: "dynamic", position, ...options });
  return { name, car, power: 18 + 2 * i, passed: 0 };
});

/** A simple driver: turns to the next gate, and goes easy in bends. */
function drive({ car, power, passed }) {
  const [x, y] = world.localPoint(car, GATES[passed % GATES.length]);
  const steer = clamp(Math.atan2(y, x), 0.6);
  const thrust = power * (1 - Math.abs(steer));
  for (const wheel of WHEELS) {
    const turn = wheel[0] > 0 ? steer : 0;
    const [cosine, sine] = [Math.cos(turn), Math.sin(turn)];
    const place = world.worldPoint(car, wheel);
    const [vx, vy] = world.localVector(car, world.velocityAt(car, place));
    const grip = clamp(10 * (vx * sine - vy * cosine), world.containsPoint(oil, place) ? 4 : 40);
    const push = [thrust * cosine - grip * sine, thrust * sine + grip * cosine];
    world.applyForceAt(car, world.worldVector(car, push), place);
  }
}

const places = [];
while (places.length < racers.length && world.stats().steps < 3600) {
  racers.forEach(drive);
  world.step();
  for (const event of world.events().sensorBegin) {
    const { a: gate, b: car } = world.pairOf(event);
    const racer = racers[car.bodyData - 1];
    if (!racer || gate.shapeData !== racer.passed % GATES.length) continue;
    racer.passed++;
    if (racer.passed !== LAPS * GATES.length + 1) continue;
    places.push(racer);
    console.log(`${places.length}. ${racer.name}, ${(world.stats().steps / 60).toFixed(2)} s`);
  }
}
console.log(world.hash());
process.exitCode = places.length === racers.length ? 0 : 1;
