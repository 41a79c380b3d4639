// A clock that a falling weight drives. Gears lead to an escape wheel, whose teeth the anchor lets
// pass one at a time while its pendulum swings; and each tooth pushes it on. Stop the pendulum.

import { NOTHING, partsOf, PI } from "./joints/parts.js";

export const title = "Clock";
export const about =
  "A falling weight drives it through gears, and its pendulum lets one tooth pass at a time.";
export const menu = { group: "Joints", place: 540 };
export const size = { means: "times the weight", usual: 1, least: 1, most: 3 };

const TEETH = 15; // of the escape wheel
const RIM = 2; // its radius
// Half of what the anchor spans, three and a half teeth: while one tooth leaves on one side, another
// is half way to the other side.
const [SPAN_SINE, SPAN_COSINE] = [0.6691306063588582, 0.7431448254773942];
// The fifteenth, the twelfth and the thirtieth part of a turn.
const FIFTEENTH = [0.9135454576426009, 0.4067366430758002];
const TWELFTH = [0.8660254037844386, 0.5];
const THIRTIETH = [0.9781476007338057, 0.20791169081775934];

const DIAL = [-3.5, -1.4];
const DRUM = 0.6; // its radius
// Radii of wheels and pinions add up to what lies between their axles.
const [ESCAPE, SECOND, THIRD] = [[0, 3.4], [2.304, 2.728], [3.074, 0.088]];

const brass = { density: 1, friction: 0, mask: NOTHING }; // all but these:
const tooth = { friction: 0, category: 2, mask: 4 };
const pallet = { density: 4, friction: 0, category: 4, mask: 2 };
const awake = { maySleep: false };

export default function ({ createWorld, grid, size }) {
  const world = createWorld();
  const parts = partsOf(world, grid);
  const frame = addCase(parts);
  addAnchor(parts, frame);
  const escape = addEscapeWheel(parts, frame);
  const second = addWheel(parts, frame, SECOND, 1.8, 0.55);
  const third = addWheel(parts, frame, THIRD, 2.2, DRUM);
  const minute = addHand(parts, frame, 1.9, 0.08);
  const hour = addHand(parts, frame, 1.3, 0.12);
  const weight = addWeight(parts, frame, 220 * size);

  const gear = (jointA, jointB, ratio) => world.createJoint({ kind: "gear", jointA, jointB, ratio });
  // Each pinion has a third, and a quarter, of the wheel that it meshes with.
  gear(escape, second, 3);
  gear(second, third, 4);
  // A turn to the right lets the weight down by the drum’s circumference.
  gear(weight, third, -DRUM);
  gear(escape, minute, -2);
  gear(minute, hour, -12);
  return { world, view: { x: 0, y: 0.4, height: 20, width: 16 }, spawn: [10, 0] };
}

function turned([x, y], [cosine, sine]) {
  return [x * cosine - y * sine, x * sine + y * cosine];
}

function from([x, y], [dx, dy], radius) {
  return [x + radius * dx, y + radius * dy];
}

// Calls `draw` with `count` directions that are a part of a turn from each other.
function round(count, part, first, draw) {
  let direction = first;
  for (let i = 0; i < count; i++) {
    const next = turned(direction, part);
    draw(direction, next, i);
    direction = next;
  }
  return direction;
}

function addCase({ fixed, addBar }) {
  const frame = fixed();
  const bar = (a, b, half) => addBar(frame, a, b, half, brass);
  bar([-7, -8.4], [7, -8.4], 0.25);
  bar([-6.6, -8.4], [-6.6, 7.2], 0.2);
  bar([6.6, -8.4], [6.6, 7.2], 0.2);
  bar([-7.2, 7.2], [0, 9.4], 0.2);
  bar([7.2, 7.2], [0, 9.4], 0.2);
  round(30, THIRTIETH, [0, 1], (a, b) => bar(from(DIAL, a, 2.4), from(DIAL, b, 2.4), 0.06));
  round(12, TWELFTH, [0, 1], (a) => bar(from(DIAL, a, 2.05), from(DIAL, a, 2.4), 0.05));
  return frame;
}

// Two pallets on arms that touch the rim, and the pendulum below.
function addAnchor({ moving, addBar, addCircle, hinge }, frame) {
  const length = 6.6;
  const pivot = [ESCAPE[0], ESCAPE[1] + RIM / SPAN_COSINE];
  const anchor = moving(pivot, { ...awake, angularVelocity: 0.18, angularDamping: 0.02 });
  const arm = { ...brass, density: 4 };
  const ends = [-1, 1].map((side) =>
    from(ESCAPE, [side * SPAN_SINE, SPAN_COSINE], RIM + 0.04),
  );
  [-1, 1].forEach((side, i) => {
    const knee = from(pivot, [side * SPAN_COSINE, -SPAN_SINE + 0.3], 1.9);
    addBar(anchor, pivot, knee, 0.09, arm);
    addBar(anchor, knee, ends[i], 0.07, arm);
  });
  addBar(anchor, pivot, [pivot[0], pivot[1] - length], 0.06, arm);
  addCircle(anchor, 0.75, { ...brass, density: 30, offset: [0, -length] });
  for (const [x, y] of ends)
    addCircle(anchor, 0.12, { ...pallet, offset: [x - pivot[0], y - pivot[1]] });
  hinge(frame, anchor, pivot);
}

function addEscapeWheel({ circle, addBar, hinge }, frame) {
  const wheel = circle(ESCAPE, 0.6, brass, awake);
  const start = round(TEETH, FIFTEENTH, [0, 1], (a, b, i) => {
    addBar(wheel, from(ESCAPE, a, 1.25), from(ESCAPE, b, 1.25), 0.07, brass);
    if (i % 5 === 0) addBar(wheel, ESCAPE, from(ESCAPE, a, 1.25), 0.08, brass);
  });
  round(TEETH, FIFTEENTH, start, (a) =>
    addBar(wheel, from(ESCAPE, a, 1.25), from(ESCAPE, a, RIM), 0.035, tooth),
  );
  return hinge(frame, wheel, ESCAPE);
}

// Returns its hinge.
function addWheel({ circle, addBar, hinge }, frame, at, radius, pinion) {
  const wheel = circle(at, pinion, brass, awake);
  round(2 * TEETH, THIRTIETH, [1, 0], (a, b, i) => {
    const rim = from(at, a, radius - 0.16);
    addBar(wheel, rim, from(at, b, radius - 0.16), 0.06, brass);
    addBar(wheel, rim, from(at, a, radius + 0.1), 0.05, brass);
    if (i % 10 === 0) addBar(wheel, at, rim, 0.07, brass);
  });
  return hinge(frame, wheel, at);
}

function addHand({ circle, addBar, hinge }, frame, length, half) {
  const hand = circle(DIAL, 2 * half, brass, awake);
  addBar(hand, DIAL, [DIAL[0], DIAL[1] + length], half, brass);
  return hinge(frame, hand, DIAL);
}

// On its rail below the drum; returns the slider.
function addWeight({ box, tie }, frame, mass) {
  const at = [THIRD[0] + DRUM, THIRD[1] - 2];
  const weight = box(at, 0.45, 0.7, { ...brass, density: mass / (4 * 0.45 * 0.7) }, awake);
  return tie("slider", frame, weight, at, { angle: 0.5 * PI, along: { lower: -5, upper: 0.5 } });
}
