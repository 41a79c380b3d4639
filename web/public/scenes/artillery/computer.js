// The computer's aim. It solves the flight exactly, with the wind that the player sees too, and
// then errs: less with each of its shots.

import { isClear, solveSpeed } from "./flight.js";
import { barrel } from "./tanks.js";

const FIRST_ERROR = 0.14; // of the speed; in radians nearly as much of the angle
const LAST_ERROR = 0.015;
const LEARNS = 0.72; // what of the error is left after a shot

/** Where to put the barrel, in degrees, and the speed of the shell. */
export function chooseAim(world, tank, target, wind, shots, chance) {
  const aim = solveAim(world, tank, target, wind);
  const error = Math.max(LAST_ERROR, FIRST_ERROR * LEARNS ** shots);
  return {
    angle: aim.angle + 40 * error * chance(-1, 1),
    speed: aim.speed * (1 + error * chance(-1, 1)),
  };
}

/**
 * Of the shots that meet the target with nothing in the way the slowest: there an error of the
 * angle costs least. If all are blocked, the steepest.
 */
function solveAim(world, tank, target, wind) {
  const aimed = world.bodyStateOf(target.body).position;
  const away = aimed[0] < world.bodyStateOf(tank.body).position[0];
  let best = { angle: away ? 120 : 60, speed: 20, rank: -Infinity };
  for (let elevation = 30; elevation <= 84; elevation += 2) {
    const angle = away ? 180 - elevation : elevation;
    const { muzzle, direction } = barrel(world, tank, angle);
    const shot = solveSpeed(muzzle, direction, aimed, wind);
    if (!shot) continue;
    const velocity = [shot.speed * direction[0], shot.speed * direction[1]];
    const free = isClear(world, muzzle, velocity, wind, shot.time);
    const rank = free ? -shot.speed : elevation - 1000; // blocked ones come after all free ones
    if (rank > best.rank) best = { angle, speed: shot.speed, rank };
  }
  return best;
}
