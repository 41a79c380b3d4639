/**
 * Draws a scene in its present state as a small SVG. Sizes are in units of the picture, 640 by 400;
 * the page shows it at a quarter of that. The colours are visible on light and on dark backgrounds.
 */
const WIDTH = 640;
const HEIGHT = 400;
/** The smallest half extent that is drawn: 0.3 pixels on the page. Chosen: less cannot be seen. */
const LEAST = 1.2;
/** The colour of static shapes. */
const STONE = "rgb(118 134 162)";
const GROUND = `fill="${STONE}" fill-opacity=".55"`;
/** The numbers of kinds of shapes and bodies in rows of the shape table. */
const KINDS = { circle: 0, terrain: 3 };
const BODIES = { static: 0, kinematic: 1, dynamic: 2 };

/** The colours of marks, by the names of inks of scene.ts. */
const INKS = {
  ink: STONE,
  soft: STONE,
  accent: "rgb(66 141 205)",
  good: "rgb(88 184 150)",
  bad: "rgb(239 83 80)",
  gold: "rgb(240 180 70)",
  water: "rgb(66 160 222)",
  player: "rgb(245 124 82)",
  rival: "rgb(98 105 200)",
};

const SENSOR = `fill="${INKS.good}" fill-opacity=".5"`;

/**
 * The SVG of a scene. `ramp`: CSS colours of dynamic bodies, from the lowest slot to the highest.
 */
export function drawScene(scene, ramp, view = scene.view) {
  const place = placing(view);
  const paths = new Map();
  const add = (style, path) => paths.set(style, (paths.get(style) ?? "") + path);
  for (const { style, path } of shapePaths(scene, place, ramp)) add(style, path);
  for (const { style, path } of overlayPaths(scene, place)) add(style, path);
  for (const mark of scene.paint?.().marks ?? []) {
    const drawn = markPath(mark, place);
    if (drawn) add(drawn.style, drawn.path);
  }
  const body = [...paths].map(([style, path]) => `<path ${style} d="${path}"/>`).join("\n");
  const open = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${WIDTH} ${HEIGHT}">`;
  return `${open}\n${body}\n</svg>\n`;
}

/**
 * The transformation from the world to the picture in which the whole view is visible: its scale,
 * `at` for coordinates relative to `origin`, and `sees`, whether a point within `reach` is visible.
 */
function placing({ x, y, height, width = 0 }) {
  const scale = Math.min(HEIGHT / height, width > 0 ? WIDTH / width : Infinity);
  return {
    scale,
    origin: [x, y],
    at: (dx, dy) => [WIDTH / 2 + dx * scale, HEIGHT / 2 - dy * scale],
    sees: ([px, py], reach) =>
      px > -reach && px < WIDTH + reach && py > -reach && py < HEIGHT + reach,
  };
}

const round = Math.round;
const tenths = (value) => Math.round(value * 10) / 10;
const point = ([x, y]) => `${round(x)} ${round(y)}`;

/** The SVG path of a circle. */
function circle([x, y], radius) {
  const r = tenths(radius);
  const arc = (dx) => `a${r} ${r} 0 1 1 ${tenths(dx)} 0`;
  return `M${tenths(x - r)} ${round(y)}${arc(2 * r)}${arc(-2 * r)}`;
}

/** The SVG path of a box with half extents hx, hy, turned by the cosine c and the sine s. */
function box([x, y], hx, hy, c, s) {
  const corners = [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([u, v]) =>
    point([x + c * u * hx + s * v * hy, y - s * u * hx + c * v * hy]),
  );
  return `M${corners.join("L")}z`;
}

/** The paths of all visible shapes, each with its style. */
function* shapePaths({ world, hidden = [] }, place, ramp) {
  const table = world.shapeTable();
  const rows = table.rows.slice();
  const handles = table.handles.slice();
  const poses = world.poses(1, ...place.origin).slice();
  const unseen = new Set(hidden);
  const moving = [];
  for (let i = 0; i < rows.length; i += 10)
    if (rows[i + 2] === BODIES.dynamic) moving.push(rows[i]);
  const last = Math.max(1, ...moving);
  const first = moving.length > 0 ? Math.min(...moving) : 0;

  for (let row = 0; row < table.count; row++) {
    const [slot, kind, bodyKind, sensor, ox, oy, hx, hy, sc, ss] = rows.subarray(10 * row);
    if (unseen.has(slot)) continue;
    const [bx, by, bc, bs] = poses.subarray(4 * slot);
    const center = place.at(bx + bc * ox - bs * oy, by + bs * ox + bc * oy);
    const [w, h] = [hx * place.scale, hy * place.scale];
    if (kind === KINDS.terrain) {
      const id = { kind: "shape", index: handles[4 * row] - 1, generation: handles[4 * row + 1] };
      yield { style: GROUND, path: ground(world.terrainOf(id), place, bx, by) };
      continue;
    }
    if (!place.sees(center, Math.hypot(w, h))) continue;
    if (bodyKind === BODIES.dynamic && Math.max(w, h) < LEAST) continue;
    const [c, s] = [bc * sc - bs * ss, bs * sc + bc * ss];
    const [halfW, halfH] = [Math.max(w, LEAST), Math.max(h, LEAST)];
    yield {
      style: sensor ? SENSOR : styleOf(bodyKind, ramp, (slot - first) / (last - first + 1)),
      path: kind === KINDS.circle ? circle(center, halfW) : box(center, halfW, halfH, c, s),
    };
  }
}

