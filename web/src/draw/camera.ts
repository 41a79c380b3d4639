/**
 * The camera: the place of the world in the middle of the view (x, y), and the scale in CSS pixels
 * per world unit. Places are kept in double precision, so that scenes far from the world's origin
 * do not jitter. The canvas may be split into two panes, which show the same part of the world.
 */
import type { Vec2 } from "thud";
import type { View } from "../scene/scene";

/** Widths of the strips at the window's edges that controls cover, in CSS pixels. */
export interface Insets {
  top: number;
  right: number;
  bottom: number;
  left: number;
}

/** A rectangle in the world. */
export interface Box {
  x0: number;
  y0: number;
  x1: number;
  y1: number;
}

/**
 * A part of the canvas, and the point (middleX, middleY) in it that shows the camera's place; in
 * CSS pixels of the canvas.
 */
export interface Pane {
  /** The pane 0 shows thud's bodies, 1 the other engine's. */
  readonly index: 0 | 1;
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
  readonly middleX: number;
  readonly middleY: number;
}

/** Smallest width and height, in CSS pixels, that are assumed free of controls. Chosen. */
const LEAST_FREE = 50;
/** Space on either side of the line between two panes, in CSS pixels. Chosen. */
const GAP = 12;
/** Space at the top of each of two panes for the engine's name, in CSS pixels. Chosen. */
export const PANE_HEAD = 42;

/**
 * In a window taller than the view, a view that is `low` (scene.ts) stands this share of the spare
 * height below the middle. Chosen.
 */
const SKY = 0.4;

export class Camera {
  x = 0;
  y = 0;
  scale = 20;
  width = 1;
  height = 1;
  /** The strips that controls cover. The camera's place is in the middle of the rest. */
  insets: Insets = { top: 0, right: 0, bottom: 0, left: 0 };
  #split = false;
  /** The scene's own view. */
  #home: View = { x: 0, y: 0, height: 20 };

  get middleX(): number {
    return this.panes[0].middleX;
  }

  get middleY(): number {
    return this.panes[0].middleY;
  }

  /** Whether there are two panes. */
  get split(): boolean {
    return this.#split;
  }

