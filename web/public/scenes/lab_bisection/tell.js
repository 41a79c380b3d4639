// The numbers that the panel reads out, and the line over the picture.

export function tellBisection(halved, shots) {
  return {
    readings: { interval: intervalRows(halved), bound: boundRows(shots) },
    message: message(halved),
  };
}

/** Without numbers, which change all the time while something is dragged: it is said aloud. */
function message({ found, overlapsAtStart, impact }) {
  if (overlapsAtStart) return "The shapes overlap at the start of the step: nothing is to be halved.";
  if (found) return "Apart at the start and overlapping at the end: halving closes in on the time between.";
  return impact === null
    ? "The shapes do not meet in this step."
    : "The shapes meet within the step and are apart at its end: the overlap test misses that.";
}

const time = (value) => (value === null ? "none" : value.toFixed(5));

function intervalRows({ intervals, tests, found, engine, impact }) {
  const { low, high } = intervals.at(-1);
  return [
    ["Interval", found ? `${time(low)} to ${time(high)}` : "no collision is found"],
    ["Its length", found ? `1/${1 / (high - low)} of the step` : "the whole step"],
    ["Overlap tests spent", String(tests)],
    ["The engine, to this length", time(engine.time)],
    ["Swept test, exact", time(impact)],
    ["Can halving miss them?", engine.bisectable ? "no" : "yes, they move too far"],
  ];
}

function boundRows({ motion, thinnest, bisectable, limit, poses, lanes }) {
  return [
    ["Bound", bisectable ? "kept: is caught" : "broken: may pass"],
    ["Speed × step", motion.toFixed(3)],
    ["Thinnest of paper and bullet", thinnest.toFixed(2)],
    ["Speed at the bound", limit.toFixed(2)],
    ["Poses that touch the paper", String(poses)],
    ...lanes.map(({ detection, outcome }) => [`With ${detection}`, outcome]),
  ];
}
