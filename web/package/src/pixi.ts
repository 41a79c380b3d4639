/**
 * "thud/pixi": moves the display objects of PixiJS 8 with bodies. It imports nothing of PixiJS: the program hands
 * in its own objects.
 */
import { trace } from "./draw/debug.js";
import { Drag, type DragOptions, partsOf } from "./draw/drag.js";
import { Sprites } from "./draw/sprites.js";
import type { BodyRef, Vec2 } from "./types.js";
import type { DrawOptions } from "./view-types.js";
import type { World } from "./world.js";

export { Drag, type DragOptions };

/** A display object, such as a Sprite, as far as it is used here. */
export interface PixiObject {
  x: number;
  y: number;
  rotation: number;
  destroy(): void;
}

/** A Graphics. */
export interface PixiGraphics {
  clear(): unknown;
  poly(points: number[], close?: boolean): unknown;
  stroke(style: { width: number; color: number }): unknown;
}

/** A Container. */
export interface PixiContainer<Child> {
  addChild(child: Child): unknown;
  toLocal(point: { x: number; y: number }): { x: number; y: number };
}

/** What is used of an Application. */
export interface PixiApplication {
  canvas: HTMLCanvasElement;
  renderer: { screen: { width: number; height: number } };
}

/**
 * The display objects of bodies in a container, whose own place and scale are the camera: the world's place
 * [x, y] is at (scale x, -scale y) in it.
 */
export class PixiView<Child extends PixiObject> {
  readonly #world: World;
  readonly #container: PixiContainer<Child>;
  readonly #sprites: Sprites<Child>;
  readonly #scale: number;

  /** `scale`: units of the container, at first pixels, for each length unit. */
  constructor(world: World, container: PixiContainer<Child>, { scale = 32 } = {}) {
    [this.#world, this.#container, this.#scale] = [world, container, scale];
    this.#sprites = new Sprites<Child>(
      world,
      (child, x, y, cosine, sine) => {
        [child.x, child.y, child.rotation] = [scale * x, -scale * y, -Math.atan2(sine, cosine)];
      },
      (child) => child.destroy(),
    );
  }

  /**
   * Adds an object to the container, which follows a body until that is destroyed; it is then destroyed, too.
   * Returns the object, whose anchor or pivot is to be at the body's origin. Throws "stale" for no body.
   */
  add<Its extends Child>(body: BodyRef, child: Its): Its {
    this.#sprites.add(body, child);
    this.#container.addChild(child);
    return child;
  }

  /** Moves all objects to their bodies' poses; `alpha`: what `World.advance` returned. */
  update(alpha: number): void {
    this.#sprites.update(alpha);
  }

  /** Draws what the engine sees between two corners of the world into a Graphics of the container. */
  debug(graphics: PixiGraphics, options: DrawOptions): void {
    graphics.clear();
    const [x0, y0] = options.origin ?? [0, 0];
    const s = this.#scale;
    trace(this.#world, options, 3 / s, (points, closed, color) => {
      graphics.poly(points.map((value, i) => (i % 2 ? -s * (y0 + value) : s * (x0 + value))), closed);
      graphics.stroke({ width: 1.5, color });
    });
  }

  /** Lets pointers over the application's canvas drag dynamic bodies, until `end` of what is returned. */
  drag({ canvas, renderer }: PixiApplication, options: DragOptions = {}): Drag {
    const placeOf = (event: PointerEvent): Vec2 => {
      const { screen } = renderer;
      const [right, down] = partsOf(canvas, event);
      const place = this.#container.toLocal({ x: right * screen.width, y: down * screen.height });
      return [place.x / this.#scale, -place.y / this.#scale];
    };
    return new Drag(this.#world, canvas, placeOf, options);
  }
}
