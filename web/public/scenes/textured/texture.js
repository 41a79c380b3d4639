// What the ground is made of, and where in the texture a place of it lies.

/** Its rows, one above the other: v goes from row to row, u along the ground in metres. */
export const TEXTURE = [
  { name: "Rock", friction: 1.2, ink: "soft" },
  { name: "Grass", friction: 0.6, ink: "good" },
  { name: "Ice", friction: 0.01, ink: "rival" },
  { name: "Sand", friction: 0.3, ink: "gold" },
];

/** Of each vertex: as far apart on the texture as on the ground, in the middle of a row. */
export function coordinatesOf(points, row) {
  let u = 0;
  return points.map(([x, y], i) => {
    const [x0, y0] = points[i - 1] ?? [x, y];
    u += Math.sqrt((x - x0) * (x - x0) + (y - y0) * (y - y0));
    return { u, v: row + 0.5 };
  });
}

/**
 * What the engine reads the friction from: the rows follow each other in a circle. The ends of a band
 * lie midway to its neighbours’ rows, so that friction goes over from band to band.
 */
export function frictionOf(points, row) {
  const rows = TEXTURE.length;
  const vertices = points.map((_, i) => (row + (i === 0 ? -0.5 : i === points.length - 1 ? 0.5 : 0)) / rows);
  return { vertices, table: TEXTURE.map(({ friction }) => friction), repeats: true };
}

/** A band as it lies now: who digs gives it other vertices, which have coordinates of their own. */
function present(world, band) {
  const revision = world.revision.terrains;
  if (band.revision !== revision) {
    band.points = world.terrainOf(band.shape).points;
    band.coordinates = coordinatesOf(band.points, band.row);
    band.revision = revision;
  }
  return band;
}

/**
 * The engine’s weights of the two vertices beside a place, and what they make of the coordinates. A
 * foot on the end of a band may touch it a little beyond.
 */
export function textureAt(world, band, place) {
  const { shape, points, coordinates } = present(world, band);
  const x = Math.min(points.at(-1)[0], Math.max(points[0][0], place));
  const { height, normal, segment, weights } = world.groundAt(shape, x);
  const [a, b] = [coordinates[segment], coordinates[segment + 1]];
  const u = weights[0] * a.u + weights[1] * b.u;
  const v = weights[0] * a.v + weights[1] * b.v;
  const [from, to] = points.slice(segment);
  const friction = world.frictionAt(shape, x);
  return { x, y: height, normal, weights, from, to, u, v, row: Math.floor(v), friction };
}
