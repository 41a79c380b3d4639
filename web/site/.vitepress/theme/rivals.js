/**
 * Other engines for examples of how a program is brought from them: each module as a program imports
 * it, but `show` is called with what its world is drawn and advanced by.
 */
import cp from "chipmunk";
import Matter from "matter-js";
import * as planckModule from "planck";
import { circleOf, steps, styleOf } from "./rival-rows.js";

/** The middle, half extents and direction of a box from its corners in turn. */
function boxOf(corners) {
  const [a, b, c] = corners;
  const [width, height] = [Math.hypot(b.x - a.x, b.y - a.y), Math.hypot(c.x - b.x, c.y - b.y)];
  const [cosine, sine] = [(b.x - a.x) / width, (b.y - a.y) / width];
  return [(a.x + c.x) / 2, (a.y + c.y) / 2, width / 2, height / 2, cosine, sine, 0];
}

/** planck, whose worlds are shown: circles, boxes and edges. */
export function planck(show) {
  class World extends planckModule.World {
    constructor(...options) {
      super(...options);
      show({ advance: steps(() => this.step(1 / 60)), draw: () => this.#draw() });
    }

    #draw() {
      const [shapes, lines] = [[], []];
      for (let body = this.getBodyList(); body; body = body.getNext())
        for (let fixture = body.getFixtureList(); fixture; fixture = fixture.getNext()) {
          const shape = fixture.getShape();
          const style = styleOf(body.isStatic(), body.isAwake());
          const corners = (shape.m_vertices ?? []).map((corner) => body.getWorldPoint(corner));
          if (shape.getType() === "circle")
            shapes.push(...circleOf(body.getWorldPoint(shape.getCenter()), shape.getRadius(), body.getAngle()), style, 0);
          else if (shape.getType() === "polygon") shapes.push(...boxOf(corners), style, 0);
          else {
            const [from, to] = [shape.m_vertex1, shape.m_vertex2].map((end) => body.getWorldPoint(end));
            lines.push(from.x, from.y, to.x, to.y, style);
          }
        }
      return { shapes: Float32Array.from(shapes), lines: Float32Array.from(lines) };
    }
  }
  return { ...planckModule, World };
}

/** matter.js, whose engines are shown: circles and boxes; its y points down, that of the picture up. */
export function matter(show) {
  const create = (options) => {
    const engine = Matter.Engine.create(options);
    const draw = () => {
      const shapes = Matter.Composite.allBodies(engine.world).flatMap((body) => {
        const up = ({ x, y }) => ({ x, y: -y });
        const row = body.circleRadius
          ? circleOf(up(body.position), body.circleRadius, -body.angle)
          : boxOf(body.vertices.map(up));
        return [...row, styleOf(body.isStatic, !body.isSleeping), 0];
      });
      return { shapes: Float32Array.from(shapes), lines: new Float32Array(0) };
    };
    show({ advance: steps(() => Matter.Engine.update(engine, 1000 / 60)), draw });
    return engine;
  };
  return { ...Matter, Engine: { ...Matter.Engine, create } };
}

/** Chipmunk in JavaScript, whose spaces are shown: circles, boxes and segments. */
export function chipmunk(show) {
  class Space extends cp.Space {
    constructor() {
      super();
      show({ advance: steps(() => this.step(1 / 60)), draw: () => this.#draw() });
    }

    #draw() {
      const [shapes, lines] = [[], []];
      this.eachShape((shape) => {
        const { body } = shape;
        const style = styleOf(body.isStatic(), !body.isSleeping());
        if (shape.type === "circle") shapes.push(...circleOf(shape.tc, shape.r, body.a), style, 0);
        else if (shape.type === "segment") lines.push(shape.ta.x, shape.ta.y, shape.tb.x, shape.tb.y, style);
        else {
          const corners = [0, 2, 4].map((i) => ({ x: shape.tVerts[i], y: shape.tVerts[i + 1] }));
          shapes.push(...boxOf(corners), style, 0);
        }
      });
      return { shapes: Float32Array.from(shapes), lines: Float32Array.from(lines) };
    }
  }
  return { ...cp, Space };
}
