/**
 * Bombs on a castle, with a saved game: what is saved is the world's snapshot and the game's own
 * data, and a game that loads it goes on to the same bits, in this run of the program or a later one.
 */
import { aabb, circle, obb } from "thud";

export const title = "Castle";
export const about = "Throw a castle off its island with six bombs; save before a bold one.";
export const menu = { group: "Games", place: 135 };

const [STONE, BOMB] = [2, 4]; // categories
const BOMBS = 6;
const WANTED = 12; // stones
const HEIGHT = 9; // from which bombs fall
const LOWEST = -10; // a stone below this is gone
const REACH = 8; // of the crane to either side
const SETTLES = 240; // steps after the last bomb until the game is over

export default function ({ createWorld }) {
  const world = createWorld();
  const island = world.createBody({ shapes: [aabb(8, 0.5, { offset: [0, -0.5] })] });

  const game = {
    world,
    view: { x: 0, y: 3, height: 17, width: 18 },
    keys: { left: "move", right: "move", fire: "drop a bomb", up: "save", down: "load", restart: "begin anew" },
    pointer: true,
    hidden: [island.index],
    state: begin(),
    save,
    load,

    update({ held, pointer }) {
      if (held.restart) Object.assign(game.state, begin());
      const { state } = game;
      const pressed = (key) => held[key] && !state.before[key];
      const taps = pointer && state.before.down && !pointer.down; // let go
      if (pressed("up")) state.saved = save();
      else if (pressed("down") && state.saved) load(state.saved);
      else play(held, pointer, pressed("fire") || taps);
      state.before = { ...held, down: Boolean(pointer?.down) };
    },

    /** A bomb explodes where it meets something; each stone that falls off the island is a point. */
    stepped() {
      const { state } = game;
      state.flash = Math.max(0, state.flash - 1);
      if (state.bomb && world.contactsOf(state.bomb).length > 0) explode(state.bomb);
      const isGone = (body) => world.positionOf(body)[1] < LOWEST;
      if (state.bomb && isGone(state.bomb)) explode(state.bomb);
      const gone = state.stones.filter(({ body }) => isGone(body));
      for (const { body } of gone) world.destroy(body);
      state.stones = state.stones.filter((stone) => !gone.includes(stone));
      state.score += gone.length;
      if (state.bombs === 0 && !state.bomb) state.waited++;
      state.over ||= state.stones.length === 0 || state.waited > SETTLES;
    },

    paint() {
      const { state } = game;
      const { x } = state;
      const at = (body) => {
        const { position, angle } = world.bodyStateOf(body);
        return { x: position[0], y: position[1], angle };
      };
      const [bombX, bombY] = state.bomb ? world.positionOf(state.bomb) : [x, HEIGHT];
      const ready = state.bombs > 0 || state.bomb;
      return {
        marks: [
          { kind: "box", x: 0, y: -0.5, halfWidth: 8, halfHeight: 0.5, round: 0.2, ink: "good", filled: true },
          ...state.stones.map(({ body, halfWidth, halfHeight }) => (
            { kind: "box", ...at(body), halfWidth: halfWidth - 0.03, halfHeight: halfHeight - 0.03, round: 0.06, ink: halfWidth > 1 ? "gold" : "accent", filled: true }
          )),
          { kind: "line", points: [[x - 0.6, HEIGHT + 0.5], [x + 0.6, HEIGHT + 0.5]], ink: "soft", width: 4 },
          { kind: "line", points: [[x, HEIGHT], [x, 0]], ink: "soft", width: 1, dashed: true },
          { kind: "circle", x: bombX, y: bombY, radius: ready ? 0.3 : 0, ink: "ink", filled: true },
          { kind: "circle", x: state.at[0], y: state.at[1], radius: state.flash > 0 ? 3 - 0.2 * state.flash : 0, ink: "bad", filled: true, opacity: 0.03 * state.flash },
        ],
        figures: [
          { label: "Bombs", value: String(state.bombs) },
          { label: "Stones off", value: `${state.score} of ${WANTED}` },
        ],
        message: message(state),
        buttons: { left: "◀", right: "▶", fire: "Drop", up: "Save", ...(state.saved ? { down: "Load" } : {}) },
      };
    },
  };
  return game;

  /** Builds the castle. Returns the game's own data. */
  function begin() {
    for (const body of world.bodies()) if (body.index !== island.index) world.destroy(body);
    const stones = [];
    const addStone = (x, y, halfWidth, halfHeight) => {
      const shapes = [obb(halfWidth, halfHeight, { category: STONE })];
      const body = world.createBody({ kind: "dynamic", position: [x, y], shapes });
      stones.push({ body, halfWidth, halfHeight });
    };
    for (const x of [-6, -2, 2, 6]) for (let y = 0.5; y < 4; y++) addStone(x, y, 0.5, 0.5);
    for (const x of [-4, 0, 4]) addStone(x, 4.2, 2, 0.2);
    const effects = { flash: 0, at: [0, 0] };
    return { stones, ...effects, bomb: null, bombs: BOMBS, score: 0, x: -3, waited: 0, over: false, pointed: null, before: {}, saved: null, news: "" };
  }

  function play(held, pointer, drops) {
    const { state } = game;
    if (held.left || held.right) state.x += 0.12 * (held.right - held.left);
    else if (pointer && pointer.x !== state.pointed) state.x = state.pointed = pointer.x;
    state.x = Math.max(-REACH, Math.min(REACH, state.x));
    if (!drops || state.bomb || state.bombs === 0) return;
    const shapes = [circle(0.3, { category: BOMB, density: 2 })];
    state.bomb = world.createBody({ kind: "dynamic", position: [state.x, HEIGHT], velocity: [0, -6], shapes });
    state.bombs--;
    state.news = "";
  }

  function explode(bomb) {
    const { state } = game;
    state.at = world.positionOf(bomb);
    state.flash = 12;
    state.bomb = null;
    world.destroy(bomb);
    world.explode({ center: state.at, radius: 1, falloff: 3, impulse: 40 });
  }

  /** All that makes up the game, as plain data: write it to a file, or keep it. */
  function save() {
    const { saved, ...rest } = game.state;
    game.state.news = "Saved.";
    return structuredClone({ world: world.snapshot(), rest });
  }

  /** Goes on from what `save` returned, which stays as it is. */
  function load(saved) {
    world.restore(saved.world);
    Object.assign(game.state, structuredClone(saved.rest), { saved, news: "Loaded." });
  }
}

function message({ over, score, bombs, news, saved }) {
  if (over) return `${score >= WANTED ? "The castle is yours" : "The castle stands"}: ${score} stones are off. ${saved ? "Load to try again." : "Restart to begin anew."}`;
  if (news) return news;
  return bombs === BOMBS ? `Throw ${WANTED} stones off the island with ${BOMBS} bombs.` : "";
}

/** Where its bombs fall. */
const PLACES = [-7, 7, -5.4, 5.4, -2.6, 2.6];

/** A computer player: what it holds in the next step. It saves before the fourth bomb. */
export function robot({ state }) {
  if (state.bomb || state.bombs === 0) return {};
  if (state.bombs === 3 && !state.saved) return { held: { up: true } };
  const way = PLACES[BOMBS - state.bombs] - state.x;
  if (Math.abs(way) > 0.1) return { held: { left: way < 0, right: way > 0 } };
  return { held: { fire: state.flash === 0 && !state.before.fire } };
}
