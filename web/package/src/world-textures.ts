/**
 * The layer of World with textured ground: terrain whose friction is read from a texture where each
 * contact stands. thud_textured.h describes it in full.
 */
import { explained } from "./checks/hook.js";
import { ListAt, NumberAt, TextureAt } from "./generated/slots.js";
import { view } from "./numbers.js";
import { Kind } from "./plain/handles.js";
import { withTexture } from "./terrain-line.js";
import type { ShapeRef, Texture } from "./types.js";
import { WorldShapes } from "./world-shapes.js";

/** See the head of this file. */
export class WorldTextures extends WorldShapes {
  /**
   * Gives a terrain a texture in place of its friction, from the next step on; null takes it away.
   * The lists are copied. Edits of the line leave the texture where it lies: a vertex that they make
   * gets the value that the line had at its x.
   * @throws {ThudError} "invalid", also for another kind of shape, or another number of vertices
   * than the line has; "stale"; "locked" inside a callback; "memory".
   * @example world.setTexture(shape, { vertices: [0.9, 0.9, 0.1, 0.1, 0.9] })
   */
  setTexture(shape: ShapeRef, texture: Texture | null): void {
    if (texture === null) {
      this.on(Kind.shape, "api_shape_remove_texture", shape);
      return;
    }
    withTexture(this.engine, "setTexture", texture, (...numbers) => {
      try {
        this.on(Kind.shape, "api_shape_set_texture", shape, ...numbers);
      } catch (refused) {
        throw explained(refused, "setTexture", { texture });
      }
    });
  }

  /**
   * A copy of the texture of a terrain as it is now; null where it has none.
   * @throws {ThudError} "stale"; "invalid" for another kind of shape.
   */
  textureOf(shape: ShapeRef): Texture | null {
    this.on(Kind.shape, "api_shape_texture", shape);
    const { buffer, slots: s } = this.engine;
    const [count, entries] = [s[TextureAt.vertices + ListAt.count], s[TextureAt.table + ListAt.count]];
    if (count === 0) return null;
    const vertices = view(Float64Array, buffer, s[TextureAt.vertices], count).slice();
    if (entries === 0) return { vertices };
    const table = view(Float32Array, buffer, s[TextureAt.table], entries).slice();
    return { vertices, table, repeats: s[TextureAt.repeats] !== 0 };
  }

  /**
   * The friction of a terrain at x, a coordinate in the world: that of its texture, beyond an end
   * of the line that of the end; without a texture that of the shape.
   * @throws {ThudError} "invalid" for another kind of shape; "stale".
   * @example const grip = world.frictionAt(shape, x)
   */
  frictionAt(shape: ShapeRef, x: number): number {
    this.on(Kind.shape, "api_friction_at", shape, x);
    return this.engine.slots[NumberAt.value];
  }

  /**
   * Prepares a world that never had a texture for `restore` from a snapshot with textures, which it
   * would refuse otherwise.
   * @throws {ThudError} "memory"; "locked" inside a callback.
   */
  useTextures(): void {
    this.engine.check(this.engine.exports.api_world_use_textures(this.address));
  }
}
