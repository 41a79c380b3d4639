// How a player aims and fires: by keys, or by drawing back like a slingshot.

const LEAST_SPEED = 5;
export const MOST_SPEED = 28; // metres a second; power is a percentage of it
const FULL_PULL = 12; // metres to draw back for full power
const LEAST_PULL = 1; // less is no shot: a way out for who has changed their mind
const RUN_UP = 18; // steps after which a held key turns from single steps to motion

const KEYS = ["left", "right", "up", "down", "fire"];
/** Over a network an input is the sum of a bit for each key that is held. */
export const INPUTS = 2 ** KEYS.length;
export const inputOf = (held) => KEYS.reduce((sum, key, i) => sum + (held[key] ? 2 ** i : 0), 0);
export const heldOf = (input) => Object.fromEntries(KEYS.map((key, i) => [key, (input & (2 ** i)) !== 0]));

/** Changes the tank's aim; true if it fires. `game.holds` and `game.pull` keep what goes on. */
export function control(game, tank, input, pressed, tapped) {
  const turn = repeat(game, "left", input) - repeat(game, "right", input);
  const power = repeat(game, "up", input) - repeat(game, "down", input);
  setAim(tank, tank.angle + turn, tank.speed + (power * MOST_SPEED) / 100);
  return draw(game, tank, input.pointer, tapped) || pressed("fire");
}

export function setAim(tank, angle, speed) {
  tank.angle = Math.min(180, Math.max(0, angle));
  tank.speed = Math.min(MOST_SPEED, Math.max(LEAST_SPEED, speed));
}

/** 1 in steps in which a held key counts: the first, and after a while every other. */
function repeat(game, key, { held }) {
  game.holds[key] = held[key] ? game.holds[key] + 1 : 0;
  const steps = game.holds[key];
  return steps === 1 || (steps > RUN_UP && steps % 2 === 0) ? 1 : 0;
}

/** The pointer may go down anywhere: on a phone there is little room behind a tank. */
function draw(game, tank, pointer, tapped) {
  if (tapped) game.pull = { from: [pointer.x, pointer.y], by: [0, 0] };
  if (game.pull === null) return false;
  if (pointer?.down) {
    const { from } = game.pull;
    const by = [from[0] - pointer.x, from[1] - pointer.y];
    game.pull.by = by;
    const length = Math.hypot(...by);
    if (length < LEAST_PULL) return false;
    const degrees = (Math.atan2(by[1], by[0]) * 180) / Math.PI;
    // Below the horizon it aims level, to the side that the pull points to.
    const angle = degrees >= 0 ? degrees : degrees > -90 ? 0 : 180;
    setAim(tank, angle, Math.min(1, length / FULL_PULL) * MOST_SPEED);
    return false;
  }
  const fires = Math.hypot(...game.pull.by) >= LEAST_PULL;
  game.pull = null;
  return fires;
}
