/**
 * Measures how deep bodies overlap, whichever engine has moved them, with the same geometry: a thud
 * world of its own holds copies of the bodies, is given their poses, and runs a step of a
 * nanosecond without gravity, in which contacts are found and nothing moves.
 *
 * Pairs that the measured world lets through do not count, in neither engine: those that a rule or
 * the scene's own filter keeps apart are none here either; what a listener lets pass at the moment
 * is a contact without points there; and of a one-way rule what is held is a contact with points.
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
import type { Known } from "../worker/watch";
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
  readonly #source: World;
  readonly #world: World;
  readonly #mirror: Mirror;
  /** By the slot of the body that it copies. */
  readonly #copies = new Map<number, Copy>();
  /** By the index of a copied shape, the original; its kind as rules have it. */
  readonly #originals = new Map<number, { id: ShapeId; kind: number }>();
  #vetoes = false;
  /** Bits of `category` that shapes have had. */
  #categories = 0;
  /** As the measured world has it; what it answers may change with it alone. */
  #filter: PairFilter | undefined;
  /** Pairs of the measured world's contacts, by `keyOf`: whether it holds them at present. */
  readonly #held = new Map<string, boolean>();
  /** Kinds between which there is a one-way rule, by `keyOf`. */
  readonly #oneWay = new Set<string>();

  /** `lengthScale` is the one of the world that it measures; `known` spares it looks. */
  constructor(
    world: World,
    lengthScale = 1,
    private readonly known?: Pick<Known, "called">,
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

  /** Bodies that have shapes. */
  get bodies(): number {
    return this.#copies.size;
  }

  /** Follows bodies that came or went and ground that was dug. */
  sync(): void {
    this.#mirror.sync();
    if (this.known?.called.has("setFilter") === false) return;
    for (const { shapes } of this.#copies.values())
      for (const made of shapes.values()) {
        const { category, mask, group } = this.#source.shapeState(this.#original(made));
        const own = this.#world.shapeState(made);
        if (category === own.category && mask === own.mask && group === own.group) continue;
        this.#world.setFilter(made, { category, mask, group });
        this.#originals.get(made.index)!.kind = kindOf(category);
        this.#categories |= category;
      }
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
    this.#leaveOut();
    this.#world.step();
    const { penetrationMax, penetrationMean } = this.#world.error();
    // Separation is a negative depth, and touching may be a negative zero.
    return { worst: Math.max(0, penetrationMax), mean: Math.max(0, penetrationMean) };
  }

  /** What the measured world lets through. */
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

  #copyRules(): void {
    const kinds = bitsOf(this.#categories);
    this.#oneWay.clear();
    for (const [i, first] of kinds.entries())
      for (const second of kinds.slice(i)) {
        const meeting = this.#source.rule(first, second)?.meeting;
        const ignored = this.#world.rule(first, second) !== null;
        if (ignored !== (meeting === "ignore"))
          this.#world.setRule(first, second, ignored ? null : { meeting: "ignore" });
        if (meeting === "oneWay") this.#oneWay.add(keyOf(first, second));
      }
  }

  #findHeld(): void {
    this.#held.clear();
    const { length, pointCount, shapeA, shapeB } = CONTACT_ROW;
    for (const body of this.#source.bodies()) {
      const rows = this.#source.contactView(body);
      for (let at = 0; at < rows.length; at += length)
        this.#held.set(keyOf(rows[at + shapeA] - 1, rows[at + shapeB] - 1), rows[at + pointCount] > 0);
    }
  }

  readonly #veto: Listener = (rows, count) => {
    const { length, shapeA, shapeB, collide } = LISTENED_ROW;
    for (let at = 0; at < count * length; at += length) {
      const [a, b] = [shapeA, shapeB].map((side) => this.#originals.get(rows[at + side] - 1)!);
      // What has only just begun to touch is in no list yet: a one-way rule may let it pass.
      const isHeld = this.#held.get(keyOf(a.id.index, b.id.index)) ?? !this.#oneWay.has(keyOf(a.kind, b.kind));
      if (!isHeld) rows[at + collide] = 0;
    }
  };

  #original(copy: ShapeId): ShapeId {
    return this.#originals.get(copy.index)!.id;
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
    const state = this.#source.shapeState(id);
    if (state.kind === "terrain") return;
    this.removeShape(state.body, id);
    this.addShape(state.body, id, state, null);
  }

  changeBody(id: BodyId): void {
    this.#world.setKind(this.#copy(id).id, this.#source.bodyState(id).kind);
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

/** Of two, whichever comes first. */
function keyOf(a: number, b: number): string {
  return a < b ? `${a} ${b}` : `${b} ${a}`;
}

/** The lowest bit. */
function kindOf(category: number): number {
  return (category & -category) >>> 0;
}

function bitsOf(bits: number): number[] {
  const found: number[] = [];
  for (let i = 0; i < 32; i++) if (bits & (1 << i)) found.push((1 << i) >>> 0);
  return found;
}
