// A ball falls on a pad, slowly where the two meet. The world's prologue is asked about the contact
// and answers as the panel says: as it is, another surface, a veto, or velocities of its own, as a
// kicker or a portal. After the step epilogues are told: the world's, the ball's, and that of the
// pads, which goes by the category of their shapes.

import { paintAll } from "./lab_callbacks/picture.js";
import { ROW } from "./lab_callbacks/row.js";
import { tell } from "./lab_callbacks/tell.js";

export const title = "Asked and told";
export const about =
  "A contact in slow motion: the prologue is asked, and its answer holds; then the epilogues are told.";
export const menu = { group: "Laboratory", place: 159 };

const ANSWERS = [
  { value: "plain", label: "As it is" },
  { value: "surface", label: "Surface" },
  { value: "veto", label: "Veto" },
  { value: "kicker", label: "Kicker" },
  { value: "portal", label: "Portal" },
];
const slider = (name, label, least, most, step, group) => (
  { kind: "slider", name, label, least, most, step, group }
);
const check = (name, label, about, group = "Epilogues") => ({ kind: "check", name, label, about, group });
const CONTROLS = [
  check("asks", "It is asked", "One function, called about each contact before it is solved.", "Prologue"),
  { kind: "choice", name: "answer", label: "Its answer", options: ANSWERS, group: "Prologue" },
  slider("friction", "Friction", 0, 2, 0.1, "Of the surface"),
  slider("restitution", "Restitution", 0, 1.5, 0.1, "Of the surface"),
  slider("speed", "Speed, m/s", 0, 16, 0.5, "Of the kicker"),
  slider("turn", "Turned by, °", 0, 270, 90, "Of the portal"),
  check("toWorld", "The world’s", "One function for all contacts of the world, called first."),
  check("toBall", "The ball’s", "A function of this body alone: it is called for its own contacts."),
  check("toPads", "The pads’", "A function for all shapes of one category: pads."),
  slider("slow", "Slower by", 1, 32, 1, "Time near the pad"),
];

const [PAD, BALL] = [2, 4]; // categories
const START = { position: [-1.8, 4.5], velocity: [2, 0], radius: 0.5 };
const EXIT = [-3.5, 3.5]; // where the portal leads to
const STEP = 1 / 60; // s
const NEAR = 0.7; // metres of gap within which time is slow
const FLIGHT = 4; // s until the ball falls anew
const TRAIL = 160; // places that are kept

/** What is counted of one fall. */
const nothing = () => (
  { asked: 0, answered: 0, world: 0, ball: 0, pads: 0, impulse: 0, energy: 0, before: null, after: null, at: null }
);

