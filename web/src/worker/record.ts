/**
 * Records what runs: the scene is built once more, in the engine that records, and goes through the
 * steps that the history keeps, with the visitor's commands. So recording costs nothing while a
 * scene runs, and what was seen can be recorded afterwards. The last hash is compared with that of
 * the running world. Imported when the first recording is made.
 */
import type { Engine } from "thud";
import { Recorder } from "thud/recording";
import { Playback, recordedEngine, type Shown, SHOWN } from "./playback";
import type { Recorded } from "./protocol";
import type { Session } from "./session";
import { describe } from "./stage";
import { SceneError } from "./trouble";

/** Bytes that the hashes of bodies may take, of which each has 2 with each hash. Chosen. */
const HASH_BYTES = 2 ** 20;
/** Steps from one keyframe to the next. Chosen: a second at 60 steps a second. */
const KEYFRAME_STEPS = 60;
/** Milliseconds between two reports. Chosen. */
const REPORT = 200;

/** Records `session`, which `build` builds once more. `report` gets the part that is done. */
export async function record(
  session: Session,
  wasm: string,
  build: (engine: Engine) => Promise<Session>,
  report: (part: number) => void,
): Promise<Recorded> {
  if (session instanceof Playback)
    throw new SceneError({ message: "This is a recording already. A fork of it can be recorded." });
  const again = await build(await recordedEngine(wasm));
  try {
    return repeat(session, again, report);
  } finally {
    again.close();
  }
}

function repeat(session: Session, again: Session, report: (part: number) => void): Recorded {
  const { world } = again;
  // A snapshot may have what only the visitor's hand has brought, such as the joint of a pull.
  world.useJoints();
  world.useRules();
  world.useTextures();
  const { first } = session.history;
  const steps = session.step - first;
  const hashBytes = 2 * steps * world.stats().bodies;
  let recorder: Recorder | null = null;
  let reported = performance.now();
  try {
    session.repeatIn(
      again,
      () => {
        const shown: Shown = { view: describe(session).view, lengthScale: session.lengthScale };
        recorder = new Recorder(world, {
          hashSteps: Math.max(1, Math.ceil(hashBytes / HASH_BYTES)),
          bodyHashes: true,
          keyframeSteps: KEYFRAME_STEPS,
        });
        recorder.chunk(SHOWN, new TextEncoder().encode(JSON.stringify(shown)));
      },
      (step) => {
        if (performance.now() - reported < REPORT) return;
        reported = performance.now();
        report((step - first) / steps);
      },
    );
    if (world.hash() !== session.world.hash())
      throw new SceneError({
        message:
          "This scene does not repeat itself, so it cannot be recorded: its update may depend " +
          "on the world, its state and the input alone.",
      });
    return { bytes: recorder!.bytes(), steps };
  } finally {
    (recorder as Recorder | null)?.end();
  }
}
