/**
 * Records the running scene: it is built once more, in an engine that records, and makes the steps
 * that the history keeps again, with the visitor's commands. So recording costs nothing while a
 * scene runs, and what was seen can be recorded afterwards. The last hash is compared with that of
 * the running world, unless its last step has failed. Imported when the first recording is made.
 */
import type { Engine } from "thud";
import { load } from "thud/first";
import { Recorder } from "thud/recording";
import { Playback, Played, type Shown, SHOWN } from "./playback";
import type { Recorded } from "./protocol";
import type { Session } from "./session";
import { describe } from "./stage";
import { SceneError } from "./trouble";

/**
 * Bytes that all hashes of single bodies may take; every hash of the world comes with 2 bytes for
 * each body. Chosen.
 */
const HASH_BYTES = 2 ** 20;
/** Steps from one keyframe to the next. Chosen: a second at 60 steps a second. */
const KEYFRAME_STEPS = 60;
/** Milliseconds between two reports. Chosen. */
const REPORT = 200;
/**
 * The generations of a body's handle in two worlds differ by 2654435769 times the number of worlds
 * that were made between them (td_tag in engine/src/state/handles.h). This is the inverse of that
 * factor modulo 2^32.
 */
const INVERSE = 0x144cbc89;
/**
 * A larger number of worlds is not believed: the two handles are not of one body. Chosen far above
 * those of a visit.
 */
const MOST_WORLDS = 100_000;

/**
 * Records `session`. `build` builds its scene once more; `report` is called with the share that is
 * done, 0 to 1.
 */
export async function record(
  session: Session,
  wasm: string,
  build: (engine: Engine) => Promise<Session>,
  report: (part: number) => void,
): Promise<Recorded> {
  if (session instanceof Playback)
    throw new SceneError({ message: "This is a recording already. A fork of it can be recorded." });
  let again = await build(await load(wasm));
  try {
    // The code of a scene keeps handles, which have the number of their world: it has to be the
    // same as that of the world that runs. An engine of its own counts anew.
    const missing = again instanceof Played ? 0 : worldsBetween(session, again);
    if (missing > 0) {
      again.close();
      const engine = await load(wasm);
      for (let i = 0; i < missing; i++) engine.createWorld().close();
      again = await build(engine);
    }
    makeReady(again);
    session.startIn(again);
    return repeat(session, again, report);
  } finally {
    again.close();
  }
}

/**
 * Prepares a world for parts of a snapshot that the scene itself never makes, such as the joint by
 * which the visitor pulls a body.
 */
function makeReady({ world }: Session): void {
  world.useJoints();
  world.useRules();
  world.useTextures();
}

/**
 * The number of worlds that were made between that of `again`, which was just built, and that of
 * `session`, by the handles of a body before and after `again` takes the state of `session`. Bodies
 * whose slots have been used again since say nothing; 0 if this is so for all bodies.
 */
function worldsBetween(session: Session, again: Session): number {
  const { world } = again;
  const built = new Map(world.bodies().map(({ index, generation }) => [index, generation]));
  makeReady(again);
  world.restore(session.history.before(session.history.first)!.world);
  for (const { index, generation } of world.bodies()) {
    const before = built.get(index);
    if (before === undefined) continue;
    const worlds = Math.imul(generation - before, INVERSE) >>> 0;
    if (worlds < MOST_WORLDS) return worlds;
  }
  return 0;
}

function repeat(session: Session, again: Session, report: (part: number) => void): Recorded {
  const { world } = again;
  const { first } = session.history;
  const steps = session.step - first;
  const hashBytes = 2 * steps * world.stats().bodies;
  const shown: Shown = { view: describe(session).view, lengthScale: session.lengthScale };
  const recorder = new Recorder(world, {
    hashSteps: Math.max(1, Math.ceil(hashBytes / HASH_BYTES)),
    bodyHashes: true,
    keyframeSteps: KEYFRAME_STEPS,
    queries: true,
  });
  let reported = performance.now();
  try {
    recorder.chunk(SHOWN, new TextEncoder().encode(JSON.stringify(shown)));
    session.repeatIn(again, (step) => {
      if (performance.now() - reported < REPORT) return;
      reported = performance.now();
      report((step - first) / steps);
    });
    if (!session.broken && world.hash() !== session.world.hash())
      throw new SceneError({
        message:
          "This scene does not repeat itself, so it cannot be recorded: its update may depend " +
          "on the world, its state and the input alone.",
      });
    return { bytes: recorder.bytes(), steps };
  } finally {
    recorder.end();
  }
}
