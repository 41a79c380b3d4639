/**
 * Dragging of dynamic bodies with the pointers of a page: mouse, pen and any number of fingers. A body is
 * held by a target joint, whose other end is on a static body without shapes where the body was taken.
 */
import type { BodyId, JointId, Vec2 } from "../types.js";
import type { World } from "../world.js";

export interface DragOptions {
  /** The distance from a pointer within which a body is taken, a length. Default 0.2 length scales of the world. */
  reach?: number;
  /** The frequency of the joint's spring, Hz, which is critically damped. Default 5. */
  frequency?: number;
  /**
   * The maximum force of the spring, per mass of the body: length/s². It must be well above gravity. Default 400
   * length scales/s².
   */
  strength?: number;
  /** The category bits of shapes whose bodies may be dragged. Default all. */
  mask?: number;
}

/** A body that a pointer holds. */
interface Hold {
  body: BodyId;
  joint: JointId;
  holder: BodyId;
  /** The place where the body was taken: that of the holder. */
  start: Vec2;
}

/**
 * The damper of a held body's rotation, without which a body that hangs from the pointer keeps swinging: its
 * angular velocity decays at 2 damping (2 pi frequency) = 5/s.
 */
const TURN = { frequency: 0.05, damping: 8 };

/** Where a pointer is in an element: the parts of its width from the left and of its height from the top. */
export function partsOf(element: Element, { clientX, clientY }: { clientX: number; clientY: number }): Vec2 {
  const { left, top, width, height } = element.getBoundingClientRect();
  return [(clientX - left) / width, (clientY - top) / height];
}

/** Lets the pointers over an element drag the bodies of a world, until `end`. */
export class Drag {
  readonly #world: World;
  readonly #place: (event: PointerEvent) => Vec2;
  readonly #options: Required<DragOptions>;
  /** What is held, by the pointers' numbers. */
  readonly #holds = new Map<number, Hold>();
  /** Stops listening. */
  readonly #listening = new AbortController();

  /** `place`: the place of a pointer in the world. The element is no longer scrolled or zoomed by touch. */
  constructor(world: World, element: HTMLElement, place: (event: PointerEvent) => Vec2, options: DragOptions = {}) {
    this.#world = world;
    this.#place = place;
    const scale = world.lengthScale;
    const { reach = 0.2 * scale, frequency = 5, strength = 400 * scale, mask = -1 } = options;
    this.#options = { reach, frequency, strength, mask };
    const { signal } = this.#listening;
    const listen = (type: "pointerdown" | "pointermove" | "pointerup" | "pointercancel", act: (event: PointerEvent) => void) =>
      element.addEventListener(type, act, { signal });
    listen("pointerdown", (event) => {
      if (event.button === 0 && this.#take(event)) element.setPointerCapture(event.pointerId);
    });
    listen("pointermove", (event) => this.#move(event));
    for (const type of ["pointerup", "pointercancel"] as const)
      listen(type, ({ pointerId }) => this.#release(pointerId));
    element.style.touchAction = "none";
  }

  /** The bodies that are held now. */
  get bodies(): BodyId[] {
    return [...this.#holds.values()].map(({ body }) => body);
  }

  /** Releases all bodies and stops listening; to be called before the world is closed. */
  end(): void {
    this.#listening.abort();
    for (const pointer of this.#holds.keys()) this.#release(pointer);
  }

  #take(event: PointerEvent): boolean {
    const world = this.#world;
    const start = this.#place(event);
    const body = this.#bodyAt(start);
    this.#release(event.pointerId);
    if (!body) return false;
    const { frequency, strength } = this.#options;
    const spring = { frequency, damping: 1, springForce: strength * world.bodyStateOf(body).mass };
    const holder = world.createBody({ position: start });
    let joint;
    try {
      joint = world.createJoint({ kind: "target", bodyA: holder, bodyB: body, at: start, along: spring, across: spring, turn: TURN });
    } catch (error) {
      world.destroy(holder);
      throw error;
    }
    this.#holds.set(event.pointerId, { body, joint, holder, start });
    return true;
  }

  /** The dynamic body with the shape that is closest to a place, or deepest around it; null for none in reach. */
  #bodyAt(center: Vec2): BodyId | null {
    const world = this.#world;
    const { reach: radius, mask } = this.#options;
    const found = world
      .overlap({ kind: "circle", center, radius }, { mask })
      .map((shape) => ({ body: world.shapeStateOf(shape).body, distance: world.closestPointOf(shape, center).distance }))
      .filter(({ body }) => world.bodyStateOf(body).kind === "dynamic" && !world.bodyStateOf(body).quarantined)
      .sort((a, b) => a.distance - b.distance);
    return found[0]?.body ?? null;
  }

  #move(event: PointerEvent): void {
    const hold = this.#holds.get(event.pointerId);
    if (!hold || !this.#world.isValid(hold.joint)) return;
    const [x, y] = this.#place(event);
    this.#world.setJointFrame(hold.joint, "a", { position: [x - hold.start[0], y - hold.start[1]] });
  }

  #release(pointer: number): void {
    const hold = this.#holds.get(pointer);
    this.#holds.delete(pointer);
    if (hold && this.#world.isValid(hold.holder)) this.#world.destroy(hold.holder); // and the joint with it
  }
}
