/** Collects the strokes of all joints by colour and width, and draws them as few paths. */
import type { JointInks } from "./palette";
import { Paths, pathsOf } from "./paths";

type Ink = "metal" | "rope" | "spring" | "band";

/**
 * Widths of lines are rounded to multiples of this, in CSS pixels, so that lines share paths.
 * Chosen.
 */
const WIDTH_STEP = 0.5;
/**
 * A spring's number of turns (smallest, largest), the CSS pixels per turn, and the share of its
 * length that each straight end takes. Chosen.
 */
const TURNS = [2, 7] as const;
const TURN = 9;
const STRAIGHT = 0.1;
/** CSS pixels by which a line's dark or light edge is wider than the line. Chosen. */
const EDGE = 1.5;
/** Largest width of a force's arrow, and largest length of its head, in CSS pixels. Chosen. */
const STRONGEST = 5;
const HEAD = 8;
/** Smallest ratio of the length of the largest force's arrow to its width. Chosen. */
const SLIM = 6;

interface Stroke {
  ink: Ink;
  width: number;
  paths: Paths;
}

export class JointPaths {
  readonly #strokes = new Map<string, Stroke>();
  readonly #dots = new Map<Ink, Paths>();
  readonly #pins = new Paths();
  readonly #plates = new Paths();
  readonly #dashes = new Paths();
  /** By width, in CSS pixels. */
  readonly #forces = new Map<number, Paths>();
  readonly #gaps = new Paths();

  /** A path for one line, which the caller begins with moveTo. */
  line(ink: Ink, width: number): Path2D {
    const rounded = Math.max(1, WIDTH_STEP * Math.round(width / WIDTH_STEP));
    const name = `${ink} ${rounded}`;
    let stroke = this.#strokes.get(name);
    if (!stroke) this.#strokes.set(name, (stroke = { ink, width: rounded, paths: new Paths() }));
    return stroke.paths.next();
  }

  segment(ink: Ink, width: number, ax: number, ay: number, bx: number, by: number): void {
    const path = this.line(ink, width);
    path.moveTo(ax, ay);
    path.lineTo(bx, by);
  }

  dot(ink: Ink, radius: number, x: number, y: number): void {
    let paths = this.#dots.get(ink);
    if (!paths) this.#dots.set(ink, (paths = new Paths()));
    addCircle(paths.next(), radius, x, y);
  }

