// Four kinds of bodies in a drum, and what each two of them are to each other: a rule for each pair,
// which changes by a timetable until the visitor sets it in the panel. No body turns, so that one-way
// is from above, and none sleeps.

export const title = "Who meets whom";
export const about =
  "Four kinds in a drum collide, ignore each other or hold one way, as a table to click says.";
export const menu = { group: "Who meets whom", place: 563 };
export const size = { means: "bodies", usual: 100, least: 4, most: 2000 };

const [HALF, APART, TURN] = [0.3, 0.7, 0.4363323129985824]; // 25 degrees a second
const NAMES = ["Orange", "Blue", "Green", "Gold"];
const INKS = ["player", "rival", "good", "gold"];
const RULES = ["collide", "ignore", "oneWay"];

// From which step on, of which two kinds, and what they are then to each other.
const TIMETABLE = [
  [0, 0, 1, "ignore"],
  [0, 2, 3, "oneWay"],
  [60, 0, 1, "collide"],
  [60, 0, 2, "ignore"],
  [90, 1, 1, "ignore"],
  [300, 1, 3, "oneWay"],
  [300, 2, 3, "collide"],
];

const kind = (index) => 2 << index;

// The table has a digit for each pair, row by row, and of both orders: it is the same in both.
const placeOf = (a, b) => NAMES.length * a + b;

export default function ({ createWorld, grid, size }) {
  const world = createWorld();
  const columns = Math.ceil(Math.sqrt(size));
  const inner = 1.5 + 0.5 * columns;
  addDrum(world, grid, inner);
  const bodies = Array.from({ length: size }, (_, i) => {
    const x = ((i % columns) - 0.5 * (columns - 1)) * APART;
    const y = (Math.floor(i / columns) - 0.5 * (columns - 1)) * APART + inner;
    const options = { position: [grid(x), grid(y)], fixedRotation: true, maySleep: false };
    const body = world.createBody({ kind: "dynamic", ...options });
    const surface = { friction: 0.6, category: kind(i % NAMES.length) };
    if (i % 2 === 0) world.createCircle(body, { radius: HALF, ...surface });
    else world.createObb(body, { halfWidth: HALF, halfHeight: HALF, ...surface });
    return body;
  });

  const begun = tableAt(0);
  const scene = {
    world,
    view: { x: 0, y: inner, height: 3.2 * inner, width: 3 * inner },
    spawn: [0, inner],
    controls: [
      {
        kind: "matrix",
        name: "meetings",
        label: "What two kinds are to each other",
        names: NAMES,
        words: ["collide", "ignore", "one way"],
        alone: 2, // of these a kind may be so many to itself
        group: "Who meets whom",
      },
    ],
    state: { meetings: begun, timetable: begun },
    update,
    paint: () => ({ marks: bodies.flatMap(mark) }),
  };
  heed(begun);
  return scene;

  function update({ step }) {
    const { state } = scene;
    // What the visitor has set stays.
    if (state.meetings === state.timetable) state.meetings = state.timetable = tableAt(step);
    heed(state.meetings);
  }

  function heed(table) {
    for (let a = 0; a < NAMES.length; a++)
      for (let b = a; b < NAMES.length; b++) {
        const rule = RULES[table[placeOf(a, b)]];
        if ((world.rule(kind(a), kind(b))?.kind ?? "collide") !== rule)
          world.setRule(kind(a), kind(b), { kind: rule });
      }
  }

  function mark(body, i) {
    if (!world.isValid(body)) return [];
    const [x, y] = world.positionOf(body);
    const look = { x, y, ink: INKS[i % INKS.length], filled: true };
    if (i % 2 === 0) return [{ kind: "circle", radius: HALF, ...look }];
    return [{ kind: "box", halfWidth: HALF, halfHeight: HALF, ...look }];
  }
}

function tableAt(step) {
  const digits = Array(NAMES.length * NAMES.length).fill(0);
  for (const [from, a, b, rule] of TIMETABLE)
    if (from <= step) digits[placeOf(a, b)] = digits[placeOf(b, a)] = RULES.indexOf(rule);
  return digits.join("");
}

// One kinematic body of four walls: nothing that is in it can slow it down.
function addDrum(world, grid, inner) {
  const position = [0, grid(inner)];
  const drum = world.createBody({ kind: "kinematic", position, angularVelocity: TURN });
  const [thin, long, friction] = [0.5, inner + 1, 0.6];
  for (const x of [inner + thin, -inner - thin])
    world.createObb(drum, { halfWidth: thin, halfHeight: long, offset: [x, 0], friction });
  for (const y of [inner + thin, -inner - thin])
    world.createObb(drum, { halfWidth: long, halfHeight: thin, offset: [0, y], friction });
}
