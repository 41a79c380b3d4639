/**
 * What one call costs that finds when a ball hits a wall, without a world: bisection to several
 * tolerances, and the swept test. The time of the hit is known: the gap over the way of the step.
 */
import type { Engine, Vec2 } from "thud";
import type { PlacedShape } from "thud/geometry";

export interface CallPrice {
  detection: "bisect" | "swept";
  /**
   * How often the interval with the hit is halved: it ends as 2^-halvings of the step. 0 for swept.
   */
  halvings: number;
  /** Microseconds of a call. */
  time: number;
  /** The mean way between where the ball is found and where it hits, metres. */
  error: number;
}

const HALVINGS = [2, 4, 8, 12, 16, 20, 24];
const BALLS = 64;
const RADIUS = 0.1;
/**
 * Rounds, of which the least time counts, and the calls of a round for each ball. The first rounds
 * run in code that the browser has not yet made fast.
 */
const ROUNDS = 12;
const OFTEN = 60;

const WALL: PlacedShape = { kind: "aabb", center: [1, 0], halfWidth: 1, halfHeight: 1 };
const AT_REST: { way: Vec2 } = { way: [0, 0] };

/** The way of a ball in a step of 1/60 s, and the part of it after which it hits the wall. */
const wayOf = (ball: number) => (3 + 0.11 * ball) / 60;
const partOf = (ball: number) => (0.5 + 0.618 * ball) % 1;

export async function measureCalls(engine: Engine): Promise<CallPrice[]> {
  const { timeOfCollision, timeOfImpact } = await import("thud/geometry");
  const balls = Array.from({ length: BALLS }, (_, i) => {
    const way = wayOf(i);
    const center: Vec2 = [-RADIUS - partOf(i) * way, 0];
    const ball: PlacedShape = { kind: "circle", center, radius: RADIUS };
    const motion: { way: Vec2 } = { way: [way, 0] };
    return { ball, motion, way, part: partOf(i) };
  });
  const find = ({ ball, motion }: (typeof balls)[number], halvings: number) =>
    halvings > 0
      ? timeOfCollision(engine, ball, motion, WALL, AT_REST, 2 ** -halvings).time
      : timeOfImpact(engine, ball, motion, WALL, AT_REST);
  const prices = [...HALVINGS, 0].map((halvings): CallPrice => {
    const away = balls.map((one) => Math.abs((find(one, halvings) ?? 1) - one.part) * one.way);
    const error = away.reduce((sum, one) => sum + one, 0) / BALLS;
    return { detection: halvings > 0 ? "bisect" : "swept", halvings, time: Infinity, error };
  });
  // One after the other in each round, so that what else the device does slows all alike.
  for (let round = 0; round < ROUNDS; round++)
    for (const price of prices) {
      const start = performance.now();
      for (let i = 0; i < OFTEN; i++) for (const one of balls) find(one, price.halvings);
      price.time = Math.min(price.time, (1000 * (performance.now() - start)) / (OFTEN * BALLS));
    }
  return prices;
}
