/**
 * A race seen from above: three cars, two laps, an oil slick and cones on the track. The force of a
 * tyre is limited by its grip, so that a car that is too fast slides.
 */
import { aabb, circle, obb, walls } from "thud";

export const title = "Car race";
export const about = "Two laps against two computer drivers, on tyres that slide.";
export const menu = { group: "Games", place: 132 };

const [GATE, CAR] = [2, 4]; // categories
const LAPS = 2;
// The places of the gates, in the order in which cars must pass them.
const GATES = [[0, -14], [20, -12], [23, 0], [20, 12], [0, 14], [-20, 12], [-23, 0], [-20, -12]];
const LAST = LAPS * GATES.length + 1; // gates that are passed in a race
// The places of the tyres in the car's frame; the two in front are steered.
const TYRES = [[1.2, 0.7], [1.2, -0.7], [-1.2, 0.7], [-1.2, -0.7]];
const OIL = [10, 15];
const NAMES = ["You", "Ada", "Bob"];
const INKS = ["player", "rival", "good"];
const clamp = (value, most) => Math.max(-most, Math.min(most, value));

export default function ({ createWorld }) {
  const world = createWorld({ gravity: [0, 0] });
  const track = world.createBody({ shapes: [aabb(14, 8), ...walls(29, 20, 2)] });
  const oil = world.createCircle(track, { radius: 3, offset: OIL, sensor: true });
  const gate = { category: GATE, sensor: true };
  const gates = world.createBody({
    shapes: GATES.map((offset, userData) => circle(4, { ...gate, offset, userData })),
  });

  const game = {
    world,
    view: { x: -6, y: -8, height: 40, width: 24 },
    keys: { left: "steer", right: "steer", up: "drive", down: "brake", restart: "race again" },
    pointer: true,
    hidden: [gates.index],
    state: begin(),

    update({ held, pointer }) {
      if (held.restart) Object.assign(game.state, begin());
      const { state } = game;
      if (held.left || held.right || held.up || held.down || pointer?.down) state.started = true;
      if (!state.started) return;
      state.steps++;
      state.racers.forEach((racer, i) => {
        const { steer, thrust, brake } = i === 0 && !state.over ? wish(racer, held, pointer) : aimAt(world, racer);
        for (const at of TYRES) {
          const grip = world.containsPoint(oil, world.worldPoint(racer.car, at)) ? 4 : 40;
          world.applyTyre(racer.car, { at, steer: at[0] > 0 ? steer : 0, thrust, brake, grip });
        }
      });
    },

    stepped() {
      const { state } = game;
      for (const { a: gate, b: car } of world.eventPairs(GATE, CAR)) {
        const racer = state.racers[car.bodyData];
        if (gate.shapeData !== racer.passed % GATES.length || racer.passed === LAST) continue;
        if (++racer.passed === LAST) state.ranking.push({ name: NAMES[car.bodyData], steps: state.steps });
      }
      state.over = state.racers[0].passed === LAST;
    },

    paint() {
      const { state } = game;
      const [you] = state.racers;
      const [x, y] = GATES[you.passed % GATES.length];
      const laps = Math.max(0, Math.floor((you.passed - 1) / GATES.length));
      return {
        // Little is to be seen beyond the walls.
        follow: world.positionOf(you.car).map((place, i) => clamp(place, [17, 8][i])),
        marks: [
          { kind: "circle", x: OIL[0], y: OIL[1], radius: 3, ink: "soft", filled: true, opacity: 0.5 },
          { kind: "circle", x, y, radius: state.over ? 0 : 4, ink: "gold", filled: true, opacity: 0.25 },
          ...state.racers.flatMap(({ car }, i) => picture(car, INKS[i])),
        ],
        figures: [
          { label: "Lap", value: `${Math.min(LAPS, laps + 1)} of ${LAPS}` },
          { label: "Place", value: `${placeOf(state)} of ${NAMES.length}` },
          { label: "Time", value: `${seconds(state.steps)} s` },
        ],
        message: message(state),
      };
    },
  };
  return game;

  /** Puts cars and cones at their places. Returns the game's own data. */
  function begin() {
    for (const body of world.bodies())
      if (body.index !== track.index && body.index !== gates.index) world.destroy(body);
    // Cones are light, and damping soon stops them.
    const places = Array.from({ length: 12 }, (_, i) => [-22 + 4 * i, i % 2 ? 12 : -11]);
    const cone = { linearDamping: 2, angularDamping: 2, shapes: [circle(0.4, { density: 0.2 })] };
    world.createBodies({ kind: "dynamic", ...cone }, places);
    const racers = NAMES.map((_, i) => {
      const position = [-6 - 5 * i, i % 2 ? -12.5 : -15.5];
      const shapes = [obb(2, 0.9, { category: CAR, friction: 0.2 })];
      const car = world.createBody({ kind: "dynamic", position, linearDamping: 0.4, userData: i, shapes });
      return { car, power: [24, 18, 20][i], passed: 0, steer: 0, way: [1, 0], pointed: null };
    });
    return { racers, ranking: [], steps: 0, started: false, over: false };
  }

  /** What the player wants of the car: by keys, or towards where the pointer is held. */
  function wish(racer, held, pointer) {
    let to = 0.6 * (held.left - held.right);
    let [thrust, brake] = [held.up ? racer.power : 0, held.down ? 14 : 0];
    if (pointer?.down) {
      const [x, y] = world.positionOf(racer.car);
      // The view follows the car: a pointer that rests still points the same way.
      if (racer.pointed !== pointer.x + pointer.y) racer.way = [pointer.x - x, pointer.y - y];
      racer.pointed = pointer.x + pointer.y;
      const [ahead, aside] = world.localPoint(racer.car, [x + racer.way[0], y + racer.way[1]]);
      to = clamp(Math.atan2(aside, ahead), 0.6);
      thrust = racer.power;
    }
    racer.steer += clamp(to - racer.steer, 0.08);
    if (brake && forwards(racer) < 1) [thrust, brake] = [-10, 0]; // it backs up
    return { steer: racer.steer, thrust, brake };
  }

  /** The car's speed in the direction in which it looks. */
  function forwards({ car }) {
    const { velocity: [vx, vy] } = world.velocityOf(car);
    const { angle } = world.bodyStateOf(car);
    return vx * Math.cos(angle) + vy * Math.sin(angle);
  }

  function picture(car, ink) {
    const { position: [x, y], angle } = world.bodyStateOf(car);
    const [glassX, glassY] = world.worldPoint(car, [0.5, 0]);
    const box = { kind: "box", angle, filled: true };
    return [
      { ...box, x, y, halfWidth: 2, halfHeight: 0.9, ink },
      { ...box, x: glassX, y: glassY, halfWidth: 0.35, halfHeight: 0.7, round: 0.15, ink: "ink", opacity: 0.7 },
    ];
  }
}

