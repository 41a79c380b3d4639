/**
 * The camera: which place of the world stands in the middle, and how many CSS pixels a metre has.
 * Everything is in double, so that scenes far from the world's origin stay still. The canvas may be
 * parted into two panes that show the same place.
 */
import type { Vec2 } from "thud";
import type { View } from "../scene/scene";

export interface Insets {
  top: number;
  right: number;
  bottom: number;
  left: number;
}

/** A box in the world. */
export interface Box {
  x0: number;
  y0: number;
  x1: number;
  y1: number;
}

/** A part of the canvas, in CSS pixels, and where in it the camera's place stands. */
export interface Pane {
  /** 0: thud's; 1: the other engine's. */
  readonly index: 0 | 1;
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
  readonly middleX: number;
  readonly middleY: number;
}

/** A part that the controls leave free is taken to be no smaller, in CSS pixels. */
const LEAST_FREE = 50;
/** Of two panes, in CSS pixels: kept free on either side of the line between them. */
const GAP = 12;
/** Of two panes, in CSS pixels: kept free at the top of each for its name. */
export const PANE_HEAD = 42;

/** The part of what a tall window has to spare by which a low view stands under its middle. */
const SKY = 0.4;

export class Camera {
  x = 0;
  y = 0;
  scale = 20;
  width = 1;
  height = 1;
  /** Where controls lie over the canvas; the world's middle is that of what they leave free. */
  insets: Insets = { top: 0, right: 0, bottom: 0, left: 0 };
  #split = false;
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

  /** What fills a pane goes on filling it. */
  set split(split: boolean) {
    if (split === this.#split) return;
    const before = this.#homeScale();
    this.#split = split;
    this.scale *= this.#homeScale() / before;
  }

  /** One, or two of the same free size: side by side or one above the other, whichever shows more
   * of the remembered view. */
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

  /** The pane under a point of the canvas. */
  paneAt(x: number, y: number): Pane {
    const { panes } = this;
    const last = panes[panes.length - 1];
    return x >= last.left && y >= last.top ? last : panes[0];
  }

  toScreen(x: number, y: number, pane: Pane = this.panes[0]): [x: number, y: number] {
    return [pane.middleX + (x - this.x) * this.scale, pane.middleY - (y - this.y) * this.scale];
  }

  toWorld(x: number, y: number, pane: Pane = this.paneAt(x, y)): [x: number, y: number] {
    return [this.x + (x - pane.middleX) / this.scale, this.y - (y - pane.middleY) / this.scale];
  }

  /** The world's part that the first pane shows. */
  get visible(): Box {
    return this.visibleIn(this.panes[0]);
  }

  visibleIn(pane: Pane): Box {
    const [x0, y1] = this.toWorld(pane.left, pane.top, pane);
    const [x1, y0] = this.toWorld(pane.left + pane.width, pane.top + pane.height, pane);
    return { x0, y0, x1, y1 };
  }

  /** Remembers a scene's view: its middle, and what must fit, in metres. */
  setHome(view: View): void {
    this.#home = view;
    this.goHome();
  }

  /** As `setHome`, with all of a box in view. */
  fit({ x0, y0, x1, y1 }: Box): void {
    this.setHome({ x: (x0 + x1) / 2, y: (y0 + y1) / 2, height: y1 - y0, width: x1 - x0 });
  }

  goHome(): void {
    const [freeWidth, freeHeight] = this.#free();
    const { x, y, height, low } = this.#viewFor(freeWidth, freeHeight);
    this.x = x;
    this.scale = this.#homeScale();
    const shown = (2 * (this.middleY - this.insets.top)) / this.scale;
    this.y = low && !this.#split ? y + SKY * Math.max(0, shown - height) : y;
  }

  /** Width and height of what controls leave free of the first pane. */
  #free(): [width: number, height: number] {
    const [{ middleX, middleY }] = this.panes;
    const head = this.#split ? PANE_HEAD : 0;
    return [
      Math.max(LEAST_FREE, 2 * (middleX - this.insets.left)),
      Math.max(LEAST_FREE, 2 * (middleY - this.insets.top - head)),
    ];
  }

  #viewFor(freeWidth: number, freeHeight: number): View {
    return (freeHeight > freeWidth && this.#home.tall) || this.#home;
  }

  #homeScale(): number {
    const fitting = this.#fitting(...this.#free());
    return Number.isFinite(fitting) ? fitting : this.scale;
  }

  /** The scale at which the remembered view fits into a part of the canvas. */
  #fitting(freeWidth: number, freeHeight: number): number {
    const { height, width = 0 } = this.#viewFor(freeWidth, freeHeight);
    return Math.min(freeHeight / height, width > 0 ? freeWidth / width : Infinity);
  }

  /** Goes the given part of the way to a place. */
  follow([x, y]: Vec2, part: number): void {
    this.x += part * (x - this.x);
    this.y += part * (y - this.y);
  }

  resize(width: number, height: number): void {
    this.width = Math.max(1, width);
    this.height = Math.max(1, height);
  }

  pan(dx: number, dy: number): void {
    this.x -= dx / this.scale;
    this.y += dy / this.scale;
  }

  /** Zooms about a point of the screen, which keeps its place. */
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
