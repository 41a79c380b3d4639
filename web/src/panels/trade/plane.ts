/**
 * `Plane`: a scatter plot of speed and accuracy, with a point for each setting. The time per step
 * increases to the right and the overlap upwards, both on logarithmic axes, so that lower left is
 * better. It is SVG, so that points can be hovered, focused and pressed.
 */
import { make } from "../../page/dom";
import { errorText, timeText } from "./text";

export interface PlanePoint {
  /** Identifies the point from one `show` to the next. */
  key: string;
  engine: "thud" | "box2d";
  label: string;
  /** Milliseconds per step. */
  time: number;
  /** The worst overlap in length scales, which are sizes of a typical body. */
  error: number;
  /** The setting runs at present, so that the point moves. */
  live?: boolean;
  /** Points with the same row are joined by a line. */
  row?: string;
  /** Chooses the point's setting when the point is pressed. */
  go?: () => void;
}

/** Size and margins of the plot in units of its viewBox. On a phone it is lower, to leave room for
 * the controls. Chosen. */
const WIDTH = 360;
const HEIGHT = { usual: 220, phone: 150 };
const PHONE = matchMedia("(width < 40em), (height <= 31.25em)");
const EDGE = { left: 40, right: 12, top: 12, bottom: 34 };
/** Lower ends of the axes, in length scales and milliseconds: smaller values, such as 0, are drawn
 * there. Chosen. */
const LEAST_ERROR = 1e-6;
const LEAST_TIME = 1e-3;
/** Estimated width of a label's letter, in units of the viewBox. Chosen. */
const LETTER = 6.1;

/** The elements of a point: its group, and in that the mark and the label. */
interface Dot {
  element: SVGElement;
  mark: SVGElement;
  text: SVGElement;
}

/** A rectangle in the units of the viewBox. */
interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
}

/** The exponents of the powers of ten between which an axis lies: around all values with a margin
 * of 0.05, at least one decade apart, and not below that of `least`. */
function decades(values: readonly number[], least: number): [from: number, to: number] {
  const lowest = Math.log10(Math.min(...values)) - 0.05;
  const from = Math.floor(Math.max(Math.log10(least), lowest));
  return [from, Math.max(from + 1, Math.ceil(Math.log10(Math.max(...values)) + 0.05))];
}

