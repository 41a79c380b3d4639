/**
 * What one call costs that finds when a ball hits a wall, without a world: bisection to several
 * tolerances, and the swept test. The time of the hit is known: the gap over the way of the step.
 */
import type { Engine, Vec2 } from "thud";
import type { PlacedShape } from "thud/geometry";

export interface CallPrice {
  detection: "bisect" | "swept";
  /** Of the interval, which ends as 2^-halvings of the step; 0 for swept. */
  halvings: number;
  /** Microseconds of a call. */
  time: number;
  /** The mean way between where the ball is found and where it hits, metres. */
  error: number;
}

const HALVINGS = [2, 4, 8, 12, 16, 20, 24];
const BALLS = 64;
const RADIUS = 0.1;
/** Batches of calls, of which the least time counts, and the calls of a batch for each ball. */
const BATCHES = 5;
const OFTEN = 100;

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
  const price = (halvings: number): CallPrice => {
    const find = ({ ball, motion }: (typeof balls)[number]) =>
      halvings > 0
        ? timeOfCollision(engine, ball, motion, WALL, AT_REST, 2 ** -halvings).time
        : timeOfImpact(engine, ball, motion, WALL, AT_REST);
    let time = Infinity;
    for (let batch = 0; batch < BATCHES; batch++) {
      const start = performance.now();
      for (let i = 0; i < OFTEN; i++) for (const one of balls) find(one);
      time = Math.min(time, (1000 * (performance.now() - start)) / (OFTEN * BALLS));
    }
    const sum = balls.reduce((all, one) => all + Math.abs((find(one) ?? 1) - one.part) * one.way, 0);
    return { detection: halvings > 0 ? "bisect" : "swept", halvings, time, error: sum / BALLS };
  };
  return [...HALVINGS, 0].map(price);
}
