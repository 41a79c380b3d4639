/**
 * Reports that the scene runs slower than real time, with the cause and what helps, for as long as
 * it does. Imported when that happens for the first time.
 */
import type { Frame } from "../scene/frame";
import { mean } from "../shared/step-times";
import type { App } from "./app";
import { byId, make } from "./dom";
import { duration } from "./format";
import { say } from "./messages";

/** Values of `Player.lag` at which the report appears and disappears; far enough from each other
 * that it does not flicker. Chosen. */
const MUCH = 0.2;
const LITTLE = 0.05;
/** Milliseconds between two changes of the text. Chosen. */
const EVERY = 1000;
/** Milliseconds for which the line shows the advice too. Chosen. */
const READ = 12_000;
/** Number of last frames from which the cause is found. Chosen. */
const LAST = 60;
/** Share of the real-time budget: a worker that needs less is not the cause. Chosen. */
const BUSY = 0.7;

/** The cause of slow motion. */
interface Why {
  /** Names the cause; each kind is announced with its advice once per scene. */
  kind: string;
  /** The cause in words. */
  short: string;
  advice: string;
}

/** Adds the line for the report to the page, and keeps it up to date. */
export function watch(app: App): void {
  const line = make("p", { id: "slow", class: "panel", hidden: true });
  byId("notice").after(line);
  let frames: Frame[] = [];
  /** When the text last changed, on the clock of performance.now(). */
  let shown = 0;
  /** Until this time the line shows the advice. */
  let whole = 0;
  /** Kinds of causes that were announced for this scene. */
  const told = new Set<string>();
  const hide = () => (line.hidden = true);
  app.listen({
    run() {
      frames = [];
      told.clear();
      hide();
    },
    state: ({ paused }) => paused && hide(),
    frame(frame) {
      const { lag, paused, speed } = app.player;
      if (paused) return;
      if (frame.samples.length > 0) frames = [...frames.slice(1 - LAST), frame];
      if (lag < LITTLE) hide();
      const now = performance.now();
      if (lag < (line.hidden ? MUCH : LITTLE) || now < shown + EVERY || frames.length === 0) return;
      shown = now;
      const why = whyOf(app, frames);
      const rate = `${((1 - lag) * speed).toPrecision(2)}×`;
      const text = `${speed === 1 ? `Slow motion, ${rate}` : `${rate}, not ${speed}×`}: ${why.short}`;
      if (!told.has(why.kind)) {
        told.add(why.kind);
        whole = now + READ;
        say(`The scene cannot keep up with the clock: ${why.short}. ${why.advice}`);
      }
      line.textContent = now < whole ? `${text}. ${why.advice}` : text;
      line.hidden = false;
    },
  });
}

/**
 * The cause, found from the last frames: the largest of the milliseconds per step that thud, Box2D,
 * the rest of the worker's work for a step, and making frames take; or the display, if these
 * together stay below BUSY of the budget.
 */
function whyOf({ player, scene }: App, frames: readonly Frame[]): Why {
  const sum = (of: (frame: Frame) => number) =>
    frames.reduce((total, frame) => total + of(frame), 0);
  const samples = frames.flatMap((frame) => frame.samples);
  const step = sum(({ spent }) => spent?.steps ?? 0) / samples.length;
  const thud = mean(samples.map(({ milliseconds }) => milliseconds));
  const box2d = mean(samples.map(({ box2d }) => box2d?.milliseconds ?? 0));
  const rest = step - thud - box2d;
  const picture = sum(({ spent }) => spent?.picture ?? 0) / samples.length;
  const budget = (1000 * (scene?.timeStep ?? 1 / 60)) / player.speed;
  // From BUSY of the budget on the worker counts as the cause, even if it is within the budget.
  const ofBudget = (time: number) =>
    time > budget
      ? `${duration(time)}, ${duration(budget)} would keep up`
      : `${duration(time)} of the ${duration(budget)} that there are`;
  if (step + picture < BUSY * budget) {
    const pictures = Math.round(1 / player.interval);
    return {
      kind: "display",
      short: `the browser draws ${pictures} pictures a second`,
      advice: "A smaller window, or fewer programs beside this one, may help.",
    };
  }
  const most = Math.max(thud, box2d, rest, picture);
  if (most === picture)
    return {
      kind: "picture",
      short: `showing a step takes ${ofBudget(picture)}`,
      advice: "Fewer bodies or overlays take less.",
    };
  const short = `a step takes ${ofBudget(step)}`;
  if (most === box2d)
    return { kind: "box2d", short, advice: `Box2D takes ${duration(box2d)} of that.` };
  if (most === rest)
    return {
      kind: "rest",
      short,
      advice: `The scene’s own code, and what is kept to go back in time, take ${duration(rest)}.`,
    };
  return { kind: "thud", short, advice: "Fewer bodies or a lower quality take less." };
}
