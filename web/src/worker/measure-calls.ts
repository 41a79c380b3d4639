/**
 * Measures, without a world, what a single call costs that finds when a ball hits a wall: bisection
 * to several tolerances, and the swept test. The exact time of the hit is known: the gap divided by
 * the distance that the ball moves in the step.
 */
import type { Engine, Vec2 } from "thud";
import type { PlacedShape } from "thud/geometry";

export interface CallPrice {
  detection: "bisect" | "swept";
  /**
   * How many times bisection halves the interval that contains the hit: at the end its length is
   * 2^-halvings of the step. 0 for swept.
   */
  halvings: number;
  /** Microseconds of a call. */
  time: number;
  /**
   * The mean distance between the place of the ball at the time that was found and the place where
   * it hits, metres.
   */
  error: number;
}

const HALVINGS = [2, 4, 8, 12, 16, 20, 24];
const BALLS = 64;
const RADIUS = 0.1;
/**
 * ROUNDS: number of rounds; the result is the least time of all, since in the first rounds the
 * browser has not yet compiled the code to its fastest form. OFTEN: calls for each ball in a round.
 */
const ROUNDS = 12;
const OFTEN = 60;

const WALL: PlacedShape = { kind: "aabb", center: [1, 0], halfWidth: 1, halfHeight: 1 };
const AT_REST: { way: Vec2 } = { way: [0, 0] };

/**
 * The distance that a ball moves in a step of 1/60 s, and the share of it after which the ball hits
 * the wall.
 */
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
  // All methods are run in each round, so that other load of the device slows all of them alike.
  for (let round = 0; round < ROUNDS; round++)
    for (const price of prices) {
      const start = performance.now();
      for (let i = 0; i < OFTEN; i++) for (const one of balls) find(one, price.halvings);
      price.time = Math.min(price.time, (1000 * (performance.now() - start)) / (OFTEN * BALLS));
    }
  return prices;
}
