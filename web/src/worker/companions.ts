/**
 * Runs Box2D beside whichever scene runs, for as long as the page wants it. Loads Box2D when it is
 * first wanted.
 */
import type { Engine } from "thud";
import type { Box2DCompanion } from "../box2d/companion";
import { messageOf } from "../shared/error";
import type { Box2DRequest } from "./protocol";
import type { Session } from "./session";
import { knownOf, watchWorlds } from "./watch";

export class Companions {
  /** What the page asked for last; null: no Box2D. */
  #wanted: Box2DRequest | null = null;
  #session: Session | null = null;
  #kind: typeof Box2DCompanion | null = null;

  /** To be called before any world is created, so that every world is watched. */
  constructor(engine: Engine) {
    watchWorlds(engine);
  }

  /**
   * Starts, changes or ends Box2D beside the session. Throws if Box2D cannot be loaded; the scene
   * then runs without it.
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
    session.box2dTrouble = null;
    if (!wanted) {
      const { companion } = session;
      session.companion = null;
      companion?.end();
      return;
    }
    // Once Box2D is loaded, nothing below takes time, so both engines begin with the same step.
    this.#kind ??= (await import("../box2d/companion")).Box2DCompanion;
    const companion = await this.#kind.load(session, knownOf(session.world), wanted);
    // While Box2D was loading, another scene may have begun, or the page may have changed its
    // request.
    if (this.#session !== session || this.#wanted !== wanted) companion.end();
    else if (session.companion instanceof this.#kind) session.companion.choose(wanted);
    else session.companion = companion;
  }
}
