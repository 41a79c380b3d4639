/**
 * Pool for two computer players. A player tries some random shots in the world by `whatIf`, which
 * restores it, and plays the best one. A player who sinks a ball plays again; sinking the cue ball
 * costs a point.
 */
import { circle, load, walls } from "thud";

const RADIUS = 0.03; // of a ball, metres
const [CUE, BALL, POCKET] = [2, 4, 8]; // categories

const thud = await load();
// Swept detection: balls collide at their time of impact, at any speed.
const world = thud.createWorld({ gravity: [0, 0], lengthScale: 0.05, detection: "swept" });

const pocket = (x, y) => circle(0.05, { offset: [x, y], category: POCKET, sensor: true });
const pockets = [-1.3, 0, 1.3].flatMap((x) => [pocket(x, 0.65), pocket(x, -0.65)]);
world.createBody({ shapes: [...walls(1.3, 0.65, 0.1, { restitution: 0.8 }), ...pockets] });

const disc = (category) => circle(RADIUS, { category, restitution: 0.95, friction: 0.05 });
const options = { kind: "dynamic", linearDamping: 1.2, fixedRotation: true };
const cue = world.createBody({ ...options, position: [-0.6, 0], shapes: [disc(CUE)] });
const rack = [[0, 0], [1, -1], [1, 1], [2, -2], [2, 0], [2, 2], [3, -3], [3, -1], [3, 1], [3, 3]];
const places = rack.map(([x, y]) => [0.5 + 1.75 * RADIUS * x, 1.01 * RADIUS * y]);
const balls = world.createBodies({ ...options, shapes: [disc(BALL)] }, places);

/** Plays a shot until all balls are at rest. Returns its points. */
function shoot(velocity) {
  let points = 0;
  world.setVelocity(cue, velocity);
  do {
    world.step();
    for (const { b: sunk } of world.eventPairs(POCKET, CUE | BALL)) {
      points += sunk.category === BALL ? 1 : -1;
      if (sunk.category === CUE) world.setTransform(cue, [-0.6, 0]);
      else world.destroy(sunk.body);
    }
  } while (world.awakeBodies().length > 0);
  return points;
}

let seed = 1;
const random = () => (seed = (seed * 16807) % 2147483647) / 2147483647;

/** A shot at a random ball, with a random error of the angle, at speed 4. */
function randomShot() {
  const left = balls.filter((ball) => world.isValid(ball));
  const [x, y] = world.localPoint(cue, world.positionOf(left[Math.floor(random() * left.length)]));
  const angle = Math.atan2(y, x) + 0.1 * (random() - 0.5);
  return [4 * Math.cos(angle), 4 * Math.sin(angle)];
}

const score = [0, 0]; // Ada's, who tries nine shots, and Bob's, who tries three
let [turn, shots] = [0, 0];
for (; balls.some((ball) => world.isValid(ball)); shots++) {
  const tries = Array.from({ length: turn === 0 ? 9 : 3 }, randomShot);
  const worth = tries.map((shot) => world.whatIf(() => shoot(shot)));
  const points = shoot(tries[worth.indexOf(Math.max(...worth))]);
  score[turn] += points;
  if (points <= 0) turn = 1 - turn;
}
console.log(`Ada ${score[0]}, Bob ${score[1]} after ${shots} shots`);
console.log(world.hash());
