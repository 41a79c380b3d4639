/**
 * The plane of speed and accuracy: time of a step to the right, overlap upwards, both logarithmic,
 * so that lower left is better. Of SVG, because its points are hovered, focused and pressed.
 */
import { make } from "../../page/dom";
import { errorText, timeText } from "./text";

export interface PlanePoint {
  key: string;
  engine: "thud" | "box2d";
  label: string;
  /** Milliseconds of a step. */
  time: number;
  /** In length scales. */
  error: number;
  /** Measured at this moment. */
  live?: boolean;
  /** Points of a row are joined. */
  row?: string;
  /** Goes to that setting. */
  go?: () => void;
}

/** Of the drawing; on a phone it must leave room for the knobs. */
const WIDTH = 360;
const HEIGHT = { usual: 220, phone: 150 };
const PHONE = matchMedia("(width < 40em), (height <= 31.25em)");
const EDGE = { left: 40, right: 12, top: 12, bottom: 34 };
/** Smaller ones are drawn here: nobody can tell them from none. */
const LEAST_ERROR = 1e-6;
const LEAST_TIME = 1e-3;
/** Of a label, per letter. */
const LETTER = 6.1;

/** What a point is drawn with. */
interface Dot {
  element: SVGElement;
  mark: SVGElement;
  text: SVGElement;
}

interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
}

/** Powers of ten around all values, at least one decade, and not through the outermost values but
 * those at `least`. */
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
  /** By key: they stay while figures change, so that they can be pressed and keep the focus. */
  readonly #dots = new Map<string, Dot>();
  #points: readonly PlanePoint[] = [];
  #height = HEIGHT.usual;
  #focused: string | null = null;
  /** Of which the line below tells: the last that was pointed at or focused. */
  #told: string | null = null;

  constructor() {
    this.element = make("figure", { class: "plane" });
    this.element.append(this.#svg, this.#detail);
    this.#svg.append(this.#ground);
    this.#svg.addEventListener("keydown", (event) => this.#move(event));
    this.#svg.addEventListener("pointerleave", () => (this.#told = this.#focused));
  }

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
    // A press counts for the point that it began on, though the scales may move it meanwhile.
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

  /** Arrow keys go from point to point, Enter to the setting: one stop of the Tab key in all. */
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
    // They are the scene's keys elsewhere.
    event.preventDefault();
    event.stopPropagation();
  }

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

function figuresOf({ label, time, error }: PlanePoint): string {
  return `${label}: ${timeText(time)} a step, worst overlap ${errorText(error)}`;
}

function along(value: number, [from, to]: [number, number], low: number, high: number): number {
  return low + ((Math.log10(value) - from) / (to - from)) * (high - low);
}

function around({ x, y }: { x: number; y: number }): Box {
  return { x: x - 5, y: y - 5, width: 10, height: 10 };
}

/** Beside the point where nothing else stands yet; null if there is no such place. */
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

/** 0.01, 1, 100; where digits would be many, 10⁻⁵. */
function plainPower(power: number): string {
  if (power >= -3 && power <= 4) return String(Number((10 ** power).toPrecision(1)));
  const digits = [...String(power)].map((letter) =>
    letter === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(letter)],
  );
  return `10${digits.join("")}`;
}

function svg(name: string, attributes: Record<string, string | number>): SVGElement {
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  set(element, attributes);
  return element;
}

function set(element: SVGElement, attributes: Record<string, string | number>): void {
  for (const [key, value] of Object.entries(attributes)) {
    const text = typeof value === "number" ? String(Number(value.toFixed(2))) : value;
    element.setAttribute(key, text);
  }
}
