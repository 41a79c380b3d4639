/**
 * The resolution of one collision as five small pictures: the lecture's four steps for an overlap,
 * and beside them where the swept shapes meet.
 */
import type { Vec2 } from "thud";
import { make } from "../../page/dom";
import type { Collision, Places } from "../../worker/microscope";
import { numberText } from "./values";

/** Units of a picture's view box, and the part of it that the shapes may take. Chosen. */
const SIZE = 120;
const FILL = 0.8;
/** An arrow is at most so long, in the same units. Chosen. */
const ARROW = 34;

/** Speeds far below this one, length/s, have no arrow that can be seen. Chosen. */
const SLOW = 1e-2;

type Shape = Places[number];

interface Arrow {
  from: Vec2;
  along: Vec2;
}

interface Picture {
  title: string;
  text: string;
  places: Places;
  /** Where the shapes were before, drawn dashed. */
  ghosts?: Places;
  arrows?: readonly Arrow[];
}

/** The pictures as a list. */
export function resolutionPictures(found: Collision): HTMLElement {
  const items = picturesOf(found).map((picture) => {
    const caption = make("div", {}, make("b", {}, picture.title), ` ${picture.text}`);
    return make("li", {}, drawing(picture, found), caption);
  });
  return make("ol", { class: "resolution", id: "scope-pictures" }, ...items);
}

function picturesOf(found: Collision): Picture[] {
  const { resolution: r, formula, normal, timeStep } = found;
  // An overlap that was there before the step has come about in the one before it.
  const step = found.arriving ? "the step" : "the step before";
  const share = (fraction: number) => `${numberText(fraction)} of ${step}`;
  const speeds = (first: Vec2, second: Vec2): Arrow[] => [
    { from: r.apart[0].center, along: first },
    { from: r.apart[1].center, along: second },
  ];
  const pictures: Picture[] = [
    {
      title: "Overlap found.",
      text: r.found
        ? `At the end of ${step} they are ${numberText(r.depth)} deep in each other.`
        : `They do not overlap at the end of ${step}.`,
      places: r.end,
      ghosts: r.start,
    },
    {
      title: r.time === null ? "Pushed apart." : "Moved back.",
      text:
        r.time === null
          ? `They overlapped all along: ${numberText(r.depth)} along the normal.`
          : `To the time of collision, found by halving: ${share(r.time)}, ` +
            `${numberText(1000 * r.time * timeStep)} ms.`,
      places: r.apart,
      ghosts: r.end,
      arrows: [{ from: found.point, along: normal }],
    },
    {
      title: "Velocities changed.",
      text: `v_n from ${numberText(formula.normalSpeed)} to ${numberText(formula.normalSpeedFinal)}.`,
      places: r.apart,
      arrows: speeds(formula.a.velocity, formula.b.velocity),
    },
    {
      title: "The rest moved.",
      text:
        r.time === null
          ? `Nothing is left of ${step}.`
          : `With the new velocities for the other ${share(1 - r.time)}.`,
      places: r.rest,
      ghosts: r.apart,
    },
  ];
  pictures.push(
    r.impact === null || r.met === null
      ? {
          title: "Swept:",
          text: "no time of impact in this motion: they overlap at its start, or do not meet.",
          places: r.end,
        }
      : {
          title: "Swept:",
          text: `they first meet at ${share(r.impact)}, and never overlap.`,
          places: r.met,
          ghosts: r.start,
          arrows: [{ from: found.point, along: normal }],
        },
  );
  return pictures;
}

/** The half extents of a shape's bounds. */
function boundsOf(shape: Shape): Vec2 {
  if (shape.kind === "circle") return [shape.radius, shape.radius];
  const angle = shape.kind === "obb" ? shape.angle : 0;
  const [c, s] = [Math.abs(Math.cos(angle)), Math.abs(Math.sin(angle))];
  const { halfWidth, halfHeight } = shape;
  return [c * halfWidth + s * halfHeight, s * halfWidth + c * halfHeight];
}

/** One picture; all of a pair have the same part of the world, about where the two meet. */
function drawing({ title, places, ghosts, arrows = [] }: Picture, found: Collision): SVGElement {
  const { resolution, point } = found;
  // The smaller shape gives the scale: a wall or ground would make it too small to see.
  const smaller = Math.min(...places.map((shape) => Math.max(...boundsOf(shape))));
  const ways = [0, 1].map((i) =>
    Math.hypot(
      resolution.end[i].center[0] - resolution.start[i].center[0],
      resolution.end[i].center[1] - resolution.start[i].center[1],
    ),
  );
  const scale = (FILL * SIZE) / (4 * smaller + Math.max(...ways));
  const at = ([x, y]: Vec2): Vec2 => [
    SIZE / 2 + scale * (x - point[0]),
    SIZE / 2 - scale * (y - point[1]),
  ];
  const root = svg("svg", { viewBox: `0 0 ${SIZE} ${SIZE}`, role: "img", "aria-label": title });
  for (const [list, name] of [[ghosts, "ghost"], [places, "solid"]] as const)
    list?.forEach((shape, i) => root.append(outline(shape, at, scale, `${name} of-${"ab"[i]}`)));
  const longest = Math.max(...arrows.map(({ along: [x, y] }) => Math.hypot(x, y)), SLOW);
  for (const { from, along } of arrows) {
    const [x, y] = at(from);
    const [dx, dy] = [(ARROW * along[0]) / longest, (-ARROW * along[1]) / longest];
    const length = Math.hypot(dx, dy);
    if (length < 1) continue;
    const [ux, uy] = [dx / length, dy / length];
    const [tx, ty] = [x + dx, y + dy];
    const head = [-1, 1].map((side) => `${tx - 5 * ux - 3 * side * uy},${ty - 5 * uy + 3 * side * ux}`);
    root.append(
      svg("polyline", { class: "arrow", points: `${x},${y} ${tx},${ty}` }),
      svg("polyline", { class: "arrow", points: `${head[0]} ${tx},${ty} ${head[1]}` }),
    );
  }
  return root;
}

function outline(
  shape: Shape,
  at: (place: Vec2) => Vec2,
  scale: number,
  name: string,
): SVGElement {
  const [x, y] = at(shape.center);
  if (shape.kind === "circle")
    return svg("circle", { class: name, cx: x, cy: y, r: scale * shape.radius });
  const angle = shape.kind === "obb" ? shape.angle : 0;
  const [width, height] = [2 * scale * shape.halfWidth, 2 * scale * shape.halfHeight];
  return svg("rect", {
    class: name,
    x: x - width / 2,
    y: y - height / 2,
    width,
    height,
    transform: `rotate(${(-180 * angle) / Math.PI} ${x} ${y})`,
  });
}

function svg(name: string, attributes: Record<string, string | number>): SVGElement {
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, String(value));
  return element;
}
