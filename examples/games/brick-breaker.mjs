/**
 * Brick breaker with a computer player. Every third brick drops a capsule, which widens the paddle
 * that catches it. The game is won when no brick is left, and lost with the third ball.
 */
import { aabb, circle, load, walls } from "thud";

const [PADDLE, BRICK, BALL, CAPSULE, PIT] = [2, 4, 8, 16, 32]; // categories
const SPEED = 14; // of the ball, length/s
const clamp = (value, most) => Math.max(-most, Math.min(most, value));

const thud = await load();
const world = thud.createWorld({ gravity: [0, 0], detection: "swept" });

const pit = aabb(9, 1, { offset: [0, -13], category: PIT, sensor: true });
world.createBody({ shapes: [...walls(8, 13, 1, { offset: [0, -1.5] }), pit] });
const places = Array.from({ length: 40 }, (_, i) => [(i % 8) * 2 - 7, 4 + Math.floor(i / 8)]);
const bricks = world.createBodies({ shapes: [aabb(0.9, 0.4, { category: BRICK })] }, places);
const shapes = [aabb(1, 0.3, { category: PADDLE })];
const paddle = world.createBody({ kind: "kinematic", position: [0, -9], shapes });

/** A ball or a capsule that bounces without loss. Returns its body. */
function addDisc(category, mask, position, velocity) {
  const shapes = [circle(0.3, { category, mask, restitution: 1, friction: 0 })];
  return world.createBody({ kind: "dynamic", position, velocity, fixedRotation: true, shapes });
}

let [left, balls, caught] = [bricks.length, 3, 0];
while (left > 0 && balls > 0) {
  const ball = addDisc(BALL, ~CAPSULE, [0, -5], [0, -SPEED]);
  while (left > 0 && world.isValid(ball)) {
    // The player moves the paddle so that the ball hits it where it is sent to a brick, at most 0.2
    // a step.
    const [x] = world.positionOf(paddle);
    const [ballX] = world.positionOf(ball);
    const [brickX, brickY] = world.positionOf(bricks.find((brick) => world.isValid(brick)));
    const aside = clamp((brickX - ballX) / (brickY + 9), 0.9);
    world.setTarget(paddle, [x + clamp(ballX - aside - x, 0.2), -9]);
    world.step();

    for (const { a: brick } of world.eventPairs(BRICK, BALL)) {
      if (--left % 3 === 0) addDisc(CAPSULE, PADDLE | PIT, world.positionOf(brick.body), [0, -4]);
      world.destroy(brick.body);
    }
    for (const { a: capsule, b: paddle } of world.eventPairs(CAPSULE, PADDLE)) {
      world.destroy(capsule.body);
      world.setHalfExtents(paddle.shape, 1 + 0.25 * ++caught, 0.3);
    }
    // The ball leaves at an angle that grows with its distance from the paddle's middle.
    const angle = Math.atan(ballX - x);
    for (const { b } of world.eventPairs(PADDLE, BALL))
      world.setVelocity(b.body, [SPEED * Math.sin(angle), SPEED * Math.cos(angle)]);
    for (const { b: lost } of world.eventPairs(PIT, BALL | CAPSULE)) world.destroy(lost.body);
  }
  if (!world.isValid(ball)) balls--;
}
console.log(`${left} bricks and ${balls} balls left, ${caught} capsules caught`);
console.log(`${(world.stats().steps / 60).toFixed(1)} s, ${world.hash()}`);
process.exitCode = left === 0 ? 0 : 1;
