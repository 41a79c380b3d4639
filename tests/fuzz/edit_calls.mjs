/**
 * Random calls for calls.mjs that change bodies and shapes, apply forces, and read bodies and
 * shapes. */
import { thud } from "../web/support/package.mjs";

const WORDS = ["static", "kinematic", "dynamic", "dynamic", "none"];
const DETECTIONS = [null, "overlap", "continuous", "bisect", "swept", "none"];

export const EDIT_CALLS = {
  setFilter: (s) =>
    s.world.setFilter(s.shape(), s.options(s.pick([{}, { mask: s.below(9) }, { group: s.below(5) - 2 }]))),
  setFriction: (s) => s.world.setFriction(s.shape(), s.number(0, 2)),
  setRestitution: (s) => s.world.setRestitution(s.shape(), s.number(0, 1)),
  setSurfaceSpeed: (s) => s.world.setSurfaceSpeed(s.shape(), s.number(-3, 3)),
  setDensity: (s) => s.world.setDensity(s.shape(), s.number(0, 4)),
  setSensor: (s) => s.world.setSensor(s.shape(), s.below(3) === 0),
  setEvents: (s) => s.world.setEvents(s.shape(), s.below(3) > 0),
  setRadius: (s) => s.world.setRadius(s.shape(), s.number(0.1, 1)),
  setHalfExtents: (s) => s.world.setHalfExtents(s.shape(), s.number(0.1, 1), s.number(0.1, 1)),
  setUserData: (s) => s.world.setUserData(s.pick([s.body(), s.shape()]), s.number(0, 9)),
  setKind: (s) => s.world.setKind(s.body(), s.pick(WORDS)),
  setDamping: (s) => s.world.setDamping(s.body(), s.number(0, 3), s.number(0, 3)),
  setGravityScale: (s) => s.world.setGravityScale(s.body(), s.number(-1, 2)),
  setFixedRotation: (s) => s.world.setFixedRotation(s.body(), s.below(2) === 0),
  setLocks: (s) => s.world.setLocks(s.body(), s.options({ x: s.below(2) === 0, y: s.below(2) === 0 })),
  locksOf: (s) => s.world.locksOf(s.body()),
  setDetection: (s) => s.world.setDetection(s.body(), s.pick(DETECTIONS)),
  setMaySleep: (s) => s.world.setMaySleep(s.body(), s.below(2) === 0),
  setMass: (s) => {
    const center = [s.number(-1, 1), s.number(-1, 1)];
    const mass = { mass: s.number(0.1, 9), inertia: s.number(0, 9), center };
    s.world.setMass(s.body(), s.below(4) === 0 ? null : s.options(mass));
  },
  applyForce: (s) => s.world.applyForce(s.body(), s.vector(), s.place()),
  applyCenterImpulse: (s) => s.world.applyCenterImpulse(s.body(), s.vector()),
  applyAngularImpulse: (s) => s.world.applyAngularImpulse(s.body(), s.number(-9, 9)),
  setTarget: (s) => s.world.setTarget(s.body(), s.place(), s.number(-4, 4)),
  explode: (s) =>
    s.world.explode(
      s.options({
        center: s.place(),
        radius: s.number(0, 4),
        falloff: s.number(0, 4),
        impulse: s.number(-9, 9),
        cover: s.pick(["none", "static", "all"]),
        rays: 1 + s.below(8),
        filter: s.filter(),
      }),
    ),
  applyWind: (s) => s.world.applyWind(s.body(), s.vector(), { drag: s.number(0, 2), lift: s.number(0, 2) }),
  applyBuoyancy: (s) => s.world.applyBuoyancy(s.body(), { point: s.place(), density: s.number(0, 3) }),
  applyRollingResistance: (s) => s.world.applyRollingResistance(s.body(), s.number(0, 1)),
  applyGrip: (s) => 
    s.world.applyGrip(s.body(), s.place(), s.vector(), s.number(-3, 3), s.number(0, 99)),
  applyTyre: (s) => {
    const forces = { thrust: s.number(-40, 40), brake: s.number(0, 9), grip: s.number(0, 60) };
    const tyre = { at: [s.number(-2, 2), s.number(-1, 1)], steer: s.number(-1, 1), ...forces };
    return s.world.applyTyre(s.body(), s.options(tyre));
  },
  setRule: (s) => {
    const kind = s.pick(["collide", "ignore", "oneWay", "oneWay", "none"]);
    const rule = { kind, solidSide: s.vector(), friction: s.number(0, 2), eventImpulse: s.number(0, 2) };
    s.world.setRule(s.below(9), 1 + s.below(9), s.below(4) === 0 ? null : s.options(rule));
  },
  rule: (s) => s.world.rule(1 << s.below(4), 1 << s.below(4)),
  useRules: (s) => s.world.useRules(),
  useTextures: (s) => s.world.useTextures(),
  impulseEvents: (s) => s.world.impulseEvents(),
  impulseEventView: (s) => s.world.impulseEventView(),
  setListeners: (s) => {
    s.after = null; // listeners and the pair filter are not part of a snapshot
    const veto = s.number(0, 3), friction = s.number(0, 2);
    const prologue = (rows, count) => {
      for (let i = 0; i < count; i += 2) [rows[20 * i + 16], rows[20 * i + 17]] = [veto, friction];
    };
    s.after = null; // listeners and the pair filter are not part of a snapshot
    const without = [[], ["point"], ["bodies"]][s.below(3)];
    s.world.setListeners(s.below(3) === 0 ? null : { prologue, epilogue() {}, without });
  },
  decide: (s) => {
    const side = () => s.options({ velocity: s.vector(), angularVelocity: s.number(-9, 9) });
    s.after = null;
    const [row, response] = [s.number(-1, 3), s.pick([{ a: side() }, { b: side() }, { a: side(), b: side() }])];
    // Outside of a prologue it is refused.
    if (s.below(4) === 0) s.world.decide(row, response);
    s.world.setListeners({ prologue: (rows, count) => count > 0 && s.world.decide(s.below(count), response) });
  },
  setBodyEpilogue: (s) => {
    s.after = null;
    s.world.setBodyEpilogue(s.body(), s.below(3) === 0 ? null : (row, side) => row[side]);
  },
  setCategoryEpilogue: (s) => {
    s.after = null;
    s.world.setCategoryEpilogue(s.below(5), s.below(3) === 0 ? null : (row, side) => row[side]);
  },
  setPairFilter: (s) => {
    s.after = null;
    const kept = s.below(5);
    s.after = null;
    s.world.setPairFilter(s.below(3) === 0 ? null : (a, b) => (a.index + b.index) % 5 !== kept);
  },
  velocityAt: (s) => s.world.velocityAt(s.body(), s.place()),
  worldPoint: (s) => s.world.worldPoint(s.body(), s.vector()),
  localPoint: (s) => s.world.localPoint(s.body(), s.place()),
  worldVector: (s) => s.world.worldVector(s.body(), s.vector()),
  localVector: (s) => s.world.localVector(s.body(), s.vector()),
  spawn: (s) => {
    const number = s.world.spawn(s.options({ kind: s.pick(["static", "dynamic"]), position: s.place() }));
    s.world.destroy(number, "body");
  },
  castRayInto: (s) => s.world.castRayInto(s.place(), s.vector(), s.pick([null, s.filter()]), []),
  motionOf: (s) => {
    s.world.motionOf(s.body(), []);
  },
  positionOf: (s) => s.world.positionOf(s.body()),
  rotationOf: (s) => s.world.rotationOf(s.body()),
  velocityOf: (s) => s.world.velocityOf(s.body()),
  userDataOf: (s) => s.world.userDataOf(s.pick([s.body(), s.shape()])),
  bodyOf: (s) => s.world.bodyOf(s.shape()),
  stepSettings: (s) => s.world.stepSettings(),
  bodies: (s) => s.world.bodies(),
  awakeBodies: (s) => s.world.awakeBodies(),
  shapes: (s) => s.world.shapes(),
  movedBodies: (s) => s.world.movedBodies(),
  bodyAt: (s) => s.world.bodyAt(s.number(-2, 50)),
  shapeAt: (s) => s.world.shapeAt(s.number(-2, 50)),
  sensorOverlapsOf: (s) => s.world.sensorOverlapsOf(s.shape()),
  castRays: (s) => s.world.castRays([...s.place(), ...s.vector(), ...s.place(), ...s.vector()], s.filter()),
  castRayEach: (s) => {
    const [first, second, told] = [s.number(-1, 1), s.number(-1, 1), []];
    s.world.castRayEach(s.place(), s.vector(), (hit) => told.push(hit) % 2 ? first : second, s.filter());
    return told;
  },
  castShapeEach: (s) => {
    const shape = s.solid(), told = [];
    s.world.castShapeEach(s.solid(), s.place(), s.vector(), (hit) => {
      told.push(hit, s.world.castShape(shape, hit.point, [1, 1]));
      if (s.below(40) === 0) s.world.step();
      if (s.below(4) === 0) s.world.setFriction(hit.shape, 0.5);
      return told.length < 9 ? undefined : 0;
    }, s.filter());
    return told;
  },
  shapeCastRay: (s) => s.world.shapeCastRay(s.shape(), s.place(), s.vector()),
  extrapolate: (s) => s.world.extrapolate(s.body(), s.number()),
  predict: (s) => s.world.predict(s.body(), s.number()),
  extrapolateAwake: (s) => s.world.extrapolateAwake(s.number()),
  containsPoint: (s) => s.world.containsPoint(s.shape(), s.place()),
  closestPointOf: (s) => s.world.closestPointOf(s.shape(), s.place()),
  boundsOf: (s) => s.world.boundsOf(s.shape()),
  eventViews: (s) => {
    s.world.eventViews();
  },
  contactViewOf: (s) => {
    s.world.contactViewOf(s.body());
  },
  eventPairs: (s) => [...s.world.eventPairs(s.below(16), s.pick([3, 9, s.number(0, 9)]))],
  whatIf: (s) => {
    const hash = s.world.hash();
    const there = s.world.whatIf(() => {
      s.world.step();
      return s.world.bodies();
    });
    if (s.world.hash() !== hash) throw new Error("what might be has changed what is");
    return there;
  },
  Rollback: (s) => {
    const body = s.body();
    const play = ([push]) => {
      s.world.applyCenterForce(body, [push, 0]);
      s.world.step();
    };
    const given = { idle: [0], step: play, depth: 1 + s.below(9) };
    const rollback = new thud.Rollback(s.world, s.options(given));
    for (let i = 0; i < 12; i++) {
      if (s.below(2)) rollback.input(s.below(8) === 0 ? 1 : 0, s.below(12), s.below(3));
      rollback.advance();
    }
    const counts = [rollback.steps, rollback.confirmed, rollback.replayed, rollback.settle()];
    const { step, isDetailed } = rollback.compare(rollback.report(rollback.confirmed));
    if (step !== -1 || isDetailed) throw new Error("a rollback differs from itself");
    rollback.leave(0, rollback.steps + 1);
    rollback.hearLead(0, s.below(9));
    rollback.restore(rollback.snapshot());
    rollback.enter(0, rollback.steps + 2);
    return [...counts, rollback.steps, rollback.settled, rollback.ahead];
  },
  pairOf: (s) => s.world.pairOf({ a: s.shape(), b: s.shape() }),
};
