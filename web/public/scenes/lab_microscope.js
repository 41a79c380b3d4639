// Four collisions to take apart: in the panel Inside, part Contacts, each of them opens with every
// number of its formulas. They begin anew every two seconds, with what is set then.

export const title = "Collisions to take apart";
export const about =
  "Head on, on a slope, on a corner, heavy on light: each collision with its normal, depth and every formula.";
export const menu = { group: "Laboratory", place: 160 };

/** Steps from one beginning to the next. */
const ROUND = 120;
/** Middles of the four lanes. */
const [HEAD_ON, SLOPE, CORNER, HEAVY] = [-12, -4, 4, 12];
const NAMES = [[HEAD_ON, "Head on"], [SLOPE, "Slope"], [CORNER, "Corner"], [HEAVY, "Heavy"]];

const slider = (name, label, least, most, step) => (
  { kind: "slider", name, label, least, most, step, group: "At the next beginning" }
);
const CONTROLS = [
  slider("restitution", "Restitution e", 0, 1, 0.05),
  slider("friction", "Friction μ", 0, 1, 0.05),
  slider("speed", "Speed, m/s", 1, 20, 0.5),
  slider("ratio", "Heavier by", 1, 100, 1),
];

export default function ({ createWorld }) {
  const world = createWorld();
  const ground = (x, y, halfWidth, halfHeight, angle = 0) => {
    const body = world.createBody({ position: [x, y], angle });
    world.createObb(body, { halfWidth, halfHeight, angle: 0, friction: 1 });
  };
  for (const x of [CORNER, HEAVY]) ground(x, -0.5, 3.5, 0.5);
  ground(SLOPE, 0.8, 3.5, 0.5, -0.4);

  const scene = {
    world,
    view: { x: 0, y: 3, height: 14, width: 34 },
    spawn: [0, 8],
    controls: CONTROLS,
    show: ["contacts"],
    panel: "contacts",
    state: { restitution: 0.5, friction: 0.4, speed: 6, ratio: 3, bodies: [] },
    update({ step }) {
      if (step > 0 && step % ROUND === 0) begin(scene);
    },
    paint: () => ({ marks: MARKS, figures: figuresOf(scene) }),
  };
  begin(scene);
  return scene;
}

/** Puts all bodies back to where they begin. */
function begin({ world, state }) {
  for (const body of state.bodies) world.destroy(body);
  const { restitution, speed, ratio } = state;
  // A pair's friction is the geometric mean of both; the ground has 1.
  const surface = { restitution, friction: state.friction ** 2 };
  const body = (position, velocity, rest = {}) =>
    world.createBody({ kind: "dynamic", maySleep: false, position, velocity, ...rest });
  const ball = (at, radius, density = 1) =>
    world.createCircle(at, { radius, density, ...surface });

  const left = body([HEAD_ON - 2.5, 3], [speed, 0], { gravityScale: 0 });
  ball(left, 0.6);
  const right = body([HEAD_ON + 2.5, 3], [-speed, 0], { gravityScale: 0 });
  ball(right, 0.6, ratio);

  const dropped = body([SLOPE, 5], [0, -speed]);
  ball(dropped, 0.6);

  const box = body([CORNER, 5], [0, -speed], { angle: 0.5 });
  world.createObb(box, { halfWidth: 1, halfHeight: 0.6, angle: 0, ...surface });

  const light = body([HEAVY, 0.4], [0, 0]);
  ball(light, 0.4);
  const heavy = body([HEAVY, 5], [0, -speed]);
  ball(heavy, 0.9, ratio);
  state.bodies = [left, right, dropped, box, light, heavy];
}

const MARKS = NAMES.map(([x, text]) => (
  { kind: "text", x, y: -2, text, ink: "ink", size: 14 }
));

/** Momentum and energy of the pair that meets head on. */
function figuresOf({ world, state }) {
  const pair = state.bodies.slice(0, 2).map((body) => world.bodyStateOf(body));
  const momentum = pair.reduce((sum, { mass, velocity }) => sum + mass * velocity[0], 0);
  const energy = pair.reduce((sum, { mass, velocity, inertia, angularVelocity }) =>
    sum + 0.5 * mass * (velocity[0] ** 2 + velocity[1] ** 2) + 0.5 * inertia * angularVelocity ** 2, 0);
  return [
    { label: "Head on, momentum", value: momentum.toFixed(2) },
    { label: "Head on, energy", value: energy.toFixed(2) },
  ];
}