const seconds = (steps) => (steps / 60).toFixed(1);

/** The player's place: how many are ahead, by gates passed. */
function placeOf({ racers, ranking }) {
  const at = ranking.findIndex(({ name }) => name === NAMES[0]);
  if (at >= 0) return at + 1;
  return 1 + racers.filter(({ passed }) => passed > racers[0].passed).length;
}

function message({ started, over, ranking, racers }) {
  if (over) return `${ranking.map(({ name, steps }) => `${name} ${seconds(steps)} s`).join(", ")}. Restart to race again.`;
  if (!started) return "Two laps through the yellow gates: drive, or hold the pointer ahead of the car.";
  return racers[0].passed === 0 ? "Go!" : "Through the yellow gate.";
}

/** A simple driver, who steers towards the next gate and brakes in bends. */
function aimAt(world, { car, power, passed }) {
  const [x, y] = world.localPoint(car, GATES[passed % GATES.length]);
  const steer = clamp(Math.atan2(y, x), 0.6);
  return { steer, thrust: power * (1 - Math.abs(steer)), brake: 8 * Math.abs(steer) };
}

/** A computer player: what it holds in the next step. */
export function robot({ world, state }) {
  const { steer } = aimAt(world, state.racers[0]);
  const held = { left: steer > 0.08, right: steer < -0.08, up: Math.abs(steer) < 0.4, down: Math.abs(steer) > 0.5 };
  return { held };
}
