/** What runs a game, with or without a window: what its function is given, and a step of it. */
import { Mover } from "thud";

export const NO_KEYS = { left: false, right: false, up: false, down: false, fire: false, restart: false };

/** What a game is given: how it makes its world and its characters. */
export const settingOf = (thud) => ({
  createWorld: (options) => thud.createWorld(options),
  createMover: (world, options) => new Mover(world, options),
});

/** One step of a game, with what its player holds: `held`, keys, and `pointer`, a place in the world. */
export function stepOf(game, step, { held = {}, pointer = null } = {}) {
  game.update({ step, held: { ...NO_KEYS, ...held }, pointer });
  game.world.step();
  game.stepped?.();
}
