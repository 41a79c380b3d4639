/** What lies over the bodies: a character, the engine's debug drawing, the line that pulls. */
import type { World } from "thud";
import type { Camera } from "../camera";
import type { Character } from "../character";
import type { Sum } from "../sums";
import { DRAWN, drawLists } from "./debug";
import type { Theme } from "./palette";
import { drawSums } from "./sums";

export const OVERLAYS = [
  "contacts",
  "normals",
  "bounds",
  "cells",
  "islands",
  "sleeping",
  "timings",
  "axes",
  "pairs",
  "motions",
] as const;
export type OverlayName = (typeof OVERLAYS)[number];

export class Overlay {
  readonly #context: CanvasRenderingContext2D;
  #ratio = 1;
  #clean = false;

  constructor(context: CanvasRenderingContext2D) {
    this.#context = context;
  }

  resize(width: number, height: number, ratio: number): void {
    this.#context.canvas.width = Math.round(width * ratio);
    this.#context.canvas.height = Math.round(height * ratio);
    this.#ratio = ratio;
    this.#clean = true;
  }

  draw(
    world: World,
    camera: Camera,
    theme: Theme,
    on: ReadonlySet<OverlayName>,
    pull: readonly [from: readonly [number, number], to: readonly [number, number]] | null,
    character: Character | null,
    alpha: number,
    sums: readonly Sum[],
  ): void {
    const any = DRAWN.some((name) => on.has(name));
    const empty = !any && !pull && !character && sums.length === 0;
    if (empty && this.#clean) return;
    const context = this.#context;
    context.setTransform(this.#ratio, 0, 0, this.#ratio, 0, 0);
    context.clearRect(0, 0, camera.width, camera.height);
    this.#clean = empty;
    if (character) drawCharacter(context, camera, theme, character, alpha);
    context.translate(camera.middleX, camera.middleY);
    drawSums(context, sums, camera.scale, theme);
    if (any) this.#drawDebug(world, camera, theme, on);
    context.translate(-camera.middleX, -camera.middleY);
    if (pull) drawPull(context, camera, theme, pull);
  }

  #drawDebug(world: World, camera: Camera, theme: Theme, on: ReadonlySet<OverlayName>): void {
    const { x0, y0, x1, y1 } = camera.visible;
    const view = { origin: [camera.x, camera.y], upper: [x1, y1] } as const;
    // The intervals stand on the lower edge of what the controls leave free.
    const free = y0 + camera.insets.bottom / camera.scale;
    if (on.has("axes")) {
      const lists = world.debugDraw({ axes: true, ...view, lower: [x0, free] });
      drawLists(this.#context, lists, camera.scale, theme, on);
    }
    const lists = world.debugDraw({
      shapes: on.has("islands"),
      islands: on.has("islands"),
      bounds: on.has("bounds"),
      cells: on.has("cells"),
      contacts: on.has("contacts") || on.has("normals"),
      pairs: on.has("pairs"),
      motions: on.has("motions"),
      ...view,
      lower: [x0, y0],
    });
    drawLists(this.#context, lists, camera.scale, theme, on);
  }
}

/** A rounded box that looks where it goes. */
function drawCharacter(
  context: CanvasRenderingContext2D,
  camera: Camera,
  theme: Theme,
  character: Character,
  alpha: number,
): void {
  const { halfWidth, halfHeight, facing } = character;
  const [x, y] = camera.toScreen(...character.place(alpha));
  const [hx, hy] = [halfWidth * camera.scale, halfHeight * camera.scale];
  context.beginPath();
  context.roundRect(x - hx, y - hy, 2 * hx, 2 * hy, 0.6 * hx);
  context.fillStyle = theme.character;
  context.fill();
  const eyes = (radius: number, offset: number, colour: string) => {
    context.beginPath();
    for (const side of [-1, 1]) {
      const at = x + hx * (0.35 * facing + 0.32 * side + offset * facing);
      context.moveTo(at + radius, y - 0.5 * hy);
      context.arc(at, y - 0.5 * hy, radius, 0, 2 * Math.PI);
    }
    context.fillStyle = colour;
    context.fill();
  };
  eyes(0.27 * hx, 0, "#ffffff");
  eyes(0.14 * hx, 0.1, "#12161f");
}

function drawPull(
  context: CanvasRenderingContext2D,
  camera: Camera,
  theme: Theme,
  [from, to]: readonly [readonly [number, number], readonly [number, number]],
): void {
  const [x0, y0] = camera.toScreen(...from);
  const [x1, y1] = camera.toScreen(...to);
  context.strokeStyle = theme.pull;
  context.fillStyle = theme.pull;
  context.lineWidth = 2;
  context.lineCap = "round";
  context.beginPath();
  context.moveTo(x0, y0);
  context.lineTo(x1, y1);
  context.stroke();
  context.beginPath();
  context.arc(x0, y0, 4, 0, 2 * Math.PI);
  context.fill();
}
