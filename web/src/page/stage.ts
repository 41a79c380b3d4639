/**
 * `Stage`: the scene on its canvases. It draws what the player shows, and turns input of pointers
 * and of the crosshair into moves of the camera or commands to the worker.
 */
import { OVERLAYS, type OverlayName } from "../scene/overlays";
import type { Pane } from "../draw/camera";
import type { Renderer } from "../draw/renderer";
import { type DrawOptions, View } from "../draw/view";
import type { Look } from "../worker/protocol";
import type { App } from "./app";
import { byId } from "./dom";
import { notice } from "./messages";
import { inBody, pick } from "./input/pick";
import { listenToPointers, type Tool } from "./input/pointers";

/** Rate in 1/s at which the camera approaches the place that the scene wants followed: after t
 * seconds the share exp(-FOLLOW_RATE t) of the distance is left. Chosen. */
const FOLLOW_RATE = 6;
/** Radius of an explosion and of a crater: `sizes` times the half width of a typical body, but at
 * least `pixels` CSS pixels. `speed`: the speed that an explosion gives to bodies at its centre, in
 * length scales (sizes of a typical body, which the scene states) per second. Chosen. */
const BLAST = { pixels: 60, sizes: 8, speed: 18 };
const CRATER = { pixels: 16, sizes: 3.5 };
/** CSS pixels from the crosshair within which a body counts as under it. Chosen. */
const CROSSHAIR_REACH = 24;

/** A body under the mouse by its slot (its index in `Frame.now`), and where the mouse is: in the
 * world (x, y), and in CSS pixels (screenX, screenY). */
export interface Hovered {
  slot: number;
  x: number;
  y: number;
  screenX: number;
  screenY: number;
}

export class Stage {
  readonly view: View;
  tool: Tool = "hand";
  /** How Box2D's bodies are drawn while Box2D runs the same scene. */
  split: DrawOptions["split"] = "none";
  /** The slot of the body that is outlined; null: none. */
  outlined: number | null = null;
  /** Set by a panel; called with the body under the mouse, or null, when the mouse moves. */
  onHover: ((hovered: Hovered | null) => void) | null = null;
  /** Set by a panel; called with the body that was clicked or tapped, or null for none. */
  onPick: ((slot: number | null) => void) | null = null;
  #app!: App;
  /** Overlays that the scene asks for and the visitor has not chosen; they end with the scene. */
  #lent: readonly OverlayName[] = [];
  /** The camera follows the place that the scene wants followed; moving the view ends that. */
  #follows = true;
  /** The crosshair for use without a pointer; "holds": it drags a body. */
  #crosshair: "off" | "on" | "holds" = "off";
  /** Whether the scene has ground that can be dug. */
  #hasGround = false;
  #movedTimer = 0;

  /** `drawn`: what draws on the canvas of the bodies. */
  constructor(drawn: Renderer) {
    this.view = new View(
      {
        backdrop: byId<HTMLCanvasElement>("backdrop"),
        overlay: byId<HTMLCanvasElement>("overlay"),
      },
      drawn,
      (renderer) =>
        notice(
          renderer === "webgl2"
            ? "WebGL is back."
            : "The browser took WebGL away: drawing goes on with Canvas 2D.",
        ),
    );
  }

  /** The visible part of the world and the chosen overlays, for the worker. */
  get look(): Look {
    const { camera, shown } = this.view;
    const { x0, y0, x1, y1 } = camera.visible;
    // The overlay "axes" is drawn at the lower edge: above the controls that cover the canvas.
    const free = shown.has("axes") ? camera.insets.bottom / camera.scale : 0;
    return {
      origin: [camera.x, camera.y],
      lower: [x0, y0 + free],
      upper: [x1, y1],
      overlays: [...shown],
      focus: this.outlined,
    };
  }

