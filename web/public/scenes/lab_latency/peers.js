// What each peer sees, by each method, and how far that is from the truth.

import { LONGEST, newest } from "./line.js";
import { build, judge, steer, TIME_STEP } from "./rink.js";

export const METHODS = ["last", "reckoned", "swept", "rollback"];
/** Steps of which inputs and places are kept. */
export const KEPT = 256;
/** Steps between two snapshots from which a rollback begins anew after going back in time. */
const BASES = 128;
/** Steps over which errors are averaged, and of which the picture is drawn. */
export const WINDOW = 600;
/** Numbers of a body in the past: x, y and both velocities. */
const NUMBERS = 4;
const ROW = 3 * NUMBERS;
/** The bins of the delay, ms. */
export const BIN = 50;
export const BINS = 9;

/** The part of the state that peers need. */
export const peerState = () => ({
  step: 0,
  inputs: [new Float64Array(KEPT), new Float64Array(KEPT)],
  past: new Float64Array(KEPT * ROW),
  known: [0, 0], // the newest packet that each peer has
  replayed: 0,
  bases: [],
  seen: [], // by peer and method: places of the puck and of the rival’s mallet
  off: [], // by peer and method: where the puck is drawn, less where it is
  offs: METHODS.map(() => new Float32Array(WINDOW)),
  jumps: METHODS.map(() => new Float32Array(WINDOW)),
  sums: METHODS.map(() => new Float64Array(BINS)),
  counts: new Float64Array(BINS),
});

/** Both peers of the game that is in `world`, with worlds of their own by `createWorld`. */
export class Peers {
  #world;
  #bodies;
  #Rollback;
  #worlds;
  /** A world to ask what follows from a packet: it is never stepped. */
  #asked;
  /** For each peer its rollback, and the number of the step that is its first. */
  #sessions = [];

  constructor(world, bodies, createWorld, Rollback) {
    this.#world = world;
    this.#bodies = bodies;
    this.#Rollback = Rollback;
    this.#worlds = [0, 1].map(() => createWorld());
    this.#asked = createWorld();
    for (const one of [...this.#worlds, this.#asked]) build(one);
  }

  /** Notes where everything is before the first step. */
  begin(state) {
    this.#note(state);
    this.#base(state);
    this.#begin(state, state.bases[0]);
  }

  /** After a step of the world: packets arrive, and each peer draws its picture. */
  stepped(state) {
    state.step++;
    this.#note(state);
    for (const peer of [0, 1]) {
      const before = state.known[peer];
      state.known[peer] = newest(state.step, peer, before, state);
      this.#hear(state, peer, before);
      const { rollback } = this.#sessions[peer];
      const run = rollback.replayed;
      rollback.advance();
      state.replayed += rollback.replayed - run;
      state.seen[peer] = this.#look(state, peer);
    }
    this.#measure(state);
    if (state.step % BASES > 0) return;
    this.#base(state);
    if (this.#strayed(state.bases[0])) this.restored(state);
  }

  /** After the state was restored: the same rollbacks, from a snapshot of the past. */
  restored(state) {
    const oldest = Math.min(...state.known, state.step);
    const base = [...state.bases].reverse().find(({ step }) => step <= oldest);
    this.#begin(state, base);
    for (const [peer, { rollback, from }] of this.#sessions.entries())
      for (let step = from; step < state.step; step++) {
        for (const player of [0, 1])
          if (player === peer || step < state.known[peer])
            rollback.input(player, step - from, state.inputs[player][step % KEPT]);
        rollback.advance();
      }
  }

  /** The world’s hash after a number of steps, by a peer’s rollback; all its inputs have arrived. */
  hashAt(peer, step) {
    const { rollback, from } = this.#sessions[peer];
    return rollback.hashAt(step - from);
  }

  #begin(state, base) {
    // A rollback predicts the input before its first step by `idle`.
    const idle = [0, 1].map((player) => state.inputs[player][(base.step + KEPT - 1) % KEPT]);
    this.#asked.restore(base.snapshot); // from here on it has the bodies' handles
    this.#sessions = this.#worlds.map((world) => {
      world.restore(base.snapshot);
      const bodies = this.#bodies;
      const step = (inputs, game) => {
        steer(world, bodies, inputs);
        world.step();
        judge(world, bodies, game);
      };
      const game = { score: [...base.score] };
      const rollback = new this.#Rollback(world, { idle, step, state: game, depth: KEPT });
      return { rollback, from: base.step };
    });
  }

  #base(state) {
    const world = this.#world;
    const [snapshot, hash] = [world.snapshot(), world.hash()];
    const base = { step: state.step, snapshot, hash, score: [...state.score] };
    state.bases = [...state.bases.slice(-1), base];
  }

