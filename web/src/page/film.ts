/**
 * Makes a video of the steps that the time slider reaches. They are shown once more at their speed;
 * each time the scene's three canvases are drawn they are copied into one canvas, which the
 * browser's MediaRecorder records. Imported when the first one is made.
 */
import "../style/film.css";
import { messageOf } from "../shared/error";
import type { App } from "./app";
import { byId, make } from "./dom";
import { count } from "./format";
import { notice } from "./messages";
import { saveFile } from "./save-file";

/** The ids of the scene's canvases, from the lowest to the topmost. */
const CANVASES = ["backdrop", "bodies", "overlay"];
/** Formats of a video with the endings of their files, the best first. */
const FORMATS = [
  ["video/webm;codecs=vp9", "webm"],
  ["video/webm;codecs=vp8", "webm"],
  ["video/webm", "webm"],
  ["video/mp4", "mp4"],
] as const;
/** Pictures a second, at most, and bits a second: enough for thin lines that move. Chosen. */
const RATE = 60;
const BITS = 8_000_000;

/** The format that this browser makes; undefined: it makes no videos. */
function formatOf(): readonly [type: string, ending: string] | undefined {
  const films = typeof MediaRecorder === "function" && "captureStream" in HTMLCanvasElement.prototype;
  return films ? FORMATS.find(([type]) => MediaRecorder.isTypeSupported(type)) : undefined;
}

/** Milliseconds for which the last picture is shown at the end of the video. Chosen. */
const LAST_PICTURE = 200;
/**
 * An encoder may take a second to start, and drops the pictures that it gets until then. So the
 * first picture is held until the encoder has produced BEGUN bytes, which is checked every LOOKS
 * milliseconds. Chosen.
 */
const BEGUN = 500;
const LOOKS = 50;
/**
 * The encoder of a busy browser may produce nothing at all. If the first encoder has not produced a
 * byte after so many milliseconds, a second one is started, and then a third. The steps are filmed
 * by the last one in any case; if it has produced nothing by the end, there is no video. Chosen.
 */
const TRIES = [3000, 5000, 10_000];

class Film {
  readonly #canvas = document.createElement("canvas");
  readonly #parts: Blob[] = [];
  readonly #recorder: MediaRecorder;
  readonly #ended: Promise<void>;
  readonly #forget: () => void;
  /** The ending of the file's name. */
  readonly ending: string;

