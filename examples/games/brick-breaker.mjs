/**
 * Brick breaker with a computer player. Every third brick drops a capsule: caught, it widens the
 * paddle. The game is won when no brick is left, and lost with the third ball.
 */
import { load } from "thud";

const [WALL, PADDLE, BRICK, BALL, CAPSULE, PIT] = [1, 2, 4, 8, 16, 32]; // categories
const SPEED = 14;
const clamp = (value, most) => Math.max(-most, Math.min(most, value));

const thud = await load();
const world = thud.createWorld({ gravity: [0, 0], detection: "swept" });

const box = (category, halfWidth, halfHeight, offset = [0, 0], sensor = false) => {
  const material = { category, sensor, restitution: 1, friction: 0 };
  return { kind: "aabb", halfWidth, halfHeight, offset, ...material };
};
const sides = [-8.5, 8.5].map((x) => box(WALL, 0.5, 12, [x, 0]));
const pit = box(PIT, 9, 1, [0, -13], true);
world.createBody({ shapes: [...sides, box(WALL, 9, 0.5, [0, 12]), pit] });
const bricks = Array.from({ length: 40 }, (_, i) => {
  const position = [(i % 8) * 2 - 7, 4 + Math.floor(i / 8)];
  return world.createBody({ position, shapes: [box(BRICK, 0.9, 0.4)] });
});
const shapes = [box(PADDLE, 1, 0.3)];
const paddle = world.createBody({ kind: "kinematic", position: [0, -9], shapes });

function addDisc(category, mask, position, velocity) {
  const shapes = [{ kind: "circle", radius: 0.3, category, mask, restitution: 1, friction: 0 }];
  const options = { position, velocity, fixedRotation: true, shapes };
  return world.createBody({ kind: "dynamic", ...options });
}
const ball = addDisc(BALL, WALL | PADDLE | BRICK | PIT, [0, -5], [0, -SPEED]);

let [left, balls, caught] = [bricks.length, 3, 0];
while (left > 0 && balls > 0) {
  // The player wants the ball to meet the paddle where it goes to a brick from, but is slow.
  const [x] = world.positionOf(paddle);
  const [ballX] = world.positionOf(ball);
  const [brickX, brickY] = world.positionOf(bricks.find((brick) => world.isValid(brick)));
  const aside = clamp((brickX - ballX) / (brickY + 9), 0.9);
  world.setTarget(paddle, [x + clamp(ballX - aside - x, 0.2), -9]);
  world.step();

  for (const { a: brick } of world.meetings(BRICK, BALL)) {
    if (--left % 3 === 0) addDisc(CAPSULE, PADDLE | PIT, world.positionOf(brick.body), [0, -4]);
    world.destroy(brick.body);
  }
  for (const { a: capsule, b: paddle } of world.meetings(CAPSULE, PADDLE)) {
    world.destroy(capsule.body);
    world.setHalfExtents(paddle.shape, 1 + 0.25 * ++caught, 0.3);
  }
  for (const { b: capsule } of world.meetings(PIT, CAPSULE)) world.destroy(capsule.body);
  // The more aside the ball meets the paddle, the more aside it goes; and it keeps its speed.
  let [vx, vy] = world.velocityOf(ball).velocity;
  for (const _ of world.meetings(PADDLE, BALL)) [vx, vy] = [SPEED * (ballX - x), SPEED];
  const pace = SPEED / Math.hypot(vx, vy);
  world.setVelocity(ball, [vx * pace, vy * pace]);
  for (const _ of world.meetings(PIT, BALL)) {
    balls--;
    world.setTransform(ball, [0, -5]);
    world.setVelocity(ball, [0, -SPEED]);
  }
}
console.log(`${left} bricks and ${balls} balls left, ${caught} capsules caught`);
console.log(`${(world.stats().steps / 60).toFixed(1)} s, ${world.hash()}`);
process.exitCode = left === 0 ? 0 : 1;
