/** Random calls of "thud/geometry" for calls.mjs: functions of two shapes without a world. */
import { geometry } from "../web/support/package.mjs";

const placed = (s) => ({ ...s.solid(), center: s.place() });
const motion = (s) => ({ way: s.vector(), ...(s.below(2) ? {} : { turn: s.number(-4, 4) }) });
const moving = (s) => [placed(s), motion(s), placed(s), motion(s)];

export const GEOMETRY_CALLS = {
  closest: (s) => geometry.closest(s.engine, placed(s), placed(s)),
  timeOfImpact: (s) => geometry.timeOfImpact(s.engine, ...moving(s), s.number(0, 1)),
  timeOfCollision: (s) => geometry.timeOfCollision(s.engine, ...moving(s), s.number(1e-6, 1)),
  minkowskiCast: (s) => geometry.minkowskiCast(s.engine, ...moving(s)),
  approach: (s) => geometry.approach(s.engine, ...moving(s)),
  volumeAroundShape: (s) =>
    geometry.volumeAroundShape(s.engine, s.pick(["circle", "aabb", "obb", "terrain"]), placed(s)),
  volumesOverlap: (s) => geometry.volumesOverlap(s.engine, placed(s), placed(s)),
  overlapOften: (s) =>
    geometry.overlapOften(s.engine, placed(s), placed(s), s.below(2) === 0, s.below(9)),
};
