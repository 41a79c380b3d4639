// The four worlds that run side by side. They are not in the page's snapshots: when the visitor goes
// back in time, they begin anew and are run up to the step that is shown.

import { createMotion, errorOf, LANES, SECONDS } from "./motions.js";

/** Steps of the page a second, and until the next round: the end is shown for a moment. */
const PAGE = 60;
const ROUND = (SECONDS + 1) * PAGE;

export function createLanes(thud) {
  let lanes = null;
  /** What the lanes run, and how many of their steps they have made. */
  let [run, made] = ["", 0];

  const close = () => {
    for (const { world } of Object.values(lanes ?? {})) world.close();
    lanes = null;
  };
  /** Brings the lanes to the time of the state. */
  const reach = ({ motion, rate, time }) => {
    const steps = Math.round(time * rate);
    if (run !== motion + rate || steps < made) {
      close();
      [run, made] = [motion + rate, 0];
      lanes = Object.fromEntries(LANES.map((name) => [name, createMotion(thud, motion, name, Number(rate))]));
    }
    for (; made < steps; made++) for (const { world } of Object.values(lanes)) world.step();
  };
  const errorsNow = ({ motion, time }) =>
    Object.fromEntries(LANES.map((name) => [name, errorOf(lanes[name], motion, time)]));

  return {
    close,
    /** Goes on by one step of the page; a round begins when the last has ended or the choice changes. */
    update(state, step) {
      const chosen = state.motion + state.rate;
      if (chosen !== state.chosen) state.end = null;
      if (chosen !== state.chosen || step >= state.start + ROUND) {
        state.chosen = chosen;
        state.start = step;
      }
      state.time = Math.min(SECONDS, (step + 1 - state.start) / PAGE);
      if (state.time < SECONDS || state.ended === state.start) return;
      state.ended = state.start;
      reach(state);
      state.end = errorsNow(state);
    },
    look(state) {
      reach(state);
      return { lanes, errors: errorsNow(state) };
    },
  };
}
