// What the panel reads out of the line, under what is ticked there, and the line over the picture.

const number = (value, digits = 2) => value.toFixed(digits).replace(/^-(0\.?0*)$/, "$1");
const degrees = ([nx, ny]) => `${number((Math.atan2(-nx, ny) * 180) / Math.PI, 1)}°`;

export function tell(state, seen, box, costs) {
  const readings = {
    weights: weightRows(state, seen),
    foot: footRows(seen),
    box: boxRows(state, seen, box),
    cost: costRows(costs),
  };
  return { readings, message: message(state) };
}

const FOUND = {
  flat: "Flat ground: no search. Its two vertices are x = 0 and x = 1, and beyond them weights go on.",
  uniform: "Equal distances: a division finds the two vertices beside a place.",
  irregular: "Any distances: a binary search finds the two vertices beside a place.",
};

/** Without numbers, which change all the time while something is dragged: it is said aloud. */
function message({ line }) {
  return FOUND[line];
}

function weightRows({ line }, { ground, beside, u, friction }) {
  const names = line === "flat" ? ["x = 0", "x = 1"] : [ground.segment, ground.segment + 1];
  return [
    ["Between vertices", names.join(" and ")],
    ["At x", beside.map(([x]) => number(x)).join(" and ")],
    ["Their weights", ground.weights.map((weight) => number(weight)).join(" and ")],
    ["Height", number(ground.height)],
    ["Texture coordinate", number(u)],
    ["Friction", number(friction)],
  ];
}

function footRows({ feet, stance }) {
  return [
    ["Left foot, height", number(feet[0].height)],
    ["Right foot, height", number(feet[1].height)],
    ["Highest in the stance", `${number(stance.height)} at x ${number(stance.x)}`],
    ["Lean by", degrees(stance.normal)],
  ];
}

function boxRows({ stop }, { stop: summed }, { position: [x], speed, ground, pair }) {
  return [
    ["At x", number(x)],
    ["Speed", `${number(speed)} m/s`],
    ["Friction of the ground", number(ground)],
    ["With the box’s 1", number(pair)],
    ["It last stopped at x", stop === null ? "not yet" : number(stop)],
    ["By v dv = −g (μ + slope) dx", summed === null ? "beyond the end" : number(summed)],
  ];
}

function costRows(costs) {
  if (!costs) return [];
  const { n, flat, uniform, irregular, halvings } = costs;
  const time = (value) => (value === undefined ? "being measured" : `${number(value, value < 10 ? 1 : 0)} ns`);
  return [
    ["Vertices", String(n)],
    ["Flat, no search", time(flat)],
    ["Uniform, 1 division", time(uniform)],
    [`Irregular, ${halvings} halvings`, time(irregular)],
  ];
}