export class Plane {
  readonly element: HTMLElement;
  readonly #svg = svg("svg", {
    role: "group",
    "aria-label": "Time of a step to the right, overlap upwards; lower left is better",
  });
  readonly #detail = make("p", { class: "plane-detail" });
  /** Axes and the lines that join points. */
  readonly #ground = svg("g", {});
  /** By the points' keys. Elements stay while figures change, so that a press is not interrupted
   * and the focus is kept. */
  readonly #dots = new Map<string, Dot>();
  #points: readonly PlanePoint[] = [];
  #height = HEIGHT.usual;
  /** Key of the point that was focused last. */
  #focused: string | null = null;
  /** Key of the point that the line below describes: the last one that was hovered or focused. */
  #told: string | null = null;

  constructor() {
    this.element = make("figure", { class: "plane" });
    this.element.append(this.#svg, this.#detail);
    this.#svg.append(this.#ground);
    this.#svg.addEventListener("keydown", (event) => this.#move(event));
    this.#svg.addEventListener("pointerleave", () => (this.#told = this.#focused));
  }

  /** Draws points; without any, the text `nothing`. */
  show(points: readonly PlanePoint[], nothing: string): void {
    this.#points = points;
    this.#height = PHONE.matches ? HEIGHT.phone : HEIGHT.usual;
    this.#svg.setAttribute("viewBox", `0 0 ${WIDTH} ${this.#height}`);
    this.#ground.replaceChildren();
    for (const [key, { element }] of this.#dots) {
      if (points.some((point) => point.key === key)) continue;
      element.remove();
      this.#dots.delete(key);
    }
    if (points.length === 0) {
      const text = svg("text", { x: WIDTH / 2, y: this.#height / 2, class: "nothing" });
      text.textContent = nothing;
      this.#ground.append(text);
      this.#detail.textContent = "";
      return;
    }
    const times = points.map(({ time }) => Math.max(LEAST_TIME, time));
    const timeDecades = decades(times, LEAST_TIME);
    const errors = points.map(({ error }) => Math.max(LEAST_ERROR, error));
    const errorDecades = decades(errors, LEAST_ERROR);
    const place = ({ time, error }: Pick<PlanePoint, "time" | "error">) => ({
      x: along(Math.max(LEAST_TIME, time), timeDecades, EDGE.left, WIDTH - EDGE.right),
      y: along(Math.max(LEAST_ERROR, error), errorDecades, this.#height - EDGE.bottom, EDGE.top),
    });
    this.#drawAxes(timeDecades, errorDecades, place);
    this.#joinRows(points, place);
    const taken: Box[] = points.map((point) => around(place(point)));
    for (const point of points) this.#drawPoint(point, place(point), taken);
    this.#tell(this.#pointOf(this.#told) ?? points.find(({ live }) => live));
  }

  #drawAxes(
    times: [number, number],
    errors: [number, number],
    place: (at: { time: number; error: number }) => { x: number; y: number },
  ): void {
    for (let power = times[0]; power <= times[1]; power++) {
      const { x } = place({ time: 10 ** power, error: 1 });
      this.#line(x, EDGE.top, x, this.#height - EDGE.bottom, "grid");
      this.#text(x, this.#height - EDGE.bottom + 13, plainPower(power), "tick middle");
    }
    for (let power = errors[0]; power <= errors[1]; power++) {
      const { y } = place({ time: 1, error: 10 ** power });
      this.#line(EDGE.left, y, WIDTH - EDGE.right, y, "grid");
      this.#text(EDGE.left - 5, y + 4, plainPower(power), "tick end");
    }
    this.#text(WIDTH - EDGE.right, this.#height - 5, "ms a step →", "axis end");
    this.#text(2, this.#height - 5, "↑ worst overlap", "axis");
    this.#text(EDGE.left + 6, this.#height - EDGE.bottom - 6, "↙ better", "better");
  }

  /** Draws the lines that join the points of a row. */
  #joinRows(
    points: readonly PlanePoint[],
    place: (at: PlanePoint) => { x: number; y: number },
  ): void {
    for (const row of new Set(points.map((point) => point.row))) {
      if (row === undefined) continue;
      const members = points.filter((point) => point.row === row);
      const ends = members.map(place).map(({ x, y }) => `${x.toFixed(1)},${y.toFixed(1)}`);
      const line = svg("polyline", { points: ends.join(" "), class: `row ${members[0].engine}` });
      this.#ground.append(line);
    }
  }

  /** Draws a point, and its label if there is room. `taken`: boxes that labels must not cover. */
  #drawPoint(point: PlanePoint, { x, y }: { x: number; y: number }, taken: Box[]): void {
    const { key, engine, label, live, go } = point;
    const first = this.#pointOf(this.#focused) ?? this.#points[0];
    const figures = figuresOf(point);
    const { element, mark, text } = this.#dots.get(key) ?? this.#addDot(point);
    set(element, {
      class: `dot ${engine}${live ? " live" : ""}`,
      transform: `translate(${x.toFixed(2)} ${y.toFixed(2)})`,
      tabindex: point === first ? 0 : -1,
      role: go ? "button" : "img",
      "aria-label": go ? `${figures}; go to this setting` : figures,
    });
    if (engine === "thud") set(mark, { r: live ? 6 : 4.5 });
    const at = freePlace(label, x, y, this.#height - EDGE.bottom, taken);
    text.textContent = at ? label : "";
    if (!at) return;
    taken.push(at);
    set(text, { x: at.x - x, y: at.y + at.height - 3 - y });
  }

  /** Creates the elements of a point and their listeners: a circle for thud, a square for Box2D. */
  #addDot({ key, engine }: PlanePoint): Dot {
    const element = svg("g", { "data-point": key });
    const mark =
      engine === "thud"
        ? svg("circle", {})
        : svg("rect", { x: -4.2, y: -4.2, width: 8.4, height: 8.4 });
    const text = svg("text", {});
    element.append(svg("circle", { r: 15, class: "reach" }), mark, text);
    const tell = () => {
      this.#told = key;
      this.#tell(this.#pointOf(key));
    };
    element.addEventListener("pointerenter", tell);
    element.addEventListener("focus", () => {
      this.#focused = key;
      tell();
    });
    // A press counts for the point on which it began, even if a change of scale moves the point.
    const hold = ({ pointerId }: PointerEvent) => element.setPointerCapture(pointerId);
    element.addEventListener("pointerdown", hold);
    element.addEventListener("click", () => this.#pointOf(key)?.go?.());
    this.#svg.append(element);
    const dot = { element, mark, text };
    this.#dots.set(key, dot);
    return dot;
  }

  #pointOf(key: string | null): PlanePoint | undefined {
    return this.#points.find((point) => point.key === key);
  }

  /** Arrow keys move the focus from point to point, Enter and Space choose the point's setting. The
   * Tab key stops only once in the plot. */
  #move(event: KeyboardEvent): void {
    const by = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
    const at = this.#points.findIndex(({ key }) => key === this.#focused);
    if (by !== undefined && at >= 0) {
      const { length } = this.#points;
      const next = this.#dots.get(this.#points[(at + by + length) % length].key)!.element;
      set(this.#dots.get(this.#points[at].key)!.element, { tabindex: -1 });
      set(next, { tabindex: 0 });
      next.focus();
    } else if (event.key === "Enter" || event.key === " ") {
      this.#points[at]?.go?.();
    } else {
      return;
    }
    // Outside the plot these keys are shortcuts of the page or keys of a game.
    event.preventDefault();
    event.stopPropagation();
  }

  /** Describes a point in the line below the plot. */
  #tell(point: PlanePoint | undefined): void {
    this.#detail.textContent = point ? figuresOf(point) : "";
  }

  #line(x1: number, y1: number, x2: number, y2: number, kind: string): void {
    this.#ground.append(svg("line", { x1, y1, x2, y2, class: kind }));
  }

  #text(x: number, y: number, text: string, kind: string): void {
    const element = svg("text", { x, y, class: kind, "aria-hidden": "true" });
    element.textContent = text;
    this.#ground.append(element);
  }
}

