// A crane sets a lintel on two piers, and then it is yours: drive the trolley, wind the rope up and
// down, let go and take hold of what hangs below the hook, and build on.

import { NOTHING, partsOf } from "./joints/parts.js";

export const title = "Crane";
export const about = "A trolley on its rail and a winch set a lintel on two piers, without a swing.";
export const menu = { group: "Joints", place: 534 };
export const size = { means: "blocks in a pier", usual: 6, least: 1, most: 9 };

const [JIB, MAST, FROM, TO] = [13, -9, -5, 3.4];
const DRIVE = 0.05; // of the trolley, metres a step
const WIND = 1.2; // of the winch, metres a second
const REACH = 1.5; // below the hook, in which it takes hold

export default function ({ createWorld, grid, size }) {
  const world = createWorld();
  const parts = partsOf(world, grid);
  world.createTerrain(parts.fixed().body, { kind: "flat", slope: 0 });
  const crane = addCrane(parts);

  const [halfWidth, halfHeight] = [0.6, 0.4];
  for (let i = 0; i < size; i++)
    for (const side of [-1, 1]) {
      const at = [3 + side * 2.4, halfHeight + 2 * halfHeight * i];
      parts.box(at, halfWidth, halfHeight, { density: 20, friction: 0.8 });
    }
  // Lowered to where the lintel lies, and the straps go slack.
  const { hook, rail, rope, straps } = addLoad(parts, crane, JIB - 4.7 - 0.8 * size + 0.8);

  const scene = {
    world,
    view: { x: -1.5, y: 8, height: 20.5, width: 26 },
    spawn: [3, 11],
    keys: {
      left: "drive",
      right: "drive",
      up: "wind up",
      down: "let down",
      fire: "let go, take hold",
    },
    state: { target: TO - FROM, winding: null, straps, fired: false },
    update,
  };
  return scene;

  function update({ held }) {
    const { state } = scene;
    const drive = held.right - held.left;
    const winding = held.down - held.up;
    if (drive !== 0) {
      state.target = Math.max(-3, Math.min(13, state.target + DRIVE * drive));
      world.setDrive(rail, "along", { target: state.target, lower: -3, upper: 13 });
    }
    // Until the first key the rope goes on as it began.
    if (winding !== (state.winding ?? 0)) {
      state.winding = winding;
      world.setDrive(rope, "along", { motorSpeed: WIND * winding, upper: 12.5 });
    }
    if (held.fire && !state.fired) state.straps = state.straps.length > 0 ? letGo() : takeHold();
    state.fired = held.fire;
  }

  function letGo() {
    for (const strap of scene.state.straps) world.destroy(strap);
    return [];
  }

  /** Of what is below the hook the nearest body, by a rope to its middle. */
  function takeHold() {
    const [x, y] = world.bodyStateOf(hook.body).position;
    const found = world
      .overlap({ kind: "circle", center: [x, y - REACH], radius: REACH })
      .map((shape) => world.shapeStateOf(shape).body)
      .filter(({ index }) => index !== hook.body.index)
      .map((body) => ({ body, state: world.bodyStateOf(body) }))
      .filter(({ state }) => state.kind === "dynamic")
      .map(({ body, state: { position } }) => ({
        body,
        to: position,
        length: Math.hypot(position[0] - x, position[1] - y),
      }))
      .sort((a, b) => a.length - b.length);
    if (found.length === 0) return [];
    const [{ body, to, length }] = found;
    const along = { lower: 0, upper: length };
    const ends = { bodyA: hook.body, bodyB: body, from: [x, y], to };
    return [world.createJoint({ kind: "distance", ...ends, along })];
  }
}

// Seen from afar: nothing meets it.
function addCrane({ fixed, addBar }) {
  const [half, reach, back] = [0.7, 10, 5];
  const [left, right] = [MAST - half, MAST + half];
  const crane = fixed();
  const bar = (a, b, thick) => addBar(crane, a, b, thick, { mask: NOTHING });
  for (const side of [-1, 1])
    bar([MAST + side * half, 0], [MAST + side * half, JIB + 1.4], 0.1);
  for (let i = 0; i < 9; i++)
    bar([i % 2 ? right : left, 1.5 * i], [i % 2 ? left : right, 1.5 * (i + 1)], 0.05);
  bar([MAST - back, JIB + 0.5], [reach, JIB + 0.5], 0.1);
  bar([MAST - half, JIB + 1.3], [reach - 1, JIB + 1.3], 0.07);
  for (let i = 0; i < 18; i++) {
    const x = MAST + half + i;
    bar([x, i % 2 ? JIB + 1.3 : JIB + 0.5], [x + 1, i % 2 ? JIB + 0.5 : JIB + 1.3], 0.04);
  }
  bar([MAST, JIB + 1.3], [MAST, JIB + 4], 0.1);
  bar([MAST, JIB + 4], [reach - 3, JIB + 1.3], 0.05);
  bar([MAST, JIB + 4], [MAST - back, JIB + 0.6], 0.05);
  bar([MAST - back + 0.8, JIB - 1.4], [MAST - back + 0.8, JIB + 0.4], 0.8);
  return crane;
}

// From the trolley a rope to the hook, and from there two to the lintel’s ends.
function addLoad({ box, circle, tie, link }, crane, drop) {
  const half = 3.1;
  const [hookY, lintelY] = [JIB - 2.4, JIB - 2.4 - 2];
  const [group, friction] = [-2, 0.8];
  const calm = { linearDamping: 0.3, angularDamping: 0.3 };
  const trolley = box([FROM, JIB + 0.1], 0.5, 0.22, { density: 40, friction, group });
  const hook = circle([FROM, hookY], 0.22, { density: 40, friction, group }, calm);
  const lintel = box([FROM, lintelY], half, 0.3, { density: 20, friction, group }, calm);
  const weight = 10 * (trolley.mass + hook.mass + lintel.mass);

  // A spring draws the trolley to its place; its force is limited, so that it sets off gently.
  const rail = tie("slider", crane, trolley, [FROM, JIB + 0.1], {
    along: {
      lower: -1,
      upper: TO - FROM + 1,
      frequency: 0.3,
      damping: 1.5,
      target: TO - FROM,
      springForce: 0.06 * weight,
    },
  });
  const rope = link(trolley, hook, [FROM, JIB + 0.1], [FROM, hookY], (length) => ({
    along: { lower: 1, upper: length + drop, motorSpeed: 0.35, motorForce: 3 * weight },
  }));
  const straps = [-1, 1].map((side) =>
    link(hook, lintel, [FROM, hookY], [FROM + side * 0.8 * half, lintelY + 0.3], (length) => ({
      along: { lower: 0, upper: length },
    })),
  );
  return { hook, rail, rope, straps };
}
