/** The rows of `Shapes`: where their numbers stand, and which colour each row has. */
import { BODY_KINDS, SHAPE_KINDS } from "thud";
import type { Shapes } from "../scene/frame";
import { classColour, mix, rampColour, type Rgb, type Theme } from "./palette";

/** Numbers a row, as in ShapeTable.rows of the package. */
export const ROW = 10;
/** Where in a row they stand. */
export const SLOT = 0;
export const SHAPE = 1;
export const BODY = 2;
const SENSOR = 3;
export const OFFSET = 4;
export const HALF = 6;
export const TURN = 8;

export const CIRCLE = SHAPE_KINDS.indexOf("circle");
export const STATIC = BODY_KINDS.indexOf("static");
export const DYNAMIC = BODY_KINDS.indexOf("dynamic");
const KINEMATIC = BODY_KINDS.indexOf("kinematic");

/** How far a sleeping body's colour fades. */
const FADE = 0.4;
/** Opacity of sensors, of 255. */
const SENSOR_ALPHA = 72;

export interface Colouring {
  theme: Theme;
  /** By row; all are awake without it. */
  awake: Uint8Array | null;
  /** By row, and -1 for none; without it bodies have their place in the ramp. */
  classes: Int32Array | null;
}

/** Red, green, blue and opacity of each row. */
export function rowColours(shapes: Shapes, { theme, awake, classes }: Colouring): Uint8Array {
  const colours = new Uint8Array(4 * shapes.count);
  const ofClass = new Map<number, Rgb>();
  for (let row = 0; row < shapes.count; row++) {
    const at = row * ROW;
    const fixed = shapes.rows[at + BODY] === STATIC;
    let colour = plainColour(shapes, at, theme);
    if (classes && !fixed) {
      const number = classes[row] ?? -1;
      let known = ofClass.get(number);
      if (!known) {
        known = number < 0 ? theme.classless : classColour(number, theme.dark);
        ofClass.set(number, known);
      }
      colour = known;
    }
    if (awake && awake[row] === 0 && !fixed) colour = mix(colour, theme.sleep, FADE);
    colours[4 * row] = colour[0];
    colours[4 * row + 1] = colour[1];
    colours[4 * row + 2] = colour[2];
    colours[4 * row + 3] = shapes.rows[at + SENSOR] !== 0 ? SENSOR_ALPHA : 255;
  }
  return colours;
}

/** Moving bodies run through the ramp in the order of their creation, so that mixing shows. */
function plainColour(shapes: Shapes, at: number, theme: Theme): Rgb {
  if (shapes.rows[at + SENSOR] !== 0) return theme.sensor;
  if (shapes.rows[at + BODY] === STATIC) return theme.fixed;
  if (shapes.rows[at + BODY] === KINEMATIC) return theme.kinematic;
  return rampColour(rampPlace(shapes.order[shapes.rows[at + SLOT]], shapes.moving));
}

/** A little jitter keeps neighbours apart. */
function rampPlace(order: number, moving: number): number {
  const jitter = ((order * 0.618034) % 1) - 0.5;
  const spread = moving > 40 ? 0.07 : 0.12;
  return (order + 0.5) / Math.max(1, moving) + spread * jitter;
}