  /** Connects the stage with the app, and the canvas with its pointer events. */
  attach(app: App): void {
    this.#app = app;
    const { camera } = this.view;
    app.listen({
      run: (scene) => {
        camera.setHome(scene.view);
        const place = app.state.camera;
        if (place) {
          Object.assign(camera, place);
          this.#follows = false;
        } else this.#follows = true;
        this.#lend(scene.show);
      },
      frame: ({ terrains }) => {
        if (terrains) this.#hasGround = terrains.some(({ terrain }) => terrain.kind !== "flat");
      },
    });
    const canvas = byId("overlay");
    listenToPointers(canvas, camera, {
      tool: () => this.tool,
      taken: () => this.tool === "hand" && (app.scene?.pointer ?? false),
      point: (x, y, down) => app.do({ kind: "pointer", x, y, down }),
      grab: (x, y, reach, pane) => this.#grab(x, y, reach, pane),
      drag: (x, y) => app.do({ kind: "drag", x, y }),
      release: () => app.do({ kind: "release" }),
      apply: (tool, x, y) => this.apply(tool, x, y),
      hover: (at) => this.#hover(at),
      tap: (x, y, reach) => {
        if (this.tool === "hand") this.onPick?.(this.#bodyAt(x, y, reach, false));
      },
      moved: () => this.#moved(),
    });
    canvas.addEventListener("blur", () => this.#endCrosshair());
  }

  setTool(tool: Tool): void {
    this.tool = tool;
    byId("overlay").dataset.tool = tool;
  }

  /** Shows or hides an overlay, as the visitor has chosen. */
  setOverlay(name: OverlayName, on: boolean): void {
    const { shown } = this.view;
    this.#lent = this.#lent.filter((other) => other !== name);
    if (on) shown.add(name);
    else shown.delete(name);
    this.#app.state.overlays = OVERLAYS.filter(
      (other) => shown.has(other) && !this.#lent.includes(other),
    );
    this.#app.refresh();
    this.#app.chosen();
  }

  /** A scene begins: shows the chosen overlays and those that this scene asks for. */
  #lend(overlays: readonly OverlayName[]): void {
    const { shown } = this.view;
    const chosen = this.#app.state.overlays;
    this.#lent = overlays.filter((name) => OVERLAYS.includes(name) && !chosen.includes(name));
    shown.clear();
    for (const name of [...chosen, ...this.#lent]) shown.add(name);
  }

  // ---- the view ----

  /** Shows the whole scene, and follows it again. */
  home(): void {
    this.view.camera.goHome();
    this.#follows = true;
    this.#app.state.camera = null;
    this.#app.refresh();
    this.#app.chosen();
  }

  /** Moves the view by CSS pixels. */
  pan(dx: number, dy: number): void {
    this.view.camera.pan(dx, dy);
    if (this.#crosshair === "holds") this.#drag();
    this.#moved();
  }

  zoom(factor: number): void {
    this.view.camera.zoom(factor);
    this.#moved();
  }

  /** The visitor has moved the view: stops following and keeps the view in the address. */
  #moved(): void {
    this.#follows = false;
    this.#app.refresh();
    const { x, y, scale } = this.view.camera;
    this.#app.state.camera = { x, y, scale };
    clearTimeout(this.#movedTimer);
    // Browsers refuse to change the address very often: it changes 300 ms after the last move.
    this.#movedTimer = window.setTimeout(() => this.#app.chosen(), 300);
  }

  /** Draws what the player shows; called once per picture, `seconds` after the one before. */
  draw(seconds: number): void {
    const shown = this.#app.player.shown;
    if (!shown) return;
    const { frame, alpha } = shown;
    const held = byId("overlay").dataset.mode;
    const target = this.#follows ? this.view.follow(frame, alpha) : null;
    if (target && held !== "pan" && held !== "pinch")
      this.view.camera.follow(target, 1 - Math.exp(-FOLLOW_RATE * seconds));
    if (this.view.draw(frame, alpha, { split: this.split, held: this.outlined })) this.#app.drawn();
  }

  // ---- commands ----

  /** Uses a tool at a place of the world. */
  apply(tool: Exclude<Tool, "hand">, x: number, y: number): void {
    // In a scene without moving bodies a typical one is taken to have a half width of 0.5.
    const size = this.#app.shapes?.typicalSize || 0.5;
    const { scale } = this.view.camera;
    if (tool === "blast") {
      const radius = Math.max(BLAST.sizes * size, BLAST.pixels / scale);
      const speed = BLAST.speed * (this.#app.scene?.lengthScale ?? 1);
      this.#app.do({ kind: "explode", x, y, radius, speed });
    } else if (tool === "dig") {
      const radius = Math.max(CRATER.sizes * size, CRATER.pixels / scale);
      this.#app.do({ kind: "dig", x, y, radius });
      if (!this.#hasGround)
        notice("There is no ground to dig here: try the scene Digging.");
    } else this.#app.do({ kind: "spawn", shape: tool, x, y, size });
  }

  /** Enter on the scene: shows the crosshair in the middle of the view, or acts there as a press of
   * the pointer does. */
  actAtCrosshair(): void {
    const { x, y, scale } = this.view.camera;
    if (this.#crosshair === "off") this.#showCrosshair();
    else if (this.#crosshair === "holds") {
      this.#app.do({ kind: "release" });
      this.#crosshair = "on";
    } else if (this.tool !== "hand") this.apply(this.tool, x, y);
    else if (this.#grab(x, y, CROSSHAIR_REACH / scale)) this.#crosshair = "holds";
    else notice("No body lies under the crosshair. The arrow keys move the view.");
  }

  /** Picks the body at the crosshair, as a click on it does. */
  pickAtCrosshair(): void {
    const { x, y, scale } = this.view.camera;
    if (this.#crosshair === "off") this.#showCrosshair();
    const slot = this.#bodyAt(x, y, CROSSHAIR_REACH / scale, false);
    if (slot === null) notice("No body lies under the crosshair. The arrow keys move the view.");
    else this.onPick?.(slot);
  }

  /** The slot of the body at a place of the world, within `reach` world units; null for none. */
  #bodyAt(x: number, y: number, reach: number, dynamicOnly: boolean): number | null {
    const { shapes, player } = this.#app;
    const frame = player.shown?.frame;
    return shapes && frame ? pick(shapes, frame, x, y, reach, dynamicOnly) : null;
  }

  #showCrosshair(): void {
    const { camera } = this.view;
    const mark = byId("crosshair");
    mark.style.left = `${camera.middleX}px`;
    mark.style.top = `${camera.middleY}px`;
    mark.hidden = false;
    this.#crosshair = "on";
  }

  /** Drags the held body to the crosshair. */
  #drag(): void {
    const { x, y } = this.view.camera;
    this.#app.do({ kind: "drag", x, y });
  }

  /** The canvas has lost the focus: releases the held body and hides the crosshair. */
  #endCrosshair(): void {
    if (this.#crosshair === "holds") this.#app.do({ kind: "release" });
    this.#crosshair = "off";
    byId("crosshair").hidden = true;
  }

  /** Takes hold of the dynamic body at a place; false if there is none. In Box2D's pane (1) the
   * body is found at Box2D's pose. The body is pulled in both engines. */
  #grab(x: number, y: number, reach: number, pane: Pane["index"] = 0): boolean {
    const { shapes, player } = this.#app;
    const frame = player.shown?.frame;
    if (!shapes || !frame) return false;
    const placed = { origin: frame.origin, now: (pane === 1 && frame.box2d?.now) || frame.now };
    const slot = pick(shapes, placed, x, y, reach, true);
    if (slot === null) return false;
    this.#app.do({ kind: "grab", slot, anchor: inBody(placed, slot, x, y), x, y });
    return true;
  }

  /** The mouse has moved: calls `onHover` with the body within 3 CSS pixels. */
  #hover(at: { x: number; y: number; screenX: number; screenY: number } | null): void {
    if (!this.onHover) return;
    const slot = at && this.#bodyAt(at.x, at.y, 3 / this.view.camera.scale, false);
    this.onHover(at && slot !== null ? { slot, ...at } : null);
  }
}
