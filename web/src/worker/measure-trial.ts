/**
 * A scene that one engine runs in order to be measured, without a visitor's commands, history or
 * drawing.
 */
import type { Engine, World } from "thud";
import type { Box2D } from "../box2d/load";
import { Ruler } from "../box2d/ruler";
import { Box2DWorld } from "../box2d/world";
import { type Input, noKeys } from "../scene/scene";
import { BODY, KINEMATIC, ROW } from "../scene/shape-table";
import type { Box2DSetting } from "./measure-settings";
import type { SceneRequest } from "./protocol";
import type { Session } from "./session";
import { recordOf, type Watched } from "./watch";

/** What measuring gets from the worker. */
export interface Laboratory {
  engine: Engine;
  /** Null if Box2D could not be loaded; thud is then measured alone. */
  box2d: Box2D | null;
  open(request: SceneRequest): Promise<Session>;
}

/** The input of each step: no keys, no pointer. */
const IDLE: Pick<Input, "held" | "pointer"> = {
  held: noKeys(),
  pointer: null,
};

export class Trial {
  readonly #session: Session;
  readonly #box2dWorld: Box2DWorld | null;
  /** Whether `step` and `overlap` measure Box2D (true) or thud. */
  readonly #measuresBox2D: boolean;
  readonly #watched: Watched | undefined;
  /** Whether each engine can run without the other. */
  readonly #alone: boolean;
  #ruler: Ruler | null = null;
  #step = 0;

  /**
   * Opens the scene. With `setting`, Box2D is measured; without, thud. `sleep`: bodies fall asleep
   * as the scene lets them; else none does.
   */
  static async open(
    { box2d, open }: Laboratory,
    request: SceneRequest,
    setting?: Box2DSetting,
    sleep = false,
  ): Promise<Trial> {
    const session = await open(request);
    return new Trial(session, box2d, recordOf(session.world), setting, sleep);
  }

  private constructor(
    session: Session,
    box2d: Box2D | null,
    watched: Watched | undefined,
    setting: Box2DSetting | undefined,
    sleep: boolean,
  ) {
    this.#session = session;
    this.#watched = watched;
    this.#measuresBox2D = setting !== undefined;
    // The copy in Box2D follows what the scene's code and thud do to kinematic bodies. Where there
    // is any, both engines must run to measure Box2D; and both run to measure thud, too, because
    // each engine evicts the other's data from the processor's caches.
    this.#alone = !session.scene.update && !session.scene.stepped && !hasKinematic(session.world);
    this.#box2dWorld =
      box2d && (setting || !this.#alone)
        ? new Box2DWorld(box2d, session.world, { ...watched, ...setting })
        : null;
    watched?.forwardTo(this.#box2dWorld);
    if (sleep) return;
    // A step in which all bodies sleep does not show what an engine can do.
    session.world.setSleeping(false);
    this.#box2dWorld?.setSleeping(false);
  }

  close(): void {
    this.#watched?.forwardTo(null);
    this.#ruler?.close();
    this.#box2dWorld?.close();
    this.#session.close();
  }

  /** Number of bodies of the thud world. */
  get bodies(): number {
    return this.#session.world.stats().bodies;
  }

  get world(): World {
    return this.#session.world;
  }

  get size(): number {
    return this.#session.size;
  }

  /** What the scene has and Box2D is not given; empty where Box2D does not run. */
  get misses(): string[] {
    return this.#box2dWorld?.misses ?? [];
  }

  get timeStep(): number {
    return this.#session.timeStep;
  }

  /** Makes a step. Returns the milliseconds of the measured engine's step alone. */
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

  /**
   * The deepest and the mean overlap, in length scales, computed by the same geometry for both
   * engines.
   */
  overlap(): { worst: number; mean: number } {
    const { world, scene, lengthScale } = this.#session;
    const { x, y } = scene.view ?? { x: 0, y: 0 };
    const ruler = (this.#ruler ??= new Ruler(world, lengthScale, this.#watched));
    ruler.sync();
    const poses = this.#measuresBox2D ? this.#box2dWorld!.poses(1, x, y) : world.poses(1, x, y);
    const { worst, mean } = ruler.overlap(poses, x, y);
    return { worst: worst / lengthScale, mean: mean / lengthScale };
  }

  /**
   * The deepest overlap that thud itself reports of the last step, in length scales; null for
   * Box2D, which reports none.
   */
  get ownReport(): number | null {
    const { world, lengthScale } = this.#session;
    return this.#measuresBox2D ? null : Math.max(0, world.stepError().penetrationMax) / lengthScale;
  }
}

function hasKinematic(world: World): boolean {
  const { rows, count } = world.shapeTable();
  for (let row = 0; row < count; row++) if (rows[row * ROW + BODY] === KINEMATIC) return true;
  return false;
}

/**
 * Makes steps of each engine for so many milliseconds: browsers compile WebAssembly to faster code
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
