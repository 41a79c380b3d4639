/** Rapier for examples of how a program is brought from it: loaded alone, since it is large. */
import * as Rapier from "@dimforge/rapier2d-compat";
import { circleOf, steps, styleOf } from "./rival-rows.js";

/** Rapier, whose worlds are shown: balls and cuboids. */
export function rapier(show) {
  class World extends Rapier.World {
    constructor(gravity) {
      super(gravity);
      show({ advance: steps(() => this.step()), draw: () => this.#draw() });
    }

    #draw() {
      const shapes = [];
      this.forEachCollider((collider) => {
        const body = collider.parent();
        const style = styleOf(!body || body.isFixed(), !body?.isSleeping());
        const [place, angle] = [collider.translation(), collider.rotation()];
        if (collider.shapeType() === Rapier.ShapeType.Ball) shapes.push(...circleOf(place, collider.radius(), angle), style, 0);
        else if (collider.shapeType() === Rapier.ShapeType.Cuboid) {
          const { x, y } = collider.halfExtents();
          shapes.push(place.x, place.y, x, y, Math.cos(angle), Math.sin(angle), 0, style, 0);
        }
      });
      return { shapes: Float32Array.from(shapes), lines: new Float32Array(0) };
    }
  }
  return { ...Rapier, World, init };
}

/** Starts Rapier, which warns of how it starts itself: the reader can do nothing about it. */
async function init() {
  const { warn } = console;
  console.warn = () => {};
  await Rapier.init().finally(() => (console.warn = warn));
}
