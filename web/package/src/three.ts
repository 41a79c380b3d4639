/**
 * "thud/three": moves the objects of three.js with bodies, in the plane z = 0, in the world's units, with y up.
 * It imports nothing of three.js: the program hands in its own objects.
 */
import { trace } from "./draw/debug.js";
import { Drag, type DragOptions, partsOf } from "./draw/drag.js";
import { Sprites } from "./draw/sprites.js";
import type { BodyRef, Vec2 } from "./types.js";
import type { DrawOptions } from "./view-types.js";
import type { World } from "./world.js";

export { Drag, type DragOptions };

/** An Object3D, such as a Mesh, as far as it is used here. */
export interface ThreeObject {
  position: { x: number; y: number };
  rotation: { z: number };
  removeFromParent(): unknown;
}

/** A Vector3. */
export interface ThreeVector {
  x: number;
  y: number;
  z: number;
  set(x: number, y: number, z: number): ThreeVector;
  unproject(camera: never): ThreeVector;
}

/** What is used of a camera, whichever kind it is. */
export interface ThreeCamera {
  position: { clone(): ThreeVector };
  updateMatrixWorld(): void;
}

/** The objects of bodies in a scene or a group. The group is to be neither moved, turned nor scaled. */
export class ThreeView<Child extends ThreeObject> {
  readonly #world: World;
  readonly #group: { add(child: Child): unknown };
  readonly #sprites: Sprites<Child>;

  constructor(world: World, group: { add(child: Child): unknown }) {
    [this.#world, this.#group] = [world, group];
    this.#sprites = new Sprites<Child>(
      world,
      ({ position, rotation }, x, y, cosine, sine) => {
        [position.x, position.y, rotation.z] = [x, y, Math.atan2(sine, cosine)];
      },
      (child) => child.removeFromParent(),
    );
  }

  /**
   * Adds an object to the group, which follows a body until that is destroyed, and is then removed; its
   * geometry and material stay the program's. Returns the object.
   * @throws {ThudError} "stale" for a body that does not exist.
   */
  add<Its extends Child>(body: BodyRef, child: Its): Its {
    this.#sprites.add(body, child);
    this.#group.add(child);
    return child;
  }

  /** Moves all objects to their bodies' poses; `alpha`: what `World.advance` returned. */
  update(alpha: number): void {
    this.#sprites.update(alpha);
  }

  /**
   * What the engine sees between two corners of the world, for LineSegments: x, y and z of both ends of every
   * line, and red, green and blue of both, linear in [0, 1] as three.js takes them.
   */
  debug(options: DrawOptions): { positions: number[]; colours: number[] } {
    const [positions, colours]: number[][] = [[], []];
    const [x0, y0] = options.origin ?? [0, 0];
    trace(this.#world, options, 0.05, (points, closed, colour) => {
      const rgb = [16, 8, 0].map((shift) => ((((colour >> shift) & 0xff) / 0xff + 0.055) / 1.055) ** 2.4);
      for (let at = 0; at < points.length - (closed ? 0 : 2); at += 2)
        for (const i of [at, (at + 2) % points.length]) {
          positions.push(x0 + points[i], y0 + points[i + 1], 0);
          colours.push(...rgb);
        }
    });
    return { positions, colours };
  }

  /** Lets pointers over a canvas drag dynamic bodies through a camera, until `end` of what is returned. */
  drag(canvas: HTMLCanvasElement, camera: ThreeCamera, options: DragOptions = {}): Drag {
    const placeOf = (event: PointerEvent): Vec2 => {
      const [right, down] = partsOf(canvas, event);
      const [x, y] = [2 * right - 1, 1 - 2 * down];
      camera.updateMatrixWorld();
      const [near, far] = [-1, 1].map((z) => camera.position.clone().set(x, y, z).unproject(camera as never));
      const way = near.z / (near.z - far.z); // where the line of sight meets the plane z = 0
      return [near.x + way * (far.x - near.x), near.y + way * (far.y - near.y)];
    };
    return new Drag(this.#world, canvas, placeOf, options);
  }
}
