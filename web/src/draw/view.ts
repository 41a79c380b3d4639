/**
 * Draws the frames that come from the worker, on three canvases on top of each other: backdrop,
 * bodies and overlay. It has no world, only the last frame, and draws it at a time between its two
 * states.
 */
import type { Vec2 } from "thud";
import type { Frame, Shapes } from "../scene/frame";
import type { OverlayName } from "../scene/overlays";
import type { Paint } from "../scene/scene";
import { Backdrop } from "./backdrop";
import { Bodies, type RendererChange } from "./bodies";
import { Camera } from "./camera";
import type { Joints } from "./joints";
import { Overlay } from "./overlay";
import { DARK, LIGHT, type Theme } from "./palette";
import type { Poses } from "./poses";
import type { Renderer } from "./renderer";
import { smoothFollow, smoothMarks } from "./smooth";

export interface DrawOptions {
  /**
   * How Box2D's bodies are drawn, where a frame has any: "side" in a pane of their own, "over" as
   * outlines over thud's bodies.
   */
  split: "none" | "side" | "over";
  /** The slot of a body that gets an outline, since the panel Inside shows it; null: none. */
  held: number | null;
}

export interface Canvases {
  backdrop: HTMLCanvasElement;
  overlay: HTMLCanvasElement;
}

/**
 * Largest number of device pixels per CSS pixel. Chosen: more cost time without a visible
 * difference.
 */
const MOST_PIXELS = 2;
/**
 * Marks are interpolated between frames that are at most this many steps apart. A larger distance
 * is a jump in time. Chosen.
 */
const MOST_STEPS = 8;

export class View {
  readonly camera = new Camera();
  /** The overlays that are on. */
  readonly shown = new Set<OverlayName>();
  readonly #backdrop: Backdrop;
  readonly #bodies: Bodies;
  readonly #overlay: Overlay;
  #theme: Theme = DARK;
  #frame: Frame | null = null;
  #shapes: Shapes | null = null;
  /** By row of shapes, as the last frame told. */
  #awake: Uint8Array | null = null;
  /** Imported when there are first joints. */
  #joints: Joints | null = null;
  #jointRows: Float32Array | null = null;
  #bearings: Float32Array | undefined;
  /** Whether the bodies' colours show sleep at present. */
  #sleepShown = false;
  /** Whether colours have to be set again, and the picture drawn again. */
  #stale = true;
  /**
   * The last picture: its frame, and as text all else that determines it. An equal one is not drawn
   * again.
   */
  #drawn: { frame: Frame; how: string } | null = null;
  /**
   * What `paint` returned for the frame before the last one, and how many steps earlier; null if
   * there is no such frame to interpolate from.
   */
  #paint: { paint: Paint; steps: number } | null = null;

