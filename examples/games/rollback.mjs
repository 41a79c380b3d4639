/**
 * Air hockey between two peers over a slow line. Neither waits for the other: each predicts that the
 * other's input has not changed, and where that was wrong restores that step and runs the steps since
 * then again. The world is that of the player's peer; the other one is the computer's.
 */
import { aabb, circle, Rollback } from "thud";

export const title = "Air hockey by rollback";
export const about = "Play at once over a slow line; wrong guesses are run again.";
export const menu = { group: "Games", place: 136 };

const LATEST = 12; // the largest delay of an input, steps
const IDLE = 4; // an input of 0 to 8: x is its remainder by 3, y its quotient, each minus 1
const GOALS = 5; // that win
const [PUCK, STRIKER] = [1, 2]; // categories
const [PUCK_RADIUS, RADIUS] = [0.5, 0.8];

export default function ({ createWorld }) {
  const world = createWorld({ gravity: [0, 0] });
  const { puck, strikers } = build(world);
  const start = world.snapshot();
  // A world that is restored from it has the same bodies.
  const peers = [world, createWorld({ gravity: [0, 0] })].map((one) => ({ world: one, puck, strikers, isLast: false }));
  const [, theirs] = peers;
  let own; // the world as the inputs have made it, a snapshot

  const game = {
    world,
    view: { x: 0, y: 0, height: 12, width: 21.5 },
    keys: { left: "push", right: "push", up: "push", down: "push", restart: "play again" },
    pointer: true,
    hidden: [puck, ...strikers].map(({ index }) => index),
    state: begin(),

    update({ held, pointer }) {
      if (held.restart) Object.assign(game.state, begin());
      const { state } = game;
      world.restore(own); // what the page's tools have changed is no input, and does not stay
      if (!state.over) play(inputOf(held, pointer));
    },

    stepped() {
      const { state } = game;
      state.score = scoreOf(world, puck, peers[0].rollback.state);
      state.over = state.score.some((goals) => goals >= GOALS);
      own = world.snapshot();
    },

    /** Time has gone back: both peers get all inputs again that had arrived by then. */
    restored() {
      const { state } = game;
      connect();
      for (let step = 0; step < state.steps; step++) {
        peers.forEach(({ rollback }, player) => {
          for (const from of [0, 1])
            if (from === player || state.due[from][step] < state.steps)
              rollback.input(from, step, state.inputs[from][step]);
          rollback.advance();
        });
      }
      own = world.snapshot();
    },

    paint() {
      const { state } = game;
      const disc = ([x, y], radius, ink) => ({ kind: "circle", x, y, radius, ink, filled: true });
      const [ringX, ringY] = theirs.world.positionOf(theirs.puck);
      return {
        marks: [
          { kind: "line", points: [[0, -5], [0, 5]], ink: "soft", width: 2 },
          { kind: "circle", x: 0, y: 0, radius: 1.5, ink: "soft" },
          ...[-1, 1].map((side) => (
            { kind: "line", points: [[9.6 * side, -3], [9.6 * side, 3]], ink: side < 0 ? "player" : "rival", width: 5 }
          )),
          { kind: "circle", x: ringX, y: ringY, radius: PUCK_RADIUS, ink: "rival" },
          disc(world.positionOf(strikers[0]), RADIUS, "player"),
          disc(world.positionOf(strikers[1]), RADIUS, "rival"),
          disc(world.positionOf(puck), PUCK_RADIUS, "ink"),
        ],
        figures: [
          { label: "You", value: String(state.score[0]) },
          { label: "Computer", value: String(state.score[1]) },
          { label: "Run again", value: `${state.replayed} steps` },
        ],
        message: message(state),
      };
    },

  };
  return game;

  /** A new match, with as many steps as there are inputs. Returns the game's own data. */
  function begin() {
    connect();
    return { inputs: [[], []], due: [[], []], steps: 0, score: [0, 0], replayed: 0, unlike: 0, over: false, seed: 1 };
  }

  /** Both peers begin anew, each with a rollback of its world. */
  function connect() {
    for (const peer of peers) {
      peer.world.restore(start);
      const step = (inputs, score) => {
        judge(peer, score);
        steer(peer, inputs);
        if (!peer.isLast) peer.world.step();
      };
      peer.rollback = new Rollback(peer.world, { idle: [IDLE, IDLE], step, state: [0, 0], depth: 2 * LATEST });
    }
    own = world.snapshot();
  }

  /** A step of both peers: what arrives, what each holds, and what is sent. */
  function play(mine) {
    const { state } = game;
    const now = state.steps++;
    peers.forEach(({ rollback }, player) => {
      const from = 1 - player;
      for (let step = Math.max(0, now - LATEST); step < now; step++)
        if (state.due[from][step] === now) rollback.input(from, step, state.inputs[from][step]);
    });
    peers.forEach((peer, player) => {
      const { rollback } = peer;
      state.replayed += rollback.settle();
      const input = player === 0 ? mine : choose(peer, player);
      state.inputs[player][now] = input;
      state.due[player][now] = now + 3 + Math.floor((LATEST - 2) * random(state));
      rollback.input(player, now, input);
      // Who runs the game makes the last step of this peer's world.
      peer.isLast = player === 0;
      rollback.advance();
      peer.isLast = false;
    });
    const [one, two] = peers.map(({ rollback }) => rollback);
    const known = Math.min(one.confirmed, two.confirmed);
    if (one.hashAt(known) !== two.hashAt(known)) state.unlike++;
  }

  /** Eight directions: by keys, or towards the pointer. */
  function inputOf(held, pointer) {
    const [x, y] = world.positionOf(strikers[0]);
    const push = (way) => (Math.abs(way) < 0.25 ? 0 : Math.sign(way));
    const across = held.right - held.left;
    const along = held.up - held.down;
    if (across || along || !pointer) return IDLE + across + 3 * along;
    return IDLE + push(pointer.x - x) + 3 * push(pointer.y - y);
  }
}

