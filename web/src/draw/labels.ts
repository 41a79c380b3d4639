/**
 * Tells which engine a pane shows: a name at the top right of each pane and a line between the
 * panes; or, where both engines are in one pane, a legend. A scene's own figures are at the left.
 */
import { type Camera, type Pane, PANE_HEAD } from "./camera";
import type { Layer } from "./layer";
import { cssColour, type Theme } from "./palette";

const NAMES = { thud: "thud", box2d: "Box2D" } as const;
const FONT = '600 14px system-ui, -apple-system, "Segoe UI", Roboto, sans-serif';
/**
 * In CSS pixels: height of a name's plate, space between two plates, space within a plate, and
 * radius of the dot before a name. Chosen.
 */
const HEIGHT = 28;
const GAP = 8;
const PADDING = 11;
const DOT = 5;

export function drawLabels(
  layer: Layer,
  camera: Camera,
  theme: Theme,
  split: "side" | "over",
): void {
  const { panes } = camera;
  const box2d = cssColour(theme.box2d);
  const thud = theme.inks.accent;
  /** Draws a plate `shift` pixels from the right, and returns its width. */
  const plate = (pane: Pane, shift: number, name: string, colour: string, filled: boolean) => {
    let width = 0;
    layer.inPane(pane, (context) => {
      context.font = FONT;
      width = context.measureText(name).width + 2 * PADDING + 3 * DOT;
      const right = Math.min(pane.left + pane.width, camera.width - camera.insets.right);
      const left = right - GAP - shift - width;
      const top = Math.max(pane.top, camera.insets.top) + (PANE_HEAD - HEIGHT) / 2;
      drawPlate(context, theme, { left, top, width }, name, colour, filled);
    });
    return width;
  };
  const [first, second] = panes;
  if (split === "over" || !second) {
    const width = plate(first, 0, `${NAMES.box2d}, outlined`, box2d, false);
    plate(first, width + GAP, NAMES.thud, thud, true);
    return;
  }
  plate(first, 0, NAMES.thud, thud, true);
  layer.inPane(second, (context) => drawDivider(context, second, theme));
  plate(second, 0, NAMES.box2d, box2d, true);
}

/**
 * A name on a plate, with a disc (`filled`) or ring before it, as the engine's bodies are drawn.
 */
function drawPlate(
  context: CanvasRenderingContext2D,
  theme: Theme,
  { left, top, width }: { left: number; top: number; width: number },
  name: string,
  colour: string,
  filled: boolean,
): void {
  const middle = top + HEIGHT / 2;
  context.globalAlpha = 0.86;
  context.fillStyle = theme.halo;
  context.beginPath();
  context.roundRect(left, top, width, HEIGHT, HEIGHT / 2);
  context.fill();
  context.globalAlpha = 1;
  context.beginPath();
  context.arc(left + PADDING + DOT, middle, filled ? DOT : DOT - 1, 0, 2 * Math.PI);
  context.fillStyle = colour;
  context.strokeStyle = colour;
  context.lineWidth = 2;
  if (filled) context.fill();
  else context.stroke();
  context.fillStyle = theme.inks.ink;
  context.textBaseline = "middle";
  context.fillText(name, left + PADDING + 3 * DOT, middle + 0.5);
}

/** The line between two panes. */
function drawDivider(context: CanvasRenderingContext2D, pane: Pane, theme: Theme): void {
  context.fillStyle = theme.inks.soft;
  if (pane.left > 0) context.fillRect(pane.left, pane.top, 1.5, pane.height);
  else context.fillRect(pane.left, pane.top, pane.width, 1.5);
}