  /**
   * `renderer`: that of createRenderer, for the canvas of the bodies. `changed` is called when a
   * WebGL context was lost or restored.
   */
  constructor(canvases: Canvases, renderer: Renderer, changed: RendererChange = () => {}) {
    this.#backdrop = new Backdrop(canvases.backdrop);
    this.#overlay = new Overlay(canvases.overlay, () => (this.#drawn = null));
    this.#bodies = new Bodies(renderer, (name) => {
      this.resize();
      changed(name);
    });
  }

  setTheme(dark: boolean): void {
    this.#theme = dark ? DARK : LIGHT;
    this.#stale = true;
  }

  /** Adapts the canvases to the window's size. */
  resize(): void {
    const ratio = Math.min(MOST_PIXELS, devicePixelRatio);
    const { innerWidth: width, innerHeight: height } = window;
    this.camera.resize(width, height);
    for (const layer of [this.#backdrop, this.#bodies.renderer, this.#overlay])
      layer.resize(width, height, ratio);
    this.#drawn = null;
  }

  /**
   * Takes over what a frame contains. Shapes, terrains and the like are in a frame only when they
   * changed. Frames must come in order; one may be left out only if its data has been moved to the
   * next (`handOver` of player.ts). `draw` and `follow` call this.
   */
  receive(frame: Frame): void {
    const last = this.#frame;
    if (frame === last) return;
    this.#frame = frame;
    const sameRun = last !== null && last.run === frame.run;
    const steps = sameRun ? frame.step - last.step : 0;
    if (steps > 0 && steps <= MOST_STEPS && last?.paint) this.#paint = { paint: last.paint, steps };
    else if (steps !== 0 || !sameRun) this.#paint = null;
    if (!sameRun) this.#forget();
    if (frame.terrains) this.#backdrop.setTerrains(frame.terrains);
    if (frame.shapes) {
      this.#shapes = frame.shapes;
      this.#bodies.setShapes(frame.shapes);
      this.#awake = null;
      this.#stale = true;
    }
    this.#stale ||= differs(this.#awake, frame.awake);
    this.#awake = frame.awake ?? this.#awake;
    if (frame.joints) this.#setJoints(frame.joints);
    this.#bearings = frame.bearings ?? this.#bearings;
  }

  /** Keeps the rows of joints, and imports the code that draws them when there are first any. */
  #setJoints(rows: Float32Array): void {
    if (!this.#jointRows && rows.length > 0 && !this.#joints)
      void import("./joints").then(({ Joints }) => {
        this.#joints = new Joints();
        this.#stale = true;
      });
    this.#jointRows = rows.length > 0 ? rows : null;
  }

  /**
   * `alpha` is 0 at the frame's `before`, and 1 at its `now`. False if the picture is the same as
   * before, and was not drawn again.
   */
  draw(frame: Frame, alpha: number, options: DrawOptions): boolean {
    this.receive(frame);
    const { camera } = this;
    const split = frame.box2d ? options.split : "none";
    camera.split = split === "side";
    const { x, y, scale, panes } = camera;
    const how = JSON.stringify([alpha, options, x, y, scale, panes, [...this.shown]]);
    if (!this.#stale && this.#drawn?.frame === frame && this.#drawn.how === how) return false;
    this.#drawn = { frame, how };
    this.#colour(split === "none");
    this.#backdrop.draw(camera, this.#theme, this.#shapes?.typicalSize ?? 0);

    const { renderer } = this.#bodies;
    const offset = [frame.origin[0] - camera.x, frame.origin[1] - camera.y] as const;
    const { before, now, box2d } = frame;
    let otherPoses: Poses | null = null;
    const poses: Poses = { engine: "thud", before, now, alpha, offset };
    renderer.clear();
    renderer.draw(poses, camera, panes[0], { kind: "state" });
    if (box2d && split !== "none") {
      const others: Poses = { ...poses, engine: "box2d", before: box2d.before, now: box2d.now };
      if (split === "side") {
        otherPoses = others;
        renderer.draw(others, camera, panes[1], { kind: "plain" });
      } else {
        const look = { kind: "outline", colour: this.#theme.box2d } as const;
        renderer.draw(others, camera, panes[0], look);
      }
    }

    const marks = frame.paint
      ? smoothMarks(this.#paint?.paint ?? null, frame.paint, this.#part(alpha))
      : [];
    const joints = this.#jointRows && this.#joints;
    joints?.set(this.#jointRows!, this.#shapes);
    const bearings = this.shown.has("joints") ? this.#bearings : undefined;
    const { held } = options;
    const shapes = this.#shapes;
    const picture = { frame, shapes, poses, otherPoses, joints, bearings, marks, held, split };
    this.#overlay.draw(picture, camera, this.#theme, this.shown);
    return true;
  }

  /**
   * The place that the scene wants the view to follow, interpolated like its marks; null if there
   * is none.
   */
  follow(frame: Frame, alpha: number): Vec2 | null {
    this.receive(frame);
    if (!frame.paint) return null;
    return smoothFollow(this.#paint?.paint ?? null, frame.paint, this.#part(alpha));
  }

  /**
   * The share of the time between the last two frames' marks. These may be several steps apart,
   * while `alpha` is a share of the last step.
   */
  #part(alpha: number): number {
    return 1 - (1 - alpha) / (this.#paint?.steps ?? 1);
  }

  /** Drops everything that belongs to the previous scene. */
  #forget(): void {
    this.#shapes = null;
    this.#awake = null;
    this.#jointRows = null;
    this.#bearings = undefined;
    this.#backdrop.setTerrains([]);
    this.#bodies.setShapes(NOTHING);
    this.#stale = true;
  }

  /**
   * Sets the bodies' colours. `alone`: no other engine is shown. Beside another engine, whose
   * bodies' sleep is not known, sleep is not shown.
   */
  #colour(alone: boolean): void {
    const sleep = alone && this.shown.has("sleeping");
    if (sleep === this.#sleepShown && !this.#stale) return;
    this.#stale = false;
    this.#sleepShown = sleep;
    this.#bodies.setColours({ theme: this.#theme, awake: sleep ? this.#awake : null });
  }
}

/** Whether `fresh` has other values. Most frames repeat the last values. */
function differs(old: ArrayLike<number> | null, fresh: ArrayLike<number> | undefined): boolean {
  if (!fresh) return false;
  if (!old || old.length !== fresh.length) return true;
  for (let i = 0; i < fresh.length; i++) if (old[i] !== fresh[i]) return true;
  return false;
}

/** The shapes of a scene that is not known yet. */
const NOTHING: Shapes = {
  rows: new Float32Array(0),
  count: 0,
  all: 0,
  slots: 0,
  moving: 0,
  order: new Uint32Array(0),
  typicalSize: 0,
};
