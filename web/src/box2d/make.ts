/**
 * Makes Box2D's bodies, shapes and chains from thud's. The differences:
 *
 * - Box2D's tolerances are lengths in metres, for bodies of about one metre, and this build of it
 *   has no function to change that. So a world is scaled by its length scale, as Box2D's manual
 *   advises: `unit` is the length of a metre in the world's units. Times and masses stay the same.
 * - A body that cannot rotate (fixed rotation, or an AABB) has its rotation locked.
 * - Terrain is a chain. Chains are solid on the left of their direction, so the points go from
 *   right to left. The first and last edge of a chain do not collide, so each end gets one more
 *   point ("ghost"), in the direction of the last edge.
 * - A body whose own detection is "swept" is a bullet. Box2D stops bullets at moving bodies, but
 *   not at other bullets. So a world that sweeps all bodies has no bullets; they would pass through
 *   each other.
 * - Both engines mix friction as the square root of the product, and restitution as the larger
 *   value.
 */
import type { BodyOptions, BodyState, ShapeState, Terrain, Vec2, WorldOptions } from "thud";
import type {
  b2BodyId,
  b2ChainId,
  b2Circle,
  b2Filter,
  b2Polygon,
  b2ShapeDef,
  b2ShapeId,
  b2SurfaceMaterial,
  b2WorldId,
} from "../../node_modules/box2d3-wasm/build/dist/es/deluxe/Box2D.deluxe";
import type { Box2D } from "./load";
import type { Placing } from "./places";

/** Half the width of the chain for flat terrain, which is endless in thud; in metres. Chosen. */
const FLAT_HALF_WIDTH = 4096;

/** What the functions below need of the Box2D world. */
export interface Common extends Placing {
  box2d: Box2D;
  /** Whether Box2D reports contacts, as thud does: it takes time in both engines. */
  events: boolean;
}

/** A circle or a box. */
export type SolidState = Exclude<ShapeState, { kind: "terrain" }>;

/**
 * Default of WorldOptions.maximumSpeed in thud, in length scales per second. Box2D's is 400 m/s.
 */
const MAXIMUM_SPEED = 1e6;

/**
 * Creates a world. Where `options` say nothing, gravity and the largest speed are thud's defaults,
 * and everything else is Box2D's. Throws if Box2D has too many worlds.
 */
export function createWorld(
  { box2d, unit }: Common,
  options: WorldOptions,
  contactHertz?: number,
): b2WorldId {
  const [x, y] = options.gravity ?? [0, -10];
  const def = box2d.b2DefaultWorldDef();
  def.gravity.Set(x / unit, y / unit);
  def.maximumLinearSpeed = options.maximumSpeed ?? MAXIMUM_SPEED;
  def.enableSleep = options.sleeping ?? true;
  def.restitutionThreshold = options.restitutionThreshold ?? def.restitutionThreshold;
  def.hitEventThreshold = options.hitSpeed ?? def.hitEventThreshold;
  def.contactHertz = contactHertz ?? def.contactHertz;
  const world = box2d.b2CreateWorld(def);
  def.delete();
  if (world.index1 === 0) throw new Error("Box2D has no room for another world");
  return world;
}

/**
 * Creates a body without shapes. `options` has the properties that the thud world does not tell.
 */
export function makeBody(
  { box2d, unit, origin }: Common,
  world: b2WorldId,
  state: BodyState,
  options: BodyOptions,
): b2BodyId {
  const def = box2d.b2DefaultBodyDef();
  const { b2_staticBody, b2_kinematicBody, b2_dynamicBody } = box2d.b2BodyType;
  def.type = { static: b2_staticBody, kinematic: b2_kinematicBody, dynamic: b2_dynamicBody }[
    state.kind
  ];
  const [x, y] = state.position;
  def.position.Set((x - origin[0]) / unit, (y - origin[1]) / unit);
  def.rotation.c = Math.cos(state.angle);
  def.rotation.s = Math.sin(state.angle);
  def.gravityScale = state.gravityScale;
  def.linearDamping = options.linearDamping ?? 0;
  def.angularDamping = options.angularDamping ?? 0;
  def.motionLocks.angularZ = state.kind === "dynamic" && state.inertia === 0;
  def.enableSleep = options.maySleep ?? true;
  def.isBullet = options.detection === "swept";
  def.isAwake = state.awake || state.kind !== "dynamic";
  const body = box2d.b2CreateBody(world, def);
  def.delete();
  return body;
}

