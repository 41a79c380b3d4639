// The ball’s way, its velocity before and after the contact, the normal, and where a portal leads.

const line = (points, ink, more = {}) => ({ kind: "line", points, ink, ...more });
const text = ([x, y], words, ink) => ({ kind: "text", x, y, text: words, ink });
const SCALE = 0.17; // metres of an arrow for each m/s

export function paintAll({ answer, trail, fall }, { position: [x, y], radius, exit, near }) {
  const marks = [];
  for (const piece of piecesOf(trail))
    if (piece.length > 1) marks.push(line(piece, "soft", { width: 2, dashed: true }));
  if (answer === "portal") {
    marks.push({ kind: "circle", x: exit[0], y: exit[1], radius: 0.7, ink: "accent" });
    marks.push(text([exit[0], exit[1] + 1], "leads here", "accent"));
  }
  if (near) marks.push({ kind: "circle", x, y, radius: radius + 0.08, ink: "gold" });
  if (fall.at) paintContact(marks, fall);
  return { marks };
}

/** The way, cut where the ball jumped: at the portal. */
function piecesOf(trail) {
  const pieces = [[]];
  trail.forEach((place, i) => {
    const [x, y] = trail[i - 1] ?? place;
    if (Math.abs(place[0] - x) + Math.abs(place[1] - y) > 1) pieces.push([]);
    pieces.at(-1).push(place);
  });
  return pieces;
}

function paintContact(marks, { at, before, after }) {
  const [x, y] = at.point;
  const tip = ([dx, dy], scale) => [x + scale * dx, y + scale * dy];
  marks.push(line([at.point, tip(at.normal, 2.2)], "soft", { dashed: true }));
  marks.push(text([x, y - 0.35], "contact", "ink"));
  // The velocity before ends at the contact, the one after begins there.
  const from = tip(before, -SCALE);
  paintArrow(marks, from, at.point, "rival");
  marks.push(text([from[0] - 0.6, from[1] + 0.2], "before", "rival"));
  if (after === null) return;
  const to = tip(after, SCALE);
  paintArrow(marks, at.point, to, "good");
  marks.push(text([to[0] + 0.5, to[1] + 0.2], "after", "good"));
}

function paintArrow(marks, from, to, ink) {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  const length = Math.sqrt(dx * dx + dy * dy);
  marks.push(line([from, to], ink, { width: 3 }));
  if (length < 0.05) return;
  const [u, v] = [(0.22 * dx) / length, (0.22 * dy) / length];
  const barb = (side) => [to[0] - u - 0.6 * side * v, to[1] - v + 0.6 * side * u];
  marks.push(line([barb(1), to, barb(-1)], ink, { width: 3 }));
}
