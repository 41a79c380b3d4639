// Artillery duel: two tanks on a real mountainside in Tennessee, and the ground gives way. Over a network
// `match` has what the page needs: all that changes stands in the world and in `state`, and a step depends
// on them and on the players’ inputs alone.
// Change the rules below, or the files that they are made of in scenes/artillery.

import { BLAST, explode } from "./artillery/blast.js";
import { chooseAim } from "./artillery/computer.js";
import { control, heldOf, inputOf, INPUTS, setAim } from "./artillery/controls.js";
import { GRAVITY, lengthOf } from "./artillery/flight.js";
import { buildGround, chooseGround, REACH } from "./artillery/ground.js";
import { picture } from "./artillery/picture.js";
import { barrel, buildLoose, buildShell, buildTank, right } from "./artillery/tanks.js";

export const title = "Artillery duel";
export const about = "Duel the computer or a friend on real hills that every shell digs into.";
export const menu = { group: "Games", place: 120 };

const HEALTH = 100;
const STRONGEST_WIND = 2.5; // metres a second squared, either way
const SAFE_FALL = 5; // metres a second; faster landings hurt
const FALL_HURTS = 5; // health points for each metre a second more
const LONGEST_SETTLING = 300; // steps from a hit to the next turn
const STEP = 1 / 60;
const CHOICE = "Left: play the computer. Right: two players.";

