// Two motions without loss, as docs/catalogue.md measures them: balls between two walls without
// gravity, and balls on a floor. They do not meet each other, so that each is alone with its wall.

export const LANES = ["overlap", "continuous", "bisect", "swept"];
export const BALLS = 64;
/** The simulated time after which the error is taken, s. */
export const SECONDS = 2;
export const RATES = [60, 120, 240, 480, 960];
export const RADIUS = 0.1;
/** The balls of the shuttle go to and fro so far, m. */
export const ROOM = 2;
const GRAVITY = 10;

/** Speed of a ball of the shuttle, and the height from which one of the hop falls. */
const speedOf = (ball) => 3 + 0.11 * ball;
const heightOf = (ball) => 1 + 0.031 * ball;

/**
 * By name: gravity; the boxes that are hit (centre and half extents); where a ball begins and how
 * fast; and where it is at a time, in closed form.
 */
export const MOTIONS = {
  shuttle: {
    gravity: 0,
    boxes: [[-1, 0, 1, 1000], [ROOM + 2 * RADIUS + 1, 0, 1, 1000]],
    start: (ball) => [RADIUS, ball],
    speed: speedOf,
    at(ball, time) {
      const way = (speedOf(ball) * time) % (2 * ROOM);
      return [RADIUS + (way <= ROOM ? way : 2 * ROOM - way), ball];
    },
  },
  hop: {
    gravity: -GRAVITY,
    boxes: [[BALLS / 2, -1, 1000, 1]],
    start: (ball) => [ball, RADIUS + heightOf(ball)],
    speed: () => 0,
    at(ball, time) {
      const height = heightOf(ball);
      const fall = Math.sqrt((2 * height) / GRAVITY);
      const since = ((time + fall) % (2 * fall)) - fall; // from the top of the flight
      return [ball, RADIUS + height - 0.5 * GRAVITY * since * since];
    },
  },
};

/** A world with the balls of a motion: { world, balls }. Whoever calls this closes the world. */
export function createMotion(thud, name, detection, rate) {
  const { gravity, boxes, start, speed } = MOTIONS[name];
  const world = thud.createWorld({
    ...{ gravity: [0, gravity], detection, timeStep: 1 / rate, sleeping: false },
  });
  const material = { density: 1, friction: 0, restitution: 1 };
  for (const [x, y, halfWidth, halfHeight] of boxes) {
    const body = world.createBody({ position: [x, y] });
    world.createAabb(body, { halfWidth, halfHeight, ...material });
  }
  const balls = Array.from({ length: BALLS }, (_, i) => {
    const ball = world.createBody({ kind: "dynamic", position: start(i), velocity: [speed(i), 0] });
    world.createCircle(ball, { radius: RADIUS, group: -1, ...material });
    return ball;
  });
  return { world, balls };
}

/** The mean distance of the balls from where the closed form has them at this time. */
export function errorOf({ world, balls }, name, time) {
  const { at } = MOTIONS[name];
  const away = balls.map((ball, i) => {
    const [x, y] = world.bodyStateOf(ball).position;
    const [u, v] = at(i, time);
    return Math.hypot(x - u, y - v);
  });
  return away.reduce((sum, one) => sum + one, 0) / BALLS;
}
