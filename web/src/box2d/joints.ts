/**
 * The joints of a Box2DWorld. They are created, changed and removed as those of the thud world are.
 * A joint that can break does so in each engine by the force that it bears there.
 */
import type { BodyId, JointId, World } from "thud";
import type {
  b2BodyId,
  b2JointId,
  b2WorldId,
} from "../../node_modules/box2d3-wasm/build/dist/es/deluxe/Box2D.deluxe";
import { gapOf, type Gap } from "./joint-gap";
import type { Common } from "./make";
import { heeding } from "./heeding";
import { frameOfA, makeJoint, setFrame, type Tie } from "./make-joint";

/** A joint that exists in Box2D, with the options that it was given last. */
interface Made {
  tie: Tie;
  joint: b2JointId;
  /** Its options without the frames and the user data, as text. */
  rest: string;
}

/** A force or torque limit from which on a joint never breaks. */
const UNBREAKABLE = 1e30;

/** The joints of one Box2DWorld. */
export class Joints {
  /** Box2D's joints, by index and generation of the thud joint. */
  readonly #made = new Map<string, Made>();
  /** Joints that have to be compared before the next step. */
  readonly #touched = new Map<string, JointId>();
  /** Names (keys of `#made`) of joints that can break in Box2D, by the index of Box2D's joint. */
  readonly #brittle = new Map<number, string>();
  /** Names of joints that broke in Box2D; they stay broken there for as long as thud has them. */
  readonly #broken = new Set<string>();
  /** What Box2D's joint lacks, for joints that Box2D has not, or has without some part. */
  readonly #lacks = new Map<string, readonly string[]>();

  /**
   * `bodyOf` returns Box2D's body, and creates it if it has no shapes; null if the thud body is
   * disabled.
   */
  constructor(
    private readonly common: Common,
    private readonly source: World,
    private readonly world: b2WorldId,
    private readonly bodyOf: (body: BodyId) => b2BodyId | null,
  ) {}

  /** To be called when a joint was created, changed or destroyed in the thud world. */
  touch(joint: JointId): void {
    this.#touched.set(nameOf(joint), joint);
  }

  /** Like `touch`, for all joints of either engine. */
  touchAll(): void {
    for (const name of this.#made.keys()) this.touch(idOf(name));
    for (const joint of this.source.joints()) this.touch(joint);
  }

  /** What Box2D's joints lack, in a few words each. */
  get misses(): Set<string> {
    return new Set([...this.#lacks.values()].flat());
  }

  /** Brings the touched joints up to date. To be called after bodies were. */
  follow(): void {
    for (const [name, joint] of this.#touched) this.#follow(name, joint);
    this.#touched.clear();
  }

  /** To be called before a body is removed: Box2D removes its joints with it. */
  forget(body: BodyId): void {
    for (const [name, { tie }] of this.#made)
      if (tie.bodyA.index === body.index || tie.bodyB.index === body.index) this.#remove(name);
  }

  /** Removes the joints that bore more than they can in the last step. */
  breakThem(): void {
    if (this.#brittle.size === 0) return;
    const events = this.common.box2d.b2World_GetJointEvents(this.world);
    const names: (string | undefined)[] = [];
    for (let i = 0; i < events.count; i++)
      names.push(this.#brittle.get(events.GetJointEvent(i).jointId.index1));
    events.delete();
    for (const name of names) {
      if (name === undefined) continue;
      this.#remove(name);
      this.#broken.add(name);
    }
  }

  /**
   * The gap of the joint that is open the most, for each array of poses. Only joints count that
   * exist in both engines; without any the result is empty.
   */
  gaps(poses: readonly Float32Array[]): Gap[] {
    const worst: [number, number][] = [];
    for (const [name, { tie }] of this.#made) {
      if (tie.kind === "target" || tie.kind === "filter") continue;
      if (!this.source.isValid(idOf(name))) continue;
      poses.forEach((one, i) => {
        const [length, angle] = gapOf(tie, one);
        const [most, furthest] = worst[i] ?? [0, 0];
        worst[i] = [Math.max(most, length), Math.max(furthest, angle)];
      });
    }
    return worst;
  }

  /** Creates, changes or removes Box2D's joint, so that it has the options of the thud joint. */
  #follow(name: string, joint: JointId): void {
    const { source } = this;
    const options = source.isValid(joint) ? source.jointOptionsOf(joint) : null;
    if (!options) this.#broken.delete(name);
    if (!options?.enabled || this.#broken.has(name)) return this.#remove(name);
    if (options.kind === "gear") return void this.#lacks.set(name, ["gears"]);
    const rest = textOf(options);
    const known = this.#made.get(name);
    if (known?.rest === rest) return this.#place(known, options);
    this.#remove(name);
    const [a, b] = [this.bodyOf(options.bodyA), this.bodyOf(options.bodyB)];
    if (!a || !b) return;
    const heeded = heeding(options);
    const made = makeJoint(this.common, this.world, [a, b], heeded.tie);
    this.#lacks.set(name, heeded.lacks());
    this.#made.set(name, { tie: options, joint: made, rest });
    this.#bear(name, made, options);
  }

  /** Sets the force and torque at which Box2D reports the joint as broken. */
  #bear(name: string, joint: b2JointId, tie: Tie): void {
    const { breakForce = UNBREAKABLE, breakTorque = UNBREAKABLE } = tie;
    if (tie.onlyReports || Math.min(breakForce, breakTorque) >= UNBREAKABLE) return;
    const { box2d, unit } = this.common;
    box2d.b2Joint_SetForceThreshold(joint, breakForce / unit);
    box2d.b2Joint_SetTorqueThreshold(joint, breakTorque / unit ** 2);
    this.#brittle.set(joint.index1, name);
  }

  /** Moves the joint's frames, which are all that differs. */
  #place(made: Made, tie: Tie): void {
    const { box2d } = this.common;
    const same = JSON.stringify(framesOf(made.tie)) === JSON.stringify(framesOf(tie));
    made.tie = tie;
    if (same) return;
    const transform = new box2d.b2Transform();
    setFrame(this.common, transform, frameOfA(tie));
    box2d.b2Joint_SetLocalFrameA(made.joint, transform);
    setFrame(this.common, transform, framesOf(tie)[1]);
    box2d.b2Joint_SetLocalFrameB(made.joint, transform);
    transform.delete();
    box2d.b2Joint_WakeBodies(made.joint);
  }

  #remove(name: string): void {
    this.#lacks.delete(name);
    const made = this.#made.get(name);
    if (!made) return;
    this.#made.delete(name);
    this.#brittle.delete(made.joint.index1);
    this.common.box2d.b2DestroyJoint(made.joint, true);
  }
}

/** Both frames of the options; empty for a filter joint, which has none. */
function framesOf(tie: Tie) {
  return tie.kind === "filter" ? [] : [tie.frameA, tie.frameB];
}

/** The options without the frames and the user data, as text. */
function textOf(tie: Tie): string {
  return JSON.stringify({ ...tie, frameA: 0, frameB: 0, userData: 0 });
}

/** The key of a joint in the maps above. */
function nameOf({ index, generation }: JointId): string {
  return `${index}:${generation}`;
}

function idOf(name: string): JointId {
  const [index, generation] = name.split(":").map(Number);
  return { kind: "joint", index, generation };
}
