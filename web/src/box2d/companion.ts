/**
 * Runs Box2D beside a scene: a copy of the scene's world that is given the same commands, makes the
 * same steps, and is measured by the same code. The copy is made at the beginning of the first
 * step, and made anew at the first step after a jump in time.
 */
import type { Vec2 } from "thud";
import type { Box2DSample, Compared } from "../scene/frame";
import { messageOf } from "../shared/error";
import { type Blast, explode } from "../worker/hands";
import type { Box2DRequest } from "../worker/protocol";
import type { Companion, Session } from "../worker/session";
import type { Watched } from "../worker/watch";
import { type Box2D, forgetBox2D, loadBox2D } from "./load";
import { middleOf } from "./places";
import { Ruler } from "./ruler";
import { Box2DWorld } from "./world";

/** Contact frequency in Hz: Box2D's default. */
const CONTACT_HERTZ = 30;
/**
 * Milliseconds per step that the comparison of both engines may take on average, and largest number
 * of steps between two comparisons. Chosen.
 */
const COMPARING = 2;
const LONGEST = 60;

/** Box2D's copy of the world, and what is needed to compare the two. */
interface Pair {
  box2dWorld: Box2DWorld;
  /** Measures overlaps in the thud world. The Box2DWorld has a ruler of its own. */
  ruler: Ruler;
  /**
   * A place near the bodies. Overlaps are measured relative to it, so that poses are exact as
   * floats.
   */
  origin: Vec2;
  /** The step at which the copy was made. */
  since: number;
  /** The step from which on the two are compared again. */
  nextComparison: number;
}

/** Implements the companion of a session; the interface says when each method is called. */
export class Box2DCompanion implements Companion {
  #pair: Pair | null = null;

  /** Loads Box2D. Throws if that fails, or if nothing was recorded of the world. */
  static async load(
    session: Session,
    record: Watched | undefined,
    request: Box2DRequest,
  ): Promise<Box2DCompanion> {
    if (!record) throw new Error("The world was made before Box2D could watch it.");
    return new Box2DCompanion(await loadBox2D(), session, record, request);
  }

  private constructor(
    private readonly box2d: Box2D,
    private readonly session: Session,
    private readonly record: Watched,
    private request: Box2DRequest,
  ) {}

  /** Takes the number of substeps from the request. */
  applyRequest(request: Box2DRequest): void {
    this.request = request;
    if (this.#pair) this.#pair.box2dWorld.substeps = request.substeps;
  }

  end(): void {
    const pair = this.#pair;
    this.#pair = null;
    this.record.forwardTo(null);
    pair?.ruler.close();
    pair?.box2dWorld.close();
  }

  begin(): void {
    if (this.#pair) return;
    this.#guard(() => {
      const { session, record } = this;
      const { world, lengthScale } = session;
      const box2dWorld = new Box2DWorld(this.box2d, world, {
        ...record,
        substeps: this.request.substeps,
        contactHertz: CONTACT_HERTZ,
      });
      this.#pair = {
        box2dWorld,
        ruler: new Ruler(world, lengthScale, record),
        origin: middleOf(world),
        since: session.step,
        nextComparison: session.step,
      };
      record.forwardTo(box2dWorld);
    });
  }

  apart(act: () => void): void {
    this.record.apart(act);
  }

  explode(blast: Blast): void {
    this.#use(({ box2dWorld }) => {
      const bodies = box2dWorld.within(blast.x, blast.y, blast.radius);
      explode(box2dWorld, bodies, blast);
    });
  }

  sync(): void {
    this.#use(({ box2dWorld }) => box2dWorld.sync());
  }

  step(): Box2DSample | undefined {
    return this.#use((pair) => {
      const { box2dWorld, since } = pair;
      const milliseconds = box2dWorld.step();
      const { awakeBodies: awake, origin } = box2dWorld;
      const { misses } = box2dWorld;
      const sample: Box2DSample = { milliseconds, awake, since, origin, misses };
      const { step } = this.session;
      if (step < pair.nextComparison) return sample;
      const start = performance.now();
      const compared = { thud: this.#measureWorld(pair), box2d: measureBox2D(pair) };
      const [ours, theirs] = box2dWorld.jointGaps();
      if (ours) [compared.thud.jointGap, compared.box2d.jointGap] = [ours, theirs];
      const pause = Math.ceil((performance.now() - start) / COMPARING);
      pair.nextComparison = step + Math.min(LONGEST, Math.max(1, pause));
      return { ...sample, compared };
    });
  }

  poses([x, y]: Vec2): { before: Float32Array; now: Float32Array } {
    const poses = this.#use(({ box2dWorld }) => {
      // Changes made while the scene is paused show at once.
      box2dWorld.sync();
      return { before: box2dWorld.poses(0, x, y), now: box2dWorld.poses(1, x, y) };
    });
    const { world } = this.session;
    return poses ?? { before: world.poses(0, x, y).slice(), now: world.poses(1, x, y).slice() };
  }

  #measureWorld({ ruler, origin: [x, y] }: Pair): Compared {
    const { world } = this.session;
    const { kineticEnergy, potentialEnergy } = world.measure();
    ruler.sync();
    return {
      penetration: ruler.penetration(world.poses(1, x, y), x, y),
      energy: kineticEnergy + potentialEnergy,
      bodies: ruler.bodies,
    };
  }

  #use<T>(act: (pair: Pair) => T): T | undefined {
    const pair = this.#pair;
    return pair ? this.#guard(() => act(pair)) : undefined;
  }

  /** Runs `act`. If it throws, the comparison ends and the scene goes on. */
  #guard<T>(act: () => T): T | undefined {
    try {
      return act();
    } catch (error) {
      const { session } = this;
      session.box2dTrouble = messageOf(error);
      session.companion = null;
      // After a trap no function of the WebAssembly module may be called, so nothing of it can be
      // freed. The module is dropped, and its memory with it.
      if (error instanceof WebAssembly.RuntimeError) {
        forgetBox2D();
        this.record.forwardTo(null);
        this.#pair?.ruler.close();
        this.#pair = null;
      } else this.end();
      return undefined;
    }
  }
}

function measureBox2D({ box2dWorld }: Pair): Compared {
  const [kinetic, potential] = box2dWorld.energy();
  return {
    penetration: box2dWorld.penetration(),
    energy: kinetic + potential,
    bodies: box2dWorld.bodies,
  };
}
