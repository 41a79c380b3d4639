// Boats on a lake, with loose cargo. Drop crates on them, pull them under, tow them.

import { float, lake } from "./fields/act.js";
import { partsOf } from "./joints/parts.js";

export const title = "Boats";
export const about =
  "Hulls, crates and a log float as deep as they weigh: drop more on them, and they sink deeper.";
export const menu = { group: "Water, wind, fire", place: 551 };
export const size = { means: "boats", usual: 3, least: 1, most: 60 };

const SPACING = 9; // from boat to boat
const WATER = { level: 0, density: 2, drag: 1.5 }; // a body of density 1 floats half in, half out

export default function ({ createWorld, grid, size }) {
  const world = createWorld();
  const parts = partsOf(world, grid);
  const half = 0.5 * SPACING * size + 6.5;
  const first = 2.5 - 0.5 * SPACING * (size - 1);
  const land = addLand(world, parts, half);
  const boats = [addBarge, addSailingBoat, addTug];
  for (let i = 0; i < size; i++) boats[i % 3](parts, first + SPACING * i);
  addBuoy(parts, first + 4.9);
  addLoose(parts, half);

  const marks = lake(WATER.level, land.slice(4, 10));
  return {
    world,
    view: { x: 0, y: 0.6, height: 15, width: 2 * half + 1 },
    spawn: [0, 7],
    update: () => float(world, WATER),
    paint: () => ({ marks }),
  };
}

/** The lake's bed, and both shores. */
function addLand(world, { fixed, addBar }, half) {
  const points = [
    [-half - 24, 9], [-half - 14, 3], [-half - 6, 1.7], [-half - 1.5, 0.8], [-half, 0],
    [-half + 3, -2.4], [-half + 6, -4.8], [half - 6, -5.6], [half - 3, -2.8], [half, 0],
    [half + 1.5, 0.8], [half + 6, 1.5], [half + 14, 3.4], [half + 24, 9],
  ];
  const friction = 0.7;
  world.createTerrain(fixed().body, { kind: "irregular", points }, { friction });
  const jetty = fixed([-half + 1, 1.3]);
  addBar(jetty, [-half - 3, 1.3], [-half + 4, 1.3], 0.15, { friction });
  addBar(jetty, [-half + 1, -3], [-half + 1, 1.2], 0.12, { friction });
  addBar(jetty, [-half + 3.4, -4], [-half + 3.4, 1.2], 0.12, { friction });
  return points;
}

const friction = 0.5;

/** With a bow and a stern that lean outwards and keep the cargo in. */
function addHull({ box, addBar }, [x, y], halfWidth, halfHeight, density) {
  const hull = box([x, y], halfWidth, halfHeight, { density, friction });
  for (const side of [-1, 1]) {
    const low = [x + side * (halfWidth - 0.1), y - halfHeight + 0.1];
    const high = [x + side * (halfWidth + 0.5), y + halfHeight + 0.4];
    addBar(hull, low, high, 0.12, { density, friction });
  }
  return hull;
}

function addBarge(parts, x) {
  const [y, high, half] = [0.6, 0.55, 0.4];
  addHull(parts, [x, y], 2.8, high, 0.5);
  for (let i = 0; i < 7; i++) {
    const row = Math.floor(i / 4);
    const at = [x + 0.85 * ((i % 4) - (row ? 1 : 1.5)), y + high + half + 2 * half * row];
    parts.box(at, half, half, { density: 0.6, friction });
  }
}

function addSailingBoat(parts, x) {
  const [y, high, radius] = [0.7, 0.4, 0.25];
  const hull = addHull(parts, [x, y], 2.1, high, 0.6);
  const add = (offset, halfWidth, halfHeight, density) =>
    parts.addBox(hull, halfWidth, halfHeight, { offset, density, friction });
  add([0, -0.8], 0.5, 0.45, 3); // the keel
  add([-0.2, 2.6], 0.07, 2.2, 0.3);
  for (let i = 0; i < 5; i++) add([0.9 - 0.17 * i, 1.5 + 0.6 * i], 0.95 - 0.17 * i, 0.29, 0.05);
  for (let i = 0; i < 3; i++)
    parts.circle([x - 1.7 + 0.55 * i, y + high + radius], radius, { density: 0.7, friction });
}

function addTug(parts, x) {
  const [y, high, logX] = [0.6, 0.5, x + 4.6];
  const tug = addHull(parts, [x, y], 1.6, high, 0.8);
  parts.addBox(tug, 0.8, 0.5, { offset: [-0.3, 1], density: 0.3, friction });
  parts.addBox(tug, 0.2, 0.45, { offset: [-0.1, 1.95], density: 0.3, friction });
  const log = parts.box([logX, 0.3], 1.3, 0.28, { density: 1.3, friction });
  parts.link(tug, log, [x + 1.9, y + high], [logX - 1.2, 0.3], (length) => ({
    along: { lower: 0, upper: length },
  }));
}

/** On a chain, which reaches to the ground. */
function addBuoy({ fixed, bar, circle, addBox, hinge }, x) {
  const [links, y] = [8, 0.3];
  const top = y - 0.9;
  const group = -1;
  let at = [x - 3, -5];
  let last = fixed(at);
  addBox(last, 0.5, 0.3, { density: 4, friction, group });
  for (let i = 0; i < links; i++) {
    const to = [at[0] + 3 / links, at[1] + (top + 5) / links];
    const link = bar(at, to, 0.05, { density: 4, friction, group });
    hinge(last, link, at);
    [last, at] = [link, to];
  }
  const buoy = circle([x, y], 0.6, { density: 0.4, friction, group });
  hinge(last, buoy, at);
  addBox(buoy, 0.07, 0.5, { offset: [0, 1], density: 0.4, friction, group });
  addBox(buoy, 0.2, 0.2, { offset: [0, 1.6], density: 0.4, friction, group });
  addBox(buoy, 0.15, 0.3, { offset: [0, -0.6], density: 5, friction, group });
}

/** By themselves, from light to too heavy. */
function addLoose({ box, circle }, half) {
  [0.3, 0.8, 1.4, 5].forEach((density, i) => {
    const at = [-half + 5 + 1.2 * i, 1.5 + 1.2 * i];
    box(at, 0.45, 0.45, { density, friction });
  });
  circle([-half + 2.5, 2.5], 0.55, { density: 0.1, friction });
}
