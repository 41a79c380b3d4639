/**
 * Runs Box2D beside whichever scene runs, for as long as the page wants it. Loads Box2D when it is
 * first wanted. A companion is a copy of the session's world in another engine, which makes the
 * same steps; a session has at most one (session.ts).
 */
import type { Engine } from "thud";
import type { Box2DCompanion } from "../box2d/companion";
import { messageOf } from "../shared/error";
import type { Box2DRequest } from "./protocol";
import type { Session } from "./session";
import { recordOf, watchWorlds } from "./watch";

export class CompanionKeeper {
  /** What the page asked for last; null: no Box2D. */
  #wanted: Box2DRequest | null = null;
  /** The session whose companion was settled last. */
  #session: Session | null = null;
  /** The class of companions; null until its module is loaded. */
  #companionClass: typeof Box2DCompanion | null = null;

  /**
   * To be called before any world is created, so that what a copy of it needs is recorded of every
   * world (watch.ts).
   */
  constructor(engine: Engine) {
    watchWorlds(engine);
  }

  /**
   * Starts, changes or ends Box2D beside the session; null: beside the next one that begins.
   * Throws if Box2D cannot be loaded; the scene then runs without it.
   */
  async want(wanted: Box2DRequest | null, session: Session | null): Promise<void> {
    this.#wanted = wanted;
    if (session) await this.#settle(session);
  }

  /**
   * To be called when a scene begins. Does not throw: an error is kept in `session.box2dTrouble`.
   */
  async join(session: Session): Promise<void> {
    try {
      await this.#settle(session);
    } catch (error) {
      session.box2dTrouble = messageOf(error);
    }
  }

  /** Makes the session's companion what `#wanted` says. */
  async #settle(session: Session): Promise<void> {
    this.#session = session;
    const wanted = this.#wanted;
    const { companion } = session;
    session.box2dTrouble = null;
    if (!wanted) {
      session.companion = null;
      companion?.end();
      return;
    }
    if (this.#companionClass && companion instanceof this.#companionClass) {
      companion.applyRequest(wanted);
      return;
    }
    // Once Box2D is loaded, these two awaits resolve before the next message of the page, and so
    // before the next step: both engines begin with it.
    this.#companionClass ??= (await import("../box2d/companion")).Box2DCompanion;
    const record = recordOf(session.world);
    const loaded = await this.#companionClass.load(session, record, wanted);
    // While Box2D was loading, another scene may have begun, or the page may have changed its
    // request; a later call then settles that. A companion without a step has copied nothing, and
    // needs no end.
    if (this.#session === session && this.#wanted === wanted) session.companion = loaded;
  }
}
