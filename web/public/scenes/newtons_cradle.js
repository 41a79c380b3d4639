// Three Newton’s cradles: balls that touch and hang side by side, each on a string of its own from
// a bar. As many swing out on the right as came in on the left, to the same height, and back again.
// At the top stands how much of the energy that there was is left: take hold of a ball and let go.

import { partsOf } from "./joints/parts.js";

export const title = "Newton’s cradle";
export const about = "As many balls swing out as came in, as high, and the energy stays.";
export const menu = { group: "Joints", place: 530 };
export const size = { means: "balls in a row", usual: 5, least: 4, most: 30 };

const [STRING, RADIUS, PITCH, GRAVITY] = [3, 0.5, 5, 10];
const ELASTIC = { friction: 0, restitution: 1 };
// Lifted balls hang by the angle of a triangle of sides 3, 4 and 5.
const [SINE, COSINE] = [0.6, 0.8];

export default function ({ createWorld, grid, size }) {
  const world = createWorld({ gravity: [0, -GRAVITY] });
  const { fixed, circle, link } = partsOf(world, grid);
  // Each with the height at which it hangs.
  const balls = [];

  // In cradle 1, at the top, one ball is lifted; in cradle 2 two, in cradle 3 three.
  for (let lifted = 1; lifted <= 3; lifted++) {
    const top = PITCH * (2 - lifted) + 0.5 * STRING;
    const bar = fixed([0, top + 0.125]);
    world.createAabb(bar.body, { halfWidth: 0.5 * size + 0.25, halfHeight: 0.125, ...ELASTIC });
    for (let i = 0; i < size; i++) {
      const x = i - 0.5 * (size - 1);
      const at = i < lifted ? [x - SINE * STRING, top - COSINE * STRING] : [x, top - STRING];
      const ball = circle(at, RADIUS, ELASTIC, { maySleep: false });
      link(bar, ball, [x, top], at);
      balls.push({ body: ball.body, low: top - STRING });
    }
  }

  const start = energyOf(world, balls);
  return {
    world,
    view: { x: 0, y: 0, height: 3 * PITCH + 1, width: size + 7 },
    spawn: [0, 2 * PITCH],
    paint() {
      const { motion, height } = energyOf(world, balls);
      const share = (part) => `${((100 * part) / (start.motion + start.height)).toFixed(1)} %`;
      return {
        figures: [
          { label: "Energy", value: share(motion + height) },
          { label: "of motion", value: share(motion) },
          { label: "of height", value: share(height) },
        ],
      };
    },
  };
}

// Of all balls that are left, in joules: of their motion, and of their height above where they hang.
function energyOf(world, balls) {
  let [motion, height] = [0, 0];
  for (const { body, low } of balls) {
    if (!world.isValid(body)) continue;
    const { mass, inertia, position, velocity, angularVelocity } = world.bodyStateOf(body);
    const [x, y] = velocity;
    motion += 0.5 * (mass * (x * x + y * y) + inertia * angularVelocity * angularVelocity);
    height += mass * GRAVITY * (position[1] - low);
  }
  return { motion, height };
}
