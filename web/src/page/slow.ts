/**
 * Says that the scene runs slower than the clock, and why, for as long as it does. Loaded when that
 * happens for the first time.
 */
import type { Frame } from "../scene/frame";
import { mean } from "../shared/step-times";
import type { App } from "./app";
import { byId, make } from "./dom";
import { duration } from "./format";
import { say } from "./messages";

/** The parts of its time from which on it is told, and below which it is over. */
const MUCH = 0.2;
const LITTLE = 0.05;
/** Milliseconds between two texts. */
const EVERY = 1000;
/** Milliseconds that what helps is shown. */
const READ = 12_000;
/** Frames that are looked at. */
const LAST = 60;
/** Of the time that there is: a worker that needs as much has none to spare. */
const BUSY = 0.7;

interface Why {
  /** What is told once for each scene. */
  kind: string;
  short: string;
  advice: string;
}

export function watch(app: App): void {
  const line = make("p", { id: "slow", class: "panel", hidden: true });
  byId("notice").after(line);
  let frames: Frame[] = [];
  let shown = 0;
  /** Until then what helps is told too. */
  let whole = 0;
  /** What has been told of this scene. */
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

/** What takes the time, by the last frames. */
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
  // A worker may be the reason before it needs more than there is: it has none to spare (BUSY).
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
