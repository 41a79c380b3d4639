/**
 * Pool for two computer players: each tries some shots in the world itself, takes them back,
 * and plays the best. Who sinks a ball goes on; who sinks the cue ball loses a point.
 */
import { load } from "thud";

const RADIUS = 0.03;
const [CUE, BALL] = [1, 2]; // user data

const thud = await load();
// Swept: balls meet at the time of impact, however fast they are.
const world = thud.createWorld({ gravity: [0, 0], lengthScale: 0.05, detection: "swept" });

const rail = { kind: "aabb", halfWidth: 1.4, halfHeight: 0.05, restitution: 0.8 };
const pocket = { kind: "circle", radius: 0.05, sensor: true };
const shapes = [-1, 1].flatMap((side) => [
  { ...rail, offset: [0, 0.7 * side] },
  { ...rail, halfWidth: 0.05, halfHeight: 0.7, offset: [1.35 * side, 0] },
  ...[-1.3, 0, 1.3].map((x) => ({ ...pocket, offset: [x, 0.65 * side] })),
]);
world.createBody({ shapes });

function addBall(x, y, userData) {
  const shapes = [{ kind: "circle", radius: RADIUS, restitution: 0.95, friction: 0.05 }];
  const options = { linearDamping: 1.2, fixedRotation: true, userData, shapes };
  return world.createBody({ kind: "dynamic", position: [x, y], ...options });
}
const cue = addBall(-0.6, 0, CUE);
for (let row = 0; row < 4; row++)
  for (let y = -row; y <= row; y += 2) addBall(0.5 + 1.75 * RADIUS * row, 1.01 * RADIUS * y, BALL);

/** Plays until all balls are at rest. Returns what that is worth. */
function shoot(velocity) {
  let points = 0;
  world.setVelocity(cue, velocity);
  do {
    world.step();
    for (const event of world.events().sensorBegin) {
      const { body, bodyData } = world.pairOf(event).b;
      points += bodyData === BALL ? 1 : -1;
      if (bodyData === BALL) world.destroy(body);
      else world.setTransform(cue, [-0.6, 0]);
    }
  } while (world.awakeBodies().length > 0);
  return points;
}

let seed = 1;
const random = () => (seed = (seed * 16807) % 2147483647) / 2147483647;

/** Somewhere at a ball, hard enough to go around the table. */
function randomShot() {
  const balls = world.bodies().filter((body) => world.userDataOf(body) === BALL);
  const [x, y] = world.positionOf(balls[Math.floor(balls.length * random())]);
  const [cx, cy] = world.positionOf(cue);
  const angle = Math.atan2(y - cy, x - cx) + 0.1 * (random() - 0.5);
  return [4 * Math.cos(angle), 4 * Math.sin(angle)];
}

/** The best of some, each tried in the world itself. */
function bestShot(tries) {
  const shots = Array.from({ length: tries }, () => {
    const velocity = randomShot();
    return { velocity, points: world.whatIf(() => shoot(velocity)) };
  });
  return shots.reduce((best, shot) => (shot.points > best.points ? shot : best)).velocity;
}

const players = [{ name: "Ada", tries: 9, score: 0 }, { name: "Bob", tries: 3, score: 0 }];
let shots = 0;
for (let turn = 0; world.bodies().length > 2; shots++) {
  const points = shoot(bestShot(players[turn].tries));
  players[turn].score += points;
  if (points <= 0) turn = 1 - turn;
}
const [ada, bob] = players.map(({ name, score }) => `${name} ${score}`);
console.log(`${ada}, ${bob} after ${shots} shots`);
console.log(world.hash());
