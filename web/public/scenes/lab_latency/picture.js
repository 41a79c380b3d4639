// What is drawn: both peers’ pictures, with the truth as a ring, and two figures below them.

import { APART, GOAL, LONG, MALLET, MIDDLE, PUCK, TIME_STEP, WIDE } from "./rink.js";
import { BIN, BINS, METHODS, rowOf, WINDOW } from "./peers.js";
import { MEASURED } from "./measured.js";

export const NAMES = {
  last: "Last known place",
  reckoned: "Dead reckoning",
  swept: "Swept prediction",
  rollback: "Rollback",
};
const SHORT = ["Last place", "Reckoning", "Swept", "Rollback"];
const INKS = ["bad", "gold", "water", "good"];
/** The box of a figure, relative to the rink above it. */
const LEFT = -4.4;
const RIGHT = 5;
const BOTTOM = -8.4;
const HEIGHT = 3.6;
/** The highest error that a figure shows, lengths, and the time that is drawn, steps. */
const TOP = 4;
const DRAWN = 360;
const EACH = 4;

const line = (points, ink, more = {}) => ({ kind: "line", points, ink, ...more });
const disc = (x, y, radius, ink) => (
  { kind: "circle", x, y, radius, ink, filled: true }
);
const text = (x, y, words, ink, size = 13) => (
  { kind: "text", x, y, text: words, ink, size }
);

export function picture(state) {
  const marks = [];
  for (const peer of [0, 1]) paintPeer(marks, state, peer, MIDDLE + peer * APART);
  paintTime(marks, state, MIDDLE);
  paintDelay(marks, state, MIDDLE + APART);
  METHODS.forEach((name, i) => marks.push(text((i - 1.5) * APART * 0.5, BOTTOM - 1.4, SHORT[i], INKS[i], 11)));
  return marks;
}

/** What a peer sees; its own mallet is where it is. */
function paintPeer(marks, state, peer, middle) {
  const method = METHODS.indexOf(state.method);
  const shift = middle - MIDDLE;
  marks.push(text(middle, 0.45 - WIDE, `${peer === 0 ? "Left" : "Right"} peer’s view`, "ink"));
  marks.push(line([[middle, -WIDE], [middle, WIDE]], "soft", { width: 1 }));
  for (const side of [-1, 1])
    marks.push(line([[middle + side * LONG, -GOAL], [middle + side * LONG, GOAL]], "soft", { width: 1 }));
  const [x, y] = rowOf(state, state.step, 0);
  const own = rowOf(state, state.step, 1 + peer);
  const rival = rowOf(state, state.step, 2 - peer);
  const [puckX, puckY, rivalX, rivalY] = state.seen[peer]?.[method] ?? [x, y, rival[0], rival[1]];
  const inks = ["player", "rival"];
  marks.push(disc(own[0] + shift, own[1], MALLET, inks[peer]));
  marks.push(disc(rivalX + shift, rivalY, MALLET, inks[1 - peer]));
  marks.push(disc(puckX + shift, puckY, PUCK, "ink"));
  if (!state.truth) return;
  marks.push({ ...disc(rival[0] + shift, rival[1], MALLET, "soft"), filled: false });
  marks.push(line([[puckX + shift, puckY], [x + shift, y]], "accent"));
  marks.push({ ...disc(x + shift, y, PUCK, "accent"), filled: false });
}

function axes(marks, middle, title, from, to) {
  const [x0, x1, y1] = [middle + LEFT, middle + RIGHT, BOTTOM + HEIGHT];
  marks.push(line([[x0, y1], [x0, BOTTOM], [x1, BOTTOM]], "soft", { width: 1 }));
  for (let value = 0; value <= TOP; value++)
    marks.push(text(x0 - 0.3, BOTTOM + (value / TOP) * HEIGHT, String(value), "ink", 11));
  marks.push(text(middle, y1 + 0.45, title, "ink", 12));
  marks.push(text(x0 + 0.5, BOTTOM - 0.5, from, "ink", 11), text(x1 - 0.8, BOTTOM - 0.5, to, "ink", 11));
}

const height = (error) => BOTTOM + (Math.min(error, TOP) / TOP) * HEIGHT;

/** The error of each method in the last seconds, the mean of `EACH` steps a point. */
function paintTime(marks, state, middle) {
  axes(marks, middle, "Puck’s error, lengths", `${DRAWN * TIME_STEP} s ago`, "now");
  METHODS.forEach((name, method) => {
    const points = [];
    for (let back = DRAWN - EACH; back >= 0; back -= EACH) {
      let sum = 0;
      for (let i = 0; i < EACH; i++) {
        const step = state.step - back - i;
        sum += step > 0 ? state.offs[method][step % WINDOW] : 0;
      }
      points.push([middle + RIGHT - (back / DRAWN) * (RIGHT - LEFT), height(sum / EACH)]);
    }
    marks.push(line(points, INKS[method], { width: name === state.method ? 3 : 1.2 }));
  });
}

/** The mean error over the delay: measured beforehand as lines, and as it runs as discs. */
function paintDelay(marks, state, middle) {
  axes(marks, middle, "Mean error by delay", "0 ms", `${BIN * (BINS - 1)} ms`);
  const across = (delay) => middle + LEFT + (delay / (BIN * (BINS - 1))) * (RIGHT - LEFT);
  METHODS.forEach((name, method) => {
    const points = MEASURED.delays.map((delay, i) => [across(delay), height(MEASURED[name][i])]);
    marks.push(line(points, INKS[method], { width: name === state.method ? 3 : 1.2 }));
    for (let bin = 0; bin < BINS; bin++) {
      const count = state.counts[bin];
      const error = count > 0 ? state.sums[method][bin] / count : 0;
      const now = count > 0 ? 0.14 : 0.001;
      marks.push(disc(across(bin * BIN), height(error), now, INKS[method]));
    }
  });
}
