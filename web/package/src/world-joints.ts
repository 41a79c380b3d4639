/**
 * The layer of World that creates, changes and reads joints. thud_joint.h describes joints in full.
 * Calls that change a joint throw a ThudError "locked" inside a callback.
 */
import {
  HandleAt,
  JOINT_OPTIONS,
  JointEventAt,
  JointHandlesAt,
  JointOptionsAt,
  JointRowAt,
  JointStateAt,
  JointTableAt,
  FRAME_OPTIONS,
  FrameOptionsAt,
  ListAt,
} from "./generated/slots.js";
import { named, readJoint, writeDrive, writeJoint } from "./joint-numbers.js";
import {
  type AnyJointOptions,
  type Direction,
  DIRECTIONS,
  type Drive,
  type DriveForces,
  JOINT_KINDS,
  type JointEvent,
  type JointFrame,
  type JointOptions,
  type JointState,
  type JointTable,
  type Numbered,
} from "./joint-types.js";
import {
  bodyAt,
  fill,
  flagOf,
  indexOf,
  jointAt,
  numbersOf,
  rowsOf,
  userDataOf,
  vecAt,
  view,
} from "./numbers.js";
import { Kind } from "./plain/handles.js";
import type { BodyRef, JointId, JointRef } from "./types.js";
import { WorldViews } from "./world-views.js";

const SIDES = ["a", "b"] as const;
/** The options of setJointBreaking: breakForce, breakTorque, onlyReports. */
const BREAKING = JOINT_OPTIONS.slice(
  JointOptionsAt.breakForce,
  JointOptionsAt.onlyReports + 1,
);

