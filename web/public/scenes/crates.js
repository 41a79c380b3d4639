// Stacks of crates, and weights that fall onto some of them. A crate that bears more than its rule
// lets it bear breaks into four, which go on as it moved there. Drop more by hand, or drag a weight.

export const title = "Breakable crates";
export const about =
  "Weights fall onto stacks of crates: what bears too great an impulse breaks into four.";
export const menu = { group: "Who meets whom", place: 562 };
export const size = { means: "crates", usual: 36, least: 1, most: 600 };

const [HALF, APART, ROWS, EVERY] = [0.5, 1.3, 4, 3]; // a weight every so many stacks
const MOST = 6; // kg m/s in a step: as if it fell from 1.8 m
const [RADIUS, LOWEST, HIGHER] = [0.7, 8, 3]; // of the weights

// What a visitor drops has kind 1, and so have the ground and the weights.
const [ANY, CRATE, PIECE] = [1, 2, 4];

const friction = 0.6;

export default function ({ createWorld, grid, size }) {
  const world = createWorld();
  const stacks = Math.ceil(size / ROWS);
  const half = 0.5 * APART * stacks + 4;
  const first = -0.5 * APART * (stacks - 1);
  const wall = (x, y, halfWidth, halfHeight) => {
    const body = world.createBody({ position: [grid(x), grid(y)] });
    world.createAabb(body, { halfWidth, halfHeight, friction });
  };
  const loose = (x, y) => world.createBody({ kind: "dynamic", position: [grid(x), grid(y)] });
  wall(0, -0.5, half + 1, 0.5);
  for (const side of [-1, 1]) wall(side * (half + 0.5), 3, 0.5, 3);
  for (let i = 0; i < size; i++) {
    const body = loose(first + APART * Math.floor(i / ROWS), HALF + 2 * HALF * (i % ROWS));
    world.createObb(body, { halfWidth: HALF, halfHeight: HALF, friction, category: CRATE });
  }
  for (let i = 0; i < stacks / EVERY; i++) {
    const body = loose(first + APART * EVERY * i + 0.3, LOWEST + HIGHER * (i % 6));
    world.createCircle(body, { radius: RADIUS, density: 8, friction });
  }
  world.setRule(CRATE, ANY | CRATE | PIECE, { eventImpulse: MOST });

  const scene = {
    world,
    view: { x: 0, y: 5, height: 13, width: 2 * half + 2 },
    spawn: [0, 10],
    state: { broken: 0 },
    stepped() {
      for (const { a, b } of world.impulseEvents())
        for (const shape of [a, b])
          if (world.isValid(shape) && world.shapeStateOf(shape).category === CRATE) {
            breakUp(world, shape);
            scene.state.broken++;
          }
    },
    paint: () => ({ figures: [{ label: "Broken", value: String(scene.state.broken) }] }),
  };
  return scene;
}

function breakUp(world, shape) {
  const { body, halfWidth, halfHeight, density, friction } = world.shapeStateOf(shape);
  const { angle, angularVelocity } = world.bodyStateOf(body);
  for (const [right, up] of [[-0.5, -0.5], [0.5, -0.5], [-0.5, 0.5], [0.5, 0.5]]) {
    const position = world.worldPoint(body, [right * halfWidth, up * halfHeight]);
    const velocity = world.velocityAt(body, position);
    const kind = "dynamic";
    const piece = world.createBody({ kind, position, velocity, angle, angularVelocity });
    const box = { halfWidth: 0.5 * halfWidth, halfHeight: 0.5 * halfHeight, density, friction };
    world.createObb(piece, { ...box, category: PIECE });
  }
  world.destroy(body);
}