export default async function ({ createWorld, grid, readText, random, seed }) {
  const stretch = await chooseGround(readText, random(seed + 1)(0, 1));
  const world = createWorld({ gravity: [0, -GRAVITY], timeStep: STEP });
  const ground = buildGround(world, stretch);
  const tanks = stretch.sites.map((site) => buildTank(world, site));
  const shell = buildShell(world);
  const loose = buildLoose(world, grid, ground, random(seed + 2));

  let own = -1; // over a network, the tank of whoever looks at this screen; -1: they only watch
  const middle = Math.max(...stretch.sites.map((site) => site.y)) + 4;
  const scene = {
    world,
    view: { x: 0, y: middle, height: 27, width: 46 },
    spawn: [0, middle + 8],
    keys: {
      left: "turn the barrel",
      right: "turn the barrel",
      up: "set the power",
      down: "set the power",
      fire: "fire",
      restart: "begin a new game",
    },
    pointer: true,
    hidden: [shell.index, ...tanks.map(({ body }) => body.index)],
    state: newGame(0),
    update,
    paint: () => picture(scene, tanks, shell, HEALTH, own),
    match: {
      inputs: INPUTS,
      input: inputOf,
      begin(player) {
        own = player ?? -1;
        scene.state.online = true;
        scene.state.computer = false;
        startTurn(scene.state, 0);
      },
      step(inputs) {
        playTogether(inputs);
        world.step();
      },
    },
  };
  return scene;

  /** All that changes, as plain data: with the world's snapshot it is the whole game. */
  function newGame(chances) {
    return {
      phase: "choose", // then "aim", "fly" and "settle" in turn, and "over"
      computer: true, // aims for the second tank
      online: false, // each player has a browser of their own
      waits: false, // for a player who has left
      turn: 0, // whose tank: 0 or 1
      wind: 0, // metres a second squared, to the right
      tanks: [60, 120].map((angle) => ({ health: HEALTH, angle, speed: 17, fall: 0, shots: 0 })),
      chances, // random numbers drawn so far
      plan: null, // the computer's aim, towards which its barrel turns
      waited: 0, // steps in this phase
      velocity: [0, 0], // of the shell, if nothing meets it in the next step
      trail: [],
      effects: [], // rings and figures that fade
      message: CHOICE,
      before: {}, // keys held in the last step
      both: [{}, {}], // over a network, by player
      pointerDown: false,
      holds: { left: 0, right: 0, up: 0, down: 0 },
      pull: null, // a slingshot drawn: where from and by how much
    };
  }

  function update(input) {
    const game = scene.state;
    const pressed = (key) => input.held[key] && !game.before[key];
    const tapped = Boolean(input.pointer?.down) && !game.pointerDown;
    if (pressed("restart")) restart();
    else play(game, input, pressed, tapped);
    scene.state.before = { ...input.held };
    scene.state.pointerDown = Boolean(input.pointer?.down);
  }

  /** A step over a network: of each player the input, null for one who has left. */
  function playTogether(inputs) {
    const game = scene.state;
    game.waits = inputs.includes(null);
    const both = inputs.map((input) => heldOf(input ?? 0));
    const isPressed = (player) => (key) => both[player][key] && !game.both[player][key];
    // After a game either begins the next one.
    const anyone = (key) => isPressed(0)(key) || isPressed(1)(key);
    const pressed = game.phase === "over" ? anyone : isPressed(game.turn);
    play(game, { held: both[game.turn], pointer: null }, pressed, false);
    game.both = both;
  }

  function play(game, input, pressed, tapped) {
    game.waited++;
    game.effects = game.effects.filter((effect) => ++effect.age < effect.life);
    tanks.forEach((_, i) => feelFall(game, i));
    if (game.phase === "choose") choose(game, input, pressed, tapped);
    else if (game.phase === "aim") aim(game, input, pressed, tapped);
    else if (game.phase === "fly") fly(game);
    else if (game.phase === "settle") settle(game);
    else if (pressed("fire") || (tapped && game.waited > 60)) restart();
  }

  function choose(game, input, pressed, tapped) {
    const forOne = pressed("left") || pressed("fire") || (tapped && input.pointer.x < 0);
    const forTwo = pressed("right") || (tapped && input.pointer.x >= 0);
    if (!forOne && !forTwo) return;
    game.computer = forOne;
    startTurn(game, 0);
  }

  function startTurn(game, turn) {
    tanks.forEach((tank) => right(world, grid, ground, tank));
    enter(game, "aim");
    game.turn = turn;
    game.wind = chance(game, -STRONGEST_WIND, STRONGEST_WIND);
    game.plan = null;
    game.pull = null;
    game.holds = { left: 2, right: 2, up: 2, down: 2 }; // a key still held is no new press
    const whose = game.computer ? "Your" : `${nameOf(game, turn)}’s`;
    game.message =
      game.computer && turn === 1
        ? "The computer aims."
        : `${whose} turn: aim and fire, or drag back anywhere and let go.`;
  }

  function aim(game, input, pressed, tapped) {
    if (isDecided(game)) return finish(game); // the ground went from under a tank
    const isComputers = game.computer && game.turn === 1;
    const own = game.tanks[game.turn];
    const fires = isComputers
      ? computerAims(game, own)
      : control(game, own, input, pressed, tapped);
    if (fires) fire(game, own);
  }

  /** Thinks for a moment, then turns the barrel; true when it is there. */
  function computerAims(game, own) {
    if (game.waited < 30) return false;
    const draw = (low, high) => chance(game, low, high);
    game.plan ??= chooseAim(world, tanks[1], tanks[0], game.wind, own.shots, draw);
    const turn = Math.max(-1.5, Math.min(1.5, game.plan.angle - own.angle));
    const more = Math.max(-0.3, Math.min(0.3, game.plan.speed - own.speed));
    const before = [own.angle, own.speed];
    setAim(own, own.angle + turn, own.speed + more);
    return before[0] === own.angle && before[1] === own.speed;
  }

  function fire(game, own) {
    const { muzzle, direction } = barrel(world, tanks[game.turn], own.angle);
    game.velocity = [own.speed * direction[0], own.speed * direction[1]];
    world.setEnabled(shell, true);
    world.setTransform(shell, muzzle);
    world.setVelocity(shell, game.velocity);
    own.shots++;
    game.trail = [];
    game.message = "Fire!";
    game.effects.push({ kind: "flash", x: muzzle[0], y: muzzle[1], radius: 1.4, age: 0, life: 10 });
    enter(game, "fly");
    pushByWind(game);
  }

  /** A shell whose velocity is not what gravity and wind alone make of it has met something. */
  function fly(game) {
    const { position, velocity } = world.bodyStateOf(shell);
    const [x, y] = position;
    const change = lengthOf([velocity[0] - game.velocity[0], velocity[1] - game.velocity[1]]);
    if (Math.abs(x) > REACH || game.waited > 1200) return land(game, null);
    if (game.waited > 1 && change > 0.01) return land(game, position);
    game.trail = [...game.trail, [x, y]].slice(-16);
    pushByWind(game);
  }

  function pushByWind(game) {
    const { mass, velocity } = world.bodyStateOf(shell);
    world.applyCenterForce(shell, [mass * game.wind, 0]);
    game.velocity = [velocity[0] + game.wind * STEP, velocity[1] - GRAVITY * STEP];
  }

  /** At a place, or nowhere: out of the field. */
  function land(game, place) {
    world.setEnabled(shell, false);
    enter(game, "settle");
    if (!place) {
      game.message = "The shell is out of the field.";
      return;
    }
    const [x, y] = place;
    game.effects.push({ kind: "ring", x, y, radius: BLAST, age: 0, life: 32 });
    const hurt = explode(world, ground, tanks, place).map(Math.round);
    hurt.forEach((points, i) => hurtTank(game, i, points));
    const losses = hurt.map((lost, i) => (lost > 0 ? ` ${nameOf(game, i)}: −${lost}.` : ""));
    game.message = hurt.some((lost) => lost > 0) ? `Hit.${losses.join("")}` : "A miss.";
  }

  function hurtTank(game, i, points) {
    if (points <= 0) return;
    const tank = game.tanks[i];
    tank.health = Math.max(0, tank.health - points);
    const [x, y] = world.bodyStateOf(tanks[i].body).position;
    game.effects.push({ kind: "loss", x, y: y + 3.4, text: `−${points}`, age: 0, life: 80 });
    if (tank.health === 0) game.effects.push({ kind: "ring", x, y, radius: 3, age: 0, life: 45 });
  }

  /** Falls count when they end: by the downward speed that is gone. */
  function feelFall(game, i) {
    const tank = game.tanks[i];
    const down = -world.bodyStateOf(tanks[i].body).velocity[1];
    if (down > tank.fall) tank.fall = down;
    else if (down < 0.5 * tank.fall) {
      const points = Math.round((tank.fall - SAFE_FALL) * FALL_HURTS);
      if (game.phase !== "choose") hurtTank(game, i, points);
      tank.fall = 0;
    }
  }

  function settle(game) {
    const speeds = tanks.map(({ body }) => lengthOf(world.bodyStateOf(body).velocity));
    const still = game.waited > 60 && Math.max(...speeds) < 0.2;
    if (!still && game.waited < LONGEST_SETTLING) return;
    if (isDecided(game)) finish(game);
    else startTurn(game, 1 - game.turn);
  }

  function isDecided(game) {
    return game.tanks.some(({ health }) => health === 0);
  }

  function finish(game) {
    enter(game, "over");
    const left = game.tanks.findIndex(({ health }) => health > 0);
    const name = left < 0 ? "Nobody" : nameOf(game, left);
    game.message = `${name} ${name === "You" ? "win" : "wins"}. Fire for another game.`;
  }

  /** Everything back to its place; the winds to come are others. */
  function restart() {
    world.setEnabled(shell, false);
    world.setHeights(ground, 0, stretch.heights);
    for (const { body, position, angle } of [...tanks, ...loose]) {
      world.setEnabled(body, false); // no contact is to remember how it lay
      world.setEnabled(body, true);
      world.setTransform(body, position, angle);
      world.setVelocity(body, [0, 0]);
      world.setAwake(body, true);
    }
    const { online, chances } = scene.state;
    Object.assign(scene.state, newGame(chances), { online, computer: !online });
    if (online) startTurn(scene.state, 0);
  }

  function enter(game, phase) {
    game.phase = phase;
    game.waited = 0;
  }

  function nameOf(game, i) {
    return game.computer ? ["You", "Computer"][i] : ["Left", "Right"][i];
  }

  /** The same numbers again when time went back: the count of those drawn is in the state. */
  function chance(game, low, high) {
    return random(1000 * (seed + 1) + game.chances++)(low, high);
  }
}
