/**
 * Measures how deep bodies overlap, by the same code for both engines. A thud world of its own
 * holds copies of the bodies. It is given their poses and makes a step of a nanosecond without
 * gravity, which finds contacts and moves nothing.
 *
 * Pairs that do not collide in the measured world do not count, in either engine. Pairs that a rule
 * or the scene's pair filter excludes are excluded here, too. A pair that a listener lets pass at
 * present has a contact without points in the measured world, and is vetoed here. A pair with a
 * one-way rule counts only while its contact in the measured world has points.
 */
import {
  type BodyId,
  type BodyState,
  CONTACT_ROW,
  type Listener,
  LISTENED_ROW,
  type PairFilter,
  type ShapeId,
  type ShapeState,
  type Terrain,
  type World,
} from "thud";
import type { WorldRecord } from "../worker/watch";
import { Mirror, type Twin } from "./mirror";

/**
 * Length of the step in seconds. Overlapping bodies are pushed apart at up to 3 length scales per
 * second, so by no more than 3e-9 length scales.
 */
const INSTANT = 1e-9;

/** The copy of a body. */
interface Copy {
  id: BodyId;
  shapes: Map<number, ShapeId>;
  /** The pose that was set last. A body with the same pose is not set again. */
  x: number;
  y: number;
  cosine: number;
  sine: number;
}

export class Ruler implements Twin {
  readonly #source: World;
  readonly #world: World;
  readonly #mirror: Mirror;
  /** Copies by the slot of the body. */
  readonly #copies = new Map<number, Copy>();
  /**
   * By the index of a copied shape: the original shape, and its kind (lowest bit of `category`), to
   * which rules apply.
   */
  readonly #originals = new Map<number, { id: ShapeId; kind: number }>();
  /** Whether the ruler's world has a listener that vetoes contacts. */
  #vetoes = false;
  /** All bits of `category` that shapes have had. */
  #categories = 0;
  /** The measured world's pair filter. */
  #filter: PairFilter | undefined;
  /**
   * For each pair of shapes (`keyOf`) with a contact in the measured world, whether that has
   * points.
   */
  readonly #held = new Map<string, boolean>();
  /** The pairs of kinds (`keyOf`) with a one-way rule. */
  readonly #oneWay = new Set<string>();

