// The computer’s driver: it makes for the nearest car, from the middle outwards, and keeps off the ends.

import { inputOf } from "./cars.js";

const CAREFUL = 1.7; // lengths from the end at which it turns round
const NEAR = 2.6;

export function think(world, arena, cars, state, own) {
  if (state.players[own].out) return 0;
  const placeOf = (car) => world.positionOf(car.hull);
  const [x] = placeOf(cars[own]);
  const speed = world.velocityOf(cars[own].hull).velocity[0];
  const { cosine } = world.rotationOf(cars[own].hull);
  const others = cars.filter((_, i) => i !== own && !state.players[i].out).map(placeOf);
  const end = arena.left(state.fallen);
  const soon = x + 0.35 * speed;
  let way = x > 0 ? -1 : 1;
  if (others.length > 0 && Math.abs(soon) < end - CAREFUL) {
    const away = others.map((place) => place[0] - x);
    const nearest = away.reduce((best, one) => (Math.abs(one) < Math.abs(best) ? one : best));
    way = nearest > 0 ? 1 : -1;
    // It hops now and then when another is near, and each car at its own time.
    const hops = Math.abs(nearest) < NEAR && (state.steps + 53 * own) % 170 === 0;
    if (hops) return inputOf(way < 0, way > 0, true);
  }
  return inputOf(way < 0, way > 0, cosine < 0.3);
}
