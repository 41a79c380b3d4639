/**
 * Box2D beside one running scene: a copy of its world, which takes the same commands, makes the
 * same steps, and is measured by the same code. It begins, and after a jump in time begins anew,
 * with the first step that is made, from what the world is then.
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

/** Of contacts, Hz: Box2D's own. */
const CONTACT_HERTZ = 30;
/** Milliseconds a step that comparing may take on average, and steps between two at most. */
const COMPARING = 2;
const LONGEST = 60;

/** What there is while Box2D runs along. */
interface Pair {
  box2dWorld: Box2DWorld;
  /** Of the thud world; the other has its own. */
  ruler: Ruler;
  /** Near the bodies, so that their places are exact as floats. */
  origin: Vec2;
  since: number;
  /** The step at which the two are compared next. */
  nextComparison: number;
}

export class Box2DCompanion implements Companion {
  #pair: Pair | null = null;

  static async load(
    session: Session,
    known: Watched | undefined,
    request: Box2DRequest,
  ): Promise<Box2DCompanion> {
    if (!known) throw new Error("The world was made before Box2D could watch it.");
    return new Box2DCompanion(await loadBox2D(), session, known, request);
  }

  private constructor(
    private readonly box2d: Box2D,
    private readonly session: Session,
    private readonly known: Watched,
    private request: Box2DRequest,
  ) {}

  choose(request: Box2DRequest): void {
    this.request = request;
    if (this.#pair) this.#pair.box2dWorld.substeps = request.substeps;
  }

  end(): void {
    const pair = this.#pair;
    this.#pair = null;
    this.known.forwardTo(null);
    pair?.ruler.close();
    pair?.box2dWorld.close();
  }

  begin(): void {
    if (this.#pair) return;
    this.#guard(() => {
      const { session, known } = this;
      const { world, lengthScale } = session;
      const box2dWorld = new Box2DWorld(this.box2d, world, {
        ...known,
        substeps: this.request.substeps,
        contactHertz: CONTACT_HERTZ,
      });
      this.#pair = {
        box2dWorld,
        ruler: new Ruler(world, lengthScale, known),
        origin: middleOf(world),
        since: session.step,
        nextComparison: session.step,
      };
      known.forwardTo(box2dWorld);
    });
  }

  apart(act: () => void): void {
    this.known.apart(act);
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
      // What was done while the scene stands is seen before the next step.
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

  /** An error ends the comparison, and not the scene. */
  #guard<T>(act: () => T): T | undefined {
    try {
      return act();
    } catch (error) {
      const { session } = this;
      session.box2dTrouble = messageOf(error);
      session.companion = null;
      // After a trap nothing of the module can be used, and its memory goes with it.
      if (error instanceof WebAssembly.RuntimeError) {
        forgetBox2D();
        this.known.forwardTo(null);
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
