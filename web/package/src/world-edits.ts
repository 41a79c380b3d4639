/**
 * The layer of World with setters of bodies and shapes. A change takes effect with the next step,
 * wakes the body and the bodies that touch it, and is in snapshots taken after it. thud_edits.h
 * describes them in full.
 *
 * Every setter throws a ThudError "invalid" for a value out of range or of the wrong type, "stale"
 * for a handle of a destroyed object, and "locked" inside a callback; then nothing has changed.
 */
import { checkOptions } from "./checks/names.js";
import { Kind, kindOf } from "./plain/handles.js";
import { flagOf, indexOf, numbersOf, userDataOf, xOf } from "./numbers.js";
import {
  BODY_KINDS,
  type BodyRef,
  type BodyKind,
  type Detection,
  DETECTIONS,
  type Filter,
  type Locks,
  type Mass,
  type ShapeRef,
} from "./types.js";
import { NumberAt, ShapeStateAt } from "./generated/slots.js";
import { WorldJoints } from "./world-joints.js";

const FILTER = ["category", "mask", "group"] as const;
const LOCKS = ["x", "y"] as const;
const MASS = ["mass", "inertia", "center", "."] as const;

/** The layer of World with setters. */
export class WorldEdits extends WorldJoints {
  // ---- shapes ----

  /**
   * Sets which shapes a shape collides with (category, mask, group); options that are not given
   * keep their values. Contacts that are no longer allowed end, with an event.
   * @throws {ThudError} "invalid", "stale"; "locked" inside a callback; "memory".
   * @example world.setFilter(ghost, { mask: 0 })
   */
  setFilter(shape: ShapeRef, filter: Filter): void {
    const [category, mask, group] = numbersOf("setFilter", filter, FILTER);
    this.on(Kind.shape, "api_shape_state", shape);
    const s = this.engine.slots;
    this.on(
      Kind.shape,
      "api_shape_set_filter",
      shape,
      category ?? s[ShapeStateAt.category],
      mask ?? s[ShapeStateAt.mask],
      group ?? s[ShapeStateAt.group],
    );
  }

  /**
   * Sets the coefficient of friction, 0 to 10⁶.
   * @throws {ThudError} "invalid", "stale"; "locked" inside a callback.
   * @example world.setFriction(ice, 0)
   */
  setFriction(shape: ShapeRef, friction: number): void {
    this.on(Kind.shape, "api_shape_set_friction", shape, friction);
  }

  /**
   * Sets the restitution, the speed after a bounce over the speed before, [0, 1].
   * @throws {ThudError} "invalid", "stale"; "locked" inside a callback.
   */
  setRestitution(shape: ShapeRef, restitution: number): void {
    this.on(Kind.shape, "api_shape_set_restitution", shape, restitution);
  }

  /**
   * Sets the speed of the surface, as of a conveyor belt: length/s, clockwise about the shape, up
   * to 10⁶ length scales a second either way.
   * @throws {ThudError} "invalid", "stale"; "locked" inside a callback.
   * @example world.setSurfaceSpeed(belt, -2)
   */
  setSurfaceSpeed(shape: ShapeRef, speed: number): void {
    this.on(Kind.shape, "api_shape_set_surface_speed", shape, speed);
  }

  /**
   * Sets the density, mass per area, 0 to 10¹². The mass and the centre of mass of the body are
   * computed again at once.
   * @throws {ThudError} "invalid", "stale"; "locked" inside a callback.
   */
  setDensity(shape: ShapeRef, density: number): void {
    this.on(Kind.shape, "api_shape_set_density", shape, density);
  }

  /**
   * Sets whether a shape is a sensor, which reports overlaps and collides with nothing. Its
   * contacts end with events, and begin again as those of the other kind.
   * @throws {ThudError} "invalid", "stale"; "locked" inside a callback; "memory".
   */
  setSensor(shape: ShapeRef, sensor: boolean): void {
    this.on(Kind.shape, "api_shape_set_sensor", shape, flagOf(sensor, "sensor"));
    this.shapesRevision++;
  }

  /**
   * Sets whether contacts of a shape make events; a pair makes them where both of its shapes do. An
   * end is reported if its begin was. Wakes no body.
   * @throws {ThudError} "invalid", "stale"; "locked" inside a callback.
   * @example world.setEvents(debris, false)
   */
  setEvents(shape: ShapeRef, events: boolean): void {
    this.on(Kind.shape, "api_shape_set_events", shape, flagOf(events, "events"));
  }

  /**
   * Sets the radius of a circle, a length from 10⁻⁴ to 16384 length scales, of static bodies to
   * 32000. The mass of the body is computed again; shapes that it then overlaps are separated.
   * @throws {ThudError} "invalid", also for another kind of shape, "stale"; "locked" inside a
   * callback.
   * @example world.setRadius(balloon, 0.8)
   */
  setRadius(shape: ShapeRef, radius: number): void {
    this.on(Kind.shape, "api_shape_set_radius", shape, radius);
    this.shapesRevision++;
  }

