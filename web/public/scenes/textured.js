// A walker on ground with a texture, which says what the ground is made of. What a foot stands on is
// read where it stands: the two vertices on both sides of it weigh in by how near they are, and what
// their weights make of their texture coordinates is a place in the texture.

import { partsOf } from "./joints/parts.js";
import { groundMarks, printMarks, touchMarks } from "./textured/picture.js";
import { coordinatesOf, frictionOf, TEXTURE, textureAt } from "./textured/texture.js";
import { addWalker } from "./walker.js";

export const title = "Textured ground";
export const about =
  "Each foot reads off the texture what it stands on: it grips on rock, slips on ice, leaves its print.";
export const menu = { group: "How it is done", place: 655 };
export const size = { means: "walkers", usual: 1, least: 1, most: 20 };

const BAND = 6; // metres from material to material
const POINTS = 5; // of a band
const WALL = 4; // metres, at both ends
const PRINTS = 80; // that are kept

export default function ({ createWorld, grid, random, size }) {
  const world = createWorld();
  const parts = partsOf(world, grid);
  const ground = parts.fixed().body;
  const bands = addBands(world, ground, random(5), -6 * size - 6, 12 + 2 * size);
  const walkers = Array.from({ length: size }, (_, i) =>
    addWalker(world, parts, i, 12 * (i - 0.5 * (size - 1))),
  );
  const bandOf = new Map(bands.map((band) => [band.shape.index, band]));
  const still = groundMarks(bands);

  /** What of the texture lies where a shape touches the ground. */
  const touches = () =>
    world.contactsOf(ground).flatMap(({ a, b, points }) =>
      points.slice(0, 1).map(({ point: [x] }) => ({
        ...textureAt(world, bandOf.get(a.index), x),
        foot: b.index,
      })),
    );

  const view = { x: 0, y: 2, height: 9, width: 11 * size };
  const walked = () => {
    const ways = walkers.map(({ body, x }) => world.bodyStateOf(body).position[0] - x);
    return ways.reduce((sum, way) => sum + way, 0) / size;
  };
  const scene = {
    world,
    view,
    spawn: [0, 9],
    state: {
      prints: [], // where feet trod and, for as long as they stood, slid to
      standing: [], // feet that stood in the last step
    },
    update() {
      const { state } = scene;
      const now = touches();
      for (const { foot, x, y, normal } of now) {
        const print = state.prints.findLast((one) => one.foot === foot);
        if (print && state.standing.includes(foot)) print.to = [x, y];
        else state.prints.push({ foot, from: [x, y], to: [x, y], normal });
      }
      state.prints = state.prints.slice(-PRINTS);
      state.standing = now.map(({ foot }) => foot);
    },
    paint() {
      const now = touches();
      const last = now.at(-1);
      return {
        follow: [view.x + walked(), view.y],
        marks: [...still, ...printMarks(scene.state.prints), ...touchMarks(now)],
        figures: last ? figuresOf(last, slipOf(scene.state.prints, last)) : [],
      };
    },
  };
  return scene;
}

/** Terrain lines of one body, whose vertices lie at uneven distances; neighbours share their ends. */
function addBands(world, body, chance, start, count) {
  let end = [start, WALL];
  return Array.from({ length: count }, (_, i) => {
    const points = [end];
    for (let j = 1; j < POINTS; j++) {
      const jitter = chance(-0.3, 0.3);
      const x = start + BAND * i + (BAND / (POINTS - 1)) * j + (j < POINTS - 1 ? jitter : 0);
      points.push([x, chance(-0.1, 0.1)]);
    }
    if (i === count - 1) points.at(-1)[1] = WALL;
    end = points.at(-1);
    const row = i % TEXTURE.length;
    const { friction } = TEXTURE[row];
    const shape = world.createTerrain(body, { kind: "irregular", points }, { friction });
    world.setTexture(shape, frictionOf(points, row));
    return { shape, row, points, coordinates: coordinatesOf(points, row) };
  });
}

/** How far a foot has slid since it came down. */
function slipOf(prints, { foot }) {
  const print = prints.findLast((one) => one.foot === foot);
  return print ? Math.hypot(print.to[0] - print.from[0], print.to[1] - print.from[1]) : 0;
}

function figuresOf({ row, u, v, weights, friction }, slip) {
  const { name } = TEXTURE[row];
  return [
    { label: "Under a foot", value: `${name}, friction ${friction.toFixed(2)}` },
    { label: "Weights of the vertices", value: weights.map((weight) => weight.toFixed(2)).join(" + ") },
    { label: "Texture", value: `u ${u.toFixed(2)}, v ${v.toFixed(1)}` },
    { label: "It slid", value: `${slip.toFixed(2)} m` },
  ];
}
