/**
 * Pool against the computer, which tries some random shots in the world by `whatIf`, which restores
 * it, and plays the best one. Who sinks a ball plays again; sinking the cue ball costs a point.
 */
import { circle, walls } from "thud";

export const title = "Pool";
export const about = "Ten balls against a computer that tries its shots beforehand.";
export const menu = { group: "Games", place: 134 };

const RADIUS = 0.03; // of a ball, metres
const [CUE, BALL, POCKET] = [2, 4, 8]; // categories
const HOME = [-0.6, 0]; // of the cue ball
const FASTEST = 4; // m/s
const POWER = 6; // speed for each metre that the pointer was drawn, 1/s
const THINKS = 45; // steps
const TRIES = 4; // shots that the computer tries
const NAMES = ["You", "Computer"];
const POCKETS = [-1.3, 0, 1.3].flatMap((x) => [[x, 0.65], [x, -0.65]]);
const RACK = [[0, 0], [1, -1], [1, 1], [2, -2], [2, 0], [2, 2], [3, -3], [3, -1], [3, 1], [3, 3]];
const INKS = ["gold", "bad", "water", "rival", "accent"];

export default function ({ createWorld }) {
  // Swept detection: balls collide at their time of impact, at any speed.
  const world = createWorld({ gravity: [0, 0], lengthScale: 0.05, detection: "swept" });
  const pockets = POCKETS.map((offset) => circle(0.05, { offset, category: POCKET, sensor: true }));
  const table = world.createBody({ shapes: [...walls(1.3, 0.65, 0.1, { restitution: 0.8 }), ...pockets] });

  const game = {
    world,
    view: { x: 0, y: 0, height: 1.7, width: 2.9 },
    keys: { left: "turn", right: "turn", up: "set the power", down: "set the power", fire: "shoot", restart: "begin anew" },
    pointer: true,
    hidden: [table.index],
    state: begin(),

    update({ held, pointer }) {
      if (held.restart) Object.assign(game.state, begin());
      const { state } = game;
      if (state.over || state.rolls) return;
      if (state.turn === 1) {
        if (++state.waited === THINKS) shoot(bestShot(game, TRIES));
      } else if (aim(held, pointer)) shoot(velocityOf(state));
    },

    stepped() {
      const { state } = game;
      if (!state.rolls) return;
      state.points += sink(world, state.cue);
      state.balls = state.balls.filter(({ body }) => world.isValid(body));
      if (world.awakeBodies().length > 0) return;
      // All is at rest: the next turn.
      state.score[state.turn] += state.points;
      state.last = state.points;
      if (state.points <= 0) state.turn = 1 - state.turn;
      Object.assign(state, { rolls: false, points: 0, waited: 0, over: state.balls.length === 0 });
    },

    paint() {
      const { state } = game;
      const disc = (body, ink) => {
        const [x, y] = world.positionOf(body);
        return { kind: "circle", x, y, radius: RADIUS, ink, filled: true };
      };
      const aims = !state.rolls && !state.over && state.turn === 0;
      return {
        marks: [
          { kind: "box", x: 0, y: 0, halfWidth: 1.4, halfHeight: 0.75, round: 0.08, ink: "soft", filled: true, opacity: 0.5 },
          { kind: "box", x: 0, y: 0, halfWidth: 1.3, halfHeight: 0.65, ink: "good", filled: true, opacity: 0.55 },
          ...POCKETS.map(([x, y]) => ({ kind: "circle", x, y, radius: 0.05, ink: "soft", filled: true })),
          ...(aims ? cueOf(state) : []),
          ...state.balls.map(({ body, ink }) => disc(body, ink)),
          disc(state.cue, "ink"),
        ],
        figures: NAMES.map((label, i) => ({ label, value: String(state.score[i]) })),
        message: message(state),
      };
    },
  };
  return game;

  /** Puts the balls on the table. Returns the game's own data. */
  function begin() {
    for (const body of world.bodies()) if (body.index !== table.index) world.destroy(body);
    const disc = (category) => circle(RADIUS, { category, restitution: 0.95, friction: 0.05 });
    const options = { kind: "dynamic", linearDamping: 1.2, fixedRotation: true };
    const cue = world.createBody({ ...options, position: HOME, shapes: [disc(CUE)] });
    const places = RACK.map(([x, y]) => [0.5 + 1.75 * RADIUS * x, 1.01 * RADIUS * y]);
    const bodies = world.createBodies({ ...options, shapes: [disc(BALL)] }, places);
    const balls = bodies.map((body, i) => ({ body, ink: INKS[i % INKS.length] }));
    const aim = { angle: 0, power: 3, pull: null, before: {} };
    return { cue, balls, ...aim, score: [0, 0], turn: 0, shots: 0, points: 0, last: 0, waited: 0, rolls: false, over: false, seed: 1 };
  }

  function shoot(velocity) {
    const { state } = game;
    world.setVelocity(state.cue, velocity);
    Object.assign(state, { rolls: true, shots: state.shots + 1, pull: null });
  }

  /** Aims by keys, or by drawing the pointer back as a slingshot. True if the player shoots. */
  function aim(held, pointer) {
    const { state } = game;
    state.angle += 0.012 * (held.left - held.right);
    state.power = Math.max(0.3, Math.min(FASTEST, state.power + 0.04 * (held.up - held.down)));
    const fires = held.fire && !state.before.fire;
    state.before = { fire: held.fire };
    if (pointer?.down) {
      state.pull ??= { x: pointer.x, y: pointer.y, length: 0 };
      const [x, y] = [state.pull.x - pointer.x, state.pull.y - pointer.y];
      state.pull.length = Math.hypot(x, y);
      if (state.pull.length > RADIUS) {
        state.angle = Math.atan2(y, x);
        state.power = Math.max(0.3, Math.min(FASTEST, POWER * state.pull.length));
      }
    }
    const letsGo = state.pull && !pointer?.down;
    const drawn = letsGo && state.pull.length > RADIUS;
    if (letsGo) state.pull = null;
    return fires || drawn;
  }

  /** The line of the shot to what it meets first, and the cue behind the ball. */
  function cueOf({ cue, angle, power }) {
    const [x, y] = world.positionOf(cue);
    const [dx, dy] = [Math.cos(angle), Math.sin(angle)];
    const along = (way) => [x + way * dx, y + way * dy];
    const met = world.castShape(circle(RADIUS), [x, y], [3 * dx, 3 * dy], { ignore: cue });
    const way = 3 * (met?.fraction ?? 1);
    const back = 2 * RADIUS + 0.08 * power;
    return [
      { kind: "line", points: [along(RADIUS), along(way)], ink: "ink", width: 1.5, dashed: true },
      { kind: "circle", x: along(way)[0], y: along(way)[1], radius: RADIUS, ink: "ink" },
      { kind: "line", points: [along(-back), along(-back - 0.6)], ink: "accent", width: 5 },
    ];
  }
}

