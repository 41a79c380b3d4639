// What acts on all that is awake before each step: water and wind. The built-in scenes of C have the
// same, number for number (demo/scene/act_thud.c).

/** Lifts and brakes what is below a level. */
export function float(world, { level, density, drag }) {
  const water = { density, linearDrag: drag, angularDrag: drag };
  for (const body of world.awakeBodies()) {
    const { kind, position } = world.bodyStateOf(body);
    if (kind === "dynamic") world.applyBuoyancy(body, { point: [position[0], level], ...water });
  }
}

// Steps from gust to gust, long ones and short ones, and steps that either takes for a metre.
const [LONG_GUST, SHORT_GUST, STEPS_PER_METRE] = [300, 113, 4];

// From -1 to 1, in parabolas, which look like a sine of period 1: Math.sin may differ between
// browsers.
function wave(time) {
  const t = time - Math.floor(time);
  return t < 0.5 ? 16 * t * (0.5 - t) : -16 * (t - 0.5) * (1 - t);
}

/** Metres a second, to the right, at a place: gusts come from where the wind does. */
export function windAt(step, x, wind, { origin }) {
  const metres = Math.floor(x - origin);
  const t = step - STEPS_PER_METRE * (wind < 0 ? -metres : metres);
  return wind * (1 + 0.5 * wave(t / LONG_GUST) + 0.3 * wave(t / SHORT_GUST));
}

/** Pushes everything that is loose. */
export function blow(world, step, wind, gusts, air) {
  for (const body of world.awakeBodies()) {
    const { kind, position } = world.bodyStateOf(body);
    if (kind === "dynamic")
      world.applyWind(body, [windAt(step, position[0], wind, gusts), 0], air);
  }
}

// ---- what of it is to be seen ----

/**
 * Marks over a lake, darker the deeper. `bed` goes from where the water begins to where it ends, and
 * `level` is its surface.
 */
export function lake(level, bed) {
  const surface = [[bed[0][0], level], [bed.at(-1)[0], level]];
  const layers = Array.from({ length: 9 }, (_, i) => ({
    kind: "line",
    points: below(bed, level - 0.06 * i * (i + 2)),
    ink: "water",
    filled: true,
    opacity: i === 0 ? 0.2 : 0.07,
  }));
  return [...layers, { kind: "line", points: surface, ink: "water" }];
}

/** What of a polygon lies below a level. */
function below(points, level) {
  return points.flatMap((point, i) => {
    const next = points[(i + 1) % points.length];
    const inside = point[1] <= level ? [point] : [];
    if (point[1] <= level === next[1] <= level) return inside;
    const part = (level - point[1]) / (next[1] - point[1]);
    return [...inside, [point[0] + part * (next[0] - point[0]), level]];
  });
}

const SPEED = 12; // of an explosion's ring, metres until it is gone

/** Marks of an explosion; `age` from 0 to 1. */
export function ring([x, y], age) {
  const glow = (1 - age) * (1 - age);
  const radius = 0.4 + SPEED * age;
  const circle = (part, opacity, filled) => {
    return { kind: "circle", x, y, radius: part * radius, ink: "gold", opacity, filled };
  };
  const sparks = Array.from({ length: 12 }, (_, i) => {
    const [dx, dy] = [Math.cos((i * Math.PI) / 6 + 0.2), Math.sin((i * Math.PI) / 6 + 0.2)];
    const points = [0.55, 0.8].map((part) => [x + part * radius * dx, y + part * radius * dy]);
    return { kind: "line", points, ink: "accent", opacity: glow };
  });
  return [circle(0.5, 0.5 * glow * glow, true), circle(0.9, 0.4 * glow), circle(1, glow), ...sparks];
}
