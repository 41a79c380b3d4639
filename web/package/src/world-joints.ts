/** What ties bodies together: joints, made, set and read. */
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
  userData,
  vecAt,
  view,
} from "./numbers.js";
import { Kind } from "./plain/handles.js";
import type { BodyRef, JointId, JointRef } from "./types.js";
import { WorldViews } from "./world-views.js";

const SIDES = ["a", "b"] as const;
const BREAKING = JOINT_OPTIONS.slice(
  JointOptionsAt.breakForce,
  JointOptionsAt.onlyReports + 1,
);

export class WorldJoints extends WorldViews {
  /**
   * Ties two bodies together, or two joints as a gear. It takes effect with the next step, and is
   * gone with either body.
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
   * Where a joint is, by how much it is off, and what it bears.
   * @example world.jointState(joint).force
   */
  jointState(joint: JointRef): JointState {
    this.on(Kind.joint, "api_joint_get", joint);
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

  /** What another like it can be made with, as it is now: with its frames in both bodies. */
  jointOptions(joint: JointRef): AnyJointOptions {
    this.on(Kind.joint, "api_joint_options", joint);
    return readJoint(this.engine.slots);
  }

  /**
   * Sets what acts in a direction that the joint's kind drives; what is not named stays. Wakes its
   * bodies.
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

  /** Sets how long a rod is. Wakes its bodies. */
  setJointLength(joint: JointRef, length: number): void {
    this.on(Kind.joint, "api_joint_set_length", joint, length);
  }

  /**
   * Sets where a joint is in its body a or b; what is not named stays. Wakes both.
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
   * Sets what a joint bears; what is not named stays.
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

  /** False lets go of both bodies, until true. Wakes them. */
  setJointEnabled(joint: JointRef, enabled: boolean): void {
    this.on(Kind.joint, "api_joint_set_enabled", joint, flagOf(enabled, "enabled"));
  }

  /** Keeps a number for your own use: whole, from 0 to 2⁵³ - 1. */
  setJointUserData(joint: JointRef, data: number): void {
    this.on(Kind.joint, "api_joint_set_user_data", joint, userData(data) ?? 0);
  }

  /** Every joint of the world. */
  joints(): JointId[] {
    this.onWorld("api_world_joints");
    return this.#jointIds();
  }

  /** The joints of a body. */
  jointsOf(body: BodyRef): JointId[] {
    this.on(Kind.body, "api_body_joints", body);
    return this.#jointIds();
  }

  /**
   * The joints that broke in the last step, or only bore more than they can; copied, so that it
   * may be kept.
   * @example world.jointEvents()
   */
  jointEvents(): JointEvent[] {
    const { engine } = this;
    this.onWorld("api_world_joint_events");
    const { buffer, slots } = engine;
    return rowsOf(Float64Array, buffer, slots, ListAt.address, JointEventAt.length, readEvent);
  }

  /**
   * Every joint for drawing: where its ends, its axis and its bodies are at alpha between the last
   * two steps, relative to the origin as `poses` has it; its limits, and what it bears.
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

  /** Makes a world that never had a joint ready to be restored from a snapshot that has some. */
  useJoints(): void {
    this.onWorld("api_world_use_joints");
  }

  /** As far as the engine lets limits be; a little less, for rounding. */
  get #furthest(): number {
    return this.reach / 1000;
  }

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