/** Gives an existing body the same properties as `makeBody`, except pose and velocity. */
export function setBody(
  { box2d }: Common,
  body: b2BodyId,
  state: BodyState,
  options: BodyOptions,
): void {
  const { b2_staticBody, b2_kinematicBody, b2_dynamicBody } = box2d.b2BodyType;
  box2d.b2Body_SetType(
    body,
    { static: b2_staticBody, kinematic: b2_kinematicBody, dynamic: b2_dynamicBody }[state.kind],
  );
  box2d.b2Body_SetGravityScale(body, state.gravityScale);
  box2d.b2Body_SetLinearDamping(body, options.linearDamping ?? 0);
  box2d.b2Body_SetAngularDamping(body, options.angularDamping ?? 0);
  const locks = new box2d.b2MotionLocks();
  locks.linearX = locks.linearY = false;
  locks.angularZ = state.kind === "dynamic" && state.inertia === 0;
  box2d.b2Body_SetMotionLocks(body, locks);
  locks.delete();
  box2d.b2Body_EnableSleep(body, options.maySleep ?? true);
  box2d.b2Body_SetBullet(body, options.detection === "swept");
  if (state.kind === "dynamic") box2d.b2Body_SetAwake(body, true);
}

/** Sets a body's mass. `center` is the centre of mass in the body's frame. */
export function setMass(
  { box2d, unit }: Common,
  body: b2BodyId,
  { mass, inertia, center }: { mass: number; inertia: number; center: Vec2 },
): void {
  const data = new box2d.b2MassData();
  data.mass = mass;
  data.rotationalInertia = inertia / unit ** 2;
  const at = new box2d.b2Vec2(center[0] / unit, center[1] / unit);
  data.center = at;
  box2d.b2Body_SetMassData(body, data);
  at.delete();
  data.delete();
}

/** Gives an existing shape the same properties as `makeShape`, except whether it is a sensor. */
export function setShape(common: Common, made: b2ShapeId, shape: SolidState): void {
  const { box2d, unit } = common;
  const filter = box2d.b2Shape_GetFilter(made);
  setFilter(filter, shape);
  box2d.b2Shape_SetFilter(made, filter);
  filter.delete();
  const material = box2d.b2Shape_GetSurfaceMaterial(made);
  setMaterial(material, shape, unit);
  box2d.b2Shape_SetSurfaceMaterial(made, material);
  material.delete();
  withGeometry(
    common,
    shape,
    (circle) => box2d.b2Shape_SetCircle(made, circle),
    (box) => box2d.b2Shape_SetPolygon(made, box),
  );
  box2d.b2Shape_SetDensity(made, shape.density * unit * unit, true);
}

/** Creates a circle or box. */
export function makeShape(common: Common, body: b2BodyId, shape: SolidState): b2ShapeId {
  const { box2d, unit, events } = common;
  const def: b2ShapeDef = box2d.b2DefaultShapeDef();
  def.density = shape.density * unit * unit;
  def.isSensor = shape.sensor;
  def.enableContactEvents = events;
  def.enableHitEvents = events;
  def.enableSensorEvents = events;
  setMaterial(def.material, shape, unit);
  setFilter(def.filter, shape);
  const made = withGeometry(
    common,
    shape,
    (circle) => box2d.b2CreateCircleShape(body, def, circle),
    (box) => box2d.b2CreatePolygonShape(body, def, box),
  );
  def.delete();
  return made;
}

