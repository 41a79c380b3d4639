/** The camera: which place of the world stands in the middle, and how many CSS pixels a metre has. */

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

export class Camera {
  x = 0;
  y = 0;
  scale = 20;
  width = 1;
  height = 1;
  /** Where controls lie over the canvas; the world's middle is that of what they leave free. */
  insets: Insets = { top: 0, right: 0, bottom: 0, left: 0 };
  #home = { x: 0, y: 0, height: 20, width: 0 };

  get middleX(): number {
    return (this.width + this.insets.left - this.insets.right) / 2;
  }

  get middleY(): number {
    return (this.height + this.insets.top - this.insets.bottom) / 2;
  }

  toScreen(x: number, y: number): [x: number, y: number] {
    return [this.middleX + (x - this.x) * this.scale, this.middleY - (y - this.y) * this.scale];
  }

  toWorld(x: number, y: number): [x: number, y: number] {
    return [this.x + (x - this.middleX) / this.scale, this.y - (y - this.middleY) / this.scale];
  }

  /** The world's part that the canvas shows. */
  get visible(): Box {
    const [x0, y1] = this.toWorld(0, 0);
    const [x1, y0] = this.toWorld(this.width, this.height);
    return { x0, y0, x1, y1 };
  }

  /** Remembers a scene's view: its middle, and what must fit, in metres. */
  setHome(x: number, y: number, height: number, width: number): void {
    this.#home = { x, y, height, width };
    this.goHome();
  }

  goHome(): void {
    const { x, y, height, width } = this.#home;
    const freeWidth = Math.max(50, this.width - this.insets.left - this.insets.right);
    const freeHeight = Math.max(50, this.height - this.insets.top - this.insets.bottom);
    this.x = x;
    this.y = y;
    this.scale = Math.min(freeHeight / height, width > 0 ? freeWidth / width : Infinity);
  }

  /** Goes the given part of the way to a place. */
  follow([x, y]: readonly [number, number], part: number): void {
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
