/**
 * Makes Box2D's bodies, shapes and chains of thud's. What needs translation:
 *
 * - Box2D's tolerances are lengths in metres, for bodies of about one metre, and this build of it
 *   cannot be told another unit. A world whose typical body has another size is scaled to it, as
 *   Box2D's manual advises; `unit` is a metre in the world's lengths. Times and masses stay.
 * - A body that cannot turn (fixed rotation, or an AABB) is one without inertia.
 * - Terrain is a chain: one-sided, solid to the left of its direction of travel, so its points go
 *   from right to left. A chain's first and last edge do not collide, so that each end gets a ghost
 *   point that continues the last edge.
 * - A body that is to be swept is a bullet, which Box2D stops at moving bodies too, but not at
 *   other bullets: a world that sweeps all has none, or they would pass through each other.
 * - Friction mixes as the square root of the product and restitution as the larger in both engines.
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

/** Half the width of what stands in for endless ground, in metres. */
const FLAT_HALF_WIDTH = 4096;

/** What all of a world's bodies have in common. */
export interface Common extends Placing {
  box2d: Box2D;
  /** Whether contacts are to be told of: it costs Box2D as it costs thud. */
  events: boolean;
}

/** Of a circle or a box. */
export type SolidState = Exclude<ShapeState, { kind: "terrain" }>;

/** As fast as thud lets bodies be, in length scales a second; Box2D's default is 400. */
const MAXIMUM_SPEED = 1e6;

/** Where `options` say nothing, Box2D keeps its defaults but for gravity and the highest speed. */
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

/** A body without its shapes. What a thud world does not tell of a body comes in `options`. */
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

/** A body that is there is given what its making gave it, but for where it is and how it moves. */
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

/** `center` is in the body's frame. */
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

/** A shape that is there is given what its making gave it; whether it is a sensor stays. */
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

/** Calls one of the two, with what is freed afterwards. */
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
    // An AABB has no angle of its own, and its body none either.
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
  // The bindings' own SetMaterials leaves zeros in the definition.
  const material = box2d.b2DefaultSurfaceMaterial();
  setMaterial(material, shape, unit);
  const count = box2d.b2Chain_GetSegmentCount(chain);
  for (const segment of box2d.b2Chain_GetSegments(chain, count) as b2ShapeId[])
    box2d.b2Shape_SetSurfaceMaterial(segment, material);
  for (const handle of [def, material, ...points]) handle.delete();
  return chain;
}

/** From right to left, with the ghost points, in metres. */
function chainPoints(terrain: Terrain, unit: number): Vec2[] {
  const points = vertices(terrain, unit).reverse();
  const last = points.length - 1;
  return [beyond(points[0], points[1]), ...points, beyond(points[last], points[last - 1])];
}

/** As far past `end` as `before` is in front of it. */
function beyond(end: Vec2, before: Vec2): Vec2 {
  return [2 * end[0] - before[0], 2 * end[1] - before[1]];
}

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
