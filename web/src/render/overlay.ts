/** What lies over the bodies: a character, the engine's debug drawing, the line that pulls. */
import { DRAW_STYLES, type DrawLists, type World } from "thud";
import type { Camera } from "../camera";
import type { Character } from "../character";
import { islandColour, type Theme } from "./palette";

export const OVERLAYS = [
  "contacts",
  "normals",
  "bounds",
  "cells",
  "islands",
  "sleeping",
  "timings",
] as const;
export type OverlayName = (typeof OVERLAYS)[number];

const BOUNDS = DRAW_STYLES.indexOf("bounds");
const CELL = DRAW_STYLES.indexOf("cell");
const CONTACT = DRAW_STYLES.indexOf("contact");
const NORMAL = DRAW_STYLES.indexOf("normal");

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
  ): void {
    const wanted = ["contacts", "normals", "bounds", "cells", "islands"] as const;
    const any = wanted.some((name) => on.has(name));
    const empty = !any && !pull && !character;
    if (empty && this.#clean) return;
    const context = this.#context;
    context.setTransform(this.#ratio, 0, 0, this.#ratio, 0, 0);
    context.clearRect(0, 0, camera.width, camera.height);
    this.#clean = empty;
    if (character) drawCharacter(context, camera, theme, character, alpha);
    if (any) {
      const { x0, y0, x1, y1 } = camera.visible;
      const lists = world.debugDraw({
        shapes: on.has("islands"),
        islands: on.has("islands"),
        bounds: on.has("bounds"),
        cells: on.has("cells"),
        contacts: on.has("contacts") || on.has("normals"),
        origin: [camera.x, camera.y],
        lower: [x0, y0],
        upper: [x1, y1],
      });
      context.translate(camera.middleX, camera.middleY);
      drawLists(context, lists, camera.scale, theme, on);
      context.translate(-camera.middleX, -camera.middleY);
    }
    if (pull) drawPull(context, camera, theme, pull);
  }
}

function drawLists(
  context: CanvasRenderingContext2D,
  lists: DrawLists,
  scale: number,
  theme: Theme,
  on: ReadonlySet<OverlayName>,
): void {
  const boxes = { [BOUNDS]: new Path2D(), [CELL]: new Path2D() };
  const islands = new Map<number, Path2D>();
  const { shapes, lines, points } = lists;
  for (let i = 0; i < shapes.length; i += 9) {
    const [style, island] = [shapes[i + 7], shapes[i + 8]];
    if (style === BOUNDS || style === CELL) addOutline(boxes[style], shapes, i, scale);
    else if (island >= 0) {
      let path = islands.get(island);
      if (!path) islands.set(island, (path = new Path2D()));
      addOutline(path, shapes, i, scale);
    }
  }
  for (const [island, path] of islands) {
    context.fillStyle = islandColour(island, theme.dark);
    context.fill(path);
  }
  const linePaths = { [BOUNDS]: boxes[BOUNDS], [CELL]: boxes[CELL], [NORMAL]: new Path2D() };
  for (let i = 0; i < lines.length; i += 5) {
    const path = linePaths[lines[i + 4]];
    path?.moveTo(lines[i] * scale, -lines[i + 1] * scale);
    path?.lineTo(lines[i + 2] * scale, -lines[i + 3] * scale);
  }
  const stroke = (path: Path2D, colour: string, width: number) => {
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.stroke(path);
  };
  stroke(linePaths[CELL], theme.cell, 1);
  stroke(linePaths[BOUNDS], theme.bounds, 1);
  if (on.has("normals")) stroke(linePaths[NORMAL], theme.normal, 1.5);
  if (on.has("contacts")) {
    const radius = Math.min(3.5, Math.max(1.2, 0.08 * scale));
    context.beginPath();
    for (let i = 0; i < points.length; i += 3) {
      if (points[i + 2] !== CONTACT) continue;
      const [x, y] = [points[i] * scale, -points[i + 1] * scale];
      context.moveTo(x + radius, y);
      context.arc(x, y, radius, 0, 2 * Math.PI);
    }
    context.fillStyle = theme.contact;
    context.fill();
  }
}

function addOutline(path: Path2D, shapes: Float32Array, at: number, scale: number): void {
  const [x, y, hx, hy, c, s, round] = shapes.subarray(at, at + 7);
  if (round !== 0) {
    path.moveTo((x + hx) * scale, -y * scale);
    path.arc(x * scale, -y * scale, hx * scale, 0, 2 * Math.PI);
    return;
  }
  const corner = (a: number, b: number): [number, number] => [
    (x + a * c * hx - b * s * hy) * scale,
    -(y + a * s * hx + b * c * hy) * scale,
  ];
  path.moveTo(...corner(-1, -1));
  path.lineTo(...corner(1, -1));
  path.lineTo(...corner(1, 1));
  path.lineTo(...corner(-1, 1));
  path.closePath();
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