const velocityOf = ({ angle, power }) => [power * Math.cos(angle), power * Math.sin(angle)];

/** What was sunk in the last step: takes balls off the table. Returns the points. */
function sink(world, cue) {
  let points = 0;
  for (const { b: sunk } of world.eventPairs(POCKET, CUE | BALL)) {
    points += sunk.category === BALL ? 1 : -1;
    if (sunk.category === BALL) world.destroy(sunk.body);
    else {
      world.setTransform(cue, HOME);
      world.setVelocity(cue, [0, 0]);
    }
  }
  return points;
}

/** The best of some shots at random balls, with a random error of the angle. */
function bestShot({ world, state }, tries) {
  const random = () => (state.seed = (state.seed * 16807) % 2147483647) / 2147483647;
  const shots = Array.from({ length: tries }, () => {
    const { body } = state.balls[Math.floor(random() * state.balls.length)];
    const [x, y] = world.localPoint(state.cue, world.positionOf(body));
    const angle = Math.atan2(y, x) + 0.1 * (random() - 0.5);
    return velocityOf({ angle, power: FASTEST });
  });
  const worth = shots.map((shot) => world.whatIf(() => {
    let points = 0;
    world.setVelocity(state.cue, shot);
    do {
      world.step();
      points += sink(world, state.cue);
    } while (world.awakeBodies().length > 0);
    return points;
  }));
  return shots[worth.indexOf(Math.max(...worth))];
}

function message({ over, rolls, turn, shots, last, score }) {
  const [you, computer] = score;
  if (over) return `${you > computer ? "You win" : you < computer ? "The computer wins" : "A draw"}, ${you} to ${computer}. Restart to begin anew.`;
  if (rolls) return turn === 0 ? "Your shot." : "The computer’s shot.";
  if (turn === 1) return "The computer tries some shots.";
  if (shots > 0 && last > 0) return "Once more: aim and shoot.";
  return "Sink more balls than the computer: drag back anywhere and let go, or use the keys.";
}

/** A computer player: what it holds in the next step. */
export function robot(game) {
  const { state } = game;
  if (state.rolls || state.turn === 1) return {};
  if (!state.pull) return { pointer: { x: 0, y: 0, down: true } };
  if (state.pull.length > 0) return { pointer: { x: 0, y: 0, down: false } };
  const [vx, vy] = bestShot(game, 3 * TRIES);
  return { pointer: { x: -vx / POWER, y: -vy / POWER, down: true } };
}
