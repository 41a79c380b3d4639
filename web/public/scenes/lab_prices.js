// Four detections at work on a motion that is known in closed form, each in a world of its own: the
// scenes that the panel Trade measures under “Detection, priced”, where error stands over time.

import { LANES } from "./lab_prices/motions.js";
import { createLanes } from "./lab_prices/lanes.js";
import { paintLanes } from "./lab_prices/picture.js";

export const title = "Detection, priced";
export const about =
  "Overlap, bisection and swept on a motion known in closed form: error over time, from 60 to 960 steps a second.";
export const menu = { group: "Laboratory", place: 153 };

const choice = (name, label, options, group) => (
  {
    ...{ kind: "choice", name, label, group },
    options: options.map((value) => ({ value, label: value[0].toUpperCase() + value.slice(1) })),
  }
);

const CONTROLS = [
  choice("motion", "Motion", ["shuttle", "hop"], "Balls that lose no energy"),
  choice("rate", "Steps a second", ["60", "120", "240", "480", "960"], "Balls that lose no energy"),
  {
    ...{ kind: "check", name: "errors", label: "Error now", group: "Look at" },
    about: "The mean distance of 64 balls from where the closed form has them.",
  },
  {
    ...{ kind: "check", name: "ends", label: "Error after two seconds", group: "Look at" },
    about: "It stays until the next round ends. The panel Trade measures what it costs.",
  },
];

const millimetres = (metres) => `${(1000 * metres).toFixed(2)} mm`;

export default function ({ createWorld, thud }) {
  const state = {
    ...{ motion: "shuttle", rate: "60", errors: true, ends: true },
    ...{ chosen: "", start: 0, time: 0 }, // of the round: what is shown, its first step, its time in s
    ...{ ended: -1, end: null }, // the first step of the round that ended last, and its errors
  };
  const lanes = createLanes(thud);
  return {
    world: createWorld({ gravity: [0, 0] }),
    view: { x: 0, y: 2.2, height: 8.5, width: 13 },
    panel: "trade",
    controls: CONTROLS,
    state,
    update: ({ step }) => lanes.update(state, step),
    paint() {
      const seen = lanes.look(state);
      const rows = (errors) => LANES.map((name) => [name, errors ? millimetres(errors[name]) : "not yet"]);
      return {
        marks: paintLanes(state, seen),
        readings: { errors: rows(seen.errors), ends: rows(state.end) },
      };
    },
    close: lanes.close,
  };
}
