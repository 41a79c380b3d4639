/**
 * The worker in which physics runs, so that a slow step never blocks the page. It makes steps when
 * the page asks for them, and answers questions. It begins with each question when it arrives; one
 * that has to wait, as for a file, may be answered after later ones.
 */
import type { Engine } from "thud";
import { load } from "thud/first";
import { CompanionKeeper } from "./companion-keeper";
import { bringSums, Frames, readyFor, transferables } from "./frames";
import { importScene } from "./module";
import type { Progress, QuestionName, Questions, SceneRequest, ToPage, ToWorker } from "./protocol";
import type { Session } from "./session";
import { describe, setUp } from "./stage";
import { SceneError, troubleOf } from "./trouble";

/** Milliseconds of one tick, after which a frame is sent even if steps remain. Chosen. */
const PATIENCE = 24;

let engine: Engine;
let companionKeeper: CompanionKeeper;
let base: string;
let session: Session | null = null;
/** What the session was started with. */
let begun: SceneRequest;
let frames: Frames;
/** Number of scenes that were asked for. */
let runs = 0;

type Answers = {
  [Name in QuestionName]: (
    ask: Questions[Name]["ask"],
    report: (progress: Progress<Name>) => void,
  ) => Promise<Questions[Name]["answer"]> | Questions[Name]["answer"];
};

/** The functions that answer the page's questions; see `Questions` in protocol.ts. */
const answers: Answers = {
  async load({ wasm, rest, threads, page }) {
    base = page;
    engine =
      (threads && (await (await import("thud/threads")).loadThreads(threads))) ||
      (await load(new URL(wasm, page), rest && new URL(rest, page)));
    companionKeeper = new CompanionKeeper(engine);
    return engine.threads;
  },

  async complete() {
    await engine.complete();
    // The page works without these two: error messages are then shorter, and sums are not drawn.
    const explained = import("thud/explain").then(({ explainErrors }) => explainErrors());
    await Promise.allSettled([explained, bringSums()]);
  },

  async run(request) {
    const run = ++runs;
    const next = await open(request, run);
    await readyFor(next);
    if (run !== runs) {
      next.close();
      throw new Error("Another scene was asked for meanwhile.");
    }
    session?.close();
    session = next;
    begun = request;
    frames = new Frames(session);
    void companionKeeper.join(session);
    return describe(session);
  },

  choose({ quality, substeps, maxError }) {
    session?.do({ kind: "choose", quality, substeps, maxError });
  },

  seek({ step, look }) {
    const running = needSession();
    if (!running.seek(step))
      throw new Error(`Step ${step} is not kept any more, or has not been made.`);
    return frames.make(look);
  },

  box2d: (wanted) => companionKeeper.want(wanted, session),

  hash: () => needSession().hash,

  advance({ steps }) {
    const running = needSession();
    for (let i = 0; i < steps; i++) running.makeStep();
    return running.hash;
  },

  rerun: ({ steps }) => needSession().rerun(steps),

  async record({ wasm }, report) {
    const running = needSession();
    const [request, run] = [begun, runs];
    // Recording builds the scene once more, and a second instance of a match would take over its
    // connections.
    if (request.match) throw new SceneError({ message: "A match over a network cannot be recorded." });
    const { record } = await import("./record");
    return record(running, wasm, (engine) => open(request, run, engine), report);
  },

  listCalls: ({ on }) => needSession().listCalls(on),

  bisectionLimit: () => needSession().world.bisectionLimit(),

  async inspect({ slot }) {
    const { inspect } = await import("./inspect");
    const { world, step } = needSession();
    return inspect(world, step, slot);
  },

  async contacts({ slot }) {
    const { listContacts } = await import("./microscope");
    return listContacts(needSession(), slot);
  },

  async examine({ pair, step }) {
    const [{ examine }, geometry] = await Promise.all([
      import("./microscope"),
      import("thud/geometry"),
    ]);
    return examine(needSession(), engine, geometry, pair, step);
  },

  async runToContact() {
    const { runToContact } = await import("./microscope");
    return runToContact(needSession());
  },

  async measure(request, report) {
    const { measure, prepare } = await import("./measure-all");
    const { laboratory, withoutBox2D } = await prepare(engine, open);
    return measure(laboratory, request, withoutBox2D, report);
  },

  async prices(_, report) {
    const { measurePrices } = await import("./measure-prices");
    return measurePrices(engine, base, report);
  },

  async heavier({ scene, sizes, hertz }, report) {
    const { findHoldings, prepare } = await import("./measure-all");
    const { laboratory, withoutBox2D } = await prepare(engine, open);
    return { ...(await findHoldings(laboratory, scene, sizes, hertz, report)), withoutBox2D };
  },
};

/** Imports and sets up a scene, or opens a recording. `run`: 0 for one that is measured. */
async function open(request: SceneRequest, run = 0, within = engine): Promise<Session> {
  if (request.recording) return (await import("./playback")).play(request.recording, run);
  const module = await importScene(base, request.name, request.code);
  const readText = (file: string) => readFile(file, request.files);
  if (request.match) {
    const { play } = await import("./match");
    return play(run, module, within, request, readText);
  }
  return setUp(run, module, within, request, readText);
}

/** The running session. Throws if there is none. */
function needSession(): Session {
  if (!session) throw new Error("No scene runs.");
  return session;
}

/**
 * The text of a file, for a scene's `readText`: one of the visitor's files (`own`), or a file
 * within the page's folder. Throws for any other.
 */
async function readFile(
  file: string,
  own: Readonly<Record<string, string>> | undefined,
): Promise<string> {
  if (own && file in own) return own[file];
  if (file.startsWith("own/")) throw new Error(`${file} was not brought.`);
  const url = new URL(file, base);
  if (!url.href.startsWith(new URL(".", base).href))
    throw new Error(`${file} is not a file of this page.`);
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${file} cannot be loaded: ${response.status}`);
  return response.text();
}

function post(message: ToPage, transfer: ArrayBuffer[] = []): void {
  self.postMessage(message, { transfer });
}

/** Answers a question, with the trouble if it throws. */
async function answer(id: number, name: QuestionName, value: never): Promise<void> {
  try {
    const result = await answers[name](value, (progress) =>
      post({ kind: "progress", id, value: progress }),
    );
    const transfer = name === "seek" ? transferables(result as Questions["seek"]["answer"]) : [];
    post({ kind: "answer", id, value: result }, transfer);
  } catch (error) {
    post({ kind: "answer", id, trouble: troubleOf(error) });
  }
}

/** Makes steps up to number `until`, for PATIENCE milliseconds at most. */
function tick(running: Session, until: number): void {
  const end = performance.now() + PATIENCE;
  while (running.step < Math.min(until, running.end) && performance.now() < end)
    running.makeStep();
}

self.onmessage = ({ data }: MessageEvent<ToWorker>) => {
  if (data.kind === "ask") {
    void answer(data.id, data.name, data.value as never);
    return;
  }
  if (!session) return;
  try {
    if (data.kind === "command") session.do(data.command);
    else {
      // A tick that the page sent before it knew of this scene is not for it: no steps are made.
      const start = performance.now();
      if (data.run === session.run) tick(session, data.until);
      const made = performance.now();
      const frame = frames.make(data.look);
      frame.spent = { steps: made - start, picture: performance.now() - made };
      post({ kind: "frame", frame }, transferables(frame));
    }
  } catch (error) {
    post({ kind: "trouble", run: session.run, trouble: troubleOf(error) });
  }
};
