// Air hockey by two peers, over a line that delays what they tell each other. The scene’s world is
// the truth: the game as if nothing took time. What each peer sees of it is drawn in a rink of its
// own, by one of four methods, and the errors of all four are measured at once. The rink, the
// players, the line, the peers and the picture stand in lab_latency/.
//
// Of the truth each peer gets packets, and its own mallet is where it is. By the first three methods
// it makes a picture of the newest packet; by a rollback it runs the game itself, on the inputs in it.

import { KEPT, METHODS, Peers, peerState, rowOf, WINDOW } from "./lab_latency/peers.js";
import { NAMES, picture } from "./lab_latency/picture.js";
import { wish } from "./lab_latency/players.js";
import { build, inputOf, judge, MIDDLE, OPTIONS, steer } from "./lab_latency/rink.js";

export const title = "Latency";
export const about = "Two peers play air hockey over a slow line; four ways to hide the delay.";
export const menu = { group: "Laboratory", place: 161 };

const slider = (name, label, most, step) => (
  { kind: "slider", name, label, least: 0, most, step, group: "The line" }
);
const CONTROLS = [
  {
    ...{ kind: "choice", name: "method", label: "By", group: "Method" },
    options: METHODS.map((value) => ({ value, label: NAMES[value] })),
  },
  {
    ...{ kind: "check", name: "errors", label: "Errors", group: "Method" },
    about: "How far off the puck is drawn, lengths: the mean of the last 10 s.",
  },
  slider("delay", "Delay, ms", 400, 10),
  slider("jitter", "Jitter, ms", 200, 10),
  slider("loss", "Loss, %", 50, 1),
  {
    ...{ kind: "check", name: "truth", label: "The truth", group: "The line" },
    about: "Rings where the puck and the mallet are, as if nothing took time.",
  },
  {
    ...{ kind: "check", name: "play", label: "Play left", group: "You" },
    about: "Drive the left mallet by pointer or keys.",
  },
];

const MESSAGES = {
  last: "The last packet’s puck stands still.",
  reckoned: "The packet’s puck flies on, through walls too.",
  swept: "The packet’s puck flies on to the first wall.",
  rollback: "Each runs the game, and again as inputs come.",
};

/** How far a key moves the place that a mallet makes for, from where it is. */
const REACH = 0.8;

/** Where the visitor’s mallet is to go. */
function own(mallet, { held, pointer }) {
  const across = Number(held.right) - Number(held.left);
  const along = Number(held.up) - Number(held.down);
  if (across || along) return [mallet[0] + REACH * across, mallet[1] + REACH * along];
  return pointer ? [pointer.x - MIDDLE, pointer.y] : mallet;
}

export default async function ({ createWorld, loadRollback, seed }) {
  const Rollback = await loadRollback();
  const world = createWorld(OPTIONS);
  const bodies = build(world);
  const peers = new Peers(world, bodies, () => createWorld(OPTIONS), Rollback);
  const state = {
    ...{ method: "reckoned", delay: 150, jitter: 0, loss: 0, play: false, seed },
    ...{ errors: true, truth: true },
    ...{ score: [0, 0], ...peerState() },
  };
  peers.begin(state);
  const relative = (body) => {
    const [x, y, vx, vy] = rowOf(state, state.step, body);
    return [x - MIDDLE, y, vx, vy];
  };
  const rows = () => METHODS.map((name, i) => [NAMES[name], lengths(mean(state.offs[i], state.step))]);
  const largest = () => Math.max(...state.jumps[METHODS.indexOf(state.method)].slice(0, state.step + 1));

  return {
    world,
    state,
    controls: CONTROLS,
    view: { x: 0, y: -1.9, height: 16, width: 23 },
    hidden: bodies.map(({ index }) => index),
    pointer: true,
    keys: ["left", "right", "up", "down"],
    update(input) {
      if (Object.values(input.held).some(Boolean)) state.play = true;
      for (const side of [0, 1]) {
        const mallet = relative(1 + side);
        const mine = state.play && side === 0;
        const to = mine ? own(mallet, input) : wish(side, relative(0), mallet, state.step, state.seed);
        state.inputs[side][state.step % KEPT] = inputOf(to);
      }
      steer(world, bodies, state.inputs.map((inputs) => inputs[state.step % KEPT]));
    },
    stepped() {
      judge(world, bodies, state);
      peers.stepped(state);
    },
    restored: () => peers.restored(state),
    paint: () => ({
      marks: picture(state),
      figures: [{ label: "Score", value: state.score.join(" : ") }],
      message: MESSAGES[state.method],
      readings: {
        errors: [
          ["Drawn now", rows()[METHODS.indexOf(state.method)][1]],
          ...rows(),
          ["Largest correction", lengths(largest())],
          ["Steps run again", String(state.replayed)],
        ],
        truth: [["Newest packet", `${state.step - Math.min(...state.known)} steps old`]],
      },
    }),
  };
  function mean(errors, steps) {
    const count = Math.min(steps, WINDOW);
    return count ? errors.reduce((sum, error) => sum + error, 0) / count : 0;
  }
}

const lengths = (value) => value.toFixed(2);
