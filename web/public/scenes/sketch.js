// A scene to start your own from: ground, a few bodies, and keys that push the ball.
// Change a number, then press Run.

const PUSH = 12; // force of a key

export const title = "A scene of your own";
export const about = "A small one to start from: open Code, change a number and press Run.";
export const menu = { group: "How it is done", place: 610 };
export const size = { means: "boxes", usual: 12, least: 1, most: 500 };

export default function ({ createWorld, random, seed, size }) {
  const world = createWorld({ gravity: [0, -10] });
  const chance = random(seed);

  const ground = world.createBody({ position: [0, -1] });
  world.createAabb(ground, { halfWidth: 20, halfHeight: 1 });

  const ball = world.createBody({ kind: "dynamic", position: [-8, 2] });
  world.createCircle(ball, { radius: 0.6, restitution: 0.5 });

  for (let i = 0; i < size; i++) {
    const box = world.createBody({ kind: "dynamic", position: [chance(-4, 8), 2 + i] });
    world.createObb(box, { halfWidth: chance(0.3, 0.7), halfHeight: chance(0.3, 0.7) });
  }

  return {
    world,
    view: { x: 0, y: 4, height: 14 },
    keys: { left: "push the ball", right: "push the ball", up: "lift it" },

    update({ held }) {
      const along = (held.right ? PUSH : 0) - (held.left ? PUSH : 0);
      const up = held.up ? 2 * PUSH : 0;
      if (along || up) world.applyCenterForce(ball, [along, up]);
    },

    paint() {
      const [x, y] = world.bodyStateOf(ball).position;
      return {
        marks: [{ kind: "circle", x, y, radius: 0.75, ink: "player" }],
        message: "Knock the boxes off the table.",
      };
    },
  };
}
