/**
 * Follows the bodies and shapes of a thud world, and tells a `Twin`, which keeps a copy of the
 * world, what was added, changed and removed since the last call of `sync`.
 */
import type { BodyId, BodyState, ShapeId, ShapeState, Terrain, World } from "thud";
import { BODY, bodyAt, ROW, shapeAt } from "../scene/shape-table";

/** A copy of a world: what is called when the world has changed. */
export interface Twin {
  addBody(id: BodyId, state: BodyState): void;
  addShape(body: BodyId, id: ShapeId, state: ShapeState, terrain: Terrain | null): void;
  /** Called after the last shape of a new body was added. */
  finishBody(id: BodyId, state: BodyState): void;
  /** The shape's size changed, or it became a sensor or ceased to be one. */
  changeShape(id: ShapeId): void;
  /** The body's kind changed. */
  changeBody(id: BodyId): void;
  removeShape(body: BodyId, id: ShapeId): void;
  /** The body was removed, and its shapes with it. */
  removeBody(id: BodyId): void;
}

/** A body with shapes. */
interface Member {
  id: BodyId;
  /** By index of the shape. */
  shapes: Map<number, ShapeId>;
}

/** A terrain, with its vertices at the last call. */
interface Ground {
  body: BodyId;
  id: ShapeId;
  terrain: Terrain;
}

export class Mirror {
  readonly #world: World;
  readonly #twin: Twin;
  #handles = new Uint32Array(0);
  /** The rows of the world's shape table at the last call. */
  #rows = new Float32Array(0);
  /** Bodies by slot, and their shapes, at the last call. */
  #members = new Map<number, Member>();
  /** Terrains at the last call, by index of the shape. */
  readonly #grounds = new Map<number, Ground>();

  constructor(world: World, twin: Twin) {
    this.#world = world;
    this.#twin = twin;
  }

  /** Tells the twin what changed. Bodies without shapes are not followed. */
  sync(): void {
    const { handles, rows, count } = this.#world.shapeTable();
    const sameShapes = equal(handles, this.#handles);
    if (!sameShapes || !equal(rows, this.#rows)) {
      const changed = this.#changed(handles, rows, count);
      this.#handles = handles.slice();
      this.#rows = rows.slice();
      if (!sameShapes) this.#follow(membersOf(this.#handles));
      for (const { body, shape, ofBody, ofShape } of changed) {
        if (ofBody) this.#twin.changeBody(body);
        if (ofShape) this.#twin.changeShape(shape);
      }
    }
    for (const ground of this.#grounds.values()) this.#followGround(ground);
  }

  /**
   * The shapes that existed at the last call and have another row now. `ofBody`: the body's kind
   * changed; `ofShape`: anything else did.
   */
  #changed(
    handles: Uint32Array,
    rows: Float32Array,
    count: number,
  ): { shape: ShapeId; body: BodyId; ofBody: boolean; ofShape: boolean }[] {
    const before = new Map<number, number>();
    for (let row = 0; 4 * row < this.#handles.length; row++)
      before.set(this.#handles[4 * row], row);
    const changed = [];
    for (let row = 0; row < count; row++) {
      const was = before.get(handles[4 * row]);
      if (was === undefined || this.#handles[4 * was + 1] !== handles[4 * row + 1]) continue;
      const [old, now] = [
        this.#rows.subarray(was * ROW, (was + 1) * ROW),
        rows.subarray(row * ROW, (row + 1) * ROW),
      ];
      if (equal(old, now)) continue;
      const ofShape = old.some((value, column) => column !== BODY && value !== now[column]);
      changed.push({
        shape: shapeAt(handles, row),
        body: bodyAt(handles, row),
        ofBody: old[BODY] !== now[BODY],
        ofShape,
      });
    }
    return changed;
  }

  /** Tells the twin which bodies and shapes came and went. */
  #follow(members: Map<number, Member>): void {
    const old = this.#members;
    this.#members = members;
    for (const [slot, was] of old) {
      const is = members.get(slot);
      if (is && same(is.id, was.id)) this.#removeShapes(was, is);
      else this.#removeBody(was);
    }
    for (const [slot, is] of members) {
      const was = old.get(slot);
      if (was && same(is.id, was.id)) this.#addShapes(was, is);
      else this.#addBody(is);
    }
  }

  #addBody(member: Member): void {
    const state = this.#world.bodyStateOf(member.id);
    this.#twin.addBody(member.id, state);
    for (const shape of member.shapes.values()) this.#addShape(member.id, shape);
    this.#twin.finishBody(member.id, state);
  }

  #removeBody(member: Member): void {
    for (const index of member.shapes.keys()) this.#grounds.delete(index);
    this.#twin.removeBody(member.id);
  }

  #removeShapes(was: Member, is: Member): void {
    for (const [index, shape] of was.shapes) {
      const left = is.shapes.get(index);
      if (left && same(left, shape)) continue;
      this.#grounds.delete(index);
      this.#twin.removeShape(was.id, shape);
    }
  }

  #addShapes(was: Member, is: Member): void {
    for (const [index, shape] of is.shapes) {
      const known = was.shapes.get(index);
      if (!known || !same(known, shape)) this.#addShape(is.id, shape);
    }
  }

  #addShape(body: BodyId, id: ShapeId): void {
    const state = this.#world.shapeStateOf(id);
    const terrain = state.kind === "terrain" ? this.#world.terrainOf(id) : null;
    if (terrain) this.#grounds.set(id.index, { body, id, terrain });
    this.#twin.addShape(body, id, state, terrain);
  }

  /** Makes a terrain anew if its vertices changed. */
  #followGround(ground: Ground): void {
    const { body, id } = ground;
    const terrain = this.#world.terrainOf(id);
    if (equalTerrains(terrain, ground.terrain)) return;
    ground.terrain = terrain;
    this.#twin.removeShape(body, id);
    this.#twin.addShape(body, id, this.#world.shapeStateOf(id), terrain);
  }
}

/** Bodies by slot, from the handles of a shape table. */
function membersOf(handles: Uint32Array): Map<number, Member> {
  const members = new Map<number, Member>();
  for (let row = 0; 4 * row < handles.length; row++) {
    const id = bodyAt(handles, row);
    let member = members.get(id.index);
    if (!member) members.set(id.index, (member = { id, shapes: new Map() }));
    const shape = shapeAt(handles, row);
    member.shapes.set(shape.index, shape);
  }
  return members;
}

function same(a: BodyId | ShapeId, b: BodyId | ShapeId): boolean {
  return a.index === b.index && a.generation === b.generation;
}

function equal(a: ArrayLike<number>, b: ArrayLike<number>): boolean {
  if (a.length !== b.length) return false;
  for (let i = 0; i < a.length; i++) if (a[i] !== b[i]) return false;
  return true;
}

/** Whether two terrains have the same vertices. A flat terrain never changes. */
function equalTerrains(a: Terrain, b: Terrain): boolean {
  if (a.kind === "uniform" && b.kind === "uniform") return equal(a.heights, b.heights);
  if (a.kind !== "irregular" || b.kind !== "irregular") return true;
  if (a.points.length !== b.points.length) return false;
  for (let i = 0; i < a.points.length; i++) if (!equal(a.points[i], b.points[i])) return false;
  return true;
}
