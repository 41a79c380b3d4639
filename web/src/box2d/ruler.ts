/**
 * Measures how deep bodies overlap, whichever engine has moved them, with the same geometry: a thud
 * world of its own holds copies of the bodies, is given their poses, and runs a step of a
 * nanosecond without gravity, in which contacts are found and nothing moves.
 */
import type { BodyId, BodyState, ShapeId, ShapeState, Terrain, World } from "thud";
import { Mirror, type Twin } from "./mirror";

/** Seconds; overlap is pushed apart at 3 length scales a second. */
const INSTANT = 1e-9;

interface Copy {
  id: BodyId;
  shapes: Map<number, ShapeId>;
  /** As it was put last; what rests is left alone. */
  x: number;
  y: number;
  cosine: number;
  sine: number;
}

export class Ruler implements Twin {
  readonly #world: World;
  readonly #mirror: Mirror;
  /** By the slot of the body that it copies. */
  readonly #copies = new Map<number, Copy>();

  /** `lengthScale` is the one of the world that it measures. */
  constructor(world: World, lengthScale = 1) {
    this.#world = world.engine.createWorld({
      gravity: [0, 0],
      timeStep: INSTANT,
      lengthScale,
      quality: "draft",
      substeps: 1,
      sleeping: false,
      detection: "overlap",
      contactEvents: false,
    });
    this.#mirror = new Mirror(world, this);
  }

  close(): void {
    this.#world.close();
  }

  /** Bodies that have shapes. */
  get bodies(): number {
    return this.#copies.size;
  }

  /** Follows bodies that came or went and ground that was dug. */
  sync(): void {
    this.#mirror.sync();
  }

  /** The deepest of `overlap`. */
  penetration(poses: Float32Array, originX = 0, originY = 0): number {
    return this.overlap(poses, originX, originY).worst;
  }

  /**
   * The deepest overlap and the mean over all contact points, in the world's lengths; 0 without
   * any. `poses` are those of `World.poses` or `Box2DWorld.poses`, relative to the origin; bodies
   * without stay where they were.
   */
  overlap(poses: Float32Array, originX = 0, originY = 0): { worst: number; mean: number } {
    for (const [slot, copy] of this.#copies) {
      const [x, y, cosine, sine] = poses.subarray(4 * slot, 4 * slot + 4);
      if (!(Number.isFinite(x) && Number.isFinite(y))) continue;
      this.#put(copy, originX + x, originY + y, cosine, sine);
    }
    this.#world.step();
    const { penetrationMax, penetrationMean } = this.#world.error();
    // Separation is a negative depth, and touching may be a negative zero.
    return { worst: Math.max(0, penetrationMax), mean: Math.max(0, penetrationMean) };
  }

  #put(copy: Copy, x: number, y: number, cosine: number, sine: number): void {
    if (copy.x === x && copy.y === y && copy.cosine === cosine && copy.sine === sine) return;
    Object.assign(copy, { x, y, cosine, sine });
    this.#world.setTransform(copy.id, [x, y], Math.atan2(sine, cosine));
  }

  // ---- Twin ----

  addBody({ index }: BodyId, { kind, position, angle }: BodyState): void {
    const id = this.#world.createBody({ kind, position, angle });
    this.#copies.set(index, { id, shapes: new Map(), x: NaN, y: NaN, cosine: 1, sine: 0 });
  }

  addShape(body: BodyId, { index }: ShapeId, state: ShapeState, terrain: Terrain | null): void {
    const copy = this.#copy(body);
    copy.shapes.set(index, this.#createShape(copy.id, state, terrain));
  }

  #createShape(body: BodyId, state: ShapeState, terrain: Terrain | null): ShapeId {
    const { body: _, ...options } = state;
    if (options.kind === "circle") return this.#world.createCircle(body, options);
    if (options.kind === "aabb") return this.#world.createAabb(body, options);
    if (options.kind === "obb") return this.#world.createObb(body, options);
    return this.#world.createTerrain(body, terrain!, options);
  }

  finishBody(): void {}

  removeShape(body: BodyId, { index }: ShapeId): void {
    const { shapes } = this.#copy(body);
    const shape = shapes.get(index);
    if (shape) this.#world.destroy(shape);
    shapes.delete(index);
  }

  removeBody(body: BodyId): void {
    this.#world.destroy(this.#copy(body).id);
    this.#copies.delete(body.index);
  }

  #copy({ index }: BodyId): Copy {
    const copy = this.#copies.get(index);
    if (!copy) throw new Error(`the ruler has no body in slot ${index}`);
    return copy;
  }
}
