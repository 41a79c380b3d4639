/**
 * What is done in Box2D when a scene calls a method of its thud world. The lists below say it for
 * each method. A method that is in none of them is not copied to Box2D: the page then names it
 * beside the figures, and the engines are not compared. So a method that is new in thud counts as
 * missing until it is added here.
 */
import { type BodyId, handleOf, type JointId, type ShapeId, type Vec2, type World } from "thud";
import type { Box2DWorld } from "./world";

type Method = keyof World;

/**
 * Methods that are applied to Box2D's body, too. If the body is not copied yet, nothing is done:
 * the copy will be made from the state of the thud body. Only forces, which act in the next step
 * and are no part of that state, are applied to the copy once it is made.
 */
const TO_BODY: { [Name in Method]?: (box2d: Box2DWorld, body: BodyId, ...args: never[]) => void } = {
  setTransform: (box2d, body, position: Vec2, angle?: number) =>
    box2d.setTransform(body, position, angle),
  setVelocity: (box2d, body, velocity: Vec2, angular?: number) =>
    box2d.setVelocity(body, velocity, angular),
  applyImpulse: (box2d, body, impulse: Vec2, point: Vec2) =>
    box2d.applyImpulse(body, impulse, point),
  applyCenterImpulse: (box2d, body, impulse: Vec2) =>
    box2d.applyImpulse(body, impulse, box2d.bodyStateOf(body).center),
  applyAngularImpulse(box2d, body, impulse: number) {
    const { velocity, angularVelocity, inertia } = box2d.bodyStateOf(body);
    if (inertia > 0) box2d.setVelocity(body, velocity, angularVelocity + impulse / inertia);
  },
  applyForce: (box2d, body, force: Vec2, point: Vec2) => box2d.applyForce(body, force, point),
  applyCenterForce: (box2d, body, force: Vec2) => box2d.applyCenterForce(body, force),
  applyTorque: (box2d, body, torque: number) => box2d.applyTorque(body, torque),
  setAwake: (box2d, body, awake: boolean) => box2d.setAwake(body, awake),
  setKind: change,
  setDamping: change,
  setGravityScale: change,
  setFixedRotation: change,
  setLocks: change,
  setDetection: change,
  setMaySleep: change,
  setMass: change,
};

/** Those of TO_BODY whose effect the state of the thud body does not tell. */
const FORCES = new Set<Method>(["applyForce", "applyCenterForce", "applyTorque"]);

/** Gives Box2D's body the properties that the thud body has now. */
function change(box2d: Box2DWorld, body: BodyId): void {
  box2d.changeBody(body);
}

/** Methods after which Box2D's shape is given the properties that the thud shape has now. */
const TO_SHAPE = new Set<Method>([
  "setFilter",
  "setFriction",
  "setRestitution",
  "setSurfaceSpeed",
  "setDensity",
  "setSensor",
  "setRadius",
  "setHalfExtents",
]);

/** Methods after which Box2D's joint is updated before the next step. */
const TO_JOINT = new Set<Method>([
  "setDrive",
  "setJointLength",
  "setJointFrame",
  "setJointBreaking",
  "setJointEnabled",
]);

/** Methods that are applied to Box2D's world, too. */
const TO_WORLD: { [Name in Method]?: (box2d: Box2DWorld, ...args: never[]) => void } = {
  setGravity: (box2d, gravity: Vec2) => box2d.setGravity(gravity),
  setTimeStep: (box2d, seconds: number) => box2d.setTimeStep(seconds),
  setSleeping: (box2d, sleeping: boolean) => box2d.setSleeping(sleeping),
};

/** Methods whose effect Box2DWorld.sync finds before the next step, by comparing both worlds. */
const LOOKED_AT = new Set<Method>([
  "createBody",
  "spawn",
  "createBodies",
  "createCircle",
  "createAabb",
  "createObb",
  "createTerrain",
  "createJoint",
  "destroy",
  "setEnabled",
  "setHeights",
  "dig",
  "raise",
  "replaceRange",
]);

/**
 * Methods that need nothing done in Box2D: queries, events, settings of how thud solves, and
 * setTarget, because the velocities of kinematic bodies are copied before each step.
 */
