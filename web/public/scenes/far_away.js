// A ball flies into a pyramid, ten thousand kilometres from the origin. A twin of this world does
// the same at the origin, unseen. Places are doubles and everything else is relative to them, so
// the two should not come apart: until you touch this one.

export const title = "10,000 km away";
export const about =
  "A heap 10,000 km from the origin, and by how much it differs from its twin at the origin.";
export const menu = { group: "Crowds and extremes", place: 710 };
export const size = { means: "powers of ten of the distance", usual: 7, least: 0, most: 7 };

export default function ({ createWorld, size }) {
  const far = 10 ** size;
  const here = build(createWorld(), far);
  let twin = build(createWorld(), 0);
  const state = { steps: 0 };

  return {
    world: here.world,
    view: { x: far, y: 6, height: 20, width: 44 },
    spawn: [far, 20],
    state,
    update() {
      twin.world.step();
      state.steps++;
    },
    // Time went back: the twin starts anew and catches up.
    restored() {
      twin.world.close();
      twin = build(createWorld(), 0);
      for (let i = 0; i < state.steps; i++) twin.world.step();
    },
    paint: () => ({
      figures: [
        { label: "From the origin", value: `${far.toLocaleString("en")} m` },
        { label: "From its twin", value: `${apart(here, twin, far).toPrecision(1)} m` },
      ],
    }),
  };
}

function build(world, x) {
  const bodies = [];
  const add = (dx, y, velocity = [0, 0]) => {
    const body = world.createBody({ kind: "dynamic", position: [x + dx, y], velocity });
    bodies.push(body);
    return body;
  };
  const ground = world.createBody({ position: [x, -1] });
  world.createAabb(ground, { halfWidth: 40, halfHeight: 1 });
  const rows = 16;
  for (let row = 0; row < rows; row++)
    for (let i = 0; i < rows - row; i++) {
      const box = add(i + 0.5 * (row + 1 - rows), row + 0.5);
      world.createObb(box, { halfWidth: 0.5, halfHeight: 0.5 });
    }
  world.createCircle(add(-20, 6, [25, 2]), { radius: 1.5, density: 4 });
  return { world, bodies };
}

// The largest difference between what the two have done.
function apart(here, twin, far) {
  let most = 0;
  here.bodies.forEach((body, i) => {
    if (!here.world.isValid(body)) return;
    const [x, y] = here.world.bodyStateOf(body).position;
    const [twinX, twinY] = twin.world.bodyStateOf(twin.bodies[i]).position;
    most = Math.max(most, Math.abs(x - far - twinX), Math.abs(y - twinY));
  });
  return most;
}
