/**
 * Draws Minkowski sums: the outline of the sum about the first shape's centre, and the second shape
 * as a point.
 */
import type { Sum } from "../scene/frame";
import type { Theme } from "./palette";

/** The canvas' origin is the place that the sums are relative to. */
export function drawSums(
  context: CanvasRenderingContext2D,
  sums: readonly Sum[],
  scale: number,
  theme: Theme,
): void {
  for (const { origin, point, overlaps, edge, outline } of sums) {
    const colour = overlaps ? theme.sumOverlapping : theme.sum;
    context.strokeStyle = colour;
    context.fillStyle = colour;
    context.lineJoin = "round";
    context.lineWidth = 2;
    context.beginPath();
    for (let i = 0; i < outline.length; i += 2)
      context.lineTo((origin[0] + outline[i]) * scale, -(origin[1] + outline[i + 1]) * scale);
    context.closePath();
    context.stroke();
    context.globalAlpha = 0.12;
    context.fill();
    context.globalAlpha = 1;
    context.lineWidth = 1;
    context.beginPath();
    context.moveTo(point[0] * scale, -point[1] * scale);
    context.lineTo(edge[0] * scale, -edge[1] * scale);
    context.stroke();
    for (const [place, radius] of [[origin, 2.5], [point, 5]] as const) {
      context.beginPath();
      context.arc(place[0] * scale, -place[1] * scale, radius, 0, 2 * Math.PI);
      context.fill();
    }
  }
}