  /** A disc with an edge (hinge). */
  pin(radius: number, x: number, y: number): void {
    addCircle(this.#pins.next(), radius, x, y);
  }

  /** A path for one closed shape, which is drawn filled and with an edge. */
  plate(): Path2D {
    return this.#plates.next();
  }

  /** A dashed line (gear). */
  dash(ax: number, ay: number, bx: number, by: number): void {
    const path = this.#dashes.next();
    path.moveTo(ax, ay);
    path.lineTo(bx, by);
  }

  /**
   * An arrow for a force fx, fy, in units of the largest force, which is `reach` pixels long.
   * Smaller forces have proportionally shorter and narrower arrows; none is drawn below one pixel.
   */
  force(x: number, y: number, fx: number, fy: number, reach: number): void {
    const share = Math.hypot(fx, fy);
    const length = reach * share;
    if (length < 1) return;
    const width = Math.max(1, Math.round(Math.min(STRONGEST, reach / SLIM) * share));
    const path = pathsOf(this.#forces, width).next();
    const [tipX, tipY] = [x + reach * fx, y + reach * fy];
    const head = Math.min(HEAD, 0.4 * length) / share;
    path.moveTo(x, y);
    path.lineTo(tipX, tipY);
    path.moveTo(tipX - head * (fx - 0.6 * fy), tipY - head * (fy + 0.6 * fx));
    path.lineTo(tipX, tipY);
    path.lineTo(tipX - head * (fx + 0.6 * fy), tipY - head * (fy - 0.6 * fx));
  }

  /** Marks a joint that is open: a ring around its second end, and a line between the ends. */
  gap(radius: number, { ax, ay, bx, by }: { ax: number; ay: number; bx: number; by: number }): void {
    const path = this.#gaps.next();
    addCircle(path, radius, bx, by);
    path.moveTo(ax, ay);
    path.lineTo(bx, by);
  }

  draw(context: CanvasRenderingContext2D, inks: JointInks): void {
    context.lineCap = "round";
    context.lineJoin = "round";
    context.setLineDash([2, 5]);
    context.lineWidth = 1.5;
    context.strokeStyle = inks.gear;
    this.#dashes.stroke(context);
    context.setLineDash([]);
    for (const { width, paths } of this.#strokes.values()) {
      context.lineWidth = width + EDGE;
      context.strokeStyle = inks.edge;
      paths.stroke(context);
    }
    for (const { ink, width, paths } of this.#strokes.values()) {
      context.lineWidth = width;
      context.strokeStyle = inks[ink];
      paths.stroke(context);
    }
    for (const [ink, paths] of this.#dots) {
      context.fillStyle = inks[ink];
      paths.fill(context);
    }
    context.lineWidth = 1;
    context.strokeStyle = inks.edge;
    context.fillStyle = inks.metal;
    for (const paths of [this.#plates, this.#pins]) {
      paths.fill(context);
      paths.stroke(context);
    }
    context.strokeStyle = inks.force;
    for (const [width, paths] of this.#forces) {
      context.lineWidth = width;
      paths.stroke(context);
    }
    context.lineWidth = 2.5;
    context.strokeStyle = inks.open;
    this.#gaps.stroke(context);
  }
}

function addCircle(path: Path2D, radius: number, x: number, y: number): void {
  path.moveTo(x + radius, y);
  path.arc(x, y, radius, 0, 2 * Math.PI);
}

/** A zigzag from a to b with straight ends; its amplitude is `half`, but 2 to 9 pixels. */
export function addSpring(
  path: Path2D,
  ax: number,
  ay: number,
  bx: number,
  by: number,
  half: number,
): void {
  const [dx, dy] = [bx - ax, by - ay];
  const length = Math.hypot(dx, dy);
  path.moveTo(ax, ay);
  if (length > 0) {
    const side = Math.min(Math.max(half, 2), 9) / length;
    const turns = Math.min(TURNS[1], Math.max(TURNS[0], Math.round(length / TURN)));
    for (let i = 0; i < 2 * turns; i++) {
      const t = STRAIGHT + ((1 - 2 * STRAIGHT) * (i + 0.5)) / (2 * turns);
      const out = i % 2 === 0 ? side : -side;
      path.lineTo(ax + t * dx - out * dy, ay + t * dy + out * dx);
    }
  }
  path.lineTo(bx, by);
}

/**
 * A rope of a given length from a to b. A slack rope is a parabola with the sag
 *   0.5 sqrt((length - chord) (length + chord / 2)),
 * which is the sag of the parabola of that length where the rope is nearly taut, and half the
 * length where both ends meet.
 */
export function addRope(
  path: Path2D,
  ax: number,
  ay: number,
  bx: number,
  by: number,
  length: number,
): void {
  const chord = Math.hypot(bx - ax, by - ay);
  const sag = 0.5 * Math.sqrt(Math.max(0, length - chord) * (length + 0.5 * chord));
  path.moveTo(ax, ay);
  // A quadratic curve passes halfway between its chord and its control point.
  if (sag > 0.5) path.quadraticCurveTo(0.5 * (ax + bx), 0.5 * (ay + by) + 2 * sag, bx, by);
  else path.lineTo(bx, by);
}

/**
 * A rectangle about x, y. Its axis is the unit vector ux, uy; it is 2 `half` wide, and `stretch`
 * times as long.
 */
export function addSquare(
  path: Path2D,
  x: number,
  y: number,
  ux: number,
  uy: number,
  half: number,
  stretch: number,
): void {
  const [ax, ay, bx, by] = [stretch * half * ux, stretch * half * uy, -half * uy, half * ux];
  path.moveTo(x - ax - bx, y - ay - by);
  path.lineTo(x + ax - bx, y + ay - by);
  path.lineTo(x + ax + bx, y + ay + by);
  path.lineTo(x - ax + bx, y - ay + by);
  path.closePath();
}
