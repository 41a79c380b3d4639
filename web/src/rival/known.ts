/** What a rival is told of the world that it copies. */
import type { BodyId, BodyOptions, WorldOptions } from "thud";

/** What a thud world does not tell of itself; watch.ts collects it. */
export interface Known {
  /** What it was made with, or has been set to since. */
  options: WorldOptions;
  /** What its bodies were made with: their damping, sleep and detection count. */
  bodyOptions(body: BodyId): BodyOptions | undefined;
  /** Another number whenever bodies, shapes or ground changed. */
  changes(): number;
}

/** What is not known is taken to be the default, and `sync` looks through everything. */
export interface RivalSettings extends Partial<Known> {
  /** A step. Default 4, as Box2D's manual recommends. */
  substeps?: number;
  /** Of contacts, Hz. Default 30, Box2D's own; it takes at most an eighth of its substep rate. */
  contactHertz?: number;
}
