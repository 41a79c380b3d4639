/** Interpolates a scene's marks, and the place that its view follows, between two steps. */
import type { Vec2 } from "thud";
import type { Mark, Paint } from "../scene/scene";

/**
 * `part` is 0 at `before` and 1 at `now`. The marks of `now` are returned as they are if `before`
 * does not have as many marks of the same kinds.
 */
export function smoothMarks(before: Paint | null, now: Paint, part: number): readonly Mark[] {
  const last = now.marks ?? [];
  const first = before?.marks ?? [];
  const alike =
    first.length === last.length && first.every((mark, i) => mark.kind === last[i].kind);
  return alike ? last.map((mark, i) => between(first[i], mark, part)) : last;
}

/** The place that the view follows, or null. */
export function smoothFollow(before: Paint | null, now: Paint, part: number): Vec2 | null {
  if (!now.follow) return null;
  return before?.follow ? betweenPoints(before.follow, now.follow, part) : now.follow;
}

/** A mark between two marks of the same kind; `last` where they cannot be interpolated. */
function between(first: Mark, last: Mark, part: number): Mark {
  if (last.kind === "line") {
    if (first.kind !== "line" || first.points.length !== last.points.length) return last;
    const points = last.points.map((point, i) => betweenPoints(first.points[i], point, part));
    return { ...last, points };
  }
  if (first.kind === "line") return last;
  const [x, y] = betweenPoints([first.x, first.y], [last.x, last.y], part);
  if (last.kind !== "box" || first.kind !== "box") return { ...last, x, y };
  const [from, to] = [first.angle ?? 0, last.angle ?? 0];
  // The angle from the first to the last, in the shorter direction.
  const turn = Math.atan2(Math.sin(to - from), Math.cos(to - from));
  return { ...last, x, y, angle: from + part * turn };
}

function betweenPoints(first: Vec2, last: Vec2, part: number): Vec2 {
  return [first[0] + part * (last[0] - first[0]), first[1] + part * (last[1] - first[1])];
}
