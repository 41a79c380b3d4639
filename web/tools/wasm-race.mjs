/**
 * Measures the step times of the same scene in thud and in Box2D v3 as WebAssembly, in Node.js or
 * in a page. Both step in alternating turns, so that changes of the machine's speed affect both
 * alike.
 *
 * thud's module builds the scene, from which bodies and shapes are read through the package's
 * public API and created in Box2D. Scenes with terrain are left out: Box2D's chains are one-sided
 * and end in ghost points, which is another ground.
 */

/**
 * The scenes, their sizes, and the steps before and during the measurement; the same as in
 * tests/bench/plan.c.
 */
export const PLANS = [
  { scene: "pyramid", size: 100, warmUp: 10, steps: 200 },
  { scene: "circle_pit", size: 10000, warmUp: 30, steps: 300 },
  { scene: "smash", size: 9600, warmUp: 1, steps: 200 },
  { scene: "tumbler", size: 2000, warmUp: 120, steps: 300 },
  { scene: "tumbler_half", size: 2000, warmUp: 120, steps: 300 },
  { scene: "platformer", size: 2000, warmUp: 30, steps: 300 },
  { scene: "gas", size: 1000, warmUp: 10, steps: 200 },
  { scene: "gas", size: 4000, warmUp: 10, steps: 200 },
  { scene: "gas", size: 16000, warmUp: 10, steps: 100 },
  { scene: "sizes", size: 4000, warmUp: 10, steps: 300 },
  { scene: "one_spot", size: 4000, warmUp: 1, steps: 200 },
];

/** Steps of a turn. Chosen. */
const TURN = 8;

/** The number of a built-in scene. Throws for an unknown name. */
function sceneIndex(engine, name) {
  for (let i = 0; i < engine.exports.api_scene_count(); i++) {
    if (engine.text(engine.exports.api_scene_name(i)) === name) return i;
  }
  throw new Error(`there is no scene '${name}'`);
}

/** A world of thud with the scene of a plan, without sleeping. */
function buildThud(thud, engine, plan) {
  const index = sceneIndex(engine, plan.scene);
  thud.World.writeOptions(engine, { sleeping: false });
  engine.check(engine.exports.api_scene_create(index, plan.size));
  return new thud.World(engine, {}, engine.slots[0]);
}

/** The handles of the bodies with shapes, in the order of their slots. */
function bodiesOf(world) {
  const { count, rows, handles } = world.shapeTable();
  const found = new Map();
  for (let i = 0; i < count; i++) {
    const index = rows[10 * i];
    found.set(index, { kind: "body", index, generation: handles[4 * i + 3] });
  }
  return [...found.values()].sort((a, b) => a.index - b.index);
}

const BOX2D_TYPES = {
  static: "b2_staticBody",
  kinematic: "b2_kinematicBody",
  dynamic: "b2_dynamicBody",
};

/** Creates a shape of thud in a Box2D body. */
function addShape(b2, world, body, shape) {
  const def = b2.b2DefaultShapeDef();
  def.density = shape.density;
  def.material.friction = shape.friction;
  def.material.restitution = shape.restitution;
  const offset = new b2.b2Vec2(...shape.offset);
  if (shape.kind === "circle") {
    const circle = new b2.b2Circle();
    circle.center = offset;
    circle.radius = shape.radius;
    b2.b2CreateCircleShape(body, def, circle);
    circle.delete();
  } else {
    const polygon = b2.b2MakeOffsetBox(
      shape.halfWidth,
      shape.halfHeight,
      offset,
      b2.b2MakeRot(shape.angle ?? 0),
    );
    b2.b2CreatePolygonShape(body, def, polygon);
  }
  def.delete();
}

/** A Box2D world with the bodies and shapes of a thud world, and their number. */
function buildBox2d(b2, thudWorld, gravity) {
  const def = b2.b2DefaultWorldDef();
  def.gravity.Set(...gravity);
  def.enableSleep = false;
  const world = b2.b2CreateWorld(def);
  def.delete();
  let bodies = 0;
  for (const id of bodiesOf(thudWorld)) {
    const state = thudWorld.bodyStateOf(id);
    const shapes = thudWorld.shapesOf(id).map((shape) => thudWorld.shapeStateOf(shape));
    const bodyDef = b2.b2DefaultBodyDef();
    bodyDef.type = b2.b2BodyType[BOX2D_TYPES[state.kind]];
    bodyDef.position.Set(...state.position);
    bodyDef.rotation = b2.b2MakeRot(state.angle);
    bodyDef.linearVelocity.Set(...state.velocity);
    bodyDef.angularVelocity = state.angularVelocity;
    bodyDef.gravityScale = state.gravityScale;
    if (state.kind === "dynamic" && state.inertia === 0) bodyDef.motionLocks.angularZ = true;
    const body = b2.b2CreateBody(world, bodyDef);
    bodyDef.delete();
    for (const shape of shapes) addShape(b2, world, body, shape);
    bodies++;
  }
  return { world, bodies };
}

/** The gravity of scenes whose gravity is not [0, -10]. */
const GRAVITY = { gas: [0, 0], smash: [0, 0] };

/** Median, 99th percentile and maximum of times. */
function summary(times) {
  const sorted = Float64Array.from(times).sort();
  const at = (share) => sorted[Math.min(sorted.length - 1, Math.ceil(share * sorted.length) - 1)];
  return { median: at(0.5), p99: at(0.99), max: sorted[sorted.length - 1] };
}

/**
 * Measures one plan. Returns median, 99th percentile and maximum of the step times of both, ms.
 * `progress` is called after each turn with the share that is done.
 */
export function race(thud, engine, b2, plan, progress = () => {}) {
  const own = buildThud(thud, engine, plan);
  const rival = buildBox2d(b2, own, GRAVITY[plan.scene] ?? [0, -10]);
  const step = {
    thud: () => own.step(),
    box2d: () => b2.b2World_Step(rival.world, 1 / 60, 4),
  };
  const names = ["thud", "box2d"];
  const times = { thud: [], box2d: [] };
  for (const name of names) for (let i = 0; i < plan.warmUp; i++) step[name]();
  for (let first = 0, turn = 0; first < plan.steps; first += TURN, turn++) {
    for (const k of [turn % 2, 1 - (turn % 2)]) {
      for (let i = first; i < Math.min(first + TURN, plan.steps); i++) {
        const start = performance.now();
        step[names[k]]();
        times[names[k]].push(performance.now() - start);
      }
    }
    progress(Math.min(1, (first + TURN) / plan.steps));
  }
  const stats = own.stats();
  own.close();
  b2.b2DestroyWorld(rival.world);
  return {
    scene: plan.scene,
    size: plan.size,
    bodies: stats.bodies,
    box2d_bodies: rival.bodies,
    thud: summary(times.thud),
    box2d: summary(times.box2d),
  };
}