/** The layer of World with joints. */
export class WorldJoints extends WorldViews {
  /**
   * Creates a joint between two bodies, or a gear between two joints. It takes effect with the next
   * step, wakes both bodies, and is destroyed with either of them.
   * @throws {ThudError} "invalid" for a value out of range, options that exclude or need each
   * other, or bodies that the kind does not allow; "stale"; "locked" inside a callback; "memory".
   * @example world.createJoint({ kind: "hinge", bodyA, bodyB, at: [0, 5] })
   */
  createJoint(options: AnyJointOptions | Numbered<AnyJointOptions>): JointId {
    const { engine } = this;
    writeJoint(engine, options);
    named(options.kind, options, this.#furthest, () =>
      engine.check(engine.exports.api_joint_create(this.address, this.#furthest)),
    );
    return jointAt(engine.slots, HandleAt.index1);
  }

  /**
   * The state of a joint after the last step: its values, gaps and forces.
   * @throws {ThudError} "stale".
   * @example world.jointStateOf(joint).force
   */
  jointStateOf(joint: JointRef): JointState {
    this.on(Kind.joint, "api_joint_state", joint);
    const s = this.engine.slots;
    const [along, across, turn] = s.subarray(JointStateAt.value);
    const driveAt = (i: number): DriveForces => {
      const [limit, spring, motor] = s.subarray(JointStateAt.drive + 3 * i);
      return { limit, spring, motor };
    };
    return {
      kind: JOINT_KINDS[s[JointStateAt.kind]],
      bodyA: bodyAt(s, JointStateAt.bodyA),
      bodyB: bodyAt(s, JointStateAt.bodyB),
      enabled: s[JointStateAt.enabled] !== 0,
      value: { along, across, turn },
      gap: s[JointStateAt.gap],
      angleGap: s[JointStateAt.angleGap],
      force: vecAt(s, JointStateAt.force),
      torque: s[JointStateAt.torque],
      drive: { along: driveAt(0), across: driveAt(1), turn: driveAt(2) },
      userData: s[JointStateAt.userData],
    };
  }

  /**
   * The options of a joint as they are now, with its frames in both bodies, from which another such
   * joint can be made.
   * @throws {ThudError} "stale".
   */
  jointOptionsOf(joint: JointRef): AnyJointOptions {
    this.on(Kind.joint, "api_joint_options", joint);
    return readJoint(this.engine.slots);
  }

  /**
   * Sets the drive of a direction that the joint's kind drives; options that are not given keep
   * their values. Wakes its bodies.
   * @throws {ThudError} "invalid", also for a direction that the kind does not drive; "stale";
   * "locked" inside a callback.
   * @example world.setDrive(joint, "turn", { motorSpeed: -3 })
   */
  setDrive(joint: JointRef, direction: Direction, drive: Drive): void {
    const i = indexOf(DIRECTIONS, direction, "direction");
    this.on(Kind.joint, "api_joint_options", joint);
    writeDrive(this.engine.slots, i, drive, direction);
    named("setDrive", { [direction]: drive }, this.#furthest, () =>
      this.on(Kind.joint, "api_joint_set_drive", joint, i, this.#furthest),
    );
  }

  /**
   * Sets the length of a distance joint: above 0, up to 10⁶ length scales. Wakes its bodies.
   * @throws {ThudError} "invalid", also for another kind; "stale"; "locked" inside a callback.
   */
  setJointLength(joint: JointRef, length: number): void {
    this.on(Kind.joint, "api_joint_set_length", joint, length);
  }

  /**
   * Sets the frame of a joint in its body a or b; options that are not given keep their values.
   * Wakes both bodies.
   * @throws {ThudError} "invalid", also for gears and filters; "stale"; "locked" inside a callback.
   * @example world.setJointFrame(joint, "a", { position: [pointer.x, pointer.y] })
   */
  setJointFrame(joint: JointRef, side: "a" | "b", frame: JointFrame): void {
    const i = indexOf(SIDES, side, "side");
    const numbers = numbersOf("frame", frame, FRAME_OPTIONS);
    this.on(Kind.joint, "api_joint_options", joint);
    fill(this.engine.slots, numbers, JointOptionsAt.frameA + FrameOptionsAt.length * i);
    named("setJointFrame", { [`frame${side.toUpperCase()}`]: frame }, this.#furthest, () =>
      this.on(Kind.joint, "api_joint_set_frame", joint, i),
    );
  }

  /**
   * Sets the force and torque beyond which a joint breaks; options that are not given keep their
   * values.
   * @throws {ThudError} "invalid", "stale"; "locked" inside a callback.
   * @example world.setJointBreaking(joint, { breakForce: 500 })
   */
  setJointBreaking(
    joint: JointRef,
    options: Pick<JointOptions, "breakForce" | "breakTorque" | "onlyReports">,
  ): void {
    const numbers = numbersOf("setJointBreaking", options, BREAKING);
    this.on(Kind.joint, "api_joint_options", joint);
    fill(this.engine.slots, numbers, JointOptionsAt.breakForce);
    named("setJointBreaking", options, this.#furthest, () =>
      this.on(Kind.joint, "api_joint_set_breaking", joint),
    );
  }

  /**
   * Sets whether a joint acts. Wakes both bodies.
   * @throws {ThudError} "invalid", "stale"; "locked" inside a callback.
   */
  setJointEnabled(joint: JointRef, enabled: boolean): void {
    this.on(Kind.joint, "api_joint_set_enabled", joint, flagOf(enabled, "enabled"));
  }

  /**
   * Sets the user data of a joint: a whole number from 0 to 2⁵³ - 1 for your own use.
   * @throws {ThudError} "invalid", "stale"; "locked" inside a callback.
   */
  setJointUserData(joint: JointRef, data: number): void {
    this.on(Kind.joint, "api_joint_set_user_data", joint, userDataOf(data) ?? 0);
  }

  /** All joints of the world, in a deterministic order. */
  joints(): JointId[] {
    this.onWorld("api_world_joints");
    return this.#jointIds();
  }

  /**
   * The joints of a body, in a deterministic order.
   * @throws {ThudError} "stale".
   */
  jointsOf(body: BodyRef): JointId[] {
    this.on(Kind.body, "api_body_joints", body);
    return this.#jointIds();
  }

  /**
   * The joints whose force or torque exceeded breakForce or breakTorque in the last step, or in the
   * steps of the last `advance`. A copy.
   * @example world.jointEvents()
   */
  jointEvents(): JointEvent[] {
    const { engine } = this;
    this.onWorld("api_world_joint_events");
    const { buffer, slots } = engine;
    return rowsOf(Float64Array, buffer, slots, ListAt.address, JointEventAt.length, readEvent);
  }

  /**
   * All joints for drawing, as views into wasm memory, valid until the next call of the engine:
   * anchors and axes with the bodies at `alpha` between the last two steps, relative to the origin,
   * both as in `poses`; limits and forces.
   * It has no joints (count 0) where alpha is outside [0, 1] or the origin further than 10⁹ length
   * scales.
   * @throws {ThudError} "memory".
   */
  jointTable(alpha = 1, originX = 0, originY = 0): JointTable {
    const { engine } = this;
    engine.check(engine.exports.api_joint_table(this.address, originX, originY, alpha));
    const { buffer, slots: s } = engine;
    const count = s[JointTableAt.count];
    return {
      count,
      rows: view(Float32Array, buffer, s[JointTableAt.rows], JointRowAt.length * count),
      handles: view(Uint32Array, buffer, s[JointTableAt.handles], JointHandlesAt.length * count),
    };
  }

  /**
   * Prepares a world that never had a joint for `restore` from a snapshot with joints, which it
   * would refuse otherwise.
   * @throws {ThudError} "memory"; "locked" inside a callback.
   */
  useJoints(): void {
    this.onWorld("api_world_use_joints");
  }

  /**
   * The largest length of a joint, in length units: 10⁶ length scales, less 0.1 percent for
   * rounding.
   */
  get #furthest(): number {
    return this.reach / 1000;
  }

  /** The joint handles of the list that the last call of the module has left in the slots. */
  #jointIds(): JointId[] {
    const { buffer, slots } = this.engine;
    return rowsOf(Uint32Array, buffer, slots, ListAt.address, HandleAt.length, jointAt);
  }

}

function readEvent(rows: Float64Array, at: number): JointEvent {
  return {
    joint: jointAt(rows, at + JointEventAt.joint),
    bodyA: bodyAt(rows, at + JointEventAt.bodyA),
    bodyB: bodyAt(rows, at + JointEventAt.bodyB),
    userData: rows[at + JointEventAt.userData],
    force: rows[at + JointEventAt.force],
    torque: rows[at + JointEventAt.torque],
    broken: rows[at + JointEventAt.broken] !== 0,
  };
}
