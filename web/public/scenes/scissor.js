// A scissor lift raises 100 times its own mass. A motor draws its foot together until a limit: at the
// bottom it has to pull with some seventy times the load.

import { partsOf } from "./joints/parts.js";

export const title = "Scissor lift";
export const about =
  "Twenty stages of bars lift a hundred times their mass, drawn together at the foot alone.";
export const menu = { group: "Joints", place: 539 };
export const size = { means: "stages", usual: 20, least: 1, most: 100 };

const BAR = 3; // long
const [FROM, TO] = [2.88, 2.7]; // how wide it stands, at first and drawn together
const FEET = 0.3;
const steel = { density: 5, group: -1 }; // bars do not meet each other

export default function ({ createWorld, grid, size }) {
  const world = createWorld();
  const { fixed, moving, addBox, bar, circle, hinge, tie } = partsOf(world, grid);
  const ground = fixed();
  world.createTerrain(ground.body, { kind: "flat", slope: 0 });

  const height = Math.sqrt(BAR * BAR - FROM * FROM); // of a stage
  const x = -0.5 * FROM;
  const stages = [];
  for (let i = 0; i < size; i++) {
    const [low, high] = [FEET + i * height, FEET + (i + 1) * height];
    const rising = bar([x, low], [-x, high], 0.07, steel);
    const falling = bar([-x, low], [x, high], 0.07, steel);
    const below = stages.at(-1);
    hinge(rising, falling, [0, 0.5 * (low + high)]);
    hinge(below?.falling ?? ground, rising, [x, low]);
    if (below) hinge(below.rising, falling, [-x, low]);
    stages.push({ rising, falling });
  }

  // A small body on a bar that slides along the carrier.
  const slide = (carrier, on, at, along) => {
    const part = circle(at, 0.12, steel);
    hinge(on, part, at);
    tie("slider", carrier, part, at, { along });
    return part;
  };
  const bars = stages.flatMap(({ rising, falling }) => [rising, falling]);
  const load = bars.reduce((sum, { mass }) => sum + 100 * mass, 0);
  const top = FEET + size * height;
  const { rising, falling } = stages.at(-1);
  slide(ground, stages[0].falling, [-x, FEET], {
    lower: TO - FROM,
    upper: 0.01,
    motorSpeed: -0.04,
    motorForce: (20 * load * size * FROM) / height,
  });
  const platform = moving([0, top]);
  addBox(platform, 1.7, 1, { offset: [0, 1.2], ...steel, density: load / (4 * 1.7 * 1) });
  hinge(falling, platform, [x, top]);
  slide(platform, rising, [-x, top]);

  const reach = FEET + size * Math.sqrt(BAR * BAR - TO * TO) + 3;
  return {
    world,
    view: { x: 0, y: 0.47 * reach, height: 1.12 * reach + 1 },
    spawn: [4, 6],
  };
}