/** Calls `asCircle` or `asBox` with Box2D's geometry of the shape, and frees that afterwards. */
function withGeometry<T>(
  { box2d, unit }: Common,
  shape: SolidState,
  asCircle: (circle: b2Circle) => T,
  asBox: (box: b2Polygon) => T,
): T {
  const offset = new box2d.b2Vec2(shape.offset[0] / unit, shape.offset[1] / unit);
  let result: T;
  if (shape.kind === "circle") {
    const circle = new box2d.b2Circle();
    circle.center = offset;
    circle.radius = shape.radius / unit;
    result = asCircle(circle);
    circle.delete();
  } else {
    const turn = new box2d.b2Rot();
    // Neither an AABB nor its body is ever rotated.
    const angle = shape.kind === "obb" ? shape.angle : 0;
    turn.c = Math.cos(angle);
    turn.s = Math.sin(angle);
    const [hx, hy] = [shape.halfWidth / unit, shape.halfHeight / unit];
    const box = box2d.b2MakeOffsetBox(hx, hy, offset, turn);
    result = asBox(box);
    box.delete();
    turn.delete();
  }
  offset.delete();
  return result;
}

/** Creates the chain of a terrain. */
export function makeChain(
  { box2d, unit, events }: Common,
  body: b2BodyId,
  shape: ShapeState,
  terrain: Terrain,
): b2ChainId {
  const def = box2d.b2DefaultChainDef();
  const points = chainPoints(terrain, unit).map(([x, y]) => new box2d.b2Vec2(x, y));
  setFilter(def.filter, shape);
  def.enableSensorEvents = events;
  def.SetPoints(points);
  const chain = box2d.b2CreateChain(body, def);
  // SetMaterials of the bindings would write zeros, so the material is set on each segment.
  const material = box2d.b2DefaultSurfaceMaterial();
  setMaterial(material, shape, unit);
  const count = box2d.b2Chain_GetSegmentCount(chain);
  for (const segment of box2d.b2Chain_GetSegments(chain, count) as b2ShapeId[])
    box2d.b2Shape_SetSurfaceMaterial(segment, material);
  for (const handle of [def, material, ...points]) handle.delete();
  return chain;
}

/** The terrain's vertices from right to left, with a ghost point at each end, in metres. */
function chainPoints(terrain: Terrain, unit: number): Vec2[] {
  const points = vertices(terrain, unit).reverse();
  const last = points.length - 1;
  return [beyond(points[0], points[1]), ...points, beyond(points[last], points[last - 1])];
}

/** The point `before`, mirrored at `end`. */
function beyond(end: Vec2, before: Vec2): Vec2 {
  return [2 * end[0] - before[0], 2 * end[1] - before[1]];
}

/** The terrain's vertices from left to right, in metres. */
function vertices(terrain: Terrain, unit: number): Vec2[] {
  switch (terrain.kind) {
    case "flat": {
      const rise = (terrain.slope ?? 0) * FLAT_HALF_WIDTH;
      return [
        [-FLAT_HALF_WIDTH, -rise],
        [FLAT_HALF_WIDTH, rise],
      ];
    }
    case "uniform":
      return Array.from(terrain.heights, (height, i): Vec2 => [
        (terrain.x0 + i * terrain.spacing) / unit,
        height / unit,
      ]);
    case "irregular":
      return Array.from(terrain.points, ([x, y]): Vec2 => [x / unit, y / unit]);
  }
}

function setMaterial(material: b2SurfaceMaterial, shape: ShapeState, unit: number): void {
  material.friction = shape.friction;
  material.restitution = shape.restitution;
  material.tangentSpeed = shape.surfaceSpeed / unit;
}

function setFilter(filter: b2Filter, shape: ShapeState): void {
  filter.categoryBits = shape.category;
  filter.maskBits = shape.mask;
  filter.groupIndex = shape.group;
}
