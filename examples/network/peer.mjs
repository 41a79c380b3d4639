/**
 * One player's machine: a world with the game of cars.mjs, a rollback, and what players tell each
 * other, by RollbackPeers of the package. It is that of peer.c, with the same bytes. What carries the
 * messages is not known here.
 */
import { Rollback, RollbackPeers } from "thud";
import { bodiesOf, buildCars, carsStep, createField, IDLE, INPUTS, newState, stateBytes } from "./cars.mjs";

/** A world with the game, and its rollback. */
function open(thud, players, depth, options) {
  const world = createField(thud, options);
  const state = newState(buildCars(world, players));
  const idle = Array(players).fill(IDLE);
  return { world, rollback: new Rollback(world, { idle, step: carsStep(world), depth, state, stateBytes }) };
}

export class Peer {
  /** How often no step could be run. */
  waits = 0;

  /**
   * `me`: the own number, from 0; `depth`: as in RollbackOptions; `end`: the steps of the game, 0: no
   * end; `mesh`: as in RollbackPeersOptions; `world`: options of createWorld; `reader`: a WelcomeReader,
   * in place of all but `world`, to join the game that it has read.
   */
  constructor(thud, { me, players, depth, end = 0, mesh = false, world = {}, reader = null }) {
    const about = reader ? { ...reader.welcome, me: reader.welcome.own } : { me, players, depth, end };
    Object.assign(this, { me: about.me, players: about.players, end: about.end });
    Object.assign(this, open(thud, about.players, about.depth, world));
    const options = { rollback: this.rollback, inputs: INPUTS };
    this.net = reader
      ? RollbackPeers.join(reader, options)
      : new RollbackPeers({ ...options, own: me, players, depth, end, mesh });
    this.bodies = bodiesOf(this.rollback.state, this.players);
    if (mesh) for (let other = 0; other < players; other++) if (other !== me) this.net.connect(other);
  }

  close() {
    this.world.close();
  }

  get steps() {
    return this.rollback.steps;
  }

  /** Runs the next step, and those that others have run before it joined. */
  advance() {
    if (!this.net.advance() && !this.net.hasEnded) this.waits++;
    while (this.net.isBehind && this.net.advance());
  }

  /** The hash after the last step that is confirmed. */
  get hash() {
    return this.rollback.hashAt(this.rollback.confirmed);
  }
}
