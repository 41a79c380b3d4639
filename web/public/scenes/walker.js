// Walking linkages: of Theo Jansen, whose legs go by the lengths that he found, and of Joe Klann, as
// his patent (US 6,260,862) draws it. One motor turns the crank; all else are bars and hinges.

import { meeting, partsOf } from "./joints/parts.js";

export const title = "Walking linkages";
export const about =
  "The legs of Theo Jansen and of Joe Klann walk by one motor each; all else are bars and hinges.";
export const menu = { group: "Joints", place: 538 };
export const size = { means: "walkers", usual: 2, least: 1, most: 50 };

const SINE = 0.8660254037844386;
// The crank’s pins, as parts of its radius: thirds of a turn, and halves.
const THIRDS = [[1, 0], [-0.5, SINE], [-0.5, -SINE]];
const HALVES = [[-1, 0], [1, 0]];

// `height`: of the crank’s axle above the ground; `hangers`: where the legs turn in the frame.
const MAKES = [
  {
    turns: THIRDS,
    scale: 0.045,
    radius: 15,
    height: 95,
    hangers: [[-38, -7.8], [-38, -7.8]],
    speed: -2,
    addLeg: addJansenLeg,
  },
  {
    turns: HALVES,
    scale: 2.1,
    radius: 0.268,
    height: 0.82,
    hangers: [[-0.233, 0.616], [-0.59, -0.176]],
    speed: 2.4,
    addLeg: addKlannLeg,
  },
];

export default function ({ createWorld, grid, size }) {
  const world = createWorld();
  const parts = partsOf(world, grid);
  const right = 12 * size;
  const points = [
    [-60, 3], [-40, 0], [right, 0], [right + 6, 0.4], [right + 10, 0.2],
    [right + 17, 0.9], [right + 24, 0.5], [right + 40, 4],
  ];
  world.createTerrain(parts.fixed().body, { kind: "irregular", points }, { friction: 0.9 });
  const frames = [];
  for (let i = 0; i < size; i++)
    frames.push(addWalker(world, parts, i, 12 * (i - 0.5 * (size - 1))));
  const view = { x: 3, y: 4, height: 9 + 6.5 * size, width: 14 * size };
  const walked = () => {
    const ways = frames.map(({ body, x }) => world.bodyStateOf(body).position[0] - x);
    return ways.reduce((sum, way) => sum + way, 0) / size;
  };
  return {
    world,
    view,
    spawn: [0, 9],
    paint: () => ({ follow: [view.x + walked(), view.y] }),
  };
}

/**
 * By their numbers both makes take turns. A leg is described for the left of the crank’s axle, and
 * mirrored for the right. Parts of one walker do not meet each other.
 */
export function addWalker(world, parts, number, x) {
  const make = MAKES[number % 2];
  const group = -1 - number;
  const { scale, radius, hangers, speed, turns, addLeg } = make;
  const axle = [x, scale * make.height];
  const made = [];
  const keep = (part) => {
    made.push(part);
    return part;
  };
  const place = (side, [px, py]) => [axle[0] + side * scale * px, axle[1] + scale * py];

  const frame = keep(parts.moving(axle));
  for (const hanger of hangers) {
    const left = place(1, hanger);
    const mirrored = [2 * axle[0] - left[0], left[1]];
    parts.addBar(frame, left, mirrored, 0.1, { density: 60, friction: 0.9, group });
  }
  const rod = { density: 2, friction: 0.9, group };
  const crank = keep(parts.circle(axle, scale * radius, rod));
  // A motor from the start, whose force is set when the weight is known.
  const motor = parts.hinge(frame, crank, axle, { turn: { motorSpeed: speed, motorForce: 1 } });

  for (const [tx, ty] of turns)
    for (const side of [-1, 1]) {
      const bar = (a, b) => keep(parts.bar(place(side, a), place(side, b), 0.06, rod));
      const add = (part, a, b) => parts.addBar(part, place(side, a), place(side, b), 0.06, rod);
      const foot = (part, at) => {
        const [fx, fy] = place(side, at);
        const offset = [fx - part.x, fy - part.y];
        parts.addCircle(part, 0.14, { ...rod, offset, friction: 1.5 });
      };
      const pin = (a, b, at) => parts.hinge(a, b, place(side, at));
      addLeg({ frame, crank, bar, add, foot, pin }, [side * radius * tx, radius * ty]);
    }

  const weight = made.reduce((sum, { mass }) => sum + 10 * mass, 0);
  world.setDrive(motor, "turn", { motorForce: 4 * weight * scale * radius });
  return frame;
}

// Jansen’s numbers, in the units that he gives them in; the letters are his. The crank has radius
// 15, and the fixed axle lies 38 beside its own and 7.8 below.
function addJansenLeg({ frame, crank, bar, add, foot, pin }, turn) {
  const [b, c, d, e, f, g, h, i, j, k] = [41.5, 39.3, 40.1, 55.8, 39.4, 36.7, 65.7, 49, 50, 61.9];
  const axle = [-38, -7.8];
  const top = meeting(axle, b, turn, j);
  const low = meeting(turn, k, axle, c);
  const out = meeting(axle, d, top, e);
  const knee = meeting(low, g, out, f);
  const toe = meeting(low, i, knee, h);
  const upperRod = bar(turn, top);
  const lowerRod = bar(turn, low);
  const upper = bar(axle, top);
  add(upper, top, out);
  add(upper, out, axle);
  const rocker = bar(axle, low);
  const link = bar(out, knee);
  const leg = bar(knee, low);
  add(leg, low, toe);
  add(leg, toe, knee);
  foot(leg, toe);
  pin(crank, upperRod, turn);
  pin(crank, lowerRod, turn);
  pin(frame, upper, axle);
  pin(frame, rocker, axle);
  pin(upperRod, upper, top);
  pin(lowerRod, leg, low);
  pin(rocker, leg, low);
  pin(upper, link, out);
  pin(link, leg, knee);
}

// Klann’s places with the crank level, from its axle on; a crank elsewhere keeps the lengths.
function addKlannLeg({ frame, crank, bar, add, foot, pin }, turn) {
  const [high, deep] = [[-0.233, 0.616], [-0.59, -0.176]];
  const level = {
    turn: [-0.268, 0],
    elbow: [-0.858, 0],
    knee: [-1.367, 0.116],
    hip: [-0.733, 0.75],
    toe: [-1.599, -0.75],
  };
  const elbow = meeting(deep, away(deep, level.elbow), turn, away(level.turn, level.elbow));
  const knee = meeting(elbow, away(level.elbow, level.knee), turn, away(level.turn, level.knee));
  const hip = meeting(knee, away(level.knee, level.hip), high, away(high, level.hip));
  const toe = meeting(hip, away(level.hip, level.toe), knee, away(level.knee, level.toe));
  const arm = bar(turn, elbow);
  add(arm, elbow, knee);
  const lower = bar(deep, elbow);
  const upper = bar(high, hip);
  const leg = bar(hip, knee);
  add(leg, knee, toe);
  foot(leg, toe);
  pin(crank, arm, turn);
  pin(frame, lower, deep);
  pin(lower, arm, elbow);
  pin(frame, upper, high);
  pin(upper, leg, hip);
  pin(arm, leg, knee);
}

function away(a, b) {
  const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
  return Math.sqrt(dx * dx + dy * dy);
}