  /** Starts the encoder. Throws if the browser cannot make videos. */
  constructor(app: App) {
    const format = formatOf();
    if (!format) throw new Error("this browser makes none.");
    this.ending = format[1];
    // Encoders need even numbers of pixels. If the window's size changes later, its pictures are
    // fitted into the first size.
    const { width, height } = byId<HTMLCanvasElement>("overlay");
    this.#canvas.width = width & ~1;
    this.#canvas.height = height & ~1;
    this.#take();
    const stream = this.#canvas.captureStream(RATE);
    this.#recorder = new MediaRecorder(stream, { mimeType: format[0], videoBitsPerSecond: BITS });
    this.#ended = new Promise((resolve, reject) => {
      this.#recorder.onstop = () => resolve();
      this.#recorder.onerror = () => reject(new Error("the browser has stopped it."));
    });
    this.#recorder.ondataavailable = ({ data }) => this.#parts.push(data);
    this.#recorder.start(LOOKS);
    this.#forget = app.listen({ drawn: () => this.#take() });
  }

  /**
   * Copies the scene's picture. This must be done right after drawing, since the content of a WebGL
   * canvas is lost once the browser has shown it.
   */
  #take(): void {
    const { width, height } = this.#canvas;
    const context = this.#canvas.getContext("2d")!;
    context.fillStyle = getComputedStyle(document.body).backgroundColor;
    context.fillRect(0, 0, width, height);
    for (const id of CANVASES) {
      const layer = byId<HTMLCanvasElement>(id);
      if (layer.width > 0 && layer.height > 0) context.drawImage(layer, 0, 0, width, height);
    }
  }

  /** Shows the present picture for so many milliseconds at most, and ends earlier if `until` holds. */
  async hold(milliseconds: number, until = () => false): Promise<void> {
    const end = performance.now() + milliseconds;
    while (performance.now() < end && !until()) {
      await new Promise((next) => setTimeout(next, LOOKS));
      // Drawn once more, so that the recorder takes it as a new picture.
      this.#canvas.getContext("2d")!.drawImage(this.#canvas, 0, 0);
    }
  }

  /** Number of bytes that the encoder has produced so far. */
  get bytes(): number {
    return this.#parts.reduce((sum, { size }) => sum + size, 0);
  }

  /** Stops the encoder, and returns the video. Throws if the encoder has produced nothing. */
  async end(): Promise<Blob> {
    this.#forget();
    // After an error the browser has stopped the recorder already.
    if (this.#recorder.state !== "inactive") this.#recorder.stop();
    await this.#ended;
    for (const track of this.#recorder.stream.getTracks()) track.stop();
    if (this.bytes === 0) throw new Error("the browser's encoder has given nothing.");
    return new Blob(this.#parts, { type: this.#recorder.mimeType });
  }
}

/**
 * Films the steps that the time slider reaches, and saves the video as a file for the visitor. The
 * scene must not be a match over a network, which cannot go back.
 */
export async function saveVideo(app: App): Promise<void> {
  const shown = app.player.shown?.frame;
  if (!shown || !app.scene) return;
  const { paused } = app.state;
  const { run } = app.scene;
  const stop = make("button", { id: "stop-film", class: "primary" }, "Stop");
  const told = make("span", { "aria-hidden": "true" });
  const bar = make("div", { id: "filming", class: "panel", role: "group", "aria-label": "Video" }, told, stop);
  let stopped = false;
  stop.addEventListener("click", () => (stopped = true));
  app.setPaused(true);
  // The panel would cover the scene.
  byId("dock").querySelector<HTMLElement>(".close")!.click();
  byId("controls").before(bar);
  stop.focus();
  window.dispatchEvent(new Event("resize"));
  try {
    const film = await play(app, () => stopped, (text) => (told.textContent = text));
    if (app.scene) saveFile(app, film.video, film.ending);
    notice(`The video has ${count(Math.ceil(film.video.size / 1000))} kB.`);
  } catch (error) {
    notice(`There is no video: ${messageOf(error)}`, 20);
  }
  const hadFocus = bar.contains(document.activeElement);
  bar.remove();
  window.dispatchEvent(new Event("resize"));
  if (hadFocus) byId("overlay").focus();
  if (app.scene?.run === run && app.state.paused) app.setPaused(paused);
}

/**
 * Starts a film with the present picture, and resolves when its encoder has started, or when the
 * visitor has ended the wait (`stopped`).
 */
async function begin(app: App, stopped: () => boolean): Promise<Film> {
  for (let tries = 1; ; tries++) {
    const film = new Film(app);
    await film.hold(TRIES[tries - 1]!, () => film.bytes > BEGUN);
    if (film.bytes > 0 || stopped() || tries === TRIES.length) return film;
    film.end().catch(() => {});
  }
}

/**
 * Plays the steps while they are filmed. Ends early if `stopped`, if the visitor resumes the scene,
 * or if another scene starts.
 */
async function play(
  app: App,
  stopped: () => boolean,
  tell: (text: string) => void,
): Promise<{ video: Blob; ending: string }> {
  const { run, timeStep } = app.scene!;
  const { first, last } = app.player.shown!.frame.history;
  const goesOn = () => !stopped() && app.state.paused && app.scene?.run === run;
  const seconds = (steps: number) => Math.round(steps * timeStep);
  await app.seek(first);
  await new Promise(requestAnimationFrame);
  tell("Video: the encoder begins");
  const film = await begin(app, stopped);
  try {
    const begun = performance.now();
    for (let step = first; step < last && goesOn(); ) {
      await new Promise(requestAnimationFrame);
      const since = ((performance.now() - begun) / 1000) * app.state.speed;
      const due = Math.min(last, first + Math.floor(since / timeStep));
      if (due > step && goesOn()) await app.seek((step = due));
      tell(`Video: ${seconds(step - first)} of ${seconds(last - first)} s`);
    }
    await film.hold(LAST_PICTURE);
  } catch (error) {
    film.end().catch(() => {});
    throw error;
  }
  return { video: await film.end(), ending: film.ending };
}
