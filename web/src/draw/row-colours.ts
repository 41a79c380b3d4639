/** Computes the colour of each row of `Shapes`. */
import type { Shapes } from "../scene/frame";
import { BODY, KINEMATIC, ROW, SENSOR, SLOT, STATIC } from "../scene/shape-table";
import { mix, rampColour, type Rgb, type Theme } from "./palette";

/** Share of the theme's sleep colour in a sleeping body's colour. Chosen. */
const FADE = 0.4;
/** Opacity of sensors, from 0 to 255. Chosen. */
const SENSOR_ALPHA = 72;

export interface Colouring {
  theme: Theme;
  /** By row, 0 if the body sleeps; null: all bodies are drawn as awake. */
  awake: Uint8Array | null;
}

/** Red, green, blue and opacity of each row, as bytes. */
export function rowColours(shapes: Shapes, { theme, awake }: Colouring): Uint8Array {
  const colours = new Uint8Array(4 * shapes.all);
  for (let row = 0; row < shapes.all; row++) {
    const at = row * ROW;
    const fixed = shapes.rows[at + BODY] === STATIC;
    let colour = plainColour(shapes, at, theme);
    if (awake && awake[row] === 0 && !fixed) colour = mix(colour, theme.sleep, FADE);
    colours[4 * row] = colour[0];
    colours[4 * row + 1] = colour[1];
    colours[4 * row + 2] = colour[2];
    colours[4 * row + 3] = shapes.rows[at + SENSOR] !== 0 ? SENSOR_ALPHA : 255;
  }
  return colours;
}

/**
 * The colour of a row without sleep. Dynamic bodies get colours of the ramp in the order of their
 * creation, so that a viewer sees how bodies mix.
 */
function plainColour(shapes: Shapes, at: number, theme: Theme): Rgb {
  if (shapes.rows[at + SENSOR] !== 0) return theme.sensor;
  if (shapes.rows[at + BODY] === STATIC) return theme.fixed;
  if (shapes.rows[at + BODY] === KINEMATIC) return theme.kinematic;
  return rampColour(rampPlace(shapes.order[shapes.rows[at + SLOT]], shapes.moving));
}

/** The place of a body on the ramp. A small offset by its number makes neighbours differ. */
function rampPlace(order: number, moving: number): number {
  const jitter = ((order * 0.618034) % 1) - 0.5;
  const spread = moving > 40 ? 0.07 : 0.12;
  return (order + 0.5) / Math.max(1, moving) + spread * jitter;
}
