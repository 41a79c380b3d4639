/**
 * The joints of a Box2DWorld: made, set and broken as those of the thud world are. One that breaks
 * does so in each engine by what it bears there.
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

interface Made {
  tie: Tie;
  joint: b2JointId;
  /** All of it but the frames, as text. */
  rest: string;
}

/** From here on a joint bears whatever comes. */
const UNBREAKABLE = 1e30;

export class Joints {
  /** By index and generation of thud's. */
  readonly #made = new Map<string, Made>();
  readonly #touched = new Map<string, JointId>();
  /** Of those that Box2D may break, by the index of its own. */
  readonly #brittle = new Map<number, string>();
  /** Of those that Box2D has not or not wholly, what it lacks. */
  readonly #lacks = new Map<string, readonly string[]>();

  /** `bodyOf` makes a body that has no shapes; null if the thud world has it switched off. */
  constructor(
    private readonly common: Common,
    private readonly source: World,
    private readonly world: b2WorldId,
    private readonly bodyOf: (body: BodyId) => b2BodyId | null,
  ) {}

  /** It was made, set or destroyed in the thud world. */
  touch(joint: JointId): void {
    this.#touched.set(nameOf(joint), joint);
  }

  /** Also those that are gone there. */
  touchAll(): void {
    for (const name of this.#made.keys()) this.touch(idOf(name));
    for (const joint of this.source.joints()) this.touch(joint);
  }

  /** What Box2D was not given of joints, in a few words each. */
  get misses(): Set<string> {
    return new Set([...this.#lacks.values()].flat());
  }

  /** Does after its bodies what was done to those that were touched. */
  follow(): void {
    for (const [name, joint] of this.#touched) this.#follow(name, joint);
    this.#touched.clear();
  }

  /** Before a body goes, which takes its joints along. */
  forget(body: BodyId): void {
    for (const [name, { tie }] of this.#made)
      if (tie.bodyA.index === body.index || tie.bodyB.index === body.index) this.#remove(name);
  }

  /** After a step: those that bore too much. */
  breakThem(): void {
    if (this.#brittle.size === 0) return;
    const events = this.common.box2d.b2World_GetJointEvents(this.world);
    const names: (string | undefined)[] = [];
    for (let i = 0; i < events.count; i++)
      names.push(this.#brittle.get(events.GetJointEvent(i).jointId.index1));
    events.delete();
    for (const name of names) if (name !== undefined) this.#remove(name);
  }

  /** The worst of all that hold in both engines, in each one's own poses; none without any. */
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

  #follow(name: string, joint: JointId): void {
    const { source } = this;
    const options = source.isValid(joint) ? source.jointOptions(joint) : null;
    if (!options?.enabled) return this.#remove(name);
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

  #bear(name: string, joint: b2JointId, tie: Tie): void {
    const { breakForce = UNBREAKABLE, breakTorque = UNBREAKABLE } = tie;
    if (tie.onlyReports || Math.min(breakForce, breakTorque) >= UNBREAKABLE) return;
    const { box2d, unit } = this.common;
    box2d.b2Joint_SetForceThreshold(joint, breakForce / unit);
    box2d.b2Joint_SetTorqueThreshold(joint, breakTorque / unit ** 2);
    this.#brittle.set(joint.index1, name);
  }

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

function framesOf(tie: Tie) {
  return tie.kind === "filter" ? [] : [tie.frameA, tie.frameB];
}

function textOf(tie: Tie): string {
  return JSON.stringify({ ...tie, frameA: 0, frameB: 0, userData: 0 });
}

function nameOf({ index, generation }: JointId): string {
  return `${index}:${generation}`;
}

function idOf(name: string): JointId {
  const [index, generation] = name.split(":").map(Number);
  return { kind: "joint", index, generation };
}
