/**
 * "thud/phaser": moves the game objects of Phaser with bodies. It imports nothing of Phaser: the program hands
 * in its own objects.
 */
import { trace } from "./draw/debug.js";
import { Drag, type DragOptions, partsOf } from "./draw/drag.js";
import { Sprites } from "./draw/sprites.js";
import type { BodyRef, Vec2 } from "./types.js";
import type { DrawOptions } from "./view-types.js";
import type { World } from "./world.js";

export { Drag, type DragOptions };

/** A game object, such as a Sprite, as far as it is used here. */
export interface PhaserObject {
  x: number;
  y: number;
  rotation: number;
  destroy(): void;
}

/** A Graphics. */
export interface PhaserGraphics {
  clear(): unknown;
  lineStyle(width: number, colour: number): unknown;
  strokePoints(points: { x: number; y: number }[], closeShape?: boolean, closePath?: boolean): unknown;
}

/** What is used of a Scene. */
export interface PhaserScene {
  game: { canvas: HTMLCanvasElement };
  scale: { width: number; height: number };
  cameras: { main: { getWorldPoint(x: number, y: number): { x: number; y: number } } };
}

/** The game objects of bodies in a scene, in which the world's place [x, y] is at (scale x, -scale y). */
export class PhaserView {
  readonly #world: World;
  readonly #scene: PhaserScene;
  readonly #scale: number;
  readonly #sprites: Sprites<PhaserObject>;

  /** `scale`: units of the scene, pixels unless its camera zooms, for each length unit. */
  constructor(world: World, scene: PhaserScene, { scale = 32 } = {}) {
    [this.#world, this.#scene, this.#scale] = [world, scene, scale];
    this.#sprites = new Sprites<PhaserObject>(
      world,
      (object, x, y, cosine, sine) => {
        [object.x, object.y, object.rotation] = [scale * x, -scale * y, -Math.atan2(sine, cosine)];
      },
      (object) => object.destroy(),
    );
  }

  /**
   * Lets an object of the scene follow a body until that is destroyed; it is then destroyed, too. Returns the
   * object, whose origin is to be at the body's.
   * @throws {ThudError} "stale" for a body that does not exist.
   */
  add<Its extends PhaserObject>(body: BodyRef, object: Its): Its {
    this.#sprites.add(body, object);
    return object;
  }

  /** Moves all objects to their bodies' poses; `alpha`: what `World.advance` returned. */
  update(alpha: number): void {
    this.#sprites.update(alpha);
  }

  /** Draws what the engine sees between two corners of the world into a Graphics at the scene's origin. */
  debug(graphics: PhaserGraphics, options: DrawOptions): void {
    graphics.clear();
    const [x0, y0] = options.origin ?? [0, 0];
    const s = this.#scale;
    trace(this.#world, options, 3 / s, (line, closed, colour) => {
      graphics.lineStyle(1.5, colour);
      const ends = Array.from({ length: line.length / 2 }, (_, i) => ({ x: s * (x0 + line[2 * i]), y: -s * (y0 + line[2 * i + 1]) }));
      graphics.strokePoints(ends, closed, closed);
    });
  }

  /** Lets pointers drag dynamic bodies through the main camera, until `end` of what is returned. */
  drag(options: DragOptions = {}): Drag {
    const { game, scale, cameras } = this.#scene;
    const placeOf = (event: PointerEvent): Vec2 => {
      const [right, down] = partsOf(game.canvas, event);
      const place = cameras.main.getWorldPoint(right * scale.width, down * scale.height);
      return [place.x / this.#scale, -place.y / this.#scale];
    };
    return new Drag(this.#world, game.canvas, placeOf, options);
  }
}