  /**
   * `lengthScale` is that of the measured world. `known`, if given, tells which methods were
   * called, so that filters need not be compared if none was set.
   */
  constructor(
    world: World,
    lengthScale = 1,
    private readonly known?: Pick<WorldRecord, "called">,
  ) {
    this.#source = world;
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

  /** Number of bodies that have shapes. */
  get bodies(): number {
    return this.#copies.size;
  }

  /** Brings the copies up to date: bodies, shapes, terrain and filters. */
  sync(): void {
    this.#mirror.sync();
    if (this.known?.called.has("setFilter") === false) return;
    for (const { shapes } of this.#copies.values())
      for (const made of shapes.values()) {
        const { category, mask, group } = this.#source.shapeStateOf(this.#original(made));
        const own = this.#world.shapeStateOf(made);
        if (category === own.category && mask === own.mask && group === own.group) continue;
        this.#world.setFilter(made, { category, mask, group });
        this.#originals.get(made.index)!.kind = kindOf(category);
        this.#categories |= category;
      }
  }

  /** The largest overlap of `overlap`. */
  penetration(poses: Float32Array, originX = 0, originY = 0): number {
    return this.overlap(poses, originX, originY).worst;
  }

  /**
   * The largest overlap, and the mean over all contact points, in the world's units; 0 without
   * contacts. `poses` are those of World.poses or Box2DWorld.poses, relative to the origin. Bodies
   * without a pose stay where they were.
   */
  overlap(poses: Float32Array, originX = 0, originY = 0): { worst: number; mean: number } {
    for (const [slot, copy] of this.#copies) {
      const [x, y, cosine, sine] = poses.subarray(4 * slot, 4 * slot + 4);
      if (!(Number.isFinite(x) && Number.isFinite(y))) continue;
      this.#put(copy, originX + x, originY + y, cosine, sine);
    }
    this.#leaveOut();
    this.#world.step();
    const { penetrationMax, penetrationMean } = this.#world.stepError();
    // A separation is a negative depth; where bodies just touch it may be -0.
    return { worst: Math.max(0, penetrationMax), mean: Math.max(0, penetrationMean) };
  }

  /** Excludes the pairs that do not collide in the measured world. */
  #leaveOut(): void {
    const { filter, prologue } = this.#source.engine.callbacks.of(this.#source.address);
    if (filter !== this.#filter) {
      this.#filter = filter;
      this.#world.setPairFilter(
        filter ? (a, b) => filter(this.#original(a), this.#original(b)) : null,
      );
    }
    this.#copyRules();
    const asks = prologue !== undefined || this.#oneWay.size > 0;
    if (asks) this.#findHeld();
    if (asks !== this.#vetoes) this.#world.setListeners(asks ? { prologue: this.#veto } : null);
    this.#vetoes = asks;
  }

  /** Copies rules that exclude pairs, and notes one-way rules. */
  #copyRules(): void {
    const kinds = bitsOf(this.#categories);
    this.#oneWay.clear();
    for (const [i, first] of kinds.entries())
      for (const second of kinds.slice(i)) {
        const kind = this.#source.rule(first, second)?.kind;
        const ignored = this.#world.rule(first, second) !== null;
        if (ignored !== (kind === "ignore"))
          this.#world.setRule(first, second, ignored ? null : { kind: "ignore" });
        if (kind === "oneWay") this.#oneWay.add(keyOf(first, second));
      }
  }

  /** Notes which contacts of the measured world have points. */
  #findHeld(): void {
    this.#held.clear();
    const { length, pointCount, shapeA, shapeB } = CONTACT_ROW;
    for (const body of this.#source.bodies()) {
      const rows = this.#source.contactViewOf(body);
      for (let at = 0; at < rows.length; at += length)
        this.#held.set(keyOf(rows[at + shapeA] - 1, rows[at + shapeB] - 1), rows[at + pointCount] > 0);
    }
  }

  /** Vetoes the contacts that the measured world lets pass. */
  readonly #veto: Listener = (rows, count) => {
    const { length, shapeA, shapeB, collide } = LISTENED_ROW;
    for (let at = 0; at < count * length; at += length) {
      const [a, b] = [shapeA, shapeB].map((side) => this.#originals.get(rows[at + side] - 1)!);
      // A pair that has only just come into contact has no contact in the measured world yet. It
      // counts, except where there is a one-way rule, which may let it pass.
      const isHeld = this.#held.get(keyOf(a.id.index, b.id.index)) ?? !this.#oneWay.has(keyOf(a.kind, b.kind));
      if (!isHeld) rows[at + collide] = 0;
    }
  };

  /** The measured shape of a copied one. */
  #original(copy: ShapeId): ShapeId {
    return this.#originals.get(copy.index)!.id;
  }

  /** Sets the pose of a copy. */
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

  addShape(body: BodyId, id: ShapeId, state: ShapeState, terrain: Terrain | null): void {
    const copy = this.#copy(body);
    const made = this.#createShape(copy.id, state, terrain);
    copy.shapes.set(id.index, made);
    this.#originals.set(made.index, { id, kind: kindOf(state.category) });
    this.#categories |= state.category;
  }

  #createShape(body: BodyId, state: ShapeState, terrain: Terrain | null): ShapeId {
    const { body: _, ...options } = state;
    if (options.kind === "circle") return this.#world.createCircle(body, options);
    if (options.kind === "aabb") return this.#world.createAabb(body, options);
    if (options.kind === "obb") return this.#world.createObb(body, options);
    return this.#world.createTerrain(body, terrain!, options);
  }

  finishBody(): void {}

  changeShape(id: ShapeId): void {
    const state = this.#source.shapeStateOf(id);
    if (state.kind === "terrain") return;
    this.removeShape(state.body, id);
    this.addShape(state.body, id, state, null);
  }

  changeBody(id: BodyId): void {
    this.#world.setKind(this.#copy(id).id, this.#source.bodyStateOf(id).kind);
  }

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

/** A key of an unordered pair of numbers. */
function keyOf(a: number, b: number): string {
  return a < b ? `${a} ${b}` : `${b} ${a}`;
}

/** The kind of a shape for rules: the lowest bit of its category. */
function kindOf(category: number): number {
  return (category & -category) >>> 0;
}

/** The bits that are set, each as a number. */
function bitsOf(bits: number): number[] {
  const found: number[] = [];
  for (let i = 0; i < 32; i++) if (bits & (1 << i)) found.push((1 << i) >>> 0);
  return found;
}