/** A point's description. */
function figuresOf({ label, time, error }: PlanePoint): string {
  return `${label}: ${timeText(time)} a step, worst overlap ${errorText(error)}`;
}

/** The coordinate of a value on a logarithmic axis whose ends are at `low` and `high`. */
function along(value: number, [from, to]: [number, number], low: number, high: number): number {
  return low + ((Math.log10(value) - from) / (to - from)) * (high - low);
}

/** The box that a point's mark covers. */
function around({ x, y }: { x: number; y: number }): Box {
  return { x: x - 5, y: y - 5, width: 10, height: 10 };
}

/** A place for a label beside the point (x, y) that is inside the plot and covers no box of
 * `taken`; null if there is none. */
function freePlace(
  label: string,
  x: number,
  y: number,
  bottom: number,
  taken: readonly Box[],
): Box | null {
  const [width, height] = [LETTER * label.length, 13];
  const places = [
    { x: x + 8, y: y - 7 },
    { x: x - 8 - width, y: y - 7 },
    { x: x - width / 2, y: y - 20 },
    { x: x - width / 2, y: y + 7 },
    { x: x + 6, y: y - 18 },
    { x: x + 6, y: y + 5 },
    { x: x - 6 - width, y: y - 18 },
    { x: x - 6 - width, y: y + 5 },
  ];
  for (const place of places) {
    const box = { ...place, width, height };
    const inside =
      box.x >= EDGE.left && box.x + width <= WIDTH - 2 && box.y >= 0 && box.y + height <= bottom;
    if (inside && !taken.some((other) => overlap(box, other))) return box;
  }
  return null;
}

function overlap(a: Box, b: Box): boolean {
  return (
    a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height
  );
}

/** A power of ten as text: "0.01", "1", "100"; "10⁻⁵" where it would have many digits. */
function plainPower(power: number): string {
  if (power >= -3 && power <= 4) return String(Number((10 ** power).toPrecision(1)));
  const digits = [...String(power)].map((letter) =>
    letter === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(letter)],
  );
  return `10${digits.join("")}`;
}

/** Creates an SVG element with attributes. */
function svg(name: string, attributes: Record<string, string | number>): SVGElement {
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  set(element, attributes);
  return element;
}

/** Sets attributes; numbers are rounded to two decimals. */
function set(element: SVGElement, attributes: Record<string, string | number>): void {
  for (const [key, value] of Object.entries(attributes)) {
    const text = typeof value === "number" ? String(Number(value.toFixed(2))) : value;
    element.setAttribute(key, text);
  }
}
