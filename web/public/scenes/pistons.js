// A floor of kinematic pistons runs as a wave. Nothing can stop them: they carry what lies on them.

export const title = "Pistons";
export const about = "Forty pistons move in a wave and carry what lies on them.";
export const menu = { group: "In motion", place: 440 };
export const size = { means: "balls and boxes", usual: 300, least: 1, most: 5000 };

const PISTONS = 40;
const PERIOD = 150; // steps
const WAVES = 2;
const HALF_HEIGHT = 10;

export default function ({ createWorld, random, grid, seed, size }) {
  const world = createWorld();
  const half = 0.5 * PISTONS;
  for (const side of [-1, 1]) {
    const wall = world.createBody({ position: [side * (half + 0.5), 10] });
    world.createAabb(wall, { halfWidth: 0.5, halfHeight: 20 });
  }
  const pistons = Array.from({ length: PISTONS }, (_, i) => {
    const position = [i + 0.5 - half, wave(i, 0) - HALF_HEIGHT];
    const piston = world.createBody({ kind: "kinematic", position });
    world.createObb(piston, { halfWidth: 0.48, halfHeight: HALF_HEIGHT });
    return piston;
  });

  const chance = random(seed + 1);
  for (let i = 0; i < size; i++) {
    const x = ((i % 30) - 14.5) * 1.2 + chance(-0.1, 0.1);
    const y = 3.5 + Math.floor(i / 30) * 1.2;
    const body = world.createBody({ kind: "dynamic", position: [grid(x), grid(y)] });
    const radius = chance(0.2, 0.45);
    if (i % 2 === 0) world.createCircle(body, { radius });
    else world.createObb(body, { halfWidth: radius, halfHeight: radius });
  }

  return {
    world,
    view: { x: 0, y: 4, height: 18, width: PISTONS + 4 },
    spawn: [0, 14],
    update({ step }) {
      pistons.forEach((piston, i) => {
        if (!world.isValid(piston)) return;
        // So fast that it is where the wave will be after this step.
        const target = wave(i, step + 1) - HALF_HEIGHT;
        const rise = target - world.bodyStateOf(piston).position[1];
        world.setVelocity(piston, [0, rise * 60]);
      });
    },
  };
}

// From -1.5 to 1.5, in parabolas, which look like a sine: Math.sin may differ between browsers.
function wave(piston, step) {
  const t = (step / PERIOD + WAVES * (1 - piston / PISTONS)) % 1;
  return t < 0.5 ? 24 * t * (0.5 - t) : -24 * (t - 0.5) * (1 - t);
}
