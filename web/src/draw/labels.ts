/** Which engine is which: a name in each pane and a line between them, or a key to the outlines. */
import type { Camera, Pane } from "./camera";
import type { Layer } from "./layer";
import { cssColour, type Theme } from "./palette";

const NAMES = { thud: "thud", box2d: "Box2D" } as const;
const FONT = '600 14px system-ui, -apple-system, "Segoe UI", Roboto, sans-serif';
/** CSS pixels: of a name's plate, and between it and what lies above. */
const HEIGHT = 28;
const PADDING = 11;
const GAP = 10;

export function drawLabels(
  layer: Layer,
  camera: Camera,
  theme: Theme,
  rival: "side" | "over",
): void {
  const { panes } = camera;
  const box2d = cssColour(theme.box2d);
  const thud = theme.inks.accent;
  if (rival === "over" || panes.length < 2) {
    layer.inPane(panes[0], (context) => {
      const [, top] = freeCorner(camera, panes[0]);
      const names = [NAMES.thud, `${NAMES.box2d}, outlined`];
      const widths = names.map((name) => plateWidth(context, name));
      const left = panes[0].middleX - (widths[0] + GAP + widths[1]) / 2;
      drawPlate(context, theme, left, top, names[0], thud, true);
      drawPlate(context, theme, left + widths[0] + GAP, top, names[1], box2d, false);
    });
    return;
  }
  panes.forEach((pane, i) =>
    layer.inPane(pane, (context) => {
      const [, top] = freeCorner(camera, pane);
      const name = i === 0 ? NAMES.thud : NAMES.box2d;
      const left = pane.middleX - plateWidth(context, name) / 2;
      drawPlate(context, theme, left, top, name, i === 0 ? thud : box2d, true);
      if (i > 0) drawDivider(context, pane, theme);
    }),
  );
}

/** The upper left corner of what the controls leave free of a pane. */
function freeCorner({ insets }: Camera, pane: Pane): [x: number, y: number] {
  return [Math.max(pane.left, insets.left) + GAP, Math.max(pane.top, insets.top) + GAP];
}

function plateWidth(context: CanvasRenderingContext2D, name: string): number {
  context.font = FONT;
  return context.measureText(name).width + 2 * PADDING + 16;
}

/** A name on a plate, with a dot or ring of the bodies' look before it. */
function drawPlate(
  context: CanvasRenderingContext2D,
  theme: Theme,
  x: number,
  y: number,
  name: string,
  colour: string,
  filled: boolean,
): void {
  context.globalAlpha = 0.86;
  context.fillStyle = theme.halo;
  context.beginPath();
  context.roundRect(x, y, plateWidth(context, name), HEIGHT, HEIGHT / 2);
  context.fill();
  context.globalAlpha = 1;
  context.beginPath();
  context.arc(x + PADDING + 4, y + HEIGHT / 2, filled ? 5 : 4, 0, 2 * Math.PI);
  context.fillStyle = colour;
  context.strokeStyle = colour;
  context.lineWidth = 2;
  if (filled) context.fill();
  else context.stroke();
  context.fillStyle = theme.inks.ink;
  context.textBaseline = "middle";
  context.textAlign = "left";
  context.fillText(name, x + PADDING + 16, y + HEIGHT / 2 + 0.5);
}

/** At the edge of the second pane. */
function drawDivider(context: CanvasRenderingContext2D, pane: Pane, theme: Theme): void {
  context.fillStyle = theme.inks.soft;
  if (pane.left > 0) context.fillRect(pane.left, pane.top, 1.5, pane.height);
  else context.fillRect(pane.left, pane.top, pane.width, 1.5);
}
