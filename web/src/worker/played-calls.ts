/**
 * The calls that a program made before a step of its recording, as text and as marks that are
 * drawn: queries with what they found, and the places that other calls changed.
 */
import type { Vec2, World } from "thud";
import type { PlayedCall } from "thud/recording";
import type { Calls } from "../scene/frame";
import type { Ink, Mark } from "../scene/scene";

/** Maximum number of calls that are listed and drawn, and of characters of one. Chosen. */
const MOST_CALLS = 200;
const LONGEST = 160;
/** Digits of a number that is not whole. */
const DIGITS = 4;
/** Radius of the disc at a hit, a share of the view's height, and the length of its normal. Chosen. */
const DISC = 0.006;
const NORMAL = 0.04;

const QUERY: Ink = "water";
const HIT: Ink = "bad";
const CHANGE: Ink = "accent";

/** The calls without the one that makes the step. */
function others(calls: readonly PlayedCall[]): readonly PlayedCall[] {
  return calls.filter(({ name, refused }) => name !== "thud_world_step" || refused !== null);
}

/** The list of a step's calls. */
export function listCalls(all: readonly PlayedCall[]): Calls {
  const calls = others(all);
  return { count: calls.length, lines: calls.slice(0, MOST_CALLS).map(textOf) };
}

/**
 * A call as it would be written in C, without the prefix "thud_"; a handle is written as # and its
 * index.
 */
function textOf({ name, refused, values, returned, found }: PlayedCall): string {
  const short = name.replace(/^thud_/, "");
  if (refused !== null) return `${short}: refused, ${refused}`;
  const numbers = values.map(({ number, handle }) => 
    handle ? `#${number}` : `${Number.isInteger(number) ? number : Number(number.toPrecision(DIGITS))}`,
  );
  const text = `${short}(${numbers.join(", ")})`;
  const cut = text.length > LONGEST ? `${text.slice(0, LONGEST)}…` : text;
  if (found) return `${cut}: ${found.length === 0 ? "nothing" : found.length === 1 ? "1 hit" : `${found.length} hits`}`;
  return returned === null ? cut : `${cut} = #${returned}`;
}

/** Marks of a step's calls. `height`: of the view. */
export function markCalls(all: readonly PlayedCall[], world: World, height: number): Mark[] {
  const bodies = new Map(world.bodies().map((body) => [body.index, body]));
  const shapes = new Map(world.shapes().map((shape) => [shape.index, shape]));
  const marks: Mark[] = [];
  const changed = new Set<number>();
  for (const call of others(all).slice(0, MOST_CALLS)) {
    if (call.found) marks.push(...queryMarks(call), ...hitMarks(call, height));
    else marks.push(...placeMarks(call));
    const handle = call.values.find((value) => value.handle)?.number ?? call.returned;
    if (handle === null || handle < 0 || call.found) continue;
    if (call.name.startsWith("thud_body_")) changed.add(handle);
    const shape = call.name.startsWith("thud_shape_") ? shapes.get(handle) : undefined;
    if (shape) changed.add(world.bodyOf(shape).index);
  }
  for (const index of changed) {
    const body = bodies.get(index);
    if (!body) continue;
    const [x, y] = world.bodyStateOf(body).position;
    marks.push({ kind: "circle", x, y, radius: 3 * DISC * height, ink: CHANGE });
  }
  return marks;
}

/** A circle or a box, from the seven numbers of a thud_geometry, about a place. */
function outline([kind, x, y, cos, sin, halfWidth, halfHeight]: readonly number[], at: Vec2): Mark {
  const place = { x: at[0] + x, y: at[1] + y, ink: QUERY };
  if (kind === 0) return { kind: "circle", ...place, radius: halfWidth };
  return { kind: "box", ...place, halfWidth, halfHeight, angle: Math.atan2(sin, cos) };
}

/** Marks of where a query searched: its ray, the path of its shape, or its area. */
function queryMarks({ name, values, found }: PlayedCall): Mark[] {
  const numbers = values.map(({ number }) => number);
  const [a, b, c, d] = numbers;
  const along = (x: number, y: number, dx: number, dy: number): Mark => ({
    kind: "line",
    points: [[x, y], [x + dx, y + dy]],
    ink: QUERY,
    width: 1,
    dashed: true,
  });
  switch (name) {
    case "thud_world_cast_ray":
    case "thud_world_cast_ray_all":
    case "thud_world_cast_ray_each":
      return [along(a, b, c, d)];
    case "thud_world_cast_rays": {
      // Each ray has four numbers, and those of its filter, if it has one.
      const count = found!.length;
      const each = count > 0 ? (numbers.length - 1) / count : 0;
      if (!Number.isInteger(each)) return [];
      return Array.from({ length: Math.min(count, MOST_CALLS) }, (_, i) => {
        const [x, y, dx, dy] = numbers.slice(i * each);
        return along(x, y, dx, dy);
      });
    }
    case "thud_world_cast_shape":
    case "thud_world_cast_shape_all":
    case "thud_world_cast_shape_each": {
      const [dx, dy] = numbers.slice(9);
      const shape = numbers.slice(2, 9);
      return [outline(shape, [a, b]), outline(shape, [a + dx, b + dy]), along(a, b, dx, dy)];
    }
    case "thud_world_overlap_shape":
      return [outline(numbers.slice(2, 9), [a, b])];
    case "thud_world_overlap_aabb": {
      const middle: Vec2 = [(a + c) / 2, (b + d) / 2];
      return [outline([1, 0, 0, 1, 0, (c - a) / 2, (d - b) / 2], middle)];
    }
    case "thud_world_closest": {
      const [hit] = found!;
      return hit ? [along(a, b, hit.point[0] - a, hit.point[1] - b)] : [];
    }
  }
  return [];
}

/** The points that a query hit, with the normals there. An overlap has none. */
function hitMarks({ name, found }: PlayedCall, height: number): Mark[] {
  if (name.includes("overlap")) return [];
  return found!.slice(0, MOST_CALLS).flatMap(({ point: [x, y], normal: [nx, ny] }): Mark[] => {
    // The ray of a bulk cast that hit nothing.
    if (nx === 0 && ny === 0) return [];
    const end: Vec2 = [x + NORMAL * height * nx, y + NORMAL * height * ny];
    return [
      { kind: "circle", x, y, radius: DISC * height, ink: HIT, filled: true },
      { kind: "line", points: [[x, y], end], ink: HIT, width: 1.5 },
    ];
  });
}

/** The places of calls that act on an area. */
function placeMarks({ name, refused, values }: PlayedCall): Mark[] {
  if (refused !== null) return [];
  const numbers = values.filter(({ handle }) => !handle).map(({ number }) => number);
  const [x, y, radius] = numbers;
  if (name !== "thud_world_explode" && name !== "thud_shape_dig") return [];
  return radius > 0 ? [{ kind: "circle", x, y, radius, ink: CHANGE }] : [];
}
