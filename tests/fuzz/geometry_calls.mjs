/** Random calls of "thud/geometry" for calls.mjs: shapes and terrain lines without a world. */
import { geometry } from "../web/support/package.mjs";

const placed = (s) => ({ ...s.solid(), center: s.place() });
const motion = (s) => ({ way: s.vector(), ...(s.below(2) ? {} : { turn: s.number(-4, 4) }) });
const moving = (s) => [placed(s), motion(s), placed(s), motion(s)];
const kind = (s) => s.pick(["circle", "aabb", "obb", "terrain"]);
const points = (s) => Array.from({ length: s.below(7) }, () => s.vector());

const capsule = (s) => (
  { kind: "capsule", from: s.vector(), to: s.vector(), radius: s.number(0.1, 2) }
);
const capsuleOrShape = (s) => (s.below(2) ? capsule(s) : placed(s));
// Random points are hardly ever a polygon; around a circle they are one.
const polygon = (s) =>
  s.below(3) === 0
    ? points(s)
    : Array.from({ length: 3 + s.below(9) }, (_, i) => {
        const length = 12;
        const far = s.number(0.5, 3);
        return [far * Math.cos((6.28 * i) / length), far * Math.sin((6.28 * i) / length)];
      });

export const GEOMETRY_CALLS = {
  approximate: (s) =>
    geometry.approximate(s.engine, polygon(s), {
      shapes: s.below(6),
      ...(s.below(2) ? {} : { kinds: s.pick(["both", "circles", "boxes", "none"]) }),
      ...(s.below(2) ? {} : { distance: s.number(0, 1) }),
    }),
  capsuleOf: (s) => geometry.capsuleOf(s.engine, { ...placed(s), kind: "circle", radius: 1 }, s.vector()),
  capsuleClosest: (s) => geometry.capsuleClosest(s.engine, capsule(s), capsuleOrShape(s)),
  capsuleTimeOfImpact: (s) =>
    geometry.capsuleTimeOfImpact(
      s.engine,
      ...[capsule(s), s.vector(), capsuleOrShape(s), s.vector(), s.number(0, 1)],
    ),
  capsuleClosestOnTerrain: (s) => geometry.capsuleClosestOnTerrain(s.engine, s.line(), capsule(s)),
  capsuleTimeOfImpactOnTerrain: (s) =>
    geometry.capsuleTimeOfImpactOnTerrain(s.engine, s.line(), capsule(s), s.vector(), s.number(0, 1)),
  closest: (s) => geometry.closest(s.engine, placed(s), placed(s)),
  timeOfImpact: (s) => geometry.timeOfImpact(s.engine, ...moving(s), s.number(0, 1)),
  timeOfCollision: (s) => geometry.timeOfCollision(s.engine, ...moving(s), s.number(1e-6, 1)),
  minkowskiCast: (s) => geometry.minkowskiCast(s.engine, ...moving(s)),
  approach: (s) => geometry.approach(s.engine, ...moving(s)),
  contacts: (s) => geometry.contacts(s.engine, placed(s), placed(s), s.number(0, 2)),
  castRay: (s) => geometry.castRay(s.engine, placed(s), s.vector(), s.vector()),
  volumeAroundShape: (s) => geometry.volumeAroundShape(s.engine, kind(s), placed(s)),
  volumeAroundMotion: (s) => geometry.volumeAroundMotion(s.engine, kind(s), placed(s), motion(s)),
  volumeAroundPoints: (s) => geometry.volumeAroundPoints(s.engine, kind(s), points(s)),
  volumeAroundTerrain: (s) =>
    geometry.volumeAroundTerrain(s.engine, kind(s), s.line(), s.number(-20, 0), s.number(-5, 20)),
  mergeVolumes: (s) => geometry.mergeVolumes(s.engine, kind(s), placed(s), placed(s)),
  volumeContains: (s) => geometry.volumeContains(s.engine, placed(s), placed(s)),
  volumeContainsPoint: (s) => geometry.volumeContainsPoint(s.engine, placed(s), s.vector()),
  terrainAt: (s) => geometry.terrainAt(s.engine, s.line(), s.number(-20, 20)),
  textureAt: (s) => geometry.textureAt(s.engine, s.line(), s.number(-20, 20), points(s)),
  terrainAtOften: (s) => geometry.terrainAtOften(s.engine, s.line(), s.number(-20, 0), s.number(-5, 20), s.below(9)),
  frictionAt: (s) => geometry.frictionAt(s.engine, s.line(), s.number(-20, 20), s.texture()),
  footOn: (s) => geometry.footOn(s.engine, s.line(), s.number(-20, 20), s.number(0, 3)),
  segmentsOf: (s) => geometry.segmentsOf(s.engine, s.line(), s.number(-20, 0), s.number(-5, 20)),
  castRayOnTerrain: (s) => geometry.castRayOnTerrain(s.engine, s.line(), s.vector(), s.vector()),
  closestOnTerrain: (s) => geometry.closestOnTerrain(s.engine, s.line(), placed(s)),
  contactsOnTerrain: (s) =>
    geometry.contactsOnTerrain(s.engine, s.line(), placed(s), s.number(0, 2)),
  timeOfImpactOnTerrain: (s) =>
    geometry.timeOfImpactOnTerrain(s.engine, s.line(), placed(s), motion(s), s.number(0, 1)),
  timeOfCollisionOnTerrain: (s) =>
    geometry.timeOfCollisionOnTerrain(s.engine, s.line(), placed(s), motion(s), s.number(1e-6, 1)),
  volumesOverlap: (s) => geometry.volumesOverlap(s.engine, placed(s), placed(s)),
  overlapOften: (s) =>
    geometry.overlapOften(s.engine, placed(s), placed(s), s.below(2) === 0, s.below(9)),
};
