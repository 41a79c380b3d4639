// The bridge as bodies: a beam is a box, and joints at its ends tie it to nodes, small bodies where
// beams meet, or to the walls of the gorge. A joint that pulls harder than it bears breaks.

import { placeOf, ROAD_HALF } from "./levels.js";
import { isRoad, isSame, lengthOf } from "./plan.js";

export const STRENGTH = 310; // newtons, of a joint
const STIFFNESS = 40; // hertz, of a beam along itself
export const STRUT_HALF = 0.11;
export const NODE_RADIUS = 0.16;

// What meets what: struts are behind the road, and vehicles pass them.
const GROUND = 1;
const ROAD = 2;
export const VEHICLE = 4;
const STRUT = 8;

/** Plain data, for the game's state: bodies, joints, and how hard each beam is strained. */
export function raise(world, anchor, level, plan) {
  const nodes = [];
  const bodyAt = (place) => {
    if (level.anchors.some((other) => isSame(other, place))) return anchor;
    const found = nodes.find((node) => isSame(node.place, place));
    if (found) return found.body;
    const body = world.createBody({ kind: "dynamic", position: placeOf(level, place) });
    const filter = { category: STRUT, mask: GROUND };
    world.createCircle(body, { radius: NODE_RADIUS, density: 3, ...filter });
    nodes.push({ place, body });
    return body;
  };
  const beams = plan.map((beam) => {
    const body = buildBeam(world, level, beam);
    const ends = [beam.from, beam.to].map((place) => [placeOf(level, place), bodyAt(place)]);
    if (ends[1][1] === anchor) ends.reverse();
    const joints = [hinge(world, body, ...ends[0]), spring(world, body, ...ends[1], anchor)];
    const halfLength = lengthOf(beam) / 2;
    return { body, joints, halfLength, road: isRoad(beam), strain: 0, broken: false };
  });
  return { beams, nodes: nodes.map(({ body }) => body) };
}

function hinge(world, beam, at, node) {
  return world.createJoint({ kind: "hinge", bodyA: node, bodyB: beam, at, breakForce: STRENGTH });
}

/**
 * A hinge that gives way a little along the beam, as steel does: among beams that cannot give way
 * at all, more of them than it takes, nothing would say which one bears how much.
 */
function spring(world, beam, at, node, anchor) {
  if (node === anchor) return hinge(world, beam, at, node); // from wall to wall
  const { angle } = world.bodyStateOf(beam);
  const along = { frequency: STIFFNESS, damping: 1 };
  const ends = { bodyA: beam, bodyB: node, at, angle };
  return world.createJoint({ kind: "wheel", ...ends, along, breakForce: STRENGTH });
}

function buildBeam(world, level, beam) {
  const [x0, y0] = placeOf(level, beam.from);
  const [x1, y1] = placeOf(level, beam.to);
  const position = [(x0 + x1) / 2, (y0 + y1) / 2];
  const angle = Math.atan2(y1 - y0, x1 - x0);
  const body = world.createBody({ kind: "dynamic", position, angle });
  const road = isRoad(beam);
  world.createObb(body, {
    halfWidth: lengthOf(beam) / 2,
    halfHeight: road ? ROAD_HALF : STRUT_HALF,
    density: road ? 1 : 0.6,
    friction: 0.9,
    category: road ? ROAD : STRUT,
    mask: road ? GROUND | VEHICLE : GROUND,
  });
  return body;
}

/** Reads what the last step did to every beam; gives those of which a joint is gone. */
export function feel(world, { beams }) {
  return beams.filter((beam) => {
    const before = beam.broken;
    const whole = beam.joints.filter((joint) => world.isValid(joint));
    const forces = whole.map((joint) => Math.hypot(...world.jointStateOf(joint).force));
    beam.broken = whole.length < beam.joints.length;
    beam.strain = beam.broken ? 1 : Math.max(...forces) / STRENGTH;
    return beam.broken && !before;
  });
}

/** Joints go with the bodies. */
export function takeDown(world, { beams, nodes }) {
  for (const body of [...beams.map((beam) => beam.body), ...nodes]) world.destroy(body);
}
