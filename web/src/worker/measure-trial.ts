/** One engine running a scene to be measured, without a visitor's hands, history or drawing. */
import type { Engine, World } from "thud";
import type { Box2D } from "../box2d/load";
import { Ruler } from "../box2d/ruler";
import { Box2DWorld } from "../box2d/world";
import { type Input, noKeys } from "../scene/scene";
import { BODY, KINEMATIC, ROW } from "../scene/shape-table";
import type { Box2DSetting } from "./measure-settings";
import type { SceneRequest } from "./protocol";
import type { Session } from "./session";
import { knownOf, type Watched } from "./watch";

/** What measuring needs of the worker. */
export interface Laboratory {
  engine: Engine;
  /** Null: it could not be loaded, and thud is measured alone. */
  box2d: Box2D | null;
  open(request: SceneRequest): Promise<Session>;
}

const IDLE: Pick<Input, "held" | "pointer"> = {
  held: noKeys(),
  pointer: null,
};

export class Trial {
  readonly #session: Session;
  readonly #box2dWorld: Box2DWorld | null;
  /** Whether the times and overlaps asked for are Box2D's. */
  readonly #measuresBox2D: boolean;
  readonly #watched: Watched | undefined;
  /** Whether each engine can run without the other. */
  readonly #alone: boolean;
  #ruler: Ruler | null = null;
  #step = 0;

  /** With `setting` Box2D is measured, else thud. */
  static async open(
    { box2d, open }: Laboratory,
    request: SceneRequest,
    setting?: Box2DSetting,
  ): Promise<Trial> {
    const session = await open(request);
    return new Trial(session, box2d, knownOf(session.world), setting);
  }

  private constructor(
    session: Session,
    box2d: Box2D | null,
    watched: Watched | undefined,
    setting: Box2DSetting | undefined,
  ) {
    this.#session = session;
    this.#watched = watched;
    this.#measuresBox2D = setting !== undefined;
    // Box2D follows what the scene's code and thud do to kinematic bodies, so that both must run
    // there; then both do in thud's turn too, because each takes the other's place in the caches.
    this.#alone = !session.scene.update && !session.scene.stepped && !hasKinematic(session.world);
    this.#box2dWorld =
      box2d && (setting || !this.#alone)
        ? new Box2DWorld(box2d, session.world, { ...watched, ...setting })
        : null;
    watched?.forwardTo(this.#box2dWorld);
    // A step in which all sleeps says nothing of what an engine holds, or how quick it is.
    session.world.setSleeping(false);
    this.#box2dWorld?.setSleeping(false);
  }

  close(): void {
    this.#watched?.forwardTo(null);
    this.#ruler?.close();
    this.#box2dWorld?.close();
    this.#session.close();
  }

  get bodies(): number {
    return this.#session.world.stats().bodies;
  }

  get size(): number {
    return this.#session.size;
  }

  /** What Box2D is not given; empty where it does not run. */
  get misses(): string[] {
    return this.#box2dWorld?.misses ?? [];
  }

  get timeStep(): number {
    return this.#session.timeStep;
  }

  /** Milliseconds of the measured engine's step, and nothing else. */
  step(): number {
    const { scene, world } = this.#session;
    const box2dWorld = this.#box2dWorld;
    scene.update?.({ step: this.#step++, ...IDLE });
    box2dWorld?.sync();
    if (!this.#measuresBox2D || !this.#alone) world.step();
    const milliseconds = box2dWorld?.step() ?? 0;
    if (!this.#alone) scene.stepped?.();
    return this.#measuresBox2D ? milliseconds : 1000 * world.stats().stepSeconds;
  }

  /** In length scales, by the same geometry for both engines. */
  overlap(): { worst: number; mean: number } {
    const { world, scene, lengthScale } = this.#session;
    const { x, y } = scene.view ?? { x: 0, y: 0 };
    const ruler = (this.#ruler ??= new Ruler(world, lengthScale, this.#watched));
    ruler.sync();
    const poses = this.#measuresBox2D ? this.#box2dWorld!.poses(1, x, y) : world.poses(1, x, y);
    const { worst, mean } = ruler.overlap(poses, x, y);
    return { worst: worst / lengthScale, mean: mean / lengthScale };
  }

  /** What thud itself reports of the last step; of Box2D null, which has no such report. */
  get ownReport(): number | null {
    const { world, lengthScale } = this.#session;
    return this.#measuresBox2D ? null : Math.max(0, world.error().penetrationMax) / lengthScale;
  }
}

function hasKinematic(world: World): boolean {
  const { rows, count } = world.shapeTable();
  for (let row = 0; row < count; row++) if (rows[row * ROW + BODY] === KINEMATIC) return true;
  return false;
}

/**
 * Steps until so many milliseconds have passed: browsers translate WebAssembly anew, for speed,
 * only after it has run for a while.
 */
export async function warmUp(
  laboratory: Laboratory,
  request: SceneRequest,
  milliseconds: number,
): Promise<void> {
  for (const setting of laboratory.box2d ? [undefined, { substeps: 4 }] : [undefined]) {
    const trial = await Trial.open(laboratory, request, setting);
    try {
      const end = performance.now() + milliseconds;
      while (performance.now() < end) {
        trial.step();
        trial.overlap();
      }
    } finally {
      trial.close();
    }
  }
}
