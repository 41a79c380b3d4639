// The numbers that the panel reads out, and the line over the picture.

export function tellSwept(met, flown) {
  return {
    readings: { equation: equationRows(met), nearest: nearestRows(met), sagitta: flightRows(flown) },
    message: message(met),
  };
}

/** Without numbers, which change all the time while something is dragged: it is said aloud. */
function message({ coefficients, discriminant, approach: { time } }) {
  if (coefficients[2] <= 0) return "The circles overlap from the start.";
  if (time !== null) return "The circles touch at the smaller root.";
  if (discriminant < 0) return "The discriminant is negative: the circles never touch.";
  return "Both roots are outside of the step: the circles do not touch in it.";
}

const number = (value) => value.toFixed(4).replace("-0.0000", "0.0000");

function equationRows({ reach, coefficients: [a, b, c], discriminant, roots, approach: { time } }) {
  return [
    ["Time of impact, by the engine", time === null ? "never in this step" : number(time)],
    ["R, the radii together", number(reach)],
    ["a = v·v", number(a)],
    ["b = 2 p·v", number(b)],
    ["c = p·p − R²", number(c)],
    ["Discriminant b² − 4 a c", number(discriminant)],
    ["Roots", roots.length > 0 ? roots.map(number).join(" and ") : "none"],
  ];
}

function nearestRows({ reach, approach: { minDistance, minDistanceTime } }) {
  return [
    ["Centres, at their nearest", number(minDistance)],
    ["It comes at", number(minDistanceTime)],
    ["Between the surfaces", number(minDistance - reach)],
  ];
}

function flightRows({ sagitta, gap, miss }) {
  return [
    ["g dt²/8", sagitta.toFixed(5)],
    ["Parabola above the straight way", gap.toFixed(5)],
    ["The engine’s ball off the parabola", miss.toFixed(5)],
  ];
}
