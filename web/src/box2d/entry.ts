/** What a Box2DWorld keeps of a body. */
import type { BodyId, BodyState, Vec2 } from "thud";
import type {
  b2BodyId,
  b2ChainId,
  b2ShapeId,
} from "../../node_modules/box2d3-wasm/build/dist/es/deluxe/Box2D.deluxe";
import type { Common } from "./make";

export interface Entry {
  id: BodyId;
  body: b2BodyId;
  kind: BodyState["kind"];
  turns: boolean;
  gravityScale: number;
  /** By the index of the shape. */
  made: Map<number, { shape: b2ShapeId } | { chain: b2ChainId }>;
  /** Null after its shapes changed. */
  weight: Weight | null;
}

interface Weight {
  mass: number;
  /** About the centre of mass; 0 if it cannot turn. */
  inertia: number;
  /** Centre of mass in the body's frame. */
  center: Vec2;
}

export function weigh({ box2d, unit }: Common, { body, turns }: Entry): Weight {
  const data = box2d.b2Body_GetMassData(body);
  const { mass, rotationalInertia, center } = data;
  const weight: Weight = {
    mass,
    inertia: turns ? rotationalInertia * unit * unit : 0,
    center: [center.x * unit, center.y * unit],
  };
  data.delete();
  return weight;
}
