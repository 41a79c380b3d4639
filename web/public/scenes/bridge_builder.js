// Bridge builder: beams tied by hinges, a budget, and a vehicle that has to get across.
// Change the gorges in bridge_builder/levels.js, prices in plan.js, what beams bear in bridge.js.

import { feel, raise, takeDown } from "./bridge_builder/bridge.js";
import { buildLand, LEVELS, VIEW } from "./bridge_builder/levels.js";
import { picture } from "./bridge_builder/picture.js";
import { clear, costOf, emptyPlan, sketch, undo } from "./bridge_builder/plan.js";
import { buildVehicle, drive, putBack } from "./bridge_builder/vehicles.js";

export const title = "Bridge builder";
export const about = "Build a bridge on a budget and see whether it bears what drives over it.";
export const menu = { group: "Games", place: 130 };

const STOPS_AFTER = 3; // metres behind the gorge
const FALLEN = -2.5; // metres: a vehicle that low does not come back
const STUCK = 240; // steps without getting on
const AT_ONCE = 2; // steps: what breaks later breaks because of what broke before

export default function ({ createWorld }) {
  const world = createWorld({ gravity: [0, -10] });
  const anchor = buildLand(world);
  const vehicles = LEVELS.map((level) => buildVehicle(world, level));
  const shown = vehicles.flatMap(({ bodies }) => bodies.map(({ index }) => index));

  const scene = {
    world,
    view: { ...VIEW, x: LEVELS[0].x + LEVELS[0].width / 2 },
    spawn: [LEVELS[0].x + LEVELS[0].width / 2, 6],
    keys: {
      left: "undo",
      right: "clear",
      fire: "drive and to go on",
      restart: "begin a new game",
    },
    pointer: true,
    /** What `picture` paints; it is asked for anew whenever bodies come or go. */
    get hidden() {
      const { bridge } = scene.state;
      const bodies = bridge ? [...bridge.nodes, ...bridge.beams.map(({ body }) => body)] : [];
      return [...shown, ...bodies.map(({ index }) => index)];
    },
    state: newGame(),
    update,
    paint: () => picture(world, LEVELS, vehicles, scene.state),
  };
  return scene;

  /** All that changes, as plain data: with the world's snapshot it is the whole game. */
  function newGame() {
    return {
      phase: "plan", // then "drive", and "won" or "lost"
      level: 0,
      stars: LEVELS.map(() => 0), // the most that each gorge has brought
      plan: emptyPlan(),
      bridge: null, // while it stands
      broken: 0, // beams
      first: [], // those that broke first in the last test, until the next one
      sinceBroken: 0, // steps since the first of them
      waited: 0, // steps in this phase
      stuck: 0, // steps without getting on
      effects: [], // rings that fade
      note: "", // what became of the last thing that was tried
      before: {}, // keys held in the last step
    };
  }

  function update({ held, pointer }) {
    const game = scene.state;
    const pressed = (key) => held[key] && !game.before[key];
    game.waited++;
    game.effects = game.effects.filter((effect) => ++effect.age < effect.life);
    if (pressed("restart")) restart(game);
    else if (game.phase === "plan") planOn(game, pointer, pressed);
    else driveOn(game, pressed);
    game.before = { ...held };
  }

  function planOn(game, pointer, pressed) {
    const { plan } = game;
    const note = sketch(plan, LEVELS[game.level], pointer);
    if (note !== null) game.note = note;
    if (pressed("left")) game.note = undo(plan);
    if (pressed("right")) game.note = clear(plan);
    if (pressed("fire")) start(game);
  }

  function start(game) {
    game.bridge = raise(world, anchor, LEVELS[game.level], game.plan.beams);
    game.plan.selected = game.plan.press = null;
    game.broken = game.stuck = game.sinceBroken = 0;
    game.first = [];
    drive(world, vehicles[game.level], true);
    enter(game, "drive");
  }

  function driveOn(game, pressed) {
    const level = LEVELS[game.level];
    const vehicle = vehicles[game.level];
    if (game.broken > 0) game.sinceBroken++;
    for (const beam of feel(world, game.bridge)) {
      const [x, y] = world.bodyStateOf(beam.body).position;
      game.effects.push({ x, y, age: 0, life: 30 });
      game.broken++;
      const at = game.bridge.beams.indexOf(beam);
      if (game.sinceBroken < AT_ONCE) game.first.push(game.plan.beams[at]);
    }
    const { position, velocity } = world.bodyStateOf(vehicle.chassis);
    const past = position[0] - level.x - level.width;
    if (past > STOPS_AFTER) drive(world, vehicle, false);
    if (game.phase === "drive") {
      game.stuck = Math.abs(velocity[0]) < 0.1 ? game.stuck + 1 : 0;
      if (past > vehicle.rear) win(game, level);
      else if (position[1] < FALLEN || game.stuck > STUCK) enter(game, "lost");
    }
    if (game.phase === "won" && pressed("left")) backToPlan(game);
    else if (pressed("fire")) goOn(game);
  }

  function win(game, level) {
    const saved = level.budget - costOf(game.plan.beams);
    const stars = 1 + level.stars.filter((least) => saved >= least).length;
    game.stars[game.level] = Math.max(stars, game.stars[game.level]);
    const next = level.stars[stars - 1];
    const more = next ? ` Save ${next} for ${"★".repeat(stars + 1)}.` : "";
    game.note = `${"★".repeat(stars)}${"☆".repeat(3 - stars)} Across, with ${saved} saved.${more}`;
    enter(game, "won");
  }

  /** To the next gorge, or back to the drawing board. */
  function goOn(game) {
    if (game.phase !== "won") backToPlan(game);
    else if (game.level === LEVELS.length - 1) restart(game);
    else {
      takeDown(world, game.bridge);
      drive(world, vehicles[game.level], false);
      Object.assign(game, { plan: emptyPlan(), first: [], level: game.level + 1 });
      planAnew(game);
    }
  }

  function backToPlan(game) {
    takeDown(world, game.bridge);
    putBack(world, vehicles[game.level]);
    planAnew(game);
  }

  function planAnew(game) {
    Object.assign(game, { bridge: null, effects: [], note: "" });
    enter(game, "plan");
  }

  function restart(game) {
    if (game.bridge) takeDown(world, game.bridge);
    for (const vehicle of vehicles) putBack(world, vehicle);
    Object.assign(game, newGame());
  }

  function enter(game, phase) {
    game.phase = phase;
    game.waited = 0;
  }
}
