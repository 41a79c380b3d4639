/**
 * The ranges of arguments that a call takes by position, and the error that names the argument out
 * of range. ranges.ts has the same for options, which have names.
 */
import { ThudError } from "../error.js";
import {
  ANGLE,
  ANY,
  DRAG,
  FLOW,
  MASS_RANGES,
  MATERIAL,
  PLACE,
  POSITIVE,
  type Ranges,
  SIZE,
  VECTOR,
  WAY,
  whyNot,
  WIND_RANGES,
  WORLD_RANGES,
} from "./ranges.js";

const { friction, restitution, surfaceSpeed, density } = MATERIAL;
/** A torque or an angular impulse, and the components of a force or impulse (THUD_FORCE_MAX). */
const PUSH = { least: -1e30, most: 1e30 };
/** A point in a body's frame, length scales (THUD_SIZE_MAX). */
const OFFSET = { least: -16384, most: 16384, pair: true, scaled: true };
/** A force or an impulse, as a vector. */
const PUSHES = { ...PUSH, pair: true };
/** x or y of a place in the world, or a height. */
const COORDINATE = { ...PLACE, pair: false };
/** How far ahead a pose is asked for, s (THUD_AHEAD_MAX). */
const AHEAD = { least: 0, most: 60 };
const COUNT = { ...POSITIVE, least: 1 };
/** The length of a distance joint, length scales (THUD_JOINT_LENGTH_MAX). */
const LENGTH = { least: 0, most: 1e6, above: true, scaled: true };

/**
 * By the name of the module's function: the method of the package that calls it, and the ranges of
 * its arguments in their order. An argument that is a pair takes two numbers of the call.
 */
export const ARGUMENTS: Readonly<Record<string, readonly [method: string, ranges: Ranges]>> = {
  api_world_set_gravity: ["setGravity", { gravity: VECTOR }],
  api_world_set_time_step: ["setTimeStep", { seconds: WORLD_RANGES.timeStep }],
  api_world_set_max_error: ["setMaxError", { maxError: WORLD_RANGES.maxError }],
  api_world_advance: ["advance", { elapsed: { least: 0, most: 1e9 }, maxSteps: COUNT }],
  api_shape_set_friction: ["setFriction", { friction }],
  api_shape_set_restitution: ["setRestitution", { restitution }],
  api_shape_set_surface_speed: ["setSurfaceSpeed", { speed: surfaceSpeed }],
  api_shape_set_density: ["setDensity", { density }],
  api_shape_set_radius: ["setRadius", { radius: SIZE }],
  api_shape_set_half_extents: ["setHalfExtents", { halfWidth: SIZE, halfHeight: SIZE }],
  api_shape_dig: ["dig", { center: PLACE, radius: SIZE }],
  api_shape_raise: ["raise", { x: COORDINATE, radius: SIZE, height: COORDINATE }],
  api_shape_replace_range: ["replaceRange", { x0: ANY, x1: ANY }],
  api_ground_at: ["groundAt", { x: COORDINATE }],
  api_friction_at: ["frictionAt", { x: ANY }],
  api_place_foot: ["placeFoot", { x: COORDINATE, width: POSITIVE }],
  api_shape_cast_ray: ["shapeCastRay", { origin: PLACE, translation: WAY }],
  api_shape_contains_point: ["containsPoint", { point: PLACE }],
  api_body_extrapolate: ["extrapolate", { seconds: AHEAD }],
  api_body_predict: ["predict", { seconds: AHEAD }],
  api_world_extrapolate_awake: ["extrapolateAwake", { seconds: AHEAD }],
  api_shape_closest_point: ["closestPointOf", { point: PLACE }],
  api_body_set_transform: ["setTransform", { position: PLACE, angle: ANGLE }],
  api_body_set_velocity: ["setVelocity", { velocity: VECTOR, angularVelocity: ANY }],
  api_body_set_target: ["setTarget", { position: PLACE, angle: ANGLE }],
  api_body_set_damping: ["setDamping", { linear: POSITIVE, angular: POSITIVE }],
  api_body_set_gravity_scale: ["setGravityScale", { scale: ANY }],
  api_body_set_mass: ["setMass", MASS_RANGES],
  api_body_apply_impulse: ["applyImpulse", { impulse: VECTOR, point: PLACE }],
  api_body_apply_force: ["applyForce", { force: PUSHES, point: PLACE }],
  api_body_apply_center_force: ["applyCenterForce", { force: VECTOR }],
  api_body_apply_torque: ["applyTorque", { torque: ANY }],
  api_body_apply_center_impulse: ["applyCenterImpulse", { impulse: PUSHES }],
  api_body_apply_angular_impulse: ["applyAngularImpulse", { impulse: PUSH }],
  api_body_apply_wind: ["applyWind", { velocity: FLOW, ...WIND_RANGES }],
  api_body_apply_rolling_resistance: ["applyRollingResistance", { coefficient: DRAG }],
  api_body_apply_grip: [
    "applyGrip",
    { point: OFFSET, axis: VECTOR, speed: { ...FLOW, pair: false }, maxForce: { least: 0, most: 1e30 } },
  ],
  api_body_velocity_at: ["velocityAt", { point: PLACE }],
  api_body_world_point: ["worldPoint", { point: PLACE }],
  api_body_local_point: ["localPoint", { point: PLACE }],
  api_body_world_vector: ["worldVector", { vector: VECTOR }],
  api_body_local_vector: ["localVector", { vector: VECTOR }],
  api_joint_set_length: ["setJointLength", { length: LENGTH }],
};

/** The methods to suggest where the point of a force or an impulse is missing. */
const WITHOUT_POINT: Readonly<Record<string, string>> = {
  applyForce: "applyCenterForce or applyTorque",
  applyImpulse: "applyCenterImpulse or applyAngularImpulse",
};

/**
 * The error to throw in place of `error`, which the module's function `name` gave for these numbers
 * (the arguments after the handle): one that names the first argument out of range, or `error`
 * itself where none is found. `scale`: the world's length scale.
 */
export function blameArguments(
  error: ThudError,
  name: string,
  numbers: readonly unknown[],
  scale: number,
): ThudError {
  if (!(name in ARGUMENTS)) return error;
  const [method, ranges] = ARGUMENTS[name];
  const given: Record<string, unknown> = {};
  const needed: Record<string, Ranges[string]> = {};
  let at = 0;
  for (const [argument, range] of Object.entries(ranges)) {
    const value = range.pair ? numbers.slice(at, at + 2) : numbers[at];
    given[argument] = Array.isArray(value) && value.every((one) => one === undefined) ? undefined : value;
    needed[argument] = { ...range, needed: true };
    at += range.pair ? 2 : 1;
  }
  const why = whyNot(given, needed, scale);
  if (why === null) return error;
  const isPointMissing = why.startsWith("point ") && given.point === undefined;
  const hint = isPointMissing && method in WITHOUT_POINT ? `; without a point write ${WITHOUT_POINT[method]}` : "";
  return new ThudError("invalid", `${method}: ${why}${hint}`, { cause: error });
}