  /**
   * Sets the half extents of an AABB or OBB around the same centre: lengths, with the range of
   * `setRadius`. The mass of the body is computed again; shapes that it then overlaps are
   * separated.
   * @throws {ThudError} "invalid", also for another kind of shape, "stale"; "locked" inside a
   * callback.
   */
  setHalfExtents(shape: ShapeRef, halfWidth: number, halfHeight: number): void {
    this.on(Kind.shape, "api_shape_set_half_extents", shape, halfWidth, halfHeight);
    this.shapesRevision++;
  }

  // ---- bodies ----

  /**
   * Sets the user data of a body or a shape: a whole number from 0 to 2⁵³ - 1 for your own use.
   * Wakes no body. `kind`: a handle of another kind is refused.
   * @throws {ThudError} "invalid", "stale".
   */
  setUserData(id: BodyRef | ShapeRef, data: number, kind?: "body" | "shape"): void {
    const number = userDataOf(data) ?? 0;
    if (kindOf(id, kind) === Kind.shape) this.on(Kind.shape, "api_shape_set_user_data", id, number);
    else this.on(Kind.body, "api_body_set_user_data", id, number);
  }

  /**
   * Sets the kind of a body. One that becomes static loses its velocity; one that becomes dynamic
   * gets the mass of its shapes. Its contacts end, and those that still touch begin again with the
   * next step; forces that wait for the step are dropped.
   * @throws {ThudError} "invalid", also for a quarantined body, one with terrain, shapes that are
   * too large for the kind, or joints that do not allow it; "stale"; "locked" inside a callback;
   * "memory".
   * @example world.setKind(platform, "dynamic")
   */
  setKind(body: BodyRef, kind: BodyKind): void {
    this.on(Kind.body, "api_body_set_kind", body, indexOf(BODY_KINDS, kind, "kind"));
    this.shapesRevision++;
  }

  /**
   * Sets the damping of the velocity and of the angular velocity, 1/s, both 0 or more.
   * @throws {ThudError} "invalid", "stale"; "locked" inside a callback.
   */
  setDamping(body: BodyRef, linear: number, angular: number): void {
    this.on(Kind.body, "api_body_set_damping", body, linear, angular);
  }

  /**
   * Sets the factor of the world's gravity; a body with 0 floats.
   * @throws {ThudError} "invalid", "stale"; "locked" inside a callback.
   */
  setGravityScale(body: BodyRef, scale: number): void {
    this.on(Kind.body, "api_body_set_gravity_scale", body, scale);
  }

  /**
   * Sets whether no torque turns a body. True sets the angular velocity of a dynamic body to 0.
   * @throws {ThudError} "invalid", "stale"; "locked" inside a callback.
   */
  setFixedRotation(body: BodyRef, fixed: boolean): void {
    this.on(Kind.body, "api_body_set_fixed_rotation", body, flagOf(fixed, "fixed"));
  }

  /**
   * Sets the axes of the world along which a dynamic body does not move; axes that are not given
   * are free. A lock keeps the centre of mass where it is, or where `setTransform` puts it. It is a
   * joint, which `jointsOf` lists.
   * @throws {ThudError} "invalid", also for a body that is not dynamic; "stale"; "locked" inside a
   * callback; "memory".
   * @example world.setLocks(paddle, { x: true })
   */
  setLocks(body: BodyRef, locks: Locks): void {
    const [x, y] = numbersOf("setLocks", locks, LOCKS);
    this.on(Kind.body, "api_body_set_locks", body, x ?? 0, y ?? 0);
  }

  /**
   * The axes along which a body is locked.
   * @throws {ThudError} "stale".
   */
  locksOf(body: BodyRef): { x: boolean; y: boolean } {
    this.on(Kind.body, "api_body_locks", body);
    const locked = this.engine.slots[NumberAt.value];
    return { x: (locked & 1) !== 0, y: locked > 1 };
  }

  /**
   * Sets how the collisions of a body are found; null: as the world's, also when that changes
   * later.
   * @throws {ThudError} "invalid", "stale"; "locked" inside a callback.
   */
  setDetection(body: BodyRef, detection: Detection | null): void {
    const number = detection === null ? -1 : indexOf(DETECTIONS, detection, "detection");
    this.on(Kind.body, "api_body_set_detection", body, number);
  }

  /**
   * Sets whether a body may sleep. Where it may not, its island stays awake with it.
   * @throws {ThudError} "invalid", "stale"; "locked" inside a callback.
   */
  setMaySleep(body: BodyRef, maySleep: boolean): void {
    this.on(Kind.body, "api_body_set_may_sleep", body, flagOf(maySleep, "maySleep"));
  }

  /**
   * Sets the mass of a dynamic body, in place of that of its shapes, until it is set again or the
   * body changes its kind. Null: the mass is that of its shapes.
   * @throws {ThudError} "invalid", also for a body that is not dynamic; "stale"; "locked" inside a
   * callback.
   * @example world.setMass(boat, { mass: 900, inertia: 400, center: [0, -0.4] })
   */
  setMass(body: BodyRef, mass: Mass | null): void {
    if (mass === null) {
      this.on(Kind.body, "api_body_weigh", body);
      return;
    }
    checkOptions("setMass", mass, MASS);
    const { center = [0, 0] } = mass;
    this.on(Kind.body, "api_body_set_mass", body, mass.mass, mass.inertia, xOf(center, "center"), center?.[1]);
  }
}
