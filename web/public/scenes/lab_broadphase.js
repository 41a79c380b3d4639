// A gas of circles that pass through each other, so that only the search for pairs has work. The
// counts are those of a second world, made for the broadphase that is chosen, in which each circle is
// put where it is now in the one that is shown; see lab_broadphase/second.js and chart.js.

import { chart, lattice } from "./lab_broadphase/chart.js";
import { createSecond } from "./lab_broadphase/second.js";

export const title = "How few tests find all pairs?";
export const about = "Broadphases search the same gas of circles; their tests are counted, not timed.";
export const menu = { group: "Laboratory", place: 157 };
export const size = { means: "circles", usual: 300, least: 2, most: 2000 };

const BROADPHASES = [
  { value: "all", label: "All pairs" },
  { value: "grid", label: "Grid" },
  { value: "sweep", label: "Sweep x" },
  { value: "sweep_y", label: "Sweep y" },
  { value: "sweep_widest", label: "Sweep widest" },
  { value: "sweep_both", label: "Sweep both" },
];
const ARRANGEMENTS = [
  { value: "spread", label: "Spread" },
  { value: "flat", label: "In a flat room" },
  { value: "upright", label: "In an upright room" },
  { value: "gathered", label: "All in one cell" },
  { value: "unequal", label: "Unequal sizes" },
];
const RADIUS = 0.2;

const CONTROLS = [
  { kind: "choice", name: "broadphase", label: "Broadphase", options: BROADPHASES, group: "Search" },
  {
    ...{ kind: "slider", name: "cellSize", label: "Cell size" },
    ...{ least: 0, most: 20, step: 0.5, group: "Search" },
  },
  {
    ...{ kind: "check", name: "counts", label: "Counts of a step", group: "Search" },
    about: "A test compares the bounds of two circles. Only circles that left their bounds search.",
  },
  {
    ...{ kind: "check", name: "cells", label: "Cells of the grid", group: "Search" },
    about: "At cell size 0 the engine chooses it by the sizes of the circles.",
  },
  {
    ...{ kind: "choice", name: "arrangement", label: "Arrangement" },
    ...{ options: ARRANGEMENTS, group: "Circles" },
  },
];

/** Half the width and height of the room that the circles fly in. */
function roomOf(arrangement, half) {
  if (arrangement === "flat") return [half, half / 16];
  if (arrangement === "upright") return [half / 16, half];
  return arrangement === "gathered" ? [0.25, 0.25] : [half, half];
}

const radiusOf = (arrangement, i) =>
  arrangement === "unequal" ? RADIUS * [0.25, 0.5, 1, 8][i % 32 === 31 ? 3 : i % 3] : RADIUS;

export default function ({ createWorld, random, grid, seed, size, thud }) {
  const world = createWorld({ gravity: [0, 0] });
  const half = Math.max(3, 0.6 * Math.sqrt(size));
  const chance = random(seed + 9);
  const bodies = Array.from({ length: size }, () => {
    const position = [grid(chance(-half, half)), grid(chance(-half, half))];
    const velocity = [chance(-4, 4), chance(-4, 4)];
    return world.createBody({ kind: "dynamic", position, velocity, maySleep: false });
  });
  const shapes = bodies.map((body) => world.createCircle(body, { radius: RADIUS, mask: 0 }));
  const second = createSecond(thud, size);
  const scene = {
    world,
    view: { x: 0.6 * half, y: 0, height: 2.4 * half, width: 3.6 * half },
    controls: CONTROLS,
    state: {
      ...{ broadphase: "grid", cellSize: 0, arrangement: "spread", arranged: "spread" },
      ...{ counts: true, cells: true },
    },
    update() {
      const { state } = scene;
      const room = roomOf(state.arrangement, half);
      if (state.arranged !== state.arrangement) {
        const before = roomOf(state.arranged, half);
        state.arranged = state.arrangement;
        for (let i = 0; i < size; i++) {
          const { position } = world.bodyStateOf(bodies[i]);
          world.setTransform(bodies[i], position.map((x, k) => (x / before[k]) * room[k]));
          world.setRadius(shapes[i], radiusOf(state.arrangement, i));
        }
      }
      const poses = world.poses();
      bodies.forEach((body, i) => turnBack(world, body, poses, 4 * body.index, room));
    },
    paint() {
      const { state } = scene;
      const radii = bodies.map((_, i) => radiusOf(state.arranged, i));
      const { counts, past } = second.count(world, bodies, radii, state);
      const marks = [...lattice(state, world.poses(), bodies, half), ...chart(past, counts, size, half)];
      return { marks, readings: readingsOf(counts, state.broadphase, size) };
    },
    close: () => second.close(),
  };
  return scene;
}

/** Turns a circle back that has left the room and still moves outwards. */
function turnBack(world, body, poses, at, room) {
  const out = [0, 1].map((k) => (Math.abs(poses[at + k]) > room[k] ? Math.sign(poses[at + k]) : 0));
  if (out[0] === 0 && out[1] === 0) return;
  const { velocity } = world.bodyStateOf(body);
  if (!out.some((side, k) => side * velocity[k] > 0)) return;
  world.setVelocity(body, velocity.map((v, k) => (out[k] === 0 ? v : -out[k] * Math.abs(v))));
}

const whole = (n) => Math.round(n).toLocaleString("en");

function readingsOf(counts, broadphase, size) {
  const pairs = (size * (size - 1)) / 2;
  const share = pairs > 0 ? `${((100 * counts.tested) / pairs).toFixed(1)} %` : "none";
  const rows = [
    ["Pairs tested", whole(counts.tested)],
    [`Of n (n − 1) / 2 = ${whole(pairs)}`, share],
    ["Circles that search", `${whole(counts.moved)} of ${whole(size)}`],
    ["Pairs found", whole(counts.found)],
    ["Tests a circle", (counts.tested / size).toFixed(2)],
  ];
  if (broadphase.startsWith("sweep")) rows.push(["Inversions repaired", whole(counts.sortMoves)]);
  const cells = [
    ["Cells used", whole(counts.cells)],
    ["Circles in a cell, mean", (counts.cellShapes / Math.max(counts.cells, 1)).toFixed(2)],
    ["Most in a cell", whole(counts.cellShapesMax)],
  ];
  return { counts: rows, cells: broadphase === "grid" ? cells : [["Cells", "only the grid has some"]] };
}