export default function ({ createWorld, grid }) {
  const world = createWorld({ timeStep: STEP, sleeping: false });
  const pad = world.createBody({ position: [0, -0.25] });
  world.createAabb(pad, { halfWidth: 2.5, halfHeight: 0.25, category: PAD, friction: 0.6 });
  const ball = world.createBody({ kind: "dynamic", position: START.position, velocity: START.velocity });
  world.createCircle(ball, { radius: START.radius, category: BALL, friction: 0.6 });
  let heard = ""; // which epilogues are set

  const scene = {
    world,
    view: { x: 0, y: 3.1, height: 8.8, width: 9.5, tall: { x: 0, y: 3, height: 10, width: 8.6 } },
    spawn: [2, 6],
    keys: { fire: "drop again" },
    controls: CONTROLS,
    state: {
      ...{ answer: "kicker", friction: 0, restitution: 1, speed: 11, turn: 90, slow: 12 },
      ...{ asks: true, toWorld: true, toBall: true, toPads: true },
      ...{ time: 0, wasDown: false, isAsked: false, trail: [], fall: nothing(), answers: null },
    },
    update({ held }) {
      const { state } = scene;
      listen(state);
      // What is shown of a fall is of one answer: another one begins with the next fall.
      const answers = [state.asks, state.answer, state.friction, state.restitution, state.speed, state.turn].join();
      const isNew = state.answers !== null && state.answers !== answers;
      state.answers = answers;
      if (isNew || state.time > FLIGHT || isLost() || (held.fire && !state.wasDown)) drop(state);
      state.wasDown = held.fire;
      state.isAsked = false;
      const gap = world.positionOf(ball)[1] - START.radius;
      const step = STEP / (Math.abs(gap) < NEAR ? state.slow : 1);
      if (world.stepSettings().timeStep !== step) world.setTimeStep(step);
      state.time += step;
    },
    stepped() {
      const { state } = scene;
      if (state.isAsked) state.fall.after = world.velocityOf(ball).velocity;
      state.fall.energy += world.stepError().energyDecided;
      state.trail.push([...world.positionOf(ball)]);
      state.trail = state.trail.slice(-TRAIL);
    },
    paint() {
      const position = world.positionOf(ball);
      const seen = { position, radius: START.radius, exit: EXIT, near: state().isAsked };
      return { ...paintAll(state(), seen), ...tell(state()) };
    },
  };
  const state = () => scene.state;

  /** Sets the listeners that are ticked. */
  function listen({ asks, toWorld, toBall, toPads }) {
    const now = `${asks} ${toWorld} ${toBall} ${toPads}`;
    if (now === heard) return;
    heard = now;
    world.setListeners({
      prologue: asks ? prologue : undefined,
      epilogue: toWorld ? toldWorld : undefined,
    });
    world.setBodyEpilogue(ball, toBall ? () => state().fall.ball++ : null);
    world.setCategoryEpilogue(PAD, toPads ? () => state().fall.pads++ : null);
  }

  function isLost() {
    const [x, y] = world.positionOf(ball);
    return Math.abs(x) > 7 || y < -3 || y > 12;
  }

  function drop(state) {
    world.setTransform(ball, START.position.map(grid));
    world.setVelocity(ball, START.velocity);
    Object.assign(state, { time: 0, trail: [], fall: nothing() });
  }

  /** Asked about each contact before it is solved; of the two the pad is a, since it is static. */
  function prologue(rows, count) {
    for (let i = 0; i < count; i++) {
      const row = rows.subarray(i * ROW.length, (i + 1) * ROW.length);
      if (row[ROW.bodyA] !== pad.index + 1 || row[ROW.bodyB] !== ball.index + 1) continue;
      const { velocity } = world.velocityOf(ball);
      const fall = state().fall;
      fall.asked++;
      state().isAsked = true;
      fall.before ??= velocity;
      fall.at ??= { point: [row[ROW.point], row[ROW.point + 1]], normal: [row[ROW.normal], row[ROW.normal + 1]] };
      answer(row, i, velocity);
    }
  }

  /** Writes the answer into the row, or decides the velocity after the collision. */
  function answer(row, i, [x, y]) {
    const { answer: kind, friction, restitution, speed, turn, fall } = state();
    const [nx, ny] = [row[ROW.normal], row[ROW.normal + 1]];
    const along = x * nx + y * ny; // negative while the ball comes down
    if (kind === "plain" || (along >= 0 && kind !== "veto" && kind !== "surface")) return;
    fall.answered++;
    if (kind === "veto") row[ROW.collide] = 0;
    if (kind === "surface") [row[ROW.friction], row[ROW.restitution]] = [friction, restitution];
    if (kind === "kicker")
      world.decide(i, { b: { velocity: [x + (speed - along) * nx, y + (speed - along) * ny] } });
    if (kind === "portal") {
      world.decide(i, { b: { velocity: turned([x, y], turn / 90) } });
      world.setTransform(ball, EXIT); // inside a callback it waits for the next step
    }
  }

  function toldWorld(rows, count) {
    for (let at = 0; at < count * ROW.length; at += ROW.length) {
      if (rows[at + ROW.bodyB] !== ball.index + 1) continue;
      state().fall.world++;
      state().fall.impulse += rows[at + ROW.normalImpulse];
    }
  }

  return scene;
}

/** A vector turned to the left by so many quarters. */
function turned([x, y], quarters) {
  return quarters > 0 ? turned([-y, x], quarters - 1) : [x, y];
}
