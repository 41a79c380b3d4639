/** Keeps Box2D beside whichever scene runs while the page wants it; loads it when first wanted. */
import type { Engine } from "thud";
import type { Box2DCompanion } from "../box2d/companion";
import { messageOf } from "../shared/error";
import type { Box2DRequest } from "./protocol";
import type { Session } from "./session";
import { knownOf, watchWorlds } from "./watch";

export class Companions {
  #wanted: Box2DRequest | null = null;
  #session: Session | null = null;
  #kind: typeof Box2DCompanion | null = null;

  /** Before any world is made. */
  constructor(engine: Engine) {
    watchWorlds(engine);
  }

  /** Throws if Box2D cannot be loaded; what runs then goes on alone. */
  async want(wanted: Box2DRequest | null, session: Session | null): Promise<void> {
    this.#wanted = wanted;
    if (session) await this.#settle(session);
  }

  /** A scene begins. */
  async join(session: Session): Promise<void> {
    try {
      await this.#settle(session);
    } catch (error) {
      session.box2dTrouble = messageOf(error);
    }
  }

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
    // Once it is there nothing is waited for, so that the two begin with the same step.
    this.#kind ??= (await import("../box2d/companion")).Box2DCompanion;
    const companion = await this.#kind.load(session, knownOf(session.world), wanted);
    // Meanwhile another scene may have begun, or the panel may have been closed.
    if (this.#session !== session || this.#wanted !== wanted) companion.end();
    else if (session.companion instanceof this.#kind) session.companion.choose(wanted);
    else session.companion = companion;
  }
}
