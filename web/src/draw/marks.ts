/** Draws a scene's own marks (Mark in scene.ts). */
import type { Mark } from "../scene/scene";
import type { Camera, Pane } from "./camera";
import type { Theme } from "./palette";

/** Width of outlines, in CSS pixels. */
const OUTLINE = 2;
const TEXT_SIZE = 14;
const FONT = 'system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", sans-serif';

export function drawMarks(
  context: CanvasRenderingContext2D,
  camera: Camera,
  pane: Pane,
  theme: Theme,
  marks: readonly Mark[],
): void {
  context.lineJoin = "round";
  context.lineCap = "round";
  for (const mark of marks) {
    const colour = theme.inks[mark.ink] ?? theme.inks.ink;
    context.strokeStyle = colour;
    context.fillStyle = colour;
    if (mark.kind === "line") {
      if (mark.filled) context.fillStyle = theme.fills[mark.ink] ?? colour;
      drawLine(context, camera, pane, mark);
      continue;
    }
    context.save();
    context.translate(...camera.toScreen(mark.x, mark.y, pane));
    if (mark.kind === "text") drawText(context, theme, mark);
    else if (mark.kind === "figure") drawFigure(context, camera.scale, mark);
    else {
      context.fillStyle = theme.fills[mark.ink] ?? colour;
      drawShape(context, camera.scale, mark);
    }
    context.restore();
  }
}

type Of<Kind extends Mark["kind"]> = Extract<Mark, { kind: Kind }>;

function drawLine(
  context: CanvasRenderingContext2D,
  camera: Camera,
  pane: Pane,
  { points, width = OUTLINE, dashed = false, opacity = 1, filled = false }: Of<"line">,
): void {
  context.beginPath();
  for (const [x, y] of points) context.lineTo(...camera.toScreen(x, y, pane));
  context.globalAlpha = opacity;
  context.lineWidth = width;
  context.setLineDash(dashed ? [2 * width + 3, 2 * width + 4] : []);
  if (filled) context.fill();
  else context.stroke();
  context.setLineDash([]);
  context.globalAlpha = 1;
}

/** Draws a circle or box about the canvas' origin. */
function drawShape(
  context: CanvasRenderingContext2D,
  scale: number,
  mark: Of<"circle"> | Of<"box">,
): void {
  context.globalAlpha = mark.opacity ?? 1;
  context.beginPath();
  if (mark.kind === "circle") {
    context.arc(0, 0, Math.max(0, mark.radius) * scale, 0, 2 * Math.PI);
  } else {
    const [hx, hy] = [mark.halfWidth * scale, mark.halfHeight * scale];
    context.rotate(-(mark.angle ?? 0));
    context.roundRect(-hx, -hy, 2 * hx, 2 * hy, Math.max(0, mark.round ?? 0) * scale);
  }
  context.lineWidth = OUTLINE;
  if (mark.filled) context.fill();
  else context.stroke();
}

/** A rounded box with eyes, which look to the left or right (`facing`). */
function drawFigure(
  context: CanvasRenderingContext2D,
  scale: number,
  { halfWidth, halfHeight, facing }: Of<"figure">,
): void {
  const [hx, hy] = [halfWidth * scale, halfHeight * scale];
  context.beginPath();
  context.roundRect(-hx, -hy, 2 * hx, 2 * hy, 0.6 * Math.min(hx, hy));
  context.fill();
  context.globalAlpha = 0.35;
  context.lineWidth = 1.5;
  context.strokeStyle = "#12161f";
  context.stroke();
  context.globalAlpha = 1;
  const eyes = (radius: number, offset: number, colour: string) => {
    context.beginPath();
    for (const side of [-1, 1]) {
      const at = hx * (0.24 * facing + 0.32 * side + offset * facing);
      context.moveTo(at + radius, -0.5 * hy);
      context.arc(at, -0.5 * hy, radius, 0, 2 * Math.PI);
    }
    context.fillStyle = colour;
    context.fill();
  };
  eyes(0.25 * hx, 0, "#ffffff");
  eyes(0.13 * hx, 0.1, "#12161f");
}

/** Text of a fixed size on the screen, with an outline in the background's colour. */
function drawText(
  context: CanvasRenderingContext2D,
  theme: Theme,
  { text, size = TEXT_SIZE }: Of<"text">,
): void {
  context.font = `600 ${size}px ${FONT}`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.lineWidth = Math.max(3, 0.3 * size);
  context.strokeStyle = theme.halo;
  context.strokeText(text, 0, 0);
  context.fillText(text, 0, 0);
}
