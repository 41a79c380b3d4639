/** What a Box2DWorld keeps of a body. */
import type { BodyId, BodyState, Vec2 } from "thud";
import type {
  b2BodyId,
  b2ChainId,
  b2ShapeId,
} from "../../node_modules/box2d3-wasm/build/dist/es/deluxe/Box2D.deluxe";
import type { Common } from "./make";

/** A body of the thud world, and its copy in Box2D. */
export interface Entry {
  id: BodyId;
  body: b2BodyId;
  kind: BodyState["kind"];
  /** Whether the body can rotate. */
  turns: boolean;
  gravityScale: number;
  /** Box2D's shapes and chains, by the index of the thud shape. */
  made: Map<number, { shape: b2ShapeId } | { chain: b2ChainId }>;
  /** Null after the body's shapes changed, until it is computed again. */
  weight: Weight | null;
}

interface Weight {
  mass: number;
  /** Moment of inertia about the centre of mass; 0 if the body cannot rotate. */
  inertia: number;
  /** Centre of mass in the body's frame. */
  center: Vec2;
}

/** The body's mass, inertia and centre as Box2D has them, in the world's units. */
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