  /**
   * Changes the scale with the number of panes, so that the view fills a pane as much as before.
   */
  set split(split: boolean) {
    if (split === this.#split) return;
    const before = this.#homeScale();
    this.#split = split;
    this.scale *= this.#homeScale() / before;
  }

  /**
   * One pane, or two with the same free size: side by side or one above the other, by which of the
   * two shows the scene's view at the larger scale.
   */
  get panes(): readonly Pane[] {
    const { width, height, insets } = this;
    const right = width - insets.right;
    const bottom = height - insets.bottom;
    const middle = (low: number, high: number) => (low + high) / 2;
    const middleX = middle(insets.left, right);
    const middleY = middle(insets.top, bottom);
    if (!this.#split) return [{ index: 0, left: 0, top: 0, width, height, middleX, middleY }];
    const [freeWidth, freeHeight] = [right - insets.left, bottom - insets.top];
    const beside = this.#fitting(freeWidth / 2 - GAP, freeHeight - PANE_HEAD);
    const below = this.#fitting(freeWidth, freeHeight / 2 - GAP - PANE_HEAD);
    if (beside >= below) {
      const part = Math.round(middleX);
      const common = { top: 0, height, middleY: middle(insets.top + PANE_HEAD, bottom) };
      return [
        { ...common, index: 0, left: 0, width: part, middleX: middle(insets.left, part - GAP) },
        {
          ...common, index: 1, left: part, width: width - part, middleX: middle(part + GAP, right),
        },
      ];
    }
    const part = Math.round(middleY);
    const common = { left: 0, width, middleX };
    const upper = middle(insets.top + PANE_HEAD, part - GAP);
    const lower = middle(part + PANE_HEAD, bottom - GAP);
    return [
      { ...common, index: 0, top: 0, height: part, middleY: upper },
      { ...common, index: 1, top: part, height: height - part, middleY: lower },
    ];
  }

  /** The pane that contains a point of the canvas. */
  paneAt(x: number, y: number): Pane {
    const { panes } = this;
    const last = panes[panes.length - 1];
    return x >= last.left && y >= last.top ? last : panes[0];
  }

  /** From a place in the world to the canvas, in CSS pixels. */
  toScreen(x: number, y: number, pane: Pane = this.panes[0]): [x: number, y: number] {
    return [pane.middleX + (x - this.x) * this.scale, pane.middleY - (y - this.y) * this.scale];
  }

  /** From a point of the canvas, in CSS pixels, to the world. */
  toWorld(x: number, y: number, pane: Pane = this.paneAt(x, y)): [x: number, y: number] {
    return [this.x + (x - pane.middleX) / this.scale, this.y - (y - pane.middleY) / this.scale];
  }

  /** The part of the world that the first pane shows. */
  get visible(): Box {
    return this.visibleIn(this.panes[0]);
  }

  visibleIn(pane: Pane): Box {
    const [x0, y1] = this.toWorld(pane.left, pane.top, pane);
    const [x1, y0] = this.toWorld(pane.left + pane.width, pane.top + pane.height, pane);
    return { x0, y0, x1, y1 };
  }

  /** Sets the scene's view, and shows it. */
  setHome(view: View): void {
    this.#home = view;
    this.goHome();
  }

  /** Like `setHome`, with a view that contains all of a rectangle. */
  fit({ x0, y0, x1, y1 }: Box): void {
    this.setHome({ x: (x0 + x1) / 2, y: (y0 + y1) / 2, height: y1 - y0, width: x1 - x0 });
  }

  /** Shows the scene's view. */
  goHome(): void {
    const [freeWidth, freeHeight] = this.#free();
    const { x, y, height, low } = this.#viewFor(freeWidth, freeHeight);
    this.x = x;
    this.scale = this.#homeScale();
    const shown = (2 * (this.middleY - this.insets.top)) / this.scale;
    this.y = low && !this.#split ? y + SKY * Math.max(0, shown - height) : y;
  }

  /** Width and height of the part of the first pane that controls leave free. */
  #free(): [width: number, height: number] {
    const [{ middleX, middleY }] = this.panes;
    const head = this.#split ? PANE_HEAD : 0;
    return [
      Math.max(LEAST_FREE, 2 * (middleX - this.insets.left)),
      Math.max(LEAST_FREE, 2 * (middleY - this.insets.top - head)),
    ];
  }

  /** The scene's view, or its view for tall windows where the free part is taller than wide. */
  #viewFor(freeWidth: number, freeHeight: number): View {
    return (freeHeight > freeWidth && this.#home.tall) || this.#home;
  }

  /** The scale at which the scene's view fits into the first pane. */
  #homeScale(): number {
    const fitting = this.#fitting(...this.#free());
    return Number.isFinite(fitting) ? fitting : this.scale;
  }

  /** The scale at which the scene's view fits into a part of the canvas of this size. */
  #fitting(freeWidth: number, freeHeight: number): number {
    const { height, width = 0 } = this.#viewFor(freeWidth, freeHeight);
    return Math.min(freeHeight / height, width > 0 ? freeWidth / width : Infinity);
  }

  /** Moves the given share of the way to a place. */
  follow([x, y]: Vec2, part: number): void {
    this.x += part * (x - this.x);
    this.y += part * (y - this.y);
  }

  resize(width: number, height: number): void {
    this.width = Math.max(1, width);
    this.height = Math.max(1, height);
  }

  /** Moves the view by a distance on the screen, in CSS pixels. */
  pan(dx: number, dy: number): void {
    this.x -= dx / this.scale;
    this.y += dy / this.scale;
  }

  /**
   * Zooms about a point of the screen, which keeps showing the same place. The scale stays within
   * 1/50 and 200 times (roughly) that of the scene's view.
   */
  zoom(factor: number, screenX = this.middleX, screenY = this.middleY): void {
    const [x, y] = this.toWorld(screenX, screenY);
    const home = this.#home.height;
    const least = Math.min(this.width, this.height) / (home * 50);
    const most = (200 * Math.min(this.width, this.height)) / home;
    this.scale = Math.min(most, Math.max(least, this.scale * factor));
    const [newX, newY] = this.toWorld(screenX, screenY);
    this.x += x - newX;
    this.y += y - newY;
  }
}
