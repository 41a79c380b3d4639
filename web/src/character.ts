/**
 * A figure to play with, on levels that ask for one, and the lifts that carry it. The viewer's
 * demo/play/character.c does the same. Lengths are in length scales of the level.
 *
 * Two kindnesses that players take for granted: a jump counts a moment after the ground is gone,
 * and a moment before it is there.
 */
import {
  type BodyId,
  Mover,
  type MoverReport,
  type ShapeId,
  type SolidShape,
  type Vec2,
  type World,
} from "thud";
import type { Built } from "./catalogue";
import { DYNAMIC, STATIC } from "./render/shapes";

const HALF_WIDTH = 0.35;
const HALF_HEIGHT = 0.75;
/** Per second; gains per second squared. */
const RUN_SPEED = 8;
const RUN_GAIN = 60;
const AIR_GAIN = 35;
const JUMP_HEIGHT = 3.2;
/** More gravity than what falls by itself has: jumps feel light otherwise. */
const GRAVITY_MORE = 1.6;
const FALL_SPEED = 25;
/** Of the rise is left where the key is let go. */
const CUT_SHORT = 0.45;
/** Seconds. */
const KINDNESS = 0.1;
/** Force, for bodies of density 1. */
const PUSH = 60;
const ONE_WAY_CATEGORY = 2;
/** What falls that far below where it began is out of every level. */
const LOST_BELOW = 200;

/** What the player wants, as long as it lasts. */
export interface Keys {
  left: boolean;
  right: boolean;
  jump: boolean;
  down: boolean;
}

interface Lift {
  body: BodyId;
  shape: SolidShape;
}

export class Character {
  /** The body by which what moves by itself meets it; drawn as the figure instead. */
  readonly body: BodyId;
  readonly halfWidth: number;
  readonly halfHeight: number;
  /** -1 left, 1 right. */
  facing = 1;
  readonly #world: World;
  readonly #mover: Mover;
  readonly #keys: Readonly<Keys>;
  readonly #unit: number;
  readonly #gravity: number;
  readonly #start: Vec2;
  readonly #lifts: Lift[];
  #before: Vec2;
  #now: Vec2;
  #velocity: Vec2 = [0, 0];
  #ground: MoverReport["ground"] = null;
  #jumpHeld = false;
  #jumpWasDown = false;
  #sinceGround = 0;
  #sinceJumpKey = 1;

  constructor({ world, spawn, gravity, lengthScale }: Built, keys: Readonly<Keys>) {
    this.#world = world;
    this.#keys = keys;
    this.#unit = lengthScale;
    this.#gravity = GRAVITY_MORE * Math.hypot(...gravity);
    this.#start = this.#before = this.#now = [spawn[0], spawn[1]];
    this.#lifts = findLifts(world);
    this.halfWidth = HALF_WIDTH * lengthScale;
    this.halfHeight = HALF_HEIGHT * lengthScale;
    const box = { halfWidth: this.halfWidth, halfHeight: this.halfHeight };
    this.body = world.createBody({ kind: "kinematic", position: this.#start });
    world.createAabb(this.body, box);
    this.#mover = new Mover(world, {
      shape: { kind: "aabb", ...box },
      position: this.#start,
      pushForce: PUSH * lengthScale ** 3,
      body: this.body,
      oneWay: ONE_WAY_CATEGORY,
    });
  }

  close(): void {
    this.#mover.close();
  }

  /** Moves it on by a step of the world, after that was made. */
  step(dt: number): void {
    for (const lift of this.#lifts) turnLift(this.#world, lift, dt);
    this.#before = this.#now;
    this.#steer(dt);
    this.#jump(dt);
    const report = this.#mover.move(this.#velocity, dt, { drop: this.#keys.down });
    this.#velocity = report.velocity;
    this.#ground = report.ground;
    this.#now = report.position;
    if (this.#now[1] < this.#start[1] - LOST_BELOW * this.#unit) this.#goToStart();
  }

  get moves(): boolean {
    return this.#before[0] !== this.#now[0] || this.#before[1] !== this.#now[1];
  }

  /** Where its middle is seen, `alpha` between the last two steps. */
  place(alpha: number): Vec2 {
    const [[x0, y0], [x1, y1]] = [this.#before, this.#now];
    return [x0 + alpha * (x1 - x0), y0 + alpha * (y1 - y0)];
  }

  #goToStart(): void {
    this.#before = this.#now = this.#start;
    this.#velocity = [0, 0];
    this.#ground = null;
    this.#mover.place(this.#start);
  }

  #steer(dt: number): void {
    const wanted = (Number(this.#keys.right) - Number(this.#keys.left)) * RUN_SPEED * this.#unit;
    const gain = (this.#ground ? RUN_GAIN : AIR_GAIN) * this.#unit * dt;
    const [vx, vy] = this.#velocity;
    if (wanted !== 0) this.facing = Math.sign(wanted);
    this.#velocity = [
      vx < wanted ? Math.min(vx + gain, wanted) : Math.max(vx - gain, wanted),
      Math.max(vy - this.#gravity * dt, -FALL_SPEED * this.#unit),
    ];
  }

  #jump(dt: number): void {
    const pressed = this.#keys.jump && !this.#jumpWasDown;
    this.#jumpWasDown = this.#keys.jump;
    this.#sinceGround = this.#ground ? 0 : this.#sinceGround + dt;
    this.#sinceJumpKey = pressed ? 0 : this.#sinceJumpKey + dt;
    const [vx, vy] = this.#velocity;
    if (this.#sinceJumpKey <= KINDNESS && this.#sinceGround <= KINDNESS) {
      const [gx, gy] = this.#ground?.velocity ?? [0, 0];
      const rise = Math.sqrt(2 * this.#gravity * JUMP_HEIGHT * this.#unit);
      this.#velocity = [vx + gx, rise + Math.max(0, gy)];
      this.#sinceJumpKey = this.#sinceGround = 1;
      this.#jumpHeld = true;
    } else if (this.#jumpHeld && !this.#keys.jump && vy > 0) {
      this.#velocity = [vx, vy * CUT_SHORT];
      this.#jumpHeld = false;
    }
  }
}

/** Kinematic boxes that travel. */
function findLifts(world: World): Lift[] {
  const { count, rows, handles } = world.shapeTable();
  const kinematic: ShapeId[] = [];
  for (let i = 0; i < count; i++) {
    const bodyKind = rows[10 * i + 2];
    if (bodyKind !== STATIC && bodyKind !== DYNAMIC)
      kinematic.push({ kind: "shape", index: handles[4 * i] - 1, generation: handles[4 * i + 1] });
  }
  return kinematic.flatMap((id) => {
    const { kind, body, halfExtents } = world.shapeState(id);
    const [halfWidth, halfHeight] = halfExtents;
    return kind === "aabb" ? [{ body, shape: { kind, halfWidth, halfHeight } }] : [];
  });
}

/** Lifts turn back where they meet what stands still, sensors too. */
function turnLift(world: World, { body, shape }: Lift, dt: number): void {
  const { position, velocity } = world.bodyState(body);
  const ahead: Vec2 = [2 * dt * velocity[0], 2 * dt * velocity[1]];
  const met = world.castShapeAll(shape, position, ahead, { sensors: true }).some(
    ({ shape: other, normal }) =>
      normal[0] * ahead[0] + normal[1] * ahead[1] < 0 &&
      world.bodyState(world.shapeState(other).body).kind === "static",
  );
  if (met) world.setVelocity(body, [-velocity[0], -velocity[1]], 0);
}