const HARMLESS = new Set<Method>([
  "setTarget",
  "step",
  "close",
  "snapshot",
  "pack",
  "unpack",
  "hash",
  "whatIf",
  "setQuality",
  "setMaxError",
  "setEvents",
  "setUserData",
  "setJointUserData",
  "useRules",
  "useTextures",
  "useJoints",
  "stats",
  "stepError",
  "measure",
  "stepSettings",
  "bisectionLimit",
  "extrapolate",
  "extrapolateAwake",
  "predict",
  "broadphaseCounts",
  "events",
  "eventViews",
  "impulseEvents",
  "impulseEventView",
  "jointEvents",
  "contactViewOf",
  "contactsOf",
  "eventPairs",
  "pairOf",
  "sensorOverlapsOf",
  "poses",
  "shapeTable",
  "shapeTableAwake",
  "jointTable",
  "draw",
  "isValid",
  "bodyStateOf",
  "shapeStateOf",
  "shapesOf",
  "bodyOf",
  "locksOf",
  "rule",
  "positionOf",
  "rotationOf",
  "velocityOf",
  "motionOf",
  "userDataOf",
  "velocityAt",
  "worldPoint",
  "localPoint",
  "worldVector",
  "localVector",
  "bodies",
  "awakeBodies",
  "movedBodies",
  "shapes",
  "bodyAt",
  "shapeAt",
  "joints",
  "jointsOf",
  "jointStateOf",
  "jointOptionsOf",
  "terrainOf",
  "textureOf",
  "frictionAt",
  "groundAt",
  "placeFoot",
  "castRay",
  "castRayInto",
  "castRayAll",
  "castRayEach",
  "castRays",
  "shapeCastRay",
  "castShape",
  "castShapeAll",
  "castShapeEach",
  "closest",
  "overlap",
  "containsPoint",
  "closestPointOf",
  "boundsOf",
]);

/**
 * Names of methods that Box2D does not get, for the page. A method without one is named as it is.
 */
const WORDS: { [Name in Method]?: string } = {
  applyBuoyancy: "water",
  applyWind: "wind",
  explode: "explosions with cover",
  applyGrip: "tyres",
  applyTyre: "tyres",
  applyRollingResistance: "rolling resistance",
  setRule: "rules between kinds",
  setTexture: "the texture of the ground",
  setPairFilter: "the scene’s own filter of pairs",
  setListeners: "listeners of contacts",
  setBodyEpilogue: "listeners of contacts",
  setCategoryEpilogue: "listeners of contacts",
  decide: "velocities that a prologue decides",
};

/** Whether Box2DWorld.sync need not compare both worlds after a call of this method. */
function leavesAll(method: Method): boolean {
  return method in TO_BODY || method in TO_WORLD || HARMLESS.has(method);
}

/** The methods that were called and that Box2D does not get, in a word or two each. */
export function missesOf(called: ReadonlySet<string>): string[] {
  const got = [TO_SHAPE, TO_JOINT, LOOKED_AT];
  const words = ([...called] as Method[])
    .filter((method) => !leavesAll(method) && !got.some((list) => list.has(method)))
    .map((method) => WORDS[method] ?? `what ${String(method)} does`);
  return [...new Set(words)];
}

/** Does in Box2D what was done to the world by one call. */
export function follow(
  box2d: Box2DWorld,
  method: string,
  result: unknown,
  args: readonly unknown[],
): void {
  const [first, ...rest] = args as never[];
  const name = method as Method;
  if (!leavesAll(name)) box2d.lookAgain();
  if (name in TO_BODY) {
    const body = idOf(first, "body") as BodyId;
    const apply = () => box2d.isValid(body) && TO_BODY[name]!(box2d, body, ...rest);
    if (box2d.isValid(body)) apply();
    else if (FORCES.has(name)) box2d.afterCopy(apply);
  } else if (name in TO_WORLD) {
    TO_WORLD[name]!(box2d, first, ...rest);
  } else if (TO_SHAPE.has(name)) {
    box2d.changeShape(idOf(first, "shape") as ShapeId);
  } else if (TO_JOINT.has(name)) {
    box2d.touchJoint(idOf(first, "joint") as JointId);
  } else if (name === "createJoint") {
    box2d.touchJoint(result as JointId);
  } else if (name === "destroy") {
    const id = idOf(first, rest[0]);
    if (id.kind === "joint") box2d.touchJoint(id);
  }
}

/** A handle, also where the caller passed it as a number. */
function idOf(ref: unknown, kind: "body" | "shape" | "joint"): BodyId | ShapeId | JointId {
  return typeof ref === "number" ? handleOf(ref, kind) : (ref as BodyId | ShapeId | JointId);
}
