// A small game on a level drawn in Tiled (www.mapeditor.org): collect the coins, mind the spikes,
// reach the flag. What a thing is to the game is its `category` in the map; the world tells what
// the figure touches. Try another JUMP_HEIGHT in platformer_game/figure.js, or more LIVES here.
import { findBodies, putBack } from "./platformer_game/bodies.js";
import { DROP, Figure, WALK } from "./platformer_game/figure.js";
import { grassOn } from "./platformer_game/grass.js";
import { findLifts, turnLifts } from "./platformer_game/lifts.js";
import { checkpoint, coin, goal, plank, spikes } from "./platformer_game/pictures.js";

export const title = "Platformer";
export const about = "Run, jump and ride lifts through a level made in Tiled.";
export const menu = { group: "Games", place: 110 };

const PLANK = 2;
const COIN = 4;
const SPIKES = 8;
const CHECKPOINT = 16;
const GOAL = 32;

const LIVES = 3;
const STEPS_PER_SECOND = 60;
const HURT_STEPS = 40; // until the figure is back at its checkpoint
const MARGIN = 0.1; // metres: a touch of the figure's rim does not count
const LEFTMOST = 6; // for the view's middle: little is to be seen beyond the wall there

const HINTS = [
  [4, 7.6, "Hold up for a longer jump"],
  [45, 12.8, "Down drops through a plank"],
  [104, 7.8, "Too high? Push the crate, jump from it"],
];

export default async function (setting) {
  const level = await setting.readLevel("adventure", await setting.readText("levels/adventure.tmj"));
  const world = setting.buildLevel(level);
  const lifts = findLifts(world);
  const crates = findBodies(world, ({ kind }) => kind === "dynamic");
  const sensors = findBodies(world, ({ shape }) => shape.sensor);
  const grass = grassOn(world);
  const planks = findBodies(world, ({ shape }) => shape.category === PLANK);
  const things = new Map(sensors.map((sensor) => [sensor.userData, sensor]));
  const coins = sensors.filter(({ shape }) => shape.category === COIN);
  const figure = new Figure(setting, world, level);

  const begin = () => ({
    figure: figure.startAt(level.spawn),
    phase: "playing", // or "hurt", "won", "over"
    steps: 0, // played
    hurtFor: 0, // steps
    lives: LIVES,
    taken: [], // coins, and checkpoints that were reached: their object numbers in the map
    home: level.spawn,
  });

  const scene = {
    world,
    view: { x: LEFTMOST, y: level.spawn[1] + 1.5, height: 16, width: 12 },
    spawn: level.spawn,
    keys: { ...WALK, ...DROP, restart: "play again" },
    hidden: [figure.body.index, ...sensors.map(({ body }) => body.index)],
    state: begin(),

    update({ held }) {
      turnLifts(world, lifts);
      if (held.restart) restart();
      else if (scene.state.phase === "playing") play(scene.state, held);
      else if (scene.state.phase === "won") figure.move(scene.state.figure, {}); // to the ground
      else lieStill(scene.state);
    },

    restored() {
      figure.restore(scene.state.figure);
    },

    paint() {
      const { state } = scene;
      const [x, y] = state.figure.place;
      return {
        follow: [Math.max(x, LEFTMOST), y + 1.5],
        marks: [
          ...grass,
          ...[...planks, ...sensors].flatMap((thing) => picture(state, thing)),
          ...hints(),
          hero(state),
        ],
        figures: [
          { label: "Time", value: `${seconds(state)} s` },
          { label: "Coins", value: `${coinsOf(state)} of ${coins.length}` },
          { label: "Lives", value: String(state.lives) },
        ],
        message: message(state),
      };
    },
  };
  return scene;

  // Crates too: none is ever lost for good.
  function restart() {
    putBack(world, [...crates, ...lifts]);
    Object.assign(scene.state, begin());
  }

  function play(state, held) {
    state.steps++;
    figure.move(state.figure, held);
    for (const thing of touched(state.figure.place)) meet(state, thing);
  }

  function touched(center) {
    const halfWidth = figure.halfWidth - MARGIN;
    const halfHeight = figure.halfHeight - MARGIN;
    return world
      .overlap({ kind: "aabb", center, halfWidth, halfHeight }, { sensors: true })
      .map((shape) => things.get(world.bodyStateOf(world.shapeStateOf(shape).body).userData))
      .filter((thing) => thing !== undefined);
  }

  function meet(state, { userData, shape, position: [x, y] }) {
    const isNew = !state.taken.includes(userData);
    if (shape.category === COIN && isNew) state.taken.push(userData);
    if (shape.category === CHECKPOINT && isNew) {
      state.taken.push(userData);
      state.home = [x, y - shape.halfHeight + figure.halfHeight + 0.05];
    }
    if (shape.category === GOAL) state.phase = "won";
    if (shape.category === SPIKES && state.phase === "playing") {
      state.lives--;
      state.phase = state.lives > 0 ? "hurt" : "over";
      state.hurtFor = 0;
    }
  }

  function lieStill(state) {
    figure.stop();
    state.hurtFor++;
    if (state.phase === "over" || state.hurtFor < HURT_STEPS) return;
    putBack(world, [...crates, ...lifts]);
    state.figure = figure.startAt(state.home);
    state.phase = "playing";
  }

  function coinsOf({ taken }) {
    return coins.filter(({ userData }) => taken.includes(userData)).length;
  }

  function picture({ taken }, { userData, shape, position: [x, y] }) {
    const { halfWidth, halfHeight, radius } = shape;
    const done = taken.includes(userData);
    if (shape.category === PLANK) return plank(x, y, halfWidth, halfHeight);
    if (shape.category === COIN) return done ? [] : coin(x, y, radius);
    if (shape.category === SPIKES) return spikes(x, y, halfWidth, halfHeight);
    if (shape.category === CHECKPOINT) return checkpoint(x, y, halfHeight, done);
    if (shape.category === GOAL) return goal(x, y, halfHeight);
    return []; // where lifts turn back
  }

  function hints() {
    return HINTS.map(([x, y, text]) => ({ kind: "text", x, y, text, ink: "soft" }));
  }

  function hero({ figure: state, phase }) {
    return figure.mark(state, phase === "hurt" || phase === "over" ? "bad" : "player");
  }

  function message(state) {
    const count = `${coinsOf(state)} of ${coins.length} coins`;
    if (state.phase === "won")
      return `You made it: ${seconds(state)} s, ${count}. Restart to play again.`;
    if (state.phase === "over") return `Game over, with ${count}. Restart to try again.`;
    if (state.phase === "hurt")
      return state.lives > 1 ? `Spikes! ${state.lives} lives left.` : "Spikes! Your last life.";
    return "Collect the coins and reach the flag.";
  }
}

function seconds({ steps }) {
  return (steps / STEPS_PER_SECOND).toFixed(1);
}