  /**
   * Whether a peer had another game than the truth at a base: the visitor has thrown something in,
   * or chosen another quality, which no input tells.
   */
  #strayed({ step, hash }) {
    const kept = ({ from }) => step >= from;
    return this.#sessions.some((one, peer) => kept(one) && this.hashAt(peer, step) !== hash);
  }

  /** Keeps where all bodies are now. */
  #note({ past, step }) {
    this.#bodies.forEach((body, i) => {
      const at = (step % KEPT) * ROW + i * NUMBERS;
      past.set([...this.#world.positionOf(body), ...this.#world.velocityOf(body).velocity], at);
    });
  }

  /** A peer’s own input of the last step, and those of the other one that have just arrived. */
  #hear(state, peer, before) {
    const { rollback, from } = this.#sessions[peer];
    const own = state.step - 1;
    rollback.input(peer, own - from, state.inputs[peer][own % KEPT]);
    for (let step = Math.max(before, from); step < state.known[peer]; step++)
      rollback.input(1 - peer, step - from, state.inputs[1 - peer][step % KEPT]);
  }

  /** Puck and rival’s mallet by each method, [x, y, x, y]. */
  #look(state, peer) {
    const packet = state.known[peer];
    const age = (state.step - packet) * TIME_STEP;
    const asked = this.#asked;
    this.#bodies.forEach((body, i) => {
      const [x, y, vx, vy] = rowOf(state, packet, i);
      asked.setTransform(body, [x, y]);
      asked.setVelocity(body, [vx, vy]);
    });
    const [puck, rival] = [this.#bodies[0], this.#bodies[2 - peer]];
    const both = (place) => [...place(puck), ...place(rival)];
    return [
      both((body) => asked.positionOf(body)),
      both((body) => asked.extrapolate(body, age).position),
      both((body) => asked.predict(body, age).position),
      both((body) => this.#worlds[peer].positionOf(body)),
    ];
  }

  #measure(state) {
    const bin = Math.min(BINS - 1, Math.round(state.delay / BIN));
    const [x, y] = rowOf(state, state.step, 0);
    const slot = state.step % WINDOW;
    METHODS.forEach((_, method) => {
      let [error, jump] = [0, 0];
      for (const peer of [0, 1]) {
        const [seenX, seenY] = state.seen[peer][method];
        const off = [seenX - x, seenY - y];
        const last = state.off[peer]?.[method] ?? off;
        state.off[peer] ??= [];
        state.off[peer][method] = off;
        error += Math.hypot(...off) / 2;
        jump = Math.max(jump, Math.hypot(off[0] - last[0], off[1] - last[1]));
      }
      state.offs[method][slot] = error;
      state.jumps[method][slot] = jump;
      if (state.step > LONGEST) state.sums[method][bin] += error;
    });
    if (state.step > LONGEST) state.counts[bin]++;
  }
}

/** Where a body was after a number of steps: x, y and both velocities. */
export function rowOf({ past }, step, body) {
  const at = (step % KEPT) * ROW + body * NUMBERS;
  return past.subarray(at, at + NUMBERS);
}