/** Puts puck and strikers into a rink. Returns them. */
function build(world) {
  const wall = (halfWidth, halfHeight, x, y, mask = PUCK | STRIKER) =>
    aabb(halfWidth, halfHeight, { offset: [x, y], mask, restitution: 0.9 });
  const sides = [wall(10.5, 0.5, 0, 5.5), wall(10.5, 0.5, 0, -5.5)];
  const goals = [-10, 10].flatMap((x) => [wall(0.5, 1, x, -4), wall(0.5, 1, x, 4), wall(0.5, 3, x, 0, STRIKER)]);
  world.createBody({ shapes: [...sides, ...goals] });
  world.createBody({ shapes: [aabb(0.02, 5, { mask: STRIKER })] });
  const addDisc = (x, radius, category, linearDamping) => {
    const shapes = [circle(radius, { category, restitution: 0.9, friction: 0 })];
    return world.createBody({ kind: "dynamic", position: [x, 0], linearDamping, shapes });
  };
  const puck = addDisc(0, PUCK_RADIUS, PUCK, 0.1);
  const strikers = [addDisc(-6, RADIUS, STRIKER, 3), addDisc(6, RADIUS, STRIKER, 3)];
  world.setVelocity(puck, [6, 4]);
  return { puck, strikers };
}

/** The score, with a goal of the last step. */
function scoreOf(world, puck, score) {
  const [x] = world.positionOf(puck);
  return Math.abs(x) < 10.5 ? score : score.map((goals, player) => goals + Number((x > 0) === (player === 0)));
}

/** Counts a goal of the step before, and puts the puck in the middle. */
function judge({ world, puck }, score) {
  const [x] = world.positionOf(puck);
  if (Math.abs(x) < 10.5) return;
  score[x > 0 ? 0 : 1]++;
  world.setTransform(puck, [0, 0]);
  world.setVelocity(puck, [6 * Math.sign(x), 4]);
}

function steer({ world, strikers }, inputs) {
  inputs.forEach((held, player) => {
    world.applyCenterForce(strikers[player], [80 * ((held % 3) - 1), 80 * (Math.floor(held / 3) - 1)]);
  });
}

/** The input of a computer player, which moves behind the puck and pushes it, or guards its goal. */
function choose({ world, puck, strikers }, player) {
  const side = 2 * player - 1;
  const [x, y] = world.positionOf(strikers[player]);
  const [px, py] = world.positionOf(puck);
  const behind = [px + 2 * side, py > 0 ? py - 2 : py + 2];
  const to = px * side < 0 ? [6 * side, py / 2] : (x - px) * side > 0.6 ? [px, py] : behind;
  const push = (way) => (Math.abs(way) < 0.2 ? 0 : Math.sign(way));
  return IDLE + push(to[0] - x) + 3 * push(to[1] - y);
}

const random = (state) => (state.seed = (state.seed * 16807) % 2147483647) / 2147483647;

function message({ over, score, steps }) {
  if (over) return `${score[0] > score[1] ? "You win" : "The computer wins"}, ${score.join(" to ")}. Restart to play again.`;
  if (steps < 240) return `First to ${GOALS} goals. The ring is where the other peer sees the puck.`;
  return "";
}

/** A computer player: what it holds in the next step. */
export function robot({ world, hidden, state }) {
  const [puck, ...strikers] = world.bodies().filter(({ index }) => hidden.includes(index));
  const input = choose({ world, puck, strikers }, 0);
  const [across, along] = [(input % 3) - 1, Math.floor(input / 3) - 1];
  return state.over ? {} : { held: { left: across < 0, right: across > 0, up: along > 0, down: along < 0 } };
}