/**
 * The style of a shape by the kind of its body; `t` in [0, 1) selects the colour of dynamic ones.
 */
function styleOf(bodyKind, ramp, t) {
  if (bodyKind === BODIES.static) return `fill="${STONE}" fill-opacity=".8"`;
  if (bodyKind === BODIES.kinematic) return `fill="${STONE}"`;
  const colour = ramp[Math.floor(t * ramp.length)];
  return `fill="${colour}" stroke="#10141c" stroke-opacity=".45" stroke-width="1.5"`;
}

/** The path of the visible part of a terrain, closed along the picture's lower edge. */
function ground(terrain, place, x, y) {
  const reach = (WIDTH / place.scale) * 0.6;
  const points =
    terrain.kind === "flat"
      ? [-reach, reach].map((dx) => [dx - x, (terrain.slope ?? 0) * (dx - x)])
      : terrain.kind === "uniform"
        ? Array.from(terrain.heights, (height, i) => [terrain.x0 + i * terrain.spacing, height])
        : terrain.points;
  const shown = points.filter((_, i) => {
    const [before, next] = [points[i - 1] ?? points[i], points[i + 1] ?? points[i]];
    return next[0] + x > -reach && before[0] + x < reach;
  });
  if (shown.length < 2) return "";
  const line = shown.map(([px, py]) => place.at(px + x, py + y));
  const below = ([px]) => [px, HEIGHT + 10];
  return `M${[below(line[0]), ...line, below(line.at(-1))].map(point).join("L")}z`;
}

/** The paths of the engine's debug drawing, of the options that the scene names in `show`. */
function* overlayPaths({ world, show = [] }, place) {
  if (show.length === 0) return;
  const [halfX, halfY] = [WIDTH / 2 / place.scale, HEIGHT / 2 / place.scale];
  const { shapes, lines } = world.draw({
    ...Object.fromEntries(show.map((name) => [name, true])),
    origin: place.origin,
    lower: [place.origin[0] - halfX, place.origin[1] - halfY],
    upper: [place.origin[0] + halfX, place.origin[1] + halfY],
  });
  const style = `fill="none" stroke="${INKS.rival}" stroke-opacity=".6" stroke-width="1.5"`;
  for (let i = 0; i < shapes.length; i += 9) {
    const [x, y, hx, hy, c, s, round] = shapes.subarray(i);
    const [center, w, h] = [place.at(x, y), hx * place.scale, hy * place.scale];
    yield { style, path: round ? circle(center, w) : box(center, w, h, c, s) };
  }
  for (let i = 0; i < lines.length; i += 5) {
    const [x0, y0, x1, y1] = lines.subarray(i);
    yield { style, path: `M${point(place.at(x0, y0))}L${point(place.at(x1, y1))}` };
  }
}

/** The path of a mark that the scene paints (Mark of scene.ts); null where it is not drawn. */
function markPath(mark, { at, scale, origin, sees }) {
  const ink = INKS[mark.ink];
  const from = ([x, y]) => at(x - origin[0], y - origin[1]);
  if (mark.kind === "line") {
    const dashed = mark.dashed ? ' stroke-dasharray="14 10"' : "";
    const path = `M${mark.points.map((p) => point(from(p))).join("L")}`;
    const opacity = mark.opacity ?? 1;
    if (mark.filled) return { style: `fill="${ink}" fill-opacity="${opacity}"`, path: `${path}z` };
    const faded = opacity < 1 ? ` stroke-opacity="${opacity}"` : "";
    return { style: `fill="none" stroke="${ink}" stroke-width="4"${dashed}${faded}`, path };
  }
  if (mark.kind === "text") return null;
  const center = from([mark.x, mark.y]);
  const reach = mark.radius ?? Math.hypot(mark.halfWidth, mark.halfHeight);
  if (!sees(center, scale * reach)) return null;
  const style = mark.filled
    ? `fill="${ink}" fill-opacity="${mark.opacity ?? 1}"`
    : mark.kind === "figure"
      ? `fill="${ink}"`
      : `fill="none" stroke="${ink}" stroke-width="3" stroke-opacity="${mark.opacity ?? 1}"`;
  if (mark.kind === "circle") return { style, path: circle(center, mark.radius * scale) };
  const angle = mark.angle ?? 0;
  const [w, h] = [mark.halfWidth * scale, mark.halfHeight * scale];
  return { style, path: box(center, w, h, Math.cos(angle), Math.sin(angle)) };
}
